# SPDX-License-Identifier: Apache-2.0
"""Whether span, balls, pins and chord touch the flank, and whether what was measured is inside the allowance."""

import math

from ...sheet.check import Check, check
from ...sheet.remedy import Remedy, change, remedy
from ...sheet.text import Amount, Name, Text
from ...sheet.units import Metre
from ..formulas import ISO
from ..inputs import GearsInputs
from ..result import ToothSystem, WheelResult
from ..words import mm
from . import formulas as m
from .measured import NAMES
from .result import Measured, MeasuresResult

BETWEEN_MEASURED = Text("rule of this program: routes that differ by more than the whole field of the allowance contradict each other")


def contact_checks(system: ToothSystem, wheel: WheelResult, sizes: MeasuresResult) -> list[Check]:
    """Whether span and balls touch where they should.  A ball that is given must fit; a chosen one is only advised."""
    id, name, D_M = f"gears.{wheel.name}", wheel.name, wheel.ball_diameter
    balls = _touching_ball(system, wheel, wheel.form_diameter), _touching_ball(system, wheel, wheel.tip_diameter)
    kind = "limit" if wheel.ball_given else "advice"

    def other_ball() -> tuple[Remedy, ...]:
        fits, key = wheel.preferred_ball if wheel.preferred_ball is not None else wheel.ideal_ball, "gears.ball_diameter_mm"
        own = remedy(change(GearsInputs, key, None), effect=Text("each wheel then has its own"))
        return remedy(change(GearsInputs, key, float(f"{fits * 1e3:.4g}"))), own

    checks = [
        check(f"{id}.span_contact", Text("Circle on which the span of {name} touches", name=name), sizes.span_contact_diameter, "in",
            (wheel.form_diameter, wheel.tip_diameter), "mm", Text("{iso}: the anvils must touch the involute", iso=ISO),
            Text("Span another number of teeth.")),
        check(f"{id}.ball", Text("Measuring ball of {name}", name=name), D_M, "in", balls, "mm",
            Text("geometry: the ball must touch between form and tip circle"), kind=kind, remedies=other_ball),
    ]  # fmt: skip
    if wheel.over_balls is not None:
        checks.append(check(f"{id}.ball_proud", Text("Balls of {name} above its tip", name=name),
            (wheel.over_balls - wheel.tip_diameter) / 2, ">", 0.0, "mm", Text("geometry: the balls must stand proud of the tip circle"),
            kind=kind, remedies=other_ball))  # fmt: skip
    if sizes.over_one_ball is not None:
        above_root = sizes.over_one_ball - D_M - wheel.root_diameter / 2
        checks.append(check(f"{id}.ball_root", Text("Ball of {name} above the root", name=name), above_root, ">=", 0.0, "mm",
            Text("geometry: the ball must not lie on the root"), kind=kind, remedies=other_ball))  # fmt: skip
    if system.beta:
        checks.append(check(
            f"{id}.span_width", Text("Face width of {name} for its span", name=name), wheel.face_width, ">=", sizes.span_width, "mm",
            Text("{iso}: W·sin β_b, the width of the anvils apart", iso=ISO), Text("Span fewer teeth, or measure over balls."),
        ))  # fmt: skip
    return checks


def _touching_ball(system: ToothSystem, wheel: WheelResult, d_y: Metre) -> Metre:
    """Diameter of the ball that touches on a circle."""
    alpha_yt = math.acos(min(wheel.base_diameter / d_y, 1.0))
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    return m.ball_for_contact(
        wheel.reference_thickness, wheel.reference_diameter, alpha_t, wheel.teeth, wheel.base_diameter, beta_b, alpha_yt
    )


def checks(system: ToothSystem, wheel: WheelResult, sizes: MeasuresResult, teeth: dict[str, Measured]) -> tuple[Check, ...]:
    """The constant chord, the pins of an odd helical wheel, and what was measured against the allowance, if there is one."""
    id, name = f"gears.{wheel.name}", wheel.name
    checks = [check(
        f"{id}.constant_chord", Text("Circle of the ends of the constant chord of {name}", name=name), sizes.constant_chord_diameter, "in",
        (wheel.form_diameter, wheel.tip_diameter), "mm", Text("{iso}: the calliper must touch the involute", iso=ISO),
        Text("Measure the chord at the reference circle, or the span."),
    )]  # fmt: skip
    if sizes.pins_width is not None:
        checks.append(check(
            f"{id}.pins_width", Text("Face width of {name} for two opposite pins", name=name), wheel.face_width, ">=", sizes.pins_width,
            "mm", Text("{skew}: half an axial pitch between the pins", skew=m.SKEW), Text("Measure over balls, or the span."),
        ))  # fmt: skip
    if wheel.allowance is None:
        return tuple(checks)
    upper, lower = wheel.allowance
    for key, tooth in teeth.items():
        checks.append(check(f"{id}.{key}", Text("Change of the span of {name} by its measured {names}", name=name, names=NAMES[key]),
            tooth.span_change, "in", (lower, upper), "µm", Name(f"gears.wheels.{name}.span_allowance_um"),
            _advice(system, wheel, key, sizes)))  # fmt: skip
    if len(thicknesses := [tooth.normal_thickness for tooth in teeth.values()]) > 1:
        checks.append(check(
            f"{id}.measured_spread", Text("Tooth thickness of {name}, difference between the measured routes", name=name),
            max(thicknesses) - min(thicknesses), "<=", (upper - lower) / math.cos(system.alpha_n), "µm", BETWEEN_MEASURED,
            Text("Measure again; runout changes sizes over balls and pins, and the real tip a chordal thickness, but not a span."),
        ))  # fmt: skip
    return tuple(checks)


def _advice(system: ToothSystem, wheel: WheelResult, key: str, sizes: MeasuresResult) -> Text:
    """How a size is taken, and what can hide in it."""
    ball = Text("It is taken with {ball_diameter} mm in diameter", ball_diameter=mm(wheel.ball_diameter, ".5g"))
    if key == "measured_span":
        return Text("It is taken over {span_teeth} teeth. Thicker: finish the teeth further; thinner: the backlash is larger.",
            span_teeth=Amount(wheel.span_teeth, form="g"))  # fmt: skip
    if key == "measured_over_balls":
        return Text("{ball}. Half of the runout can hide in it.", ball=ball)
    if key == "measured_over_pins":
        free = ""
        if sizes.over_pins is not None and sizes.over_two_pins is not None:
            less = mm(sizes.over_pins - sizes.over_two_pins, ".3f")
            free = Text(" Two pins under a free micrometer read {over_pins} mm less.", over_pins=less)
        return Text("{ball}, between faces parallel to the axis.{free}", ball=ball, free=free)
    tip = Text("It is taken {chordal_height} mm below a tip circle of {tip_diameter} mm",
        chordal_height=mm(wheel.chordal_height, ".4f"), tip_diameter=mm(wheel.tip_diameter, ".4f"))  # fmt: skip
    psi = math.asin(wheel.chordal_thickness * math.cos(system.beta) ** 3 / (wheel.teeth * system.m_n))
    more = math.tan(system.alpha_n - psi) * 0.1  # the flank leans by so much against the middle of the tooth
    return Text("{tip}; a tip circle smaller by 0.1 mm makes the chord read {more} mm more.", tip=tip, more=Amount(more, form=".3f"))
