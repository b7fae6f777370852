# SPDX-License-Identifier: Apache-2.0
"""`contralbero verify`: solves the design inside a report again and says identical, signed, or what else the file
is."""

from argparse import Namespace
from pathlib import Path

from calc.design.disk import read_file
from calc.design.limits import PDF_BYTES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.sheet.version import VERSION
from calc.sheet.visible import visible
from reports.verify.verify import Verdict, verify

MOST = 20  # differences that are listed
LAST = {
    Verdict.IDENTICAL: "identical, byte for byte",
    Verdict.SIGNED: "signed, or prepared for it: what this program writes, byte for byte, and after it fields that "
    "cover nothing",
    Verdict.COVERED: "covered: the field of a signature lies over what is printed",
    Verdict.OTHER_VERSION: "another version: the same values, verdicts and texts; only the version that wrote it can "
    "call it identical",
    Verdict.SAVED_ANEW: "saved anew: no difference was found, but the bytes are not this program's; ask for the "
    "report as it was written",
    Verdict.DIFFERS: "differs",
}
TRUSTED = (Verdict.IDENTICAL, Verdict.SIGNED)


def run_verify(asked: Namespace) -> int:
    path = Path(asked.file)
    verification = verify(_bytes(path), str(path))

    def say(text: str) -> None:
        """What stands in the file may hold anything; a terminal must not obey it."""
        print(visible(text))

    say(f"{path}: {verification.design}")
    if verification.version != VERSION:
        say(
            f"written by version {verification.version}; this is version {VERSION}: texts are compared, "
            "and what differs may come from that"
        )
    for name in verification.changed:
        say(f"the attachment {name} is not the one that the report was written with")
    for difference in verification.differences[: MOST if not asked.all else None]:
        say(f"{difference.what}: {difference.was} in the report, {difference.now} now")
    if not asked.all and len(verification.differences) > MOST:
        print(f"and {len(verification.differences) - MOST} more; --all lists them")
    for number in verification.signed:
        print(f"page {number} carries the field of a signature; what that shows is not the report's")
    if verification.front:
        print(
            "what it says of the search for the whole drive is what the attachment front.json says; that is not "
            "searched again"
        )
    print(LAST[verification.verdict])
    return 0 if verification.verdict in TRUSTED else 1


def _bytes(path: Path) -> bytes:
    """What stands in the file.  Raises BadInput for one that is none, or too large: a pipe would never end."""
    try:
        return read_file(path, PDF_BYTES)
    except OSError as error:
        reason = Text(
            "cannot be read: {reason}; give a report that `contralbero report` wrote",
            reason=error.strerror or str(error),
        )
        raise BadInput(str(path), [InputError(0, "", "", reason)]) from None
