# SPDX-License-Identifier: Apache-2.0
"""What stands around the wheels, and how much room each of them has at a point: plain numbers or arrays of points.

`clearances.py` says the same line by line for the places that are taken in the end.
"""

import math
from typing import TYPE_CHECKING, Any

from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import Metre
from ..inputs import GearsInputs
from . import formulas as f

if TYPE_CHECKING:
    from ..result import TrainResult

FREE = math.inf  # the clearance of a wheel that has nothing near it


@record
class Room:
    """Walls, neighbours, and how far each wheel reaches."""

    walls: tuple[tuple[str, complex, complex], ...]
    neighbours: tuple[tuple[str, complex, Metre], ...]
    swept: dict[str, Metre]
    mates: dict[str, set[str]]

    def around(self, wheel: str, p: complex, places: dict[str, complex]) -> Metre:
        """The smallest clearance of a wheel at a point; `places`: of the other wheels."""
        r_s = self.swept[wheel]
        found = [f.wall_distance.function(p, a, b) - r_s for _, a, b in self.walls]
        found += [abs(p - q) - r_s - r for _, q, r in self.neighbours]
        found += [abs(p - q) - r_s - self.swept[name] for name, q in places.items() if name != wheel and name not in self.mates[wheel]]
        return min(found, default=FREE)

    def around_all(self, wheel: str, p: Any, places: dict[str, complex]) -> Any:
        """The same for an array of points."""
        import numpy as np

        r_s = self.swept[wheel]
        least: Any = np.full(p.shape, FREE)
        for _, a, b in self.walls:
            share = np.clip(((p - a) * (b - a).conjugate()).real / abs(b - a) ** 2, 0.0, 1.0)
            least = np.minimum(least, np.abs(p - a - share * (b - a)) - r_s)
        for _, q, r in self.neighbours:
            least = np.minimum(least, np.abs(p - q) - r_s - r)
        for name, q in places.items():
            if name != wheel and name not in self.mates[wheel]:
                least = np.minimum(least, np.abs(p - q) - r_s - self.swept[name])
        return least


def room(gears: GearsInputs, train: "TrainResult") -> Room:
    mates: dict[str, set[str]] = {w.name: set() for w in gears.wheels}
    tolerance: dict[str, Metre] = {}
    for mesh in train.meshes.values():
        for one, other in ((mesh.driver, mesh.driven), (mesh.driven, mesh.driver)):
            mates[one].add(other)
            if mesh.centre_tolerance > tolerance.get(one, -1.0):
                tolerance[one] = mesh.centre_tolerance
    swept = {}
    for wheel in gears.wheels:
        upper = wheel.tip_diameter_tolerance[0] if wheel.tip_diameter_tolerance else 0.0
        with about(f"wheel {wheel.name}, room"):
            swept[wheel.name] = f.swept_radius(
                d_a=train.wheels[wheel.name].tip_diameter, E_da=upper, F_r=wheel.runout or 0.0, T_a=tolerance[wheel.name]
            )
    return Room(
        tuple((w.name, complex(*w.from_), complex(*w.to)) for w in gears.walls),
        tuple((n.name, complex(*n.position), n.radius) for n in gears.neighbours),
        swept,
        mates,
    )
