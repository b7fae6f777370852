# SPDX-License-Identifier: Apache-2.0
"""One of several words, in one row.  Enter or space opens the list; in the list, letters find a word."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.widget import Widget

from ..base_app import BaseApp
from .entry import LEAVING
from .wrap import fit


class Choice(Widget, can_focus=True):
    """The arrows stay free for going from field to field.  `prompt` stands there while nothing is chosen."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [*LEAVING, Binding("enter,space", "open", "Show the list", show=False)]

    @dataclass
    class Changed(Message):
        choice: "Choice"
        value: str

    def __init__(self, words: tuple[str, ...], value: str, *, optional: bool, prompt: str) -> None:
        super().__init__()
        self.words = words
        self.value = value
        self.optional = optional or not value
        self.prompt = prompt

    def show(self, text: str) -> None:
        """Put a word in; nobody is told."""
        if text != self.value:
            self.value = text
            self.refresh()

    def take(self, word: str) -> None:
        """Choose a word, or none."""
        if word != self.value:
            self.show(word)
            self.post_message(self.Changed(self, word))

    def turn(self, by: int) -> None:
        """The next word, or the one before."""
        if self.words:
            here = self.words.index(self.value) if self.value in self.words else -1 if by > 0 else 0
            self.take(self.words[(here + by) % len(self.words)])

    def render(self) -> Content:
        mark = "v" if self.app.signs.ascii else "▼"
        room = max(1, self.size.width - 2)
        text = fit(self.value or self.prompt, room)
        return Content.assemble((f"{text:<{room}} ", "" if self.value else "italic dim"), (mark, "dim"))

    def action_open(self) -> None:
        from ..screens.choose import Choose

        words = self.words if not self.value or self.value in self.words else (self.value, *self.words)
        self.app.push_screen(Choose(words, self.value, self.prompt if self.optional else "", self.region), self._chosen)

    def _chosen(self, word: str | None) -> None:
        if word is not None:
            self.take(word)

    def on_click(self, event: events.Click) -> None:
        event.stop()
        self.focus()
        self.action_open()
