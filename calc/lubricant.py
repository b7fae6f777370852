# SPDX-License-Identifier: Apache-2.0
"""Oils: viscosity, density, specific heat over temperature, and what acts in a gear mesh.  Used by bearings and friction.

Temperatures in °C.  Validity: 2 to 1e5 mm²/s, from 0 °C to about 40 K above the hotter of the two given points (140 °C); the
thinning of multigrade oils at high shear rate is not part of these laws.
"""

from bisect import bisect_right
from itertools import pairwise
from typing import cast

import numpy as np

from .catalogue import Oil, base_stocks
from .sheet.formula import formula
from .sheet.functions import largest, ln, log10, power
from .sheet.record import record
from .sheet.text import Amount, Text
from .sheet.units import (
    Celsius,
    JoulePerKilogramKelvin,
    KilogramPerMetre3,
    Number,
    PascalSecond,
    PerKelvin,
    PerPascal,
    SquareMetrePerSecond,
)  # fmt: skip
from .sheet.value import based_on

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
POLYMER_THICKENED = -3.3  # slope of the viscosity line: flatter is a multigrade; rule of this program, tells those of its table apart
FLATTEST, STEEPEST = 1.0, 6.0  # slopes of viscosity lines, either sign; silicones have about 1.3, polyphenyl ethers 4.7 (from memory)


@formula("ν", "Finotti 2013, 5.3: Walther's lg lg(ν + c) = C_2 + C_1·lg T from two points; c = 0.6 there, 0.7 in ASTM D341", unit="mm²/s")
def kinematic_viscosity(C_2: Number, C_1: Number, T: Celsius, c: Number) -> SquareMetrePerSecond:
    """>>> kinematic_viscosity(C_2=7.882, C_1=-3.039, T=120.9, c=0.6)
    9.095069...e-06
    """
    return (10 ** (10 ** (C_2 + C_1 * log10((T + ZERO_CELSIUS) / ONE_KELVIN))) - c) * CENTISTOKE


@formula("ρ", "linear in temperature; reproduces the densities of Finotti 2013, 5.5.3, to their last digit")
def density(rho_15: KilogramPerMetre3, T: Celsius) -> KilogramPerMetre3:
    """>>> density(rho_15=860, T=120.9)
    800.8019
    """
    return rho_15 * (1 - SLOPE * (T - REFERENCE))


@formula("c_p", "linear in temperature, identified from the tables without a number of Finotti 2013, 5.5.2 and 5.5.3")
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
)
def pressure_viscosity(k: PerPascal, mu: PascalSecond, s: Number) -> PerPascal:
    return k * power(mu / MILLIPASCAL_SECOND, s)


@formula("k", "AGMA 925-A03, solved for k at 40 °C", names={"alpha_40": "α_40", "mu_40": "μ_40"})
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


@formula("β", "mathematics, derivative of the viscosity and density laws: −d ln μ/dT")
def temperature_coefficient(C_1: Number, nu: SquareMetrePerSecond, c: Number, T: Celsius) -> PerKelvin:
    return SLOPE / (1 - SLOPE * (T - REFERENCE)) - ln(10.0) * C_1 * log10(nu / CENTISTOKE + c) * (1 + c * CENTISTOKE / nu) / (
        T + ZERO_CELSIUS
    )


@formula("β", "rule of this program: where the rows of an oil rise with temperature, which no oil does, the viscosity counts as constant")
def not_rising(beta: PerKelvin) -> PerKelvin:
    return largest(beta, 0 * beta)


@formula("C_1", "mathematics: slope of the viscosity line through the points at 40 and 100 °C", names={"nu_40": "ν_40", "nu_100": "ν_100"})
def viscosity_slope(nu_100: SquareMetrePerSecond, nu_40: SquareMetrePerSecond, c: Number) -> Number:
    return (log10(log10(nu_100 / CENTISTOKE + c)) - log10(log10(nu_40 / CENTISTOKE + c))) / (log10(373.15) - log10(313.15))


@formula("C_2", "mathematics: intercept of the viscosity line through the point at 40 °C", names={"nu_40": "ν_40"})
def viscosity_intercept(nu_40: SquareMetrePerSecond, c: Number, C_1: Number) -> Number:
    return log10(log10(nu_40 / CENTISTOKE + c)) - C_1 * log10(313.15)


@formula("ν_i", "definition of kinematic viscosity: a row of the oil's own table", unit="mm²/s", names={"mu_i": "μ_i", "T_i": "T_i"})
def row_viscosity(mu_i: PascalSecond, rho_15: KilogramPerMetre3, T_i: Celsius) -> SquareMetrePerSecond:
    """>>> row_viscosity(mu_i=0.12858, rho_15=850.5, T_i=40.0)
    0.000153678...
    """
    return mu_i / (rho_15 * (1 - SLOPE * (T_i - REFERENCE)))


@formula("C_1", "mathematics: slope of the viscosity line between two rows of the oil's own table")
def slope_between(nu_1: SquareMetrePerSecond, T_1: Celsius, nu_2: SquareMetrePerSecond, T_2: Celsius, c: Number) -> Number:
    return (log10(log10(nu_2 / CENTISTOKE + c)) - log10(log10(nu_1 / CENTISTOKE + c))) / log10((T_2 + ZERO_CELSIUS) / (T_1 + ZERO_CELSIUS))


@formula("C_2", "mathematics: intercept of the viscosity line through a row of the oil's own table")
def intercept_through(nu_1: SquareMetrePerSecond, T_1: Celsius, c: Number, C_1: Number) -> Number:
    return log10(log10(nu_1 / CENTISTOKE + c)) - C_1 * log10((T_1 + ZERO_CELSIUS) / ONE_KELVIN)


@record
class State:
    """An oil at a temperature: kinematic and dynamic viscosity, density, specific heat."""

    nu: SquareMetrePerSecond
    mu: PascalSecond
    rho: KilogramPerMetre3
    cp: JoulePerKilogramKelvin


class Lubricant:
    """An oil with its viscosity law, ready to be asked at any temperature (°C; scalar or array).

    The law is Walther's line through the viscosities at 40 and 100 °C, or such a line between each two rows of the oil's own table, the
    outermost ones carried on beyond it, or one viscosity at every temperature.
    """

    of_numbers = True  # for `unlinked`

    def __init__(self, oil: Oil, law: str = "walther") -> None:
        self.oil = oil
        self.law = law
        self.c = ADDED[law]
        self.C_1 = self.C_2 = 0.0  # of the one line
        self.lines: tuple[tuple[Number, Number], ...] = ()  # C_2 and C_1 between the rows
        if oil.nu40 is not None and oil.nu100 is not None:
            self.C_1 = viscosity_slope(nu_100=oil.nu100, nu_40=oil.nu40, c=self.c)
            self.C_2 = viscosity_intercept(nu_40=oil.nu40, c=self.c, C_1=self.C_1)
        elif oil.viscosities:
            rows = [(row_viscosity(mu_i=row.viscosity, rho_15=oil.rho15, T_i=row.temperature), row.temperature) for row in oil.viscosities]
            self.lines = tuple(self._line(*one, *other) for one, other in pairwise(rows))

    def _line(self, nu_1: SquareMetrePerSecond, T_1: Celsius, nu_2: SquareMetrePerSecond, T_2: Celsius) -> tuple[Number, Number]:
        C_1 = slope_between(nu_1=nu_1, T_1=T_1, nu_2=nu_2, T_2=T_2, c=self.c)
        return intercept_through(nu_1=nu_1, T_1=T_1, c=self.c, C_1=C_1), C_1

    @property
    def constant(self) -> bool:
        """Whether the viscosity is the same at every temperature."""
        return self.oil.viscosity is not None

    @property
    def reach(self) -> tuple[Celsius, Celsius] | None:
        """The temperatures that the oil's own table covers; None where it has none."""
        rows = self.oil.viscosities
        return (rows[0].temperature, rows[-1].temperature) if rows else None

    @property
    def polymer_thickened(self) -> bool:
        """Whether its viscosity line is as flat as that of a multigrade oil; not known where the viscosity is one for all temperatures."""
        if self.lines:
            low, high = (self.nu(T) for T in (40.0, 100.0))
            return viscosity_slope(nu_100=high, nu_40=low, c=self.c) > POLYMER_THICKENED
        return not self.constant and self.C_1 > POLYMER_THICKENED

    def at(self, T: Celsius) -> State:
        rho = density(rho_15=self.oil.rho15, T=T)
        if self.oil.viscosity is not None:
            mu = constant_viscosity(mu=self.oil.viscosity, T=T)
            return State(implied_viscosity(mu=mu, rho=rho), mu, rho, specific_heat(T=T))
        nu = self.nu(T)
        return State(nu, dynamic_viscosity(nu=nu, rho=rho), rho, specific_heat(T=T))

    def nu(self, T: Celsius) -> SquareMetrePerSecond:
        """The kinematic viscosity by the line that holds at this temperature."""
        if self.oil.viscosity is not None:
            return self.at(T).nu
        C_2, C_1 = self._line_at(T)
        return kinematic_viscosity(C_2=C_2, C_1=C_1, T=T, c=self.c)

    def _line_at(self, T: Celsius) -> tuple[Number, Number]:
        """Intercept and slope; of an array of temperatures an array each."""
        if not self.lines:
            return self.C_2, self.C_1
        inner = [row.temperature for row in self.oil.viscosities[1:-1]]
        if getattr(T, "ndim", 0) == 0:
            return self.lines[bisect_right(inner, T)]
        from .sheet.linked_array import gathered

        there = np.searchsorted(inner, np.asarray(T), "right")
        C_2, C_1 = (gathered(part) for part in zip(*self.lines))
        return cast("tuple[Number, Number]", (C_2[there], C_1[there]))

    @property
    def nu40(self) -> SquareMetrePerSecond:
        """Its kinematic viscosity at 40 °C: as given, else by its law."""
        return self.nu(40.0) if self.oil.nu40 is None else self.oil.nu40

    @property
    def nu100(self) -> SquareMetrePerSecond:
        return self.nu(100.0) if self.oil.nu100 is None else self.oil.nu100

    def alpha(self, mu: PascalSecond) -> PerPascal:
        """The rise of viscosity with pressure, from the dynamic viscosity at the same temperature."""
        base, k = base_stocks()[self.oil.base], None
        if self.oil.pressure_viscosity_40 is not None:
            k = pressure_viscosity_constant(alpha_40=self.oil.pressure_viscosity_40, mu_40=self.at(40.0).mu, s=base.s)
        return pressure_viscosity(k=base.k if k is None else k, mu=mu, s=base.s)

    def beta(self, T: Celsius) -> PerKelvin:
        """The fall of ln μ with temperature; at a row of the oil's own table that of the line above it."""
        if self.constant:
            return based_on(0.0, self.oil.viscosity)
        C_2, C_1 = self._line_at(T)
        beta = temperature_coefficient(C_1=C_1, nu=kinematic_viscosity(C_2=C_2, C_1=C_1, T=T, c=self.c), c=self.c, T=T)
        return not_rising(beta=beta) if self.lines else beta

    @property
    def limiting_shear(self) -> Number:
        """The largest shear stress of the oil over its pressure: as given, else by its base."""
        given = self.oil.limiting_shear
        return base_stocks()[self.oil.base].limiting_shear if given is None else given


def line_problem(nu40: SquareMetrePerSecond, nu100: SquareMetrePerSecond) -> Text | None:
    """Why the line through an oil's viscosities at 40 and 100 °C can be that of no liquid lubricant; None where it can."""
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
