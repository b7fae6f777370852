# SPDX-License-Identifier: Apache-2.0
"""All that is measured on one wheel beside its span and its size over balls: pins, one ball, chords, limits, and what a size means."""

import math
from collections.abc import Callable, Iterable
from functools import partial

from ...sheet.check import Check
from ...sheet.quantity import Described, Stated
from ...sheet.step import Table
from ...sheet.text import Text
from ...sheet.trace import about
from ...sheet.units import Metre, Radian
from ...sheet.value import based_on
from .. import formulas as f
from ..inputs import Wheel
from ..result import ToothSystem, WheelResult
from . import formulas as m
from .checks import checks
from .measured import measured
from .result import MeasuresResult, Seat
from .spans import best, spans, spans_table

STRAIGHT: Radian = 1e-6  # a smaller helix is none: its axial pitch is endless
STEEPEST: Radian = math.pi / 4  # β_K from which two loose pins find no smallest distance near where they are opposite


def measures(
    system: ToothSystem, given: Wheel, wheel: WheelResult, working: Iterable[tuple[str, Metre]] = ()
) -> tuple[MeasuresResult, tuple[Check, ...], Callable[[], Table]]:
    """The measures of one wheel, their checks, and the table of its spans.

    `working`: (mate, working diameter d_w) of each mesh, for the balls that touch there.  Raises NoSolution where a measured size is
    that of no tooth.
    """
    ball = wheel.ball_diameter
    sizes: dict[str, float] = {}
    with about(Text("wheel {name}", name=wheel.name)):
        sizes["normal_thickness"] = m.normal_thickness(m_n=system.m_n, x=wheel.profile_shift, alpha_n=system.alpha_n)
        sizes["span_contact_diameter"] = m.span_contact_diameter(wheel.base_diameter, wheel.span_length, system.base_helix_angle)
        sizes["span_width"] = m.span_width(wheel.span_length, system.base_helix_angle)
        sizes |= _over_balls_and_pins(system, wheel, wheel.seat) | _constant_chord(system, wheel)
        if wheel.teeth % 2 and system.beta > STRAIGHT and "over_pins" in sizes:
            width = m.pins_width(m_n=system.m_n, beta=system.beta, D_M=ball, beta_b=system.base_helix_angle)
            sizes["pins_width"] = based_on(width, width, wheel.teeth)  # asked of odd numbers only
    balls = _ideal_balls(system, wheel, working)
    sizes |= _limits(system, wheel)
    teeth = measured(system, given, wheel)
    if len(thicknesses := [tooth.normal_thickness for tooth in teeth.values()]) > 1:
        sizes["measured_spread"] = based_on(max(thicknesses) - min(thicknesses), *thicknesses)
    all_spans = spans(system, wheel)
    best_span = best(all_spans, wheel.reference_diameter + 2 * wheel.profile_shift * system.m_n)
    if best_span is not None:
        with about(Text("wheel {name}", name=wheel.name)):
            of = (system, wheel.teeth, wheel.profile_shift, wheel.form_curvature, wheel.tip_curvature)
            sizes["best_span_teeth"] = m.best_span(K=based_on(best_span.K, *of))
    result = MeasuresResult(
        **sizes, ideal_balls=balls, measured_span=teeth.get("measured_span"), measured_over_balls=teeth.get("measured_over_balls"),
        measured_over_pins=teeth.get("measured_over_pins"), measured_chordal_thickness=teeth.get("measured_chordal_thickness"),
    )  # fmt: skip
    table = partial(spans_table, wheel, all_spans, wheel.span_teeth, None if best_span is None else best_span.K)
    return result, checks(system, wheel, result, teeth), table


def _over_balls_and_pins(system: ToothSystem, wheel: WheelResult, seat: Seat | None) -> dict[str, Metre]:
    """Sizes over one ball and over pins; none where the ball does not fit between the flanks."""
    if seat is None:
        return {}
    z, d_K, D_M = wheel.teeth, seat.d_K, wheel.ball_diameter
    sizes = {
        "over_one_ball": m.radial_size(d_K=d_K, D_M=D_M), "over_pins": over_pins(system, z, d_K, D_M), "ball_contact_diameter": seat.d_y,
    }  # fmt: skip
    beta_K: Radian = m.helix_angle_at_centres(beta_b=system.base_helix_angle, alpha_K=seat.alpha_K)
    if z % 2 and system.beta and beta_K < STEEPEST:
        sizes["over_two_pins"] = m.over_two_pins(d_K=d_K, delta=m.pin_angle(z=z, beta_K=beta_K), beta_K=beta_K, D_M=D_M)
    return sizes


def over_pins(system: ToothSystem, z: int, d_K: Metre, D_M: Metre) -> Metre:
    """Between faces parallel to the wheel's axis."""
    if z % 2 and not system.beta:
        return m.over_pins_odd_spur(d_K=d_K, z=z, D_M=D_M)
    return m.over_pins_opposite(d_K=d_K, D_M=D_M)


def _constant_chord(system: ToothSystem, wheel: WheelResult) -> dict[str, Metre]:
    d, alpha_n = wheel.reference_diameter, system.alpha_n
    chord = m.constant_chord(m_n=system.m_n, alpha_n=alpha_n, x=wheel.profile_shift)
    return {
        "constant_chord": chord,
        "constant_chord_height": m.constant_chord_height(d_a=wheel.tip_diameter, d=d, s_cc=chord, alpha_n=alpha_n),
        "constant_chord_diameter": m.constant_chord_diameter(d=d, s_cc=chord, alpha_n=alpha_n, beta=system.beta),
    }


def _ideal_balls(system: ToothSystem, wheel: WheelResult, working: Iterable[tuple[str, Metre]]) -> dict[str, Stated]:
    """The balls that touch at the working circles; none where the flanks meet inside the circle."""
    balls = {}
    for mate, d_w in working:
        with about(Text("wheel {name}, working circle with {mate}", name=wheel.name, mate=mate)):
            D = m.ball_for_contact(wheel.reference_thickness, wheel.reference_diameter, system.transverse_pressure_angle, wheel.teeth,
                wheel.base_diameter, system.base_helix_angle, f.pressure_angle_at(wheel.base_diameter, d_w))  # fmt: skip
        if D > 0:
            label = Text("Ball that touches at the working circle with {mate}", mate=mate)
            balls[f"ideal_ball_at_{mate}"] = Stated(Described(label, "mm", "D_w"), D)
    return balls


def _limits(system: ToothSystem, wheel: WheelResult) -> dict[str, Metre]:
    """The allowance of the thickness, and the sizes at both of its ends."""
    limits: dict[str, Metre] = {}
    if wheel.allowance is None or wheel.ends is None:
        return limits
    m_n, alpha_n, z_v = system.m_n, system.alpha_n, wheel.virtual_teeth
    for end, side, E_W in zip(("max", "min"), ("upper", "lower"), wheel.allowance):
        tooth = wheel.ends[end]
        with about(Text("measures of {name}, {text} tooth", name=wheel.name, text=Text("thickest") if end == "max" else Text("thinnest"))):
            E_sn = m.thickness_allowance(E_W=E_W, alpha_n=alpha_n)
            limits[f"thickness_allowance_{side}"] = E_sn
            limits[f"transverse_allowance_{side}"] = m.transverse_allowance(E_sn=E_sn, beta=system.beta)
            sizes = _over_balls_and_pins(system, wheel, tooth.seat)
            limits |= {f"{size}_{end}": sizes[size] for size in ("over_one_ball", "over_pins", "over_two_pins") if size in sizes}
            psi = m.half_tooth_angle(z_v=z_v, x=tooth.x_E, alpha_n=alpha_n)
            limits[f"chordal_thickness_{end}"] = m.chordal_thickness(z_v=z_v, m_n=m_n, psi=psi)
            limits[f"constant_chord_{end}"] = m.constant_chord(m_n=m_n, alpha_n=alpha_n, x=tooth.x_E)
    return limits
