# SPDX-License-Identifier: Apache-2.0
"""Actions that read and write files."""

from functools import partial
from pathlib import Path

from textual.notifications import SeverityLevel
from textual.worker import get_current_worker

from calc.sheet.errors import BadInput, Cancelled
from calc.sheet.text import EMPTY, Name, Text

from ..session.recording import Recording
from ..session.recovery import Edits
from ..session.saving import ChangedOnDisk, Draft, SaveError, write_atomic
from ..session.session import Session
from .edit_actions import rebuilt
from .host import Host


class FileActions:
    def __init__(self, host: Host) -> None:
        self._host = host

    @property
    def _session(self) -> Session:
        return self._host.session

    # --- saving
    def save(self) -> None:
        host = self._host
        if self._session.read_only:
            host.app.tell(Text("{name} is read-only; give another name.", name=self._session.name), "warning")
            self.save_as()
            return
        try:
            path = self._session.save(force=host.app.warned_of == self._session.home)
        except SaveError as error:
            host.app.warned_of = self._session.home if isinstance(error, ChangedOnDisk) else None
            host.app.tell(error.text, "error")
            return
        self._saved(path)

    def _saved(self, path: Path) -> None:
        host = self._host
        host.app.warned_of = None
        host.app.tell(Text("Saved: {path}", path=str(path)))
        if self._session.message:
            host.app.tell(self._session.message, "warning")
            self._session.message = EMPTY
        host.show_state()

    def save_as(self) -> None:
        from .path_dialogs import SaveDialog

        self._host.app.push_screen(SaveDialog(self._session), self._save_as)

    def _save_as(self, path: Path | None) -> None:
        if path is None:
            return
        try:
            self._saved(self._session.save_as(path))
        except SaveError as error:
            self._host.app.tell(error.text, "error")

    # --- opening
    def open(self) -> None:
        from .path_dialogs import OpenDialog, folder_of

        self._host.app.push_screen(
            OpenDialog(self._session.memory, folder_of(self._session), self._session.path), self._opened
        )

    async def _opened(self, session: Session | None) -> None:
        if session is not None:
            await self._host.app.enter(session)

    async def open_path(self, path: Path) -> None:
        """Open a design whose path is known."""
        try:
            session = Session.open(path, memory=self._session.memory, now=self._session.now)
        except BadInput as bad:
            self._host.app.tell(bad.errors[0].text(bad.place), "error")
            return
        await self._opened(session)

    def new(self) -> None:
        """The start page, at its engines."""
        self._host.app.begin(engines=True)

    def restore(self, kept: Edits | None = None) -> None:
        """Put back edits that were kept aside, by another session or for another version of the file: the last, or
        these."""
        host = self._host
        if self._session.restore(kept):
            rebuilt(host)
        else:
            host.app.tell(Text("No unsaved edits are kept for this design."))

    def reload(self) -> None:
        """Take the file as it is now on the disk."""
        host = self._host
        edited = self._session.dirty
        try:
            changed = self._session.reload()
        except BadInput as bad:
            text = Text("The file is not taken: {mistake}", mistake=bad.errors[0].text(self._session.name))
            if len(bad.errors) > 1:
                text = Text("{text} ({n} mistakes in all)", text=text, n=len(bad.errors))
            host.app.tell(text, "error")
            return
        if not changed:
            host.app.tell(Text("The design is as its file has it."))
            return
        host.app.warned_of = None
        rebuilt(host)
        host.app.tell(
            Text("{name} is read anew. Undo returns to your edits.", name=self._session.name)
            if edited
            else Text("{name} is read anew.", name=self._session.name)
        )

    # --- report and export
    def report(self) -> None:
        from .path_dialogs import folder_of

        if self._can_write():
            self._write(folder_of(self._session) / (self._session.home.stem + ".pdf"))

    def export(self) -> None:
        from .path_dialogs import ExportDialog

        host = self._host
        if not self._can_write():
            return
        data = self._session.data
        gears = "gears" in data and (host.step.key == "gears" or "countershaft" not in data)

        def write(path: Path | None) -> None:
            if path is not None and self._can_write():
                self._write(path, gears)

        host.app.push_screen(ExportDialog(self._session, gears), write)

    def _can_write(self) -> bool:
        """Whether there is something to write, and nothing being written; says what is in the way."""
        host = self._host
        if host.app.writing:
            host.app.tell(Text("Still being written: {writing}. It goes on; wait for it.", writing=host.app.writing))
            return False
        if not self._session.valid:
            place, reason = next(iter(self._session.reasons().items()))
            host.app.tell(
                Text(
                    "No report, export or replay while the input is not valid: {map} {reason}",
                    map=".".join(map(str, place)),
                    reason=reason,
                ),
                "error",
            )
            return False
        return True

    def _write(self, path: Path, gears: bool = False) -> None:
        host = self._host
        host.app.writing = Name(path.suffix.removeprefix(".").upper())
        self._host.refresh_top_line()
        work = partial(self._write_file, path, self._session.draft(), gears, host.app.say.code)
        host.in_thread("write", work, exclusive=False)

    def _write_file(self, path: Path, draft: Draft, gears: bool, lang: str) -> None:
        """Runs in another thread."""
        host, worker = self._host, get_current_worker()
        kind, shown = path.suffix.removeprefix(".").upper(), -1

        def progress(share: float, what: str) -> None:
            nonlocal shown
            if worker.is_cancelled or not host.is_attached:
                raise Cancelled
            if (percent := int(100 * share)) != shown:
                shown = percent
                host.call_later(self._show_progress, Name(f"{kind} {percent} %"))

        severity: SeverityLevel = "error"
        try:
            from ..session.exporting import write_draft

            write_draft(path, draft, gears, progress, lang)
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
        host.call_later(self._wrote, text, severity)

    def _show_progress(self, what: Text) -> None:
        self._host.app.writing = what
        self._host.refresh_top_line()

    def _wrote(self, text: Text, severity: SeverityLevel = "information", recording: Recording | None = None) -> None:
        """A file is written, or could not be: tell it.  `recording` ends with it, as it stands in a replay now."""
        host = self._host
        host.app.writing = EMPTY
        host.app.tell(text, severity)
        if recording is not None and self._session.recording is recording:
            self._session.recording = None
        host.refresh_top_line()

    # --- recording
    def record(self) -> None:
        """Begin to record a replay; or end it, and ask where to write it."""
        host = self._host
        if self._session.recording is None:
            self._session.record()
            host.app.tell(
                Text(
                    "Every edit is recorded from here on; {key} once more ends it and writes a replay.",
                    key=host.app.shown_key("record"),
                )
            )
            self._host.refresh_top_line()
            return
        if not self._can_write():
            return
        from .path_dialogs import RecordDialog

        host.app.push_screen(RecordDialog(self._session), self._recorded)

    def _recorded(self, path: Path | None) -> None:
        host, recording = self._host, self._session.recording
        if recording is None:
            host.app.tell(Text("The recording is given up."))
        elif path is not None:
            host.app.writing = Name("TOML")
            work = partial(self._write_replay, path, recording, self._session.draft(recording.end))
            host.in_thread("write", work, exclusive=False)
        self._host.refresh_top_line()

    def _write_replay(self, path: Path, recording: Recording, draft: Draft) -> None:
        """Runs in another thread."""
        host = self._host
        try:
            _, results = draft.solved()
            write_atomic(path, recording.text(results).encode("utf-8"), inputs=[draft.home])
        except Exception as error:  # the recording is not lost by it
            host.call_later(
                self._wrote,
                Text("{name} can not be written, the recording goes on: {error}", name=path.name, error=str(error)),
                "error",
            )
        else:
            host.call_later(self._wrote, Text("Replay: {path}", path=str(path)), "information", recording)
