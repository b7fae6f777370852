# SPDX-License-Identifier: Apache-2.0
"""The one screen: steps, inputs, checks, calculation and curve, always live.  Nobody presses "calculate".

One screen in five files, each of which calls what stands in those before it: `workbench_panes` (its parts, and which
are seen), `workbench_results` (solving in the background, and what is shown of it), `workbench_moves` (going somewhere,
reading, explaining), `workbench_edits` (changing the design, searching, files), and this one, where keys and messages
come in.  A key runs the method `action_NAME` that `assistant/actions.py` names."""

from inspect import isawaitable

from textual import events, on
from textual.widget import Widget

from calc.design.model import STEPS
from calc.sheet.text import EMPTY

from ..actions import BY_ID
from ..session.session import Session
from ..widgets.checks import Checks
from ..widgets.curve_pane import CurvePane
from ..widgets.entry import Entry
from ..widgets.field import Field
from ..widgets.form import Form
from ..widgets.headings import ArrayHeading, Fold, TableHeading
from ..widgets.item_list import ItemList
from ..widgets.steps import READY
from .workbench_edits import WorkbenchEdits
from .workbench_panes import PANES


class Workbench(WorkbenchEdits):
    """What comes to the screen from outside, from its widgets and from the keyboard, and who of it deals with that."""

    # --- a design is entered, or everything shown anew
    async def enter(self, session: Session) -> None:
        """Go on with another design."""
        self.begin(session)
        await self.compose_again()
        self.on_mount()

    async def speak(self) -> None:
        """Show everything in the language that the program speaks now."""
        step, pane = self.step, self.pane
        await self.compose_again()
        self.set_out()
        self.show_step()
        self.at_pane(pane)
        await self.open_step(step)
        self.form.focus_place(None)
        self.solve()

    def on_mount(self) -> None:
        if not (self.stands and self.query(Checks)):  # the end of the program came before its parts
            return
        self.set_out()
        self.form.focus_place(None)
        self.show_step()
        self.call_after_refresh(self.solve)
        if self.session.message:
            self.app.tell(self.session.message)
            self.session.message = EMPTY

    # --- keys
    async def action_act(self, id: str) -> None:
        """Run an action of the table.  Keys that wait for it go where it has led."""
        hold = self.app.holding
        name, *arguments = BY_ID[id].call or (id,)
        result = getattr(self, f"action_{name}")(*arguments)
        if isawaitable(result):
            await result
        self.app.screen.call_after_refresh(self.app.release, hold)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Keys do nothing, and are lost, while there is nothing that they could act on; those that leaf through shafts
        are the field's where there are none to leaf through."""
        if action == "act" and BY_ID[str(parameters[0])].first and self.stands:
            return self.leafs
        return self.stands

    def on_key(self, event: events.Key) -> None:
        """A letter that was struck before its field had the focus goes to the field."""
        if event.is_printable and isinstance(self.focused, Entry):
            event.stop()
            self.focused.post_message(event)

    # --- the form
    @on(Field.Edited)
    def field_edited(self, event: Field.Edited) -> None:
        event.stop()
        if self.stands:
            self.session.edit(event.field.place, event.text)
            self.edited()

    @on(ArrayHeading.Leafed)
    def shaft_leafed(self, event: ArrayHeading.Leafed) -> None:
        """Other arrays are leafed through in the form alone."""
        event.stop()
        self.look_at(event.index)

    @on(ArrayHeading.Added)
    def element_added(self, event: ArrayHeading.Added) -> None:
        event.stop()
        self.add_element(event.heading.row.place, event.heading.region)

    @on(ArrayHeading.Removed)
    def element_removed(self, event: ArrayHeading.Removed) -> None:
        event.stop()
        self.remove_element(event.heading.row.place, event.index)

    @on(TableHeading.Added)
    def table_added(self, event: TableHeading.Added) -> None:
        event.stop()
        self.put_table(event.heading.row.place, True)

    @on(TableHeading.Removed)
    def table_removed(self, event: TableHeading.Removed) -> None:
        event.stop()
        self.put_table(event.heading.row.place, False)

    @on(Form.Asked)
    def step_asked_for(self, event: Form.Asked) -> None:
        event.stop()
        self.build_step(event.step, event.choice)

    @on(Form.LeftOut)
    def step_left_out(self, event: Form.LeftOut) -> None:
        event.stop()
        self.leave_step_out(event.step)

    @on(Form.Done)
    async def form_done(self, event: Form.Done) -> None:
        event.stop()
        await self.lead_on()

    @on(Form.Changed)
    def form_changed(self, event: Form.Changed) -> None:
        event.stop()
        self.edited()

    # --- the lists: what belongs to a row that is moved to is shown beside it, and a row that is chosen leads somewhere
    @on(ItemList.Moved, "Radio")
    def radio_moved(self) -> None:
        self.show_help()
        self.show_finding()

    @on(Fold.Turned)
    def fold_turned(self, event: Fold.Turned) -> None:
        event.stop()
        self.show_help()

    @on(ItemList.Moved, "Checks")
    def checks_moved(self) -> None:
        self.show_finding()

    @on(ItemList.Moved, "Calculation")
    def calculation_moved(self) -> None:
        if self.stands:
            self.pane_named("calculation").set_title(right=self.calculation.position())

    @on(ItemList.Chosen, "Steps")
    async def step_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()
        if self.stands and event.key == READY:
            self.action_ready()
        elif self.stands:
            self.at_pane("inputs")
            await self.open_step(next(step for step in STEPS if step.key == event.key))

    @on(ItemList.Chosen, "Checks")
    def check_chosen(self, event: ItemList.Chosen) -> None:
        """It is explained; a click on it goes to its line."""
        event.stop()
        if self.stands and event.clicked:
            self.to_line(event.key)
        elif self.stands:
            self.action_explain()

    @on(ItemList.Chosen, "Calculation, TableList")
    def line_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()
        if self.stands and not event.clicked:
            self.action_explain()

    @on(ItemList.Chosen, "Taken")
    async def taken_chosen(self, event: ItemList.Chosen) -> None:
        """A value that was taken over leads to its owner."""
        event.stop()
        if self.stands:
            await self.to_value(event.key)

    @on(Checks.WantSlopes)
    def slopes_wanted(self, event: Checks.WantSlopes) -> None:
        event.stop()
        self.want_slopes(event.check)

    @on(Checks.WantWays)
    def ways_wanted(self, event: Checks.WantWays) -> None:
        event.stop()
        self.want_ways(event.check)

    @on(CurvePane.Turned)
    def curve_turned(self, event: CurvePane.Turned) -> None:
        event.stop()
        if self.stands:
            self.show_keys()

    # --- focus and size
    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        pane = next((node.id for node in event.widget.ancestors_with_self if node.id in PANES), None)
        if pane is not None:
            self.at_pane(pane)
        self.show_help()
        self.call_later(self.show_finding)

    def on_descendant_blur(self, event: events.DescendantBlur) -> None:
        self.call_later(self.show_help)
        self.call_later(self._keep_focus)
        self.call_later(self.show_finding)

    def _keep_focus(self) -> None:
        """A list that is hidden and shown between two frames loses the focus, with nobody to take it."""
        if self.focused is None and self.pane != "inputs" and self.stands:
            self.set_focus(self.pane_named(self.pane).target, scroll_visible=False)

    def on_resize(self, event: events.Resize) -> None:
        if not self.stands:
            return
        self.set_out()
        focused = self.focused
        if focused is not None:
            self.call_after_refresh(self._keep_in_view, focused)

    def _keep_in_view(self, widget: Widget) -> None:
        if widget.is_attached and self.focused is None:
            widget.focus()
        if widget.is_attached and isinstance(widget, Entry):
            widget.scroll_visible(animate=False)
