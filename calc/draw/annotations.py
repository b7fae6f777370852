# SPDX-License-Identifier: Apache-2.0
"""A part of a sheet while it is drawn: its marks before it has its place, signs, and numbers as a drawing has them.

Marks are in millimetres on the paper."""

import math
from collections.abc import Callable, Iterable

from ..sheet.record import replace
from ..sheet.text import Amount, Name, Text
from ..sheet.units import UNITS, Metre, Radian
from .drawing import (
    CUT,
    DIMENSION,
    HATCH,
    TABLE,
    TEXT,
    Arc,
    Box,
    Dimension,
    Hatch,
    Ink,
    Point,
    Polyline,
    Side,
    Words,
    moved,
    reach,
    spanned,
)
from .lettering import arrow, room, shortened, strokes, width

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
        self, start: Point, end: Point, line: float, label: str, *, upright: bool = False, shift: float = 0.0
    ) -> None:
        """A distance along the sheet, or up it; `line`: where its dimension line lies across that."""
        at = (line, start[1]) if upright else (start[0], line)
        ends, high = (_metres(start), _metres(end), _metres(at)), LETTER * _MM
        self.marks.append(Dimension(DIMENSION, *ends, high, upright, shift=shift * _MM, label=Name(label)))

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
        case Dimension():
            return [point for stroke in strokes(mark) for point in corners(stroke)]
        case Hatch(outlines=outlines):
            return [point for outline in outlines for point in outline]
        case _:
            return reach(mark)


def _metres(point: Point) -> Point:
    return point[0] * _MM, point[1] * _MM


# --- signs of a drawing
# A diameter on its shelf, a surface's roughness (ISO 21920-1), the ends of a cutting plane (ISO 128-3).

SLOPE = math.tan(math.pi / 3)
SHORT_LEG, LONG_LEG = 3.5, 7.0  # heights of the two legs of the sign of a surface
GAP = 1.0
MARK, TAIL = 5.5, 7.0  # a cutting plane's end, and the arrow on it


def sign_width(texture: str) -> float:
    return (SHORT_LEG + LONG_LEG) / SLOPE + width(texture, LETTER) + GAP if texture else 0.0


def roughness(leaf: Leaf, texture: str, x: float, y: float) -> None:
    """The sign that leaves the process open, standing on a line at y; its value below its bar."""
    foot = x + SHORT_LEG / SLOPE
    bend = foot + LONG_LEG / SLOPE
    end = bend + width(texture, LETTER) + GAP
    leaf.line(DIMENSION, (x, y + SHORT_LEG), (foot, y), (bend, y + LONG_LEG), (end, y + LONG_LEG))
    leaf.words(texture, bend, y + LONG_LEG - LETTER - GAP, layer=DIMENSION)


def shelf_size(label: str, texture: str) -> tuple[float, float]:
    """Width and height of what stands on a shelf."""
    wide = width(label, LETTER) + 2 * GAP
    return (wide + sign_width(texture) + 2 * GAP, LONG_LEG + GAP) if texture else (wide, LETTER + 2 * GAP)


def shelf(leaf: Leaf, foot: Point, y: float, right: bool, label: str, texture: str = "") -> None:
    """A line up from `foot`, and on the line that it bends into a label and a surface's sign."""
    wide, _ = shelf_size(label, texture)
    left = foot[0] if right else foot[0] - wide
    leaf.line(DIMENSION, foot, (foot[0], y), (foot[0] + (wide if right else -wide), y))
    leaf.words(label, left + GAP, y + GAP, layer=DIMENSION)
    if texture:
        roughness(leaf, texture, left + 3 * GAP + width(label, LETTER), y)


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


def radius(leaf: Leaf, centre: Point, length: float, angle: float, label: str, out: float) -> None:
    """A radius by an arrow from outside: its tip on the arc, its label on a shelf away from the middle."""
    tip, end = _polar(centre, length, angle), _polar(centre, out, angle)
    _leader(leaf, tip, angle + math.pi, end, math.cos(angle) >= 0, label)


def through(leaf: Leaf, length: float, angle: float, back: float, label: str) -> None:
    """A radius by an arrow from inside: its line comes through the centre, from a shelf on the other side."""
    tip, end = _polar((0.0, 0.0), length, angle), _polar((0.0, 0.0), back, angle + math.pi)
    _leader(leaf, tip, angle, end, end[0] >= 0, label)


def _leader(leaf: Leaf, tip: Point, angle: float, end: Point, right: bool, label: str) -> None:
    """An arrow whose line bends at its other end, to the right or to the left, and bears a label there."""
    wide = width(label, LETTER) + GAP
    leaf.line(DIMENSION, tip, end, (end[0] + (wide if right else -wide), end[1]))
    leaf.arrow(tip, angle)
    leaf.words(label, end[0] + (GAP if right else -GAP), end[1] + GAP, "left" if right else "right", layer=DIMENSION)


def angle(leaf: Leaf, centre: Point, inner: float, at: float, start: float, end: float, label: str) -> None:
    """The angle between two directions, on an arc of radius `at`; the number outside its middle."""
    for side in (start, end):
        leaf.line(DIMENSION, _polar(centre, inner + GAP, side), _polar(centre, at + 2 * GAP, side))
    leaf.arc(DIMENSION, centre, at, start, end)
    back = 0.5 * 3.0 / at  # an arrow on an arc lies along its chord
    leaf.arrow(_polar(centre, at, start), start - math.pi / 2 + back)
    leaf.arrow(_polar(centre, at, end), end + math.pi / 2 - back)
    middle = (start + end) / 2
    x, y = _polar(centre, at + 1.5 * GAP, middle)
    aside, higher = math.cos(middle) * width(label, LETTER) / 2, (math.sin(middle) - 1) * LETTER / 2
    leaf.words(label, x + aside, y + higher, "centre", layer=DIMENSION)


def _polar(centre: Point, radius: float, angle: float) -> Point:
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


# --- numbers as a drawing has them
# Rounded, without zeros behind, in the language of the sheet.

Say = Callable[[str], str]
ALIKE = 1e-9  # m
FINE, COARSE = 2, 1  # decimals of a length that the design gives, and of one that follows from masses
GIVEN = 1e-4  # mm: what is so close to a hundredth is given


def number(x: float, digits: int) -> Amount:
    """Rounded to so many decimals, without zeros behind them."""
    return Amount(round(x, digits) + 0.0, form=".12g")


def millimetres(length: Metre, digits: int = FINE) -> Amount:
    return number(UNITS["mm"].shown(length), digits)


def rounded(length: Metre) -> Amount:
    """A length as a drawing has it: 27.51 that only follows from a mass is 27.5, but 26.25 that is given stays."""
    shown = UNITS["mm"].shown(length)
    return number(shown, FINE if abs(shown - round(shown, FINE)) < GIVEN else COARSE)


def degrees(angle: Radian, digits: int = COARSE) -> Text:
    return Text("{angle}°", angle=number(math.degrees(angle), digits))


def alone(amount: Amount) -> Text:
    return Text("{number}", number=amount)


def signed(length: Metre) -> Amount:
    """A deviation with its sign; 0 has none."""
    shown = round(UNITS["mm"].shown(length), 4) + 0.0
    return Amount(shown, form="+.12g" if shown else "g")


def deviated(size: Text, lower: Metre, upper: Metre) -> Text:
    """A size with its deviations; those that differ by their sign alone stand together."""
    if abs(lower + upper) < ALIKE:
        return Text("{size} ±{deviation}", size=size, deviation=millimetres(upper, 4))
    return Text("{size} ({upper}/{lower})", size=size, upper=signed(upper), lower=signed(lower))
