# SPDX-License-Identifier: Apache-2.0
"""The list of words of a field, beside the field."""

from collections.abc import Callable
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.geometry import Region
from textual.screen import ModalScreen
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from .once import Once


class Choose(Once, ModalScreen[str | None]):
    """Gives the word, an empty one for "let the program choose", None when nothing was chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Back", show=False)]

    def __init__(
        self, words: tuple[str, ...], value: str, prompt: str, beside: Region, typed: str = "", said: Callable[[str], str] = str
    ) -> None:
        """`said`: a word as people read it."""
        super().__init__()
        self.words = (*([""] if prompt else []), *words)
        self.shown = [said(word) if word else prompt for word in self.words]
        self.value, self.prompt, self.beside = value, prompt, beside
        self._typed = typed.lower()

    def compose(self) -> ComposeResult:
        options = OptionList(*[Option(Content(shown)) for shown in self.shown], id="choose", compact=True)
        height = min(len(self.words), max(4, self.app.size.height - 6))
        width = max(self.beside.width, max(map(len, self.shown)) + 4)
        options.styles.width = width
        options.styles.height = height + 2
        top = min(self.beside.y + 1, self.app.size.height - height - 2)
        options.styles.offset = (max(0, min(self.beside.x - 1, self.app.size.width - width)), max(0, top))
        yield options

    def on_mount(self) -> None:
        options = self.query_one(OptionList)
        options.highlighted = self.words.index(self.value) if self.value in self.words else 0
        options.focus()
        if self._typed:
            self._find()

    def on_key(self, event: events.Key) -> None:
        """Letters find a word: typed together, its beginning or a part of it."""
        if event.key == "backspace":
            self._typed = self._typed[:-1]
        elif event.is_printable and event.character and event.key != "enter":
            self._typed += event.character.lower()
        else:
            return
        event.stop()
        event.prevent_default()
        self._find()

    def _find(self) -> None:
        """Put the cursor on the word that begins with, or has in it, what was typed."""
        low = [shown.lower() if word else "" for shown, word in zip(self.shown, self.words)]
        either = [f"{shown}\n{word.lower()}" for shown, word in zip(low, self.words)]  # or as the file has it
        found = next(
            (n for n, w in enumerate(low) if w.startswith(self._typed)), next((n for n, w in enumerate(either) if self._typed in w), None)
        )
        if found is not None:
            self.query_one(OptionList).highlighted = found
        else:
            self._typed = self._typed[-1:]

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.dismiss(self.words[event.option_index])

    def on_click(self, event: events.Click) -> None:
        if event.widget is self:
            self.dismiss(None)

    def action_cancel(self) -> None:
        self.dismiss(None)
