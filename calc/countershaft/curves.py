# SPDX-License-Identifier: Apache-2.0
"""The figures of this step: what is left over a turn and over the speed range, and what the bearings carry."""

import numpy as np

from ..draw.shaft_outline import outline_curve
from ..imbalance.curves import DRAWN
from ..sheet.arrays import Array
from ..sheet.step import Curve, DrawnLoad, Series, axis_label
from ..sheet.text import EMPTY, Name, Text
from ..sheet.units import Metre, Newton, RadPerSecond
from .bending.shaft import Bending
from .result import CountershaftResult
from .rows import called
from .sizing.sectors import LEFT_OVER, WORDS, ShaftTask

STACK = "bending"


def curves(
    todo: ShaftTask, shaft: CountershaftResult, omega: RadPerSecond, positions: tuple[Metre, ...]
) -> tuple[Curve, ...]:
    """All figures of the step but those of its making; `omega` of the crank at rated speed, `positions` of the
    bearings."""
    parts = (
        (Text("couple"), "N·m", todo.C, todo.C_against, shaft.couple_vector, todo.one_couple, todo.may_leave),
        (Text("force"), "N", todo.F, todo.F_against, shaft.force_vector, todo.one_force, LEFT_OVER * todo.one_force),
    )
    over_speed, over_a_turn = [], []
    for word, unit, like, against, supplied, one_cylinder, limit in parts:
        if max(abs(like), abs(against), abs(supplied)) > DRAWN * one_cylinder:
            left = getattr(shaft, f"residual_order_{todo.order}_{word}")
            over_speed.append(_over_speed(todo.order, word, unit, abs(like) + abs(against), left, limit, omega))
            over_a_turn.append(_over_a_turn(todo.order, word, unit, like, against, supplied))
    outline = (outline_curve(shaft.outline, positions),) if shaft.outline is not None else ()
    bent = _bent(shaft.bending, positions) if shaft.bending is not None else ()
    if shaft.bending is not None and outline:
        bent = (_loaded(outline[0], shaft.bending, positions, _carried(shaft)), *bent)
    return (*over_speed, *bent, *outline, _reactions(shaft, omega), *over_a_turn)


def _over_a_turn(order: int, word: Text, unit: str, like: complex, against: complex, supplied: complex) -> Curve:
    """What is left of the shaft's order, as the path over a turn, before and after the shaft."""
    degrees = np.arange(0, 361, 3.0)
    same, other = np.exp(-1j * np.radians(degrees)), np.exp(1j * np.radians(degrees))
    before, after = (against * other + vector * same for vector in (like, like + supplied))
    title = Text("{words}-order {word} before and after the counter-shaft", words=WORDS[order], word=word)
    series = Series(Text("before"), before.imag, before.real), Series(Text("after"), after.imag, after.real)
    return Curve(
        "residual" if word == "couple" else "residual_force",
        title,
        Text("horizontal, {unit}", unit=unit),
        Text("vertical, {unit}", unit=unit),
        series,
        equal=True,
        along=(Text("crank angle, °"), degrees / order),
    )


def _speeds(omega: RadPerSecond) -> tuple[Array, Array]:
    """Crank speeds up to a tenth above rated [rpm], and the square of their ratio to it, by which all inertia forces
    grow."""
    share = np.linspace(0.0, 1.1, 45)
    return share * omega * 30 / np.pi, share**2


def _over_speed(
    order: int, word: Text, unit: str, before: float, after: float, limit: float, omega: RadPerSecond
) -> Curve:
    """The peak of a turn over the speed range, without the shaft and with it; what may be left is judged at rated
    speed."""
    rpm, square = _speeds(omega)
    title = Text("{words}-order {word} over the speed range, peak of a turn", words=WORDS[order], word=word)
    series = Series(Text("before"), rpm, before * square), Series(Text("after"), rpm, after * square)
    return Curve(
        f"residual_{word}_over_speed",
        title,
        axis_label("crank speed", "rpm"),
        Text("{word}, {unit}", word=word, unit=unit),
        series,
        limits=((Text("may be left at rated speed"), limit),),
    )


def _carried(shaft: CountershaftResult) -> list[tuple[Text, Newton]]:
    """The bearings, front to rear, each with what turns on it."""
    if shaft.support:
        return [(Name(name), support.reaction) for name, support in shaft.support.items()]
    return [(called(row), load) for row, load in shaft.loads.items()]


def _reactions(shaft: CountershaftResult, omega: RadPerSecond) -> Curve:
    """What turns with the shaft, on each of its bearings."""
    rpm, square = _speeds(omega)
    series = tuple(Series(name, rpm, load * square) for name, load in _carried(shaft))
    title = Text("Reactions of the bearings over the speed range, the turning part")
    return Curve("reactions", title, axis_label("crank speed", "rpm"), axis_label("reaction", "N"), series)


def _loaded(outline: Curve, bent: Bending, positions: tuple[Metre, ...], carried: list[tuple[Text, Newton]]) -> Curve:
    """The shaft with the resultants of its centrifugal load and what its bearings hold against them, in the plane of
    its couple.

    `carried`: by each bearing, as the tables have it; the bent shaft gives its direction.  (Its own reactions are a
    little larger, as it is thrown outwards while it bends.)
    """
    along = np.cos(np.angle(np.asarray(bent.reactions)) - bent.plane)
    held = zip(positions, (along * [load for _, load in carried]).tolist())
    loads = [DrawnLoad(Text("load"), z * 1e3, F) for z, F in bent.loads] + [
        DrawnLoad(Text("bearing"), z * 1e3, F, held=True) for z, F in held
    ]
    title = Text("The shaft at rated speed: centrifugal load and reactions, shear, bending moment, deflection")
    return Curve(
        "loads",
        title,
        outline.x_label,
        outline.y_label,
        outline.series,
        stack=STACK,
        loads=tuple(loads),
        load_unit="N",
        short=1,
    )


def _bent(bent: Bending, positions: tuple[Metre, ...]) -> tuple[Curve, ...]:
    """Shear, bending moment and deflection line, in the plane of the shaft's couple."""
    z, from_middle = bent.z * 1e3, axis_label("from mid-shaft", "mm")
    lines = (
        Series(Text("with the stiffness share of the sectors"), z, bent.deflection * 1e6),
        Series(Text("at full stiffness"), z, bent.deflection_stiff * 1e6),
        Series(Text("bearings"), np.array(positions) * 1e3, np.zeros(len(positions))),
    )
    shear, moment = Text("Shear force of the shaft at rated speed"), Text("Bending moment of the shaft at rated speed")
    deflection, at = Text("Deflection line of the shaft at rated speed"), bent.largest_moment_z
    largest = float(np.interp(at, bent.moment_z, bent.moment))
    return (
        Curve(
            "shear_force",
            shear,
            from_middle,
            axis_label("shear", "N"),
            (Series(EMPTY, bent.shear_z * 1e3, bent.shear),),
            stack=STACK,
            short=2,
        ),
        Curve(
            "moment",
            moment,
            from_middle,
            axis_label("moment", "N·m"),
            (Series(EMPTY, bent.moment_z * 1e3, bent.moment),),
            point=(at * 1e3, largest),
            stack=STACK,
            short=3,
        ),
        Curve("deflection", deflection, from_middle, axis_label("deflection", "µm"), lines, stack=STACK, short=4),
    )
