# SPDX-License-Identifier: Apache-2.0
"""Open another design.  A file that is none stays in the dialog, with the reason."""

from pathlib import Path

from calc.sheet.errors import BadInput
from calc.sheet.text import Text
from calc.studies.shipped import DESIGNS

from ..session.recovery import Memory
from ..session.session import Session
from .compare_with import errors_text
from .path_dialogs import PathDialog


class OpenDialog(PathDialog[Session | None]):
    """Gives the session of the design that was opened."""

    TITLE_TEXT = Text("Open a design")
    HINT = Text("Enter opens, ↓ goes to the list, Esc goes back. Unsaved edits of this design are kept.")

    def __init__(self, memory: Memory, folder: Path, here: Path | None = None) -> None:
        super().__init__(f"{str(folder).rstrip('/')}/", folder)
        self.memory, self.here = memory, here  # the design that is open

    def offered(self) -> list[tuple[Text, list[Path]]]:
        recent = [path for path in self.memory.recent() if path != self.here]
        return [(Text("Opened last"), recent), (Text("Examples"), sorted(DESIGNS.glob("*.toml")))]

    def take(self, path: Path) -> None:
        if path.is_dir():
            self.fill()
            self.say(Text("This is a folder; give the name of a design file in it."))
            return
        try:
            session = Session.open(path, memory=self.memory)
        except BadInput as bad:
            self.say(errors_text(bad, path.name))
            return
        self.dismiss(session)
