# SPDX-License-Identifier: Apache-2.0
"""Bearings of a shaft, plain and rolling ones: what each carries and loses, how long it lives, and a search for better
ones."""

from importlib import import_module
from typing import Any

# what this package offers, each from its module; loaded when it is asked for
OFFERED = {
    "Feed": ".plain.film.grooved",
    "Film": ".plain.as_support",
    "Springs": ".rolling.contact",
    "film_at": ".plain.film.table",
    "relative_clearance": ".plain.formulas",
    "solve_film": ".plain.solve",
    "solve_grooved": ".plain.film.grooved",
    "sommerfeld": ".plain.formulas",
    "specific_load": "..library.journal_rules",
}
__all__ = [*OFFERED]


def __getattr__(name: str) -> Any:
    if name not in OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(OFFERED[name], __name__), name)


def __dir__() -> list[str]:
    return __all__
