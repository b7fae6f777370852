# SPDX-License-Identifier: Apache-2.0
"""The crank train: geometry, kinematics, masses, crank angles, firing, gas and torque, the strength of a throw."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from .formulas import angular_speed as angular_speed
    from .formulas import displacement as displacement
    from .formulas import mean_piston_speed as mean_piston_speed
    from .inputs import EngineInputs as EngineInputs
    from .result import EngineResult as EngineResult
    from .solve import solve_engine as solve_engine

offer(globals())
