# SPDX-License-Identifier: Apache-2.0
"""matplotlib drawn straight as the operators of PDF.

A `RendererBase` of matplotlib for what our figures consist of: lines and areas.  No conversion by way of another file,
the same bytes every time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.path import Path

from ..typesetting.boxes import EDGE

CAPS = {"butt": 0, "round": 1, "projecting": 2}
JOINS = {"miter": 0, "round": 1, "bevel": 2}


class LineRenderer(RendererBase):
    """Draws one figure of this size into `code`, from its lower left corner; one pixel is one point."""

    def __init__(self, code: list[str], width: float, height: float) -> None:
        super().__init__()
        self.code, self.width, self.height = code, width, height

    def get_canvas_width_height(self) -> tuple[float, float]:
        return self.width, self.height

    def flipy(self) -> bool:
        return False

    def points_to_pixels(self, points: Any) -> Any:
        return points

    # --- paths

    def draw_path(self, gc: GraphicsContextBase, path: Path, transform: Any, rgbFace: Any = None) -> None:
        thick = gc.get_linewidth()
        stroke = thick > 0 and gc.get_alpha() != 0 and gc.get_rgb()[3] > 0
        fill = rgbFace is not None and (len(rgbFace) < 4 or rgbFace[3] > 0)
        drawn = self._path(path, transform, simplify=path.should_simplify and not fill)
        if not drawn or not (stroke or fill):
            return
        self.code.append("q")
        if (clip := gc.get_clip_rectangle()) is not None:
            x, y, w, h = (number + EDGE for number in clip.bounds)
            self.code.append(f"{x:.2f} {y:.2f} {w:.2f} {h:.2f} re W n")
        if stroke:
            offset, dashes = gc.get_dashes()
            pattern = " ".join(f"{d:.2f}" for d in np.atleast_1d(dashes).tolist()) if dashes is not None else ""
            cap, join = CAPS[gc.get_capstyle()], JOINS[gc.get_joinstyle()]
            self.code.append(f"{_rgb(gc.get_rgb())} RG {thick:.2f} w {cap} J {join} j [{pattern}] {offset or 0:.2f} d")
        if fill:
            self.code.append(f"{_rgb(rgbFace)} rg")
        self.code += [drawn, {(True, True): "B", (True, False): "S", (False, True): "f"}[stroke, fill], "Q"]

    def _path(self, path: Path, transform: Any, *, simplify: bool) -> str:
        clean = path.cleaned(transform=transform, remove_nans=True, simplify=simplify)
        points, codes = (np.asarray(clean.vertices) + EDGE).tolist(), np.asarray(clean.codes).tolist()
        operators: list[str] = []
        i = 0
        while i < len(codes):
            x, y = points[i]
            match codes[i]:
                case Path.MOVETO:
                    operators.append(f"{x:.2f} {y:.2f} m")
                case Path.LINETO:
                    operators.append(f"{x:.2f} {y:.2f} l")
                case Path.CURVE3:  # as the cubic with the same shape
                    (a, b), (c, d), (e, f) = points[i - 1], points[i], points[i + 1]
                    cubic = (a + 2 * c) / 3, (b + 2 * d) / 3, (e + 2 * c) / 3, (f + 2 * d) / 3, e, f
                    operators.append(" ".join(f"{v:.2f}" for v in cubic) + " c")
                    i += 1
                case Path.CURVE4:
                    operators.append(" ".join(f"{v:.2f}" for p in points[i : i + 3] for v in p) + " c")
                    i += 2
                case Path.CLOSEPOLY:
                    operators.append("h")
            i += 1
        return " ".join(operators)

    def draw_image(self, gc: GraphicsContextBase, x: float, y: float, im: Any, transform: Any = None) -> None:
        raise NotImplementedError("the report's figures are lines")

    def draw_text(self, gc: GraphicsContextBase, x: float, y: float, s: str, *args: Any, **kwargs: Any) -> None:
        raise NotImplementedError("the page sets the text of a figure, in the report's own letters")


def _rgb(colour: Any) -> str:
    return " ".join(f"{float(c):.3f}" for c in colour[:3])
