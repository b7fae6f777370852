# SPDX-License-Identifier: Apache-2.0
"""The last row: the keys, as the table of actions and the user's key map have them."""

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from ..actions import ACTIONS, BY_ID, Action
from ..base_app import BaseApp

# What goes first where there is not room for all, after what does nothing here.  F4 leads to the curve, and narrow to every pane.
SPARED = ("variant", "curve", "choose", "trouble")
SPARED_NARROW = ("variant", "curve", "choose", "pane", "trouble", "quit", "undo", "save", "report", "palette", "fix", "back")


class FooterLine(Widget):
    """Textual's own footer is made anew at every change of the focus; this one stands still."""

    app: BaseApp

    def __init__(self) -> None:
        super().__init__(id="footer-line")
        self.idle: tuple[str, ...] = ()  # actions that do nothing here

    def show(self, idle: tuple[str, ...]) -> None:
        if idle != self.idle:
            self.idle = idle
            self.refresh()

    def render(self) -> Content:
        width = self.size.width
        wide = width >= 100
        spared = [*self.idle, *(SPARED if wide else SPARED_NARROW)]
        least = 0 if wide else len(self.idle) + 1
        for gap, count in ((2, least), *((1, n) for n in range(least, len(spared) + 1))):
            shown = [a for a in ACTIONS if a.footer and a.id not in spared[:count]]
            end = self._part(BY_ID["palette"]) if BY_ID["palette"] in shown else Content("")
            left = Content(" " * gap).join(self._part(a) for a in shown if a.id != "palette")
            if left.cell_length + (end.cell_length + 3 if end else 0) <= width:
                break
        start = " " if left.cell_length < width else ""
        gap = width - len(start) - left.cell_length - end.cell_length - 1
        return Content.assemble(start, left, " " * gap, end) if end else Content.assemble(start, left)

    def _part(self, action: Action) -> Content:
        say, key = self.app.say, self.app.shown_key(action.id)
        part = Content.assemble((say(key), "bold $footer-key-foreground"), " ", say(action.footer))
        return part.stylize(Style.from_meta({"@click": f"screen.{action.does}"}))
