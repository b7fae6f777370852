# SPDX-License-Identifier: Apache-2.0
"""All that is measured on one wheel: what a measured size means, every span, whether it touches, and the limits.

In order: the tooth of a measured size, the spans, the checks, the measures (pins, one ball, chords)."""

import math
from collections.abc import Callable, Iterable, Iterator
from functools import partial

from ...sheet.check import Check, CheckRule
from ...sheet.errors import NoSolution
from ...sheet.quantity import Described, Stated, dotted
from ...sheet.record import record
from ...sheet.remedy import Remedy, change, remedy
from ...sheet.step import Table
from ...sheet.text import COMMA, EMPTY, Amount, Name, Text
from ...sheet.units import Metre, Number, Radian
from ...sheet.value import about, based_on, untraced
from .. import formulas as f
from ..formulas import ISO
from ..inputs import GearsInputs
from ..limits import mm
from ..result import ToothSystem, WheelResult
from ..wheel_inputs import Wheel
from . import formulas as m
from .result import Measured, MeasuresResult, Seat

# --- measured sizes of a wheel, and the tooth that each of them means

NAMES = {
    "measured_span": "span",
    "measured_over_balls": Text("size over balls"),
    "measured_over_pins": Text("size over pins"),
    "measured_chordal_thickness": Text("chordal thickness"),
}


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
        return m.shift_of_span(
            W=size, m_n=m_n, alpha_n=alpha_n, K=wheel.span_teeth, z=z, alpha_t=system.transverse_pressure_angle
        )
    if key == "measured_chordal_thickness":
        z_v = m.virtual_teeth(z=z, beta=system.beta)
        if size > z_v * m_n:
            why = Text("no chord of its virtual wheel is longer than {z_v} mm", z_v=mm(z_v * m_n, ".4g"))
            raise _no_tooth(wheel, key, size, why)
        return m.shift_of_half_angle(psi=m.angle_of_chord(s_c=size, z_v=z_v, m_n=m_n), z_v=z_v, alpha_n=alpha_n)
    return _shift_of_balls(system, wheel, key, size)


def _shift_of_balls(system: ToothSystem, wheel: WheelResult, key: str, size: Metre) -> Number:
    """Pins of a helical wheel lie opposite each other, whatever its number of teeth."""
    z, D_M, d_b = wheel.teeth, wheel.ball_diameter, wheel.base_diameter
    opposite = z % 2 == 0 or (key == "measured_over_pins" and system.beta > 0)
    d_K = m.centres_opposite(M=size, D_M=D_M) if opposite else m.centres_odd(M=size, D_M=D_M, z=z)
    if d_K < d_b:
        least = d_b * (1.0 if opposite else math.cos(math.pi / (2 * z))) + D_M
        sizes = {"d_m": mm(D_M, ".5g"), "least": mm(least, ".4f")}
        raise _no_tooth(wheel, key, size, Text("with {d_m} mm in diameter it is at least {least} mm", **sizes))
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    alpha_K = f.pressure_angle_at(d_b=d_b, d_y=d_K)
    s_t = m.thickness_of_centres(
        d=wheel.reference_diameter, alpha_K=alpha_K, alpha_t=alpha_t, D_M=D_M, d_b=d_b, beta_b=beta_b, z=z
    )
    return m.shift_of_thickness(s_t=s_t, beta=system.beta, m_n=system.m_n, alpha_n=system.alpha_n)


def _tooth(system: ToothSystem, wheel: WheelResult, key: str, size: Metre, x_E: Number) -> Measured:
    m_n, alpha_n = system.m_n, system.alpha_n
    s_n = m.normal_thickness(m_n=m_n, x=x_E, alpha_n=alpha_n)
    if not 0 < s_n < math.pi * m_n:
        fits = round(wheel.span_teeth + (size - wheel.span_length) / (math.pi * m_n * math.cos(alpha_n)))
        hint, K = EMPTY, Amount(wheel.span_teeth, form="g")
        if key == "measured_span" and fits > 0:
            hint = Text("it is near a span over {fits} teeth, not {span_teeth}", fits=fits, span_teeth=K)
        thick, pitch = mm(s_n, ".4g"), mm(math.pi * m_n, ".4g")
        why = Text("its teeth would be {s_n} mm thick, at a pitch of {pi} mm", s_n=thick, pi=pitch)
        raise _no_tooth(wheel, key, size, why, hint)
    E_W = m.span_change(x_E=x_E, x=wheel.profile_shift, m_n=m_n, alpha_n=alpha_n)
    return Measured(
        generating_shift=x_E,
        span_change=E_W,
        thickness_change=m.thickness_allowance(E_W=E_W, alpha_n=alpha_n),
        normal_thickness=s_n,
        transverse_thickness=f.reference_thickness(m_n=m_n, x=x_E, alpha_n=alpha_n, beta=system.beta),
    )


def _no_tooth(wheel: WheelResult, key: str, size: Metre, why: str, hint: Text = EMPTY) -> NoSolution:
    return NoSolution(
        Text("gears.wheels.{name}.{key}_mm = {size}: {why}", name=wheel.name, key=key, size=mm(size, "g"), why=why),
        advice=hint
        or Text(
            "compare it with the computed {names}, and the ball or pin with the one that was used", names=NAMES[key]
        ),
    )


# --- the span over every number of teeth that an anvil can reach
# Where it touches, the width it needs, and which is best.

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
    """All spans that touch the involute between form and tip circle, one more to each side, and the one chosen for the
    wheel."""
    beta_b, z = system.base_helix_angle, wheel.teeth
    p_bn = system.base_pitch * math.cos(beta_b)
    with untraced():
        W_0 = m.span(system.m_n, system.alpha_n, 0.0, z, system.transverse_pressure_angle, wheel.profile_shift)
        low, high = ((2 * rho / math.cos(beta_b) - W_0) / p_bn for rho in (wheel.form_curvature, wheel.tip_curvature))
        first, last = max(1, math.floor(low)), min(math.ceil(high), z)
        counts = sorted({*range(first, last + 1), round(wheel.span_teeth)})
        return tuple(_span(system, wheel, K) for K in counts)


def _span(system: ToothSystem, wheel: WheelResult, K: int) -> Span:
    beta_b = system.base_helix_angle
    W_K = m.span(
        system.m_n, system.alpha_n, float(K), wheel.teeth, system.transverse_pressure_angle, wheel.profile_shift
    )
    d_W, b_W = m.span_contact_diameter(wheel.base_diameter, W_K, beta_b), m.span_width(W_K, beta_b)
    fault = Text("needs a wider face") if wheel.face_width <= b_W else EMPTY
    if d_W <= wheel.form_diameter:
        fault = Text("touches below the form circle")
    elif d_W >= wheel.tip_diameter:
        fault = Text("misses the tip circle")
    return Span(K, W_K, d_W, b_W, fault)


def best(spans: tuple[Span, ...], d_V: Metre) -> Span | None:
    """The span that touches nearest to the circle d_V = d + 2·x·m_n; None where none can be measured."""
    return min((s for s in spans if not s.fault), key=lambda s: (abs(s.contact_diameter - d_V), s.K), default=None)


def spans_table(wheel: WheelResult, spans: tuple[Span, ...], chosen: Number, best_K: int | None) -> Table:
    """`chosen`: the K of the wheel's span."""
    upper, lower = wheel.allowance or (None, None)

    def row(s: Span) -> tuple[str | float | None, ...]:
        words = Text("chosen") if round(chosen) == s.K else EMPTY, Text("best") if best_K == s.K else EMPTY, s.fault
        limits = (None if E is None else (s.length + E) / MM for E in (lower, upper))
        sizes = s.length / MM, *limits, s.contact_diameter / MM, s.width / MM
        return f"{s.K}", *sizes, COMMA.join(filter(None, words))

    return Table(
        f"spans_{wheel.name}",
        Text("Spans of {name}", name=wheel.name),
        (
            (Text("K"), ""),
            (Text("W_K"), "mm"),
            (Text("smallest"), "mm"),
            (Text("largest"), "mm"),
            (Text("touches at d_W"), "mm"),
            (Text("face width needed"), "mm"),
            (EMPTY, ""),
        ),
        tuple(row(s) for s in spans),
        Text(
            "Best: touches nearest to d + 2·x·m_n of those that can be measured. The width is without the anvils' own."
        ),
    )


# --- whether span, balls, pins and chord touch the flank, and whether what was measured is inside the allowance

SPAN_TEETH = dotted("gears", GearsInputs.wheels, "W", Wheel.span_teeth)
SPAN_ALLOWANCE = dotted("gears", GearsInputs.wheels, "W", Wheel.span_allowance)
FACE_WIDTH = dotted("gears", GearsInputs.wheels, "W", Wheel.face_width)
BALL_DIAMETER = dotted("gears", GearsInputs.ball_diameter)
ONE_OF_SEVERAL = "One of several ways to measure the teeth."
MEASURED_CAUSE = "gears.W.measured"
MODULE = "the normal module"

SPAN_CONTACT = CheckRule(
    "gears.W.span_contact",
    "advice",
    ONE_OF_SEVERAL,
    sense="in",
    unit="mm",
    source=Text("{iso}: the anvils must touch the involute", iso=ISO),
    advice=Text("Span another number of teeth."),
    value_id=dotted("gears", "W", MeasuresResult.span_contact_diameter),
    moved_by=(SPAN_TEETH,),
)
SPAN_WIDTH = CheckRule(
    "gears.W.span_width",
    "advice",
    ONE_OF_SEVERAL,
    unit="mm",
    source=Text("{iso}: W·sin β_b, the width of the anvils apart", iso=ISO),
    advice=Text("Span fewer teeth, or measure over balls."),
    cause=SPAN_CONTACT.id,
    limit_id=dotted("gears", "W", MeasuresResult.span_width),
    moved_by=(SPAN_TEETH, FACE_WIDTH),
)
BALL = CheckRule(
    "gears.W.ball",
    "caution",
    "The size over balls of the drawing can not be measured with the ball that is given; nothing breaks.",
    sense="in",
    unit="mm",
    source=Text("geometry: the ball must touch between form and tip circle"),
    value_id=dotted("gears", "W", WheelResult.ball_diameter),
    moved_by=(BALL_DIAMETER,),
)
BALL_PROUD = CheckRule(
    "gears.W.ball_proud",
    "caution",
    "Balls that do not stand proud of the tip can not be measured over; nothing breaks.",
    sense=">",
    unit="mm",
    source=Text("geometry: the balls must stand proud of the tip circle"),
    zero="the diameter of the ball",
    cause=BALL.id,
    moved_by=(BALL_DIAMETER,),
)
BALL_ROOT = CheckRule(
    "gears.W.ball_root",
    "caution",
    "A ball that lies on the root does not measure the flanks; nothing breaks.",
    unit="mm",
    source=Text("geometry: the ball must not lie on the root"),
    zero="the diameter of the ball",
    cause=BALL.id,
    moved_by=(BALL_DIAMETER,),
)
CONSTANT_CHORD = CheckRule(
    "gears.W.constant_chord",
    "advice",
    ONE_OF_SEVERAL,
    sense="in",
    unit="mm",
    source=Text("{iso}: the calliper must touch the involute", iso=ISO),
    advice=Text("Measure the chord at the reference circle, or the span."),
    cause=SPAN_CONTACT.id,
    value_id=dotted("gears", "W", MeasuresResult.constant_chord_diameter),
    moved_by=(dotted("gears", GearsInputs.wheels, "W", Wheel.tip_shortening),),
)
PINS_WIDTH = CheckRule(
    "gears.W.pins_width",
    "advice",
    ONE_OF_SEVERAL,
    unit="mm",
    source=Text("{skew}: half an axial pitch between the pins", skew=m.SKEW),
    advice=Text("Measure over balls, or the span."),
    cause=SPAN_CONTACT.id,
    limit_id=dotted("gears", "W", MeasuresResult.pins_width),
    moved_by=(FACE_WIDTH,),
)
MEASURED_SPREAD = CheckRule(
    "gears.W.measured_spread",
    "method",
    "Measurements that contradict each other say nothing of the part.",
    sense="<=",
    unit="µm",
    source=Text(
        "rule of this program: routes that differ by more than the whole field of the allowance contradict each other"
    ),
    advice=Text(
        "Measure again; runout changes sizes over balls and pins, and the real tip a chordal thickness, but not a span."
    ),
    zero=MODULE,
    cause=MEASURED_CAUSE,
)


MEASURED = {
    key: CheckRule(
        f"gears.W.{key}",
        "caution",
        "The wheel as made lies outside its drawing.",
        sense="in",
        unit="µm",
        zero=MODULE,
        cause=MEASURED_CAUSE,
        moved_by=(dotted("gears", GearsInputs.wheels, "W", getattr(Wheel, key)), SPAN_ALLOWANCE),
    )
    for key in NAMES
}


def contact_checks(system: ToothSystem, wheel: WheelResult, sizes: MeasuresResult) -> Iterator[Check]:
    """Whether span and balls touch where they should.  A ball that is chosen is not judged."""
    name = wheel.name
    yield SPAN_CONTACT(
        sizes.span_contact_diameter,
        (wheel.form_diameter, wheel.tip_diameter),
        at=name,
        name=Text("Circle on which the span of {name} touches", name=name),
    )
    if wheel.ball_given:
        yield from _ball_checks(system, wheel, sizes)
    if system.beta:
        label = Text("Face width of {name} for its span", name=name)
        yield SPAN_WIDTH(wheel.face_width, sizes.span_width, at=name, name=label)


def _ball_checks(system: ToothSystem, wheel: WheelResult, sizes: MeasuresResult) -> Iterator[Check]:
    name, D_M = wheel.name, wheel.ball_diameter
    alphas = (
        f.pressure_angle_at.function(wheel.base_diameter, d_y) for d_y in (wheel.form_diameter, wheel.tip_diameter)
    )
    least, most = (ball_at(system, wheel, alpha_yt) for alpha_yt in alphas)

    def other_ball() -> tuple[Remedy, ...]:
        fits = wheel.preferred_ball if wheel.preferred_ball is not None else wheel.ideal_ball
        per_wheel = remedy(change(GearsInputs, BALL_DIAMETER, None), effect=Text("each wheel then has its own"))
        return remedy(change(GearsInputs, BALL_DIAMETER, float(f"{fits * 1e3:.4g}"))), per_wheel

    yield BALL(D_M, (least, most), at=name, name=Text("Measuring ball of {name}", name=name), remedies=other_ball)
    if wheel.over_balls is not None:
        label, proud = Text("Balls of {name} above its tip", name=name), (wheel.over_balls - wheel.tip_diameter) / 2
        yield BALL_PROUD(proud, 0.0, at=name, name=label, scale=D_M, remedies=other_ball)
    if sizes.over_one_ball is not None:
        label = Text("Ball of {name} above the root", name=name)
        above = sizes.over_one_ball - D_M - wheel.root_diameter / 2
        yield BALL_ROOT(above, 0.0, at=name, name=label, scale=D_M, remedies=other_ball)


def ball_at(system: ToothSystem, wheel: WheelResult, alpha_yt: Radian) -> Metre:
    """Diameter of the ball that touches where the flank has a pressure angle."""
    s_t, d, d_b = wheel.reference_thickness, wheel.reference_diameter, wheel.base_diameter
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    return m.ball_for_contact(s_t, d, alpha_t, wheel.teeth, d_b, beta_b, alpha_yt)


def checks(system: ToothSystem, wheel: WheelResult, sizes: MeasuresResult) -> Iterator[Check]:
    """The constant chord, the pins of an odd helical wheel, and what was measured against the allowance, if there is
    one."""
    name = wheel.name
    yield CONSTANT_CHORD(
        sizes.constant_chord_diameter,
        (wheel.form_diameter, wheel.tip_diameter),
        at=name,
        name=Text("Circle of the ends of the constant chord of {name}", name=name),
    )
    if sizes.pins_width is not None:
        label = Text("Face width of {name} for two opposite pins", name=name)
        yield PINS_WIDTH(wheel.face_width, sizes.pins_width, at=name, name=label)
    if wheel.allowance is None:
        return
    upper, lower = wheel.allowance
    teeth: dict[str, Measured] = {key: tooth for key in NAMES if (tooth := getattr(sizes, key)) is not None}
    for key, tooth in teeth.items():
        yield MEASURED[key](
            tooth.span_change,
            (lower, upper),
            at=name,
            name=Text("Change of the span of {name} by its measured {names}", name=name, names=NAMES[key]),
            source=Name(dotted("gears", GearsInputs.wheels, name, Wheel.span_allowance)),
            advice=_advice(system, wheel, key, sizes),
            scale=system.m_n,
        )
    if len(thicknesses := [tooth.normal_thickness for tooth in teeth.values()]) > 1:
        yield MEASURED_SPREAD(
            max(thicknesses) - min(thicknesses),
            (upper - lower) / math.cos(system.alpha_n),
            at=name,
            name=Text("Tooth thickness of {name}, difference between the measured routes", name=name),
            scale=system.m_n,
        )


def _advice(system: ToothSystem, wheel: WheelResult, key: str, sizes: MeasuresResult) -> Text:
    """How a size is taken, and what can hide in it."""
    ball = Text("It is taken with {ball_diameter} mm in diameter", ball_diameter=mm(wheel.ball_diameter, ".5g"))
    if key == "measured_span":
        return Text(
            "It is taken over {span_teeth} teeth. Thicker: finish the teeth further; thinner: the backlash is larger.",
            span_teeth=Amount(wheel.span_teeth, form="g"),
        )
    if key == "measured_over_balls":
        return Text("{ball}. Half of the runout can hide in it.", ball=ball)
    if key == "measured_over_pins":
        free = ""
        if sizes.over_pins is not None and sizes.over_two_pins is not None:
            less = mm(sizes.over_pins - sizes.over_two_pins, ".3f")
            free = Text(" Two pins under a free micrometer read {over_pins} mm less.", over_pins=less)
        return Text("{ball}, between faces parallel to the axis.{free}", ball=ball, free=free)
    h_c, d_a = mm(wheel.chordal_height, ".4f"), mm(wheel.tip_diameter, ".4f")
    tip = Text(
        "It is taken {chordal_height} mm below a tip circle of {tip_diameter} mm", chordal_height=h_c, tip_diameter=d_a
    )
    psi = m.angle_of_chord.function(s_c=wheel.chordal_thickness, z_v=wheel.virtual_teeth, m_n=system.m_n)
    # the flank leans by so much against the middle of the tooth
    more = Amount(math.tan(system.alpha_n - psi) * 0.1, form=".3f")
    return Text("{tip}; a tip circle smaller by 0.1 mm makes the chord read {more} mm more.", tip=tip, more=more)


# --- the measures

STRAIGHT: Radian = 1e-6  # a smaller helix is none: its axial pitch is endless
STEEPEST: Radian = math.pi / 4  # β_K from which two loose pins find no smallest distance near where they are opposite


def measures(
    system: ToothSystem, given: Wheel, wheel: WheelResult, working: Iterable[tuple[str, Metre]] = ()
) -> tuple[MeasuresResult, Callable[[], Table]]:
    """The measures of one wheel, and the table of its spans.

    `working`: (mate, working diameter d_w) of each mesh, for the balls that touch there.  Raises NoSolution where a
    measured size is that of no tooth."""
    ball = wheel.ball_diameter
    sizes: dict[str, float] = {}
    with about(Text("wheel {name}", name=wheel.name)):
        sizes["normal_thickness"] = m.normal_thickness(m_n=system.m_n, x=wheel.profile_shift, alpha_n=system.alpha_n)
        sizes["span_contact_diameter"] = m.span_contact_diameter(
            wheel.base_diameter, wheel.span_length, system.base_helix_angle
        )
        sizes["span_width"] = m.span_width(wheel.span_length, system.base_helix_angle)
        sizes |= _over_balls_and_pins(system, wheel, wheel.seat)
        d, alpha_n = wheel.reference_diameter, system.alpha_n
        chord = m.constant_chord(m_n=system.m_n, alpha_n=alpha_n, x=wheel.profile_shift)
        sizes["constant_chord"] = chord
        sizes["constant_chord_height"] = m.constant_chord_height(wheel.tip_diameter, d, chord, alpha_n)
        sizes["constant_chord_diameter"] = m.constant_chord_diameter(d, chord, alpha_n, system.beta)
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
        **sizes,
        ideal_balls=balls,
        measured_span=teeth.get("measured_span"),
        measured_over_balls=teeth.get("measured_over_balls"),
        measured_over_pins=teeth.get("measured_over_pins"),
        measured_chordal_thickness=teeth.get("measured_chordal_thickness"),
    )
    table = partial(spans_table, wheel, all_spans, wheel.span_teeth, None if best_span is None else best_span.K)
    return result, table


def _over_balls_and_pins(system: ToothSystem, wheel: WheelResult, seat: Seat | None) -> dict[str, Metre]:
    """Sizes over one ball and over pins; none where the ball does not fit between the flanks."""
    if seat is None:
        return {}
    z, d_K, D_M = wheel.teeth, seat.d_K, wheel.ball_diameter
    sizes = {
        "over_one_ball": m.radial_size(d_K=d_K, D_M=D_M),
        "over_pins": over_pins(system, z, d_K, D_M),
        "ball_contact_diameter": seat.d_y,
    }
    beta_K: Radian = m.helix_angle_at_centres(beta_b=system.base_helix_angle, alpha_K=seat.alpha_K)
    if z % 2 and system.beta and beta_K < STEEPEST:
        sizes["over_two_pins"] = m.over_two_pins(d_K=d_K, delta=m.pin_angle(z=z, beta_K=beta_K), beta_K=beta_K, D_M=D_M)
    return sizes


def over_pins(system: ToothSystem, z: int, d_K: Metre, D_M: Metre) -> Metre:
    """Between faces parallel to the wheel's axis."""
    if z % 2 and not system.beta:
        return m.over_pins_odd_spur(d_K=d_K, z=z, D_M=D_M)
    return m.over_pins_opposite(d_K=d_K, D_M=D_M)


def _ideal_balls(system: ToothSystem, wheel: WheelResult, working: Iterable[tuple[str, Metre]]) -> dict[str, Stated]:
    """The balls that touch at the working circles; none where the flanks meet inside the circle."""
    balls = {}
    for mate, d_w in working:
        with about(Text("wheel {name}, working circle with {mate}", name=wheel.name, mate=mate)):
            D = ball_at(system, wheel, f.pressure_angle_at(wheel.base_diameter, d_w))
        if D > 0:
            label = Text("Ball that touches at the working circle with {mate}", mate=mate)
            balls[f"ideal_ball_at_{mate}"] = Stated(Described(label, "mm", "D_w"), D)
    return balls


def _limits(system: ToothSystem, wheel: WheelResult) -> dict[str, Metre]:
    """The allowance of the thickness, and the sizes at both of its ends."""
    limits: dict[str, Metre] = {}
    if wheel.ends is None:
        return limits
    m_n, alpha_n, z_v = system.m_n, system.alpha_n, wheel.virtual_teeth
    extremes = ("max", "upper", Text("thickest")), ("min", "lower", Text("thinnest"))
    for (end, side, extreme), E_W in zip(extremes, wheel.allowance or ()):
        tooth = wheel.ends[end]
        with about(Text("measures of {name}, {text} tooth", name=wheel.name, text=extreme)):
            E_sn = m.thickness_allowance(E_W=E_W, alpha_n=alpha_n)
            limits[f"thickness_allowance_{side}"] = E_sn
            limits[f"transverse_allowance_{side}"] = m.transverse_allowance(E_sn=E_sn, beta=system.beta)
            sizes = _over_balls_and_pins(system, wheel, tooth.seat)
            sizes.pop("ball_contact_diameter", None)  # of the tooth without allowance only
            limits |= {f"{name}_{end}": size for name, size in sizes.items()}
            psi = m.half_tooth_angle(z_v=z_v, x=tooth.x_E, alpha_n=alpha_n)
            limits[f"chordal_thickness_{end}"] = m.chordal_thickness(z_v=z_v, m_n=m_n, psi=psi)
            limits[f"constant_chord_{end}"] = m.constant_chord(m_n=m_n, alpha_n=alpha_n, x=tooth.x_E)
    return limits
