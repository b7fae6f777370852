# SPDX-License-Identifier: Apache-2.0
"""The sheets of the wheels of a train, as ISO 2203 draws gears: cut along the axis, the teeth not cut, and seen from
the front."""

import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING

from ..sheet.text import COMMA, Text
from ..sheet.units import Metre
from . import defaults, sizes
from .annotations import Leaf
from .drawing import CENTRE, DIMENSION, EDGE, VISIBLE
from .gear_data import gear_table, tooth_notes
from .indications import OnShelf, Zone, datum, frame, shelf
from .sheet_data import PART_DRAWING, chosen
from .sizes import Say
from .turned import in_field, tips
from .workshop_sheet import DrawnPart, Release, WorkshopSheet, composed

if TYPE_CHECKING:
    from ..gears.result import WheelResult
    from ..solve import Results

OVER = 4.0  # an axis beyond what it is the axis of
LINE, NEXT = 10.0, 9.0  # from the view to its first dimension, and on to the next
ABOVE = 6.0  # from the view to its frames
APART = 14.0  # one view from the other
HUB = "A"  # the axis of the bore


def wheel_sheets(
    results: "Results",
    say: Say = str,
    data: Mapping[str, object] | None = None,
    release: Release | None = None,
) -> dict[str, WorkshopSheet]:
    """A sheet for each wheel, by its name; none where the train is not solved."""
    train, gears = results.train, results.design.gears
    if train is None or gears is None:
        return {}
    bores = {wheel_inputs.name: wheel_inputs.bore_diameter for wheel_inputs in gears.wheels}
    sheets = {}
    for n, wheel in enumerate(train.wheels.values(), 1):
        title, sheet, bore = say(Text("Gear {name}", name=wheel.name)), f"{n}/{len(train.wheels)}", bores[wheel.name]
        mass = "" if wheel.mass is None else say(Text("{m} kg", m=sizes.number(wheel.mass, 2)))
        part = DrawnPart(title=title, material=wheel.material, mass=mass, sheet=sheet, of=results.design.name)
        beside, notes = [gear_table(results, wheel, say)], _notes(wheel, bore, data)
        views, control = partial(_views, wheel, bore, say), results.design.control
        sheets[wheel.name] = composed(part, views, beside, notes, control, say, PART_DRAWING, release)
    return sheets


def _views(wheel: "WheelResult", bore: Metre | None, say: Say, scale: float) -> Leaf:
    """The section to the left, its dimensions around it, the front view to the right."""
    leaf, by = Leaf(), scale * 1e3
    diameters = wheel.tip_diameter, wheel.root_diameter, wheel.reference_diameter, bore or 0.0
    b, (tip, root, pitch, inner) = by * wheel.face_width, (by * diameter / 2 for diameter in diameters)
    leaf.box(VISIBLE, 0.0, -tip, b, tip)
    for sign in (1.0, -1.0):
        leaf.line(VISIBLE, (0.0, sign * root), (b, sign * root))
        leaf.line(CENTRE, (-OVER / 2, sign * pitch), (b + OVER / 2, sign * pitch))
        if inner:
            leaf.line(VISIBLE, (0.0, sign * inner), (b, sign * inner))
            leaf.hatch([(0.0, sign * inner), (b, sign * inner), (b, sign * root), (0.0, sign * root)])
    if not inner:
        leaf.hatch([(0.0, -root), (b, -root), (b, root), (0.0, root)])
    leaf.line(CENTRE, (-OVER, 0.0), (b + OVER, 0.0))
    face = sizes.length(wheel.face_width, defaults.general(wheel.face_width)).inscribed(say)
    leaf.dimension((0.0, -tip), (b, -tip), -tip - LINE, face)
    if bore is not None:
        size = in_field(bore, defaults.BORE_FIELD).inscribed(say)
        leaf.dimension((0.0, -inner), (0.0, inner), -LINE, size, upright=True)
        datum(leaf, HUB, -LINE, inner)
        _frames(leaf, wheel, say, b, tip)
    leaf.dimension((0.0, -tip), (0.0, tip), -LINE - NEXT * bool(inner), tips(wheel).inscribed(say), upright=True)
    x = b + APART + tip
    for radius, layer in ((tip, VISIBLE), (pitch, CENTRE), (root, EDGE), (inner, VISIBLE)):
        if radius:
            leaf.arc(layer, (x, 0.0), radius)
    leaf.line(CENTRE, (x - tip - OVER, 0.0), (x + tip + OVER, 0.0))
    leaf.line(CENTRE, (x, -tip - OVER), (x, tip + OVER))
    return leaf


def _frames(leaf: Leaf, wheel: "WheelResult", say: Say, b: float, tip: float) -> None:
    """How true the tips and a face run about the bore, above the section: to its left, and to its right."""
    of_tips, of_face = (
        OnShelf(frame=(Zone("run-out", say(sizes.alone(sizes.millimetres(wide, 4))), HUB),))
        for wide in (wheel.tolerances.runout, wheel.tolerances.face)
    )
    shelf(leaf, (b / 2, -tip, tip), tip + ABOVE, False, of_tips)
    y = tip + ABOVE + of_face.high / 2
    leaf.line(DIMENSION, (b, tip + 1.0), (b, y + 2.0))
    leaf.line(DIMENSION, (b, y), (b + ABOVE, y))
    leaf.arrow((b, y), math.pi)
    frame(leaf, of_face.frame, b + ABOVE, tip + ABOVE)


def _notes(wheel: "WheelResult", bore: Metre | None, data: Mapping[str, object] | None) -> Iterator[Text]:
    yield Text("Dimensions in mm. Teeth by the table; the diameter of the tips as drawn.")
    yield from tooth_notes(wheel)
    yield defaults.said()
    more = []
    if bore is not None:
        yield Text("Run-out of the tips by that of the teeth, of a face 0.2·F_β·d_a/b (ISO/TR 10064-3).")
        more.append(Text("{field} of the bore", field=str(defaults.BORE_FIELD)))
    if wheel.tip_diameter_min is None:
        more.append(defaults.of_tips())
    yield from chosen(data, "gears", more=more)
    lacking = Text("bore and hub") if bore is None else Text("hub and keyway")
    yield Text("Not given by the design: {what}.", what=COMMA.join([lacking]))
