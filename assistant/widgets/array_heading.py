# SPDX-License-Identifier: Apache-2.0
"""The heading of an array of tables: how many there are, which one is shown, and the keys that add, remove and leaf."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.widget import Widget

from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from ..places import content_at
from ..session import Session
from .entry import LEAVING
from .field_help import heading_help
from .rows import Row
from .wrap import fit


class ArrayHeading(Widget, can_focus=True):
    """`◂ 2 of 4: central ▸` of a long array, `2` of a short one that stands there whole."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("left", "leaf(-1)", "Element before", show=False),
        Binding("right,space", "leaf(1)", "Next element", show=False),
        Binding("plus", "add", "Add an element", show=False),
        Binding("minus,delete", "remove", "Remove the element", show=False),
    ]
    HELP = Text(
        "+ (or Enter, while there is none) adds an element, like the last one; − takes out the one that is shown (the last of a short "
        "list); ← → leafs through them."
    )

    @dataclass
    class Leafed(Message):
        heading: "ArrayHeading"
        index: int

    @dataclass
    class Added(Message):
        heading: "ArrayHeading"

    @dataclass
    class Removed(Message):
        heading: "ArrayHeading"
        index: int

    def __init__(self, row: Row, session: Session) -> None:
        super().__init__()
        self.row = row
        self.session = session
        self.reason = EMPTY  # why the array as a whole is not accepted
        self._looks: tuple[object, ...] = ()

    def redraw(self, row: Row, reason: Text) -> None:
        """Draw anew if there is something new to draw."""
        looks = (row.shown, self.names(), reason)
        self.row, self.reason = row, reason
        if looks != self._looks:
            self._looks = looks
            self.refresh()

    @property
    def adds(self) -> bool:
        """Whether Enter adds an element: where there are some, Enter goes on."""
        return not self.names()

    def names(self) -> list[str]:
        return [str(item.get("name", n + 1)) for n, item in enumerate(content_at(self.session.data, self.row.place) or [])]

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        return heading_help(self.row.about, self.HELP, self.reason, self.app)

    def render(self) -> Content:
        names = self.names()
        shown = self.row.shown
        signs = self.app.signs
        before, after, minus = ("<", ">", "-") if signs.ascii else ("◂", "▸", "−")
        title = f"{signs.mark('invalid')} {self.row.about.label}" if self.reason else self.row.about.label
        if shown is None or shown >= len(names):
            middle: list[Content | str | tuple[str, str]] = [(f"  {len(names)}", "dim")]
        else:
            name = f" {names[shown]}" if names[shown] != str(shown + 1) else ""
            text = f" {self.app.say(Text('{n} of {count}', n=shown + 1, count=len(names)))}{name} "
            middle = [
                "  ",
                self._link(before, "leaf(-1)"),
                fit(text, max(8, self.size.width - len(title) - 10)),  # beside blanks, arrows and buttons
                self._link(after, "leaf(1)"),
            ]
        buttons: list[Content | str] = (
            [self._link("+", "add"), " ", self._link(minus, "remove")] if names else [self._link(self.app.say(Text("+ add")), "add")]
        )
        left = Content.assemble((" " + title, signs.style("invalid") if self.reason else "bold"), *middle)
        gap = max(1, self.size.width - left.cell_length - Content.assemble(*buttons).cell_length - 1)
        return Content.assemble(left, " " * gap, *buttons)

    def _link(self, text: str, action: str) -> Content:
        from textual.style import Style

        return Content.styled(text, "bold" if self.has_focus else "dim").stylize(Style.from_meta({"@click": action}))

    def action_leaf(self, by: int) -> None:
        if self.row.shown is not None and (count := len(self.names())):
            self.post_message(self.Leafed(self, (self.row.shown + by) % count))

    def action_add(self) -> None:
        self.post_message(self.Added(self))

    def action_remove(self) -> None:
        if count := len(self.names()):
            self.post_message(self.Removed(self, count - 1 if self.row.shown is None else self.row.shown))

    def on_focus(self, event: events.Focus) -> None:
        self.refresh()

    def on_blur(self, event: events.Blur) -> None:
        self.refresh()
