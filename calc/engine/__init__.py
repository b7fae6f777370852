# SPDX-License-Identifier: Apache-2.0
"""The crank train: geometry, kinematics, masses, crank angles, firing, gas and torque, the strength of a throw."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["EngineInputs", "angular_speed", "displacement", "mean_piston_speed", "solve_engine"]

if TYPE_CHECKING:
    from .formulas import angular_speed, displacement, mean_piston_speed
    from .inputs import EngineInputs
    from .solve import values as solve_engine
else:
    __getattr__ = lazy(
        __name__,
        {
            "EngineInputs": ".inputs",
            "angular_speed": ".formulas",
            "displacement": ".formulas",
            "mean_piston_speed": ".formulas",
            "solve_engine": ".solve:values",
        },
    )
