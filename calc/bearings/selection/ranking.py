# SPDX-License-Identifier: Apache-2.0
"""From all candidates to the few that are offered: the nearest to the design, the least power of each oil and supply,
the Pareto set.

The bearings do not know of each other while oil and supply are the same: each is chosen for itself.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from ...sheet.arrays import Array
from ...sheet.check import Check
from ...sheet.record import record
from ...sheet.search import first, governing, least
from ...sheet.text import EMPTY, Text
from ...sheet.units import Kelvin, Metre, Number, Radian, Watt
from ..checks import FILM_DOUBLE_LOAD, FILM_EDGE, TEMPERATURE_RISE_USUAL
from .grid import CandidateField
from .states import BearingTask, Index, States, check_of, judge, mckee, solved, usual
from .variants import Variant

ALIKE = 0.1  # W: powers that are taken for equal, so that the smaller change goes first
MOST = 12  # rows of the Pareto set
STEPS = (0.1e-6, 0.2e-6, 0.25e-6, 0.5e-6, 1e-6, 2e-6, 5e-6, 10e-6)  # of film between them

Fields = Mapping[str, Sequence[CandidateField]]  # of one variant: by bearing, front to rear, a field for each diameter
Slopes = Mapping[str, Radian]
# what is wanted least of every candidate, and what of equal ones
Order = Callable[[CandidateField], tuple[Array, Array]]


@record
class Pick:
    """One bearing as it is offered, solved where it stands: in `films`, of shape (states, 1).  `corner`: the state that
    governs."""

    task: BearingTask
    length: Metre
    clearance: Metre
    power: Watt
    film_edge: Metre
    film_double_load: Metre
    rise: Kelvin
    mckee: Number
    margin: Number
    checks: tuple[Check, ...]  # every rule on it
    governing: Check
    corner: Text
    unusual: Check | None  # the advice on its relative clearance, where it does not keep it
    films: States

    @property
    def diameter(self) -> Metre:
        return self.task.seat.bearing.diameter

    @property
    def change(self) -> Number:
        task = self.task
        return (
            abs(self.length / task.length - 1)
            + abs(self.clearance / task.clearance - 1)
            + abs(self.diameter / task.diameter - 1)
        )

    def with_slope(self, slope: Radian) -> "Pick":
        return _pick(self.task, self.films, slope)


@record
class CandidateRow:
    """All bearings with one oil and supply, front to rear.  `what`: now, nearest, least power, too long, more film."""

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
    worst, psi = governing(limits.values(), 0), usual(task, films.clearance)
    state = worst.where if isinstance(worst.where, Text) else int(np.broadcast_to(worst.where, (1,))[0])
    corner = state if isinstance(state, Text) else task.states[state].name if state > 0 else EMPTY
    return Pick(
        task,
        float(films.length[0]),
        float(films.clearance[0]),
        float(films.power[0]),
        float(limits[FILM_EDGE].value[0]) * 1e-6,
        float(limits[FILM_DOUBLE_LOAD].value[0]) * 1e-6,
        float(limits[TEMPERATURE_RISE_USUAL].value[0]),
        float(mckee(task, films)[0]),
        float(least(limits.values())[0]),
        tuple(check_of(limit, 0) for limit in limits.values()),
        check_of(worst, 0),
        corner,
        check_of(psi, 0) if psi.margin[0] < 0 else None,
        films,
    )


# --- orders


def by_power(field: CandidateField) -> tuple[Array, Array]:
    """The least power, the smaller change where powers are alike."""
    return np.round(field.states.power / ALIKE), field.change()


def by_change(field: CandidateField) -> tuple[Array, Array]:
    """The smallest change from the design, the least power where changes are the same."""
    return np.round(field.change(), 9), field.states.power


def by_excess(field: CandidateField) -> tuple[Array, Array]:
    """The least length beyond the room, the least power where that is the same."""
    room, states = field.task.room.longest, field.states
    return 0 * states.length if room is None else np.maximum(states.length - room, 0.0), states.power


def best(fields: Fields, slopes: Slopes, order: Order) -> tuple[Pick, ...] | None:
    """Of one oil and supply the first by an order, surfaces as they are before smoother ones; None where a bearing has
    no candidate."""
    ranked = [_best(some, slopes[place], order) for place, some in fields.items()]
    if None in ranked:
        return None
    return tuple(_at(*found[1:], slopes[place]) for place, found in zip(fields, ranked) if found is not None)


def rank(fields: Fields, slopes: Slopes, order: Order) -> tuple[float, ...] | None:
    """Level of the surfaces, how many clearances are not usual, and what is wanted of the first by an order, as the
    grids have them; None: there is none."""
    ranked = [found[0] for place, some in fields.items() if (found := _best(some, slopes[place], order)) is not None]
    return tuple(map(sum, zip(*ranked))) if len(ranked) == len(fields) else None


def best_diameters(fields: Fields, slopes: Slopes) -> dict[str, Metre] | None:
    """Those that need least power; None where a bearing has no candidate."""
    every = {
        place: ranked[1].task.seat.bearing.diameter
        for place, some in fields.items()
        if (ranked := _best(some, slopes[place], by_power))
    }
    return every if len(every) == len(fields) else None


def _best(
    fields: Sequence[CandidateField], slope: Radian, order: Order
) -> tuple[tuple[int, bool, float, float], CandidateField, Index] | None:
    """Rank, field and place of the first by an order, a usual clearance before others."""
    every = []
    for field in fields:
        primary, two = order(field)
        unusual, kept = field.wanted(slope)
        if (index := first(kept, primary, two)) is not None:
            every.append(((field.task.level, unusual, float(primary[index]), float(two[index])), field, index))
    return min(every, key=lambda entry: entry[0], default=None)


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
    """A candidate of a field, solved where it stands."""
    return picks(field.task, [field.states.length[index]], [field.states.clearance[index]], slope)[0]


# --- power against film


def pareto(every: Iterable[tuple[Variant, Fields]], slopes: Slopes) -> list[CandidateRow]:
    """The least power for ever more film at the edge of the worse bearing: no other candidate has more film for less
    power."""
    able = []
    for variant, fields in every:
        films = [
            [f.judged(slopes[place])[FILM_EDGE].value[f.passing(slopes[place])] for f in some]
            for place, some in fields.items()
        ]
        sides = [np.concatenate(side) * 1e-6 for side in films if side]
        if len(sides) == len(fields) and all(side.size for side in sides):
            able.append((variant, fields, min(side.min() for side in sides), min(side.max() for side in sides)))
    if not able:
        return []
    low, high = min(entry[2] for entry in able), max(entry[3] for entry in able)
    step = next((s for s in STEPS if (high - low) / s < MOST), STEPS[-1])
    rows: list[CandidateRow] = []
    for film in np.arange(np.floor(low / step), np.floor(high / step) + 1) * step:
        pairs = [
            (variant, {place: _least_with(some, slopes[place], film) for place, some in fields.items()})
            for variant, fields, *_ in able
        ]
        variant, found = min(
            pairs, key=lambda pair: sum(one[0] if one is not None else np.inf for one in pair[1].values())
        )
        if None in found.values():
            continue
        picked = tuple(_at(*one[1:], slopes[place]) for place, one in found.items() if one is not None)
        row = CandidateRow("more film", variant, picked)
        while rows and row.film >= rows[-1].film and row.power <= rows[-1].power:
            rows.pop()
        if not rows or row.film > rows[-1].film:
            rows.append(row)
    return rows


def _least_with(
    fields: Sequence[CandidateField], slope: Radian, film: Metre
) -> tuple[Watt, CandidateField, Index] | None:
    """The least power with at least this film, and whose it is; None: there is none."""
    best: tuple[Watt, CandidateField, Index] | None = None
    for field in fields:
        kept = field.passing(slope) & (field.judged(slope)[FILM_EDGE].value * 1e-6 >= film)
        if (index := first(kept, field.states.power)) is not None and (
            best is None or field.states.power[index] < best[0]
        ):
            best = float(field.states.power[index]), field, index
    return best
