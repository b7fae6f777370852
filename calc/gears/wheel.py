# SPDX-License-Identifier: Apache-2.0
"""One wheel, once its shift is known: circles, thicknesses, the sizes for its drawing, and its mass."""

import math
from collections.abc import Mapping

from ..library.catalogue import Material
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.functions import pi
from ..sheet.quantity import Described, Stated
from ..sheet.record import record, replace
from ..sheet.step import Outcome
from ..sheet.text import Amount, Text
from ..sheet.units import Kilogram, KilogramPerMetre3, Metre, Number, Radian
from ..sheet.value import about, based_on, trace, untraced
from . import formulas as f
from .accuracy import tooth_tolerances
from .inputs import GearsInputs
from .limits import mm
from .measures import formulas as m
from .measures.formulas import preferred_ball, seat
from .measures.result import Seat
from .profile.cut import Cut, form_diameter_of_undercut
from .rating.influence import inner_diameter
from .result import End, ToothSystem, TrainResult, WheelResult
from .wheel_inputs import Wheel


@record
class _Bare:
    """What every size of a wheel needs."""

    system: ToothSystem
    wheel: Wheel
    x: Number
    d: Metre
    d_b: Metre


def solve_wheel(gears: GearsInputs, system: ToothSystem, wheel: Wheel, x: Number, d: Metre, d_b: Metre) -> WheelResult:
    """All values of one wheel, at rest.  A tooth that can not be is no solution; one that is only poor is for the
    checks to judge."""
    bare = _Bare(system, wheel, x, d, d_b)
    alpha_t, alpha_n = system.transverse_pressure_angle, system.alpha_n
    with about(Text("wheel {name}", name=wheel.name)):
        d_a = f.tip_diameter(d, system.m_n, x, wheel.tip_shortening)
        d_f = f.root_diameter(d, system.m_n, x, system.h_fP)
        x_min = f.undercut_limit(system.h_fP, system.rho_aP0, alpha_n, wheel.teeth, alpha_t, system.beta)
        d_Ff = _form_diameter(bare, x, x_min)
        _must_be_a_tooth(wheel, x, d_a, d_f, d_Ff)
        s_t = f.reference_thickness(system.m_n, x, alpha_n, system.beta)
        s_at = f.thickness_at(d_a, s_t, d, alpha_t, f.pressure_angle_at(d_b, d_a))
        s_an = f.normal_thickness_at(s_at, system.beta, d_a, d)
        s_f = f.thickness_at(d_Ff, s_t, d, alpha_t, f.pressure_angle_at(d_b, d_Ff))
        alpha_m = _mid_flank(bare, d_a, d_Ff)
        chord = m.virtual_teeth(wheel.teeth, system.beta)
        psi = m.half_tooth_angle(chord, x, alpha_n)
        K = wheel.span_teeth or m.whole_span_teeth(
            m.span_teeth(wheel.teeth, alpha_m, system.base_helix_angle, alpha_t, x, alpha_n)
        )
        W_K = m.span(system.m_n, alpha_n, K, wheel.teeth, alpha_t, x)
        ideal = m.ball_for_contact(s_t, d, alpha_t, wheel.teeth, d_b, system.base_helix_angle, alpha_m)
        preferred = preferred_ball(system, wheel.teeth, s_t, d, d_b, (d_Ff, d_a), d_f, ideal)
        ball = gears.ball_diameter or preferred or ideal
        place = seat(system, wheel.teeth, s_t, d, d_b, ball)
        if place is not None and not d_Ff <= place.d_y <= d_a:
            place = None
        pointed = f.pointed_diameter(d_b, f.angle_of_involute(f.pointed_involute(s_t, d, alpha_t)))
        h, M = f.tooth_depth(d_a, d_f), _over_balls(wheel.teeth, place, ball)
        s_c, h_c = m.chordal_thickness(chord, system.m_n, psi), m.chordal_height(chord, system.m_n, psi, d_a, d)
        rho_a, rho_F = f.curvature_at(d_a, d_b), f.curvature_at(d_Ff, d_b)
        ends, limits = _limits(bare, ball if place is not None else None, x_min, d_a)
        b = wheel.face_width or gears.face_width
        return WheelResult(
            tooth_depth=h,
            pointed_diameter=pointed,
            profile_shift=x,
            undercut_limit=x_min,
            reference_diameter=d,
            base_diameter=d_b,
            tip_diameter=d_a,
            root_diameter=d_f,
            form_diameter=d_Ff,
            tip_thickness=s_at,
            tip_thickness_normal=s_an,
            form_thickness=s_f,
            speed=0.0,
            span_teeth=K,
            span=_span(wheel, round(K), W_K),
            ideal_ball=ideal,
            preferred_ball=preferred,
            ball_diameter=ball,
            ball_given=gears.ball_diameter is not None,
            over_balls=M,
            chordal_thickness=s_c,
            chordal_height=h_c,
            name=wheel.name,
            teeth=wheel.teeth,
            face_width=b,
            material=wheel.material,
            allowance=_allowance(wheel),
            reference_thickness=s_t,
            span_length=W_K,
            tip_curvature=rho_a,
            form_curvature=rho_F,
            tolerances=tooth_tolerances(system.m_n, d, d_a, b, gears.accuracy_grade, wheel.runout),
            virtual_teeth=chord,
            seat=place,
            ends=ends,
            measures=None,
            strikes=None,
            **limits,
            **_tips(wheel, d_a),
        )


def _form_diameter(bare: _Bare, x: Number, x_min: Number) -> Metre:
    s = bare.system
    if x < x_min or s.s_pr > 0:
        return form_diameter_of_undercut(Cut(s, bare.wheel.teeth, x))
    depth = f.straight_flank_depth(s.m_n, s.h_fP, s.rho_aP0, s.alpha_n, x)
    d_Ff = f.form_diameter(bare.d, s.transverse_pressure_angle, depth, bare.d_b)
    return based_on(d_Ff, d_Ff, s.s_pr)  # above 0 the tool undercuts


def _must_be_a_tooth(wheel: Wheel, x: Number, d_a: Metre, d_f: Metre, d_Ff: Metre) -> None:
    follows, k, shift = wheel.profile_shift is None, wheel.tip_shortening, Amount(x, form=".6g")
    origin = Text(" (it follows from the train)") if follows else ""
    place = Text("gears.wheels.{name}.profile_shift = {x}{origin}", name=wheel.name, x=shift, origin=origin)
    if d_f <= 0:
        root = mm(d_f, ".4g")
        raise NoSolution(
            Text(
                "{place}: the tool would cut through the centre of the wheel (root diameter {d_f} mm)",
                place=place,
                d_f=root,
            ),
            advice=Text("give more teeth, a larger shift, or a smaller gears.tool_addendum"),
        )
    if d_a <= d_Ff:
        cut = Text(" and the tip cut {tip_shortening} mm", tip_shortening=mm(k, "g")) if k else ""
        better = Text("{text} profile shift", text=Text("less") if x > 0 else Text("more"))
        if follows:
            centres = Text("bring the centres closer") if x > 0 else Text("set the centres further apart")
            better += Text(": it follows, so {text} or shift its mate", text=centres)
        advice = Text("give {better}; or ", better=better)
        advice += Text("a smaller tip_shortening_mm") if k else Text("more teeth")
        what = Text(
            "{place}{cut}: the tip circle ({d_a} mm) lies inside the form circle ({d_ff} mm), no involute flank is "
            "left",
            place=place,
            cut=cut,
            d_a=mm(d_a, ".4f"),
            d_ff=mm(d_Ff, ".4f"),
        )
        raise NoSolution(what, advice=advice)


def _mid_flank(bare: _Bare, d_a: Metre, d_Ff: Metre) -> Radian:
    """Pressure angle where spans and balls are meant to touch: at d + 2·x·m_n, or halfway up the flank where that is
    not on it."""
    d_V = based_on(bare.d + 2 * bare.x * bare.system.m_n, bare.d, bare.x, bare.system.m_n)
    return f.pressure_angle_at(bare.d_b, d_V if d_Ff < d_V < d_a else based_on((d_Ff + d_a) / 2, d_Ff, d_a))


def _allowance(wheel: Wheel) -> tuple[Metre, Metre] | None:
    return None if wheel.span_allowance is None else (wheel.span_allowance[0], wheel.span_allowance[1])


def _span(wheel: Wheel, K: int, W_K: Metre) -> dict[str, Stated]:
    upper, lower = _allowance(wheel) or (None, None)
    sizes = {"": ("", W_K)}
    if lower is not None and upper is not None:
        sizes["_min"] = (Text(", smallest"), m.span_with_allowance(W_K, lower))
        sizes["_max"] = (Text(", largest"), m.span_with_allowance(W_K, upper))
    return {
        f"span_{K}{end}": Stated(
            Described(Text("Span over {k} teeth{said}", k=K, said=end_of_it), "mm", f"W_{K}"), size
        )
        for end, (end_of_it, size) in sizes.items()
    }


def _over_balls(z: int, place: Seat | None, ball: Metre) -> Metre | None:
    if place is None:
        return None
    return m.over_balls_odd(place.d_K, z, ball) if z % 2 else m.over_balls_even(place.d_K, ball)


def _tips(wheel: Wheel, d_a: Metre) -> dict[str, Metre]:
    """The tip diameter at both ends of its tolerance."""
    if wheel.tip_diameter_tolerance is None:
        return {}
    upper, lower = wheel.tip_diameter_tolerance
    return {"tip_diameter_min": f.with_tolerance(d=d_a, T=lower), "tip_diameter_max": f.with_tolerance(d=d_a, T=upper)}


def _limits(
    bare: _Bare, ball: Metre | None, x_min: Number, d_a: Metre
) -> tuple[dict[str, End] | None, dict[str, Metre | None]]:
    """The sizes at both ends of the allowance; `ball` None: no ball fits."""
    s, z, d, roots = bare.system, bare.wheel.teeth, bare.d, bare.wheel.root_diameter_tolerance
    if (allowance := _allowance(bare.wheel)) is None:
        if roots is None:
            return None, {}
        d_f = f.root_diameter(d, s.m_n, bare.x, s.h_fP)
        return None, {f"root_diameter_{end}": f.with_tolerance(d=d_f, T=T) for end, T in zip(("max", "min"), roots)}
    ends: dict[str, End] = {}
    sizes: dict[str, Metre | None] = {}
    for end, E_W, T in zip(("max", "min"), allowance, roots or (None, None)):
        extreme = Text("thickest") if end == "max" else Text("thinnest")
        with about(Text("wheel {name}, {text} tooth", name=bare.wheel.name, text=extreme)):
            x_E = m.generating_shift(bare.x, E_W, s.m_n, s.alpha_n)
            s_t = f.reference_thickness(s.m_n, x_E, s.alpha_n, s.beta)
            d_f = f.root_diameter(d, s.m_n, x_E, s.h_fP)
            d_Ff = _form_diameter(bare, x_E, x_min)
            _must_stay_a_tooth(bare, E_W, s_t, d_f, d_Ff, d_a)
            s_at = f.thickness_at(d_a, s_t, d, s.transverse_pressure_angle, f.pressure_angle_at(bare.d_b, d_a))
            if end == "min":
                sizes["tip_thickness_normal_min"] = f.normal_thickness_at(s_at, s.beta, d_a, d)
            sizes[f"root_diameter_{end}"] = d_f if T is None else f.with_tolerance(d=d_f, T=T)
            sizes[f"form_diameter_{end}"] = d_Ff
            place = None if ball is None else seat(s, z, s_t, d, bare.d_b, ball)
            sizes[f"over_balls_{end}"] = None if ball is None else _over_balls(z, place, ball)
            ends[end] = End(x_E, s_t, place)
    return ends, sizes


def _must_stay_a_tooth(bare: _Bare, E_W: Metre, s_t: Metre, d_f: Metre, d_Ff: Metre, d_a: Metre) -> None:
    """A tooth that its allowance takes away, or that fills its space where the flank begins, is none."""
    s, advice = bare.system, Text("−20 to −50 µm is usual")
    allowance = Amount(E_W * 1e6, form="g")
    place = Text("gears.wheels.{name}.span_allowance_um = {size}", name=bare.wheel.name, size=allowance)
    if s_t <= 0 or d_f <= 0:
        nominal = s.m_n * (math.pi / 2 + 2 * bare.x * math.tan(s.alpha_n))  # s_n without allowance
        least = Amount(-nominal * math.cos(s.alpha_n) * 1e6, form=".0f")
        raise NoSolution(
            Text("{place}: takes away the whole tooth", place=place),
            advice=Text("it must stay above {least} µm; {advice}", least=least, advice=advice),
        )
    form = mm(d_Ff, ".4f")
    if d_Ff >= d_a:
        outside = Text(
            "{place}: the form circle ({d_ff} mm) of such teeth lies outside the tip circle ({d_a} mm)",
            place=place,
            d_ff=form,
            d_a=mm(d_a, ".4f"),
        )
        raise NoSolution(outside, advice=advice)
    with untraced():
        at_form = f.thickness_at(d_Ff, s_t, bare.d, s.transverse_pressure_angle, f.pressure_angle_at(bare.d_b, d_Ff))
    if at_form >= math.pi * d_Ff / bare.wheel.teeth:
        filled = Text("{place}: the teeth fill their spaces at the form circle ({d_ff} mm)", place=place, d_ff=form)
        raise NoSolution(filled, advice=advice)


# --- the bodies of the wheels: what each weighs


@formula(
    "m_W",
    "geometry: disc of the reference diameter, open inside its rim or its bore",
    meanings={"rho": "Density", "d_i": "Inside diameter of the rim"},
)
def wheel_mass(rho: KilogramPerMetre3, b: Metre, d: Metre, d_i: Metre) -> Kilogram:
    """>>> wheel_mass(rho=7860, b=0.015, d=0.054, d_i=0.0)
    0.27001...
    """
    return pi / 4 * rho * b * (d**2 - d_i**2)


def with_masses(
    outcome: Outcome[TrainResult], gears: GearsInputs, materials: Mapping[str, Material]
) -> Outcome[TrainResult]:
    """The same outcome with the mass of each wheel of which its bore leaves something."""
    train = outcome.solution
    wheels = {}
    with trace() as lines:
        for given in gears.wheels:
            wheel = train.wheels[given.name]
            with about(Text("wheel {name}, mass", name=given.name)):
                inside = inner_diameter(wheel.root_diameter, given.bore_diameter, given.rim_thickness)
                rho, d, mass = materials[wheel.material].density, wheel.reference_diameter, None
                if inside < d:
                    mass = wheel_mass(rho=rho, b=wheel.face_width, d=d, d_i=inside)
            wheels[given.name] = replace(wheel, mass=mass)
    return replace(outcome, result=replace(train, wheels=wheels), lines=(*outcome.lines, *lines))
