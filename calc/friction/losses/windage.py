# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What the wheels lose to the air and oil mist around them, loaded or not.

Anderson and Loewenthal give the loss of a spur wheel in a mist of one part oil in 34.25 parts air; other mists are scaled by the
same law of turbulent discs, P ~ ρ^0.8·η^0.2.  A wheel that dips into oil churns it besides (`churning.py`).
"""

from ...sheet.formula import formula
from ...sheet.functions import largest, smallest
from ...sheet.text import Text
from ...sheet.units import KilogramPerMetre3, Metre, Number, PascalSecond, RevPerSecond, Watt

ANDERSON = Text("Anderson and Loewenthal 1980")

C_3: Watt = 2.82e-4  # at 1 m, 1 rpm and a viscosity of 1 mPa·s
ONE_RPM: RevPerSecond = 1 / 60
ONE_METRE: Metre = 1.0
MILLIPASCAL_SECOND: PascalSecond = 1e-3
AIR_DENSITY: KilogramPerMetre3 = 1.2
AIR_VISCOSITY: PascalSecond = 0.019e-3 * 35.25 / 34.25
PARTS_AIR: Number = 34.25


@formula("ρ_0", Text("{anderson}: density of the mist of the tests, 34.25 parts air to one of oil", anderson=ANDERSON))
def mist_of_the_tests(rho_oil: KilogramPerMetre3) -> KilogramPerMetre3:
    return (rho_oil + PARTS_AIR * AIR_DENSITY) / (1 + PARTS_AIR)


@formula("s_oil", "physics: share of oil by volume in a mist of the given density", names={"rho_m": "ρ_m"})
def oil_share(rho_m: KilogramPerMetre3, rho_oil: KilogramPerMetre3) -> Number:
    return smallest(largest((rho_m - AIR_DENSITY) / (rho_oil - AIR_DENSITY), 0.0), 1.0)


@formula("η_m", Text("{anderson}: viscosity of the mist by shares of volume", anderson=ANDERSON), unit="mPa·s")
def mist_viscosity(s_oil: Number, eta_oil: PascalSecond, eta_air: PascalSecond) -> PascalSecond:
    return s_oil * eta_oil + (1 - s_oil) * eta_air


@formula("P_W", Text("{anderson}; scaled to another mist by its density to the power 0.8", anderson=ANDERSON))
def windage(b: Metre, r: Metre, n: RevPerSecond, eta_m: PascalSecond, rho_m: KilogramPerMetre3, rho_0: KilogramPerMetre3) -> Watt:
    """>>> windage(b=0.015, r=0.02695, n=43.33, eta_m=0.0002303, rho_m=24, rho_0=23.9)
    0.1058093...
    """
    return (
        C_3 * (1 + 2.3 * b / r) * (n / ONE_RPM) ** 2.8 * (r / ONE_METRE) ** 4.6 * (eta_m / MILLIPASCAL_SECOND) ** 0.2
        * (rho_m / rho_0) ** 0.8
    )  # fmt: skip
