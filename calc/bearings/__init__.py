# SPDX-License-Identifier: Apache-2.0
"""Plain bearings: film, friction, oil flow, temperature, clearance."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["Feed", "film_at", "relative_clearance", "solve_film", "solve_grooved", "sommerfeld", "specific_load"]

if TYPE_CHECKING:
    from .public import Feed, film_at, relative_clearance, solve_film, solve_grooved, sommerfeld, specific_load
else:
    __getattr__ = lazy(__name__, __all__)
