# SPDX-License-Identifier: Apache-2.0
"""The picture of a step: its sketch, drawn anew for each result, size and edited field, and turned with the crank where
it can be."""

import math
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, ClassVar

from textual.binding import Binding, BindingType
from textual.content import Content
from textual.timer import Timer
from textual.widget import Widget

from calc.design.model import TITLES, Design
from calc.draw.drawing import Sketch
from calc.sheet.text import EMPTY, Text

from ..actions import bound
from ..base_app import BaseApp

if TYPE_CHECKING:
    from calc.solve import Results

STEP, PRESSED = 20, 10  # degrees that the crank turns by itself at a time, and by a key
RATE = 10.0  # times a second
KEPT = 40  # drawings; a whole turn
WAITS = Text("The picture waits for the results of the step {step}.")
FAILED = Text("The picture of this step cannot be drawn.")
MORE = Text("{walk_back} {walk_on} other pictures")


class Picture(Widget, can_focus=True):
    """`degrees`: the crank angle of sketches that turn."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", f"turn(-{PRESSED})", "Turn back", show=False),
        Binding("right", f"turn({PRESSED})", "Turn", show=False),
        bound("walk_back", "leaf(-1)"),
        bound("walk_on", "leaf(1)"),
        Binding("space", "halt", "Halt and go on", show=False),
    ]

    def __init__(self, id: str | None = "picture-drawing") -> None:
        super().__init__(id=id)
        self.step, self.lit = "", ""
        self.design: Design | None = None
        self.results: Results | None = None
        self.degrees = 0
        self.turns = False  # whether the sketch depends on the crank's angle
        self.view, self.views = 0, 1  # which of the sketch's pictures comes first, of so many
        self._drawn: dict[tuple[object, ...], tuple[Content, bool]] = {}
        self._clock: Timer | None = None
        self._halted = False

    # --- what is shown
    def show(self, step_key: str, design: Design | None, results: "Results | None", lit_key: str = "") -> None:
        """The sketch of a step; what the field of `lit_key` changes is lit."""
        if results is not self.results or design is not self.design:
            self._drawn.clear()
        if (step_key, design, results, lit_key) != (self.step, self.design, self.results, self.lit):
            self.view = self.view if step_key == self.step else 0
            self.step, self.design, self.results, self.lit = step_key, design, results, lit_key
            self.refresh()

    def render(self) -> Content:
        columns, rows = self.size
        key = (self.step, columns, rows, self.lit, self.degrees, self.view, self.app.signs)
        if key not in self._drawn:
            if len(self._drawn) >= KEPT:
                self._drawn.clear()
            self._drawn[key] = self._draw(columns, rows)
        drawing, self.turns = self._drawn[key]
        return drawing

    def _draw(self, columns: int, rows: int) -> tuple[Content, bool]:
        """The picture, and whether it turns with the crank."""
        from .canvas import draw

        signs, say = self.app.signs, self.app.say
        try:
            sketch = sketch_of(self.step, self.design, self.results, math.radians(self.degrees), self.view)
            if isinstance(sketch, Sketch):
                self.views = sketch.views
                lit = self.design.as_in_rules(self.lit) if self.design is not None else self.lit
                sketch = sketch if self.view else self._with(lit, sketch)
                key = self.app.shown_key
                more = Text(MORE.template, walk_back=key("walk_back"), walk_on=key("walk_on"))
                return draw(sketch, columns, rows, signs, say, lit, more), sketch.turning
        except Exception:  # a picture that cannot be drawn never stops the work that it shows
            sketch = FAILED
        return Content.styled(say(sketch), signs.style("muted")), False

    def _with(self, lit: str, sketch: Sketch) -> Sketch:
        """Where nothing of a picture is lit, one that stands apart on paper and has what is, if there is one."""
        if not lit or shows(lit, *(part for part in (sketch, *sketch.beside) if not part.caption)):
            return sketch
        angle = math.radians(self.degrees)
        others = (sketch_of(self.step, self.design, self.results, angle, view) for view in range(1, sketch.views))
        apart = (other for other in others if isinstance(other, Sketch) and other.caption)
        return next((other for other in apart if shows(lit, other)), sketch)

    # --- turning
    def action_turn(self, by: int) -> None:
        if self.turns:
            self.degrees = (self.degrees + by) % 360
            self.refresh()

    def action_leaf(self, by: int) -> None:
        self.view = (self.view + by) % self.views
        self.refresh()

    def action_halt(self) -> None:
        if self._clock is not None:
            (self._clock.resume if self._halted else self._clock.pause)()
            self._halted = not self._halted

    def on_focus(self) -> None:
        if self.app.animation_level != "none":
            self._clock = self._clock or self.set_interval(1 / RATE, lambda: self.action_turn(STEP))
            self._clock.resume()

    def on_blur(self) -> None:
        if self._clock is not None:
            self._clock.pause()


def shows(lit: str, *pictures: Sketch) -> bool:
    """Whether one of the pictures has something that the input changes."""
    from .canvas import covers

    return any(covers(key, lit) for part in pictures for mark in part.primitives for key in mark.key.split())


def sketch_of(
    step: str, design: Design | None, results: "Results | None", angle: float, view: int = 0
) -> Sketch | Text:
    """The sketch of a step at a crank angle, its picture `view` first, or what it waits for."""
    if not step or design is None:
        return EMPTY
    outcome = results.outcomes.get(step) if results is not None else None
    if getattr(design, step) is None:
        return EMPTY  # it is not built yet, as the form says
    if outcome is None or outcome.result is None:
        return Text(WAITS.template, step=TITLES[step])
    make: Callable[..., Sketch] = import_module(f"calc.{step}.sketch").sketch
    sketch = make(design, results)
    if sketch.views > 1:
        return make(design, results, angle=angle, view=view % sketch.views)
    return make(design, results, angle=angle) if sketch.turning and angle else sketch
