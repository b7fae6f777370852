# SPDX-License-Identifier: Apache-2.0
"""Where pictures lie in a frame of character cells: next to each other or above, each at the largest true scale with all its words."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from rich.cells import cell_len

from calc.locale import Language
from calc.draw.drawing import Dimension, Mark, Point, Sketch, Words, reach
from calc.sheet.text import Amount

from .raster import Floats

LEAST, SMALL = (14, 6), 0.5  # columns and rows, and share of its scale, below which a picture beside another one is left out
SMALLER = 0.97  # step of the scale at which the pictures are tried next to each other
GAPS = 3, 1  # columns and rows between pictures
RIGHT, CENTRE, LEFT = "left", "centre", "right"


@dataclass(frozen=True)
class Frame:
    """A part of the canvas, in cells."""

    left: int
    top: int
    columns: int
    rows: int

    @property
    def roomy(self) -> bool:
        return self.columns >= LEAST[0] and self.rows >= LEAST[1]


class Spread:
    """What a picture spans: its points, and how many cells its words reach around theirs."""

    def __init__(self, sketch: Sketch, say: Language) -> None:
        reaches: list[tuple[float, ...]] = [(*point, 0.3, 0.3, 0.15, 0.15) for mark in sketch.primitives for point in reach(mark)]
        reaches += [reach for mark in sketch.primitives for reach in _word_reach(mark, say)]
        self.x, self.y, self.left, self.right, self.up, self.down = np.array(reaches or [(0.0,) * 6]).T
        self.sketch, self.title = sketch, bool(sketch.title)
        self.extent = max(float(np.ptp(self.x)), float(np.ptp(self.y))) or 1.0
        self.least_wide = cell_len(say(sketch.title))

    def edges(self, scale: float) -> tuple[float, float, float, float]:
        """Left, right, top and bottom in cells, at so many columns per metre."""
        across, upwards = self.x * scale, self.y * (scale / 2)
        return (
            float((across - self.left).min()), float((across + self.right).max()),
            float((upwards + self.up).max()), float((upwards - self.down).min()),
        )  # fmt: skip

    def size(self, scale: float) -> tuple[float, float]:
        """Columns and rows."""
        left, right, top, bottom = self.edges(scale)
        return max(right - left, self.least_wide), top - bottom + self.title

    def largest(self, columns: int, rows: int) -> float:
        """The largest scale that fits into so many cells."""
        scale = (columns + 2 * rows) / self.extent
        scale = _shrunk(self.x, self.left, self.right, columns, scale)
        return 2 * _shrunk(self.y, self.down, self.up, rows - self.title, scale / 2)


def _shrunk(at: Floats, before: Floats, behind: Floats, room: float, scale: float) -> float:
    """The largest scale, up to the given one, at which all that is around these places fits into the room.

    What the places span grows along straight lines that get steeper: following the steepest back never goes too far.
    """
    for _ in range(len(at)):
        last, first = int((at * scale + behind).argmax()), int((at * scale - before).argmin())
        reach = float(at[last] - at[first])
        over = reach * scale + float(behind[last] + before[first]) - room
        if over <= 1e-9 or reach <= 0:
            return scale
        scale = max(0.0, scale - over / reach)
    return scale


def arranged(pictures: list[Spread], columns: int, rows: int) -> list[tuple[Spread, Frame]]:
    """The pictures side by side or one above the other, whichever draws them larger; as many as are still large enough."""
    while len(pictures) > 1:
        ways = [way for way in (_shared(pictures, columns, rows, 0), _shared(pictures, columns, rows, 1)) if way is not None]
        if ways:
            return max(ways, key=lambda way: way[0])[1]
        pictures = pictures[:-1]
    return [(pictures[0], Frame(0, 0, columns, rows))]


def _shared(pictures: list[Spread], columns: int, rows: int, way: int) -> tuple[float, list[tuple[Spread, Frame]]] | None:
    """The frames side by side (`way` 0) or one above the other, and the share of the scale that each has of what it would have alone;
    None where they get too small."""
    gap = GAPS[way] * (len(pictures) - 1)
    room = (columns, rows)[way] - gap
    if room <= 0:
        return None
    alone = [picture.largest(columns, rows) for picture in pictures]
    share, sizes = 1.0, [room + 1]
    while sum(sizes) > room and share >= SMALL:
        sizes = [math.ceil(picture.size(share * scale)[way]) for picture, scale in zip(pictures, alone)]
        share *= SMALLER
    share /= SMALLER
    spare, at, frames = room - sum(sizes), 0, []
    for n, (picture, size) in enumerate(zip(pictures, sizes)):
        size += spare * (n + 1) // len(sizes) - spare * n // len(sizes)
        frames.append((picture, Frame(at, 0, size, rows) if way == 0 else Frame(0, at, columns, size)))
        at += size + GAPS[way]
    return (share, frames) if sum(sizes) <= room and all(frame.roomy for _, frame in frames) else None


class Fit:
    """Where metres lie in a frame of cells: in its middle, at the largest true scale at which the picture and its words are within."""

    def __init__(self, picture: Spread, frame: Frame) -> None:
        self.scale = picture.largest(frame.columns, frame.rows)  # columns per metre
        left, right, top, bottom = picture.edges(self.scale)
        self.x = frame.left + (frame.columns - (right - left)) / 2 - left
        above = max(0, math.floor((frame.rows - (top - bottom) - picture.title) / 2))
        self.title = frame.top + above  # the row of the title
        self.y = self.title + picture.title + top

    def cell(self, at: Point) -> tuple[int, int]:
        """Row and column of a place."""
        return math.floor(self.y - at[1] * self.scale / 2), math.floor(self.x + at[0] * self.scale)

    def dots(self, points: Iterable[Point]) -> Floats:
        places = np.array(list(points), float).reshape(-1, 2)
        return np.column_stack([2 * (self.x + places[:, 0] * self.scale), 4 * (self.y - places[:, 1] * self.scale / 2)])


def _word_reach(mark: Mark, say: Language) -> Iterable[tuple[float, ...]]:
    """A place, and how many cells its words reach from there to the left, right, up and down."""
    match mark:
        case Words(at=at, side=side):
            wide = cell_len(words_of(mark, say))
            left: float = {RIGHT: 0.0, CENTRE: wide / 2, LEFT: wide}[side]
            yield *at, left, wide - left, 0.5, 0.5
        case Dimension(start=start, end=end, line=(x, y), upright=upright):
            room = cell_len(words_of(mark, say)) + 2
            if upright:
                left, right = (1.0, room) if x >= start[0] else (room, 1.0)
                yield x, (start[1] + end[1]) / 2, left, right, 0.5, 0.5
            else:
                yield (start[0] + end[0]) / 2, y, room / 2, room / 2, 0.5, 0.5


def words_of(mark: Words | Dimension, say: Language) -> str:
    """What a word or a dimension says."""
    if isinstance(mark, Words):
        return say(mark.text)
    if mark.label:
        return say(mark.label)
    length = mark.end[1] - mark.start[1] if mark.upright else mark.end[0] - mark.start[0]
    return ("Ø " if mark.diameter else "") + say.part(Amount(abs(length) * 1000, "mm"))
