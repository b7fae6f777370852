# SPDX-License-Identifier: Apache-2.0
"""Open another design.  A file that is none stays in the dialog, with the reason."""

from pathlib import Path

from calc.sheet.errors import BadInput

from ..session import Session
from .path_dialog import PathDialog


class OpenDialog(PathDialog[Session | None]):
    """Gives the session of the design that was opened."""

    TITLE_TEXT = "Open a design"
    HINT = "Enter opens, ↓ goes to the list, Esc goes back. Unsaved edits of this design are kept."

    def __init__(self, session: Session) -> None:
        super().__init__("", session.path.parent if session.path is not None else Path.cwd())
        self.session = session

    def on_mount(self) -> None:
        self.start = str(self.folder) + "/"
        super().on_mount()
        box = self.query_one("#path")
        box.value = self.start  # type: ignore[attr-defined]
        box.cursor_position = len(self.start)  # type: ignore[attr-defined]
        self.fill()

    def take(self, path: Path) -> None:
        if path.is_dir():
            self.fill()
            self.say("This is a folder; give the name of a design file in it.")
            return
        try:
            session = Session.open(path, memory=self.session.memory, now=self.session.now)
        except BadInput as bad:
            more = f"\n… and {len(bad.errors) - 4} more" if len(bad.errors) > 4 else ""
            self.say("\n".join(error.text(path.name) for error in bad.errors[:4]) + more)
            return
        self.dismiss(session)
