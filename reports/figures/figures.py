# SPDX-License-Identifier: Apache-2.0
"""Curves of the sheet as figures of the page: one style, readable in grey print, alone or over each other.

Lines differ by their pattern as well as by their colour, bars by their grey.  Over the page's whole width lines bear
their names; else the legend stands above the axes where it can hide nothing.  A locus is drawn in true scale.  All
variants of a curve stand in one figure; two of many lines stand beside each other."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from calc.sheet.step import Curve
from calc.sheet.text import COMMA, EMPTY

from ..typesetting.boxes import GREY
from ..typesetting.fonts import LEFT, WIDTH
from ..typesetting.pagination import Block, Picture
from ..typesetting.prose import STRONG, lines, run
from ..typesetting.tags import CAPTION, FIGURE, Tag
from .arrows import ARROW, head
from .labels import Label, at_the_ends, at_the_point, draw_legend, legend, margin, placed
from .plots import ALONE, HIGH, LEFT_AXIS, LETTER, LOW, RIGHT_AXIS, Look, Plots, numbers, plot
from .spoken import in_words
from .tornado import Lying, lies

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


# --- curves along one x over each other as one figure
# The loaded shaft as a sketch, then what the loads do in it.

PANEL, NAME = 44.0, 13.0  # height of the axes of one curve, and of its name over them
# half the height of the sketched shaft; length of the longest and of the shortest arrow
BODY, FORCE, LEAST = (14.0, 24.0, 9.0)
BETWEEN = 2.0  # from the shaft to an arrow
SHADE = (0.85, 0.85, 0.85)
AXIS = (8.0, 2.0, 1.5, 2.0)
BESIDE = 0.03  # of the width: room at either end of what was measured
SKETCH = 2 * (BODY + BETWEEN + FORCE) + 4.0


class Stack:
    """The figure, laid out before anything is drawn.  It takes the page's width."""

    def __init__(self, number: str, curves: list[Curve], word: str, plots: Plots) -> None:
        self.curves, self.plots = curves, plots
        self.legend: list[Any] = []  # of a figure beside it, of which there is none
        self.rows = 0
        self.title = f"{word} {number}. {curves[0].title}"
        self.tag = Tag(FIGURE, alt=f"{self.title}. {'. '.join(in_words(curve, plots.say) for curve in curves)}.")
        self.caption = lines(self.title, STRONG, WIDTH - LEFT_AXIS, 3)
        xs = np.concatenate([numbers(series.x) for curve in curves for series in curve.series])
        xs = xs[np.isfinite(xs)]
        self.ends = (float(xs.min()), float(xs.max())) if xs.size else (0.0, 1.0)
        if self.ends[0] == self.ends[1]:  # one speed
            self.ends = (0.9 * self.ends[0], 1.1 * self.ends[1])
        elif any(curve.measured is not None for curve in curves):  # points stand inside the frame
            room = BESIDE * (self.ends[1] - self.ends[0])
            self.ends = (self.ends[0] - room, self.ends[1] + room)
        self.under = len(self.caption) * STRONG.leading
        self.height = sum(map(_height, curves)) + LOW + self.under
        looks = [Look(at_the_point, ends=self.ends, lowest=curve is curves[-1]) for curve in curves]
        self.panels = [
            None if curve.loads else plot(plots, curve, WIDTH, LOW + _panel(curve) + HIGH, look)
            for curve, look in zip(curves, looks)
        ]

    def draw(self, pen: Pen, x: float, y: float) -> None:
        for curve, panel in zip(self.curves, self.panels):
            named = x + LEFT_AXIS + run(curve.y_label, LETTER).width + 14.0
            if sum(bool(series.label) for series in curve.series) > 1 and not curve.loads:
                draw_legend(pen, legend(curve, x + WIDTH - named, self.plots), named, y - NAME - HIGH + 2.5)
            y -= _height(curve)
            if panel is None:
                self._sketch(pen, curve, x, y + SKETCH / 2)
            else:
                panel.place(pen, x, y - LOW)
        with pen.tagged(Tag(CAPTION, self.tag)):
            for i, line in enumerate(self.caption):
                pen.put(line, x + LEFT_AXIS, y - LOW - (i + 0.78) * STRONG.leading)

    def _sketch(self, pen: Pen, curve: Curve, x: float, middle: float) -> None:
        """The shaft flattened to a strip, its loads as arrows that pull at it, and those of its bearings, which
        push."""
        left, scale = LEFT + x + LEFT_AXIS, (WIDTH - LEFT_AXIS - RIGHT_AXIS) / (self.ends[1] - self.ends[0])
        tall = max(float(np.nanmax(np.abs(numbers(series.y)))) for series in curve.series)

        def at(a: float, b: float) -> tuple[float, float]:
            return left + scale * (a - self.ends[0]), middle + BODY / tall * b

        outline, axis = ([at(*p) for p in zip(numbers(s.x).tolist(), numbers(s.y).tolist())] for s in curve.series[:2])
        pen.shape([outline], SHADE)
        pen.line(outline, 0.5, GREY)
        pen.line(axis, 0.4, GREY, AXIS)
        strokes, labels = [*pairwise(outline)], []
        largest = max(abs(load.size) for load in curve.loads)
        for load in curve.loads:
            up = 1.0 if load.size > 0 else -1.0
            length = max(FORCE * abs(load.size) / largest, LEAST)
            side = -up if load.held else up  # a load pulls at the shaft from outside, a support pushes
            near = at(load.x, 0.0)[0], middle + side * (BODY + BETWEEN)
            far = near[0], near[1] + side * length
            tail, tip = (far, near) if load.held else (near, far)
            neck, corners = head(tail, tip)
            pen.line([tail, neck], 1.1, ARROW)
            pen.area(corners, ARROW)
            strokes.append((tail, tip))
            labels.append(
                Label(run(f"{load.label} {self.plots.short(abs(load.size))} {curve.load_unit}", LETTER), far, "right")
            )
        pieces = np.array([(*a, *b) for a, b in strokes])
        frame = LEFT + x + LEFT_AXIS, middle - SKETCH / 2, LEFT + x + WIDTH, middle + SKETCH / 2
        for box, (a, b), _ in placed(labels, pieces, frame):
            pen.put(box, a - LEFT, b)


def _height(curve: Curve) -> float:
    return SKETCH if curve.loads else NAME + _panel(curve) + HIGH


def _panel(curve: Curve) -> float:
    """Height of the axes: what was measured stands on a tall one, its residuals below it on one as low as others."""
    return LOW_AXES if curve.measured is not None and curve.series[0].label else PANEL


# --- the figures

GUTTER = 16.0
PART = (WIDTH - GUTTER) / 2
TALL, LOW_AXES, SQUARE = 128.0, 92.0, 160.0  # height of the axes: beside another, over the whole width, in true scale
FLAT, ROOM = 2.0, 1.2  # width over height from which a drawing is flat, and the room it gets around it
NAMED = 5  # lines: so many bear their names
CROWDED = 4  # lines; two variants of more are drawn apart


def figure_blocks(numbered: list[tuple[int, Curve]], word: str, plots: Plots, *, wide: bool = False) -> list[Block]:
    """Figures two beside each other, each with its number and title below; `wide`: each over the whole width, if its
    scale allows it, in the text's flow."""
    blocks = []
    stacks = {number: [c for n, c in numbered if n == number] for number, curve in numbered if curve.stack}
    curves = [
        part
        for number, curve in numbered
        if not curve.stack or curve is stacks[number][0]
        for part in _apart(number, curve)
    ]
    n = 0
    while n < len(curves):
        row = curves[n : n + 1] if _alone(curves[n : n + 2], wide) else curves[n : n + 2]
        alone = len(row) == 1
        pair: list[_Figure | Stack] = [
            Stack(number, stacks[int(number)], word, plots)
            if c.stack
            else _Figure(number, c, word, plots, WIDTH if _broad(c) or (alone and not c.equal) else PART)
            for number, c in row
        ]
        n += len(row)
        above = max(len(f.legend) for f in pair)
        for figure in pair:
            figure.rows = above  # so that the axes of neighbours stand level
        height = max(f.height for f in pair)

        def draw(pen: Pen, y: float, pair: list[_Figure | Stack] = pair) -> None:
            for i, figure in enumerate(pair):
                with pen.tagged(figure.tag):
                    figure.draw(pen, i * (PART + GUTTER), y)

        below = min(height - figure.height + figure.under for figure in pair)
        blocks.append(
            Block(height, draw, gap=8.0, floats=wide, content=Picture(tuple(figure.title for figure in pair), below))
        )
    return blocks


def _apart(number: int, curve: Curve) -> list[tuple[str, Curve]]:
    """A curve with its number; two variants of many lines are the figures a and b, where like lines look alike."""
    if curve.equal or curve.bars or len(curve.variants) != 2 or len(curve.series) <= CROWDED:
        return [(str(number), curve)]
    curves = []
    for letter, variant in zip("ab", curve.variants):
        series = tuple(replace(s, variant=EMPTY) for s in curve.series if s.variant in ("", variant))
        curves.append(
            (f"{number}{letter}", replace(curve, title=COMMA.join((curve.title, variant)), series=series, variants=()))
        )
    return curves


def _alone(two: list[tuple[str, Curve]], wide: bool) -> bool:
    """Whether the first of two figures takes a row for itself: broad ones do, and the figures a and b of one curve stay
    together."""
    if wide and not two[0][0].endswith("a") and not all(curve.equal for _, curve in two):
        return True
    return len(two) < 2 or any(_broad(curve) for _, curve in two) or two[1][0].endswith("a")


def _broad(curve: Curve) -> bool:
    """Whether a figure takes the page's whole width whatever stands beside it."""
    return bool(curve.stack) or lies(curve) or _flat(curve)


def _flat(curve: Curve) -> bool:
    """Whether a figure in true scale is so much wider than high that it takes the page's whole width."""
    return curve.equal and _ratio(curve) > FLAT


def _ratio(curve: Curve) -> float:
    """Width over height of what is drawn."""
    wide, high = (np.ptp(np.concatenate([numbers(getattr(s, axis)) for s in curve.series])) for axis in ("x", "y"))
    return float(wide / high) if high > 0 else 1.0


class _Figure:
    """One figure with its legend and caption, laid out before anything is drawn."""

    def __init__(self, number: str, curve: Curve, word: str, plots: Plots, width: float) -> None:
        self.title = f"{word} {number}. {curve.title}"
        self.tag = Tag(FIGURE, alt=f"{self.title}. {in_words(curve, plots.say)}.")
        self.caption = lines(self.title, STRONG, width - LEFT_AXIS, 4)
        named = width == WIDTH and not (curve.equal or curve.bars or curve.variants) and len(curve.series) <= NAMED
        self.look = Look(at_the_ends, margin(curve, plots)) if named else ALONE
        self.legend = [] if self.look.named else legend(curve, width - LEFT_AXIS, plots)
        self.rows = len(self.legend)
        self.axes = SQUARE if curve.equal else TALL if width < WIDTH else LOW_AXES
        self.wide = LEFT_AXIS + SQUARE + RIGHT_AXIS if curve.equal else width
        if _flat(curve):
            self.axes, self.wide = ROOM * (width - LEFT_AXIS - RIGHT_AXIS) / _ratio(curve), width
        self.lying = Lying(curve, width, plots) if lies(curve) else None
        if self.lying is not None:
            self.axes = self.lying.height
        else:
            self.recording = plot(plots, curve, self.wide, self.axes + LOW + HIGH, self.look)

    @property
    def legend_height(self) -> float:
        return self.rows * LETTER.leading + 3.0

    @property
    def height(self) -> float:
        return self.legend_height + HIGH + self.axes + LOW + self.under

    @property
    def under(self) -> float:
        """What the caption takes."""
        return len(self.caption) * STRONG.leading

    def draw(self, pen: Pen, x: float, y: float) -> None:
        top = y - LETTER.leading * (self.rows - len(self.legend) + 0.78)
        draw_legend(pen, self.legend, x + LEFT_AXIS, top)
        low = y - self.legend_height - HIGH - self.axes - LOW
        if self.lying is not None:
            self.lying.draw(pen, x, low)
        else:
            self.recording.place(pen, x, low)
        with pen.tagged(Tag(CAPTION, self.tag)):
            for i, line in enumerate(self.caption):
                pen.put(line, x + LEFT_AXIS, low - (i + 0.78) * STRONG.leading)
