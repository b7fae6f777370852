# SPDX-License-Identifier: Apache-2.0
"""`contralbero verify`: writes the report inside a file again, and says what the file is."""

from argparse import Namespace
from pathlib import Path

from assistant.named_files import STANDARD, demand_ending, put, spoken, standard_input
from calc.design.disk import read_file
from calc.design.limits import PDF_BYTES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.sheet.visible import visible
from reports.made import others
from reports.verify.verify import NOTHING, Verdict, Verification, verify

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
    if asked.original not in (None, STANDARD):
        demand_ending(asked.original, "pdf", option="--original")
    raw = standard_input(PDF_BYTES) if asked.file == STANDARD else _bytes(path)
    found = verify(raw, str(path))
    lines = [f"{path}: {found.design}"]
    lines += [f"made with {name} {theirs}; here is {ours}" for name, (theirs, ours) in others(found.made).items()]
    lines += found.signers
    if found.why:
        count = len(raw) - len(found.original)
        lines += [f"{count:,} bytes were appended, which are not signatures of its fields alone: {found.why}"]
    if found.verdict is Verdict.NOT_AS_WRITTEN:
        lines += _compared(found, None if asked.all else MOST)
    if found.front:
        lines += ["of the search for the whole drive it repeats front.json inside it; that is not searched again"]
    if asked.original is not None:
        if not found.original:
            raise BadInput(str(path), [InputError(0, "", "", Text("does not begin with what this program writes"))])
        put(asked.original, found.original, [path])
        lines += [f"the report as it was written: {asked.original}"] if asked.original != STANDARD else []
    with spoken(asked.original):
        for line in [*([] if asked.quiet else lines), LAST[found.verdict]]:
            print(visible(line))  # what stands in the file may hold anything; a terminal must not obey it
    if found.verdict in (Verdict.IDENTICAL, Verdict.SIGNED):
        return 0
    return 1 if found.differences or found.changed else 4


def _compared(found: Verification, most: int | None) -> list[str]:
    """What is inside and what it gives now, beside each other."""
    lines = [f"the attachment {name} is not one that the report was written with" for name in found.changed]
    made = f"made by {found.made['program']}; " if "program" in others(found.made) else ""
    if not found.differences:
        return [*lines, f"{made}{found.compared:,} values and verdicts were compared: the same to 1e-9"]
    new, gone = sum(of.was == NOTHING for of in found.differences), sum(of.now == NOTHING for of in found.differences)
    counts = f"{len(found.differences) - new - gone:,} changed since, {new:,} new, {gone:,} gone"
    lines += [f"{made}{found.compared:,} values and verdicts were compared: {counts.removesuffix(', 0 new, 0 gone')}:"]
    shown = sorted(found.differences, key=lambda of: NOTHING in (of.was, of.now))
    lines += [f"{of.what}: {of.was} in the report, {of.now} now" for of in shown[:most]]
    if most is not None and len(shown) > most:
        lines += [f"and {len(shown) - most:,} more; --all lists them"]
    return lines


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
