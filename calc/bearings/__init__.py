# SPDX-License-Identifier: Apache-2.0
"""Bearings of a shaft, plain and rolling ones: what each carries and loses, how long it lives, and a search for better
ones."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from ..library.journal_rules import specific_load as specific_load
    from .inputs import BearingsInputs as BearingsInputs
    from .plain.as_support import FilmLaw as FilmLaw
    from .plain.film.grooved import Feed as Feed
    from .plain.film.grooved import solve_grooved as solve_grooved
    from .plain.film.table import film_at as film_at
    from .plain.formulas import relative_clearance as relative_clearance
    from .plain.formulas import sommerfeld as sommerfeld
    from .plain.routes.states import Film as Film
    from .plain.solve import solve_film as solve_film
    from .result import BearingsResult as BearingsResult
    from .rolling.contact import Springs as Springs

offer(globals())
