# SPDX-License-Identifier: Apache-2.0
"""The places where a value is given: a line to type on, and a choice of words.

What is typed is understood by the session and not here: `3,5` must not become 35."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.geometry import Size
from textual.message import Message
from textual.reactive import Reactive
from textual.widget import Widget
from textual.widgets import Input
from textual.widgets.input import Selection

from calc.design.names import choice_word

from ..actions import BY_ID
from ..base_app import BaseApp
from .line import EDITS, Line
from .text import fit

# Other keys are given to the part that has the focus, and wait there for their turn.  These move the focus before the
# next key is looked at, so that of keys that come in one burst (a slow line, a busy machine) none ends up in the field
# that was left.
LEAVING: tuple[Binding, ...] = (
    Binding("tab", "app.focus_next", "Next field", show=False, priority=True),
    Binding("shift+tab", "app.focus_previous", "Previous field", show=False, priority=True),
    Binding("down", f"screen.{BY_ID['down'].does}", "Next field", show=False, priority=True),
    Binding("up", f"screen.{BY_ID['up'].does}", "Previous field", show=False, priority=True),
)
AT_ONCE = ("down", "up", "go_on", "quit")  # actions that have such a binding, here or in the app


class Entry(Line):
    """A one-row text input.  The first key replaces the text, as in a table; from then on it is being edited, and Esc
    takes it back.

    `numeric`: no letter begins a number, so letters may be keys before anything is typed.

    A form has thirty of them, so the text and the compact look are put in without waking up the watchers of `Input`,
    each of which would style the field anew and report the first text as an edit."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("enter", "accept", "Accept, go on", show=False, priority=True),
    ]
    # the box keeps its size whatever is typed; nothing else has to move
    virtual_size = Reactive(Size(0, 0), layout=False)

    @dataclass
    class Began(Message):
        """The first key was struck."""

        entry: "Entry"

    @dataclass
    class Pasted(Message):
        """Several values at once."""

        entry: "Entry"
        values: list[str]

    def __init__(self, value: str, placeholder: str = "", *, numeric: bool = False) -> None:
        super().__init__(select_on_focus=False, validate_on=[])
        self.numeric = numeric
        self.editing = False
        self.add_class("-textual-compact", update=False)
        self.set_reactive(Input.compact, True)
        self.set_reactive(Input.placeholder, placeholder)
        self.set_reactive(Input.value, value)
        self.set_reactive(Input.selection, Selection.cursor(self._end(value)))
        self._initial_value = False

    def on_mount(self) -> None:
        self.virtual_size = Size(self.content_width, 1)

    async def _on_key(self, event: events.Key) -> None:
        if event.key in EDITS or event.is_printable:
            self._begin()
        await super()._on_key(event)

    def _begin(self) -> None:
        if not self.editing:
            self.editing = True
            self.post_message(self.Began(self))

    def _end(self, value: str) -> int:
        """Where the cursor rests: behind a number; words that are longer than their box show how they begin."""
        return len(value) if self.numeric else 0

    def _on_focus(self, event: events.Focus) -> None:
        if not event.from_app_focus:
            self._select()

    def _select(self) -> None:
        """All of it, with the cursor where it rests."""
        self.selection = Selection(len(self.value) - (end := self._end(self.value)), end)

    def arrive(self, text: str) -> None:
        """As if it had just got the focus, with this text in it."""
        self.show(text)
        self.editing = False
        self._select()

    def _on_blur(self, event: events.Blur) -> None:
        self.editing = False

    def _on_paste(self, event: events.Paste) -> None:
        """Several lines, or cells of a table, are several values; nothing of them is dropped."""
        self._begin()
        values = [part.strip() for line in event.text.strip().splitlines() for part in line.split("\t")]
        if len(values) > 1:
            event.stop()
            event.prevent_default()
            self.post_message(self.Pasted(self, values))

    async def action_accept(self) -> None:
        """Go on; at the end of the form there is nowhere to go, and the text is accepted when all of it is there."""
        await self.run_action(f"screen.{BY_ID['go_on'].does}")
        if self.screen.focused is self:
            self.call_later(self.action_submit)

    def show(self, text: str) -> None:
        """Put a text in, with the cursor behind it; nobody is told."""
        if text != self.value:
            with self.prevent(Input.Changed):
                self.value = text
            self.cursor_position = self._end(text)


# --- one of several words, in one row
# Space, → or a letter opens the list, in which letters find a word; Enter goes on.

AUTO = "(auto)"  # the program chooses; the same in every language, as in the texts that name it


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
        return choice if self.named else self.app.say(choice_word(choice))

    def render(self) -> Content:
        mark = "v" if self.app.signs.ascii else "▼"
        room = max(1, self.size.width - 2)
        text = fit(self.said(self.value) if self.value else self.prompt, room)
        return Content.assemble((f"{text:<{room}} ", "" if self.value else "italic dim"), (mark, "dim"))

    def on_key(self, event: events.Key) -> None:
        """A letter or a digit begins a word."""
        if not event.is_printable or not event.character or not event.character.isalnum():
            return
        event.stop()
        event.prevent_default()
        if self.app.screen is not self.screen:  # struck while the list was being opened
            self.app.screen.post_message(event)
        else:
            self.action_open(event.character)

    def action_open(self, typed: str = "") -> None:
        from ..screens.dialogs import Choose

        words = self.words if not self.value or self.value in self.words else (self.value, *self.words)
        none = self.prompt if self.optional else ""
        if none in map(self.said, words):  # what the program takes by itself, beside the same word as chosen
            none = f"{none} {AUTO}"
        self.app.push_screen(Choose(words, self.value, none, self.region, typed, self.said), self._chosen)

    async def _chosen(self, word: str | None) -> None:
        """Enter in the list takes the word and goes on."""
        if word is not None:
            self.take(word)
            await self.run_action(f"screen.{BY_ID['go_on'].does}")

    def on_click(self, event: events.Click) -> None:
        event.stop()
        self.focus()
        self.action_open()
