# SPDX-License-Identifier: Apache-2.0
"""Strength of the flanks against pitting, ISO 6336-2: the film, the curvature at single contact, work hardening, the safety.

Every length is in the transverse section; "hard" and "soft" are the two flanks of a mesh.  The film factors are those of the softer
material.  The size factor Z_X is 1: so for through-hardened teeth, and for surface-hardened ones whose case is deep enough for their size.
"""

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import largest, pi, power, smallest, sqrt, tan
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, MetrePerSecond, Number, Pascal, Radian, SquareMetrePerSecond
from .classes import StrengthClass
from .life import flank_life

IACS = Text("ISO 6336-2:2006 and 2019 as in IACS UR M56 (Rev. 4)")
SOFT: Pascal = 850e6  # σ_Hlim between which the film factors change
SPAN: Pascal = 350e6
RADIUS: Metre = 10e-3  # of relative curvature, of the test gears
ROUGHNESS: Metre = 3e-6  # Rz of the test gears
ROUGHEST: Metre = 16e-6  # Rz_H that counts
THICK: SquareMetrePerSecond = 134e-6
FAST: MetrePerSecond = 32.0
PER_SECOND: MetrePerSecond = 1.0
CENTISTOKE: SquareMetrePerSecond = 1e-6


# --- curvature at the inner point of single contact ----------------------------------------------------------------------------
@formula("M_BD", Text("{iacs}: curvature at the wheel's inner point of single contact against the pitch point; index m: mate", iacs=IACS))
def curvature_ratio(
    alpha_wt: Radian, d_a: Metre, d_b: Metre, z: Number, d_am: Metre, d_bm: Metre, z_m: Number, eps_alpha: Number
) -> Number:
    return tan(alpha_wt) / sqrt((sqrt(d_a**2 / d_b**2 - 1) - 2 * pi / z) * (sqrt(d_am**2 / d_bm**2 - 1) - (eps_alpha - 1) * 2 * pi / z_m))


@formula("Z_BD", Text("{iacs}: single pair factor (Z_B of the smaller, Z_D of the larger wheel), straight from M_BD at ε_β = 0 "
    "to 1 at ε_β ≥ 1, not below 1", iacs=IACS), names={"M": "M_BD"})  # fmt: skip
def single_pair_factor(M: Number, eps_beta: Number) -> Number:
    return largest(M - smallest(eps_beta, 1.0) * (M - 1), 1.0)


# --- film ------------------------------------------------------------------------------------------------------------------
@formula("C_ZL", Text("{iacs}: 0.83 up to 850 MPa, 0.91 from 1200 MPa", iacs=IACS), names={"sigma": "σ_Hlim"})
def lubricant_coefficient(sigma: Pascal) -> Number:
    return 0.83 + 0.08 * smallest(largest((sigma - SOFT) / SPAN, 0.0), 1.0)


@formula("Z_L", Text("{iacs}: lubricant factor, mineral oil; ν_40: at 40 °C", iacs=IACS), names={"nu_40": "ν_40"})
def lubricant_factor(C_ZL: Number, nu_40: SquareMetrePerSecond) -> Number:
    return C_ZL + 4 * (1 - C_ZL) / (1.2 + THICK / nu_40) ** 2


@formula("C_Zv", IACS)
def velocity_coefficient(C_ZL: Number) -> Number:
    return C_ZL + 0.02


@formula("Z_v", Text("{iacs}: velocity factor; v: at the pitch circle", iacs=IACS))
def velocity_factor(C_Zv: Number, v: MetrePerSecond) -> Number:
    return C_Zv + 2 * (1 - C_Zv) / sqrt(0.8 + FAST / v)


@formula("ρ_red", Text("{iacs}: radius of relative curvature at the pitch point; ρ = d_b/2·tan α_wt", iacs=IACS), unit="mm")
def relative_radius(d_b1: Metre, d_b2: Metre, alpha_wt: Radian) -> Metre:
    return d_b1 * d_b2 / (d_b1 + d_b2) * tan(alpha_wt) / 2


@formula("Rz_10", Text("{iacs}: mean roughness, brought to 10 mm of curvature", iacs=IACS), unit="µm", names={"rho": "ρ_red"})
def relative_roughness(Rz_1: Metre, Rz_2: Metre, rho: Metre) -> Metre:
    return (Rz_1 + Rz_2) / 2 * power(RADIUS / rho, 1 / 3)


@formula("C_ZR", Text("{iacs}: 0.15 up to 850 MPa, 0.08 from 1200 MPa", iacs=IACS), names={"sigma": "σ_Hlim"})
def roughness_coefficient(sigma: Pascal) -> Number:
    return 0.15 - 0.07 * smallest(largest((sigma - SOFT) / SPAN, 0.0), 1.0)


@formula("Z_R", Text("{iacs}: roughness factor, 1 at 3 µm", iacs=IACS))
def roughness_factor(Rz_10: Metre, C_ZR: Number) -> Number:
    return power(ROUGHNESS / Rz_10, C_ZR)


# --- work hardening --------------------------------------------------------------------------------------------------------------
@formula("Rz_H", Text("{iacs}: roughness of the hard flank as it works on the soft one", iacs=IACS), unit="µm",
    names={"nu_40": "ν_40", "rho": "ρ_red"})  # fmt: skip
def equivalent_roughness(Rz_hard: Metre, Rz_soft: Metre, rho: Metre, v: MetrePerSecond, nu_40: SquareMetrePerSecond) -> Metre:
    return Rz_hard * power(RADIUS / rho, 0.33) * power(Rz_hard / Rz_soft, 0.66) / power(v / PER_SECOND * nu_40 / CENTISTOKE / 1500, 0.33)


@formula("Z_W", Text("{iacs}: work hardening of a soft flank by a surface-hardened one; HBW counts from 130 to 470, Rz_H from "
    "3 to 16 µm; not below 1", iacs=IACS))  # fmt: skip
def work_hardening_by_hard(HBW: Number, Rz_H: Metre) -> Number:
    return largest(
        (1.2 - (smallest(largest(HBW, 130.0), 470.0) - 130) / 1700) * (ROUGHNESS / smallest(largest(Rz_H, ROUGHNESS), ROUGHEST)) ** 0.15,
        1.0,
    )


@formula("Z_W", Text("{iacs}: larger wheel, both through-hardened, pinion 1.2 times as hard or more; the ratio counts up to 1.7, "
    "u up to 20", iacs=IACS))  # fmt: skip
def work_hardening_through(HBW_1: Number, HBW_2: Number, u: Number) -> Number:
    return 1 + (0.00898 * smallest(HBW_1 / HBW_2, 1.7) - 0.00829) * (smallest(u, 20.0) - 1)


# --- strength ----------------------------------------------------------------------------------------------------------------
@formula("σ_H", "ISO 6336-2:2006: contact stress of one wheel; K_H = K_A·K_v·K_Hβ·K_Hα", unit="MPa")
def contact_stress_of_wheel(Z_BD: Number, sigma_H0: Pascal, K_H: Number) -> Pascal:
    return Z_BD * sigma_H0 * sqrt(K_H)


@formula("σ_HG", "ISO 6336-2:2006: pitting stress limit; Z_X = 1", unit="MPa")
def pitting_limit(sigma_Hlim: Pascal, Z_NT: Number, Z_L: Number, Z_v: Number, Z_R: Number, Z_W: Number) -> Pascal:
    return sigma_Hlim * Z_NT * Z_L * Z_v * Z_R * Z_W


@formula("σ_HP", "ISO 6336-2:2006: permissible contact stress", unit="MPa")
def permissible_contact_stress(sigma_HG: Pascal, S_Hmin: Number) -> Pascal:
    return sigma_HG / S_Hmin


@formula("S_H", "ISO 6336-2:2006: safety against pitting, on stress")
def contact_safety(sigma_HG: Pascal, sigma_H: Pascal) -> Number:
    return sigma_HG / sigma_H


@formula("S_H²", "elasticity, contact stress grows with the root of the load: safety on load")
def contact_safety_on_load(S_H: Number) -> Number:
    return S_H**2


@record
class Film:
    """The three factors of the film, of a mesh."""

    Z_L: Number
    Z_v: Number
    Z_R: Number
    rho_red: Metre


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


def film_factors(
    sigma_Hlim: Pascal, nu_40: SquareMetrePerSecond, v: MetrePerSecond, Rz_1: Metre, Rz_2: Metre, d_b1: Metre, d_b2: Metre, alpha_wt: Radian
) -> Film:
    """`sigma_Hlim`: of the softer material; `nu_40`: the oil at 40 °C; `v`: at the pitch circle, above 0."""
    C_ZL = lubricant_coefficient(sigma=sigma_Hlim)
    rho = relative_radius(d_b1=d_b1, d_b2=d_b2, alpha_wt=alpha_wt)
    return Film(
        Z_L=lubricant_factor(C_ZL=C_ZL, nu_40=nu_40),
        Z_v=velocity_factor(C_Zv=velocity_coefficient(C_ZL=C_ZL), v=v),
        Z_R=roughness_factor(Rz_10=relative_roughness(Rz_1=Rz_1, Rz_2=Rz_2, rho=rho), C_ZR=roughness_coefficient(sigma=sigma_Hlim)),
        rho_red=rho,
    )


def single_pair(
    alpha_wt: Radian, d_a: Metre, d_b: Metre, z: Number, d_am: Metre, d_bm: Metre, z_m: Number, eps_alpha: Number, eps_beta: Number
) -> Number:
    """Z_B or Z_D of a wheel (index m: its mate).  Outside 1 < ε_α < 2 no point has single contact: 1 (rule of this program)."""
    if not 1 < eps_alpha < 2:
        return 1.0
    if (d_a / d_b) ** 2 - 1 <= (2 * pi / z) ** 2 or (d_am / d_bm) ** 2 - 1 <= ((eps_alpha - 1) * 2 * pi / z_m) ** 2:
        raise NoSolution(
            Text("single pair factor Z_B, Z_D: the inner point of single contact lies on the base circle"),
            advice=Text("give more teeth, a larger profile shift, or cut less off the tip"),
        )
    M = curvature_ratio(alpha_wt=alpha_wt, d_a=d_a, d_b=d_b, z=z, d_am=d_am, d_bm=d_bm, z_m=z_m, eps_alpha=eps_alpha)
    return single_pair_factor(M=M, eps_beta=eps_beta)


@formula("Z_W", Text("{iacs}: no hard flank works on a softer steel one", iacs=IACS), shows="1")
def no_work_hardening() -> Number:
    return 1.0


def work_hardening(
    own: StrengthClass, mate: StrengthClass, Rz: Metre, Rz_m: Metre, rho_red: Metre, v: MetrePerSecond, nu_40: SquareMetrePerSecond,
    u: Number,
) -> Number:  # fmt: skip
    """Z_W of a wheel; `u`: its teeth over those of its mate.  1 where no hard flank works on a softer steel one."""
    if own.through_hardened and mate.surface_hardened:
        return work_hardening_by_hard(HBW=own.brinell, Rz_H=equivalent_roughness(Rz_hard=Rz_m, Rz_soft=Rz, rho=rho_red, v=v, nu_40=nu_40))
    if own.through_hardened and mate.through_hardened and u > 1 and mate.brinell >= 1.2 * own.brinell:
        return work_hardening_through(HBW_1=mate.brinell, HBW_2=own.brinell, u=u)
    return no_work_hardening()


def contact_strength(
    own: StrengthClass, *, sigma_H0: Pascal, K_H: Number, Z_BD: Number, film: Film, Z_W: Number, cycles: Number | None, S_Hmin: Number,
    pitting: bool = False,
) -> ContactStrength:  # fmt: skip
    """Stress and strength of one flank.  `cycles` None: the endurance limit."""
    Z_NT = flank_life(own.kind, cycles, pitting)
    sigma_H = contact_stress_of_wheel(Z_BD=Z_BD, sigma_H0=sigma_H0, K_H=K_H)
    sigma_HG = pitting_limit(sigma_Hlim=own.sigma_Hlim, Z_NT=Z_NT, Z_L=film.Z_L, Z_v=film.Z_v, Z_R=film.Z_R, Z_W=Z_W)
    return ContactStrength(
        Z_BD=Z_BD, Z_NT=Z_NT, Z_W=Z_W, sigma_H=sigma_H, sigma_HG=sigma_HG,
        sigma_HP=permissible_contact_stress(sigma_HG=sigma_HG, S_Hmin=S_Hmin),
        S_H=contact_safety(sigma_HG=sigma_HG, sigma_H=sigma_H) if sigma_H > 0 else None,
    )  # fmt: skip
