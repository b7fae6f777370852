# SPDX-License-Identifier: Apache-2.0
"""All candidates of one bearing with one oil and one supply, at once.

Lengths stand on the step of their input (half millimetres) and clearances on 5 µm, the design's own beside them.  Films
are solved at a few lengths, a tenth apart, and taken between them by a cubic in ln l (below 1e-4 off); what is offered
is solved again where it stands."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from ...countershaft.rows import BearingRow
from ...library.journal_rules import heat_index, specific_load
from ...sheet.arrays import Array, BoolArray, IndexArray
from ...sheet.check import CheckRule
from ...sheet.quantity import described
from ...sheet.record import record
from ...sheet.search import Judged, least, multiples
from ...sheet.units import Metre, Radian
from .. import formulas as f
from ..checks import (
    FILM_DOUBLE_LOAD,
    FILM_EDGE,
    FILM_EDGE_TRUMPLER,
    HEAT_INDEX,
    LENGTH_RATIO_USUAL,
    SPECIFIC_LOAD,
    TEMPERATURE,
    TEMPERATURE_RISE_USUAL,
    TRANSITION,
)
from ..corners import widths
from ..routes import supply
from .states import LEAST_COLD, BearingTask, States, judge, solved, usual
from .variants import SUPPLIES, Variant

LENGTH = described(BearingRow.length)
LENGTH_STEP: Metre = LENGTH.units.inside(LENGTH.step or 0.5)
CLEARANCE_STEP: Metre = 5e-6
SAME = 1e-10  # m
# of the diameter, where the usual ones leave too little oil, or the cold none of them; rule of this program
WIDEST = 2.5e-3
FEW = 4  # steps beyond the least that must be left when cold, whatever the widest; rule of this program
USUAL_FACTORS = described(BearingRow.clearance_factor).usual or (0.0, 1.0)  # K, after Finotti 2013, 5.5.2
APART = math.log(1.1)  # between the lengths that are solved
KEPT = 1e-4  # a margin of a film or its heat below this may be one of the cubic's making
OF_HEAT = (TEMPERATURE, TEMPERATURE_RISE_USUAL)
OF_LOAD = (SPECIFIC_LOAD, HEAT_INDEX)
OF_FILM = (FILM_EDGE, FILM_EDGE_TRUMPLER, FILM_DOUBLE_LOAD, *OF_HEAT, TRANSITION)


@record
class CandidateField:
    """`states`: clearances down, lengths across."""

    task: BearingTask
    variant: Variant
    states: States

    def judged(self, slope: Radian) -> dict[CheckRule, Judged]:
        """Every rule on every candidate, by its declaration."""
        known: dict[Radian, dict[CheckRule, Judged]] = self.__dict__.setdefault("_judged", {})
        if slope not in known:
            known[slope] = {limit.rule.declared: limit for limit in judge(self.task, self.states, slope)}
        return known[slope]

    def passing(self, slope: Radian) -> BoolArray:
        """Which candidates keep every rule."""
        known: dict[Radian, BoolArray] = self.__dict__.setdefault("_passing", {})
        if slope not in known:
            every = self.judged(slope).items()
            known[slope] = np.all([limit.margin >= (KEPT if rule in OF_FILM else 0.0) for rule, limit in every], axis=0)
        return known[slope]

    def wanted(self, slope: Radian) -> tuple[bool, BoolArray]:
        """Those of the candidates that keep every rule which have a usual clearance, else all; and whether they have
        none."""
        every, clearance_limit = self.passing(slope), usual(self.task, self.states.clearance)
        kept = every & (clearance_limit.margin >= 0)
        return not kept.any(), kept if kept.any() else every

    def _least(self, slope: Radian, *rules: CheckRule) -> Array:
        judged = self.judged(slope)
        return least(judged[rule] for rule in rules)

    def holds(self, slope: Radian) -> bool:
        """Whether some candidate keeps the rules on the film that smoother surfaces do not help, whatever its heat and
        size."""
        return bool((self._least(slope, FILM_EDGE_TRUMPLER, FILM_DOUBLE_LOAD, TRANSITION) >= 0).any())

    def hot(self, slope: Radian) -> bool:
        """Whether some candidate has no film or too little oil: a wider clearance, or a thinner oil, may then help the
        film."""
        return bool((self._least(slope, *OF_HEAT) < 0).any())

    def carries(self, slope: Radian) -> bool:
        """Whether some length carries the load, whatever the film."""
        return bool((self._least(slope, *OF_LOAD) >= 0).any())

    def in_room(self) -> "CandidateField | None":
        """The lengths alone that the shaft leaves room for; None: there is none."""
        longest = self.task.room.longest
        if longest is None:
            return self
        n = int((self.states.length[0] <= longest + SAME).sum())
        if n == self.states.length.shape[1]:
            return self
        return replace(self, states=self.states.among(slice(n))) if n else None

    def smoother(self) -> "Iterator[CandidateField]":
        """The same with its own surfaces, and with ever smoother ones."""
        return (replace(self, task=task) for task in self.task.smoother())

    def of(self, twin: BearingTask) -> "CandidateField":
        """The same for another bearing that is alike."""
        return replace(self, task=twin.with_oil(self.variant.lubricant, self.variant.supply, self.variant.fits))

    def change(self) -> Array:
        """From the design: the sum of the relative changes of length, clearance and diameter; rule of this program."""
        task = self.task
        moved = np.abs(self.states.length / task.length - 1) + np.abs(self.states.clearance / task.clearance - 1)
        return np.where(moved < 1e-9, 0.0, moved) + abs(task.seat.bearing.diameter / task.diameter - 1)


def alike(task: BearingTask, other: BearingTask) -> bool:
    """Whether two bearings have the same candidates with the same films."""
    return (
        vars(task.duty) == vars(other.duty)
        and vars(task.seat.bearing) == vars(other.seat.bearing)
        and (task.length, task.clearance, task.room.longest, task.corners)
        == (other.length, other.clearance, other.room.longest, other.corners)
    )


def lengths(task: BearingTask, in_room: bool = False) -> Array:
    """Whole steps within the usual l/d, where asked those in the room alone, and the design's own."""
    inputs, d = task.seat.inputs, task.seat.bearing.diameter
    usual = task.rules[LENGTH_RATIO_USUAL].check.limit
    assert isinstance(usual, tuple)
    lands = supply.lands(inputs)
    lost = (inputs.groove_width or 0.0) if lands == 2 else 0.0
    shortest, longest = (lands * share * d + lost for share in usual)
    shortest = max(shortest, (getattr(inputs, SUPPLIES[inputs.supply]) or 0.0) + LENGTH_STEP)
    if in_room and task.room.longest is not None:
        longest = min(longest, task.room.longest)
    return multiples(LENGTH_STEP, shortest, longest, [task.length] if shortest <= task.length <= longest else [])


def _bearable(task: BearingTask, l: Array) -> Array:
    """The lengths that carry the load whatever the film; the longest alone where none does, so that it can be said by
    how much."""
    if not l.size:
        return l
    inputs, duty = task.seat.inputs, task.duty
    p = specific_load(F=duty.load, d=task.seat.bearing.diameter, l=supply.bare_length(inputs, l))
    W = heat_index(F=duty.load, n=duty.speed, l=l)
    carries = least([task.rules[SPECIFIC_LOAD].on(p), task.rules[HEAT_INDEX].on(W)]) >= 0
    return l[carries] if carries.any() else l[-1:]


def clearances(task: BearingTask, widest: Metre, few: int = 0) -> Array:
    """Whole 5 µm from the least that must be left when cold up to the widest, a few steps at least, and the design's
    own."""
    seat, d = task.seat, task.seat.bearing.diameter
    T_J, T_S = widths(seat.inputs, d)
    shrinks = seat.clearance - seat.clearance_at(seat.inputs.lowest_temperature)
    half = (T_J + T_S) / 2
    narrowest = shrinks + (LEAST_COLD + half if task.corners else max(LEAST_COLD, half))
    if widest < narrowest and not few:
        return np.array([])
    widest = max(widest, task.clearance, narrowest + few * CLEARANCE_STEP)
    given = [task.clearance] if narrowest <= task.clearance else []
    return multiples(CLEARANCE_STEP, max(narrowest, CLEARANCE_STEP), widest, given)


def widest_usual(task: BearingTask) -> Metre:
    """The clearance of the greatest factor K that is usual."""
    d = task.seat.bearing.diameter
    return f.clearance_by_factor(K=USUAL_FACTORS[1], d=d, u=f.surface_speed(d=d, n=task.duty.speed))


def field(task: BearingTask, variant: Variant, slope: Radian, in_room: bool = False) -> CandidateField | None:
    """With clearances wider than the usual ones where nothing passes with these and some have too little oil, which may
    thin the film too; None where no length is left to look at."""
    at = task.with_oil(variant.lubricant, variant.supply, variant.fits)
    l = _bearable(at, lengths(at, in_room))
    usual = field_over(at, variant, l, clearances(at, widest_usual(at)))
    if usual is not None and (not usual.hot(slope) or not usual.carries(slope) or usual.passing(slope).any()):
        return usual
    return field_over(at, variant, l, clearances(at, WIDEST * at.seat.bearing.diameter, FEW)) or usual


def field_over(at: BearingTask, variant: Variant, l: Array, g: Array) -> CandidateField | None:
    """Lengths `l` and clearances `g`, both rising; None where there are none."""
    if not l.size or not g.size:
        return None
    few, between = over_lengths(l)
    states = solved(at, few, g[:, None], all_rises=False)
    if few is l:
        return CandidateField(at, variant, states)
    many = {name: between(getattr(states, name)) for name in ("film", "rise", "viscosity", "power", "flow")}
    return CandidateField(at, variant, States(*np.broadcast_arrays(l, g[:, None]), **many))


def over_lengths(l: Array) -> tuple[Array, Callable[[Array], Array]]:
    """A few lengths that films are solved at, and how numbers at these, along the last axis, become those at all; `l`
    itself where these are few."""
    spread = math.log(l[-1] / l[0])
    nodes = max(math.ceil(spread / APART) + 1, 4)
    if l.size <= nodes:
        return l, lambda numbers: numbers
    x = np.linspace(0.0, spread, nodes)
    first, weights = _cubic(x, np.log(l / l[0]))

    def between(numbers: Array) -> Array:
        parts = [weights[i] * numbers[..., first + i] for i in range(4)]
        all_of_them: Array = parts[0] + parts[1] + parts[2] + parts[3]
        return all_of_them

    return l[0] * np.exp(x), between


def _cubic(x: Array, at: Array) -> tuple[IndexArray, list[Array]]:
    """For other points than the evenly spaced nodes x: the first of the four nodes about each, and the weights of the
    four."""
    first = np.clip(np.searchsorted(x, at) - 2, 0, x.size - 4)
    near = [x[first + k] for k in range(4)]
    return first, [
        np.prod([(at - near[k]) / (near[i] - near[k]) for k in range(4) if k != i], axis=0) for i in range(4)
    ]
