# SPDX-License-Identifier: Apache-2.0
"""External helical involute wheels and their pairs: one function per equation.

Index n: normal section, t: transverse section, w: working circle, b: base circle, a: tip, f: root, F: form circle, N:
contact with the mate.  x is the shift coefficient without backlash, in normal modules; 1 is the driver, 2 the driven
wheel.  ρ is the radius of curvature of the flank, which is also the place on the line of action, from the point where
it touches the base circle."""

import math

import numpy as np

from ..sheet.arrays import Array
from ..sheet.formula import formula
from ..sheet.functions import acos, asin, atan, cos, inv, joined, largest, pi, sin, sqrt, tan
from ..sheet.text import Text
from ..sheet.units import Metre, Number, Radian, RevPerSecond

ISO = Text("ISO 21771:2007")


# --- the tooth system, common to all wheels of a train


@formula("m_t", Text("{iso}: transverse module", iso=ISO), unit="mm")
def transverse_module(m_n: Metre, beta: Radian) -> Metre:
    """>>> transverse_module(m_n=0.002, beta=0.3825)
    0.002155789...
    """
    return m_n / cos(beta)


@formula("m_n", Text("{iso}: normal module from the transverse one", iso=ISO), unit="mm")
def normal_module(m_t: Metre, beta: Radian) -> Metre:
    """>>> normal_module(m_t=0.002155789, beta=0.3825)
    0.00199999...
    """
    return m_t * cos(beta)


@formula("α_t", Text("{iso}: transverse pressure angle", iso=ISO))
def transverse_pressure_angle(alpha_n: Radian, beta: Radian) -> Radian:
    """>>> transverse_pressure_angle(alpha_n=0.3491, beta=0.3825)
    0.3739056...
    """
    return atan(tan(alpha_n) / cos(beta))


@formula("β_b", Text("{iso}: helix angle at the base circle", iso=ISO))
def base_helix_angle(beta: Radian, alpha_n: Radian) -> Radian:
    """>>> base_helix_angle(beta=0.3825, alpha_n=0.3491)
    0.3583477...
    """
    return asin(sin(beta) * cos(alpha_n))


@formula("p_bt", Text("{iso}: transverse base pitch", iso=ISO), unit="mm")
def base_pitch(m_t: Metre, alpha_t: Radian) -> Metre:
    return pi * m_t * cos(alpha_t)


@formula(
    "h_fP",
    Text(
        "{iso}: dedendum of the finished teeth; a tool that leaves stock on the flanks is held back from the root by "
        "q/sin α_n",
        iso=ISO,
    ),
)
def finished_dedendum(h_aP0: Number, q: Metre, m_n: Metre, alpha_n: Radian) -> Number:
    return h_aP0 - q / (m_n * sin(alpha_n))


@formula("s_pr", Text("{iso}: undercut that the protuberance leaves under the finished flank", iso=ISO), unit="mm")
def residual_undercut(pr_P0: Metre, q: Metre) -> Metre:
    return pr_P0 - q


@formula(
    "u_c",
    "geometry, straight-sided tool with round corners: half distance of the corner centres, transverse; must not be "
    "negative",
    unit="mm",
)
def tool_corner_position(
    m_t: Metre, h_fP: Number, rho_aP0: Number, m_n: Metre, alpha_t: Radian, alpha_n: Radian, beta: Radian, s_pr: Metre
) -> Metre:
    return pi * m_t / 4 - (h_fP - rho_aP0) * m_n * tan(alpha_t) - (rho_aP0 * m_n - s_pr) / (cos(alpha_n) * cos(beta))


# --- one wheel


@formula("d", Text("{iso}: reference diameter", iso=ISO), unit="mm")
def reference_diameter(z: Number, m_t: Metre) -> Metre:
    """>>> reference_diameter(z=25, m_t=0.00215579)
    0.05389475
    """
    return z * m_t


@formula("d_b", Text("{iso}: base diameter", iso=ISO), unit="mm")
def base_diameter(d: Metre, alpha_t: Radian) -> Metre:
    """>>> base_diameter(d=0.05389, alpha_t=0.3739)
    0.05016673...
    """
    return d * cos(alpha_t)


@formula(
    "d_a",
    Text("{iso}: tip diameter; k is the tip cut, radial", iso=ISO),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def tip_diameter(d: Metre, m_n: Metre, x: Number, k: Metre) -> Metre:
    """>>> tip_diameter(d=0.05389, m_n=0.002, x=0.01423, k=0)
    0.05794692
    """
    return d + 2 * m_n * (1 + x) - 2 * k


@formula(
    "d_f",
    Text("{iso}: root diameter made by the tool", iso=ISO),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def root_diameter(d: Metre, m_n: Metre, x: Number, h_fP: Number) -> Metre:
    """>>> root_diameter(d=0.05389, m_n=0.002, x=0.01423, h_fP=1.41)
    0.04830692
    """
    return d + 2 * m_n * (x - h_fP)


@formula("x_min", Text("{iso}: smallest shift without undercut, tool with tip radius", iso=ISO))
def undercut_limit(h_fP: Number, rho_aP0: Number, alpha_n: Radian, z: Number, alpha_t: Radian, beta: Radian) -> Number:
    """>>> undercut_limit(h_fP=1.41, rho_aP0=0.2, alpha_n=0.3491, z=25, alpha_t=0.3739, beta=0.3825)
    -0.5190684...
    """
    return h_fP - rho_aP0 * (1 - sin(alpha_n)) - z * sin(alpha_t) ** 2 / (2 * cos(beta))


@formula(
    "h_F",
    Text("{iso}: depth of the end of the tool's straight flank below the reference circle", iso=ISO),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def straight_flank_depth(m_n: Metre, h_fP: Number, rho_aP0: Number, alpha_n: Radian, x: Number) -> Metre:
    return m_n * (h_fP - rho_aP0 * (1 - sin(alpha_n)) - x)


@formula("d_Ff", Text("{iso}: form diameter, where the fillet begins; holds for x ≥ x_min", iso=ISO), unit="mm")
def form_diameter(d: Metre, alpha_t: Radian, h_F: Metre, d_b: Metre) -> Metre:
    return sqrt((d * sin(alpha_t) - 2 * h_F / sin(alpha_t)) ** 2 + d_b**2)


@formula(
    "s_t",
    Text("{iso}: transverse tooth thickness at the reference circle", iso=ISO),
    unit="mm",
    meanings={"x": "Profile shift coefficient"},
)
def reference_thickness(m_n: Metre, x: Number, alpha_n: Radian, beta: Radian) -> Metre:
    return m_n * (pi / 2 + 2 * x * tan(alpha_n)) / cos(beta)


@formula("h", Text("{iso}: tooth depth", iso=ISO), unit="mm")
def tooth_depth(d_a: Metre, d_f: Metre) -> Metre:
    return (d_a - d_f) / 2


@formula("inv α_p", Text("{iso}: pressure angle where the flanks of a tooth meet", iso=ISO))
def pointed_involute(s_t: Metre, d: Metre, alpha_t: Radian) -> Number:
    return s_t / d + inv(alpha_t)


@formula("d_p", Text("{iso}: circle on which the tooth is pointed", iso=ISO), unit="mm")
def pointed_diameter(d_b: Metre, alpha_p: Radian) -> Metre:
    return d_b / cos(alpha_p)


@formula("d", "geometry: a diameter with its tolerance", unit="mm", names={"d": "d_nom", "T": "E_d"})
def with_tolerance(d: Metre, T: Metre) -> Metre:
    return d + T


@formula(
    "α_yt", Text("{iso}: transverse pressure angle at a circle", iso=ISO), meanings={"d_y": "Diameter of the circle"}
)
def pressure_angle_at(d_b: Metre, d_y: Metre) -> Radian:
    return acos(d_b / d_y)


@formula(
    "s_yt",
    Text("{iso}: transverse tooth thickness at a circle", iso=ISO),
    unit="mm",
    meanings={"d_y": "Diameter of the circle"},
)
def thickness_at(d_y: Metre, s_t: Metre, d: Metre, alpha_t: Radian, alpha_yt: Radian) -> Metre:
    return d_y * (s_t / d + inv(alpha_t) - inv(alpha_yt))


@formula("s_yn", Text("{iso}: normal tooth thickness at a circle, tan β_y = tan β·d_y/d", iso=ISO), unit="mm")
def normal_thickness_at(s_yt: Metre, beta: Radian, d_y: Metre, d: Metre) -> Metre:
    return s_yt * cos(atan(tan(beta) * d_y / d))


@formula(
    "ρ_y",
    Text("{iso}: radius of curvature of the flank at a circle, transverse", iso=ISO),
    unit="mm",
    meanings={"d_y": "Diameter of the circle"},
)
def curvature_at(d_y: Metre, d_b: Metre) -> Metre:
    return sqrt(d_y**2 - d_b**2) / 2


@formula(
    "d_y",
    Text("{iso}: circle on which the flank has a radius of curvature", iso=ISO),
    unit="mm",
    names={"rho": "ρ_y"},
    meanings={"rho": "Radius of curvature of the flank there"},
)
def diameter_at(d_b: Metre, rho: Metre) -> Metre:
    return sqrt(d_b**2 + 4 * rho**2)


@formula("n", "kinematics: ratio of the teeth; wheels in mesh turn in opposite senses", unit="rpm")
def driven_speed(n_1: RevPerSecond, z_1: Number, z_2: Number) -> RevPerSecond:
    return -n_1 * z_1 / z_2


@formula("i", "kinematics: ratio of the speeds, − where the last wheel turns against the first")
def speed_ratio(n_last: RevPerSecond, n_1: RevPerSecond) -> Number:
    return n_last / n_1


# --- a pair: centre distance and shifts


@formula("α_wt", Text("{iso}: working transverse pressure angle", iso=ISO))
def working_pressure_angle(d_b1: Metre, d_b2: Metre, a_w: Metre) -> Radian:
    """>>> working_pressure_angle(d_b1=0.07225, d_b2=0.07827, a_w=0.08056)
    0.3647568...
    """
    return acos((d_b1 + d_b2) / (2 * a_w))


@formula("β_w", Text("{iso}: helix angle at the working circle", iso=ISO))
def working_helix_angle(beta_b: Radian, alpha_wt: Radian) -> Radian:
    return atan(tan(beta_b) / cos(alpha_wt))


@formula("d_w", Text("{iso}: working diameter; z is the wheel's, z_m its mate's", iso=ISO), unit="mm")
def working_diameter(a_w: Metre, z: Number, z_m: Number) -> Metre:
    return 2 * a_w * z / (z + z_m)


@formula("m_wt", Text("{iso}: transverse module at the working circles", iso=ISO), unit="mm")
def working_module(a_w: Metre, z_1: Number, z_2: Number) -> Metre:
    return 2 * a_w / (z_1 + z_2)


@formula("y", Text("{iso}: centre distance modification, in normal modules", iso=ISO))
def centre_modification(a_w: Metre, d_1: Metre, d_2: Metre, m_n: Metre) -> Number:
    return joined(a_w, -(d_1 + d_2) / 2) / m_n


@formula(
    "Σx",
    Text("{iso}: sum of the shifts of both wheels", iso=ISO),
    meanings={"x_1": "Profile shift coefficient of the driver"},
)
def sum_of_shifts(x_1: Number, x_2: Number) -> Number:
    return x_1 + x_2


@formula("x", "rule of this program: the first wheel whose shift nothing gives has none", shows="0")
def no_shift() -> Number:
    return 0.0


@formula(
    "j_bn",
    Text(
        "{iso}: normal backlash that is left where the driven wheel has less shift than meshes without; exact", iso=ISO
    ),
    unit="µm",
)
def backlash_of_shifts(m_n: Metre, alpha_n: Radian, x_0: Number, x_2: Number) -> Metre:
    """`x_0`: the driven wheel's shift that leaves no backlash at this centre distance.

    >>> backlash_of_shifts(m_n=0.002, alpha_n=0.3491, x_0=-0.156, x_2=-0.16)
    5.472...e-06
    """
    return 2 * m_n * sin(alpha_n) * (x_0 - x_2)


@formula("Σx", Text("{iso}: sum of the shifts without backlash", iso=ISO))
def shift_sum(z_1: Number, z_2: Number, alpha_wt: Radian, alpha_t: Radian, alpha_n: Radian) -> Number:
    return (z_1 + z_2) * (inv(alpha_wt) - inv(alpha_t)) / (2 * tan(alpha_n))


@formula("x", Text("{iso}: shift of the mate", iso=ISO), names={"x_sum": "Σx"})
def mate_shift(x_sum: Number, x_m: Number) -> Number:
    """>>> mate_shift(x_sum=-0.142, x_m=0.014)
    -0.156
    """
    return x_sum - x_m


@formula(
    "inv α_wt",
    Text("{iso}: working pressure angle without backlash", iso=ISO),
    meanings={"x_1": "Profile shift coefficient of the driver"},
)
def working_involute(alpha_t: Radian, alpha_n: Radian, x_1: Number, x_2: Number, z_1: Number, z_2: Number) -> Number:
    return inv(alpha_t) + 2 * tan(alpha_n) * (x_1 + x_2) / (z_1 + z_2)


@formula(
    "α_y",
    "mathematics: pressure angle of an involute, by Newton's method from inv α = tan α − α",
    shows="the angle whose involute is given: tan α − α = inv α",
    names={"involute": "inv α"},
)
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


def _angles_of_involutes(involute: Array) -> Array:
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


@formula("a_w", Text("{iso}: centre distance without backlash", iso=ISO), unit="mm")
def centre_distance(z_1: Number, z_2: Number, m_t: Metre, alpha_t: Radian, alpha_wt: Radian) -> Metre:
    """>>> centre_distance(z_1=25, z_2=36, m_t=0.002156, alpha_t=0.3739, alpha_wt=0.376)
    0.06581237...
    """
    return (z_1 + z_2) * m_t * cos(alpha_t) / (2 * cos(alpha_wt))


@formula(
    "k*·m_n",
    Text("{iso}: tip shortening that would keep the standard clearance", iso=ISO),
    unit="mm",
    meanings={"x_1": "Profile shift coefficient of the driver"},
)
def standard_tip_shortening(x_1: Number, x_2: Number, m_n: Metre, a_w: Metre, d_1: Metre, d_2: Metre) -> Metre:
    return (x_1 + x_2) * m_n - joined(a_w, -(d_1 + d_2) / 2)


# --- a pair: contact


@formula("c", Text("{iso}: tip clearance at the root of the wheel", iso=ISO), unit="mm")
def tip_clearance(a_w: Metre, d_f: Metre, d_am: Metre) -> Metre:
    """>>> tip_clearance(a_w=0.065813, d_f=0.048307, d_am=0.081657)
    0.0008309999...
    """
    return a_w - d_f / 2 - d_am / 2


@formula("T_1T_2", Text("{iso}: length of the line of action between the base circles", iso=ISO), unit="mm")
def line_of_action(a_w: Metre, alpha_wt: Radian) -> Metre:
    """>>> line_of_action(a_w=0.06581, alpha_wt=0.376)
    0.02416561...
    """
    return a_w * sin(alpha_wt)


@formula(
    "ρ_A",
    Text("{iso}: start of the active profile, where the mate's tip arrives or the fillet ends", iso=ISO),
    unit="mm",
    names={"T": "T_1T_2"},
)
def start_of_active_profile(T: Metre, rho_am: Metre, rho_F: Metre) -> Metre:
    return largest(T - rho_am, rho_F)


@formula("g_α", Text("{iso}: path of contact", iso=ISO), unit="mm", names={"T": "T_1T_2"})
def path_of_contact(T: Metre, rho_A1: Metre, rho_A2: Metre) -> Metre:
    return T - rho_A1 - rho_A2


@formula("ε_α", Text("{iso}: transverse contact ratio", iso=ISO))
def transverse_contact_ratio(g_alpha: Metre, p_bt: Metre) -> Number:
    """>>> transverse_contact_ratio(g_alpha=0.00937, p_bt=0.006305)
    1.486122...
    """
    return g_alpha / p_bt


@formula("ε_β", Text("{iso}: overlap ratio; b is the common width", iso=ISO))
def overlap_ratio(b: Metre, beta: Radian, m_n: Metre) -> Number:
    """>>> overlap_ratio(b=0.015, beta=0.3825, m_n=0.002)
    0.8910471...
    """
    return b * sin(beta) / (pi * m_n)


@formula("ε_γ", Text("{iso}: total contact ratio", iso=ISO))
def total_contact_ratio(eps_alpha: Number, eps_beta: Number) -> Number:
    return eps_alpha + eps_beta


@formula(
    "ρ_B",
    Text("{iso}: lowest point of single contact; exists where 1 ≤ ε_α < 2", iso=ISO),
    unit="mm",
    names={"T": "T_1T_2"},
)
def lowest_single_contact(T: Metre, rho_Am: Metre, p_bt: Metre) -> Metre:
    """One base pitch before the end of contact, which is where the mate's begins."""
    return T - rho_Am - p_bt


@formula("ρ_D", Text("{iso}: highest point of single contact; exists where 1 ≤ ε_α < 2", iso=ISO), unit="mm")
def highest_single_contact(rho_A: Metre, p_bt: Metre) -> Metre:
    """One base pitch after its own start of contact."""
    return rho_A + p_bt


@formula(
    "ζ",
    Text("{iso}: specific sliding, negative below the working circle", iso=ISO),
    names={"T": "T_1T_2", "rho": "ρ_y"},
)
def specific_sliding(T: Metre, rho: Metre, z: Number, z_m: Number) -> Number:
    """>>> specific_sliding(T=0.02417, rho=0.005132, z=25, z_m=36)
    -1.576156...
    """
    return 1 - (T - rho) * z / (rho * z_m)
