# SPDX-License-Identifier: Apache-2.0
"""A curve of the sheet as a figure: one style, readable in grey print.

Lines differ by their pattern as well as by their colour, the legend stands above the axes where it can hide nothing, and a
locus is drawn in true scale.
"""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np

from calc.sheet.number import short
from calc.sheet.step import Curve

from .boxes import BLACK, Box, Colour
from .flow import LEFT, WIDTH, Block
from .letters import clean
from .prose import STRONG, Style, broken, lines, run

if TYPE_CHECKING:
    from .page import Pen

# Okabe and Ito's palette, in an order whose greys differ, each with its own pattern (lengths in points).
LINES: tuple[tuple[Colour, tuple[float, ...], float], ...] = (
    ((0.0, 0.447, 0.698), (), 1.15),
    ((0.835, 0.369, 0.0), (4.5, 1.8), 1.15),
    ((0.0, 0.62, 0.451), (5.0, 1.4, 1.2, 1.4), 1.15),
    ((0.8, 0.475, 0.655), (1.3, 1.3), 1.35),
    ((0.337, 0.706, 0.914), (7.0, 2.2), 1.15),
    ((0.902, 0.624, 0.0), (7.0, 1.4, 1.2, 1.4, 1.2, 1.4), 1.15),
    (BLACK, (2.4, 1.2), 0.9),
)
LIMIT: tuple[Colour, tuple[float, ...], float] = ((0.55, 0.0, 0.0), (8.0, 2.0, 2.0, 2.0), 0.8)
INK: Colour = (0.25, 0.25, 0.25)
LETTER = Style(6.6, 8.6)
NUMBER = Style(6.2, 8.0, colour=INK)
TICK = 2.5
GUTTER = 16.0
PART = (WIDTH - GUTTER) / 2
LOW, LEFT_AXIS, RIGHT_AXIS, HIGH = 25.0, 46.0, 8.0, 4.0  # around the axes
TALL, SQUARE = 128.0, 160.0  # height of the axes


def figure_blocks(curves: list[tuple[int, Curve]], word: str, plots: Plots) -> list[Block]:
    """Figures two beside each other, each with its number and title below."""
    blocks = []
    n = 0
    while n < len(curves):
        last = n + 1 == len(curves)
        pair = [_Figure(number, curve, word, plots, WIDTH if last and not curve.equal else PART) for number, curve in curves[n : n + 2]]
        n += 2
        above = max(len(f.legend) for f in pair)
        for figure in pair:
            figure.rows = above  # so that the axes of neighbours stand level
        height = max(f.height for f in pair)

        def draw(pen: Pen, y: float, pair: list[_Figure] = pair) -> None:
            for i, figure in enumerate(pair):
                figure.draw(pen, i * (PART + GUTTER), y)

        blocks.append(Block(height, draw, gap=8.0))
    return blocks


class _Figure:
    """One figure with its legend and caption, laid out before anything is drawn."""

    def __init__(self, number: int, curve: Curve, word: str, plots: Plots, width: float) -> None:
        self.curve, self.plots, self.width = curve, plots, width
        self.caption = lines(f"{word} {number}. {curve.title}", STRONG, width - LEFT_AXIS, 3)
        self.legend = _legend(curve, width - LEFT_AXIS)
        self.rows = len(self.legend)
        self.axes = SQUARE if curve.equal else TALL
        self.wide = LEFT_AXIS + SQUARE + RIGHT_AXIS if curve.equal else width

    @property
    def legend_height(self) -> float:
        return self.rows * LETTER.leading + 3.0

    @property
    def height(self) -> float:
        return self.legend_height + HIGH + self.axes + LOW + len(self.caption) * STRONG.leading

    def draw(self, pen: Pen, x: float, y: float) -> None:
        top = y - LETTER.leading * (self.rows - len(self.legend) + 0.78)
        for i, entries in enumerate(self.legend):
            at = x + LEFT_AXIS
            for (colour, dashes, thick), box in entries:
                base = top - i * LETTER.leading
                _sample(pen, at, base + 2.2, colour, dashes, thick)
                pen.put(box, at + 24.0, base)
                at += 24.0 + box.width + 12.0
        low = y - self.legend_height - HIGH - self.axes - LOW
        height = self.axes + LOW + HIGH
        pen.figure(lambda: plot(self.plots, pen, self.curve, LEFT + x, low, self.wide, height))
        for i, line in enumerate(self.caption):
            pen.put(line, x + LEFT_AXIS, low - (i + 0.78) * STRONG.leading)


def _legend(curve: Curve, space: float) -> list[list[tuple[tuple[Colour, tuple[float, ...], float], Box]]]:
    """The legend's rows: line sample and label."""
    unit = curve.y_label.rpartition(", ")[2] if ", " in curve.y_label else ""
    named = [(LINES[i % len(LINES)], s.label) for i, s in enumerate(curve.series) if s.label]
    named += [(LIMIT, f"{label} {short(value)} {unit}".strip()) for label, value in _limits(curve)]
    rows: list[list[tuple[Any, Box]]] = [[]]
    filled = 0.0
    for style, label in named:
        box = run(broken(label, LETTER, space - 26.0, 1)[0], LETTER)
        wide = 24.0 + box.width + 12.0
        if rows[-1] and filled + wide - 12.0 > space:
            rows.append([])
            filled = 0.0
        rows[-1].append((style, box))
        filled += wide
    return rows if rows[0] else []


def _sample(pen: Pen, x: float, y: float, colour: Colour, dashes: tuple[float, ...], thick: float) -> None:
    """A piece of line as long as a legend needs, in dashes."""
    at, end, on = 0.0, 20.0, True
    lengths = dashes or (end,)
    i = 0
    while at < end:
        length = min(lengths[i % len(lengths)], end - at)
        if on:
            pen._line([(LEFT + x + at, y), (LEFT + x + at + length, y)], thick, colour)
        at += length
        on, i = not on, i + 1


def _limits(curve: Curve) -> list[tuple[str, float]]:
    return [(label, value) for label, value in curve.limits if isfinite(value)]


class Plots:
    """The axes that the figures of one report are drawn with: making them costs more than drawing, so like ones are used again."""

    def __init__(self) -> None:
        self.made: dict[tuple[float, float, bool], Any] = {}

    def axes(self, width: float, height: float, equal: bool) -> Any:
        """Empty axes for a figure of this size."""
        if (found := self.made.get((width, height, equal))) is None:
            found = self.made[width, height, equal] = _new_axes(width, height, equal)
        for line in list(found.lines):
            line.remove()
        found.dataLim.set_points(np.array([[np.inf, np.inf], [-np.inf, -np.inf]]))
        found.autoscale(True)
        return found


def _new_axes(width: float, height: float, equal: bool) -> Any:
    from matplotlib.backend_bases import FigureCanvasBase
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width / 72, height / 72), dpi=72, facecolor="none")
    FigureCanvasBase(figure)
    left, low = LEFT_AXIS / width, LOW / height
    axes: Any = figure.add_axes((left, low, 1 - left - RIGHT_AXIS / width, 1 - low - HIGH / height), facecolor="none")
    axes.grid(True, color=(0.87, 0.87, 0.87), linewidth=0.4)
    axes.set_axisbelow(True)
    axes.tick_params(width=0.5, length=TICK, color=INK, labelleft=False, labelbottom=False)
    for name, spine in axes.spines.items():
        spine.set(linewidth=0.6, color=INK, visible=name in ("left", "bottom"))
    if equal:
        axes.set_aspect("equal", adjustable="datalim")
    else:
        axes.margins(x=0)
    return axes


def _pattern(dashes: tuple[float, ...], thick: float) -> Any:
    return (0, tuple(d / thick for d in dashes)) if dashes else "-"


def _is_point(curve: Curve, xs: Any, ys: Any) -> bool:
    """Whether a line would be too small to be seen: a single value, or a locus that is next to nothing beside the others."""
    seen = np.isfinite(ys) & np.isfinite(xs)
    if np.count_nonzero(seen) <= 1:
        return True
    if not curve.equal:
        return False
    largest = max(np.nanmax(np.hypot(np.asarray(s.x, float), np.asarray(s.y, float)), initial=0.0) for s in curve.series)
    return bool(np.nanmax(np.hypot(xs, ys)) < 0.01 * largest)


def plot(plots: Plots, pen: Pen, curve: Curve, x: float, y: float, width: float, height: float) -> None:
    """Draw a curve into a rectangle of the page."""
    from matplotlib.ticker import MaxNLocator

    from .renderer import PageRenderer

    axes = plots.axes(width, height, curve.equal)
    for i, series in enumerate(curve.series):
        xs, ys = np.atleast_1d(np.asarray(series.x, float)), np.atleast_1d(np.asarray(series.y, float))
        colour, dashes, thick = LINES[i % len(LINES)]
        dot = "o" if _is_point(curve, xs, ys) else None
        axes.plot(xs, ys, color=colour, lw=thick, ls=_pattern(dashes, thick), marker=dot, markersize=2.8, solid_joinstyle="round")
    for _, value in _limits(curve):
        colour, dashes, thick = LIMIT
        axes.axhline(value, color=colour, lw=thick, ls=_pattern(dashes, thick))
    degrees = curve.x_label.rstrip().endswith("°")
    if degrees and not curve.equal and 355.0 < axes.get_xlim()[1] < 360.0:
        axes.set_xlim(right=360.0)  # a turn whose last point is its first
    low, high = axes.get_ylim()
    if low < 0 < high and not curve.equal:
        axes.axhline(0.0, color=(0.6, 0.6, 0.6), lw=0.5, zorder=0.9)
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 1.5, 3, 4.5, 6, 9, 10] if degrees else [1, 2, 2.5, 5, 10]))
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    axes.apply_aspect()
    renderer = PageRenderer(pen.canvas, x, y, width, height)
    axes.figure.draw(renderer)
    renderer.finish()
    _letter(pen, axes, curve, x - LEFT, y)


def _letter(pen: Pen, axes: Any, curve: Curve, x: float, y: float) -> None:
    """The numbers and names of the axes."""
    frame = axes.bbox
    (low_x, high_x), (low_y, high_y) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    down = y + frame.y0 - TICK - 0.85 * NUMBER.size
    end = -1.0
    for value in axes.xaxis.get_majorticklocs():
        box = run(short(value), NUMBER)
        at = axes.transData.transform((value, low_y))[0] - box.width / 2
        if low_x - 1e-9 <= value <= high_x + 1e-9 and at > end:
            pen.put(box, x + min(at, axes.figure.bbox.width - box.width), down)
            end = at + box.width + 3.0
    for value in axes.yaxis.get_majorticklocs():
        if low_y - 1e-9 <= value <= high_y + 1e-9:
            box = run(short(value), NUMBER)
            at = axes.transData.transform((low_x, value))[1]
            pen.put(box, x + frame.x0 - TICK - 2.0 - box.width, y + at - 0.36 * NUMBER.size)
    name = run(broken(clean(curve.x_label), LETTER, frame.width, 1)[0], LETTER)
    pen.put(name, x + frame.x0 + (frame.width - name.width) / 2, down - 1.35 * LETTER.size)
    name = run(broken(clean(curve.y_label), LETTER, frame.height, 1)[0], LETTER)
    pen.turn(name, x + 7.0, y + frame.y0 + (frame.height - name.width) / 2)
