# SPDX-License-Identifier: Apache-2.0
"""`contralbero verify`: solves the design inside a report again and says identical, signed, or what differs."""

from argparse import Namespace
from pathlib import Path

from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.version import VERSION
from reports.verify import verify

MOST = 20  # differences that are listed


def run(asked: Namespace) -> int:
    path = Path(asked.file)
    try:
        raw = path.read_bytes()
    except OSError as error:
        reason = Text("cannot be read: {reason}; give a report that `contralbero report` wrote", reason=error.strerror or str(error))
        raise BadInput(str(path), [InputError(0, "", "", reason)]) from None
    found = verify(raw, str(path))

    def say(text: str) -> None:
        """What stands in the file may hold anything; a terminal must not obey it."""
        print("".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in text))

    say(f"{path}: {found.design}")
    if not found.same_version:
        say(f"written by version {found.version}; this is version {VERSION}: texts are compared, and what differs may come from that")
    for name in found.changed:
        say(f"the attachment {name} is not the one that the report was written with")
    for one in found.differences[: MOST if not asked.all else None]:
        say(f"{one.what}: {one.was} in the report, {one.now} now")
    if not asked.all and len(found.differences) > MOST:
        print(f"and {len(found.differences) - MOST} more; --all lists them")
    for number in found.signed:
        print(f"page {number} carries the field of a signature; what that shows is not the report's")
    if not found.kept:
        print("differs")
        return 1
    if found.signed:
        print("signed, or prepared for it: nothing that is printed is covered, and all values, verdicts and pages are identical")
        return 0
    print("identical, byte for byte" if found.same_bytes else "identical in all values, verdicts and pages; other bytes")
    return 0
