# SPDX-License-Identifier: Apache-2.0
"""How unevenly the teeth share the load: along the face width (K_Hβ, K_Fβ, method C) and between tooth pairs (K_Hα, K_Fα, method B).

ISO 6336-1.  No helix modification is reckoned with (B_1 = B_2 = 1), and the contact pattern is not proven: f_sh and f_ma add up.
"""

from ...sheet.formula import formula
from ...sheet.functions import largest, smallest, sqrt
from ...sheet.units import Metre, Newton, NewtonPerMetre, Number, Pascal, PerPascal

CLAUSE_7 = "ISO 6336-1:2006, clause 7, method C, compared with public code"
CLAUSE_8 = "ISO 6336-1:2006, clause 8, method B, the same in 2019, compared with public code"
NAMES = {
    "w_m": "(F_m/b)", "f_Hbeta": "f_Hβ", "F_betax": "F_βx", "F_betay": "F_βy", "c_gamma_beta": "c_γβ", "c_gamma_alpha": "c_γα",
    "K_Hbeta": "K_Hβ", "f": "f_α",
}  # fmt: skip
LEAST_BEND: PerPascal = 5e-12  # 0.005 mm·µm/N
LEAST_SLENDER = 3.0  # b/h


# --- along the face width --------------------------------------------------------------------------------------------------
@formula("F_m/b", f"{CLAUSE_7}: mean load per face width", unit="N/mm")
def mean_load(w: NewtonPerMetre, K_V: Number) -> NewtonPerMetre:
    return w * K_V


@formula("F_βx,min", f"{CLAUSE_7}: smallest misalignment to reckon with", unit="µm", names=NAMES)
def least_misalignment(w_m: NewtonPerMetre, f_Hbeta: Metre) -> Metre:
    return largest(LEAST_BEND * w_m, 0.5 * f_Hbeta)


@formula("F_βx", f"{CLAUSE_7}: misalignment before running in, contact pattern not proven", unit="µm", names={"F_min": "F_βx,min"})
def initial_misalignment(f_sh: Metre, f_ma: Metre, F_min: Metre) -> Metre:
    return largest(1.33 * f_sh + f_ma, F_min)


@formula("F_βy", f"{CLAUSE_7}: misalignment after running in", unit="µm", names=NAMES)
def effective_misalignment(F_betax: Metre, y_beta: Metre) -> Metre:
    return F_betax - y_beta


@formula("ξ_β", f"{CLAUSE_7}: misalignment in terms of the deflection of the teeth, F_βy·c_γβ/(2·F_m/b)", names=NAMES)
def relative_misalignment(F_betay: Metre, c_gamma_beta: Pascal, w_m: NewtonPerMetre) -> Number:
    return F_betay * c_gamma_beta / (2 * w_m)


@formula("K_Hβ", f"{CLAUSE_7}: the whole face width touches", names={"xi": "ξ_β"})
def face_factor_whole(xi: Number) -> Number:
    return 1 + xi


@formula("K_Hβ", f"{CLAUSE_7}: a part of the face width touches", names={"xi": "ξ_β"})
def face_factor_part(xi: Number) -> Number:
    return 2 * sqrt(xi)


@formula("b_cal/b", f"{CLAUSE_7}: share of the face width that touches", unit="%", names={"xi": "ξ_β"})
def contact_share(xi: Number) -> Number:
    return 1 / sqrt(largest(xi, 1.0))


@formula("N_F", f"{CLAUSE_7}: from the smaller b/h of both wheels, at least 3", names={"r": "(b/h)"})
def root_exponent(r: Number) -> Number:
    return r**2 / (1 + r + r**2)


@formula("b/h", f"{CLAUSE_7}: face width over tooth height, at least 3")
def slenderness(b: Metre, d_a: Metre, d_f: Metre) -> Number:
    return largest(2 * b / (d_a - d_f), LEAST_SLENDER)


@formula("K_Fβ", f"{CLAUSE_7}: at the root", names=NAMES)
def face_factor_root(K_Hbeta: Number, N_F: Number) -> Number:
    return K_Hbeta**N_F


# --- between tooth pairs ---------------------------------------------------------------------------------------------------
@formula("q_α", f"{CLAUSE_8}: deviation in terms of the deflection of the teeth", names=NAMES)
def relative_deviation(c_gamma_alpha: Pascal, f: Metre, y_alpha: Metre, w_m: NewtonPerMetre, K_Hbeta: Number) -> Number:
    """The larger of f_pb and f_fα counts; the load that decides is F_t·K_A·K_V·K_Hβ."""
    return c_gamma_alpha * (f - y_alpha) / (w_m * K_Hbeta)


@formula("K_α", f"{CLAUSE_8}: ε_γ up to 2, before its limits")
def pair_factor(eps_gamma: Number, q_alpha: Number) -> Number:
    return eps_gamma / 2 * (0.9 + 0.4 * q_alpha)


@formula("K_α", f"{CLAUSE_8}: ε_γ above 2, before its limits")
def pair_factor_high(eps_gamma: Number, q_alpha: Number) -> Number:
    return 0.9 + 0.4 * sqrt(2 * (eps_gamma - 1) / eps_gamma) * q_alpha


@formula("K_Hα,max", f"{CLAUSE_8}: one pair carries all", names={"Z_eps": "Z_ε"})
def pair_limit_flank(eps_gamma: Number, eps_alpha: Number, Z_eps: Number) -> Number:
    return eps_gamma / (eps_alpha * Z_eps**2)


@formula("K_Fα,max", f"{CLAUSE_8}: one pair carries all")
def pair_limit_root(eps_gamma: Number, eps_alpha: Number) -> Number:
    return eps_gamma / (0.25 * eps_alpha + 0.75)


@formula("K_Hα", f"{CLAUSE_8}: within its limits", names={"K_max": "K_Hα,max", "K_alpha": "K_α"})
def pair_factor_flank(K_alpha: Number, K_max: Number) -> Number:
    return largest(1.0, smallest(K_alpha, K_max))


@formula("K_Fα", f"{CLAUSE_8}: within its limits", names={"K_max": "K_Fα,max", "K_alpha": "K_α"})
def pair_factor_root(K_alpha: Number, K_max: Number) -> Number:
    return largest(1.0, smallest(K_alpha, K_max))


@formula("w", "ISO 6336-1, as generally published: load per face width, F_t·K_A/b", unit="N/mm")
def line_load(F_t: Newton, K_A: Number, b: Metre) -> NewtonPerMetre:
    return F_t * K_A / b
