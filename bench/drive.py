# SPDX-License-Identifier: Apache-2.0
"""Times of the drive over speed:  python -m bench.drive

Flanks that part and strike, with their forces, of a train of three bodies at 180 and at 36 points, and the backlash that
is still quiet; against the map of the friction step in the same run."""

import math

import numpy as np

from bench.film import best
from calc.design.toml_file import design, read
from calc.friction.studies.maps import over_speed_and_temperature
from calc.gears.drive.forces import impacts
from calc.gears.drive.motion import Bodies, Motion
from calc.gears.drive.strikes import closed, fly, quiet_backlashes
from calc.solve import solve
from calc.studies.shipped import EXAMPLE

HARMONICS = 16
AB = 35e-3, 70e-3


def train(points: int) -> tuple[Motion, Bodies]:
    """Two idlers and a heavy shaft behind a crank of three cylinders; from idle to rated speed, from no load to full."""
    n = np.arange(1, HARMONICS + 1)
    omega = np.linspace(94.0, 272.0, points)
    a = np.outer(1 + 2 * omega / 272.0, np.exp(-1j * (1.5 - 0.1 * n)) * 7.0 / n**1.3)
    motion = Motion(1.5 * n, a, omega, 4 * math.pi)
    drag = np.outer(omega / 94.0, [0.2, 0.2, 9.0])
    three = (np.array(of) for of in ([0.32, 0.38, 10.25], [38e-6, 38e-6, 53e-6], [15e-3] * 3, [15.2e9] * 3))
    mass, backlash, width, stiffness = three
    return motion, Bodies((-1, 0, 1), np.ones(3), (True,) * 3, mass, drag, backlash, width, stiffness)


def all_of(motion: Motion, bodies: Bodies) -> None:
    of = closed(motion, bodies)
    impacts(motion, bodies, of, fly(motion, bodies, of))


def main() -> None:
    friction = solve(design(read(EXAMPLE))).outcomes["friction"]
    assert friction.further is not None
    drive, _, power, on = friction.further.args  # type: ignore[attr-defined]
    baseline = best(lambda: over_speed_and_temperature(drive, power, on), 1, 3)
    many, few = train(180), train(36)
    rows = (
        ("strikes and forces of 3 bodies at 60 speeds and 3 loads", best(lambda: all_of(*many), 3)),
        ("the same at 12 speeds and 3 loads", best(lambda: all_of(*few), 10)),
        ("backlash that is quiet, two limits", best(lambda: quiet_backlashes(*few, 2, AB), 3)),
    )
    print(f"{'map of the friction step, 28 points (baseline)':66s}{baseline * 1e6:12.1f} µs")
    for title, seconds in rows:
        print(f"{title:66s}{seconds * 1e6:12.1f} µs{seconds / baseline:12.3f}")


if __name__ == "__main__":
    main()
