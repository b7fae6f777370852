# SPDX-License-Identifier: Apache-2.0
"""The target of a shaft that is out of balance on purpose, the shop's angles, and the rings that take it off.

Unbalances are vectors that turn with the shaft: real up, imaginary 90° further in the sense of crank rotation, cylinder
1 at TDC, also of a shaft that turns the other way.  The planes are the outer bearings', f and r."""

from math import copysign, radians

from ...sheet.formula import formula
from ...sheet.functions import argument, cis, modulus, pi, resultant, sqrt
from ...sheet.text import Text
from ...sheet.units import (
    Kilogram,
    KilogramMetre,
    Metre,
    Newton,
    Number,
    PhasorKilogramMetre,
    Radian,
    RevPerSecond,
)

TURN: Radian = 2 * pi
WHOLE = radians(1e-9)  # what is so close to a whole turn is none
LEVERS = Text("statics: the unbalance shared by the tolerance planes as their levers have it")
MASSES = {"m": "m_i", "e": "e_i", "z": "z_i", "gamma": "φ_i"}
MEANINGS = {
    "m": "Eccentric masses",
    "e": "Radii of the centres of gravity",
    "z": "Places of the eccentric masses",
    "gamma": "Directions of the eccentric masses",
}
SHOP = Text("definition: counted by the shop, from its zero, with the shaft's rotation or against it")
RING = Text("statics: both rings have the force and the moment of the target, against it")
COUNTED = {"s": "s_α", "phi": "φ", "phi_0": "φ_0"}
OF_SHOP = {
    "s": "1 where the shop counts as the crank turns, −1 against it",
    "phi_0": "Angle from which the shop counts",
}


@formula("U_f", LEVERS, unit="g·mm", names=MASSES, meanings=MEANINGS)
def target_front(m: Kilogram, e: Metre, gamma: Radian, z: Metre, z_f: Metre, z_r: Metre) -> PhasorKilogramMetre:
    """Of two equal masses in one direction, midway, one has to be in each plane.

    >>> import numpy as np
    >>> both = dict(m=np.array([1.0, 1.0]), e=0.01, gamma=np.array([0.0, 0.0]), z=np.array([-0.1, 0.1]))
    >>> round(abs(target_front(**both, z_f=-0.2, z_r=0.2)), 9)
    0.01
    """
    return resultant(m * e * cis(gamma) * (z_r - z) / (z_r - z_f))


@formula("U_r", LEVERS, unit="g·mm", names=MASSES, meanings=MEANINGS)
def target_rear(m: Kilogram, e: Metre, gamma: Radian, z: Metre, z_f: Metre, z_r: Metre) -> PhasorKilogramMetre:
    return resultant(m * e * cis(gamma) * (z - z_f) / (z_r - z_f))


@formula("|U|", "mathematics: length of the vector of an unbalance", unit="g·mm")
def length(U: PhasorKilogramMetre) -> KilogramMetre:
    return modulus(U)


@formula(
    "φ_U",
    "mathematics: direction of the vector, from 0 to 360°",
    shows="arg U, what is within 1e-9° of 360 is 0",
    meanings={"return": "Direction of an unbalance in the engine, cylinder 1 at TDC"},
)
def direction(U: PhasorKilogramMetre) -> Radian:
    return once(argument(U))


@formula(
    "α_z",
    SHOP,
    shows="s_α·(φ − φ_0), from 0 to 360°",
    names=COUNTED,
    meanings=OF_SHOP | {"phi": "Angle in the engine, cylinder 1 at TDC", "return": "Angle as the shop counts it"},
)
def shop_angle(s: Number, phi: Radian, phi_0: Radian) -> Radian:
    """>>> import math
    >>> round(math.degrees(shop_angle(s=-1.0, phi=math.radians(30), phi_0=math.radians(210))), 9)
    180.0
    """
    return once(s * (phi - phi_0))


@formula(
    "φ_α",
    SHOP,
    names=COUNTED | {"alpha": "α_z"},
    meanings=OF_SHOP | {"alpha": "Angle as the shop counts it", "return": "The same angle in the engine"},
)
def engine_angle(s: Number, alpha: Radian, phi_0: Radian) -> Radian:
    return phi_0 + s * alpha


def once(angle: Radian) -> Radian:
    """From 0 up to a whole turn."""
    turned = angle % TURN
    return 0.0 if TURN - turned < WHOLE or turned < WHOLE else turned


def sense(ratio: Number, count: str) -> Number:
    """1 where the shop counts in the sense of crank rotation, −1 against it; `ratio`: of the shaft to the crank."""
    return copysign(1.0, ratio) * (1.0 if count == "with" else -1.0)


@formula("U_1", RING, unit="g·mm", meanings={"z_1": "Plane of the front ring", "z_2": "Plane of the rear ring"})
def ring_front(
    U_f: PhasorKilogramMetre, z_f: Metre, U_r: PhasorKilogramMetre, z_r: Metre, z_1: Metre, z_2: Metre
) -> PhasorKilogramMetre:
    return -((U_f + U_r) * z_2 - (U_f * z_f + U_r * z_r)) / (z_2 - z_1)


@formula("U_2", RING, unit="g·mm", meanings={"z_1": "Plane of the front ring", "z_2": "Plane of the rear ring"})
def ring_rear(
    U_f: PhasorKilogramMetre, z_f: Metre, U_r: PhasorKilogramMetre, z_r: Metre, z_1: Metre, z_2: Metre
) -> PhasorKilogramMetre:
    return -((U_f * z_f + U_r * z_r) - (U_f + U_r) * z_1) / (z_2 - z_1)


@formula(
    "F_b",
    "dynamics: what the target puts on a pedestal of the balancing machine, without rings",
    names={"U": "|U|", "n_b": "n_M"},
    meanings={"U": "Target in the plane", "n_b": "Speed of the balancing machine"},
)
def machine_force(U: KilogramMetre, n_b: RevPerSecond) -> Newton:
    """>>> machine_force(U=0.0230240277884776, n_b=10.0)
    90.895218...
    """
    return U * (2 * pi * n_b) ** 2


@formula(
    "ΔU_m",
    "mathematics: root of squares of independent errors",
    unit="g·mm",
    names={"s_m": "s_M", "s_r": "s_R"},
    meanings={"s_m": "Standard error of the machine", "s_r": "Standard error of a ring"},
)
def uncertainty(s_m: KilogramMetre, s_r: KilogramMetre) -> KilogramMetre:
    return sqrt(s_m**2 + s_r**2)


@formula(
    "U_e",
    "definition: what the reading has beyond the target",
    unit="g·mm",
    names={"phi": "φ_α"},
    meanings={
        "U_m": "Unbalance that was read",
        "phi": "Its direction in the engine",
        "U_t": "Target still in the reading, 0 where it was taken off",
    },
)
def excess(U_m: KilogramMetre, phi: Radian, U_t: PhasorKilogramMetre) -> PhasorKilogramMetre:
    return U_m * cis(phi) - U_t


@formula(
    "U_left",
    "statics: what is too much less what the holes take, as their levers have it",
    unit="g·mm",
    names={"u": "u_k", "x": "x_k", "gamma": "φ_k"},
    meanings={
        "u": "Unbalance that each hole takes",
        "x": "Share of the plane in each hole, by its lever",
        "gamma": "Directions of the holes",
        "U_e": "What the reading has beyond the target",
    },
)
def left(U_e: PhasorKilogramMetre, u: KilogramMetre, x: Number, gamma: Radian) -> PhasorKilogramMetre:
    return U_e - resultant(u * x * cis(gamma))
