# SPDX-License-Identifier: Apache-2.0
"""The drawing of a curve.  Imported only when there is one: it brings numpy and the plotting library with it."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.segment import Segment
from textual.app import ComposeResult
from textual.containers import Grid
from textual.content import Content
from textual.strip import Strip
from textual_hires_canvas import Canvas
from textual_plot import HiResMode, NumericAxisFormatter, PlotWidget
from textual_plot.plot_widget import Legend

from calc.sheet.step import Curve

from .signs import Signs

if TYPE_CHECKING:
    from ..app import ContralberoApp

ROUND = 2.0  # how much higher than wide a cell of a terminal is
ROOM = 0.04  # of the height, above and below


class Numbers(NumericAxisFormatter):
    """Labels with a true minus sign, as everywhere."""

    def get_labels_for_ticks(self, ticks: Sequence[float]) -> list[str]:
        return [label.replace("-", "−") for label in super().get_labels_for_ticks(ticks)]


PLAIN = str.maketrans({**dict.fromkeys("┏┓┗┛┣┫┳┻╋", "+"), "━": "-", "┃": "|", "█": "*", "−": "-"})


class Sheet(Canvas):
    """A canvas whose rows always have a style: where colours are switched off, a row without one stops the program."""

    app: "ContralberoApp"

    def render_line(self, y: int) -> Strip:
        strip = super().render_line(y)
        if not strip.cell_length:
            return Strip.blank(self.size.width, self.rich_style)
        return Strip([Segment(s.text.translate(PLAIN), s.style) for s in strip]) if self.app.signs.ascii else strip


class Plot(PlotWidget, can_focus=False, inherit_bindings=False):
    """Braille lines in a frame; the labels of the axes stand above, in the legend."""

    def __init__(self) -> None:
        super().__init__(allow_pan_and_zoom=False)
        self.set_reactive(PlotWidget.margin_top, 0)
        self.set_reactive(PlotWidget.margin_bottom, 1)
        self.set_x_formatter(Numbers())
        self.set_y_formatter(Numbers())

    def compose(self) -> ComposeResult:
        with Grid():
            for name in ("margin-top", "margin-left", "plot", "margin-bottom"):
                yield Sheet(1, 1, id=name)
        yield Legend(id="legend")

    def render(self) -> Any:
        super().render()
        return Content("")

    def draw(self, curve: Curve, signs: Signs) -> None:
        """The lines of a curve and its limits, in the space that there is."""
        mode = None if signs.ascii else HiResMode.BRAILLE
        self.clear()
        x_low, x_high = _extent([s.x for s in curve.series])
        y_low, y_high = _extent([*(s.y for s in curve.series), [limit for _, limit in curve.limits]])
        if not all(map(math.isfinite, (x_low, x_high, y_low, y_high))):
            return
        for n, series in enumerate(curve.series):
            x, y = np.asarray(series.x, float), np.asarray(series.y, float)
            whole = np.isfinite(x) & np.isfinite(y)
            if whole.any():
                self.plot(x[whole], y[whole], line_style=signs.line(n), hires_mode=mode)
        for _, limit in curve.limits:
            self.plot(np.array([x_low, x_high]), np.array([limit, limit]), line_style=signs.limit(), hires_mode=mode)
        room = ROOM * (y_high - y_low) or 0.5 * abs(y_high) or 1.0
        y_low, y_high = y_low - room, y_high + room
        if x_low == x_high:
            x_low, x_high = x_low - (abs(x_low) or 1.0) / 2, x_high + (abs(x_high) or 1.0) / 2
        height = max(2, self.size.height - self.margin_bottom - 2)
        y_ticks = ticks(y_low, y_high, max(2, round(height * 0.8)))
        self.margin_left = 2 + max(map(len, self._y_formatter.get_labels_for_ticks(y_ticks)), default=4)
        width = max(4, self.size.width - self.margin_left - 2)
        if curve.equal:
            x_low, x_high, y_low, y_high = _round(x_low, x_high, y_low, y_high, width, height)
            y_ticks = ticks(y_low, y_high, max(2, round(height * 0.8)))
        self.set_xticks(ticks(x_low, x_high, max(2, width // 7)))
        self.set_yticks(y_ticks)
        self.set_xlimits(x_low, x_high)
        self.set_ylimits(y_low, y_high)


def _extent(parts: Sequence[Any]) -> tuple[float, float]:
    values = np.concatenate([np.asarray(part, float).ravel() for part in parts])
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if values.size else (math.nan, math.nan)


def ticks(low: float, high: float, most: int) -> list[float]:
    """At most so many places at 1, 2 or 5 times a power of ten."""
    span = high - low
    if not span > 0:
        return [low]
    power = 10.0 ** math.floor(math.log10(span / most))
    step = next((n * power for n in (1, 2, 5, 10, 20) if span / (n * power) <= most), 50 * power)
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [n * step for n in range(first, last + 1)]


def _round(x_low: float, x_high: float, y_low: float, y_high: float, width: int, height: int) -> tuple[float, float, float, float]:
    """Limits with which a circle is round."""
    scale = max((x_high - x_low) / width, (y_high - y_low) / (height * ROUND)) or 1.0
    x, y = (x_low + x_high) / 2, (y_low + y_high) / 2
    return x - scale * width / 2, x + scale * width / 2, y - scale * height * ROUND / 2, y + scale * height * ROUND / 2
