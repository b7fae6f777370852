# SPDX-License-Identifier: Apache-2.0
"""The laws of an oil over temperature: viscosity, density, specific heat, pressure-viscosity, and viscosity index.

Viscosity follows Walther's line.

Temperatures in °C.  Validity: 2 to 1e5 mm²/s, from 0 °C to about 40 K above the hotter of the two given points (140
°C); the thinning of multigrade oils at high shear rate is not part of these laws."""

from typing import cast

import numpy as np

from ..sheet.formula import formula
from ..sheet.functions import largest, ln, log10, power
from ..sheet.text import Amount, Text
from ..sheet.units import (
    Celsius,
    JoulePerKilogramKelvin,
    KilogramPerMetre3,
    Number,
    PascalSecond,
    PerKelvin,
    PerPascal,
    SquareMetrePerSecond,
)

ZERO_CELSIUS: Celsius = 273.15
ONE_KELVIN: Celsius = 1.0
CENTISTOKE: SquareMetrePerSecond = 1e-6
SLOPE: PerKelvin = 0.00065
REFERENCE: Celsius = 15.0
CP_0: JoulePerKilogramKelvin = 1801.25
CP_1: JoulePerKilogramKelvin = 4.6
MILLIPASCAL_SECOND: PascalSecond = 1e-3
LOWEST, HIGHEST = 2e-6, 0.1  # m²/s: where the viscosity laws hold
ADDED = {"walther": 0.6, "d341": 0.7}  # the constant under the double logarithm
# slope of the viscosity line: flatter is a multigrade; rule of this program, tells those of its table apart
POLYMER_THICKENED = -3.3
# slopes of viscosity lines, either sign; silicones have about 1.3, polyphenyl ethers 4.7 (from memory)
FLATTEST, STEEPEST = (1.0, 6.0)


@formula(
    "ν",
    "Finotti 2013, 5.3: kinematic viscosity, Walther's lg lg(ν + c_ν) = C_2 + C_1·lg T from two points; c_ν = 0.6 "
    "there, 0.7 in ASTM D341",
    unit="mm²/s",
    names={"T": "T_oil", "c": "c_ν"},
    meanings={
        "c": "Constant of the viscosity line",
        "T": "Temperature of the oil",
        "C_2": "Intercept of the viscosity line",
        "C_1": "Slope of the viscosity line",
    },
)
def kinematic_viscosity(C_2: Number, C_1: Number, T: Celsius, c: Number) -> SquareMetrePerSecond:
    """>>> kinematic_viscosity(C_2=7.882, C_1=-3.039, T=120.9, c=0.6)
    9.095069...e-06
    """
    return (10 ** (10 ** (C_2 + C_1 * log10((T + ZERO_CELSIUS) / ONE_KELVIN))) - c) * CENTISTOKE


@formula(
    "ρ",
    "linear in temperature; reproduces the densities of Finotti 2013, 5.5.3, to their last digit",
    names={"T": "T_oil"},
    meanings={"rho_15": "Density at 15 °C", "T": "Temperature of the oil"},
)
def density(rho_15: KilogramPerMetre3, T: Celsius) -> KilogramPerMetre3:
    """>>> density(rho_15=860, T=120.9)
    800.8019
    """
    return rho_15 * (1 - SLOPE * (T - REFERENCE))


@formula(
    "c_p",
    "linear in temperature, identified from the tables without a number of Finotti 2013, 5.5.2 and 5.5.3",
    names={"T": "T_oil"},
    meanings={"T": "Temperature of the oil"},
)
def specific_heat(T: Celsius) -> JoulePerKilogramKelvin:
    return CP_0 + CP_1 * T / ONE_KELVIN


@formula("μ", "definition of kinematic viscosity", unit="mPa·s")
def dynamic_viscosity(nu: SquareMetrePerSecond, rho: KilogramPerMetre3) -> PascalSecond:
    """>>> dynamic_viscosity(nu=9.092e-06, rho=800.8)
    0.007280873...
    """
    return nu * rho


@formula(
    "α",
    "AGMA 925-A03: α = k·ηˢ, η dynamic (the gear friction thesis, eq. 41, writes the kinematic one)",
    names={"k": "k_α", "s": "s_α"},
    meanings={
        "k": "Constant of the pressure-viscosity coefficient",
        "s": "Exponent of the pressure-viscosity coefficient",
    },
)
def pressure_viscosity(k: PerPascal, mu: PascalSecond, s: Number) -> PerPascal:
    return k * power(mu / MILLIPASCAL_SECOND, s)


@formula("k_α", "AGMA 925-A03, solved for k at 40 °C", names={"alpha_40": "α_40", "mu_40": "μ_40", "s": "s_α"})
def pressure_viscosity_constant(alpha_40: PerPascal, mu_40: PascalSecond, s: Number) -> PerPascal:
    return alpha_40 / power(mu_40 / MILLIPASCAL_SECOND, s)


@formula(
    "μ",
    "definition: viscosity as given, the same at every temperature",
    shows="μ as given, at every T",
    unit="mPa·s",
    names={"mu": "μ_given"},
)
def constant_viscosity(mu: PascalSecond, T: Celsius) -> PascalSecond:
    return cast(PascalSecond, np.full_like(T, mu)) if isinstance(T, np.ndarray) else mu


@formula("ν", "definition of kinematic viscosity, solved for it", unit="mm²/s")
def implied_viscosity(mu: PascalSecond, rho: KilogramPerMetre3) -> SquareMetrePerSecond:
    return mu / rho


@formula(
    "β_T",
    "mathematics, derivative of the viscosity and density laws: −d ln μ/dT",
    names={"T": "T_oil", "c": "c_ν"},
    meanings={"c": "Constant of the viscosity line"},
)
def temperature_coefficient(C_1: Number, nu: SquareMetrePerSecond, c: Number, T: Celsius) -> PerKelvin:
    return SLOPE / (1 - SLOPE * (T - REFERENCE)) - ln(10.0) * C_1 * log10(nu / CENTISTOKE + c) * (
        1 + c * CENTISTOKE / nu
    ) / (T + ZERO_CELSIUS)


@formula(
    "β_T",
    "rule of this program: where the rows of an oil rise with temperature, which no oil does, the viscosity counts as "
    "constant",
    names={"beta": "β_T"},
)
def not_rising(beta: PerKelvin) -> PerKelvin:
    return largest(beta, 0 * beta)


@formula(
    "C_1",
    "mathematics: slope of the viscosity line through the points at 40 and 100 °C",
    names={"nu_40": "ν_40", "nu_100": "ν_100", "c": "c_ν"},
    meanings={
        "nu_40": "Kinematic viscosity at 40 °C",
        "nu_100": "Kinematic viscosity at 100 °C",
        "c": "Constant of the viscosity line",
    },
)
def viscosity_slope(nu_100: SquareMetrePerSecond, nu_40: SquareMetrePerSecond, c: Number) -> Number:
    return (log10(log10(nu_100 / CENTISTOKE + c)) - log10(log10(nu_40 / CENTISTOKE + c))) / (
        log10(373.15) - log10(313.15)
    )


@formula(
    "C_2",
    "mathematics: intercept of the viscosity line through the point at 40 °C",
    names={"nu_40": "ν_40", "c": "c_ν"},
    meanings={"nu_40": "Kinematic viscosity at 40 °C", "c": "Constant of the viscosity line"},
)
def viscosity_intercept(nu_40: SquareMetrePerSecond, c: Number, C_1: Number) -> Number:
    return log10(log10(nu_40 / CENTISTOKE + c)) - C_1 * log10(313.15)


@formula(
    "ν_i",
    "definition of kinematic viscosity: a row of the oil's own table",
    unit="mm²/s",
    names={"mu_i": "μ_i", "T_i": "T_i"},
)
def row_viscosity(mu_i: PascalSecond, rho_15: KilogramPerMetre3, T_i: Celsius) -> SquareMetrePerSecond:
    """>>> row_viscosity(mu_i=0.12858, rho_15=850.5, T_i=40.0)
    0.000153678...
    """
    return mu_i / (rho_15 * (1 - SLOPE * (T_i - REFERENCE)))


@formula("C_1", "mathematics: slope of the viscosity line between two rows of the oil's own table", names={"c": "c_ν"})
def slope_between(
    nu_1: SquareMetrePerSecond, T_1: Celsius, nu_2: SquareMetrePerSecond, T_2: Celsius, c: Number
) -> Number:
    return (log10(log10(nu_2 / CENTISTOKE + c)) - log10(log10(nu_1 / CENTISTOKE + c))) / log10(
        (T_2 + ZERO_CELSIUS) / (T_1 + ZERO_CELSIUS)
    )


@formula("C_2", "mathematics: intercept of the viscosity line through a row of the oil's own table", names={"c": "c_ν"})
def intercept_through(nu_1: SquareMetrePerSecond, T_1: Celsius, c: Number, C_1: Number) -> Number:
    return log10(log10(nu_1 / CENTISTOKE + c)) - C_1 * log10((T_1 + ZERO_CELSIUS) / ONE_KELVIN)


def line_problem(nu40: SquareMetrePerSecond, nu100: SquareMetrePerSecond) -> Text | None:
    """Why the line through an oil's viscosities at 40 and 100 °C can be that of no liquid lubricant; None where it
    can."""
    c = ADDED["walther"]
    slope = -viscosity_slope(nu_100=nu100, nu_40=nu40, c=c)
    if FLATTEST <= slope <= STEEPEST:
        return None

    def at_100(C_1: Number) -> str:
        C_2 = viscosity_intercept(nu_40=nu40, c=c, C_1=-C_1)
        return f"{kinematic_viscosity(C_2=C_2, C_1=-C_1, T=100.0, c=c) / CENTISTOKE:.3g}"

    return Text(
        "no liquid lubricant has it with {nu40} mm²/s at 40 °C: its viscosity line would have the slope {slope}; "
        "silicones have 1.3, mineral oils 3.5, polyphenyl ethers 4.7, and {flattest} to {steepest} are allowed: "
        "here from {at_100} to {at_1002} mm²/s",
        nu40=Amount(nu40 / CENTISTOKE, form="g"),
        slope=Amount(slope, form=".2g"),
        flattest=Amount(FLATTEST, form="g"),
        steepest=Amount(STEEPEST, form="g"),
        at_100=at_100(STEEPEST),
        at_1002=at_100(FLATTEST),
    )


# --- the viscosity index: how little an oil thins with heat
# Beside two series of reference oils of the same viscosity at 100 °C.

SQUARE_MILLIMETRE_PER_SECOND: SquareMetrePerSecond = 1e-6
LOWEST_AT_100 = 2e-6  # m²/s at 100 °C: below it the index is not defined

# ASTM D2270, X2: L = a·Y² + b·Y + c, H = d·Y² + e·Y + f, up to Y mm²/s at 100 °C; from memory, held against its table
# by the tests.  From 55 to 70 mm²/s the last row, which the standard has for what is above 70, is within 0.3 % of the
# table.
REFERENCE_OILS = (
    (3.8, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077),
    (4.4, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183),
    (5.0, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119),
    (6.4, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557),
    (7.0, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656),
    (7.7, 0.01191, 21.475, -72.87, 0.79762, -0.7321, 14.61),
    (9.0, 0.41858, 16.1558, -56.04, 0.05794, 10.5156, -28.24),
    (12.0, 0.88779, 7.5527, -16.6, 0.26665, 6.7015, -10.81),
    (15.0, 0.7672, 10.7972, -38.18, 0.20073, 8.4658, -22.49),
    (18.0, 0.97305, 5.3135, -2.2, 0.28889, 5.9741, -4.93),
    (22.0, 0.97256, 5.25, -0.98, 0.24504, 7.416, -16.73),
    (28.0, 0.91413, 7.4759, -21.82, 0.20323, 9.1267, -34.23),
    (40.0, 0.87031, 9.7157, -50.77, 0.18411, 10.1015, -46.75),
    (55.0, 0.84703, 12.6752, -133.31, 0.17029, 11.4866, -80.62),
    (float("inf"), 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947),
)


@formula(
    "L",
    "ASTM D2270, X2: oil of index 0 with the same viscosity at 100 °C",
    shows="by rows",
    unit="mm²/s",
    names={"nu_100": "ν_100"},
)
def of_index_0(nu_100: SquareMetrePerSecond) -> SquareMetrePerSecond:
    Y = nu_100 / SQUARE_MILLIMETRE_PER_SECOND
    a, b, c = next(row[1:4] for row in REFERENCE_OILS if row[0] >= Y)
    return (a * Y**2 + b * Y + c) * SQUARE_MILLIMETRE_PER_SECOND


@formula(
    "H",
    "ASTM D2270, X2: oil of index 100 with the same viscosity at 100 °C",
    shows="by rows",
    unit="mm²/s",
    names={"nu_100": "ν_100"},
)
def of_index_100(nu_100: SquareMetrePerSecond) -> SquareMetrePerSecond:
    Y = nu_100 / SQUARE_MILLIMETRE_PER_SECOND
    d, e, f = next(row[4:7] for row in REFERENCE_OILS if row[0] >= Y)
    return (d * Y**2 + e * Y + f) * SQUARE_MILLIMETRE_PER_SECOND


@formula("VI", "ASTM D2270, procedure A, up to 100", names={"nu_40": "ν_40"})
def index_up_to_100(L: SquareMetrePerSecond, nu_40: SquareMetrePerSecond, H: SquareMetrePerSecond) -> Number:
    return 100 * (L - nu_40) / (L - H)


@formula("N", "ASTM D2270, procedure B", names={"nu_40": "ν_40", "nu_100": "ν_100"})
def exponent(H: SquareMetrePerSecond, nu_40: SquareMetrePerSecond, nu_100: SquareMetrePerSecond) -> Number:
    return log10(H / nu_40) / log10(nu_100 / SQUARE_MILLIMETRE_PER_SECOND)


@formula("VI", "ASTM D2270, procedure B, above 100")
def index_above_100(N: Number) -> Number:
    return (10**N - 1) / 0.00715 + 100


def viscosity_index(nu_40: SquareMetrePerSecond, nu_100: SquareMetrePerSecond) -> Number | None:
    """The viscosity index; None below 2 mm²/s at 100 °C."""
    if nu_100 < LOWEST_AT_100:
        return None
    H = of_index_100(nu_100=nu_100)
    if nu_40 < H:
        return index_above_100(N=exponent(H=H, nu_40=nu_40, nu_100=nu_100))
    return index_up_to_100(L=of_index_0(nu_100=nu_100), nu_40=nu_40, H=H)
