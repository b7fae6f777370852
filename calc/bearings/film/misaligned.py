# SPDX-License-Identifier: Apache-2.0
"""Reynolds' equation for a journal that slopes in its seat: the pressure grows towards the edge where the film is thinner.

The film h = c·(1 + (ε + τ·z)·cos θ), z from −1 at one edge to 1 at the other: the journal slopes in the plane of its narrowest film, which
thins it most.  Every slice across is a plain bearing of eccentricity ε + τ·z, so that the flow around between two nodes is exact as in
`reynolds`, whose equation, film end and nodes these are, over the whole length on one grid.  A moment holds the slope: the shaft's.
"""

import math

import numpy as np

from ...sheet.arrays import Array
from ...sheet.record import record
from .reynolds import ECCENTRICITY_RANGE, film_grid, film_integrals, pressure_of


@record
class MisalignedFilm:
    """One state, dimensionless as in `reynolds.FilmSolution`."""

    sommerfeld: float
    z: Array  # nodes from edge to edge, −1 to 1
    pressure_along: Array  # Π there, at the angle where it is largest


def solve_misaligned(eccentricity: float, tilt: float, length_ratio: float, cells: tuple[int, int] = (96, 16)) -> MisalignedFilm:
    """`eccentricity` in the middle, `tilt` τ: what the slope takes of the film at the edge, over the radial clearance.

    `cells` around, and across half of the length.  Raises ValueError where an edge leaves the range: there the film is narrowest opposite.
    """
    low, high = ECCENTRICITY_RANGE
    if not low * (1 - 1e-9) <= eccentricity - abs(tilt) <= eccentricity + abs(tilt) <= high * (1 + 1e-9):
        raise ValueError(f"eccentricity ratio {eccentricity:g} ± {abs(tilt):g}: a journal that slopes is solved from {low:g} to {high:g}")
    grid = film_grid(eccentricity, length_ratio, *cells)
    theta, z = grid.theta, np.append(-grid.z[::-1], grid.z[1:])
    gap = np.diff(z)
    across = 0.5 * (np.append(gap, 0.0) + np.append(0.0, gap))
    eps = eccentricity + tilt * z
    gamma = 2.0 * np.arctan2(np.sqrt(1.0 - eps) * np.sin(theta[:, None] / 2), np.sqrt(1.0 + eps) * np.cos(theta[:, None] / 2))
    square, cube = film_integrals(gamma, eps)
    conductance = 1.0 / np.diff(cube, axis=0)
    drag = 6.0 * np.diff(square, axis=0) * conductance
    film = 1.0 + (eps[1:] + eps[:-1]) / 2 * np.cos(theta[:, None])
    sideways = (film**3 * (grid.around / length_ratio**2)[:, None] / gap)[1:-1]

    along, source = conductance[:, 1:-1] * across[1:-1], -np.diff(drag, axis=0)[:, 1:-1] * across[1:-1]
    diagonal = along[1:] + along[:-1] + sideways[:, 1:] + sideways[:, :-1]
    pressure = np.pad(pressure_of(theta, along, sideways[:, 1:], diagonal, source), ((0, 0), (1, 0)))
    per_angle = pressure @ across * grid.around
    load = math.hypot(float(per_angle @ np.cos(theta)), float(per_angle @ np.sin(theta))) / 2
    return MisalignedFilm(1.0 / (math.pi * load), z, pressure[int(pressure.max(axis=1).argmax())])
