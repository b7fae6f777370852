# SPDX-License-Identifier: Apache-2.0
"""A step of the design, what solving it gives, and the curves and tables that screen and paper draw."""

import cmath
from collections.abc import Callable, Container, Iterator
from dataclasses import replace
from functools import cached_property
from typing import Any

from .check import Check, worst
from .errors import NoSolution
from .quantity import Published, published
from .record import record
from .trace import Line


@record
class Step:
    """One of the six: its key in the file, its title, the class of its inputs.  Of `headlines`, ids of values, the first that a design
    has stands for the step."""

    key: str
    title: str
    inputs: type
    headlines: tuple[str, ...] = ()

    def headline(self, values: Container[str]) -> str | None:
        """The value that stands for the step, of those that there are."""
        return next((id for id in self.headlines if id in values), None)


@record
class Series:
    """One line of a curve, in shown units.  `variant`: the one of the curve's variants that it belongs to; empty: all of them."""

    label: str
    x: Any
    y: Any
    variant: str = ""


@record
class Turning:
    """Vectors set tip to tail, each turning at `orders` times the crank's speed (negative: backward).  Their end runs along a locus.

    Real is up, imaginary is to the right: 90° further in the sense of crank rotation.
    """

    names: tuple[str, ...]
    phasors: tuple[complex, ...]
    orders: tuple[int, ...]
    variant: str = ""

    def at(self, theta: float) -> list[complex]:
        """Origin, tips and end of the chain at a crank angle [rad]."""
        points = [0j]
        for phasor, order in zip(self.phasors, self.orders):
            points.append(points[-1] + phasor * cmath.exp(1j * order * theta))
        return points


@record
class Curve:
    """Data with labels and limit lines; terminal and paper draw the same object.

    `equal`: both axes in true scale.  `bars`: the series are groups of bars at their x; with `names` the groups at 1, 2, … have these, and
    paper lays them on their side.  `variants`: the terminal shows one of them at
    a time, paper all.  `turning`: the vectors whose ends draw the loci.
    `along`: what all series run along, where it is not x, as of loci: its label and its value at each of their points.
    """

    id: str
    title: str
    x_label: str
    y_label: str
    series: tuple[Series, ...]
    limits: tuple[tuple[str, float], ...] = ()
    equal: bool = False
    bars: bool = False
    names: tuple[str, ...] = ()
    variants: tuple[str, ...] = ()
    turning: tuple[Turning, ...] = ()
    along: tuple[str, Any] | None = None


@record
class Table:
    """A table of results that belong side by side.  `columns`: (label, unit); cells are words, numbers in that unit, or None (empty).

    `covers`: values whose ids begin with one of these stand in the table; the report's results leave them out, audit excepted.
    """

    id: str
    title: str
    columns: tuple[tuple[str, str], ...]
    rows: tuple[tuple[str | float | None, ...], ...]
    note: str = ""
    covers: tuple[str, ...] = ()


@record
class Erratum:
    """Where a source is wrong: the value that it has, beside the one that is judged, and why."""

    about: str  # id of the value that is judged
    label: str
    source_value: float  # in the shown unit
    unit: str
    source: str
    why: str


@record
class Further:
    """Curves, tables and notes that are made when they are asked for."""

    curves: tuple[Curve, ...] = ()
    tables: tuple[Table, ...] = ()
    notes: tuple[str, ...] = ()


@record
class Outcome:
    """What solving one step gave.  `state`: solved, blocked (`reason` names what it waits for), not_asked, no_solution.

    `further` makes curves, tables and notes that take longer than a keystroke may; who shows them asks for `whole`.
    """

    key: str
    state: str = "solved"
    result: Any = None
    checks: tuple[Check, ...] = ()
    lines: tuple[Line, ...] = ()
    curves: tuple[Curve, ...] = ()
    tables: tuple[Table, ...] = ()
    errata: tuple[Erratum, ...] = ()
    proposals: tuple[str, ...] = ()  # what could be done about what was found, and why
    notes: tuple[str, ...] = ()  # assumptions, and what the program chose
    reason: str = ""
    further: Callable[[], Further] | None = None

    @cached_property
    def whole(self) -> "Outcome":
        """The same outcome with what takes longer, made once."""
        if self.further is None or self.state != "solved":
            return self
        try:
            more = self.further()
        except (NoSolution, ArithmeticError, ValueError) as error:
            more = Further(notes=(f"Not everything can be shown: {error}.",))
        return replace(
            self, curves=self.curves + more.curves, tables=self.tables + more.tables, notes=self.notes + more.notes, further=None
        )  # fmt: skip

    @property
    def verdict(self) -> str:
        return worst([c.verdict for c in self.checks]) if self.state == "solved" else self.state

    def values(self) -> Iterator[Published]:
        if self.result is not None:
            yield from published(self.result, self.key)
