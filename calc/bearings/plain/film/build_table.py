# SPDX-License-Identifier: Apache-2.0
"""Writes `tables/film_table.npy` from direct solutions:  python -m calc.bearings.plain.film.build_table  (about half a
minute).

Needed only after a change of `reynolds` or of the nodes below.  The same code writes the same bytes.
"""

import math
import sys
from io import BytesIO
from pathlib import Path

import numpy as np

from ....sheet.arrays import Array
from .reynolds import ECCENTRICITY_RANGE, LENGTH_RATIO_RANGE, radial_damping, solve_film
from .table import QUANTITIES, TABLE, short_bearing_damping, short_bearing_load

ECCENTRICITIES = 30
LENGTH_RATIOS = 24
CELLS = (384, 32)


def eccentricity_nodes() -> Array:
    """Even in atanh ε."""
    low, high = ECCENTRICITY_RANGE
    nodes = np.tanh(np.linspace(math.atanh(low), math.atanh(high), ECCENTRICITIES))
    nodes[[0, -1]] = low, high
    return nodes


def length_ratio_nodes() -> Array:
    """Even in the fourth root of l/d: closer than even in ln(l/d) towards long bearings, where the flow bends most."""
    low, high = LENGTH_RATIO_RANGE
    nodes = np.linspace(low**0.25, high**0.25, LENGTH_RATIOS) ** 4
    nodes[[0, -1]] = low, high
    return nodes


def node_values(eccentricity: float, length_ratio: float) -> tuple[float, ...]:
    """The stored quantities of one node, in the order of `nodes.QUANTITIES`."""
    film = solve_film(eccentricity, length_ratio, cells=CELLS)
    short = length_ratio**2 * short_bearing_load(eccentricity)
    load = -math.log(2.0 * math.pi * film.sommerfeld * short)
    over_load = 2.0 * math.pi * film.sommerfeld * radial_damping(eccentricity, length_ratio, cells=CELLS)
    damping = math.log(over_load / short_bearing_damping(eccentricity))
    return load, film.attitude, film.flow, film.side_flow_ratio, film.pressure_ratio, damping


def build() -> Array:
    """The table as one structured value: the nodes, and value, d/dx, d/dy and d²/dxdy of each quantity's bicubic
    spline."""
    from scipy.interpolate import RectBivariateSpline  # type: ignore[import-untyped]

    eccentricities, length_ratios = eccentricity_nodes(), length_ratio_nodes()
    values = np.array([[node_values(e, b) for b in length_ratios.tolist()] for e in eccentricities.tolist()])
    x, y = np.arctanh(eccentricities), np.log(length_ratios)
    rows = np.empty((2 * LENGTH_RATIOS, 2 * ECCENTRICITIES, len(QUANTITIES)))
    for quantity in range(len(QUANTITIES)):
        spline = RectBivariateSpline(x, y, values[:, :, quantity], kx=3, ky=3, s=0)
        for dy in (0, 1):
            for dx in (0, 1):
                rows[dy::2, dx::2, quantity] = spline(x, y, dx=dx, dy=dy).T
    shape = [
        ("eccentricity", "<f8", (ECCENTRICITIES,)),
        ("length_ratio", "<f8", (LENGTH_RATIOS,)),
        ("rows", "<f8", rows.shape),
    ]
    table = np.zeros((), dtype=shape)
    table["eccentricity"], table["length_ratio"], table["rows"] = eccentricities, length_ratios, rows
    return table


def main(path: Path = TABLE) -> None:
    buffer = BytesIO()
    np.save(buffer, build(), allow_pickle=False)
    path.write_bytes(buffer.getvalue())


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:]))
