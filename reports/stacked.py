# SPDX-License-Identifier: Apache-2.0
"""Curves along one x over each other as one figure: the loaded shaft as a sketch, then what the loads do in it."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from calc.sheet.step import Curve

from .figures.arrows import ARROW, head
from .setting.boxes import GREY
from .labels import Label, placed
from .figures.legend import draw_legend, legend
from .figures.labels import at_the_point
from .paper import LEFT, WIDTH
from .figures.plots import HIGH, LEFT_AXIS, LETTER, LOW, RIGHT_AXIS, Look, Plots, in_words, numbers
from .setting.prose import STRONG, lines, run
from .setting.tags import FIGURE, Tag

if TYPE_CHECKING:
    from .setting.pen import Pen

PANEL, NAME = 44.0, 13.0  # height of the axes of one curve, and of its name over them
BODY, FORCE, LEAST = 14.0, 24.0, 9.0  # half the height of the sketched shaft; length of the longest and of the shortest arrow
BETWEEN = 2.0  # from the shaft to an arrow
SHADE = (0.85, 0.85, 0.85)
AXIS = (8.0, 2.0, 1.5, 2.0)
SKETCH = 2 * (BODY + BETWEEN + FORCE) + 4.0


class Stack:
    """The figure, laid out before anything is drawn.  It takes the page's width."""

    def __init__(self, number: str, curves: list[Curve], word: str, plots: Plots) -> None:
        self.curves, self.plots = curves, plots
        self.legend: list[Any] = []  # of a figure beside it, of which there is none
        self.rows = 0
        self.title = f"{word} {number}. {curves[0].title}"
        self.tag = Tag(FIGURE, alt=f"{self.title}. {'; '.join(in_words(curve, plots) for curve in curves)}")
        self.caption = lines(self.title, STRONG, WIDTH - LEFT_AXIS, 3)
        xs = np.concatenate([numbers(series.x) for curve in curves for series in curve.series])
        xs = xs[np.isfinite(xs)]
        self.ends = (float(xs.min()), float(xs.max())) if xs.size else (0.0, 1.0)
        self.under = len(self.caption) * STRONG.leading
        self.height = sum(map(_height, curves)) + LOW + self.under
        looks = [Look(at_the_point, ends=self.ends, lowest=curve is curves[-1]) for curve in curves]
        self.panels = [None if curve.loads else plots.ask(curve, WIDTH, LOW + PANEL + HIGH, look) for curve, look in zip(curves, looks)]

    def draw(self, pen: Pen, x: float, y: float) -> None:
        for curve, panel in zip(self.curves, self.panels):
            named = x + LEFT_AXIS + run(curve.y_label, LETTER).width + 14.0
            if sum(bool(series.label) for series in curve.series) > 1 and not curve.loads:
                draw_legend(pen, legend(curve, x + WIDTH - named, self.plots), named, y - NAME - HIGH + 2.5)
            y -= _height(curve)
            if panel is None:
                self._sketch(pen, curve, x, y + SKETCH / 2)
            else:
                panel().place(pen, x, y - LOW)
        for i, line in enumerate(self.caption):
            pen.put(line, x + LEFT_AXIS, y - LOW - (i + 0.78) * STRONG.leading)

    def _sketch(self, pen: Pen, curve: Curve, x: float, middle: float) -> None:
        """The shaft flattened to a strip, its loads as arrows that pull at it, and those of its bearings, which push."""
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
            labels.append(Label(run(f"{load.label} {self.plots.short(abs(load.size))} {curve.load_unit}", LETTER), far, "right"))
        pieces = np.array([(*a, *b) for a, b in strokes])
        frame = LEFT + x + LEFT_AXIS, middle - SKETCH / 2, LEFT + x + WIDTH, middle + SKETCH / 2
        for box, (a, b), _ in placed(labels, pieces, frame):
            pen.put(box, a - LEFT, b)


def _height(curve: Curve) -> float:
    return SKETCH if curve.loads else NAME + PANEL + HIGH
