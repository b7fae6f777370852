# SPDX-License-Identifier: Apache-2.0
"""Strength of flank and tooth root: load cycles and life factors, pitting by ISO 6336-2, breakage by ISO 6336-3.

Of the flank: the film, the curvature at single contact, work hardening, the safety.

Every length is in the transverse section; "hard" and "soft" are the two flanks of a mesh.  The film factors are those
of the softer material.  The size factor Z_X is 1: so for through-hardened teeth, and for surface-hardened ones whose
case is deep enough for their size."""

from itertools import pairwise

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import largest, ln, pi, power, smallest, sqrt, tan
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, MetrePerSecond, Number, Pascal, Radian, RevPerSecond, Second, SquareMetrePerSecond
from .classes import StrengthClass

# --- load cycles and the life factors Z_NT (flank) and Y_NT (root) of ISO 6336-2 and -3
# The curves are straight lines between knees in log–log scale.  To the left of the first knee the strength is static
# and constant.  Past the last knee but one the standard leaves a range: 0.85 at 10¹⁰ cycles, up to 1 with the best
# material, making, lubrication and experience; the curves here take 0.85.  Where no life is given the factor is 1: the
# strength at the knee (5·10⁷ or 2·10⁶ on the flank, 3·10⁶ at the root). The lubricant, surface and notch factors stay
# those of the long life on the whole curve; the standard drops them towards static strength.

FLANK = Text("ISO 6336-2:2006 and 2019, Table 2")
ROOT = Text("ISO 6336-3:2006 and 2019, Table 1")
LONGEST = 1e10  # cycles: the end of the tables

Knees = tuple[tuple[float, float], ...]  # (cycles, factor), rising cycles
STEEL: Knees = ((1e5, 1.6), (5e7, 1.0), (LONGEST, 0.85))
NITRIDED: Knees = ((1e5, 1.3), (2e6, 1.0), (LONGEST, 0.85))
NITROCARBURISED: Knees = ((1e5, 1.1), (2e6, 1.0), (LONGEST, 0.85))
FLANK_CURVES = {
    "GG": NITRIDED,
    "GGG(ferr.)": NITRIDED,
    "NT(nitr.)": NITRIDED,
    "NV(nitr.)": NITRIDED,
    "NV(nitrocar.)": NITROCARBURISED,
}
ROOT_THROUGH: Knees = ((1e4, 2.5), (3e6, 1.0), (LONGEST, 0.85))  # St, V, GTS, GGG(perl.)
ROOT_HARDENED: Knees = ((1e3, 2.5), (3e6, 1.0), (LONGEST, 0.85))
ROOT_NITRIDED: Knees = ((1e3, 1.6), (3e6, 1.0), (LONGEST, 0.85))
ROOT_NITROCARBURISED: Knees = ((1e3, 1.1), (3e6, 1.0), (LONGEST, 0.85))
ROOT_CURVES = {
    "Eh": ROOT_HARDENED,
    "IF": ROOT_HARDENED,
    "GG": ROOT_NITRIDED,
    "GGG(ferr.)": ROOT_NITRIDED,
    "NT(nitr.)": ROOT_NITRIDED,
    "NV(nitr.)": ROOT_NITRIDED,
    "NV(nitrocar.)": ROOT_NITROCARBURISED,
}


@formula("N_L", "ISO 6336-6: load cycles of one flank; n_c: loaded contacts in a turn", names={"c": "n_c"})
def load_cycles(n: RevPerSecond, L_h: Second, c: Number) -> Number:
    return abs(n) * L_h * c


@formula(
    "p_N",
    "mathematics: straight line between two knees of the life curve, log–log",
    meanings={
        "Y_1": "Life factor at the first knee",
        "Y_2": "Life factor at the second knee",
        "N_1": "Load cycles at the first knee",
        "N_2": "Load cycles at the second knee",
    },
)
def life_exponent(Y_1: Number, Y_2: Number, N_1: Number, N_2: Number) -> Number:
    return ln(Y_1 / Y_2) / ln(N_2 / N_1)


@formula(
    "Z_NT",
    Text("{flank}: life factor, contact; from the knee Z_1 at N_1", flank=FLANK),
    names={"p": "p_N"},
    meanings={
        "Z_1": "Life factor at the knee of the life curve",
        "N_1": "Load cycles at the knee of the life curve",
        "N_L": "Load cycles",
    },
)
def flank_life_factor(Z_1: Number, N_1: Number, N_L: Number, p: Number) -> Number:
    return Z_1 * power(N_1 / N_L, p)


@formula(
    "Y_NT",
    Text("{root}: life factor, root; from the knee Y_1 at N_1", root=ROOT),
    names={"p": "p_N"},
    meanings={
        "Y_1": "Life factor at the knee of the life curve",
        "N_1": "Load cycles at the knee of the life curve",
        "N_L": "Load cycles",
    },
)
def root_life_factor(Y_1: Number, N_1: Number, N_L: Number, p: Number) -> Number:
    return Y_1 * power(N_1 / N_L, p)


@record
class Segment:
    """The line of a curve that holds at a number of cycles: from (N_1, Y_1), falling with the power p."""

    N_1: Number
    Y_1: Number
    p: Number


def contacts_per_turn(driven: int, drives: int) -> int:
    """Loaded contacts of the flank that sees most of them, and of the root, in one turn.

    As a driven wheel one flank is loaded, as a driver the other: an idler loads each flank once a turn (and its root
    once each way), a driver of two wheels the same flank twice."""
    return max(driven, drives, 1)


def flank_knees(kind: str) -> Knees:
    return FLANK_CURVES.get(kind, STEEL)


def root_knees(kind: str) -> Knees:
    return ROOT_CURVES.get(kind, ROOT_THROUGH)


def flank_life(kind: str, N_L: Number | None = None) -> Number:
    """Z_NT; without a number of cycles that of the endurance limit, 1."""
    knees = flank_knees(kind)
    N_L = endurance(knees) if N_L is None else N_L
    line = segment(knees, N_L)
    return flank_life_factor(Z_1=line.Y_1, N_1=line.N_1, N_L=N_L, p=line.p)


def root_life(kind: str, N_L: Number | None = None) -> Number:
    """Y_NT; without a number of cycles that of the endurance limit, 1."""
    knees = root_knees(kind)
    N_L = endurance(knees) if N_L is None else N_L
    line = segment(knees, N_L)
    return root_life_factor(Y_1=line.Y_1, N_1=line.N_1, N_L=N_L, p=line.p)


def endurance(knees: Knees) -> Number:
    """The cycles at which the factor is 1."""
    return next(N for N, Y in knees if Y == 1.0)


def segment(knees: Knees, N_L: Number) -> Segment:
    """Past the last knee the last line goes on: the tables end at 10¹⁰ cycles."""
    if N_L <= knees[0][0]:
        return Segment(*knees[0], 0.0)
    i = next((i for i, (N, _) in enumerate(knees) if N_L < N), len(knees) - 1)
    (N_1, Y_1), (N_2, Y_2) = knees[i - 1], knees[i]
    return Segment(N_1, Y_1, life_exponent(Y_1=Y_1, Y_2=Y_2, N_1=N_1, N_2=N_2))


# --- strength of the flank, ISO 6336-2

IACS_FLANK = Text("ISO 6336-2:2006 and 2019 as in IACS UR M56 (Rev. 4)")
SOFT: Pascal = 850e6  # σ_Hlim between which the film factors change
SPAN: Pascal = 350e6
RADIUS: Metre = 10e-3  # of relative curvature, of the test gears
ROUGHNESS: Metre = 3e-6  # Rz of the test gears
THICK: SquareMetrePerSecond = 134e-6
FAST: MetrePerSecond = 32.0
PER_SECOND: MetrePerSecond = 1.0
CENTISTOKE: SquareMetrePerSecond = 1e-6


# --- curvature at the inner point of single contact


@formula(
    "tan α_i",
    Text(
        "{iacs}: curvature over d_b/2 where the wheel's inner single contact is, ε base pitches from the tip; not "
        "positive: inside the base circle",
        iacs=IACS_FLANK,
    ),
    meanings={"eps": "Base pitches from the tip"},
)
def inner_curvature(d_a: Metre, d_b: Metre, eps: Number, z: Number) -> Number:
    return sqrt(d_a**2 / d_b**2 - 1) - eps * 2 * pi / z


@formula(
    "M_BD",
    Text(
        "{iacs}: curvature at the wheel's inner point of single contact against the pitch point; index m: mate",
        iacs=IACS_FLANK,
    ),
    names={"t": "tan α_i", "t_m": "tan α_im"},
)
def curvature_ratio(alpha_wt: Radian, t: Number, t_m: Number) -> Number:
    return tan(alpha_wt) / sqrt(t * t_m)


@formula(
    "Z_BD",
    Text(
        "{iacs}: single pair factor (Z_B of the smaller, Z_D of the larger wheel), straight from M_BD at ε_β = 0 "
        "to 1 at ε_β ≥ 1, not below 1",
        iacs=IACS_FLANK,
    ),
    names={"M": "M_BD"},
)
def single_pair_factor(M: Number, eps_beta: Number) -> Number:
    return largest(M - smallest(eps_beta, 1.0) * (M - 1), 1.0)


# --- film


@formula("C_ZL", Text("{iacs}: 0.83 up to 850 MPa, 0.91 from 1200 MPa", iacs=IACS_FLANK), names={"sigma": "σ_Hlim"})
def lubricant_coefficient(sigma: Pascal) -> Number:
    return 0.83 + 0.08 * smallest(largest((sigma - SOFT) / SPAN, 0.0), 1.0)


@formula(
    "Z_L",
    Text("{iacs}: lubricant factor, mineral oil; ν_40: at 40 °C", iacs=IACS_FLANK),
    names={"nu_40": "ν_40"},
    meanings={"nu_40": "Kinematic viscosity at 40 °C"},
)
def lubricant_factor(C_ZL: Number, nu_40: SquareMetrePerSecond) -> Number:
    return C_ZL + 4 * (1 - C_ZL) / (1.2 + THICK / nu_40) ** 2


@formula("C_Zv", IACS_FLANK)
def velocity_coefficient(C_ZL: Number) -> Number:
    return C_ZL + 0.02


@formula("Z_v", Text("{iacs}: velocity factor; v: at the pitch circle", iacs=IACS_FLANK))
def velocity_factor(C_Zv: Number, v: MetrePerSecond) -> Number:
    return C_Zv + 2 * (1 - C_Zv) / sqrt(0.8 + FAST / v)


@formula(
    "ρ_red",
    Text("{iacs}: radius of relative curvature at the pitch point; ρ = d_b/2·tan α_wt", iacs=IACS_FLANK),
    unit="mm",
)
def relative_radius(d_b1: Metre, d_b2: Metre, alpha_wt: Radian) -> Metre:
    return d_b1 * d_b2 / (d_b1 + d_b2) * tan(alpha_wt) / 2


@formula(
    "Rz_10",
    Text("{iacs}: mean roughness, brought to 10 mm of curvature", iacs=IACS_FLANK),
    unit="µm",
    names={"rho": "ρ_red"},
)
def relative_roughness(Rz_1: Metre, Rz_2: Metre, rho: Metre) -> Metre:
    return (Rz_1 + Rz_2) / 2 * power(RADIUS / rho, 1 / 3)


@formula("C_ZR", Text("{iacs}: 0.15 up to 850 MPa, 0.08 from 1200 MPa", iacs=IACS_FLANK), names={"sigma": "σ_Hlim"})
def roughness_coefficient(sigma: Pascal) -> Number:
    return 0.15 - 0.07 * smallest(largest((sigma - SOFT) / SPAN, 0.0), 1.0)


@formula("Z_R", Text("{iacs}: roughness factor, 1 at 3 µm", iacs=IACS_FLANK))
def roughness_factor(Rz_10: Metre, C_ZR: Number) -> Number:
    return power(ROUGHNESS / Rz_10, C_ZR)


# --- work hardening


@formula(
    "Rz_H",
    Text("{iacs}: roughness of the hard flank as it works on the soft one", iacs=IACS_FLANK),
    unit="µm",
    names={"nu_40": "ν_40", "rho": "ρ_red"},
)
def equivalent_roughness(
    Rz_hard: Metre, Rz_soft: Metre, rho: Metre, v: MetrePerSecond, nu_40: SquareMetrePerSecond
) -> Metre:
    return (
        Rz_hard
        * power(RADIUS / rho, 0.33)
        * power(Rz_hard / Rz_soft, 0.66)
        / power(v / PER_SECOND * nu_40 / CENTISTOKE / 1500, 0.33)
    )


@formula(
    "Z_W",
    Text(
        "{iacs}: work hardening of a soft flank by a surface-hardened one; HBW counts from 130, Rz_H from 3 µm; not "
        "below 1",
        iacs=IACS_FLANK,
    ),
)
def work_hardening_by_hard(HBW: Number, Rz_H: Metre) -> Number:
    """The ends at 470 HBW and 16 µm make no difference: past them it is 1."""
    return largest((1.2 - (largest(HBW, 130.0) - 130) / 1700) * (ROUGHNESS / largest(Rz_H, ROUGHNESS)) ** 0.15, 1.0)


@formula(
    "Z_W",
    Text(
        "{iacs}: larger wheel, both through-hardened, pinion 1.2 times as hard or more; the ratio counts up to 1.7, "
        "u up to 20",
        iacs=IACS_FLANK,
    ),
)
def work_hardening_through(HBW_1: Number, HBW_2: Number, u: Number) -> Number:
    return 1 + (0.00898 * smallest(HBW_1 / HBW_2, 1.7) - 0.00829) * (smallest(u, 20.0) - 1)


# --- strength


@formula("σ_H", "ISO 6336-2:2006: contact stress of one wheel; K_H = K_A·K_v·K_Hβ·K_Hα", unit="MPa")
def contact_stress_of_wheel(Z_BD: Number, sigma_H0: Pascal, K_H: Number) -> Pascal:
    return Z_BD * sigma_H0 * sqrt(K_H)


@formula("σ_HG", "ISO 6336-2:2006: pitting stress limit; Z_X = 1", unit="MPa")
def pitting_limit(sigma_Hlim: Pascal, Z_NT: Number, Z_L: Number, Z_v: Number, Z_R: Number, Z_W: Number) -> Pascal:
    return sigma_Hlim * Z_NT * Z_L * Z_v * Z_R * Z_W


@formula(
    "σ_HP",
    "ISO 6336-2:2006: permissible contact stress",
    unit="MPa",
    meanings={"S_Hmin": "Least safety against pitting"},
)
def permissible_contact_stress(sigma_HG: Pascal, S_Hmin: Number) -> Pascal:
    return sigma_HG / S_Hmin


@formula("S_H", "ISO 6336-2:2006: safety against pitting, on stress")
def contact_safety(sigma_HG: Pascal, sigma_H: Pascal) -> Number:
    return sigma_HG / sigma_H


@formula("S_H²", "elasticity, contact stress grows with the root of the load: safety on load")
def contact_safety_on_load(S_H: Number) -> Number:
    return S_H**2


@record
class ContactStrength:
    """One wheel of a mesh.  S_H is None where there is no load."""

    Z_BD: Number
    Z_NT: Number
    Z_W: Number
    sigma_H: Pascal
    sigma_HG: Pascal
    sigma_HP: Pascal
    S_H: Number | None


@formula("Z_W", Text("{iacs}: no hard flank works on a softer steel one", iacs=IACS_FLANK), shows="1")
def no_work_hardening() -> Number:
    return 1.0


def work_hardening(
    strength: StrengthClass,
    mate: StrengthClass,
    Rz: Metre,
    Rz_m: Metre,
    rho_red: Metre,
    v: MetrePerSecond,
    nu_40: SquareMetrePerSecond,
    u: Number,
) -> Number:
    """Z_W of a wheel; `u`: its teeth over those of its mate.  1 where no hard flank works on a softer steel one."""
    if strength.through_hardened and mate.surface_hardened:
        return work_hardening_by_hard(
            HBW=strength.brinell, Rz_H=equivalent_roughness(Rz_hard=Rz_m, Rz_soft=Rz, rho=rho_red, v=v, nu_40=nu_40)
        )
    if strength.through_hardened and mate.through_hardened and u > 1 and mate.brinell >= 1.2 * strength.brinell:
        return work_hardening_through(HBW_1=mate.brinell, HBW_2=strength.brinell, u=u)
    return no_work_hardening()


# --- strength of the tooth root, ISO 6336-3: rim, notch, surface, size, reversed load, the safety

ISO = Text("ISO 6336-3:2006 and 2019")
IACS_ROOT = Text("ISO 6336-3:2006 and 2019 as in IACS UR M56 (Rev. 4)")
MILLIMETRE: Metre = 1e-3
MICRON: Metre = 1e-6
MEGAPASCAL = 1e6
TEST_GEAR = 2.0  # Y_ST: stress correction of the gears by which σ_Flim was found
RIM_LEAST, RIM_FULL = 0.5, 1.2  # of s_R/h_t
ROUGHEST_ROOT: Metre = 40e-6  # Rz of the root up to which Y_RrelT was found

# Slip layer by proof stress (MPa → mm), ISO 6336-3, Table 3: St from memory and public code, the others in IACS UR M56
# too.
SLIP_ST = ((300.0, 0.0833), (400.0, 0.0445))
SLIP_V = ((500.0, 0.0281), (600.0, 0.0194), (800.0, 0.0064), (1000.0, 0.0014))
HARDENED = ("V", "GTS", "GGG(perl.)", "Eh", "IF")  # groups of Y_RrelT
IRON = ("GG", "GGG(ferr.)")
SIZE = dict.fromkeys(("St", "V", "GTS", "GGG(perl.)"), (1.03, 0.006, 0.85))
SIZE |= dict.fromkeys(IRON, (1.075, 0.015, 0.70))
SIZE_HARDENED = (1.05, 0.010, 0.80)  # Eh, IF and the nitrided
LOADING = {"pulsating": 1.0, "reversed": 0.7}


# --- the body: factors of the stress


@formula("Y_B", Text("{iacs}: rim thickness factor of external teeth, 0.5 < s_R/h_t < 1.2", iacs=IACS_ROOT))
def thin_rim_factor(h_t: Metre, s_R: Metre) -> Number:
    return 1.6 * ln(2.242 * h_t / s_R)


@formula(
    "Y_DT",
    Text("{iacs}: deep tooth factor of accuracy grades up to 4; 1 up to ε_αn = 2.05, not below 0.7", iacs=IACS_ROOT),
    names={"eps_alphan": "ε_αn"},
)
def deep_tooth(eps_alphan: Number) -> Number:
    return largest(smallest(2.366 - 0.666 * eps_alphan, 1.0), 0.7)


@formula("σ_F", "ISO 6336-3:2006: tooth root stress; K_F = K_A·K_v·K_Fβ·K_Fα", unit="MPa")
def root_stress_of_wheel(sigma_F0: Pascal, Y_B: Number, Y_DT: Number, K_F: Number) -> Pascal:
    return sigma_F0 * Y_B * Y_DT * K_F


# --- the material: factors of the strength


@formula(
    "ρ'",
    Text("{iso}: slip layer, Table 3 by proof stress", iso=ISO),
    unit="mm",
    shows="straight line between the rows, held at both ends",
)
def slip_layer(R_p: Pascal, structural: Number) -> Metre:
    """`structural`: 1 for St, 0 for V, GTS and GGG(perl.)."""
    rows = SLIP_ST if structural else SLIP_V
    R = R_p / MEGAPASCAL
    if R <= rows[0][0]:
        return rows[0][1] * 1e-3
    for (low, a), (high, b) in pairwise(rows):
        if R <= high:
            return (a + (b - a) * (R - low) / (high - low)) * 1e-3
    return rows[-1][1] * 1e-3


@formula(
    "Y_δrelT",
    Text("{iacs}: relative notch sensitivity; the test gear has q_s = 2.5", iacs=IACS_ROOT),
    names={"rho": "ρ'"},
    meanings={"rho": "Thickness of the slip layer"},
)
def notch_sensitivity(rho: Metre, q_s: Number) -> Number:
    return (1 + sqrt(0.2 * rho / MILLIMETRE * (1 + 2 * q_s))) / (1 + sqrt(1.2 * rho / MILLIMETRE))


@formula(
    "Y_RrelT",
    Text("{iacs}: relative surface factor, hardened; Rz of the root from 1 to 40 µm, 1 at 10 µm", iacs=IACS_ROOT),
)
def surface_hardened(Rz_F: Metre) -> Number:
    return 1.674 - 0.529 * power(Rz_F / MICRON + 1, 0.1)


@formula(
    "Y_RrelT",
    Text(
        "{iacs}: relative surface factor, structural steel; Rz of the root from 1 to 40 µm, 1 at 10 µm", iacs=IACS_ROOT
    ),
)
def surface_structural(Rz_F: Metre) -> Number:
    return 5.306 - 4.203 * power(Rz_F / MICRON + 1, 0.01)


@formula(
    "Y_RrelT",
    Text(
        "{iacs}: relative surface factor, nitrided (iron: {iso}); Rz of the root from 1 to 40 µm",
        iacs=IACS_ROOT,
        iso=ISO,
    ),
)
def surface_nitrided(Rz_F: Metre) -> Number:
    """At 10 µm it gives 0.994: so are its constants printed; older public texts have the exponent 1/200, which gives
    1."""
    return 4.299 - 3.259 * power(Rz_F / MICRON + 1, 0.0058)


@formula(
    "Y_RrelT",
    Text("{iacs}: relative surface factor, Rz of the root below 1 µm", iacs=IACS_ROOT),
    shows="1.12 hardened, 1.07 structural steel, 1.025 others",
)
def surface_smooth(kind: str) -> Number:
    return (1.12 if kind in HARDENED else 1.07 if kind == "St" else 1.025) * 1.0


@formula(
    "Y_X",
    Text("{iacs}: size factor, 1 up to m_n = 5 mm (iron: {iso})", iacs=IACS_ROOT, iso=ISO),
    names={"Y": "Y_min", "a": "a_X", "b": "b_X"},
    meanings={
        "Y": "Smallest size factor",
        "a": "Constant of the size factor",
        "b": "Slope of the size factor over the module",
    },
)
def size_factor(a: Number, b: Number, m_n: Metre, Y: Number) -> Number:
    return largest(smallest(a - b * m_n / MILLIMETRE, 1.0), Y)


@formula("Y_M", "IACS UR M56 (Rev. 4), design factor; idlers also ISO 6336-3", shows="1 pulsating, 0.7 reversed")
def mean_stress_factor(loading: str) -> Number:
    return LOADING[loading] * 1.0


@formula(
    "σ_FG",
    "ISO 6336-3:2006: tooth root stress limit; Y_M for reversed load",
    unit="MPa",
    names={"Y_drelT": "Y_δrelT"},
    meanings={"Y_ST": "Stress correction factor of the test gear"},
)
def root_limit(
    sigma_Flim: Pascal, Y_ST: Number, Y_NT: Number, Y_drelT: Number, Y_RrelT: Number, Y_X: Number, Y_M: Number
) -> Pascal:
    return sigma_Flim * Y_ST * Y_NT * Y_drelT * Y_RrelT * Y_X * Y_M


@formula(
    "σ_FP",
    "ISO 6336-3:2006: permissible root stress",
    unit="MPa",
    meanings={"S_Fmin": "Least safety against tooth breakage"},
)
def permissible_root_stress(sigma_FG: Pascal, S_Fmin: Number) -> Pascal:
    return sigma_FG / S_Fmin


@formula("S_F", "ISO 6336-3:2006: safety against tooth breakage")
def bending_safety(sigma_FG: Pascal, sigma_F: Pascal) -> Number:
    return sigma_FG / sigma_F


@record
class RootStrength:
    """One wheel in one mesh.  S_F is None where there is no load."""

    Y_B: Number
    Y_DT: Number
    Y_NT: Number
    Y_drelT: Number
    Y_RrelT: Number
    Y_X: Number
    Y_M: Number
    sigma_F: Pascal
    sigma_FG: Pascal
    sigma_FP: Pascal
    S_F: Number | None


@formula("Y_B", Text("{iacs}: a solid body, or a rim of 1.2 tooth depths or more", iacs=IACS_ROOT), shows="1")
def solid_rim() -> Number:
    return 1.0


@formula("Y_DT", Text("{iacs}: accuracy grades above 4", iacs=IACS_ROOT), shows="1")
def usual_tooth() -> Number:
    return 1.0


def rim_of(d_f: Metre, bore: Metre | None, rim: Metre | None) -> Metre | None:
    """What carries the teeth: the rim that is given, else what the bore leaves below the root; None: a solid body."""
    return rim if rim is not None or bore is None else (d_f - bore) / 2


def rim_factor(wheel: str, h_t: Metre, s_R: Metre | None) -> Number:
    """Y_B; `h_t`: tooth depth.  No rim given: a solid body, 1.  A rim of half the tooth depth or less is refused."""
    if s_R is None or s_R >= RIM_FULL * h_t:
        return solid_rim()
    if s_R <= RIM_LEAST * h_t:
        raise NoSolution(
            Text(
                "gears.wheels.{wheel}.rim_thickness_mm (or what its bore leaves) = {s_r}: rim factor Y_B",
                wheel=wheel,
                s_r=Amount(s_R * 1000.0, form=".4g"),
            ),
            Text("ISO 6336-3 ends at half the tooth depth"),
            Text(
                "give it more than {rim_least} mm; from {rim_full} mm on the rim counts as solid",
                rim_least=Amount(RIM_LEAST * h_t * 1000.0, form=".4g"),
                rim_full=Amount(RIM_FULL * h_t * 1000.0, form=".4g"),
            ),
        )
    return thin_rim_factor(h_t=h_t, s_R=s_R)


def deep_tooth_factor(grade: int, eps_alphan: Number) -> Number:
    """Y_DT: only precise teeth (ISO 1328-1 grade 4 or better) of high contact ratio share the load."""
    return deep_tooth(eps_alphan=eps_alphan) if grade <= 4 else usual_tooth()


def loading_of(driven: int, drives: int, reverses: bool = False) -> str:
    """How a wheel's root is loaded: reversed where it is driven by one and drives another, or where the torque changes
    its sign."""
    return "reversed" if (driven and drives) or reverses else "pulsating"


def surface_factor(kind: str, Rz_F: Metre) -> Number:
    """Y_RrelT; past 40 µm the lines go on, which a check says."""
    if Rz_F < MICRON:
        return surface_smooth(kind=kind)
    if kind in HARDENED:
        return surface_hardened(Rz_F=Rz_F)
    return surface_structural(Rz_F=Rz_F) if kind == "St" else surface_nitrided(Rz_F=Rz_F)
