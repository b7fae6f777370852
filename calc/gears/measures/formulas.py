# SPDX-License-Identifier: Apache-2.0
"""What the inspector measures on one wheel: span over teeth, size over balls, chordal thickness.

An allowance E_W is the change of the span.  The tooth is thinner by it in the normal section at E_W/cos α_n, which the generating
shift x_E carries; so the measures of a thinned tooth are those of a tooth with the shift x_E.
"""

import math

from ...sheet.formula import formula
from ...sheet.functions import cos, inv, pi, sin, sqrt, tan
from ...sheet.units import Metre, Number, Radian
from ..formulas import ISO

STEEPEST: Radian = 1.5  # no ball touches a flank further out than this pressure angle of its centre


@formula("x_E", f"{ISO}: generating shift of a tooth thinned by the change E_W of its span")
def generating_shift(x: Number, E_W: Metre, m_n: Metre, alpha_n: Radian) -> Number:
    return x + E_W / (2 * m_n * sin(alpha_n))


# --- span ------------------------------------------------------------------------------------------------------------------
@formula("K", f"{ISO}: number of teeth for a contact at the circle of α_yt, before rounding")
def span_teeth(z: Number, alpha_yt: Radian, beta_b: Radian, alpha_t: Radian, x: Number, alpha_n: Radian) -> Number:
    return z / pi * (tan(alpha_yt) / cos(beta_b) ** 2 - inv(alpha_t) - 2 * x * tan(alpha_n) / z) + 0.5


@formula("K", "the nearest whole number of teeth, of two that are equally near the smaller", shows="K rounded, at least 1")
def whole_span_teeth(K: Number) -> Number:
    return float(max(1, math.ceil(K - 0.5 - 1e-9)))  # whatever the last digits say


@formula(
    "K", f"{ISO}: of the spans that can be measured the one that touches nearest to d + 2·x·m_n", shows="K with d_W nearest to d + 2·x·m_n"
)
def best_span(K: Number) -> Number:
    return 1.0 * K


@formula("W_K", f"{ISO}: base tangent length over K teeth", unit="mm")
def span(m_n: Metre, alpha_n: Radian, K: Number, z: Number, alpha_t: Radian, x: Number) -> Metre:
    return m_n * cos(alpha_n) * (pi * (K - 0.5) + z * inv(alpha_t)) + 2 * x * m_n * sin(alpha_n)


@formula("W_K,E", "an allowance is a change of the span", unit="mm")
def span_with_allowance(W_K: Metre, E_W: Metre) -> Metre:
    return W_K + E_W


@formula("d_W", f"{ISO}: circle on which the anvils touch, K teeth placed symmetrically", unit="mm")
def span_contact_diameter(d_b: Metre, W_K: Metre, beta_b: Radian) -> Metre:
    return sqrt(d_b**2 + (W_K * cos(beta_b)) ** 2)


@formula("b_W", f"{ISO}: face width that the span needs, anvils apart", unit="mm")
def span_width(W_K: Metre, beta_b: Radian) -> Metre:
    return W_K * sin(beta_b)


# --- balls -----------------------------------------------------------------------------------------------------------------
@formula("inv α_K", f"{ISO}: pressure angle at the centre of a ball in the tooth space; negative: the ball touches no flank")
def ball_involute(s_t: Metre, d: Metre, alpha_t: Radian, D_M: Metre, d_b: Metre, beta_b: Radian, z: Number) -> Number:
    return s_t / d + inv(alpha_t) + D_M / (d_b * cos(beta_b)) - pi / z


@formula("d_K", f"{ISO}: circle of the ball centres", unit="mm")
def ball_centre_diameter(d_b: Metre, alpha_K: Radian) -> Metre:
    return d_b / cos(alpha_K)


@formula("M", f"{ISO}: size over two balls, even number of teeth", unit="mm")
def over_balls_even(d_K: Metre, D_M: Metre) -> Metre:
    return d_K + D_M


@formula("M", f"{ISO}: size over two balls, odd number of teeth", unit="mm")
def over_balls_odd(d_K: Metre, z: Number, D_M: Metre) -> Metre:
    return d_K * cos(pi / (2 * z)) + D_M


@formula("d_y", f"{ISO}: circle on which a ball touches the flanks", unit="mm")
def ball_contact_diameter(d_b: Metre, alpha_K: Radian, D_M: Metre, beta_b: Radian) -> Metre:
    return sqrt(d_b**2 + (d_b * tan(alpha_K) - D_M * cos(beta_b)) ** 2)


@formula(
    "D_y", "contact of a ball with a helical involute, solved exactly (the usual closed form holds for spur teeth)", unit="mm",
    shows="ball that touches the flanks at α_yt: tan α_K·sin²β_b + (α_K + c)·cos²β_b = tan α_yt, c = s_t/d + inv α_t − π/z",
)  # fmt: skip
def ball_for_contact(s_t: Metre, d: Metre, alpha_t: Radian, z: Number, d_b: Metre, beta_b: Radian, alpha_yt: Radian) -> Metre:
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


# --- chordal thickness, normal section ---------------------------------------------------------------------------------------
@formula("z_v", f"{ISO}: teeth of the virtual spur wheel at the reference circle")
def virtual_teeth(z: Number, beta: Radian) -> Number:
    return z / cos(beta) ** 3


@formula("ψ", f"{ISO}: half angle of the tooth on the virtual wheel")
def half_tooth_angle(z_v: Number, x: Number, alpha_n: Radian) -> Radian:
    return pi / (2 * z_v) + 2 * x * tan(alpha_n) / z_v


@formula("s_c", f"{ISO}: normal chordal thickness at the reference circle", unit="mm")
def chordal_thickness(z_v: Number, m_n: Metre, psi: Radian) -> Metre:
    return z_v * m_n * sin(psi)


@formula("h_c", f"{ISO}: height of the tip above the chord", unit="mm")
def chordal_height(z_v: Number, m_n: Metre, psi: Radian, d_a: Metre, d: Metre) -> Metre:
    return z_v * m_n * (1 - cos(psi)) / 2 + (d_a - d) / 2


@formula(
    "s_cc",
    f"{ISO}: constant chord, between the points where the basic rack touches both flanks; the same for any number of teeth",
    unit="mm",
)
def constant_chord(m_n: Metre, alpha_n: Radian, x: Number) -> Metre:
    """Exact for helical teeth too, in the normal section through the middle of the tooth at the reference circle."""
    return m_n * (pi / 2 * cos(alpha_n) ** 2 + x * sin(2 * alpha_n))


@formula("h_cc", f"{ISO}: height of the tip above the constant chord", unit="mm")
def constant_chord_height(d_a: Metre, d: Metre, s_cc: Metre, alpha_n: Radian) -> Metre:
    return (d_a - d) / 2 - s_cc * tan(alpha_n) / 2


@formula("d_cc", "rack and tooth at the pitch point: circle on which the ends of the constant chord lie", unit="mm")
def constant_chord_diameter(d: Metre, s_cc: Metre, alpha_n: Radian, beta: Radian) -> Metre:
    return sqrt((d + s_cc * tan(alpha_n)) ** 2 + (s_cc * cos(beta)) ** 2)


# --- tooth thickness and its allowance -----------------------------------------------------------------------------------------
@formula("s_n", f"{ISO}: normal tooth thickness at the reference circle", unit="mm")
def normal_thickness(m_n: Metre, x: Number, alpha_n: Radian) -> Metre:
    return m_n * (pi / 2 + 2 * x * tan(alpha_n))


@formula("E_sn", f"{ISO}: normal tooth thickness allowance of a change of the span", unit="µm")
def thickness_allowance(E_W: Metre, alpha_n: Radian) -> Metre:
    return E_W / cos(alpha_n)


@formula("E_st", f"{ISO}: transverse tooth thickness allowance at the reference circle", unit="µm")
def transverse_allowance(E_sn: Metre, beta: Radian) -> Metre:
    return E_sn / cos(beta)
