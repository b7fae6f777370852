# SPDX-License-Identifier: Apache-2.0
"""The sketch of a step as a figure: its pictures beside each other, each in true scale, their words where they cover
neither each other nor lines.

Areas are light greys; what fails is drawn heavier and has a ✗, what is to be heeded has a ▲.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from importlib import import_module
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from calc.draw.drawing import (
    AXIS,
    CONTEXT,
    DIMENSIONS,
    HIDDEN,
    OUTLINE,
    Arc,
    Area,
    Dimension,
    Mark,
    Point,
    Polyline,
    Sketch,
    State,
    Words,
)
from calc.locale import Language
from calc.sheet.check import SIGNS
from calc.sheet.step import OF_SHAFTS, Outcome, Step
from calc.sheet.text import Amount, Text

from ..context import Context
from ..typesetting.boxes import BLACK, GREY, Colour
from ..typesetting.fonts import BOLD, LEFT, WIDTH
from ..typesetting.pagination import Block, Picture
from ..typesetting.prose import NOTE, STRONG, Style, lines, one_line
from ..typesetting.tags import CAPTION, FIGURE, Tag
from .labels import FREE, Label, placed
from .spoken import read_out, with_state

if TYPE_CHECKING:
    from ..typesetting.pen import Pen

HIGH = 118.0  # at most, of a row of pictures; where shafts stand below each other of each of them
BETWEEN = 18.0  # of two pictures
ABREAST, PAIRED, APART = 4, 2, 8.0  # pictures in a row, and of a figure of their own; between two rows
LETTERS = Style(7.5, 9.2)
FAINT_LETTERS = Style(7.5, 9.2, colour=GREY)
SIGN = Style(9.0, 9.6, BOLD)
WIDEST = 170.0  # of a word
PIECES = 60  # of a whole circle
TICK, TIP = 2.2, 5.0  # half a dimension's tick, an arrow's head
LINES: dict[str, tuple[float, Colour, tuple[float, ...]]] = {  # layer → thickness, colour, dashes
    OUTLINE: (0.75, BLACK, ()),
    CONTEXT: (0.5, (0.5, 0.5, 0.5), ()),
    AXIS: (0.4, GREY, (8.0, 2.0, 1.5, 2.0)),
    HIDDEN: (0.6, GREY, (3.0, 2.0)),
    DIMENSIONS: (0.35, GREY, ()),
}
HEAVY: dict[State, float] = {"": 1.0, "warn": 1.5, "fail": 2.2}  # times a line's thickness
DARK = 0.55  # how dark a full shade is


def sketch_figure(context: Context, step: Step, outcome: Outcome[object]) -> list[Block]:
    """The pictures of a solved step, each with its number and its notes; nothing where there is nothing to draw."""
    if outcome.state != "solved" or outcome.result is None:
        return []
    results = context.original or context.results
    sketch: Sketch = import_module(f"calc.{step.key}.sketch").sketch(context.design, results)
    parts = [part for part in (sketch, *sketch.beside) if part.primitives]
    if context.shaft or (context.shafts and step.key in OF_SHAFTS):  # what shows all of them stands once
        parts = [part for part in parts if bool(part.of_all) is not bool(context.shaft)]
    if not parts:
        return []
    captions = dict.fromkeys(part.caption for part in parts)
    return [
        _figure(
            context,
            [part for part in parts if part.caption == own],
            context.say(own) if own else context.title(step),
        )
        for own in captions
    ]


def _figure(context: Context, parts: list[Sketch], title: str) -> Block:
    context.figures += 1
    title = f"{context.shaft}: {title}" if context.shaft else title
    caption = f"{context.words['figure']} {context.figures}. {title}"
    notes = "; ".join(dict.fromkeys(context.say(note) for part in parts for note in part.notes))
    abreast = PAIRED if any(part.caption for part in parts) else ABREAST
    pictures = [_Picture(part, context.say) for part in parts]
    return _rows(pictures, caption + (f" ({notes})" if notes else ""), abreast)


class _Row:
    """Pictures side by side, as high as the width of the page allows."""

    def __init__(self, pictures: list[_Picture]) -> None:
        self.pictures = pictures
        room = WIDTH - BETWEEN * (len(pictures) - 1)
        low, high = 10.0, HIGH * max(1, *(picture.of_all for picture in pictures))
        if sum(picture.width(high) for picture in pictures) > room:
            for _ in range(12):
                middle = (low + high) / 2
                low, high = (
                    (middle, high) if sum(picture.width(middle) for picture in pictures) <= room else (low, middle)
                )
            high = low
        self.scales = [picture.scale(high) for picture in pictures]
        self.widths = [picture.width(high) for picture in pictures]
        self.apart = BETWEEN + (room - sum(self.widths)) / len(pictures)
        self.titled = NOTE.leading + 2.0 if any(picture.title for picture in pictures) else 0.0
        self.drawn = max(picture.height(scale) for picture, scale in zip(pictures, self.scales))

    @property
    def height(self) -> float:
        return self.titled + self.drawn

    def draw(self, pen: Pen, y: float) -> None:
        x = (self.apart - BETWEEN) / 2
        for picture, width, scale in zip(self.pictures, self.widths, self.scales):
            if picture.title:
                title = one_line(picture.title, NOTE, width + self.apart - 4.0)
                pen.put(title, x + (width - title.width) / 2, y - 0.78 * NOTE.leading)
            picture.draw(pen, x, y - self.height, (width, self.drawn), scale)
            x += width + self.apart


def _rows(pictures: list[_Picture], caption: str, abreast: int) -> Block:
    """One row of pictures, or several where there are many, above their caption."""
    count = math.ceil(len(pictures) / abreast)
    across = math.ceil(len(pictures) / count)
    rows = [_Row(pictures[n : n + across]) for n in range(0, len(pictures), across)]
    under = lines(caption, STRONG, WIDTH, 3)

    def draw(pen: Pen, y: float) -> None:
        for row in rows:
            row.draw(pen, y)
            y -= row.height + APART
        with pen.tagged(Tag(CAPTION, tag)):
            for i, line in enumerate(under):
                pen.put(line, 0.0, y + APART - 5.0 - (i + 0.78) * STRONG.leading)

    below = len(under) * STRONG.leading
    tag = Tag(FIGURE, alt=f"{caption}. {' '.join(filter(None, (picture.told for picture in pictures)))}".strip())
    high = sum(row.height for row in rows) + APART * (len(rows) - 1) + 5.0 + below
    return Block(high, draw, gap=6.0, content=Picture((caption,), below), tag=tag)


class _Picture:
    """One picture: its lines in its own units, its words with their places."""

    def __init__(self, sketch: Sketch, say: Language) -> None:
        self.title = say(sketch.title) if sketch.title else ""
        self.marks, self.of_all = sketch.primitives, sketch.of_all
        self.left, self.low, self.right, self.top = sketch.box
        self.labels = list(_labels(sketch, say))
        words = read_out(with_state(say(mark.text), mark.state, say) for mark in self.marks if isinstance(mark, Words))
        self.told = f"{': '.join(filter(None, (self.title, ', '.join(words))))}." if words else ""

    def scale(self, high: float) -> float:
        """Points of the page for a unit of the picture, so that it and its words are no higher than this, and no wider
        than the page."""
        low, up = 0.0, min(high / max(self.top - self.low, 1e-12), WIDTH / max(self.right - self.left, 1e-12))
        for _ in range(14):
            middle = (low + up) / 2
            fits = self.height(middle) <= high and self._wide(middle) <= WIDTH
            low, up = (middle, up) if fits else (low, middle)
        return low

    def width(self, high: float) -> float:
        return self._wide(self.scale(high))

    def height(self, scale: float) -> float:
        _, low, _, top = self._extent(scale)
        return top - low

    def _wide(self, scale: float) -> float:
        left, _, right, _ = self._extent(scale)
        return right - left

    def _extent(self, scale: float) -> tuple[float, float, float, float]:
        """Left, lower, right and upper end, with all words, in points from the picture's origin."""
        corners = [
            (self.left * scale, self.low * scale, self.right * scale, self.top * scale),
            *(label.box(scale) for label in self.labels),
        ]
        lefts, lows, rights, tops = zip(*corners)
        return min(lefts) - 1.0, min(lows) - 1.0, max(rights) + 1.0, max(tops) + 1.0

    def draw(self, pen: Pen, x: float, y: float, size: tuple[float, float], scale: float) -> None:
        """Into a room of this size with its lower left corner here."""
        left, low, _, top = self._extent(scale)
        dx, dy = LEFT + x - left, y - low + (size[1] - (top - low)) / 2

        def at(point: Point) -> Point:
            return dx + scale * point[0], dy + scale * point[1]

        strokes: list[list[Point]] = []
        for area in (mark for mark in self.marks if isinstance(mark, Area)):
            grey = 1 - DARK * min(1.0, area.shade)
            pen.shape([[at(point) for point in outline] for outline in area.outlines], (grey, grey, grey))
        for mark in self.marks:
            for path in _paths(mark):
                points = [at(point) for point in path]
                thick, colour, dashes = LINES.get(mark.layer, LINES[DIMENSIONS])
                pen.line(points, thick * HEAVY[mark.state], BLACK if mark.state else colour, dashes)
                strokes.append(points)
            if isinstance(mark, Polyline) and mark.arrow:
                _tip(pen, at(mark.points[-2]), at(mark.points[-1]), mark)
            if isinstance(mark, Dimension):
                for a, b in _ends(mark):
                    px, py = at((a, b))
                    pen.line([(px - TICK, py - TICK), (px + TICK, py + TICK)], 0.5, GREY)
        pieces = np.array([(*a, *b) for path in strokes for a, b in pairwise(path)]).reshape(-1, 4)
        frame = (LEFT + x - FREE, y, LEFT + x + size[0] + FREE, y + size[1])
        for box, (bx, by), clear in placed([label.moved(scale, dx, dy) for label in self.labels], pieces, frame):
            if not clear:
                pen.panel(
                    bx - LEFT - 0.8, by - 0.24 * LETTERS.size, box.width + 1.6, 0.98 * LETTERS.size, (1.0, 1.0, 1.0)
                )
            pen.put(box, bx - LEFT, by)


def _labels(sketch: Sketch, say: Language) -> Iterator[Label]:
    """The words and numbers of a picture, those of dimensions first; the sign of a part that is not as it should be
    stands once."""
    signed: set[tuple[str, str]] = set()
    marks = sorted(sketch.primitives, key=lambda mark: not isinstance(mark, Dimension))
    for mark in marks:
        if isinstance(mark, Dimension):
            yield _number(mark, say)
        elif isinstance(mark, Words):
            words = say(mark.text)
            if mark.state:
                words = f"{SIGNS[mark.state]} {words}"
                signed.add((mark.key, mark.state))
            style = FAINT_LETTERS if mark.layer in (CONTEXT, HIDDEN) else LETTERS
            yield Label(one_line(words, style, WIDEST), mark.at, mark.side)
    for mark in marks:
        if mark.state and (mark.key, mark.state) not in signed and not isinstance(mark, Words):
            signed.add((mark.key, mark.state))
            yield Label(one_line(SIGNS[mark.state], SIGN, WIDEST), _middle(mark), "centre")


def _number(mark: Dimension, say: Language) -> Label:
    (x, y), (x_2, y_2) = _ends(mark)
    n = 1 if mark.upright else 0
    words = (
        say(mark.label)
        if mark.label
        else say(Text("{length}", length=Amount(round(abs(mark.end[n] - mark.start[n]) * 1e3, 2))))
    )
    return Label(one_line(words, LETTERS, WIDEST), ((x + x_2) / 2, (y + y_2) / 2), "left" if mark.upright else "above")


def _ends(mark: Dimension) -> tuple[Point, Point]:
    """Of the dimension line."""
    x, y = mark.line
    if mark.upright:
        return (x, mark.start[1]), (x, mark.end[1])
    return (mark.start[0], y), (mark.end[0], y)


def _paths(mark: Mark) -> Iterator[list[Point]]:
    """The lines of a mark."""
    match mark:
        case Polyline(points=points, closed=closed):
            yield [*points, points[0]] if closed else list(points)
        case Arc(centre=(x, y), radius=r, start=start, end=end):
            n = max(6, math.ceil(PIECES * abs(end - start) / (2 * math.pi)))
            turns = [start + (end - start) * i / n for i in range(n + 1)]
            yield [(x + r * math.cos(t), y + r * math.sin(t)) for t in turns]
        case Dimension(start=start, end=end):
            ends = _ends(mark)
            yield from ([point, foot] for point, foot in zip((start, end), ends) if point != foot)
            yield list(ends)


def _middle(mark: Mark) -> Point:
    points = mark.outlines[0] if isinstance(mark, Area) else next(_paths(mark))
    xs, ys = zip(*points)
    return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2


def _tip(pen: Pen, tail: Point, tip: Point, mark: Polyline) -> None:
    """The head of an arrow."""
    length = math.dist(tail, tip)
    if not length:
        return
    x, y = (tip[0] - tail[0]) / length, (tip[1] - tail[1]) / length
    long = min(TIP, length)
    foot = tip[0] - x * long, tip[1] - y * long
    half = 0.32 * long
    colour = BLACK if mark.state else LINES.get(mark.layer, LINES[DIMENSIONS])[1]
    pen.area([tip, (foot[0] - y * half, foot[1] + x * half), (foot[0] + y * half, foot[1] - x * half)], colour)
