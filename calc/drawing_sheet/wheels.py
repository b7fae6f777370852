# SPDX-License-Identifier: Apache-2.0
"""The sheets of the wheels of a train, as ISO 2203 draws gears: cut along the axis, the teeth not cut, and seen from the front."""

from collections.abc import Iterator, Mapping

from ..gears.result import TrainResult, WheelResult
from ..sheet.layers import CENTRE, EDGE, VISIBLE
from ..sheet.text import COMMA, Text
from ..sheet.units import Metre
from ..solve import Results
from ..draw.sheet_data import PART_DRAWING, chosen, gear_rows
from .facts import tips
from ..draw.annotations import Leaf
from .saying import Say, millimetres, rounded
from .sheet import COLUMNS, Part, Sheet, composed, tables

OVER = 4.0  # an axis beyond what it is the axis of
LINE, NEXT = 10.0, 9.0  # from the view to its first dimension, and on to the next
APART = 14.0


def wheel_sheets(results: Results, say: Say = str, data: Mapping[str, object] | None = None) -> list[Sheet]:
    """A sheet for each wheel; none where the train is not solved."""
    train, gears = results.result(TrainResult), results.design.gears
    if train is None or gears is None:
        return []
    bores = {one.name: one.bore_diameter for one in gears.wheels}
    return [
        composed(
            Part(title=f"{results.design.name}: {wheel.name}", material=wheel.material, sheet=f"{n}/{len(train.wheels)}"),
            lambda scale, wheel=wheel: _views(wheel, bores[wheel.name], scale, say),  # type: ignore[misc]
            tables([(say(Text("Gear data: {name}", name=wheel.name)), gear_rows(results, wheel, say), COLUMNS)]),
            _notes(bores[wheel.name], data), results.design.control, say, PART_DRAWING,
        )
        for n, wheel in enumerate(train.wheels.values(), 1)
    ]  # fmt: skip


def _views(wheel: WheelResult, bore: Metre | None, scale: float, say: Say) -> Leaf:
    """The section to the left, its dimensions around it, the front view to the right."""
    leaf, by = Leaf(), scale * 1e3
    b, tip, root, pitch = (
        by * wheel.face_width,
        by * wheel.tip_diameter / 2,
        by * wheel.root_diameter / 2,
        by * wheel.reference_diameter / 2,
    )
    inner = by * bore / 2 if bore is not None else 0.0
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
    leaf.dimension((0.0, -tip), (b, -tip), -tip - LINE, say(Text("{size}", size=rounded(wheel.face_width))))
    if bore is not None:
        leaf.dimension((0.0, -inner), (0.0, inner), -LINE, say(Text("⌀{diameter}", diameter=millimetres(bore))), upright=True)
    leaf.dimension((0.0, -tip), (0.0, tip), -LINE - NEXT * bool(inner), say(tips(wheel)), upright=True)
    x = b + APART + tip
    for radius, layer in ((tip, VISIBLE), (pitch, CENTRE), (root, EDGE), (inner, VISIBLE)):
        if radius:
            leaf.arc(layer, (x, 0.0), radius)
    leaf.line(CENTRE, (x - tip - OVER, 0.0), (x + tip + OVER, 0.0))
    leaf.line(CENTRE, (x, -tip - OVER), (x, tip + OVER))
    return leaf


def _notes(bore: Metre | None, data: Mapping[str, object] | None) -> Iterator[Text]:
    yield Text("Dimensions in mm. Teeth by the table; the diameter of the tips as drawn.")
    yield from chosen(data, "gears")
    lacking = [Text("bore and hub") if bore is None else Text("fit of the bore, hub")]
    lacking += [Text("heat treatment"), Text("general and geometrical tolerances"), Text("roughness elsewhere"), Text("chamfers")]
    yield Text("Not given by the design: {what}.", what=COMMA.join(lacking))
