# SPDX-License-Identifier: Apache-2.0
"""The crank train: geometry, kinematics, masses, crank angles, firing, gas and torque, the strength of a throw."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module, behind a colon how it is called there; loaded when it is asked for
OFFERED = {
    "EngineInputs": ".inputs",
    "angular_speed": ".formulas",
    "displacement": ".formulas",
    "mean_piston_speed": ".formulas",
    "solve_engine": ".solve",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module, _, called = OFFERED[name].partition(":")
    return getattr(import_module(module, __name__), called or name)


def __dir__() -> list[str]:
    return __all__
