# SPDX-License-Identifier: Apache-2.0
"""The workshop drawings: the shaft seen along its axis and cut, its sheet, and the sheets of the wheels.

End view and section look from front to rear, where a crank that turns as engines do turns clockwise."""

import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from ..sheet.quantity import dotted
from ..sheet.text import COMMA, Text
from ..sheet.units import Metre, Radian
from . import annotations, sheet_data
from .annotations import COLUMNS, TITLE, Leaf, Say, SheetTable, degrees, millimetres, number, rounded
from .drawing import CENTRE, EDGE, VISIBLE, Point
from .shaft_outline import FLAT, upwards
from .sheet_data import PART_DRAWING, TurnedPiece
from .side_view import OVER, SideView
from .workshop_sheet import DrawnPart, Release, WorkshopSheet, composed, tables

if TYPE_CHECKING:
    from ..countershaft.outline import Piece
    from ..countershaft.result import CountershaftResult
    from ..gears.result import WheelResult
    from ..solve import Results

CHORD = math.radians(2.0)  # of what is hatched
OVER_OUTLINE = 3.0
ASIDE = math.radians(40.0)  # of a radius from the middle of its sector
WIDEST = math.radians(100.0)  # half of a sector that leaves room for its radii beside it
BEHIND = 2.0  # from the end of an axis to the label of a radius
OUT = 8.0  # from a sector to its angle's arc
TURN = 2 * math.pi


def on_sheet(angle: Radian, up: Radian) -> Radian:
    """A direction of the shaft, counted as the crank turns, as an angle of the sheet."""
    return math.pi / 2 - (angle - up)


def kinds(pieces: list[TurnedPiece]) -> dict[str, TurnedPiece]:
    """The sectors that differ, each by the letter of its section."""
    sections: dict[tuple[float, ...], TurnedPiece] = {}
    for turned_piece in pieces:
        piece = turned_piece.piece
        if piece.half_angle is not None:
            way = math.cos(piece.angle), math.sin(piece.angle)
            size = (piece.outer_radius, piece.core_radius, piece.half_angle, *way)
            sections.setdefault(tuple(round(x, 6) for x in size), turned_piece)
    return dict(zip("ABCDEFGHJKLMNPQRSTUVWXYZ", sections.values()))


def section(letter: str, piece: "Piece", up: Radian, scale: float, say: Say, bore: Metre = 0.0) -> Leaf:
    """A sector on its core, cut: hatched, with its radii and its angle; `bore`: radius of a bore along the shaft."""
    assert piece.half_angle is not None
    leaf, by, half = Leaf(), scale * 1e3, piece.half_angle
    R, r, middle = by * piece.outer_radius, by * piece.core_radius, on_sheet(piece.angle, up)
    outer, core = (say(Text("R{size}", size=millimetres(size))) for size in (piece.outer_radius, piece.core_radius))
    first, last = middle - half, middle + half
    hollow = [_arc(by * bore, 0.0, TURN)] if bore else []
    if math.pi - half < FLAT:
        leaf.hatch(_arc(R, 0.0, TURN), *hollow)
        leaf.arc(VISIBLE, (0.0, 0.0), R)
        annotations.radius(leaf, (0.0, 0.0), R, math.pi / 4, outer, R + OUT)
    else:
        leaf.hatch(_arc(R, first, last) + (_arc(r, last, first + TURN) if r else [(0.0, 0.0)]), *hollow)
        leaf.arc(VISIBLE, (0.0, 0.0), R, first, last)
        leaf.arc(VISIBLE, (0.0, 0.0), r, last, first + TURN)
        for side in (first, last):
            leaf.line(VISIBLE, _polar(r, side), _polar(R, side))
        _sized(leaf, R, r, middle, half, (outer, core), say)
    if bore:
        leaf.arc(VISIBLE, (0.0, 0.0), by * bore)
    _cross(leaf, R)
    leaf.words(f"{letter}–{letter}", 0.0, R + OUT + 9.0, "centre", TITLE)
    return leaf


def _sized(leaf: Leaf, R: float, r: float, middle: Radian, half: Radian, labels: tuple[str, str], say: Say) -> None:
    """Both radii and the angle; the radii on the side where the angle's arc is not, so of a wide sector the angle is
    that of its gap."""
    outer, core = labels
    centre, back = (0.0, 0.0), R + OVER_OUTLINE + BEHIND
    if half <= WIDEST:
        annotations.angle(leaf, centre, R, R + OUT, middle - half, middle + half, say(degrees(2 * half)))
        annotations.through(leaf, R, middle - min(ASIDE, half / 2), back, outer)
        if r:
            annotations.radius(leaf, centre, r, middle + math.pi + math.pi / 4, core, back)
    else:
        annotations.angle(leaf, centre, R, R + OUT, middle + half, middle - half + TURN, say(degrees(TURN - 2 * half)))
        annotations.radius(leaf, centre, R, middle - ASIDE, outer, R + OUT)
        if r:
            annotations.through(leaf, r, middle + math.pi + (math.pi - half) / 2, back, core)


def end_view(pieces: list[TurnedPiece], gear: Metre | None, up: Radian, scale: float, bore: Metre = 0.0) -> Leaf:
    """The shaft from its front end: of every piece what no other hides; `bore`: radius of a bore along the shaft."""
    leaf, by = Leaf(), scale * 1e3
    if bore:
        leaf.arc(VISIBLE, (0.0, 0.0), by * bore)
    turns = sorted({round(angle % TURN, 9) for piece in pieces for angle in _ends(piece.piece, up)} | {0.0})
    fields = list(zip(turns, [*turns[1:], TURN]))
    hidden = [0.0] * len(fields)
    for piece in pieces:
        radii = [_radius(piece, (a + b) / 2, up) for a, b in fields]
        if len(set(radii)) == 1 and all(radii[0] > h + FLAT for h in hidden):
            leaf.arc(VISIBLE, (0.0, 0.0), by * radii[0])
        else:
            for (a, b), radius, before in zip(fields, radii, hidden):
                if radius > before + FLAT:
                    leaf.arc(VISIBLE, (0.0, 0.0), by * radius, a, b)
            for n, (a, _) in enumerate(fields):
                low, high = sorted((radii[n - 1], radii[n]))
                low = max(low, hidden[n - 1], hidden[n])
                if high > low + FLAT:
                    leaf.line(VISIBLE, _polar(by * low, a), _polar(by * high, a))
        hidden = [max(h, radius) for h, radius in zip(hidden, radii)]
    if gear is not None and pieces[0].piece.what == "gear":
        leaf.arc(CENTRE, (0.0, 0.0), by * gear / 2)
    _cross(leaf, by * max(hidden))
    return leaf


def _ends(piece: "Piece", up: Radian) -> Iterator[Radian]:
    if piece.half_angle is not None and math.pi - piece.half_angle > FLAT:
        middle = on_sheet(piece.angle, up)
        yield from (middle - piece.half_angle, middle + piece.half_angle)


def _radius(turned_piece: TurnedPiece, at: Radian, up: Radian) -> Metre:
    piece = turned_piece.piece
    if piece.half_angle is None:
        return turned_piece.radius
    aside = abs(math.remainder(at - on_sheet(piece.angle, up), TURN))
    return piece.outer_radius if aside < piece.half_angle else piece.core_radius


def _cross(leaf: Leaf, radius: float) -> None:
    for way in ((1.0, 0.0), (0.0, 1.0)):
        reach = radius + OVER_OUTLINE
        leaf.line(CENTRE, (-reach * way[0], -reach * way[1]), (reach * way[0], reach * way[1]))


def _arc(radius: float, start: Radian, end: Radian) -> list[Point]:
    n = max(2, math.ceil((end - start) / CHORD))
    return [_polar(radius, start + (end - start) * i / n) for i in range(n + 1)]


def _polar(radius: float, angle: Radian) -> Point:
    return radius * math.cos(angle), radius * math.sin(angle)


# --- the sheet of the counter-shaft

MASS_COLUMNS = (32.0, 18.0, 20.0, 20.0, 22.0)
APART = 8.0  # one view from another


def shaft_sheet(
    results: "Results",
    say: Say = str,
    data: Mapping[str, object] | None = None,
    *,
    title: str = "",
    sheet: str = "1/1",
    release: Release | None = None,
) -> WorkshopSheet | None:
    """The drawing of the counter-shaft; None where its outline is not known.  `data`: of the design's file, for what it
    leaves out; `title`: of the part, where that is not that of the step; `sheet`: of how many."""
    solved, shaft = results.shaft, results.design.countershaft
    if solved is None or shaft is None or solved.outline is None:
        return None
    mass = say(Text("{m} kg", m=number(solved.mass, 2))) if solved.mass is not None else ""
    masses = say(Text("Eccentric masses, cylinder 1 at TDC"))
    beside = [
        (say(Text("Balancing")), sheet_data.balance_rows(results, solved, say), COLUMNS),
        (masses, sheet_data.mass_rows(results, solved, say), MASS_COLUMNS),
        *_of_bearings(results, say),
    ]
    if (wheel := sheet_data.shaft_wheel(results)) is not None:
        beside.insert(0, _gear_table(results, wheel, say))
    return composed(
        DrawnPart(
            title=title or say(results.design.title(dotted("countershaft"))),
            material=shaft.material,
            mass=mass,
            sheet=sheet,
            of=results.design.name,
        ),
        lambda scale: _shaft_views(results, solved, scale, say),
        tables(beside),
        sheet_data.notes(results, solved, upwards(solved.outline), data),
        results.design.control,
        say,
        PART_DRAWING,
        release,
    )


def _of_bearings(results: "Results", say: Say) -> Iterator[SheetTable]:
    """What each kind says of those of its bearings that are solved."""
    outcome, inputs = results.outcomes.get(dotted("bearings")), results.design.bearings
    known: Mapping[str, Any] = getattr(outcome.result, "bearings", {}) if outcome is not None else {}
    if inputs is None:
        return
    solved = [row for row in results.design.rows if row.name in known]
    for one in {row.kind: row for row in solved}.values():
        alike = {row.name: known[row.name] for row in solved if row.kind == one.kind}
        yield from results.kind_of(one).on_drawing(alike, inputs, say)


def _gear_table(results: "Results", wheel: "WheelResult", say: Say) -> SheetTable:
    return say(Text("Gear data: {name}", name=wheel.name)), sheet_data.gear_rows(results, wheel, say), COLUMNS


def _shaft_views(results: "Results", solved: "CountershaftResult", scale: float, say: Say) -> Leaf:
    """The side view with the end view to its right, and the sections in rows below them."""
    assert solved.outline is not None and results.design.countershaft is not None
    up, pieces, wheel = upwards(solved.outline), sheet_data.turned(results, solved), sheet_data.shaft_wheel(results)
    gear = wheel.reference_diameter if wheel is not None else None
    cut, bore = kinds(pieces), solved.outline.bore
    views = Leaf()
    side = SideView(pieces, results.design.countershaft.bearing_positions, up, scale, say, bore)
    views.add(side.draw({letter: (piece.start + piece.end) / 2 for letter, piece in cut.items()}, gear))
    end = end_view(pieces, gear, up, scale, bore)
    views.add(end, side.right + APART + OVER - end.extent[0], 0.0)
    left, y, right, _ = views.extent
    x, lowest = left, y
    for letter, piece in cut.items():
        leaf = section(letter, piece.piece, up, scale, say, bore)
        box = leaf.extent
        under = scale * 1e3 * (piece.start + piece.end) / 2  # its cutting plane, if there is room
        at = min(max(x - box[0], under), max(right - box[2], x - box[0]))
        if at + box[2] > right + APART and x > left:
            x, y = left, lowest
            at = x - box[0]
        views.add(leaf, at, y - APART - box[3])
        x, lowest = at + box[2] + APART, min(lowest, y - APART - box[3] + box[1])
    return views


# --- the sheets of the wheels of a train, as ISO 2203 draws gears
# Cut along the axis, the teeth not cut, and seen from the front.

OVER_WHEEL = 4.0  # an axis beyond what it is the axis of
LINE, NEXT = 10.0, 9.0  # from the view to its first dimension, and on to the next
WHEEL_VIEWS_APART = 14.0


def wheel_sheets(
    results: "Results",
    say: Say = str,
    data: Mapping[str, object] | None = None,
    release: Release | None = None,
) -> list[WorkshopSheet]:
    """A sheet for each wheel; none where the train is not solved."""
    train, gears = results.train, results.design.gears
    if train is None or gears is None:
        return []
    bores = {wheel_inputs.name: wheel_inputs.bore_diameter for wheel_inputs in gears.wheels}
    sheets = []
    for n, wheel in enumerate(train.wheels.values(), 1):
        title, sheet, bore = say(Text("Gear {name}", name=wheel.name)), f"{n}/{len(train.wheels)}", bores[wheel.name]
        part = DrawnPart(title=title, material=wheel.material, sheet=sheet, of=results.design.name)
        views = partial(_wheel_views, wheel, bore, say)
        beside, control = tables([_gear_table(results, wheel, say)]), results.design.control
        sheets.append(composed(part, views, beside, _notes(bore, data), control, say, PART_DRAWING, release))
    return sheets


def _wheel_views(wheel: "WheelResult", bore: Metre | None, say: Say, scale: float) -> Leaf:
    """The section to the left, its dimensions around it, the front view to the right."""
    leaf, by = Leaf(), scale * 1e3
    diameters = wheel.tip_diameter, wheel.root_diameter, wheel.reference_diameter, bore or 0.0
    b, (tip, root, pitch, inner) = by * wheel.face_width, (by * diameter / 2 for diameter in diameters)
    leaf.box(VISIBLE, 0.0, -tip, b, tip)
    for sign in (1.0, -1.0):
        leaf.line(VISIBLE, (0.0, sign * root), (b, sign * root))
        leaf.line(CENTRE, (-OVER_WHEEL / 2, sign * pitch), (b + OVER_WHEEL / 2, sign * pitch))
        if inner:
            leaf.line(VISIBLE, (0.0, sign * inner), (b, sign * inner))
            leaf.hatch([(0.0, sign * inner), (b, sign * inner), (b, sign * root), (0.0, sign * root)])
    if not inner:
        leaf.hatch([(0.0, -root), (b, -root), (b, root), (0.0, root)])
    leaf.line(CENTRE, (-OVER_WHEEL, 0.0), (b + OVER_WHEEL, 0.0))
    leaf.dimension((0.0, -tip), (b, -tip), -tip - LINE, say(Text("{size}", size=rounded(wheel.face_width))))
    if bore is not None:
        label = say(Text("⌀{diameter}", diameter=millimetres(bore)))
        leaf.dimension((0.0, -inner), (0.0, inner), -LINE, label, upright=True)
    leaf.dimension((0.0, -tip), (0.0, tip), -LINE - NEXT * bool(inner), say(sheet_data.tips(wheel)), upright=True)
    x = b + WHEEL_VIEWS_APART + tip
    for radius, layer in ((tip, VISIBLE), (pitch, CENTRE), (root, EDGE), (inner, VISIBLE)):
        if radius:
            leaf.arc(layer, (x, 0.0), radius)
    leaf.line(CENTRE, (x - tip - OVER_WHEEL, 0.0), (x + tip + OVER_WHEEL, 0.0))
    leaf.line(CENTRE, (x, -tip - OVER_WHEEL), (x, tip + OVER_WHEEL))
    return leaf


def _notes(bore: Metre | None, data: Mapping[str, object] | None) -> Iterator[Text]:
    yield Text("Dimensions in mm. Teeth by the table; the diameter of the tips as drawn.")
    yield from sheet_data.chosen(data, "gears")
    lacking = [Text("bore and hub") if bore is None else Text("fit of the bore, hub"), Text("heat treatment")]
    lacking += [Text("general and geometrical tolerances"), Text("roughness elsewhere"), Text("chamfers")]
    yield Text("Not given by the design: {what}.", what=COMMA.join(lacking))
