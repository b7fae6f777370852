# SPDX-License-Identifier: Apache-2.0
"""The last row: the keys, as the table of actions and the user's key map have them."""

from typing import TYPE_CHECKING

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from ..actions import ACTIONS, BY_ID, Action

if TYPE_CHECKING:
    from ..app import ContralberoApp

SPARED = ("variant", "curve", "trouble")  # what goes first where even wide is not wide enough


class FooterLine(Widget):
    """Textual's own footer is made anew at every change of the focus; this one stands still."""

    app: "ContralberoApp"

    def __init__(self) -> None:
        super().__init__(id="footer-line")

    def render(self) -> Content:
        width = self.size.width
        wide = width >= 100
        shown = [a for a in ACTIONS if a.footer and (wide or not a.wide) and a.id != "palette"]
        end = self._part(BY_ID["palette"]) if wide else Content("")
        for gap, left_out in ((1 if not wide else 2, ()), (1, ()), (1, SPARED[:1]), (1, SPARED[:2]), (1, SPARED)):
            line = Content(" " * gap).join(self._part(a) for a in shown if a.id not in left_out)
            left = Content.assemble(" ", line)
            if not wide or left.cell_length + end.cell_length + 2 <= width:
                break
        return Content.assemble(left, " " * max(1, width - left.cell_length - end.cell_length - 1), end) if wide else left

    def _part(self, action: Action) -> Content:
        made = Content.assemble((self.app.shown_key(action.id), "bold $footer-key-foreground"), " ", action.footer)
        return made.stylize(Style.from_meta({"@click": f"screen.{action.does}"}))
