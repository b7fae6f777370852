# SPDX-License-Identifier: Apache-2.0
"""A list of items, each of one or more rows, with a cursor that stays on its item when the content changes."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, cast

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.geometry import Region, Size
from textual.message import Message
from textual.scroll_view import ScrollView
from textual.selection import Selection
from textual.strip import Strip
from textual.style import Style
from textual.visual import RenderOptions

from ..base_app import BaseApp

if TYPE_CHECKING:
    from textual.css.styles import RulesMap


@dataclass(frozen=True)
class Item:
    """`value` and `line` are what is copied.  An item without a key can not be chosen."""

    key: str
    rows: Sequence[Content]
    value: str = ""
    line: str = ""


class ItemList(ScrollView, can_focus=True, inherit_bindings=False):
    """Subclasses say what the items are for a width; this class draws, scrolls and moves the cursor.

    Up and down are the main screen's, as everywhere.
    """

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("pagedown", "page(1)", "A screenful down", show=False),
        Binding("pageup", "page(-1)", "A screenful up", show=False),
        Binding("home", "page(-1000)", "To the beginning", show=False),
        Binding("end", "page(1000)", "To the end", show=False),
    ]
    COMPONENT_CLASSES: ClassVar[set[str]] = {"item-list--cursor"}
    ALLOW_SELECT = True

    @dataclass
    class Chosen(Message):
        """An item was chosen, by Enter or by a click."""

        source: "ItemList"
        key: str
        clicked: bool = False

        @property
        def control(self) -> "ItemList":
            return self.source

    @dataclass
    class Moved(Message):
        """The cursor or the visible part has moved."""

        source: "ItemList"

        @property
        def control(self) -> "ItemList":
            return self.source

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id)
        self.items: list[Item] = []
        self.cursor = -1
        self._rows: list[tuple[int, Content]] = []  # (item, row)
        self._first: list[int] = []  # first row of each item
        self._built = 0  # the width for which the rows were made
        self.stale = False  # what stands here is no longer, or not yet, what the fields say
        self._wanted: tuple[str, bool] | None = None  # where to go as soon as there are rows

    def set_stale(self, stale: bool) -> None:
        if stale != self.stale:
            self.stale = stale
            self.refresh()

    # --- content
    def build(self, width: int) -> list[Item]:
        raise NotImplementedError

    @property
    def room(self) -> int:
        """The cells of a row, without the scroll bar."""
        return self.scrollable_content_region.width

    def rebuild(self) -> None:
        """Make the items anew; the cursor stays on the item that it is on."""
        width = self.room
        if width < 2:
            return
        key = self.key
        items = self.build(width - 1)
        if items is self.items or (width == self._built and _same(items, self.items)):
            self.items = items
            self._go_where_wanted()
            return
        self.items = items
        self._built = width
        self._rows = [(i, row) for i, item in enumerate(self.items) for row in item.rows]
        self._first = []
        n = 0
        for item in self.items:
            self._first.append(n)
            n += len(item.rows)
        keys = [item.key for item in self.items]
        key = self._wanted[0] if self._wanted is not None and self._wanted[0] in keys else key
        self.cursor = keys.index(key) if key in keys and key else next((i for i, k in enumerate(keys) if k), -1)
        size = Size(width, n)
        if size != self.virtual_size:
            self.virtual_size = size  # which lays the screen out anew
        self.refresh()
        self.post_message(self.Moved(self))
        self._go_where_wanted()

    def _go_where_wanted(self) -> None:
        """Where the cursor was sent while there was nothing to see yet."""
        if self._wanted is not None and self.size.height:
            wanted, self._wanted = self._wanted, None
            self.call_after_refresh(self.go_to, wanted[0], top=wanted[1])

    def on_resize(self, event: events.Resize) -> None:
        if self.room != self._built:
            self.rebuild()
        else:
            self.post_message(self.Moved(self))
            self._go_where_wanted()

    def on_show(self) -> None:
        """What was set while the list was hidden, and had no width, is built now; its size need not have changed."""
        self.rebuild()

    def notify_style_update(self) -> None:
        super().notify_style_update()
        self.refresh()

    # --- cursor
    @property
    def key(self) -> str:
        """The key of the item under the cursor."""
        return self.items[self.cursor].key if 0 <= self.cursor < len(self.items) else ""

    @property
    def item(self) -> Item | None:
        return self.items[self.cursor] if 0 <= self.cursor < len(self.items) else None

    def go_to(self, key: str, *, top: bool = False) -> bool:
        """Put the cursor on an item and bring it into view, now or as soon as the list is shown."""
        index = next((i for i, item in enumerate(self.items) if item.key == key), None)
        if not self.items or not self.size.height:
            self._wanted = (key, top)
            # a key that comes before the list is shown is for that item
            self.cursor = self.cursor if index is None else index
            return True
        if index is not None:
            self._move(index, top=top)
        return index is not None

    def move(self, by: int) -> None:
        """Move the cursor over the items that can be chosen."""
        i = self.cursor
        step = 1 if by > 0 else -1
        for _ in range(abs(by)):
            j = i + step
            while 0 <= j < len(self.items) and not self.items[j].key:
                j += step
            if not 0 <= j < len(self.items):
                # nothing more to choose: show what stands there all the same
                self.scroll_to(y=self.virtual_size.height if step > 0 else 0, animate=False)
                break
            i = j
        if i != self.cursor:
            self._move(i)

    def action_page(self, by: int) -> None:
        """Move by a screenful, or by many."""
        if not self._first or self.cursor < 0:
            return
        before, page = self.cursor, by * max(1, self.size.height - 1)
        wanted, seen = self._first[self.cursor] + page, self.scroll_y + page
        choosable = [i for i, item in enumerate(self.items) if item.key]
        nearest = min(choosable, key=lambda i: abs(self._first[i] - wanted))
        if nearest == self.cursor:  # an item higher than the list
            nearest = choosable[max(0, min(len(choosable) - 1, choosable.index(nearest) + (1 if by > 0 else -1)))]
        self._move(nearest)
        if nearest == before or not 0 <= wanted < len(self._rows):  # nothing more to choose: show what stands there
            self.scroll_to(y=seen, animate=False, force=True)

    def _move(self, index: int, *, top: bool = False) -> None:
        self.cursor = index
        first, count = self._first[index], len(self.items[index].rows)
        if top:
            self.scroll_to(y=max(0, first - 1), animate=False, force=True)
        else:
            self.scroll_to_region(Region(0, first, 1, min(count, max(1, self.size.height))), animate=False, force=True)
        self.refresh()
        self.post_message(self.Moved(self))

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        super().watch_scroll_y(old_value, new_value)
        self.post_message(self.Moved(self))

    def choose(self, clicked: bool = False) -> None:
        if self.key:
            self.post_message(self.Chosen(self, self.key, clicked))

    def on_click(self, event: events.Click) -> None:
        line = event.y + round(self.scroll_y)
        if 0 <= line < len(self._rows):
            index = self._rows[line][0]
            if self.items[index].key:
                self._move(index)
                self.choose(clicked=True)

    def on_focus(self) -> None:
        self.refresh()

    def on_blur(self) -> None:
        self.refresh()

    # --- drawing
    def render_line(self, y: int) -> Strip:
        line = y + round(self.scroll_y)
        width = self.room
        style = self.visual_style + Style(dim=True) if self.stale else self.visual_style
        if not 0 <= line < len(self._rows):
            return Strip.blank(width, style.rich_style)
        index, row = self._rows[line]
        here = self.has_focus and index == self.cursor
        if here:
            style += self.get_visual_style("item-list--cursor")
        content = Content(self.app.signs.mark("cursor") if here and line == self._first[index] else " ") + row
        if (selection := self.text_selection) is not None and (span := selection.get_span(line)) is not None:
            start, end = span
            chosen = self.screen.get_visual_style("screen--selection")
            content = content.stylize(chosen, start, len(content) if end == -1 else end)
        strips = content.render_strips(width, 1, style, RenderOptions(self._get_style, cast("RulesMap", self.styles)))
        strip = strips[0] if strips else Strip.blank(width, style.rich_style)
        return strip.adjust_cell_length(width, style.rich_style).apply_offsets(0, line)

    def get_selection(self, selection: Selection) -> tuple[str, str] | None:
        return selection.extract("\n".join(" " + row.plain for _, row in self._rows)), "\n"

    def selection_updated(self, selection: Selection | None) -> None:
        self.refresh()


def _same(some: list[Item], others: list[Item]) -> bool:
    """The same rows in the same styles."""
    return len(some) == len(others) and all(
        a.key == b.key and len(a.rows) == len(b.rows) and all(p.is_same(q) for p, q in zip(a.rows, b.rows))
        for a, b in zip(some, others)
    )
