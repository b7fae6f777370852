# SPDX-License-Identifier: Apache-2.0
"""The drawing sheet: the shaft with its dimensions, turned to fill a page, and the data of the wheels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from calc.drawings import shaft, wheels
from calc.languages.outcome import in_language
from calc.sheet.drawing import Arc, Dimension, Point, Polyline, Primitive, Words
from calc.sheet.text import EMPTY

from .boxes import BLACK, GREY, Box, Colour, text
from .context import Context
from .flow import Block, heading
from .fonts import clean
from .paper import HEIGHT, LEFT, WIDTH
from .prose import SECTION, Style, lines
from .tornado import dashed
from .values import table_blocks

if TYPE_CHECKING:
    from .pen import Pen

ROOM = HEIGHT - 70.0  # of the page's height, which the drawing runs along
LEAST = 4.2  # size of the smallest letters
STYLES: dict[str, tuple[float, Colour, tuple[float, ...]]] = {  # layer → width of its lines, their colour, dashes
    "OUTLINE": (0.9, BLACK, ()), "AXIS": (0.35, GREY, (9.0, 2.0, 1.5, 2.0)), "DIMENSIONS": (0.3, GREY, ()),
}  # fmt: skip
THIN = (0.5, BLACK, ())
PIECES = 48  # of a whole circle
MOST = 160.0  # letters of a line that the drawing makes room for; a longer one is cut
TICK = 2.2  # half an arrow's length


def drawing_blocks(context: Context) -> list[Block]:
    """The sheet of what the design draws; nothing where it draws nothing."""
    made: list[Block] = []
    if drawn := shaft(context.results):
        title = context.design.name
        said = [replace(one, text=context.say(one.text)) if isinstance(one, Words) and one.text != title else one for one in drawn]
        made.append(_drawing(said))
    return made


def wheel_blocks(context: Context) -> list[Block]:
    """The data of the wheels as they stand on their drawings."""
    data = wheels(context.results)
    if data is None:
        return []
    table = replace(in_language(data, context.say), columns=data.columns)  # the names of the wheels are the user's
    return [*heading(table.title, SECTION, gap=11.0, after=0.0), *table_blocks(context, [replace(table, title=EMPTY)])]


def _drawing(drawn: Sequence[Primitive]) -> Block:
    """The drawing turned a quarter to the left, as large as the page allows."""
    xs, ys = zip(*(point for one in drawn for point in _points(one)))
    scale = min(ROOM / (max(xs) - min(xs)), WIDTH / (max(ys) - min(ys)))
    long, high = scale * (max(xs) - min(xs)), scale * (max(ys) - min(ys))

    def draw(pen: Pen, top: float) -> None:
        sheet = _Sheet(pen, scale, min(xs), max(ys), (WIDTH - high) / 2, top - long, long)
        for one in drawn:
            sheet.draw(one)

    return Block(long, draw, gap=4.0)


def _points(one: Primitive) -> list[Point]:
    """The corners of what a primitive takes of the sheet."""
    match one:
        case Polyline(points=points):
            return list(points)
        case Arc(centre=(x, y), radius=r):
            return [(x - r, y - r), (x + r, y + r)]
        case Words(at=(x, y), text=words, height=h):
            return [(x, y), (x + min(0.75, MOST / max(1, len(words))) * h * len(words), y + h)]
        case Dimension(start=start, end=end, line=line, height=h):
            return [start, end, (line[0] - h, line[1] - h), (line[0] + h, line[1] + 2 * h)]


class _Sheet:
    """From the sheet's metres to the points of the page, the sheet's right being the page's up."""

    def __init__(self, pen: Pen, scale: float, left: float, upper: float, x: float, y: float, long: float) -> None:
        self.pen, self.scale = pen, scale
        self.left, self.upper, self.x, self.y, self.long = left, upper, x, y, long

    def at(self, point: Point) -> tuple[float, float]:
        return LEFT + self.x + self.scale * (self.upper - point[1]), self.y + self.scale * (point[0] - self.left)

    def draw(self, one: Primitive) -> None:
        match one:
            case Polyline(layer=layer, points=points, closed=closed):
                self.line([*points, points[0]] if closed else list(points), layer)
            case Arc(layer=layer, centre=(x, y), radius=r, start=start, end=end):
                n = max(4, math.ceil(PIECES * (end - start) / (2 * math.pi)))
                turn = [start + (end - start) * i / n for i in range(n + 1)]
                self.line([(x + r * math.cos(t), y + r * math.sin(t)) for t in turn], layer)
            case Words(at=at, text=words, height=h):
                size = max(LEAST, self.scale * h)
                room = self.y + self.long - self.at(at)[1]
                self.words(lines(words, Style(size, size), room, 1)[0], at)
            case Dimension():
                self.dimension(one)

    def line(self, points: list[Point], layer: str) -> None:
        thick, colour, dashes = STYLES.get(layer, THIN)
        placed = [self.at(point) for point in points]
        if dashes:
            dashed(self.pen, placed[0], placed[-1], (colour, dashes, thick))
        else:
            self.pen.line(placed, thick, colour)

    def words(self, box: Box, at: Point, *, middle: bool = False, upright: bool = False) -> None:
        """Text that reads along the sheet; upright: along its second axis, which is across the page."""
        x, y = self.at(at)
        back = box.width / 2 if middle else 0.0
        if upright:
            self.pen.put(box, x - LEFT - back, y)
        else:
            self.pen.turn(box, x - LEFT, y - back)

    def dimension(self, one: Dimension) -> None:
        """Two lines out to the dimension, the dimension line with its ticks, and the number on it."""
        n = 1 if one.upright else 0
        ends = [_with(one.line, n, point[n]) for point in (one.start, one.end)]
        for point, end in zip((one.start, one.end), ends):
            self.line([point, end], "DIMENSIONS")
        self.line(ends, "DIMENSIONS")
        for end in ends:
            x, y = self.at(end)
            self.pen.line([(x - TICK, y - TICK), (x + TICK, y + TICK)], 0.5, GREY)
        length = abs(one.end[n] - one.start[n]) * 1e3
        number = f"{'⌀' if one.diameter else ''}{length:.2f}".rstrip("0").rstrip(".")
        middle = _with(ends[0], n, (ends[0][n] + ends[1][n]) / 2 + one.shift)
        box = text(clean(number), max(LEAST, self.scale * one.height))
        off = 0.25 * one.height
        if not one.upright and box.width > self.scale * length / 1e3:
            off = -one.height  # a number longer than its dimension stands where no line crosses it
        place = (middle[0] + off, middle[1]) if one.upright else (middle[0], middle[1] + off)
        self.words(box, place, middle=True, upright=one.upright)


def _with(point: Point, n: int, value: float) -> Point:
    return (value, point[1]) if n == 0 else (point[0], value)
