# SPDX-License-Identifier: Apache-2.0
"""The engine from Python, in SI: `from calc import engine`."""

from .formulas import angular_speed, displacement, mean_piston_speed
from .inputs import EngineInputs
from .solve import values as solve_engine

__all__ = ["EngineInputs", "angular_speed", "displacement", "mean_piston_speed", "solve_engine"]
