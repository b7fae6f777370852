# SPDX-License-Identifier: Apache-2.0
"""What is assumed and to be heeded of the layout of a train and of the forces on its axes, and where the source is
wrong."""

import math
from collections.abc import Mapping

from ...sheet.step import Erratum
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Number
from ..inputs import GearsInputs
from ..practice import mm
from ..result import WheelResult
from .phase import Phase
from .result import ForcesResult, LayoutResult

HANDS = {"left": Text("left"), "right": Text("right")}
# Of the drawing and the text of Finotti 2013: journal, tip circle, and the gap that the text gives.
DRAWN_JOURNAL, DRAWN_TIP, DRAWN_GAP = 59.5e-3, 58.7e-3, 0.8e-3


def notes(gears: GearsInputs, result: LayoutResult, teeth: Phase, last: WheelResult, end_unknown: bool) -> list[Text]:
    """`end_unknown`: the journals are known, but not which of them the last wheel passes."""
    notes, step = [], Amount(360 / last.teeth, form=".4g")
    if any(wheel.clearance is not None for wheel in result.wheels.values()) and all(
        w.runout is None for w in gears.wheels
    ):
        notes.append(Text("Clearances around the wheels: no runout of the teeth is given, and none is taken off."))
    if last.name not in teeth.teeth:
        notes.append(
            Text(
                "{last} can be meshed in steps of 360°/{z} = {z2}°: without positions the assembly phase is not known.",
                last=last.name,
                z=last.teeth,
                z2=step,
            )
        )
    elif teeth.offset is not None:
        notes.append(
            Text(
                "Seen so that the crank turns clockwise, cylinder 1 at TDC: the nearest tooth of {last} stands "
                "{degrees}° {sense} from its "
                "eccentric. This angle, or the marks, must stand on the drawing: {last} can be meshed in steps of "
                "{z}°. A tooth of {driver} "
                "stands at gears.tooth_angle_deg = {degrees2}.",
                last=last.name,
                degrees=Amount(abs(math.degrees(teeth.offset)), form=".3f"),
                sense=Text("further") if teeth.offset >= 0 else Text("back"),
                z=step,
                driver=gears.meshes[0].driver,
                degrees2=Amount(math.degrees(gears.tooth_angle), form="g"),
            )
        )
    if end_unknown:
        notes.append(
            Text("On which side {last} passes a bearing is not known: the smaller journal is judged.", last=last.name)
        )
    return notes


def errata(tip: Metre, journals: tuple[Metre, Metre] | None, gap: Metre | None) -> tuple[Erratum, ...]:
    """The gap in the text of the source, where the journal is the source's and the tip circle is that of its sheet, not
    of its drawing."""
    if (
        gap is None
        or journals is None
        or all(abs(d - DRAWN_JOURNAL) > 1e-6 for d in journals)
        or not 1.5 < gap / DRAWN_GAP < 2.5
    ):
        return ()
    why = Text(
        "The drawing gives a tip diameter of {drawn_tip} mm, the sheet {tip} mm: with the sheet's the gap is about "
        "twice the eight tenths "
        "of the text.",
        drawn_tip=mm(DRAWN_TIP, "g"),
        tip=mm(tip, ".3f"),
    )
    name, source = Text("Gap at insertion by the text of Finotti 2013"), Text("Finotti 2013, 4.1")
    return (Erratum("gears.insertion_gap", name, DRAWN_GAP * 1e3, "mm", source, why),)


def forces_notes(gears: GearsInputs, result: ForcesResult, turns: Mapping[str, Number]) -> tuple[Text, ...]:
    if not gears.helix_angle:
        return ()
    notes = []
    if all(w.hand is None for w in gears.wheels):
        notes.append(
            Text(
                "Hands of the helix: not given; chosen: {driver} right-handed, the others in turn.",
                driver=gears.meshes[0].driver,
            )
        )
    last = gears.meshes[-1].driven
    wheel = result.wheels[last]
    assert wheel.thrust is not None
    if wheel.thrust:
        where = Text("the flywheel") if wheel.thrust > 0 else Text("the front")
        sense = Text("as") if turns[last] > 0 else Text("against")
        notes.append(
            Text(
                "{last}, {hand}-handed and turning {sense} the crank, is pushed {thrust} N towards {where} (the crank "
                "turning clockwise seen "
                "from its front end): its shaft must be held there, and the other way where the torque reverses.",
                last=last,
                hand=HANDS[wheel.hand],
                sense=sense,
                thrust=Amount(abs(wheel.thrust)),
                where=where,
            )
        )
    return tuple(notes)
