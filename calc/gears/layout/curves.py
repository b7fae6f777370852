# SPDX-License-Identifier: Apache-2.0
"""The train seen along its axes, the tables of its places, marks and forces, and what is assumed of them."""

import math
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from ...sheet.arrays import ComplexArray
from ...sheet.quantity import dotted
from ...sheet.step import Curve, Erratum, Series, Table, axis_label
from ...sheet.text import Amount, Name, Text
from ...sheet.units import Metre, Number
from ..inputs import GearsInputs
from ..limits import mm
from ..result import TrainResult
from .phase import Phase
from .positions import Placing
from .result import ForcesResult, LayoutResult, ShaftLayout

MM = 1e3
Row = tuple[str | float | None, ...]
AROUND = np.linspace(0, 2 * np.pi, 121)


def layout_curve(gears: GearsInputs, train: TrainResult, layout: LayoutResult) -> Curve | None:
    """In true scale: circles of tips and of meshing, a spoke to tooth 1, walls and neighbours.  None where no wheel has
    a place."""
    placed = {name: wheel for name, wheel in layout.wheels.items() if wheel.position is not None}
    if not placed:
        return None
    series = []
    for name, wheel in placed.items():
        working = {round(d_w / 2, 5): d_w / 2 for _, d_w, _ in train.mates(name)}  # alike ones once
        radii = [train.wheels[name].tip_diameter / 2, *sorted(working.values(), reverse=True)]
        direction = np.exp(1j * (wheel.tooth_angle or 0.0))
        # one line: each ring begins and ends at tooth 1
        rings = [radius * direction * np.exp(1j * AROUND) for radius in radii]
        series.append(_line(Name(name), wheel.position + np.concatenate([*rings, [0.0]])))
    places = {name: wheel.position for name, wheel in placed.items()} | layout.sprockets
    series += [_line(Name(name), line) for name, line in stage_lines(train, places)]
    for wall in gears.walls:
        series.append(_line(Name(wall.name), np.array([complex(*wall.from_), complex(*wall.to)])))
    for other in gears.neighbours:
        series.append(_line(Name(other.name), complex(*other.position) + other.radius * np.exp(1j * AROUND)))
    return Curve(
        "layout",
        Text("Layout of the train, cylinder 1 at TDC, crank clockwise"),
        axis_label("side", "mm"),
        axis_label("up", "mm"),
        tuple(series),
        equal=True,
    )


def stage_lines(train: TrainResult, places: Mapping[str, complex | None]) -> Iterator[tuple[str, ComplexArray]]:
    """Each chain or belt whose axes have a place, by its name: its line around both sprockets; of a sprocket on its
    outer side the pitch circle, for where else the chain runs is not known."""
    for name, stage in train.stages.items():
        p_1, p_2 = places.get(stage.driver), places.get(stage.driven)
        if p_1 is not None and p_2 is not None:
            r_1, r_2 = stage.pitch_diameter_driver / 2, stage.pitch_diameter_driven / 2
            inner = train.tree.by_key[name].sense > 0
            yield name, loop(p_1, p_2, r_1, r_2) if inner else p_2 + r_2 * np.exp(1j * AROUND)


def loop(p_1: complex, p_2: complex, r_1: Metre, r_2: Metre) -> ComplexArray:
    """The line of a chain around two sprockets on its inner side, closed; one circle where the other lies in it."""
    apart = abs(p_2 - p_1)
    if apart <= abs(r_1 - r_2):
        p, r = (p_1, r_1) if r_1 >= r_2 else (p_2, r_2)
        circle: ComplexArray = p + r * np.exp(1j * AROUND)
        return circle
    toward = math.atan2((p_2 - p_1).imag, (p_2 - p_1).real)
    half = math.acos((r_1 - r_2) / apart)  # between the line of centres and the radius to a strand
    back = np.linspace(toward + half, toward - half + 2 * math.pi, AROUND.size)
    front = np.linspace(toward - half, toward + half, AROUND.size)
    line: ComplexArray = np.concatenate([p_1 + r_1 * np.exp(1j * back), p_2 + r_2 * np.exp(1j * front)])
    return np.append(line, line[0])


def _line(label: Text, points: ComplexArray) -> Series:
    return Series(label, points.imag * MM, points.real * MM)


def tables(train: TrainResult, placing: Placing, result: LayoutResult, teeth: Phase) -> tuple[Table, ...]:
    """Places, the crossings of the circles of the centre distances, and the teeth to mark; none of them without
    places."""
    if not placing.p:
        return ()
    rows: list[Row] = []
    for name, wheel in result.wheels.items():
        if (p := wheel.position) is not None:
            tooth = None if wheel.tooth_angle is None else math.degrees(wheel.tooth_angle)
            room = None if wheel.clearance is None else wheel.clearance / 1e-3
            where = p.real / 1e-3, p.imag / 1e-3, wheel.placed_by
            rows.append((name, train.wheels[name].teeth, *where, tooth, wheel.nearest or None, room))
    columns = (
        (Text("wheel"), ""),
        (Text("z"), ""),
        (Text("up"), "mm"),
        (Text("side"), "mm"),
        (Text("placed by"), ""),
        (Text("tooth 1"), "°"),
        (Text("nearest"), ""),
        (Text("clearance"), "mm"),
    )
    covers = tuple(f"gears.{name}.{part}" for name in placing.p for part in ("position_", "clearance_", "tooth_angle"))
    note = Text("From the crank's axis; side: 90° on in its rotation.")
    tables = [Table("places", Text("Places of the wheels"), columns, tuple(rows), note, covers)]
    if placing.solutions:
        both: list[Row] = []
        for name, between, p, g, chosen in placing.solutions:
            room, answer = g / 1e-3 if math.isfinite(g) else None, Text("yes") if chosen else Text("no")
            both.append((name, between, p.real / 1e-3, p.imag / 1e-3, room, answer))
        head = (
            (Text("wheel"), ""),
            (Text("between"), ""),
            (Text("up"), "mm"),
            (Text("side"), "mm"),
            (Text("clearance"), "mm"),
            (Text("chosen"), ""),
        )
        title = Text("Where the circles of the centre distances cross")
        tables.append(Table("idler_positions", title, head, tuple(both)))
    return (*tables, _marks(teeth, result.marks_period)) if teeth.marks else tuple(tables)


def _marks(teeth: Phase, period: float) -> Table:
    between = [Text("{between} and {between2}", between=m.between[0], between2=m.between[1]) for m in teeth.marks]
    rows = tuple(
        (f"{m.driver}–{m.driven}", m.tooth, math.degrees(m.off), space) for m, space in zip(teeth.marks, between)
    )
    return Table(
        "timing_marks",
        Text("Teeth to mark, cylinder 1 at TDC"),
        (
            (Text("mesh"), ""),
            (Text("tooth of the driver"), ""),
            (Text("off the line of centres"), "°"),
            (Text("between teeth of the driven wheel"), ""),
        ),
        rows,
        Text(
            "Teeth are counted in the sense of crank rotation from tooth 1: that at the angle given for the first "
            "driver, of the wheel on a shaft the one nearest the eccentric, of the others the one nearest to up. The "
            "marks of all wheels meet again after {period} turns.",
            period=Amount(period, form="g"),
        ),
    )


def forces_tables(result: ForcesResult) -> tuple[Table, ...]:
    teeth = tuple(
        (key.replace("_", "–"), m.working_tangential_force, m.working_radial_force, m.axial_force)
        for key, m in result.meshes.items()
    )
    rows: list[Row] = []
    for name, w in result.wheels.items():
        least = w.bearing_force if w.bearing_force is not None else w.bearing_force_min
        most = w.bearing_force if w.bearing_force is not None else w.bearing_force_max
        couple = w.tilting_couple if w.tilting_couple is not None else w.tilting_couple_max
        direction = None if w.bearing_force_direction is None else math.degrees(w.bearing_force_direction)
        rows.append((name, w.hand or None, least, most, direction, w.thrust, couple))
    covers = tuple(
        f"gears.{name}.{part}" for name in result.wheels for part in ("bearing_force", "thrust", "tilting_couple")
    )
    return (
        Table(
            "tooth_forces",
            Text("Forces between the teeth, at the working circles"),
            ((Text("mesh"), ""), (Text("F_tw"), "N"), (Text("F_rw"), "N"), (Text("F_a"), "N")),
            teeth,
            covers=tuple(
                f"gears.{key}.{part}"
                for key in result.meshes
                for part in ("working_tangential", "working_radial", "axial_")
            ),
        ),
        Table(
            "bearing_forces",
            Text("Forces on the bearings of the wheels"),
            (
                (Text("wheel"), ""),
                (Text("hand"), ""),
                (Text("least"), "N"),
                (Text("most"), "N"),
                (Text("direction"), "°"),
                (Text("thrust"), "N"),
                (Text("tilting couple"), "N·m"),
            ),
            tuple(rows),
            Text(
                "Least and most differ where the included angle is not known; the tilting couple is then the largest. "
                "Direction from up in the sense of crank rotation. Thrust: + towards the flywheel, the crank turning "
                "clockwise seen from its front end."
            ),
            covers,
        ),
    )


# --- what is assumed and to be heeded of the layout and of the forces on its axes, and where the source is wrong

HANDS = {"left": Text("left"), "right": Text("right")}
# Of the drawing and the text of Finotti 2013: journal, tip circle, and the gap that the text gives.
DRAWN_JOURNAL, DRAWN_TIP, DRAWN_GAP = 59.5e-3, 58.7e-3, 0.8e-3


def notes(
    gears: GearsInputs, train: TrainResult, result: LayoutResult, teeth: Phase, end_unknown: Mapping[str, bool]
) -> Iterator[Text]:
    """`end_unknown`: by the wheel on each shaft, whether the journals are known, but not which of them it passes."""
    near = any(w.clearance is not None for w in result.wheels.values())
    if near and all(w.runout is None for w in gears.wheels):
        yield Text("Clearances around the wheels: no runout of the teeth is given, and none is taken off.")
    for name, unknown in end_unknown.items():
        z = train.tree.driving[name].z_2
        step = Amount(360 / z, form=".4g")
        if name not in teeth.teeth:
            yield Text(
                "{last} can be meshed in steps of 360°/{z} = {z2}°: without positions the assembly phase is not known.",
                last=name,
                z=z,
                z2=step,
            )
        elif (offset := teeth.offsets.get(name)) is not None:
            yield Text(
                "Seen so that the crank turns clockwise, cylinder 1 at TDC: the nearest tooth of {last} stands "
                "{degrees}° {sense} from its eccentric. This angle, or the marks, must stand on the drawing: {last} "
                "can be meshed in steps of {z}°. A tooth of {driver} stands at {degrees2}°, the angle given for it.",
                last=name,
                degrees=Amount(abs(math.degrees(offset)), form=".3f"),
                sense=Text("further") if offset >= 0 else Text("back"),
                z=step,
                driver=gears.first,
                degrees2=Amount(math.degrees(gears.tooth_angle), form="g"),
            )
        if unknown:
            yield Text("On which side {last} passes a bearing is not known: the smaller journal is judged.", last=name)


def errata(tip: Metre, journals: tuple[Metre, Metre] | None, gap: Metre | None) -> tuple[Erratum, ...]:
    """The gap in the text of the source, where the journal is the source's and the tip circle is that of its sheet, not
    of its drawing."""
    if gap is None or not 1.5 < gap / DRAWN_GAP < 2.5:
        return ()
    if journals is None or all(abs(d - DRAWN_JOURNAL) > 1e-6 for d in journals):
        return ()
    why = Text(
        "The drawing gives a tip diameter of {drawn_tip} mm, the sheet {tip} mm: with the sheet's the gap is about "
        "twice the eight tenths of the text. Which of the two was cut is not said.",
        drawn_tip=mm(DRAWN_TIP, "g"),
        tip=mm(tip, ".3f"),
    )
    name, source = Text("Gap at insertion by the text of Finotti 2013"), Text("Finotti 2013, 4.1")
    about, at = dotted("gears", ShaftLayout.insertion_gap), ("Finotti 2013", "1562-1568, 2058")
    return (Erratum(about, name, DRAWN_GAP * 1e3, "mm", source, why, at),)


def forces_notes(
    gears: GearsInputs, result: ForcesResult, turns: Mapping[str, Number], ends: Iterable[str]
) -> Iterator[Text]:
    """`ends`: the wheels on the shafts."""
    if not gears.helix_angle:
        return
    if all(w.hand is None for w in gears.wheels):
        yield Text(
            "Hands of the helix: not given; chosen: {driver} right-handed, the others in turn.", driver=gears.first
        )
    for last in ends:
        wheel = result.wheels[last]
        assert wheel.thrust is not None
        if wheel.thrust:
            where = Text("the flywheel") if wheel.thrust > 0 else Text("the front")
            yield Text(
                "{last}, {hand}-handed and turning {sense} the crank, is pushed {thrust} N towards {where} (the crank "
                "turning clockwise seen from its front end): its shaft must be held there, and the other way where the "
                "torque reverses.",
                last=last,
                hand=HANDS[wheel.hand],
                sense=Text("as") if turns[last] > 0 else Text("against"),
                thrust=Amount(abs(wheel.thrust)),
                where=where,
            )
