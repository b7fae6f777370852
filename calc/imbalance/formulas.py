# SPDX-License-Identifier: Apache-2.0
"""Inertia forces and couples as vectors that turn with (⁺) and against (⁻) the crank at n times its speed.

A vector is a complex number: real up, imaginary 90° further in the sense of crank rotation, taken while cylinder 1
stands at TDC. Forces act from the moving parts on the block; a couple is Σ z·F, positive = rear force up.  φ are the
throws, ψ the banks, θ₀ the angle of throw 1 at that moment, c_n the harmonics of a/(ω² r)."""

from ..sheet.formula import formula
from ..sheet.functions import argument, cis, conj, joined, modulus, pi, resultant, sin
from ..sheet.text import Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    Metre,
    Metres,
    Newton,
    NewtonMetre,
    Number,
    PhasorNewton,
    PhasorNewtonMetre,
    PhasorNumber,
    Radian,
    Radians,
    RadPerSecond,
)

VECTORS = Text("Finotti 2013, 2.2.3 and 2.3.3")  # there of the first two orders; here of any order, throws and banks
SHARE = (
    "Finotti 2013, 2.3.2: couple of the counterweights that carry the share κ of the reciprocating masses, opposite "
    "the pins"
)
SUM = "mathematics: sum of the turning vectors of reciprocating and rotating masses"
VERTICAL = "geometry, ellipse of two counter-turning vectors: largest vertical component"
HORIZONTAL = "geometry, ellipse of two counter-turning vectors: largest horizontal component"
LONG_AXIS = "geometry, ellipse of two counter-turning vectors: half its long axis"
SHORT_AXIS = "geometry, ellipse of two counter-turning vectors: half its short axis"
DIRECTION = "geometry, ellipse of two counter-turning vectors: direction of its long axis from up"
ONE_TOOTH = "mathematics, exact difference of two vectors one tooth of the shaft's wheel apart"
FORCES, COUPLES = {"F_f": "F⁺", "F_b": "F⁻"}, {"C_f": "C⁺", "C_b": "C⁻"}


@formula(
    "F_n⁺",
    Text("{vectors}: force of an order that turns forward", vectors=VECTORS),
    names={"m": "M_alt"},
    meanings={"n": "Order", "psi": "Bank angles of the cylinders", "c_n": "Harmonics of the acceleration"},
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
    return 0.5 * omega**2 * m * r * c_n * cis(n * theta_0) * resultant(cis(psi) * cis(n * (phi - psi)))


@formula(
    "F_n⁻",
    Text("{vectors}: force of an order that turns backward", vectors=VECTORS),
    names={"m": "M_alt"},
    meanings={"n": "Order", "psi": "Bank angles of the cylinders", "c_n": "Harmonics of the acceleration"},
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
    return 0.5 * omega**2 * m * r * conj(c_n) * cis(-n * theta_0) * resultant(cis(psi) * cis(-n * (phi - psi)))


@formula(
    "C_n⁺",
    Text("{vectors}: couple of an order that turns forward", vectors=VECTORS),
    names={"m": "M_alt"},
    meanings={"n": "Order", "psi": "Bank angles of the cylinders", "c_n": "Harmonics of the acceleration"},
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
    return 0.5 * omega**2 * m * r * c_n * cis(n * theta_0) * resultant(z * cis(psi) * cis(n * (phi - psi)))


@formula(
    "C_n⁻",
    Text("{vectors}: couple of an order that turns backward", vectors=VECTORS),
    names={"m": "M_alt"},
    meanings={"n": "Order", "psi": "Bank angles of the cylinders", "c_n": "Harmonics of the acceleration"},
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
    return 0.5 * omega**2 * m * r * conj(c_n) * cis(-n * theta_0) * resultant(z * cis(psi) * cis(-n * (phi - psi)))


@formula(
    "F_κ",
    SHARE,
    names={"m": "M_alt"},
    meanings={"return": "Force of the counterweights that carry the share κ of the reciprocating masses"},
)
def counterweight_force(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, phi: Radians
) -> PhasorNewton:
    return -kappa * omega**2 * m * r * cis(theta_0) * resultant(cis(phi))


@formula("C_κ", SHARE, names={"m": "M_alt"})
def counterweight_couple(
    kappa: Number, omega: RadPerSecond, m: Kilogram, r: Metre, theta_0: Radian, z: Metres, phi: Radians
) -> PhasorNewtonMetre:
    return -kappa * omega**2 * m * r * cis(theta_0) * resultant(z * cis(phi))


@formula(
    "F_rot",
    "dynamics: centrifugal force of what the crank's counterweights leave of the rotating masses",
    names={"rho": "κ_rot"},
)
def rotating_force(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, phi: Radians
) -> PhasorNewton:
    return (1 - rho) * omega**2 * M_rot * r * cis(theta_0) * resultant(cis(phi))


@formula(
    "C_rot", "dynamics: couple of what the crank's counterweights leave of the rotating masses", names={"rho": "κ_rot"}
)
def rotating_couple(
    rho: Number, omega: RadPerSecond, M_rot: Kilogram, r: Metre, theta_0: Radian, z: Metres, phi: Radians
) -> PhasorNewtonMetre:
    return (1 - rho) * omega**2 * M_rot * r * cis(theta_0) * resultant(z * cis(phi))


@formula("F_0⁺", SUM, names={"F_1": "F_1⁺"})
def with_rotating_force(F_1: PhasorNewton, F_rot: PhasorNewton) -> PhasorNewton:
    return joined(F_1, F_rot)


@formula("C_0⁺", SUM, names={"C_1": "C_1⁺"})
def with_rotating_couple(C_1: PhasorNewtonMetre, C_rot: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(C_1, C_rot)


@formula(
    "F_1⁺,κ",
    "mathematics: force of order 1 that turns forward, with the counterweights; they change neither F_1⁻ nor a higher "
    "order",
    names={"F_1": "F_1⁺"},
    meanings={
        "F_1": "Force of order 1 that turns forward",
        "return": "Force of order 1 that turns forward, with the counterweights",
    },
)
def remaining_force(F_1: PhasorNewton, F_kappa: PhasorNewton) -> PhasorNewton:
    return joined(F_1, F_kappa)


@formula(
    "C_1⁺,κ",
    "mathematics: couple of order 1 that turns forward, with the counterweights; they change neither C_1⁻ nor a "
    "higher order",
    names={"C_1": "C_1⁺"},
    meanings={
        "C_1": "Couple of order 1 that turns forward",
        "return": "Couple of order 1 that turns forward, with the counterweights",
    },
)
def remaining_couple(C_1: PhasorNewtonMetre, C_kappa: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(C_1, C_kappa)


@formula("F_V", VERTICAL, names=FORCES)
def force_peak_vertical(F_f: PhasorNewton, F_b: PhasorNewton) -> Newton:
    return modulus(joined(F_f, conj(F_b)))


@formula("F_H", HORIZONTAL, names=FORCES)
def force_peak_horizontal(F_f: PhasorNewton, F_b: PhasorNewton) -> Newton:
    return modulus(joined(F_f, -conj(F_b)))


@formula("C_V", VERTICAL, names=COUPLES)
def couple_peak_vertical(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(joined(C_f, conj(C_b)))


@formula("C_H", HORIZONTAL, names=COUPLES)
def couple_peak_horizontal(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(joined(C_f, -conj(C_b)))


@formula("F_max", LONG_AXIS, names=FORCES)
def force_peak(F_f: PhasorNewton, F_b: PhasorNewton) -> Newton:
    return modulus(F_f) + modulus(F_b)


@formula("F_min", SHORT_AXIS, names=FORCES)
def force_least(F_f: PhasorNewton, F_b: PhasorNewton) -> Newton:
    return modulus(joined(modulus(F_f), -modulus(F_b)))


@formula("∠F_max", DIRECTION, names=FORCES)
def force_axis(F_f: PhasorNewton, F_b: PhasorNewton) -> Radian:
    return argument(F_f * F_b) / 2


@formula("C_max", LONG_AXIS, names=COUPLES)
def couple_peak(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_f) + modulus(C_b)


@formula("C_min", SHORT_AXIS, names=COUPLES)
def couple_least(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(joined(modulus(C_f), -modulus(C_b)))


@formula("∠C_max", DIRECTION, names=COUPLES)
def couple_axis(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre) -> Radian:
    return argument(C_f * C_b) / 2


@formula(
    "C_S",
    "Finotti 2013, 2.5.3.3: the shaft opposes the backward couple of the first order",
    names={"C_b": "C_1⁻"},
    meanings={"return": "Couple that the counter-shaft must supply"},
)
def required_couple(C_b: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return -C_b


@formula("|F|", "mathematics, length of the vector", unit="N")
def force_length(F: PhasorNewton) -> Newton:
    return modulus(F)


@formula("∠F", "mathematics, direction of the vector from up, while cylinder 1 stands at TDC")
def force_direction(F: PhasorNewton) -> Radian:
    return argument(F)


@formula("|C|", "mathematics, length of the vector")
def couple_length(C: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C)


@formula("∠C", "mathematics, direction of the vector from up, while cylinder 1 stands at TDC")
def couple_direction(C: PhasorNewtonMetre) -> Radian:
    return argument(C)


@formula("U·Δz", "dynamics, couple over ω²: the product of unbalance and arm that the shaft needs", unit="kg·mm²")
def unbalance_product(C_S: NewtonMetre, omega: RadPerSecond) -> KilogramMetre2:
    """>>> unbalance_product(C_S=572.9, omega=272.3)
    0.007726512...
    """
    return C_S / omega**2


@formula(
    "C_2,F",
    "Finotti 2013, 2.5.3.4 (wrong: it leaves out the share that the crank balances, which order 2 does not know)",
)
def second_order_couple_of_finotti(kappa: Number, C_2: NewtonMetre) -> NewtonMetre:
    """The thesis takes the mass that is not balanced on the crank, (1 − κ)·M_alt; the full reciprocating mass acts at
    order 2."""
    return (1 - kappa) * C_2


@formula("ΔC/1°", "mathematics, exact difference of two vectors one degree apart")
def couple_per_degree(C_S: NewtonMetre) -> NewtonMetre:
    """>>> couple_per_degree(C_S=572.9)
    9.998864...
    """
    return 2 * C_S * sin(pi / 360)


@formula("ΔC/tooth", ONE_TOOTH, names={"z": "z_w"})
def couple_per_tooth(C_S: NewtonMetre, z: Number) -> NewtonMetre:
    return 2 * C_S * sin(pi / z)


@formula(
    "F_S",
    "Finotti 2013, 2.3.3: the shaft opposes the backward force of the first order",
    names={"F_b": "F_1⁻"},
    meanings={"return": "Force that the counter-shaft must supply"},
)
def required_force(F_b: PhasorNewton) -> PhasorNewton:
    return -F_b


@formula("U", "dynamics, force over ω²: the unbalance that the shaft needs", unit="kg·mm")
def required_unbalance(F_S: Newton, omega: RadPerSecond) -> KilogramMetre:
    return F_S / omega**2


@formula("ΔF/1°", "mathematics, exact difference of two vectors one degree apart")
def force_per_degree(F_S: Newton) -> Newton:
    return 2 * F_S * sin(pi / 360)


@formula("ΔF/tooth", ONE_TOOTH, names={"z": "z_w"})
def force_per_tooth(F_S: Newton, z: Number) -> Newton:
    return 2 * F_S * sin(pi / z)
