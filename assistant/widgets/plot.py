# SPDX-License-Identifier: Apache-2.0
"""The drawing of a curve.  Imported only when there is one: it brings numpy and the plotting library with it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.segment import Segment
from textual import events
from textual.app import ComposeResult
from textual.containers import Grid
from textual.content import Content
from textual.strip import Strip
from textual.widgets import Static
from textual_hires_canvas import Canvas
from textual_plot import HiResMode, NumericAxisFormatter, PlotWidget
from textual_plot.plot_widget import Legend, LinePlot

from calc.sheet.step import Curve

from ..base_app import BaseApp
from .curve_view import TURN, Sight, even_ticks, stand_below, ticks
from .reading import axis, finite_limits
from .residual_strip import BAR, PLAIN_BAR, PLAIN_POINT, POINT, bars_of, strip
from .signs import Look, Signs

if TYPE_CHECKING:
    from .reading import Reading

ROUND = 2.0  # how much higher than wide a cell of a terminal is
ROOM = 0.04  # of the height, above and below
DOTS = np.array([2.0, 4.0])  # of braille in a cell, across and down
# of each pattern, in dots: drawn, left out; the last a chain
DASHES = ((1.0, 0.0), (4.0, 3.0), (1.0, 2.5), (7.0, 2.0, 1.0, 2.0))
MOST_DECIMALS = 9  # of a tick
TURNS = 2  # cells after which lines that run over each other take turns
EIGHTHS = " ▁▂▃▄▅▆▇█"
Cell = tuple[int, int]  # column and row


class Numbers(NumericAxisFormatter):
    """Labels with as many digits as the ticks have (22.5, which the library writes 22), and with a true minus sign."""

    def get_labels_for_ticks(self, ticks: Sequence[float]) -> list[str]:
        small = 1e-6 * max((abs(b - a) for a, b in pairwise(ticks)), default=max(map(abs, ticks), default=0.0))
        decimals = next(
            (n for n in range(MOST_DECIMALS) if all(abs(round(tick, n) - tick) <= small for tick in ticks)),
            MOST_DECIMALS,
        )
        return [f"{tick + 0.0:.{decimals}f}".replace("-", "−") for tick in ticks]


PLAIN = str.maketrans({**dict.fromkeys("┏┓┗┛┣┫┳┻╋", "+"), "━": "-", "┃": "|", "█": "*", "−": "-"})


class PlotArea(Canvas):
    """A canvas whose rows always have a style: where colours are switched off, a row without one stops the program."""

    app: BaseApp

    def on_resize(self) -> None:
        """The plot may have been drawn before its margins had their new size."""
        self.query_ancestor(Plot).fit()

    def render_line(self, y: int) -> Strip:
        strip = super().render_line(y)
        if not strip.cell_length:
            return Strip.blank(self.size.width, self.rich_style)
        return Strip([Segment(s.text.translate(PLAIN), s.style) for s in strip]) if self.app.signs.ascii else strip


@dataclass
class PlottedLine(LinePlot):
    """`series`: a line of the curve, which may run over others; not a limit or a vector, which stand above them."""

    look: Look
    series: bool = False


@dataclass
class Bars:
    """One series of a bar chart: `number` of `count` in each group."""

    x: Any
    y: Any
    number: int
    count: int
    look: Look


class Plot(PlotWidget, can_focus=False, inherit_bindings=False):
    """Braille lines, or bars, in a frame; the labels of the axes stand above, in the legend."""

    app: BaseApp

    def __init__(self) -> None:
        super().__init__(allow_pan_and_zoom=False)
        self.set_reactive(PlotWidget.margin_top, 0)
        self.set_reactive(PlotWidget.margin_bottom, 1)
        self.set_x_formatter(Numbers())
        self.set_y_formatter(Numbers())
        self.bars: list[Bars] = []
        self.marks: list[tuple[complex, str, str]] = []  # place, sign and its colour, if it has one of its own
        self.reading: Reading | None = None
        self._taken: dict[Cell, tuple[str, str]] = {}  # character and colour of the cells that series run through
        self._shown: tuple[Sight, Signs] | None = None
        self.strip: Static | None = None  # below it, of the residuals of what was measured

    def on_mount(self, event: events.Mount | None = None) -> None:
        if event is not None and not self.query(Grid):  # the end of the program came before its parts
            event.prevent_default()

    def compose(self) -> ComposeResult:
        with Grid():
            for name in ("margin-top", "margin-left", "plot", "margin-bottom"):
                yield PlotArea(1, 1, id=name)
        yield Legend(id="legend")

    def render(self) -> Any:
        super().render()
        return Content("")

    def fit(self) -> None:
        """Draw anew on canvases whose size has changed."""
        self._needs_canvas_resize = True
        self._rerender()

    def on_resize(self) -> None:
        """True scale and ticks depend on the room, and that on the rows of the legend too."""
        self._needs_canvas_resize = True
        if self._shown is not None:
            self.draw(*self._shown, self.reading)

    def pointed_at(self, x: float, y: float) -> tuple[float, float, float, float] | None:
        """A place of the screen in the numbers of the curve, and how far a cell reaches there; None outside the
        frame."""
        canvas, room = self.query_one("#plot", Canvas), self._scale_rectangle
        column, row = int(x) - canvas.region.x, int(y) - canvas.region.y
        if not room.area or not room.contains(column, row):
            return None
        across, up = (self._x_max - self._x_min) / room.width, (self._y_max - self._y_min) / room.height
        return (*self.get_coordinate_from_pixel(column, row), across, up)

    # --- content
    def draw(self, sight: Sight, signs: Signs, reading: "Reading | None" = None) -> None:
        """What is seen of a curve, in the space that there is.  The axes span all variants and all crank angles."""
        self._shown, self.reading = (sight, signs), reading
        curve = sight.curve
        self.clear()
        self.bars, self.marks = [], []
        x_low, x_high, y_low, y_high = extent(curve)
        if not all(map(math.isfinite, (x_low, x_high, y_low, y_high))):
            return
        for n, series in enumerate(sight.series):
            x, y = np.asarray(series.x, float), np.asarray(series.y, float)
            whole = np.isfinite(x) & np.isfinite(y)
            if curve.bars:
                self.bars.append(Bars(x[whole], y[whole], n, len(sight.series), signs.look(n)))
            elif whole.any():
                self._line(x[whole], y[whole], signs.look(n, sight.series), series=True)
        for _, limit in finite_limits(curve):
            self._line(np.array([x_low, x_high]), np.array([limit, limit]), signs.limit())
        self._vectors(sight, signs)
        if curve.point is not None:
            mark = (signs.mark("fail"), signs.limit().colour) if curve.fails else ("@" if signs.ascii else "●", "")
            self.marks.append((complex(curve.point[1], curve.point[0]), *mark))
        room = ROOM * (y_high - y_low) or 0.5 * abs(y_high) or 1.0
        y_low, y_high = y_low - (room if y_low or not curve.bars else 0.0), y_high + room
        if x_low == x_high:
            x_low, x_high = x_low - (abs(x_low) or 1.0) / 2, x_high + (abs(x_high) or 1.0) / 2
        height = max(2, self.size.height - self.margin_bottom - 2)
        grounded = curve.bars and y_low == 0.0
        even_low, even_high, y_ticks = even_ticks(y_low, y_high, height, grounded=grounded)
        self.margin_left = 2 + max(map(len, self._y_formatter.get_labels_for_ticks(y_ticks)), default=4)
        width = max(4, self.size.width - self.margin_left - 2)
        if curve.equal:
            x_low, x_high, y_low, y_high = _round(x_low, x_high, y_low, y_high, width, height)
            even_low, even_high, y_ticks = even_ticks(y_low, y_high, height)
            wider = (x_high - x_low) / 2 * ((even_high - even_low) / (y_high - y_low) - 1)
            x_low, x_high = x_low - wider, x_high + wider
        y_low, y_high = even_low, even_high
        places = [x for x in places_of(curve) if x_low <= x <= x_high] if curve.bars else []
        round_ = axis(curve.x_label)[1] == "°" and not curve.equal
        self.set_xticks(
            places if 0 < len(places) <= width // 3 else ticks(x_low, x_high, max(2, width // 7), degrees=round_)
        )
        self.set_yticks(y_ticks)
        self.set_xlimits(x_low, x_high)
        self.set_ylimits(y_low, y_high)

    def _line(self, x: Any, y: Any, look: Look, *, series: bool = False) -> None:
        self._datasets.append(PlottedLine(x, y, None if look.plain else HiResMode.BRAILLE, look.colour, look, series))
        self._labels.append(None)

    def _vectors(self, sight: Sight, signs: Signs) -> None:
        """The vectors tip to tail: real is up, imaginary to the right."""
        n = len(sight.series)
        for chain in sight.chains:
            points = chain.at(math.radians(sight.degrees))
            for tail, tip in pairwise(points):
                self._line(np.array([tail.imag, tip.imag]), np.array([tail.real, tip.real]), signs.look(n))
                n += 1
            self.marks += [(points[0], "+" if signs.ascii else "┼", ""), (points[-1], "@" if signs.ascii else "●", "")]

    # --- drawing
    def _render_plot(self) -> None:
        self._taken.clear()
        super()._render_plot()
        canvas = self.query_one("#plot", Canvas)
        if canvas._canvas_size is None or self._scale_rectangle.area == 0:
            return
        for bars in self.bars:
            self._render_bars(canvas, bars)
        style = str(self.get_component_rich_style("plot--tick"))
        self._name_limits(canvas)
        self._render_measured(canvas, style)
        for point, char, colour in self.marks:
            canvas.set_pixel(*self.get_pixel_from_coordinate(point.imag, point.real), char, colour or style)
        if self.reading is not None:
            self._render_cursor(canvas, self.reading, style)

    def _render_measured(self, canvas: Canvas, style: str) -> None:
        """What was measured: points on their bars, and below the plot the strip of the residuals."""
        if self._shown is None or (points := self._shown[0].curve.measured) is None:
            return
        (sight, signs), room = self._shown, self._scale_rectangle
        point, bar = (PLAIN_POINT, PLAIN_BAR) if signs.ascii else (POINT, BAR)
        for x, low, high in bars_of(points):
            column, bottom = self.get_pixel_from_coordinate(x, low)
            top = self.get_pixel_from_coordinate(x, high)[1]
            for row in range(max(top, room.y), min(bottom, room.bottom - 1) + 1):
                if room.contains(column, row):
                    canvas.set_pixel(column, row, bar, style)
        for x, y in zip(points.x.tolist(), points.y.tolist()):
            if room.contains(*(cell := self.get_pixel_from_coordinate(x, y))):
                canvas.set_pixel(*cell, point, style)
        if self.strip is not None:
            unit = axis(sight.curve.y_label)[1]
            left, width = self.margin_left, self.size.width

            def column_of(x: float) -> int:
                return int(self.get_pixel_from_coordinate(x, self._y_min)[0])

            rows = strip(points, unit, column_of, left, width, self.app.say, point)
            self.strip.update(Content("\n".join(rows)))

    def _render_x_ticks(self) -> None:
        """Ticks with their numbers below; a number at the edge is moved in, and one that would run into another is left
        out."""
        canvas, margin, room = (
            self.query_one("#plot", Canvas),
            self.query_one("#margin-bottom", Canvas),
            self._scale_rectangle,
        )
        margin.reset()
        axis_style, tick_style = (str(self.get_component_rich_style(f"plot--{part}")) for part in ("axis", "tick"))
        free, ticks_ = 0, [tick for tick in self._x_ticks or () if self._x_min <= tick <= self._x_max]
        labels = self._x_formatter.get_labels_for_ticks(ticks_)
        names = [str(name) for name in self._shown[0].curve.names] if self._shown is not None else []
        if stand_below(names, self.size.width) and ticks_ == list(range(1, len(names) + 1)):
            labels = names
        for tick, label in zip(ticks_, labels):
            column = min(max(self.get_pixel_from_coordinate(tick, self._y_min)[0], room.x), room.right - 1)
            for row, quad in ((0, (2, 0, 0, 0)), (room.bottom, (0, 0, 2, 0))):
                canvas.set_pixel(column, row, self.combine_quad_with_pixel(quad, canvas, column, row), style=axis_style)
            left = min(column + self.margin_left - len(label) // 2, margin.size.width - len(label))
            if left >= free:
                for n, char in enumerate(label):
                    margin.set_pixel(left + n, 0, char, tick_style)
                free = left + len(label) + 1

    def _name_limits(self, canvas: Canvas) -> None:
        """The name of each limit on its line, or beside it, where it covers nothing else; as far to the right as may
        be."""
        if self._shown is None:
            return
        (sight, signs), room = self._shown, self._scale_rectangle
        for name, limit in finite_limits(sight.curve):
            label = f" {name} "
            _, at = self.get_pixel_from_coordinate(self._x_min, limit)
            lefts = range(room.right - len(label) - 1, room.x, -1)
            places = ((row, left) for row in (at, at - 1, at + 1) if room.y <= row < room.bottom for left in lefts)
            candidates = ([(column, row) for column in range(left, left + len(label))] for row, left in places)
            cells = next((cells for cells in candidates if not any(cell in self._taken for cell in cells)), [])
            for cell, char in zip(cells, label):
                canvas.set_pixel(*cell, char, signs.limit().colour)
            self._taken.update({cell: canvas.get_pixel(*cell) for cell in cells})

    def _render_cursor(self, canvas: Canvas, reading: "Reading", style: str) -> None:
        """A line behind the curves where they are functions of x, and a mark on each of them."""
        assert self._shown is not None
        room, (sight, signs) = self._scale_rectangle, self._shown
        if self.bars:
            return
        if reading.x is not None:
            column, _ = self.get_pixel_from_coordinate(reading.x, self._y_min)
            for row in range(room.y, room.bottom):
                if canvas.get_pixel(column, row)[0] == " ":
                    canvas.set_pixel(column, row, "|" if signs.ascii else "│", style)
        for read in sorted(reading.reads, key=lambda read: read.number == reading.chosen):
            if math.isfinite(read.x) and math.isfinite(read.y):
                cell = self.get_pixel_from_coordinate(read.x, read.y)
                if room.contains(*cell):
                    look = signs.look(read.number, sight.series)
                    canvas.set_pixel(*cell, signs.point(read.number == reading.chosen), look.colour)

    def _render_line_plot(self, dataset: LinePlot) -> None:
        if not isinstance(dataset, PlottedLine) or not dataset.series:
            self._draw_line(dataset)
            return
        canvas, room = self.query_one("#plot", Canvas), self._scale_rectangle
        points = np.array([self.get_hires_pixel_from_coordinate(x, y) for x, y in zip(dataset.x, dataset.y)], float)
        cells = dict.fromkeys((math.floor(x), math.floor(y)) for x, y in _along(points))
        self._draw_line(dataset)
        for n, cell in enumerate(cell for cell in cells if cell in self._taken):
            if n // TURNS % 2:  # where lines run over each other they take turns, so that both are seen
                canvas.set_pixel(*cell, *self._taken[cell])
        self._taken.update({cell: canvas.get_pixel(*cell) for cell in cells if room.contains(*cell)})

    def _draw_line(self, dataset: LinePlot) -> None:
        if not isinstance(dataset, PlottedLine) or not (dataset.look.plain or dataset.look.pattern):
            super()._render_line_plot(dataset)
            return
        canvas, look = self.query_one("#plot", Canvas), dataset.look
        if look.plain:
            pixels = [self.get_pixel_from_coordinate(x, y) for x, y in zip(dataset.x, dataset.y)]
            for (x0, y0), (x1, y1) in pairwise(pixels):
                canvas.draw_line(x0, y0, x1, y1, look.plain, look.colour)
            return
        points = np.array([self.get_hires_pixel_from_coordinate(x, y) for x, y in zip(dataset.x, dataset.y)], float)
        if drawn := _along(points, *DASHES[look.pattern]):
            canvas.set_hires_pixels(drawn, HiResMode.BRAILLE, look.colour)

    def _render_bars(self, canvas: Canvas, bars: Bars) -> None:
        """Upright bars of whole cells in width; only a whole fill has a fine end."""
        room = self._scale_rectangle
        places = places_of(self._shown[0].curve) if self._shown is not None else []
        pitch = min(np.diff(places), default=1.0) * room.width / (self._x_max - self._x_min)
        wide = max(1, int((pitch - 1) / bars.count))
        scale = room.height / (self._y_max - self._y_min)
        zero = room.bottom - round(-self._y_min * scale)  # the row above which bars stand
        fine = not bars.look.plain and bars.look.pattern == 0
        for x, y in zip(bars.x, bars.y):
            left = self.get_pixel_from_coordinate(x, 0.0)[0] - bars.count * wide // 2 + bars.number * wide
            cells = abs(y) * scale
            full = int(cells) if fine and y > 0 else round(cells)
            column = [zero - 1 - i if y > 0 else zero + i for i in range(full)]
            drawn = [(row, bars.look.bar_mark) for row in column]
            if fine and y > 0 and (end := EIGHTHS[round((cells - full) * 8)]) != " ":
                drawn.append((zero - 1 - full, end))
            for row, char in drawn:
                for cell in range(left, left + wide):
                    if room.x <= cell < room.right and room.y <= row < room.bottom:
                        canvas.set_pixel(cell, row, char, bars.look.colour)
            self._mark_bar(canvas, bars, x, left + (wide - 1) // 2, min([row for row, _ in drawn], default=zero) - 1)

    def _mark_bar(self, canvas: Canvas, bars: Bars, x: float, column: int, row: int) -> None:
        """The mark of the cursor above a bar."""
        reading = self.reading
        if reading is None or reading.x != x or self._shown is None:
            return
        cell = column, max(row, self._scale_rectangle.y)
        if self._scale_rectangle.contains(*cell):
            canvas.set_pixel(
                *cell,
                self._shown[1].point(bars.number == reading.chosen),
                str(self.get_component_rich_style("plot--tick")),
            )


def _along(points: Any, *pattern: float) -> list[tuple[float, float]]:
    """Places along a line in cells, half a dot apart; of the dots of a `pattern` every other stretch is left out."""
    way = np.concatenate([[0.0], np.cumsum(np.hypot(*(np.diff(points, axis=0) * DOTS).T))])
    there = np.arange(0.0, way[-1], 0.5)
    if pattern:
        there = there[np.searchsorted(np.cumsum(pattern), there % sum(pattern), side="right") % 2 == 0]
    return [
        (float(x), float(y)) for x, y in zip(np.interp(there, way, points[:, 0]), np.interp(there, way, points[:, 1]))
    ]


def places_of(curve: Curve) -> list[float]:
    """Where the groups of a bar chart stand."""
    return sorted({float(x) for series in curve.series for x in series.x if math.isfinite(x)})


def extent(curve: Curve) -> tuple[float, float, float, float]:
    """What the axes of a curve have to hold, over all its variants and all crank angles: x from, to, y from, to."""
    xs: list[Any] = [s.x for s in curve.series]
    ys: list[Any] = [*(s.y for s in curve.series), [limit for _, limit in finite_limits(curve)]]
    if curve.equal:
        tips = [
            z for chain in curve.turning for degrees in range(0, 360, TURN) for z in chain.at(math.radians(degrees))
        ]
        xs, ys = [*xs, [z.imag for z in tips]], [*ys, [z.real for z in tips]]
    if (points := curve.measured) is not None:
        xs, ys = [*xs, points.x], [*ys, points.y, points.y - points.bar, points.y + points.bar]
    (x_low, x_high), (y_low, y_high) = _extent(xs), _extent(ys)
    if curve.bars:
        gap = min(np.diff(places_of(curve)), default=1.0) / 2
        x_low, x_high, y_low, y_high = x_low - gap, x_high + gap, min(y_low, 0.0), max(y_high, 0.0)
    return x_low, x_high, y_low, y_high


def _extent(parts: Sequence[Any]) -> tuple[float, float]:
    values = np.concatenate([np.asarray(part, float).ravel() for part in parts])
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if values.size else (math.nan, math.nan)


def _round(
    x_low: float, x_high: float, y_low: float, y_high: float, width: int, height: int
) -> tuple[float, float, float, float]:
    """Limits with which a circle is round; what lies at the right end has a cell of its own."""
    scale = max((x_high - x_low) / (width - 1), (y_high - y_low) / (height * ROUND)) or 1.0
    x, y = (x_low + x_high) / 2, (y_low + y_high) / 2
    return x - scale * width / 2, x + scale * width / 2, y - scale * height * ROUND / 2, y + scale * height * ROUND / 2
