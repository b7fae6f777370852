# SPDX-License-Identifier: Apache-2.0
"""What each remedy needs, and what it leaves: counterweights on the crank, and shafts that turn with or against it.

The counterweights of the crank take any share of what turns forward at crank speed.  A shaft at i times crank speed
takes the one vector that turns like it; its unbalance takes the force, unbalance times arm the couple.  Two shafts at
±i beside the cylinders' plane, at the same distance (Lanchester), raise no roll torque; a single one that carries a
force does."""

from typing import Any

import numpy as np

from ..engine.result import EngineResult
from ..sheet.formula import formula
from ..sheet.functions import argument, cis, joined, modulus, resultant
from ..sheet.quantity import group, result, value
from ..sheet.record import replace
from ..sheet.shown import Shown
from ..sheet.text import Amount, Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    Metre,
    Metres,
    Newton,
    NewtonMetre,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorMetre,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
    Radians,
    RadPerSecond,
)
from ..sheet.value import about, based_on
from . import orders as u
from .inputs import ImbalanceInputs

SHAFTS = Text("dynamics, rotating vector of the shaft against the vector that turns like it (Finotti 2013, 2.3.3)")
SIGNIFICANT = 1e-6  # of one cylinder's m·r·ω²: below this there is nothing to balance


@formula("U", SHAFTS, unit="kg·mm", names={"F_n": "F"})
def shaft_unbalance(F_n: PhasorNewton, i: Number, omega: RadPerSecond) -> KilogramMetre:
    """The unbalance of a shaft that turns at i times crank speed and takes the force F."""
    return modulus(F_n) / (i * omega) ** 2


@formula(
    "U·Δz",
    SHAFTS,
    unit="kg·mm²",
    names={"C_n": "C"},
    meanings={"i": "Speed of the shaft over that of the crank", "C_n": "Couple of the order"},
)
def shaft_product(C_n: PhasorNewtonMetre, i: Number, omega: RadPerSecond) -> KilogramMetre2:
    """Unbalance times arm of a shaft that turns at i times crank speed and takes the couple C."""
    return modulus(C_n) / (i * omega) ** 2


@formula("∠U", "dynamics: opposite to the force that it takes, cylinder 1 at TDC", names={"F_n": "F"})
def unbalance_direction(F_n: PhasorNewton) -> Radian:
    return argument(-F_n)


@formula(
    "∠U·Δz",
    "dynamics: opposite to the couple that it takes, cylinder 1 at TDC",
    names={"C_n": "C"},
    meanings={"C_n": "Couple of the order"},
)
def product_direction(C_n: PhasorNewtonMetre) -> Radian:
    return argument(-C_n)


@formula("F_S", "dynamics: centrifugal force of an unbalance")
def supplied_force(i: Number, omega: RadPerSecond, U: KilogramMetre, gamma: Radian) -> PhasorNewton:
    return (i * omega) ** 2 * U * cis(gamma)


@formula(
    "C_S",
    "dynamics: centrifugal couple of two opposed unbalances",
    names={"P": "U·Δz"},
    meanings={"i": "Speed of the shaft over that of the crank"},
)
def supplied_couple(i: Number, omega: RadPerSecond, P: KilogramMetre2, gamma: Radian) -> PhasorNewtonMetre:
    return (i * omega) ** 2 * P * cis(gamma)


@formula(
    "F_left",
    "geometry, sum of engine and shafts: half the long axis of the ellipse",
    names={"F_f": "F⁺", "F_b": "F⁻", "S_f": "F_S⁺", "S_b": "F_S⁻"},
    meanings={
        "F_f": "Force of the order that turns forward",
        "S_f": "Force of the shafts that turns forward",
        "S_b": "Force of the shafts that turns backward",
    },
)
def force_left(F_f: PhasorNewton, S_f: PhasorNewton, F_b: PhasorNewton, S_b: PhasorNewton) -> Newton:
    return modulus(joined(F_f, S_f)) + modulus(joined(F_b, S_b))


@formula(
    "C_left",
    "geometry, sum of engine and shafts: half the long axis of the ellipse",
    names={"C_f": "C⁺", "C_b": "C⁻", "S_f": "C_S⁺", "S_b": "C_S⁻"},
    meanings={
        "C_f": "Couple of the order that turns forward",
        "S_f": "Couple of the shafts that turns forward",
        "S_b": "Couple of the shafts that turns backward",
    },
)
def couple_left(
    C_f: PhasorNewtonMetre, S_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre, S_b: PhasorNewtonMetre
) -> NewtonMetre:
    return modulus(joined(C_f, S_f)) + modulus(joined(C_b, S_b))


@formula(
    "T_roll",
    "mathematics, amplitude of Im(p̄·F): a force that turns about an axis beside the crank's",
    names={"p": "p_S"},
)
def roll_torque(p: PhasorMetre, F: PhasorNewton) -> NewtonMetre:
    """The torque about the crank's axis of a force that turns about the axis at p (real up, imaginary to the side)."""
    return modulus(p) * modulus(F)


M_EQ = Text("Finotti 2013, 2.5.3.1: bob mass of a crankpin, rotating mass and the share κ of the reciprocating one")


@formula("M_eq", M_EQ, unit="g", meanings={"M_rot": "Rotating mass"})
def equivalent_mass(M_rot: Kilogram, kappa: Number, M_alt: Kilogram) -> Kilogram:
    return M_rot + kappa * M_alt


@formula("M_eq", Text("{m_eq}; κ_rot the share of the rotating mass", m_eq=M_EQ), unit="g", names={"rho": "κ_rot"})
def equivalent_mass_of_shares(rho: Number, M_rot: Kilogram, kappa: Number, M_alt: Kilogram) -> Kilogram:
    return rho * M_rot + kappa * M_alt


def crank_masses(imbalance: ImbalanceInputs, e: EngineResult) -> Any:
    """What the crank's counterweights carry of each cylinder: one mass for all, or one for each where they differ, (…,
    cylinders)."""
    M_alt, M_rot = u.masses(e)
    rho, kappa = imbalance.rotating_balance_fraction, imbalance.crank_balance_fraction
    if np.any(rho != 1):
        return equivalent_mass_of_shares(rho=rho, M_rot=M_rot, kappa=kappa, M_alt=M_alt)
    return equivalent_mass(M_rot=based_on(M_rot, M_rot, rho), kappa=kappa, M_alt=M_alt)


@formula("U_cr", "mathematics: sum of the crankpins' equivalent masses (Finotti 2013, 2.4)", unit="kg·mm")
def crank_unbalance(M_eq: Kilogram, r: Metre, theta_0: Radian, phi: Radians) -> PhasorKilogramMetre:
    return M_eq * r * cis(theta_0) * resultant(cis(phi))


@formula(
    "U·z_cr",
    "mathematics: sum of the crankpins' equivalent masses, about mid-engine (Finotti 2013, 2.4)",
    unit="kg·mm²",
)
def crank_product(M_eq: Kilogram, r: Metre, theta_0: Radian, z: Metres, phi: Radians) -> PhasorKilogramMetre2:
    return M_eq * r * cis(theta_0) * resultant(z * cis(phi))


@formula(
    "U_cw",
    "dynamics: two counterweights a span l apart, against force and couple of the crankpins (Finotti 2013, 2.4)",
    unit="kg·mm",
)
def counterweight(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, l: Metre, side: Number) -> PhasorKilogramMetre:
    """The unbalance of the rear (side +1) or front (side −1) counterweight; U and P of all crankpins about the middle
    of the span."""
    return -(U / 2 + side * P / l)


@formula("m_cw", "geometry: mass from unbalance and radius of its centre of gravity", unit="g")
def counterweight_mass(U_cw: PhasorKilogramMetre, r_cw: Metre) -> Kilogram:
    return modulus(U_cw) / r_cw


@formula("∠U_cw", "mathematics: direction of the counterweight, cylinder 1 at TDC")
def counterweight_direction(U_cw: PhasorKilogramMetre) -> Radian:
    return argument(U_cw)


@result
class BalanceShaft(Shown):
    """What one shaft of a remedy carries; directions with cylinder 1 at TDC, from up, in the sense of crank
    rotation."""

    speed_ratio: Number = value("Speed ratio to the crank", "", "i")
    unbalance: KilogramMetre | None = value("Unbalance", "kg·mm", "U", default=None)
    unbalance_phase: Radian | None = value("its direction", "°", default=None)
    unbalance_product: KilogramMetre2 | None = value("Unbalance times arm", "kg·mm²", "U·Δz", default=None)
    unbalance_product_phase: Radian | None = value("its direction", "°", default=None)


@result
class BalancingRemedy(Shown):
    """One remedy: its share on the crank, its shafts, and the peaks of force and couple that it leaves."""

    title: str
    crank_balance_fraction: Number = value("Share balanced on the crank", "", "κ")
    shafts: dict[str, BalanceShaft] = group(
        spread=True,
        key_words={
            "forward": Text("forward"),
            "backward": Text("backward"),
            "forward_2": Text("forward 2"),
            "backward_2": Text("backward 2"),
        },
    )
    order_1_force: Newton = value("First-order force left, peak", "N", "F_1")
    order_1_couple: NewtonMetre = value("First-order couple left, peak", "N·m", "C_1")
    order_2_force: Newton = value("Second-order force left, peak", "N", "F_2")
    order_2_couple: NewtonMetre = value("Second-order couple left, peak", "N·m", "C_2")
    roll_torque: NewtonMetre | None = value("Roll torque of the shaft beside the crank", "N·m", "T_roll", default=None)
    roll_torque_at_100_mm: NewtonMetre | None = value(
        "Roll torque with the shaft 100 mm beside the crank", "N·m", default=None
    )


@result
class Counterweight(Shown):
    """One of the two counterweights that take the crank's share."""

    mass: Kilogram = value("Mass", "g", "m_cw")
    angle: Radian = value("Direction, cylinder 1 at TDC", "°")


Vectors = tuple[complex, complex, complex, complex]
Supply = tuple[BalanceShaft | None, PhasorNewton, PhasorNewtonMetre]  # a shaft, if there is one, and what it supplies
NO_SHAFT: Supply = (None, 0j, 0j)
SECOND_ORDER = ("forward_2", "backward_2")


def remedies(
    omega: RadPerSecond,
    kappa: Number,
    first: Vectors,
    second: Vectors,
    whole: tuple[complex, complex],
    one_force: Newton,
    one_couple: NewtonMetre,
    axis: complex | None,
) -> dict[str, BalancingRemedy]:
    """Every remedy that has something to take.

    `first` and `second` are the vectors F⁺ F⁻ C⁺ C⁻ of the engine whose rotating masses alone are balanced; `whole`
    force and couple of crank counterweights for the whole reciprocating mass; `kappa` the share that the design's crank
    carries; `axis` where a single shaft stands [m], real up, imaginary to the side, None where not known."""

    def shaft(i: int, F: PhasorNewton, C: PhasorNewtonMetre) -> Supply:
        """The shaft at i times crank speed that takes F and C, and what it supplies."""
        balance_shaft = BalanceShaft(speed_ratio=float(i))
        F_S = C_S = 0j
        with about(Text("shaft at {i} times crank speed", i=Amount(i, form="+d"))):
            if needs_force := np.any(np.abs(F) > SIGNIFICANT * one_force):
                U, gamma = shaft_unbalance(F_n=F, i=float(i), omega=omega), unbalance_direction(F_n=F)
                F_S = supplied_force(i=float(i), omega=omega, U=U, gamma=gamma)
                balance_shaft = replace(balance_shaft, unbalance=U, unbalance_phase=gamma)
            if needs_couple := np.any(np.abs(C) > SIGNIFICANT * one_couple):
                P, gamma = shaft_product(C_n=C, i=float(i), omega=omega), product_direction(C_n=C)
                C_S = supplied_couple(i=float(i), omega=omega, P=P, gamma=gamma)
                balance_shaft = replace(balance_shaft, unbalance_product=P, unbalance_product_phase=gamma)
        return balance_shaft if needs_force or needs_couple else None, F_S, C_S

    (F_f, F_b, C_f, C_b), (F_f2, F_b2, C_f2, C_b2) = first, second
    shafts = {
        "backward": shaft(-1, F_b, C_b),
        "forward": shaft(1, F_f, C_f),
        "forward_2": shaft(2, F_f2, C_f2),
        "backward_2": shaft(-2, F_b2, C_b2),
    }
    backward, forward, plus, minus = (balance_shaft for balance_shaft, _, _ in shafts.values())

    def remedy(title: Text, share: Number, *names: str) -> BalancingRemedy:
        """`share` of the reciprocating masses on the crank, which acts on what turns forward only, and the shafts of
        these names."""
        left_f, left_c = joined(F_f, share * whole[0]), joined(C_f, share * whole[1])
        left_f, left_c = based_on(left_f, F_f, share, whole[0]), based_on(left_c, C_f, share, whole[1])
        used = {name: supply for name in names if (supply := shafts[name])[0] is not None}
        S_f, S_b, S_f2, S_b2 = (used.get(name, NO_SHAFT)[1:] for name in ("forward", "backward", *SECOND_ORDER))
        single = S_b[0] if "backward" in used and "forward" not in used and np.any(S_b[0]) else None
        with about(title):
            return BalancingRemedy(
                title=title,
                crank_balance_fraction=share,
                shafts={name: balance_shaft for name, (balance_shaft, _, _) in used.items() if balance_shaft},
                order_1_force=force_left(F_f=left_f, S_f=S_f[0], F_b=F_b, S_b=S_b[0]),
                order_1_couple=couple_left(C_f=left_c, S_f=S_f[1], C_b=C_b, S_b=S_b[1]),
                order_2_force=force_left(F_f=F_f2, S_f=S_f2[0], F_b=F_b2, S_b=S_b2[0]),
                order_2_couple=couple_left(C_f=C_f2, S_f=S_f2[1], C_b=C_b2, S_b=S_b2[1]),
                roll_torque=roll_torque(p=axis, F=single) if single is not None and axis is not None else None,
                roll_torque_at_100_mm=roll_torque(p=0.1 + 0j, F=single) if single is not None else None,
            )

    by_name = {"crank": remedy(Text("counterweights for half of the reciprocating mass"), 0.5)}
    if backward:
        by_name["backward_shaft"] = remedy(Text("the same, and one shaft at −1"), 0.5, "backward")
    if forward and backward:
        by_name["first_order_pair"] = remedy(Text("two shafts at ±1"), 0.0, "forward", "backward")
    if plus or minus:
        how = Text("two shafts at ±2") if plus and minus else Text("one shaft at {what}2", what="+" if plus else "−")
        title = Text("crank as designed, {how}", how=how)
        by_name["second_order_shafts"] = remedy(title, kappa, *SECOND_ORDER)
        if backward:
            title = Text("half on the crank, one shaft at −1, {how}", how=how)
            by_name["crank_and_shafts"] = remedy(title, 0.5, "backward", *SECOND_ORDER)
        if forward and backward:
            title = Text("two shafts at ±1, {how}", how=how)
            by_name["four_shafts"] = remedy(title, 0.0, "forward", "backward", *SECOND_ORDER)
    return by_name


def counterweights(
    M_eq: Kilogram, r: Metre, theta_0: Radian, phi: Radians, z: Metres, span: Metre, radius: Metre, unlike: bool = False
) -> dict[str, Counterweight]:
    """The two counterweights, a span apart about mid-engine, that carry the equivalent masses of all crankpins.

    `unlike`: `M_eq` has one for each.
    """
    U = (u.crank_unbalance if unlike else crank_unbalance)(M_eq=M_eq, r=r, theta_0=theta_0, phi=phi)
    P = (u.crank_product if unlike else crank_product)(M_eq=M_eq, r=r, theta_0=theta_0, z=z, phi=phi)
    weights = {}
    for name, side in (("front", -1.0), ("rear", 1.0)):
        with about(Text("{name} counterweight", name=name)):
            U_cw = counterweight(U=U, P=P, l=span, side=side)
            weights[name] = Counterweight(
                mass=counterweight_mass(U_cw=U_cw, r_cw=radius), angle=counterweight_direction(U_cw=U_cw)
            )
    return weights
