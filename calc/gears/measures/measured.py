# SPDX-License-Identifier: Apache-2.0
"""Measured sizes of a wheel, and the tooth that each of them means."""

import math

from ...sheet.errors import NoSolution
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.trace import about
from ...sheet.units import Metre, Number
from .. import formulas as f
from ..inputs import Wheel
from ..result import ToothSystem, WheelResult
from ..words import mm
from . import formulas as m
from .result import Measured

NAMES = {
    "measured_span": "span", "measured_over_balls": Text("size over balls"), "measured_over_pins": Text("size over pins"),
    "measured_chordal_thickness": Text("chordal thickness"),
}  # fmt: skip


def measured(system: ToothSystem, given: Wheel, wheel: WheelResult) -> dict[str, Measured]:
    """By the name of the input, those that are given."""
    teeth = {}
    for key, name in NAMES.items():
        if (size := getattr(given, key)) is not None:
            with about(Text("wheel {name}, measured {name2}", name=wheel.name, name2=name)):
                teeth[key] = _tooth(system, wheel, key, size, _shift(system, wheel, key, size))
    return teeth


def _shift(system: ToothSystem, wheel: WheelResult, key: str, size: Metre) -> Number:
    z, m_n, alpha_n = wheel.teeth, system.m_n, system.alpha_n
    if key == "measured_span":
        return m.shift_of_span(W=size, m_n=m_n, alpha_n=alpha_n, K=wheel.span_teeth, z=z, alpha_t=system.transverse_pressure_angle)
    if key == "measured_chordal_thickness":
        z_v = m.virtual_teeth(z=z, beta=system.beta)
        if size > z_v * m_n:
            raise _no_tooth(wheel, key, size, Text("no chord of its virtual wheel is longer than {z_v} mm", z_v=mm(z_v * m_n, ".4g")))
        return m.shift_of_half_angle(psi=m.angle_of_chord(s_c=size, z_v=z_v, m_n=m_n), z_v=z_v, alpha_n=alpha_n)
    return _shift_of_balls(system, wheel, key, size)


def _shift_of_balls(system: ToothSystem, wheel: WheelResult, key: str, size: Metre) -> Number:
    """Pins of a helical wheel lie opposite each other, whatever its number of teeth."""
    z, D_M, d_b = wheel.teeth, wheel.ball_diameter, wheel.base_diameter
    opposite = z % 2 == 0 or (key == "measured_over_pins" and system.beta > 0)
    d_K = m.centres_opposite(M=size, D_M=D_M) if opposite else m.centres_odd(M=size, D_M=D_M, z=z)
    if d_K < d_b:
        least = d_b * (1.0 if opposite else math.cos(math.pi / (2 * z))) + D_M
        raise _no_tooth(wheel, key, size,
            Text("with {d_m} mm in diameter it is at least {least} mm", d_m=mm(D_M, ".5g"), least=mm(least, ".4f")))  # fmt: skip
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    alpha_K = f.pressure_angle_at(d_b=d_b, d_y=d_K)
    s_t = m.thickness_of_centres(d=wheel.reference_diameter, alpha_K=alpha_K, alpha_t=alpha_t, D_M=D_M, d_b=d_b, beta_b=beta_b, z=z)
    return m.shift_of_thickness(s_t=s_t, beta=system.beta, m_n=system.m_n, alpha_n=system.alpha_n)


def _tooth(system: ToothSystem, wheel: WheelResult, key: str, size: Metre, x_E: Number) -> Measured:
    m_n, alpha_n = system.m_n, system.alpha_n
    s_n = m.normal_thickness(m_n=m_n, x=x_E, alpha_n=alpha_n)
    if not 0 < s_n < math.pi * m_n:
        fits = round(wheel.span_teeth + (size - wheel.span_length) / (math.pi * m_n * math.cos(alpha_n)))
        hint = EMPTY
        if key == "measured_span" and fits > 0:
            hint = Text("it is near a span over {fits} teeth, not {span_teeth}", fits=fits, span_teeth=Amount(wheel.span_teeth, form="g"))
        raise _no_tooth(
            wheel, key, size,
            Text("its teeth would be {s_n} mm thick, at a pitch of {pi} mm", s_n=mm(s_n, ".4g"), pi=mm(math.pi * m_n, ".4g")), hint,
        )  # fmt: skip
    E_W = m.span_change(x_E=x_E, x=wheel.profile_shift, m_n=m_n, alpha_n=alpha_n)
    return Measured(generating_shift=x_E, span_change=E_W, thickness_change=m.thickness_allowance(E_W=E_W, alpha_n=alpha_n),
        normal_thickness=s_n, transverse_thickness=f.reference_thickness(m_n=m_n, x=x_E, alpha_n=alpha_n, beta=system.beta))  # fmt: skip


def _no_tooth(wheel: WheelResult, key: str, size: Metre, why: str, hint: Text = EMPTY) -> NoSolution:
    return NoSolution(
        Text("gears.wheels.{name}.{key}_mm = {size}: {why}", name=wheel.name, key=key, size=mm(size, "g"), why=why),
        advice=hint or Text("compare it with the computed {names}, and the ball or pin with the one that was used", names=NAMES[key]),
    )
