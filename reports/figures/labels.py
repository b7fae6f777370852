# SPDX-License-Identifier: Apache-2.0
"""The names of lines and limits at their ends, and the value where the design stands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from math import isfinite
from typing import Any

import numpy as np

from calc.sheet.step import Curve, Series

from ..setting.boxes import GREY, Box
from ..setting.fonts import BOLD
from ..labels import crossed, meet
from .plots import LETTER, RIGHT_AXIS, Plots, limit_words, limits, numbers, series_label, y_unit
from ..setting.prose import Style, lines

OVER, UNDER = 0.72 * LETTER.size, 0.24 * LETTER.size  # what letters take over and under their base line
WIDEST = 150.0  # of a name
ASIDE = 14.0  # from the axes to the names on their right
NEAR = 6.0  # a value so near to a line could be taken for a name of it
VALUE = Style(LETTER.size, LETTER.leading, BOLD)
COVERED, CROSSED, CLOSE, FAR = 20.0, 10.0, 3.0, 0.5  # costs: over the mark, for each line across, near one, for each point further off
BESIDE, REACH = 12.0, 30.0  # from the mark to a value beside it, and to the farthest place for one

Placed = tuple[Box, float, float]


def margin(curve: Curve, plots: Plots) -> float:
    """What the names need on the right of a figure."""
    widths = [box.width for box in _boxes(curve, plots)]
    return ASIDE + max(widths) + 2.0 if widths else RIGHT_AXIS


def at_the_ends(axes: Any, curve: Curve, plots: Plots) -> list[Placed]:
    """The names right of the axes, each led to the end of its line, with their places from the figure's corner; and the value."""
    named = [series for _, series in _names(curve)]
    return at_the_point(axes, curve, plots) + _at_the_right(axes, _boxes(curve, plots), _paths(axes, curve, named))


def at_the_point(axes: Any, curve: Curve, plots: Plots) -> list[Placed]:
    """What the curve is where the design stands, beside the mark of it: not outside, not over the mark, not across a line if it can.

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
        return min(((a, b) for a, b in spots if frame.x0 <= a <= right and frame.y0 + UNDER <= b <= top), key=cost, default=None)

    sides, middle = (x - 7.0 - box.width, x + 7.0), x - box.width / 2
    beside = [(a, y + dy) for a in sides for dy in (5.0, -0.36 * LETTER.size, -10.0)] + [(middle, y + dy) for dy in (8.0, -14.0)]
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
    from matplotlib.transforms import IdentityTransform

    ends = [
        (*path[np.isfinite(path).all(axis=1)][-1].tolist(), box) for path, box in zip(paths, boxes) if np.isfinite(path).all(axis=1).any()
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
