# SPDX-License-Identifier: Apache-2.0
"""The axes of a figure and what stands in them: lines, bars, loci with their vectors.  The letters are the page's
own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np
from matplotlib.backend_bases import FigureCanvasBase
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.ticker import FixedLocator, MaxNLocator
from matplotlib.transforms import IdentityTransform

from calc.locale import Language
from calc.sheet.number import short
from calc.sheet.step import Curve, Series, line_of

from ..typesetting.boxes import BLACK, Box, Colour
from ..typesetting.fonts import clean
from ..typesetting.pen import Recorder, Recording
from ..typesetting.prose import Style, broken, lines, run
from .arrows import Arrow, arrows, draw_arrows
from .renderer import LineRenderer

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
# Bars differ by their grey as well as by their colour; from the fifth on they are hatched.
BARS: tuple[Colour, ...] = ((0.0, 0.28, 0.46), (0.945, 0.69, 0.2), (0.0, 0.58, 0.42), (0.80, 0.92, 0.985))
DASHES = (4.5, 1.8)  # of series that are dashed
BROAD, THIN = 2.1, 0.8  # of the thickness of a line, for loci that may run over each other
LIMITS: tuple[tuple[Colour, tuple[float, ...], float], ...] = (
    ((0.55, 0.0, 0.0), (8.0, 2.0, 2.0, 2.0), 0.8),
    ((0.3, 0.0, 0.45), (2.0, 2.0), 0.9),
)
# where the design stands, within its limits and beyond one: mark, size, thickness
POINTS = {False: ("o", 5.0, 0.5), True: ("x", 7.0, 2.0)}
BAND: Colour = (0.89, 0.89, 0.89)
FILLED = 0.8  # share of a group's place that its bars take
EDGE = 0.4
HATCH = 3.2  # from one line of a hatching to the next, in points
INK: Colour = (0.25, 0.25, 0.25)
LETTER = Style(7.5, 9.2)
NUMBER = Style(7.5, 9.0, colour=INK)
TICK = 2.5
AROUND = 12.0  # over and under lines that bear their names: the value under the lowest point has room
LEFT_AXIS, RIGHT_AXIS, LOW, HIGH = 46.0, 8.0, 24.0, 4.0  # around the axes


def line_style(i: int) -> tuple[Colour, tuple[float, ...], float]:
    """Colour, dashes and thickness of the i-th line; when all patterns are used up they come again, thicker."""
    colour, dashes, thick = LINES[i % len(LINES)]
    return colour, dashes, thick * (1 + 0.9 * (i // len(LINES)))


def limit_style(i: int) -> tuple[Colour, tuple[float, ...], float]:
    """Colour, dashes and thickness of the i-th limit."""
    return LIMITS[i % len(LIMITS)]


EDGE_STYLE: tuple[Colour, tuple[float, ...], float] = ((0.45, 0.45, 0.45), (), 0.5)  # of a band


def series_style(curve: Curve, i: int) -> tuple[Colour, tuple[float, ...], float]:
    """How the i-th series is drawn; the last two of a band are its edges.  Loci may run over each other, and more than
    once: the first of a variant is broad, and those that are drawn over it are thin, so that it looks out on both
    sides of them."""
    if curve.band and i >= len(curve.series) - 2:
        return EDGE_STYLE
    colour, dashes, thick = line_style(line_of(curve.series, i))
    if any(series.dashed for series in curve.series):
        dashes = DASHES if curve.series[i].dashed else ()
    like = [n for n, s in enumerate(curve.series) if s.variant == curve.series[i].variant]
    if curve.equal and len(like) > 1:
        thick *= BROAD if i == like[0] else THIN
    return colour, dashes, thick


def limits(curve: Curve) -> list[tuple[str, float]]:
    return [(label, value) for label, value in curve.limits if isfinite(value)]


def numbers(values: Any) -> Any:
    return np.atleast_1d(np.asarray(values, float))


def series_label(curve: Curve, series: Series) -> str:
    """What the legend calls a series: with its variant where other variants have one of the same name."""
    alone = sum(s.label == series.label for s in curve.series) == 1
    return series.label if alone and series.label else ", ".join(x for x in (series.label, series.variant) if x)


def limit_words(curve: Curve, plots: Plots) -> list[str]:
    """The limits with their values."""
    return [f"{label} {plots.short(value)} {y_unit(curve)}".strip() for label, value in limits(curve)]


def y_unit(curve: Curve) -> str:
    return curve.y_label.rpartition(", ")[2] if ", " in curve.y_label else ""


def tick_words(values: list[float]) -> list[str]:
    """The numbers of an axis, all written one way and none of them rounded: 0.005 beside 0.01, and not 5·10⁻³; 40.025
    beside 40.05."""
    largest = max((abs(v) for v in values), default=0.0)
    rounded = [v if abs(v) > 1e-9 * largest else 0.0 for v in values]
    if 1e-2 <= largest < 1e5:
        return [f"{v:.7g}".replace("-", "−") for v in rounded]
    return [short(v) for v in rounded]


def fitted(words: str, width: float) -> Box:
    """The name of an axis on one line, cut where it is too long."""
    words = clean(words)
    box = run(words, LETTER)
    return box if box.width <= width else run(broken(words, LETTER, width, 1)[0], LETTER)


class Plots:
    """What the figures of one report are drawn with: axes, which are used again, since making them costs more than
    drawing, and how its language writes a number."""

    def __init__(self, say: Language) -> None:
        self.made: dict[tuple[float, float, float, bool, bool], Any] = {}
        self.say, self.number = say, say.number

    def short(self, value: float) -> str:
        return self.number(short(value))

    def axes(self, width: float, height: float, curve: Curve, right: float = RIGHT_AXIS) -> Any:
        """Empty axes for a figure of this size and kind."""
        kind = (width, height, right, curve.equal, curve.bars)
        if (axes := self.made.get(kind)) is None:
            axes = self.made[kind] = _new_axes(*kind)
        for old in [*axes.lines, *axes.patches, *axes.collections]:
            old.remove()
        axes.dataLim.set_points(np.array([[np.inf, np.inf], [-np.inf, -np.inf]]))
        axes.autoscale(True)
        return axes


def _new_axes(width: float, height: float, right: float, equal: bool, bars: bool) -> Any:
    figure = Figure(figsize=(width / 72, height / 72), dpi=72, facecolor="none")
    FigureCanvasBase(figure)
    left, low = LEFT_AXIS / width, LOW / height
    axes: Any = figure.add_axes((left, low, 1 - left - right / width, 1 - low - HIGH / height), facecolor="none")
    axes.grid(True, axis="y" if bars else "both", color=(0.87, 0.87, 0.87), linewidth=0.4)
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
    """Whether a line would be too small to be seen: a single value, or a locus that is next to nothing beside the
    others."""
    seen = np.isfinite(ys) & np.isfinite(xs)
    if np.count_nonzero(seen) <= 1:
        return True
    if not curve.equal:
        return False
    largest = max(
        np.nanmax(np.hypot(np.asarray(s.x, float), np.asarray(s.y, float)), initial=0.0) for s in curve.series
    )
    return bool(np.nanmax(np.hypot(xs, ys)) < 0.01 * largest)


@dataclass(frozen=True, slots=True)
class Look:
    """What of a figure is not the curve's own: what finds places for the names of its lines, inside or in a margin
    `right` of it, and, as one of a stack, from where to where it goes along x and whether it is the lowest, which has
    the numbers."""

    named: Callable[[Any, Curve, Plots], list[tuple[Box, float, float]]] | None = None
    right: float = RIGHT_AXIS
    ends: tuple[float, float] | None = None
    lowest: bool = True


ALONE = Look()


def plot(plots: Plots, curve: Curve, width: float, height: float, look: Look = ALONE) -> Recording:
    """Draw a curve into a frame of this size."""
    axes, frame = plots.axes(width, height, curve, look.right), Recorder()
    drawn = filled(axes, curve)
    if look.ends is not None:
        axes.set_xlim(look.ends)
    if look.named and (look.ends is not None or curve.point is not None):
        low, high = axes.get_ylim()
        more = (high - low) * AROUND / axes.bbox.height
        axes.set_ylim(low - more, high + more)
    named = look.named(axes, curve, plots) if look.named is not None else []
    if drawn:
        draw_arrows(frame, axes, drawn, _variant_colours(curve))
    axes.figure.draw(LineRenderer(frame.code, width, height))
    _letter(plots, frame, axes, curve, look)
    for box, a, b in named:
        frame.put(box, a, b)
    return frame.recording


def filled(axes: Any, curve: Curve) -> list[Arrow]:
    """Put the lines, bars and limits of a curve into axes; gives its vectors, which are still to be drawn."""
    drawn = arrows(curve)
    if drawn:
        axes.update_datalim([(p.imag, p.real) for a in drawn for p in (a.tail, a.tip)])
        for cross in (axes.axhline, axes.axvline):
            cross(0.0, color=(0.6, 0.6, 0.6), lw=0.5, zorder=0.9)
    if curve.bars:
        _bars(axes, curve)
    else:
        _lines(axes, curve)
    _points(axes, curve)
    for i, (_, value) in enumerate(limits(curve)):
        colour, dashes, thick = limit_style(i)
        axes.axhline(value, color=colour, lw=thick, ls=_pattern(dashes, thick))
    if curve.point is not None and all(map(isfinite, curve.point)):
        sign, size, thick = POINTS[curve.fails]
        axes.plot(
            *curve.point, marker=sign, markersize=size, color=BLACK, markeredgewidth=thick, zorder=4, clip_on=False
        )
    low, high = axes.get_ylim()
    if low < 0 < high and not curve.equal:
        axes.axhline(0.0, color=(0.6, 0.6, 0.6), lw=0.5, zorder=2.5 if curve.bars else 0.9)
    axes.yaxis.set_major_locator(MaxNLocator(6 if axes.bbox.height > 60 else 3, steps=[1, 2, 2.5, 5, 10]))
    axes.apply_aspect()
    return drawn


def _lines(axes: Any, curve: Curve) -> None:
    edges = range(len(curve.series) - 2, len(curve.series)) if curve.band else range(0)
    if edges:
        lower, upper = (curve.series[i] for i in edges)
        axes.fill_between(
            numbers(lower.x), numbers(lower.y), numbers(upper.y), facecolor=BAND, edgecolor="none", lw=0, zorder=0.5
        )
    for i, series in enumerate(curve.series):
        xs, ys = numbers(series.x), numbers(series.y)
        colour, dashes, thick = series_style(curve, i)
        dot = "o" if _is_point(curve, xs, ys) else None
        axes.plot(
            xs,
            ys,
            color=colour,
            lw=thick,
            ls=_pattern(dashes, thick),
            marker=dot,
            markersize=2.8,
            solid_joinstyle="round",
        )
    degrees = curve.x_label.rstrip().endswith("°")
    if degrees and not curve.equal and 355.0 < axes.get_xlim()[1] < 360.0:
        axes.set_xlim(right=360.0)  # a turn whose last point is its first
    left, right = axes.get_xlim()
    turns = degrees and right - left > 45.0
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 1.5, 3, 4.5, 6, 9, 10] if turns else [1, 2, 2.5, 5, 10]))


def _points(axes: Any, curve: Curve) -> None:
    """What was measured: points, each on a bar of one standard uncertainty either way."""
    if (points := curve.measured) is None:
        return
    for x, y, bar in zip(points.x.tolist(), points.y.tolist(), points.bar.tolist()):
        if isfinite(bar) and bar > 0:
            axes.plot(
                [x, x], [y - bar, y + bar], color=BLACK, lw=0.7, marker="_", markersize=4.0, zorder=3, clip_on=False
            )
    axes.plot(points.x, points.y, color=BLACK, lw=0, marker="o", markersize=3.2, zorder=3.5, clip_on=False)


def _variant_colours(curve: Curve) -> dict[str, Colour]:
    """The colour of the one locus that a chain of vectors draws; where a variant has several the arrows keep their
    own."""
    named = [s.variant for s in curve.series]
    return {variant: line_style(named.index(variant))[0] for variant in named if variant and named.count(variant) == 1}


def _bars(axes: Any, curve: Curve) -> None:
    """Groups of bars that stand on zero."""
    groups = [(numbers(s.x), numbers(s.y)) for s in curve.series]
    seen = [(xs[ok], ys[ok]) for xs, ys in groups for ok in [np.isfinite(xs) & np.isfinite(ys)]]
    places = np.unique(np.concatenate([xs for xs, _ in seen] or [np.zeros(0)]))
    if not places.size:
        return
    step = float(np.diff(places).min()) if places.size > 1 else 1.0
    tops = np.concatenate([ys for _, ys in seen])
    low, high = min(0.0, float(tops.min())), max(0.0, float(tops.max()))
    room = 0.05 * (high - low)
    axes.set_xlim(places[0] - step / 2, places[-1] + step / 2)
    axes.set_ylim(low - room if low < 0 else 0.0, high + room if high > low else 1.0)
    axes.xaxis.set_major_locator(FixedLocator(places.tolist()) if places.size <= 16 else MaxNLocator(8, integer=True))
    wide = FILLED * step / len(seen)
    for i, (xs, ys) in enumerate(seen):
        left = xs + (i - len(seen) / 2) * wide
        corners = [[(a, 0.0), (a, b), (a + wide, b), (a + wide, 0.0)] for a, b in zip(left.tolist(), ys.tolist()) if b]
        if not corners:
            continue
        path = Path.make_compound_path_from_polys(np.array(corners))
        axes.add_patch(PathPatch(path, facecolor=bar_colour(i), edgecolor=BLACK, lw=EDGE, zorder=2))
        for a, b, c, d in (axes.transData.transform(bar)[[0, 2]].ravel().tolist() for bar in np.array(corners)):
            for line in hatching(i, min(a, c), min(b, d), abs(c - a), abs(d - b)):
                axes.plot(*zip(*line), color=BLACK, lw=EDGE, transform=IdentityTransform(), zorder=2.1)


def bar_colour(i: int) -> Colour:
    return BARS[i % len(BARS)]


def hatching(i: int, x: float, y: float, width: float, height: float) -> list[list[tuple[float, float]]]:
    """The diagonals across the i-th kind of bar, in points: none for the first four."""
    if i < len(BARS):
        return []
    diagonals = []
    for n in range(1, int((width + height) / HATCH) + 1):
        c = n * HATCH - height  # the diagonal meets the lower edge's line at x + c
        diagonals.append(
            [(x + max(c, 0.0), y + max(-c, 0.0)), (x + min(c + height, width), y + min(height, width - c))]
        )
    return diagonals


def _letter(plots: Plots, frame: Recorder, axes: Any, curve: Curve, look: Look) -> None:
    """The numbers and names of the axes; of one in a stack the name of y lies over it."""
    inside = axes.bbox
    (low_x, high_x), (low_y, high_y) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    ticks = _seen(axes.yaxis.get_majorticklocs(), low_y, high_y)
    for value, words in zip(ticks, tick_words(ticks)):
        box = run(plots.number(words), NUMBER)
        at = axes.transData.transform((low_x, value))[1]
        frame.put(box, inside.x0 - TICK - 2.0 - box.width, at - 0.36 * NUMBER.size)
    if look.ends is not None:
        frame.put(fitted(curve.y_label, inside.width), inside.x0, inside.y1 + 2.5)
    else:
        room = inside.height + inside.y0
        for n, name in enumerate(lines(curve.y_label, LETTER, room, 2)):
            at = inside.y0 + (inside.height - name.width) / 2
            frame.turn(name, 7.0 + n * 0.95 * LETTER.size, min(max(at, 0.0), room - name.width))
    if not look.lowest:
        return
    down, end = inside.y0 - TICK - 0.85 * NUMBER.size, -1.0
    ticks = _seen(axes.xaxis.get_majorticklocs(), low_x, high_x)
    for value, words in zip(ticks, tick_words(ticks)):
        box = run(plots.number(words), NUMBER)
        at = axes.transData.transform((value, low_y))[0] - box.width / 2
        if at > end:
            frame.put(box, min(at, axes.figure.bbox.width - box.width), down)
            end = at + box.width + 3.0
    whole = axes.figure.bbox.width
    name = fitted(curve.x_label, whole)
    at = min(inside.x0 + (inside.width - name.width) / 2, whole - name.width)
    frame.put(name, max(at, 0.0), down - 1.3 * LETTER.size)


def _seen(ticks: Any, low: float, high: float) -> list[float]:
    return [float(v) for v in ticks if low - 1e-9 <= v <= high + 1e-9]
