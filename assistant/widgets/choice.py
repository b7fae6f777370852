# SPDX-License-Identifier: Apache-2.0
"""One of several words, in one row.  Space, → or a letter opens the list, in which letters find a word; Enter goes on."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.widget import Widget

from calc.sheet.choice_words import word

from ..actions import BY_ID
from ..base_app import BaseApp
from .entry import LEAVING, LOCK
from .text import fit


class Choice(Widget, can_focus=True):
    """The arrows stay free for going from field to field.  `prompt` stands there while nothing is chosen."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("enter", f"screen.{BY_ID['go_on'].does}", "Go on", show=False, priority=True),
        Binding("space,right", "open", "Show the list", show=False),
    ]

    @dataclass
    class Changed(Message):
        choice: "Choice"
        value: str

    @dataclass
    class Locked(Message):
        """The lock of the input is asked for."""

        choice: "Choice"

    def __init__(self, words: tuple[str, ...], value: str, *, optional: bool, prompt: str, named: bool = False) -> None:
        """`named`: the words are names, which every language leaves as they are."""
        super().__init__()
        self.named = named
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

    def said(self, choice: str) -> str:
        """A word as people read it."""
        return choice if self.named else self.app.say(word(choice))

    def render(self) -> Content:
        mark = "v" if self.app.signs.ascii else "▼"
        room = max(1, self.size.width - 2)
        text = fit(self.said(self.value) if self.value else self.prompt, room)
        return Content.assemble((f"{text:<{room}} ", "" if self.value else "italic dim"), (mark, "dim"))

    def on_key(self, event: events.Key) -> None:
        """A letter or a digit begins a word; `k` is the key of the lock."""
        if not event.is_printable or not event.character or not event.character.isalnum():
            return
        event.stop()
        event.prevent_default()
        if self.app.screen is not self.screen:  # struck while the list was being opened
            self.app.screen.post_message(event)
        elif event.key == LOCK:
            self.post_message(self.Locked(self))
        else:
            self.action_open(event.character)

    def action_open(self, typed: str = "") -> None:
        from ..screens.dialogs import Choose

        words = self.words if not self.value or self.value in self.words else (self.value, *self.words)
        self.app.push_screen(Choose(words, self.value, self.prompt if self.optional else "", self.region, typed, self.said), self._chosen)

    async def _chosen(self, word: str | None) -> None:
        """Enter in the list takes the word and goes on."""
        if word is not None:
            self.take(word)
            await self.run_action(f"screen.{BY_ID['go_on'].does}")

    def on_click(self, event: events.Click) -> None:
        event.stop()
        self.focus()
        self.action_open()
