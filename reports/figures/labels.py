# SPDX-License-Identifier: Apache-2.0
"""The words of a figure: where they stand, the names of lines and limits at their ends, and the legend.

The value stands where the design does."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from math import isfinite
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from matplotlib.transforms import IdentityTransform

from calc.draw.drawing import Point
from calc.sheet.step import Curve, Series

from ..typesetting.boxes import BLACK, GREY, Box, Colour
from ..typesetting.fonts import BOLD, LEFT
from ..typesetting.prose import Style, lines
from .arrows import arrows, sample_arrow
from .plots import (
    EDGE,
    LETTER,
    RIGHT_AXIS,
    Plots,
    bar_colour,
    hatching,
    limit_style,
    limit_words,
    limits,
    numbers,
    series_label,
    series_style,
    y_unit,
)
from .tornado import dashed

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


# --- where words stand
# Each as near to its place as it can be without covering another one or lying across a line.

UP, DOWN = 0.74, 0.22  # of the size: what letters take above and below their base line
SIZE = 7.5
FREE = 4.0  # how far words may reach out of their picture
STEPS = 9  # rings of places around the first one
STEP = 3.2  # from ring to ring
WAYS = tuple((np.cos(t), np.sin(t)) for t in np.pi / 4 * np.array([2, 6, 0, 4, 1, 3, 5, 7]))
CROSSED_LABEL, FAR_LABEL = 6.0, 1.0  # what a line under words costs, and a ring
Side = Literal["left", "centre", "right", "above"]
Extent = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Label:
    """Words with the place that they belong to: `side` as in sketches; above: in the middle over it."""

    words: Box
    at: Point
    side: Side

    def box(self, scale: float = 1.0) -> Extent:
        x, y = self.base(scale)
        return x, y - DOWN * SIZE, x + self.words.width, y + UP * SIZE

    def base(self, scale: float = 1.0) -> Point:
        """Where its base line begins."""
        x, y = self.at[0] * scale, self.at[1] * scale
        wide = self.words.width
        back = {"left": -2.0, "centre": wide / 2, "right": wide + 2.0, "above": wide / 2}[self.side]
        return x - back, y + (DOWN * SIZE + 1.2 if self.side == "above" else -(UP - DOWN) / 2 * SIZE)

    def moved(self, scale: float, dx: float, dy: float) -> Label:
        """The same on the page."""
        return replace(self, at=(dx + scale * self.at[0], dy + scale * self.at[1]))


def placed(labels: list[Label], pieces: Any, frame: Extent) -> list[tuple[Box, Point, bool]]:
    """The words with their places, and whether no line is under them."""
    taken: list[Extent] = []
    places = []
    for label in labels:
        best: tuple[float, Extent, bool] | None = None
        for cost, box in _places(label.box(), frame):
            if best is not None and cost >= best[0]:
                break
            if any(meet(box, other) for other in taken):
                continue
            across = crossed(box, pieces)
            if best is None or cost + CROSSED_LABEL * bool(across) < best[0]:
                best = cost + CROSSED_LABEL * bool(across), box, not across
        _, box, clear = best or (0.0, label.box(), False)
        taken.append(box)
        places.append((label.words, (box[0], box[1] + DOWN * SIZE), clear))
    return places


def _places(box: Extent, frame: Extent) -> list[tuple[float, Extent]]:
    """Places for words with what they cost, the cheapest first, all within the frame."""
    places = []
    for ring in range(STEPS + 1):
        for x, y in WAYS if ring else ((0.0, 0.0),):
            dx, dy = ring * STEP * x * (1.6 if ring else 1.0), ring * STEP * y
            dx = min(max(dx, frame[0] - box[0]), frame[2] - box[2])
            dy = min(max(dy, frame[1] - box[1]), frame[3] - box[3])
            places.append((FAR_LABEL * ring, (box[0] + dx, box[1] + dy, box[2] + dx, box[3] + dy)))
    return places


def meet(box: Extent, other: Extent) -> bool:
    return box[0] < other[2] + 1.5 and other[0] < box[2] + 1.5 and box[1] < other[3] and other[1] < box[3]


def crossed(box: Extent, pieces: Any) -> bool:
    """Whether a piece of line runs through a box: its ends clipped to it leave something."""
    if not len(pieces):
        return False
    start, way = pieces[:, :2], pieces[:, 2:] - pieces[:, :2]
    low, high = np.array(box[:2]) + 0.2, np.array(box[2:]) - 0.2
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (low - start) / way, (high - start) / way
    still = way == 0
    inside = (start >= low) & (start <= high)
    first = np.where(still, np.where(inside, -np.inf, np.inf), np.minimum(a, b)).max(axis=1)
    last = np.where(still, np.where(inside, np.inf, -np.inf), np.maximum(a, b)).min(axis=1)
    return bool(np.any((first <= last) & (last >= 0) & (first <= 1)))


# --- the names of lines and limits, and the value at the design's point

OVER, UNDER = 0.72 * LETTER.size, 0.24 * LETTER.size  # what letters take over and under their base line
WIDEST = 150.0  # of a name
ASIDE = 14.0  # from the axes to the names on their right
NEAR = 6.0  # a value so near to a line could be taken for a name of it
VALUE = Style(LETTER.size, LETTER.leading, BOLD)
# costs: over the mark, for each line across, near one, for each point further off
COVERED, CROSSED, CLOSE, FAR = (20.0, 10.0, 3.0, 0.5)
BESIDE, REACH = 12.0, 30.0  # from the mark to a value beside it, and to the farthest place for one

Placed = tuple[Box, float, float]


def margin(curve: Curve, plots: Plots) -> float:
    """What the names need on the right of a figure."""
    widths = [box.width for box in _boxes(curve, plots)]
    return ASIDE + max(widths) + 2.0 if widths else RIGHT_AXIS


def at_the_ends(axes: Any, curve: Curve, plots: Plots) -> list[Placed]:
    """The names right of the axes, each led to the end of its line, with their places from the figure's corner; and the
    value."""
    named = [series for _, series in _names(curve)]
    return at_the_point(axes, curve, plots) + _at_the_right(axes, _boxes(curve, plots), _paths(axes, curve, named))


def at_the_point(axes: Any, curve: Curve, plots: Plots) -> list[Placed]:
    """What the curve is where the design stands, beside the mark of it: not outside, not over the mark, not across a
    line if it can.

    Where it lies across a line at every place beside the mark, it goes further off, to where it crosses fewest.
    """
    if curve.point is None or not all(map(isfinite, curve.point)):
        return []
    x, y = map(float, axes.transData.transform(curve.point))
    frame = axes.bbox
    box = lines(f"{plots.short(curve.point[1])} {y_unit(curve)}".strip(), VALUE, frame.width / 2, 1)[0]
    paths = [np.column_stack([path[:-1], path[1:]]) for path in _paths(axes, curve, curve.series)]
    pieces = [path[np.isfinite(path).all(axis=1)] for path in paths]

    def cost(spot: tuple[float, float]) -> float:
        a, b = spot
        words = a, b - UNDER, a + box.width, b + OVER
        around = a, b - UNDER - NEAR, a + box.width, b + OVER + NEAR
        over = COVERED * meet(words, (x - 4, y - 4, x + 4, y + 4))
        across = sum(crossed(words, some) for some in pieces)
        near = CROSSED * across or CLOSE * any(crossed(around, some) for some in pieces)
        return over + near + FAR * max(abs(b + 0.36 * LETTER.size - y) - BESIDE, 0.0)

    def best(spots: Iterable[tuple[float, float]]) -> tuple[float, float] | None:
        right, top = frame.x1 + 8.0 - box.width, frame.y1 + 1.0 - OVER
        return min(
            ((a, b) for a, b in spots if frame.x0 <= a <= right and frame.y0 + UNDER <= b <= top),
            key=cost,
            default=None,
        )

    sides, middle = (x - 7.0 - box.width, x + 7.0), x - box.width / 2
    beside = [(a, y + dy) for a in sides for dy in (5.0, -0.36 * LETTER.size, -10.0)] + [
        (middle, y + dy) for dy in (8.0, -14.0)
    ]
    spot = best(beside)
    if spot is not None and cost(spot) >= CROSSED:
        spot = best([spot, *((a, y + dy) for a in (*sides, middle) for dy in np.arange(-REACH, REACH).tolist())])
    return [(box, *spot)] if spot is not None else []


def _paths(axes: Any, curve: Curve, some: Iterable[Series]) -> list[Any]:
    """Lines, then limits, in points."""
    named = [(numbers(series.x), numbers(series.y)) for series in some]
    ends = np.array(axes.get_xlim())
    named += [(ends, np.full(2, value)) for _, value in limits(curve)]
    return [axes.transData.transform(np.column_stack(pair)) for pair in named]


def _at_the_right(axes: Any, boxes: list[Box], paths: list[Any]) -> list[Placed]:
    """Names under each other in the order of the ends of their lines, as near to them as they can be."""
    ends = [
        (*path[np.isfinite(path).all(axis=1)][-1].tolist(), box)
        for path, box in zip(paths, boxes)
        if np.isfinite(path).all(axis=1).any()
    ]
    ends.sort(key=lambda end: end[1])
    heights = [y for _, y, _ in ends]
    step = 1.1 * LETTER.size
    for _ in range(60):  # neighbours push each other apart
        for i, (low, high) in enumerate(pairwise(heights)):
            if (short_of := step - (high - low)) > 0.01:
                heights[i : i + 2] = low - short_of / 2, high + short_of / 2
    right = axes.bbox.x1
    for (x, y, _), height in zip(ends, heights):
        way = ((x + 1.0, right + 2.0, right + ASIDE - 4.0, right + ASIDE - 2.0), (y, y, height, height))
        axes.plot(*way, color=GREY, lw=0.4, transform=IdentityTransform(), clip_on=False)
    return [(box, right + ASIDE, height - 0.36 * LETTER.size) for (_, _, box), height in zip(ends, heights)]


def _boxes(curve: Curve, plots: Plots) -> list[Box]:
    """The names of lines, then those of limits with their values."""
    names = [label for label, _ in _names(curve)] + limit_words(curve, plots)
    return [lines(name, LETTER, WIDEST, 1)[0] for name in names]


def _names(curve: Curve) -> Iterator[tuple[str, Any]]:
    return ((label, series) for series in curve.series if (label := series_label(curve, series)))


# --- the legend: samples of lines, bars and arrows, each with what it shows

SAMPLE = 20.0  # width of a legend's sample

Sample = Callable[["Pen", float, float], None]  # draws it at a place: from the left margin, height of its middle
Legend = list[list[tuple[Sample, Box]]]  # its rows


def legend(curve: Curve, space: float, plots: Plots) -> Legend:
    """The legend's rows: sample and label."""
    named: list[tuple[Sample, Box]] = []
    for i, series in enumerate(curve.series):
        if label := series_label(curve, series):
            named.append(
                (_bar_sample(i) if curve.bars else _line_sample(*series_style(curve, i)), _label(label, space))
            )
    for i, label in enumerate(limit_words(curve, plots)):
        named.append((_line_sample(*limit_style(i)), _label(label, space)))
    for arrow in {a.number: a for a in arrows(curve)}.values():
        named.append(
            (lambda pen, x, y: sample_arrow(pen, x, y, SAMPLE), _label(f"{arrow.number}  {arrow.name}", space))
        )
    rows: Legend = [[]]
    filled = 0.0
    for sample, box in named:
        wide = SAMPLE + 4.0 + box.width + 12.0
        if rows[-1] and filled + wide - 12.0 > space:
            rows.append([])
            filled = 0.0
        rows[-1].append((sample, box))
        filled += wide
    return rows if rows[0] else []


def draw_legend(pen: Pen, rows: Legend, x: float, top: float) -> None:
    """Draw it from the left margin `x` and the base `top` of its first row."""
    for i, entries in enumerate(rows):
        at, base = x, top - i * LETTER.leading
        for sample, box in entries:
            sample(pen, at, base + 2.2)
            pen.put(box, at + SAMPLE + 4.0, base)
            at += SAMPLE + 4.0 + box.width + 12.0


def _label(words: str, space: float) -> Box:
    return lines(words, LETTER, space - SAMPLE - 6.0, 1)[0]


def _line_sample(colour: Colour, dashes: tuple[float, ...], thick: float) -> Sample:
    """A piece of line as long as a legend needs, in dashes."""

    def draw(pen: Pen, x: float, y: float) -> None:
        dashed(pen, (LEFT + x, y), (LEFT + x + SAMPLE, y), (colour, dashes, thick))

    return draw


def _bar_sample(i: int) -> Sample:
    """A box filled like the bars of the i-th series."""
    high = 6.0

    def draw(pen: Pen, x: float, y: float) -> None:
        left, low = LEFT + x, y - high / 2
        pen.panel(x, low, SAMPLE, high, bar_colour(i))
        edge = [(left, low), (left + SAMPLE, low), (left + SAMPLE, low + high), (left, low + high), (left, low)]
        for line in [*hatching(i, left, low, SAMPLE, high), edge]:
            pen.line(line, EDGE, BLACK)

    return draw
