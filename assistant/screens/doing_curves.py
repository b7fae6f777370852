# SPDX-License-Identifier: Apache-2.0
"""What the keys do in the pane of curves and tables, one method for each action of the table."""

from textual import work

from ..widgets.curve_pane import CurvePane
from .part import Part


class DoingCurves(Part):
    """The actions on what is shown of a step.  A part of `Doing`."""

    # --- which curve, and what of it
    def action_curve(self) -> None:
        self._turn_curve(1)

    def action_curve_back(self) -> None:
        self._turn_curve(-1)

    def _turn_curve(self, by: int) -> None:
        me = self._me
        pane = me.query_one(CurvePane)
        if pane.leaves and not pane.display:  # first the one that stands there, which has not been seen
            me.action_to_view("curve")
            return
        if len(pane.leaves) < 2:
            me.app.tell("This step has no other curve." if pane.leaves else "This step has no curve.")
        pane.action_turn(by)

    @work
    async def action_curves(self) -> None:
        """The list of all curves and tables of the step."""
        from .curve_list import CurveList

        me = self._me
        pane = me.query_one(CurvePane)
        if not pane.leaves or pane.leaf is None:
            me.app.tell("This step has no curve.")
            return
        id = await me.app.push_screen_wait(CurveList(f"{me.number} {me.app.say(me.step.title)}", pane.leaves, pane.leaf.id))
        if id is not None:
            pane.choose(id)
            me.action_to_view("curve")

    def action_read(self, by: int, fine: bool = False) -> None:
        """Move the cursor of a curve, or the columns of a table."""
        pane = self._me.query_one(CurvePane)
        if self._me.focused is pane:
            pane.read(by, fine)
        elif self._me.focused is pane.list:
            pane.list.columns(by)

    def action_read_end(self, last: bool) -> None:
        pane = self._me.query_one(CurvePane)
        if self._me.focused is pane:
            pane.read_end(last)

    def action_variant(self) -> None:
        me = self._me
        pane = me.query_one(CurvePane)
        shown = pane.next_variant()
        if not shown:
            me.app.tell("This curve has one variant only.")
        elif not pane.display:
            me.app.tell(f"The curve is shown {shown}.")

    def action_crank(self, by: int) -> None:
        me = self._me
        if not me.query_one(CurvePane).turn_crank(by):
            me.app.tell("This curve has no vectors that turn with the crank.")
