# SPDX-License-Identifier: Apache-2.0
"""Strength of the tooth root, ISO 6336-3: rim, notch, surface, size, reversed load, the safety."""

from itertools import pairwise

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import largest, ln, power, smallest, sqrt
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Number, Pascal
from .classes import StrengthClass
from .life import root_life

ISO = Text("ISO 6336-3:2006 and 2019")
IACS = Text("ISO 6336-3:2006 and 2019 as in IACS UR M56 (Rev. 4)")
MILLIMETRE: Metre = 1e-3
MICRON: Metre = 1e-6
MEGAPASCAL = 1e6
TEST_GEAR = 2.0  # Y_ST: stress correction of the gears by which σ_Flim was found
RIM_LEAST, RIM_FULL = 0.5, 1.2  # of s_R/h_t
ROUGHEST: Metre = 40e-6  # Rz of the root up to which Y_RrelT was found

# Slip layer by proof stress (MPa → mm), ISO 6336-3, Table 3: St from memory and public code, the others in IACS UR M56 too.
SLIP_ST = ((300.0, 0.0833), (400.0, 0.0445))
SLIP_V = ((500.0, 0.0281), (600.0, 0.0194), (800.0, 0.0064), (1000.0, 0.0014))
HARDENED = ("V", "GTS", "GGG(perl.)", "Eh", "IF")  # groups of Y_RrelT
IRON = ("GG", "GGG(ferr.)")
SIZE = {"St": (1.03, 0.006, 0.85), "V": (1.03, 0.006, 0.85), "GTS": (1.03, 0.006, 0.85), "GGG(perl.)": (1.03, 0.006, 0.85)}
SIZE |= dict.fromkeys(IRON, (1.075, 0.015, 0.70))
SIZE_HARDENED = (1.05, 0.010, 0.80)  # Eh, IF and the nitrided
LOADING = {"pulsating": 1.0, "reversed": 0.7}


# --- the body: factors of the stress -----------------------------------------------------------------------------------------
@formula("Y_B", Text("{iacs}: rim thickness factor of external teeth, 0.5 < s_R/h_t < 1.2", iacs=IACS))
def thin_rim_factor(h_t: Metre, s_R: Metre) -> Number:
    return 1.6 * ln(2.242 * h_t / s_R)


@formula("Y_DT", Text("{iacs}: deep tooth factor of accuracy grades up to 4, 2.05 < ε_αn; not below 0.7", iacs=IACS),
    names={"eps_alphan": "ε_αn"})  # fmt: skip
def deep_tooth(eps_alphan: Number) -> Number:
    return largest(smallest(2.366 - 0.666 * eps_alphan, 1.0), 0.7)


@formula("σ_F", "ISO 6336-3:2006: tooth root stress; K_F = K_A·K_v·K_Fβ·K_Fα", unit="MPa")
def root_stress_of_wheel(sigma_F0: Pascal, Y_B: Number, Y_DT: Number, K_F: Number) -> Pascal:
    return sigma_F0 * Y_B * Y_DT * K_F


# --- the material: factors of the strength -------------------------------------------------------------------------------------
@formula(
    "ρ'", Text("{iso}: slip layer, Table 3 by proof stress", iso=ISO), unit="mm", shows="straight line between the rows, held at both ends"
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


@formula("Y_δrelT", Text("{iacs}: relative notch sensitivity; the test gear has q_s = 2.5", iacs=IACS), names={"rho": "ρ'"})
def notch_sensitivity(rho: Metre, q_s: Number) -> Number:
    return (1 + sqrt(0.2 * rho / MILLIMETRE * (1 + 2 * q_s))) / (1 + sqrt(1.2 * rho / MILLIMETRE))


@formula("Y_RrelT", Text("{iacs}: relative surface factor, hardened; Rz of the root from 1 to 40 µm, 1 at 10 µm", iacs=IACS))
def surface_hardened(Rz_F: Metre) -> Number:
    return 1.674 - 0.529 * power(Rz_F / MICRON + 1, 0.1)


@formula("Y_RrelT", Text("{iacs}: relative surface factor, structural steel; Rz of the root from 1 to 40 µm, 1 at 10 µm", iacs=IACS))
def surface_structural(Rz_F: Metre) -> Number:
    return 5.306 - 4.203 * power(Rz_F / MICRON + 1, 0.01)


@formula("Y_RrelT", Text("{iacs}: relative surface factor, nitrided (iron: {iso}); Rz of the root from 1 to 40 µm", iacs=IACS, iso=ISO))
def surface_nitrided(Rz_F: Metre) -> Number:
    """At 10 µm it gives 0.994: so are its constants printed; older public texts have the exponent 1/200, which gives 1."""
    return 4.299 - 3.259 * power(Rz_F / MICRON + 1, 0.0058)


@formula("Y_RrelT", Text("{iacs}: relative surface factor, Rz of the root below 1 µm", iacs=IACS),
    shows="1.12 hardened, 1.07 structural steel, 1.025 others")  # fmt: skip
def surface_smooth(kind: str) -> Number:
    return (1.12 if kind in HARDENED else 1.07 if kind == "St" else 1.025) * 1.0


@formula(
    "Y_X", Text("{iacs}: size factor, 1 up to m_n = 5 mm (iron: {iso})", iacs=IACS, iso=ISO), names={"Y": "Y_min", "a": "a_X", "b": "b_X"}
)
def size_factor(a: Number, b: Number, m_n: Metre, Y: Number) -> Number:
    return largest(smallest(a - b * m_n / MILLIMETRE, 1.0), Y)


@formula("Y_M", "IACS UR M56 (Rev. 4), design factor; idlers also ISO 6336-3", shows="1 pulsating, 0.7 reversed")
def mean_stress_factor(loading: str) -> Number:
    return LOADING[loading] * 1.0


@formula("σ_FG", "ISO 6336-3:2006: tooth root stress limit; Y_M for reversed load", unit="MPa",
    names={"Y_drelT": "Y_δrelT"})  # fmt: skip
def root_limit(sigma_Flim: Pascal, Y_ST: Number, Y_NT: Number, Y_drelT: Number, Y_RrelT: Number, Y_X: Number, Y_M: Number) -> Pascal:
    return sigma_Flim * Y_ST * Y_NT * Y_drelT * Y_RrelT * Y_X * Y_M


@formula("σ_FP", "ISO 6336-3:2006: permissible root stress", unit="MPa")
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


@formula("Y_B", Text("{iacs}: a solid body, or a rim of 1.2 tooth depths or more", iacs=IACS), shows="1")
def solid_rim() -> Number:
    return 1.0


@formula("Y_DT", Text("{iacs}: accuracy grades above 4, or ε_αn up to 2.05", iacs=IACS), shows="1")
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
            Text("gears.wheels.{wheel}.rim_thickness_mm (or what its bore leaves) = {s_r}: rim factor Y_B", wheel=wheel,
                s_r=Amount(s_R * 1000.0, form=".4g")),
            Text("ISO 6336-3 ends at half the tooth depth"),
            Text("give it more than {rim_least} mm; from {rim_full} mm on the rim counts as solid",
                rim_least=Amount(RIM_LEAST * h_t * 1000.0, form=".4g"), rim_full=Amount(RIM_FULL * h_t * 1000.0, form=".4g")),
        )  # fmt: skip
    return thin_rim_factor(h_t=h_t, s_R=s_R)


def deep_tooth_factor(grade: int, eps_alphan: Number) -> Number:
    """Y_DT: only precise teeth (ISO 1328-1 grade 4 or better) of high contact ratio share the load."""
    return deep_tooth(eps_alphan=eps_alphan) if grade <= 4 and eps_alphan > 2.05 else usual_tooth()


def loading_of(driven: int, drives: int, reverses: bool = False) -> str:
    """How a wheel's root is loaded: reversed where it is driven by one and drives another, or where the torque changes its sign."""
    return "reversed" if (driven and drives) or reverses else "pulsating"


def surface_factor(kind: str, Rz_F: Metre) -> Number:
    """Y_RrelT; past 40 µm the lines go on, which a check says."""
    if Rz_F < MICRON:
        return surface_smooth(kind=kind)
    if kind in HARDENED:
        return surface_hardened(Rz_F=Rz_F)
    return surface_structural(Rz_F=Rz_F) if kind == "St" else surface_nitrided(Rz_F=Rz_F)


def root_strength(
    own: StrengthClass, *, sigma_F0: Pascal, K_F: Number, Y_B: Number, Y_DT: Number, q_s: Number, Rz_F: Metre, m_n: Metre, loading: str,
    cycles: Number | None, S_Fmin: Number,
) -> RootStrength:  # fmt: skip
    """Stress and strength of one root.  `loading`: pulsating or reversed; `cycles` None: the endurance limit."""
    rho = own.slip_layer if own.proof_stress is None else slip_layer(R_p=own.proof_stress, structural=float(own.kind == "St"))
    assert rho is not None  # every row of the table has one of the two
    a, b, least = SIZE.get(own.kind, SIZE_HARDENED)
    Y_NT, Y_drelT = root_life(own.kind, cycles), notch_sensitivity(rho=rho, q_s=q_s)
    Y_RrelT, Y_X = surface_factor(own.kind, Rz_F), size_factor(a=a, b=b, m_n=m_n, Y=least)
    Y_M = mean_stress_factor(loading=loading)
    sigma_F = root_stress_of_wheel(sigma_F0=sigma_F0, Y_B=Y_B, Y_DT=Y_DT, K_F=K_F)
    sigma_FG = root_limit(sigma_Flim=own.sigma_Flim, Y_ST=TEST_GEAR, Y_NT=Y_NT, Y_drelT=Y_drelT, Y_RrelT=Y_RrelT, Y_X=Y_X, Y_M=Y_M)
    return RootStrength(
        Y_B=Y_B, Y_DT=Y_DT, Y_NT=Y_NT, Y_drelT=Y_drelT, Y_RrelT=Y_RrelT, Y_X=Y_X, Y_M=Y_M, sigma_F=sigma_F, sigma_FG=sigma_FG,
        sigma_FP=permissible_root_stress(sigma_FG=sigma_FG, S_Fmin=S_Fmin),
        S_F=bending_safety(sigma_FG=sigma_FG, sigma_F=sigma_F) if sigma_F > 0 else None,
    )  # fmt: skip
