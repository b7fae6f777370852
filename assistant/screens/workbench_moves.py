# SPDX-License-Identifier: Apache-2.0
"""Where the main screen's keys lead, and what they show: a step, a pane, a field, a check, a line, a curve, or a screen
of its own; none of it changes the design."""

import os
from typing import Any

from textual.app import SuspendNotSupported

from calc.design.addresses import as_table, asks, step_at
from calc.design.labels import Place
from calc.design.model import STEPS
from calc.sheet.check import URGENT
from calc.sheet.errors import BadInput
from calc.sheet.step import Step
from calc.sheet.text import Text
from calc.sheet.verdict import severity

from ..actions import BY_ID
from ..session.calculation import VALUES
from ..session.compare_with import Chosen
from ..session.guide import step_of, title_of
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.curve_pane import CurvePane
from ..widgets.entry import Choice, Entry
from ..widgets.form import Form
from ..widgets.headings import ArrayHeading, TableHeading
from ..widgets.item_list import ItemList
from ..widgets.radio import Balance, Radio
from ..widgets.steps import Steps, nothing_left, states_of
from ..widgets.table_list import TableList
from .help import HelpScreen
from .path_dialogs import CompareWith
from .workbench_panes import VIEWS
from .workbench_results import WorkbenchResults

WRITING = Text("The calculation is still being written out.")
FIRST = Text("This is the first step.")
ONE_SHAFT = Text("This design has no other shaft; the list of shafts in step 3 adds one.")
NO_SHAFT = Text("Shafts are leafed through in steps 3 to 5.")
NO_CURVE = Text("This step has no curve.")
NO_PIXELS = Text(
    "The curve in pixels: Kitty, iTerm2, WezTerm, foot and others show it; "
    "this terminal does not say that it does, so nothing was drawn."
)


class WorkbenchMoves(WorkbenchResults):
    # --- to a step, a field, a check, a line
    async def action_to_step(self, n: int) -> None:
        await self._arrive(STEPS[n - 1])

    async def _arrive(self, step: Step, offered: bool = True) -> None:
        """Open a step; what is to be chosen in it, or `offered`, stands under the cursor, where letters stay keys."""
        idle = isinstance(self.focused, Form)
        await self.open_step(step)
        free = not self._done or (offered and not asks(self.session.data, step.key))
        if idle and free and isinstance(next(iter(self.form.stops()), None), Radio):
            self.form.focus_place(None)

    async def land(self, step: Step) -> None:
        """Open a step that was asked for by its name, on its first choice or field, wherever the focus was."""
        self.at_pane("inputs")
        await self.open_step(step)
        self.form.focus_place(None, at_once=True)

    async def action_turn_step(self, by: int, offered: bool = True) -> None:
        """To the step after or before; `offered`: also to one that the design may do without and has not."""
        self.app.forget(FIRST)
        step = self._beside(by, offered)
        if step is not None:
            await self._arrive(step, offered)
        elif by > 0:
            self.action_ready()  # behind the last step
        else:
            self.app.tell(FIRST)

    def _beside(self, by: int, offered: bool = False) -> Step | None:
        """The step after, or before; none behind the last one.  `offered`: also one that the design may do without."""
        data, n = self.session.data, self.number - 1 + by
        without = as_table(data.get("without"))
        while 0 <= n < len(STEPS) and STEPS[n].optional and not asks(data, STEPS[n].key):
            if offered and "engine" in data and STEPS[n].key not in without:
                break
            n += by  # nobody is led into what the design does without
        return STEPS[n] if 0 <= n < len(STEPS) else None

    @property
    def enter_leads(self) -> str:
        """The step that Enter leads to now, or that it builds; empty where it does something else."""
        if self.form_of(self.step) is None:  # another form may just be on its way
            return ""
        focused, after = self.focused, self._beside(1)
        if isinstance(focused, Steps):
            return focused.key
        if isinstance(focused, Balance) and focused.taken:
            leads_on = True
        elif isinstance(focused, Radio):
            return self.step.key
        elif focused is self.form:
            leads_on = self._done
        elif isinstance(focused, (ArrayHeading, TableHeading)):
            leads_on = not focused.adds and self.form.below() is None
        else:
            leads_on = isinstance(focused, (Entry, Choice)) and self.form.below() is None
        return after.key if leads_on and after is not None else ""

    async def lead_on(self) -> None:
        """The step after; where nothing is left to do in it, no field of it is edited, so that the next Enter leads on
        again."""
        before = self.step
        await self.action_turn_step(1, offered=False)  # Enter leads nobody into what the design does without
        if self.step is not before and self._done:
            self.set_focus(self.form, scroll_visible=False)

    @property
    def _done(self) -> bool:
        """Whether nothing is left to do in the step, or what is waits for a later one."""
        return nothing_left(states_of(self.session), self.step.key)

    async def action_trouble(self) -> None:
        """The next check that fails; after those, the next that warns."""
        session = self.session
        if session.reasons():
            await self.to_field(next(iter(session.reasons())))
            return
        if session.results is None:
            return
        outcomes = session.results.outcomes
        faults = [(s, group[0]) for s in STEPS for group in outcomes[s.key].causes if group[0].verdict in URGENT]
        faults.sort(key=lambda f: severity(f[1])[:4])
        if not faults:
            self.app.tell(Text("No check fails or warns."))
            return
        checks = self.checks
        here = next((n for n, (s, c) in enumerate(faults) if s is self.step and c.id == checks.key), None)
        if here is not None and checks.has_focus:
            step, check = faults[(here + 1) % len(faults)]
        else:
            step, check = next(
                (f for f in faults if f[0] is self.step and f[1].verdict == faults[0][1].verdict), faults[0]
            )
        await self.to_check(step, check.id)

    async def to_check(self, step: Step, id: str) -> None:
        """To a finding of a step, with the shaft in view that it is of."""
        self.at_pane("checks")
        await self.open_step(step, stay=True)
        if (shaft := self.session.shaft_of_finding(id)) is not None:
            self.look_at(shaft)
        self.set_focus(self.checks)
        self.call_after_refresh(self.checks.go_to, id)

    def action_line(self) -> None:
        """From a check to the line of the calculation that gives its value."""
        if self.focused is self.checks and self.checks.key:
            self.to_line(self.checks.key)
        else:
            finding, pane = self.app.shown_key("trouble"), self.app.shown_key("pane")
            self.app.tell(Text("Go to a check first ({finding}, or {pane} to the checks).", finding=finding, pane=pane))

    def to_line(self, check: str) -> None:
        """The line of the calculation that a check comes from."""
        calculation = self.calculation
        if self.page is None:
            self.app.tell(WRITING)
            return
        index = calculation.sheet.line_of.get(check)
        if index is None:
            self.app.tell(Text("No single line of the calculation gives this value."))
            return
        self.at_pane("calculation")
        self.set_focus(calculation)
        self.call_after_refresh(calculation.go_to, calculation.sheet.entries[index].number, top=True)

    async def to_value(self, id: str) -> None:
        """The field of an input, or the step of a result."""
        step = next((s for s in STEPS if s.key == step_at(self.session.data, id)), self.step)
        try:
            place: Place | None = self.session.place(id)
        except BadInput:
            place = None
            if (shaft := self.session.shaft_of(id)) is not None:
                self.look_at(shaft)
        self.at_pane("inputs")
        await self.open_step(step, place)

    async def to_field(self, place: Place) -> None:
        """Open the step of a field and put the focus there."""
        step = next((s for s in STEPS if s.key == step_of(place, self.session.data)), self.step)
        self.at_pane("inputs")
        await self.open_step(step, place)
        self.form.focus_place(place, at_once=True)
        self.call_after_refresh(self.form.bring_into_view)  # a form that was just made has its size then

    def action_turn_shaft(self, by: int) -> None:
        """To the next shaft."""
        if self.leafs:
            self.look_at((self.session.shaft + by) % len(self.session.shafts))
        else:
            self.app.tell(ONE_SHAFT if len(self.session.shafts) < 2 else NO_SHAFT)

    # --- between panes, and in them
    def action_move(self, by: int) -> None:
        """To the next field, check or line."""
        focused = self.focused
        if isinstance(focused, CurvePane):
            focused.read_line(by)
        elif isinstance(focused, ItemList):
            before = focused.cursor
            focused.move(by)
            if focused.cursor == before and self.pane == "inputs":
                self.form.go(by)
        elif self.pane == "inputs":
            self.form.go(by)

    def action_turn_pane(self, by: int) -> None:
        """The next pane that is shown; narrow, the panes follow each other."""
        names = list(VIEWS) if not self.wide else ["steps", *VIEWS] if self.large else list(self.shown_panes)
        here = names.index(self.pane) if self.pane in names else 0
        self.action_to_view(names[(here + by) % len(names)])

    def action_view(self) -> None:
        """Narrow: the next view.  Wide: findings, calculation and curve in turn."""
        self.action_to_view(self.next_view())

    def action_enlarge(self) -> None:
        """This pane alone, or all of them again."""
        self.large = self.wide and not self.large
        self.set_out()

    def action_to_view(self, name: str) -> None:
        self.at_pane(name)
        if name == "inputs":
            self.form.focus_place(None, at_once=True)
        else:
            self.set_focus(self.pane_named(name).target)

    def action_leave(self) -> None:
        """Out of the field; the cursor off the curve; out of a large pane; back to the form."""
        if self.form.restore():
            pass
        elif self.focused in self.form.stops():
            self.set_focus(self.form, scroll_visible=False)
        elif self.pane == "curve" and self.curve_pane.put_away():
            pass
        elif self.large:
            self.large = False
            self.set_out()
        elif self.pane != "inputs":
            self.leave_pane()

    def leave_pane(self) -> None:
        """Back to the form, no field of it edited."""
        self.at_pane("inputs")
        self.set_focus(self.form, scroll_visible=False)

    async def action_go_on(self) -> None:
        """Enter: choose in a list, go into the form, add an element, or on to the next field; from a finished step to
        the next."""
        if isinstance(self.focused, ItemList) and (self.focused.key or self.pane == "inputs"):
            self.focused.choose()
        elif self.focused is self.form and not self._done:
            self.form.focus_place(None)
        elif self.focused is self.form:
            await self.lead_on()
        elif isinstance(self.focused, (ArrayHeading, TableHeading)) and self.focused.adds:
            self.focused.action_add()
        elif self.pane == "inputs":
            self.form.go_on()
        else:
            self.leave_pane()  # nothing can be chosen here: the next Enter goes on there

    # --- which curve, and what of it
    def action_turn_curve(self, by: int) -> None:
        pane = self.curve_pane
        if pane.leaves and not pane.display:  # first the one that stands there, which has not been seen
            self.action_to_view("curve")
            return
        if len(pane.leaves) < 2:
            self.app.tell(Text("This step has no other curve.") if pane.leaves else NO_CURVE)
        pane.action_turn(by)

    def action_curves(self) -> None:
        """The list of all curves and tables of the step."""
        from .curves import CurveList

        pane = self.curve_pane
        if not pane.leaves or pane.leaf is None:
            self.app.tell(NO_CURVE)
            return

        def choose(id: str | None) -> None:
            if id is not None:
                pane.choose(id)
                self.action_to_view("curve")

        self.app.push_screen(
            CurveList(
                f"{self.number} {self.app.say(title_of(self.step, self.session.data))}", pane.leaves, pane.leaf.id
            ),
            choose,
        )

    def action_pixels(self) -> None:
        """The curve as the report has it, on a terminal that shows pixels."""
        from .curves import protocol, show

        curve = self.curve_pane.curve
        how = protocol(os.environ)
        if curve is None or not how:
            self.app.tell(NO_CURVE if curve is None else NO_PIXELS)
            return
        try:
            with self.app.suspend():
                show(curve, how, self.app.say)
        except SuspendNotSupported:
            self.app.tell(NO_PIXELS)

    def action_read(self, by: int, fine: bool = False) -> None:
        """Move the cursor of a curve, or the columns of a table."""
        pane = self.curve_pane
        if self.focused is pane:
            pane.read(by, fine)
        elif self.focused is pane.list:
            pane.list.columns(by)

    def action_read_end(self, last: bool) -> None:
        pane = self.curve_pane
        if self.focused is pane:
            pane.read_end(last)

    def action_variant(self) -> None:
        pane = self.curve_pane
        shown = pane.next_variant()
        if not shown:
            self.app.tell(Text("This curve has one variant only."))
        elif not pane.display:
            self.app.tell(Text("The curve is shown {shown}.", shown=shown))

    def action_crank(self, by: int) -> None:
        """Turn the vectors that turn with the crank, in steps."""
        if not self.curve_pane.turn_crank(by):
            self.app.tell(Text("This curve has no vectors that turn with the crank."))

    def action_walk(self, by: int) -> None:
        """To the next point of a curve that is made at many."""
        if not self.curve_pane.walk(by):
            self.app.tell(Text("This curve is no working cycle of a mesh."))

    # --- comparing and explaining
    def action_compare(self) -> None:
        """Ask what to compare with, show the comparison, and go where the user wants to."""
        from .compare import CompareScreen

        app, session = self.app, self.session
        if not session.valid:
            place, reason = next(iter(session.reasons().items()))
            app.tell(
                Text(
                    "Nothing to compare while the input is not valid: {key} {reason}",
                    key=".".join(map(str, place)),
                    reason=reason,
                ),
                "error",
            )
            return

        async def go(id: str | None) -> None:
            if id is not None and id.partition(".")[0] in {step.key for step in STEPS}:
                await self.to_value(id)

        def show(other: Chosen | None) -> None:
            if other is not None:
                app.push_screen(CompareScreen(session, other), go)

        app.push_screen(CompareWith(session), show)

    def action_explain(self) -> None:
        """Where the number comes from that the cursor is on; then, if one was chosen, to the field of an input."""
        subject = self._subject()
        if not subject and isinstance(self.focused, Calculation) and self.page is None:
            self.app.tell(WRITING)
            return
        if not subject:
            self.app.tell(
                Text("There is nothing to explain here: go to a check, a line of the calculation or a value.")
            )
            return
        from .explain import Explain

        self.app.push_screen(Explain(self.session, **subject), self._explained)

    async def _explained(self, key: str | None) -> None:
        if key is not None:
            await self.to_value(key)

    def _subject(self) -> dict[str, Any]:
        """What is to be explained: the check, the line or the value under the cursor."""
        page = self.page
        results, focused = self.session.results, self.focused
        if results is None or not isinstance(focused, ItemList):
            return {}
        lines = page.whole.lines if page is not None else ()
        if isinstance(focused, Checks):
            check = next((c for c in results.checks() if c.id == focused.key), None)
            if check is None:
                return {}
            index = page.sheet.line_of.get(check.id) if page is not None else None
            return {"check": check} | ({"line": lines[index]} if index is not None else {})
        # else those are lines of older results, as they are without a row to see
        if isinstance(focused, Calculation) and page is not None:
            numbers = [entry.number for entry in page.sheet.entries]
            return {"line": lines[numbers.index(focused.key)]} if focused.key in numbers else {}
        if isinstance(focused, TableList) and focused.table is not None and focused.table.id == VALUES:
            return {"value": focused.table.rows[int(focused.key.rpartition(" ")[2])][-1]}
        if focused.key in self.session.values():
            return {"value": focused.key}
        return {}

    # --- help, palette, copy, end
    def action_help(self) -> None:
        self.app.push_screen(HelpScreen(self))

    def action_palette(self) -> None:
        self.app.action_command_palette()

    def action_copy(self, what: str) -> None:
        """Copy the `value` or the whole `line` that the user is at."""
        focused, pane = self.focused, self.curve_pane
        text = ""
        if isinstance(focused, ItemList) and focused.item is not None:
            text = getattr(focused.item, what) or focused.item.line
        elif self.pane == "curve" and (leaf := pane.leaf) is not None:
            reading = pane.reading
            line = (
                Text("{curve}: {reading}", curve=leaf.title, reading=reading.line)
                if reading is not None
                else leaf.title
            )
            text = self.app.say(reading.value if reading is not None and what == "value" else line)
        else:
            field = self.form.field
            place = field.place if field is not None else None if self.form.here() else self.form.last
            if place is not None and place[-1] is not None and self.session.text(place):
                about = self.session.about(place)
                value = f"{self.session.text(place)} {about.unit}".rstrip()
                text = value if what == "value" else f"{about.label} {value}"
        if not text:
            self.app.tell(Text("There is nothing to copy here."))
            return
        self.app.copy_to_clipboard(text)
        self.app.tell(Text("Copied: {text}", text=text))

    async def action_quit(self) -> None:
        await self.app.action_quit()

    # --- the closing page
    def action_ready(self, unfolded: str = "") -> None:
        """Show what is left to do, and go where it says."""
        from .ready import ReadyScreen

        self.session.solve()  # the page says what holds of the design as it is now
        self.app.push_screen(ReadyScreen(self, unfolded), self._go_from_ready)

    async def _go_from_ready(self, to: str | None) -> None:
        if to in BY_ID:
            await self.run_action(BY_ID[to].does)
        elif to is not None:
            step = next(step for step in STEPS if step.key == to.partition(".")[0])
            if "." in to:
                await self.to_check(step, to)
            else:
                self.at_pane("inputs")
                await self.open_step(step)
