# SPDX-License-Identifier: Apache-2.0
"""Whether the oil of the bearings leaves by the support's drains while the machine stands tilted.

The passage to a drain loses of its slope what the machine tilts.  What runs off by the rest is that of a half-full pipe of its narrowest
bore, with the oil as it leaves the bearings; cold, it runs off far slower, and the film carries out as much.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from ...sheet.check import Check, check
from ...sheet.formula import formula
from ...sheet.functions import pi, power, sin, smallest
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.trace import about, trace
from ...sheet.units import CubicMetrePerSecond, Metre, MetrePerSecond, MetrePerSecond2, Number, Radian, SquareMetrePerSecond
from ..result import CountershaftResult
from .drain import DrainResult, named

if TYPE_CHECKING:
    from ...bearings.result import BearingsResult

G: MetrePerSecond2 = 9.80665
PIPE = Text("physics, steady flow down a half-full pipe, whose hydraulic diameter is its bore")


@formula("v_l", Text("{pipe}: laminar (Hagen, Poiseuille)", pipe=PIPE), names={"theta": "θ_d", "d": "d_d", "G": "g"})
def laminar_speed(theta: Radian, d: Metre, nu: SquareMetrePerSecond) -> MetrePerSecond:
    return G * sin(theta) * d**2 / (32 * nu)


@formula("v_t", Text("{pipe}: turbulent, smooth wall, coefficient of friction 0.316/Re^0.25 (Blasius)", pipe=PIPE),
    names={"theta": "θ_d", "d": "d_d", "G": "g"})  # fmt: skip
def turbulent_speed(theta: Radian, d: Metre, nu: SquareMetrePerSecond) -> MetrePerSecond:
    return power(2 * G * sin(theta) * power(d, 5 / 4) / (0.316 * power(nu, 1 / 4)), 4 / 7)


@formula(
    "Q_d", "rule of this program: half full, since air has to come back the same way; of both frictions the larger", names={"d": "d_d"}
)
def run_off(d: Metre, v_l: MetrePerSecond, v_t: MetrePerSecond) -> CubicMetrePerSecond:
    return pi / 8 * d**2 * smallest(v_l, v_t)


@formula("Q_o", "given in the design: what of each bearing's oil the drain takes")
def oil_taken(x_f: Number, Q_f: CubicMetrePerSecond, x_r: Number, Q_r: CubicMetrePerSecond) -> CubicMetrePerSecond:
    return x_f * Q_f + x_r * Q_r


def with_oil(outcome: Outcome[CountershaftResult], bearings: "BearingsResult | None") -> Outcome[CountershaftResult]:
    """The same outcome with the bearings' oil against what runs off, of each drain whose bore is given and that has a slope left."""
    shaft = outcome.result
    if shaft is None or bearings is None:
        return outcome
    with trace() as lines:
        drain = _with_oil(shaft.drain, bearings) if shaft.drain is not None else None
        further = {name: _with_oil(one, bearings) for name, one in (shaft.further_drains or {}).items()}
    found = [named(made, name) for name, one in {"": drain, **further}.items() if one is not None for made in _checks(one)]
    result = replace(shaft, drain=drain, further_drains=further or None)
    return replace(outcome, result=result, checks=(*outcome.checks, *found), lines=(*outcome.lines, *lines)) if found else outcome


def _with_oil(one: DrainResult, bearings: "BearingsResult") -> DrainResult:
    drain, slope = one.drain, one.drain_slope
    if drain.bore is None or slope is None or slope <= 0:
        return one
    front, rear = bearings.bearings["front"], bearings.bearings["rear"]
    with about(Text("oil drain")):
        nu = max(bearing.seat.oil_at(bearing.outlet_temperature).nu for bearing in (front, rear))
        v_l, v_t = laminar_speed(theta=slope, d=drain.bore, nu=nu), turbulent_speed(theta=slope, d=drain.bore, nu=nu)
        flow = oil_taken(x_f=drain.oil_share[0], Q_f=front.oil_flow, x_r=drain.oil_share[1], Q_r=rear.oil_flow)
        return replace(one, drain_flow=flow, drain_run_off=run_off(d=drain.bore, v_l=v_l, v_t=v_t))


def _checks(one: DrainResult) -> Iterator[Check]:
    if one.drain_flow is not None and one.drain_run_off is not None:
        yield check(f"{one.drain.id}.run_off", Text("Oil of the bearings that the drain takes"), one.drain_flow, "<=", one.drain_run_off,
            "L/min", Text("rule of this program: it must run off by itself, by the slope that the machine's tilt leaves"),
            Text("A wider bore, a steeper passage, or a drain more. Cold oil runs off far slower."))  # fmt: skip
