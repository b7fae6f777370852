# SPDX-License-Identifier: Apache-2.0
"""The sums over the cylinders where their masses differ: those of `formulas.py`, `remedies.py` and `webs.py` with each mass inside.

Names and parameters are theirs; m, M_rot and M_eq have an entry for every cylinder.  Textbooks: vector sums of m·r and m·r·z, such as
Khurmi and Gupta, Theory of Machines, Balancing of Reciprocating Masses.
"""

from ..engine.result import EngineResult
from ..sheet.arrays import each
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
)  # fmt: skip

FORWARD = Text("Finotti 2013, 2.2.3 and 2.4: reciprocating force as two turning vectors, here for any order, throws, banks and masses")
SHARE = Text("Finotti 2013, 2.3.3: the share κ of the reciprocating masses, each carried by a counterweight opposite its pin")
PINS = Text("Finotti 2013, 2.4: sum over the crankpins, here each with its own mass")
BOBS = Text("Finotti 2013, 2.6: what the bobs lack of the equivalent masses, here each with its own")


def masses(e: EngineResult) -> tuple[Kilogram, Kilogram]:
    """What reciprocates and what rotates: the masses that all cylinders have, or those of each."""
    return (e.reciprocating_mass, e.rotating_mass) if e.unlike is None else (each(e.unlike.reciprocating), each(e.unlike.rotating))


@formula("F_n⁺", FORWARD)
def force_forward(
    omega: RadPerSecond, m: Kilogram, r: Metre, c_n: PhasorNumber, n: Number, theta_0: Radian, psi: Radian, phi: Radian
) -> PhasorNewton:
    return 0.5 * omega**2 * r * c_n * cis(n * theta_0) * resultant(m * cis(psi) * cis(n * (phi - psi)))


@formula("F_n⁻", FORWARD)
def force_backward(
    omega: RadPerSecond, m: Kilogram, r: Metre, c_n: PhasorNumber, n: Number, theta_0: Radian, psi: Radian, phi: Radian
) -> PhasorNewton:
    return 0.5 * omega**2 * r * conj(c_n) * cis(-n * theta_0) * resultant(m * cis(psi) * cis(-n * (phi - psi)))


@formula("C_n⁺", FORWARD)
def couple_forward(
    omega: RadPerSecond, m: Kilogram, r: Metre, c_n: PhasorNumber, n: Number, theta_0: Radian, z: Metre, psi: Radian, phi: Radian
) -> PhasorNewtonMetre:
    return 0.5 * omega**2 * r * c_n * cis(n * theta_0) * resultant(m * z * cis(psi) * cis(n * (phi - psi)))


@formula("C_n⁻", FORWARD)
def couple_backward(
    omega: RadPerSecond, m: Kilogram, r: Metre, c_n: PhasorNumber, n: Number, theta_0: Radian, z: Metre, psi: Radian, phi: Radian
) -> PhasorNewtonMetre:
    return 0.5 * omega**2 * r * conj(c_n) * cis(-n * theta_0) * resultant(m * z * cis(psi) * cis(-n * (phi - psi)))


@formula("F_κ", SHARE)
def counterweight_force(kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, phi: Radian) -> PhasorNewton:
    return -kappa * omega**2 * r * cis(theta_0) * resultant(m * cis(phi))


@formula("C_κ", SHARE)
def counterweight_couple(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, z: Metre, phi: Radian
) -> PhasorNewtonMetre:
    return -kappa * omega**2 * r * cis(theta_0) * resultant(m * z * cis(phi))


@formula("F_rot", PINS, names={"rho": "κ_rot"})
def rotating_force(rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, phi: Radian) -> PhasorNewton:
    return (1 - rho) * omega**2 * r * cis(theta_0) * resultant(M_rot * cis(phi))


@formula("C_rot", PINS, names={"rho": "κ_rot"})
def rotating_couple(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, z: Metre, phi: Radian
) -> PhasorNewtonMetre:
    return (1 - rho) * omega**2 * r * cis(theta_0) * resultant(M_rot * z * cis(phi))


@formula("U_cr", PINS, unit="kg·mm")
def crank_unbalance(M_eq: Kilogram, r: Metre, theta_0: Radian, phi: Radian) -> PhasorKilogramMetre:
    return r * cis(theta_0) * resultant(M_eq * cis(phi))


@formula("U·z_cr", PINS, unit="kg·mm²")
def crank_product(M_eq: Kilogram, r: Metre, theta_0: Radian, z: Metre, phi: Radian) -> PhasorKilogramMetre2:
    return r * cis(theta_0) * resultant(M_eq * z * cis(phi))


@formula("U·z", BOBS, unit="kg·mm²", names={"z_p": "z_P", "phi_p": "φ_P"})
def lacking_product(
    r: Metre, theta_0: Radian, M_eq: Kilogram, z: Metre, phi: Radian, m_b: Kilogram, z_p: Metre, phi_p: Radian
) -> PhasorKilogramMetre2:
    return r * cis(theta_0) * (resultant(M_eq * z * cis(phi)) - resultant(m_b * z_p * cis(phi_p)))


@formula("U", BOBS, unit="kg·mm", names={"phi_p": "φ_P"})
def lacking_unbalance(r: Metre, theta_0: Radian, M_eq: Kilogram, phi: Radian, m_b: Kilogram, phi_p: Radian) -> PhasorKilogramMetre:
    return r * cis(theta_0) * (resultant(M_eq * cis(phi)) - resultant(m_b * cis(phi_p)))
