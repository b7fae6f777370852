# SPDX-License-Identifier: Apache-2.0
"""The source's first method: the charts of Raimondi & Boyd 1958, carried to any l/d by the cubic in d/l of the source.

The published rows stand in tables/raimondi_boyd.toml.  The cubic is exact at l/d = ∞, 1, ½ and ¼; between ½ and ¼ it errs by up to
−18 … +34 % in the film, which is why this route is shown and does not judge.
"""

import math
import tomllib
from bisect import bisect
from functools import cache
from itertools import pairwise

from ...catalogue import TABLES
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Number

LOWEST_RATIO = 0.25  # the cubic is not defined below the charts' smallest l/d


class OutsideCharts(ValueError):
    """The point lies outside the published charts."""


@record
class _Line:
    """One quantity of one chart over ln S, with the slopes of a monotone cubic (Fritsch & Carlson 1980, harmonic means)."""

    x: list[float]
    y: list[float]
    slopes: list[float]

    def at(self, x: float) -> float:
        k = min(max(bisect(self.x, x) - 1, 0), len(self.x) - 2)
        h = self.x[k + 1] - self.x[k]
        t = (x - self.x[k]) / h
        left = (1 + 2 * t) * (1 - t) ** 2 * self.y[k] + t * (1 - t) ** 2 * h * self.slopes[k]
        return left + t**2 * (3 - 2 * t) * self.y[k + 1] - t**2 * (1 - t) * h * self.slopes[k + 1]


def _line(x: list[float], y: list[float]) -> _Line:
    h = [b - a for a, b in pairwise(x)]
    rise = [(b - a) / w for (a, b), w in zip(pairwise(y), h)]
    between = zip(pairwise(h), pairwise(rise))
    inner = [3 * (h1 + h2) / ((2 * h2 + h1) / r1 + (h2 + 2 * h1) / r2) for (h1, h2), (r1, r2) in between]
    return _Line(x, y, [rise[0], *inner, rise[-1]])


@cache
def _charts() -> dict[float, tuple[_Line, _Line]]:
    """Per l/d: ε and ln f* over ln S."""
    rows = tomllib.loads((TABLES / "raimondi_boyd.toml").read_text(encoding="utf-8"))["row"]
    charts = {}
    for ratio in sorted({float(r["length_ratio"]) for r in rows}):
        mine = sorted((r for r in rows if float(r["length_ratio"]) == ratio), key=lambda r: r["S"])
        ln_S = [math.log(r["S"]) for r in mine]
        charts[ratio] = _line(ln_S, [r["eccentricity"] for r in mine]), _line(ln_S, [math.log(r["friction_variable"]) for r in mine])
    return charts


def _read(chart: tuple[_Line, _Line], S: float) -> tuple[float, float]:
    """h₀/c and f* of one chart at S.  Above the last point, ε falls and f* rises in proportion to 1/S and S, as they do for ε → 0."""
    eps, ln_f = chart
    x = math.log(S)
    if x < eps.x[0]:
        raise OutsideCharts(
            Text("S = {s} is below the charts ({exp})", s=Amount(S, form=".4g"), exp=Amount(math.exp(eps.x[0]), form=".4g"))
        )
    if x > eps.x[-1]:
        beyond = math.exp(x - eps.x[-1])
        return 1 - eps.y[-1] / beyond, math.exp(ln_f.y[-1]) * beyond
    return 1 - eps.at(x), math.exp(ln_f.at(x))


def chart_readings(S: float) -> dict[float, tuple[float, float]]:
    """h₀/c and f* of every chart at the same S."""
    return {ratio: _read(chart, S) for ratio, chart in _charts().items()}


@formula(
    "y", "Raimondi & Boyd 1958, interpolation in l/d at constant S (Finotti 2013, 5.5.2)",
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
        raise OutsideCharts(Text("l/d = {b} is below the charts ({lowest_ratio})", b=Amount(b, form=".3g"), lowest_ratio=LOWEST_RATIO))
    y = {ratio: pair[which] for ratio, pair in chart_readings(S).items()}
    return by_length_ratio.function(b, y[math.inf], y[1.0], y[0.5], y[0.25])
