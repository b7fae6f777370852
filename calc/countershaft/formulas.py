# SPDX-License-Identifier: Apache-2.0
"""The shaft from its eccentric masses, in the order of Finotti 2013, 4.1.

Vectors are complex numbers as in the imbalance step: real up, imaginary 90° further in the sense of crank rotation, cylinder 1 at
TDC.  They turn with the shaft, against the crank.  z from mid-shaft, + towards the flywheel.
"""

from ..sheet.formula import formula
from ..sheet.functions import argument, cis, modulus, resultant, total
from ..sheet.units import Kilogram, KilogramMetre, Metre, Newton, NewtonMetre, PhasorNewton, PhasorNewtonMetre, Radian, RadPerSecond

TABLE_4_1 = "Finotti 2013, 4.1 (with ω², not ω as printed there)"


@formula("F_S", TABLE_4_1)
def shaft_force(omega: RadPerSecond, m: Kilogram, e: Metre, gamma: Radian) -> PhasorNewton:
    """The rotating force that the shaft puts on its supports: what its masses do not balance statically."""
    return omega**2 * resultant(m * e * cis(gamma))


@formula("C_S", TABLE_4_1)
def shaft_couple(omega: RadPerSecond, m: Kilogram, e: Metre, z: Metre, gamma: Radian) -> PhasorNewtonMetre:
    return omega**2 * resultant(m * e * z * cis(gamma))


@formula("ΣU", "static unbalance: rotating force over ω²", unit="g·mm")
def static_unbalance(F_S: Newton, omega: RadPerSecond) -> KilogramMetre:
    return F_S / omega**2


@formula("Σm", "sum of the eccentric masses")
def eccentric_mass(m: Kilogram) -> Kilogram:
    return total(m)


@formula("R_r", "equilibrium of the shaft on two supports (Finotti 2013, 3.2.3.1)")
def reaction_rear(C_S: PhasorNewtonMetre, z_f: Metre, F_S: PhasorNewton, z_r: Metre) -> PhasorNewton:
    """The force of the rear support on the shaft; it turns with the shaft."""
    return -(C_S - z_f * F_S) / (z_r - z_f)


@formula("R_f", "equilibrium of the shaft on two supports (Finotti 2013, 3.2.3.1)")
def reaction_front(F_S: PhasorNewton, R_r: PhasorNewton) -> PhasorNewton:
    return -F_S - R_r


@formula("|R|", "modulus of the vector")
def reaction(R: PhasorNewton) -> Newton:
    return modulus(R)


@formula("|C_S|", "modulus of the vector")
def couple(C_S: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_S)


@formula("∠C_S", "direction of the vector while cylinder 1 stands at TDC")
def couple_phase(C_S: PhasorNewtonMetre) -> Radian:
    return argument(C_S)


@formula("|F_S|", "modulus of the vector")
def force(F_S: PhasorNewton) -> Newton:
    return modulus(F_S)


@formula("C_1⁻,res", "sum of the two vectors that turn backwards", names={"C_b": "C_1⁻"})
def residual_backward(C_b: PhasorNewtonMetre, C_S: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return C_b + C_S


@formula(
    "C_1,res",
    "largest first-order couple over a turn: the forward and the backward vector in line",
    names={"C_f": "C_1⁺", "C_b": "C_1⁻,res"},
)
def residual_couple(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_f) + modulus(C_b)


@formula(
    "F_1,res", "largest first-order force over a turn: the forward and the backward vector in line", names={"F_f": "F_1⁺", "F_b": "F_1⁻"}
)
def residual_force(F_f: PhasorNewton, F_b: PhasorNewton, F_S: PhasorNewton) -> Newton:
    return modulus(F_f) + modulus(F_b + F_S)
