# SPDX-License-Identifier: Apache-2.0
"""The step of several shafts: what twins have of their originals, and all of them by their names behind what they leave
over together."""

from collections.abc import Mapping

from ..imbalance.remedies import roll_torque
from ..sheet.formula import formula
from ..sheet.functions import total
from ..sheet.linked_array import gathered
from ..sheet.quantity import group, result, value, values
from ..sheet.record import replace
from ..sheet.shown import Shown
from ..sheet.step import Outcome, beside, joined
from ..sheet.text import Name, Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre2,
    KilogramMetres2,
    Kilograms,
    Metre,
    Newton,
    NewtonMetre,
    Number,
    Numbers,
    Radian,
    RevPerSecond,
)
from ..sheet.value import about, based_on, trace
from . import formulas as f
from .mass_properties import InertiaResult, turned
from .result import CountershaftResult, Standing
from .rows import called, sign
from .sums import SystemResult
from .supports import phases_of
from .twins import Resolved, turned_over


def of_twin(original: CountershaftResult, twin: Resolved) -> CountershaftResult:
    """What a twin gives: of a mirror image the conjugate vectors, with loads, slopes and speeds that are its
    original's."""
    axis = twin.inputs.axis
    F, C, reactions, masses = original.force_vector, original.couple_vector, original.reactions, original.masses
    scatter, side, inertia = original.scatter, original.centre_of_gravity_side, original.inertia
    with about(Name(twin.name)):
        if twin.how == "mirrors":
            F, C = f.mirrored_force(F_S=F), f.mirrored_couple(C_S=C)
            reactions = tuple(based_on(R.conjugate(), R) for R in reactions)
            masses = tuple(map(turned_over, masses))
            scatter = None if scatter is None else replace(scatter, target=scatter.target.mirrored())
            inertia = None if inertia is None else inertia.mirrored()
            side = None if side is None else turned(side)
        return replace(
            original,
            couple_phase=f.couple_phase(C_S=C),
            force_vector=F,
            couple_vector=C,
            reactions=reactions,
            load_phases=phases_of(original.loads, reactions),
            masses=masses,
            scatter=scatter,
            centre_of_gravity_side=side,
            inertia=inertia,
            roll_torque=None if axis is None else roll_torque(p=based_on(complex(*axis), axis), F=F),
        )


@result
class TwinResult(Shown):
    """Of a twin what is not its original's."""

    couple: NewtonMetre = value("Couple of the shaft as designed", "N·m", "C_S", short=True)
    couple_phase: Radian = value("its phase, cylinder 1 at TDC", "°", short=True)
    force: Newton = value("Rotating force of the shaft", "N", "F_S", short=True)
    load_phases: dict[str, Radian] = values(
        "Phase of the {row} bearing's reaction on the shaft, cylinder 1 at TDC",
        "°",
        "∠R_*",
        id="reaction_*_phase",
        called=called,
        sign=sign,
    )
    centre_of_gravity_up: Metre | None = value(
        "Centre of gravity of its outline, up from the axis, cylinder 1 at TDC", "mm", "x_G", default=None
    )
    centre_of_gravity_side: Metre | None = value(
        "the same, 90° further in the sense of crank rotation", "mm", "y_G", default=None
    )
    inertia: InertiaResult | None = group(default=None, words="inertia")
    roll_torque: NewtonMetre | None = value("Roll torque of its force beside the crank", "N·m", "T_roll", default=None)
    first_critical_speed_on_films: RevPerSecond | None = value(
        "First bending critical speed on its films, where they are its own", "rpm", "n_1", default=None, short=True
    )
    standing: Standing | None = group(spread=True, default=None)


def told(twin: CountershaftResult) -> TwinResult:
    return TwinResult(
        couple=twin.couple,
        couple_phase=twin.couple_phase,
        force=twin.force,
        load_phases=twin.load_phases,
        centre_of_gravity_up=twin.centre_of_gravity_up,
        centre_of_gravity_side=twin.centre_of_gravity_side,
        inertia=twin.inertia,
        roll_torque=twin.roll_torque,
        first_critical_speed_on_films=twin.first_critical_speed_on_films,
        standing=twin.standing,
    )


@result
class ShaftsResult(Shown):
    """All shafts of an engine."""

    sums: SystemResult = group(spread=True)
    shafts: dict[str, CountershaftResult | TwinResult] = group(spread=True)
    shaft_mass: Kilogram | None = value("Mass of all shafts", "kg", "Σm_S", default=None, page_one=7)
    moment_of_inertia_at_crank: KilogramMetre2 | None = value(
        "Moment of inertia of all shafts, as the crank has it", "kg·mm²", "Σi²J_S", default=None
    )


@formula("Σm_S", "definition: sum over the shafts", names={"m": "m_S"})
def mass_of_all(m: Kilograms) -> Kilogram:
    return total(m)


@formula("Σi²J_S", "dynamics: kinetic energy of shafts that turn at i times crank speed", names={"J": "J_S"})
def inertia_at_crank(i: Numbers, J: KilogramMetres2) -> KilogramMetre2:
    return total(i**2 * J)


HELD_ALONE = Text(
    "Bolts: each support is judged with what its own shaft puts on it; where one holds several shafts, name them "
    "(carries)."
)


def whole(
    shafts: Mapping[str, Outcome[CountershaftResult]],
    twins: Mapping[str, Outcome[CountershaftResult]],
    ratios: Mapping[str, Number],
    sums: Outcome[SystemResult],
    *,
    named: bool,
) -> "Outcome[CountershaftResult] | Outcome[ShaftsResult]":
    """The step: the one shaft with what it leaves, or all of them by their names, `named`, as they are where a design
    has several; `twins` behind their originals."""
    if not named:
        (first,) = shafts.values()
        alone = first if first.result is None else replace(first, result=replace(first.result, sums=sums.result))
        return beside(sums, alone)
    every = {name: shaft.result for name, shaft in (*shafts.items(), *twins.items()) if shaft.result is not None}
    together = None
    if sums.result is not None and len(every) == len(shafts) + len(twins):
        masses = [shaft.mass for shaft in every.values() if shaft.mass is not None]
        inertias = [shaft.moment_of_inertia for shaft in every.values() if shaft.moment_of_inertia is not None]
        with trace() as lines:
            m, J = None, None
            if len(masses) == len(inertias) == len(every):
                m = mass_of_all(m=gathered(masses))
                J = inertia_at_crank(i=gathered(list(ratios.values())), J=gathered(inertias))
        together = ShaftsResult(
            sums=sums.result,
            shafts={name: told(shaft) if name in twins else shaft for name, shaft in every.items()},
            shaft_mass=m,
            moment_of_inertia_at_crank=J,
        )
        sums = replace(sums, lines=(*sums.lines, *lines))
    if len(every) > 1 and any(shaft.bolts is not None and shaft.bolts.carries is None for shaft in every.values()):
        sums = replace(sums, notes=(*sums.notes, HELD_ALONE))
    return beside(sums, joined("countershaft", {**shafts, **twins}, together, named=True))
