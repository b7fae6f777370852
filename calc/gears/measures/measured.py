# SPDX-License-Identifier: Apache-2.0
"""Measured sizes of a wheel: what each says about its teeth, whether that is inside the allowance, and whether they agree."""

import math
from typing import TYPE_CHECKING

from ...sheet.check import Check, check
from ...sheet.errors import NoSolution
from ...sheet.quantity import result, value
from ...sheet.trace import about
from ...sheet.units import Metre, Number
from .. import formulas as f
from . import back
from . import formulas as m

if TYPE_CHECKING:
    from ..inputs import Wheel
    from ..result import ToothSystem, WheelResult

FIELD = "rule of this program: routes that differ by more than the whole field of the allowance contradict each other"


@result
class Measured:
    """The tooth that a measured size means."""

    generating_shift: Number = value("Generating shift", "", "x_E")
    span_change: Metre = value("Change of the span, the allowance met", "µm", "E_W")
    thickness_change: Metre = value("Change of the normal tooth thickness", "µm", "E_sn")
    normal_thickness: Metre = value("Normal tooth thickness", "mm", "s_n")
    transverse_thickness: Metre = value("Transverse tooth thickness", "mm", "s_t")


NAMES = {
    "measured_span": "span", "measured_over_balls": "size over balls", "measured_over_pins": "size over pins",
    "measured_chordal_thickness": "chordal thickness",
}  # fmt: skip


def measured(system: "ToothSystem", given: "Wheel", wheel: "WheelResult") -> dict[str, Measured]:
    """By the name of the input, those that are given."""
    found = {}
    for key, name in NAMES.items():
        if (size := getattr(given, key)) is not None:
            with about(f"wheel {wheel.name}, measured {name}"):
                found[key] = _tooth(system, wheel, key, size, _shift(system, wheel, key, size))
    return found


def _shift(system: "ToothSystem", wheel: "WheelResult", key: str, size: Metre) -> Number:
    z, m_n, alpha_n = wheel.teeth, system.m_n, system.alpha_n
    if key == "measured_span":
        return back.shift_of_span(W=size, m_n=m_n, alpha_n=alpha_n, K=wheel.span_teeth, z=z, alpha_t=system.transverse_pressure_angle)
    if key == "measured_chordal_thickness":
        z_v = m.virtual_teeth(z=z, beta=system.beta)
        if size > z_v * m_n:
            raise _no_tooth(wheel, key, size, f"no chord of its virtual wheel is longer than {z_v * m_n * 1e3:.4g} mm")
        return back.shift_of_half_angle(psi=back.angle_of_chord(s_c=size, z_v=z_v, m_n=m_n), z_v=z_v, alpha_n=alpha_n)
    return _shift_of_balls(system, wheel, key, size)


def _shift_of_balls(system: "ToothSystem", wheel: "WheelResult", key: str, size: Metre) -> Number:
    """Pins of a helical wheel lie opposite each other, whatever its number of teeth."""
    z, D_M, d_b = wheel.teeth, wheel.ball_diameter, wheel.base_diameter
    opposite = z % 2 == 0 or (key == "measured_over_pins" and system.beta > 0)
    d_K = back.centres_opposite(M=size, D_M=D_M) if opposite else back.centres_odd(M=size, D_M=D_M, z=z)
    if d_K < d_b:
        least = d_b * (1.0 if opposite else math.cos(math.pi / (2 * z))) + D_M
        raise _no_tooth(wheel, key, size, f"with {D_M * 1e3:.5g} mm in diameter it is at least {least * 1e3:.4f} mm")
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    alpha_K = f.pressure_angle_at(d_b=d_b, d_y=d_K)
    s_t = back.thickness_of_centres(d=wheel.pitch_diameter, alpha_K=alpha_K, alpha_t=alpha_t, D_M=D_M, d_b=d_b, beta_b=beta_b, z=z)
    return back.shift_of_thickness(s_t=s_t, beta=system.beta, m_n=system.m_n, alpha_n=system.alpha_n)


def _tooth(system: "ToothSystem", wheel: "WheelResult", key: str, size: Metre, x_E: Number) -> Measured:
    m_n, alpha_n = system.m_n, system.alpha_n
    s_n = m.normal_thickness(m_n=m_n, x=x_E, alpha_n=alpha_n)
    if not 0 < s_n < math.pi * m_n:
        fits = round(wheel.span_teeth + (size - wheel.span_length) / (math.pi * m_n * math.cos(alpha_n)))
        hint = f"it is near a span over {fits} teeth, not {wheel.span_teeth:g}" if key == "measured_span" and fits > 0 else ""
        raise _no_tooth(wheel, key, size, f"its teeth would be {s_n * 1e3:.4g} mm thick, at a pitch of {math.pi * m_n * 1e3:.4g} mm", hint)
    E_W = back.span_change(x_E=x_E, x=wheel.profile_shift, m_n=m_n, alpha_n=alpha_n)
    return Measured(
        generating_shift=x_E,
        span_change=E_W,
        thickness_change=m.thickness_allowance(E_W=E_W, alpha_n=alpha_n),
        normal_thickness=s_n,
        transverse_thickness=f.reference_thickness(m_n=m_n, x=x_E, alpha_n=alpha_n, beta=system.beta),
    )


def _no_tooth(wheel: "WheelResult", key: str, size: Metre, why: str, hint: str = "") -> NoSolution:
    return NoSolution(
        f"gears.wheels.{wheel.name}.{key}_mm = {size * 1e3:g}: {why}",
        advice=hint or f"compare it with the computed {NAMES[key]}, and the ball or pin with the one that was used",
    )


def measured_checks(
    system: "ToothSystem", wheel: "WheelResult", routes: dict[str, Measured], over_pins: Metre | None, over_two_pins: Metre | None
) -> list[Check]:
    """Each measured size against the allowance, and all of them against each other; none without an allowance."""
    if wheel.allowance is None:
        return []
    upper, lower = wheel.allowance
    name, found = wheel.name, []
    for key, route in routes.items():
        said = f"Change of the span of {name} by its measured {NAMES[key]}"
        found.append(
            check(
                f"gears.{name}.{key}", said, route.span_change, "in", (lower, upper),
                "µm", f"gears.wheels.{name}.span_allowance_um", _advice(system, wheel, key, over_pins, over_two_pins), kind="advice",
            )
        )  # fmt: skip
    if len(thicknesses := [route.normal_thickness for route in routes.values()]) > 1:
        found.append(
            check(
                f"gears.{name}.measured_spread", f"Tooth thickness of {name}, difference between the measured routes",
                max(thicknesses) - min(thicknesses), "<=", (upper - lower) / math.cos(system.alpha_n), "µm", FIELD,
                "Measure again; runout changes sizes over balls and pins, and the real tip a chordal thickness, but not a span.",
                kind="advice",
            )
        )  # fmt: skip
    return found


def _advice(system: "ToothSystem", wheel: "WheelResult", key: str, over_pins: Metre | None, over_two_pins: Metre | None) -> str:
    ball = f"It is taken with {wheel.ball_diameter * 1e3:.5g} mm in diameter"
    if key == "measured_span":
        return f"It is taken over {wheel.span_teeth:g} teeth. Thicker: finish the teeth further; thinner: the backlash is larger."
    if key == "measured_over_balls":
        return f"{ball} (gears.ball_diameter_mm). Half of the runout can hide in it."
    if key == "measured_over_pins":
        free = ""
        if over_pins is not None and over_two_pins is not None:
            free = f" Two pins under a free micrometer read {(over_pins - over_two_pins) * 1e3:.3f} mm less."
        return f"{ball} (gears.ball_diameter_mm), between faces parallel to the axis.{free}"
    tip = f"It is taken {wheel.chordal_height * 1e3:.4f} mm below a tip circle of {wheel.tip_diameter * 1e3:.4f} mm"
    psi = math.asin(wheel.chordal_thickness * math.cos(system.beta) ** 3 / (wheel.teeth * system.m_n))
    more = math.tan(system.alpha_n - psi) * 0.1  # the flank leans by so much against the middle of the tooth
    return f"{tip}; a tip circle smaller by 0.1 mm makes the chord read {more:.3f} mm more."
