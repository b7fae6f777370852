# SPDX-License-Identifier: Apache-2.0
"""A question with two answers."""

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Static

from .once import Once


class Ask(Once, ModalScreen[bool]):
    """`y` or Enter gives True, `n` or Esc False."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("y,enter", "answer(True)", "Yes", show=False),
        Binding("n,escape", "answer(False)", "No", show=False),
    ]

    def __init__(self, question: str, yes: str, no: str) -> None:
        super().__init__()
        self.question, self.yes, self.no = question, yes, no

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Static(Content(self.question))
            yield Static("")
            yield Static(Content.assemble(("y", "bold"), f" {self.yes}    ", ("n", "bold"), f" {self.no}"))

    def action_answer(self, answer: bool) -> None:
        self.dismiss(answer)
