# SPDX-License-Identifier: Apache-2.0
"""A curve of the sheet as a figure: one style, readable in grey print.

Lines differ by their pattern as well as by their colour, bars by their grey.  Over the page's whole width lines bear their names; else the
legend stands above the axes where it can hide nothing.  A locus is drawn in true scale.  All variants of a curve stand in one figure; two
of many lines stand beside each other.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from calc.sheet.step import Curve
from calc.sheet.text import COMMA, EMPTY

from ..content import Picture
from ..setting.flow import Block
from .legend import draw_legend, legend
from .labels import at_the_ends, margin
from ..paper import WIDTH
from .plots import ALONE, HIGH, LEFT_AXIS, LETTER, LOW, RIGHT_AXIS, Look, Plots, in_words, numbers
from ..setting.prose import STRONG, lines
from ..stacked import Stack
from ..setting.tags import FIGURE, Tag
from .tornado import Lying, lies

if TYPE_CHECKING:
    from ..setting.pen import Pen

GUTTER = 16.0
PART = (WIDTH - GUTTER) / 2
TALL, LOW_AXES, SQUARE = 128.0, 92.0, 160.0  # height of the axes: beside another, over the whole width, in true scale
FLAT, ROOM = 2.0, 1.2  # width over height from which a drawing is flat, and the room it gets around it
NAMED = 5  # lines: so many bear their names
CROWDED = 4  # lines; two variants of more are drawn apart


def figure_blocks(numbered: list[tuple[int, Curve]], word: str, plots: Plots, *, wide: bool = False) -> list[Block]:
    """Figures two beside each other, each with its number and title below; `wide`: each over the whole width, if its scale allows it,
    in the text's flow."""
    blocks = []
    stacks = {number: [c for n, c in numbered if n == number] for number, curve in numbered if curve.stack}
    curves = [part for number, curve in numbered if not curve.stack or curve is stacks[number][0] for part in _apart(number, curve)]
    n = 0
    while n < len(curves):
        row = curves[n : n + 1] if _alone(curves[n : n + 2], wide) else curves[n : n + 2]
        alone = len(row) == 1
        pair: list[_Figure | Stack] = [
            Stack(number, stacks[int(number)], word, plots) if c.stack
            else _Figure(number, c, word, plots, WIDTH if _broad(c) or (alone and not c.equal) else PART)
            for number, c in row
        ]  # fmt: skip
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
        blocks.append(Block(height, draw, gap=8.0, floats=wide, content=Picture(tuple(figure.title for figure in pair), below)))
    return blocks


def _apart(number: int, curve: Curve) -> list[tuple[str, Curve]]:
    """A curve with its number; two variants of many lines are the figures a and b, where like lines look alike."""
    if curve.equal or curve.bars or len(curve.variants) != 2 or len(curve.series) <= CROWDED:
        return [(str(number), curve)]
    made = []
    for letter, variant in zip("ab", curve.variants):
        own = tuple(replace(s, variant=EMPTY) for s in curve.series if s.variant in ("", variant))
        made.append((f"{number}{letter}", replace(curve, title=COMMA.join((curve.title, variant)), series=own, variants=())))
    return made


def _alone(two: list[tuple[str, Curve]], wide: bool) -> bool:
    """Whether the first of two figures takes a row for itself: broad ones do, and the figures a and b of one curve stay together."""
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
        self.tag = Tag(FIGURE, alt=f"{self.title}. {in_words(curve, plots)}")
        self.caption = lines(self.title, STRONG, width - LEFT_AXIS, 3)
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
            self.recording = plots.ask(curve, self.wide, self.axes + LOW + HIGH, self.look)

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
            self.recording().place(pen, x, low)
        for i, line in enumerate(self.caption):
            pen.put(line, x + LEFT_AXIS, low - (i + 0.78) * STRONG.leading)
