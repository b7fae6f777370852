# SPDX-License-Identifier: Apache-2.0
"""The calculation of a step made readable: its lines with what is judged by them, what the source has wrong, what is
assumed.

Written away from the screen, so that a long calculation can be prepared in another thread.
"""

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from calc.design.key_values import judged
from calc.locale import Language
from calc.locale.language import in_language
from calc.sheet.check import Check
from calc.sheet.errors import Cancelled
from calc.sheet.step import Erratum, Outcome, Table
from calc.sheet.text import EMPTY, Name, Text
from calc.sheet.value import leaves, link_of


@dataclass(frozen=True)
class SheetEntry:
    """One line of the calculation."""

    number: str  # 3.12
    about: str
    formula: str
    numbers: str
    source: str
    checks: tuple[
        tuple[Check, str], ...
    ] = ()  # each with its verdict, or that it holds outside the validity of its formula
    errata: tuple[Erratum, ...] = ()

    def text(self) -> str:
        return f"{self.formula} {self.numbers}   [{self.source}]"

    def value(self) -> str:
        return self.numbers.rpartition("= ")[2].partition("   (")[0]


@dataclass(frozen=True)
class CalculationSheet:
    """The calculation of one step.  `line_of`: which entry a check or a value comes from."""

    entries: tuple[SheetEntry, ...] = ()
    errata: tuple[Erratum, ...] = ()  # those that belong to no single line
    proposals: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    line_of: dict[str, int] = field(default_factory=dict)


def sheet(outcome: Outcome[object], step: int, say: Language, stop: Callable[[], bool] = bool) -> CalculationSheet:
    """The calculation of an outcome, whose texts are already in the language; `step` is the number of the step.

    Raises Cancelled as soon as `stop` says so.
    """
    from calc.sheet.expression import line_text

    number_of = {line: i for i, line in enumerate(outcome.lines)}
    values = {v.id: v.inside for v in outcome.values()}

    def number_of_line(*numbers: Any) -> int | None:
        """The line that gave the first of these numbers that one gave."""
        return next((number_of[leaf] for x in numbers for leaf in leaves(link_of(x)) if leaf in number_of), None)

    line_of: dict[str, int] = {}
    for check in outcome.checks:
        if (index := number_of_line(values.get(check.value_id), check.value)) is not None:
            line_of[check.id] = index
    for erratum in outcome.errata:
        if (index := number_of_line(values.get(erratum.about))) is not None:
            line_of.setdefault(erratum.about, index)
    by_line: dict[int, list[tuple[Check, str]]] = defaultdict(list)
    for check in outcome.checks:
        by_line[line_of.get(check.id, -1)].append((check, judged(check, outcome.checks)))
    wrong: dict[int, list[Erratum]] = defaultdict(list)
    for erratum in outcome.errata:
        wrong[line_of.get(erratum.about, -1)].append(erratum)
    entries = []
    for i, line in enumerate(outcome.lines):
        if stop():
            raise Cancelled
        formula, numbers, source = line_text(line, say, say.number)
        checks, errata = tuple(by_line.get(i, ())), tuple(wrong.get(i, ()))
        entries.append(SheetEntry(f"{step}.{i + 1}", say(line.about), formula, numbers, source, checks, errata))
    return CalculationSheet(tuple(entries), tuple(wrong[-1]), outcome.proposals, tuple(outcome.notes), line_of)


VALUES = "values"  # the table of all values of a step; the id of each stands in its last column


def values_table(outcome: Outcome[object], say: Language) -> Table:
    """Every value that a step publishes."""
    rows = tuple((v.label, v.shown, v.unit, v.id) for v in outcome.values())
    table = Table(
        VALUES,
        Text("All values of this step"),
        ((Text("Value"), ""), (EMPTY, ""), (Text("Unit"), ""), (Name("id"), "")),
        rows,
    )
    return in_language(table, say)
