# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What radial shaft seals cost: two published rules, by diameter and speed alone, or also by the oil."""

from ...sheet.formula import formula
from ...sheet.functions import largest, log10
from ...sheet.units import Celsius, Kelvin, Metre, Number, RevPerSecond, SquareMetrePerSecond, Watt

MILLIMETRE: Metre = 1e-3
ONE_RPM: RevPerSecond = 1 / 60
ONE_WATT: Watt = 1.0
ONE_KELVIN: Kelvin = 1.0
CENTISTOKE: SquareMetrePerSecond = 1e-6


@formula("P_D", "Freudenberg Simrit, as in ISO/TR 14179-2:2001: one radial shaft seal")
def simrit(d_sh: Metre, n: RevPerSecond) -> Watt:
    return 7.69e-6 * (d_sh / MILLIMETRE) ** 2 * (n / ONE_RPM) * ONE_WATT


@formula(
    "P_D",
    "Linke 2010: one radial shaft seal in oil; no less than nothing where thin oil is hot",
    names={"nu_40": "ν_40"},
)
def linke(T_oil: Celsius, nu_40: SquareMetrePerSecond, d_sh: Metre, n: RevPerSecond) -> Watt:
    return (
        largest(145 - 1.6 * T_oil / ONE_KELVIN + 350 * log10(log10(nu_40 / CENTISTOKE + 0.8)), 0.0)
        * 1e-7 * (d_sh / MILLIMETRE) ** 2 * (n / ONE_RPM) * ONE_WATT
    )  # fmt: skip


@formula("P_D", "mathematics: several seals of one size", names={"P": "P_D"})
def several(N: Number, P: Watt) -> Watt:
    return N * P
