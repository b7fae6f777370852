# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of one order, of one engine or of many: their vectors, their ellipses, and their peaks."""

from collections.abc import Callable
from typing import Any, Generic

import numpy as np

from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..sheet.arrays import Value
from ..sheet.formula import formula
from ..sheet.functions import cis, conj, resultant
from ..sheet.quantity import group, result, value
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import (
    Kilogram,
    Metre,
    Metres,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNewton,
    PhasorNewtonMetre,
    PhasorNumber,
    Radian,
    Radians,
    RadPerSecond,
)
from ..sheet.value import based_on
from . import formulas as f
from .inputs import ImbalanceInputs

# --- sums over the cylinders where their masses or crank radii differ
# Those of `formulas.py`, `remedies.py` and `webs.py`, each inside.
#
# Names and parameters are theirs; m, M_rot, M_eq, r and c_n may have an entry for every cylinder.  Textbooks: vector
# sums of m·r and m·r·z, such as Khurmi and Gupta, Theory of Machines, Balancing of Rotating Masses, and of
# Reciprocating ones.

VECTORS = Text("Finotti 2013, 2.2.3 and 2.4")  # here for any order, throws, banks, masses and radii
SHARE = Text(
    "Finotti 2013, 2.3.3: the share κ of the reciprocating masses, each carried by a counterweight opposite its pin "
    "and at its radius"
)
PINS = Text("Finotti 2013, 2.4: sum over the crankpins, here each with its own mass and radius")
BOBS = Text("Finotti 2013, 2.6: what the bobs lack of the equivalent masses, here each with its own mass and radius")


def masses(e: EngineResult) -> tuple[Any, Any]:
    """What reciprocates and what rotates: the masses that all cylinders have, or those of each."""
    return (e.reciprocating_mass, e.rotating_mass) if e.unlike is None else (e.unlike.reciprocating, e.unlike.rotating)


def radius(engine: EngineInputs, e: EngineResult) -> Any:
    """The crank radius that all cylinders have, or that of each."""
    return engine.crank_radius if e.unlike is None else e.unlike.radius


def harmonics(e: EngineResult, kinematics: str = "two_term") -> tuple[Any, ...]:
    """The harmonics of a/(ω² r), those that all cylinders have or those of each."""
    source = e if e.unlike is None else e.unlike
    return source.harmonics if kinematics == "exact" else source.two_term


def measures(engine: EngineInputs, e: EngineResult) -> tuple[Metre, Number]:
    """The crank radius and ratio of the one cylinder that what is left is held against: means of those that differ."""
    if e.unlike is None:
        return engine.crank_radius, e.lambda_
    r, lam = e.unlike.radius, e.unlike.lambda_
    return based_on(float(np.mean(r)), r), based_on(float(np.mean(lam)), lam)


@formula(
    "F_n⁺",
    Text("{vectors}: force of an order that turns forward", vectors=VECTORS),
    meanings={"n": "Order", "psi": "Bank angles of the cylinders"},
)
def force_forward(
    omega: RadPerSecond,
    m: Kilogram,
    r: Metre,
    c_n: PhasorNumber,
    n: Number,
    theta_0: Radian,
    psi: Radians,
    phi: Radians,
) -> PhasorNewton:
    return 0.5 * omega**2 * cis(n * theta_0) * resultant(m * r * c_n * cis(psi) * cis(n * (phi - psi)))


@formula(
    "F_n⁻",
    Text("{vectors}: force of an order that turns backward", vectors=VECTORS),
    meanings={"n": "Order", "psi": "Bank angles of the cylinders"},
)
def force_backward(
    omega: RadPerSecond,
    m: Kilogram,
    r: Metre,
    c_n: PhasorNumber,
    n: Number,
    theta_0: Radian,
    psi: Radians,
    phi: Radians,
) -> PhasorNewton:
    return 0.5 * omega**2 * cis(-n * theta_0) * resultant(m * r * conj(c_n) * cis(psi) * cis(-n * (phi - psi)))


@formula(
    "C_n⁺",
    Text("{vectors}: couple of an order that turns forward", vectors=VECTORS),
    meanings={"n": "Order", "psi": "Bank angles of the cylinders"},
)
def couple_forward(
    omega: RadPerSecond,
    m: Kilogram,
    r: Metre,
    c_n: PhasorNumber,
    n: Number,
    theta_0: Radian,
    z: Metres,
    psi: Radians,
    phi: Radians,
) -> PhasorNewtonMetre:
    return 0.5 * omega**2 * cis(n * theta_0) * resultant(m * r * c_n * z * cis(psi) * cis(n * (phi - psi)))


@formula(
    "C_n⁻",
    Text("{vectors}: couple of an order that turns backward", vectors=VECTORS),
    meanings={"n": "Order", "psi": "Bank angles of the cylinders"},
)
def couple_backward(
    omega: RadPerSecond,
    m: Kilogram,
    r: Metre,
    c_n: PhasorNumber,
    n: Number,
    theta_0: Radian,
    z: Metres,
    psi: Radians,
    phi: Radians,
) -> PhasorNewtonMetre:
    return 0.5 * omega**2 * cis(-n * theta_0) * resultant(m * r * conj(c_n) * z * cis(psi) * cis(-n * (phi - psi)))


@formula("F_κ", SHARE)
def counterweight_force(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, phi: Radians
) -> PhasorNewton:
    return -kappa * omega**2 * cis(theta_0) * resultant(m * r * cis(phi))


@formula("C_κ", SHARE)
def counterweight_couple(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, z: Metres, phi: Radians
) -> PhasorNewtonMetre:
    return -kappa * omega**2 * cis(theta_0) * resultant(m * r * z * cis(phi))


@formula("F_rot", PINS, names={"rho": "κ_rot"})
def rotating_force(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, phi: Radians
) -> PhasorNewton:
    return (1 - rho) * omega**2 * cis(theta_0) * resultant(M_rot * r * cis(phi))


@formula("C_rot", PINS, names={"rho": "κ_rot"})
def rotating_couple(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, z: Metres, phi: Radians
) -> PhasorNewtonMetre:
    return (1 - rho) * omega**2 * cis(theta_0) * resultant(M_rot * r * z * cis(phi))


@formula("U_cr", PINS, unit="kg·mm")
def crank_unbalance(M_eq: Kilogram, r: Metre, theta_0: Radian, phi: Radians) -> PhasorKilogramMetre:
    return cis(theta_0) * resultant(M_eq * r * cis(phi))


@formula("U·z_cr", PINS, unit="kg·mm²")
def crank_product(M_eq: Kilogram, r: Metre, theta_0: Radian, z: Metres, phi: Radians) -> PhasorKilogramMetre2:
    return cis(theta_0) * resultant(M_eq * r * z * cis(phi))


@formula("U·z", BOBS, unit="kg·mm²", names={"r_p": "r_P", "z_p": "z_P", "phi_p": "φ_P"})
def lacking_product(
    r: Metre,
    theta_0: Radian,
    M_eq: Kilogram,
    z: Metres,
    phi: Radians,
    m_b: Kilogram,
    r_p: Metre,
    z_p: Metres,
    phi_p: Radians,
) -> PhasorKilogramMetre2:
    return cis(theta_0) * (resultant(M_eq * r * z * cis(phi)) - resultant(m_b * r_p * z_p * cis(phi_p)))


@formula("U", BOBS, unit="kg·mm", names={"r_p": "r_P", "phi_p": "φ_P"})
def lacking_unbalance(
    r: Metre, theta_0: Radian, M_eq: Kilogram, phi: Radians, m_b: Kilogram, r_p: Metre, phi_p: Radians
) -> PhasorKilogramMetre:
    return cis(theta_0) * (resultant(M_eq * r * cis(phi)) - resultant(m_b * r_p * cis(phi_p)))


# --- one order

DUST = 1e-9  # of one cylinder's m·r·ω²: so little is not worth a figure


@result
class Order(Shown, Generic[Value]):
    """One order: the vectors turning with and against the crank at n times its speed, after the crank's own
    counterweights.

    Peak, least and axis are half the long axis, half the short axis and the direction of the long axis of the ellipse
    that the two vectors draw; a circle has no axis."""

    force_forward: Value = value("Force turning forward", "N", "F⁺", short=True)
    force_forward_phase: Value = value("its phase", "°")
    force_backward: Value = value("Force turning backward", "N", "F⁻", short=True)
    force_backward_phase: Value = value("its phase", "°")
    force_peak_vertical: Value = value("Largest vertical force", "N", "F_V")
    force_peak_horizontal: Value = value("Largest horizontal force", "N", "F_H")
    force_peak: Value = value("Largest force", "N", "F_max", short=True, page_one=4, headline=3)
    force_least: Value = value("Smallest force over the turn", "N", "F_min")
    force_axis: Value | None = value("Direction of the largest force", "°", "∠F_max")
    couple_forward: Value = value("Couple turning forward", "N·m", "C⁺", short=True)
    couple_forward_phase: Value = value("its phase", "°")
    couple_backward: Value = value("Couple turning backward", "N·m", "C⁻", short=True)
    couple_backward_phase: Value = value("its phase", "°")
    couple_peak_vertical: Value = value("Largest vertical couple", "N·m", "C_V")
    couple_peak_horizontal: Value = value("Largest horizontal couple", "N·m", "C_H")
    couple_peak: Value = value("Largest couple", "N·m", "C_max", short=True, page_one=3, headline=4)
    couple_least: Value = value("Smallest couple over the turn", "N·m", "C_min")
    couple_axis: Value | None = value("Direction of the largest couple", "°", "∠C_max")
    vectors: tuple[complex, complex, complex, complex]  # F⁺ F⁻ C⁺ C⁻
    # the same with no share of the reciprocating masses on the crank
    unbalanced: tuple[complex, complex, complex, complex]
    two_term: "Order[Value] | None" = group(default=None, short=False, words="two term")


def order(n: int, c_n: complex, imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult) -> Order:
    """Order n of engines whose crank carries a share of the reciprocating and rotating masses; `c_n`: the harmonic of
    a/(ω² r)."""
    alike, (m, M_rot) = e.unlike is None, masses(e)
    omega, r, theta_0 = e.angular_speed, radius(engine, e), e.crank.theta_0
    phi, z, psi = e.crank.phi, e.crank.z, e.crank.psi  # arrays enter the formulas here
    F_f = F_f0 = (f.force_forward if alike else force_forward)(omega, m, r, c_n, float(n), theta_0, psi, phi)
    F_b = (f.force_backward if alike else force_backward)(omega, m, r, c_n, float(n), theta_0, psi, phi)
    C_f = C_f0 = (f.couple_forward if alike else couple_forward)(omega, m, r, c_n, float(n), theta_0, z, psi, phi)
    C_b = (f.couple_backward if alike else couple_backward)(omega, m, r, c_n, float(n), theta_0, z, psi, phi)
    if n == 1:
        kappa, rho = imbalance.crank_balance_fraction, imbalance.rotating_balance_fraction
        if np.any(rho != 1):
            F_rot = (f.rotating_force if alike else rotating_force)(rho, omega, M_rot, r, theta_0, phi)
            F_f0 = f.with_rotating_force(F_1=F_f, F_rot=F_rot)
            C_rot = (f.rotating_couple if alike else rotating_couple)(rho, omega, M_rot, r, theta_0, z, phi)
            C_f0 = f.with_rotating_couple(C_1=C_f, C_rot=C_rot)
        F_f0, C_f0 = based_on(F_f0, F_f0, rho), based_on(C_f0, C_f0, rho)
        F_f = f.remaining_force(
            F_f0, (f.counterweight_force if alike else counterweight_force)(kappa, omega, m, r, theta_0, phi)
        )
        C_f = f.remaining_couple(
            C_f0, (f.counterweight_couple if alike else counterweight_couple)(kappa, omega, m, r, theta_0, z, phi)
        )
    return Order(
        force_forward=f.force_length(F=F_f),
        force_forward_phase=f.force_direction(F=F_f),
        force_backward=f.force_length(F=F_b),
        force_backward_phase=f.force_direction(F=F_b),
        force_peak_vertical=f.force_peak_vertical(F_f, F_b),
        force_peak_horizontal=f.force_peak_horizontal(F_f, F_b),
        force_peak=f.force_peak(F_f, F_b),
        force_least=f.force_least(F_f, F_b),
        force_axis=_axis(f.force_axis, F_f, F_b),
        couple_forward=f.couple_length(C=C_f),
        couple_forward_phase=f.couple_direction(C=C_f),
        couple_backward=f.couple_length(C=C_b),
        couple_backward_phase=f.couple_direction(C=C_b),
        couple_peak_vertical=f.couple_peak_vertical(C_f, C_b),
        couple_peak_horizontal=f.couple_peak_horizontal(C_f, C_b),
        couple_peak=f.couple_peak(C_f, C_b),
        couple_least=f.couple_least(C_f, C_b),
        couple_axis=_axis(f.couple_axis, C_f, C_b),
        vectors=(F_f, F_b, C_f, C_b),
        unbalanced=(F_f0, F_b, C_f0, C_b),
    )


def _axis(formula: Callable[[complex, complex], Radian], forward: complex, backward: complex) -> Radian | None:
    """The direction of an ellipse's long axis; None for a circle, NaN for one among many."""
    there = (np.abs(forward) > 0) & (np.abs(backward) > 0)
    if not np.any(there):
        return None
    axis = formula(forward, backward)
    return np.where(there, axis, np.nan) if isinstance(axis, np.ndarray) else axis
