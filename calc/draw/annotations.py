# SPDX-License-Identifier: Apache-2.0
"""A part of a sheet while it is drawn: its marks before it has its place, sizes and cutting planes.

Marks are in millimetres on the paper."""

import math
from collections.abc import Iterable
from typing import Literal

from ..sheet.record import replace
from ..sheet.units import Radian
from .drawing import (
    CUT,
    DIMENSION,
    HATCH,
    TABLE,
    TEXT,
    Arc,
    Area,
    Box,
    Dimension,
    Hatch,
    Ink,
    Inscription,
    Measure,
    Point,
    Polyline,
    Side,
    Words,
    moved,
    reach,
    spanned,
)
from .lettering import arrow, inscribed_width, inscribed_words, room, shortened, strokes, width

LETTER, TITLE = 2.5, 3.5  # heights of capitals, ISO 3098
SPACING = 2.0  # of a hatch
COLUMNS = (68.0, 44.0)  # of a table: what, and how much
Rows = list[tuple[str, ...]]
SheetTable = tuple[str, Rows, tuple[float, ...]]  # head, rows, widths of the columns
_MM = 1e-3


class Leaf:
    """Marks about an origin of their own.  All lengths are millimetres on the paper; the marks themselves are in
    metres."""

    def __init__(self) -> None:
        self.marks: list[Ink] = []

    def line(self, layer: str, *points: Point, closed: bool = False) -> None:
        self.marks.append(Polyline(layer, tuple(map(_metres, points)), closed))

    def box(self, layer: str, left: float, low: float, right: float, top: float) -> None:
        self.line(layer, (left, low), (right, low), (right, top), (left, top), closed=True)

    def arc(self, layer: str, centre: Point, radius: float, start: float = 0.0, end: float = 2 * math.pi) -> None:
        self.marks.append(Arc(layer, _metres(centre), radius * _MM, start, end))

    def words(
        self, text: str, x: float, y: float, side: Side = "left", height: float = LETTER, layer: str = TEXT
    ) -> None:
        if text:
            self.marks.append(Words(layer, (x * _MM, y * _MM), text, height * _MM, side=side))

    def arrow(self, tip: Point, angle: float, layer: str = DIMENSION, height: float = LETTER) -> None:
        """An arrow that points in the direction of an angle."""
        self.marks.append(replace(arrow(_metres(tip), (math.cos(angle), math.sin(angle)), height * _MM), layer=layer))

    def hatch(self, *outlines: Iterable[Point]) -> None:
        self.marks.append(Hatch(HATCH, tuple(tuple(map(_metres, outline)) for outline in outlines), SPACING * _MM))

    def dimension(
        self, start: Point, end: Point, line: float, size: Inscription, *, upright: bool = False, shift: float = 0.0
    ) -> None:
        """A distance along the sheet, or up it; `line`: where its dimension line lies across that."""
        at = (line, start[1]) if upright else (start[0], line)
        first, last, on_line = map(_metres, (start, end, at))
        shape = Dimension(DIMENSION, first, last, on_line, LETTER * _MM, upright, shift=shift * _MM)
        turned = math.pi / 2 if upright else 0.0
        self.marks.append(Measure(DIMENSION, "length", (first, last, on_line), strokes(shape, size), size, turned))

    def measure(
        self,
        kind: Literal["length", "radius", "angle"],
        points: Iterable[Point],
        picture: "Leaf",
        size: Inscription,
        turned: Radian = 0.0,
    ) -> None:
        """A size whose strokes are drawn already; `points` and `turned`: as a measure has them."""
        drawn = tuple(mark for mark in picture.marks if isinstance(mark, Polyline | Arc | Area | Words))
        self.marks.append(Measure(DIMENSION, kind, tuple(map(_metres, points)), drawn, size, turned))

    def inscribe(self, size: Inscription, x: float, y: float, side: Side = "left") -> None:
        """A size and its deviations, which begins at x, has its middle there, or ends there."""
        wide = inscribed_width(size, LETTER)
        left = x - {"left": 0.0, "centre": wide / 2, "right": wide}[side]
        self.marks += inscribed_words(size, _metres((left, y)), LETTER * _MM)

    def table(self, rows: list[tuple[str, ...]], columns: tuple[float, ...], head: str = "", row: float = 5.0) -> None:
        """Ruled rows below the origin, the first column's words on its left; a head stands above them.  Of two columns
        the second takes of the first what its longest cell needs: a size is never cut."""
        if len(columns) == 2 and rows:
            last = max(columns[1], *(width(cells[1], LETTER) + 3.0 for cells in rows))
            columns = (sum(columns) - last, last)
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
        left, low, right, top = spanned(point for mark in self.marks for point in corners(mark))
        return left / _MM, low / _MM, right / _MM, top / _MM


def corners(mark: Ink) -> Iterable[Point]:
    """Points that span a mark, letters included."""
    match mark:
        case Words():
            left, low, right, top = room(mark)
            return (left, low), (right, top)
        case Measure(picture=picture):
            return [point for stroke in picture for point in corners(stroke)]
        case _:
            return reach(mark)


def _metres(point: Point) -> Point:
    return point[0] * _MM, point[1] * _MM


# --- signs of a drawing
# The ends of a cutting plane (ISO 128-3), radii and angles.

GAP = 1.0
MARK, TAIL = 5.5, 7.0  # a cutting plane's end, and the arrow on it


def cutting_plane(leaf: Leaf, letter: str, x: float, high: float, low: float) -> list[Box]:
    """Both ends of a cutting plane, with arrows that look to the right; gives what they take of the view."""
    boxes = []
    for y, way in ((high, 1.0), (low, -1.0)):
        inner, outer = y + way * GAP, y + way * (GAP + MARK)
        leaf.line(CUT, (x, inner), (x, outer))
        leaf.line(DIMENSION, (x - TAIL, outer), (x, outer))
        leaf.arrow((x, outer), 0.0)
        leaf.words(letter, x - TAIL, outer + GAP if way > 0 else outer - GAP - TITLE, "left", TITLE)
        ends = sorted((inner, outer + way * (TITLE + 2 * GAP)))
        boxes.append((x - TAIL - GAP, ends[0], x + GAP, ends[1]))
    return boxes


def radius(leaf: Leaf, centre: Point, length: float, angle: float, size: Inscription, out: float) -> None:
    """A radius by an arrow from outside: its tip on the arc, its label on a shelf away from the middle."""
    tip, end = _polar(centre, length, angle), _polar(centre, out, angle)
    picture = leader(tip, angle + math.pi, end, math.cos(angle) >= 0, size)
    leaf.measure("radius", (centre, tip), picture, size)


def through(leaf: Leaf, length: float, angle: float, back: float, size: Inscription) -> None:
    """A radius by an arrow from inside: its line comes through the centre, from a shelf on the other side."""
    tip, end = _polar((0.0, 0.0), length, angle), _polar((0.0, 0.0), back, angle + math.pi)
    leaf.measure("radius", ((0.0, 0.0), tip), leader(tip, angle, end, end[0] >= 0, size), size)


def leader(tip: Point, angle: float, end: Point, right: bool, size: Inscription) -> Leaf:
    """An arrow whose line bends at its other end, to the right or to the left, and bears a size there."""
    leaf, wide = Leaf(), inscribed_width(size, LETTER) + GAP
    leaf.line(DIMENSION, tip, end, (end[0] + (wide if right else -wide), end[1]))
    leaf.arrow(tip, angle)
    leaf.inscribe(size, end[0] + (GAP if right else -GAP), end[1] + GAP, "left" if right else "right")
    return leaf


def angle(leaf: Leaf, centre: Point, inner: float, at: float, start: float, end: float, size: Inscription) -> None:
    """The angle between two directions, on an arc of radius `at`; the number outside its middle."""
    picture = Leaf()
    for side in (start, end):
        picture.line(DIMENSION, _polar(centre, inner + GAP, side), _polar(centre, at + 2 * GAP, side))
    picture.arc(DIMENSION, centre, at, start, end)
    back = 0.5 * 3.0 / at  # an arrow on an arc lies along its chord
    picture.arrow(_polar(centre, at, start), start - math.pi / 2 + back)
    picture.arrow(_polar(centre, at, end), end + math.pi / 2 - back)
    middle = (start + end) / 2
    x, y = _polar(centre, at + 1.5 * GAP, middle)
    aside = math.cos(middle) * inscribed_width(size, LETTER) / 2
    picture.inscribe(size, x + aside, y + (math.sin(middle) - 1) * LETTER / 2, "centre")
    ends = (_polar(centre, inner, side) for side in (start, end))
    leaf.measure("angle", (*ends, centre, _polar(centre, at, middle)), picture, size)


def _polar(centre: Point, radius: float, angle: float) -> Point:
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
