# SPDX-License-Identifier: Apache-2.0
"""What a torque over the crank angle gives, whether of the gas or of a diagram."""

from ..sheet.arrays import many
from ..sheet.formula import formula
from ..sheet.functions import modulus
from ..sheet.units import KilogramMetre2, NewtonMetre, Number, RadPerSecond, Watt


@formula("T_hi", "mathematics: largest of the points of the cycle, its corners among them", shows="largest T(ε)")
def highest(T: NewtonMetre) -> NewtonMetre:
    return float(many(T).max())


@formula("T_lo", "mathematics: smallest of the points of the cycle, its corners among them", shows="smallest T(ε)")
def lowest(T: NewtonMetre) -> NewtonMetre:
    return float(many(T).min())


@formula("|T|", "mathematics: amount of the torque at the crank angle where it is largest")
def amount(T: NewtonMetre) -> NewtonMetre:
    return modulus(T)


@formula("P_i", "definition of power", unit="kW")
def indicated_power(T_m: NewtonMetre, omega: RadPerSecond) -> Watt:
    return T_m * omega


@formula("δ_s", "dynamics: speed irregularity (ω_max − ω_min)/ω_m of a flywheel, ΔE = J·ω²·δ_s")
def speed_irregularity(Delta_E: NewtonMetre, J: KilogramMetre2, omega: RadPerSecond) -> Number:
    return Delta_E / (J * omega**2)
