# SPDX-License-Identifier: Apache-2.0
"""All that is measured on one wheel beside its span and its size over balls: pins, one ball, chords, limits, and what a size means."""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ...sheet.check import Check, check
from ...sheet.quantity import Described, Stated, group, result, value
from ...sheet.step import Table
from ...sheet.trace import about
from ...sheet.units import Metre, Number, Radian
from .. import formulas as f
from . import formulas as m
from . import pins as p
from .measured import Measured, measured, measured_checks
from .seat import Seat
from .spans import best, spans, spans_table

if TYPE_CHECKING:
    from ..inputs import Wheel
    from ..result import ToothSystem, WheelResult

STRAIGHT: Radian = 1e-6  # a smaller helix is none: its axial pitch is endless
STEEPEST: Radian = math.pi / 4  # β_K from which two loose pins find no smallest distance near where they are opposite


@result
class MeasuresResult:
    """Values ending in _min and _max belong to the two ends of the allowance of the span.  Allowances are changes, thinner is negative."""

    normal_thickness: Metre = value("Normal tooth thickness at the reference circle", "mm", "s_n")
    thickness_allowance_upper: Metre | None = value("Upper allowance of the normal tooth thickness", "µm", "E_sns", default=None)
    thickness_allowance_lower: Metre | None = value("Lower allowance of the normal tooth thickness", "µm", "E_sni", default=None)
    transverse_allowance_upper: Metre | None = value("Upper allowance of the transverse tooth thickness", "µm", "E_sts", default=None)
    transverse_allowance_lower: Metre | None = value("Lower allowance of the transverse tooth thickness", "µm", "E_sti", default=None)
    best_span_teeth: Number | None = value("Teeth spanned, best", "", "K", default=None)
    span_contact_diameter: Metre = value("Circle on which the span touches", "mm", "d_W")
    span_width: Metre = value("Face width that the span needs", "mm", "b_W")
    ideal_balls: dict[str, Stated] = group(spread=True)  # ideal_ball_at_MATE
    ball_contact_diameter: Metre | None = value("Circle on which the measuring ball touches", "mm", "d_M", default=None)
    over_one_ball: Metre | None = value("Size over one ball or pin, from the axis", "mm", "M_r", default=None)
    over_one_ball_min: Metre | None = value("Size over one ball or pin, thinnest tooth", "mm", "M_r", default=None)
    over_one_ball_max: Metre | None = value("Size over one ball or pin, thickest tooth", "mm", "M_r", default=None)
    over_pins: Metre | None = value("Size over pins, faces parallel to the axis", "mm", "M_dR", default=None)
    over_pins_min: Metre | None = value("Size over pins, thinnest tooth", "mm", "M_dR", default=None)
    over_pins_max: Metre | None = value("Size over pins, thickest tooth", "mm", "M_dR", default=None)
    over_two_pins: Metre | None = value("Smallest size over two pins, free faces", "mm", "M_2R", default=None)
    over_two_pins_min: Metre | None = value("Smallest size over two pins, thinnest tooth", "mm", "M_2R", default=None)
    over_two_pins_max: Metre | None = value("Smallest size over two pins, thickest tooth", "mm", "M_2R", default=None)
    pins_width: Metre | None = value("Face width that two opposite pins need", "mm", "b_R", default=None)
    chordal_thickness_min: Metre | None = value("Chordal thickness, thinnest tooth", "mm", "s_c", default=None)
    chordal_thickness_max: Metre | None = value("Chordal thickness, thickest tooth", "mm", "s_c", default=None)
    constant_chord: Metre = value("Constant chord, normal", "mm", "s_cc")
    constant_chord_min: Metre | None = value("Constant chord, thinnest tooth", "mm", "s_cc", default=None)
    constant_chord_max: Metre | None = value("Constant chord, thickest tooth", "mm", "s_cc", default=None)
    constant_chord_height: Metre = value("Height above the constant chord", "mm", "h_cc")
    constant_chord_diameter: Metre = value("Circle of the ends of the constant chord", "mm", "d_cc")
    measured_span: Measured | None = group(default=None)
    measured_over_balls: Measured | None = group(default=None)
    measured_over_pins: Measured | None = group(default=None)
    measured_chordal_thickness: Measured | None = group(default=None)
    measured_spread: Metre | None = value("Tooth thickness, difference between the measured routes", "µm", "Δs_n", default=None)


def measures(
    system: "ToothSystem", given: "Wheel", wheel: "WheelResult", working: Iterable[tuple[str, Metre]] = ()
) -> tuple[MeasuresResult, tuple[Check, ...], Table]:
    """The measures of one wheel, their checks, and the table of its spans.

    `working`: (mate, working diameter d_w) of each mesh, for the balls that touch there.  Raises NoSolution where a measured size is
    that of no tooth.
    """
    name, ball = wheel.name, wheel.ball_diameter
    found: dict[str, Any] = {}
    with about(f"wheel {name}"):
        found["normal_thickness"] = m.normal_thickness(m_n=system.m_n, x=wheel.profile_shift, alpha_n=system.alpha_n)
        found |= _span(system, wheel)
        found |= _sizes(system, wheel, wheel.seat, ball)
        found |= _constant_chord(system, wheel)
        if wheel.teeth % 2 and system.beta > STRAIGHT and found.get("over_pins") is not None:
            found["pins_width"] = p.pins_width(m_n=system.m_n, beta=system.beta, D_M=ball, beta_b=system.base_helix_angle)
    found["ideal_balls"] = _ideal_balls(system, wheel, working)
    found |= _limits(system, wheel, ball)
    routes = measured(system, given, wheel)
    found |= routes
    if len(thicknesses := [route.normal_thickness for route in routes.values()]) > 1:
        found["measured_spread"] = max(thicknesses) - min(thicknesses)
    table_of = spans(system, wheel)
    best_span = best(table_of, wheel.pitch_diameter + 2 * wheel.profile_shift * system.m_n)
    if best_span is not None:
        with about(f"wheel {wheel.name}"):
            found["best_span_teeth"] = m.best_span(K=best_span.K)
    made = MeasuresResult(**found)
    judged = (*_checks(wheel, made), *measured_checks(system, wheel, routes, made.over_pins, made.over_two_pins))
    return made, judged, spans_table(wheel, table_of, wheel.span_teeth, None if best_span is None else best_span.K)


def _span(system: "ToothSystem", wheel: "WheelResult") -> dict[str, Metre]:
    W_K, beta_b = wheel.span_length, system.base_helix_angle
    return {
        "span_contact_diameter": m.span_contact_diameter(d_b=wheel.base_diameter, W_K=W_K, beta_b=beta_b),
        "span_width": m.span_width(W_K=W_K, beta_b=beta_b),
    }


def _sizes(system: "ToothSystem", wheel: "WheelResult", place: Seat | None, ball: Metre) -> dict[str, Metre]:
    """Sizes over one ball and over pins; none where the ball does not fit between the flanks."""
    if place is None:
        return {}
    z, d_K, beta_b = wheel.teeth, place.d_K, system.base_helix_angle
    found = {
        "over_one_ball": p.radial_size(d_K=d_K, D_M=ball), "over_pins": over_pins(system, z, d_K, ball), "ball_contact_diameter": place.d_y,
    }  # fmt: skip
    beta_K: Radian = p.helix_angle_at_centres(beta_b=beta_b, alpha_K=place.alpha_K)
    if z % 2 and system.beta and beta_K < STEEPEST:
        found["over_two_pins"] = p.over_two_pins(d_K=d_K, delta=p.pin_angle(z=z, beta_K=beta_K), beta_K=beta_K, D_M=ball)
    return found


def over_pins(system: "ToothSystem", z: int, d_K: Metre, D_M: Metre) -> Metre:
    """Between faces parallel to the wheel's axis."""
    if z % 2 and not system.beta:
        return p.over_pins_odd_spur(d_K=d_K, z=z, D_M=D_M)
    return p.over_pins_opposite(d_K=d_K, D_M=D_M)


def _constant_chord(system: "ToothSystem", wheel: "WheelResult") -> dict[str, Metre]:
    chord = m.constant_chord(m_n=system.m_n, alpha_n=system.alpha_n, x=wheel.profile_shift)
    d, alpha_n = wheel.pitch_diameter, system.alpha_n
    return {
        "constant_chord": chord,
        "constant_chord_height": m.constant_chord_height(d_a=wheel.tip_diameter, d=d, s_cc=chord, alpha_n=alpha_n),
        "constant_chord_diameter": m.constant_chord_diameter(d=d, s_cc=chord, alpha_n=alpha_n, beta=system.beta),
    }


def _ideal_balls(system: "ToothSystem", wheel: "WheelResult", working: Iterable[tuple[str, Metre]]) -> dict[str, Stated]:
    """The balls that touch at the working circles."""
    found = {}
    d, d_b, s_t = wheel.pitch_diameter, wheel.base_diameter, wheel.reference_thickness
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    for mate, d_w in working:
        with about(f"wheel {wheel.name}, working circle with {mate}"):
            alpha_wt = f.pressure_angle_at(d_b=d_b, d_y=d_w)
            D = m.ball_for_contact(s_t=s_t, d=d, alpha_t=alpha_t, z=wheel.teeth, d_b=d_b, beta_b=beta_b, alpha_yt=alpha_wt)
        if D <= 0:  # the flanks meet further out: no ball reaches this circle
            continue
        found[f"ideal_ball_at_{mate}"] = Stated(Described(f"Ball that touches at the working circle with {mate}", "mm", "D_w"), D)
    return found


def _limits(system: "ToothSystem", wheel: "WheelResult", ball: Metre) -> dict[str, Metre]:
    """The allowance of the thickness, and the sizes at both of its ends."""
    found: dict[str, Metre] = {}
    if wheel.allowance is None or wheel.ends is None:
        return found
    m_n, alpha_n = system.m_n, system.alpha_n
    for end, side, E_W in zip(("max", "min"), ("upper", "lower"), wheel.allowance):
        with about(f"measures of {wheel.name}, {'thickest' if end == 'max' else 'thinnest'} tooth"):
            E_sn = m.thickness_allowance(E_W=E_W, alpha_n=alpha_n)
            found[f"thickness_allowance_{side}"] = E_sn
            found[f"transverse_allowance_{side}"] = m.transverse_allowance(E_sn=E_sn, beta=system.beta)
            x_E = wheel.ends[end].x_E
            sizes = _sizes(system, wheel, wheel.ends[end].seat, ball)
            found |= {f"{size}_{end}": sizes[size] for size in ("over_one_ball", "over_pins", "over_two_pins") if size in sizes}
            z_v = wheel.virtual_teeth
            psi = m.half_tooth_angle(z_v=z_v, x=x_E, alpha_n=alpha_n)
            found[f"chordal_thickness_{end}"] = m.chordal_thickness(z_v=z_v, m_n=m_n, psi=psi)
            found[f"constant_chord_{end}"] = m.constant_chord(m_n=m_n, alpha_n=alpha_n, x=x_E)
    return found


def _checks(wheel: "WheelResult", made: MeasuresResult) -> list[Check]:
    """What the wheel's own checks do not say yet: the constant chord, the pins of an odd helical wheel."""
    name, flank = wheel.name, (wheel.form_diameter, wheel.tip_diameter)
    advice = "Measure the chord at the reference circle, or the span."
    found = [
        check(
            f"gears.{name}.constant_chord", f"Circle of the ends of the constant chord of {name}", made.constant_chord_diameter,
            "in", flank, "mm", f"{f.ISO}: the calliper must touch the involute", advice, kind="advice",
        )
    ]  # fmt: skip
    if made.pins_width is not None:
        found.append(
            check(
                f"gears.{name}.pins_width", f"Face width of {name} for two opposite pins", wheel.face_width, ">=", made.pins_width, "mm",
                f"{p.SKEW}: half an axial pitch between the pins", "Measure over balls, or the span.", kind="advice",
            )
        )  # fmt: skip
    return found
