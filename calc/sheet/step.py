# SPDX-License-Identifier: Apache-2.0
"""A step of the design, what solving it gives, and the curves and tables that screen and paper draw."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property, partial
from itertools import chain
from typing import TYPE_CHECKING, Generic, Literal, TypeVar, cast

from .check import Check, stretched
from .curve import Curve as Curve
from .curve import DrawnLoad as DrawnLoad
from .curve import Series as Series
from .curve import Turning as Turning
from .curve import Walk as Walk
from .curve import axis_label as axis_label
from .curve import line_of as line_of
from .curve import said_of
from .deferred import Later, Many
from .errors import NoSolution, text_of
from .number import aligned, brief
from .quantity import Published, insides, published
from .record import record, replace
from .shown import figure, frame, html
from .text import EMPTY, Amount, Name, Text
from .value import Line
from .verdict import Counts, colour_state, counts, grouped, step_state, verdict_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame

State = Literal["solved", "blocked", "not_asked", "no_solution"]
R = TypeVar("R", covariant=True)  # a step's class of results


@record
class Step:
    """One of the steps: its key in the file, its title, the class of its inputs.  `optional`: nothing is missing in a
    design without it."""

    key: str
    title: Text
    inputs: type
    optional: bool = False

    def heads(self, values: Mapping[str, Published]) -> list[Published]:
        """The values that stand for the step: the first of them, or the first two where there is a line for them.  What
        is 0 stands for nothing where another is not."""
        mine = [v for id, v in values.items() if v.headline and v.id == id and id.startswith(f"{self.key}.")]
        present = sorted(mine, key=lambda value: value.headline)
        return [value for value in present if value.shown] or present


@record
class Table:
    """A table of results that belong side by side.  `columns`: (label, unit); cells are Texts, names, numbers in it, or
    None (empty).

    `covers`: values whose ids begin with one of these stand in the table; the report's results leave them out, audit
    excepted.  `short`: it stands in a short report too."""

    id: str
    title: Text
    columns: tuple[tuple[Text, str], ...]
    rows: tuple[tuple[str | float | None, ...], ...]
    note: Text = EMPTY
    covers: tuple[str, ...] = ()
    short: bool = False

    def of_one(self, step: str, name: str) -> "Table":
        """The same as that of one of several shafts."""
        covers = tuple(f"{step}.{name}.{id.removeprefix(f'{step}.')}" for id in self.covers)
        return replace(self, id=f"{name}.{self.id}", title=said_of(name, self.title), covers=covers)


@record
class Erratum:
    """Where a source is wrong: the value that it has, beside the one that is judged, and why."""

    about: str  # id of the value that is judged
    label: Text
    source_value: float  # in the shown unit
    unit: str
    source: Text
    why: Text
    at: tuple[str, str] = ("", "")  # document and lines: its row of tables/errata.toml


@record
class Further:
    """Curves, tables and notes that are made when they are asked for."""

    curves: Many[Curve] = ()
    tables: tuple[Table, ...] = ()
    notes: tuple[Text, ...] = ()


@record
class Outcome(Generic[R]):
    """What solving one step gave.  `state`: solved, blocked (`reason` names what it waits for), not_asked, no_solution.

    `result` is there where the state is solved, and only there.  `computes`: the step is there for its numbers, and
    need not judge anything.

    `further` makes curves, tables and notes that take longer than a keystroke may; who shows them asks for `whole`.
    `key_curves`: of those curves the ones that a short report has too, made when they are looked at.
    """

    key: str
    state: State = "solved"
    result: R | None = None
    checks: tuple[Check, ...] = ()
    lines: Many[Line] = ()
    curves: Many[Curve] = ()
    tables: Many[Table] = ()
    errata: Many[Erratum] = ()
    proposals: tuple[Text, ...] = ()  # what could be done about what was found, and why
    notes: Many[Text] = ()  # assumptions, and what the program chose
    reason: Text = EMPTY
    further: Callable[[], Further] | None = None
    key_curves: Many[Curve] = ()
    computes: bool = False

    def __str__(self) -> str:
        """The verdict, every value by its id, and the checks that are open."""
        shown = aligned(self._title(), ((f"  {v.id}", brief(v.shown), f"{v.unit:<9} {v.label}") for v in self.values()))
        return "\n".join([shown, *(f"  {check}" for check in self.checks if check.open)])

    def _title(self) -> str:
        return f"{self.key}: {self.words()}" + (f", {self.reason}" if self.reason else "")

    def _repr_html_(self) -> str:
        """The same as a table in a notebook."""
        rows = ((v.id, brief(v.shown), f"{v.unit:<9} {v.label}") for v in self.values())
        return html(self._title(), rows, [check for check in self.checks if check.open])

    def to_frame(self) -> "DataFrame":
        """Every value by its id, with its unit and label, as a frame of pandas; empty where the step is not solved."""
        return frame(self.values())

    def plot(self, curve: str = "", ax: "Axes | None" = None) -> "Axes":
        """One of its curves, by its id, with matplotlib; left out: the first.  Returns the axes.  BadInput, with the
        ids that there are, where there is no such curve."""
        every = chain(self.curves, self.whole.curves) if curve else self.curves or self.whole.curves
        return figure(f"{self.key}.plot", every, curve).plot(ax)

    @cached_property
    def whole(self) -> "Outcome[R]":
        """The same outcome with what takes longer, made once."""
        if self.further is None or self.state != "solved":
            return self
        try:
            more = self.further()
        except (NoSolution, ArithmeticError, ValueError) as error:
            more = Further(notes=(Text("Not everything can be shown: {error}.", error=text_of(error)),))
        curves, tables, notes = self.curves + more.curves, self.tables + more.tables, self.notes + more.notes
        return replace(self, curves=curves, tables=tables, notes=notes, further=None)

    @property
    def solution(self) -> R:
        """The result of a step that is known to be solved."""
        assert self.result is not None, self.key
        return self.result

    @cached_property
    def causes(self) -> tuple[tuple[Check, ...], ...]:
        """The checks under their causes, the worst first; asked for at every keystroke."""
        return tuple(grouped(self.checks))

    @cached_property
    def verdict(self) -> str:
        return step_state(self.checks, computes=self.computes) if self.state == "solved" else self.state

    @cached_property
    def counts(self) -> Counts:
        return counts(self.checks)

    @property
    def colour(self) -> str:
        """The state whose colour its verdict has."""
        return colour_state(self.verdict, self.counts)

    def words(self) -> Text:
        """`WARN: 2 cautions`."""
        return verdict_words(self.verdict, self.counts)

    def values(self, wanted: frozenset[str] = frozenset()) -> list[Published]:
        """All values of the step, or those whose ids are `wanted`."""
        return published(self.result, self.key, wanted=wanted) if self.result is not None else []


# --- several shafts: a step has an outcome of each
OF_SHAFTS = ("countershaft", "bearings")  # the steps that each shaft has for itself
WORST: tuple[State, ...] = ("not_asked", "solved", "blocked", "no_solution")


def joined(
    key: str, outcomes: Mapping[str, Outcome[object]], result: R | None, *, named: bool | None = None
) -> Outcome[R]:
    """The outcomes of one step, by the shafts that they are of, as one: its state is the worst of theirs, its reason
    that of the first in it; `named`, as where there are several, each shaft's name stands in ids and before words.

    `result`: of all of them, where every one is solved; None: the only one has its own."""
    first, *others = outcomes.items()
    if not (others or named):
        return cast("Outcome[R]", first[1] if result is None else replace(first[1], result=result))
    worst = max((outcome.state for outcome in outcomes.values()), key=WORST.index)
    reason = next(
        Text("{name}: {reason}", name=Name(name), reason=outcome.reason) if outcome.reason else EMPTY
        for name, outcome in outcomes.items()
        if outcome.state == worst
    )
    every = [(name, outcome) for name, outcome in outcomes.items()]

    longer = [(name, outcome.further) for name, outcome in every if outcome.further is not None]
    return Outcome(
        key,
        worst,
        result if worst == "solved" else None,
        checks=tuple(check.of_one(name, OF_SHAFTS) for name, outcome in every for check in outcome.checks),
        lines=Later(lambda: (line for _, outcome in every for line in outcome.lines)),
        curves=Later(lambda: (curve.of_one(name) for name, outcome in every for curve in outcome.curves)),
        tables=Later(lambda: (table.of_one(key, name) for name, outcome in every for table in outcome.tables)),
        errata=Later(lambda: (erratum for _, outcome in every for erratum in outcome.errata)),
        proposals=tuple(said_of(name, words) for name, outcome in every for words in outcome.proposals),
        notes=Later(lambda: (said_of(name, note) for name, outcome in every for note in outcome.notes)),
        reason=reason,
        further=partial(_further, key, longer) if longer else None,
        key_curves=Later(lambda: (curve.of_one(name) for name, outcome in every for curve in outcome.key_curves)),
        computes=any(outcome.computes for _, outcome in every),
    )


def _further(key: str, longer: Sequence[tuple[str, Callable[[], Further]]]) -> Further:
    more = [(name, make()) for name, make in longer]
    return Further(
        curves=Later(lambda: (curve.of_one(name) for name, one in more for curve in one.curves)),
        tables=tuple(table.of_one(key, name) for name, one in more for table in one.tables),
        notes=tuple(said_of(name, note) for name, one in more for note in one.notes),
    )


def beside(sums: Outcome[object], shafts: Outcome[R]) -> Outcome[R]:
    """What stands of a step for each shaft, behind what is of all of them together."""
    return replace(
        shafts,
        checks=sums.checks + shafts.checks,
        lines=shafts.lines + sums.lines,
        curves=sums.curves + shafts.curves,
        tables=sums.tables + shafts.tables,
        notes=sums.notes + shafts.notes,
    )


def judged(outcomes: Iterable[Outcome[object]], reasons: tuple[tuple[str, str], ...]) -> dict[str, Outcome[object]]:
    """The outcomes by their keys, with what stands outside the validity of its formula known less well, and with the
    checks that the user accepts by id and reason; what there is to say of an entry is a note."""
    by_key = {outcome.key: _stretched(outcome) for outcome in outcomes}
    if not reasons:
        return by_key
    with_checks = [key for key, outcome in by_key.items() if outcome.state == "solved" or outcome.checks]
    for key in with_checks:
        # with the first of them what is of no step, or of one without checks
        others = (id for id, _ in reasons if key == with_checks[0] and id.partition(".")[0] not in with_checks)
        mine = {id: reason for id, reason in reasons if id.startswith(f"{key}.")} | dict.fromkeys(others, "")
        by_key[key] = _accepted(by_key[key], mine) if mine else by_key[key]
    return by_key


def _stretched(outcome: Outcome[R]) -> Outcome[R]:
    checks = stretched(outcome.checks)
    return outcome if checks is outcome.checks else replace(outcome, checks=checks)


def _accepted(outcome: Outcome[R], reasons: dict[str, str]) -> Outcome[R]:
    checks = tuple([replace(c, accepted=reasons[c.id]) if c.id in reasons else c for c in outcome.checks])
    return replace(outcome, checks=checks, notes=outcome.notes + Later(lambda: _of_accepted(checks, reasons)))


def _of_accepted(checks: tuple[Check, ...], reasons: dict[str, str]) -> list[Text]:
    """What there is to say of what is accepted."""
    by_id = {c.id: c for c in checks}
    notes = [Text("{ignored}.", ignored=words) for id in reasons if (words := ignored(id, by_id.get(id)))]
    held = [id for id in reasons if id in by_id and by_id[id].verdict == "pass"]
    return notes + [Text("Accepted without need, since it holds: {id}.", id=id) for id in held]


def ignored(id: str, check: Check | None) -> Text:
    """Why an entry of what is accepted does nothing; empty where it may.  `check`: what it names, where that is there.

    It was written for another version of the design, or of the program: it may stay, and is said."""
    if check is None:
        return Text("Ignored: {id} is accepted, but this design has no such check", id=id)
    if check.kind == "limit":
        return Text("Ignored: {id} is accepted, but is a limit, which nobody can accept", id=id)
    return EMPTY


# --- numbers far outside of what a step is for: a word instead of an infinite value

LARGEST = 1e290  # in SI; beyond it the smallest unit overflows


def finite(result: object, prefix: str, advice: Text) -> None:
    """Raises NoSolution where a value is no number, or infinite."""
    if all(-LARGEST < x < LARGEST for x in insides(result)):
        return
    for value in published(result, prefix):
        if not math.isfinite(value.shown):
            raise NoSolution(value.label, Text("{id} is {shown}", id=value.id, shown=Amount(value.shown)), advice)
