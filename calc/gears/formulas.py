# SPDX-License-Identifier: Apache-2.0
"""External helical involute wheels and their pairs: one function per equation.

Index n: normal section, t: transverse section, w: working circle, b: base circle, a: tip, f: root, F: form circle, N: contact
with the mate.  x is the shift coefficient without backlash, in normal modules; 1 is the driver, 2 the driven wheel.  ρ is the
radius of curvature of the flank, which is also the place on the line of action, from the point where it touches the base circle.
"""

import math
from typing import Any

import numpy as np

from ..sheet.formula import formula
from ..sheet.functions import acos, asin, atan, cos, inv, largest, pi, sin, sqrt, tan
from ..sheet.units import Metre, Number, Radian, RevPerSecond

ISO = "ISO 21771:2007, as generally published"


# --- the tooth system, common to all wheels of a train ------------------------------------------------------------------
@formula("m_t", f"{ISO}: transverse module", unit="mm")
def transverse_module(m_n: Metre, beta: Radian) -> Metre:
    return m_n / cos(beta)


@formula("α_t", f"{ISO}: transverse pressure angle")
def transverse_pressure_angle(alpha_n: Radian, beta: Radian) -> Radian:
    return atan(tan(alpha_n) / cos(beta))


@formula("β_b", f"{ISO}: helix angle at the base circle")
def base_helix_angle(beta: Radian, alpha_n: Radian) -> Radian:
    return asin(sin(beta) * cos(alpha_n))


@formula("p_bt", f"{ISO}: transverse base pitch", unit="mm")
def base_pitch(m_t: Metre, alpha_t: Radian) -> Metre:
    return pi * m_t * cos(alpha_t)


@formula("h_fP", f"{ISO}: dedendum of the finished teeth; a tool that leaves stock on the flanks is held back from the root by q/sin α_n")
def finished_dedendum(h_aP0: Number, q: Metre, m_n: Metre, alpha_n: Radian) -> Number:
    return h_aP0 - q / (m_n * sin(alpha_n))


@formula("s_pr", f"{ISO}: undercut that the protuberance leaves under the finished flank", unit="mm")
def residual_undercut(pr_P0: Metre, q: Metre) -> Metre:
    return pr_P0 - q


@formula("u_c", "straight-sided tool with round corners: half distance of the corner centres, transverse; must not be negative", unit="mm")
def tool_corner_position(
    m_t: Metre, h_fP: Number, rho_aP0: Number, m_n: Metre, alpha_t: Radian, alpha_n: Radian, beta: Radian, s_pr: Metre
) -> Metre:
    return pi * m_t / 4 - (h_fP - rho_aP0) * m_n * tan(alpha_t) - (rho_aP0 * m_n - s_pr) / (cos(alpha_n) * cos(beta))


# --- one wheel -------------------------------------------------------------------------------------------------------------
@formula("d", f"{ISO}: reference diameter", unit="mm")
def reference_diameter(z: Number, m_t: Metre) -> Metre:
    return z * m_t


@formula("d_b", f"{ISO}: base diameter", unit="mm")
def base_diameter(d: Metre, alpha_t: Radian) -> Metre:
    return d * cos(alpha_t)


@formula("d_a", f"{ISO}: tip diameter; k is the tip cut, radial", unit="mm")
def tip_diameter(d: Metre, m_n: Metre, x: Number, k: Metre) -> Metre:
    return d + 2 * m_n * (1 + x) - 2 * k


@formula("d_f", f"{ISO}: root diameter made by the tool", unit="mm")
def root_diameter(d: Metre, m_n: Metre, x: Number, h_fP: Number) -> Metre:
    return d + 2 * m_n * (x - h_fP)


@formula("x_min", f"{ISO}: smallest shift without undercut, tool with tip radius")
def undercut_limit(h_fP: Number, rho_aP0: Number, alpha_n: Radian, z: Number, alpha_t: Radian, beta: Radian) -> Number:
    return h_fP - rho_aP0 * (1 - sin(alpha_n)) - z * sin(alpha_t) ** 2 / (2 * cos(beta))


@formula("h_F", f"{ISO}: depth of the end of the tool's straight flank below the reference circle", unit="mm")
def straight_flank_depth(m_n: Metre, h_fP: Number, rho_aP0: Number, alpha_n: Radian, x: Number) -> Metre:
    return m_n * (h_fP - rho_aP0 * (1 - sin(alpha_n)) - x)


@formula("d_Ff", f"{ISO}: form diameter, where the fillet begins; holds for x ≥ x_min", unit="mm")
def form_diameter(d: Metre, alpha_t: Radian, h_F: Metre, d_b: Metre) -> Metre:
    return sqrt((d * sin(alpha_t) - 2 * h_F / sin(alpha_t)) ** 2 + d_b**2)


@formula("s_t", f"{ISO}: transverse tooth thickness at the reference circle", unit="mm")
def reference_thickness(m_n: Metre, x: Number, alpha_n: Radian, beta: Radian) -> Metre:
    return m_n * (pi / 2 + 2 * x * tan(alpha_n)) / cos(beta)


@formula("h", f"{ISO}: tooth depth", unit="mm")
def tooth_depth(d_a: Metre, d_f: Metre) -> Metre:
    return (d_a - d_f) / 2


@formula("inv α_p", f"{ISO}: pressure angle where the flanks of a tooth meet")
def pointed_involute(s_t: Metre, d: Metre, alpha_t: Radian) -> Number:
    return s_t / d + inv(alpha_t)


@formula("d_p", f"{ISO}: circle on which the tooth is pointed", unit="mm")
def pointed_diameter(d_b: Metre, alpha_p: Radian) -> Metre:
    return d_b / cos(alpha_p)


@formula("d", "a diameter with its tolerance", unit="mm")
def with_tolerance(d: Metre, T: Metre) -> Metre:
    return d + T


@formula("α_yt", f"{ISO}: transverse pressure angle at a circle")
def pressure_angle_at(d_b: Metre, d_y: Metre) -> Radian:
    return acos(d_b / d_y)


@formula("s_yt", f"{ISO}: transverse tooth thickness at a circle", unit="mm")
def thickness_at(d_y: Metre, s_t: Metre, d: Metre, alpha_t: Radian, alpha_yt: Radian) -> Metre:
    return d_y * (s_t / d + inv(alpha_t) - inv(alpha_yt))


@formula("s_yn", f"{ISO}: normal tooth thickness at a circle, tan β_y = tan β·d_y/d", unit="mm")
def normal_thickness_at(s_yt: Metre, beta: Radian, d_y: Metre, d: Metre) -> Metre:
    return s_yt * cos(atan(tan(beta) * d_y / d))


@formula("ρ_y", f"{ISO}: radius of curvature of the flank at a circle, transverse", unit="mm")
def curvature_at(d_y: Metre, d_b: Metre) -> Metre:
    return sqrt(d_y**2 - d_b**2) / 2


@formula("d_y", f"{ISO}: circle on which the flank has a radius of curvature", unit="mm")
def diameter_at(d_b: Metre, rho: Metre) -> Metre:
    return sqrt(d_b**2 + 4 * rho**2)


@formula("n", "ratio of the teeth; wheels in mesh turn in opposite senses", unit="rpm")
def driven_speed(n_1: RevPerSecond, z_1: Number, z_2: Number) -> RevPerSecond:
    return -n_1 * z_1 / z_2


@formula("i", "ratio of the speeds, − where the last wheel turns against the first")
def speed_ratio(n_last: RevPerSecond, n_1: RevPerSecond) -> Number:
    return n_last / n_1


# --- a pair: centre distance and shifts ------------------------------------------------------------------------------------
@formula("α_wt", f"{ISO}: working transverse pressure angle")
def working_pressure_angle(d_b1: Metre, d_b2: Metre, a_w: Metre) -> Radian:
    return acos((d_b1 + d_b2) / (2 * a_w))


@formula("β_w", f"{ISO}: helix angle at the working circle")
def working_helix_angle(beta_b: Radian, alpha_wt: Radian) -> Radian:
    return atan(tan(beta_b) / cos(alpha_wt))


@formula("d_w", f"{ISO}: working diameter; z is the wheel's, z_m its mate's", unit="mm")
def working_diameter(a_w: Metre, z: Number, z_m: Number) -> Metre:
    return 2 * a_w * z / (z + z_m)


@formula("m_wt", f"{ISO}: transverse module at the working circles", unit="mm")
def working_module(a_w: Metre, z_1: Number, z_2: Number) -> Metre:
    return 2 * a_w / (z_1 + z_2)


@formula("y", f"{ISO}: centre distance modification, in normal modules")
def centre_modification(a_w: Metre, d_1: Metre, d_2: Metre, m_n: Metre) -> Number:
    return (a_w - (d_1 + d_2) / 2) / m_n


@formula("Σx", f"{ISO}: sum of the shifts of both wheels")
def sum_of_shifts(x_1: Number, x_2: Number) -> Number:
    return x_1 + x_2


@formula("x", "rule of this program: the first wheel whose shift nothing gives has none", shows="0")
def no_shift() -> Number:
    return float("0")


@formula("Σx", f"{ISO}: sum of the shifts without backlash")
def shift_sum(z_1: Number, z_2: Number, alpha_wt: Radian, alpha_t: Radian, alpha_n: Radian) -> Number:
    return (z_1 + z_2) * (inv(alpha_wt) - inv(alpha_t)) / (2 * tan(alpha_n))


@formula("x", f"{ISO}: shift of the mate", names={"x_sum": "Σx"})
def mate_shift(x_sum: Number, x_m: Number) -> Number:
    return x_sum - x_m


@formula("inv α_wt", f"{ISO}: working pressure angle without backlash")
def working_involute(alpha_t: Radian, alpha_n: Radian, x_1: Number, x_2: Number, z_1: Number, z_2: Number) -> Number:
    return inv(alpha_t) + 2 * tan(alpha_n) * (x_1 + x_2) / (z_1 + z_2)


@formula("α", "inverse of inv α = tan α − α by Newton's method, from above", shows="the angle whose involute is given: tan α − α = inv α")
def angle_of_involute(involute: Number) -> Radian:
    """The root of t − arctan t = inv α in t = tan α; from a start above it the iteration falls steadily.

    0 where inv α is not above 0; in an array no number there.
    """
    if isinstance(involute, np.ndarray):
        return _angles_of_involutes(involute)
    if involute <= 0:
        return 0.0
    t = involute + pi / 2
    if (start := (3 * involute) ** (1 / 3)) < 1.5:
        t = min(t, math.tan(start))
    for _ in range(60):
        step = (t - math.atan(t) - involute) * (1 + t * t) / (t * t)
        t -= step
        if abs(step) <= 1e-15 * t:
            break
    return math.atan(t)


def _angles_of_involutes(involute: Any) -> Any:
    """The same for an array, by the same steps."""
    wanted = np.where(involute > 0, involute, np.nan)
    start = (3 * wanted) ** (1 / 3)
    t = np.where(start < 1.5, np.minimum(wanted + np.pi / 2, np.tan(np.minimum(start, 1.5))), wanted + np.pi / 2)
    for _ in range(60):
        step = (t - np.arctan(t) - wanted) * (1 + t * t) / (t * t)
        t = t - step
        if not (np.abs(step) > 1e-15 * t).any():
            break
    return np.arctan(t)


@formula("a_w", f"{ISO}: centre distance without backlash", unit="mm")
def centre_distance(z_1: Number, z_2: Number, m_t: Metre, alpha_t: Radian, alpha_wt: Radian) -> Metre:
    return (z_1 + z_2) * m_t * cos(alpha_t) / (2 * cos(alpha_wt))


@formula("k*·m_n", f"{ISO}: tip shortening that would keep the standard clearance", unit="mm")
def standard_tip_shortening(x_1: Number, x_2: Number, m_n: Metre, a_w: Metre, d_1: Metre, d_2: Metre) -> Metre:
    return (x_1 + x_2) * m_n - (a_w - (d_1 + d_2) / 2)


# --- a pair: contact -------------------------------------------------------------------------------------------------------
@formula("c", f"{ISO}: tip clearance at the root of the wheel", unit="mm")
def tip_clearance(a_w: Metre, d_f: Metre, d_am: Metre) -> Metre:
    return a_w - d_f / 2 - d_am / 2


@formula("T_1T_2", f"{ISO}: length of the line of action between the base circles", unit="mm")
def line_of_action(a_w: Metre, alpha_wt: Radian) -> Metre:
    return a_w * sin(alpha_wt)


@formula("ρ_A", f"{ISO}: start of the active profile, where the mate's tip arrives or the fillet ends", unit="mm", names={"T": "T_1T_2"})
def start_of_active_profile(T: Metre, rho_am: Metre, rho_F: Metre) -> Metre:
    return largest(T - rho_am, rho_F)


@formula("g_α", f"{ISO}: path of contact", unit="mm", names={"T": "T_1T_2"})
def path_of_contact(T: Metre, rho_A1: Metre, rho_A2: Metre) -> Metre:
    return T - rho_A1 - rho_A2


@formula("ε_α", f"{ISO}: transverse contact ratio")
def transverse_contact_ratio(g_alpha: Metre, p_bt: Metre) -> Number:
    return g_alpha / p_bt


@formula("ε_β", f"{ISO}: overlap ratio; b is the common width")
def overlap_ratio(b: Metre, beta: Radian, m_n: Metre) -> Number:
    return b * sin(beta) / (pi * m_n)


@formula("ε_γ", f"{ISO}: total contact ratio")
def total_contact_ratio(eps_alpha: Number, eps_beta: Number) -> Number:
    return eps_alpha + eps_beta


@formula("ρ_B", f"{ISO}: lowest point of single contact; exists where 1 ≤ ε_α < 2", unit="mm", names={"T": "T_1T_2"})
def lowest_single_contact(T: Metre, rho_Am: Metre, p_bt: Metre) -> Metre:
    """One base pitch before the end of contact, which is where the mate's begins."""
    return T - rho_Am - p_bt


@formula("ρ_D", f"{ISO}: highest point of single contact; exists where 1 ≤ ε_α < 2", unit="mm")
def highest_single_contact(rho_A: Metre, p_bt: Metre) -> Metre:
    """One base pitch after its own start of contact."""
    return rho_A + p_bt


@formula("ζ", f"{ISO}: specific sliding, negative below the working circle", names={"T": "T_1T_2"})
def specific_sliding(T: Metre, rho: Metre, z: Number, z_m: Number) -> Number:
    return 1 - (T - rho) * z / (rho * z_m)
