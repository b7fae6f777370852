# SPDX-License-Identifier: Apache-2.0
"""`contralbero compare`: two designs side by side, differences first."""

import sys
from argparse import Namespace
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from assistant.plain import finite, sign, table_lines
from assistant.saving import spare
from calc.compare import EQUAL, SAME, CheckDifference, Comparison, ValueDifference, compare
from calc.compare_tables import Names, check_table, input_table, value_table, verdict_table
from calc.design import STEPS
from calc.design_file import Document, design, read
from calc.prediction import compared_table
from calc.sheet.check import Check
from calc.sheet.errors import BadInput, InputError
from calc.sheet.number import short
from calc.sheet.step import Table
from calc.sheet.text import Text
from calc.solve import Results, solve
from calc.version import VERSION

MOST = 6  # values of a step that are shown
LONGEST = 24  # characters of a name above a column
Sides = tuple[tuple[Document, Results], tuple[Document, Results]]


def run(asked: Namespace) -> int:
    """What is wrong with either file is said at once."""
    solved, wrong = [], []
    for name in (asked.a, asked.b):
        try:
            document = read(name)
            solved.append((document, design(document)))
        except BadInput as bad:
            wrong.append(str(bad))
    if wrong:
        print("\n".join(dict.fromkeys(wrong)), file=sys.stderr)
        return 2
    (a, made_a), (b, made_b) = solved
    sides = ((a, solve(made_a)), (b, solve(made_b)))
    found = compare(a.data, b.data, sides[0][1], sides[1][1])
    if asked.output:
        spare(Path(asked.output), asked.a, asked.b)
        return _write(sides, found, Path(asked.output), asked.lang)
    if asked.json:
        import json

        print(json.dumps(comparison_json(sides, found), ensure_ascii=False, indent=1, default=str))  # a date
    else:
        print("\n".join(text(sides, found, asked.all)))
    return 0


def _write(sides: Sides, found: Comparison, path: Path, lang: str) -> int:
    from reports.comparison import write

    try:
        write(*sides, found, column_names(*(Path(document.place).stem for document, _ in sides)), path, lang=lang)
    except OSError as error:
        raise BadInput(
            str(path),
            [InputError(0, "", "", Text("cannot be written: {reason}; choose another place", reason=error.strerror or str(error)))],
        ) from None
    print("\n".join(_summary(found)) if not found.equal else EQUAL)
    print(f"\n{path}")
    return 0


# --- text -------------------------------------------------------------------------------------------------------------------
def text(sides: Sides, found: Comparison, everything: bool) -> Iterator[str]:
    """Which designs; then inputs, verdicts, checks and values, each with what differs first."""
    names = column_names(*(Path(document.place).stem for document, _ in sides))
    wide = max(map(len, names))
    for name, (document, results) in zip(names, sides):
        yield f"{name:<{wide}}  {results.design.name}   {document.place}".rstrip()
    yield ""
    if found.equal:
        yield EQUAL
        return
    yield from _summary(found)
    if found.inputs:
        yield from _table(input_table(found.inputs, names, full=everything))
    yield from _table(verdict_table(found, names, sign))
    yield from _checks(found, names, everything)
    yield from _values(found, names, everything)
    (_, a), (_, b) = sides
    if (measured := compared_table((a.design, a.predicted), (b.design, b.predicted), names)) is not None:
        yield from _table(measured)


def column_names(a: str, b: str) -> Names:
    """The names of the files, where they tell the designs apart and are not too long."""
    return (a, b) if a != b and max(len(a), len(b)) <= LONGEST else ("A", "B")


def _summary(found: Comparison) -> Iterator[str]:
    moved = found.checks_moved
    worse = sum(d.worse for d in moved)
    both = sum(d.both for d in found.values)
    n = len(found.inputs)
    yield "1 input differs." if n == 1 else f"{n} inputs differ."
    n = len(found.steps_moved)
    yield "1 step changes its verdict." if n == 1 else f"{n} steps change their verdict."
    n = len(moved)
    if n == 1:
        yield "1 check changes its verdict, to the worse." if worse else "1 check changes its verdict, to the better."
    elif n:
        yield f"{n} checks change their verdict: {worse} to the worse from A to B, {n - worse} to the better."
    else:
        yield "No check changes its verdict."
    yield f"{both} values differ by more than {short(SAME)} of the larger one."
    if lone := len(found.values) - both:
        yield f"{lone} values stand in one design only."


def _checks(found: Comparison, names: Names, everything: bool) -> Iterator[str]:
    """Those whose verdict moved; then, in the steps that both have, what fails or warns in one design only."""
    moved = found.checks_moved
    if everything:
        tables = [("Checks that differ", found.checks)]
    else:
        tables = [("Checks whose verdict moved", moved), ("Checks of one design only that do not pass", found.checks_lone)]
    shown: set[str] = set()
    for title, rows in tables:
        if rows:
            yield from _table(check_table(rows, names, sign), title)
            shown |= {d.id for d in rows}
    rest = [d for d in found.checks if d.id not in shown]
    if rest and not shown:
        yield from ("", "Checks")
    yield from _further(rest, names, "checks keep their verdict at another value or limit", "further checks stand in {name} only")


def _values(found: Comparison, names: Names, everything: bool) -> Iterator[str]:
    for step in STEPS:
        of_step = [d for d in found.values if d.step == step.key]
        both = [d for d in of_step if d.both]
        shown = of_step if everything else both[:MOST]
        if shown:
            title = (
                Text("{step}: values that differ", step=step.title)
                if everything
                else Text("{step}: values that differ most", step=step.title)
            )
            yield from _table(value_table(step.key, title, shown, names))
        if everything:
            continue
        if not shown and of_step:
            yield from ("", f"{step.title}")
        rest = [d for d in of_step if d not in shown]
        yield from _further(rest, names, "more values differ", "values stand in {name} only")


def _further(rest: Sequence[CheckDifference | ValueDifference], names: Names, differ: str, only: str) -> Iterator[str]:
    """How many are not shown."""
    counts = Counter("both" if d.both else "a" if d.b is None else "b" for d in rest)
    for key, words in (("both", differ), ("a", only.format(name=names[0])), ("b", only.format(name=names[1]))):
        if counts[key]:
            yield f"  {counts[key]} {words} (--all lists them)"


def _table(table: Table, title: str = "") -> Iterator[str]:
    yield ""
    first, *lines = table_lines(table)
    yield title or first
    yield from lines


# --- JSON -------------------------------------------------------------------------------------------------------------------
def comparison_json(sides: Sides, found: Comparison) -> dict[str, Any]:
    """All that differs.  `in` says which design has a check or a value; a number that is not finite is null."""
    return {
        "schema": 1,
        "program": "contralbero",
        "version": VERSION,
        "designs": [{"file": d.place, "name": results.design.name, "sha256": d.sha256} for d, results in sides],
        "equal": found.equal,
        "inputs": [{"key": d.key, "label": d.label, "unit": d.unit, "a": d.a, "b": d.b} for d in found.inputs],
        "steps": {v.step: {"a": v.a.verdict, "b": v.b.verdict, "moved": v.moved} for v in found.verdicts},
        "checks": [
            {"id": d.id, "name": d.name, "moved": d.moved, "in": _where(d), "a": _check(d.a), "b": _check(d.b)} for d in found.checks
        ],
        "values": [
            {
                "id": d.id,
                "label": d.label,
                "unit": d.unit,
                "in": _where(d),
                "relative": finite(d.relative),
                "a": finite(d.a),
                "b": finite(d.b),
            }
            for d in found.values
        ],
    }


def _where(d: CheckDifference | ValueDifference) -> str:
    return "both" if d.both else "a" if d.b is None else "b"


def _check(check: Check | None) -> dict[str, Any] | None:
    if check is None:
        return None
    return {
        "value": finite(check.value),
        "sense": check.sense,
        "limit": list(check.limit) if isinstance(check.limit, tuple) else check.limit,
        "unit": check.unit,
        "margin": finite(check.margin),
        "kind": check.kind,
        "verdict": check.verdict,
    }
