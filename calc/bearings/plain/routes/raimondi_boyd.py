# SPDX-License-Identifier: Apache-2.0
"""The charts of Raimondi & Boyd 1958, carried to any l/d by their cubic in d/l: film, friction, attitude, flow and
largest pressure.

The published rows stand in tables/raimondi_boyd.toml.  The cubic is exact at l/d = ∞, 1, ½ and ¼; between ½ and ¼ it
errs by up to −18 … +34 % in the film, which is why these routes are shown and do not judge.

Their own flow is that of a film that draws its oil in without pressure: Q enters, Q_s of it leaves over the edges on
the way, at the mean of both temperatures, the rest at the end of the film.  The source (as Shigley for a pressure-fed
bearing) takes instead what the supply pressure drives through, alone."""

import math
from bisect import bisect
from functools import cache, lru_cache
from itertools import pairwise
from typing import NamedTuple

from ....library.table_file import house_table
from ....sheet.formula import formula
from ....sheet.record import record
from ....sheet.text import Amount, Text
from ....sheet.units import (
    CubicMetrePerSecond,
    JoulePerKilogramKelvin,
    Kelvin,
    KilogramPerMetre3,
    Metre,
    Number,
    Radian,
    RevPerSecond,
    Watt,
)
from .states import OutsideCharts

LOWEST_RATIO = 0.25  # the cubic is not defined below the charts' smallest l/d


@record
class _Line:
    """One quantity of one chart over ln S, with the slopes of a monotone cubic (Fritsch & Carlson 1980, harmonic
    means)."""

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
    inner = [
        3 * (h1 + h2) / ((2 * h2 + h1) / r1 + (h2 + 2 * h1) / r2) if r1 * r2 > 0 else 0.0
        for (h1, h2), (r1, r2) in between
    ]
    return _Line(x, y, [rise[0], *inner, rise[-1]])


class Reading(NamedTuple):
    """What the charts say at one S and l/d; between the charts' l/d each by the cubic."""

    relative_film: float  # h₀/c
    friction_variable: float  # f*
    flow: float  # Q/(r·c·n·l)
    side_flow_share: float  # Q_s/Q
    attitude: float  # φ in degrees
    pressure_ratio: float  # P/p_max


CENTRED = Reading(1.0, math.inf, math.pi, 0.0, 90.0, 0.5)  # ε → 0, but for P/p_max, which is held at the last point


@cache
def _charts() -> dict[float, list[_Line]]:
    """Per l/d the lines over ln S, in the order of `Reading`: ε and ln f* for its first two."""
    rows = house_table("raimondi_boyd.toml")["row"]
    charts = {}
    for ratio in sorted({float(r["length_ratio"]) for r in rows}):
        mine = sorted((r for r in rows if float(r["length_ratio"]) == ratio), key=lambda r: r["S"])
        columns = [[r["eccentricity"] for r in mine], [math.log(r["friction_variable"]) for r in mine]]
        columns += [[r[name] for r in mine] for name in ("flow", "side_flow_share", "attitude_deg", "pressure_ratio")]
        charts[ratio] = [_line([math.log(r["S"]) for r in mine], column) for column in columns]
    return charts


def _read(chart: list[_Line], S: float) -> Reading:
    """One chart at S.  Above the last point, ε, Q_s/Q, Q's and φ's distance from the centred journal's fall and f*
    rises in proportion to 1/S and S, as they do for ε → 0."""
    x = math.log(S)
    first, last = chart[0].x[0], chart[0].x[-1]
    if x < first:
        raise OutsideCharts(
            Text(
                "S = {s} is below the charts ({exp})", s=Amount(S, form=".4g"), exp=Amount(math.exp(first), form=".4g")
            )
        )
    eps, ln_f, flow, share, attitude, pressure = (line.at(min(x, last)) for line in chart)
    beyond = math.exp(max(x - last, 0.0))
    return Reading(
        1 - eps / beyond,
        math.exp(ln_f) * beyond,
        CENTRED.flow + (flow - CENTRED.flow) / beyond,
        share / beyond,
        CENTRED.attitude + (attitude - CENTRED.attitude) / beyond,
        pressure,
    )


@lru_cache(maxsize=16)
def chart_readings(S: float) -> dict[float, Reading]:
    """Every chart at the same S."""
    return {ratio: _read(chart, S) for ratio, chart in _charts().items()}


@formula(
    "y",
    "Raimondi & Boyd 1958, interpolation in l/d at constant S (Finotti 2013, 5.5.2)",
    names={"b": "(l/d)", "y_inf": "y_∞", "y_1": "y_1", "y_2": "y_½", "y_4": "y_¼"},
)
def by_length_ratio(b: Number, y_inf: Number, y_1: Number, y_2: Number, y_4: Number) -> Number:
    """The cubic in d/l through l/d = ∞, 1, ½, ¼; not below ¼."""
    return (
        -(1 - b) * (1 - 2 * b) * (1 - 4 * b) * y_inf / 8
        + (1 - 2 * b) * (1 - 4 * b) * y_1 / 3
        - (1 - b) * (1 - 4 * b) * y_2 / 4
        + (1 - b) * (1 - 2 * b) * y_4 / 24
    ) / b**3


BY_CHART = Text("Raimondi & Boyd 1958, charts and interpolation of the source")


@formula("h_0/c", BY_CHART, shows="h_0/c from the charts at S, by the cubic in d/l", names={"b": "l/d"})
def relative_film(S: Number, b: Number) -> Number:
    return at(S, b).relative_film


@formula("f*", BY_CHART, shows="f* from the charts at S, by the cubic in d/l", names={"b": "l/d"})
def friction_variable(S: Number, b: Number) -> Number:
    return at(S, b).friction_variable


@formula("Q*", BY_CHART, shows="Q/(r·c·n·l) from the charts at S, by the cubic in d/l", names={"b": "l/d"})
def relative_flow(S: Number, b: Number) -> Number:
    return at(S, b).flow


@formula("Q_s/Q", BY_CHART, shows="Q_s/Q from the charts at S, by the cubic in d/l", names={"b": "l/d"})
def side_flow_share(S: Number, b: Number) -> Number:
    return at(S, b).side_flow_share


@formula("φ", BY_CHART, shows="φ from the charts at S, by the cubic in d/l", unit="°", names={"b": "l/d"})
def attitude_angle(S: Number, b: Number) -> Radian:
    return math.radians(at(S, b).attitude)


@formula("p/p_max", BY_CHART, shows="p/p_max from the charts at S, by the cubic in d/l", names={"b": "l/d"})
def pressure_ratio(S: Number, b: Number) -> Number:
    return at(S, b).pressure_ratio


def at(S: float, b: float) -> Reading:
    """The charts at S and l/d, which six formulas ask for one after the other."""
    return _at(float(S), float(b))  # no line of the calculation that leads to them is kept with what is known


@lru_cache(maxsize=16)
def _at(S: float, b: float) -> Reading:
    if b < LOWEST_RATIO:
        raise OutsideCharts(
            Text("l/d = {b} is below the charts ({lowest_ratio})", b=Amount(b, form=".3g"), lowest_ratio=LOWEST_RATIO)
        )
    y = chart_readings(S)
    return Reading(*(by_length_ratio.function(b, *four) for four in zip(y[math.inf], y[1.0], y[0.5], y[0.25])))


@formula("Q", "Raimondi & Boyd 1958: flow that the turning film draws in", unit="L/min", names={"Q_rel": "Q*"})
def film_flow(Q_rel: Number, d: Metre, g: Metre, n_h: RevPerSecond, l: Metre) -> CubicMetrePerSecond:
    """Q/(r·c·n·l) = Q*."""
    return Q_rel * d * g * n_h * l / 4


@formula(
    "Q_s", "Raimondi & Boyd 1958: the part of it that leaves over the edges", unit="L/min", names={"share": "(Q_s/Q)"}
)
def side_flow(share: Number, Q: CubicMetrePerSecond) -> CubicMetrePerSecond:
    return share * Q


@formula("ΔT", "Raimondi & Boyd 1958: what leaves over the edges has warmed by half, the rest by the whole", unit="K")
def temperature_rise(
    P_f: Watt, rho: KilogramPerMetre3, c_p: JoulePerKilogramKelvin, Q: CubicMetrePerSecond, Q_s: CubicMetrePerSecond
) -> Kelvin:
    return P_f / (rho * c_p * (Q - Q_s / 2))
