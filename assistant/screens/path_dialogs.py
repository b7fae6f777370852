# SPDX-License-Identifier: Apache-2.0
"""A dialog that asks for a path: a place to type, the designs of the folder, and a line that says what is wrong."""

from pathlib import Path
from typing import ClassVar, TypeVar

from rich.cells import cell_len
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from .once import Once

Found = TypeVar("Found")
MOST = 200  # names in the list
NO_PATH = (OSError, ValueError, RuntimeError)  # too long, with a sign that no name may have, of a user that there is not
WIDEST, SHARE, FRAME = 110, 0.9, 9  # columns of a dialog, its share of the screen, and what frame and scroll bar take of it


class PathDialog(Once, ModalScreen[Found]):
    """Subclasses say what becomes of the path that was given."""

    app: BaseApp
    TITLE_TEXT = EMPTY
    HINT = EMPTY
    ENDINGS: tuple[str, ...] = (".toml",)  # of the files that are listed
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Cancel", show=False),
        Binding("down", "list(1)", "To the list", show=False),
        Binding("up", "list(-1)", "Back from the list", show=False),
    ]

    def __init__(self, start: str, folder: Path) -> None:
        super().__init__()
        self.start = start
        self.folder = folder
        self._names: list[str] = []

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(Content.styled(self.app.say(self.TITLE_TEXT), "bold"))
            yield Input(self.start, compact=True, select_on_focus=False, id="path")
            yield OptionList(id="names", compact=True)
            yield Static("", id="wrong", classes="wrong")
            yield Static(Content.styled(self.app.say(self.HINT), "dim"))

    def on_mount(self) -> None:
        self.query_one("#path", Input).cursor_position = len(self.start)
        self.fill()

    def text(self) -> str:
        return self.query_one("#path", Input).value.strip()

    def path(self) -> Path:
        path = Path(self.text()).expanduser()
        return path if path.is_absolute() else self.folder / path

    def offered(self) -> list[tuple[Text, list[Path]]]:
        """Files from elsewhere, under their headings, that are listed as long as the path is untouched."""
        return []

    def fill(self) -> None:
        """What is offered, and the folders and files beside what is typed."""
        text = self.text()
        rows: list[tuple[str, str]] = []  # what is shown, and the path that it stands for; none for a heading
        for heading, paths in self.offered() if text == self.start else ():
            rows += [(self.app.say(heading), ""), *((self.cut(str(one)), str(one)) for one in paths)] if paths else []
        folder, names = self.folder, []
        try:
            path = self.path()
            folder, begin = (path, "") if not text or text.endswith(("/", "\\")) else (path.parent, path.name.lower())
            for item in sorted(folder.iterdir(), key=lambda p: (p.is_dir(), p.name.lower())):
                if item.name.startswith(".") or not item.name.lower().startswith(begin):
                    continue
                if item.suffix.lower() in self.ENDINGS or item.is_dir():
                    names.append(item.name + ("/" if item.is_dir() else ""))
        except NO_PATH:
            pass
        if rows and names:
            rows.append((self.cut(str(folder)), ""))
        rows += [(name, str(folder / name) + ("/" if name.endswith("/") else "")) for name in names[:MOST]]
        self._names = [path for _, path in rows]
        options = self.query_one("#names", OptionList)
        options.clear_options()
        options.add_options([Option(Content.styled(shown, "" if path else "bold"), disabled=not path) for shown, path in rows])
        options.display = bool(rows)

    def cut(self, path: str) -> str:
        """A path that is too long for the list, without its middle: where it begins and what it is called stay."""
        room = max(20, min(WIDEST, int(SHARE * self.app.size.width)) - FRAME)
        if cell_len(path) <= room:
            return path
        more = self.app.signs.mark("more")
        end = (room - len(more)) * 2 // 3
        return path[: room - len(more) - end] + more + path[-end:]

    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        self.say(EMPTY)
        self.fill()

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        try:
            path = self.path()
            path.resolve()
            self.take(path)
        except NO_PATH as error:
            self.say(Text("No file can have this name: {reason}.", reason=getattr(error, "strerror", None) or str(error)))

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        name = self._names[event.option_index]
        box = self.query_one("#path", Input)
        box.value = name
        box.cursor_position = len(name)
        box.focus()
        if not name.endswith("/"):
            self.take(Path(name))

    def take(self, path: Path) -> None:
        """What becomes of the path.  May raise what a path that can not be one raises."""
        raise NotImplementedError

    def say(self, text: Text) -> None:
        """What is wrong with the path."""
        self.query_one("#wrong", Static).update(Content(self.app.say(text)))

    def action_list(self, by: int) -> None:
        if not self.is_mounted:  # a key that came before there is a list
            return
        options = self.query_one("#names", OptionList)
        if by > 0 and options.display and self.focused is not options:
            options.focus()
            options.action_first()

    def action_cancel(self) -> None:
        self.dismiss(None)
