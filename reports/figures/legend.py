# SPDX-License-Identifier: Apache-2.0
"""The legend of a figure: samples of its lines, bars and arrows, each with what it shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from calc.sheet.step import Curve

from ..setting.boxes import BLACK, Box, Colour
from ..setting.fonts import LEFT
from ..setting.prose import lines
from .arrows import arrows, sample_arrow
from .plots import EDGE, LETTER, Plots, bar_colour, hatching, limit_style, limit_words, series_label, series_style
from .tornado import dashed

if TYPE_CHECKING:
    from ..setting.pen import Pen

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
