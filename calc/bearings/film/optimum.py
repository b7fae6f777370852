# SPDX-License-Identifier: Apache-2.0
"""Between the largest load and the least friction: the two films h₀/c that Raimondi and Boyd mark on their chart.

With the smallest film h₀ held, c = h₀/(1 − ε): the load goes with (1 − ε)²/S, the coefficient of friction with f*/(1 − ε).
"""

import numpy as np

from ...sheet.arrays import Array, element, one
from ...sheet.formula import formula
from ...sheet.text import Text
from ...sheet.units import Number
from .table import film_at

ECCENTRICITIES = np.linspace(0.04, 0.97, 94)
RAIMONDI_BOYD = Text("Raimondi & Boyd 1958, chart of the smallest film")


@formula(
    "b_f", Text("{chart}: 0 at the least friction, 100 % at the largest load", chart=RAIMONDI_BOYD), unit="%",
    names={"eps": "ε", "share_f": "(h_0/c)_f", "share_F": "(h_0/c)_F"},
)  # fmt: skip
def place_in_band(eps: Number, share_f: Number, share_F: Number) -> Number:
    return (1 - eps - share_f) / (share_F - share_f)


@formula("(h_0/c)_F", RAIMONDI_BOYD, names={"b": "l/d"}, shows="where (1 − ε)²/S of this l/d is largest")
def share_of_largest_load(b: Number) -> Number:
    """Published for l/d 1, ½ and ¼, as read from the chart: 0.53, 0.43 and 0.27 (from memory of Shigley).

    >>> share_of_largest_load(b=1.0)
    0.53...
    """
    film = film_at(ECCENTRICITIES, one(b))
    return _summit((1 - ECCENTRICITIES) ** 2 / film.sommerfeld)


@formula("(h_0/c)_f", RAIMONDI_BOYD, names={"b": "l/d"}, shows="where f*/(1 − ε) of this l/d is smallest")
def share_of_least_friction(b: Number) -> Number:
    """Published for l/d 1, ½ and ¼, as read from the chart: 0.30, 0.12 and 0.03 (from memory of Shigley).

    >>> share_of_least_friction(b=1.0)
    0.33...
    """
    film = film_at(ECCENTRICITIES, one(b))
    return _summit(-film.friction / (1 - ECCENTRICITIES))


def _summit(y: Array) -> float:
    """h₀/c where y is largest, by the parabola through its three highest points; at an end of the range that end."""
    at = np.argmax(y)
    if at == 0 or at == len(y) - 1:
        return element(1 - ECCENTRICITIES, at)
    below, middle, above = (element(y, at + n) for n in (-1, 0, 1))
    step = ECCENTRICITIES[1] - ECCENTRICITIES[0]
    summit: float = one(element(1 - ECCENTRICITIES, at) - step / 2 * (below - above) / (below - 2 * middle + above))
    return summit
