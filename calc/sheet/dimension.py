# SPDX-License-Identifier: Apache-2.0
"""A dimension in strokes, as ISO 129-1 has it: two extension lines, the dimension line with its arrows, and the number above it."""

from ..draw.drawing import Area, Dimension, Point, Polyline, Words
from .layers import DIMENSION
from ..draw.lettering import width
from .units import UNITS, Metre

ARROW = 1.2  # all in heights of a letter: length of an arrow,
HALF_ARROW = 0.16  # half of its width,
OFF = 0.4  # between what is drawn and an extension line, and between the dimension line and its number,
BEYOND = 0.8  # how far an extension line goes on,
TAIL = 2.0  # and the dimension line beside arrows that stand outside, in arrows
TIGHT = 2.2  # arrows: in less they stand outside

Stroke = Polyline | Area | Words


def strokes(dimension: Dimension) -> tuple[Stroke, ...]:
    """What is drawn of a dimension, number and arrows included."""
    h, n = dimension.height, 1 if dimension.upright else 0
    first, last = sorted((dimension.start, dimension.end), key=lambda point: point[n])
    a, b, level = first[n], last[n], dimension.line[1 - n]
    number = written(dimension)
    middle, half = (a + b) / 2 + dimension.shift, width(number, h) / 2
    tail = TAIL * ARROW * h if outside(b - a, h) else 0.0
    reach = [min(a - tail, middle - half) if dimension.shift or tail else a, max(b + tail, middle + half) if dimension.shift or tail else b]
    way = -1.0 if tail else 1.0
    made: list[Stroke] = []
    for point in (first, last):
        start, sign = point[1 - n], 1.0 if level > point[1 - n] else -1.0
        if abs(level - start) > OFF * h:
            made.append(Polyline(DIMENSION, (_at(point[n], start + sign * OFF * h, n), _at(point[n], level + sign * BEYOND * h, n))))
    made += [Polyline(DIMENSION, (_at(reach[0], level, n), _at(reach[1], level, n)))]
    made += [arrow(_at(a, level, n), _at(-way, 0.0, n), h), arrow(_at(b, level, n), _at(way, 0.0, n), h)]
    above = level - OFF * h if dimension.upright else level + OFF * h
    made.append(Words(DIMENSION, _at(middle, above, n), number, h, side="centre", turned=dimension.upright))
    return tuple(made)


def outside(length: Metre, height: Metre) -> bool:
    """Whether the arrows stand outside what they measure, as it has no room for them."""
    return length < TIGHT * ARROW * height


def written(dimension: Dimension) -> str:
    """The number that stands on a dimension: its label, else the distance."""
    if dimension.label:
        return dimension.label
    n = 1 if dimension.upright else 0
    length = UNITS["mm"].shown(abs(dimension.end[n] - dimension.start[n]))
    return f"{'⌀' if dimension.diameter else ''}{round(length, 2):g}"


def arrow(tip: Point, direction: Point, height: Metre) -> Area:
    """A filled arrow that ends in `tip`; `direction` is of length 1."""
    (x, y), (u, v) = tip, direction
    back, half = ARROW * height, HALF_ARROW * height
    corners = (tip, (x - back * u - half * v, y - back * v + half * u), (x - back * u + half * v, y - back * v - half * u))
    return Area(DIMENSION, (corners,), 1.0)


def _at(along: float, across: float, n: int) -> Point:
    return (along, across) if n == 0 else (across, along)
