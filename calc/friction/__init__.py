# SPDX-License-Identifier: Apache-2.0
"""Friction of the meshes, the other losses of the train, and the power balance of the whole drive."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module; loaded when it is asked for
OFFERED = {
    "mass_loss": ".losses.turning_masses",
    "schlenk": ".models",
    "solve_loss": ".solve",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(OFFERED[name], __name__), name)


def __dir__() -> list[str]:
    return __all__
