# SPDX-License-Identifier: Apache-2.0
"""From all candidates to the few that are offered: the least friction, the smallest, the nearest to the design, the
Pareto set.

The bearings do not know of each other while oil and supply are the same: each is chosen for itself.  Those whose parts
are picked by classes have one diameter and one clearance, and are chosen together."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from ....sheet.arrays import Array
from ....sheet.check import Check
from ....sheet.record import record
from ....sheet.search import first, governing, least
from ....sheet.text import EMPTY, Text
from ....sheet.units import Celsius, Metre, Number, Radian, SquareMetre, Watt
from ..checks import FILM_EDGE, TEMPERATURE
from .grid import CandidateField
from .states import BearingTask, Index, States, check_of, judge, solved
from .variants import Variant

ONE_PER_CENT = math.log(1.01)  # powers are alike within it, so that the smaller bearing goes first
MOST = 10  # rows of the Pareto set
STEPS = (0.1e-6, 0.2e-6, 0.25e-6, 0.5e-6, 1e-6, 2e-6, 5e-6, 10e-6)  # of film between them

Fields = Mapping[str, Sequence[CandidateField]]  # of one variant: by bearing, front to rear, a field for each diameter
Slopes = Mapping[str, Radian]


class Wanted(NamedTuple):
    """What bearings are chosen by, of one or of many candidates; the sums where several are meant.  `level`: by how
    many steps the surfaces are smoother, `excess`: the length beyond the room."""

    power: Array
    area: Array
    level: Array
    change: Array
    excess: Array

    @classmethod
    def of(cls, field: CandidateField) -> "Wanted":
        """Of every candidate."""
        shape, room = field.states.power.shape, field.task.room.longest
        excess = np.zeros(shape) if room is None else np.maximum(field.states.length - room, 0.0)
        return cls(field.states.power, field.area(), np.full(shape, field.task.level), field.change(), excess)

    def at(self, index: Index) -> "Wanted":
        return Wanted(*(numbers[index] for numbers in self))


# what is wanted least, then what of equal ones, and so on
Order = Callable[[Wanted], tuple[Array, ...]]


@record
class Pick:
    """One bearing as it is offered, its `films` of shape (states, 1).  `corner`: the state that governs."""

    task: BearingTask
    length: Metre
    clearance: Metre
    power: Watt
    film_edge: Metre
    film_asked: Metre
    outlet: Celsius
    margin: Number
    checks: tuple[Check, ...]  # every rule on it
    governing: Check
    corner: Text
    films: States

    @property
    def diameter(self) -> Metre:
        return self.task.size

    @property
    def area(self) -> SquareMetre:
        return self.diameter * self.length

    @property
    def change(self) -> Number:
        task = self.task
        return (
            abs(self.length / task.length - 1)
            + abs(self.clearance / task.clearance - 1)
            + abs(self.diameter / task.diameter - 1)
        )

    def solved(self, slope: Radian) -> "Pick":
        """Solved where it stands, and judged with this slope."""
        return picks(self.task, [self.length], [self.clearance], slope)[0]


@record
class CandidateRow:
    """All bearings with one oil and supply, front to rear.  `what`: now, offered, too long, more film."""

    what: str
    variant: Variant
    picks: tuple[Pick, ...]

    @property
    def power(self) -> Watt:
        return sum(pick.power for pick in self.picks)

    @property
    def film(self) -> Metre:
        """The thinnest of them, at the edge and the worst corner."""
        return min(pick.film_edge for pick in self.picks)

    @property
    def margin(self) -> Number:
        return min(pick.margin for pick in self.picks)

    @property
    def change(self) -> Number:
        return sum(pick.change for pick in self.picks)

    @property
    def wanted(self) -> Wanted:
        sums = (self.power, sum(pick.area for pick in self.picks), self.level, self.change, sum(self.too_long))
        return Wanted(*map(np.asarray, sums))

    @property
    def corners(self) -> bool:
        """Whether it is judged at the corners of the tolerances, or as given."""
        return all(pick.task.corners for pick in self.picks)

    @property
    def level(self) -> int:
        """By how many steps the surfaces are smoother."""
        return sum(pick.task.level for pick in self.picks)

    @property
    def too_long(self) -> tuple[Metre, ...]:
        """By how much each journal is longer than its room; 0: it fits, or its room is not known."""
        return tuple(
            max(pick.length - pick.task.room.longest, 0.0) if pick.task.room.longest else 0.0 for pick in self.picks
        )


def picks(task: BearingTask, length: Sequence[float], clearance: Sequence[float], slope: Radian) -> list[Pick]:
    """Bearings of one task, solved together; length and clearance are lists of the same length."""
    there = solved(task, length, clearance)
    return [_pick(task, there.among(slice(i, i + 1)), slope) for i in range(len(there.length))]


def _pick(task: BearingTask, films: States, slope: Radian) -> Pick:
    limits = {limit.rule.declared: limit for limit in judge(task, films, slope)}
    worst = governing(limits.values(), 0)
    state = worst.where if isinstance(worst.where, Text) else int(np.broadcast_to(worst.where, (1,))[0])
    corner = state if isinstance(state, Text) else task.states[state].name if state > 0 else EMPTY
    film = limits[FILM_EDGE]
    return Pick(
        task,
        float(films.length[0]),
        float(films.clearance[0]),
        float(films.power[0]),
        float(film.value[0]) * 1e-6,
        film.rule.check.nearest[1] * 1e-6,
        float(limits[TEMPERATURE].value[0]),
        float(least(limits.values())[0]),
        tuple(check_of(limit, 0) for limit in limits.values()),
        check_of(worst, 0),
        corner,
        films,
    )


# --- orders


def by_power(wanted: Wanted) -> tuple[Array, ...]:
    """The least power, rounded to 1 %; of equal ones the smallest bearing, then the roughest surfaces, then the
    smallest change."""
    return _rounded(wanted.power), np.round(wanted.area, 9), wanted.level, np.round(wanted.change, 9)


def by_size(wanted: Wanted) -> tuple[Array, ...]:
    """The smallest bearing, then the least power."""
    return np.round(wanted.area, 9), _rounded(wanted.power), wanted.level, np.round(wanted.change, 9)


def by_change(wanted: Wanted) -> tuple[Array, ...]:
    """Surfaces as they are before smoother ones, then the smallest change from the design, then the least power."""
    return wanted.level, np.round(wanted.change, 9), wanted.power


def by_excess(wanted: Wanted) -> tuple[Array, ...]:
    """The least length beyond the room, then the least power."""
    return np.round(wanted.excess, 9), wanted.power


def _rounded(power: Array) -> Array:
    return np.round(np.log(power) / ONE_PER_CENT)


ORDERS: dict[str, Order] = {"loss": by_power, "size": by_size, "film": by_power}  # film: the Pareto set goes first


def best(fields: Fields, slopes: Slopes, order: Order) -> tuple[Pick, ...] | None:
    """Of one oil and supply the first by an order; None where a bearing has no candidate."""
    found = places_of_best(fields, slopes, order)
    return None if found is None else tuple(_at(*one, slopes[place]) for place, one in found.items())


def rank(fields: Fields, slopes: Slopes, order: Order) -> tuple[float, ...] | None:
    """What is wanted of the first by an order, of all bearings together; None: there is none."""
    found = places_of_best(fields, slopes, order)
    if found is None:
        return None
    each = [Wanted.of(field).at(index) for field, index in found.values()]
    return tuple(float(np.sum(numbers)) for numbers in order(Wanted(*(np.sum(numbers) for numbers in zip(*each)))))


def places_of_best(
    fields: Fields, slopes: Slopes, order: Order, film: Metre = 0.0
) -> dict[str, tuple[CandidateField, Index]] | None:
    """The same in the grids.  `film`: that it has at the edge at least."""
    alike = [place for place, some in fields.items() if some and some[0].task.alike]
    found: dict[str, tuple[CandidateField, Index]] = {}
    if len(alike) > 1:
        together = _best_alike({place: fields[place] for place in alike}, slopes, order, film)
        if together is None:
            return None
        found = together
    for place, some in fields.items():
        if place not in found:
            one = _best(some, slopes[place], order, film)
            if one is None:
                return None
            found[place] = one
    return {place: found[place] for place in fields}


def _best(
    fields: Sequence[CandidateField], slope: Radian, order: Order, film: Metre
) -> tuple[CandidateField, Index] | None:
    """Field and place of the first by an order."""
    every = []
    for field in fields:
        numbers = order(Wanted.of(field))
        if (index := first(field.passing(slope, film), *numbers)) is not None:
            every.append((tuple(float(wanted[index]) for wanted in numbers), field, index))
    found = min(every, key=lambda entry: entry[0], default=None)
    return None if found is None else found[1:]


def _best_alike(
    fields: Fields, slopes: Slopes, order: Order, film: Metre
) -> dict[str, tuple[CandidateField, Index]] | None:
    """The first of bearings that have one diameter, one clearance and surfaces alike: each as long as it has to be."""
    every = []
    for of_size in _of_one_size(fields):
        rows = [_in_rows(field, slopes[place], order, film) for field, place in zip(of_size, fields)]
        for step in sorted(set.intersection(*map(set, rows))):
            picked = [of_steps[step] for of_steps in rows]
            sums = Wanted(*(np.sum(numbers) for numbers in zip(*(wanted for wanted, _, _ in picked))))
            every.append((tuple(map(float, order(sums))), [one[1:] for one in picked]))
    found = min(every, key=lambda entry: entry[0], default=None)
    return None if found is None else dict(zip(fields, found[1]))


def _in_rows(
    field: CandidateField, slope: Radian, order: Order, film: Metre
) -> dict[float, tuple[Wanted, CandidateField, Index]]:
    """The first of each clearance, by its step from the design's; of those alone that have one."""
    wanted, kept, steps = Wanted.of(field), field.passing(slope, film), field.steps
    numbers = order(wanted)
    found = dict[float, tuple[Wanted, CandidateField, Index]]()
    for n in np.flatnonzero(kept.any(axis=1)):
        if (index := first(kept[n], *(row[n] for row in numbers))) is not None:
            at = (n, *index)
            found[steps[n]] = wanted.at(at), field, at
    return found


def _of_one_size(fields: Fields) -> Iterable[tuple[CandidateField, ...]]:
    """A field of each bearing, of one diameter and one step of surfaces."""
    by_size = [{(f.task.size, f.task.level): f for f in some} for some in fields.values()]
    for key in by_size[0]:
        if all(key in sizes for sizes in by_size):
            yield tuple(sizes[key] for sizes in by_size)


def closest(fields: Fields, slopes: Slopes) -> tuple[Pick, ...] | None:
    """Where nothing passes: the candidates with the largest least margin."""
    if not all(fields.values()):
        return None
    near = []
    for place, some in fields.items():
        margins = [least(field.judged(slopes[place]).values()) for field in some]
        n = max(range(len(margins)), key=lambda n: float(margins[n].max()))
        near.append(_at(some[n], np.unravel_index(int(margins[n].argmax()), margins[n].shape), slopes[place]))
    return tuple(near)


def _at(field: CandidateField, index: Index, slope: Radian) -> Pick:
    """A candidate as its field has it."""
    return _pick(field.task, field.at(index), slope)


# --- power against film


def pareto(every: Iterable[tuple[Variant, Fields]], slopes: Slopes) -> list[CandidateRow]:
    """The least power for ever more film at the edge of the worse bearing: no other candidate has more film for less
    power."""
    able = []
    for variant, fields in every:
        films = [[f.film(slopes[place])[f.passing(slopes[place])] for f in some] for place, some in fields.items()]
        sides = [np.concatenate(side) for side in films if side]
        if len(sides) == len(fields) and all(side.size for side in sides):
            able.append((variant, fields, min(side.min() for side in sides), min(side.max() for side in sides)))
    if not able:
        return []
    low, high = min(entry[2] for entry in able), max(entry[3] for entry in able)
    step = next((s for s in STEPS if (high - low) / s < MOST), STEPS[-1])
    rows: list[CandidateRow] = []
    for film in np.arange(np.floor(low / step), np.floor(high / step) + 1) * step:
        found = [
            (sum(float(field.states.power[index]) for field, index in places.values()), n, places)
            for n, (_, fields, *_) in enumerate(able)
            if (places := places_of_best(fields, slopes, lambda wanted: (wanted.power,), film)) is not None
        ]
        if not found:
            continue
        _, n, places = min(found, key=lambda entry: entry[:2])
        row = CandidateRow("more film", able[n][0], tuple(_at(*one, slopes[place]) for place, one in places.items()))
        while rows and row.film >= rows[-1].film and row.power <= rows[-1].power:
            rows.pop()
        if not rows or row.film > rows[-1].film:
            rows.append(row)
    return rows
