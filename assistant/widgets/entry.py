# SPDX-License-Identifier: Apache-2.0
"""The place where a value is typed.  What it means is the session's business: `3,5` must not become 35."""

from textual.geometry import Size
from textual.reactive import Reactive
from textual.widgets import Input
from textual.widgets.input import Selection


class Entry(Input):
    """A one-row text input.  The first key replaces the text, as in a table.

    A form has thirty of them, so the text and the compact look are put in without waking up the watchers of `Input`, each of
    which would style the field anew and report the first text as an edit.
    """

    virtual_size = Reactive(Size(0, 0), layout=False)  # the box keeps its size whatever is typed; nothing else has to move

    def __init__(self, value: str, placeholder: str = "") -> None:
        super().__init__(select_on_focus=True, validate_on=[])
        self.add_class("-textual-compact", update=False)
        self.set_reactive(Input.compact, True)
        self.set_reactive(Input.placeholder, placeholder)
        self.set_reactive(Input.value, value)
        self.set_reactive(Input.selection, Selection.cursor(len(value)))
        self._initial_value = False

    def on_mount(self) -> None:
        self.virtual_size = Size(self.content_width, 1)

    def show(self, text: str) -> None:
        """Put a text in, with the cursor behind it; nobody is told."""
        if text != self.value:
            with self.prevent(Input.Changed):
                self.value = text
            self.cursor_position = len(text)
