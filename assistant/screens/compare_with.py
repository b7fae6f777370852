# SPDX-License-Identifier: Apache-2.0
"""Asks what to compare the design with: its saved file, an earlier state, or another design."""

from pathlib import Path
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import OptionList, Static
from textual.widgets.option_list import Option

from calc.sheet.errors import BadInput
from calc.sheet.text import Text
from calc.studies.shipped import DESIGNS

from ..base_app import BaseApp
from ..session.versions import Chosen, Other, kept, of_file, of_session, past
from ..session.session import Session
from .once import Once
from .path_dialogs import PathDialog

SHOWN_ERRORS = 4


class CompareWith(Once, ModalScreen[Chosen | None]):
    """Gives the design that was chosen, solved by nobody yet."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "cancel", "Back", show=False),
        Binding("j", "move(1)", "Down", show=False),
        Binding("k", "move(-1)", "Up", show=False),
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
                Content(self.app.say(Text("This state was not valid:\n{errors}", errors=errors_text(bad, Text("the design")))))
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
        shipped = sorted(DESIGNS.glob("*.toml"))
        shipped = [path for path in shipped if str(path) not in self._names]
        self._names += [str(path) for path in shipped]
        options = self.query_one("#names", OptionList)
        options.add_options([Option(Content(self.app.say(Text("{name}   (comes with the program)", name=path.name)))) for path in shipped])
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
