# SPDX-License-Identifier: Apache-2.0
"""The spring of a scissor gear, and what is published of one.  Forces stand along the transverse line of action."""

from ...sheet.arrays import Array, BoolArray
from ...sheet.formula import formula
from ...sheet.functions import largest
from ...sheet.quantity import result, value
from ...sheet.record import record
from ...sheet.units import Metre, Newton, NewtonMetre, NewtonMetrePerRadian, Number, RevPerSecond, Watt
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


@result
class ScissorResult:
    """A split wheel in its mesh; what is None is not known."""

    torque_least: NewtonMetre = value("Torque of the spring at the largest backlash", "N·m", "T_S")
    needed: NewtonMetre = value("Torque that holds the flanks closed, idle, no load", "N·m", "T_S,min")
    needed_range: NewtonMetre = value("Torque that holds them closed up to its speed, any load", "N·m", "T_S,min")
    opens_at: RevPerSecond | None = value("Lowest speed at which they part, any load", "rpm", "n_o", default=None)
    loss: Watt | None = value("Power that the spring costs in the mesh, at most", "W", "P_S", default=None)
    main_safety_contact: Number | None = value("Main half: safety against pitting", "", "S_H", default=None)
    main_safety_bending: Number | None = value("Main half: safety against tooth breakage", "", "S_F", default=None)
    sprung_safety_contact: Number | None = value("Sprung half: safety against pitting", "", "S_H", default=None)
    sprung_safety_bending: Number | None = value("Sprung half: safety against tooth breakage", "", "S_F", default=None)
    wheel: str
    width: Metre  # of the sprung half
    to: RevPerSecond  # of the crank, up to which it shall hold
    torque: NewtonMetre  # at no backlash


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
