# SPDX-License-Identifier: Apache-2.0
"""What the half-moon sectors of a balance shaft lose in the mist around them, and what they would lose in oil.

No measurement of such weights was found, so that the loss is bracketed.  At least it is that of the closed cylinder
which they sweep, turning in a shell; without one the gap is taken as wide as the cylinder's radius.  At most that and
the drag of a plate, the flat side of the sectors, in air at rest: what surrounds it turns with it, and the less of it
the closer a shell stands.  Counted is the mean of both in proportion, in a shell the low end.

Up to Re = 2000 the friction of the cylinder is that of a laminar film.  Vortices begin far earlier (Re·√(t/R) about 41)
and the turbulent law gives eight times as much at 2000: between, the low end is a low end indeed.  Sectors in mist run
at Re beyond 10 000."""

import numpy as np

from ...countershaft.inputs import ShaftInputs
from ...countershaft.outline import Outline
from ...sheet.arguments import check_arguments, demand_alike, demand_numbers
from ...sheet.arrays import Array, Num
from ...sheet.formula import formula
from ...sheet.functions import acos, largest, pi, resultant, smallest, sqrt
from ...sheet.linked_array import column
from ...sheet.quantity import result, value
from ...sheet.record import record
from ...sheet.shown import Shown
from ...sheet.text import Text
from ...sheet.units import (
    KilogramPerMetre3,
    Metre,
    Metres,
    Number,
    Numbers,
    PascalSecond,
    RadPerSecond,
    SquareMetre,
    SquareMetres,
    Watt,
    Watts,
)
from ..inputs import FrictionInputs
from .oil_and_air import AIR_VISCOSITY

VRANCIK = Text("Vrancik 1968")
PLATE = Text(
    "rule of this program: a plate of the sector's height in air at rest, C_D 1.2 of a long plate, from memory"
)
LAMINAR: Number = 2000.0
DRAG: Number = 1.2
ON_TOP: Metre = 0.0


@result
class MassLoss(Shown):
    """What the sectors of one shaft lose to the mist."""

    mass_loss_low: Watt = value("Loss of the turning masses, at least", "W", "P_M,min", short=True)
    mass_loss_high: Watt = value("Loss of the turning masses, at most", "W", "P_M,max", short=True)
    mass_loss: Watt = value("Loss of the turning masses, counted", "W", "P_M", short=True)


@record
class Sectors:
    """The sectors of one shaft as they turn: lengths, outer and core radii, an element each; the speed of the shaft,
    one number or, of many operating points, an array; the gap to the shell that covers them, None where nothing does;
    the axis up from the crank's, None where it is not known."""

    lengths: Array
    outer_radii: Array
    core_radii: Array
    omega: RadPerSecond
    shell_gap: Metre | None
    up: Metre | None


def sectors_of(shaft: ShaftInputs, outline: Outline | None, omega: RadPerSecond) -> Sectors | None:
    """None where the outline of the shaft is not known, or has no sector."""
    pieces = [piece for piece in outline.pieces if piece.what == "sector"] if outline is not None else []
    if not pieces:
        return None
    b, R, r_0 = (column(pieces, name) for name in ("length", "outer_radius", "core_radius"))
    return Sectors(b, R, r_0, omega, shaft.shell_gap, None if shaft.axis is None else shaft.axis[0])


@formula("Re_Z", Text("{vrancik}: Reynolds number of the gap around the cylinder", vrancik=VRANCIK))
def gap_reynolds(rho: KilogramPerMetre3, omega: RadPerSecond, R: Metre, t: Metre, mu: PascalSecond) -> Number:
    return rho * omega * R * t / mu


@formula(
    "C_Z",
    Text("{vrancik}: skin friction of a cylinder in a gap; laminar up to Re = 2000, 2/Re", vrancik=VRANCIK),
    shows="C_Z from 1/√C_Z = 2.04 + 1.768·ln(Re_Z·√C_Z), Newton",
)
def skin_friction(Re: Numbers) -> Numbers:
    """>>> float(skin_friction(Re=np.array([1e5]))[0])
    0.0033221...
    """
    x = np.full(Re.shape, 10.0)  # 1/√C; the law bends down over it, so that the steps close in from below
    wanted = 2.04 + 1.768 * np.log(np.maximum(Re, LAMINAR))
    for _ in range(8):
        x -= (x + 1.768 * np.log(x) - wanted) / (1 + 1.768 / x)
    return np.where(Re > LAMINAR, x**-2, 2 / Re)


@formula("P_Z", Text("{vrancik}: power of a smooth cylinder that turns", vrancik=VRANCIK))
def cylinder_loss(C_Z: Number, rho: KilogramPerMetre3, omega: RadPerSecond, R: Metre, b: Metre) -> Watt:
    return pi * C_Z * rho * omega**3 * R**4 * b


@formula("P_P", Text("{plate}: its drag times its speed, from r_0 to R", plate=PLATE))
def plate_loss(rho: KilogramPerMetre3, omega: RadPerSecond, b: Metre, R: Metre, r_0: Metre) -> Watt:
    return DRAG / 2 * rho * omega**3 * b * (R**4 - r_0**4) / 4


@formula("P_M,min", "mathematics: sum over the sectors, each as the closed cylinder that it sweeps")
def least_loss(P_Z: Watts) -> Watt:
    return resultant(P_Z)


@formula("P_M,max", "mathematics: sum over the sectors, the plate besides", names={"P_low": "P_M,min"})
def most_loss(P_low: Watt, P_P: Watts) -> Watt:
    return P_low + resultant(P_P)


@formula(
    "P_M",
    "rule of this program: nothing says where between both it lies, so the mean in proportion",
    names={"P_low": "P_M,min", "P_high": "P_M,max"},
)
def counted_loss(P_low: Watt, P_high: Watt) -> Watt:
    return sqrt(P_low * P_high)


@formula("P_M", "rule of this program: in a shell the mist turns along, so the low end", names={"P_low": "P_M,min"})
def counted_in_shell(P_low: Watt) -> Watt:
    return P_low


def sectors_loss(
    b: Num,
    R: Num,
    r_0: Num,
    omega: RadPerSecond,
    rho: KilogramPerMetre3,
    mu: PascalSecond = AIR_VISCOSITY,
    shell_gap: Metre | None = None,
) -> MassLoss:
    """What `mass_loss` gives, of sizes that are known to be sound."""
    b, R, r_0 = (np.atleast_1d(x) for x in (b, R, r_0))
    t = R if shell_gap is None else shell_gap
    C_Z = skin_friction(Re=gap_reynolds(rho=rho, omega=omega, R=R, t=t, mu=mu))
    low = least_loss(P_Z=cylinder_loss(C_Z=C_Z, rho=rho, omega=omega, R=R, b=b))
    high = most_loss(P_low=low, P_P=plate_loss(rho=rho, omega=omega, b=b, R=R, r_0=r_0))
    counted = counted_loss(P_low=low, P_high=high) if shell_gap is None else counted_in_shell(P_low=low)
    return MassLoss(mass_loss_low=low, mass_loss_high=high, mass_loss=counted)


def mass_loss(
    b: Num,
    R: Num,
    r_0: Num,
    omega: RadPerSecond,
    rho: KilogramPerMetre3,
    mu: PascalSecond = AIR_VISCOSITY,
    shell_gap: Metre | None = None,
) -> MassLoss:
    """The loss of the sectors of a shaft that turns at `omega` [rad/s]: their lengths `b`, outer radii `R` and core
    radii `r_0` [m], arrays with an element each, or numbers of one; the loss is that of all together [W].

    `rho`: density of the mist [kg/m³] (24 by the tests of wheels); `mu`: viscosity of the air in it [Pa·s], which drops
    of oil do not thicken; `shell_gap`: between the sectors and the shell that covers them [m], None where nothing does.
    Raises BadInput where a size lies outside of the range that it has in a design file, speed or viscosity is no finite
    number, or the arrays are not of one length."""
    check_arguments(
        "mass_loss",
        b=(ShaftInputs.half_length, b),
        R=(ShaftInputs.outer_radius, R),
        r_0=(ShaftInputs.core_radius, r_0),
        rho=(FrictionInputs.mist_density, rho),
        shell_gap=(ShaftInputs.shell_gap, shell_gap),
    )
    demand_numbers("mass_loss", omega=omega, mu=mu)
    demand_alike("mass_loss", b=b, R=R, r_0=r_0)
    return sectors_loss(b, R, r_0, omega, rho, mu, shell_gap)


# --- sectors that dip into the oil


@formula(
    "h_S", "geometry: depth of the sectors under the oil at rest", unit="mm", names={"h_oil": "h_oil", "up": "x_S"}
)
def dip_depth(h_oil: Metre, up: Metre, R: Metre) -> Metre:
    """`h_oil`: oil at rest, `up`: axis of the shaft, both up from the crank's axis."""
    return smallest(largest(h_oil - up + R, ON_TOP), 2 * R)


@formula("A_S", "geometry: segment of the swept circle that is under oil", unit="mm²", names={"h": "h_S"})
def dipped_area(h: Metre, R: Metre) -> SquareMetre:
    return R**2 * acos(1 - h / R) - (R - h) * sqrt(h * (2 * R - h))


@formula(
    "P_D,max",
    "dynamics: what is swept under oil is thrown once a turn with the speed of the rim, a ceiling",
    names={"rho": "ρ_oil", "A": "A_S"},
)
def thrown_once_a_turn(rho: KilogramPerMetre3, R: Metres, omega: RadPerSecond, A: SquareMetres, b: Metres) -> Watt:
    return resultant(rho / 2 * (R * omega) ** 2 * A * b * omega / (2 * pi))


def dip_loss_most(
    b: Array, R: Array, omega: RadPerSecond, rho_oil: KilogramPerMetre3, oil_level: Metre, up: Metre
) -> Watt:
    """The most that sectors can lose to oil into which they dip, never counted: it says that they must run dry.

    `oil_level` at rest and `up`, the axis of the shaft: up from the crank's axis."""
    A = dipped_area(h=dip_depth(h_oil=oil_level, up=up, R=R), R=R)
    return thrown_once_a_turn(rho=rho_oil, R=R, omega=omega, A=A, b=b)
