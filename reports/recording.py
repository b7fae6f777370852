# SPDX-License-Identifier: Apache-2.0
"""What is drawn in a frame of its own and placed on a page afterwards.

A figure is the same wherever it stands.  So all of them can be drawn before there are pages, and by a copy of this process while it makes
the rest: the copy sends its recordings back, and what draws them, which takes longest to load, is not loaded here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from calc.sheet.aside import aside

from .boxes import Box
from .paper import LEFT

if TYPE_CHECKING:
    from .pen import Pen


@dataclass(frozen=True, slots=True)
class Recording:
    """`code`: lines and areas as operators of PDF, from the lower left corner of the frame; `words`: boxes with their places from there,
    and whether they are turned."""

    code: str
    words: tuple[tuple[Box, float, float, bool], ...]

    def place(self, pen: Pen, x: float, y: float) -> None:
        """Put it on a page with its corner there; x from the left margin."""
        pen.figure(lambda: pen.canvas._code.append(f"q 1 0 0 1 {LEFT + x:.2f} {y:.2f} cm\n{self.code}\nQ"))
        for box, a, b, turned in self.words:
            (pen.turn if turned else pen.put)(box, x + a, y + b)


class Recorder:
    """Takes down what is drawn into a frame, as a pen does for a page."""

    def __init__(self) -> None:
        self.code: list[str] = []
        self.words: list[tuple[Box, float, float, bool]] = []

    def put(self, box: Box, x: float, y: float) -> None:
        """Place a box with its base line at this height."""
        self.words.append((box, float(x), float(y), False))

    def turn(self, box: Box, x: float, y: float) -> None:
        """Place a box turned a quarter to the left, reading upwards from here."""
        self.words.append((box, float(x), float(y), True))

    @property
    def recording(self) -> Recording:
        return Recording("\n".join(self.code), tuple(self.words))


class Ahead:
    """Figures that are drawn together, ahead of the pages that they are placed on."""

    def __init__(self) -> None:
        self._asked: list[Callable[[], Recording]] = []
        self._drawn: Callable[[], list[Recording]] = cache(self._draw)

    def ask(self, draw: Callable[[], Recording]) -> Callable[[], Recording]:
        """Have a figure drawn; what is returned gives it once all are asked for, and may have to wait for it."""
        n = len(self._asked)
        self._asked.append(draw)
        return lambda: self._drawn()[n]

    def begin(self) -> None:
        """All are asked for: they are drawn meanwhile, where that can be, else when the first is placed."""
        self._drawn = cache(aside(self._draw))

    def _draw(self) -> list[Recording]:
        return [draw() for draw in self._asked]
