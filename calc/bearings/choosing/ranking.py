# SPDX-License-Identifier: Apache-2.0
"""From all candidates to the few that are offered: the nearest to the design, the least power of each oil and supply, the Pareto set.

Front and rear bearing do not know of each other while oil and supply are the same: each is chosen for itself.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ...sheet.check import Check
from ...sheet.record import record
from ...sheet.units import CubicMetrePerSecond, Kelvin, Metre, Number, Radian, Watt
from .grid import Field, passing
from .rules import Judged
from .states import STATES, States, Task, judge, margins, mckee, solved
from .variants import PLACES, Variant

ALIKE = 0.1  # W: powers that are taken for equal, so that the smaller change goes first
MOST = 12  # rows of the Pareto set
STEPS = (0.1e-6, 0.2e-6, 0.25e-6, 0.5e-6, 1e-6, 2e-6, 5e-6, 10e-6)  # of film between them

Fields = Mapping[str, Sequence[Field]]  # of one variant: front and rear, a field for each diameter
Slopes = Mapping[str, Radian]


@record
class Pick:
    """One bearing as it is offered, solved where it stands."""

    task: Task
    length: Metre
    clearance: Metre
    power: Watt
    flow: CubicMetrePerSecond
    film_edge: Metre
    film_double_load: Metre
    rise: Kelvin
    mckee: Number
    margin: Number
    checks: tuple[Check, ...]  # every rule on it
    governing: Check
    corner: str

    @property
    def diameter(self) -> Metre:
        return self.task.seat.bearing.diameter

    @property
    def change(self) -> Number:
        own = self.task
        return abs(self.length / own.length - 1) + abs(self.clearance / own.clearance - 1) + abs(self.diameter / own.diameter - 1)


@record
class Row:
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
        return min(one.film_edge for one in self.both)

    @property
    def margin(self) -> Number:
        return min(one.margin for one in self.both)

    @property
    def change(self) -> Number:
        return sum(one.change for one in self.both)

    @property
    def corners(self) -> bool:
        """Whether it is judged at the corners of the tolerances, or as given."""
        return all(one.task.corners for one in self.both)

    @property
    def level(self) -> int:
        """By how many steps the surfaces of both are smoother."""
        return sum(one.task.level for one in self.both)

    @property
    def too_long(self) -> tuple[Metre, Metre]:
        """By how much each journal is longer than its room; 0: it fits, or its room is not known."""
        front, rear = (max(one.length - one.task.room.longest, 0.0) if one.task.room.longest else 0.0 for one in self.both)
        return front, rear


def picks(task: Task, length: Any, clearance: Any, slope: Radian) -> list[Pick]:
    """Bearings of one task, solved together; length and clearance are lists of the same length."""
    there = solved(task, length, clearance)
    found = judge(task, there, slope)
    marks = mckee(task, there)
    return [_pick(task, there, found, marks, i) for i in range(len(there.length))]


def _pick(task: Task, there: States, found: list[Judged], marks: Any, i: int) -> Pick:
    by_key = {one.rule.key: one for one in found}
    governing, state = min(found, key=lambda one: float(one.margin[i])).at(i)
    return Pick(
        task, float(there.length[i]), float(there.clearance[i]), float(there.power[i]), float(there.flow[i]),
        float(by_key["film_edge"].value[i]) * 1e-6, float(by_key["film_double_load"].value[i]) * 1e-6,
        float(by_key["temperature_rise"].value[i]), float(marks[i]),
        float(margins(found)[i]), tuple(one.at(i)[0] for one in found), governing, STATES[state][0] if state > 0 else "",
    )  # fmt: skip


def least_power(fields: Fields, slopes: Slopes) -> tuple[Pick, Pick] | None:
    """Of one oil and supply; surfaces as they are before smoother ones, the smaller change where powers are alike.

    None where one of both has no candidate.
    """
    return _both(fields, slopes, _by_power)


def shortest(fields: Fields, slopes: Slopes) -> tuple[Pick, Pick] | None:
    """The least length beyond the room; the least power where that is the same."""

    def order(one: Field) -> tuple[Any, Any]:
        room = one.task.room.longest
        return (0 * one.states.length if room is None else np.maximum(one.states.length - room, 0.0)), one.states.power

    return _both(fields, slopes, order)


def nearest(fields: Fields, slopes: Slopes) -> tuple[Pick, Pick] | None:
    """The smallest change from the design that keeps every rule; the least power where changes are the same."""
    return _both(fields, slopes, _by_change)


def _both(fields: Fields, slopes: Slopes, order: Any) -> tuple[Pick, Pick] | None:
    found = [_one(fields[place], slopes[place], order) for place in PLACES]
    return None if found[0] is None or found[1] is None else (found[0], found[1])


def rank_of_nearest(fields: Fields, slopes: Slopes) -> tuple[int, float, float] | None:
    """Level of the surfaces, change and power of the nearest, as the grids have them; None: there is none."""
    both = [_best(fields[place], slopes[place], _by_change) for place in PLACES]
    if both[0] is None or both[1] is None:
        return None
    (level_1, change_1, power_1), (level_2, change_2, power_2) = both[0][0], both[1][0]
    return level_1 + level_2, change_1 + change_2, power_1 + power_2


def best_diameters(fields: Fields, slopes: Slopes) -> dict[str, Metre] | None:
    """Those that need least power; None where a bearing has no candidate."""
    both = {place: _best(fields[place], slopes[place], _by_power) for place in PLACES}
    there = {place: one[1].task.seat.bearing.diameter for place, one in both.items() if one}
    return there if len(there) == len(PLACES) else None


def _by_power(one: Field) -> tuple[Any, Any]:
    return np.round(one.states.power / ALIKE), one.change()


def _by_change(one: Field) -> tuple[Any, Any]:
    return np.round(one.change(), 9), one.states.power


def _one(fields: Sequence[Field], slope: Radian, order: Any) -> Pick | None:
    best = _best(fields, slope, order)
    if best is None:
        return None
    _, field, index = best
    return picks(field.task, [field.states.length[index]], [field.states.clearance[index]], slope)[0]


def _best(fields: Sequence[Field], slope: Radian, order: Any) -> tuple[tuple[int, float, float], Field, Any] | None:
    """Rank, field and place of the first by an order."""
    best: tuple[tuple[int, float, float], Field, Any] | None = None
    for field in fields:
        passes = passing(field.judged(slope))
        if not passes.any():
            continue
        first, second = (np.where(passes, numbers, np.inf) for numbers in order(field))
        index = np.unravel_index(np.lexsort((second.ravel(), first.ravel()))[0], passes.shape)
        rank = (field.task.level, float(first[index]), float(second[index]))
        if best is None or rank < best[0]:
            best = rank, field, index
    return best


def closest(fields: Fields, slopes: Slopes) -> tuple[Pick, Pick] | None:
    """Where nothing passes: the candidates with the largest least margin."""
    return _both_of(fields, slopes) if all(fields[place] for place in PLACES) else None


def _both_of(fields: Fields, slopes: Slopes) -> tuple[Pick, Pick]:
    found = []
    for place in PLACES:
        best = max(fields[place], key=lambda field: float(margins(field.judged(slopes[place])).max()))
        kept = margins(best.judged(slopes[place]))
        index = np.unravel_index(int(kept.argmax()), kept.shape)
        found += picks(best.task, [best.states.length[index]], [best.states.clearance[index]], slopes[place])
    return found[0], found[1]


def pareto(every: Iterable[tuple[Variant, Fields]], slopes: Slopes) -> list[Row]:
    """The least power for ever more film at the edge of the worse bearing: no other candidate has more film for less power."""
    fronts: list[tuple[Variant, Fields, Any]] = []
    for variant, fields in every:
        sides: Any = {place: _steps(fields[place], slopes[place]) for place in PLACES}
        if all(sides[place] is not None for place in PLACES):
            fronts.append((variant, fields, sides))
    if not fronts:
        return []
    low = min(min(min(side[0]) for side in sides.values()) for *_, sides in fronts)
    high = max(min(max(side[0]) for side in sides.values()) for *_, sides in fronts)
    step = next((s for s in STEPS if (high - low) / s < MOST), STEPS[-1])
    rows: list[Row] = []
    for film in np.arange(np.floor(low / step), np.floor(high / step) + 1) * step:
        offers = [(sum(_at(side, film)[0] for side in sides.values()), n) for n, (*_, sides) in enumerate(fronts)]
        power, n = min(offers)
        if not np.isfinite(power):
            continue
        variant, _, sides = fronts[n]
        both = []
        for place in PLACES:
            _, field, index = _at(sides[place], film)
            both += picks(field.task, [field.states.length[index]], [field.states.clearance[index]], slopes[place])
        row = Row("more film", variant, *both)
        while rows and row.film >= rows[-1].film and row.power <= rows[-1].power:
            rows.pop()
        if not rows or row.film > rows[-1].film:
            rows.append(row)
    return rows


def _steps(fields: Sequence[Field], slope: Radian) -> tuple[Any, ...] | None:
    """Of one bearing: films, the thickest first, and beside each the least power of all with that film or more, and whose it is."""
    films, powers, owners, places = [], [], [], []
    for n, field in enumerate(fields):
        found = field.judged(slope)
        passes = passing(found)
        edge = next(one.value for one in found if one.rule.key == "film_edge") * 1e-6
        films.append(edge[passes])
        powers.append(field.states.power[passes])
        owners.append(np.full(int(passes.sum()), n))
        places.append(np.argwhere(passes))
    if not films:
        return None
    film, power, owner, place = (np.concatenate(x) for x in (films, powers, owners, places))
    if not film.size:
        return None
    order = np.argsort(-film)
    least = np.minimum.accumulate(power[order])
    where = np.maximum.accumulate(np.where(power[order] == least, np.arange(order.size), 0))
    return film[order], least, where, owner[order], place[order], fields


def _at(side: tuple[Any, ...], film: Metre) -> tuple[Watt, Any, Any]:
    """The least power of a bearing with at least this film: power, field, index; ∞ where there is none."""
    films, least, where, owner, place, fields = side
    last = int(np.searchsorted(-films, -film, side="right")) - 1
    if last < 0:
        return float("inf"), None, None
    at = where[last]
    return float(least[last]), fields[owner[at]], tuple(place[at])
