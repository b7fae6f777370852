# SPDX-License-Identifier: Apache-2.0
"""What the keys do with files, one method for each action of the table."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from textual import work
from textual.message import Message
from textual.worker import get_current_worker

from calc.sheet.errors import BadInput, Cancelled

from ..draft import Draft
from ..recording import Recording
from ..saving import ChangedOnDisk, SaveError, write_atomic
from ..session import Session
from ..widgets.top_line import TopLine
from .part import Part


class DoingFiles(Part):
    """The actions that read and write files.  A part of `Doing`."""

    @dataclass
    class Writing(Message):
        """How far a file is that is being written in another thread."""

        what: str

    @dataclass
    class Wrote(Message):
        """It is done, or could not be: what to say about it."""

        text: str
        severity: Any = "information"
        recording: Recording | None = field(default=None, repr=False)  # what ends by it: it stands in a replay now

    def _show_top(self) -> None:
        for line in self._me.query(TopLine):  # none while another design is being entered
            line.refresh()

    # --- saving
    def action_save(self) -> None:
        me = self._me
        if self.session.read_only:
            me.app.tell(f"{self.session.name} is read-only; give another name.", "warning")
            self.action_save_as()
            return
        try:
            path = self.session.save(force=me.app.warned_of == self.session.home)
        except SaveError as error:
            me.app.warned_of = self.session.home if isinstance(error, ChangedOnDisk) else None
            me.app.tell(str(error), "error")
            return
        self._saved(path)

    def _saved(self, path: Path) -> None:
        me = self._me
        me.app.warned_of = None
        me.app.tell(f"Saved: {path}")
        if self.session.message:
            me.app.tell(self.session.message, "warning")
            self.session.message = ""
        me.show_state()

    def action_save_as(self) -> None:
        from .save_dialog import SaveDialog

        self._me.app.push_screen(SaveDialog(self.session), self._save_as)

    def _save_as(self, path: Path | None) -> None:
        if path is None:
            return
        try:
            self._saved(self.session.save_as(path))
        except SaveError as error:
            self._me.app.tell(str(error), "error")

    # --- opening
    def action_open(self) -> None:
        from .open_dialog import OpenDialog

        self._me.app.push_screen(OpenDialog(self.session), self._opened)

    async def _opened(self, session: Session | None) -> None:
        if session is not None:
            await self._me.app.enter(session)

    async def open_path(self, path: Path) -> None:
        """Open a design whose path is known."""
        try:
            session = Session.open(path, memory=self.session.memory, now=self.session.now)
        except BadInput as bad:
            self._me.app.tell(bad.errors[0].text(bad.place), "error")
            return
        await self._opened(session)

    def action_restore(self) -> None:
        """Put back edits that were kept aside for another version of the file."""
        me = self._me
        if self.session.restore():
            me.edited()
        else:
            me.app.tell("No unsaved edits are kept for this design.")

    def action_reload(self) -> None:
        """Take the file as it is now on the disk."""
        me = self._me
        edited = self.session.dirty
        try:
            changed = self.session.reload()
        except BadInput as bad:
            more = f" ({len(bad.errors)} mistakes in all)" if len(bad.errors) > 1 else ""
            me.app.tell(f"The file is not taken: {bad.errors[0].text(self.session.name)}{more}", "error")
            return
        if not changed:
            me.app.tell("The design is as its file has it.")
            return
        me.app.warned_of = None
        self.rebuilt()
        me.app.tell(f"{self.session.name} is read anew. Undo returns to your edits." if edited else f"{self.session.name} is read anew.")

    # --- report and export
    def action_report(self) -> None:
        from .save_dialog import folder_of

        if self._can_write():
            self._write(folder_of(self.session) / (self.session.home.stem + ".pdf"))

    def action_export(self) -> None:
        from .save_dialog import ExportDialog

        me = self._me
        if not self._can_write():
            return
        data = self.session.data
        gears = "gears" in data and (me.step.key == "gears" or "countershaft" not in data)

        def write(path: Path | None) -> None:
            if path is not None and self._can_write():
                self._write(path, gears)

        me.app.push_screen(ExportDialog(self.session, gears), write)

    def _can_write(self) -> bool:
        """Whether there is something to write, and nothing being written; says what is in the way."""
        me = self._me
        if me.app.writing:
            me.app.tell(f"Still being written: {me.app.writing}. It goes on; wait for it.")
            return False
        if not self.session.valid:
            place, reason = next(iter(self.session.reasons().items()))
            me.app.tell(f"No report, export or replay while the input is not valid: {'.'.join(map(str, place))} {reason}", "error")
            return False
        return True

    def _write(self, path: Path, gears: bool = False) -> None:
        me = self._me
        me.app.writing = path.suffix.removeprefix(".").upper()
        self._show_top()
        self._write_aside(path, self.session.draft(), gears)

    @work(thread=True, group="write", exit_on_error=False, description="write")
    def _write_aside(self, path: Path, draft: Draft, gears: bool) -> None:
        me, worker = self._me, get_current_worker()
        lang = me.app.say.code
        name, shown = path.suffix.removeprefix(".").upper(), -1

        def progress(share: float, what: str) -> None:
            nonlocal shown
            if worker.is_cancelled or not me.is_attached:
                raise Cancelled
            if (percent := int(100 * share)) != shown:
                shown = percent
                me.post_message(self.Writing(f"{name} {percent} %"))

        try:
            from ..exporting import write_draft

            write_draft(path, draft, gears, progress, lang)
            answer = self.Wrote(f"PDF report: {path}" if name == "PDF" else f"Exported: {path}")
        except Cancelled:  # the program ends
            return
        except ImportError as error:
            answer = self.Wrote(f"{path.name} can not be written: {error.name or error} is not installed.", "error")
        except BadInput as bad:
            answer = self.Wrote(f"{path.name} can not be written: {'; '.join(f'{e.key}: {e.reason}' for e in bad.errors)}", "error")
        except Exception as error:  # whatever goes wrong on paper, the session goes on
            answer = self.Wrote(f"{path.name} can not be written: {getattr(error, 'strerror', None) or error}", "error")
        me.post_message(answer)

    def on_doing_files_writing(self, event: Writing) -> None:
        event.stop()
        self._me.app.writing = event.what
        self._show_top()

    def on_doing_files_wrote(self, event: Wrote) -> None:
        event.stop()
        me = self._me
        me.app.writing = ""
        me.app.tell(event.text, event.severity)
        if event.recording is not None and self.session.recording is event.recording:
            self.session.recording = None
        self._show_top()

    # --- recording
    def action_record(self) -> None:
        """Begin to record a replay; or end it, and ask where to write it."""
        me = self._me
        if self.session.recording is None:
            self.session.record()
            me.app.tell(f"Every edit is recorded from here on; {me.app.shown_key('record')} once more ends it and writes a replay.")
            self._show_top()
            return
        if not self._can_write():
            return
        from .save_dialog import RecordDialog

        me.app.push_screen(RecordDialog(self.session), self._recorded)

    def _recorded(self, path: Path | None) -> None:
        me, recording = self._me, self.session.recording
        if recording is None:
            me.app.tell("The recording is given up.")
        elif path is not None:
            me.app.writing = "TOML"
            self._write_replay(path, recording, self.session.draft(recording.end))
        self._show_top()

    @work(thread=True, group="write", exit_on_error=False, description="write")
    def _write_replay(self, path: Path, recording: Recording, draft: Draft) -> None:
        try:
            _, results = draft.solved()
            write_atomic(path, recording.text(results).encode("utf-8"))
            answer = self.Wrote(f"Replay: {path}", recording=recording)
        except Exception as error:  # the recording is not lost by it
            answer = self.Wrote(f"{path.name} can not be written, the recording goes on: {error}", "error")
        self._me.post_message(answer)
