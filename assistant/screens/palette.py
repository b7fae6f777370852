# SPDX-License-Identifier: Apache-2.0
"""The palette: words in any order find whatever can be done or gone to, in every language of the program."""

from typing import ClassVar

from textual._callback import invoke
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from calc.sheet.text import Text

from ..base_app import BaseApp
from ..matching import folded
from ..widgets.text import fit
from .palette_entries import Entry, entries
from .workbench import Workbench

MOST = 60  # rows


class Found(OptionList, can_focus=False):
    """The rows; the place to type keeps the focus."""


class Palette(ModalScreen[None]):
    app: BaseApp
    HOLDS = True  # keys that follow Enter or Escape are for where it leads
    AUTO_FOCUS = "#words"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "leave", "Back", show=False, priority=True),
        Binding("down", "move(1)", "Down", show=False, priority=True),
        Binding("up", "move(-1)", "Up", show=False, priority=True),
        Binding("pagedown", "move(10)", "A screenful down", show=False, priority=True),
        Binding("pageup", "move(-10)", "A screenful up", show=False, priority=True),
    ]

    def __init__(self) -> None:
        super().__init__()
        self._entries: list[Entry] = []
        self.rows: list[Entry] = []
        self._words = ""  # for which the rows are
        self._ending = False

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        work = next((screen for screen in self.app.screen_stack if isinstance(screen, Workbench)), None)
        self._entries = entries(self.app, work)
        with Vertical(classes="dialog", id="palette"):
            yield Input(placeholder=self.app.say(Text("what to do, or where to go: words in any order")), compact=True, id="words")
            yield Found(id="found", compact=True)
            yield Static("", id="palette-help")

    def on_mount(self) -> None:
        self.fill()
        self.call_after_refresh(self.app.release)

    def on_resize(self) -> None:
        self.call_after_refresh(self.fill)

    # --- rows
    def fill(self) -> None:
        """The best first; without words, what can be done."""
        self._words = self.query_one("#words", Input).value
        words = folded(self._words).split()
        if words:
            scored = [(*entry.score(words), entry) for entry in self._entries]
            best = sorted((one for one in scored if one[0] > 0), key=lambda one: -one[0])[:MOST]
        else:
            best = [(1.0, [], entry) for entry in self._entries if entry.first]
        self.rows = [entry for _, _, entry in best]
        found = self.query_one(Found)
        width = max(8, found.size.width - 3)
        found.clear_options()
        found.add_options([Option(self._row(entry, spans, width)) for _, spans, entry in best])
        found.highlighted = 0 if self.rows else None
        self._show_help()

    def _row(self, entry: Entry, spans: list[tuple[int, int]], width: int) -> Content:
        keys = f"  {entry.keys}" if entry.keys and len(entry.title) + len(entry.keys) + 2 <= width else ""
        title = Content(fit(entry.title, width - len(keys)))
        for start, end in spans:
            title = title.stylize("bold underline", start, min(end, len(title)))
        return Content.assemble(" ", title, " " * max(0, width - len(title) - len(keys)), (keys, "dim"))

    def _show_help(self) -> None:
        at = self.query_one(Found).highlighted
        told = self.rows[at].help if at is not None and at < len(self.rows) else self.app.say(Text("Nothing has these words."))
        self.query_one("#palette-help", Static).update(Content.styled(told, "dim"))

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()
        self._show_help()

    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        self.fill()

    # --- keys
    def action_move(self, by: int) -> None:
        found = self.query_one(Found)
        if self.rows and found.highlighted is not None:
            found.highlighted = max(0, min(len(self.rows) - 1, found.highlighted + by))

    def action_leave(self) -> None:
        self._end()

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        if event.value != self._words:  # Enter came before the rows of the last letters
            self.fill()
        at = self.query_one(Found).highlighted
        if at is None:
            self.app.release()
        else:
            self._end(self.rows[at])

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self._end(self.rows[event.option_index])

    def _end(self, entry: Entry | None = None) -> None:
        """Close, once, and run what was chosen."""
        if self._ending:
            return
        self._ending = True
        app = self.app

        async def run() -> None:
            try:
                if entry is not None:
                    await invoke(entry.does)
            finally:
                app.call_after_refresh(app.call_after_refresh, app.release)  # the focus is where it leads

        self.dismiss()
        app.call_later(run)
