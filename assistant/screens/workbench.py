# SPDX-License-Identifier: Apache-2.0
"""The one screen: steps, inputs, checks, calculation and curve, always live.  Nobody presses "calculate"."""

from typing import ClassVar

from textual import events, work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container, Horizontal, Vertical
from textual.content import Content
from textual.reactive import Reactive
from textual.style import Style
from textual.timer import Timer
from textual.widget import Widget

from calc.design import STEPS
from calc.languages.outcome import said
from calc.sheet.step import Step

from ..actions import ACTIONS
from ..offers.offer import CHOICES
from ..places import Place, first_key
from ..session import Session
from ..sheets import Sheet
from ..widgets.array_heading import ArrayHeading
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.curve_pane import CurvePane
from ..widgets.entry import Entry
from ..widgets.field import Field
from ..widgets.field_help import FieldHelp
from ..widgets.footer_line import FooterLine
from ..widgets.form import Form
from ..widgets.item_list import ItemList
from ..widgets.message_line import MessageLine
from ..widgets.pane import Pane
from ..widgets.step_bar import StepBar
from ..widgets.steps import Steps
from ..widgets.table_heading import TableHeading
from ..widgets.table_list import TableList
from ..widgets.taken import Taken
from ..widgets.top_line import TopLine
from .doing import VIEWS, Doing
from .live import Live

KEEP = 1.5  # seconds after the first edit that is not kept aside until all of them are: typing does not put it off
COMPLAIN = 0.6  # seconds until a field that is being typed into says what is wrong with it
PANES = ("steps", "inputs", "checks", "calculation", "curve")


class Workbench(Doing, Live):
    """What is shown, and when it is made anew.  What the keys do stands in `Doing`, how it is solved in `Live`."""

    HORIZONTAL_BREAKPOINTS = [(0, "-tiny"), (60, "-narrow"), (100, "-wide")]  # noqa: RUF012
    BINDINGS: ClassVar[list[BindingType]] = [Binding(a.binding, a.does, a.title, show=False, id=a.id) for a in ACTIONS if a.binding]
    AUTO_FOCUS = ""
    # a change of the focus is drawn by the two widgets; the whole screen need not be
    focused: Reactive[Widget | None] = Reactive(None, repaint=False)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._keep: Timer | None = None
        self._complain: Timer | None = None
        self._making = False
        self._begin(session)

    def _begin(self, session: Session) -> None:
        self.session = session
        self.step = next((s for s in STEPS if s.key in session.data), STEPS[0])
        self.pages = {}
        self.pane = "inputs"  # the pane that has, or had last, the focus
        self.large = False  # that pane alone, on a wide screen
        self._saw: set[Place] = set()  # fields whose mistake has been said

    # --- the parts
    def compose(self) -> ComposeResult:
        # the classes that the width will give, before there is anything that would have to be styled anew
        self.add_class("-wide" if self.app.size.width >= 100 else "-narrow" if self.app.size.width >= 60 else "-tiny")
        self.set_class(self.app.ascii, "-ascii")
        yield TopLine(self.session)
        yield StepBar(self.session)
        with Horizontal(id="body"):
            yield Pane("Steps", Steps(self.session), id="steps")
            yield Pane(self._form_title(), Container(Form(self.step, self.session), id="forms"), FieldHelp(), id="inputs")
            with Vertical(id="results"):
                yield Pane("Checks", Checks(), id="checks")
                yield Pane("Calculation", Calculation(), id="calculation")
                yield CurvePane()
        yield MessageLine(self.session)
        yield FooterLine()

    async def enter(self, session: Session) -> None:
        """Go on with another design."""
        for timer in (self._keep, self._complain, self._ahead):
            if timer is not None:
                timer.stop()
        self._keep = None
        self._begin(session)
        await self._make_anew()
        self.on_mount()

    async def _make_anew(self) -> None:
        self._making = True
        try:
            await self.recompose()
        finally:
            self._making = False

    @property
    def stands(self) -> bool:
        return not self._making and bool(self.query("#footer-line"))

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Keys do nothing, and are lost, while there is nothing that they could act on."""
        return self.stands

    async def speak(self) -> None:
        """Show everything in the language that the program speaks now."""
        step, pane = self.step, self.pane
        await self._make_anew()
        self.set_out()
        self.show_step()
        self.at_pane(pane)
        await self.open_step(step)
        self.form.focus_place(None)
        self.solve()

    def on_mount(self) -> None:
        self.set_out()
        self.form.focus_place(None)
        self.show_step()
        self.call_after_refresh(self.solve)
        if self.session.message:
            self.app.tell(self.session.message)
            self.session.message = ""

    @property
    def form(self) -> Form:
        return self.query_one(f"#form-{self.step.key}", Form)

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
        place = event.heading.row.place
        index = self.session.add(place)
        self.form.chosen[place] = index
        self.edited()
        self.form.rebuild((*place, index, first_key(place)))

    def on_array_heading_removed(self, event: ArrayHeading.Removed) -> None:
        event.stop()
        self.session.remove(event.heading.row.place, event.index)
        self.edited()

    def on_table_heading_added(self, event: TableHeading.Added) -> None:
        event.stop()
        place = event.heading.row.place
        self.session.put_table(place, True)
        self.edited()
        self.form.rebuild((*place, first_key(place)))

    def on_table_heading_removed(self, event: TableHeading.Removed) -> None:
        event.stop()
        self.session.put_table(event.heading.row.place, False)
        self.edited()

    def on_form_asked(self, event: Form.Asked) -> None:
        event.stop()
        self.session.ask(event.step.key)
        self.edited()

    def edited(self) -> None:
        """The design has changed: solve, say what is not accepted, and keep the edit aside, each in its time."""
        self.solve()
        self.show_state()
        if self._keep is None:
            self._keep = self.set_timer(KEEP, self.keep)

    def show_state(self) -> None:
        """Everything but the results.  A field that is being typed into gets a moment before it complains."""
        reasons = self.session.reasons()
        here = self.form.here()
        late = {place for place in reasons if place == here and place not in self._saw}
        self.form.refresh_fields({place: reason for place, reason in reasons.items() if place not in late})
        self._saw = set(reasons) - late
        if self._complain is not None:
            self._complain.stop()
        self._complain = self.set_timer(COMPLAIN, self._complain_now) if late else None
        self.set_stale(self.session.results is not None and not late and (not self.session.valid or bool(self.session.failure)))
        self.query_one(TopLine).refresh()
        if not late:
            self.show_remedy()
            self.query_one(Steps).rebuild()
            self.query_one(StepBar).refresh()

    def _complain_now(self) -> None:
        if not self.stands:
            return
        self._saw = set(self.session.reasons())
        self.show_state()

    def keep(self) -> None:
        """Put the edits aside, in another thread; a disk may be slow."""
        self._keep = None
        self._keep_aside()

    @work(thread=True, exclusive=True, group="keep", exit_on_error=False)
    def _keep_aside(self) -> None:
        self.session.autosave()
        self.app.call_from_thread(self.query_one(TopLine).refresh)

    # --- showing
    def show_remedy(self) -> None:
        if self.session.valid and not self.session.current and self.session.results is not None:
            return  # what stands there stays until there are results: it would only flicker
        line = self.query_one(MessageLine)
        line.trouble, line.remedy = self.trouble, self.remedy
        line.redraw()
        self.show_keys()

    def show_verdicts(self) -> None:
        results = self.session.results
        outcome = said(results.outcomes[self.step.key], self.app.say) if results is not None else None
        self.query_one(Checks).show(outcome)
        if outcome is not None:
            bad = sum(c.verdict != "pass" for c in outcome.checks)
            count = len(outcome.checks)
            passing = f"{count - bad} of {count} {'check passes' if count == 1 else 'checks pass'}"
            self.query_one("#checks", Pane).set_title(right=self.app.say(passing) if count else "")
        self.query_one(TopLine).refresh()  # the last line of the screen follows: what lies between two lines is painted with them

    def show_written(self) -> None:
        page = self.pages.get(self.step.key)
        self.query_one(Calculation).show(page.sheet if page is not None else Sheet())
        self.query_one(CurvePane).show(self.step.key, page.leaves if page is not None else (), page is None)
        self.form.refresh_taken()
        self.show_keys()

    def show_keys(self) -> None:
        """The footer leaves out first what does nothing here."""
        pane, results = self.query_one(CurvePane), self.session.results
        sound = self.session.valid and results is not None and all(c.verdict == "pass" for c in results.checks())
        idle = {
            "variant": pane.curve is None or len(pane.curve.variants) < 2,
            "curve": len(pane.leaves) < 2,
            "trouble": sound,
            "mend": self.remedy is None or not self.remedy.changes,
            "choose": self.step.key not in CHOICES,
        }
        self.query_one(FooterLine).show(tuple(id for id, nothing in idle.items() if nothing))

    def on_curve_pane_turned(self, event: CurvePane.Turned) -> None:
        event.stop()
        if self.stands:
            self.show_keys()

    def show_step(self) -> None:
        """The parts that name the step."""
        steps, bar = self.query_one(Steps), self.query_one(StepBar)
        steps.current = bar.current = self.query_one(MessageLine).step = self.step.key
        self.query_one("#inputs", Pane).set_title(self._form_title())
        self.show_verdicts()
        self.show_written()
        self.show_state()
        self.write_out()
        steps.go_to(self.step.key)
        self.show_remedy()
        self.seek_remedy()

    async def open_step(self, step: Step, focus: Place | None = None, *, stay: bool = False) -> None:
        """Show another step, with the focus on a field if one had it before; `stay` leaves the focus where it is."""
        idle = focus is None and isinstance(self.focused, Form)
        inside = not stay and (self.pane == "inputs" or focus is not None)
        with self.app.batch_update():
            if step is not self.step:
                if self.pane == "inputs":
                    self.set_focus(None, scroll_visible=False)
                self.form.display = False
                self.step = step
                if self.query(f"#form-{step.key}"):
                    self.form.display = True
                else:
                    await self.query_one("#forms").mount(Form(step, self.session))
                    if not self.stands:  # the end came before the form
                        return
                self.show_step()
            if inside and idle:
                self.form.focus(scroll_visible=False)
            elif inside:
                self.form.focus_place(focus)

    # --- focus and panes
    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        pane = next((node.id for node in event.widget.ancestors_with_self if node.id in PANES), None)
        if pane is not None:
            self.at_pane(pane)
        self._show_help()

    def on_descendant_blur(self, event: events.DescendantBlur) -> None:
        self.call_later(self._show_help)

    def at_pane(self, name: str) -> None:
        """This pane is the current one; narrow, or large, it is the only one."""
        if name != self.pane and self.stands:
            self.pane = name
            self.set_out()

    @property
    def single(self) -> bool:
        """One pane at a time."""
        return self.large or not self.has_class("-wide")

    def set_out(self) -> None:
        """Show the panes that belong on the screen.  Done here and not by the style sheet, which would restyle every field."""
        single = self.single
        shown = "inputs" if self.pane == "steps" and not self.has_class("-wide") else self.pane
        results = self.query_one("#results")
        results.display = not single or shown in ("checks", "calculation", "curve")
        for pane in self.query(Pane):
            alone = single and pane.id == shown
            pane.display = alone or not single
            pane.set_class(alone, "-single")
            pane.mark(pane.id == self.pane)
            pane.set_title(views=self._views(shown) if alone and not self.has_class("-wide") else Content(""))
        if not single or shown == "curve":
            self.call_after_refresh(self.query_one(CurvePane).draw)

    def _views(self, shown: str) -> Content:
        """The names of the views, for a narrow screen."""
        parts = [
            Content.styled(self.app.say(word), "bold" if name == shown else "not bold dim").stylize(
                Style.from_meta({"@click": f"screen.to_view('{name}')"})
            )
            for name, word in VIEWS.items()
        ]
        return Content(" · ").join(parts)

    def _show_help(self) -> None:
        """The foot of the form: about the field that has the focus."""
        if not self.stands or not self.query(f"#form-{self.step.key}"):
            return
        source, say = self.form.field or self.focused, self.app.say
        if isinstance(source, (Field, ArrayHeading, TableHeading, Taken)):
            self.query_one(FieldHelp).show(*source.explained())
        elif source is not None and self.pane == "inputs":
            self.query_one(FieldHelp).show(say("No field is being edited"), say("letters act as keys; Tab or ↓ goes back to the fields."))
        else:
            self.query_one(FieldHelp).show("", "")

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        if isinstance(event.source, Calculation) and self.stands:
            self.query_one("#calculation", Pane).set_title(right=event.source.position())

    async def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        """A step is opened; a check and a line are explained, and a click on a check goes to its line; a value that was taken over leads to
        its owner."""
        event.stop()
        source = event.source
        if not self.stands:
            return
        if isinstance(source, Steps):
            self.at_pane("inputs")
            await self.open_step(next(s for s in STEPS if s.key == event.key))
        elif isinstance(source, Checks) and event.clicked:
            self.to_line(event.key)
        elif isinstance(source, Checks) or (isinstance(source, (Calculation, TableList)) and not event.clicked):
            self.action_explain()
        elif isinstance(source, Taken):
            await self.to_value(event.key)

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
