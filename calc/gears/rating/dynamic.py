# SPDX-License-Identifier: Apache-2.0
"""The dynamic factor K_V, ISO 6336-1, method B: the pair as one mass on the spring of its teeth, four ranges of speed about its resonance.

K_V is what the vibration of the teeth adds to the load; what comes from outside is in K_A.  A wheel with two mates is taken for each of
its meshes alone.
"""

from ...sheet.formula import formula
from ...sheet.functions import modulus, pi, sin
from ...sheet.record import record
from ...sheet.units import Metre, NewtonPerMetre, Number, Pascal
from .stiffness import CLAUSE_6

C_V1, C_V5 = 0.32, 0.47
MAIN_TO, ABOVE_FROM = 1.15, 1.5
MEGAPASCAL: Pascal = 1e6
MICROMETRE: Metre = 1e-6
COARSE = 6  # from this grade on tip relief brings nothing: B_k = 1


@record
class Excitation:
    """What shakes the teeth, each over the load that holds them together."""

    B_p: Number
    B_f: Number
    B_k: Number


@formula("B_p", f"{CLAUSE_6}: effect of the pitch, after running in", names={"c": "c'"})
def pitch_parameter(c: Pascal, f_pb: Metre, y_p: Metre, w: NewtonPerMetre) -> Number:
    return c * (f_pb - y_p) / w


@formula("B_f", f"{CLAUSE_6}: effect of the profile, after running in", names={"c": "c'", "f_falpha": "f_fα"})
def profile_parameter(c: Pascal, f_falpha: Metre, y_f: Metre, w: NewtonPerMetre) -> Number:
    return c * (f_falpha - y_f) / w


@formula("B_k", f"{CLAUSE_6}: effect of the tip relief", names={"c": "c'"})
def relief_parameter(c: Pascal, C_a: Metre, w: NewtonPerMetre) -> Number:
    return modulus(1 - c * C_a / w)


@formula("C_ay", f"{CLAUSE_6}: tip relief that running in makes where none is ground", unit="µm")
def run_in_relief(sigma_Hlim: Pascal) -> Metre:
    return MICROMETRE * ((sigma_Hlim / MEGAPASCAL / 97 - 18.45) ** 2 / 18 + 1.5)


@formula("C_a", "ISO 6336-1, as generally published: wheels of different material, the mean of both", unit="µm")
def mean_relief(C_a1: Metre, C_a2: Metre) -> Metre:
    return (C_a1 + C_a2) / 2


# --- coefficients by the total contact ratio; constants up to ε_γ = 2 ------------------------------------------------------------
@formula("C_v2", f"{CLAUSE_6}: ε_γ above 2")
def profile_coefficient(eps_gamma: Number) -> Number:
    return 0.57 / (eps_gamma - 0.3)


@formula("C_v3", f"{CLAUSE_6}: ε_γ above 2")
def stiffness_coefficient(eps_gamma: Number) -> Number:
    return 0.096 / (eps_gamma - 1.56)


@formula("C_v4", f"{CLAUSE_6}: ε_γ above 2")
def resonance_coefficient(eps_gamma: Number) -> Number:
    return (0.57 - 0.05 * eps_gamma) / (eps_gamma - 1.44)


@formula("C_v6", f"{CLAUSE_6}: ε_γ above 2")
def profile_coefficient_above(eps_gamma: Number) -> Number:
    return 0.12 / (eps_gamma - 1.74)


@formula("C_v7", f"{CLAUSE_6}: ε_γ from 1.5 to 2.5")
def load_coefficient_above(eps_gamma: Number) -> Number:
    return 0.125 * sin(pi * (eps_gamma - 2)) + 0.875


def _C_v2(eps_gamma: Number) -> Number:
    return profile_coefficient(eps_gamma=eps_gamma) if eps_gamma > 2 else 0.34


def _C_v3(eps_gamma: Number) -> Number:
    return stiffness_coefficient(eps_gamma=eps_gamma) if eps_gamma > 2 else 0.23


def _C_v4(eps_gamma: Number) -> Number:
    return resonance_coefficient(eps_gamma=eps_gamma) if eps_gamma > 2 else 0.90


def _C_v6(eps_gamma: Number) -> Number:
    return profile_coefficient_above(eps_gamma=eps_gamma) if eps_gamma > 2 else 0.47


def _C_v7(eps_gamma: Number) -> Number:
    return 0.75 if eps_gamma <= 1.5 else 1.0 if eps_gamma > 2.5 else load_coefficient_above(eps_gamma=eps_gamma)


# --- the four ranges -------------------------------------------------------------------------------------------------------
@formula("K", f"{CLAUSE_6}: below the main resonance")
def growth(B_p: Number, C_v2: Number, B_f: Number, C_v3: Number, B_k: Number) -> Number:
    return C_V1 * B_p + C_v2 * B_f + C_v3 * B_k


@formula("K_V", f"{CLAUSE_6}: below the main resonance, N ≤ N_S")
def factor_below(N: Number, K: Number) -> Number:
    return N * K + 1


@formula("K_V", f"{CLAUSE_6}: in the main resonance, N_S < N ≤ 1.15")
def factor_resonant(B_p: Number, C_v2: Number, B_f: Number, C_v4: Number, B_k: Number) -> Number:
    return C_V1 * B_p + C_v2 * B_f + C_v4 * B_k + 1


@formula("K_V", f"{CLAUSE_6}: above the main resonance, N ≥ 1.5")
def factor_above(B_p: Number, C_v6: Number, B_f: Number, C_v7: Number) -> Number:
    return C_V5 * B_p + C_v6 * B_f + C_v7


@formula("K_V", f"{CLAUSE_6}: between, 1.15 < N < 1.5", names={"K_115": "K_V,1.15", "K_150": "K_V,1.5"})
def factor_between(K_115: Number, K_150: Number, N: Number) -> Number:
    return K_150 + (K_115 - K_150) / 0.35 * (1.5 - N)


def dynamic_factor(B: Excitation, eps_gamma: Number, N: Number, N_S: Number) -> Number:
    """K_V by the range in which the speed lies; only the coefficients of that range are looked up.

    Where ε_γ is above 2 the formula for N ≥ 1.5 can fall below 1 for accurate wheels: the standard lets it.
    """
    if N <= N_S:
        K = growth(B_p=B.B_p, C_v2=_C_v2(eps_gamma), B_f=B.B_f, C_v3=_C_v3(eps_gamma), B_k=B.B_k)
        return factor_below(N=N, K=K)
    if N >= ABOVE_FROM:
        return _above(B, eps_gamma)
    resonant = factor_resonant(B_p=B.B_p, C_v2=_C_v2(eps_gamma), B_f=B.B_f, C_v4=_C_v4(eps_gamma), B_k=B.B_k)
    return resonant if N <= MAIN_TO else factor_between(K_115=resonant, K_150=_above(B, eps_gamma), N=N)


def _above(B: Excitation, eps_gamma: Number) -> Number:
    return factor_above(B_p=B.B_p, C_v6=_C_v6(eps_gamma), B_f=B.B_f, C_v7=_C_v7(eps_gamma))


def speed_range(N: Number, N_S: Number) -> str:
    if N <= N_S:
        return "below the main resonance"
    if N <= MAIN_TO:
        return "in the main resonance"
    return "above the main resonance" if N >= ABOVE_FROM else "between the main resonance and the range above it"
