# SPDX-License-Identifier: Apache-2.0
"""The figures of this step: what is left over a turn and over the speed range, and what the bearings carry."""

from typing import Any

import numpy as np

from ..imbalance.pictures import DRAWN
from ..sheet.step import Curve, Series
from ..sheet.units import Metre, RadPerSecond
from .bending.shaft import Bending
from .drawing import outline_curve
from .result import CountershaftResult
from .task import LEFT_OVER, WORDS, Task


def pictures(todo: Task, found: CountershaftResult, omega: RadPerSecond, positions: tuple[Metre, ...]) -> tuple[Curve, ...]:
    """All figures of the step but those of its making; `omega` of the crank at rated speed, `positions` of the bearings."""
    parts = (
        ("couple", "N·m", todo.C, todo.C_against, found.couple_vector, todo.one_couple, todo.may_leave),
        ("force", "N", todo.F, todo.F_against, found.force_vector, todo.one_force, LEFT_OVER * todo.one_force),
    )
    drawn = [part for part in parts if max(abs(part[2]), abs(part[3]), abs(part[4])) > DRAWN * part[5]]
    bent = _bent(found.bending, positions) if found.bending is not None else ()
    return (
        *(_over_speed(todo.order, *part[:4], part[6], found, omega) for part in drawn),
        *bent[:1],
        *((outline_curve(found.outline, positions),) if found.outline is not None else ()),
        *bent[1:],
        _reactions(found, omega),
        *(_over_a_turn(todo.order, *part[:5]) for part in drawn),
    )


def _over_a_turn(order: int, word: str, unit: str, like: complex, against: complex, supplied: complex) -> Curve:
    """What is left of the shaft's order, as the path over a turn, before and after the shaft."""
    degrees = np.arange(0, 361, 3.0)
    theta = np.radians(degrees)
    same, other = np.exp(-1j * theta), np.exp(1j * theta)
    alone = against * other + like * same
    after = against * other + (like + supplied) * same
    return Curve(
        "residual" if word == "couple" else "residual_force", f"{WORDS[order]}-order {word} before and after the counter-shaft",
        f"horizontal, {unit}", f"vertical, {unit}",
        (Series("before", alone.imag, alone.real), Series("after", after.imag, after.real)), equal=True,
        along=("crank angle, °", degrees / order),
    )  # fmt: skip


def _speeds(omega: RadPerSecond) -> tuple[Any, Any]:
    """Crank speeds up to a tenth above rated [rpm], and the square of their ratio to it, by which all inertia forces grow."""
    share = np.linspace(0.0, 1.1, 45)
    return share * omega * 30 / np.pi, share**2


def _over_speed(
    order: int, word: str, unit: str, like: complex, against: complex, limit: float, found: CountershaftResult, omega: RadPerSecond
) -> Curve:
    """The peak of a turn over the speed range, without the shaft and with it; what may be left is judged at rated speed."""
    rpm, square = _speeds(omega)
    after = getattr(found, f"residual_order_{order}_{word}")
    return Curve(
        f"residual_{word}_over_speed", f"{WORDS[order]}-order {word} over the speed range, peak of a turn",
        "crank speed, rpm", f"{word}, {unit}",
        (Series("before", rpm, (abs(like) + abs(against)) * square), Series("after", rpm, after * square)),
        limits=(("may be left at rated speed", limit),),
    )  # fmt: skip


def _reactions(found: CountershaftResult, omega: RadPerSecond) -> Curve:
    """What turns with the shaft, on each of its bearings."""
    rpm, square = _speeds(omega)
    each: dict[str, Any] = dict(found.support) or {"front": found.reaction_front, "rear": found.reaction_rear}
    return Curve(
        "reactions", "Reactions of the bearings over the speed range, the turning part", "crank speed, rpm", "reaction, N",
        tuple(Series(name.replace("_", " "), rpm, getattr(one, "reaction", one) * square) for name, one in each.items()),
    )  # fmt: skip


def _bent(bent: Bending, positions: tuple[Metre, ...]) -> tuple[Curve, ...]:
    """The deflection line and the bending moment, in the plane of the shaft's couple."""
    marks = Series("bearings", np.array(positions) * 1e3, np.zeros(len(positions)))
    share, z = Series("with the stiffness share of the sectors", bent.z * 1e3, bent.deflection * 1e6), bent.z * 1e3
    stiff = Series("at full stiffness", z, bent.deflection_stiff * 1e6)
    return (
        Curve("deflection", "Deflection line of the shaft at rated speed", "from mid-shaft, mm", "deflection, µm", (share, stiff, marks)),
        Curve(
            "moment", "Bending moment of the shaft at rated speed", "from mid-shaft, mm", "moment, N·m",
            (Series("", bent.moment_z * 1e3, bent.moment),),
        ),
    )  # fmt: skip
