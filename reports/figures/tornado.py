# SPDX-License-Identifier: Apache-2.0
"""Bars on their side: a row for every name of a curve, the first on top, and its bars to the left and to the right of
nought."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import ceil, floor, isfinite, log10
from typing import TYPE_CHECKING

import numpy as np

from calc.sheet.step import Curve

from ..typesetting.boxes import BLACK, Box, Colour, scaled
from ..typesetting.fonts import LEFT
from ..typesetting.prose import lines, run
from .plots import (
    EDGE,
    FILLED,
    INK,
    LEFT_AXIS,
    LETTER,
    LOW,
    NUMBER,
    RIGHT_AXIS,
    TICK,
    Plots,
    bar_colour,
    fitted,
    hatching,
    limit_style,
    limits,
    numbers,
    tick_words,
)

if TYPE_CHECKING:
    from ..typesetting.pen import Pen

THICK = 3.9  # of a bar, in points
ASIDE = 5.0  # between the names and the axes
MOST = 0.36  # share of the width that the names take; what is longer wraps
TALLEST = 520.0  # of all rows: more of them are drawn smaller
STEPS = 8  # from number to number along the axis, at most
SEEN = 0.05  # points: a bar that is less is none
GRID: Colour = (0.87, 0.87, 0.87)


def lies(curve: Curve) -> bool:
    """Whether a curve's bars have names, and lie."""
    return curve.bars and bool(curve.names)


class Lying:
    """A curve laid out for a width: the lines of its names, and how tall each row is."""

    def __init__(self, curve: Curve, width: float, plots: Plots) -> None:
        self.curve, self.width, self.number = curve, width, plots.number
        names = [lines(name, LETTER, MOST * width - ASIDE) for name in curve.names]
        bars = max(1, len(curve.series)) * THICK / FILLED
        tall = [max(bars, len(name) * LETTER.leading + 0.6) for name in names]
        self.by = min(1.0, TALLEST / sum(tall))
        self.names: list[list[Box]] = [
            [scaled(line, self.by) if self.by < 1 else line for line in name] for name in names
        ]
        self.tall = [self.by * t for t in tall]
        self.left = max(LEFT_AXIS, ASIDE + max(line.width for name in self.names for line in name))
        self.height = sum(self.tall)

    def draw(self, pen: Pen, x: float, y: float) -> None:
        """Draw rows, bars and axis; x from the left margin, y the lower edge of what stands below the axis."""
        low, top = y + LOW, y + LOW + self.height
        left, right = LEFT + x + self.left, LEFT + x + self.width - RIGHT_AXIS
        least, most = _range(self.curve)

        def at(value: float) -> float:
            return left + (right - left) * (value - least) / (most - least)

        for n in range(len(self.tall)):
            level = top - sum(self.tall[:n])
            pen.line([(LEFT + x, level), (right, level)], 0.3, GRID)
        ticks = _ticks(least, most)
        for value in ticks:
            pen.line([(at(value), low), (at(value), top)], 0.4, GRID)
            pen.line([(at(value), low - TICK), (at(value), low)], 0.5, INK)
        for i, corners in self._bars(top, at):
            _bar(pen, i, corners)
        pen.line([(at(0.0), low), (at(0.0), top)], 0.8, INK)
        pen.line([(left, low), (right, low)], 0.6, INK)
        for i, (_, value) in enumerate(limits(self.curve)):
            colour, dashes, thick = limit_style(i)
            dashed(pen, (at(value), low), (at(value), top), (colour, dashes, thick))
        self._letter(pen, x, top, low, [(at(v) - LEFT, word) for v, word in zip(ticks, tick_words(ticks))])

    def _bars(
        self, top: float, at: Callable[[float], float]
    ) -> Iterator[tuple[int, tuple[float, float, float, float]]]:
        """Every bar that can be seen: of which series, its left, lower, right and upper edge.  Those of a row stand
        about its middle."""
        rows: list[list[tuple[int, float, float]]] = [[] for _ in self.tall]
        for i, series in enumerate(self.curve.series):
            for place, value in zip(numbers(series.x).tolist(), numbers(series.y).tolist()):
                if (
                    isfinite(place)
                    and isfinite(value)
                    and 1 <= round(place) <= len(rows)
                    and abs(at(value) - at(0.0)) > SEEN
                ):
                    rows[round(place) - 1].append((i, *sorted((at(0.0), at(value)))))
        thick = self.by * THICK
        for row, tall in zip(rows, self.tall):
            for n, (i, a, b) in enumerate(row):
                upper = top - tall / 2 + (len(row) / 2 - n) * thick
                yield i, (a, upper - thick, b, upper)
            top -= tall

    def _letter(self, pen: Pen, x: float, top: float, low: float, ticks: list[tuple[float, str]]) -> None:
        """The names, the numbers of the axis and what it shows."""
        for name, tall in zip(self.names, self.tall):
            leading = self.by * LETTER.leading
            base = top - tall / 2 + (len(name) / 2) * leading - 0.76 * leading
            for n, line in enumerate(name):
                pen.put(line, x + self.left - ASIDE - line.width, base - n * leading)
            top -= tall
        down = low - TICK - 0.85 * NUMBER.size
        for place, word in ticks:
            box = run(self.number(word), NUMBER)
            pen.put(box, min(place - box.width / 2, x + self.width - box.width), down)
        wide = self.width - RIGHT_AXIS - self.left
        label = fitted(self.curve.y_label, wide)
        pen.put(label, x + self.left + (wide - label.width) / 2, down - 1.35 * LETTER.size)


def _range(curve: Curve) -> tuple[float, float]:
    """From where to where the axis goes: nought and all bars and limits are on it."""
    ends = [y[np.isfinite(y)] for y in (numbers(s.y) for s in curve.series)]
    values = np.concatenate([*ends, [0.0], [value for _, value in limits(curve)]])
    least, most = float(values.min()), float(values.max())
    room = 0.05 * (most - least)
    return (least - room if least < 0 else 0.0, most + room if most > 0 else 0.0) if room > 0 else (-1.0, 1.0)


def _ticks(least: float, most: float) -> list[float]:
    """Round numbers along an axis, at most as many steps as it has room for."""
    wanted = (most - least) / STEPS
    power = 10.0 ** floor(log10(wanted))
    step = next(step for step in (power, 2 * power, 2.5 * power, 5 * power, 10 * power) if step >= wanted * (1 - 1e-9))
    return [n * step for n in range(ceil(least / step - 1e-9), floor(most / step + 1e-9) + 1)]


def _bar(pen: Pen, i: int, corners: tuple[float, float, float, float]) -> None:
    """A bar filled like the others of its series."""
    a, b, c, d = corners
    pen.area([(a, b), (c, b), (c, d), (a, d)], bar_colour(i))
    for line in [*hatching(i, a, b, c - a, d - b), [(a, b), (c, b), (c, d), (a, d), (a, b)]]:
        pen.line(line, EDGE, BLACK)


def dashed(
    pen: Pen, start: tuple[float, float], end: tuple[float, float], style: tuple[Colour, tuple[float, ...], float]
) -> None:
    """A line along an axis in the pattern of a style."""
    colour, dashes, thick = style
    (x, y), length = start, abs(end[0] - start[0]) + abs(end[1] - start[1])
    across, up = ((end[0] - x) / length, (end[1] - y) / length) if length else (0.0, 0.0)
    done, i = 0.0, 0
    lengths = dashes or (length,)
    while done < length:
        step = min(lengths[i % len(lengths)], length - done)
        if i % 2 == 0:
            pen.line(
                [(x + across * done, y + up * done), (x + across * (done + step), y + up * (done + step))],
                thick,
                colour,
            )
        done, i = done + step, i + 1
