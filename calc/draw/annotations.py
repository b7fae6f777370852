# SPDX-License-Identifier: Apache-2.0
"""A part of a sheet while it is drawn: its marks, in millimetres on the paper, before it has its place."""

import math
from collections.abc import Iterable
from dataclasses import replace

from ..sheet.dimension import arrow, strokes
from .drawing import Arc, Box, Dimension, Hatch, Ink, Point, Polyline, Side, Words, moved, reach
from ..sheet.layers import DIMENSION, HATCH, TABLE, TEXT
from .lettering import room, shortened
from ..sheet.text import Name

LETTER, TITLE = 2.5, 3.5  # heights of capitals, ISO 3098
SPACING = 2.0  # of a hatch
_MM = 1e-3


class Leaf:
    """Marks about an origin of their own.  All lengths are millimetres on the paper; the marks themselves are in metres."""

    def __init__(self) -> None:
        self.marks: list[Ink] = []

    def line(self, layer: str, *points: Point, closed: bool = False) -> None:
        self.marks.append(Polyline(layer, tuple(map(_metres, points)), closed))

    def box(self, layer: str, left: float, low: float, right: float, top: float) -> None:
        self.line(layer, (left, low), (right, low), (right, top), (left, top), closed=True)

    def arc(self, layer: str, centre: Point, radius: float, start: float = 0.0, end: float = 2 * math.pi) -> None:
        self.marks.append(Arc(layer, _metres(centre), radius * _MM, start, end))

    def words(self, text: str, x: float, y: float, side: Side = "left", height: float = LETTER, layer: str = TEXT) -> None:
        if text:
            self.marks.append(Words(layer, (x * _MM, y * _MM), text, height * _MM, side=side))

    def arrow(self, tip: Point, angle: float, layer: str = DIMENSION, height: float = LETTER) -> None:
        """An arrow that points in the direction of an angle."""
        self.marks.append(replace(arrow(_metres(tip), (math.cos(angle), math.sin(angle)), height * _MM), layer=layer))

    def hatch(self, *outlines: Iterable[Point]) -> None:
        self.marks.append(Hatch(HATCH, tuple(tuple(map(_metres, outline)) for outline in outlines), SPACING * _MM))

    def dimension(self, start: Point, end: Point, line: float, label: str, *, upright: bool = False, shift: float = 0.0) -> None:
        """A distance along the sheet, or up it; `line`: where its dimension line lies across that."""
        at = (line, start[1]) if upright else (start[0], line)
        self.marks.append(Dimension(DIMENSION, _metres(start), _metres(end), _metres(at), LETTER * _MM, upright, shift=shift * _MM,
            label=Name(label)))  # fmt: skip

    def table(self, rows: list[tuple[str, ...]], columns: tuple[float, ...], head: str = "", row: float = 5.0) -> None:
        """Ruled rows below the origin, the first column's words on its left; a head stands above them."""
        lines: list[tuple[str, ...]] = [(head,), *rows] if head else list(rows)
        low, right = -row * len(lines), sum(columns)
        for n, cells in enumerate(lines):
            x = 0.0
            for cell, wide in zip(cells, columns if len(cells) > 1 else (right,)):
                self.words(shortened(cell, LETTER, wide - 3.0), x + 1.5, -row * (n + 1) + 1.5)
                x += wide
            if n:
                self.line(TABLE, (0.0, -row * n), (right, -row * n))
        x = 0.0
        for wide in columns[:-1]:
            x += wide
            self.line(TABLE, (x, -row if head else 0.0), (x, low))
        self.box(TABLE, 0.0, low, right, 0.0)

    def add(self, other: "Leaf", dx: float = 0.0, dy: float = 0.0) -> None:
        """The marks of another leaf, its origin at this place."""
        self.marks += [moved(mark, dx * _MM, dy * _MM) for mark in other.marks]

    @property
    def extent(self) -> Box:
        """Left, lower, right and upper end of all that is drawn, letters included, in millimetres."""
        points = [point for mark in self.marks for point in corners(mark)]
        if not points:
            return 0.0, 0.0, 0.0, 0.0
        xs, ys = zip(*points)
        return min(xs) / _MM, min(ys) / _MM, max(xs) / _MM, max(ys) / _MM


def corners(mark: Ink) -> Iterable[Point]:
    """Points that span a mark, letters included."""
    match mark:
        case Words():
            left, low, right, top = room(mark)
            return (left, low), (right, top)
        case Dimension():
            return [point for stroke in strokes(mark) for point in corners(stroke)]
        case Hatch(outlines=outlines):
            return [point for outline in outlines for point in outline]
        case _:
            return reach(mark)


def _metres(point: Point) -> Point:
    return point[0] * _MM, point[1] * _MM
