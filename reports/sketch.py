# SPDX-License-Identifier: Apache-2.0
"""The drive at a glance: the shaft and its train side by side in one scale, without dimensions."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from calc.studies.drawings import shaft, train
from calc.draw.drawing import Arc, Point, Polyline, Primitive, Words

from .setting.boxes import BLACK, GREY, Colour
from .content import Picture
from .context import Context
from .setting.flow import Block
from .paper import LEFT, WIDTH
from .setting.prose import NOTE, one_line
from .setting.tags import FIGURE, Tag

if TYPE_CHECKING:
    from .setting.pen import Pen

HIGH = 84.0  # at most, of the drawing
BETWEEN = 22.0  # of shaft and train
PIECES = 40  # of a whole circle
LINES: dict[str, tuple[float, Colour]] = {"OUTLINE": (0.8, BLACK), "AXIS": (0.4, GREY)}
THIN = (0.5, GREY)


def sketch_blocks(context: Context) -> list[Block]:
    """The sketch of what the design has; nothing where it draws nothing."""
    parts = [part for part in (_side_view(shaft(context.results)), list(train(context.results))) if part]
    if not parts:
        return []
    boxes = [_box(part) for part in parts]
    wide, high = sum(right - left for left, _, right, _ in boxes), max(top - low for _, low, _, top in boxes)
    scale = min((WIDTH - BETWEEN * (len(parts) - 1)) / wide, HIGH / high)
    words = NOTE.leading if any(isinstance(one, Words) for part in parts for one in part) else 0.0

    names = [context.design.name, *(one.text for part in parts for one in part if isinstance(one, Words))]

    def draw(pen: Pen, y: float) -> None:
        x = 0.0
        for part, (left, low, right, top) in zip(parts, boxes):
            middle = y - scale * high / 2
            for one in part:
                _draw(pen, one, scale, x - scale * left, middle - scale * (low + top) / 2)
            x += scale * (right - left) + BETWEEN

    return [Block(scale * high + words + 4.0, draw, gap=8.0, content=Picture(), tag=Tag(FIGURE, alt="; ".join(names)))]


def _side_view(drawn: tuple[Primitive, ...]) -> list[Primitive]:
    """Of the shaft's sheet the lines that lie within the outline of its side view."""
    lines = [one for one in drawn if isinstance(one, Polyline)]
    outline = next((one for one in lines if one.layer == "OUTLINE"), None)
    if outline is None:
        return []
    reach = max(abs(y) for _, y in outline.points) * 1.4
    return [one for one in lines if all(abs(y) <= reach for _, y in one.points)]


def _box(part: list[Primitive]) -> tuple[float, float, float, float]:
    """Left, lower, right and upper end of what is drawn."""
    points: list[Point] = []
    for one in part:
        if isinstance(one, Polyline):
            points += one.points
        elif isinstance(one, Arc):
            (x, y), r = one.centre, one.radius
            points += [(x - r, y - r), (x + r, y + r)]
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


def _draw(pen: Pen, one: Primitive, scale: float, x: float, y: float) -> None:
    """One primitive with the origin of its sheet at this place."""

    def at(point: Point) -> tuple[float, float]:
        return LEFT + x + scale * point[0], y + scale * point[1]

    match one:
        case Polyline(layer=layer, points=points, closed=closed):
            thick, colour = LINES.get(layer, THIN)
            pen.line([at(point) for point in (*points, points[0])] if closed else [at(point) for point in points], thick, colour)
        case Arc(layer=layer, centre=(cx, cy), radius=r, start=start, end=end):
            thick, colour = LINES.get(layer, THIN)
            turn = [start + (end - start) * i / PIECES for i in range(PIECES + 1)]
            pen.line([at((cx + r * math.cos(t), cy + r * math.sin(t))) for t in turn], thick, colour)
        case Words(at=(wx, wy), text=words):
            box = one_line(words, NOTE, 80.0)
            left, low = at((wx, wy))
            pen.put(box, left - LEFT - box.width / 2, low - NOTE.leading)
