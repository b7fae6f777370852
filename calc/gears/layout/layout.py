# SPDX-License-Identifier: Apache-2.0
"""The layout of a train from its geometry: places, clearances, teeth that meet, assembly."""

import math
from typing import TYPE_CHECKING, Any

from ...sheet.check import Check
from ...sheet.step import Erratum, Outcome, Table
from ...sheet.trace import about, trace
from ...sheet.units import UNITS, Metre, NewtonMetre, Radian
from ..inputs import GearsInputs
from ..play.backlash import residual_couple
from . import formulas as f
from .clearances import clearance_checks, clearances
from .phase import Phase, hunting, insertion_check, marks_table, phase
from .positions import Placing, place
from .result import LayoutResult, MeshLayout, WheelLayout
from .room import Room, room

if TYPE_CHECKING:
    from ..result import TrainResult

# Of the drawing and the text of Finotti 2013: journal, tip circle, and the gap that the text gives.
DRAWN_JOURNAL, DRAWN_TIP, DRAWN_GAP = 59.5e-3, 58.7e-3, 0.8e-3


def layout(
    gears: GearsInputs,
    train: "TrainResult",
    shaft_axis: complex | None = None,
    eccentric: Radian | None = None,
    journals: tuple[Metre, Metre] | None = None,
    gear_end: str | None = None,
    couple: NewtonMetre | None = None,
) -> Outcome:
    """An outcome whose result is a LayoutResult.

    `shaft_axis`: of the counter-shaft from the crank, up + i·side; the last wheel stands there.  `eccentric`: direction of the
    shaft's first eccentric mass with cylinder 1 at TDC, from up in the sense of crank rotation.  `journals`: diameters of the shaft's
    front and rear journal; `gear_end`: "front" or "rear", the one that the last wheel has to pass; None: the smaller one is judged.
    `couple`: what the shaft balances.
    """
    last = gears.meshes[-1].driven
    with trace() as lines:
        around = room(gears, train)
        placing = place(gears, train, around, shaft_axis)
        directions: dict[str, Radian] = {}
        meshes: dict[str, MeshLayout] = {}
        checks = placing.checks
        for key, mesh in train.meshes.items():
            if mesh.driver in placing.p and mesh.driven in placing.p:
                with about(f"mesh {mesh.driver}–{mesh.driven}, place"):
                    directions[key] = f.line_of_centres(p_1=placing.p[mesh.driver], p_3=placing.p[mesh.driven])
            factor, turns, judged = hunting(train, key)
            checks.append(judged)
            meshes[key] = MeshLayout(line_of_centres=directions.get(key), common_factor=factor, turns_to_repeat=turns)
        teeth = phase(train, directions, gears.tooth_angle, eccentric)
        wheels = {w.name: _wheel(w.name, gears, train, placing, around, teeth, checks) for w in gears.wheels}
        found = _assembly(gears, train, teeth, journals, gear_end, couple, checks)
    result = LayoutResult(wheels=wheels, meshes=meshes, **found)
    tables = _tables(train, placing, result, teeth)
    notes = (*placing.notes, *_notes(gears, train, result, teeth, last, journals, gear_end))
    errata = _errata(train.wheels[last].tip_diameter, journals, result)
    return Outcome("gears", result=result, checks=tuple(checks), lines=tuple(lines), tables=tables, errata=errata, notes=notes)


def _wheel(
    name: str, gears: GearsInputs, train: "TrainResult", placing: Placing, around: Room, teeth: Phase, checks: list[Check]
) -> WheelLayout:
    p = placing.p.get(name)
    if p is None:
        return WheelLayout(tooth_angle=teeth.teeth.get(name))
    given = next(w.position for w in gears.wheels if w.name == name)
    with about(f"wheel {name}, place"):
        above, beside = given if given is not None else (f.up(p=p), f.side(p=p))
    found = clearances(name, placing.p, around)
    by = placing.by[name]
    checks += clearance_checks(name, found, [w.name for w in gears.wheels], by in ("two circles", "chosen"))
    tight = min(found.values(), key=lambda one: one.g, default=None)
    return WheelLayout(
        position_up=above, position_side=beside, included_angle=_included(name, train, placing),
        **{f"clearance_{kind}": one.g for kind, one in found.items()}, tooth_angle=teeth.teeth.get(name),
        position=p, placed_by=by, nearest=tight.to if tight else "", clearance=tight.g if tight else None,
    )  # fmt: skip


def _included(name: str, train: "TrainResult", placing: Placing) -> Radian | None:
    """Of a wheel with two meshes, both neighbours placed."""
    mates = [m.driver if m.driven == name else m.driven for m in train.meshes.values() if name in (m.driver, m.driven)]
    if len(mates) != 2 or not all(mate in placing.p for mate in mates):
        return None
    with about(f"wheel {name}, place"):
        return f.included_angle(p_1=placing.p[mates[0]], p_2=placing.p[name], p_3=placing.p[mates[1]])


def _assembly(
    gears: GearsInputs, train: "TrainResult", teeth: Phase, journals: tuple[Metre, Metre] | None, gear_end: str | None,
    couple: NewtonMetre | None, checks: list[Check],
) -> dict[str, Any]:  # fmt: skip
    """Marks, the step in which the train can be meshed anew and what it costs, and the way of the last wheel through the seat."""
    z = tuple(w.teeth for w in gears.wheels)
    first, last = train.wheels[gears.meshes[0].driver], train.wheels[gears.meshes[-1].driven]
    with about("train, assembly"):
        tau = f.angular_pitch(z=last.teeth)
        found: dict[str, Any] = dict(marks_period=f.marks_period(z_1=first.teeth, z=z), remesh_angle=tau)
        errors = {"remesh": tau}
        if teeth.offset is not None:
            found["eccentric_offset"] = teeth.offset
            errors["eccentric_tooth"] = found["eccentric_tooth_error"] = f.error_of_tooth(delta=teeth.offset)
            errors["eccentric_space"] = found["eccentric_space_error"] = f.error_of_space(tau=tau, delta=teeth.offset)
        if couple is not None:
            found |= {f"{name}_couple": residual_couple(C=couple, Delta_phi=error) for name, error in errors.items()}
        if journals is not None:
            wheel = next(w for w in gears.wheels if w.name == last.name)
            upper = wheel.tip_diameter_tolerance[0] if wheel.tip_diameter_tolerance else 0.0
            end = _end(journals, gear_end)
            gap = f.insertion_gap(d_J=journals[("front", "rear").index(end)], d_a=last.tip_diameter, E_da=upper)
            found["insertion_gap"] = gap
            checks.append(insertion_check(last.name, end, gap))
    return found


def _end(journals: tuple[Metre, Metre], gear_end: str | None) -> str:
    return gear_end or ("front" if journals[0] <= journals[1] else "rear")


def _tables(train: "TrainResult", placing: Placing, result: LayoutResult, teeth: Phase) -> tuple[Table, ...]:
    if not placing.p:
        return ()
    mm = UNITS["mm"].factor
    rows: list[tuple[str | float | None, ...]] = []
    for name, wheel in result.wheels.items():
        if wheel.position is not None:
            room_ = None if wheel.clearance is None else wheel.clearance / mm
            p, angle = wheel.position, wheel.tooth_angle
            tooth = None if angle is None else math.degrees(angle)
            row = name, train.wheels[name].teeth, p.real / mm, p.imag / mm, wheel.placed_by, tooth, wheel.nearest or None, room_
            rows.append(row)
    covers = tuple(f"gears.{name}.{part}" for name in placing.p for part in ("position_", "clearance_", "tooth_angle"))
    columns = (
        ("wheel", ""),
        ("z", ""),
        ("up", "mm"),
        ("side", "mm"),
        ("placed by", ""),
        ("tooth 1", "°"),
        ("nearest", ""),
        ("clearance", "mm"),
    )
    found = [Table("layout", "Places of the wheels", columns, tuple(rows), "From the crank's axis; side: 90° on in its rotation.", covers)]
    if placing.solutions:
        both = tuple(
            (wheel, between, p.real / mm, p.imag / mm, g / mm if math.isfinite(g) else None, "yes" if chosen else "no")
            for wheel, between, p, g, chosen in placing.solutions
        )
        head = (("wheel", ""), ("between", ""), ("up", "mm"), ("side", "mm"), ("clearance", "mm"), ("chosen", ""))
        found.append(Table("idler_positions", "Where the circles of the centre distances cross", head, both))
    return (*found, marks_table(teeth, result.marks_period)) if teeth.marks else tuple(found)


def _notes(
    gears: GearsInputs, train: "TrainResult", result: LayoutResult, teeth: Phase, last: str, journals: tuple[Metre, Metre] | None,
    gear_end: str | None,
) -> list[str]:  # fmt: skip
    notes = []
    if any(wheel.clearance is not None for wheel in result.wheels.values()) and all(w.runout is None for w in gears.wheels):
        notes.append("Clearances around the wheels: no runout of the teeth is given, and none is taken off.")
    z = train.wheels[last].teeth
    if last not in teeth.teeth:
        notes.append(f"{last} can be meshed in steps of 360°/{z} = {360 / z:.4g}°: without positions the assembly phase is not known.")
    elif teeth.offset is not None:
        sense = "further" if teeth.offset >= 0 else "back"
        notes.append(
            f"Seen so that the crank turns clockwise, cylinder 1 at TDC: the nearest tooth of {last} stands "
            f"{abs(math.degrees(teeth.offset)):.3f}° {sense} from its eccentric. This angle, or the marks, must stand on the drawing: "
            f"{last} can be meshed in steps of {360 / z:.4g}°. A tooth of {gears.meshes[0].driver} stands at gears.tooth_angle_deg = "
            f"{math.degrees(gears.tooth_angle):g}."
        )
    if journals is not None and gear_end is None:
        notes.append(f"On which side {last} passes a bearing is not known: the smaller journal is judged.")
    return notes


def _errata(tip: Metre, journals: tuple[Metre, Metre] | None, result: LayoutResult) -> tuple[Erratum, ...]:
    """The gap in the text of the source, where the journal is the source's and the tip circle is that of its sheet, not of its drawing."""
    gap = result.insertion_gap
    if gap is None or journals is None or all(abs(d - DRAWN_JOURNAL) > 1e-6 for d in journals) or not 1.5 < gap / DRAWN_GAP < 2.5:
        return ()
    return (
        Erratum(
            "gears.insertion_gap", "Gap at insertion by the text of Finotti 2013", DRAWN_GAP * 1e3, "mm", "Finotti 2013, text and drawing",
            f"The drawing gives a tip diameter of {DRAWN_TIP * 1e3:g} mm, the sheet {tip * 1e3:.3f} mm: with the sheet's the gap is about "
            "twice the eight tenths of the text.",
        ),
    )  # fmt: skip
