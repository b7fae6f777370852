# SPDX-License-Identifier: Apache-2.0
"""Save under another name.  A file that is there is overwritten only after a second Enter."""

from pathlib import Path

from ..saving import free_name
from ..session import Session
from .path_dialog import PathDialog


class SaveDialog(PathDialog[Path | None]):
    """Gives the path to save to."""

    TITLE_TEXT = "Save the design as"
    HINT = "Enter saves, Esc goes back. The file that was there before stays as .bak."

    def __init__(self, session: Session) -> None:
        folder = session.path.parent if session.path is not None else Path.cwd()
        super().__init__(str(free_name(folder / session.name)), folder)
        self.session = session
        self._asked: Path | None = None

    def take(self, path: Path) -> None:
        if not path.suffix and not path.is_dir():
            path = path.with_suffix(".toml")
        if path.is_dir():
            self.say("This is a folder; give a file name in it.")
        elif not path.parent.is_dir():
            self.say(f"The folder {path.parent} does not exist.")
        elif path.exists() and path != self.session.path and path != self._asked:
            self._asked = path
            self.say(f"{path.name} exists; Enter once more overwrites it.")
        else:
            self.dismiss(path)
