# SPDX-License-Identifier: Apache-2.0
"""What an accuracy grade lets the flanks of a wheel deviate, ISO 1328-1:2013, and what running in takes away again, ISO 6336-1.

The formulas hold for 5 ≤ z ≤ 1000, 5 mm ≤ d ≤ 15 m, 0.5 mm ≤ m_n ≤ 70 mm, 4 mm ≤ b ≤ 1.2 m, β ≤ 45° and grades 1 to 11; the
standard forbids to go on beyond.  ISO 6336-1:2006 cites the tables of 1995: they differ by a rounding step here and there.
"""

import math

from ...sheet.formula import formula
from ...sheet.functions import cos, pi, smallest, sqrt
from ...sheet.units import Metre, MetrePerSecond, Number, Pascal, Radian, RevPerSecond

ISO_1328 = "ISO 1328-1:2013, clause 5, compared with public code"
RUN_IN = "ISO 6336-1:2006, 8.3.5, the same in 2019, compared with public code"
RUN_IN_BETA = "ISO 6336-1:2006, 7.5.2.1, the same in 2019, compared with public code"
SLOPES = {"f_Hbeta1": "f_Hβ1", "f_Hbeta2": "f_Hβ2"}
F_BETA = {"F_betax": "F_βx"}
MILLIMETRE: Metre = 1e-3
MICROMETRE: Metre = 1e-6
MEGAPASCAL: Pascal = 1e6
MOST_RUN_IN: Metre = 3e-6  # of a base pitch, hardened flanks
MOST_RUN_IN_BETA: Metre = 6e-6  # of a helix, hardened flanks
CAPS = ((10.0, 40e-6), (5.0, 80e-6))  # above this speed [m/s] no larger deviation runs in [m]; twice that speed class, half of it
RANGES = (("d", 5e-3, 15.0), ("m_n", 0.5e-3, 70e-3), ("b", 4e-3, 1.2))
HARD = ("Eh", "IF", "NT", "NV")  # case, induction and flame hardened, nitrided, nitrocarburised
SOFT_IRON = ("GG", "GGG(ferr.)", "GGG (ferr.)")


@formula("f_pT", f"{ISO_1328}: single pitch, before rounding", unit="µm")
def single_pitch_tolerance(d: Metre, m_n: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.001 * d / MILLIMETRE + 0.4 * m_n / MILLIMETRE + 5) * 2 ** ((A - 5) / 2)


@formula("f_fαT", f"{ISO_1328}: form of the profile, before rounding", unit="µm")
def profile_form_tolerance(m_n: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.55 * m_n / MILLIMETRE + 5) * 2 ** ((A - 5) / 2)


@formula("f_HβT", f"{ISO_1328}: slope of the helix, before rounding", unit="µm")
def helix_slope_tolerance(d: Metre, b: Metre, A: Number) -> Metre:
    return MICROMETRE * (0.05 * sqrt(d / MILLIMETRE) + 0.35 * sqrt(b / MILLIMETRE) + 4) * 2 ** ((A - 5) / 2)


@formula("f", f"{ISO_1328}, 5.2.3", shows="rounded: above 10 µm to 1 µm, from 5 µm to 0.5 µm, below to 0.1 µm", unit="µm")
def rounded(f: Metre) -> Metre:
    """Halves go up."""
    um = f * 1e6
    parts = 1 if um > 10 else 2 if um >= 5 else 10
    return math.floor(um * parts + 0.5 + 1e-9) / (parts * 1e6)


@formula("f_pb", "ISO 6336-1, as generally published: transverse base pitch, from the single pitch", unit="µm")
def base_pitch_deviation(f_pT: Metre, alpha_t: Radian) -> Metre:
    return f_pT * cos(alpha_t)


@formula(
    "f_ma", "ISO 6336-1:2019, 7.5, as public code gives it: helix slopes of both wheels, no helix modification", unit="µm", names=SLOPES
)
def mesh_misalignment(f_Hbeta1: Metre, f_Hbeta2: Metre) -> Metre:
    return sqrt(f_Hbeta1**2 + f_Hbeta2**2)


def out_of_range(m_n: Metre, b: Metre, *diameters: Metre) -> list[str]:
    """Sizes for which ISO 1328-1 has no tolerance; the formulas are then extrapolated."""
    found = []
    for symbol, low, high in RANGES:
        for size in {"d": diameters, "m_n": (m_n,), "b": (b,)}[symbol]:
            if not low <= size <= high:
                found.append(f"{symbol} = {size * 1e3:.4g} mm ({low * 1e3:g} to {high * 1e3:g} mm)")
    return found


# --- running in ------------------------------------------------------------------------------------------------------------
@formula("v", "circumferential speed at the reference circle")
def pitch_line_velocity(d: Metre, n: RevPerSecond) -> MetrePerSecond:
    return pi * d * abs(n)


@formula("y_α", f"{RUN_IN}: hardened and nitrided flanks, up to 3 µm", unit="µm")
def run_in_hard(f: Metre) -> Metre:
    return smallest(0.075 * f, MOST_RUN_IN)


@formula("y_α", f"{RUN_IN}: structural, quenched and tempered steel, pearlitic and bainitic iron", unit="µm")
def run_in_steel(f: Metre, sigma_Hlim: Pascal) -> Metre:
    return 160 * MEGAPASCAL / sigma_Hlim * f


@formula("y_α", f"{RUN_IN}: grey and ferritic nodular iron", unit="µm")
def run_in_iron(f: Metre) -> Metre:
    return 0.275 * f


@formula("y_β", f"{RUN_IN_BETA}: hardened and nitrided flanks, up to 6 µm", unit="µm", names=F_BETA)
def run_in_beta_hard(F_betax: Metre) -> Metre:
    return smallest(0.15 * F_betax, MOST_RUN_IN_BETA)


@formula("y_β", f"{RUN_IN_BETA}: structural, quenched and tempered steel, pearlitic and bainitic iron", unit="µm", names=F_BETA)
def run_in_beta_steel(F_betax: Metre, sigma_Hlim: Pascal) -> Metre:
    """Never more than F_βx itself."""
    return smallest(320 * MEGAPASCAL / sigma_Hlim, 1.0) * F_betax


@formula("y_β", f"{RUN_IN_BETA}: grey and ferritic nodular iron", unit="µm", names=F_BETA)
def run_in_beta_iron(F_betax: Metre) -> Metre:
    return 0.55 * F_betax


@formula("y", "ISO 6336-1, as generally published: wheels of different material, the mean of both", unit="µm")
def mean_run_in(y_1: Metre, y_2: Metre) -> Metre:
    return (y_1 + y_2) / 2


def running_in(f: Metre, kind: str, sigma_Hlim: Pascal, v: MetrePerSecond) -> Metre:
    """y_α of one wheel (y_p, y_f): what running in takes off a deviation `f` of pitch or profile.

    `kind`: the class of ISO 6336-5 (Eh, IF, NT…, NV…, St, V, GTS, GGG, GG, …).  Above 5 and above 10 m/s the allowance of soft flanks
    grows no further than that of 80 and 40 µm.
    """
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
    for speed, most in CAPS:
        if v > speed:
            return min(f, most)
    return f
