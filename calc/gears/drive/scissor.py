# SPDX-License-Identifier: Apache-2.0
"""A scissor gear: a wheel split across its width, whose halves a spring turns against each other, so that both flanks
of the mesh stay closed while the torque reverses.

Forces stand along the transverse line of action.  The spring's is least where the mesh has its largest backlash; it
holds while it is not below what would draw the flanks apart, and where it does not, the mesh counts as without it. Both
halves carry it, at rest too: the main half beside the load, the sprung half on its coast flank."""

from collections.abc import Callable, Iterator

import numpy as np

from ...engine.inputs import EngineInputs
from ...sheet.arrays import Array
from ...sheet.check import Check, CheckRule
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import largest, pi
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Hertzes,
    Metre,
    Newton,
    NewtonMetre,
    Newtons,
    Number,
    RevPerSecond,
    Watt,
)
from ...sheet.value import about, based_on, untraced
from ..inputs import GearsInputs
from ..rating.load import RatingContext
from .result import ScissorResult
from .scissor_inputs import Scissor
from .spring import split_wheel, spring_force, spring_torque
from .strength import held

USUAL_SHARE = 0.3  # of the face width, of the sprung half
ABOVE_IDLE = 1.5
NOTHING: Newton = 0.0
KEY = dotted("gears", GearsInputs.meshes, "#", "scissor")


@formula("T_S,min", "statics: torque of the spring that outweighs the least force over the cycle", names={"F": "F_min"})
def needed_torque(F: Newton, r_b: Metre) -> NewtonMetre:
    """`F`: of the mesh while it stays closed; nothing is needed where that is above 0.

    >>> needed_torque(F=-107.2, r_b=25.0859e-3)
    2.68920...
    """
    return largest(-F, NOTHING) * r_b


@formula("F_M", "statics: the main half carries the load and the spring")
def force_of_main_half(F: Newton, F_S: Newton) -> Newton:
    return F + F_S


@formula(
    "n_o",
    "rule of this program: lowest speed where the spring is too weak, straight between the speeds that are computed",
    unit="rpm",
    shows="lowest speed at which −F_min is above F_S",
    names={"F": "F_min"},
)
def opening_speed(n: Hertzes, F: Newtons, F_S: Newton) -> RevPerSecond:
    """`n`: rising speeds of the crank (S,), `F`: least force at each.  Asked only where some of them open it."""
    over = -F - F_S
    i = int(np.argmax(over > 0))
    if i == 0:
        return float(n[0])
    return float(n[i - 1] + (n[i] - n[i - 1]) * over[i - 1] / (over[i - 1] - over[i]))


@formula("b_S", "rule of this program: three tenths of the mesh carry the spring, the rest the load", unit="mm")
def usual_width(b: Metre) -> Metre:
    return USUAL_SHARE * b


@formula("n_S", "rule of this program: idle, with what an engine drops and hunts about it", unit="rpm")
def usual_range(n_i: RevPerSecond) -> RevPerSecond:
    return ABOVE_IDLE * n_i


@formula("P", "definition of power: force along the line of action at the speed of its flanks")
def power_of_force(F: Newton, n: RevPerSecond, r_b: Metre) -> Watt:
    """>>> power_of_force(F=100.0, n=40.0, r_b=25e-3)
    628.318...
    """
    return F * 2 * pi * abs(n) * r_b


@formula(
    "P_S",
    "energy: what both halves lose, over the loss of the mesh without a spring",
    names={"P_M": "P_VZ,M", "P_F": "P_VZ,F", "P_0": "P_VZ"},
)
def scissor_loss(P_M: Watt, P_F: Watt, P_0: Watt) -> Watt:
    """Losses of the main half, the sprung half, and of the whole width without the spring."""
    return P_M + P_F - P_0


@record
class ScissorCase:
    """What the drive knows of the mesh of a split wheel.  Forces are those of closed flanks."""

    backlash: Metre  # largest running, along the line of action
    idle_speed: RevPerSecond  # of the crank, as are all speeds here
    idle_force: Newton  # least over the cycle, idle, no load
    speeds: Array  # (S,) rising
    forces: Array  # (S, L) least over the cycle at each speed and load
    steady: Newton | None = None  # mean, at the speed of the rating
    most: Newton | None = None  # largest over the cycle, there
    lost: Callable[[Watt, Metre], Watt] | None = None  # loss of the mesh of a power and a face width, there


def scissor(given: Scissor, context: RatingContext, key: str, case: ScissorCase) -> ScissorResult:
    """The split wheel of a mesh: what its spring holds, up to which speed, and what that costs.

    Strength and loss are those of the spring at no backlash, where it is strongest."""
    mesh = context.train.meshes[key]
    wheel = context.train.wheels[split_wheel(given, mesh.driver, mesh.driven)]
    r_b = based_on(wheel.base_diameter / 2, wheel.base_diameter)
    with about(Text("scissor gear of {pair}", pair=mesh.title)):
        T_S = spring_torque(T=given.torque, c_S=given.stiffness, j=case.backlash, r_b=r_b)
        needed = needed_torque(F=case.idle_force, r_b=r_b)
        to = given.to if given.to is not None else usual_range(n_i=case.idle_speed)
        held_force, worst = spring_force(T_S=T_S, r_b=r_b), based_on(case.forces.min(axis=1), case.forces)
        over_range = needed_torque(F=_least_up_to(to, case.speeds, worst, case.idle_force), r_b=r_b)
        opens = None
        if np.any(-worst > held_force):
            opens = opening_speed(n=case.speeds, F=worst, F_S=held_force)
        b_S = given.face_width if given.face_width is not None else usual_width(b=mesh.face_width)
        rest = based_on(mesh.face_width - b_S, mesh.face_width, b_S)
        if not rest > 0:
            raise NoSolution(
                Text("scissor gear of {pair}: nothing is left of its main half", pair=mesh.title),
                tried=Text("face_width_mm = {b}", b=Amount(b_S * 1e3, form=".4g")),
                advice=Text("give less than the {b} mm of the mesh", b=Amount(mesh.face_width * 1e3, form=".4g")),
            )
        F_S = spring_force(T_S=given.torque, r_b=r_b)
        main, loss = None, None
        if case.most is not None:
            main = held(context, key, force_of_main_half(F=case.most, F_S=F_S), wheel.name, rest)
        sprung_half = held(context, key, F_S, wheel.name, b_S)
        if case.lost is not None and case.steady is not None:
            with_spring = force_of_main_half(F=case.steady, F_S=F_S)
            parts = ((with_spring, rest), (F_S, b_S), (case.steady, mesh.face_width))
            P_M, P_F, P_0 = (_loss(case.lost, power_of_force(F=F, n=wheel.speed, r_b=r_b), b) for F, b in parts)
            loss = scissor_loss(P_M=P_M, P_F=P_F, P_0=P_0)
    return ScissorResult(
        torque_least=T_S,
        needed=needed,
        needed_range=over_range,
        opens_at=opens,
        loss=loss,
        main_safety_contact=main.contact if main is not None else None,
        main_safety_bending=_least(main.bending) if main is not None else None,
        sprung_safety_contact=sprung_half.contact if sprung_half is not None else None,
        sprung_safety_bending=_least(sprung_half.bending) if sprung_half is not None else None,
        wheel=wheel.name,
        width=b_S,
        to=to,
        torque=given.torque,
    )


def _least_up_to(to: RevPerSecond, speeds: Array, worst: Array, idle: Newton) -> Newton:
    """The least force from idle up to a speed of the crank, straight between the speeds that are computed."""
    inside = worst[speeds <= to]
    end = np.interp(to, speeds, worst)
    return based_on(float(min(idle, end, *inside)), idle, worst)


def _loss(lost: Callable[[Watt, Metre], Watt], P: Watt, b: Metre) -> Watt:
    with untraced():
        loss = lost(P, b)
    return based_on(float(loss), P, b)


def _least(safeties: dict[str, Number | None]) -> Number | None:
    return min((S for S in safeties.values() if S is not None), default=None)


# --- what is judged

SCISSOR = CheckRule(
    "gears.M.scissor",
    "limit",
    "The spring is there to hold the flanks closed at idle, and nothing else: opened, both halves strike.",
    unit="N·m",
    source=Text("statics: spring at the largest running backlash against the least force over the cycle"),
    role="physics",
    zero="torque of the spring at no backlash",
    value_id=dotted("gears", "M", "scissor", ScissorResult.torque_least),
    limit_id=dotted("gears", "M", "scissor", ScissorResult.needed),
    moved_by=(
        dotted(KEY, Scissor.torque),
        dotted(KEY, Scissor.stiffness),
        dotted("engine", EngineInputs.flywheel_inertia),
    ),
    short=Text("scissor"),
)
SCISSOR_RANGE = CheckRule(
    "gears.M.scissor_range",
    "caution",
    "Above idle the flanks open and clatter.",
    unit="N·m",
    source=SCISSOR.source,
    zero=SCISSOR.zero,
    cause=SCISSOR.id,
    value_id=SCISSOR.value_id,
    limit_id=dotted("gears", "M", "scissor", ScissorResult.needed_range),
    moved_by=(dotted(KEY, Scissor.torque), dotted(KEY, Scissor.to)),
)


def scissor_checks(key: str, title: str, index: int, spring: ScissorResult) -> Iterator[Check]:
    """`index`: of the mesh in its array."""
    about_idle = Text("Spring of the scissor gear {pair}, idle, no load", pair=title)
    yield SCISSOR(spring.torque_least, spring.needed, at=key, index=index, name=about_idle, scale=spring.torque)
    about_range = Text(
        "Spring of the scissor gear {pair}, up to {n} at any load", pair=title, n=Amount(spring.to * 60, "rpm")
    )
    yield SCISSOR_RANGE(
        spring.torque_least, spring.needed_range, at=key, index=index, name=about_range, scale=spring.torque
    )
