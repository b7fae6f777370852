# SPDX-License-Identifier: Apache-2.0
"""What is drawn in a frame of its own and placed on a page afterwards.

A figure is the same wherever it stands, so it can be drawn before there are pages.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from .setting.boxes import Box
from .paper import LEFT

if TYPE_CHECKING:
    from .setting.pen import Pen


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
