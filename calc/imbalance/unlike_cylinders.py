# SPDX-License-Identifier: Apache-2.0
"""The sums over the cylinders where their masses or crank radii differ: those of `formulas.py`, `remedies.py` and
`webs.py`, each inside.

Names and parameters are theirs; m, M_rot, M_eq, r and c_n may have an entry for every cylinder.  Textbooks: vector sums
of m·r and m·r·z, such as Khurmi and Gupta, Theory of Machines, Balancing of Rotating Masses, and of Reciprocating ones.
"""

import numpy as np

from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..sheet.formula import formula
from ..sheet.functions import cis, conj, resultant
from ..sheet.text import Text
from ..sheet.units import (
    Kilogram,
    Metre,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNewton,
    PhasorNewtonMetre,
    PhasorNumber,
    Radian,
    RadPerSecond,
)
from ..sheet.value import based_on

VECTORS = Text("Finotti 2013, 2.2.3 and 2.4")  # here for any order, throws, banks, masses and radii
SHARE = Text(
    "Finotti 2013, 2.3.3: the share κ of the reciprocating masses, each carried by a counterweight opposite its pin "
    "and at its radius"
)
PINS = Text("Finotti 2013, 2.4: sum over the crankpins, here each with its own mass and radius")
BOBS = Text("Finotti 2013, 2.6: what the bobs lack of the equivalent masses, here each with its own mass and radius")


def masses(e: EngineResult) -> tuple[Kilogram, Kilogram]:
    """What reciprocates and what rotates: the masses that all cylinders have, or those of each."""
    return (e.reciprocating_mass, e.rotating_mass) if e.unlike is None else (e.unlike.reciprocating, e.unlike.rotating)


def radius(engine: EngineInputs, e: EngineResult) -> Metre:
    """The crank radius that all cylinders have, or that of each."""
    return engine.crank_radius if e.unlike is None else e.unlike.radius


def harmonics(e: EngineResult, kinematics: str = "two_term") -> tuple[complex, ...]:
    """The harmonics of a/(ω² r), those that all cylinders have or those of each."""
    found = e if e.unlike is None else e.unlike
    return found.harmonics if kinematics == "exact" else found.two_term


def measures(engine: EngineInputs, e: EngineResult) -> tuple[Metre, Number]:
    """The crank radius and ratio of the one cylinder that what is left is held against: means of those that differ."""
    if e.unlike is None:
        return engine.crank_radius, e.lambda_
    r, lam = e.unlike.radius, e.unlike.lambda_
    return based_on(float(np.mean(r)), r), based_on(float(np.mean(lam)), lam)


@formula("F_n⁺", Text("{vectors}: force of an order that turns forward", vectors=VECTORS))
def force_forward(
    omega: RadPerSecond, m: Kilogram, r: Metre, c_n: PhasorNumber, n: Number, theta_0: Radian, psi: Radian, phi: Radian
) -> PhasorNewton:
    return 0.5 * omega**2 * cis(n * theta_0) * resultant(m * r * c_n * cis(psi) * cis(n * (phi - psi)))


@formula("F_n⁻", Text("{vectors}: force of an order that turns backward", vectors=VECTORS))
def force_backward(
    omega: RadPerSecond, m: Kilogram, r: Metre, c_n: PhasorNumber, n: Number, theta_0: Radian, psi: Radian, phi: Radian
) -> PhasorNewton:
    return 0.5 * omega**2 * cis(-n * theta_0) * resultant(m * r * conj(c_n) * cis(psi) * cis(-n * (phi - psi)))


@formula("C_n⁺", Text("{vectors}: couple of an order that turns forward", vectors=VECTORS))
def couple_forward(
    omega: RadPerSecond,
    m: Kilogram,
    r: Metre,
    c_n: PhasorNumber,
    n: Number,
    theta_0: Radian,
    z: Metre,
    psi: Radian,
    phi: Radian,
) -> PhasorNewtonMetre:
    return 0.5 * omega**2 * cis(n * theta_0) * resultant(m * r * c_n * z * cis(psi) * cis(n * (phi - psi)))


@formula("C_n⁻", Text("{vectors}: couple of an order that turns backward", vectors=VECTORS))
def couple_backward(
    omega: RadPerSecond,
    m: Kilogram,
    r: Metre,
    c_n: PhasorNumber,
    n: Number,
    theta_0: Radian,
    z: Metre,
    psi: Radian,
    phi: Radian,
) -> PhasorNewtonMetre:
    return 0.5 * omega**2 * cis(-n * theta_0) * resultant(m * r * conj(c_n) * z * cis(psi) * cis(-n * (phi - psi)))


@formula("F_κ", SHARE)
def counterweight_force(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, phi: Radian
) -> PhasorNewton:
    return -kappa * omega**2 * cis(theta_0) * resultant(m * r * cis(phi))


@formula("C_κ", SHARE)
def counterweight_couple(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, z: Metre, phi: Radian
) -> PhasorNewtonMetre:
    return -kappa * omega**2 * cis(theta_0) * resultant(m * r * z * cis(phi))


@formula("F_rot", PINS, names={"rho": "κ_rot"})
def rotating_force(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, phi: Radian
) -> PhasorNewton:
    return (1 - rho) * omega**2 * cis(theta_0) * resultant(M_rot * r * cis(phi))


@formula("C_rot", PINS, names={"rho": "κ_rot"})
def rotating_couple(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, z: Metre, phi: Radian
) -> PhasorNewtonMetre:
    return (1 - rho) * omega**2 * cis(theta_0) * resultant(M_rot * r * z * cis(phi))


@formula("U_cr", PINS, unit="kg·mm")
def crank_unbalance(M_eq: Kilogram, r: Metre, theta_0: Radian, phi: Radian) -> PhasorKilogramMetre:
    return cis(theta_0) * resultant(M_eq * r * cis(phi))


@formula("U·z_cr", PINS, unit="kg·mm²")
def crank_product(M_eq: Kilogram, r: Metre, theta_0: Radian, z: Metre, phi: Radian) -> PhasorKilogramMetre2:
    return cis(theta_0) * resultant(M_eq * r * z * cis(phi))


@formula("U·z", BOBS, unit="kg·mm²", names={"r_p": "r_P", "z_p": "z_P", "phi_p": "φ_P"})
def lacking_product(
    r: Metre,
    theta_0: Radian,
    M_eq: Kilogram,
    z: Metre,
    phi: Radian,
    m_b: Kilogram,
    r_p: Metre,
    z_p: Metre,
    phi_p: Radian,
) -> PhasorKilogramMetre2:
    return cis(theta_0) * (resultant(M_eq * r * z * cis(phi)) - resultant(m_b * r_p * z_p * cis(phi_p)))


@formula("U", BOBS, unit="kg·mm", names={"r_p": "r_P", "phi_p": "φ_P"})
def lacking_unbalance(
    r: Metre, theta_0: Radian, M_eq: Kilogram, phi: Radian, m_b: Kilogram, r_p: Metre, phi_p: Radian
) -> PhasorKilogramMetre:
    return cis(theta_0) * (resultant(M_eq * r * cis(phi)) - resultant(m_b * r_p * cis(phi_p)))
