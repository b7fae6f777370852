# SPDX-License-Identifier: Apache-2.0
"""The last row: the keys, as the table of actions and the user's key map have them."""

from typing import TYPE_CHECKING

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from ..actions import ACTIONS, Action, key_name

if TYPE_CHECKING:
    from ..app import ContralberoApp


class FooterLine(Widget):
    """Textual's own footer is made anew at every change of the focus; this one stands still."""

    app: "ContralberoApp"

    def __init__(self) -> None:
        super().__init__(id="footer-line")

    def shown_key(self, action: Action) -> str:
        return key_name((self.app.key_map.get(action.id) or action.binding).split(",")[0])

    def render(self) -> Content:
        width = self.size.width
        wide = width >= 100
        shown = [a for a in ACTIONS if a.footer and (wide or not a.wide)]
        parts = []
        for action in shown:
            if action.id == "palette":
                continue
            parts.append(self._part(action))
        line = Content(" " if not wide else "  ").join(parts)
        left = Content.assemble(" ", line)
        if not wide:
            return left
        end = self._part(next(a for a in shown if a.id == "palette"))
        return Content.assemble(left, " " * max(1, width - left.cell_length - end.cell_length - 1), end)

    def _part(self, action: Action) -> Content:
        made = Content.assemble((self.shown_key(action), "bold $footer-key-foreground"), " ", action.footer)
        return made.stylize(Style.from_meta({"@click": f"screen.{action.does}"}))
