# SPDX-License-Identifier: Apache-2.0
"""One curve of the step.  The plotting library is loaded when there is something to plot, never before the first picture."""

from typing import TYPE_CHECKING, Any, ClassVar

from textual.binding import Binding, BindingType
from textual.content import Content
from textual.widgets import Static

from calc.sheet.step import Curve

from .pane import Pane
from .wrap import fit

if TYPE_CHECKING:
    from ..app import ContralberoApp


class CurvePane(Pane, can_focus=True):
    app: "ContralberoApp"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", "turn(-1)", "Curve before", show=False),
        Binding("right,space", "turn(1)", "Next curve", show=False),
    ]

    def __init__(self) -> None:
        self.legend = Static(id="curve-legend")
        super().__init__("Curve", self.legend, id="curve")
        self.curves: tuple[Curve, ...] = ()
        self.chosen: dict[str, str] = {}  # step → id of the curve that was chosen
        self.step = ""
        self._plot: Any = None
        self._written = ""
        self._drawn: Curve | None = None
        self._looks: tuple[Any, ...] = ()

    @property
    def target(self) -> "CurvePane":
        return self

    def show(self, step: str, curves: tuple[Curve, ...]) -> None:
        self.step, self.curves = step, curves
        self.draw()

    @property
    def curve(self) -> Curve | None:
        wanted = self.chosen.get(self.step)
        return next((c for c in self.curves if c.id == wanted), self.curves[0] if self.curves else None)

    def action_turn(self, by: int) -> None:
        if self.curve is not None:
            self.chosen[self.step] = self.curves[(self._number(self.curve) + by) % len(self.curves)].id
            self.draw()

    def _number(self, curve: Curve) -> int:
        return next(n for n, c in enumerate(self.curves) if c is curve)

    def on_resize(self) -> None:
        super().on_resize()
        self.draw()

    def draw(self) -> None:
        """Draw the chosen curve, if it is not the one that stands there."""
        curve = self.curve
        if not self.is_mounted or not self.display:
            return
        looks = (self.size, self.app.theme)
        if curve is self._drawn and looks == self._looks:
            return
        self._drawn, self._looks = curve, looks
        if curve is None:
            self.set_title("Curve", "none in this step")
            self._written = ""
            self.legend.update("")
            if self._plot is not None:
                self._plot.display = False
            return
        count = f"{self._number(curve) + 1} of {len(self.curves)}"
        self.set_title(curve.title, count if len(self.curves) > 1 else "")
        self._legend(curve)
        if self._plot is None:
            from .plot import Plot

            self._plot = Plot()
            self.mount(self._plot)
        self._plot.display = True
        self.call_after_refresh(self._fill, curve)

    def _legend(self, curve: Curve) -> None:
        signs = self.app.signs
        parts: list[Content | str] = []
        mark = "-" if signs.ascii else "━"
        if len(curve.series) > 1 or curve.series[0].label:
            for n, series in enumerate(curve.series):
                parts += [Content.styled(f"{mark} {series.label}", signs.line(n)), "  "]
        for name, limit in curve.limits:
            parts += [Content.styled(f"{mark} {name} {limit:.4g}", signs.style("fail")), "  "]
        width = max(10, self.size.width - 2)
        axes = fit(f"{curve.y_label} over {curve.x_label}", width)
        line = Content.assemble(*parts)
        gap = width - line.cell_length - len(axes)
        made = Content.assemble(" ", line, "\n " if gap < 0 and parts else " " * max(0, gap), (axes, "dim"))
        if made.markup != self._written:
            self._written = made.markup
            self.legend.update(made)

    def _fill(self, curve: Curve) -> None:
        if curve is self.curve and self._plot is not None:
            self._plot.draw(curve, self.app.signs)
