# SPDX-License-Identifier: Apache-2.0
"""The heading of an array of tables: how many there are, which one is shown, and the keys that add, remove and leaf."""

from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.geometry import Size
from textual.message import Message
from textual.widget import Widget

from calc.sheet.quantity import keys
from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from ..session.places import content_at
from ..session.session import Session
from .entry import LEAVING
from .field_help import heading_help
from .rows import Row
from .text import fit, pad

TALL = 30  # rows of a screen that has room for a table of the elements
MOST = 8  # elements in it
INDENT, GAP, LABEL = 3, 2, 12  # cells before its rows, between its columns, and of a label that is wider than what is below it


class ArrayHeading(Widget, can_focus=True):
    """`◂ 2 of 4: central ▸` of a long array, over a table of what its elements must have; `2` of a short one that stands there whole."""

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
        self._rows = 0  # of its table, when last looked at

    def redraw(self, row: Row, reason: Text) -> None:
        """Draw anew if there is something new to draw."""
        self.row, self.reason = row, reason
        looks = (row.shown, cells := self.cells(), self.names(), reason)
        if looks != self._looks:
            self.refresh(layout=len(cells) != self._rows)
            self._looks, self._rows = looks, len(cells)

    @property
    def adds(self) -> bool:
        """Whether Enter adds an element: where there are some, Enter goes on."""
        return not self.names()

    def names(self) -> list[str]:
        return [str(item.get("name", n + 1)) for n, item in enumerate(content_at(self.session.data, self.row.place) or [])]

    def items(self) -> list[dict[str, object]]:
        """The elements of the table; none where they stand in the form themselves, or there is no room."""
        items = content_at(self.session.data, self.row.place) or []
        return items if self.row.shown is not None and len(items) <= MOST and self.app.size.height >= TALL else []

    def cells(self) -> list[tuple[str, ...]]:
        """Their names, and what each must have beside it, below the labels."""
        assert self.row.about.table is not None
        known = {key: one.about for key, one in keys(self.row.about.table).items()}
        columns = [key for key, about in known.items() if not about.optional and about.kind not in ("table", "tables") and key != "name"]
        if not (items := self.items()) or not columns:
            return []
        labels = [f"{self.app.say(known[key].label)} {known[key].unit}".rstrip() for key in columns]
        return [("", *labels), *((name, *(self._written(item.get(key)) for key in columns)) for name, item in zip(self.names(), items))]

    def _written(self, value: object) -> str:
        if isinstance(value, (list, tuple)):
            return " ".join(map(self._written, value))
        return self.app.say.number(f"{value:g}".replace("-", "−")) if isinstance(value, (int, float)) else str(value or "")

    def get_content_height(self, container: Size, viewport: Size, width: int) -> int:
        return 1 + len(self.cells())

    def _table(self) -> list[Content]:
        """A row for each element, that which is shown marked; columns as far as there is room."""
        cells = self.cells()
        wide = [max(min(len(label), LABEL), *map(len, column)) + GAP for label, *column in zip(*cells)]
        while sum(wide) - GAP + INDENT > self.size.width and len(wide) > 2:
            wide.pop()
        here = ">" if self.app.signs.ascii else "▸"
        rows = []
        for n, row in enumerate(cells, -1):
            text = "".join(pad(fit(cell, width - GAP), width) for cell, width in zip(row, wide))
            mark, style = (here, "bold") if n == self.row.shown else (" ", "dim" if n < 0 else "")
            written = Content.styled(fit(f" {mark} {text}", self.size.width).rstrip(), style)
            rows.append(written if n < 0 else self._clicked(written, f"show({n})"))
        return rows

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
        return Content("\n").join([Content.assemble(left, " " * gap, *buttons), *self._table()])

    def _link(self, text: str, action: str) -> Content:
        return self._clicked(Content.styled(text, "bold" if self.has_focus else "dim"), action)

    def _clicked(self, content: Content, action: str) -> Content:
        from textual.style import Style

        return content.stylize(Style.from_meta({"@click": action}))

    def action_leaf(self, by: int) -> None:
        if self.row.shown is not None and (count := len(self.names())):
            self.post_message(self.Leafed(self, (self.row.shown + by) % count))

    def action_show(self, index: int) -> None:
        self.post_message(self.Leafed(self, index))

    def action_add(self) -> None:
        self.post_message(self.Added(self))

    def action_remove(self) -> None:
        if count := len(self.names()):
            self.post_message(self.Removed(self, count - 1 if self.row.shown is None else self.row.shown))

    def on_focus(self, event: events.Focus) -> None:
        self.refresh()

    def on_blur(self, event: events.Blur) -> None:
        self.refresh()
