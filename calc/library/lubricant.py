# SPDX-License-Identifier: Apache-2.0
"""An oil at any temperature: what the laws of `oil_formulas.py` make of its numbers.  Used by bearings and friction."""

from bisect import bisect_right
from itertools import pairwise
from typing import Generic, cast

import numpy as np

from ..sheet.arrays import Value
from ..sheet.record import record
from ..sheet.units import Celsius, Number, PascalSecond, PerKelvin, PerPascal, SquareMetrePerSecond
from ..sheet.value import based_on
from . import oil_formulas as f
from .catalogue import Oil, base_stocks


@record
class OilState(Generic[Value]):
    """An oil at a temperature, or at many."""

    nu: Value  # kinematic viscosity, m²/s
    mu: Value  # dynamic viscosity, Pa·s
    rho: Value  # kg/m³
    cp: Value  # specific heat, J/(kg·K)


class Lubricant:
    """An oil with its viscosity law, ready to be asked at any temperature (°C; scalar or array).

    The law is Walther's line through the viscosities at 40 and 100 °C, or such a line between each two rows of the
    oil's own table, the outermost ones carried on beyond it, or one viscosity at every temperature."""

    of_numbers = True  # for `unlinked`

    def __init__(self, oil: Oil, law: str = "walther") -> None:
        self.oil = oil
        self.law = law
        self.c = f.ADDED[law]
        self.C_1 = self.C_2 = 0.0  # of the one line
        self.lines: tuple[tuple[Number, Number], ...] = ()  # C_2 and C_1 between the rows
        if oil.nu40 is not None and oil.nu100 is not None:
            self.C_1 = f.viscosity_slope(nu_100=oil.nu100, nu_40=oil.nu40, c=self.c)
            self.C_2 = f.viscosity_intercept(nu_40=oil.nu40, c=self.c, C_1=self.C_1)
        elif oil.viscosities:
            rows = [
                (f.row_viscosity(mu_i=row.viscosity, rho_15=oil.rho15, T_i=row.temperature), row.temperature)
                for row in oil.viscosities
            ]
            self.lines = tuple(self._line(*first, *other) for first, other in pairwise(rows))

    def _line(
        self, nu_1: SquareMetrePerSecond, T_1: Celsius, nu_2: SquareMetrePerSecond, T_2: Celsius
    ) -> tuple[Number, Number]:
        C_1 = f.slope_between(nu_1=nu_1, T_1=T_1, nu_2=nu_2, T_2=T_2, c=self.c)
        return f.intercept_through(nu_1=nu_1, T_1=T_1, c=self.c, C_1=C_1), C_1

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
        """Whether its viscosity line is as flat as that of a multigrade oil; not known where the viscosity is one for
        all temperatures."""
        if self.lines:
            low, high = (self.nu(T) for T in (40.0, 100.0))
            return f.viscosity_slope(nu_100=high, nu_40=low, c=self.c) > f.POLYMER_THICKENED
        return not self.constant and self.C_1 > f.POLYMER_THICKENED

    def at(self, T: Value) -> OilState[Value]:
        rho = f.density(rho_15=self.oil.rho15, T=T)
        if self.oil.viscosity is not None:
            mu = f.constant_viscosity(mu=self.oil.viscosity, T=T)
            return OilState(f.implied_viscosity(mu=mu, rho=rho), mu, rho, f.specific_heat(T=T))
        nu = self.nu(T)
        return OilState(nu, f.dynamic_viscosity(nu=nu, rho=rho), rho, f.specific_heat(T=T))

    def nu(self, T: Value) -> Value:
        """The kinematic viscosity [m²/s] by the line that holds at a temperature [°C]."""
        if self.oil.viscosity is not None:
            return self.at(T).nu
        C_2, C_1 = self._line_at(T)
        return f.kinematic_viscosity(C_2=C_2, C_1=C_1, T=T, c=self.c)

    def _line_at(self, T: Value) -> tuple[Value | Number, Value | Number]:
        """Intercept and slope; of an array of temperatures an array each."""
        if not self.lines:
            return self.C_2, self.C_1
        inner = [row.temperature for row in self.oil.viscosities[1:-1]]
        if getattr(T, "ndim", 0) == 0:
            return self.lines[bisect_right(inner, T)]
        from ..sheet.linked_array import gathered

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
            k = f.pressure_viscosity_constant(alpha_40=self.oil.pressure_viscosity_40, mu_40=self.at(40.0).mu, s=base.s)
        return f.pressure_viscosity(k=base.k if k is None else k, mu=mu, s=base.s)

    def beta(self, T: Celsius) -> PerKelvin:
        """The fall of ln μ with temperature; at a row of the oil's own table that of the line above it."""
        if self.constant:
            return based_on(0.0, self.oil.viscosity)
        C_2, C_1 = self._line_at(T)
        beta = f.temperature_coefficient(
            C_1=C_1, nu=f.kinematic_viscosity(C_2=C_2, C_1=C_1, T=T, c=self.c), c=self.c, T=T
        )
        return f.not_rising(beta=beta) if self.lines else beta

    @property
    def limiting_shear(self) -> Number:
        """The largest shear stress of the oil over its pressure: as given, else by its base."""
        given = self.oil.limiting_shear
        return base_stocks()[self.oil.base].limiting_shear if given is None else given
