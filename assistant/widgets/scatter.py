# SPDX-License-Identifier: Apache-2.0
"""Points of two objectives in character cells: the drives of a front, the design as it is, and the one under the cursor."""

from dataclasses import dataclass

from textual.content import Content
from textual.widget import Widget

from ..base_app import BaseApp
from .text import fit, pad

DOT, NOW, PICKED = "·", "+", "◆"
PLAIN = {DOT: ".", NOW: "+", PICKED: "@"}
LEFT = 9  # cells of the numbers beside the frame


@dataclass(frozen=True)
class Points:
    """`x` and `y` of every drive by its number; `now`: of the design as it is, where it has them; `fails`: whether a limit of it does."""

    across: str
    up: str
    drives: dict[int, tuple[float, float]]
    now: tuple[float, float] | None = None
    fails: bool = False


class Scatter(Widget):
    """Redrawn whole: a front has a few dozen points."""

    app: BaseApp

    def __init__(self) -> None:
        super().__init__(id="scatter")
        self.points: Points | None = None
        self.picked = 0

    def show(self, points: Points, picked: int) -> None:
        self.points, self.picked = points, picked
        self.refresh()

    def render(self) -> Content:
        points, (width, height) = self.points, self.size
        columns, rows = width - LEFT - 1, height - 2
        if points is None or not points.drives or columns < 8 or rows < 3:
            return Content("")
        every = [*points.drives.values(), *([points.now] if points.now is not None else [])]
        (left, right), (low, high) = (_ends([p[n] for p in every]) for n in (0, 1))
        cells: dict[tuple[int, int], tuple[str, str]] = {}

        def put(at: tuple[float, float], sign: str, style: str) -> None:
            column = round((at[0] - left) / (right - left) * (columns - 1))
            row = rows - 1 - round((at[1] - low) / (high - low) * (rows - 1))
            cells[row, column] = PLAIN[sign] if self.app.ascii else sign, style

        for at in points.drives.values():
            put(at, DOT, "")
        if points.now is not None:
            put(points.now, NOW, self.app.signs.style("fail") if points.fails else "bold")
        if self.picked in points.drives:
            put(points.drives[self.picked], PICKED, self.app.signs.style("ready"))
        bar = "|" if self.app.ascii else "│"
        lines = [Content.styled(fit(f"{pad('', LEFT - 1)}{points.up}", width), "dim")]
        for row in range(rows):
            number = high if row == 0 else low if row == rows - 1 else None
            start = Content.styled((f"{number:.4g} " if number is not None else "").rjust(LEFT) + bar, "dim")
            lines.append(Content.assemble(start, *(cells.get((row, column), (" ", "")) for column in range(columns))))
        foot = f"{left:.4g}".ljust(columns - len(f"{right:.4g}")) + f"{right:.4g}"
        middle = (columns - len(points.across)) // 2
        if middle > len(f"{left:.4g}") + 1:
            foot = foot[:middle] + points.across + foot[middle + len(points.across) :]
        lines.append(Content.styled(" " * LEFT + foot, "dim"))
        return Content("\n").join(lines[:height])


def _ends(numbers: list[float]) -> tuple[float, float]:
    low, high = min(numbers), max(numbers)
    room = (high - low) * 0.04 or abs(low) * 0.01 or 1.0
    return low - room, high + room
