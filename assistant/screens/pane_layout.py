# SPDX-License-Identifier: Apache-2.0
"""Which panes are on the screen: beside each other, or one alone.

Narrow, one at a time.  Wide, the steps, the inputs, the picture, and below the picture one of findings, calculation and
curve. Very wide, the curve has a place of its own below the picture."""

from textual.containers import Vertical
from textual.content import Content
from textual.screen import Screen
from textual.style import Style

from calc.locale import Language
from calc.sheet.text import Text

from ..widgets.curve_pane import CurvePane, Pane

VIEWS = {
    "inputs": Text("Inputs"),
    "picture": Text("Picture"),
    "checks": Text("Findings"),
    "calculation": Text("Calc"),
    "curve": Text("Plot"),
}
PANES = ("steps", *VIEWS)
TURNED = ("checks", "calculation", "curve")  # take turns in one place


class PaneLayout:
    """`pane` has, or had last, the focus; `turned`: the one of those that take turns; `large`: the pane stands alone on
    a wide screen."""

    def __init__(self, screen: Screen[None]) -> None:
        self._screen = screen
        self.begin()

    def begin(self) -> None:
        self.pane, self.turned, self.large = "inputs", TURNED[0], False

    @property
    def wide(self) -> bool:
        """Whether there is room for panes beside each other."""
        return self._screen.has_class("-wide") or self.huge

    @property
    def huge(self) -> bool:
        return self._screen.has_class("-huge")

    @property
    def single(self) -> bool:
        """One pane at a time."""
        return self.large or not self.wide

    @property
    def shown(self) -> tuple[str, ...]:
        """The panes on the screen, in their order."""
        if self.single:
            return ("inputs" if self.pane == "steps" and not self.wide else self.pane,)
        if self.huge:
            return ("steps", "inputs", "picture", "curve", "calculation" if self.turned == "calculation" else "checks")
        return ("steps", "inputs", "picture", self.turned)

    @property
    def written(self) -> bool:
        """Whether what is written out of the results is on the screen."""
        return not {"calculation", "curve"}.isdisjoint(self.shown)

    def at(self, pane: str) -> None:
        """This pane has the focus now."""
        self.pane = pane
        if pane in TURNED and not (self.huge and pane == "curve"):
            self.turned = pane

    def next_view(self) -> str:
        """The pane that takes the place of the one that is shown: narrow of all, wide of those that take turns."""
        names = list(VIEWS) if not self.wide else list(TURNED[:2] if self.huge else TURNED)
        here = self.pane if not self.wide else self.turned
        return names[(names.index(here) + 1) % len(names)] if here in names else names[0]

    def set_out(self, say: Language) -> None:
        """Show the panes that belong on the screen.  Done here and not by the style sheet, which would restyle every
        field."""
        screen, single, shown = self._screen, self.single, self.shown
        for pane in screen.query(Pane):
            pane.display = pane.id in shown
            pane.set_class(single and pane.id in shown, "-single")
            pane.mark(pane.id == self.pane)
            pane.set_title(views=_views(shown[0], say) if single and not self.wide else Content(""))
        for name in ("seen", "judged", "results"):
            part = screen.query_one(f"#{name}", Vertical)
            part.display = any(pane.display for pane in part.query(Pane))
            part.set_class(single, "-single")
        screen.query_one("#seen", Vertical).set_class(not screen.query_one("#judged", Vertical).display, "-whole")
        if "curve" in shown:
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
