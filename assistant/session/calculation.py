# SPDX-License-Identifier: Apache-2.0
"""The calculation of a step made readable: its lines with what is judged by them, what the source has wrong, what is
assumed; and how far the inputs move what is judged.

Written away from the screen, so that a long calculation can be prepared in another thread.
"""

import math
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from calc.design.addresses import quantity_of, value_at
from calc.design.key_results import judged
from calc.design.labels import label_of
from calc.locale import Language
from calc.locale.language import in_language
from calc.sheet.check import Check
from calc.sheet.errors import BadInput, Cancelled
from calc.sheet.expression import line_text
from calc.sheet.step import Erratum, Outcome, Table
from calc.sheet.text import EMPTY, SEMICOLON, Amount, Name, Small, Text
from calc.sheet.value import leaves, link_of

if TYPE_CHECKING:
    from calc.design.addresses import Table as DesignTable
    from calc.studies.explain import Effect

NAMED = 2  # inputs that are named for a check, and checks for an input
DIFFERENCES = {"°C": "K"}  # the unit of a difference, where it is another
LEAST = 0.01  # that a slope comes to in figures: of what moves less, for so many tens of steps


@dataclass(frozen=True)
class SheetEntry:
    """One line of the calculation."""

    number: str  # 3.12
    about: str
    formula: str
    numbers: str
    source: str
    # each with its verdict, or that it holds outside the validity of its formula
    checks: tuple[tuple[Check, str], ...] = ()
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
        by_line[line_of.get(check.id, -1)].append((check, judged(check)))
    wrong: dict[int, list[Erratum]] = defaultdict(list)
    for erratum in outcome.errata:
        wrong[line_of.get(erratum.about, -1)].append(erratum)
    entries = []
    for i, line in enumerate(outcome.lines):
        if stop():
            raise Cancelled
        formula, numbers, source = map(say, line_text(line, say, say.number))
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


# --- how far the inputs move a check, and what an input moves


def slopes_of_check(data: "DesignTable", check: Check, effects: "tuple[Effect, ...]") -> Text:
    """`clearance −0.32 µm per µm; length +0.45 µm per mm`: the inputs that move a check most, over what they are."""
    known = [effect for effect in effects if effect.gain]
    known.sort(key=lambda effect: -abs((effect.gain or 0.0) * _size(data, effect.key)))
    return SEMICOLON.join(_slope_of(data, check, effect) for effect in known[:NAMED])


def _slope_of(data: "DesignTable", check: Check, effect: "Effect") -> Text:
    """What an input does to the value that is judged, or, where it leaves that alone, to its limit."""
    step, words = _step(data, effect.key), label_of(data, effect.key)
    if effect.slope:
        return _slope(words, effect.slope, check.unit, step)
    gain = effect.gain or 0.0
    below = check.nearest[1] == check.limit[0] if isinstance(check.limit, tuple) else check.sense in (">=", ">")
    return _slope(Text("{input}: limit", input=words), -gain if below else gain, check.unit, step)


def slopes_of_input(data: "DesignTable", key: str, moved: "tuple[tuple[Check, Effect], ...]") -> Text:
    """`film at the edge, front +0.45 µm per mm`: what an input moves most of the limits that it is meant for."""
    seen: dict[str, tuple[Check, Effect]] = {}
    for check, effect in moved:
        if (
            check.kind == "limit"
            and effect.slope
            and any(f"{key}.".startswith(f"{prefix}.") for prefix in check.moved_by)
        ):
            seen.setdefault(check.cause or check.id, (check, effect))
    step = _step(data, key)
    return SEMICOLON.join(
        _slope(Small(check.name), response.slope or 0.0, check.unit, step)
        for check, response in list(seen.values())[:NAMED]
    )


def _slope(what: Text, slope: float, unit: str, step: tuple[float, str]) -> Text:
    """`length +0.2 µm per 0.5 mm`: for so much of an input as one goes on by, or tens of it where that does next to
    nothing."""
    size, of = step
    while abs(slope * size) < LEAST:
        size *= 10
    per = Name(of) if size == 1 and of else Amount(size, of)
    moved = Amount(float(f"{slope * size:.2g}"), DIFFERENCES.get(unit, unit), form="+.3g")
    return Text("{what} {slope} per {per}", what=what, slope=moved, per=per)


def _step(data: "DesignTable", key: str) -> tuple[float, str]:
    """By how much one goes on with an input, and its unit: the step of its field, or else a round tenth of what it
    is."""
    about, size = quantity_of(data, key), _size(data, key)
    unit = DIFFERENCES.get(about.unit, about.unit)
    if about.step or about.kind == "integer":
        return about.step or 1.0, unit
    return (10.0 ** round(math.log10(size / 10)) if size else 1.0), unit


def _size(data: "DesignTable", key: str) -> float:
    try:
        value = value_at(data, key)
    except BadInput:
        return 0.0
    numbers = [abs(x) for x in (value if isinstance(value, list) else [value]) if isinstance(x, (int, float))]
    return max(numbers, default=0.0)
