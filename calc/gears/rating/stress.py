# SPDX-License-Identifier: Apache-2.0
"""Nominal stresses of ISO 6336, method B: contact σ_H0 and tooth root σ_F0, before any influence factor (every K = 1).

Here wheel 1 is the smaller of the pair and u = z_2/z_1 ≥ 1.  The tooth form holds for external wheels cut by a rack,
load at the outer point of single contact; all lengths of the virtual spur wheel (index n) are in the normal section,
those with * in modules."""

import math

from ...sheet.formula import formula
from ...sheet.functions import acos, cos, inv, pi, power, sin, smallest, sqrt, tan
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, NewtonMetre, Number, Pascal, Radian

CONTACT = Text("ISO 6336-2:2006, the same in 2019")
ROOT = Text("ISO 6336-3:2006, method B, the same in 2019")
ROOT_2019 = Text("ISO 6336-3:2019, method B")
BETA_MOST: Radian = math.radians(30)  # the helix angle factor does not grow further
BETA_FULL: Radian = math.radians(120)


@formula("F_t", "ISO 6336-1: tangential force at the reference circle")
def tangential_force(T: NewtonMetre, d: Metre) -> Newton:
    """>>> tangential_force(T=0.8592, d=0.05389)
    31.88717...
    """
    return 2 * abs(T) / d


# --- contact


@formula("Z_H", Text("{contact}: zone factor", contact=CONTACT))
def zone_factor(beta_b: Radian, alpha_wt: Radian, alpha_t: Radian) -> Number:
    """>>> zone_factor(beta_b=0.3584, alpha_wt=0.376, alpha_t=0.3739)
    2.339769...
    """
    return sqrt(2 * cos(beta_b) * cos(alpha_wt) / (cos(alpha_t) ** 2 * sin(alpha_wt)))


@formula(
    "E'",
    Text("{contact}: modulus of both bodies together, Z_E = √E'", contact=CONTACT),
    unit="MPa",
    meanings={
        "nu_1": "Poisson's ratio of the driver",
        "E_1": "Modulus of elasticity of the driver",
        "nu_2": "Poisson's ratio of the driven wheel",
        "E_2": "Modulus of elasticity of the driven wheel",
    },
)
def contact_modulus(nu_1: Number, E_1: Pascal, nu_2: Number, E_2: Pascal) -> Pascal:
    return 1 / (pi * ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2))


@formula("Z_ε", Text("{contact}: contact ratio factor; an overlap above 1 counts as 1", contact=CONTACT))
def contact_ratio_factor(eps_alpha: Number, eps_beta: Number) -> Number:
    return sqrt((4 - eps_alpha) / 3 * (1 - smallest(eps_beta, 1.0)) + smallest(eps_beta, 1.0) / eps_alpha)


@formula("Z_β", "ISO 6336-2:2006 and 2019: helix angle factor (1996 and DIN 3990: √cos β)")
def helix_factor_contact(beta: Radian) -> Number:
    return 1 / sqrt(cos(beta))


@formula(
    "σ_H0",
    Text("{contact}: nominal contact stress at the pitch point", contact=CONTACT),
    unit="MPa",
    names={"E_c": "E'"},
    meanings={"u": "Teeth of the wheel over those of the pinion"},
)
def contact_stress(
    Z_H: Number, E_c: Pascal, Z_eps: Number, Z_beta: Number, F_t: Newton, d_1: Metre, b: Metre, u: Number
) -> Pascal:
    """>>> contact_stress(Z_H=2.34, E_c=36030000000.0, Z_eps=0.8312, Z_beta=1.038, F_t=31.89, d_1=0.05389, b=0.015,
    ...     u=1.44)
    9908138...
    """
    return Z_H * sqrt(E_c) * Z_eps * Z_beta * sqrt(F_t / (d_1 * b) * (u + 1) / u)


# --- tooth root: the form of the tooth


@formula("z_n", Text("{root}: teeth of the virtual spur wheel", root=ROOT))
def virtual_teeth(z: Number, beta_b: Radian, beta: Radian) -> Number:
    return z / (cos(beta_b) ** 2 * cos(beta))


@formula("ε_αn", Text("{root}: contact ratio of the virtual wheels", root=ROOT))
def virtual_contact_ratio(eps_alpha: Number, beta_b: Radian) -> Number:
    return eps_alpha / cos(beta_b) ** 2


@formula("E", Text("{root}: half width of the tool at its corner centre", root=ROOT), unit="mm")
def tool_half_width(m_n: Metre, h_fP: Number, alpha_n: Radian, s_pr: Metre, rho_aP0: Number) -> Metre:
    return m_n * (pi / 4 - h_fP * tan(alpha_n) - (1 - sin(alpha_n)) * rho_aP0 / cos(alpha_n)) + s_pr / cos(alpha_n)


@formula(
    "G",
    Text("{root}: height of the corner centre against the reference circle", root=ROOT),
    meanings={"x": "Profile shift coefficient"},
)
def tool_corner_height(rho_aP0: Number, h_fP: Number, x: Number) -> Number:
    return rho_aP0 - h_fP + x


@formula("H", Text("{root}", root=ROOT))
def tool_corner_angle(z_n: Number, E: Metre, m_n: Metre) -> Number:
    return 2 / z_n * (pi / 2 - E / m_n) - pi / 3


@formula("θ", ROOT, shows="θ = 2G/z_n·tan θ − H, by Newton's method from −H")
def tangent_angle(G: Number, z_n: Number, H: Number) -> Radian:
    """From −H, between 0 and 60°, each step comes nearer on the same side: eight leave only rounding."""
    k, theta = 2 * G / z_n, -H
    for _ in range(8):
        t = tan(theta)
        theta = theta - (theta - k * t + H) / (1 - k * (1 + t * t))
    return theta


@formula("s*_Fn", Text("{root}: chord of the critical section, at the 30° tangents", root=ROOT))
def root_chord(z_n: Number, theta: Radian, G: Number, rho_aP0: Number) -> Number:
    return z_n * sin(pi / 3 - theta) + sqrt(3.0) * (G / cos(theta) - rho_aP0)


@formula("ρ*_F", Text("{root}: radius of the fillet at the 30° tangents", root=ROOT))
def fillet_radius(rho_aP0: Number, G: Number, theta: Radian, z_n: Number) -> Number:
    return rho_aP0 + 2 * G**2 / (cos(theta) * (z_n * cos(theta) ** 2 - 2 * G))


@formula("d_an", Text("{root}: tip diameter of the virtual wheel", root=ROOT), unit="mm")
def virtual_tip_diameter(m_n: Metre, z_n: Number, d_a: Metre, d: Metre) -> Metre:
    return m_n * z_n + d_a - d


@formula("d_bn", Text("{root}: base diameter of the virtual wheel", root=ROOT), unit="mm")
def virtual_base_diameter(m_n: Metre, z_n: Number, alpha_n: Radian) -> Metre:
    return m_n * z_n * cos(alpha_n)


@formula(
    "d_en",
    Text("{root}: circle of the outer single contact on the virtual wheel", root=ROOT),
    unit="mm",
    names={"eps_alphan": "ε_αn"},
)
def load_diameter(d_an: Metre, d_bn: Metre, m_n: Metre, alpha_n: Radian, eps_alphan: Number) -> Metre:
    return 2 * sqrt((sqrt(d_an**2 - d_bn**2) / 2 - pi * m_n * cos(alpha_n) * (eps_alphan - 1)) ** 2 + d_bn**2 / 4)


@formula("α_en", Text("{root}: pressure angle at the load", root=ROOT))
def load_pressure_angle(d_bn: Metre, d_en: Metre) -> Radian:
    return acos(d_bn / d_en)


@formula("γ_e", Text("{root}: half tooth angle at the load", root=ROOT), meanings={"x": "Profile shift coefficient"})
def load_tooth_angle(x: Number, alpha_n: Radian, z_n: Number, alpha_en: Radian) -> Radian:
    return (pi / 2 + 2 * x * tan(alpha_n)) / z_n + inv(alpha_n) - inv(alpha_en)


@formula("h*_Fe", Text("{root}: lever arm of the load; α_Fen = α_en − γ_e", root=ROOT))
def lever_arm(
    gamma_e: Radian, alpha_en: Radian, d_en: Metre, m_n: Metre, z_n: Number, theta: Radian, G: Number, rho_aP0: Number
) -> Number:
    return (
        (cos(gamma_e) - sin(gamma_e) * tan(alpha_en - gamma_e)) * d_en / m_n
        - z_n * cos(pi / 3 - theta)
        - G / cos(theta)
        + rho_aP0
    ) / 2


@formula("Y_F", Text("{root}: form factor; α_Fen = α_en − γ_e", root=ROOT), names={"h": "h*_Fe", "s": "s*_Fn"})
def form_factor(h: Number, alpha_en: Radian, gamma_e: Radian, s: Number, alpha_n: Radian) -> Number:
    return 6 * h * cos(alpha_en - gamma_e) / (s**2 * cos(alpha_n))


@formula("q_s", Text("{root}: notch parameter", root=ROOT), names={"s": "s*_Fn", "rho": "ρ*_F"})
def notch_parameter(s: Number, rho: Number) -> Number:
    return s / (2 * rho)


@formula("L", Text("{root}: chord over lever arm", root=ROOT), names={"s": "s*_Fn", "h": "h*_Fe"})
def slenderness(s: Number, h: Number) -> Number:
    return s / h


@formula("Y_S", Text("{root}: stress correction factor; holds for q_s from 1 to 8", root=ROOT))
def stress_correction(L: Number, q_s: Number) -> Number:
    return (1.2 + 0.13 * L) * power(q_s, 1 / (1.21 + 2.3 / L))


# --- tooth root: the stress


@formula("Y_β", "ISO 6336-3:2006: helix angle factor")
def helix_factor_root(eps_beta: Number, beta: Radian) -> Number:
    return 1 - smallest(eps_beta, 1.0) * smallest(beta, BETA_MOST) / BETA_FULL


@formula("Y_β", Text("{root_2019}: helix angle factor", root_2019=ROOT_2019))
def helix_factor_root_2019(eps_beta: Number, beta: Radian) -> Number:
    return (1 - smallest(eps_beta, 1.0) * smallest(beta, BETA_MOST) / BETA_FULL) / cos(beta) ** 3


@formula(
    "f_ε",
    Text("{root_2019}: load distribution for ε_αn < 2; an overlap above 1 counts as 1", root_2019=ROOT_2019),
    names={"eps_alphan": "ε_αn"},
)
def load_distribution(eps_beta: Number, eps_alphan: Number) -> Number:
    return sqrt(1 - smallest(eps_beta, 1.0) + smallest(eps_beta, 1.0) / eps_alphan)


@formula(
    "f_ε",
    Text("{root_2019}: load distribution for ε_αn ≥ 2; an overlap above 1 counts as 1", root_2019=ROOT_2019),
    names={"eps_alphan": "ε_αn"},
)
def load_distribution_high(eps_beta: Number, eps_alphan: Number) -> Number:
    return sqrt((1 - smallest(eps_beta, 1.0)) / 2 + smallest(eps_beta, 1.0) / eps_alphan)


@formula("σ_F0", "ISO 6336-3:2006: nominal tooth root stress", unit="MPa")
def root_stress(F_t: Newton, b: Metre, m_n: Metre, Y_F: Number, Y_S: Number, Y_beta: Number) -> Pascal:
    return F_t / (b * m_n) * Y_F * Y_S * Y_beta


@formula("σ_F0", Text("{root_2019}: nominal tooth root stress", root_2019=ROOT_2019), unit="MPa")
def root_stress_2019(
    F_t: Newton, b: Metre, m_n: Metre, Y_F: Number, f_eps: Number, Y_S: Number, Y_beta: Number
) -> Pascal:
    return F_t / (b * m_n) * Y_F * f_eps * Y_S * Y_beta
