# SPDX-License-Identifier: Apache-2.0
"""What the main screen's keys and forms change: the design (its fields, remedies, rows of ranked tables, steps that are
built or left out, findings that are accepted) and its files."""

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING

from textual.geometry import Region
from textual.notifications import SeverityLevel
from textual.worker import get_current_worker

from calc.bearings.rolling.row import RollingRow
from calc.design.addresses import address, as_table, asks
from calc.design.labels import SHAFTS, Place
from calc.design.model import MOST_SHAFTS, STEPS
from calc.sheet.check import URGENT, Check
from calc.sheet.errors import BadInput, Cancelled
from calc.sheet.quantity import dotted
from calc.sheet.remedy import assignment
from calc.sheet.text import COMMA, EMPTY, Name, Text
from calc.sheet.verdict import grouped

from ..actions import is_typed
from ..exports.offered import FileRow, rows, write_draft
from ..session.editing import BuildPlan, told
from ..session.guide import no_choice
from ..session.places import GEARS, driver_of, first_key, named_key, ways_to_add
from ..session.recording import Recording
from ..session.recovery import Edits
from ..session.saving import ChangedOnDisk, Draft, NeedsUpgrade, SaveError, write_atomic
from ..session.session import Session
from ..session.solving import mistake
from ..session.travelled import travelled
from ..widgets.entry import Entry
from ..widgets.field import Field
from ..widgets.form import Form
from ..widgets.radio import Todo
from ..widgets.steps import states_of
from .dialogs import Accept, Ask, Choose, LeaveOut
from .path_dialogs import ExportDialog, OpenDialog, RecordDialog, SaveDialog, folder_of
from .workbench_moves import WorkbenchMoves
from .workbench_panes import FIRST_VALID

if TYPE_CHECKING:
    from calc.studies.repair.option import RepairOption

BUILDING = Text("It is being built by the rules …")
BUILDING_ALL = Text("All that is left is being built by the rules: up to half a minute …")
GIVE_SIZE = Text("Give a size first, for instance 6205; {key} lists sizes once one is there.")
SIZE: Place = (dotted(RollingRow.size),)
ASK_UPGRADE = Text(
    "The file is written in schema 1, which has no words for what was changed.\n"
    "Save it in schema 2? Its comments stay, and the old file is kept as .bak."
)


class WorkbenchEdits(WorkbenchMoves):
    # --- fields, arrays and tables
    def rebuilt(self) -> None:
        """Show a design that has changed in more than one place."""
        if (field := self.form.field) is not None:
            field.renew()
        self.edited()
        self.form.rebuild(self.form.here())

    def apply(self, changes: Iterable[str], text: Text) -> None:
        """Make changes as one step of the undo, and tell them."""
        self.session.apply(changes)
        self.rebuilt()
        self.app.tell(text)

    def add_element(self, place: Place, beside: Region) -> None:
        """One more element of an array, and into its first field; of the shafts it is asked which."""
        session, form = self.session, self.form
        if place == SHAFTS and session.shafts:
            ways = ways_to_add(session.value(SHAFTS), session.original)
            said = {what: self.app.say(words) for what, words in ways.items()}
            if len(session.shafts) < MOST_SHAFTS:
                self.app.push_screen(
                    Choose(tuple(ways), next(iter(ways)), "", beside, said=said.__getitem__), self._add_shaft
                )
            else:
                self.app.tell(Text("There are at most {n} shafts.", n=MOST_SHAFTS))
            return
        index = form.chosen[place] = session.add(place)
        self.edited()
        form.rebuild((*place, index, first_key(place)))

    def _add_shaft(self, what: str | None) -> None:
        if what is not None:
            self.session.shaft = index = self.session.add_shaft(self.session.original, what)
            self.edited()
            self.form.rebuild((*SHAFTS, index))
            if GEARS in self.session.data:
                shaft = Name(self.session.shafts[index])
                driver = driver_of(self.session.data, shaft)
                turned = Text("{driver} drives {shaft}: the train is in step 5.", driver=Name(driver), shaft=shaft)
                loose = Text("No wheel turns {shaft} yet: its finding in step 5 says which one would.", shaft=shaft)
                self.app.tell(turned if driver else loose)

    def remove_element(self, place: Place, index: int) -> None:
        before = self.session.shafts
        self.session.remove(place, index)
        self.edited()
        gone = [name for name in before if name not in self.session.shafts]
        if len(gone) > 1:
            self.app.tell(Text("Taken out: {names}. Undo brings them back.", names=COMMA.join(map(Name, gone))))

    def put_table(self, place: Place, there: bool) -> None:
        """Add a table, and go into its first field; or leave it out."""
        self.session.put_table(place, there)
        self.edited()
        if there:
            self.form.rebuild((*place, first_key(place)))

    def action_nudge(self, by: int) -> None:
        """Raise or lower the number of a field by an increment."""
        field = self.form.field
        if field is None:
            return
        text = field.nudge(by)
        if isinstance(field.box, Entry) and text != field.box.value:
            if text == self.session.text(field.place):
                number = field.about.kind in ("number", "integer")
                self.app.tell(
                    Text("There is no step further.") if number else Text("A list, or a text, has no increment.")
                )
                return
            field.box.value = text
            field.box.cursor_position = len(text)

    def action_lock(self) -> None:
        """Lock the input of a field, or unlock it."""
        if not self.form.toggle_lock():
            self.app.tell(Text("Go to a field first: it is an input that can be locked."))

    # --- undo and redo
    async def action_undo(self) -> None:
        await self._travel(self.session.undo, Text("Undone"), Text("Nothing to undo."))

    async def action_redo(self) -> None:
        await self._travel(self.session.redo, Text("Done again"), Text("Nothing to redo."))

    async def _travel(self, travel: Callable[[], Place | None], done: Text, nothing: Text) -> None:
        """Take it back, or do it again; say what has changed, and go there."""
        before = self.session.history.state
        by_letter = isinstance(self.focused, Form) and is_typed(self.app.struck_key)
        where = travel()
        if where is None:
            self.app.tell(nothing)
            return
        names = {check.id: check.name for check in self.session.results.checks()} if self.session.results else {}
        what = travelled(before, self.session.history.state, lambda id: names.get(id, Name(id)))
        if what.words:
            self.app.tell(Text("{done}: {changes}", done=done, changes=what.words))
        place = what.place or where
        field: Field | None = self.form.field
        if field is not None:
            field.renew()
        self.edited()
        step = next((step for step in STEPS if step.key == what.step), None)
        if what.check and step is not None:
            await self.to_check(step, what.check)
        elif place:
            await self.to_field(place)
            there = self.form.field
            if there is not None:
                there.renew()
            if by_letter:  # the next letter shall be a key as well; Enter goes into the field
                self.form.last = place
                self.set_focus(self.form, scroll_visible=False)
                self.call_after_refresh((there or self.form).scroll_visible, animate=False)
        elif step is not None:
            self.at_pane("inputs")
            await self.open_step(step)

    # --- remedies
    def action_remedies(self) -> None:
        """List what would help against the finding under the cursor, else against the first of the step or the
        design."""
        session = self.session
        if session.reasons() or not session.current:
            solving = session.failure or Text("It is still being solved.")
            self.app.tell(Text("First the input has to be valid and solved.") if session.reasons() else solving)
            return
        finding = self._finding()
        if finding is None:
            self.app.tell(Text("Nothing is open: no limit fails, and every caution is kept or accepted."))
            return
        from .remedies import Remedies

        step = finding if isinstance(finding, str) else finding.id.partition(".")[0]
        dialog = Remedies(session, finding, self.known_remedy(step))
        self.app.push_screen(dialog, partial(self._remedied, session.generation, finding))

    def _finding(self) -> Check | str | None:
        """A check, or the key of a step without a solution."""
        results = self.session.results
        if results is None:
            return None
        if (
            self.focused is self.checks
            and (here := next((c for c in results.checks() if c.id == self.checks.key), None)) is not None
        ):
            return here
        for outcomes in ([results.outcomes[self.step.key]], [results.outcomes[step.key] for step in STEPS]):
            if (
                stuck := next((outcome.key for outcome in outcomes if outcome.state == "no_solution"), None)
            ) is not None:
                return stuck
            groups = grouped(c for outcome in outcomes for c in outcome.checks)
            if groups and groups[0][0].verdict in URGENT:
                return groups[0][0]
        return None

    async def _remedied(self, generation: int, finding: Check | str, way: "RepairOption | None") -> None:
        if way is not None and way.changes:
            effect = (
                Text("{check} {result}", check=finding.name, result=way.result)
                if isinstance(finding, Check) and way.passes and not way.breaks
                else way.result
            )
            result = Text("{change}: {result}. Undo takes it back.", change=way.words, result=effect)
            self.apply(way.changes, result)
        elif self.session.generation == generation:
            self.seek_remedy()  # which the list has interrupted
        else:  # something was locked, or unlocked
            self.rebuilt()
        if way is not None and not way.changes:  # which only names the field
            await self.to_field(address(self.session.data, way.keys[0], whole=True))

    # --- tables to choose from
    def action_choose(self) -> None:
        """The ranked table of what can be chosen for this step."""
        if why := no_choice(self.step.key, self.session.data):
            self.app.tell(why)
            return
        if not self.session.valid:
            sizeless = any(place[-1:] == SIZE and not self.session.text(place) for place in self.session.reasons())
            key = self.app.shown_key("choose")
            self.app.tell(Text(GIVE_SIZE.template, key=key) if sizeless else FIRST_VALID, "warning")
            return
        from .selection import Choosing

        self.app.push_screen(Choosing(self.session, self.step.key, self.known_remedy(self.step.key)), self._chosen)

    def action_drive(self) -> None:
        """The front of whole drives."""
        if why := self.no_drive():
            self.app.tell(why, "warning")
            return
        from .drive import Driving

        self.app.push_screen(Driving(self.session), self._chosen)

    def no_fit(self) -> Text:
        """Why there is nothing to fit; empty where there is."""
        if not self.session.valid:
            return FIRST_VALID
        return EMPTY if self.session.design.fits else Text("This design has no [[fits]].")

    def action_fit(self) -> None:
        """Inputs from runs of the bench."""
        if why := self.no_fit():
            self.app.tell(why, "warning")
            return
        from .fitting import Fitting

        self.app.push_screen(Fitting(self.session, self.step.key), self._chosen)

    def _chosen(self, changes: tuple[str, ...] | None) -> None:
        if changes is not None:
            self.apply(changes, told(self.session.document, changes) or Text("The design is as it was."))

    def action_guide(self) -> None:
        """Show what is to be decided in each step, or leave it out."""
        self.app.guiding = not self.app.guiding
        self.session.memory.set_setting("guide", self.app.guiding)
        for form in self.query(Form):
            form.refresh_taken()

    # --- accepting a finding
    def action_accept(self) -> None:
        """Accept the finding under the cursor, or take that back."""
        check = self.checks.check
        if check is None:
            self.app.tell(Text("Go to a finding first."))
        elif check.accepted:
            self.apply([f"accepted.{check.id}="], Text("Open again: {check}.", check=check.name))
        elif check.kind == "limit":
            why = Text(
                "{check} is a limit, which nobody can accept: change what is near it or beyond. {key} offers what "
                "would help.",
                check=check.name,
                key=self.app.shown_key("fix"),
            )
            self.app.tell(why, "warning")
        elif not check.open:
            self.app.tell(Text("{check} holds: there is nothing to accept.", check=check.name))
        else:
            group = [c for c in self.checks.group if c.kind != "limit"]
            self.app.push_screen(Accept(group, self.app.say), lambda reason: self._accepted(group, reason))

    def _accepted(self, checks: Sequence[Check], reason: str | None) -> None:
        if reason is not None:
            changes = [assignment(f"accepted.{check.id}", reason) for check in checks]
            self.apply(
                changes, Text("Accepted: {check}. It stands in the report with its reason.", check=checks[0].name)
            )

    # --- a step that the design does not have: built by rules, or left out for a reason
    def build_step(self, step: str, choice: str) -> None:
        """Build it, with the balancing or the kind of bearings that was chosen, in another thread: that may take a
        second."""
        if not self.session.valid:
            self.app.tell(FIRST_VALID, "warning")
            return
        self.app.tell(BUILDING, stays=True)
        self.in_thread("build", partial(self._build, self.session, step, choice))

    def action_build_all(self) -> None:
        """Build all that is still to do, in another thread, and show what it came to."""
        if not self.session.valid:
            self.app.tell(FIRST_VALID, "warning")
        elif "engine" not in self.session.data:
            self.app.tell(Text("Nothing can be built without an engine."), "warning")
        else:
            self.app.tell(BUILDING_ALL, stays=True)
            self.in_thread("build", partial(self._build, self.session, ""))

    def _build(self, session: Session, step: str, choice: str = "") -> None:
        """Runs in another thread; without a step, of all that are to do."""
        try:
            plan = session.plan(step, choice) if step else session.plan_all()
        except Exception as error:  # a mistake of the program must not take the user's work with it
            why = mistake(error)
            plan = BuildPlan({}, {}, why)
        if get_current_worker().is_cancelled:  # another build has taken its place, whose message stays
            return
        self.call_later(self._built, session, step, plan)

    def _built(self, session: Session, step: str, plan: BuildPlan) -> None:
        # after it is shown, however soon the build is done
        self.app.call_later(self.app.forget, BUILDING, BUILDING_ALL)
        if session is not self.session or not self.stands:
            return
        if why := session.take(plan):
            self.app.tell(why, "warning")
            before = takewhile(lambda state: state.key != step, states_of(session))
            if (first := next((state.key for state in before if state.state == "todo"), None)) is not None:
                self.call_later(self.open_step, next(candidate for candidate in STEPS if candidate.key == first))
            return
        if step and (reason := as_table(session.data.get("without")).get(step)):
            self.app.tell(Text("Left out: {reason}.", reason=str(reason)), "warning")
        # before the form is put in order, which would bring it back to a field
        self.set_focus(self.form, scroll_visible=False)
        self.edited()
        if not step:
            self.call_later(self._built_all, plan.left)

    async def _built_all(self, why: Text) -> None:
        """To the closing page, or to the first step that the rules could not build, which says why."""
        todo = next((state.key for state in states_of(self.session) if state.state == "todo"), None)
        if todo is None:
            self.action_ready()
        else:
            await self.open_step(next(step for step in STEPS if step.key == todo))
            self.app.tell(Text("The rules came no further than this step: {why}.", why=why), "warning")

    def action_leave_out(self) -> None:
        """Leave the step out that is shown."""
        if self.form.query(Todo):
            self.leave_step_out(self.step.key)
        else:
            self.app.tell(Text("Only a step that the design does not have can be left out."))

    def leave_step_out(self, step: str) -> None:
        """Ask why."""
        reason = str(as_table(self.session.data.get("without")).get(step, ""))
        self.app.push_screen(LeaveOut(step, reason, self.app.say), partial(self._left_out, self.session, step))

    async def _left_out(self, session: Session, step: str, reason: str | None) -> None:
        if reason is None or session is not self.session or not self.stands:
            return
        session.leave_out(step, reason)
        self.edited()
        await self.lead_on()

    # --- saving
    def action_save(self) -> None:
        if self.session.read_only:
            self.app.tell(Text("{name} is read-only; give another name.", name=self.session.name), "warning")
            self.action_save_as()
            return
        self._save(partial(self.session.save, force=self.app.warned_of == self.session.home))

    def _save(self, save: Callable[..., Path], upgrade: bool = False) -> None:
        """Save, or say why not; where the file's schema has no words for what changed, ask whether to write it in that
        of this program."""
        try:
            path = save(upgrade=upgrade)
        except NeedsUpgrade:
            say = self.app.say
            self.app.push_screen(
                Ask(say(ASK_UPGRADE), say(Text("save")), say(Text("go back"))),
                lambda yes: self._save(save, upgrade=True) if yes else None,
            )
        except SaveError as error:
            self.app.warned_of = self.session.home if isinstance(error, ChangedOnDisk) else None
            self.app.tell(error.text, "error")
        else:
            self._saved(path)

    def _saved(self, path: Path) -> None:
        self.app.warned_of = None
        self.app.tell(Text("Saved: {path}", path=str(path)))
        if self.session.message:
            self.app.tell(self.session.message, "warning")
            self.session.message = EMPTY
        self.show_state()

    def action_save_as(self) -> None:
        self.app.push_screen(SaveDialog(self.session), self._save_as)

    def _save_as(self, path: Path | None) -> None:
        if path is not None:
            self._save(partial(self.session.save_as, path))

    # --- opening
    def action_open(self) -> None:
        self.app.push_screen(OpenDialog(self.session.memory, folder_of(self.session), self.session.path), self._opened)

    async def _opened(self, session: Session | None) -> None:
        if session is not None:
            await self.app.enter(session)

    async def open_path(self, path: Path) -> None:
        """Open a design whose path is known."""
        try:
            session = Session.open(path, memory=self.session.memory, now=self.session.now)
        except BadInput as bad:
            self.app.tell(bad.errors[0].text(bad.place), "error")
            return
        await self._opened(session)

    def action_new(self) -> None:
        """The start page, at its engines."""
        self.app.begin(engines=True)

    def restore(self, kept: Edits | None = None) -> None:
        """Put back edits that were kept aside, by another session or for another version of the file: the last, or
        these."""
        if self.session.restore(kept):
            self.rebuilt()
        else:
            self.app.tell(Text("No unsaved edits are kept for this design."))

    def action_reload(self) -> None:
        """Take the file as it is now on the disk."""
        edited = self.session.dirty
        try:
            changed = self.session.reload()
        except BadInput as bad:
            text = Text("The file is not taken: {mistake}", mistake=bad.errors[0].text(self.session.name))
            if len(bad.errors) > 1:
                text = Text("{text} ({n} mistakes in all)", text=text, n=len(bad.errors))
            self.app.tell(text, "error")
            return
        if not changed:
            self.app.tell(Text("The design is as its file has it."))
            return
        self.app.warned_of = None
        self.rebuilt()
        self.app.tell(
            Text("{name} is read anew. Undo returns to your edits.", name=self.session.name)
            if edited
            else Text("{name} is read anew.", name=self.session.name)
        )

    # --- report and export
    def action_report(self) -> None:
        if self._can_write():
            self._write(folder_of(self.session) / (self.session.home.stem + ".pdf"), FileRow())

    def action_export(self) -> None:
        if not self._can_write():
            return
        data = self.session.data
        gears = "gears" in data and (self.step.key == "gears" or not asks(data, "countershaft"))
        draft = self.session.draft()
        offered = rows(draft.solved() if draft.results is not None else None)
        drawn = "gears" if gears else ""
        chosen = next(row for row in offered if row.kind is not None and row.option == drawn)
        dialog = ExportDialog(self.session, offered, chosen)

        def write(path: Path | None) -> None:
            if path is not None and self._can_write():
                self._write(path, dialog.chosen)

        self.app.push_screen(dialog, write)

    def _can_write(self) -> bool:
        """Whether there is something to write, and nothing being written; says what is in the way."""
        if self.app.writing:
            self.app.tell(Text("Still being written: {writing}. It goes on; wait for it.", writing=self.app.writing))
            return False
        if not self.session.valid:
            place, reason = next(iter(self.session.reasons().items()))
            self.app.tell(
                Text(
                    "No report, export or replay while the input is not valid: {map} {reason}",
                    map=named_key(self.session.data, place),
                    reason=reason,
                ),
                "error",
            )
            return False
        return True

    def _write(self, path: Path, row: FileRow) -> None:
        self.app.writing = Name(path.suffix.removeprefix(".").upper())
        self.refresh_top_line()
        work = partial(self._write_file, path, self.session.draft(), row, self.app.say.code)
        self.in_thread("write", work, exclusive=False)

    def _write_file(self, path: Path, draft: Draft, row: FileRow, lang: str) -> None:
        """Runs in another thread."""
        worker = get_current_worker()
        kind, shown = path.suffix.removeprefix(".").upper(), -1

        def progress(share: float, what: str) -> None:
            nonlocal shown
            if worker.is_cancelled or not self.is_attached:
                raise Cancelled
            if (percent := int(100 * share)) != shown:
                shown = percent
                self.call_later(self._show_progress, Name(f"{kind} {percent} %"))

        severity: SeverityLevel = "error"
        try:
            write_draft(path, draft, row, progress, lang)
            text, severity = (
                Text("PDF report: {path}", path=path) if kind == "PDF" else Text("Exported: {path}", path=path),
                "information",
            )
        except Cancelled:  # the program ends
            return
        except ImportError as error:
            text = Text(
                "{name} can not be written: {name2} is not installed.", name=path.name, name2=error.name or error
            )
        except BadInput as bad:
            text = Text(
                "{name} can not be written: {what}",
                name=path.name,
                what="; ".join(f"{e.key}: {e.reason}" for e in bad.errors),
            )
        except Exception as error:  # whatever goes wrong on paper, the session goes on
            text = Text(
                "{name} can not be written: {getattr}",
                name=path.name,
                getattr=getattr(error, "strerror", None) or error,
            )
        self.call_later(self._wrote, text, severity)

    def _show_progress(self, what: Text) -> None:
        self.app.writing = what
        self.refresh_top_line()

    def _wrote(self, text: Text, severity: SeverityLevel = "information", recording: Recording | None = None) -> None:
        """A file is written, or could not be: tell it.  `recording` ends with it, as it stands in a replay now."""
        self.app.writing = EMPTY
        self.app.tell(text, severity)
        if recording is not None and self.session.recording is recording:
            self.session.recording = None
        self.refresh_top_line()

    # --- recording
    def action_record(self) -> None:
        """Begin to record a replay; or end it, and ask where to write it."""
        if self.session.blank:
            self.app.tell(FIRST_VALID, "warning")
            return
        if self.session.recording is None:
            self.session.record()
            self.app.tell(
                Text(
                    "Every edit is recorded from here on; {key} once more ends it and writes a replay.",
                    key=self.app.shown_key("record"),
                )
            )
            self.refresh_top_line()
            return
        if not self._can_write():
            return
        self.app.push_screen(RecordDialog(self.session), self._recorded)

    def _recorded(self, path: Path | None) -> None:
        recording = self.session.recording
        if recording is None:
            self.app.tell(Text("The recording is given up."))
        elif path is not None:
            self.app.writing = Name("TOML")
            work = partial(self._write_replay, path, recording, self.session.draft(recording.end))
            self.in_thread("write", work, exclusive=False)
        self.refresh_top_line()

    def _write_replay(self, path: Path, recording: Recording, draft: Draft) -> None:
        """Runs in another thread."""
        try:
            _, results = draft.solved()
            write_atomic(path, recording.text(results).encode("utf-8"), backup=False, inputs=[draft.home])
        except Exception as error:  # the recording is not lost by it
            self.call_later(
                self._wrote,
                Text("{name} can not be written, the recording goes on: {error}", name=path.name, error=str(error)),
                "error",
            )
        else:
            self.call_later(self._wrote, Text("Replay: {path}", path=str(path)), "information", recording)
