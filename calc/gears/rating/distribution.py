# SPDX-License-Identifier: Apache-2.0
"""How unevenly the teeth share the load: along the face width (K_Hβ, K_Fβ, method C) and between tooth pairs (K_Hα,
K_Fα, method B).

ISO 6336-1, with what an accuracy grade lets the flanks deviate (ISO 1328-1:2013) and what running in takes away again.
No helix modification is reckoned with (B_1 = B_2 = 1), and the contact pattern is not proven: f_sh and f_ma add up.

The tolerances hold for 5 ≤ z ≤ 1000, 5 mm ≤ d ≤ 15 m, 0.5 mm ≤ m_n ≤ 70 mm, 4 mm ≤ b ≤ 1.2 m, β ≤ 45° and grades 1 to
11; the standard forbids to go on beyond.  ISO 6336-1:2006 cites the tables of 1995: they differ by a rounding step here
and there."""

import math

from ...sheet.formula import formula
from ...sheet.functions import cos, largest, pi, power, smallest, sqrt
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Metre,
    MetrePerSecond,
    Newton,
    NewtonPerMetre,
    Number,
    Pascal,
    PerPascal,
    Radian,
    RevPerSecond,
)

CLAUSE_7 = Text("ISO 6336-1:2006, clause 7, method C")
CLAUSE_8 = Text("ISO 6336-1:2006, clause 8, method B, the same in 2019")
NAMES = {
    "w_m": "(F_m/b)",
    "f_Hbeta": "f_Hβ",
    "F_betax": "F_βx",
    "F_betay": "F_βy",
    "c_gamma_beta": "c_γβ",
    "c_gamma_alpha": "c_γα",
    "K_Hbeta": "K_Hβ",
    "f": "f_α",
}
LEAST_BEND: PerPascal = 5e-12  # 0.005 mm·µm/N
LEAST_SLENDER = 3.0  # b/h
ISO_1328 = Text("ISO 1328-1:2013, clause 5")
RUN_IN = Text("ISO 6336-1:2006, 8.3.5, the same in 2019")
RUN_IN_BETA = Text("ISO 6336-1:2006, 7.5.2.1, the same in 2019")
SLOPES = {"f_Hbeta1": "f_Hβ1", "f_Hbeta2": "f_Hβ2"}
F_BETA = {"F_betax": "F_βx"}
MILLIMETRE: Metre = 1e-3
MICROMETRE: Metre = 1e-6
MEGAPASCAL: Pascal = 1e6
MOST_RUN_IN: Metre = 3e-6  # of a base pitch, hardened flanks
MOST_RUN_IN_BETA: Metre = 6e-6  # of a helix, hardened flanks
# above this speed [m/s] no larger deviation runs in [m]; twice that speed class, half of it
CAPS = ((10.0, 40e-6), (5.0, 80e-6))
RANGES = (("d", 5e-3, 15.0), ("m_n", 0.5e-3, 70e-3), ("b", 4e-3, 1.2))
HARD = ("Eh", "IF", "NT", "NV")  # case, induction and flame hardened, nitrided, nitrocarburised
SOFT_IRON = ("GG", "GGG(ferr.)")


# --- deviations of the flanks


@formula("f_pT", Text("{iso_1328}: single pitch, before rounding", iso_1328=ISO_1328), unit="µm", names={"A": "Q"})
def single_pitch_tolerance(d: Metre, m_n: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.001 * d / MILLIMETRE + 0.4 * m_n / MILLIMETRE + 5) * 2 ** ((A - 5) / 2)


@formula(
    "f_fαT", Text("{iso_1328}: form of the profile, before rounding", iso_1328=ISO_1328), unit="µm", names={"A": "Q"}
)
def profile_form_tolerance(m_n: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.55 * m_n / MILLIMETRE + 5) * 2 ** ((A - 5) / 2)


@formula(
    "f_HβT", Text("{iso_1328}: slope of the helix, before rounding", iso_1328=ISO_1328), unit="µm", names={"A": "Q"}
)
def helix_slope_tolerance(d: Metre, b: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.05 * sqrt(d / MILLIMETRE) + 0.35 * sqrt(b / MILLIMETRE) + 4) * 2 ** ((A - 5) / 2)


@formula(
    "f",
    Text("{iso_1328}, 5.2.3", iso_1328=ISO_1328),
    unit="µm",
    shows="rounded: above 10 µm to 1 µm, from 5 µm to 0.5 µm, below to 0.1 µm",
)
def rounded(f: Metre) -> Metre:
    """Halves go up."""
    um = f * 1e6
    parts = 1 if um > 10 else 2 if um >= 5 else 10
    return math.floor(um * parts + 0.5 + 1e-9) / (parts * 1e6)


@formula("f_pb", "ISO 6336-1: transverse base pitch, from the single pitch", unit="µm")
def base_pitch_deviation(f_pT: Metre, alpha_t: Radian) -> Metre:
    return f_pT * cos(alpha_t)


@formula("f_ma", "ISO 6336-1:2019, 7.5: helix slopes of both wheels, no helix modification", unit="µm", names=SLOPES)
def mesh_misalignment(f_Hbeta1: Metre, f_Hbeta2: Metre) -> Metre:
    return sqrt(f_Hbeta1**2 + f_Hbeta2**2)


def out_of_range(m_n: Metre, b: Metre, *diameters: Metre) -> list[Text]:
    """Sizes for which ISO 1328-1 has no tolerance; the formulas are then extrapolated."""
    sizes = {"d": diameters, "m_n": (m_n,), "b": (b,)}
    return [
        Text(
            "{symbol} = {size} mm ({low} to {high} mm)",
            symbol=symbol,
            size=Amount(size * 1e3, form=".4g"),
            low=Amount(low * 1e3, form="g"),
            high=Amount(high * 1e3, form="g"),
        )
        for symbol, low, high in RANGES
        for size in sizes[symbol]
        if not low <= size <= high
    ]


# --- running in


@formula("v", "kinematics: circumferential speed at the reference circle")
def pitch_line_velocity(d: Metre, n: RevPerSecond) -> MetrePerSecond:
    return pi * d * abs(n)


@formula("y_α", Text("{run_in}: hardened and nitrided flanks, up to 3 µm", run_in=RUN_IN), unit="µm")
def run_in_hard(f: Metre) -> Metre:
    return smallest(0.075 * f, MOST_RUN_IN)


@formula(
    "y_α",
    Text("{run_in}: structural, quenched and tempered steel, pearlitic and bainitic iron", run_in=RUN_IN),
    unit="µm",
)
def run_in_steel(f: Metre, sigma_Hlim: Pascal) -> Metre:
    return 160 * MEGAPASCAL / sigma_Hlim * f


@formula("y_α", Text("{run_in}: grey and ferritic nodular iron", run_in=RUN_IN), unit="µm")
def run_in_iron(f: Metre) -> Metre:
    return 0.275 * f


@formula("y_β", Text("{run_in}: hardened and nitrided flanks, up to 6 µm", run_in=RUN_IN_BETA), unit="µm", names=F_BETA)
def run_in_beta_hard(F_betax: Metre) -> Metre:
    return smallest(0.15 * F_betax, MOST_RUN_IN_BETA)


@formula(
    "y_β",
    Text("{run_in}: structural, quenched and tempered steel, pearlitic and bainitic iron", run_in=RUN_IN_BETA),
    unit="µm",
    names=F_BETA,
)
def run_in_beta_steel(F_betax: Metre, sigma_Hlim: Pascal) -> Metre:
    """Never more than F_βx itself."""
    return smallest(320 * MEGAPASCAL / sigma_Hlim, 1.0) * F_betax


@formula("y_β", Text("{run_in}: grey and ferritic nodular iron", run_in=RUN_IN_BETA), unit="µm", names=F_BETA)
def run_in_beta_iron(F_betax: Metre) -> Metre:
    return 0.55 * F_betax


@formula("y", "ISO 6336-1: wheels of different material, the mean of both", unit="µm")
def mean_run_in(y_1: Metre, y_2: Metre) -> Metre:
    return (y_1 + y_2) / 2


def running_in(f: Metre, kind: str, sigma_Hlim: Pascal, v: MetrePerSecond) -> Metre:
    """y_α of one wheel (y_p, y_f): what running in takes off a deviation `f` of pitch or profile.

    `kind`: the class of ISO 6336-5 (Eh, IF, NT…, NV…, St, V, GTS, GGG, GG, …).  Above 5 and above 10 m/s the allowance
    of soft flanks grows no further than that of 80 and 40 µm."""
    if kind.startswith(HARD):
        return run_in_hard(f=f)
    f = _capped(f, v)
    return run_in_iron(f=f) if kind in SOFT_IRON else run_in_steel(f=f, sigma_Hlim=sigma_Hlim)


def running_in_beta(F_betax: Metre, kind: str, sigma_Hlim: Pascal, v: MetrePerSecond) -> Metre:
    """y_β of one wheel, likewise."""
    if kind.startswith(HARD):
        return run_in_beta_hard(F_betax=F_betax)
    F = _capped(F_betax, v)
    return run_in_beta_iron(F_betax=F) if kind in SOFT_IRON else run_in_beta_steel(F_betax=F, sigma_Hlim=sigma_Hlim)


def _capped(f: Metre, v: MetrePerSecond) -> Metre:
    return next((min(f, most) for speed, most in CAPS if v > speed), f)


# --- along the face width


@formula("F_m/b", Text("{clause_7}: mean load per face width", clause_7=CLAUSE_7), unit="N/mm")
def mean_load(w: NewtonPerMetre, K_V: Number) -> NewtonPerMetre:
    return w * K_V


@formula(
    "F_βx,min",
    Text("{clause_7}: smallest misalignment to reckon with", clause_7=CLAUSE_7),
    unit="µm",
    names=NAMES,
    meanings={"w_m": "Load per face width"},
)
def least_misalignment(w_m: NewtonPerMetre, f_Hbeta: Metre) -> Metre:
    return largest(LEAST_BEND * w_m, 0.5 * f_Hbeta)


@formula(
    "F_βx",
    Text("{clause_7}: misalignment before running in, contact pattern not proven", clause_7=CLAUSE_7),
    unit="µm",
    names={"F_min": "F_βx,min"},
    meanings={"f_sh": "Misalignment by deformation"},
)
def initial_misalignment(f_sh: Metre, f_ma: Metre, F_min: Metre) -> Metre:
    return largest(1.33 * f_sh + f_ma, F_min)


@formula("F_βy", Text("{clause_7}: misalignment after running in", clause_7=CLAUSE_7), unit="µm", names=NAMES)
def effective_misalignment(F_betax: Metre, y_beta: Metre) -> Metre:
    return F_betax - y_beta


@formula(
    "ξ_β",
    Text("{clause_7}: misalignment in terms of the deflection of the teeth, F_βy·c_γβ/(2·F_m/b)", clause_7=CLAUSE_7),
    names=NAMES,
    meanings={"w_m": "Load per face width"},
)
def relative_misalignment(F_betay: Metre, c_gamma_beta: Pascal, w_m: NewtonPerMetre) -> Number:
    return F_betay * c_gamma_beta / (2 * w_m)


@formula("K_Hβ", Text("{clause_7}: the whole face width touches", clause_7=CLAUSE_7), names={"xi": "ξ_β"})
def face_factor_whole(xi: Number) -> Number:
    return 1 + xi


@formula("K_Hβ", Text("{clause_7}: a part of the face width touches", clause_7=CLAUSE_7), names={"xi": "ξ_β"})
def face_factor_part(xi: Number) -> Number:
    return 2 * sqrt(xi)


@formula(
    "b_cal/b",
    Text("{clause_7}: share of the face width that touches", clause_7=CLAUSE_7),
    unit="%",
    names={"xi": "ξ_β"},
)
def contact_share(xi: Number) -> Number:
    return 1 / sqrt(largest(xi, 1.0))


@formula(
    "N_F",
    Text(
        "{clause_7}: exponent of the face load factor at the root, from the smaller b/h of both wheels, at least 3",
        clause_7=CLAUSE_7,
    ),
    names={"r": "(b/h)"},
)
def root_exponent(r: Number) -> Number:
    return r**2 / (1 + r + r**2)


@formula("b/h", Text("{clause_7}: face width over tooth height, at least 3", clause_7=CLAUSE_7))
def slenderness(b: Metre, d_a: Metre, d_f: Metre) -> Number:
    return largest(2 * b / (d_a - d_f), LEAST_SLENDER)


@formula("K_Fβ", Text("{clause_7}: at the root", clause_7=CLAUSE_7), names=NAMES)
def face_factor_root(K_Hbeta: Number, N_F: Number) -> Number:
    return power(K_Hbeta, N_F)


# --- between tooth pairs


@formula("q_α", Text("{clause_8}: deviation in terms of the deflection of the teeth", clause_8=CLAUSE_8), names=NAMES)
def relative_deviation(c_gamma_alpha: Pascal, f: Metre, y_alpha: Metre, w_m: NewtonPerMetre, K_Hbeta: Number) -> Number:
    """The larger of f_pb and f_fα counts; the load that decides is F_t·K_A·K_V·K_Hβ."""
    return c_gamma_alpha * (f - y_alpha) / (w_m * K_Hbeta)


@formula("K_α", Text("{clause_8}: transverse load factor before its limits, ε_γ up to 2", clause_8=CLAUSE_8))
def pair_factor(eps_gamma: Number, q_alpha: Number) -> Number:
    return eps_gamma / 2 * (0.9 + 0.4 * q_alpha)


@formula("K_α", Text("{clause_8}: transverse load factor before its limits, ε_γ above 2", clause_8=CLAUSE_8))
def pair_factor_high(eps_gamma: Number, q_alpha: Number) -> Number:
    return 0.9 + 0.4 * sqrt(2 * (eps_gamma - 1) / eps_gamma) * q_alpha


@formula("K_Hα,max", Text("{clause_8}: one pair carries all", clause_8=CLAUSE_8), names={"Z_eps": "Z_ε"})
def pair_limit_flank(eps_gamma: Number, eps_alpha: Number, Z_eps: Number) -> Number:
    return eps_gamma / (eps_alpha * Z_eps**2)


@formula("K_Fα,max", Text("{clause_8}: one pair carries all", clause_8=CLAUSE_8))
def pair_limit_root(eps_gamma: Number, eps_alpha: Number) -> Number:
    return eps_gamma / (0.25 * eps_alpha + 0.75)


@formula(
    "K_Hα", Text("{clause_8}: within its limits", clause_8=CLAUSE_8), names={"K_max": "K_Hα,max", "K_alpha": "K_α"}
)
def pair_factor_flank(K_alpha: Number, K_max: Number) -> Number:
    return largest(1.0, smallest(K_alpha, K_max))


@formula(
    "K_Fα", Text("{clause_8}: within its limits", clause_8=CLAUSE_8), names={"K_max": "K_Fα,max", "K_alpha": "K_α"}
)
def pair_factor_root(K_alpha: Number, K_max: Number) -> Number:
    return largest(1.0, smallest(K_alpha, K_max))


@formula("w", "ISO 6336-1: load per face width, F_t·K_A/b", unit="N/mm")
def line_load(F_t: Newton, K_A: Number, b: Metre) -> NewtonPerMetre:
    return F_t * K_A / b
