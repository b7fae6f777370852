# SPDX-License-Identifier: Apache-2.0
"""A step of the design, what solving it gives, and the curves that screen and paper draw."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from .check import Check, worst
from .quantity import Published, published
from .trace import Line


@dataclass(frozen=True, slots=True)
class Step:
    """One of the six: its key in the file, its title, the class of its inputs."""

    key: str
    title: str
    inputs: type


@dataclass(frozen=True, slots=True)
class Series:
    """One line of a curve, in shown units."""

    label: str
    x: Any
    y: Any


@dataclass(frozen=True, slots=True)
class Curve:
    """Data with labels and limit lines; terminal and paper draw the same object.  `equal`: both axes in true scale."""

    id: str
    title: str
    x_label: str
    y_label: str
    series: tuple[Series, ...]
    limits: tuple[tuple[str, float], ...] = ()
    equal: bool = False


@dataclass(frozen=True, slots=True)
class Erratum:
    """Where a source is wrong: the value that it has, beside the one that is judged, and why."""

    about: str  # id of the value that is judged
    label: str
    source_value: float  # in the shown unit
    unit: str
    source: str
    why: str


@dataclass(frozen=True, slots=True)
class Outcome:
    """What solving one step gave.  `state`: solved, blocked (`reason` names what it waits for), not_asked, no_solution."""

    key: str
    state: str = "solved"
    result: Any = None
    checks: tuple[Check, ...] = ()
    lines: tuple[Line, ...] = ()
    curves: tuple[Curve, ...] = ()
    errata: tuple[Erratum, ...] = ()
    notes: tuple[str, ...] = ()  # assumptions, and what the program chose
    reason: str = ""

    @property
    def verdict(self) -> str:
        return worst([c.verdict for c in self.checks]) if self.state == "solved" else self.state

    def values(self) -> Iterator[Published]:
        if self.result is not None:
            yield from published(self.result, self.key)
