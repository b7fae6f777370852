# SPDX-License-Identifier: Apache-2.0
"""The front of one class: every combination of core, both journals and surfaces, the clearances chosen by what the
slopes ask for.

A combination passes where each journal bears its slope (films.py) in its shaft (shafts.py).  For every core, length,
largest seat and level of margin the clearance of least power is read from a table over the slope; the table's steps are
a thousandth of the slope's limit, and a slope counts as the next step above it, so that nothing passes by rounding.
The smaller journal is taken at every diameter that rubs less than all smaller ones: a larger one is heavier, and what
it stiffens is counted in its own slope (in the other's, a thousandth of it, as if it were the stiffest)."""

from collections.abc import Iterator, Sequence

import numpy as np

from ...sheet.arrays import Array, BoolArray, IndexArray
from ...sheet.record import record
from ...sheet.units import Metre, Number, Radian
from .films import Films, asked_film
from .front import front, lower_left
from .shafts import Shafts, ShaftSurroundings, journal_mass, journal_slopes, shafts

STEPS = 1000  # of the slope's limit
OWN = 1.01  # on what a journal's own bending adds to its slope, while it turns: a part of a hundred of it
COARSE = 16  # every so-many-th combination makes the first front, which most others can be held against


@record
class Sizes:
    """What is combined within a class, SI: cores, surfaces of both journals, margins, films of both places over their
    diameters.

    `seat`: "front" or "rear", the place of the largest journal; the other is never larger.
    """

    core: Array
    surfaces: tuple[tuple[tuple[Metre, Metre], tuple[Metre, Metre]], ...]  # Ra of journal and seat, front and rear
    margins: tuple[Number, ...]
    limit: Radian  # of the slopes
    seat: str
    films: dict[str, list[Films]]

    def asked(self, films: Films, surface: int) -> Metre:
        """The film that the peaks of a pair of surfaces ask for."""
        return asked_film(films.task, self.surfaces[surface][films.task.place == "rear"])


@record
class DriveRows:
    """Combinations, an array each: sizes in SI, `power` of both journals, `mass` of the shaft, the number of its
    `surface`."""

    core: Array
    front_diameter: Array
    front_length: Array
    front_clearance: Array
    rear_diameter: Array
    rear_length: Array
    rear_clearance: Array
    surface: Array
    margin: Array
    power: Array
    mass: Array

    def at(self, places: IndexArray | BoolArray) -> "DriveRows":
        return DriveRows(**{name: numbers[places] for name, numbers in vars(self).items()})

    @property
    def seat(self) -> Array:
        seat: Array = np.maximum(self.front_diameter, self.rear_diameter)
        return seat

    def __len__(self) -> int:
        return len(self.power)


def joined(parts: Sequence[DriveRows]) -> DriveRows:
    return DriveRows(
        **{name: np.concatenate([getattr(part, name) for part in parts]) for name in DriveRows.__dataclass_fields__}
    )


@record
class _Small:
    """The smaller journal by length and step of slope: the least power of ever larger diameters, each less than that of
    the one before.

    `power` and `diameter`: choices down, then lengths, then steps; `other`: what its bending adds to the other's slope,
    by length."""

    length: Array
    power: Array
    diameter: Array
    other: Array


def combinations(sizes: Sizes) -> int:
    """How many there are: what the front is exhaustive over."""
    count = {place: sum(f.length.size * f.clearance.size for f in some) for place, some in sizes.films.items()}
    return int(np.prod(list(count.values()))) * len(sizes.core) * len(sizes.surfaces)


def class_front(drive: ShaftSurroundings, sizes: Sizes) -> DriveRows:
    """The rows of a class that no other of it beats in power, mass, seat, surfaces and margin."""
    row_sets = [rows for surface in range(len(sizes.surfaces)) for rows in _of_surface(drive, sizes, surface)]
    if not row_sets:
        return joined([_empty()])
    rows = joined(row_sets)
    objectives = np.stack([rows.power, rows.mass, rows.seat, -rows.margin, rows.surface], 1)
    return rows.at(front(objectives))


def _of_surface(drive: ShaftSurroundings, sizes: Sizes, surface: int) -> Iterator[DriveRows]:
    small_place = "front" if sizes.seat == "rear" else "rear"
    lengths = np.unique(np.concatenate([np.round(f.length, 9) for f in sizes.films[small_place]] or [np.zeros(0)]))
    for margin in sizes.margins:
        small = _small(drive, sizes, small_place, surface, margin, lengths)
        if small is None:
            continue
        for big in sizes.films[sizes.seat]:
            rows = _with_seat(drive, sizes, small, big, surface, margin)
            if rows is not None:
                yield rows


def _table(sizes: Sizes, films: Films, bending: Array, surface: int, margin: Number) -> Array:
    """Least power of each length over the steps of the slope; `bending`: what the journal's own bending adds, by
    length."""
    net = films.bears(sizes.asked(films, surface), margin, sizes.limit) - bending * OWN
    step = np.minimum(np.floor(net / (sizes.limit / STEPS)), STEPS)
    table = np.full((films.length.size, STEPS + 1), np.inf)
    i, k = np.nonzero(step >= 0)
    np.minimum.at(table, (k, step[i, k].astype(int)), films.power[i, k])
    least: Array = np.minimum.accumulate(table[:, ::-1], axis=1)[:, ::-1]
    return least


def _small(
    drive: ShaftSurroundings, sizes: Sizes, place: str, surface: int, margin: Number, lengths: Array
) -> _Small | None:
    layers_P: list[Array] = []
    layers_D: list[Array] = []
    best = np.full((lengths.size, STEPS + 1), np.inf)
    count = np.zeros(best.shape, dtype=int)
    other = np.full(lengths.size, -np.inf)
    n, m = (0, 1) if place == "front" else (1, 0)
    for films in sizes.films[place]:  # rising diameters
        at = np.searchsorted(lengths, np.round(films.length, 9))
        bent = journal_slopes(drive, place == "front", films.task.diameter, films.length)
        other[at] = np.maximum(other[at], bent[m])
        power = np.full(best.shape, np.inf)
        power[at] = _table(sizes, films, bent[n], surface, margin)
        better = power < best * (1 - 1e-9)
        best = np.where(better, power, best)
        for level in range(int(count[better].max(initial=-1)) + 1):
            here = better & (count == level)
            if level == len(layers_P):
                layers_P.append(np.full(best.shape, np.inf))
                layers_D.append(np.zeros(best.shape))
            layers_P[level][here] = power[here]
            layers_D[level][here] = films.task.diameter
        count[better] += 1
    return _Small(lengths, np.array(layers_P), np.array(layers_D), other) if layers_P else None


def _with_seat(
    drive: ShaftSurroundings, sizes: Sizes, small: _Small, big: Films, surface: int, margin: Number
) -> DriveRows | None:
    """The front of power and mass with one largest journal."""
    front_is_small = sizes.seat == "rear"
    d = big.task.diameter
    l_f, l_r = (small.length, big.length) if front_is_small else (big.length, small.length)
    shaft = _shafts(drive, sizes.core, l_f, l_r, d, front_is_small)
    unit = sizes.limit / STEPS
    here, there = (1, 0) if front_is_small else (0, 1)  # places of the big and of the small journal among the slopes
    with np.errstate(invalid="ignore"):
        s_big = np.ceil(
            drive.turning(here, shaft.mass, shaft.slopes[here] + _along(small.other, not front_is_small)) / unit - 1e-9
        )
        s_small = np.ceil(drive.turning(there, shaft.mass, shaft.slopes[there]) / unit - 1e-9)
        fits = shaft.fits & (s_big <= STEPS) & (s_small <= STEPS)
    if not fits.any():
        return None
    i_c, i_f, i_r = np.nonzero(fits)
    i_s, i_b = (i_f, i_r) if front_is_small else (i_r, i_f)
    k_b, k_s = s_big[fits].astype(int), s_small[fits].astype(int)
    P_big = _table(sizes, big, np.zeros(big.length.size), surface, margin)[i_b, k_b]  # its own bending is in the slopes
    base, index = shaft.mass[fits], np.flatnonzero(np.isfinite(P_big))
    parts: list[tuple[Array, Array, Array, IndexArray]] = []
    for P, D in zip(small.power, small.diameter):
        power, diameter = P[i_s[index], k_s[index]] + P_big[index], D[i_s[index], k_s[index]]
        there_is = np.isfinite(power) & (diameter <= d + 1e-9)
        if there_is.any():
            at = index[there_is]
            diameter = diameter[there_is]
            parts.append(
                (power[there_is], base[at] + journal_mass(drive, diameter, small.length[i_s[at]]), diameter, at)
            )
    if not parts:
        return None
    power, mass, diameter, at = (np.concatenate(x) for x in zip(*parts))
    chosen = _least(power, mass)
    at = at[chosen]
    slopes = s_big[fits][at] * unit, s_small[fits][at] * unit
    return _rows(
        drive,
        sizes,
        big,
        small,
        surface,
        margin,
        (i_c[at], i_s[at], i_b[at]),
        diameter[chosen],
        slopes,
        (power[chosen], mass[chosen]),
    )


def _shafts(drive: ShaftSurroundings, core: Array, l_f: Array, l_r: Array, d: Metre, front_is_small: bool) -> Shafts:
    """With the rear journal's own bending and mass within: where the rear one is the smaller, those are taken out
    again."""
    shaft = shafts(drive, core, l_f, l_r, d, d)
    slopes, mass = list(shaft.slopes), shaft.mass
    if not front_is_small:
        for n, (rear, front_) in enumerate(
            zip(journal_slopes(drive, False, d, l_r), journal_slopes(drive, True, d, l_f))
        ):
            slopes[n] = slopes[n] - rear[None, None, :] + front_[None, :, None]
        mass = mass - journal_mass(drive, d, l_r)[None, None, :] + journal_mass(drive, d, l_f)[None, :, None]
    return Shafts(shaft.face, (slopes[0], slopes[1]), mass, shaft.fits)


def _along(x: Array, rear: bool) -> Array:
    return x[None, None, :] if rear else x[None, :, None]


def _least(power: Array, mass: Array) -> IndexArray:
    """The front of both: those that a front of a few do not beat, then theirs."""
    few = lower_left(power[::COARSE], mass[::COARSE]) * COARSE
    place = np.searchsorted(power[few], power, side="right") - 1
    alive = np.flatnonzero((place < 0) | (mass <= mass[few][np.maximum(place, 0)]))
    return alive[lower_left(power[alive], mass[alive])]


def _rows(
    drive: ShaftSurroundings,
    sizes: Sizes,
    big: Films,
    small: _Small,
    surface: int,
    margin: Number,
    at: tuple[IndexArray, IndexArray, IndexArray],
    diameter: Array,
    slopes: tuple[Array, Array],
    known: tuple[Array, Array],
) -> DriveRows:
    """The clearances of the rows that are kept: those of least power that bear their slopes."""
    i_c, i_s, i_b = at
    place = "front" if sizes.seat == "rear" else "rear"
    by_diameter = {f.task.diameter: f for f in sizes.films[place]}
    g_big, g_small = np.zeros(i_c.size), np.zeros(i_c.size)
    bears = big.bears(sizes.asked(big, surface), margin, sizes.limit)
    for n, column in enumerate(i_b.tolist()):
        g_big[n] = _clearance(big, bears[:, column], column, slopes[0][n])
    for d in np.unique(diameter):
        f = by_diameter[float(d)]
        bending = journal_slopes(drive, place == "front", f.task.diameter, f.length)[0 if place == "front" else 1]
        bears = f.bears(sizes.asked(f, surface), margin, sizes.limit) - bending * OWN
        for n in np.flatnonzero(diameter == d).tolist():
            column = int(np.searchsorted(np.round(f.length, 9), round(float(small.length[i_s[n]]), 9)))
            g_small[n] = _clearance(f, bears[:, column], column, slopes[1][n])
    sized = (diameter, small.length[i_s], g_small), (np.full(i_c.size, big.task.diameter), big.length[i_b], g_big)
    (d_f, l_f, g_f), (d_r, l_r, g_r) = sized if place == "front" else sized[::-1]
    surfaces, margins = np.full(i_c.size, surface, dtype=float), np.full(i_c.size, margin)
    return DriveRows(sizes.core[i_c], d_f, l_f, g_f, d_r, l_r, g_r, surfaces, margins, *known)


def _clearance(films: Films, bears: Array, column: int, slope: Radian) -> Metre:
    holds = bears >= slope * (1 - 1e-12)
    return float(films.clearance[np.where(holds, films.power[:, column], np.inf).argmin()])


def _empty() -> DriveRows:
    return DriveRows(*(np.zeros(0) for _ in DriveRows.__dataclass_fields__))
