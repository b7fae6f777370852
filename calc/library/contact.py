# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What loss and warmth of a whole mesh follow from by the standards: roughness, mean friction, loss factor, bulk temperature."""

from typing import Annotated

from ..sheet.formula import formula
from ..sheet.functions import cos, pi
from ..sheet.text import Text
from ..sheet.units import Celsius, Kelvin, Metre, MetrePerSecond, NewtonPerMetre, Number, PascalSecond, Radian, Watt

WattPerSquareMetre = Annotated[float, "W/m²"]

ISO = Text("ISO/TR 15144-1:2014")
MICROMETRE: Metre = 1e-6
MILLIMETRE: Metre = 1e-3
METRE_PER_SECOND: MetrePerSecond = 1.0
NEWTON_PER_MILLIMETRE: NewtonPerMetre = 1e3
MILLIPASCAL_SECOND: PascalSecond = 1e-3
KILOWATT_PER_SQUARE_MILLIMETRE: WattPerSquareMetre = 1e9
RISE: Kelvin = 7400.0

# Lubricant factor of the friction, ISO/TR 15144-1:2014, Table 3, the same in ISO/TR 13989-1, as in public code; it knows phosphate esters
# only (1.3): other esters count as mineral oil by a rule of this program.
LUBRICANT_FACTOR = {"mineral": 1.0, "PAO": 0.8, "PAG": 0.7}
# Lubrication factor X_S, ISO/TR 13989-1:2000 (22) and ISO/TR 15144-1:2014 (84), from memory.
LUBRICATION_FACTOR = {"spray": 1.2, "dip": 1.0, "submerged": 0.2}


@formula("Ra", Text("{iso} (3): mean roughness of both flanks", iso=ISO), unit="µm")
def mean_roughness(Ra_1: Metre, Ra_2: Metre) -> Metre:
    return (Ra_1 + Ra_2) / 2


@formula(
    "v_Σ,C",
    Text("{iso} (13): sum of the rolling speeds at the pitch point, where both are the same", iso=ISO),
)
def sum_of_speeds(v_C: MetrePerSecond) -> MetrePerSecond:
    return 2 * v_C


@formula("X_R", Text("{iso} (87): roughness factor", iso=ISO), names={"rho_nC": "ρ_n,C"})
def roughness_factor(Ra: Metre, rho_nC: Metre) -> Number:
    return 2.2 * (Ra / MICROMETRE / (rho_nC / MILLIMETRE)) ** 0.25


@formula(
    "μ_m",
    Text("{iso} (86): mean coefficient of friction", iso=ISO),
    names={"v_SumC": "v_Σ,C", "rho_nC": "ρ_n,C", "eta": "η_oil", "K_Bgamma": "K_Bγ"},
)
def mean_friction(
    w_t: NewtonPerMetre, K_Bgamma: Number, v_SumC: MetrePerSecond, rho_nC: Metre, eta: PascalSecond, X_R: Number, X_L: Number
) -> Number:
    return (
        0.045 * (w_t / NEWTON_PER_MILLIMETRE * K_Bgamma / (v_SumC / METRE_PER_SECOND * rho_nC / MILLIMETRE)) ** 0.2
        * (eta / MILLIPASCAL_SECOND) ** -0.05 * X_R * X_L
    )  # fmt: skip


@formula(
    "H_v",
    Text(
        "Ohlendorf 1958, {iso} (91): loss factor, ε_α below 2; exact where two pairs share the load half and half",
        iso=ISO,
    ),
)
def ohlendorf_loss_factor(eps_1: Number, eps_2: Number, eps_alpha: Number, z_1: Number, z_2: Number, beta_b: Radian) -> Number:
    return (eps_1**2 + eps_2**2 + 1 - eps_alpha) * (1 / z_1 + 1 / z_2) * pi / cos(beta_b)


@formula("H_v", Text("{iso} (92): loss factor, ε_α of 2 and more", iso=ISO))
def ohlendorf_loss_factor_high(eps_alpha: Number, z_1: Number, z_2: Number, beta_b: Radian) -> Number:
    return 0.5 * eps_alpha * (1 / z_1 + 1 / z_2) * pi / cos(beta_b)


@formula("ΔΘ_M", Text("{iso} (84): teeth above oil", iso=ISO), names={"X_Ca": "X_Ca"})
def bulk_rise(P: Watt, mu_m: Number, H_v: Number, a: Metre, b: Metre, X_S: Number, X_Ca: Number) -> Kelvin:
    return RISE * (P * mu_m * H_v / (KILOWATT_PER_SQUARE_MILLIMETRE * a * b)) ** 0.72 * X_S / (1.2 * X_Ca)


@formula("Θ_M", Text("{iso} (84): bulk temperature", iso=ISO), names={"T_oil": "Θ_oil", "Delta_T": "ΔΘ_M"})
def bulk_temperature(T_oil: Celsius, Delta_T: Kelvin) -> Celsius:
    return T_oil + Delta_T
