# SPDX-License-Identifier: Apache-2.0
"""The spring of a scissor gear.  Forces stand along the transverse line of action."""

from ...sheet.arrays import Array, BoolArray
from ...sheet.formula import formula
from ...sheet.functions import largest
from ...sheet.record import record
from ...sheet.units import Metre, Newton, NewtonMetre, NewtonMetrePerRadian
from ...sheet.value import untraced
from .scissor_inputs import Scissor

SLACK: NewtonMetre = 0.0


@formula("T_S", "statics: a spring that backlash lets turn by j/r_b; slack, it turns nothing", names={"T": "T_S0"})
def spring_torque(T: NewtonMetre, c_S: NewtonMetrePerRadian, j: Metre, r_b: Metre) -> NewtonMetre:
    """`j`: along the line of action; `r_b`: of the split wheel.

    >>> spring_torque(T=4.0, c_S=85.9437, j=122e-6, r_b=25.0859e-3)
    3.58203...
    """
    return largest(T - c_S * j / r_b, SLACK)


@formula("F_S", "statics: force of the spring along the line of action")
def spring_force(T_S: NewtonMetre, r_b: Metre) -> Newton:
    return T_S / r_b


@record
class Spring:
    """A split gear in a mesh: what its wheel's base radius and its largest running backlash are."""

    given: Scissor
    radius: Metre
    backlash: Metre


def split_wheel(given: Scissor, driver: str, driven: str) -> str:
    """The wheel of a mesh that is split."""
    return given.wheel if given.wheel in (driver, driven) else driven


def sprung(given: Scissor, backlash: Metre, r_b: Metre, forces: Array) -> BoolArray:
    """Whether the spring holds the flanks closed, for least forces of any shape."""
    with untraced():
        T_S = spring_torque(T=given.torque, c_S=given.stiffness, j=backlash, r_b=r_b)
        held: BoolArray = spring_force(T_S=T_S, r_b=r_b) >= -forces
        return held
