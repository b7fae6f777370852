# SPDX-License-Identifier: Apache-2.0
"""From all candidates to the few that are offered: the nearest to the design, the least power of each oil and supply,
the Pareto set.

Front and rear bearing do not know of each other while oil and supply are the same: each is chosen for itself.
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
from ..inputs import PLACES
from .grid import CandidateField
from .states import BearingTask, Index, States, check_of, judge, mckee, solved, usual
from .variants import Variant

ALIKE = 0.1  # W: powers that are taken for equal, so that the smaller change goes first
MOST = 12  # rows of the Pareto set
STEPS = (0.1e-6, 0.2e-6, 0.25e-6, 0.5e-6, 1e-6, 2e-6, 5e-6, 10e-6)  # of film between them

Fields = Mapping[str, Sequence[CandidateField]]  # of one variant: front and rear, a field for each diameter
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
    """Both bearings with one oil and supply.  `what`: now, nearest, least power, too long, more film."""

    what: str
    variant: Variant
    front: Pick
    rear: Pick

    @property
    def both(self) -> tuple[Pick, Pick]:
        return self.front, self.rear

    @property
    def power(self) -> Watt:
        return self.front.power + self.rear.power

    @property
    def film(self) -> Metre:
        """The thinnest of both bearings, at the edge and the worst corner."""
        return min(pick.film_edge for pick in self.both)

    @property
    def margin(self) -> Number:
        return min(pick.margin for pick in self.both)

    @property
    def change(self) -> Number:
        return sum(pick.change for pick in self.both)

    @property
    def corners(self) -> bool:
        """Whether it is judged at the corners of the tolerances, or as given."""
        return all(pick.task.corners for pick in self.both)

    @property
    def level(self) -> int:
        """By how many steps the surfaces of both are smoother."""
        return sum(pick.task.level for pick in self.both)

    @property
    def too_long(self) -> tuple[Metre, Metre]:
        """By how much each journal is longer than its room; 0: it fits, or its room is not known."""
        front, rear = (
            max(pick.length - pick.task.room.longest, 0.0) if pick.task.room.longest else 0.0 for pick in self.both
        )
        return front, rear


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


def best(fields: Fields, slopes: Slopes, order: Order) -> tuple[Pick, Pick] | None:
    """Of one oil and supply the first by an order, surfaces as they are before smoother ones; None where a bearing has
    no candidate."""
    front, rear = (_best(fields[place], slopes[place], order) for place in PLACES)
    if front is None or rear is None:
        return None
    return _at(*front[1:], slopes["front"]), _at(*rear[1:], slopes["rear"])


def rank(fields: Fields, slopes: Slopes, order: Order) -> tuple[float, ...] | None:
    """Level of the surfaces, how many clearances are not usual, and what is wanted of the first by an order, as the
    grids have them; None: there is none."""
    front, rear = (_best(fields[place], slopes[place], order) for place in PLACES)
    return None if front is None or rear is None else tuple(map(sum, zip(front[0], rear[0])))


def best_diameters(fields: Fields, slopes: Slopes) -> dict[str, Metre] | None:
    """Those that need least power; None where a bearing has no candidate."""
    both = {
        place: ranked[1].task.seat.bearing.diameter
        for place in PLACES
        if (ranked := _best(fields[place], slopes[place], by_power))
    }
    return both if len(both) == len(PLACES) else None


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


def closest(fields: Fields, slopes: Slopes) -> tuple[Pick, Pick] | None:
    """Where nothing passes: the candidates with the largest least margin."""
    if not all(fields[place] for place in PLACES):
        return None
    both = []
    for place in PLACES:
        margins = [least(field.judged(slopes[place]).values()) for field in fields[place]]
        n = max(range(len(margins)), key=lambda n: float(margins[n].max()))
        both.append(_at(fields[place][n], np.unravel_index(int(margins[n].argmax()), margins[n].shape), slopes[place]))
    return both[0], both[1]


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
            [f.judged(slopes[place])[FILM_EDGE].value[f.passing(slopes[place])] for f in fields[place]]
            for place in PLACES
        ]
        sides = [np.concatenate(side) * 1e-6 for side in films if side]
        if len(sides) == len(PLACES) and all(side.size for side in sides):
            able.append((variant, fields, min(side.min() for side in sides), min(side.max() for side in sides)))
    if not able:
        return []
    low, high = min(entry[2] for entry in able), max(entry[3] for entry in able)
    step = next((s for s in STEPS if (high - low) / s < MOST), STEPS[-1])
    rows: list[CandidateRow] = []
    for film in np.arange(np.floor(low / step), np.floor(high / step) + 1) * step:
        pairs = [
            (variant, [_least_with(fields[place], slopes[place], film) for place in PLACES])
            for variant, fields, *_ in able
        ]
        variant, (front, rear) = min(
            pairs, key=lambda pair: sum(candidate[0] if candidate is not None else np.inf for candidate in pair[1])
        )
        if front is None or rear is None:
            continue
        picked = _at(*front[1:], slopes["front"]), _at(*rear[1:], slopes["rear"])
        row = CandidateRow("more film", variant, *picked)
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
