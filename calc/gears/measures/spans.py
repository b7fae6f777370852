# SPDX-License-Identifier: Apache-2.0
"""The span over every number of teeth that an anvil can reach: where it touches, the width it needs, and which is best."""

import math

from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.text import COMMA, EMPTY, Text
from ...sheet.trace import untraced
from ...sheet.units import Metre, Number
from ..result import ToothSystem, WheelResult
from . import formulas as m

MM = 1e-3


@record
class Span:
    """One span; `fault` says why it can not be measured, empty where it can."""

    K: int
    length: Metre  # W_K, without allowance
    contact_diameter: Metre
    width: Metre  # needed
    fault: str


def spans(system: ToothSystem, wheel: WheelResult) -> tuple[Span, ...]:
    """All spans that touch the involute between form and tip circle, one more to each side, and the one chosen for the wheel."""
    beta_b, z = system.base_helix_angle, wheel.teeth
    p_bn = system.base_pitch * math.cos(beta_b)
    with untraced():
        W_0 = m.span(system.m_n, system.alpha_n, 0.0, z, system.transverse_pressure_angle, wheel.profile_shift)
        low, high = ((2 * rho / math.cos(beta_b) - W_0) / p_bn for rho in (wheel.form_curvature, wheel.tip_curvature))
        first, last = max(1, math.floor(low)), max(1, min(math.ceil(high), z))
        counts = sorted({*range(first, last + 1), round(wheel.span_teeth)})
        return tuple(_span(system, wheel, K) for K in counts)


def _span(system: ToothSystem, wheel: WheelResult, K: int) -> Span:
    beta_b = system.base_helix_angle
    W_K = m.span(system.m_n, system.alpha_n, float(K), wheel.teeth, system.transverse_pressure_angle, wheel.profile_shift)
    d_W, b_W = m.span_contact_diameter(wheel.base_diameter, W_K, beta_b), m.span_width(W_K, beta_b)
    return Span(K, W_K, d_W, b_W, _fault(wheel, W_K, d_W, b_W))


def _fault(wheel: WheelResult, W_K: Metre, d_W: Metre, b_W: Metre) -> Text:
    if W_K <= 0 or d_W <= wheel.form_diameter:
        return Text("touches below the form circle")
    if d_W >= wheel.tip_diameter:
        return Text("misses the tip circle")
    return Text("needs a wider face") if wheel.face_width <= b_W else EMPTY


def best(spans: tuple[Span, ...], d_V: Metre) -> Span | None:
    """The span that touches nearest to the circle d_V = d + 2·x·m_n; None where none can be measured."""
    return min((s for s in spans if not s.fault), key=lambda s: (abs(s.contact_diameter - d_V), s.K), default=None)


def spans_table(wheel: WheelResult, spans: tuple[Span, ...], chosen: Number, best_K: int | None) -> Table:
    """`chosen`: the K of the wheel's span."""
    upper, lower = wheel.allowance or (None, None)

    def row(s: Span) -> tuple[str | float | None, ...]:
        words = [word for word, holds in ((Text("chosen"), round(chosen) == s.K), (Text("best"), best_K == s.K)) if holds]
        limits = (None if E is None else (s.length + E) / MM for E in (lower, upper))
        return (f"{s.K}", s.length / MM, *limits, s.contact_diameter / MM, s.width / MM, COMMA.join(filter(None, (*words, s.fault))))

    return Table(f"spans_{wheel.name}", Text("Spans of {name}", name=wheel.name),
        ((Text("K"), ""), (Text("W_K"), "mm"), (Text("smallest"), "mm"), (Text("largest"), "mm"), (Text("touches at d_W"), "mm"),
            (Text("face width needed"), "mm"), (EMPTY, "")), tuple(row(s) for s in spans),
        Text("Best: touches nearest to d + 2·x·m_n of those that can be measured. The width is without the anvils' own."))  # fmt: skip
