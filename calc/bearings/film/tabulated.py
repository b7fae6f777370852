# SPDX-License-Identifier: Apache-2.0
"""The stored solutions of Reynolds' equation as lines of the calculation."""

from functools import lru_cache

from ...sheet.formula import formula
from ...sheet.text import Text
from ...sheet.units import Number, Radian
from . import table as film_table
from .table import FilmPoint, eccentricity_from

SOURCE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")
_film_at = lru_cache(maxsize=4)(film_table.film_at)  # five lines of a calculation ask for the same point
_film_slopes = lru_cache(maxsize=4)(film_table.film_slopes)


def film_at(eps: Number, b: Number) -> FilmPoint[float]:
    return _film_at(eps, b) if _plain(eps, b) else film_table.film_at(eps, b)


def film_slopes(eps: Number, b: Number) -> tuple[float, float]:
    return _film_slopes(eps, b) if _plain(eps, b) else film_table.film_slopes(eps, b)


def _plain(*numbers: object) -> bool:
    """No arrays, which can not be looked up."""
    return all([isinstance(number, (float, int)) for number in numbers])


@formula("ε", SOURCE, shows="ε from S(ε, l/d): table of Reynolds' solutions, inverted")
def eccentricity(S: Number, b: Number) -> Number:
    """>>> eccentricity(S=0.05436, b=0.4622)
    0.8637773...
    """
    return eccentricity_from(S, b)


@formula("φ", SOURCE, shows="φ from the table of Reynolds' solutions at ε, l/d")
def attitude_angle(eps: Number, b: Number) -> Radian:
    """>>> attitude_angle(eps=0.8638, b=0.4622)
    0.4707118...
    """
    return film_at(eps, b).attitude


@formula("Q*", SOURCE, shows="Q* = Q/(r·c·n·l) from the table of Reynolds' solutions at ε, l/d")
def relative_flow(eps: Number, b: Number) -> Number:
    return film_at(eps, b).flow


@formula("Q_s/Q", SOURCE, shows="Q_s/Q from the table of Reynolds' solutions at ε, l/d")
def side_flow_share(eps: Number, b: Number) -> Number:
    return film_at(eps, b).side_flow_ratio


@formula("p/p_max", SOURCE, shows="p/p_max from the table of Reynolds' solutions at ε, l/d")
def pressure_ratio(eps: Number, b: Number) -> Number:
    return film_at(eps, b).pressure_ratio
