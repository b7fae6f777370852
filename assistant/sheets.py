# SPDX-License-Identifier: Apache-2.0
"""The calculation of a step made readable: its lines with what is judged by them, what the source has wrong, what is assumed.

Written away from the screen, so that a long calculation can be prepared in another thread.
"""

import math
from dataclasses import dataclass, field
from typing import Any

from calc.languages import Language
from calc.sheet.check import Check
from calc.sheet.step import Erratum, Outcome, Table
from calc.sheet.units import UNITS


@dataclass(frozen=True)
class Entry:
    """One line of the calculation."""

    number: str  # 3.12
    about: str
    formula: str
    numbers: str
    source: str
    checks: tuple[Check, ...] = ()
    errata: tuple[Erratum, ...] = ()

    def text(self) -> str:
        return f"{self.formula} {self.numbers}   [{self.source}]"

    def value(self) -> str:
        return self.numbers.rpartition("= ")[2].partition("   (")[0]


@dataclass(frozen=True)
class Sheet:
    """The calculation of one step.  `line_of`: which entry a check or a value comes from."""

    entries: tuple[Entry, ...] = ()
    errata: tuple[Erratum, ...] = ()  # those that belong to no single line
    proposals: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    line_of: dict[str, int] = field(default_factory=dict)


def sheet(outcome: Outcome, step: int, say: Language) -> Sheet:
    """The calculation of an outcome, whose texts are already in the language; `step` is the number of the step."""
    from calc.sheet.expression import line_text

    values = {v.id: v for v in outcome.values()}
    sizes = [_size(line.value) for line in outcome.lines]
    line_of: dict[str, int] = {}
    for check in outcome.checks:
        if (index := _line(check.id, check.value, check.unit, outcome, values, sizes)) is not None:
            line_of[check.id] = index
    for erratum in outcome.errata:
        if (known := values.get(erratum.about)) is not None:
            if (index := _line(erratum.about, known.shown, known.unit, outcome, values, sizes)) is not None:
                line_of.setdefault(erratum.about, index)
    entries = []
    for i, line in enumerate(outcome.lines):
        formula, numbers, source = line_text(line, say)
        entries.append(
            Entry(
                f"{step}.{i + 1}", line.about, formula, numbers, source,
                tuple(c for c in outcome.checks if line_of.get(c.id) == i), tuple(e for e in outcome.errata if line_of.get(e.about) == i),
            )
        )  # fmt: skip
    rest = tuple(e for e in outcome.errata if e.about not in line_of)
    return Sheet(tuple(entries), rest, outcome.proposals, outcome.notes, line_of)


VALUES = "values"  # the table of all values of a step; the id of each stands in its last column


def values_table(outcome: Outcome, say: Language) -> Table:
    """Every value that a step publishes."""
    rows = tuple((say(v.label), v.shown, v.unit, v.id) for v in outcome.values())
    return Table(VALUES, say("All values of this step"), ((say("Value"), ""), ("", ""), (say("Unit"), ""), ("id", "")), rows)


def _size(value: Any) -> float | None:
    """The number that a line ends with, where it is a single one."""
    if isinstance(value, complex):
        return abs(value)
    try:
        return float(value) if getattr(value, "shape", ()) == () else None
    except (TypeError, ValueError):
        return None


def _line(id: str, shown: float, unit: str, outcome: Outcome, values: dict[str, Any], sizes: list[float | None]) -> int | None:
    """The line that gave a number: the very object that was published, else the same size; of several the one about the same part."""
    if not math.isfinite(shown):
        return None
    words = set(id.replace("_", ".").split("."))
    if id in values:
        inside = [values[id].inside]
    else:
        same = [v for v in values.values() if v.unit == unit and _same(v.shown, shown)]
        shared = [len(words & set(v.id.replace("_", ".").split("."))) for v in same]
        inside = [v.inside for v, n in zip(same, shared) if n == max(shared)]
    found = [i for i, line in enumerate(outcome.lines) if any(line.value is x for x in inside)]
    if not found and shown:
        number = UNITS[unit].inside(shown)
        found = [i for i, size in enumerate(sizes) if size is not None and (_same(size, number) or _same(size, shown))]
    if not found:
        return None
    return max(found, key=lambda i: (len(words & set(outcome.lines[i].about.replace("_", " ").split())), i))


def _same(a: float, b: float) -> bool:
    return abs(a - b) <= 1e-9 * max(abs(a), abs(b))
