# SPDX-License-Identifier: Apache-2.0
"""The one screen: steps, inputs, checks, calculation and curve, always live.  Nobody presses "calculate"."""

from collections.abc import Callable
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container, Horizontal, Vertical
from textual.reactive import Reactive
from textual.screen import Screen
from textual.widget import AwaitMount, Widget

from calc.design.model import STEPS
from calc.sheet.step import Step
from calc.sheet.text import EMPTY, Text

from ..actions import ACTIONS, methods
from ..base_app import BaseApp
from ..session.places import Place
from ..session.session import Session
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.curve_pane import CurvePane, Pane
from ..widgets.entry import Entry
from ..widgets.field import Field
from ..widgets.form import Form
from ..widgets.headings import ArrayHeading, TableHeading
from ..widgets.item_list import ItemList
from ..widgets.lines import FooterLine, MessageLine, TopLine
from ..widgets.picture import Picture
from ..widgets.rows import FieldHelp
from ..widgets.steps import StepBar, Steps
from ..widgets.table_list import TableList
from .accept import AcceptActions
from .background_solve import BackgroundSolve
from .building import Building
from .curves import CurveActions
from .edit_actions import EditActions
from .edit_feedback import EditFeedback
from .file_actions import FileActions
from .lists import Lists
from .moves import Moves
from .pane_layout import PANES, PaneLayout
from .reading_actions import ReadingActions
from .ready import ReadyActions
from .results_view import ResultsView
from .slopes import Slopes
from .step_forms import StepForms

HUGE = 170  # cells of a screen that has room for the findings beside the picture


class Workbench(Screen[None]):
    """What is shown, and when it is shown anew.  Its parts do the rest: what the keys do, and how the design is solved
    behind it."""

    app: BaseApp
    HORIZONTAL_BREAKPOINTS = [(0, "-tiny"), (60, "-narrow"), (100, "-wide"), (HUGE, "-huge")]  # noqa: RUF012
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding(a.binding, a.does, a.title, show=False, id=a.id) for a in ACTIONS if a.binding
    ]
    AUTO_FOCUS = ""
    # a change of the focus is drawn by the two widgets; the whole screen need not be
    focused: Reactive[Widget | None] = Reactive(None, repaint=False)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.pane_layout = PaneLayout(self)
        self.background = BackgroundSolve(self)
        self.moves = Moves(self, self.background)
        self.step_forms = StepForms(self)
        self.edits = EditActions(self, self.moves, self.background)
        self.files = FileActions(self)
        self.curves = CurveActions(self, self.moves)
        self.readings = ReadingActions(self, self.moves, self.background)
        self.slopes = Slopes(self)
        self.closing = ReadyActions(self, self.files, self.edits)
        self.building = Building(self, self.moves)
        self.results_view = ResultsView(self, self.background, self.slopes)
        self.lists = Lists(self, self.moves, self.readings, self.results_view)
        self._actions = methods(
            self.moves, self.edits, self.files, self.curves, self.readings, AcceptActions(self), self.closing
        )
        self.feedback = EditFeedback(self)
        self._composing = False
        self._begin(session)

    def _begin(self, session: Session) -> None:
        self.session = session
        self.step = next((s for s in STEPS if s.key in session.data), STEPS[0])

    # --- the parts
    def compose(self) -> ComposeResult:
        # the classes that the width will give, before there is anything that would have to be styled anew
        self.add_class(
            next(name for least, name in reversed(self.HORIZONTAL_BREAKPOINTS) if self.app.size.width >= least)
        )
        self.set_class(self.app.ascii, "-ascii")
        yield TopLine(self.session)
        yield StepBar(self.session)
        with Horizontal(id="body"):
            yield Pane(Text("Steps"), Steps(self.session), id="steps")
            yield Pane(
                self._form_title(), Container(Form(self.step, self.session), id="forms"), FieldHelp(), id="inputs"
            )
            with Vertical(id="results"):
                with Vertical(id="seen"):
                    yield Pane(Text("Picture"), Picture(), id="picture")
                    yield CurvePane()
                with Vertical(id="judged"):
                    yield Pane(Text("Findings"), Checks(), id="checks")
                    yield Pane(Text("Calculation"), Calculation(), id="calculation")
        yield MessageLine(self.session)
        yield FooterLine()

    async def enter(self, session: Session) -> None:
        """Go on with another design."""
        for part in (self.background, self.feedback, self.pane_layout):
            part.begin()
        self._begin(session)
        await self._compose_again()
        self.on_mount()

    async def _compose_again(self) -> None:
        self._composing = True
        try:
            await self.recompose()
        finally:
            self._composing = False

    @property
    def stands(self) -> bool:
        return not self._composing and any(isinstance(child, FooterLine) for child in self.children)

    async def action_act(self, id: str) -> None:
        """Run an action of the table.  Keys that wait for it go where it has led."""
        result = self._actions[id]()
        if result is not None:
            await result
        self.app.screen.call_after_refresh(self.app.release)

    def action_to_view(self, name: str) -> None:
        """The names of the views on a narrow screen are links to this."""
        self.moves.to_view(name)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Keys do nothing, and are lost, while there is nothing that they could act on."""
        return self.stands

    async def speak(self) -> None:
        """Show everything in the language that the program speaks now."""
        step, pane = self.step, self.pane_layout.pane
        await self._compose_again()
        self.set_out()
        self.show_step()
        self.at_pane(pane)
        await self.open_step(step)
        self.form.focus_place(None)
        self.background.solve()

    def on_mount(self) -> None:
        if not (self.stands and self.query(Checks)):  # the end of the program came before its parts
            return
        self.set_out()
        self.form.focus_place(None)
        self.show_step()
        self.call_after_refresh(self.background.solve)
        if self.session.message:
            self.app.tell(self.session.message)
            self.session.message = EMPTY

    # --- what its parts ask for (`Host`)
    @property
    def checks(self) -> Checks:
        return self.query_one(Checks)

    @property
    def calculation(self) -> Calculation:
        return self.query_one(Calculation)

    @property
    def curve_pane(self) -> CurvePane:
        return self.query_one(CurvePane)

    def pane_named(self, name: str) -> Pane:
        return self.query_one(f"#{name}", Pane)

    def forms(self) -> list[Form]:
        return list(self.query(Form))

    def add_form(self, form: Form) -> AwaitMount:
        return self.query_one("#forms").mount(form)

    def refresh_top_line(self) -> None:
        for line in self.query(TopLine):  # none while another design is being entered
            line.refresh()

    def set_slow(self, slow: bool) -> None:
        self.query_one(TopLine).slow = slow

    def set_stale(self, stale: bool) -> None:
        for results in (Checks, Calculation, TableList):
            self.query_one(results).set_stale(stale)

    def in_thread(self, group: str, do: Callable[[], None], *, exclusive: bool = True) -> None:
        self.run_worker(do, group=group, description=group, exit_on_error=False, exclusive=exclusive, thread=True)

    @property
    def form(self) -> Form:
        return self.query_one(f"#form-{self.step.key}", Form)

    def close_route(self) -> None:
        self.closing.ready()

    @property
    def number(self) -> int:
        return STEPS.index(self.step) + 1

    def _form_title(self) -> str:
        return f"{self.number} {self.app.say(self.step.title)}"

    # --- editing
    def on_field_edited(self, event: Field.Edited) -> None:
        event.stop()
        if self.stands:
            self.session.edit(event.field.place, event.text)
            self.edited()

    def on_array_heading_added(self, event: ArrayHeading.Added) -> None:
        event.stop()
        self.edits.add_element(event.heading.row.place)

    def on_array_heading_removed(self, event: ArrayHeading.Removed) -> None:
        event.stop()
        self.edits.remove_element(event.heading.row.place, event.index)

    def on_table_heading_added(self, event: TableHeading.Added) -> None:
        event.stop()
        self.edits.put_table(event.heading.row.place, True)

    def on_table_heading_removed(self, event: TableHeading.Removed) -> None:
        event.stop()
        self.edits.put_table(event.heading.row.place, False)

    def on_form_asked(self, event: Form.Asked) -> None:
        event.stop()
        self.building.ask(event.step, event.balancing)

    def on_form_left_out(self, event: Form.LeftOut) -> None:
        event.stop()
        self.building.leave_out(event.step)

    async def on_form_done(self, event: Form.Done) -> None:
        event.stop()
        await self.moves.lead_on()

    def on_form_changed(self, event: Form.Changed) -> None:
        event.stop()
        self.edited()

    def on_key(self, event: events.Key) -> None:
        """A letter that was struck before its field had the focus goes to the field."""
        if event.is_printable and isinstance(self.focused, Entry):
            event.stop()
            self.focused.post_message(event)

    def edited(self) -> None:
        """The design has changed: solve, say what is not accepted, and keep the edit aside, each in its time."""
        self.background.solve()
        self.call_after_refresh(self._show_edit)  # the key is painted first
        self.feedback.keep_soon()

    def _show_edit(self) -> None:
        if self.stands:
            self.show_state()

    def show_state(self) -> None:
        complete = self.feedback.show()
        self.refresh_top_line()
        if complete:
            self.show_remedy()
            self.query_one(Steps).rebuild()
            self.query_one(StepBar).refresh()

    # --- showing
    def show_remedy(self) -> None:
        self.results_view.show_remedy()

    def show_verdicts(self) -> None:
        self.results_view.show_verdicts()

    def show_picture(self) -> None:
        self.results_view.show_picture()

    def show_written(self) -> None:
        self.results_view.show_written()

    def on_curve_pane_turned(self, event: CurvePane.Turned) -> None:
        event.stop()
        if self.stands:
            self.results_view.show_keys()

    def show_step(self) -> None:
        """The parts that name the step."""
        steps, bar = self.query_one(Steps), self.query_one(StepBar)
        steps.current = bar.current = self.query_one(MessageLine).step = self.step.key
        self.query_one("#inputs", Pane).set_title(self._form_title())
        self.show_verdicts()
        self.show_written()
        self.show_state()
        self.background.write_out()
        steps.go_to(self.step.key)
        self.show_remedy()
        self.background.seek_remedy()
        self.step_forms.make_ahead()

    async def open_step(self, step: Step, focus: Place | None = None, *, stay: bool = False) -> None:
        """Show another step, with the focus on a field if one had it before; `stay` leaves the focus where it is."""
        if step is not self.step:
            self.step_forms.spare()
        idle = focus is None and isinstance(self.focused, Form)
        inside = not stay and (self.pane_layout.pane == "inputs" or focus is not None)
        before = self.step
        with self.app.batch_update():
            if step is not before:
                if self.pane_layout.pane == "inputs":
                    self.set_focus(None, scroll_visible=False)
                self.form.display = False
                self.step = step
                await self.step_forms.show(step)
                if not self.stands:  # the end came before the form
                    return
            if inside and idle:
                self.set_focus(self.form, scroll_visible=False)
            elif inside:
                self.form.focus_place(focus, at_once=True)  # before the picture, in which its field is lit
            if step is not before:
                self.show_step()

    # --- focus and panes
    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        pane = next((node.id for node in event.widget.ancestors_with_self if node.id in PANES), None)
        if pane is not None:
            self.at_pane(pane)
        self.results_view.show_help()
        if isinstance(event.widget, Checks):
            self.call_later(self.results_view.show_finding)

    def on_descendant_blur(self, event: events.DescendantBlur) -> None:
        self.call_later(self.results_view.show_help)
        self.call_later(self._keep_focus)
        if isinstance(event.widget, Checks) and self.stands:
            self.call_later(self.results_view.show_finding)

    def _keep_focus(self) -> None:
        """A list that is hidden and shown between two frames loses the focus, with nobody to take it."""
        pane = self.pane_layout.pane
        if self.focused is None and pane != "inputs" and self.stands:
            self.set_focus(self.pane_named(pane).target, scroll_visible=False)

    def at_pane(self, name: str) -> None:
        if name != self.pane_layout.pane and self.stands:
            self.pane_layout.at(name)
            self.set_out()

    def set_out(self) -> None:
        self.pane_layout.set_out(self.app.say)

    def on_checks_want_slopes(self, event: Checks.WantSlopes) -> None:
        event.stop()
        self.slopes.want(event.check)

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        self.lists.moved(event.source)

    async def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()
        if self.stands:
            await self.lists.chosen(event)

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
