# SPDX-License-Identifier: Apache-2.0
"""Actions that change the design: increments, undo, the remedies of a finding, a row of a ranked table."""

from collections.abc import Callable, Iterable
from functools import partial
from typing import TYPE_CHECKING

from calc.design.model import STEPS
from calc.sheet.check import URGENT, Check, grouped
from calc.sheet.text import COMMA, Text

from ..offers import CHOICES
from ..session.editing import told
from ..session.places import Place, first_key
from ..widgets.entry import Entry
from ..widgets.field import Field
from ..widgets.form import Form
from .background_solve import BackgroundSolve
from .host import Host
from .moves import Moves

if TYPE_CHECKING:
    from calc.studies.repair.trials import RepairOption


def rebuilt(host: Host) -> None:
    """Show a design that has changed in more than one place."""
    if (field := host.form.field) is not None:
        field.rewrite()
    host.edited()
    host.form.rebuild(host.form.here())


class EditActions:
    def __init__(self, host: Host, moves: Moves, background: BackgroundSolve) -> None:
        self._host, self._moves, self._background = host, moves, background

    def add_element(self, place: Place) -> None:
        """One more element of an array, and into its first field."""
        form = self._host.form
        index = form.chosen[place] = self._host.session.add(place)
        self._host.edited()
        form.rebuild((*place, index, first_key(place)))

    def remove_element(self, place: Place, index: int) -> None:
        self._host.session.remove(place, index)
        self._host.edited()

    def put_table(self, place: Place, there: bool) -> None:
        """Add a table, and go into its first field; or leave it out."""
        self._host.session.put_table(place, there)
        self._host.edited()
        if there:
            self._host.form.rebuild((*place, first_key(place)))

    def nudge(self, by: int) -> None:
        """Raise or lower the number of a field by an increment."""
        host = self._host
        field = host.form.field
        if field is None:
            return
        text = field.nudge(by)
        if isinstance(field.box, Entry) and text != field.box.value:
            if text == host.session.text(field.place):
                number = field.about.kind in ("number", "integer")
                host.app.tell(
                    Text("There is no step further.") if number else Text("A list, or a text, has no increment.")
                )
                return
            field.box.value = text
            field.box.cursor_position = len(text)

    async def undo(self) -> None:
        await self._travel(self._host.session.undo, Text("Undone"), Text("Nothing to undo."))

    async def redo(self) -> None:
        await self._travel(self._host.session.redo, Text("Done again"), Text("Nothing to redo."))

    async def _travel(self, travel: Callable[[], Place | None], done: Text, nothing: Text) -> None:
        from ..session.versions import edit_text

        host = self._host
        before = host.session.data
        idle = isinstance(host.focused, Form)  # a letter was the key, and the next one shall be a key as well
        place = travel()
        if place is None:
            host.app.tell(nothing)
            return
        if changed := edit_text(before, host.session.data):
            host.app.tell(Text("{done}: {changes}", done=done, changes=changed))
        field: Field | None = host.form.field
        if field is not None and field.place == place:
            field.rewrite()
        host.edited()
        if place:
            await self._moves.to_field(place)
            if (there := host.form.field) is not None:
                there.rewrite()
            if idle:
                host.form.last = place
                host.form.focus(scroll_visible=False)

    def remedies(self) -> None:
        """List what would help against the finding under the cursor, else against the first of the step or the
        design."""
        host, session = self._host, self._host.session
        if session.reasons() or not session.current:
            solving = session.failure or Text("It is still being solved.")
            host.app.tell(Text("First the input has to be valid and solved.") if session.reasons() else solving)
            return
        finding = self._finding()
        if finding is None:
            host.app.tell(Text("Nothing is open: no limit fails, and every caution is kept or accepted."))
            return
        from .remedies import Remedies

        host.app.push_screen(Remedies(session, finding), partial(self._remedied, session.generation, finding))

    def _finding(self) -> Check | str | None:
        """A check, or the key of a step without a solution."""
        host, results = self._host, self._host.session.results
        if results is None:
            return None
        if (
            host.focused is host.checks
            and (here := next((c for c in results.checks() if c.id == host.checks.key), None)) is not None
        ):
            return here
        for outcomes in ([results.outcomes[host.step.key]], [results.outcomes[step.key] for step in STEPS]):
            if (
                stuck := next((outcome.key for outcome in outcomes if outcome.state == "no_solution"), None)
            ) is not None:
                return stuck
            groups = grouped(c for outcome in outcomes for c in outcome.checks)
            if groups and groups[0][0].verdict in URGENT:
                return groups[0][0]
        return None

    async def _remedied(self, generation: int, finding: Check | str, way: "RepairOption | None") -> None:
        host = self._host
        if way is not None and way.changes:
            effect = (
                Text("{check} {result}", check=finding.name, result=way.effect)
                if isinstance(finding, Check)
                else way.effect
            )
            result = Text("{change}: {result}. Undo takes it back.", change=way.words, result=effect)
            self._apply(way.changes, result)
        elif host.session.generation == generation:
            self._background.seek_remedy()  # which the list has interrupted
        else:  # something was locked, or unlocked
            rebuilt(host)
        if way is not None and not way.changes:  # which only names the field
            await self._moves.to_field(host.session.place(way.keys[0]))

    def _apply(self, changes: Iterable[str], text: Text) -> None:
        """Make changes as one step of the undo, and tell them."""
        self._host.session.apply(changes)
        rebuilt(self._host)
        self._host.app.tell(text)

    def choose(self) -> None:
        """The ranked table of what can be chosen for this step."""
        host = self._host
        if host.step.key not in CHOICES:
            steps = COMMA.join(s.title for s in STEPS if s.key in CHOICES)
            host.app.tell(Text("There is nothing to choose in this step; there is in {steps}.", steps=steps))
            return
        if not host.session.valid:
            host.app.tell(Text("First the input has to be valid."), "warning")
            return
        from .selection import Choosing

        host.app.push_screen(Choosing(host.session, host.step.key), self._chosen)

    def drive(self) -> None:
        """The front of whole drives."""
        host = self._host
        if not host.session.valid:
            host.app.tell(Text("First the input has to be valid."), "warning")
            return
        from .drive import Driving

        host.app.push_screen(Driving(host.session), self._chosen)

    def _chosen(self, changes: tuple[str, ...] | None) -> None:
        host = self._host
        if changes is not None:
            self._apply(changes, told(host.session.document, changes) or Text("The design is as it was."))

    def guide(self) -> None:
        """Show what is to be decided in each step, or leave it out."""
        host = self._host
        host.app.guiding = not host.app.guiding
        host.session.memory.set_setting("guide", host.app.guiding)
        for form in host.forms():
            form.refresh_taken()
