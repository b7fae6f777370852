# SPDX-License-Identifier: Apache-2.0
"""Stiffness of the teeth, reduced mass of a pair and its main resonance, ISO 6336-1, method B.

Stiffness is per face width: 1 N/(mm·µm) = 1 GPa.  Wheel 1 is the smaller one.
"""

from ...sheet.formula import formula
from ...sheet.functions import cos, pi, sqrt
from ...sheet.units import KilogramPerMetre, KilogramPerMetre3, Metre, NewtonPerMetre, Number, Pascal, PerPascal, Radian, RevPerSecond

CLAUSE_9 = "ISO 6336-1:2006, clause 9, the same in 2019, compared with public code"
CLAUSE_6 = "ISO 6336-1:2006, clause 6, the same in 2019, compared with public code"
C_GAMMA = {"c_gamma_alpha": "c_γα"}
UNIT_COMPLIANCE: PerPascal = 1e-9  # 1 mm·µm/N
E_STEEL: Pascal = 206e9
C_M = 0.8  # measured over calculated stiffness
C_R = 1.0  # solid disc; a thin web would be softer
LIGHT: NewtonPerMetre = 1e5  # 100 N/mm: below, the stiffness falls with the load
DEGREE: Radian = pi / 180


@formula("q'", f"{CLAUSE_9}: compliance of a tooth pair; holds for x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2")
def tooth_compliance(z_n1: Number, z_n2: Number, x_1: Number, x_2: Number) -> PerPascal:
    return UNIT_COMPLIANCE * (
        0.04723 + 0.15551 / z_n1 + 0.25791 / z_n2 - 0.00635 * x_1 - 0.11654 * x_1 / z_n1
        - 0.00193 * x_2 - 0.24188 * x_2 / z_n2 + 0.00529 * x_1**2 + 0.00182 * x_2**2
    )  # fmt: skip


@formula("c'_th", f"{CLAUSE_9}: theoretical single stiffness", unit="GPa", names={"q": "q'"})
def theoretical_stiffness(q: PerPascal) -> Pascal:
    return 1 / q


@formula("C_B", f"{CLAUSE_9}: basic rack factor; dedendum in modules, the same tool for both wheels")
def basic_rack_factor(h_fP: Number, alpha_n: Radian) -> Number:
    return (1 + 0.5 * (1.2 - h_fP)) * (1 - 0.02 * (20 - alpha_n / DEGREE))


@formula("c'", f"{CLAUSE_9}: single stiffness from 100 N/mm on; C_M = 0.8, C_R = 1", unit="GPa", names={"c_th": "c'_th"})
def single_stiffness(c_th: Pascal, C_B: Number, beta: Radian, e: Number) -> Pascal:
    return c_th * C_M * C_R * C_B * cos(beta) * e


@formula("e", f"{CLAUSE_9}: both moduli against that of steel, E/E_St")
def modulus_ratio(E_1: Pascal, E_2: Pascal) -> Number:
    return 2 * E_1 * E_2 / (E_1 + E_2) / E_STEEL


@formula("c'", f"{CLAUSE_9}: single stiffness below 100 N/mm", unit="GPa", names={"c": "c'_100"})
def light_load_stiffness(c: Pascal, w: NewtonPerMetre) -> Pascal:
    return c * (w / LIGHT) ** 0.25


@formula(
    "c_γα",
    f"{CLAUSE_9}: mesh stiffness; holds for ε_α ≥ 1.2 and β ≤ 30°, spur gears below are up to 10 % softer",
    unit="GPa",
    names={"c": "c'"},
)
def mesh_stiffness(c: Pascal, eps_alpha: Number) -> Pascal:
    return c * (0.75 * eps_alpha + 0.25)


@formula("c_γβ", f"{CLAUSE_9}: mesh stiffness along the face width", unit="GPa", names=C_GAMMA)
def face_stiffness(c_gamma_alpha: Pascal) -> Pascal:
    return 0.85 * c_gamma_alpha


# --- resonance -------------------------------------------------------------------------------------------------------------
@formula("d_i", "disc that stands for a wheel with a rim: the mass of the rim alone counts", unit="mm")
def inside_of_rim(d_f: Metre, s_R: Metre) -> Metre:
    return d_f - 2 * s_R


@formula("d_m", f"{CLAUSE_6}: mean diameter of the teeth", unit="mm")
def mean_diameter(d_a: Metre, d_f: Metre) -> Metre:
    return (d_a + d_f) / 2


@formula("m*", f"{CLAUSE_6}: mass of a ring per face width, reduced to the line of action")
def wheel_mass(rho: KilogramPerMetre3, d_m: Metre, d_i: Metre, d_b: Metre) -> KilogramPerMetre:
    return pi / 8 * rho * (d_m**4 - d_i**4) / d_b**2


@formula("m_red", f"{CLAUSE_6}: reduced mass of the pair", names={"m_1": "m*_1", "m_2": "m*_2"})
def reduced_mass(m_1: KilogramPerMetre, m_2: KilogramPerMetre) -> KilogramPerMetre:
    return m_1 * m_2 / (m_1 + m_2)


@formula("n_E1", f"{CLAUSE_6}: speed of wheel 1 at the main resonance", unit="rpm", names=C_GAMMA)
def resonance_speed(z_1: Number, c_gamma_alpha: Pascal, m_red: KilogramPerMetre) -> RevPerSecond:
    return sqrt(c_gamma_alpha / m_red) / (2 * pi * z_1)


@formula("N", f"{CLAUSE_6}: resonance ratio")
def resonance_ratio(n_1: RevPerSecond, n_E1: RevPerSecond) -> Number:
    return abs(n_1) / n_E1


@formula("N_S", f"{CLAUSE_6}: lower end of the main resonance, below 100 N/mm")
def lower_resonance(w: NewtonPerMetre) -> Number:
    return 0.5 + 0.35 * sqrt(w / LIGHT)
