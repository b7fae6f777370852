# SPDX-License-Identifier: Apache-2.0
"""What is drawn of a shaft, as lines, arcs, words and dimensions on a sheet: the same for a drawing file, the report and the screen.

The sheet's first axis runs to the right, its second up, both in metres.  In the side view the first is z and the second the direction
of the first eccentric sector; in a cross-section, "up" is that direction too and the crank turns clockwise.
"""

import math
from itertools import pairwise

import numpy as np

from ..sheet.drawing import Arc, Dimension, Point, Polyline, Primitive, Words
from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Text
from ..sheet.units import UNITS, Metre, Radian
from .outline import TOUCH, Outline, Piece

LAYERS = ("OUTLINE", "SECTORS", "JOURNALS", "GEAR", "AXIS", "SUPPORTS", "DIMENSIONS", "TEXT")
LAYER_OF = {"sector": "SECTORS", "journal": "JOURNALS", "gear": "GEAR"}  # what a piece is → where its own shape stands
LETTER = 0.01  # rule of this program: letters are a hundredth of the shaft's length high, and all distances multiples of that
FINE = 5e-5  # m: a shorter piece is what rounding leaves between two others; it is not drawn, and they meet
FLAT = 1e-9  # rad and shares of a radius: below it an edge is seen from its end


# --- shapes -------------------------------------------------------------------------------------------------------------
def drawn(outline: Outline) -> list[Piece]:
    """The pieces that a drawing shows: each ends where the next begins."""
    return [piece for piece in outline.pieces if piece.length > FINE]


def upwards(outline: Outline) -> Radian:
    """The direction that is drawn up: that of the first sector, 0 for a shaft without one."""
    return next((piece.angle for piece in outline.pieces if piece.half_angle is not None), 0.0)


def reach(piece: Piece, up: Radian) -> tuple[Metre, Metre]:
    """How far a piece reaches above and below the axis, both counted positive: its silhouette seen across the axis."""
    if piece.half_angle is None:
        return piece.outer_radius, piece.outer_radius
    R, r_0, aside = piece.outer_radius, piece.core_radius, piece.angle - up
    return max(r_0, R * _highest(aside, piece.half_angle)), max(r_0, R * _highest(aside + math.pi, piece.half_angle))


def _highest(middle: Radian, half: Radian) -> float:
    """The largest cosine between middle − half and middle + half."""
    aside = abs(math.remainder(middle, 2 * math.pi))
    return 1.0 if aside <= half + FLAT else math.cos(aside - half)


def silhouette(outline: Outline) -> tuple[Point, ...]:
    """The shaft seen across its axis, as one closed polyline: above from front to rear, below back again."""
    up = upwards(outline)
    pieces = drawn(outline)
    ends = [piece.start for piece in pieces] + [outline.end]
    above: list[Point] = []
    below: list[Point] = []
    for piece, (start, end) in zip(pieces, pairwise(ends)):
        high, low = reach(piece, up)
        above += [(start, high), (end, high)]
        below += [(start, -low), (end, -low)]
    path = above + below[::-1]
    return tuple(point for point, before in zip(path, [path[-1], *path]) if point != before)


def support_marks(outline: Outline, positions: tuple[Metre, ...]) -> tuple[tuple[Point, ...], ...]:
    """A triangle under the shaft for each support, its tip in the support's mid-plane."""
    up, size = upwards(outline), 2 * LETTER * (outline.end - outline.start)
    marks = []
    for z in positions:
        low = max((reach(p, up)[1] for p in outline.pieces if p.start - TOUCH <= z <= p.end + TOUCH), default=0.0)
        marks.append(((z, -low), (z + size / 2, -low - size), (z - size / 2, -low - size)))
    return tuple(marks)


def axis(outline: Outline) -> tuple[Point, Point]:
    """The axis, a little longer than the shaft."""
    beyond = 2 * LETTER * (outline.end - outline.start)
    return (outline.start - beyond, 0.0), (outline.end + beyond, 0.0)


def _edges(piece: Piece, up: Radian) -> list[tuple[Point, Point]]:
    """The edges of a sector that are seen inside its silhouette: those of its two flat faces with its outside and with its core."""
    if piece.half_angle is None or math.pi - piece.half_angle < FLAT:
        return []
    edges = []
    high, low = reach(piece, up)
    for side in (1.0, -1.0):
        angle = piece.angle - up + side * piece.half_angle
        near, faces = math.sin(angle) > FLAT, side * math.cos(angle) > FLAT  # on the side of who looks; turned towards them
        for radius, seen in ((piece.outer_radius, near), (piece.core_radius, near and faces)):
            y = radius * math.cos(angle)
            if seen and radius and -low + TOUCH < y < high - TOUCH:
                edges.append(((piece.start, y), (piece.end, y)))
    return edges


def _section(piece: Piece, up: Radian, centre: Point) -> list[Primitive]:
    """The cross-section of a sector on its core: what is cut, as lines and arcs that close."""
    assert piece.half_angle is not None
    R, r_0, gamma = piece.outer_radius, piece.core_radius, piece.half_angle
    if math.pi - gamma < FLAT:
        return [Arc("SECTORS", centre, R, 0.0, 2 * math.pi)]
    middle = math.pi / 2 - (piece.angle - up)  # clockwise from up, as angles of the sheet
    first, last = middle - gamma, middle + gamma
    shapes: list[Primitive] = [Arc("SECTORS", centre, R, first, last)]
    for angle in (first, last):
        shapes.append(Polyline("SECTORS", (_round(centre, r_0, angle), _round(centre, R, angle))))
    return [*shapes, Arc("SECTORS", centre, r_0, last, first + 2 * math.pi)] if r_0 else shapes


def _round(centre: Point, radius: Metre, angle: Radian) -> Point:
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


# --- the sheet ----------------------------------------------------------------------------------------------------------
def shaft_drawing(outline: Outline, positions: tuple[Metre, ...], title: str, scale: str = "1:1") -> tuple[Primitive, ...]:
    """Side view, cross-sections of the sectors below it, dimensions and title.  `positions`: mid-planes of the supports.

    The layer OUTLINE holds the silhouette of the whole shaft, the others the shapes of their pieces again, so that each is whole by itself.
    """
    up, h = upwards(outline), LETTER * (outline.end - outline.start)
    largest = max(max(reach(piece, up)) for piece in outline.pieces)
    shapes: list[Primitive] = [Polyline("OUTLINE", silhouette(outline), True), Polyline("AXIS", axis(outline))]
    for piece in outline.pieces:
        if (layer := LAYER_OF.get(piece.what)) is not None:
            high, low = reach(piece, up)
            shapes.append(Polyline(layer, ((piece.start, -low), (piece.end, -low), (piece.end, high), (piece.start, high)), True))
            shapes += [Polyline(layer, edge) for edge in _edges(piece, up)]
    shapes += [Polyline("SUPPORTS", mark, True) for mark in support_marks(outline, positions)]
    shapes += _lengths(outline, positions, largest, h)
    shapes += _diameters(outline, h)
    shapes += _sections(outline, up, largest, h)
    return (*shapes, *_title(outline, up, largest, h, title, scale))


def _lengths(outline: Outline, positions: tuple[Metre, ...], largest: Metre, h: Metre) -> list[Primitive]:
    """Three rows below the side view: every piece, the spans of the supports, the whole shaft."""
    ends = [piece.start for piece in drawn(outline)] + [outline.end]
    rows = (tuple(ends), positions, (outline.start, outline.end))
    return [
        Dimension("DIMENSIONS", (start, -largest), (end, -largest), (start, -largest - (6 + 4 * row) * h), h)
        for row, places in enumerate(rows)
        if row < 2 or len(ends) > 2
        for start, end in pairwise(places)
    ]


def _diameters(outline: Outline, h: Metre) -> list[Primitive]:
    """One dimension for each kind and size of a full piece, across the longest of them, beside its middle where a support may stand."""
    shapes: list[Primitive] = []
    told = set()
    for piece in sorted(outline.pieces, key=lambda piece: -piece.length):
        size = (piece.what, round(piece.outer_radius, 9))
        if piece.half_angle is None and size not in told:
            told.add(size)
            z, R = piece.start + 0.7 * piece.length, piece.outer_radius
            shapes.append(Dimension("DIMENSIONS", (z, -R), (z, R), (z, 0.0), h, upright=True, diameter=True, shift=R / 2))
    return shapes


def _sections(outline: Outline, up: Radian, largest: Metre, h: Metre) -> list[Primitive]:
    """A cross-section for each kind of sector, with its letter."""
    shapes: list[Primitive] = []
    letters: dict[tuple[float, ...], str] = {}
    for piece in outline.pieces:
        if piece.half_angle is None:
            continue
        aside = piece.angle - up
        kind = tuple(round(x, 9) for x in (piece.outer_radius, piece.core_radius, piece.half_angle, math.cos(aside), math.sin(aside)))
        letter = letters.get(kind)
        if letter is None:
            letter = letters[kind] = chr(ord("A") + len(letters)) if len(letters) < 26 else f"A{len(letters) - 25}"
            x, y = _place(len(letters) - 1, outline, largest, h)
            reaches = largest + 2 * h
            shapes += [Polyline("AXIS", ((x - reaches, y), (x + reaches, y))), Polyline("AXIS", ((x, y - reaches), (x, y + reaches)))]
            shapes += _section(piece, up, (x, y))
            lines = (
                Text("Section {letter}", letter=letter), Text("R {mm}, core {mm2}", mm=_mm(piece.outer_radius), mm2=_mm(piece.core_radius)),
                Text("half-angle {degrees}°", degrees=_degrees(piece.half_angle)),
                Text("middle at {degrees}°", degrees=_degrees(piece.angle % (2 * math.pi))),
            )  # fmt: skip
            shapes += [Words("TEXT", (x + reaches + h, y + (2 - 1.7 * i) * h), line, h) for i, line in enumerate(lines)]
        shapes.append(Words("TEXT", ((piece.start + piece.end) / 2, largest + 2 * h), letter, h))
    return shapes


def _place(n: int, outline: Outline, largest: Metre, h: Metre) -> Point:
    """The centre of a cross-section: below the rows of dimensions, as many side by side as the shaft is long."""
    wide, high = 2 * largest + 24 * h, 2 * largest + 8 * h
    row, column = divmod(n, max(1, int((outline.end - outline.start) / wide)))
    return outline.start + largest + 2 * h + column * wide, -2 * largest - 20 * h - row * high


def _title(outline: Outline, up: Radian, largest: Metre, h: Metre, title: str, scale: str) -> list[Primitive]:
    degrees = _degrees(up % (2 * math.pi))
    lines = [
        Text("Millimetres, {scale}. z from mid-shaft, to the right towards the flywheel.", scale=scale),
        Text("Drawn up: {degrees}° from up with cylinder 1 at TDC, in the sense of crank rotation. In the sections the "
            "crank turns clockwise.", degrees=degrees),
    ]  # fmt: skip
    if outline.derived:
        lines.append(Text("Put together from masses, core, journals and gear (reference circle); fillets, holes and extras are left out."))
    top = largest + (8 + 1.8 * len(lines)) * h
    small = [Words("TEXT", (outline.start, top - 1.8 * (i + 1) * h), line, h) for i, line in enumerate(lines)]
    return [Words("TEXT", (outline.start, top), title, 1.6 * h), *small]


def _mm(length: Metre) -> str:
    return f"{length * 1e3:.2f}".rstrip("0").rstrip(".")


def _degrees(angle: Radian) -> str:
    return f"{math.degrees(angle):.2f}".rstrip("0").rstrip(".")


# --- the screen's and the report's ---------------------------------------------------------------------------------------
def outline_curve(outline: Outline, positions: tuple[Metre, ...]) -> Curve:
    """The side view as a curve in true scale: the points of the drawing, in mm."""
    names = (Text("front support"), *(Text("support {n}", n=n) for n in range(2, len(positions))), Text("rear support"))
    series = [_series(Text("outline"), (*silhouette(outline), silhouette(outline)[0])), _series(Text("axis"), axis(outline))]
    series += [_series(name, (*mark, mark[0])) for name, mark in zip(names, support_marks(outline, positions))]
    return Curve("outline", Text("Outline of the shaft"), axis_label("z", "mm"), axis_label("up: first eccentric mass", "mm"),
        tuple(series), equal=True)  # fmt: skip


def _series(label: Text, points: tuple[Point, ...]) -> Series:
    shown = UNITS["mm"].shown
    return Series(label, np.array([shown(x) for x, _ in points]), np.array([shown(y) for _, y in points]))
