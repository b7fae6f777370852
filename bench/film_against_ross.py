# SPDX-License-Identifier: Apache-2.0
"""The oil film against ROSS (petrobras/ross), an independent rotor-dynamics program: load carried, time, and time at
equal accuracy.

ROSS is no dependency of this program.  Into an environment of its own, then run from the root of the repository:

    python3 -m venv ROSS && ROSS/bin/pip install ross-rotordynamics 'plotly<6'
    ROSS/bin/python -m bench.film_against_ross

Both are given eccentricity and l/d, constant viscosity, and asked for the load.  The true value is this program's
solution on 768 by 64 cells.  ROSS (`FluidFlow`, finite differences, forces by "numerical") cuts negative pressures off,
which is another film end than that of Swift and Stieber: its load does not tend to the same value with finer grids, and
the error of a coarse grid may pass through zero by chance.  For each of its grids stands the time of the coarsest grid
of this program that is at least as near; the time of the stored table is beside it."""

import math
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from calc.bearings.plain.film.reynolds import solve_film
from calc.bearings.plain.film.table import film_at

STATES = ((0.2, 0.5), (0.6, 0.4622), (0.75, 0.4622), (0.8, 0.3272), (0.6, 1.0))
THEIRS = ((8, 65), (16, 133), (30, 251))  # along the shaft, around
OURS = ((24, 4), (48, 4), (96, 8), (192, 16), (384, 32))  # around, half the length
FINEST = (768, 64)
VISCOSITY, OMEGA, RADIUS, CLEARANCE = 0.01, 100.0, 0.05, 1e-4


def load_of_ross(ross: Any, eccentricity: float, length_ratio: float, grid: tuple[int, int]) -> float:
    """So = F·ψ²/(l·d·μ·ω)."""
    film = ross.FluidFlow(
        nz=grid[0],
        ntheta=grid[1],
        length=2 * RADIUS * length_ratio,
        omega=OMEGA,
        p_in=0.0,
        p_out=0.0,
        radius_rotor=RADIUS,
        radius_stator=RADIUS + CLEARANCE,
        viscosity=VISCOSITY,
        density=860.0,
        eccentricity=eccentricity * CLEARANCE,
        attitude_angle=math.pi / 4,
        bearing_type="medium_size",
        immediately_calculate_pressure_matrix_numerically=True,
    )
    radial, tangential = ross.forces(film, force_type="numerical")[:2]
    return (
        math.hypot(radial, tangential) * (CLEARANCE / RADIUS) ** 2 / (4 * RADIUS**2 * length_ratio * VISCOSITY * OMEGA)
    )


def load_of_ours(eccentricity: float, length_ratio: float, grid: tuple[int, int]) -> float:
    return 1 / (2 * math.pi * solve_film(eccentricity, length_ratio, cells=grid).sommerfeld)


def load_of_table(eccentricity: float, length_ratio: float) -> float:
    return 1 / (2 * math.pi * film_at(eccentricity, length_ratio).sommerfeld)


def timed(call: Callable[[], float]) -> tuple[float, float]:
    """The value, and the best time of some rounds (one, where it takes a second)."""
    best, value, spent = math.inf, 0.0, 0.0
    for _ in range(5):
        start = time.perf_counter()
        value = call()
        took = time.perf_counter() - start
        best, spent = min(best, took), spent + took
        if spent > 1:
            break
    return value, best


def main() -> None:
    try:
        import ross  # type: ignore[import-not-found]
        from ross.bearings import fluid_flow, fluid_flow_coefficients  # type: ignore[import-not-found]
    except ImportError as wrong:
        sys.exit(f"ROSS is not installed here ({wrong}). How to get it stands at the top of {__file__}.")

    class Theirs:
        FluidFlow = fluid_flow.FluidFlow
        forces = staticmethod(fluid_flow_coefficients.calculate_oil_film_force)

    load_of_ross(Theirs, 0.5, 0.5, (8, 33))  # compiles and loads what either asks for
    solve_film(0.5, 0.5)
    film_at(0.5, 0.5)
    print(
        f"ROSS {ross.__version__}; errors of So against {FINEST[0]} × {FINEST[1]} cells of this program; times of "
        f"one state"
    )
    for eccentricity, length_ratio in STATES:
        true = load_of_ours(eccentricity, length_ratio, FINEST)
        table, table_time = timed(partial(load_of_table, eccentricity, length_ratio))
        ours = [(grid, *timed(partial(load_of_ours, eccentricity, length_ratio, grid))) for grid in OURS]
        print(f"\nε {eccentricity:g}, l/d {length_ratio:g}: So {true:.6f}")
        for grid, value, seconds in ours:
            print(f"  ours  {grid[0]:3d} × {grid[1]:2d}   {100 * (value / true - 1):+9.4f} %  {seconds * 1e3:9.3f} ms")
        print(f"  ours  table      {100 * (table / true - 1):+9.4f} %  {table_time * 1e3:9.3f} ms")
        for wanted in THEIRS:
            value, seconds = timed(partial(load_of_ross, Theirs, eccentricity, length_ratio, wanted))
            error = abs(value / true - 1)
            grid, _, least = next(row for row in ours if abs(row[1] / true - 1) <= error)
            print(
                f"  ROSS  {wanted[1]:3d} × {wanted[0]:2d}   {100 * (value / true - 1):+9.4f} %  {seconds * 1e3:9.3f} ms"
                f"   at equal accuracy {seconds / least:7.0f} × ours ({grid[0]} × {grid[1]}, {least * 1e3:.2f} ms)"
            )


if __name__ == "__main__":
    main()
