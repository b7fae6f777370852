# SPDX-License-Identifier: Apache-2.0
"""The gear train: geometry, measures, backlash, its place in the engine, profile, rating, and a search for shifts."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module; loaded when it is asked for
OFFERED = {
    "centre_distance": ".formulas",
    "contact_stress": ".rating.stress",
    "solve_pair": ".solve",
    "span": ".measures.formulas",
    "tip_diameter": ".formulas",
    "transverse_contact_ratio": ".formulas",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(OFFERED[name], __name__), name)


def __dir__() -> list[str]:
    return __all__
