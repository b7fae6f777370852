# SPDX-License-Identifier: Apache-2.0
"""Dialogs that ask where to write.  A file that is there is overwritten only after a second Enter."""

from pathlib import Path

from calc.sheet.text import EMPTY, Text

from ..session.saving import free_name
from ..session.session import Session
from .path_dialogs import PathDialog


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
            self.say(Text("This is a folder; give a file name in it."))
        elif not path.parent.is_dir():
            self.say(Text("The folder {folder} does not exist.", folder=str(path.parent)))
        elif wrong := self.wrong(path):
            self.say(wrong)
        elif path.exists() and path != self.own and path != self._asked:
            self._asked = path
            self.say(Text("{name} exists; Enter once more overwrites it.", name=path.name))
        else:
            self.dismiss(path)

    def wrong(self, path: Path) -> Text:
        """What else is wrong with a path."""
        return EMPTY


def folder_of(session: Session) -> Path:
    """Where the files of a design belong: beside it; those of the example into the current folder."""
    return session.path.parent if session.path is not None else Path.cwd()


class SaveDialog(TargetDialog):
    """Gives the path to save the design to."""

    TITLE_TEXT = Text("Save the design as")
    HINT = Text("Enter saves, Esc goes back. The file that was there before stays as .bak.")

    def __init__(self, session: Session) -> None:
        super().__init__(free_name(folder_of(session) / session.name), session.path)


class RecordDialog(TargetDialog):
    """Gives the path to write a replay to; an empty one gives the recording up."""

    TITLE_TEXT = Text("Write the recorded replay")
    HINT = Text("Enter writes it and ends the recording, Esc goes on recording; an empty path gives the recording up.")

    def __init__(self, session: Session) -> None:
        super().__init__(free_name(folder_of(session) / f"{session.home.stem}-replay.toml"))
        self.session = session

    def take(self, path: Path) -> None:
        if not self.text():
            self.session.recording = None
            self.dismiss(None)
        else:
            super().take(path)

    def wrong(self, path: Path) -> Text:
        return Text("This is the design itself; give another name.") if path == self.session.path else EMPTY


class ExportDialog(TargetDialog):
    """Gives the path to export to; its ending says what."""

    TITLE_TEXT = Text("Export")
    ENDINGS = (".dxf", ".csv", ".json", ".pdf")
    DRAWS_SHAFT = Text(
        "The ending decides: .dxf draws the shaft (in step 5 the gears), .csv has the values, .json all results, .pdf is the report."
    )
    DRAWS_GEARS = Text(
        "The ending decides: .dxf draws the gears (in step 3 the shaft), .csv has the values, .json all results, .pdf is the report."
    )

    def __init__(self, session: Session, gears: bool) -> None:
        self.HINT = self.DRAWS_GEARS if gears else self.DRAWS_SHAFT
        name = f"{session.home.stem}-gears.dxf" if gears else f"{session.home.stem}.dxf"
        super().__init__(folder_of(session) / name)

    def wrong(self, path: Path) -> Text:
        if path.suffix.lower() in self.ENDINGS:
            return EMPTY
        return Text(
            "The ending {ending} is not known: .dxf draws, .csv has the values, .json all results, .pdf is the report.", ending=path.suffix
        )
