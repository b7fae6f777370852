# SPDX-License-Identifier: Apache-2.0
"""Which panes are on the screen: all beside each other, or one alone."""

from textual.containers import Vertical
from textual.content import Content
from textual.screen import Screen
from textual.style import Style

from calc.languages import Language
from calc.sheet.text import Text

from ..widgets.curve_pane import CurvePane
from ..widgets.pane import Pane

PANES = ("steps", "inputs", "checks", "calculation", "curve")
VIEWS = {"inputs": Text("Inputs"), "checks": Text("Checks"), "calculation": Text("Calc"), "curve": Text("Plot")}


class PaneLayout:
    """`pane` has, or had last, the focus; `large`: it stands alone on a wide screen."""

    def __init__(self, screen: Screen[None]) -> None:
        self._screen = screen
        self.begin()

    def begin(self) -> None:
        self.pane, self.large = "inputs", False

    @property
    def wide(self) -> bool:
        """Whether there is room for all panes beside each other."""
        return self._screen.has_class("-wide")

    @property
    def single(self) -> bool:
        """One pane at a time."""
        return self.large or not self.wide

    def set_out(self, say: Language) -> None:
        """Show the panes that belong on the screen.  Done here and not by the style sheet, which would restyle every field."""
        screen, single = self._screen, self.single
        shown = "inputs" if self.pane == "steps" and not self.wide else self.pane
        screen.query_one("#results", Vertical).display = not single or shown in ("checks", "calculation", "curve")
        for pane in screen.query(Pane):
            alone = single and pane.id == shown
            pane.display = alone or not single
            pane.set_class(alone, "-single")
            pane.mark(pane.id == self.pane)
            pane.set_title(views=_views(shown, say) if alone and not self.wide else Content(""))
        if not single or shown == "curve":
            screen.call_after_refresh(screen.query_one(CurvePane).draw)


def _views(shown: str, say: Language) -> Content:
    """The names of the views, for a narrow screen."""
    parts = [
        Content.styled(say(word), "bold" if name == shown else "not bold dim").stylize(
            Style.from_meta({"@click": f"screen.to_view('{name}')"})
        )
        for name, word in VIEWS.items()
    ]
    return Content(" · ").join(parts)
