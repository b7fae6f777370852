# SPDX-License-Identifier: Apache-2.0
"""Two balance shafts where they stand: the roll that their forces raise about the crank's axis, beside that of the
inertia forces.

Two equal shafts at ±n, mirrored at the cylinders' plane, raise none.  At unequal heights their sideways forces,
opposite and equal, make a moment; placed well it stands against the torque reaction of order n (the Silent Shaft of
Mitsubishi)."""

import math
from collections.abc import Iterator

from ..engine.result import EngineResult
from ..sheet.check import Check, CheckRule
from ..sheet.formula import formula
from ..sheet.functions import argument, conj, imag, joined, modulus
from ..sheet.quantity import dotted, result, value
from ..sheet.shown import Shown
from ..sheet.step import Table
from ..sheet.text import Text
from ..sheet.units import Metre, Newton, NewtonMetre, PhasorMetre, PhasorNewton, PhasorNewtonMetre, Radian, RadPerSecond
from ..sheet.value import about, based_on
from .inputs import ImbalanceInputs
from .remedies import BalanceShaft, BalancingRemedy, supplied_force

PAIRS = {1: ("first_order_pair", "forward", "backward"), 2: ("second_order_shafts", "forward_2", "backward_2")}


@formula("F_S", "dynamics: amount of the force of one shaft", names={"F": "F_S"})
def shaft_force(F: PhasorNewton) -> Newton:
    return modulus(F)


ROLL_OF_A_SHAFT = Text("statics: moment about the crank's axis of a force that turns about an axis beside it")


@formula("T_S⁺", Text("{roll}, with the crank", roll=ROLL_OF_A_SHAFT), names={"p": "p⁺", "F": "F_S⁺"})
def roll_forward(p: PhasorMetre, F: PhasorNewton) -> PhasorNewtonMetre:
    """The moment on the block is Re(T·e^(inε)), positive in the sense of crank rotation: Im(p̄·F) of the force as it
    turns.  p, F: real up, imaginary 90° further in that sense; F with cylinder 1 at TDC (ε = 0).

    >>> roll_forward(p=0.10 + 0.08j, F=1000 + 0j)
    (-80-100j)
    """
    return -1j * conj(p) * F


@formula("T_S⁻", Text("{roll}, against the crank", roll=ROLL_OF_A_SHAFT), names={"p": "p⁻", "F": "F_S⁻"})
def roll_backward(p: PhasorMetre, F: PhasorNewton) -> PhasorNewtonMetre:
    """The same of a force F·e^(−inε): i·p·F̄.  A shaft and its mirror image at equal heights raise no roll:

    >>> roll_forward(p=0.10 + 0.08j, F=1000 + 0j) + roll_backward(p=0.10 - 0.08j, F=1000 + 0j)
    0j
    """
    return conj(-1j * conj(p) * F)


@formula("T_S", "mathematics: sum of the moments of two shafts, or of those before and one more")
def rolls_joined(T_1: PhasorNewtonMetre, T_2: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(T_1, T_2)


@formula("T_roll", "mathematics: amplitude of a moment about the crank's axis")
def roll_amplitude(T_S: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(T_S)


@formula("∠T_S", "mathematics: phase of a torque that is T·cos(n·ε + ∠T), cylinder 1 at TDC at ε = 0")
def roll_phase(T_S: PhasorNewtonMetre) -> Radian:
    return argument(T_S)


@formula(
    "T_RI+S",
    "mathematics: sum of the shafts' moment and the torque reaction of the inertia forces of that order",
    names={"t_n": "t_RI,n"},
)
def roll_together(T_S: PhasorNewtonMetre, t_n: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(T_S, t_n)


@formula("Δh", "geometry: how much higher the shaft stands that turns with the crank", names={"h_f": "h⁺", "h_b": "h⁻"})
def height_difference(h_f: Metre, h_b: Metre) -> Metre:
    return h_f - h_b


@formula(
    "Δh_0",
    Text(
        "mathematics: least amount of a sum, the moment being linear in the height difference (two terms, inline four: "
        "the rod length; idea of unequal heights: Nakamura 1976, from memory)"
    ),
    names={"T": "T_RI+S", "F_f": "F_S⁺", "F_b": "F_S⁻"},
)
def best_height_difference(Dh: Metre, T: PhasorNewtonMetre, F_f: PhasorNewton, F_b: PhasorNewton) -> Metre:
    """Both shafts moved by as much, one up and one down, from where `T` is left; their sideways places stay."""
    return Dh + 2 * imag(conj(F_f + conj(F_b)) * T) / modulus(F_f + conj(F_b)) ** 2


@result
class ShaftPair(Shown):
    """Two shafts of one order at their places, and the roll about the crank's axis with and without them."""

    force_forward: Newton = value("Force of the shaft that turns forward", "N", "F_S⁺")
    force_backward: Newton = value("Force of the shaft that turns backward", "N", "F_S⁻")
    height_difference: Metre = value("Height of the forward shaft over the other", "mm", "Δh")
    roll_torque: NewtonMetre = value("Roll torque of both shafts", "N·m", "T_roll")
    roll_torque_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    reaction: NewtonMetre = value("Torque reaction of the inertia forces, that order", "N·m", "T_RI,n")
    reaction_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    roll_left: NewtonMetre = value("Roll left of both", "N·m", "T_left")
    height_difference_of_least_roll: Metre | None = value(
        "Height difference of the least roll", "mm", "Δh_0", default=None
    )


def shaft_pair(imbalance: ImbalanceInputs, e: EngineResult, remedy: dict[str, BalancingRemedy]) -> ShaftPair | None:
    """The pair against the order asked for, at the places given; None where none is given, or where the pair carries no
    force."""
    forward, backward, n = imbalance.forward_shaft_axis, imbalance.backward_shaft_axis, imbalance.shaft_pair_order
    name, *sides = PAIRS[n]
    if forward is None or backward is None or e.torque is None or name not in remedy:
        return None
    with about(Text("two shafts at ±{n}", n=n)):
        F_f, F_b = (_force(remedy[name].shafts.get(side), e.angular_speed) for side in sides)
        if not F_f and not F_b:
            return None
        p_f, p_b = (based_on(complex(*place), place) for place in (forward, backward))
        F_f, F_b = based_on(F_f, F_f, n), based_on(F_b, F_b, n)
        t_n = e.torque.reaction_harmonics[n - 1]
        t_n = based_on(t_n, t_n, n)
        Dh = height_difference(h_f=based_on(forward[0], forward, n), h_b=backward[0])
        T_S = rolls_joined(T_1=roll_forward(p=p_f, F=F_f), T_2=roll_backward(p=p_b, F=F_b))
        T = roll_together(T_S=T_S, t_n=t_n)
        sways = abs(F_f + F_b.conjugate()) > 1e-9 * abs(F_f)  # else a height difference raises no moment
        return ShaftPair(
            force_forward=shaft_force(F=F_f),
            force_backward=shaft_force(F=F_b),
            height_difference=Dh,
            roll_torque=roll_amplitude(T_S=T_S),
            roll_torque_phase=roll_phase(T_S=T_S),
            reaction=roll_amplitude(T_S=t_n),
            reaction_phase=roll_phase(T_S=t_n),
            roll_left=roll_amplitude(T_S=T),
            height_difference_of_least_roll=best_height_difference(Dh=Dh, T=T, F_f=F_f, F_b=F_b) if sways else None,
        )


def _force(shaft: BalanceShaft | None, omega: RadPerSecond) -> PhasorNewton:
    if shaft is None or shaft.unbalance is None or shaft.unbalance_phase is None:
        return 0j
    return supplied_force(i=shaft.speed_ratio, omega=omega, U=shaft.unbalance, gamma=shaft.unbalance_phase)


ROLL = CheckRule(
    "imbalance.shaft_pair.roll",
    "advice",
    "Roll is a matter of comfort; the places of the shafts can take of it, or add to it.",
    Text("Roll with the pair of shafts"),
    "<=",
    "N·m",
    Text("rule of this program: the places of the shafts should not add to the torque reaction of the inertia forces"),
    Text(
        "At equal heights and distances the pair adds nothing; the shaft that turns with the crank belongs higher "
        "than the other where the height difference of the least roll is positive."
    ),
    zero="roll torque of both shafts",
    value_id=dotted("imbalance", "shaft_pair", ShaftPair.roll_left),
    limit_id=dotted("imbalance", "shaft_pair", ShaftPair.reaction),
    moved_by=(
        dotted("imbalance", ImbalanceInputs.forward_shaft_axis),
        dotted("imbalance", ImbalanceInputs.backward_shaft_axis),
    ),
)


def roll_check(pair: ShaftPair) -> Check:
    """Whether the places of the shafts make the roll worse than it is without them."""
    return ROLL(pair.roll_left, pair.reaction, scale=pair.roll_torque)


def roll_notes(imbalance: ImbalanceInputs) -> Iterator[Text]:
    """What is said of the roll about the crank's axis where no pair has a table that tells it."""
    if imbalance.forward_shaft_axis is not None:
        yield Text(
            "No pair of shafts carries a force of order {n} here: their places raise no roll torque.",
            n=imbalance.shaft_pair_order,
        )
    yield Text(
        "The torque reaction about the crank's axis stands in the engine step. Of its inertia part two shafts of "
        "forces at unlike heights take some; that of the gas no mass takes."
    )


def pair_table(pair: ShaftPair, n: int, remedy: dict[str, BalancingRemedy]) -> Table:
    """The pair: its forces, and what is left of force and roll."""
    whole = remedy[PAIRS[n][0]]
    best = pair.height_difference_of_least_roll
    columns = (
        (Text("shafts at"), "", f"±{n}"),
        (Text("force forward"), "N", pair.force_forward),
        (Text("force backward"), "N", pair.force_backward),
        (Text("force left"), "N", whole.order_1_force if n == 1 else whole.order_2_force),
        (Text("Δh"), "mm", pair.height_difference * 1e3),
        (Text("roll of the shafts"), "N·m", pair.roll_torque),
        (Text("phase"), "°", math.degrees(pair.roll_torque_phase)),
        (Text("roll of inertia"), "N·m", pair.reaction),
        (Text("phase"), "°", math.degrees(pair.reaction_phase)),
        (Text("roll left"), "N·m", pair.roll_left),
        (Text("Δh of least roll"), "mm", None if best is None else best * 1e3),
    )
    return Table(
        "shaft_pair",
        Text("Two balance shafts at their places"),
        tuple((label, unit) for label, unit, _ in columns),
        (tuple(cell for *_, cell in columns),),
        Text(
            "Roll about the crank's axis on the block, T·cos(n·ε + phase), positive in the sense of rotation; ε from "
            "TDC of cylinder 1. Δh: the shaft that turns with the crank over the other. The gas torque is not in it: "
            "what is best under load lies elsewhere."
        ),
        covers=("imbalance.shaft_pair.",),
    )
