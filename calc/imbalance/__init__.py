# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of every order, forward and backward; crank webs and bobs, and remedies that balance."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module; loaded when it is asked for
OFFERED = {
    "ImbalanceInputs": ".inputs",
    "couple_per_degree": ".formulas",
    "solve_imbalance": ".solve",
    "unbalance_product": ".formulas",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(OFFERED[name], __name__), name)


def __dir__() -> list[str]:
    return __all__
