# SPDX-License-Identifier: Apache-2.0
"""The source's first method: the charts of Raimondi & Boyd 1958, carried to any l/d by the cubic in d/l of the source.

The published rows stand in tables/raimondi_boyd.toml.  The cubic is exact at l/d = ∞, 1, ½ and ¼; between ½ and ¼ it errs by up to
−18 … +34 % in the film, which is why this route is shown and does not judge.
"""

import math
import tomllib
from functools import cache

import numpy as np

from ..catalogue import TABLES
from ..sheet.arrays import Array
from ..sheet.formula import formula
from ..sheet.units import Number

LOWEST_RATIO = 0.25  # the cubic is not defined below the charts' smallest l/d


class OutsideCharts(ValueError):
    """The point lies outside the published charts."""


@cache
def _charts() -> dict[float, tuple[Array, Array, Array]]:
    """Per l/d: ln S, ε and ln f*, by falling ε (rising S)."""
    rows = tomllib.loads((TABLES / "raimondi_boyd.toml").read_text(encoding="utf-8"))["row"]
    charts = {}
    for ratio in sorted({float(r["length_ratio"]) for r in rows}):
        mine = sorted((r for r in rows if float(r["length_ratio"]) == ratio), key=lambda r: r["S"])
        charts[ratio] = (
            np.log([r["S"] for r in mine]), np.array([r["eccentricity"] for r in mine]), np.log([r["friction_variable"] for r in mine]),
        )  # fmt: skip
    return charts


def _read(chart: tuple[Array, Array, Array], S: float) -> tuple[float, float]:
    """h₀/c and f* of one chart at S.  Above the last point, ε falls and f* rises in proportion to 1/S and S, as they do for ε → 0."""
    ln_S, eps, ln_f = chart
    x = math.log(S)
    if x < ln_S[0]:
        raise OutsideCharts(f"S = {S:.4g} is below the charts ({math.exp(ln_S[0]):.4g})")
    if x > ln_S[-1]:
        beyond = math.exp(x - ln_S[-1])
        return 1 - float(eps[-1]) / beyond, math.exp(ln_f[-1]) * beyond
    return 1 - _cubic(ln_S, eps, x), math.exp(_cubic(ln_S, ln_f, x))


def _cubic(x: Array, y: Array, at: float) -> float:
    """Monotone cubic interpolation (Fritsch & Carlson 1980, harmonic slopes)."""
    h, delta = np.diff(x), np.diff(y) / np.diff(x)
    w1, w2 = 2 * h[1:] + h[:-1], h[1:] + 2 * h[:-1]
    slopes = np.concatenate([delta[:1], (w1 + w2) / (w1 / delta[:-1] + w2 / delta[1:]), delta[-1:]])
    k = min(max(int(np.searchsorted(x, at)) - 1, 0), h.size - 1)
    t = (at - x[k]) / h[k]
    value = (
        (1 + 2 * t) * (1 - t) ** 2 * y[k]
        + t * (1 - t) ** 2 * h[k] * slopes[k]
        + t**2 * (3 - 2 * t) * y[k + 1]
        - t**2 * (1 - t) * h[k] * slopes[k + 1]
    )
    return float(value)


def chart_readings(S: float) -> dict[float, tuple[float, float]]:
    """h₀/c and f* of every chart at the same S."""
    return {ratio: _read(chart, S) for ratio, chart in _charts().items()}


@formula(
    "y", "Raimondi & Boyd 1958, interpolation in l/d at constant S (Finotti 2013, 5.5.1)",
    names={"b": "(l/d)", "y_inf": "y_∞", "y_1": "y_1", "y_2": "y_½", "y_4": "y_¼"},
)  # fmt: skip
def by_length_ratio(b: Number, y_inf: Number, y_1: Number, y_2: Number, y_4: Number) -> Number:
    """The cubic in d/l through l/d = ∞, 1, ½, ¼; not below ¼."""
    return (
        -(1 - b) * (1 - 2 * b) * (1 - 4 * b) * y_inf / 8
        + (1 - 2 * b) * (1 - 4 * b) * y_1 / 3
        - (1 - b) * (1 - 4 * b) * y_2 / 4
        + (1 - b) * (1 - 2 * b) * y_4 / 24
    ) / b**3


@formula("h_0/c", "Raimondi & Boyd 1958, charts and interpolation of the source", shows="h_0/c from the charts at S, by the cubic in d/l")
def relative_film(S: Number, b: Number) -> Number:
    return _at(S, b, 0)


@formula("f*", "Raimondi & Boyd 1958, charts and interpolation of the source", shows="f* from the charts at S, by the cubic in d/l")
def friction_variable(S: Number, b: Number) -> Number:
    return _at(S, b, 1)


def _at(S: float, b: float, which: int) -> float:
    if b < LOWEST_RATIO:
        raise OutsideCharts(f"l/d = {b:.3g} is below the charts ({LOWEST_RATIO})")
    y = {ratio: pair[which] for ratio, pair in chart_readings(S).items()}
    return by_length_ratio.function(b, y[math.inf], y[1.0], y[0.5], y[0.25])
