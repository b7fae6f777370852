# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""Two flanks in contact: what loss and warmth of a mesh follow from, Hertz's line contact, the points on the path.

Loss and warmth of a whole mesh are those of the standards: roughness, mean friction, loss factor, bulk temperature."""

from typing import Annotated

from ..sheet.formula import formula
from ..sheet.functions import cos, modulus, pi, sqrt
from ..sheet.text import Text
from ..sheet.units import (
    Celsius,
    Kelvin,
    Metre,
    MetrePerSecond,
    NewtonPerMetre,
    Number,
    Pascal,
    PascalSecond,
    Radian,
    RevPerSecond,
    Watt,
)

WattPerSquareMetre = Annotated[float, "W/m²"]

ISO = Text("ISO/TR 15144-1:2014")
MICROMETRE: Metre = 1e-6
MILLIMETRE: Metre = 1e-3
METRE_PER_SECOND: MetrePerSecond = 1.0
NEWTON_PER_MILLIMETRE: NewtonPerMetre = 1e3
MILLIPASCAL_SECOND: PascalSecond = 1e-3
KILOWATT_PER_SQUARE_MILLIMETRE: WattPerSquareMetre = 1e9
RISE: Kelvin = 7400.0

# Lubricant factor of the friction, ISO/TR 15144-1:2014, Table 3, the same in ISO/TR 13989-1, as in public code; it
# knows phosphate esters only (1.3): other esters count as mineral oil by a rule of this program.
LUBRICANT_FACTOR = {"mineral": 1.0, "PAO": 0.8, "PAG": 0.7}
# Lubrication factor X_S, ISO/TR 13989-1:2000 (22) and ISO/TR 15144-1:2014 (84), from memory.
LUBRICATION_FACTOR = {"spray": 1.2, "dip": 1.0, "submerged": 0.2}


@formula("Ra", Text("{iso} (3): mean roughness of both flanks", iso=ISO), unit="µm")
def mean_roughness(Ra_1: Metre, Ra_2: Metre) -> Metre:
    return (Ra_1 + Ra_2) / 2


@formula("v_Σ,C", Text("{iso} (13): sum of the rolling speeds at the pitch point, where both are the same", iso=ISO))
def sum_of_speeds(v_C: MetrePerSecond) -> MetrePerSecond:
    return 2 * v_C


@formula("X_R", Text("{iso} (87): roughness factor", iso=ISO), names={"rho_nC": "ρ_n,C"})
def roughness_factor(Ra: Metre, rho_nC: Metre) -> Number:
    return 2.2 * (Ra / MICROMETRE / (rho_nC / MILLIMETRE)) ** 0.25


@formula(
    "μ_m",
    Text("{iso} (86): mean coefficient of friction", iso=ISO),
    names={"v_SumC": "v_Σ,C", "rho_nC": "ρ_n,C", "eta": "η_oil", "K_Bgamma": "K_Bγ"},
    meanings={"X_L": "Lubricant factor", "K_Bgamma": "Helical load factor"},
)
def mean_friction(
    w_t: NewtonPerMetre,
    K_Bgamma: Number,
    v_SumC: MetrePerSecond,
    rho_nC: Metre,
    eta: PascalSecond,
    X_R: Number,
    X_L: Number,
) -> Number:
    return (
        0.045
        * (w_t / NEWTON_PER_MILLIMETRE * K_Bgamma / (v_SumC / METRE_PER_SECOND * rho_nC / MILLIMETRE)) ** 0.2
        * (eta / MILLIPASCAL_SECOND) ** -0.05
        * X_R
        * X_L
    )


@formula(
    "H_v",
    Text(
        "Ohlendorf 1958, {iso} (91): loss factor, ε_α below 2; exact where two pairs share the load half and half",
        iso=ISO,
    ),
)
def ohlendorf_loss_factor(
    eps_1: Number, eps_2: Number, eps_alpha: Number, z_1: Number, z_2: Number, beta_b: Radian
) -> Number:
    return (eps_1**2 + eps_2**2 + 1 - eps_alpha) * (1 / z_1 + 1 / z_2) * pi / cos(beta_b)


@formula("H_v", Text("{iso} (92): loss factor, ε_α of 2 and more", iso=ISO))
def ohlendorf_loss_factor_high(eps_alpha: Number, z_1: Number, z_2: Number, beta_b: Radian) -> Number:
    return 0.5 * eps_alpha * (1 / z_1 + 1 / z_2) * pi / cos(beta_b)


@formula(
    "ΔΘ_M",
    Text("{iso} (84): teeth above oil", iso=ISO),
    names={"X_Ca": "X_Ca"},
    meanings={"X_S": "Factor of the lubrication", "X_Ca": "Factor of the tip relief"},
)
def bulk_rise(P: Watt, mu_m: Number, H_v: Number, a: Metre, b: Metre, X_S: Number, X_Ca: Number) -> Kelvin:
    return RISE * (P * mu_m * H_v / (KILOWATT_PER_SQUARE_MILLIMETRE * a * b)) ** 0.72 * X_S / (1.2 * X_Ca)


@formula("Θ_M", Text("{iso} (84): bulk temperature", iso=ISO), names={"T_oil": "Θ_oil", "Delta_T": "ΔΘ_M"})
def bulk_temperature(T_oil: Celsius, Delta_T: Kelvin) -> Celsius:
    return T_oil + Delta_T


# --- two elastic cylinders pressed together along a line, in place of two flanks

HERTZ = Text("Hertz 1881, line contact")


@formula(
    "E_r",
    Text("{hertz}; ISO/TR 15144-1:2014 (6), ISO/TR 13989-1:2000 (A.10): reduced modulus of elasticity", hertz=HERTZ),
    unit="GPa",
    meanings={
        "nu_1": "Poisson's ratio of the driver",
        "E_1": "Modulus of elasticity of the driver",
        "nu_2": "Poisson's ratio of the driven wheel",
        "E_2": "Modulus of elasticity of the driven wheel",
    },
)
def reduced_modulus(nu_1: Number, E_1: Pascal, nu_2: Number, E_2: Pascal) -> Pascal:
    """>>> reduced_modulus(nu_1=0.3, E_1=206000000000.0, nu_2=0.3, E_2=206000000000.0)
    2263736...
    """
    return 2 / ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2)


@formula("b_H", Text("{hertz}: half the width of the contact", hertz=HERTZ), unit="µm")
def half_width(w: NewtonPerMetre, rho_n: Metre, E_r: Pascal) -> Metre:
    """>>> half_width(w=69790, rho_n=0.004316, E_r=226400000000.0)
    5.820618...e-05
    """
    return sqrt(8 * w * rho_n / (pi * E_r))


@formula("p_H", Text("{hertz}: largest pressure", hertz=HERTZ), unit="MPa")
def hertz_pressure(w: NewtonPerMetre, E_r: Pascal, rho_n: Metre) -> Pascal:
    return sqrt(w * E_r / (2 * pi * rho_n))


@formula("p_m", Text("{hertz}: mean pressure", hertz=HERTZ), unit="MPa")
def mean_pressure(p_H: Pascal) -> Pascal:
    return pi * p_H / 4


# --- the points on the path of contact, and what the two flanks are and do there
# A place is told by ρ_1, the radius of curvature of the driver's flank in the transverse section: 0 where the line of
# action touches its base circle, T_1T_2 at that of the driven wheel.  A: contact begins; B: the pair before leaves; C:
# pitch point; D: the next pair comes; E: contact ends.  The pair is loaded alone from B to D.  Speeds are those of the
# transverse section, as ISO and AGMA use them.

GEOMETRY = Text("ISO 21771:2007")


@formula("ρ_B", "geometry: one base pitch before the end of contact", unit="mm")
def sole_contact_begins(rho_E: Metre, p_bt: Metre) -> Metre:
    return rho_E - p_bt


@formula("ρ_D", "geometry: one base pitch after the beginning of contact", unit="mm")
def sole_contact_ends(rho_A: Metre, p_bt: Metre) -> Metre:
    return rho_A + p_bt


@formula(
    "ρ_C",
    Text("{geometry}: the driver's radius of curvature at the pitch point", geometry=GEOMETRY),
    unit="mm",
    names={"T": "T_1T_2"},
)
def pitch_point(T: Metre, z_1: Number, z_2: Number) -> Metre:
    return T * z_1 / (z_1 + z_2)


@formula(
    "ρ_2",
    Text("{geometry}: radius of curvature of the driven flank", geometry=GEOMETRY),
    unit="mm",
    names={"T": "T_1T_2"},
    meanings={"rho_1": "Radius of curvature of the driver there"},
)
def driven_curvature(T: Metre, rho_1: Metre) -> Metre:
    return T - rho_1


@formula(
    "ρ_rel",
    "ISO/TR 13989-1:2000 (6): relative radius of curvature, transverse",
    unit="mm",
    meanings={"rho_1": "Radius of curvature of the driver there"},
)
def relative_radius(rho_1: Metre, rho_2: Metre) -> Metre:
    """>>> relative_radius(rho_1=0.009905, rho_2=0.01426)
    0.005845036...
    """
    return rho_1 * rho_2 / (rho_1 + rho_2)


@formula(
    "ρ_n", "ISO/TR 15144-1:2014 (45), AGMA 925-A03: relative radius of curvature, normal to the contact line", unit="mm"
)
def normal_relative_radius(rho_rel: Metre, beta_b: Radian) -> Metre:
    return rho_rel / cos(beta_b)


@formula(
    "v_r",
    "ISO/TR 15144-1:2014 (14), (15), AGMA 925-A03: rolling speed of a flank, along itself",
    names={"rho": "ρ_y"},
    meanings={"rho": "Radius of curvature of the flank there"},
)
def rolling_speed(n: RevPerSecond, rho: Metre) -> MetrePerSecond:
    return 2 * pi * modulus(n) * rho


@formula(
    "ε_1", "ISO/TR 15144-1:2014: contact ratio of the driver's addendum, recess", names={"rho_E": "ρ_E", "rho_C": "ρ_C"}
)
def recess_contact_ratio(rho_E: Metre, rho_C: Metre, p_bt: Metre) -> Number:
    return (rho_E - rho_C) / p_bt


@formula("ε_2", "ISO/TR 15144-1:2014: contact ratio of the driven wheel's addendum, approach")
def approach_contact_ratio(rho_C: Metre, rho_A: Metre, p_bt: Metre) -> Number:
    return (rho_C - rho_A) / p_bt
