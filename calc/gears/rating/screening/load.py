# SPDX-License-Identifier: Apache-2.0
"""What film and flash temperature have in common: the load per length, the two bodies, the oil; and their result.

Of the oil its friction factor and the way it arrives."""

from typing import Annotated

from ....library.catalogue import Material
from ....library.contact import LUBRICANT_FACTOR, LUBRICATION_FACTOR, mean_roughness, reduced_modulus
from ....library.lubricant import Lubricant
from ....sheet.arrays import Array
from ....sheet.formula import formula
from ....sheet.functions import cos, modulus, pi, sqrt
from ....sheet.quantity import result, value
from ....sheet.record import record
from ....sheet.shown import Shown
from ....sheet.text import Text
from ....sheet.units import (
    Celsius,
    JoulePerKilogramKelvin,
    Kelvin,
    KilogramPerMetre3,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonPerMetre,
    Number,
    Pascal,
    PascalSecond,
    PerPascal,
    Radian,
    RevPerSecond,
    Watt,
    WattPerMetreKelvin,
)
from ....sheet.value import about

ThermalProduct = Annotated[float, "W²·s/(m⁴·K²)"]

CONDUCTIVITY: WattPerMetreKelvin = 45.0  # of steel, ISO/TR 15144-1:2014, Table 2, as in public code
SPECIFIC_HEAT: JoulePerKilogramKelvin = 440.0  # the same


@formula(
    "w_Bt",
    "ISO/TR 13989-1:2000 (11): transverse load per width, with all load factors",
    unit="N/mm",
    names={"K": "K_eff"},
)
def line_load(K: Number, F_t: Newton, b: Metre) -> NewtonPerMetre:
    return K * F_t / b


@formula("P", "definition of power")
def transmitted_power(F_t: Newton, d: Metre, n: RevPerSecond) -> Watt:
    return F_t * pi * d * modulus(n)


@formula("w_t", "statics: load per width in the plane of action", unit="N/mm")
def load_in_plane_of_action(w_Bt: NewtonPerMetre, alpha_t: Radian) -> NewtonPerMetre:
    return w_Bt / cos(alpha_t)


@formula(
    "K_Bγ",
    "ISO/TR 13989-2:2000 (5) and ISO/TR 15144-1:2014 (88) to (90): more friction by more lines of contact",
    shows="1 up to ε_γ = 2; 1 + 0.2·√((ε_γ − 2)(5 − ε_γ)); 1.3 from ε_γ = 3.5 on",
)
def helical_load_factor(eps_gamma: Number) -> Number:
    return 1.0 if eps_gamma <= 2 else 1.3 if eps_gamma >= 3.5 else 1 + 0.2 * sqrt((eps_gamma - 2) * (5 - eps_gamma))


@formula(
    "b_M",
    "ISO/TR 15144-1:2014 (82), (83): square of the thermal contact coefficient",
    names={"lam": "λ_M", "c": "c_M", "rho": "ρ_M"},
    meanings={
        "lam": "Thermal conductivity of the wheel",
        "rho": "Density of the wheel",
        "c": "Specific heat of the wheel",
    },
)
def thermal_product(lam: WattPerMetreKelvin, rho: KilogramPerMetre3, c: JoulePerKilogramKelvin) -> ThermalProduct:
    return lam * rho * c


@record
class ScreeningLoad:
    """A mesh under its load: what is the same at all points of the path."""

    F_t: Newton
    w_Bt: NewtonPerMetre
    w_t: NewtonPerMetre
    K: Number
    K_A: Number
    K_Bgamma: Number
    E_r: Pascal
    b_1: ThermalProduct
    b_2: ThermalProduct
    Ra: Metre


@record
class OilBath:
    """The oil that reaches the teeth: the same for all meshes of a train."""

    lubricant: Lubricant
    T_oil: Celsius
    eta: PascalSecond  # at that temperature
    alpha_38: PerPascal
    X_L: Number
    X_S: Number


@formula("X_W", "ISO/TR 13989-1:2000, structural factor: case-hardened steel 1, nitrided 1.5", shows="1, nitrided 1.5")
def structural_factor(kind: str) -> Number:
    """`kind`: of ISO 6336-5."""
    return 1.5 if kind.startswith(("NT", "NV")) else 1.0


def oil_bath(lubricant: Lubricant, oil_temperature: Celsius, lubrication: str = "spray") -> OilBath:
    """`lubrication` "spray", "dip" or "submerged".

    The pressure-viscosity coefficient is that of ISO/TR 15144-1:2014 (9) to (11), which AGMA 925-A03 writes in other
    units."""
    with about(Text("oil of the gears")):
        eta = lubricant.at(oil_temperature).mu
        alpha_38 = lubricant.alpha(lubricant.at(38.0).mu)
    X_L, X_S = LUBRICANT_FACTOR.get(lubricant.oil.base, 1.0), LUBRICATION_FACTOR[lubrication]
    return OilBath(lubricant, oil_temperature, eta, alpha_38, X_L, X_S)


def load_of(
    F_t: Newton,
    K: Number,
    K_A: Number,
    b: Metre,
    alpha_t: Radian,
    eps_gamma: Number,
    one: Material,
    two: Material,
    Ra: tuple[Metre, Metre],
) -> ScreeningLoad:
    w_Bt = line_load(K=K, F_t=F_t, b=b)
    w_t = load_in_plane_of_action(w_Bt=w_Bt, alpha_t=alpha_t)
    K_Bgamma = helical_load_factor(eps_gamma=eps_gamma)
    E_r = reduced_modulus(nu_1=one.poisson, E_1=one.E, nu_2=two.poisson, E_2=two.E)
    b_1, b_2 = (thermal_product(lam=CONDUCTIVITY, rho=solid.density, c=SPECIFIC_HEAT) for solid in (one, two))
    return ScreeningLoad(F_t, w_Bt, w_t, K, K_A, K_Bgamma, E_r, b_1, b_2, mean_roughness(Ra_1=Ra[0], Ra_2=Ra[1]))


# --- what the screening of a mesh gives


@result
class Screening(Shown):
    """Film and temperatures of one mesh at its load.  A screening, not a rating."""

    specific_film_min: Number | None = value(
        "Smallest specific film thickness (screening)", "", "λ_GF,min", default=None, short=True
    )
    film_min: Metre | None = value("Film thickness where the specific film is smallest", "µm", "h_min", default=None)
    film_pressure: Pascal | None = value(
        "Hertzian pressure where the specific film is smallest", "MPa", "p_dyn", default=None
    )
    friction_film: Number = value("Mean coefficient of friction, micropitting method", "", "μ_m")
    bulk_temperature_film: Celsius = value("Bulk temperature, micropitting method", "°C", "Θ_M")
    flash_temperature_max: Kelvin = value("Highest flash temperature (screening)", "K", "Θ_fl,max")
    friction_flash: Number = value("Mean coefficient of friction, flash temperature method", "", "μ_m")
    bulk_temperature_flash: Celsius = value("Bulk temperature, flash temperature method", "°C", "Θ_M")
    contact_temperature_max: Celsius = value("Highest contact temperature", "°C", "Θ_B,max")
    scuffing_temperature: Celsius = value("Scuffing temperature of the oil", "°C", "Θ_S")
    scuffing_safety: Number = value("Safety against scuffing, by temperatures (screening)", "", "S_B")
    scuffing_margin: Kelvin
    title: str  # "driver–driven"
    film_place: str = ""  # A, AB, B, C, D, DE or E; empty: no film
    permissible_film: Number
    permissible_given: bool
    load_stage: Number
    load_stage_given: bool
    line_load: NewtonPerMetre  # w_Bt
    pitch_line_speed: MetrePerSecond
    oil_temperature: Celsius
    method_applies: bool  # spur or narrow helical wheels with ε_α below 2, or wide helical ones
    way: Array  # samples: way on the line of action from the pitch point
    flash: Array
    specific_film: Array | None = None
