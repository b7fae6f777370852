# SPDX-License-Identifier: Apache-2.0
"""What the inspector measures on one wheel: span, balls, pins, chordal thickness; back to the tooth; balls that fit.

An allowance E_W is the change of the span.  The tooth is thinner by it in the normal section at E_W/cos α_n, which the
generating shift x_E carries; so the measures of a thinned tooth are those of a tooth with the shift x_E.

A pin in a tooth space touches both flanks where a ball of its diameter would: its centre line is the tangent of the
helix that the ball's centre would run along, at right angles to both flanks' normals.  It can slide along its space.
Between faces parallel to the wheel's axis two pins lie flat where they are opposite each other, whatever the number of
teeth; on a helical wheel with an odd number they are then half an axial pitch apart, and a third pin in the next space,
as far off to the other side, makes the seat firm.  A free micrometer with two pins tilts and finds the smallest
distance of the two centre lines instead, which is less."""

import math

from ...sheet.formula import formula
from ...sheet.functions import asin, atan, cos, inv, pi, sin, sqrt, tan
from ...sheet.text import Text
from ...sheet.units import Metre, Number, Radian
from ...sheet.value import based_on, untraced
from .. import formulas as f
from ..formulas import ISO
from ..result import ToothSystem
from .result import Seat

OPPOSITE = Text("{iso}; agrees with centre lines of pins that lie flat between faces parallel to the axis", iso=ISO)
SKEW = Text("geometry of two skew lines, tangents of the helix of the ball centres in opposite tooth spaces")

STEEPEST: Radian = 1.5  # no ball touches a flank further out than this pressure angle of its centre


@formula(
    "x_E",
    Text("{iso}: generating shift of a tooth thinned by the change E_W of its span", iso=ISO),
    meanings={"x": "Profile shift coefficient"},
)
def generating_shift(x: Number, E_W: Metre, m_n: Metre, alpha_n: Radian) -> Number:
    return x + E_W / (2 * m_n * sin(alpha_n))


# --- span


@formula(
    "K",
    Text("{iso}: number of teeth for a contact at the circle of α_yt, before rounding", iso=ISO),
    meanings={"x": "Profile shift coefficient"},
)
def span_teeth(z: Number, alpha_yt: Radian, beta_b: Radian, alpha_t: Radian, x: Number, alpha_n: Radian) -> Number:
    return z / pi * (tan(alpha_yt) / cos(beta_b) ** 2 - inv(alpha_t) - 2 * x * tan(alpha_n) / z) + 0.5


@formula(
    "K",
    "mathematics: the nearest whole number of teeth, of two that are equally near the smaller",
    shows="K rounded, at least 1",
)
def whole_span_teeth(K: Number) -> Number:
    return float(max(1, math.ceil(K - 0.5 - 1e-9)))  # whatever the last digits say


@formula(
    "K",
    Text("{iso}: of the spans that can be measured the one that touches nearest to d + 2·x·m_n", iso=ISO),
    shows="K with d_W nearest to d + 2·x·m_n",
)
def best_span(K: Number) -> Number:
    """>>> best_span(K=4)
    4.0
    """
    return 1.0 * K


@formula(
    "W_K",
    Text("{iso}: base tangent length over K teeth", iso=ISO),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def span(m_n: Metre, alpha_n: Radian, K: Number, z: Number, alpha_t: Radian, x: Number) -> Metre:
    """>>> span(m_n=0.002, alpha_n=0.3491, K=4, z=25, alpha_t=0.3739, x=0.01423)
    0.02155130...
    """
    return m_n * cos(alpha_n) * (pi * (K - 0.5) + z * inv(alpha_t)) + 2 * x * m_n * sin(alpha_n)


@formula("W_K,E", "definition: an allowance is a change of the span", unit="mm")
def span_with_allowance(W_K: Metre, E_W: Metre) -> Metre:
    return W_K + E_W


@formula("d_W", Text("{iso}: circle on which the anvils touch, K teeth placed symmetrically", iso=ISO), unit="mm")
def span_contact_diameter(d_b: Metre, W_K: Metre, beta_b: Radian) -> Metre:
    return sqrt(d_b**2 + (W_K * cos(beta_b)) ** 2)


@formula("b_W", Text("{iso}: face width that the span needs, anvils apart", iso=ISO), unit="mm")
def span_width(W_K: Metre, beta_b: Radian) -> Metre:
    return W_K * sin(beta_b)


# --- balls


@formula(
    "inv α_K",
    Text(
        "{iso}: pressure angle at the centre of a ball in the tooth space; negative: the ball touches no flank", iso=ISO
    ),
)
def ball_involute(s_t: Metre, d: Metre, alpha_t: Radian, D_M: Metre, d_b: Metre, beta_b: Radian, z: Number) -> Number:
    return s_t / d + inv(alpha_t) + D_M / (d_b * cos(beta_b)) - pi / z


@formula("d_K", Text("{iso}: circle of the ball centres", iso=ISO), unit="mm")
def ball_centre_diameter(d_b: Metre, alpha_K: Radian) -> Metre:
    return d_b / cos(alpha_K)


@formula("M", Text("{iso}: size over two balls, even number of teeth", iso=ISO), unit="mm")
def over_balls_even(d_K: Metre, D_M: Metre) -> Metre:
    """>>> over_balls_even(d_K=0.0791742, D_M=0.0035)
    0.0826742
    """
    return d_K + D_M


@formula("M", Text("{iso}: size over two balls, odd number of teeth", iso=ISO), unit="mm")
def over_balls_odd(d_K: Metre, z: Number, D_M: Metre) -> Metre:
    return d_K * cos(pi / (2 * z)) + D_M


@formula("d_y", Text("{iso}: circle on which a ball touches the flanks", iso=ISO), unit="mm")
def ball_contact_diameter(d_b: Metre, alpha_K: Radian, D_M: Metre, beta_b: Radian) -> Metre:
    return sqrt(d_b**2 + (d_b * tan(alpha_K) - D_M * cos(beta_b)) ** 2)


@formula(
    "D_y",
    "geometry: contact of a ball with a helical involute, solved exactly (the usual closed form holds for spur teeth)",
    unit="mm",
    shows="ball that touches the flanks at α_yt: tan α_K·sin²β_b + (α_K + c)·cos²β_b = tan α_yt, c = s_t/d + inv α_t "
    "− π/z",
)
def ball_for_contact(
    s_t: Metre, d: Metre, alpha_t: Radian, z: Number, d_b: Metre, beta_b: Radian, alpha_yt: Radian
) -> Metre:
    """Newton's method in α_K; the left side rises and is convex, and the spur solution starts above the root."""
    c = s_t / d + inv(alpha_t) - pi / z
    sin2, cos2, aim = math.sin(beta_b) ** 2, math.cos(beta_b) ** 2, math.tan(alpha_yt)
    alpha_K = min(aim - c, STEEPEST)
    for _ in range(60):
        t = math.tan(alpha_K)
        step = (sin2 * t + cos2 * (alpha_K + c) - aim) / (sin2 * (1 + t * t) + cos2)
        alpha_K = min(alpha_K - step, STEEPEST)
        if abs(step) < 1e-15:
            break
    return d_b * math.cos(beta_b) * (math.tan(alpha_K) - alpha_K - c)


# --- pins, and one ball or pin from the wheel's axis


@formula("β_K", Text("{iso}: helix angle at the circle of the ball centres", iso=ISO))
def helix_angle_at_centres(beta_b: Radian, alpha_K: Radian) -> Radian:
    return atan(tan(beta_b) / cos(alpha_K))


@formula("M_r", Text("{iso}: size over one ball or pin, from the wheel's axis", iso=ISO), unit="mm")
def radial_size(d_K: Metre, D_M: Metre) -> Metre:
    return d_K / 2 + D_M / 2


@formula("M_dR", OPPOSITE, unit="mm")
def over_pins_opposite(d_K: Metre, D_M: Metre) -> Metre:
    """Even number of teeth, or any of a helical wheel."""
    return d_K + D_M


@formula("M_dR", Text("{iso}: size over two pins, spur wheel with an odd number of teeth", iso=ISO), unit="mm")
def over_pins_odd_spur(d_K: Metre, z: Number, D_M: Metre) -> Metre:
    return d_K * cos(pi / (2 * z)) + D_M


@formula(
    "δ",
    Text("{skew}: where their distance is smallest; odd number of teeth, β_K below 45°", skew=SKEW),
    shows="half the angle that two pins lack to be opposite: δ − tan²β_K·sin(2·δ)/2 = π/(2·z)",
)
def pin_angle(z: Number, beta_K: Radian) -> Radian:
    """The left side rises and is convex up to 90°: Newton's method, kept below that, falls steadily onto the root."""
    gap, half = math.pi / (2 * z), math.tan(beta_K) ** 2 / 2
    delta = gap
    for _ in range(60):
        step = (delta - half * math.sin(2 * delta) - gap) / (1 - 2 * half * math.cos(2 * delta))
        delta = min(delta - step, math.pi / 2)
        if abs(step) < 1e-15:
            break
    return delta


@formula("M_2R", Text("{skew}: smallest size over two pins, odd number of teeth", skew=SKEW), unit="mm")
def over_two_pins(d_K: Metre, delta: Radian, beta_K: Radian, D_M: Metre) -> Metre:
    return d_K * cos(delta) * sqrt(1 + (tan(beta_K) * sin(delta)) ** 2) + D_M


@formula(
    "b_R",
    Text(
        "{skew}: face width that two opposite pins need, odd number of teeth: half an axial pitch and what the "
        "contact takes",
        skew=SKEW,
    ),
    unit="mm",
)
def pins_width(m_n: Metre, beta: Radian, D_M: Metre, beta_b: Radian) -> Metre:
    """Three pins need half an axial pitch more."""
    return pi * m_n / (2 * sin(beta)) + D_M * sin(beta_b)


# --- chordal thickness, normal section


@formula("z_v", Text("{iso}: teeth of the virtual spur wheel at the reference circle", iso=ISO))
def virtual_teeth(z: Number, beta: Radian) -> Number:
    return z / cos(beta) ** 3


@formula(
    "ψ_v",
    Text("{iso}: half angle of the tooth on the virtual wheel", iso=ISO),
    meanings={"x": "Profile shift coefficient"},
)
def half_tooth_angle(z_v: Number, x: Number, alpha_n: Radian) -> Radian:
    return pi / (2 * z_v) + 2 * x * tan(alpha_n) / z_v


@formula(
    "s_c", Text("{iso}: normal chordal thickness at the reference circle", iso=ISO), unit="mm", names={"psi": "ψ_v"}
)
def chordal_thickness(z_v: Number, m_n: Metre, psi: Radian) -> Metre:
    """>>> chordal_thickness(z_v=31.31, m_n=0.002, psi=0.0505)
    0.003160966...
    """
    return z_v * m_n * sin(psi)


@formula("h_c", Text("{iso}: height of the tip above the chord", iso=ISO), unit="mm", names={"psi": "ψ_v"})
def chordal_height(z_v: Number, m_n: Metre, psi: Radian, d_a: Metre, d: Metre) -> Metre:
    return z_v * m_n * (1 - cos(psi)) / 2 + (d_a - d) / 2


@formula(
    "s_cc",
    Text(
        "{iso}: constant chord, between the points where the basic rack touches both flanks; the same for any number "
        "of teeth",
        iso=ISO,
    ),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def constant_chord(m_n: Metre, alpha_n: Radian, x: Number) -> Metre:
    """Exact for helical teeth too, in the normal section through the middle of the tooth at the reference circle.

    >>> constant_chord(m_n=0.002, alpha_n=0.3491, x=0.01423)
    0.002792322...
    """
    return m_n * (pi / 2 * cos(alpha_n) ** 2 + x * sin(2 * alpha_n))


@formula("h_cc", Text("{iso}: height of the tip above the constant chord", iso=ISO), unit="mm")
def constant_chord_height(d_a: Metre, d: Metre, s_cc: Metre, alpha_n: Radian) -> Metre:
    return (d_a - d) / 2 - s_cc * tan(alpha_n) / 2


@formula(
    "d_cc", "geometry, rack and tooth at the pitch point: circle on which the ends of the constant chord lie", unit="mm"
)
def constant_chord_diameter(d: Metre, s_cc: Metre, alpha_n: Radian, beta: Radian) -> Metre:
    return sqrt((d + s_cc * tan(alpha_n)) ** 2 + (s_cc * cos(beta)) ** 2)


# --- tooth thickness and its allowance


@formula(
    "s_n",
    Text("{iso}: normal tooth thickness at the reference circle", iso=ISO),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def normal_thickness(m_n: Metre, x: Number, alpha_n: Radian) -> Metre:
    return m_n * (pi / 2 + 2 * x * tan(alpha_n))


@formula("E_sn", Text("{iso}: normal tooth thickness allowance of a change of the span", iso=ISO), unit="µm")
def thickness_allowance(E_W: Metre, alpha_n: Radian) -> Metre:
    return E_W / cos(alpha_n)


@formula("E_st", Text("{iso}: transverse tooth thickness allowance at the reference circle", iso=ISO), unit="µm")
def transverse_allowance(E_sn: Metre, beta: Radian) -> Metre:
    return E_sn / cos(beta)


# --- from a measured size back to the tooth
# All lead over the generating shift x_E, so that they can be compared.  A chordal thickness is taken at the reference
# circle: the calliper stands at the height above the chord, from a tip circle of the nominal diameter.


@formula(
    "x_E", Text("{iso}: generating shift of a measured span, from the base tangent length", iso=ISO), names={"W": "W_K"}
)
def shift_of_span(W: Metre, m_n: Metre, alpha_n: Radian, K: Number, z: Number, alpha_t: Radian) -> Number:
    return (W / (m_n * cos(alpha_n)) - pi * (K - 0.5) - z * inv(alpha_t)) / (2 * tan(alpha_n))


@formula("d_K", Text("{iso}: circle of the centres, from the size over opposite balls or pins", iso=ISO), unit="mm")
def centres_opposite(M: Metre, D_M: Metre) -> Metre:
    return M - D_M


@formula(
    "d_K",
    Text("{iso}: circle of the centres, from the size over balls (spur: or pins), odd number of teeth", iso=ISO),
    unit="mm",
)
def centres_odd(M: Metre, D_M: Metre, z: Number) -> Metre:
    return (M - D_M) / cos(pi / (2 * z))


@formula(
    "s_t",
    Text("{iso}: transverse tooth thickness at the reference circle, from the circle of the centres", iso=ISO),
    unit="mm",
)
def thickness_of_centres(
    d: Metre, alpha_K: Radian, alpha_t: Radian, D_M: Metre, d_b: Metre, beta_b: Radian, z: Number
) -> Metre:
    return d * (inv(alpha_K) - inv(alpha_t) - D_M / (d_b * cos(beta_b)) + pi / z)


@formula("x_E", Text("{iso}: generating shift of a transverse tooth thickness at the reference circle", iso=ISO))
def shift_of_thickness(s_t: Metre, beta: Radian, m_n: Metre, alpha_n: Radian) -> Number:
    return (s_t * cos(beta) / m_n - pi / 2) / (2 * tan(alpha_n))


@formula(
    "ψ",
    Text(
        "{iso}: half angle of the tooth on the virtual wheel, from a chordal thickness at the reference circle", iso=ISO
    ),
)
def angle_of_chord(s_c: Metre, z_v: Number, m_n: Metre) -> Radian:
    return asin(s_c / (z_v * m_n))


@formula("x_E", Text("{iso}: generating shift of a half angle on the virtual wheel", iso=ISO), names={"psi": "ψ_v"})
def shift_of_half_angle(psi: Radian, z_v: Number, alpha_n: Radian) -> Number:
    return (psi * z_v - pi / 2) / (2 * tan(alpha_n))


@formula("E_W", Text("{iso}: change of the span that a generating shift means", iso=ISO), unit="µm")
def span_change(x_E: Number, x: Number, m_n: Metre, alpha_n: Radian) -> Metre:
    return 2 * (x_E - x) * m_n * sin(alpha_n)


# --- a ball between two flanks: where its centre stands and where it touches, and the preferred diameter

SOURCE = Text("DIN 3977, measuring pieces for cylindrical gears")
MILLIMETRES = (
    1, 1.1, 1.25, 1.4, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25, 3.5, 3.75, 4, 4.25, 4.5, 5, 5.25, 5.5, 6, 6.5, 7, 7.5,
    8, 9, 10, 10.5, 11,
    12, 14, 16, 18, 20, 22, 25, 28, 30, 35, 40, 45, 50,
)  # fmt: skip
PREFERRED: tuple[Metre, ...] = tuple(d / 1000 for d in MILLIMETRES)


@formula(
    "D_M",
    SOURCE,
    unit="mm",
    shows="the preferred diameter nearest to D_y that touches the flank and stands proud of the tip",
)
def nearest_preferred(D: Metre, D_y: Metre) -> Metre:
    """`D` is the one that was found."""
    return D


def preferred_ball(
    system: ToothSystem,
    z: Number,
    s_t: Metre,
    d: Metre,
    d_b: Metre,
    flank: tuple[Metre, Metre],
    d_f: Metre,
    ideal: Metre,
) -> Metre | None:
    """The preferred diameter nearest to `ideal` that touches between the circles `flank` and stands clear of the root
    and proud of the tip.

    None where there is no such diameter.
    """
    with untraced():
        for D in sorted(PREFERRED, key=lambda D: abs(D - ideal)):
            if suits(system, z, s_t, d, d_b, flank, d_f, D):
                break
            if not ideal / 3 < D < 3 * ideal:  # nothing beyond touches the flank near its middle
                return None
        else:
            return None
    return nearest_preferred(D=based_on(D, z, s_t, d, d_b, flank, d_f), D_y=ideal)


def suits(
    system: ToothSystem, z: Number, s_t: Metre, d: Metre, d_b: Metre, flank: tuple[Metre, Metre], d_f: Metre, D_M: Metre
) -> bool:
    """Whether a ball touches both flanks between these circles, clear of the root and proud of the tip."""
    there = seat(system, z, s_t, d, d_b, D_M)
    return (
        there is not None and flank[0] < there.d_y < flank[1] and there.d_K + D_M > flank[1] and there.d_K - D_M > d_f
    )


def seat(system: ToothSystem, z: Number, s_t: Metre, d: Metre, d_b: Metre, D_M: Metre) -> Seat | None:
    """None where the ball lies on the root, or would touch below the base circle, where there is no flank."""
    beta_b = system.base_helix_angle
    involute = ball_involute(
        s_t=s_t, d=d, alpha_t=system.transverse_pressure_angle, D_M=D_M, d_b=d_b, beta_b=beta_b, z=z
    )
    if involute <= 0:
        return None
    alpha_K = f.angle_of_involute(involute=involute)
    if d_b * math.tan(alpha_K) <= D_M * math.cos(beta_b):
        return None
    d_K = ball_centre_diameter(d_b=d_b, alpha_K=alpha_K)
    return Seat(alpha_K, d_K, ball_contact_diameter(d_b=d_b, alpha_K=alpha_K, D_M=D_M, beta_b=beta_b))
