# SPDX-License-Identifier: Apache-2.0
"""A pair of gears from Python, in SI: `from calc import gears`."""

import math

from ..sheet.units import Metre, Number, Radian, RevPerSecond
from .formulas import centre_distance, tip_diameter, transverse_contact_ratio
from .inputs import GearsInputs, Mesh, Wheel
from .measures.formulas import span
from .rating.stress import contact_stress
from .result import TrainResult
from .solve import geometry

__all__ = ["centre_distance", "contact_stress", "solve_pair", "span", "tip_diameter", "transverse_contact_ratio"]

DEGREES_20: Radian = math.radians(20.0)


def solve_pair(
    teeth: tuple[int, int],
    *,
    normal_module: Metre,
    face_width: Metre,
    helix_angle: Radian = 0.0,
    pressure_angle: Radian = DEGREES_20,
    profile_shift: tuple[Number | None, Number | None] = (None, None),
    centre_distance: Metre | None = None,
    tool_addendum: Number = 1.25,
    tool_tip_radius: Number = 0.38,
    speed: RevPerSecond = 1.0,
) -> TrainResult:
    """Geometry, measures and contact of two wheels: `wheels["driver"]`, `wheels["driven"]`, `meshes["driver_driven"]`.

    What is left out of profile shifts and centre distance follows from the others; without any of them the shifts are
    0, and without a distance there is no backlash.  Tool sizes in modules; `speed` of the driver.  Raises NoSolution
    where the teeth cannot be made."""
    wheels = tuple(
        Wheel(name=name, teeth=z, profile_shift=x) for name, z, x in zip(("driver", "driven"), teeth, profile_shift)
    )
    train = GearsInputs(
        normal_module=normal_module,
        pressure_angle=pressure_angle,
        helix_angle=helix_angle,
        face_width=face_width,
        tool_addendum=tool_addendum,
        tool_tip_radius=tool_tip_radius,
        wheels=wheels,
        meshes=(Mesh(driver="driver", driven="driven", centre_distance=centre_distance),),
    )
    return geometry(train, speed).solution
