# SPDX-License-Identifier: Apache-2.0
"""The heading of what is folded: `▸ More (18): cylinder offset, firing order, …`.  Enter or → opens it, ← closes it."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.widget import Widget

from calc.sheet.text import Text

from ..base_app import BaseApp
from ..session.places import content_at
from ..session.route import ROUTE
from ..session.session import Session
from .entry import LEAVING
from .rows import Row
from .text import fit


class Fold(Widget, can_focus=True):
    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("enter,space", "turn", "Open or close", show=False),
        Binding("right", "turn(True)", "Open", show=False),
        Binding("left", "turn(False)", "Close", show=False),
    ]
    HELP = Text("Enter or → opens it, ← closes it. What is left empty in it, the program assumes.")

    @dataclass
    class Turned(Message):
        fold: "Fold"
        open: bool

    def __init__(self, row: Row, session: Session) -> None:
        super().__init__(classes="" if row.place[-1] == "+0" else "-further")
        self.row = row
        self.session = session
        self._looks: tuple[object, ...] = ()

    def redraw(self, row: Row) -> None:
        self.row = row
        looks = (row.open, self._title(), row.inside)
        if looks != self._looks:
            self._looks = looks
            self.refresh()

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        return str(self.row.about.label), f"{self.app.say(self.HELP)} {', '.join(self._names())}."

    def _title(self) -> str:
        """How many inputs lie in it, and how many of them are left to the program."""
        cells = (cell for row in self.row.inside for cell in (row.inside or (row,)) if cell.kind == "field" and cell.place[0] in ROUTE)
        assumed = sum(cell.about.optional and content_at(self.session.data, cell.place) is None for cell in cells)
        title = f"{self.row.about.label} ({len(self.row.inside)})"
        return f"{title}, {self.app.say(Text('assumed ({n})', n=assumed))}" if assumed and self.row.open else title

    def _names(self) -> list[str]:
        names = [str(row.about.label) for row in self.row.inside if len(row.place) == 2 or row.kind == "field"]
        return [name if name[1:2].isupper() else name[:1].lower() + name[1:] for name in dict.fromkeys(names)]

    def render(self) -> Content:
        mark = self.app.signs.mark("unfolded" if self.row.open else "folded")
        title = f" {mark} {self._title()}"
        rest = "" if self.row.open else fit(f": {', '.join(self._names())}", max(0, self.size.width - len(title) - 1))
        return Content.assemble((title, "bold"), (rest, "dim"))

    def action_turn(self, open: bool | None = None) -> None:
        wanted = not self.row.open if open is None else open
        if wanted != self.row.open:
            self.post_message(self.Turned(self, wanted))

    def on_click(self, event: events.Click) -> None:
        event.stop()
        self.focus()
        self.action_turn()

    def on_focus(self, event: events.Focus) -> None:
        self.refresh()

    def on_blur(self, event: events.Blur) -> None:
        self.refresh()
