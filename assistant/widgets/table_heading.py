# SPDX-License-Identifier: Apache-2.0
"""The heading of a table that may be left out: `Gas  + add` where it is, `Gas  −` above its fields where it is there."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.style import Style
from textual.widget import Widget

from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from ..session.places import content_at
from ..session.session import Session
from .entry import LEAVING
from .field_help import heading_help
from .rows import Row


class TableHeading(Widget, can_focus=True):
    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("plus", "add", "Add the table", show=False),
        Binding("minus,delete", "remove", "Remove the table", show=False),
    ]
    HELP = Text(
        "This part may be left out. + or Enter adds it, its fields empty; − takes it out with all its fields. Undo takes either back."
    )

    @dataclass
    class Added(Message):
        heading: "TableHeading"

    @dataclass
    class Removed(Message):
        heading: "TableHeading"

    def __init__(self, row: Row, session: Session) -> None:
        super().__init__()
        self.row = row
        self.session = session
        self.reason = EMPTY  # why the table as a whole is not accepted
        self._looks: tuple[object, ...] = ()

    @property
    def there(self) -> bool:
        return content_at(self.session.data, self.row.place) is not None

    @property
    def adds(self) -> bool:
        """Whether Enter adds the table: where it is there, Enter goes on."""
        return not self.there

    def redraw(self, row: Row, reason: Text) -> None:
        looks = (self.there, reason, row.about.label)
        self.row = row
        self.reason = reason
        if looks != self._looks:
            self._looks = looks
            self.refresh()

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        return heading_help(self.row.about, self.HELP, self.reason, self.app)

    def render(self) -> Content:
        minus = "-" if self.app.signs.ascii else "−"
        text, action = (minus, "remove") if self.there else (self.app.say(Text("+ add")), "add")
        link = Content.styled(text, "bold" if self.has_focus else "dim").stylize(Style.from_meta({"@click": action}))
        signs = self.app.signs
        left = Content.styled(f" {self.row.about.label}", "bold" if self.there else "bold dim")
        if self.reason:
            left = Content.styled(f" {signs.mark('invalid')} {self.row.about.label}", signs.style("invalid"))
        return Content.assemble(left, " " * max(2, self.size.width - left.cell_length - link.cell_length - 1), link)

    def action_add(self) -> None:
        if not self.there:
            self.post_message(self.Added(self))

    def action_remove(self) -> None:
        if self.there:
            self.post_message(self.Removed(self))

    def on_focus(self, event: events.Focus) -> None:
        self.refresh()

    def on_blur(self, event: events.Blur) -> None:
        self.refresh()
