# SPDX-License-Identifier: Apache-2.0
"""What the keys of the main screen do, one method for each action of the table."""

from collections.abc import Callable, Iterable
from typing import Any

from textual import work

from calc.design import STEPS
from calc.sheet.errors import BadInput

from ..actions import BY_ID
from ..changes import told
from ..offers.offer import CHOICES
from ..places import Place
from ..sheets import VALUES
from ..widgets.array_heading import ArrayHeading
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks, sorted_checks
from ..widgets.choice import Choice
from ..widgets.curve_pane import CurvePane
from ..widgets.entry import Entry
from ..widgets.field import Field
from ..widgets.form import Form
from ..widgets.item_list import ItemList
from ..widgets.pane import Pane
from ..widgets.table_heading import TableHeading
from ..widgets.table_list import TableList
from .doing_curves import DoingCurves
from .doing_files import DoingFiles

WRITING = "The calculation is still being written out."
VIEWS = {"inputs": "Inputs", "checks": "Checks", "calculation": "Calc", "curve": "Plot"}
FIRST, LAST = "This is the first step.", "This is the last step."


class Doing(DoingCurves, DoingFiles):
    """The actions.  Mixed into the main screen, which has the parts."""

    # --- steps
    async def action_step(self, n: int) -> None:
        await self._me.open_step(STEPS[n - 1])

    async def action_next(self) -> None:
        await self._turn(1)

    async def action_back(self) -> None:
        await self._turn(-1)

    async def _turn(self, by: int) -> None:
        me = self._me
        me.app.forget(FIRST, LAST)
        n = me.number - 1 + by
        if 0 <= n < len(STEPS):
            await me.open_step(STEPS[n])
        else:
            me.app.tell(LAST if by > 0 else FIRST)

    async def action_trouble(self) -> None:
        """The next check that fails; after those, the next that warns."""
        me = self._me
        if self.session.reasons():
            place = next(iter(self.session.reasons()))
            await self.to_field(place)
            return
        if self.session.results is None:
            return
        outcomes = self.session.results.outcomes
        faults = [(s, c) for s in STEPS for c in sorted_checks(outcomes[s.key].checks) if c.verdict != "pass"]
        faults.sort(key=lambda f: f[1].verdict != "fail")
        if not faults:
            me.app.tell("No check fails or warns.")
            return
        checks = me.query_one(Checks)
        here = next((n for n, (s, c) in enumerate(faults) if s is me.step and c.id == checks.key), None)
        if here is not None and checks.has_focus:
            step, check = faults[(here + 1) % len(faults)]
        else:
            step, check = next((f for f in faults if f[0] is me.step and f[1].verdict == faults[0][1].verdict), faults[0])
        me.at_pane("checks")
        await me.open_step(step, stay=True)
        checks.focus()
        me.call_after_refresh(checks.go_to, check.id)

    def to_line(self, check: str) -> None:
        """The line of the calculation that a check comes from."""
        me = self._me
        calculation = me.query_one(Calculation)
        if me.page is None:
            me.app.tell(WRITING)
            return
        index = calculation.sheet.line_of.get(check)
        if index is None:
            me.app.tell("No single line of the calculation gives this value.")
            return
        me.at_pane("calculation")
        calculation.focus()
        me.call_after_refresh(calculation.go_to, calculation.sheet.entries[index].number, top=True)

    async def to_value(self, id: str) -> None:
        """The field of an input, or the step of a result."""
        me = self._me
        step = next((s for s in STEPS if s.key == id.partition(".")[0]), self._me.step)
        try:
            place: Place | None = self.session.place(id)
        except BadInput:
            place = None
        me.at_pane("inputs")
        await me.open_step(step, place)

    async def to_field(self, place: Place) -> None:
        """Open the step of a field and put the focus there."""
        me = self._me
        step = next((s for s in STEPS if place and s.key == place[0]), me.step)
        me.at_pane("inputs")
        await me.open_step(step, place)
        me.form.focus_place(place)

    # --- moving
    def action_down(self) -> None:
        self._move(1)

    def action_up(self) -> None:
        self._move(-1)

    def _move(self, by: int) -> None:
        me = self._me
        focused = me.focused
        if isinstance(focused, CurvePane):
            focused.read_line(by)
        elif isinstance(focused, ItemList):
            before = focused.cursor
            focused.move(by)
            if focused.cursor == before and me.pane == "inputs" and by < 0:
                me.form.go(by)
        elif me.pane == "inputs":
            me.form.go(by)

    def action_pane(self, by: int) -> None:
        """The next pane that is shown; narrow, the panes follow each other."""
        me = self._me
        names = [name for name in ("steps", *VIEWS) if name in VIEWS or me.has_class("-wide")]
        here = names.index(me.pane) if me.pane in names else 0
        self.action_to_view(names[(here + by) % len(names)])

    def action_view(self) -> None:
        """Narrow: the next view.  Wide: this pane large, or all of them again."""
        me = self._me
        if me.has_class("-wide"):
            me.large = not me.large
            me.set_out()
        else:
            views = list(VIEWS)
            here = views.index(me.pane) if me.pane in views else 0
            self.action_to_view(views[(here + 1) % len(views)])

    def action_to_view(self, name: str) -> None:
        me = self._me
        me.at_pane(name)
        if name == "inputs":
            me.form.focus_place(None)
        else:
            me.query_one(f"#{name}", Pane).target.focus()

    def action_leave(self) -> None:
        """Out of the field; the cursor off the curve; out of a large pane; back to the form."""
        me = self._me
        if isinstance(me.focused, (Entry, Choice)):
            me.form.focus(scroll_visible=False)
        elif me.pane == "curve" and me.query_one(CurvePane).put_away():
            pass
        elif me.large:
            me.large = False
            me.set_out()
        elif me.pane != "inputs":
            me.at_pane("inputs")
            me.form.focus(scroll_visible=False)

    def action_go_on(self) -> None:
        me = self._me
        if isinstance(me.focused, ItemList):
            me.focused.choose()
        elif me.focused is me.form:
            if me.step.key in self.session.data:
                me.form.focus_place(None)
            else:
                me.form.ask()
        elif isinstance(me.focused, (ArrayHeading, TableHeading)) and me.focused.adds:
            me.focused.action_add()
        elif me.pane == "inputs":
            me.form.go(1)

    # --- editing
    def action_nudge(self, by: int) -> None:
        me = self._me
        field = me.form.field
        if field is None:
            return
        text = field.nudge(by)
        if isinstance(field.box, Entry) and text != field.box.value:
            if text == self.session.text(field.place):
                me.app.tell(
                    "A list, or a text, has no increment." if field.about.kind not in ("number", "integer") else "There is no step further."
                )
                return
            field.box.value = text
            field.box.cursor_position = len(text)

    async def action_undo(self) -> None:
        await self._travel(self.session.undo, "Undone", "Nothing to undo.")

    async def action_redo(self) -> None:
        await self._travel(self.session.redo, "Done again", "Nothing to redo.")

    async def _travel(self, travel: Callable[[], Place | None], done: str, nothing: str) -> None:
        from ..others import edit_text

        me, before = self._me, self.session.data
        idle = isinstance(me.focused, Form)  # a letter was the key, and the next one shall be a key as well
        place = travel()
        if place is None:
            me.app.tell(nothing)
            return
        if changed := edit_text(before, self.session.data):
            me.app.tell(f"{me.app.say(done)}: {changed}")
        field: Field | None = me.form.field
        if field is not None and field.place == place:
            field.rewrite()
        me.edited()
        if place:
            await self.to_field(place)
            if (there := me.form.field) is not None:
                there.rewrite()
            if idle:
                me.form.focus(scroll_visible=False)

    # --- mending and choosing
    def action_mend(self) -> None:
        """Apply the remedy of the step that fails."""
        me = self._me
        if self.session.reasons() or not self.session.current:
            solving = self.session.failure or "It is still being solved."
            me.app.tell("First the input has to be valid and solved." if self.session.reasons() else solving)
            return
        step, remedy = me.trouble, me.remedy
        if not step:
            me.app.tell("No limit fails.")
        elif remedy is None:
            me.app.tell("A remedy is still being looked for …")
            me.seek_remedy()
        elif not remedy.changes:
            me.app.tell("No remedy was found: " + "; ".join(f"{one.name}: {one.why}" for one in remedy.left), "warning")
        else:
            self._apply(remedy.changes, f"{remedy.words}: {remedy.said}. Undo takes it back.")

    def _apply(self, changes: Iterable[str], said: str) -> None:
        """Make changes as one step of the undo, and say so."""
        self.session.apply(changes)
        self.rebuilt()
        self._me.app.tell(said)

    def action_choose(self) -> None:
        """The ranked table of what can be chosen for this step."""
        me = self._me
        if me.step.key not in CHOICES:
            there = ", ".join(s.title for s in STEPS if s.key in CHOICES)
            me.app.tell(f"There is nothing to choose in this step; there is in {there}.")
            return
        if not self.session.valid:
            me.app.tell("First the input has to be valid.", "warning")
            return
        from .choosing import Choosing

        me.app.push_screen(Choosing(self.session, me.step.key), self._chosen)

    def _chosen(self, changes: tuple[str, ...] | None) -> None:
        me = self._me
        if changes is not None:
            self._apply(changes, "; ".join(told(self.session.document, changes, me.app.say)) or "The design is as it was.")

    def action_guide(self) -> None:
        """Show what is to be decided in each step, or leave it out."""
        me = self._me
        me.app.guiding = not me.app.guiding
        self.session.memory.set_setting("guide", me.app.guiding)
        for form in me.query(Form):
            form.refresh_taken()

    # --- comparing and explaining
    @work
    async def action_compare(self) -> None:
        from .compare import compare

        await compare(self._me)

    def action_explain(self) -> None:
        """Where the number comes from that the cursor is on; then, if one was chosen, to the field of an input."""
        me = self._me
        asked = self._asked()
        if not asked and isinstance(me.focused, Calculation) and me.page is None:
            me.app.tell(WRITING)
            return
        if not asked:
            me.app.tell("There is nothing to explain here: go to a check, a line of the calculation or a value.")
            return
        from .explain import Explain

        me.app.push_screen(Explain(self.session, **asked), self._explained)

    async def _explained(self, key: str | None) -> None:
        if key is not None:
            await self.to_value(key)

    def _asked(self) -> dict[str, Any]:
        """What is to be explained: the check, the line or the value under the cursor."""
        me, results = self._me, self.session.results
        focused = me.focused
        if results is None or not isinstance(focused, ItemList):
            return {}
        if isinstance(focused, Checks):
            check = next((c for c in results.checks() if c.id == focused.key), None)
            if check is None:
                return {}
            index = me.page.sheet.line_of.get(check.id) if me.page is not None else None
            return {"check": check} | ({"line": results.outcomes[me.step.key].lines[index]} if index is not None else {})
        if isinstance(focused, Calculation) and "." in focused.key and me.page is not None:  # else those are lines of older results
            return {"line": results.outcomes[me.step.key].lines[int(focused.key.partition(".")[2]) - 1]}
        if isinstance(focused, TableList) and focused.table is not None and focused.table.id == VALUES:
            return {"value": focused.table.rows[int(focused.key.rpartition(" ")[2])][-1]}
        if focused.key in self.session.values():
            return {"value": focused.key}
        return {}

    def action_line(self) -> None:
        """From a check to the line of the calculation that gives its value."""
        me = self._me
        if isinstance(me.focused, Checks) and me.focused.key:
            self.to_line(me.focused.key)
        else:
            me.app.tell("Go to a check first (F7, or F6 to the checks).")

    # --- help, palette, copy, end
    def action_help(self) -> None:
        from .help import HelpScreen

        me = self._me
        me.app.push_screen(HelpScreen(me))

    def action_palette(self) -> None:
        self._me.app.action_command_palette()

    def action_copy(self) -> None:
        self._copy("value")

    def action_copy_line(self) -> None:
        self._copy("line")

    def _copy(self, what: str) -> None:
        me = self._me
        focused: Any = me.focused
        text = ""
        if isinstance(focused, ItemList) and focused.item is not None:
            text = getattr(focused.item, what) or focused.item.line
        elif me.pane == "curve" and (leaf := me.query_one(CurvePane).leaf) is not None:
            reading = me.query_one(CurvePane).reading
            text = leaf.title if reading is None else reading.value if what == "value" else f"{leaf.title}: {reading.line}"
        else:
            place = me.form.here() or me.form.last
            if place is not None and (place[-1] is not None) and me.session.text(place):
                about = self.session.about(place)
                value = f"{self.session.text(place)} {about.unit}".rstrip()
                text = value if what == "value" else f"{about.label} {value}"
        if not text:
            me.app.tell("There is nothing to copy here.")
            return
        me.app.copy_to_clipboard(text)
        me.app.tell(f"Copied: {text}")

    async def action_quit(self) -> None:
        await self._me.app.action_quit()


for _action in BY_ID.values():  # a key without its method would be a dead key
    assert hasattr(Doing, "action_" + _action.does.partition("(")[0]), _action.id
