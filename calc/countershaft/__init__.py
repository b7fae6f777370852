# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: what it supplies, what its supports carry, how it bends, is sized, made and mounted."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module, behind a colon how it is called there; loaded when it is asked for
OFFERED = {
    "OrderVectors": ".sums",
    "Rigid": ".bending.carried",
    "Spring": ".bending.carried",
    "SystemShaft": ".sums",
    "at_rest": ".bending.condensed",
    "carried": ".bending.carried",
    "condensed": ".bending.condensed",
    "permitted_unbalance": "..library.tolerances",
    "sector_area": ".outline",
    "sector_mass": ".outline",
    "size_sectors": ".sizing.sectors:pair",
    "size_stretches": ".sizing.stretches",
    "specific_load": "..library.journal_rules",
    "standing_on": ".bending.condensed",
    "stretches": ".sizing.stretches",
    "together": ".sums",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module, _, called = OFFERED[name].partition(":")
    return getattr(import_module(module, __name__), called or name)


def __dir__() -> list[str]:
    return __all__
