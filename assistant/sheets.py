# SPDX-License-Identifier: Apache-2.0
"""The calculation of a step made readable: its lines with what is judged by them, what the source has wrong, what is assumed.

Written away from the screen, so that a long calculation can be prepared in another thread.
"""

import math
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from calc.languages import Language
from calc.sheet.check import Check
from calc.sheet.errors import Cancelled
from calc.sheet.quantity import Published
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


def sheet(outcome: Outcome, step: int, say: Language, stop: Callable[[], bool] = bool) -> Sheet:
    """The calculation of an outcome, whose texts are already in the language; `step` is the number of the step.

    Raises Cancelled as soon as `stop` says so.
    """
    from calc.sheet.expression import line_text

    finder = _Finder(outcome)
    line_of: dict[str, int] = {}
    for check in outcome.checks:
        if (index := finder.line(check.id, check.value, check.unit)) is not None:
            line_of[check.id] = index
    for erratum in outcome.errata:
        if (known := finder.values.get(erratum.about)) is not None:
            if (index := finder.line(erratum.about, known.shown, known.unit)) is not None:
                line_of.setdefault(erratum.about, index)
    judged: dict[int, list[Check]] = defaultdict(list)
    for check in outcome.checks:
        judged[line_of.get(check.id, -1)].append(check)
    wrong: dict[int, list[Erratum]] = defaultdict(list)
    for erratum in outcome.errata:
        wrong[line_of.get(erratum.about, -1)].append(erratum)
    entries = []
    for i, line in enumerate(outcome.lines):
        if stop():
            raise Cancelled
        formula, numbers, source = line_text(line, say)
        entries.append(Entry(f"{step}.{i + 1}", line.about, formula, numbers, source, tuple(judged.get(i, ())), tuple(wrong.get(i, ()))))
    return Sheet(tuple(entries), tuple(wrong[-1]), outcome.proposals, outcome.notes, line_of)


ALIKE = 1e-9  # relative: numbers that are one and the same
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


class _Finder:
    """Finds the line that gave a number.  A calculation may have thousands of lines, and every one of them is asked for."""

    def __init__(self, outcome: Outcome) -> None:
        self.lines = outcome.lines
        self.values = {v.id: v for v in outcome.values()}
        self._by_unit: dict[str, list[Published]] = {}
        for v in self.values.values():
            self._by_unit.setdefault(v.unit, []).append(v)
        self._of_object: dict[int, list[int]] = {}  # a value, as an object → its lines
        for i, line in enumerate(self.lines):
            self._of_object.setdefault(id(line.value), []).append(i)
        self._by_size = sorted((size, i) for i, line in enumerate(self.lines) if (size := _size(line.value)) is not None)

    def line(self, key: str, shown: float, unit: str) -> int | None:
        """The line with the very object that was published, else with the same size; of several the one about the same part."""
        if not math.isfinite(shown):
            return None
        words = set(key.replace("_", ".").split("."))
        if key in self.values:
            inside = [self.values[key].inside]
        else:
            same = [v for v in self._by_unit.get(unit, ()) if _same(v.shown, shown)]
            shared = [len(words & set(v.id.replace("_", ".").split("."))) for v in same]
            inside = [v.inside for v, n in zip(same, shared) if n == max(shared)]
        found = [i for x in inside for i in self._of_object.get(id(x), ())]
        if not found and shown:
            found = [*self._of_size(UNITS[unit].inside(shown)), *self._of_size(shown)]
        if not found:
            return None
        return max(found, key=lambda i: (len(words & set(self.lines[i].about.replace("_", " ").split())), i))

    def _of_size(self, size: float) -> Iterator[int]:
        start = bisect_left(self._by_size, (size - 2 * ALIKE * abs(size), -1))
        for other, i in islice(self._by_size, start, None):
            if _same(other, size):
                yield i
            elif other > size:
                return


def _same(a: float, b: float) -> bool:
    return abs(a - b) <= ALIKE * max(abs(a), abs(b))
