# SPDX-License-Identifier: Apache-2.0
"""Actions in the pane of curves and tables."""

from calc.sheet.text import Text

from .host import Host
from .moves import Moves

NO_PIXELS = Text(
    "P draws the curve in pixels, as Kitty, iTerm2, WezTerm, foot and others can; "
    "this terminal does not say that it does, so nothing was drawn."
)


class CurveActions:
    def __init__(self, host: Host, moves: Moves) -> None:
        self._host, self._moves = host, moves

    # --- which curve, and what of it
    def turn_curve(self, by: int) -> None:
        host, pane = self._host, self._host.curve_pane
        if pane.leaves and not pane.display:  # first the one that stands there, which has not been seen
            self._moves.to_view("curve")
            return
        if len(pane.leaves) < 2:
            host.app.tell(Text("This step has no other curve.") if pane.leaves else Text("This step has no curve."))
        pane.action_turn(by)

    def curves(self) -> None:
        """The list of all curves and tables of the step."""
        from .curves import CurveList

        host, pane = self._host, self._host.curve_pane
        if not pane.leaves or pane.leaf is None:
            host.app.tell(Text("This step has no curve."))
            return

        def choose(id: str | None) -> None:
            if id is not None:
                pane.choose(id)
                self._moves.to_view("curve")

        host.app.push_screen(CurveList(f"{host.number} {host.app.say(host.step.title)}", pane.leaves, pane.leaf.id), choose)

    def pixels(self) -> None:
        """The curve as the report has it, on a terminal that shows pixels."""
        import os

        from textual.app import SuspendNotSupported

        from ..widgets.pixels import protocol, show

        host, curve = self._host, self._host.curve_pane.curve
        how = protocol(os.environ)
        if curve is None or not how:
            host.app.tell(Text("This step has no curve.") if curve is None else NO_PIXELS)
            return
        try:
            with host.app.suspend():
                show(curve, how, host.app.say)
        except SuspendNotSupported:
            host.app.tell(NO_PIXELS)

    def read(self, by: int, fine: bool = False) -> None:
        """Move the cursor of a curve, or the columns of a table."""
        host, pane = self._host, self._host.curve_pane
        if host.focused is pane:
            pane.read(by, fine)
        elif host.focused is pane.list:
            pane.list.columns(by)

    def read_end(self, last: bool) -> None:
        pane = self._host.curve_pane
        if self._host.focused is pane:
            pane.read_end(last)

    def variant(self) -> None:
        host, pane = self._host, self._host.curve_pane
        shown = pane.next_variant()
        if not shown:
            host.app.tell(Text("This curve has one variant only."))
        elif not pane.display:
            host.app.tell(Text("The curve is shown {shown}.", shown=shown))

    def crank(self, by: int) -> None:
        """Turn the vectors that turn with the crank, in steps."""
        if not self._host.curve_pane.turn_crank(by):
            self._host.app.tell(Text("This curve has no vectors that turn with the crank."))
