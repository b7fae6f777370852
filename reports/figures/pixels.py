# SPDX-License-Identifier: Apache-2.0
"""A figure of the report as a picture of pixels, for a terminal that can show one."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter

from calc.locale import Language
from calc.sheet.expression import plain
from calc.sheet.step import Curve

from .arrows import ARROW
from .plots import Plots, bar_colour, filled, limit_style, limits, series_label, series_style, tick_words

if TYPE_CHECKING:
    from numpy import uint8
    from numpy.typing import NDArray

DPI = 144
LEGEND = 7.0  # points
LEFT, RIGHT, LOW, TOP = 50.0, 14.0, 32.0, 20.0  # points around the axes


def pixels(curve: Curve, width: float, height: float, say: Language) -> NDArray[uint8]:
    """The figure as rows of red, green, blue; `width` and `height` in points.  The curve's texts are said in the
    language already."""
    axes = _made(curve, width, height, say)
    axes.figure.set_dpi(DPI)
    canvas: Any = FigureCanvasAgg(axes.figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[:, :, :3]


def png(curve: Curve, width: float, height: float, say: Language) -> bytes:
    """The same as a PNG file."""
    axes = _made(curve, width, height, say)
    file = io.BytesIO()
    axes.figure.savefig(file, format="png", dpi=DPI)
    return file.getvalue()


def _made(curve: Curve, width: float, height: float, say: Language) -> Any:
    """Axes with everything in them that a page writes beside them: numbers, names, title, legend."""
    axes = Plots(say).axes(width, height, curve)
    axes.figure.set_facecolor("white")
    axes.tick_params(labelleft=True, labelbottom=True, labelsize=LEGEND)
    for arrow in filled(axes, curve):
        ends = {"xy": (arrow.tip.imag, arrow.tip.real), "xytext": (arrow.tail.imag, arrow.tail.real)}
        axes.annotate("", **ends, arrowprops={"arrowstyle": "-|>", "color": ARROW, "lw": 0.9})
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(FuncFormatter(lambda value, _: say.number(tick_words([value])[0])))
    axes.set_xlabel(plain(curve.x_label), fontsize=LEGEND)
    axes.set_ylabel(plain(curve.y_label), fontsize=LEGEND)
    axes.set_title(plain(curve.title), fontsize=LEGEND + 2, loc="left")
    shown: list[Any] = [
        Line2D([], [], color=colour, lw=thick, ls="--" if dashes else "-", label=series_label(curve, series))
        for i, series in enumerate(curve.series)
        if series_label(curve, series) and not curve.bars
        for colour, dashes, thick in [series_style(curve, i)]
    ]
    shown += [
        Patch(facecolor=bar_colour(i), label=s.label) for i, s in enumerate(curve.series) if curve.bars and s.label
    ]
    shown += [
        Line2D([], [], color=limit_style(i)[0], ls="-.", label=label) for i, (label, _) in enumerate(limits(curve))
    ]
    if shown:
        axes.legend(handles=shown, fontsize=LEGEND, frameon=False, loc="best")
    axes.set_position((LEFT / width, LOW / height, 1 - (LEFT + RIGHT) / width, 1 - (LOW + TOP) / height))
    return axes
