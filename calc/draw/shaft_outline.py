# SPDX-License-Identifier: Apache-2.0
"""The side view of a shaft: its silhouette, its edges, and where it is carried.

The first axis is z, to the right, the second the direction of the first eccentric sector, up, both in metres.
"""

import math
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Text
from ..sheet.units import UNITS, Metre, Radian
from .drawing import TOUCH, Point, Polyline, Primitive

if TYPE_CHECKING:
    from ..countershaft.outline import Outline, Piece

LAYER_OF = {"sector": "SECTORS", "journal": "JOURNALS", "gear": "GEAR"}  # what a piece is → where its own shape stands
# rule of this program: letters are a hundredth of the shaft's length high, and all distances multiples of that
LETTER = 0.01
FINE = 5e-5  # m: a shorter piece is what rounding leaves between two others; it is not drawn, and they meet
FLAT = 1e-9  # rad and shares of a radius: below it an edge is seen from its end


# --- shapes


def drawn(outline: "Outline") -> "list[Piece]":
    """The pieces that a drawing shows: each ends where the next begins."""
    return [piece for piece in outline.pieces if piece.length > FINE]


def upwards(outline: "Outline") -> Radian:
    """The direction that is drawn up: that of the first sector, 0 for a shaft without one."""
    return next((piece.angle for piece in outline.pieces if piece.half_angle is not None), 0.0)


def reach(piece: "Piece", up: Radian) -> tuple[Metre, Metre]:
    """How far a piece reaches above and below the axis, both counted positive: its silhouette seen across the axis."""
    if piece.half_angle is None:
        return piece.outer_radius, piece.outer_radius
    R, r_0, aside = piece.outer_radius, piece.core_radius, piece.angle - up
    return max(r_0, R * _highest(aside, piece.half_angle)), max(r_0, R * _highest(aside + math.pi, piece.half_angle))


def _highest(middle: Radian, half: Radian) -> float:
    """The largest cosine between middle − half and middle + half."""
    aside = abs(math.remainder(middle, 2 * math.pi))
    return 1.0 if aside <= half + FLAT else math.cos(aside - half)


def silhouette(outline: "Outline") -> tuple[Point, ...]:
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


def support_marks(outline: "Outline", positions: tuple[Metre, ...]) -> tuple[tuple[Point, ...], ...]:
    """A triangle under the shaft for each support, its tip in the support's mid-plane."""
    up, size = upwards(outline), 2 * LETTER * (outline.end - outline.start)
    marks = []
    for z in positions:
        low = max((reach(p, up)[1] for p in outline.pieces if p.start - TOUCH <= z <= p.end + TOUCH), default=0.0)
        marks.append(((z, -low), (z + size / 2, -low - size), (z - size / 2, -low - size)))
    return tuple(marks)


def axis(outline: "Outline") -> tuple[Point, Point]:
    """The axis, a little longer than the shaft."""
    beyond = 2 * LETTER * (outline.end - outline.start)
    return (outline.start - beyond, 0.0), (outline.end + beyond, 0.0)


def bore(outline: "Outline") -> tuple[tuple[Point, Point], ...]:
    """Both edges of a bore along the whole shaft, which are hidden; none of a shaft without."""
    return tuple(((outline.start, y), (outline.end, y)) for y in (outline.bore, -outline.bore) if outline.bore)


def edges(piece: "Piece", up: Radian) -> list[tuple[Point, Point]]:
    """The edges of a sector that are seen inside its silhouette: those of its two flat faces with its outside and with
    its core."""
    if piece.half_angle is None or math.pi - piece.half_angle < FLAT:
        return []
    seen_edges = []
    high, low = reach(piece, up)
    for side in (1.0, -1.0):
        angle = piece.angle - up + side * piece.half_angle
        # on the side of who looks; turned towards them
        near, faces = (math.sin(angle) > FLAT, side * math.cos(angle) > FLAT)
        for radius, seen in ((piece.outer_radius, near), (piece.core_radius, near and faces)):
            y = radius * math.cos(angle)
            if seen and radius and -low + TOUCH < y < high - TOUCH:
                seen_edges.append(((piece.start, y), (piece.end, y)))
    return seen_edges


def shaft_drawing(outline: "Outline", positions: tuple[Metre, ...]) -> tuple[Primitive, ...]:
    """The side view without dimensions; `positions`: mid-planes of the supports.

    The layer OUTLINE holds the silhouette of the whole shaft, the others the shapes of their pieces again, so that each
    is whole by itself."""
    up = upwards(outline)
    shapes: list[Primitive] = [Polyline("OUTLINE", silhouette(outline), True), Polyline("AXIS", axis(outline))]
    shapes += [Polyline("HIDDEN", edge) for edge in bore(outline)]
    for piece in outline.pieces:
        if (layer := LAYER_OF.get(piece.what)) is not None:
            high, low = reach(piece, up)
            shapes.append(
                Polyline(layer, ((piece.start, -low), (piece.end, -low), (piece.end, high), (piece.start, high)), True)
            )
            shapes += [Polyline(layer, edge) for edge in edges(piece, up)]
    return (*shapes, *(Polyline("SUPPORTS", mark, True) for mark in support_marks(outline, positions)))


# --- the screen's and the report's


def outline_curve(outline: "Outline", positions: tuple[Metre, ...]) -> Curve:
    """The side view as a curve in true scale: the points of the drawing, in mm."""
    names = (Text("front support"), *(Text("support {n}", n=n) for n in range(2, len(positions))), Text("rear support"))
    shape = silhouette(outline)
    series = [_series(Text("outline"), (*shape, shape[0])), _series(Text("axis"), axis(outline))]
    series += [_series(name, (*mark, mark[0])) for name, mark in zip(names, support_marks(outline, positions))]
    series += [_series(Text("bore"), edge) for edge in bore(outline)]
    z, up = axis_label("z", "mm"), axis_label("up: first eccentric mass", "mm")
    return Curve("outline", Text("Outline of the shaft"), z, up, tuple(series), equal=True)


def _series(label: Text, points: tuple[Point, ...]) -> Series:
    shown = UNITS["mm"].shown
    return Series(label, np.array([shown(x) for x, _ in points]), np.array([shown(y) for _, y in points]))
