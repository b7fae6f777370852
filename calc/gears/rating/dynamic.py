# SPDX-License-Identifier: Apache-2.0
"""Stiffness of the teeth, main resonance and dynamic factor K_V of a pair, ISO 6336-1, method B.

The pair is one mass on the spring of its teeth; four ranges of speed about its resonance.  K_V is what the vibration of
the teeth adds to the load; what comes from outside is in K_A.  A wheel with two mates is taken for each of its meshes
alone.  Wheel 1 is the smaller one; stiffness is per face width: 1 N/(mm·µm) = 1 GPa."""

from ...sheet.formula import Formula, formula
from ...sheet.functions import cos, modulus, pi, power, sin, sqrt
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import (
    KilogramPerMetre,
    KilogramPerMetre3,
    Metre,
    NewtonPerMetre,
    Number,
    Pascal,
    PerPascal,
    Radian,
    RevPerSecond,
)

CLAUSE_9 = Text("ISO 6336-1:2006, clause 9, the same in 2019")
CLAUSE_6 = Text("ISO 6336-1:2006, clause 6, the same in 2019")
C_GAMMA = {"c_gamma_alpha": "c_γα"}
UNIT_COMPLIANCE: PerPascal = 1e-9  # 1 mm·µm/N
E_STEEL: Pascal = 206e9
C_M = 0.8  # measured over calculated stiffness
C_R = 1.0  # solid disc; a thin web would be softer
LIGHT: NewtonPerMetre = 1e5  # 100 N/mm: below, the stiffness falls with the load
DEGREE: Radian = pi / 180
C_V1, C_V5 = 0.32, 0.47
MAIN_TO, ABOVE_FROM = 1.15, 1.5
MEGAPASCAL: Pascal = 1e6
MICROMETRE: Metre = 1e-6
COARSE = 6  # from this grade on tip relief brings nothing: B_k = 1


# --- stiffness


@formula(
    "q'",
    Text("{clause_9}: compliance of a tooth pair; holds for x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2", clause_9=CLAUSE_9),
    meanings={"x_1": "Profile shift coefficient of the driver"},
)
def tooth_compliance(z_n1: Number, z_n2: Number, x_1: Number, x_2: Number) -> PerPascal:
    return UNIT_COMPLIANCE * (
        0.04723
        + 0.15551 / z_n1
        + 0.25791 / z_n2
        - 0.00635 * x_1
        - 0.11654 * x_1 / z_n1
        - 0.00193 * x_2
        - 0.24188 * x_2 / z_n2
        + 0.00529 * x_1**2
        + 0.00182 * x_2**2
    )


@formula("c'_th", Text("{clause_9}: theoretical single stiffness", clause_9=CLAUSE_9), unit="GPa", names={"q": "q'"})
def theoretical_stiffness(q: PerPascal) -> Pascal:
    return 1 / q


@formula(
    "C_B", Text("{clause_9}: basic rack factor; dedendum in modules, the same tool for both wheels", clause_9=CLAUSE_9)
)
def basic_rack_factor(h_fP: Number, alpha_n: Radian) -> Number:
    return (1 + 0.5 * (1.2 - h_fP)) * (1 - 0.02 * (20 - alpha_n / DEGREE))


@formula(
    "c'",
    Text("{clause_9}: single stiffness from 100 N/mm on; C_M = 0.8, C_R = 1", clause_9=CLAUSE_9),
    unit="GPa",
    names={"c_th": "c'_th"},
)
def single_stiffness(c_th: Pascal, C_B: Number, beta: Radian, e: Number) -> Pascal:
    return c_th * C_M * C_R * C_B * cos(beta) * e


@formula(
    "e",
    Text("{clause_9}: both moduli against that of steel, E/E_St", clause_9=CLAUSE_9),
    meanings={"E_1": "Modulus of elasticity of the driver", "E_2": "Modulus of elasticity of the driven wheel"},
)
def modulus_ratio(E_1: Pascal, E_2: Pascal) -> Number:
    return 2 * E_1 * E_2 / (E_1 + E_2) / E_STEEL


@formula(
    "c'", Text("{clause_9}: single stiffness below 100 N/mm", clause_9=CLAUSE_9), unit="GPa", names={"c": "c'_100"}
)
def light_load_stiffness(c: Pascal, w: NewtonPerMetre) -> Pascal:
    return c * power(w / LIGHT, 0.25)


@formula(
    "c_γα",
    Text(
        "{clause_9}: mesh stiffness; holds for ε_α ≥ 1.2 and β ≤ 30°, spur gears below are up to 10 % softer",
        clause_9=CLAUSE_9,
    ),
    unit="GPa",
    names={"c": "c'"},
)
def mesh_stiffness(c: Pascal, eps_alpha: Number) -> Pascal:
    return c * (0.75 * eps_alpha + 0.25)


@formula("c_γβ", Text("{clause_9}: mesh stiffness along the face width", clause_9=CLAUSE_9), unit="GPa", names=C_GAMMA)
def face_stiffness(c_gamma_alpha: Pascal) -> Pascal:
    return 0.85 * c_gamma_alpha


# --- resonance


@formula("d_i", "dynamics, disc that stands for a wheel with a rim: the mass of the rim alone counts", unit="mm")
def inside_of_rim(d_f: Metre, s_R: Metre) -> Metre:
    return d_f - 2 * s_R


@formula("d_m", Text("{clause_6}: mean diameter of the teeth", clause_6=CLAUSE_6), unit="mm")
def mean_diameter(d_a: Metre, d_f: Metre) -> Metre:
    return (d_a + d_f) / 2


@formula(
    "m*",
    Text("{clause_6}: mass of a ring per face width, reduced to the line of action", clause_6=CLAUSE_6),
    names={"rho": "ρ_W"},
    meanings={"rho": "Density of the wheel", "d_i": "Inside diameter of the rim"},
)
def wheel_mass(rho: KilogramPerMetre3, d_m: Metre, d_i: Metre, d_b: Metre) -> KilogramPerMetre:
    return pi / 8 * rho * (d_m**4 - d_i**4) / d_b**2


@formula("m_red", Text("{clause_6}: reduced mass of the pair", clause_6=CLAUSE_6), names={"m_1": "m*_1", "m_2": "m*_2"})
def reduced_mass(m_1: KilogramPerMetre, m_2: KilogramPerMetre) -> KilogramPerMetre:
    return m_1 * m_2 / (m_1 + m_2)


@formula(
    "n_E1", Text("{clause_6}: speed of wheel 1 at the main resonance", clause_6=CLAUSE_6), unit="rpm", names=C_GAMMA
)
def resonance_speed(z_1: Number, c_gamma_alpha: Pascal, m_red: KilogramPerMetre) -> RevPerSecond:
    return sqrt(c_gamma_alpha / m_red) / (2 * pi * z_1)


@formula("N", Text("{clause_6}: resonance ratio", clause_6=CLAUSE_6))
def resonance_ratio(n_1: RevPerSecond, n_E1: RevPerSecond) -> Number:
    return abs(n_1) / n_E1


@formula("N_S", Text("{clause_6}: lower end of the main resonance, below 100 N/mm", clause_6=CLAUSE_6))
def lower_resonance(w: NewtonPerMetre) -> Number:
    return 0.5 + 0.35 * sqrt(w / LIGHT)


# --- excitation


@record
class Excitation:
    """What shakes the teeth, each over the load that holds them together."""

    B_p: Number
    B_f: Number
    B_k: Number


@formula("B_p", Text("{clause_6}: effect of the pitch, after running in", clause_6=CLAUSE_6), names={"c": "c'"})
def pitch_parameter(c: Pascal, f_pb: Metre, y_p: Metre, w: NewtonPerMetre) -> Number:
    return c * (f_pb - y_p) / w


@formula(
    "B_f",
    Text("{clause_6}: effect of the profile, after running in", clause_6=CLAUSE_6),
    names={"c": "c'", "f_falpha": "f_fα"},
)
def profile_parameter(c: Pascal, f_falpha: Metre, y_f: Metre, w: NewtonPerMetre) -> Number:
    return c * (f_falpha - y_f) / w


@formula("B_k", Text("{clause_6}: effect of the tip relief", clause_6=CLAUSE_6), names={"c": "c'"})
def relief_parameter(c: Pascal, C_a: Metre, w: NewtonPerMetre) -> Number:
    return modulus(1 - c * C_a / w)


@formula(
    "C_ay", Text("{clause_6}: tip relief that running in makes where none is ground", clause_6=CLAUSE_6), unit="µm"
)
def run_in_relief(sigma_Hlim: Pascal) -> Metre:
    return MICROMETRE * ((sigma_Hlim / MEGAPASCAL / 97 - 18.45) ** 2 / 18 + 1.5)


@formula("C_a", "ISO 6336-1: wheels of different material, the mean of both", unit="µm")
def mean_relief(C_a1: Metre, C_a2: Metre) -> Metre:
    return (C_a1 + C_a2) / 2


# --- coefficients by the total contact ratio; constants up to ε_γ = 2


@formula("C_v2", Text("{clause_6}: ε_γ above 2", clause_6=CLAUSE_6))
def profile_coefficient(eps_gamma: Number) -> Number:
    return 0.57 / (eps_gamma - 0.3)


@formula("C_v3", Text("{clause_6}: ε_γ above 2", clause_6=CLAUSE_6))
def stiffness_coefficient(eps_gamma: Number) -> Number:
    return 0.096 / (eps_gamma - 1.56)


@formula("C_v4", Text("{clause_6}: ε_γ above 2", clause_6=CLAUSE_6))
def resonance_coefficient(eps_gamma: Number) -> Number:
    return (0.57 - 0.05 * eps_gamma) / (eps_gamma - 1.44)


@formula("C_v6", Text("{clause_6}: ε_γ above 2", clause_6=CLAUSE_6))
def profile_coefficient_above(eps_gamma: Number) -> Number:
    return 0.12 / (eps_gamma - 1.74)


@formula("C_v7", Text("{clause_6}: ε_γ from 1.5 to 2.5", clause_6=CLAUSE_6))
def load_coefficient_above(eps_gamma: Number) -> Number:
    return 0.125 * sin(pi * (eps_gamma - 2)) + 0.875


def _by_overlap(above_two: Formula[..., Number], up_to_two: Number, eps_gamma: Number) -> Number:
    """A coefficient: its formula for ε_γ above 2, else its constant."""
    return above_two(eps_gamma=eps_gamma) if eps_gamma > 2 else up_to_two


# --- the four ranges


@formula(
    "K_N",
    Text("{clause_6}: rise of the dynamic factor with N, below the main resonance", clause_6=CLAUSE_6),
    meanings={"B_k": "Share of the tip relief"},
)
def growth(B_p: Number, C_v2: Number, B_f: Number, C_v3: Number, B_k: Number) -> Number:
    return C_V1 * B_p + C_v2 * B_f + C_v3 * B_k


@formula(
    "K_V", Text("{clause_6}: dynamic factor below the main resonance, N ≤ N_S", clause_6=CLAUSE_6), names={"K": "K_N"}
)
def factor_below(N: Number, K: Number) -> Number:
    return N * K + 1


@formula("K_V", Text("{clause_6}: dynamic factor in the main resonance, N_S < N ≤ 1.15", clause_6=CLAUSE_6))
def factor_resonant(B_p: Number, C_v2: Number, B_f: Number, C_v4: Number, B_k: Number) -> Number:
    return C_V1 * B_p + C_v2 * B_f + C_v4 * B_k + 1


@formula("K_V", Text("{clause_6}: dynamic factor above the main resonance, N ≥ 1.5", clause_6=CLAUSE_6))
def factor_above(B_p: Number, C_v6: Number, B_f: Number, C_v7: Number) -> Number:
    return C_V5 * B_p + C_v6 * B_f + C_v7


@formula(
    "K_V",
    Text("{clause_6}: between, 1.15 < N < 1.5", clause_6=CLAUSE_6),
    names={"K_115": "K_V,1.15", "K_150": "K_V,1.5"},
)
def factor_between(K_115: Number, K_150: Number, N: Number) -> Number:
    return K_150 + (K_115 - K_150) / 0.35 * (1.5 - N)


def dynamic_factor(B: Excitation, eps_gamma: Number, N: Number, N_S: Number) -> Number:
    """K_V by the range in which the speed lies; only the coefficients of that range are looked up.

    Where ε_γ is above 2 the formula for N ≥ 1.5 can fall below 1 for accurate wheels: the standard lets it.
    """
    if N >= ABOVE_FROM:
        return _above(B, eps_gamma)
    C_v2 = _by_overlap(profile_coefficient, 0.34, eps_gamma)
    if N <= N_S:
        K = growth(B_p=B.B_p, C_v2=C_v2, B_f=B.B_f, C_v3=_by_overlap(stiffness_coefficient, 0.23, eps_gamma), B_k=B.B_k)
        return factor_below(N=N, K=K)
    resonant = factor_resonant(
        B_p=B.B_p, C_v2=C_v2, B_f=B.B_f, C_v4=_by_overlap(resonance_coefficient, 0.90, eps_gamma), B_k=B.B_k
    )
    return resonant if N <= MAIN_TO else factor_between(K_115=resonant, K_150=_above(B, eps_gamma), N=N)


def _above(B: Excitation, eps_gamma: Number) -> Number:
    C_v6 = _by_overlap(profile_coefficient_above, 0.47, eps_gamma)
    C_v7 = 0.75 if eps_gamma <= 1.5 else 1.0 if eps_gamma > 2.5 else load_coefficient_above(eps_gamma=eps_gamma)
    return factor_above(B_p=B.B_p, C_v6=C_v6, B_f=B.B_f, C_v7=C_v7)


def speed_range(N: Number, N_S: Number) -> Text:
    if N <= N_S:
        return Text("below the main resonance")
    if N <= MAIN_TO:
        return Text("in the main resonance")
    return (
        Text("above the main resonance")
        if N >= ABOVE_FROM
        else Text("between the main resonance and the range above it")
    )
