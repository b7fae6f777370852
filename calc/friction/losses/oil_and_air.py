# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What wheels lose to oil and air: dipping into the sump, the mist around them, oil that is thrown onto the teeth.

A wheel that dips into oil loses by moving it: Changenet and Velex's correlation in the four regimes of 2011.

Measured on single wheels of 1.5 to 5 mm module and about 100 to 160 mm diameter in a wide sump; flanges, deflectors and
a meshing partner change it.  The constants were read in public code and are continuous at Re = 4000; the papers
themselves were not read."""

from ...sheet.formula import formula
from ...sheet.functions import acos, cos, largest, pi, sin, smallest
from ...sheet.text import Text
from ...sheet.units import (
    CubicMetre,
    CubicMetrePerSecond,
    KilogramPerMetre3,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    NewtonMetre,
    Number,
    PascalSecond,
    Radian,
    RadPerSecond,
    RevPerSecond,
    SquareMetre,
    SquareMetrePerSecond,
    Watt,
)

CHANGENET = Text("Changenet, Leprince, Ville and Velex 2011")
GRAVITY: MetrePerSecond2 = 9.81
NO_DEPTH: Metre = 0.0
CALM: MetrePerSecond2 = 750.0
WILD: MetrePerSecond2 = 1250.0


@formula("h", "geometry: depth of the reference circle in the oil at rest", unit="mm")
def depth_of_reference_circle(h_t: Metre, r_a: Metre, r: Metre) -> Metre:
    return smallest(largest(h_t - (r_a - r), NO_DEPTH), 2 * r)


@formula("θ", Text("{changenet}: half of the angle that is under oil", changenet=CHANGENET))
def wetted_angle(h: Metre, r: Metre) -> Radian:
    return acos(1 - h / r)


@formula(
    "S_m",
    Text(
        "{changenet}: wetted surface, both faces, the rim and the flanks of the teeth (height 2.25·m_n)",
        changenet=CHANGENET,
    ),
)
def wetted_surface(
    r: Metre, theta: Radian, b: Metre, z: Number, m_n: Metre, alpha_t: Radian, beta: Radian
) -> SquareMetre:
    return (
        r**2 * (2 * theta - sin(2 * theta))
        + 2 * r * b * theta
        + 2 * z * theta * 2.25 * m_n * b / (pi * cos(alpha_t) * cos(beta))
    )


@formula("Re_c", Text("{changenet}: Reynolds number of the width", changenet=CHANGENET))
def reynolds(omega: RadPerSecond, r: Metre, b: Metre, nu: SquareMetrePerSecond) -> Number:
    return omega * r * b / nu


@formula("Fr", Text("{changenet}: Froude number", changenet=CHANGENET))
def froude(omega: RadPerSecond, r: Metre) -> Number:
    return omega**2 * r / GRAVITY


@formula("γ_c", Text("{changenet}: parameter of centrifugal acceleration", changenet=CHANGENET))
def centrifugal(omega: RadPerSecond, r: Metre, b: Metre, m_n: Metre) -> MetrePerSecond2:
    return omega**2 * (r * b * m_n) ** (1 / 3)


@formula(
    "C_m1",
    Text("{changenet}: torque number, γ_c up to 750 m/s²; Re_c beyond 4000 no longer counts", changenet=CHANGENET),
    names={"V": "V_0"},
)
def calm(h: Metre, r: Metre, V: CubicMetre, Fr: Number, Re_c: Number, b: Metre) -> Number:
    return (
        largest(1.366 * Re_c**-0.21, 0.239)
        * (h / (2 * r)) ** 0.45
        * (V / (2 * r) ** 3) ** 0.1
        * Fr**-0.6
        * (b / r) ** 0.21
    )


@formula("C_m2", Text("{changenet}: torque number, γ_c from 1250 m/s² on", changenet=CHANGENET), names={"V": "V_0"})
def wild(h: Metre, r: Metre, V: CubicMetre, Fr: Number, Re_c: Number, b: Metre) -> Number:
    return (
        largest(20.797 * Re_c**-0.21, 3.644)
        * (h / (2 * r)) ** 0.1
        * (V / (2 * r) ** 3) ** -0.35
        * Fr**-0.88
        * (b / (2 * r)) ** 0.85
    )


@formula("C_m", Text("{changenet}: between both, linear in γ_c", changenet=CHANGENET), names={"gamma": "γ_c"})
def torque_number(C_m1: Number, C_m2: Number, gamma: MetrePerSecond2) -> Number:
    return C_m1 + (C_m2 - C_m1) * smallest(largest((gamma - CALM) / (WILD - CALM), 0.0), 1.0)


@formula("T_C", Text("{changenet}: torque of churning", changenet=CHANGENET))
def churning_torque(
    rho: KilogramPerMetre3, omega: RadPerSecond, r: Metre, S_m: SquareMetre, C_m: Number
) -> NewtonMetre:
    return rho / 2 * omega**2 * r**3 * S_m * C_m


@formula("P_C", "definition: power of churning")
def churning(T_C: NewtonMetre, omega: RadPerSecond) -> Watt:
    return T_C * omega


# --- the air and oil mist around the wheels, loaded or not
# Anderson and Loewenthal give the loss of a spur wheel in a mist of one part oil in 34.25 parts air; other mists are
# scaled by the same law of turbulent discs, P ~ ρ^0.8·η^0.2.  A wheel that dips into oil churns it besides
# (above).

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


@formula(
    "η_m",
    Text("{anderson}: viscosity of the mist by shares of volume", anderson=ANDERSON),
    unit="mPa·s",
    meanings={"eta_air": "Viscosity of the air"},
)
def mist_viscosity(s_oil: Number, eta_oil: PascalSecond, eta_air: PascalSecond) -> PascalSecond:
    return s_oil * eta_oil + (1 - s_oil) * eta_air


@formula(
    "P_W",
    Text("{anderson}; scaled to another mist by its density to the power 0.8", anderson=ANDERSON),
    meanings={"r": "Radius of the wheel"},
)
def windage(
    b: Metre, r: Metre, n: RevPerSecond, eta_m: PascalSecond, rho_m: KilogramPerMetre3, rho_0: KilogramPerMetre3
) -> Watt:
    """>>> windage(b=0.015, r=0.02695, n=43.33, eta_m=0.0002303, rho_m=24, rho_0=23.9)
    0.1058093...
    """
    return (
        C_3
        * (1 + 2.3 * b / r)
        * (n / ONE_RPM) ** 2.8
        * (r / ONE_METRE) ** 4.6
        * (eta_m / MILLIPASCAL_SECOND) ** 0.2
        * (rho_m / rho_0) ** 0.8
    )


# --- the oil that is thrown onto the teeth and carried along


@formula("v_t", "definition of the speed of the reference circle")
def pitch_line_speed(r: Metre, n: RevPerSecond) -> MetrePerSecond:
    return 2 * pi * r * n


@formula("P_J", "dynamics: momentum of the oil that leaves with the speed of the teeth (Butsch 1989, ISO/TR 14179-2)")
def thrown_oil(rho: KilogramPerMetre3, Q: CubicMetrePerSecond, v_t: MetrePerSecond, v_j: MetrePerSecond) -> Watt:
    return rho * Q * v_t * (v_t - v_j)
