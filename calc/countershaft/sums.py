# SPDX-License-Identifier: Apache-2.0
"""All balance shafts of an engine together: what is left of each order, the roll about the crank, one tooth off.

A vector is a complex number: real up, imaginary 90° further in the sense of crank rotation, at rated speed while
cylinder 1 stands at TDC (ε = 0).  Of order n, F⁺·e^(inε) turns with the crank, F⁻·e^(−inε) against it; a shaft at
i = ±n times crank speed adds to one of them.  Couples about the middle of the engine, positive = rear force up.  All
grow with the square of speed, so that what is left is one share at all speeds."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Self

from ..imbalance import formulas as v
from ..imbalance.shaft_pair import roll_amplitude, roll_backward, roll_forward, roll_phase, roll_together, rolls_joined
from ..sheet.arrays import Array
from ..sheet.errors import BadInput, InputError
from ..sheet.formula import formula
from ..sheet.functions import conj, largest
from ..sheet.quantity import group, result, value
from ..sheet.record import record, replace
from ..sheet.shown import Shown
from ..sheet.step import Table
from ..sheet.text import EMPTY, Name, Text
from ..sheet.units import (
    Newton,
    NewtonMetre,
    Number,
    PhasorMetre,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
)
from ..sheet.value import about, based_on
from . import formulas as f


@record
class OrderVectors:
    """One order of an engine, alone or with its shafts: the vectors that turn with and against the crank, and the
    torque that their inertia puts on the block about the crank's axis, Re(roll·e^(inε)), positive in the sense of
    rotation; `roll_of_shafts`: what of it the shafts raise.  None: not known."""

    force_forward: PhasorNewton
    force_backward: PhasorNewton
    couple_forward: PhasorNewtonMetre
    couple_backward: PhasorNewtonMetre
    roll: PhasorNewtonMetre | None = None
    roll_of_shafts: PhasorNewtonMetre | None = None

    @property
    def forces(self) -> tuple[PhasorNewton, PhasorNewton]:
        return self.force_forward, self.force_backward

    @property
    def couples(self) -> tuple[PhasorNewtonMetre, PhasorNewtonMetre]:
        return self.couple_forward, self.couple_backward


@record
class SystemShaft:
    """One of the shafts: at `ratio` times crank speed (±1, ±2; below zero: against the crank), with its force and its
    couple.

    `axis`: of it from the crank's, real up, imaginary to the side; `tooth`: the angle of the shaft that its wheel (of a
    chain or a belt) is off by where it is fitted one tooth off; None: not known.  `mirrors`: the name of the shaft
    whose mirror image it is."""

    name: str
    ratio: Number
    force: PhasorNewton
    couple: PhasorNewtonMetre
    axis: PhasorMetre | None = None
    tooth: Radian | None = None
    mirrors: str | None = None

    @property
    def order(self) -> int:
        return round(abs(self.ratio))

    @property
    def forward(self) -> bool:
        return self.ratio > 0

    def late_by(self, delta: Radian, s: Number = 0.0) -> Self:
        """The same shaft late by an angle of its own (below zero: early), its couple too large by the share s."""
        sense = 1.0 if self.forward else -1.0
        force = f.late_force(F_S=self.force, sigma=sense, delta=delta)
        return replace(self, force=force, couple=f.late_couple(C_S=self.couple, s=s, sigma=sense, delta=delta))

    def mirror_image(self, name: str, axis: PhasorMetre | None = None) -> Self:
        """Its mirror image in the vertical plane through the crank: it turns the other way, and its unbalances stand at
        −γ (not at γ + 180°), each at the same place along the engine.  `axis`: where it does not stand at that of the
        mirror image, as at another height."""
        with about(Name(name)):
            force, couple = f.mirrored_force(F_S=self.force), f.mirrored_couple(C_S=self.couple)
        if axis is None and self.axis is not None:
            axis = based_on(conj(self.axis), self.axis)
        ratio = based_on(-self.ratio, self.ratio)
        return replace(self, name=name, ratio=ratio, force=force, couple=couple, axis=axis, mirrors=self.name)

    def repeated(self, name: str, axis: PhasorMetre) -> Self:
        """The same shaft once more, about an axis of its own."""
        return replace(self, name=name, axis=axis)


TOGETHER = Text("all shafts")
NOTHING = 1e-6  # N and N·m: what rounding leaves


def rolled(shafts: Iterable[SystemShaft], subject: Text = TOGETHER) -> PhasorNewtonMetre | None:
    """The moment about the crank's axis of the shafts of one order on the block; None where an axis is not known."""
    whole: PhasorNewtonMetre | None = None
    for shaft in shafts:
        if shaft.axis is None:
            return None
        with about(Text("{subject}: {name}", subject=subject, name=Name(shaft.name))):
            T = (roll_forward if shaft.forward else roll_backward)(p=shaft.axis, F=shaft.force)
            whole = T if whole is None else rolls_joined(T_1=whole, T_2=T)
    return whole


def left(engine: OrderVectors, shafts: Sequence[SystemShaft], subject: Text = TOGETHER) -> OrderVectors:
    """What the shafts of one order leave of the engine's vectors, shaft after shaft, and of the roll; `subject`: whose
    calculation this is.

    Of given shafts alone it is what those to be sized have to share: each −(1 + x_o)·w·F of what turns like it."""
    F_f, F_b, C_f, C_b = engine.force_forward, engine.force_backward, engine.couple_forward, engine.couple_backward
    for shaft in shafts:
        with about(Text("{subject}: {name}", subject=subject, name=Name(shaft.name))):
            if shaft.forward:
                F_f = f.residual_force_vector(F_like=F_f, F_S=shaft.force)
                C_f = f.residual_vector(C_like=C_f, C_S=shaft.couple)
            else:
                F_b = f.residual_force_vector(F_like=F_b, F_S=shaft.force)
                C_b = f.residual_vector(C_like=C_b, C_S=shaft.couple)
    T_S = rolled(shafts, subject)
    roll = None if T_S is None or engine.roll is None else roll_together(T_S=T_S, t_n=engine.roll)
    return OrderVectors(F_f, F_b, C_f, C_b, roll, T_S)


@result
class OrderLeft(Shown):
    """What is left of one order, as it turns with and against the crank; its least over a turn."""

    force_forward: Newton = value("Force left that turns with the crank", "N", "F⁺")
    force_forward_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    force_backward: Newton = value("Force left that turns against it", "N", "F⁻")
    force_backward_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    force_least: Newton = value("Smallest force left over the turn", "N", "F_min")
    couple_forward: NewtonMetre = value("Couple left that turns with the crank", "N·m", "C⁺")
    couple_forward_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    couple_backward: NewtonMetre = value("Couple left that turns against it", "N·m", "C⁻")
    couple_backward_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    couple_least: NewtonMetre = value("Smallest couple left over the turn", "N·m", "C_min")


@result
class OrderScatter(Shown):
    """The errors of what turns with and against the crank, root mean squares to first order."""

    force_forward: Newton = value("Error of the force that turns with the crank", "N", "σ_F⁺")
    force_backward: Newton = value("Error of the force that turns against it", "N", "σ_F⁻")
    couple_forward: NewtonMetre = value("Error of the couple that turns with the crank", "N·m", "σ_C⁺")
    couple_backward: NewtonMetre = value("Error of the couple that turns against it", "N·m", "σ_C⁻")


@result
class SystemScatter(Shown):
    """What 95 % of the engines stay below, by their peak over a turn; and the errors behind it, order by order."""

    order_1_force_95: Newton | None = value("First-order force that 95 % of the engines stay below", "N", default=None)
    order_1_couple_95: NewtonMetre | None = value(
        "First-order couple that 95 % of the engines stay below", "N·m", default=None
    )
    order_2_force_95: Newton | None = value("Second-order force that 95 % of the engines stay below", "N", default=None)
    order_2_couple_95: NewtonMetre | None = value(
        "Second-order couple that 95 % of the engines stay below", "N·m", default=None
    )
    errors: dict[str, OrderScatter] = group(spread=True)
    forces: dict[int, Array]  # of every engine what is left of each order, in rising order
    couples: dict[int, Array]


@result
class SystemResult(Shown):
    """What all shafts leave, order by order (those at which a shaft turns), at its peak over a turn; and the roll about
    the crank's axis, of the shafts alone and beside the torque reaction of the engine's inertia."""

    residual_order_1_couple: NewtonMetre | None = value(
        "First-order couple left over", "N·m", "C_left", default=None, short=True, page_one=1
    )
    residual_order_1_force: Newton | None = value(
        "First-order force left over", "N", "F_left", default=None, short=True, page_one=2
    )
    residual_order_2_couple: NewtonMetre | None = value(
        "Second-order couple left over", "N·m", "C_left", default=None, short=True, page_one=4
    )
    residual_order_2_force: Newton | None = value(
        "Second-order force left over", "N", "F_left", default=None, short=True, page_one=5
    )
    residual: dict[str, OrderLeft] = group(words="residual")
    roll_torque_order_1: NewtonMetre | None = value("First-order roll of all shafts", "N·m", "T_roll", default=None)
    roll_torque_order_1_phase: Radian | None = value("its phase, cylinder 1 at TDC", "°", default=None)
    roll_left_order_1: NewtonMetre | None = value(
        "First-order roll left over", "N·m", "T_left", default=None, short=True, page_one=3
    )
    roll_left_order_1_phase: Radian | None = value("its phase, cylinder 1 at TDC", "°", default=None)
    roll_torque_order_2: NewtonMetre | None = value("Second-order roll of all shafts", "N·m", "T_roll", default=None)
    roll_torque_order_2_phase: Radian | None = value("its phase, cylinder 1 at TDC", "°", default=None)
    roll_left_order_2: NewtonMetre | None = value(
        "Second-order roll left over", "N·m", "T_left", default=None, short=True, page_one=6
    )
    roll_left_order_2_phase: Radian | None = value("its phase, cylinder 1 at TDC", "°", default=None)
    scatter: SystemScatter | None = group(default=None, words="scatter")
    vectors: dict[int, OrderVectors]  # what is left, by order


def together(engine: Mapping[int, OrderVectors], shafts: Sequence[SystemShaft]) -> SystemResult:
    """What all shafts leave of the engine's vectors: forces [N], couples about mid-engine and roll [N·m].

    `engine`: vectors by order, 1 and 2; those at which a shaft turns are needed.  All are complex or real, their
    angle that with cylinder 1 at top dead centre, positive in the sense of crank rotation.  `shafts`: one to four, each
    of a ratio of ±1 or ±2.  The torque reaction of the engine is that of its inertia, the gas torque is not in it.

    Raises BadInput where a shaft has another ratio, or the engine has no vectors of its order."""
    wrong = [
        InputError(0, f"shafts[{n}].ratio", f"{shaft.ratio}", Text("must be ±1 or ±2, an order that `engine` has"))
        for n, shaft in enumerate(shafts)
        if abs(shaft.ratio) not in (1, 2) or shaft.order not in engine
    ]
    if wrong:
        raise BadInput("together", wrong)
    peaks: dict[str, Any] = {}
    parts: dict[str, OrderLeft] = {}
    vectors: dict[int, OrderVectors] = {}
    for n, own in _by_order(shafts).items():
        with about(subject := Text("order {n}", n=n)):
            found = vectors[n] = left(engine[n], own, subject)
            peaks[f"residual_order_{n}_couple"] = v.couple_peak(C_f=found.couple_forward, C_b=found.couple_backward)
            peaks[f"residual_order_{n}_force"] = v.force_peak(F_f=found.force_forward, F_b=found.force_backward)
            parts[f"order_{n}"] = _parts(found)
            rolls = {f"roll_torque_order_{n}": found.roll_of_shafts, f"roll_left_order_{n}": found.roll}
            for name, roll in rolls.items():
                if roll is not None:
                    peaks |= {name: roll_amplitude(T_S=roll), f"{name}_phase": roll_phase(T_S=roll)}
    return SystemResult(**peaks, residual=parts, vectors=vectors)


def _by_order(shafts: Iterable[SystemShaft]) -> dict[int, list[SystemShaft]]:
    """The shafts of each order at which one turns, the lowest first."""
    orders: dict[int, list[SystemShaft]] = {}
    for shaft in sorted(shafts, key=lambda shaft: shaft.order):
        orders.setdefault(shaft.order, []).append(shaft)
    return orders


def _parts(found: OrderVectors) -> OrderLeft:
    F_f, F_b, C_f, C_b = found.force_forward, found.force_backward, found.couple_forward, found.couple_backward
    return OrderLeft(
        force_forward=v.force_length(F=F_f),
        force_forward_phase=v.force_direction(F=F_f),
        force_backward=v.force_length(F=F_b),
        force_backward_phase=v.force_direction(F=F_b),
        force_least=v.force_least(F_f=F_f, F_b=F_b),
        couple_forward=v.couple_length(C=C_f),
        couple_forward_phase=v.couple_direction(C=C_f),
        couple_backward=v.couple_length(C=C_b),
        couple_backward_phase=v.couple_direction(C=C_b),
        couple_least=v.couple_least(C_f=C_f, C_b=C_b),
    )


def sums_table(engine: Mapping[int, OrderVectors], shafts: Sequence[SystemShaft], left: SystemResult) -> Table:
    """Order by order what the engine has, what each shaft does, and what is left: force, couple and, where the axes are
    known, the roll about the crank.  What is nought throughout has no row."""
    rows: list[tuple[str | float | None, ...]] = []
    for n, before in engine.items():
        after = left.vectors[n]
        one = {shaft.name: shaft for shaft in shafts if shaft.order == n}
        rolls = {name: rolled([shaft]) for name, shaft in one.items()}
        for words, alone, of_shafts, rest in (
            (
                Text("force of order {n}, N", n=n),
                _peak(before.forces),
                {k: abs(s.force) for k, s in one.items()},
                _peak(after.forces),
            ),
            (
                Text("couple of order {n}, N·m", n=n),
                _peak(before.couples),
                {k: abs(s.couple) for k, s in one.items()},
                _peak(after.couples),
            ),
            (
                Text("roll of order {n}, N·m", n=n),
                _size(before.roll),
                {k: _size(T) for k, T in rolls.items()},
                _size(after.roll),
            ),
        ):
            cells = [alone, *(of_shafts.get(shaft.name) for shaft in shafts), rest]
            if any(cell is not None and cell > NOTHING for cell in cells):
                rows.append((words, *cells))
    columns = (
        (EMPTY, ""),
        (Text("engine"), ""),
        *((Name(shaft.name), "") for shaft in shafts),
        (Text("left over"), ""),
    )
    note = Text(
        "Peaks over a turn of the crank, at rated speed. Of the roll the torque of the engine's inertia is counted, "
        "that of the gas is not."
    )
    return Table("sums", Text("What the shafts leave over"), columns, tuple(rows), note, short=True)


def _peak(pair: tuple[complex, complex]) -> float:
    return abs(pair[0]) + abs(pair[1])


def _size(roll: complex | None) -> float | None:
    return None if roll is None else abs(roll)


# --- one tooth off
# Late and early differ, since what is left has a phase of its own: of each value by itself the larger one counts.

OFF = Text("definition: one tooth late or one tooth early, the larger")


@formula("F_τ", OFF, names={"late": "F_late", "early": "F_early"})
def force_off(late: Newton, early: Newton) -> Newton:
    return largest(late, early)


@formula("C_τ", OFF, names={"late": "C_late", "early": "C_early"})
def couple_off(late: NewtonMetre, early: NewtonMetre) -> NewtonMetre:
    return largest(late, early)


@formula("T_τ", OFF, names={"late": "T_late", "early": "T_early"})
def roll_off(late: NewtonMetre, early: NewtonMetre) -> NewtonMetre:
    return largest(late, early)


@result
class ToothOff(Shown):
    """What is left with some of the shafts one tooth of their own wheels off, all late or all early, at its peak over a
    turn: of each value the larger."""

    order_1_force: Newton | None = value("First-order force left one tooth off", "N", "F_τ", default=None)
    order_1_couple: NewtonMetre | None = value("First-order couple left one tooth off", "N·m", "C_τ", default=None)
    order_1_roll: NewtonMetre | None = value("First-order roll left one tooth off", "N·m", "T_τ", default=None)
    order_2_force: Newton | None = value("Second-order force left one tooth off", "N", "F_τ", default=None)
    order_2_couple: NewtonMetre | None = value("Second-order couple left one tooth off", "N·m", "C_τ", default=None)
    order_2_roll: NewtonMetre | None = value("Second-order roll left one tooth off", "N·m", "T_τ", default=None)
    # by order: force, couple and roll (None: not known), each late and early
    columns: dict[int, tuple[tuple[float, float], tuple[float, float], tuple[float, float] | None]]


@record
class TeethOff:
    """Each shaft by itself; each shaft together with its mirror images, by its name; all shafts, where there are
    several.  A row is left out where a wheel is not known."""

    shafts: dict[str, ToothOff]
    pairs: dict[str, ToothOff]
    all: ToothOff | None

    def rows(self) -> Iterator[tuple[Text, ToothOff]]:
        """All of them with their words."""
        for name, off in self.shafts.items():
            yield Name(name), off
        for name, off in self.pairs.items():
            yield Text("{name} and its mirror image", name=Name(name)), off
        if self.all is not None:
            yield Text("all shafts"), self.all


def pairs_of(shafts: Sequence[SystemShaft]) -> dict[str, list[SystemShaft]]:
    """Each shaft that has mirror images together with them, by its name."""
    pairs: dict[str, list[SystemShaft]] = {}
    for shaft in shafts:
        if shaft.mirrors is not None:
            original = next(one for one in shafts if one.name == shaft.mirrors)
            pairs.setdefault(shaft.mirrors, [original]).append(shaft)
    return pairs


def teeth_off(engine: Mapping[int, OrderVectors], shafts: Sequence[SystemShaft]) -> TeethOff:
    """What is left with shafts one tooth off, at the orders at which they turn.

    A mirrored pair that is off together stays a pair of mirror images: its force stays vertical, and each sense of it
    lacks 2·sin(τ/2)."""
    alone = {
        shaft.name: _off(engine, shafts, [shaft], Text("{name} one tooth off", name=Name(shaft.name)))
        for shaft in shafts
    }
    both = {
        name: _off(engine, shafts, pair, Text("{name} and its mirror image one tooth off", name=Name(name)))
        for name, pair in pairs_of(shafts).items()
    }
    return TeethOff(
        shafts={name: one for name, one in alone.items() if one is not None},
        pairs={name: pair for name, pair in both.items() if pair is not None},
        all=_off(engine, shafts, shafts, Text("all shafts one tooth off")) if len(shafts) > 1 else None,
    )


def _off(
    engine: Mapping[int, OrderVectors], shafts: Sequence[SystemShaft], which: Sequence[SystemShaft], words: Text
) -> ToothOff | None:
    values: dict[str, Any] = {}
    columns: dict[int, Any] = {}
    orders = _by_order(shafts)
    for n in _by_order(which):
        forces, couples, rolls = [], [], []
        for subject, sign in ((Text("{words}, late", words=words), 1.0), (Text("{words}, early", words=words), -1.0)):
            with about(subject):
                moved = []
                for shaft in orders[n]:
                    if shaft in which:
                        if shaft.tooth is None:
                            return None
                        shaft = shaft.late_by(based_on(sign * shaft.tooth, shaft.tooth))
                    moved.append(shaft)
                case = left(engine[n], moved, subject)
                forces.append(v.force_peak(F_f=case.force_forward, F_b=case.force_backward))
                couples.append(v.couple_peak(C_f=case.couple_forward, C_b=case.couple_backward))
                if case.roll is not None:
                    rolls.append(roll_amplitude(T_S=case.roll))
        with about(words):
            values[f"order_{n}_force"] = force_off(late=forces[0], early=forces[1])
            values[f"order_{n}_couple"] = couple_off(late=couples[0], early=couples[1])
            if rolls:
                values[f"order_{n}_roll"] = roll_off(late=rolls[0], early=rolls[1])
        columns[n] = tuple(forces), tuple(couples), tuple(rolls) or None
    return ToothOff(**values, columns=columns)


def teeth_table(teeth: TeethOff) -> Table:
    """Every row of them, order by order, late beside early."""
    rows = [
        (words, str(n), *force, *couple, *(roll or (None, None)))
        for words, off in teeth.rows()
        for n, (force, couple, roll) in off.columns.items()
    ]
    columns = (
        (Text("one tooth off"), ""),
        (Text("order"), ""),
        (Text("force left, late"), "N"),
        (Text("early"), "N"),
        (Text("couple left, late"), "N·m"),
        (Text("early"), "N·m"),
        (Text("roll left, late"), "N·m"),
        (Text("early"), "N·m"),
    )
    note = Text("Peaks over a turn, with shafts fitted one tooth of their own wheels late or early.")
    return Table("teeth_off", Text("What is left one tooth off"), columns, tuple(rows), note)
