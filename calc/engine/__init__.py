# SPDX-License-Identifier: Apache-2.0
"""The crank train: geometry, kinematics, masses, crank angles."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["EngineInputs", "angular_speed", "displacement", "mean_piston_speed", "solve_engine"]

if TYPE_CHECKING:
    from .public import EngineInputs, angular_speed, displacement, mean_piston_speed, solve_engine
else:
    __getattr__ = lazy(__name__, __all__)
