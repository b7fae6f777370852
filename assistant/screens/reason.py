# SPDX-License-Identifier: Apache-2.0
"""Asking for the reason of a decision: a line to write on, and below it usual reasons."""

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static

from calc.sheet.text import Text

from ..base_app import BaseApp
from .once import Once

HINT = Text("Enter accepts it with this reason, ↓ chooses a usual one, Esc goes back.")


class Reason(Once, ModalScreen[str | None]):
    """Gives the reason, or None.  `begun`: what stands in the line at first, to be written on."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Cancel", show=False),
        Binding("enter", "take", "Take the reason", show=False, priority=True),
        Binding("down", "list(1)", "To the usual reasons", show=False, priority=True),
        Binding("up", "list(-1)", "Back to the reason", show=False, priority=True),
    ]

    def __init__(self, question: Text, about: str, usual: tuple[Text, ...], begun: str = "") -> None:
        super().__init__()
        self.question, self.about, self.usual, self.begun = question, about, usual, begun

    def compose(self) -> ComposeResult:
        say = self.app.say
        with Vertical(classes="dialog"):
            yield Static(Content.styled(say(self.question), "bold"))
            yield Static(Content(self.about))
            yield Input(self.begun, compact=True, select_on_focus=False, id="words")
            yield OptionList(*(Content(say(reason)) for reason in self.usual), compact=True, id="names")
            yield Static("", classes="wrong")
            yield Static(Content.styled(say(HINT), "dim"))

    def action_take(self) -> None:
        """The reason that is written; in the list that of the row, to be written on."""
        options = self.query_one(OptionList)
        if self.focused is options and options.highlighted is not None:
            self._write(options.highlighted)
        elif reason := "".join(letter for letter in self.query_one(Input).value if letter.isprintable()).strip():
            self.dismiss(reason)
        else:
            self.query_one(".wrong", Static).update(Content(self.app.say(Text("A reason is needed: it stands in the report."))))

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """By a click."""
        event.stop()
        self._write(event.option_index)

    def _write(self, index: int) -> None:
        box = self.query_one(Input)
        box.value = self.app.say(self.usual[index]).removesuffix("…")
        box.cursor_position = len(box.value)
        self.set_focus(box)

    def action_list(self, by: int) -> None:
        options = self.query_one(OptionList)
        if by > 0 and self.focused is not options:
            self.set_focus(options)
            options.action_first()
        elif by > 0:
            options.action_cursor_down()
        elif options.highlighted in (0, None):
            self.set_focus(self.query_one(Input))
        else:
            options.action_cursor_up()

    def action_cancel(self) -> None:
        self.dismiss(None)
