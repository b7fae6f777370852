# SPDX-License-Identifier: Apache-2.0
"""What the keys do with files, one method for each action of the table."""

from pathlib import Path

from textual import work

from ..saving import SaveError
from ..solving import run
from .part import Part


class DoingFiles(Part):
    """The actions that read and write files.  A part of `Doing`."""

    # --- files
    def action_save(self) -> None:
        me = self._me
        if self.session.read_only:
            me.app.tell(f"{self.session.name} is read-only; give another name.", "warning")
            self.action_save_as()
            return
        try:
            path = self.session.save(force=me.app.warned_of == self.session.home)
        except SaveError as error:
            from ..saving import ChangedOnDisk

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

    @work
    async def action_save_as(self) -> None:
        from .save_dialog import SaveDialog

        me = self._me
        path = await me.app.push_screen_wait(SaveDialog(self.session))
        if path is None:
            return
        try:
            self._saved(self.session.save_as(path))
        except SaveError as error:
            me.app.tell(str(error), "error")

    @work
    async def action_open(self) -> None:
        from .open_dialog import OpenDialog

        me = self._me
        session = await me.app.push_screen_wait(OpenDialog(self.session))
        if session is not None:
            await me.app.enter(session)

    def action_restore(self) -> None:
        """Put back edits that were kept aside for another version of the file."""
        me = self._me
        if self.session.restore():
            me.edited()
        else:
            me.app.tell("No unsaved edits are kept for this design.")

    # --- report
    def action_report(self) -> None:
        me = self._me
        if not self.session.valid:
            place, reason = next(iter(self.session.reasons().items()))
            me.app.tell(f"No report while the input is not valid: {'.'.join(map(str, place))} {reason}", "error")
            return
        me.app.tell("Writing the report …")
        self._report()

    @work(thread=True, exclusive=True, group="report", exit_on_error=False)
    def _report(self) -> None:
        me = self._me
        session = self.session
        try:
            from calc.design_file import design, parse

            raw = session.bytes()
            folder = session.path.parent if session.path is not None else Path.cwd()
            path = folder / (session.home.stem + ".pdf")
            document = parse(raw, str(session.home))
            results = session.results
            if not session.current or results is None:
                from ..solving import Job

                answer = run(Job(0, design(document), results))
                results = answer.results
                if results is None:
                    raise RuntimeError(answer.failure)
            from reports.report import write

            write(document, results, raw, path, depth="engineer")
        except ImportError as error:
            me.app.call_from_thread(me.app.tell, f"The report can not be written: {error.name or error} is not installed.", "error")
        except Exception as error:  # whatever goes wrong on paper, the session goes on
            reason = getattr(error, "strerror", None) or error
            me.app.call_from_thread(me.app.tell, f"The report can not be written: {reason}", "error")
        else:
            me.app.call_from_thread(me.app.tell, f"PDF report: {path}")
