# SPDX-License-Identifier: Apache-2.0
"""Where what stands around a view has its place: dimensions in rows below it, words on shelves above it.

No dimension or word crosses or covers another.  The shorter a dimension, the closer it stands to the view: the
extension lines of a longer one then pass outside of it."""

import math
from collections.abc import Mapping, Sequence
from itertools import product

from ..sheet.record import record
from .drawing import Box
from .lettering import ARROW, TAIL, outside

CLEAR = 0.8  # mm between what stands side by side
FAR, FURTHEST = 1.0, 400  # mm: steps of a number that has to go further, and how many
LEVELS = 16  # heights that a shelf tries on either side of its line
OUTWARDS = 3  # so many of them higher it stands inwards rather than outwards
STEPS = 8  # places to each side that a number tries before it goes to the next row


@record
class Span:
    """What is measured, from `start` to `end`, by a number of that width."""

    start: float
    end: float
    wide: float

    @property
    def length(self) -> float:
        return self.end - self.start

    @property
    def middle(self) -> float:
        return (self.start + self.end) / 2


@record
class DimensionRow:
    """Where a dimension stands: how many rows away from the view, and its number how far from its middle."""

    span: Span
    level: int
    shift: float

    @property
    def number(self) -> tuple[float, float]:
        middle = self.span.middle + self.shift
        return middle - self.span.wide / 2, middle + self.span.wide / 2

    def taken(self, height: float) -> tuple[float, float]:
        """All that its line, arrows and number take of the row."""
        span = self.span
        tail = TAIL * ARROW * height if outside(span.length, height) else 0.0
        first, last = self.number
        return min(span.start - tail, first), max(span.end + tail, last)


def rows(spans: Sequence[Span], height: float) -> list[DimensionRow]:
    """A row for each span, in the order in which they are given."""
    placed: dict[int, DimensionRow] = {}
    order = sorted(range(len(spans)), key=lambda n: (round(spans[n].length, 6), n))
    for place, n in enumerate(order):
        later = [spans[i] for i in order[place + 1 :]]
        # last further and further to the right, until it is clear of all: where many short ones stand close together
        far = [_beside(spans[n], height) + FAR * step for step in range(1, FURTHEST)]
        candidates = (
            DimensionRow(spans[n], level, shift)
            for shifts in (_near(spans[n], height), far)
            for level in range(len(spans) + 1)
            for shift in shifts
        )
        free = (row for row in candidates if _clear(row, list(placed.values()), later, height))
        placed[n] = next(free, DimensionRow(spans[n], len(spans) + 1, 0.0))
    return [placed[n] for n in range(len(spans))]


def _near(span: Span, height: float) -> list[float]:
    """Where its number may stand: above its middle, elsewhere between its arrows, or beside them."""
    spare = (span.length - span.wide) / 2 - CLEAR / 2
    between = [0.0, *(sign * spare * n / STEPS for n in range(1, STEPS + 1) for sign in (1, -1))] if spare >= 0 else []
    return [*between, _beside(span, height), -_beside(span, height)]


def _beside(span: Span, height: float) -> float:
    tail = TAIL * ARROW * height if outside(span.length, height) else CLEAR
    return span.length / 2 + tail + span.wide / 2


def _clear(row: DimensionRow, placed: list[DimensionRow], later: list[Span], height: float) -> bool:
    first, last = row.taken(height)
    for other in placed:
        a, b = other.taken(height)
        if other.level == row.level and first < b - 1e-6 and a < last - 1e-6:
            return False
        ends = (other.span.start, other.span.end)
        if other.level > row.level and any(row.span.start < x < row.span.end or _within(x, row.number) for x in ends):
            return False  # its extension lines would cross the row
        if other.level < row.level and any(_within(x, other.number) for x in (row.span.start, row.span.end)):
            return False
    return not any(_within(x, row.number) for span in later for x in (span.start, span.end))


def _within(x: float, number: tuple[float, float]) -> bool:
    return number[0] - CLEAR / 2 < x < number[1] + CLEAR / 2


@record
class Shelf:
    """Words on a line of their own above a view, with a line from there straight down to what they speak of."""

    x: float  # of the line down
    foot: float  # where it ends
    wide: float  # of the words
    high: float


Place = tuple[float, bool]  # height of a shelf, and whether its words stand to the right of its line


def shelves(
    asked: Sequence[Shelf], bottom: float, step: float, limits: tuple[float, float], taken: Sequence[Box]
) -> list[Place]:
    """Where each shelf stands: its words towards the middle, or outwards where they stand much lower there; where that
    can not be, all to the right, as stairs above all else.

    `bottom`: the lowest shelf; `limits` to the left and the right; `taken`: where nothing may stand.
    """
    middle = sum(limits) / 2
    inner_first = sorted(range(len(asked)), key=lambda n: abs(asked[n].x - middle))
    order = sorted(product(range(LEVELS), (True, False)), key=lambda way: way[0] + OUTWARDS * (not way[1]))
    ways = {
        n: [(bottom + step * level, (asked[n].x <= middle) is inwards) for level, inwards in order] for n in inner_first
    }
    places = _placed(asked, inner_first, ways, limits, taken)
    if places is None:
        right_first = sorted(inner_first, key=lambda n: -asked[n].x)
        over = max((bottom, *(box[3] + CLEAR for box in taken)))
        stairs = {n: [(over + step * level, True) for level in range(LEVELS * len(asked))] for n in inner_first}
        places = _placed(asked, right_first, stairs, (-math.inf, math.inf), ()) or {n: ways[n][0] for n in inner_first}
    return [places[n] for n in range(len(asked))]


def _placed(
    asked: Sequence[Shelf],
    order: Sequence[int],
    ways: Mapping[int, Sequence[Place]],
    limits: tuple[float, float],
    taken: Sequence[Box],
) -> dict[int, Place] | None:
    """The first way of each shelf that is free, in that order; one that has no place yet keeps all above it free for
    its line."""
    places: dict[int, Place] = {}
    boxes = list(taken)
    for n in order:
        tops = {i: places[i][0] if i in places else math.inf for i in range(len(asked)) if i != n}
        lines = [(asked[i].x - CLEAR, asked[i].foot, asked[i].x + CLEAR, top) for i, top in tops.items()]
        for y, right in ways[n]:
            shelf = asked[n]
            left = shelf.x if right else shelf.x - shelf.wide
            box = (left, y - CLEAR, left + shelf.wide, y + shelf.high)
            line = (shelf.x - CLEAR, shelf.foot, shelf.x + CLEAR, y)
            free = not any(_overlap(box, other) for other in (*boxes, *lines))
            free = free and not any(_overlap(line, other) for other in boxes)
            if limits[0] <= left and left + shelf.wide <= limits[1] and free:
                places[n] = y, right
                boxes.append(box)
                break
        else:
            return None
    return places


def _overlap(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
