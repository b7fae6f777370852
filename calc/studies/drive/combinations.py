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
from .shafts import ShaftSurroundings, along, journal_mass, journal_slopes, shafts

STEPS = 1000  # of the slope's limit
OWN = 1.01  # on what a journal's own bending adds to its slope, while it turns: a part of a hundred of it
COARSE = 16  # every so-many-th combination makes the first front, which most others can be held against


@record
class Sizes:
    """What is combined within a class, SI: cores, surfaces of both journals, margins, films over their diameters.

    `surfaces`: of each bearing, by its name, Ra of journal and seat; `films`: of each bearing, front to rear, over its
    rising diameters; `seat`: the bearing with the largest journal, the other's is never larger.
    """

    core: Array
    surfaces: tuple[dict[str, tuple[Metre, Metre]], ...]
    margins: tuple[Number, ...]
    limit: Radian  # of the slopes
    seat: str
    films: dict[str, list[Films]]

    @property
    def order(self) -> tuple[int, int]:
        """The smaller journal's number and the larger one's, front to rear."""
        return (1, 0) if self.seat == next(iter(self.films)) else (0, 1)

    @property
    def small(self) -> list[Films]:
        """Those of the smaller journal."""
        return next(some for place, some in self.films.items() if place != self.seat)

    def asked(self, films: Films, surface: int) -> Metre:
        """The film that the peaks of a pair of surfaces ask for."""
        return asked_film(films.task, self.surfaces[surface][films.task.place])


@record
class DriveRows:
    """Combinations, an array each: sizes in SI, of the journals a column each, front to rear; `power` of both journals,
    `mass` of the shaft, the number of its `surface`."""

    core: Array
    diameter: Array
    length: Array
    clearance: Array
    surface: Array
    margin: Array
    power: Array
    mass: Array

    def at(self, places: IndexArray | BoolArray) -> "DriveRows":
        return DriveRows(**{name: numbers[places] for name, numbers in vars(self).items()})

    @property
    def seat(self) -> Array:
        seat: Array = self.diameter.max(1)
        return seat

    def __len__(self) -> int:
        return len(self.power)


def no_rows() -> DriveRows:
    one, both = np.zeros(0), np.zeros((0, 2))
    return DriveRows(one, both, both, both, one, one, one, one)


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
        return no_rows()
    rows = joined(row_sets)
    objectives = np.stack([rows.power, rows.mass, rows.seat, -rows.margin, rows.surface], 1)
    return rows.at(front(objectives))


def _of_surface(drive: ShaftSurroundings, sizes: Sizes, surface: int) -> Iterator[DriveRows]:
    lengths = np.unique(np.concatenate([np.round(f.length, 9) for f in sizes.small] or [np.zeros(0)]))
    for margin in sizes.margins:
        small = _small(drive, sizes, surface, margin, lengths)
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


def _small(drive: ShaftSurroundings, sizes: Sizes, surface: int, margin: Number, lengths: Array) -> _Small | None:
    layers_P: list[Array] = []
    layers_D: list[Array] = []
    best = np.full((lengths.size, STEPS + 1), np.inf)
    count = np.zeros(best.shape, dtype=int)
    other = np.full(lengths.size, -np.inf)
    n, m = sizes.order
    for films in sizes.small:
        at = np.searchsorted(lengths, np.round(films.length, 9))
        bent = journal_slopes(drive, n, films.task.diameter, films.length)
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
    n_s, n_b = sizes.order
    d, seat = big.task.diameter, big.opening
    lengths = {n_s: small.length, n_b: big.length}
    shaft = shafts(drive, sizes.core, (lengths[0], lengths[1]), seat)
    bent = journal_slopes(drive, n_b, d, big.length)
    mass = shaft.mass + along(n_b, journal_mass(drive, d, big.length))
    unit = sizes.limit / STEPS
    with np.errstate(invalid="ignore"):
        of_big = shaft.slopes[n_b] + along(n_b, bent[n_b]) + along(n_s, small.other)
        of_small = shaft.slopes[n_s] + along(n_b, bent[n_s])
        s_big = np.ceil(drive.turning(n_b, mass, of_big) / unit - 1e-9)
        s_small = np.ceil(drive.turning(n_s, mass, of_small) / unit - 1e-9)
        fits = shaft.fits & (s_big <= STEPS) & (s_small <= STEPS)
    if not fits.any():
        return None
    i_c, *journals = np.nonzero(fits)
    i_s, i_b = journals[n_s], journals[n_b]
    k_b, k_s = s_big[fits].astype(int), s_small[fits].astype(int)
    P_big = _table(sizes, big, np.zeros(big.length.size), surface, margin)[i_b, k_b]  # its own bending is in the slopes
    base, index = mass[fits], np.flatnonzero(np.isfinite(P_big))
    parts: list[tuple[Array, Array, Array, IndexArray]] = []
    for P, D in zip(small.power, small.diameter):
        power, diameter = P[i_s[index], k_s[index]] + P_big[index], D[i_s[index], k_s[index]]
        there_is = np.isfinite(power) & (diameter <= seat + 1e-9)
        if there_is.any():
            at = index[there_is]
            diameter = diameter[there_is]
            parts.append(
                (power[there_is], base[at] + journal_mass(drive, diameter, small.length[i_s[at]]), diameter, at)
            )
    if not parts:
        return None
    power, weight, diameter, at = (np.concatenate(x) for x in zip(*parts))
    chosen = _least(power, weight)
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
        (power[chosen], weight[chosen]),
    )


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
    n_s, _ = sizes.order
    by_diameter = {f.task.diameter: f for f in sizes.small}
    g_big, g_small = np.zeros(i_c.size), np.zeros(i_c.size)
    bears = big.bears(sizes.asked(big, surface), margin, sizes.limit)
    for n, column in enumerate(i_b.tolist()):
        g_big[n] = _clearance(big, bears[:, column], column, slopes[0][n])
    for d in np.unique(diameter):
        f = by_diameter[float(d)]
        bending = journal_slopes(drive, n_s, f.task.diameter, f.length)[n_s]
        bears = f.bears(sizes.asked(f, surface), margin, sizes.limit) - bending * OWN
        for n in np.flatnonzero(diameter == d).tolist():
            column = int(np.searchsorted(np.round(f.length, 9), round(float(small.length[i_s[n]]), 9)))
            g_small[n] = _clearance(f, bears[:, column], column, slopes[1][n])
    both = (diameter, small.length[i_s], g_small), (np.full(i_c.size, big.task.diameter), big.length[i_b], g_big)
    d, l, g = (np.stack(columns, 1) for columns in zip(*(both if n_s == 0 else both[::-1])))
    surfaces, margins = np.full(i_c.size, surface, dtype=float), np.full(i_c.size, margin)
    return DriveRows(sizes.core[i_c], d, l, g, surfaces, margins, *known)


def _clearance(films: Films, bears: Array, column: int, slope: Radian) -> Metre:
    holds = bears >= slope * (1 - 1e-12)
    return float(films.clearance[np.where(holds, films.power[:, column], np.inf).argmin()])
