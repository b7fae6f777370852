# SPDX-License-Identifier: Apache-2.0
"""Plain bearings: film, friction, oil flow, temperature, clearance, what suits them, and a search for better ones."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["Feed", "film_at", "relative_clearance", "solve_film", "solve_grooved", "sommerfeld", "specific_load"]

if TYPE_CHECKING:
    from ..library.journal_rules import specific_load
    from .film.grooved import Feed, solve_grooved
    from .film.table import film_at
    from .formulas import relative_clearance, sommerfeld
    from .solve import solve_film
else:
    __getattr__ = lazy(
        __name__,
        {
            "Feed": ".film.grooved",
            "film_at": ".film.table",
            "relative_clearance": ".formulas",
            "solve_film": ".solve",
            "solve_grooved": ".film.grooved",
            "sommerfeld": ".formulas",
            "specific_load": "..library.journal_rules",
        },
    )
