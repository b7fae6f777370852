# SPDX-License-Identifier: Apache-2.0
"""Asks what the file of a design that is begun is to be called."""

from pathlib import Path

from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from ..session.beginnings import engine_only, own_file
from ..session.session import Session
from .save_dialog import TargetDialog


class NewDialog(TargetDialog):
    """Gives the path of a file that is not there yet."""

    HINT = Text("Enter begins, Esc goes back. Nothing is written before you save; what you do is kept all the same.")

    def __init__(self, id: str, engine: str) -> None:
        self.TITLE_TEXT = Text("A design with the engine {engine}: its name", engine=engine)
        super().__init__(own_file(id, Path.cwd()))

    def wrong(self, path: Path) -> Text:
        return Text("{name} is there already: open it, or give another name.", name=path.name) if path.exists() else EMPTY


def begin_with(app: BaseApp, id: str, engine: str, path: Path | None = None) -> None:
    """Begin a design with a shipped engine; asks for its name where none is known yet."""

    def begin(path: Path | None) -> None:
        if path is not None:
            app.call_later(app.enter, Session.begin(engine_only(id, path), path.absolute(), memory=app.memory))

    if path is not None:
        begin(path)
    else:
        app.push_screen(NewDialog(id, engine), begin)
