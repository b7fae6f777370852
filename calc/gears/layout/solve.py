# SPDX-License-Identifier: Apache-2.0
"""The layout of a train from its geometry: places, clearances, teeth that meet, assembly."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import chain
from math import isfinite
from typing import NamedTuple, TypedDict

from ...sheet.check import Check
from ...sheet.deferred import Later
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.units import Metre, NewtonMetre, Number, Radian
from ...sheet.value import about, trace
from ..backlash.formulas import residual_couple
from ..inputs import GearsInputs
from ..result import TrainResult
from ..tree import Tree
from . import formulas as f
from .curves import errata, layout_curve, notes, tables
from .phase import Phase, hunting, phase
from .positions import Placing, place
from .result import LayoutResult, MeshLayout, ShaftLayout, WheelLayout
from .room import SHAFT_AXIS, Clearance, Room, clearance_checks, clearances, hunting_check, insertion_check, room


class ShaftInTrain(NamedTuple):
    """A counter-shaft and the wheel of a train on it; what is None is not known.

    `axis`: from the crank, up + i·side; its wheel stands there.  `eccentric`: direction of the shaft's eccentric mass
    nearest to that wheel with cylinder 1 at TDC, from up in the sense of crank rotation.  `journals`: the
    diameters that the seats of its front and rear journal leave to what comes in, infinite where nothing has to;
    `gear_end`: "front" or "rear", the one that the wheel has to pass; None: the smaller one is judged.  `couple`: what
    the shaft balances."""

    axis: complex | None = None
    eccentric: Radian | None = None
    journals: tuple[Metre, Metre] | None = None
    gear_end: str | None = None
    couple: NewtonMetre | None = None

    @property
    def inserted_end(self) -> str:
        """The end whose seat the wheel has to pass."""
        return self.gear_end or ("front" if self.journals is None or self.journals[0] <= self.journals[1] else "rear")


NO_SHAFTS: Mapping[str, ShaftInTrain] = {}


def layout(
    gears: GearsInputs, train: TrainResult, shafts: Mapping[str, ShaftInTrain] = NO_SHAFTS
) -> Outcome[LayoutResult]:
    """Places, clearances, marks and assembly of a train; `shafts` by their names."""
    on = {turn.wheel: shafts.get(name, ShaftInTrain()) for name, turn in train.shafts.items()}
    axes = {wheel: shaft.axis for wheel, shaft in on.items() if shaft.axis is not None}
    eccentrics = {wheel: shaft.eccentric for wheel, shaft in on.items() if shaft.eccentric is not None}
    with trace() as lines:
        around = room(gears, train)
        placing = place(gears, train, around, axes)
        directions: dict[str, Radian] = {}
        meshes: dict[str, MeshLayout] = {}
        for key, mesh in train.meshes.items():
            if mesh.driver in placing.p and mesh.driven in placing.p:
                with about(Text("mesh {pair}, place", pair=mesh.title)):
                    directions[key] = f.line_of_centres(p_1=placing.p[mesh.driver], p_3=placing.p[mesh.driven])
            factor, turns = hunting(train, mesh)
            meshes[key] = MeshLayout(line_of_centres=directions.get(key), common_factor=factor, turns_to_repeat=turns)
        teeth = phase(train, directions, {gears.first: gears.tooth_angle}, eccentrics)
        free: dict[str, dict[str, Clearance]] = {}
        wheels: dict[str, WheelLayout] = {}
        for name in gears.along:
            if name in train.wheels:
                wheels[name], free[name] = _wheel(name, gears, train, placing, around, teeth)
        assembly = _assembly(gears, train, teeth, on)
        sprockets = {name: p for name, p in ({train.tree.first: 0j} | axes).items() if name not in wheels}
        result = LayoutResult(wheels=wheels, meshes=meshes, sprockets=sprockets, **assembly)
    end_unknown = {wheel: shaft.journals is not None and shaft.gear_end is None for wheel, shaft in on.items()}
    wrong = (
        errata(train.wheels[wheel].tip_diameter, shaft.journals, assembled.insertion_gap)
        for (wheel, shaft), assembled in zip(on.items(), result.shafts.values())
        if wheel in train.wheels
    )
    return Outcome(
        "gears",
        result=result,
        checks=tuple(_checks(gears, train, on, placing, free, result)),
        lines=tuple(lines),
        curves=Later(lambda: filter(None, [layout_curve(gears, train, result)])),
        tables=Later(lambda: tables(train, placing, result, teeth)),
        errata=tuple(chain.from_iterable(wrong)),
        notes=Later(lambda: (*placing.notes, *notes(gears, train, result, teeth, end_unknown))),
    )


def _checks(
    gears: GearsInputs,
    train: TrainResult,
    on: Mapping[str, ShaftInTrain],
    placing: Placing,
    free: Mapping[str, dict[str, Clearance]],
    result: LayoutResult,
) -> Iterator[Check]:
    """`on`: the shafts by the wheels on them; `free`: the clearances of each wheel by their kind."""
    yield from placing.checks
    for key, mesh in train.meshes.items():
        z_1, z_2 = train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
        teeth = result.meshes[key]
        yield hunting_check(key, mesh, z_1, z_2, teeth.common_factor, teeth.turns_to_repeat)
    order = tuple(free)
    placed = [(wheel, name) for wheel, name in zip(on, result.shafts) if on[wheel].axis is not None]
    axes = {wheel: SHAFT_AXIS.replace(".S.", f".{name}.") for wheel, name in placed if len(on) > 1}
    for name in order:
        yield from clearance_checks(name, free[name], order, placing.by.get(name) in ("two circles", "chosen"), axes)
    for (wheel, shaft), (name, assembled) in zip(on.items(), result.shafts.items()):
        if assembled.insertion_gap is not None:
            end = Text("front") if shaft.inserted_end == "front" else Text("rear")
            yield insertion_check(wheel, end, assembled.insertion_gap, name if len(on) > 1 else "")


def _wheel(
    name: str, gears: GearsInputs, train: TrainResult, placing: Placing, around: Room, teeth: Phase
) -> tuple[WheelLayout, dict[str, Clearance]]:
    """A wheel in its place, and its clearances by their kind."""
    p = placing.p.get(name)
    if p is None:
        return WheelLayout(tooth_angle=teeth.teeth.get(name)), {}
    given = next(w.position for w in gears.wheels if w.name == name)
    with about(Text("wheel {name}, place", name=name)):
        above, beside = given if given is not None else (f.up(p=p), f.side(p=p))
    free = clearances(name, placing.p, around)
    tight = min(free.values(), key=lambda clearance: clearance.g, default=None)
    wheel = WheelLayout(
        position_up=above,
        position_side=beside,
        included_angle=_included(name, train, placing),
        **{f"clearance_{kind}": clearance.g for kind, clearance in free.items()},
        tooth_angle=teeth.teeth.get(name),
        position=p,
        placed_by=placing.by[name],
        nearest=tight.to if tight else "",
        clearance=tight.g if tight else None,
    )
    return wheel, free


def _included(name: str, train: TrainResult, placing: Placing) -> Radian | None:
    """Of a wheel with two meshes, both neighbours placed."""
    mates = [m.driver if m.driven == name else m.driven for m in train.meshes.values() if name in (m.driver, m.driven)]
    if len(mates) != 2 or not all(mate in placing.p for mate in mates):
        return None
    with about(Text("wheel {name}, place", name=name)):
        return f.included_angle(p_1=placing.p[mates[0]], p_2=placing.p[name], p_3=placing.p[mates[1]])


class Assembly(TypedDict):
    marks_period: Number
    shafts: dict[str, ShaftLayout]


def _assembly(gears: GearsInputs, train: TrainResult, teeth: Phase, on: Mapping[str, ShaftInTrain]) -> Assembly:
    """Marks; and of the wheel on each shaft the step in which it can be meshed anew and what that costs, and its way
    through the seat."""
    with about(Text("train, assembly")):
        pitches = {name: f.angular_pitch(z=train.tree.driving[turn.wheel].z_2) for name, turn in train.shafts.items()}
        period = f.marks_period(**_turning(gears, train.tree))
        shafts = {}
        for (name, tau), (wheel, shaft) in zip(pitches.items(), on.items()):
            shafts[name] = _shaft(gears, train, wheel, shaft, tau, teeth.offsets.get(wheel))
    return Assembly(marks_period=period, shafts=shafts)


class MarkedTeeth(TypedDict):
    z_1: Number
    z: tuple[int, ...]


def _turning(gears: GearsInputs, tree: Tree) -> MarkedTeeth:
    """The teeth of the first driver and of the wheels, or what stands for them behind chains and belts: the turns of a
    wheel are those of the first driver times z_1/z."""
    if not gears.stages:
        return MarkedTeeth(z_1=tree.links[0].z_1, z=tuple(w.teeth for w in gears.wheels))
    turns = {tree.first: Fraction(1)}
    for link in tree.links:
        turns[link.driven] = turns[link.driver] * Fraction(int(link.z_1), int(link.z_2))
    return MarkedTeeth(z_1=1, z=tuple(x.denominator for x in turns.values()))


def _shaft(
    gears: GearsInputs, train: TrainResult, name: str, shaft: ShaftInTrain, tau: Radian, offset: Radian | None
) -> ShaftLayout:
    """Of the wheel `name` on a shaft; `tau`: the step in which it can be meshed anew, `offset`: from the eccentric to
    its nearest tooth."""
    values: dict[str, float] = dict(remesh_angle=tau)
    errors = {"remesh": tau}
    if offset is not None:
        values["eccentric_offset"] = offset
        errors["eccentric_tooth"] = values["eccentric_tooth_error"] = f.error_of_tooth(delta=offset)
        errors["eccentric_space"] = values["eccentric_space_error"] = f.error_of_space(tau=tau, delta=offset)
    if (C := shaft.couple) is not None:
        values |= {f"{what}_couple": residual_couple(C=C, Delta_phi=error) for what, error in errors.items()}
    if shaft.journals is not None and name in train.wheels:
        wheel = next(w for w in gears.wheels if w.name == name)
        upper = wheel.tip_diameter_tolerance[0] if wheel.tip_diameter_tolerance else 0.0
        front, rear = shaft.journals
        d_J = front if shaft.inserted_end == "front" else rear
        if isfinite(d_J):
            values["insertion_gap"] = f.insertion_gap(d_J=d_J, d_a=train.wheels[name].tip_diameter, E_da=upper)
    return ShaftLayout(**values)
