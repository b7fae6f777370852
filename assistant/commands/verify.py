# SPDX-License-Identifier: Apache-2.0
"""`contralbero verify`: writes the report inside a file again, and says what the file is."""

from argparse import Namespace
from pathlib import Path

from calc.design.disk import read_file, write_file
from calc.design.limits import PDF_BYTES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.sheet.visible import visible
from reports.verify.verify import Verdict, Verification, verify

MOST = 20  # differences that are listed
LAST = {
    Verdict.IDENTICAL: "identical: byte for byte what this program writes from the design inside",
    Verdict.SIGNED: "signed: byte for byte what this program writes, and behind it signatures in its fields and "
    "nothing else",
    Verdict.APPENDED: "appended to: it begins with what this program writes, and something else stands behind it; a "
    "reader may show other pages. --original OUT.pdf writes the part that is ours",
    Verdict.NOT_AS_WRITTEN: "not as written: the design inside was solved again and compared; its pages were not "
    "looked at",
}


def run_verify(asked: Namespace) -> int:
    path = Path(asked.file)
    found = verify(_bytes(path), str(path))

    def say(text: str) -> None:
        """What stands in the file may hold anything; a terminal must not obey it."""
        print(visible(text))

    say(f"{path}: {found.design}")
    for name, (theirs, ours) in found.other_versions.items():
        say(f"made with {name} {theirs}; here is {ours}")
    for line in found.signers:
        say(line)
    if found.why:
        say(f"{found.appended:,} bytes were appended, which are no signatures of its fields alone: {found.why}")
    if found.verdict is Verdict.NOT_AS_WRITTEN:
        _compared(found, None if asked.all else MOST, say)
    if found.front:
        say("of the search for the whole drive it says what front.json inside it says; that is not searched again")
    if asked.original is not None:
        _write_original(found, path, Path(asked.original))
    say(LAST[found.verdict])
    if found.verdict in (Verdict.IDENTICAL, Verdict.SIGNED):
        return 0
    return 1 if found.differences or found.changed else 4


def _compared(found: Verification, most: int | None, say: object) -> None:
    assert callable(say)
    for name in found.changed:
        say(f"the attachment {name} is not the one that the report was written with")
    made = f"made by {found.made['program']}; " if "program" in found.other_versions else ""
    if not found.differences:
        say(f"{made}{found.compared:,} values, verdicts and files were compared: the same to 1e-9")
        return
    say(f"{made}of {found.compared:,} values, verdicts and files compared, {len(found.differences):,} are others now:")
    for difference in found.differences[:most]:
        say(f"{difference.what}: {difference.was} in the report, {difference.now} now")
    if most is not None and len(found.differences) > most:
        say(f"and {len(found.differences) - most} more; --all lists them")


def _write_original(found: Verification, path: Path, target: Path) -> None:
    """Raises BadInput where there is no part that is this program's."""
    if found.verdict is Verdict.NOT_AS_WRITTEN:
        raise BadInput(str(path), [InputError(0, "", "", Text("does not begin with what this program writes"))])
    written = write_file(target, found.original or _bytes(path), inputs=[path])
    print(visible(f"the report as it was written: {written}"))


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
