# SPDX-License-Identifier: Apache-2.0
"""The layout of a train from its geometry: places, clearances, teeth that meet, assembly."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from ...sheet.check import Check
from ...sheet.deferred import Later
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.units import Metre, NewtonMetre, Radian
from ...sheet.value import about, trace
from ..backlash.formulas import residual_couple
from ..inputs import GearsInputs
from ..result import TrainResult
from . import formulas as f
from .curves import errata, layout_curve, notes, tables
from .phase import Phase, hunting, phase
from .positions import Placing, place
from .result import LayoutResult, MeshLayout, WheelLayout
from .room import Clearance, Room, clearance_checks, clearances, hunting_check, insertion_check, room


class ShaftInTrain(NamedTuple):
    """The counter-shaft on the last wheel of a train; what is None is not known.

    `axis`: from the crank, up + i·side; the last wheel stands there.  `eccentric`: direction of the shaft's eccentric
    mass nearest to that wheel with cylinder 1 at TDC, from up in the sense of crank rotation.  `journals`: diameters of
    its front and rear journal; `gear_end`: "front" or "rear", the one that the last wheel has to pass; None: the
    smaller one is judged.  `couple`: what the shaft balances."""

    axis: complex | None = None
    eccentric: Radian | None = None
    journals: tuple[Metre, Metre] | None = None
    gear_end: str | None = None
    couple: NewtonMetre | None = None

    @property
    def inserted_end(self) -> str:
        """The end whose seat the last wheel has to pass."""
        return self.gear_end or ("front" if self.journals is None or self.journals[0] <= self.journals[1] else "rear")


ALONE = ShaftInTrain()


def layout(gears: GearsInputs, train: TrainResult, shaft: ShaftInTrain = ALONE) -> Outcome[LayoutResult]:
    """Places, clearances, marks and assembly of a train."""
    with trace() as lines:
        around = room(gears, train)
        placing = place(gears, train, around, shaft.axis)
        directions: dict[str, Radian] = {}
        meshes: dict[str, MeshLayout] = {}
        for key, mesh in train.meshes.items():
            if mesh.driver in placing.p and mesh.driven in placing.p:
                with about(Text("mesh {pair}, place", pair=mesh.title)):
                    directions[key] = f.line_of_centres(p_1=placing.p[mesh.driver], p_3=placing.p[mesh.driven])
            factor, turns = hunting(train, mesh)
            meshes[key] = MeshLayout(line_of_centres=directions.get(key), common_factor=factor, turns_to_repeat=turns)
        teeth = phase(train, directions, gears.tooth_angle, shaft.eccentric)
        free: dict[str, dict[str, Clearance]] = {}
        wheels: dict[str, WheelLayout] = {}
        for name in gears.along:
            wheels[name], free[name] = _wheel(name, gears, train, placing, around, teeth)
        result = LayoutResult(wheels=wheels, meshes=meshes, **_assembly(gears, train, teeth, shaft))
    last, end_unknown = train.wheels[gears.meshes[-1].driven], shaft.journals is not None and shaft.gear_end is None
    return Outcome(
        "gears",
        result=result,
        checks=tuple(_checks(gears, train, shaft, placing, free, result)),
        lines=tuple(lines),
        curves=Later(lambda: filter(None, [layout_curve(gears, train, result)])),
        tables=Later(lambda: tables(train, placing, result, teeth)),
        errata=errata(last.tip_diameter, shaft.journals, result.insertion_gap),
        notes=Later(lambda: (*placing.notes, *notes(gears, result, teeth, last, end_unknown))),
    )


def _checks(
    gears: GearsInputs,
    train: TrainResult,
    shaft: ShaftInTrain,
    placing: Placing,
    free: Mapping[str, dict[str, Clearance]],
    result: LayoutResult,
) -> Iterator[Check]:
    """`free`: the clearances of each wheel by their kind."""
    yield from placing.checks
    for key, mesh in train.meshes.items():
        z_1, z_2 = train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
        teeth = result.meshes[key]
        yield hunting_check(key, mesh, z_1, z_2, teeth.common_factor, teeth.turns_to_repeat)
    order = gears.along
    for name in order:
        yield from clearance_checks(name, free[name], order, placing.by.get(name) in ("two circles", "chosen"))
    if result.insertion_gap is not None:
        end = Text("front") if shaft.inserted_end == "front" else Text("rear")
        yield insertion_check(gears.meshes[-1].driven, end, result.insertion_gap)


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


def _assembly(gears: GearsInputs, train: TrainResult, teeth: Phase, shaft: ShaftInTrain) -> dict[str, float]:
    """Marks, the step in which the train can be meshed anew and what it costs, and the way of the last wheel through
    the seat."""
    first, last = train.wheels[gears.meshes[0].driver], train.wheels[gears.meshes[-1].driven]
    with about(Text("train, assembly")):
        tau = f.angular_pitch(z=last.teeth)
        period = f.marks_period(z_1=first.teeth, z=tuple(w.teeth for w in gears.wheels))
        values: dict[str, float] = dict(marks_period=period, remesh_angle=tau)
        errors = {"remesh": tau}
        if teeth.offset is not None:
            values["eccentric_offset"] = teeth.offset
            errors["eccentric_tooth"] = values["eccentric_tooth_error"] = f.error_of_tooth(delta=teeth.offset)
            errors["eccentric_space"] = values["eccentric_space_error"] = f.error_of_space(tau=tau, delta=teeth.offset)
        if (C := shaft.couple) is not None:
            values |= {f"{name}_couple": residual_couple(C=C, Delta_phi=error) for name, error in errors.items()}
        if shaft.journals is not None:
            wheel = next(w for w in gears.wheels if w.name == last.name)
            upper = wheel.tip_diameter_tolerance[0] if wheel.tip_diameter_tolerance else 0.0
            front, rear = shaft.journals
            d_J = front if shaft.inserted_end == "front" else rear
            values["insertion_gap"] = f.insertion_gap(d_J=d_J, d_a=last.tip_diameter, E_da=upper)
    return values
