# SPDX-License-Identifier: Apache-2.0
"""The workshop drawing of a shaft: seen from the side and cut, and its sheet.

The sections look from front to rear, where a crank that turns as engines do turns clockwise."""

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from ..sheet.quantity import dotted
from ..sheet.text import Text
from ..sheet.units import Metre, Radian
from . import annotations, sheet_data, sizes
from .annotations import COLUMNS, TITLE, Leaf, SheetTable
from .drawing import CENTRE, HIDDEN_EDGE, VISIBLE, Inscription, Point
from .gear_data import gear_table
from .shaft_outline import FLAT, upwards
from .sheet_data import PART_DRAWING
from .side_view import SideView
from .sizes import Say, Size, number
from .turned import TurnedPiece, shaft_wheel, turned
from .workshop_sheet import DrawnPart, Release, WorkshopSheet, composed

if TYPE_CHECKING:
    from ..countershaft.outline import Piece
    from ..countershaft.result import CountershaftResult
    from ..solve import Results

CHORD = math.radians(2.0)  # of what is hatched
OVER_OUTLINE = 3.0
ASIDE = math.radians(40.0)  # of a radius from the middle of its sector
WIDEST = math.radians(100.0)  # half of a sector that leaves room for its radii beside it
BEHIND = 2.0  # from the end of an axis to the label of a radius
OUT = 8.0  # from a sector to its angle's arc
HOLE_ASIDE = math.radians(20.0)  # of the label of a hole from the middle of its sector
BEYOND_ARC = 8.0  # from the angle's arc to that label
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


def section(
    letter: str,
    piece: "Piece",
    up: Radian,
    scale: float,
    say: Say,
    bore: Metre = 0.0,
    hole: tuple[Size, Metre] | None = None,
) -> Leaf:
    """A sector on its core, cut: hatched, with its radii and its angle; `bore`: radius of a bore along the shaft;
    `hole`: of the holes that calibrate it, how deep they may be."""
    assert piece.half_angle is not None
    leaf, by, half = Leaf(), scale * 1e3, piece.half_angle
    R, r, middle = by * piece.outer_radius, by * piece.core_radius, on_sheet(piece.angle, up)
    outer, core = (sizes.radius(size).inscribed(say) for size in (piece.outer_radius, piece.core_radius))
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
    if hole is not None:
        _hole(leaf, R, middle, by, *hole, say)
    _cross(leaf, R)
    leaf.words(f"{letter}–{letter}", 0.0, R + OUT + 9.0, "centre", TITLE)
    return leaf


def _sized(
    leaf: Leaf, R: float, r: float, middle: Radian, half: Radian, labels: tuple[Inscription, Inscription], say: Say
) -> None:
    """Both radii and the angle; the radii on the side where the angle's arc is not, so of a wide sector the angle is
    that of its gap."""
    outer, core = labels
    centre, back = (0.0, 0.0), R + OVER_OUTLINE + BEHIND
    if half <= WIDEST:
        annotations.angle(leaf, centre, R, R + OUT, middle - half, middle + half, sizes.angle(2 * half).inscribed(say))
        annotations.through(leaf, R, middle - min(ASIDE, half / 2), back, outer)
        if r:
            annotations.radius(leaf, centre, r, middle + math.pi + math.pi / 4, core, back)
    else:
        annotations.angle(
            leaf, centre, R, R + OUT, middle + half, middle - half + TURN, sizes.angle(TURN - 2 * half).inscribed(say)
        )
        annotations.radius(leaf, centre, R, middle - ASIDE, outer, R + OUT)
        if r:
            annotations.through(leaf, r, middle + math.pi + (math.pi - half) / 2, back, core)


def _hole(leaf: Leaf, R: float, middle: Radian, by: float, size: Size, depth: Metre, say: Say) -> None:
    """A hole from outside towards the axis, whose diameter stands on a shelf beyond the angle's arc."""
    half, deep = by * size.value / 2, by * depth
    along, across = (math.cos(middle), math.sin(middle)), (-math.sin(middle), math.cos(middle))

    def at(out: float, aside: float) -> Point:
        return out * along[0] + aside * across[0], out * along[1] + aside * across[1]

    top = math.sqrt(R * R - half * half)
    leaf.line(HIDDEN_EDGE, at(top, half), at(R - deep, half), at(R - deep, -half), at(top, -half))
    leaf.line(CENTRE, at(R + OVER_OUTLINE, 0.0), at(R - deep - OVER_OUTLINE, 0.0))
    walls = at(R - deep / 2, half), at(R - deep / 2, -half)
    words = size.inscribed(say)
    end = _polar(R + OUT + BEYOND_ARC, middle + HOLE_ASIDE)
    picture = annotations.leader(
        walls[0], math.atan2(walls[0][1] - end[1], walls[0][0] - end[0]), end, end[0] >= 0, words
    )
    leaf.measure("length", (*walls, walls[0]), picture, words, middle - math.pi / 2)


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
    if (wheel := shaft_wheel(results)) is not None:
        beside.insert(0, gear_table(results, wheel, say))
    return composed(
        DrawnPart(
            title=title or say(results.design.title(dotted("countershaft"))),
            material=shaft.material,
            mass=mass,
            sheet=sheet,
            of=results.design.name,
        ),
        lambda scale: _shaft_views(results, solved, scale, say),
        beside,
        sheet_data.notes(results, solved, turned(results, solved), upwards(solved.outline), data),
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


def _shaft_views(results: "Results", solved: "CountershaftResult", scale: float, say: Say) -> Leaf:
    """The side view, and the sections in rows below it."""
    assert solved.outline is not None and results.design.countershaft is not None
    up, pieces, wheel = upwards(solved.outline), turned(results, solved), shaft_wheel(results)
    gear = wheel.reference_diameter if wheel is not None else None
    cut, bore, hole = kinds(pieces), solved.outline.bore, _holes(results, solved)
    side = SideView(pieces, results.design.countershaft.bearing_positions, up, scale, say, bore)
    views = side.draw({letter: (piece.start + piece.end) / 2 for letter, piece in cut.items()}, gear)
    left, y, right, _ = views.extent
    x, lowest = left, y
    for letter, piece in cut.items():
        leaf = section(letter, piece.piece, up, scale, say, bore, hole)
        box = leaf.extent
        under = scale * 1e3 * (piece.start + piece.end) / 2  # its cutting plane, if there is room
        at = min(max(x - box[0], under), max(right - box[2], x - box[0]))
        if at + box[2] > right + APART and x > left:
            x, y = left, lowest
            at = x - box[0]
        views.add(leaf, at, y - APART - box[3])
        x, lowest = at + box[2] + APART, min(lowest, y - APART - box[3] + box[1])
    return views


def _holes(results: "Results", solved: "CountershaftResult") -> tuple[Size, Metre] | None:
    """How many calibration holes of which diameter each mass has, and how deep they may be; None where there are none,
    or it is not known which sectors are the masses."""
    shaft = results.design.countershaft
    if shaft is None or shaft.holes is None or solved.outline is None or not solved.outline.derived:
        return None
    holes, masses = shaft.holes, len(solved.sector or shaft.masses)
    each = f"{holes.count // masses}× " if masses and holes.count % masses == 0 else ""
    return Size(holes.diameter, f"{each}⌀"), holes.depth
