# SPDX-License-Identifier: Apache-2.0
"""Dialogs that ask where to write.  A file that is there is overwritten only after a second Enter."""

from pathlib import Path

from ..saving import free_name
from ..session import Session
from .path_dialog import PathDialog


class TargetDialog(PathDialog[Path | None]):
    """Gives the path of a file to write.  `own`: a file that may be overwritten without asking."""

    def __init__(self, start: Path, own: Path | None = None) -> None:
        super().__init__(str(start), start.parent)
        self.own = own
        self._asked: Path | None = None

    def take(self, path: Path) -> None:
        if not path.suffix and not path.is_dir():
            path = path.with_suffix(self.ENDINGS[0])
        if path.is_dir():
            self.say("This is a folder; give a file name in it.")
        elif not path.parent.is_dir():
            self.say(f"The folder {path.parent} does not exist.")
        elif wrong := self.wrong(path):
            self.say(wrong)
        elif path.exists() and path != self.own and path != self._asked:
            self._asked = path
            self.say(f"{path.name} exists; Enter once more overwrites it.")
        else:
            self.dismiss(path)

    def wrong(self, path: Path) -> str:
        """What else is wrong with a path."""
        return ""


def folder_of(session: Session) -> Path:
    """Where the files of a design belong: beside it; those of the example into the current folder."""
    return session.path.parent if session.path is not None else Path.cwd()


class SaveDialog(TargetDialog):
    """Gives the path to save the design to."""

    TITLE_TEXT = "Save the design as"
    HINT = "Enter saves, Esc goes back. The file that was there before stays as .bak."

    def __init__(self, session: Session) -> None:
        super().__init__(free_name(folder_of(session) / session.name), session.path)


class RecordDialog(TargetDialog):
    """Gives the path to write a replay to; an empty one gives the recording up."""

    TITLE_TEXT = "Write the recorded replay"
    HINT = "Enter writes it and ends the recording, Esc goes on recording; an empty path gives the recording up."

    def __init__(self, session: Session) -> None:
        super().__init__(free_name(folder_of(session) / f"{session.home.stem}-replay.toml"))
        self.session = session

    def take(self, path: Path) -> None:
        if not self.text():
            self.session.recording = None
            self.dismiss(None)
        else:
            super().take(path)

    def wrong(self, path: Path) -> str:
        return "This is the design itself; give another name." if path == self.session.path else ""


class ExportDialog(TargetDialog):
    """Gives the path to export to; its ending says what."""

    TITLE_TEXT = "Export"
    ENDINGS = (".dxf", ".csv", ".json", ".pdf")
    DRAWS_SHAFT = (
        "The ending decides: .dxf draws the shaft (in step 5 the gears), .csv has the values, .json all results, .pdf is the report."
    )
    DRAWS_GEARS = (
        "The ending decides: .dxf draws the gears (in step 3 the shaft), .csv has the values, .json all results, .pdf is the report."
    )

    def __init__(self, session: Session, gears: bool) -> None:
        self.HINT = self.DRAWS_GEARS if gears else self.DRAWS_SHAFT
        name = f"{session.home.stem}-gears.dxf" if gears else f"{session.home.stem}.dxf"
        super().__init__(folder_of(session) / name)

    def wrong(self, path: Path) -> str:
        if path.suffix.lower() in self.ENDINGS:
            return ""
        return f"The ending {path.suffix} is not known: .dxf draws, .csv has the values, .json all results, .pdf is the report."
