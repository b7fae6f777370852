# SPDX-License-Identifier: Apache-2.0
"""The dialogs that ask for a path: to compare with, to save, to export, to open, to begin a design.

Where a path is typed, the designs of the folder stand below, and a line says what is wrong."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar, TypeVar

from rich.cells import cell_len
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.input import Selection
from textual.widgets.option_list import Option

from calc.sheet.errors import BadInput
from calc.sheet.text import EMPTY, Name, Text
from calc.studies.shipped import designs, shipped_name

from ..actions import bound
from ..base_app import BaseApp
from ..exports.offered import FileRow
from ..session.beginnings import Beginning, blank, engine_only, own_file
from ..session.compare_with import Chosen, Other, kept, of_file, of_session, past
from ..session.recovery import Memory
from ..session.saving import free_name
from ..session.session import Session
from ..widgets.line import Line
from .dialogs import Once

Found = TypeVar("Found")
MOST = 200  # names in the list
# too long, with a sign that no name may have, of a user that there is not
NO_PATH = (OSError, ValueError, RuntimeError)
# columns of a dialog, its share of the screen, and what frame and scroll bar take of it
WIDEST, SHARE, FRAME = (110, 0.9, 9)


class PathDialog(Once, ModalScreen[Found]):
    """Subclasses say what becomes of the path that was given."""

    app: BaseApp
    TITLE_TEXT = EMPTY
    HINT = EMPTY
    ENDINGS: tuple[str, ...] = (".toml",)  # of the files that are listed
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("leave", "cancel"),
        bound("save", "app.save"),
        Binding("down", "list(1)", "To the list", show=False, priority=True),
        Binding("up", "list(-1)", "Back from the list", show=False, priority=True),
    ]

    def __init__(self, start: str, folder: Path) -> None:
        super().__init__()
        self.start = start
        self.folder = folder
        self._names: list[str] = []

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(Content.styled(self.app.say(self.TITLE_TEXT), "bold"))
            if not self.start.startswith(str(self.folder)):
                yield Static(Content.styled(self.cut(str(self.folder)), "dim"), id="folder")
            yield Line(self.start, compact=True, select_on_focus=False, id="path")
            yield OptionList(id="names", compact=True)
            yield Static("", id="wrong", classes="wrong")
            yield Static(Content.styled(self.app.say(self.HINT), "dim"))

    def on_mount(self) -> None:
        self.query_one("#path", Input).selection = self.selected()
        self.fill()

    def selected(self) -> Selection:
        """What the first key replaces."""
        return Selection.cursor(len(self.start))

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
            rows += (
                [(self.app.say(heading), ""), *((self.cut(str(choice)), str(choice)) for choice in paths)]
                if paths
                else []
            )
        folder, names = self.folder, []
        try:
            path = self.path()
            folder, begin = (path, "") if not text or text.endswith(("/", "\\")) else (path.parent, path.name.lower())
            for ending in self.ENDINGS:
                begin = begin.removesuffix(ending)
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
        options.add_options(
            [Option(Content.styled(shown, "" if path else "bold"), disabled=not path) for shown, path in rows]
        )
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
            self.say(
                Text("No file can have this name: {reason}.", reason=getattr(error, "strerror", None) or str(error))
            )

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Of this class alone: the toolkit calls the handlers of all classes of a dialog, and not the last one."""
        event.stop()
        self.pick(event.option_index)

    def pick(self, row: int) -> None:
        """A row of the list was chosen."""
        name = self._names[row]
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
        if self.focused is options and by < 0 and options.highlighted in (0, None):
            self.set_focus(self.query_one("#path", Input))
        elif self.focused is options:
            options.action_cursor_down() if by > 0 else options.action_cursor_up()
        elif by > 0 and options.display:
            self.set_focus(options)  # before the next key
            options.action_first()

    def action_cancel(self) -> None:
        self.dismiss(None)


# --- what to compare the design with
# Its saved file, an earlier state, or another design.

SHOWN_ERRORS = 4


class CompareWith(Once, ModalScreen[Chosen | None]):
    """Gives the design that was chosen, solved by nobody yet."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("leave", "cancel"),
        bound("save", "app.save"),
        bound("close", "cancel"),
        bound("down", "move(1)"),
        bound("up", "move(-1)"),
    ]

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self.others: list[Other | None] = []  # None: another file

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        self.others = [*kept(self.session), None, *past(self.session)]
        say = self.app.say
        texts = [say(other.title if other is not None else Text("another design file …")) for other in self.others]
        with Vertical(classes="dialog"):
            yield Static(Content.styled(say(Text("Compare the design, as it is now, with")), "bold"))
            yield OptionList(*[Option(Content(text)) for text in texts], id="others", compact=True)
            yield Static("", id="wrong", classes="wrong")
            yield Static(Content.styled(say(Text("Enter compares, Esc goes back")), "dim"))

    def on_mount(self) -> None:
        options = self.query_one(OptionList)
        options.highlighted = 0
        options.focus()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        other = self.others[event.option_index]
        if other is None:
            self.app.push_screen(CompareFile(self.session), self._found)
            return
        try:
            self.dismiss(of_session(self.session, other))
        except BadInput as bad:
            self.query_one("#wrong", Static).update(
                Content(
                    self.app.say(
                        Text("This state was not valid:\n{errors}", errors=errors_text(bad, Text("the design")))
                    )
                )
            )

    def _found(self, chosen: Chosen | None) -> None:
        if chosen is not None:
            self.dismiss(chosen)

    def action_move(self, by: int) -> None:
        options = self.query_one(OptionList)
        if by > 0:
            options.action_cursor_down()
        else:
            options.action_cursor_up()

    def action_cancel(self) -> None:
        self.dismiss(None)


class CompareFile(PathDialog[Chosen | None]):
    """Another design file: those of the folder, then those that come with the program."""

    TITLE_TEXT = Text("Compare with another design")
    HINT = Text("Enter compares, ↓ goes to the list, Esc goes back")

    def __init__(self, session: Session) -> None:
        folder = session.path.parent if session.path is not None else Path.cwd()
        super().__init__(f"{folder}/", folder)

    def fill(self) -> None:
        """What is beside the path that is typed; and always the shipped designs."""
        super().fill()
        shipped = [path for path in designs() if str(path) not in self._names]
        self._names += [str(path) for path in shipped]
        options = self.query_one("#names", OptionList)
        options.add_options(
            [
                Option(Content(self.app.say(Text("{name}   (comes with the program)", name=f"{name}.toml"))))
                for name in map(shipped_name, shipped)
            ]
        )
        options.display = bool(self._names)

    def take(self, path: Path) -> None:
        if path.is_dir():
            self.fill()
            self.say(Text("This is a folder; give the name of a design file in it."))
            return
        try:
            chosen = of_file(path)
        except BadInput as bad:
            self.say(errors_text(bad, path.name))
            return
        self.dismiss(chosen)


def errors_text(bad: BadInput, place: str) -> Text:
    """The first mistakes, one a row."""
    rows = [error.text(place) for error in bad.errors[:SHOWN_ERRORS]]
    if len(bad.errors) > SHOWN_ERRORS:
        rows.append(Text("… and {count} more", count=len(bad.errors) - SHOWN_ERRORS))
    return Text("\n").join(rows)


# --- where to write
# A file that is there is overwritten only after a second Enter.


class TargetDialog(PathDialog[Path | None]):
    """Gives the path of a file to write: what is typed takes the place of its name, folder and ending stay; a path
    leads elsewhere, and an ending that is typed goes before.  `own`: a file that may be overwritten without asking."""

    def __init__(self, start: Path, own: Path | None = None) -> None:
        super().__init__(start.name, start.parent)
        self.own = own
        self._asked: Path | None = None

    def selected(self) -> Selection:
        return Selection(0, len(Path(self.start).stem))

    @property
    def named(self) -> bool:
        """Whether there is a name, and not only an ending."""
        return self.text() not in ("", *self.ENDINGS)

    @property
    def leads_to_folder(self) -> bool:
        """Whether only an ending, or nothing, stands behind the last folder."""
        return re.split(r"[/\\]", self.text())[-1].lower() in ("", *self.ENDINGS)

    def take(self, path: Path) -> None:
        if Path(path.stem).suffix.lower() in self.ENDINGS:
            path = path.with_name(path.stem)  # the ending that was typed, before that which stood there
        if not path.suffix and not path.is_dir():
            path = path.with_suffix(self.ENDINGS[0])
        if not self.named:
            self.say(Text("Give it a name."))
        elif self.leads_to_folder or path.is_dir():
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
        if not self.named:
            self.session.recording = None
            self.dismiss(None)
        else:
            super().take(path)

    def wrong(self, path: Path) -> Text:
        return Text("This is the design itself; give another name.") if path == self.session.path else EMPTY


class ExportDialog(TargetDialog):
    """Gives the path to export to, and what; a row of the list gives its name to the file, an ending that is typed
    chooses its row."""

    TITLE_TEXT = Text("Export")
    HINT = Text("Enter writes it, ↓ goes to the list, Esc goes back.")

    def __init__(self, session: Session, offered: Sequence[FileRow], chosen: FileRow) -> None:
        self.stem, self.offered_rows, self.chosen = session.home.stem, offered, chosen
        self.ENDINGS = tuple({f".{ending}": None for row in offered for ending in row.endings})
        super().__init__(folder_of(session) / f"{self.stem}{chosen.tail}")

    def fill(self) -> None:
        """The kinds of files, once: those that can not be written with what is in the way."""
        options = self.query_one("#names", OptionList)
        if options.option_count:
            return
        width = max(len(row.tail) for row in self.offered_rows) + 2
        for row in self.offered_rows:
            shown = self.app.say(Text("{tail}{what}", tail=Name(row.tail.ljust(width)), what=row.what))
            if row.reason is not None:
                shown = self.app.say(Text("{shown}: {reason}", shown=Name(shown), reason=row.reason))
            options.add_option(Option(Content(shown), disabled=row.reason is not None))

    def pick(self, row: int) -> None:
        self.chosen = self.offered_rows[row]
        box = self.query_one("#path", Input)
        folder = box.value[: max(box.value.rfind("/"), box.value.rfind("\\")) + 1]
        box.value = f"{folder}{self.stem}{self.chosen.tail}"
        box.focus()
        box.selection = Selection(len(folder), len(box.value) - len(Path(self.chosen.tail).suffix))

    def take(self, path: Path) -> None:
        ending = Path(path.stem).suffix if Path(path.stem).suffix.lower() in self.ENDINGS else path.suffix
        if (ending := ending.lower().removeprefix(".")) and ending not in self.chosen.endings:
            meant = [row for row in self.offered_rows if ending in row.endings]
            self.chosen = next((row for row in meant if row.alone), meant[0] if meant else self.chosen)
        super().take(path)

    def wrong(self, path: Path) -> Text:
        if path.suffix.lower() not in self.ENDINGS:
            known = " ".join(self.ENDINGS)
            return Text("The ending {ending} is not known: {known}", ending=path.suffix, known=known)
        return self.chosen.reason or EMPTY


# --- which design to open
# A file that is none stays in the dialog, with the reason.


class OpenDialog(PathDialog[Session | None]):
    """Gives the session of the design that was opened."""

    TITLE_TEXT = Text("Open a design")
    HINT = Text("Enter opens, ↓ goes to the list, Esc goes back. Unsaved edits of this design are kept.")

    def __init__(self, memory: Memory, folder: Path, here: Path | None = None) -> None:
        super().__init__(f"{str(folder).rstrip('/')}/", folder)
        self.memory, self.here = memory, here  # the design that is open

    def offered(self) -> list[tuple[Text, list[Path]]]:
        recent = [path for path in self.memory.recent() if path != self.here]
        return [(Text("Opened last"), recent), (Text("Examples"), designs())]

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


# --- what the file of a design that is begun is to be called


class NewDialog(TargetDialog):
    """Gives the path of a file that is not there yet."""

    HINT = Text("Enter begins, Esc goes back. Nothing is written before you save; what you do is kept all the same.")

    def __init__(self, row: Beginning) -> None:
        title = Text("A design with the engine {engine}: its name", engine=row.title)
        own = Text("{engine}, every number of it yours: its name", engine=row.title)
        self.TITLE_TEXT = own if row.kind == "own" else title
        super().__init__(own_file(row.id, Path.cwd()))

    def wrong(self, path: Path) -> Text:
        return (
            Text("{name} is there already: open it, or give another name.", name=path.name) if path.exists() else EMPTY
        )


def begin_with(app: BaseApp, row: Beginning, path: Path | None = None) -> None:
    """Begin a design with a blank or a shipped engine; asks for its name where none is known yet."""

    def begin(path: Path | None) -> None:
        if path is not None:
            data = blank(row.id, path) if row.kind == "own" else engine_only(row.id, path)
            app.call_later(app.enter, Session.begin(data, path.absolute(), memory=app.memory))

    if path is not None:
        begin(path)
    else:
        app.push_screen(NewDialog(row), begin)
