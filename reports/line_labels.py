# SPDX-License-Identifier: Apache-2.0
"""The names of lines and limits at their ends, or beside them where nothing else is near, and the value where the design stands."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import isfinite
from typing import Any

import numpy as np

from calc.sheet.step import Curve

from .boxes import GREY, Box
from .fonts import BOLD
from .labels import Extent, crossed, meet
from .plots import LETTER, RIGHT_AXIS, Plots, limit_words, limits, numbers, series_label, y_unit
from .prose import Style, lines

OVER, UNDER = 0.76 * LETTER.size, 0.2 * LETTER.size  # what letters take over and under their base line
WIDEST = 150.0  # of a name
ASIDE = 14.0  # from the axes to the names on their right
OFF = 2.2  # from a line to its name
NEAR = 6.0  # a line that is so near to another's name could be taken for its own
PLACES = np.linspace(0.02, 0.98, 33)  # of the way that is free along the figure
VALUE = Style(LETTER.size, LETTER.leading, BOLD)
STEEP, COVERED, CROSSED, CLOSE, AWAY = 0.4, 20.0, 10.0, 3.0, 0.5  # costs; the first for each point of height

Placed = tuple[Box, float, float]


def margin(curve: Curve, plots: Plots) -> float:
    """What the names need on the right of a figure."""
    widths = [box.width for box in _boxes(curve, plots)]
    return ASIDE + max(widths) + 2.0 if widths else RIGHT_AXIS


def at_the_ends(axes: Any, curve: Curve, plots: Plots) -> list[Placed]:
    """The names right of the axes, each led to the end of its line, with their places from the figure's corner."""
    paths = _paths(axes, curve)
    made, _ = _value(axes, curve, plots, paths)
    return made + _at_the_right(axes, _boxes(curve, plots), paths)


def inside(axes: Any, curve: Curve, plots: Plots) -> list[Placed]:
    """The names beside their lines, within the axes."""
    paths = _paths(axes, curve)
    made, taken = _value(axes, curve, plots, paths)
    for i, box in enumerate(_boxes(curve, plots)):
        _put(made, taken, box, _best(box, list(_beside(paths[i], box.width, axes.bbox)), taken, axes.bbox, paths, i))
    return made


def _paths(axes: Any, curve: Curve) -> list[Any]:
    """Lines that have names, then limits, in points."""
    named = [(numbers(series.x), numbers(series.y)) for _, series in _names(curve)]
    ends = np.array(axes.get_xlim())
    named += [(ends, np.full(2, value)) for _, value in limits(curve)]
    return [axes.transData.transform(np.column_stack(pair)) for pair in named]


def _value(axes: Any, curve: Curve, plots: Plots, paths: list[Any]) -> tuple[list[Placed], list[Extent]]:
    """What the curve is where the design stands, beside the mark of it, and what room both take."""
    made: list[Placed] = []
    taken: list[Extent] = []
    if curve.point is not None and all(map(isfinite, curve.point)):
        x, y = axes.transData.transform(curve.point).tolist()
        box = lines(f"{plots.short(curve.point[1])} {y_unit(curve)}".strip(), VALUE, axes.bbox.width / 2, 1)[0]
        taken.append((x - 4, y - 4, x + 4, y + 4))
        spots = [(x + dx - (box.width if dx < 0 else 0), y + dy) for dx in (-7.0, 7.0) for dy in (5.0, -0.36 * LETTER.size, -10.0)]
        spots += [(x - box.width / 2, y + dy) for dy in (8.0, -14.0)]
        _put(made, taken, box, _best(box, [(0.0, spot) for spot in spots], taken, axes.bbox, paths, -1))
    return made, taken


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


def _put(made: list[Placed], taken: list[Extent], box: Box, place: tuple[float, float] | None) -> None:
    if place is not None:
        made.append((box, *place))
        taken.append(_extent(box, place))


def _extent(box: Box, place: tuple[float, float]) -> Extent:
    return place[0], place[1] - UNDER, place[0] + box.width, place[1] + OVER


def _beside(path: Any, wide: float, frame: Any) -> Iterator[tuple[float, tuple[float, float]]]:
    """Places over and under a line with what they cost; of a line without a middle, those beside its points."""
    x, y = path[np.isfinite(path).all(axis=1)].T
    if x.size and np.ptp(x) < 1.0:
        x, y = np.append(x, x[-1] + 1.0), np.append(y, y[-1])
    if not x.size:
        return
    if x[0] > x[-1]:
        x, y = x[::-1], y[::-1]
    low, high = max(float(x[0]), frame.x0), min(float(x[-1]), frame.x1)
    for share in PLACES:
        left = low + 3.0 + share * max(high - low - wide - 6.0, 0.0)
        own = np.interp(np.linspace(left, left + wide, 12), x, y)
        steep, away = STEEP * float(np.ptp(own)), AWAY * float(abs(share - 0.5))
        yield steep + away, (left, float(own.max()) + OFF + UNDER)
        yield steep + away + 0.1, (left, float(own.min()) - OFF - OVER)


def _best(
    box: Box, places: list[tuple[float, tuple[float, float]]], taken: list[Extent], frame: Any, paths: list[Any], own: int
) -> tuple[float, float] | None:
    """The cheapest place: not outside, not over other words, not across a line, not nearer to another line than to its own."""
    others = [np.column_stack([path[:-1], path[1:]]) for i, path in enumerate(paths) if i != own]
    around = np.concatenate([*others, np.zeros((0, 4))])
    around = around[np.isfinite(around).all(axis=1)]
    mine = np.array([(*a, *b) for a, b in pairwise(paths[own].tolist())] if own >= 0 else []).reshape(-1, 4)
    best: tuple[float, tuple[float, float]] | None = None
    for cost, place in sorted(places):
        if best is not None and cost >= best[0]:
            break
        box_of = _extent(box, place)
        if box_of[1] < frame.y0 or box_of[3] > frame.y1 + 1.0 or box_of[0] < frame.x0 or box_of[2] > frame.x1 + 8.0:
            continue
        cost += COVERED * sum(meet(box_of, other) for other in taken)
        wide = box_of[0], box_of[1] - NEAR, box_of[2], box_of[3] + NEAR
        cost += CROSSED if crossed(box_of, around) or crossed(box_of, mine) else CLOSE * crossed(wide, around)
        if best is None or cost < best[0]:
            best = cost, place
    return best[1] if best is not None else None
