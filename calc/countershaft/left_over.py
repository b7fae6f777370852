# SPDX-License-Identifier: Apache-2.0
"""What all shafts together leave over of the orders at which one turns: whether that is little enough, and its
figures."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ..gears.result import TrainResult
from ..imbalance.curves import DRAWN
from ..imbalance.result import ImbalanceResult
from ..imbalance.shaft_pair import best_height_difference
from ..sheet.check import Check, CheckRule
from ..sheet.deferred import Later
from ..sheet.functions import argument, conj, degrees
from ..sheet.quantity import declared, dotted
from ..sheet.record import replace
from ..sheet.step import Curve, Outcome, Series, axis_label
from ..sheet.text import COMMA, SPACE, Amount, Name, Text, listed
from ..sheet.units import Metre, NewtonMetre, Number, PhasorMetre, PhasorNewtonMetre, RadPerSecond
from ..sheet.value import based_on, trace, untraced
from .curves import phasor_plane, speeds, teeth_bars
from .inputs import ShaftInputs
from .rows import SHAFT
from .sizing.sectors import WORDS, ShaftTask, task
from .sums import (
    NOTHING,
    OrderVectors,
    SystemResult,
    SystemShaft,
    TeethOff,
    rolled,
    sums_table,
    teeth_off,
    teeth_table,
    together,
)

if TYPE_CHECKING:
    from .making.system_scatter import MadeShaft


def solve(
    imbalance: ImbalanceResult,
    shafts: tuple[SystemShaft, ...],
    rolls: Mapping[int, PhasorNewtonMetre],
    omega: RadPerSecond,
    made: "tuple[MadeShaft, ...]" = (),
) -> Outcome[SystemResult]:
    """Of an engine with all its shafts.

    `rolls`: by order, the torque reaction of its inertia about the crank, as far as it is known; `omega` of the crank
    at rated speed; `made`: the same shafts as they are made, of several that scatter."""
    engine = vectors_of(imbalance, shafts, rolls)
    with trace() as lines:
        left = together(engine, shafts)
        if made:
            from .making.system_scatter import system_scattered  # which few designs ask for

            left = replace(left, scatter=system_scattered(engine, made))
    tasks = {n: task(next(s.ratio for s in shafts if s.order == n), imbalance) for n in sorted(engine)}
    return Outcome(
        "countershaft",
        result=left,
        checks=tuple(
            check for n, todo in tasks.items() for check in _checks(todo, engine[n], shafts, left, min(tasks))
        ),
        lines=tuple(lines),
        curves=Later(partial(_curves, tasks, engine, shafts, left, omega))
        + Later(partial(_planes, tasks, engine, shafts)),
        tables=Later(lambda: [sums_table(engine, shafts, left)] if len(shafts) > 1 else []),
    )


def vectors_of(
    imbalance: ImbalanceResult, shafts: Sequence[SystemShaft], rolls: Mapping[int, PhasorNewtonMetre]
) -> dict[int, OrderVectors]:
    """The engine alone, of the orders at which a shaft turns."""
    orders = {shaft.order for shaft in shafts}
    return {n: OrderVectors(*imbalance.orders[f"order_{n}"].vectors, rolls.get(n)) for n in sorted(orders)}


def one_tooth_off(
    train: Outcome[TrainResult],
    imbalance: ImbalanceResult,
    shafts: tuple[SystemShaft, ...],
    rolls: Mapping[int, PhasorNewtonMetre],
) -> Outcome[TrainResult]:
    """A train with what is left where shafts are fitted one tooth of their wheels off."""
    if train.result is None or not shafts:
        return train
    engine = vectors_of(imbalance, shafts, rolls)
    with trace() as lines:
        off = teeth_off(engine, shafts)
    turns = {
        name: replace(turn, tooth_late=off.shafts.get(name), pair_late=off.pairs.get(name))
        for name, turn in train.result.shafts.items()
    }
    table = Later(lambda: [replace(teeth_table(off), short=off.all is not None)] if off.shafts else [])
    bars = Later(partial(_bars, imbalance, engine, shafts, off))
    result = replace(train.result, shafts=turns, all_late=off.all)
    lines = [*train.lines, *lines]
    return replace(train, result=result, lines=tuple(lines), tables=train.tables + table, curves=train.curves + bars)


# --- what is left over

OF_COUPLE = Text("rule of this program: 5 % of the couple to be balanced, or of m·r·ω²·a where there is none")
OF_FORCE = Text("rule of this program: 5 % of m·r·ω² of one cylinder")
MASSES = (dotted(SHAFT, ShaftInputs.masses),)

RESIDUAL = CheckRule(
    "countershaft.residual",
    "limit",
    "The couple is what the shaft is for, and no shaft may make it worse.",
    sense="<=",
    unit="N·m",
    source=OF_COUPLE,
    role="physics",
    moved_by=MASSES,
    short=Text("couple left"),
    proven=(),
    proven_where=declared(ImbalanceResult).required_couple,
)
RESIDUAL_FORCE = CheckRule(
    "countershaft.residual_force",
    "limit",
    "The force is what the shaft is for, or brings into the engine.",
    sense="<=",
    unit="N",
    source=OF_FORCE,
    role="physics",
    cause=RESIDUAL.id,
    moved_by=MASSES,
    short=Text("force left"),
    proven=(),
    proven_where=declared(ImbalanceResult).required_force,
)
RESIDUAL_SHARE = CheckRule(
    "countershaft.residual_share",
    "advice",
    "Shafts at twice crank speed are for comfort and often take a part of the couple only.",
    sense="<=",
    unit="N·m",
    source=OF_COUPLE,
    moved_by=MASSES,
    short=Text("couple left"),
    proven=(),
    proven_where=declared(ImbalanceResult).required_couple,
)
RESIDUAL_FORCE_SHARE = CheckRule(
    "countershaft.residual_force_share",
    "advice",
    "Shafts at twice crank speed are for comfort and often take a part of the force only.",
    sense="<=",
    unit="N",
    source=OF_FORCE,
    cause=RESIDUAL_SHARE.id,
    moved_by=MASSES,
    short=Text("force left"),
    proven=(),
    proven_where=declared(ImbalanceResult).required_force,
)


# where shafts take the first order and the second, of the second
RESIDUAL_2 = replace(RESIDUAL_SHARE, id="countershaft.residual_2")
RESIDUAL_FORCE_2 = replace(RESIDUAL_FORCE_SHARE, id="countershaft.residual_force_2", cause=RESIDUAL_2.id)
WORSE = Text("No shaft may make it worse.")
RESIDUAL_2_WORSE = replace(RESIDUAL, id="countershaft.residual_2_worse", why=WORSE, cause=RESIDUAL_2.id)
RESIDUAL_FORCE_2_WORSE = replace(
    RESIDUAL_FORCE, id="countershaft.residual_force_2_worse", why=WORSE, cause=RESIDUAL_FORCE_2.id
)
ROLL = CheckRule(
    "countershaft.roll",
    "advice",
    "Roll is a matter of comfort; the places of the shafts can take of it, or add to it.",
    sense="<=",
    unit="N·m",
    source=Text("rule of this program: forces beside the crank should not add to the roll of the engine's inertia"),
    zero="roll torque of all shafts",
    moved_by=(dotted(SHAFT, ShaftInputs.axis),),
    short=Text("roll left"),
)
ROLL_2 = replace(ROLL, id="countershaft.roll_2")  # of the second order, where shafts take both


def _checks(
    todo: ShaftTask, alone: OrderVectors, shafts: Sequence[SystemShaft], left: SystemResult, lowest: int
) -> Iterator[Check]:
    """The couple, the force and the roll of one order that are left over."""
    mine = [shaft for shaft in shafts if shaft.order == todo.order]
    ratio, like = mine[0].ratio, sum(shaft.ratio == mine[0].ratio for shaft in mine)
    each = Text("the shaft ")
    if len(mine) == 2 and like == 1:
        each = Text("each of both shafts ")
    elif like > 1:
        each = Text("the {like} shafts that turn alike, together, ", like=like)
    aim_couple = Text(
        "Aim at {couple} N·m at {direction}: the couple of {each}grows with mass, radius and arm.",
        couple=Amount(todo.couple, form=".1f"),
        direction=_opposite(todo.C),
        each=each,
    )
    aim_force = Text(
        "Aim at {f} N at {direction}: the force of {each}grows with mass and radius.",
        f=Amount(abs(todo.F), form=".0f"),
        direction=_opposite(todo.F),
        each=each,
    )
    alike = Text("Balance the masses against each other (mass times radius), so that only a couple remains.")
    force = todo.force_may_be_left
    couples = RESIDUAL, RESIDUAL_SHARE, RESIDUAL_2, RESIDUAL_2_WORSE
    forces = RESIDUAL_FORCE, RESIDUAL_FORCE_SHARE, RESIDUAL_FORCE_2, RESIDUAL_FORCE_2_WORSE
    for word, rules, limit, before, advice in (
        (Text("couple"), couples, todo.may_leave, abs(todo.C) + abs(todo.C_against), aim_couple),
        (Text("force"), forces, force, abs(todo.F) + abs(todo.F_against), aim_force if abs(todo.F) > force else alike),
    ):
        whole, share, second, second_worse = rules
        value = f"residual_order_{todo.order}_{word}"
        peak = getattr(left, value) or 0.0
        if like == len(mine) and str(word) in todo.out_of_reach:
            against = abs(todo.C_against if whole is RESIDUAL else todo.F_against)
            beyond = _beyond(ratio, Amount(against, whole.unit, form=".4g"))
            advice = advice + SPACE + beyond if peak - against > limit else beyond
        made: tuple[tuple[CheckRule, float], ...] = ((second, limit), (second_worse, max(before, limit)))
        if todo.order == lowest:
            # shafts at twice crank speed are for comfort and often take a part only; they fail where they make it worse
            made = ((whole if todo.order == 1 or peak > max(before, limit) else share, limit),)
        for rule, most in made:
            yield rule(
                peak,
                most,
                name=Text("{words}-order {word} left over", words=WORDS[todo.order], word=word),
                advice=advice,
                value_id=dotted("countershaft", getattr(SystemResult, value)),
            )
    yield from _roll_checks(todo, alone, mine, left, lowest)


def _beyond(ratio: Number, against: Amount) -> Text:
    """What takes the part that turns against the shaft."""
    if ratio == -1:
        return Text(
            "{against} turn against the shaft, and no mass on it takes them: that is for the counterweights of the "
            "crank (see the imbalance).",
            against=against,
        )
    return Text(
        "{against} turn against the shaft, and no mass on it takes them: a mirrored second shaft does (mirrors).",
        against=against,
    )


def _opposite(engine: complex) -> Amount:
    """The direction opposite to the engine's vector, in degrees."""
    return Amount(degrees(argument(-engine)), "°", form=".1f")


def _roll_checks(
    todo: ShaftTask, alone: OrderVectors, shafts: Sequence[SystemShaft], left: SystemResult, lowest: int
) -> Iterator[Check]:
    """The roll of one order that its shafts leave, where their places are known and one of them carries a force."""
    found, value = left.vectors[todo.order], f"roll_left_order_{todo.order}"
    if alone.roll is None or found.roll is None or found.roll_of_shafts is None:
        return
    if max(abs(shaft.force) for shaft in shafts) <= DRAWN * todo.one_force:
        return
    before, raised = based_on(abs(alone.roll), alone.roll), abs(found.roll_of_shafts)
    yield (ROLL if todo.order == lowest else ROLL_2)(
        getattr(left, value) if raised > NOTHING else before,  # which rounding makes neither larger nor smaller
        before,
        name=Text("{words}-order roll left over", words=WORDS[todo.order]),
        advice=_places_of_less_roll(alone, shafts, found.roll),
        scale=raised,
        value_id=dotted("countershaft", getattr(SystemResult, value)),
    )


NEARER = Text("The nearer the axes are to the crank's, the less roll the forces raise.")
AS_THEY_STAND, NO_PLACE = 0.5e-3, 1.0  # m: heights that are worth no word, and those that no engine has


def _places_of_less_roll(alone: OrderVectors, shafts: Sequence[SystemShaft], roll: PhasorNewtonMetre) -> Text:
    """The heights of the least roll, and what the other side of the crank leaves; all axes are known."""
    axes = [shaft.axis for shaft in shafts if shaft.axis is not None]

    def left_at(axes: Sequence[PhasorMetre]) -> NewtonMetre:
        T_S = rolled([replace(shaft, axis=axis) for shaft, axis in zip(shafts, axes)])
        return abs((T_S or 0j) + (alone.roll or 0j))

    forward, backward = ([shaft for shaft in shafts if shaft.forward is sense] for sense in (True, False))
    F_f, F_b = (sum((shaft.force for shaft in some), 0j) for some in (forward, backward))
    ways, leave = [], [abs(roll)]
    with untraced():
        S = F_f + conj(F_b)  # where it is nothing a height difference raises no moment
        up = best_height_difference(Dh=0.0, T=roll, F_f=F_f, F_b=F_b) / 2 if abs(S) > NOTHING else 0.0
        if AS_THEY_STAND < abs(up) < NO_PLACE:
            leave.append(least := left_at([axis + (up if shaft.forward else -up) for shaft, axis in zip(shafts, axes)]))
            moves = [_moved(some, by) for some, by in ((forward, up), (backward, -up)) if some]
            ways.append(
                Text(
                    "The least roll, {least} N·m, is left with {moves}.",
                    least=Amount(least, form=".1f"),
                    moves=listed(moves),
                )
            )
        aside = left_at([conj(axis) for axis in axes])
    if aside < (1 - DRAWN) * abs(roll):
        leave.append(aside)
        ways.append(Text("On the other side of the crank {aside} N·m are left.", aside=Amount(aside, form=".1f")))
    if min(leave) > abs(alone.roll or 0j):
        ways.append(NEARER)
    return SPACE.join(ways)


def _moved(shafts: Sequence[SystemShaft], up: Metre) -> Text:
    """`left 80 mm higher`."""
    parts = dict(names=listed(Name(shaft.name) for shaft in shafts), by=Amount(abs(up) * 1e3, "mm", form=".3g"))
    return Text("{names} {by} higher", **parts) if up > 0 else Text("{names} {by} lower", **parts)


SPEEDS = np.linspace(0.2, 1.0, 21)  # of several shafts, over the rated one


def _curves(
    tasks: Mapping[int, ShaftTask],
    engine: Mapping[int, OrderVectors],
    shafts: Sequence[SystemShaft],
    left: SystemResult,
    omega: RadPerSecond,
) -> tuple[Curve, ...]:
    """Of each order: over the speed range, and over a turn; what is next to nothing is not drawn.  Of several shafts a
    short report has the former."""
    over_speed: list[Curve] = []
    over_a_turn: list[Curve] = []
    off = teeth_off(engine, shafts) if len(shafts) > 1 else None
    for n, todo in tasks.items():
        before, after = engine[n], left.vectors[n]
        behind = "" if n == min(tasks) else f"_{n}"  # the ids of the first of them
        for word, unit, (f_0, b_0), (f_1, b_1), one_cylinder, limit in (
            (Text("couple"), "N·m", before.couples, after.couples, todo.one_couple, todo.may_leave),
            (Text("force"), "N", before.forces, after.forces, todo.one_force, todo.force_may_be_left),
        ):
            if max(map(abs, (f_0, b_0, f_1 - f_0, b_1 - b_0))) > DRAWN * one_cylinder:
                title = Text("{words}-order {word} over the speed range, peak of a turn", words=WORDS[n], word=word)
                rpm, square = speeds(omega) if off is None else (SPEEDS * omega * 30 / np.pi, SPEEDS**2)
                peaks = _peaks(f"order_{n}_{word}", abs(f_0) + abs(b_0), left, off)
                over = Curve(
                    f"residual_{word}_over_speed{behind}",
                    title,
                    axis_label("crank speed", "rpm"),
                    Text("{word}, {unit}", word=word, unit=unit),
                    tuple(Series(words, rpm, peak * square) for words, peak in peaks),
                    limits=((Text("may be left at rated speed"), limit),),
                )
                over_speed.append(over if off is None else replace(over, short=len(over_speed) + 1))
                id = f"residual{behind}" if word == "couple" else f"residual_force{behind}"
                over_a_turn.append(_over_a_turn(id, n, word, unit, ((f_0, b_0), (f_1, b_1))))
    return (*over_speed, *over_a_turn)


def _peaks(what: str, before: float, left: SystemResult, off: TeethOff | None) -> list[tuple[Text, float]]:
    """The peaks of force or couple of one order (`order_2_force`) at rated speed: without the shafts and with them; of
    several shafts as 95 % of them are made too, and with each of them one tooth off, where that is known."""
    after = getattr(left, f"residual_{what}")
    if off is None:
        return [(Text("before"), before), (Text("after"), after)]
    peaks = [(Text("without shafts"), before), (Text("as designed"), after)]
    if left.scatter is not None and (made := getattr(left.scatter, f"{what}_95")) is not None:
        peaks.append((Text("95 % of those made"), made))
    alike: dict[str, list[tuple[str, float]]] = {}  # mirror images leave the same
    for name, tooth in off.shafts.items():
        if (peak := getattr(tooth, what)) is not None:
            alike.setdefault(f"{peak:.6g}", []).append((name, peak))
    for several in alike.values():
        names = COMMA.join(Name(name) for name, _ in several)
        peaks.append((Text("{name} one tooth off", name=names), several[0][1]))
    return peaks


def _planes(
    tasks: Mapping[int, ShaftTask], engine: Mapping[int, OrderVectors], shafts: Sequence[SystemShaft]
) -> Iterator[Curve]:
    """Of several shafts the vectors of each order."""
    for n, todo in tasks.items() if len(shafts) > 1 else ():
        for unit, one_cylinder in (("N", todo.one_force), ("N·m", todo.one_couple)):
            plane = phasor_plane(n, unit, engine[n], shafts)
            if max((abs(v) for chain in plane.turning for v in chain.phasors), default=0.0) > DRAWN * one_cylinder:
                yield plane


def _bars(
    imbalance: ImbalanceResult, engine: Mapping[int, OrderVectors], shafts: Sequence[SystemShaft], off: TeethOff
) -> Iterator[Curve]:
    """Of several shafts what is left of each order one tooth off."""
    designed = together(engine, shafts)
    for n in engine if len(list(off.rows())) > 1 else ():
        for word, unit, one_cylinder in (("force", "N", imbalance.one_force), ("couple", "N·m", imbalance.one_couple)):
            bars = teeth_bars(n, unit, off, getattr(designed, f"residual_order_{n}_{word}"))
            if max(float(series.y.max()) for series in bars.series) > DRAWN * one_cylinder:
                yield bars


def _over_a_turn(id: str, n: int, word: Text, unit: str, pairs: Sequence[tuple[complex, complex]]) -> Curve:
    """What is left of an order, as the path over a turn, before and after the shafts: what turns with the crank and
    what turns against it."""
    turned = np.arange(0, 361, 3.0)
    along = np.exp(1j * np.radians(turned))
    before, after = (forward * along + backward * along.conj() for forward, backward in pairs)
    title = Text("{words}-order {word} before and after the counter-shaft", words=WORDS[n], word=word)
    return Curve(
        id,
        title,
        Text("horizontal, {unit}", unit=unit),
        Text("vertical, {unit}", unit=unit),
        (Series(Text("before"), before.imag, before.real), Series(Text("after"), after.imag, after.real)),
        equal=True,
        along=(Text("crank angle, °"), turned / n),
    )
