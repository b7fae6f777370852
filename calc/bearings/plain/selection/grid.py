# SPDX-License-Identifier: Apache-2.0
"""All candidates of one bearing with one oil and one supply, at once.

Lengths stand on the step of their input (half millimetres) and clearances on 5 µm, or 2 µm of small journals, the
design's own beside them.  Films
are solved at a few lengths, a tenth apart, and taken between them by a cubic in ln l (below 1e-4 off, 2e-3 where an oil
begins to thin by shear)."""

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from ....countershaft.rows import BearingRow
from ....library.journal_rules import specific_load
from ....sheet.arrays import Array, BoolArray, IndexArray
from ....sheet.check import THIN_MARGIN, CheckRule
from ....sheet.quantity import described
from ....sheet.record import record, replace
from ....sheet.search import Judged, least, multiples
from ....sheet.units import Metre, Number, Radian
from ..checks import FILM_EDGE, LENGTH_RATIO, SPECIFIC_LOAD, TEMPERATURE
from ..routes import supply
from ..suitability import MATERIAL_LOAD
from .states import EDGES, FILM_NUMBERS, BearingTask, Index, States, judge, solved_at
from .variants import SUPPLIES, Variant

LENGTH = described(BearingRow.length)
LENGTH_STEP: Metre = LENGTH.units.inside(LENGTH.step or 0.5)
CLEARANCE_STEP: Metre = 5e-6
SMALL, FINE_STEP = 45e-3, 2e-6  # m: journals below have clearances in finer steps
SAME = 1e-10  # m
WIDEST = 2.5e-3  # of the diameter: within what makers have; rule of this program
FEW = 4  # steps beyond the least that must be left when cold, whatever the widest; rule of this program
APART = math.log(1.1)  # between the lengths that are solved
KEPT = 1e-4  # a margin of a film or its heat below this may be one of the cubic's making
OF_LOAD = (SPECIFIC_LOAD, MATERIAL_LOAD)
OF_FILM = (*EDGES, TEMPERATURE)


@record
class CandidateField:
    """`states`: clearances down, lengths across.  `spare`: that the films have to have left, as a share of their
    limit."""

    task: BearingTask
    variant: Variant
    states: States
    spare: Number = 0.0

    def judged(self, slope: Radian) -> dict[CheckRule, Judged]:
        """Every rule on every candidate, by its declaration."""
        known: dict[Radian, dict[CheckRule, Judged]] = self.__dict__.setdefault("_judged", {})
        if slope not in known:
            known[slope] = {limit.rule.declared: limit for limit in judge(self.task, self.states, slope)}
        return known[slope]

    def passing(self, slope: Radian, film: Metre = 0.0) -> BoolArray:
        """Which candidates keep every rule, and have this film at the edge."""
        known: dict[Radian, BoolArray] = self.__dict__.setdefault("_passing", {})
        if slope not in known:
            spare = self.spare + KEPT
            every = self.judged(slope).items()
            known[slope] = np.all(
                [
                    limit.margin >= (spare if rule in EDGES else KEPT if rule in OF_FILM else 0.0)
                    for rule, limit in every
                ],
                axis=0,
            )
        return known[slope] & (self.film(slope) >= film) if film else known[slope]

    @property
    def steps(self) -> list[float]:
        """Its clearances in µm beyond the design's, to be held against those of bearings that are alike."""
        return [round((g - self.task.clearance) * 1e6, 3) for g in self.states.clearance[:, 0].tolist()]

    def _kept(self, slope: Radian, *rules: CheckRule) -> BoolArray:
        judged = self.judged(slope)
        kept: BoolArray = least(judged[rule] for rule in rules if rule in judged) >= 0
        return kept

    def film(self, slope: Radian) -> Array:
        """At the edge at the worst corner, in m."""
        return self.judged(slope)[FILM_EDGE].value * 1e-6

    def hot(self, slope: Radian) -> bool:
        """Whether some candidate has no film or too little oil: a wider clearance, or a thinner oil, may then help the
        film."""
        return not self._kept(slope, TEMPERATURE).all()

    def carries(self, slope: Radian) -> bool:
        """Whether some length carries the load, whatever the film."""
        loads = [rule for rule in OF_LOAD if rule in self.task.rules]
        return not loads or bool(self._kept(slope, *loads).any())

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

    def at(self, index: Index) -> States:
        """One candidate, as if it had been solved alone."""
        shown = {
            name: np.broadcast_to(getattr(self.states, name), self.states.power.shape)
            for name in ("length", "clearance")
        }
        numbers = shown | {name: getattr(self.states, name) for name in FILM_NUMBERS}
        return States(**{name: array[(..., *np.atleast_1d(index))][..., None] for name, array in numbers.items()})

    def change(self) -> Array:
        """From the design: the sum of the relative changes of length, clearance and diameter; rule of this program."""
        task = self.task
        moved = np.abs(self.states.length / task.length - 1) + np.abs(self.states.clearance / task.clearance - 1)
        return np.where(moved < 1e-9, 0.0, moved) + abs(task.size / task.diameter - 1)

    def area(self) -> Array:
        """d·l, of every candidate."""
        return self.task.size * np.broadcast_to(self.states.length, self.states.power.shape)


def lengths(task: BearingTask, in_room: bool = False) -> Array:
    """Whole steps within the l/d of the search, where asked those in the room alone; at the design's own diameter its
    own length too."""
    inputs, d = task.seat.inputs, task.size
    ratios = task.rules[LENGTH_RATIO].check.limit
    assert isinstance(ratios, tuple)
    lands = supply.lands(inputs)
    lost = (inputs.groove_width or 0.0) if lands == 2 else 0.0
    shortest, longest = (lands * share * d + lost for share in ratios)
    shortest = max(shortest, (getattr(inputs, SUPPLIES[inputs.supply]) or 0.0) + LENGTH_STEP)
    if in_room and task.room.longest is not None:
        longest = min(longest, task.room.longest)
    own = [task.length] if task.own_size and shortest <= task.length <= longest else []
    return multiples(LENGTH_STEP, shortest, longest, own)


def _bearable(task: BearingTask, l: Array) -> Array:
    """The lengths that carry the load whatever the film; the longest alone where none does, so that it can be said by
    how much."""
    loads = [task.rules[rule] for rule in OF_LOAD if rule in task.rules]
    if not l.size or not loads:
        return l
    p = specific_load(F=task.duty.load, d=task.size, l=supply.bare_length(task.seat.inputs, l))
    carries = least(load.on(p) for load in loads) >= 0
    return l[carries] if carries.any() else l[-1:]


def clearance_step(d: Metre) -> Metre:
    """Of a journal of this diameter."""
    return FINE_STEP if d < SMALL else CLEARANCE_STEP


def clearances(task: BearingTask, few: int = FEW) -> Array:
    """Whole steps from the least whose tightest corner is left when cold up to the widest, a few steps at least; at the
    design's own diameter its own clearance too.  Where limits of parts make it, whole steps from the design's own, so
    that they move by these."""
    seat, step = task.seat, clearance_step(task.size)
    shrinks = seat.clearance - seat.clearance_at(seat.inputs.lowest_temperature)
    narrowest = max(shrinks + task.half, 0.0) / (1 - THIN_MARGIN) + SAME
    widest = max(WIDEST * task.size, narrowest + few * CLEARANCE_STEP)
    if task.field is not None:
        return task.clearance + multiples(step, narrowest - task.clearance, widest - task.clearance)
    own = [task.clearance] if task.own_size and narrowest <= task.clearance else []
    return multiples(step, max(narrowest, step), max([widest, *own]), own)


def same_films(some: Sequence[BearingTask], others: Sequence[BearingTask]) -> bool:
    """Whether two bearings have the same candidates with the same films, at each of their diameters."""
    return len(some) == len(others) and all(
        not (a.own_size or b.own_size)
        and (a.size, a.half, a.corners, vars(a.duty), vars(a.faster))
        == (b.size, b.half, b.corners, vars(b.duty), vars(b.faster))
        and a.room.longest == b.room.longest
        and a.seat.inputs.of(a.seat.bearing) == b.seat.inputs.of(b.seat.bearing)
        and a.rules[LENGTH_RATIO].check.limit == b.rules[LENGTH_RATIO].check.limit
        and a.seat.rings == b.seat.rings
        and (a.field is None or a.clearance == b.clearance)
        for a, b in zip(some, others)
    )


def fields(tasks: Sequence[BearingTask], variant: Variant, in_room: bool = False) -> list[CandidateField]:
    """Of one bearing, at each diameter that has a length to look at, all solved together."""
    there = [task.with_oil(variant.lubricant, variant.supply, variant.fits) for task in tasks]
    grids = [(at, _bearable(at, lengths(at, in_room)), clearances(at)) for at in there]
    return fields_over([grid for grid in grids if grid[1].size and grid[2].size], variant)


def field_over(at: BearingTask, variant: Variant, l: Array, g: Array) -> CandidateField | None:
    """Lengths `l` and clearances `g`, both rising; None where there are none."""
    return fields_over([(at, l, g)], variant)[0] if l.size and g.size else None


def fields_over(grids: Sequence[tuple[BearingTask, Array, Array]], variant: Variant) -> list[CandidateField]:
    """Of one bearing at several diameters, each with its lengths and its clearances, both rising."""
    if not grids:
        return []
    nodes = [(task, *over_lengths(l), l, g) for task, l, g in grids]
    flat = [np.broadcast_arrays(task.size, few, g[:, None], task.half) for task, few, _, _, g in nodes]
    d, l_at, g_at, half = (np.concatenate([row[i].ravel() for row in flat]) for i in range(4))
    states = solved_at(grids[0][0], d, l_at, g_at, half, all_rises=False)
    found, end = [], 0
    for (task, _, between, l, g), shape in zip(nodes, (row[0].shape for row in flat)):
        part, end = slice(end, end + math.prod(shape)), end + math.prod(shape)
        numbers = {
            name: between(getattr(states, name)[..., part].reshape((*getattr(states, name).shape[:-1], *shape)))
            for name in FILM_NUMBERS
        }
        found.append(CandidateField(task, variant, States(*np.broadcast_arrays(l, g[:, None]), **numbers)))
    return found


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
