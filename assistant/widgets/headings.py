# SPDX-License-Identifier: Apache-2.0
"""The headings inside a form: of an array of tables, of a table that may be left out, of what is folded.

That of an array says how many there are, which one is shown, and the keys that add, remove and leaf."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.geometry import Size
from textual.message import Message
from textual.style import Style
from textual.widget import Widget

from calc.countershaft.inputs import ShaftInputs
from calc.design.labels import BEARINGS, SHAFTS, content_at, with_bearings
from calc.design.upgrade import is_twin
from calc.sheet.number import short
from calc.sheet.quantity import dotted, keys
from calc.sheet.text import EMPTY, Name, Text

from ..actions import bound
from ..base_app import BaseApp
from ..session.guide import DOCUMENT, NOTE
from ..session.places import NAME, original_of, twin_words
from ..session.session import Session
from .entry import LEAVING
from .pane import short_of_room
from .rows import ALL, FormRow, heading_help
from .text import fit, pad

TALL = 30  # rows of a screen that has room for a table of the elements
MOST = 8  # elements in it
# cells before its rows, between its columns, and of a label that is wider than what is below it
INDENT, GAP, LABEL = (3, 2, 12)
SHAFT_NAME = 8  # cells of a shaft's name in their list
RATIO = dotted(ShaftInputs.speed_ratio)


def keyed(app: BaseApp, words: Text, **more: str) -> Text:
    """What a heading does, with its keys."""
    return Text(words.template, add=app.shown_key("add"), remove=app.shown_key("leave_out"), **more)


class ArrayHeading(Widget, can_focus=True):
    """`◂ 2/4 central ▸` of a long array, over a table of what its elements must have; `2` of a short one that
    stands there whole."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("left", "leaf(-1)", "Element before", show=False),
        Binding("right,space", "leaf(1)", "Next element", show=False),
        bound("add", "add"),
        bound("leave_out", "remove"),
        Binding("delete", "remove", "Remove the element", show=False),
    ]
    HELP = Text(
        "{add} (or Enter, while there is none) adds an element, like the last one; {remove} takes out the one that is "
        "shown (the last of a short list); ← → leafs through them."
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

    def __init__(self, row: FormRow, session: Session) -> None:
        super().__init__(classes="-first" if row.place == SHAFTS else "")
        self.row = row
        self.session = session
        self.reason = EMPTY  # why the array as a whole is not accepted
        self._looks: tuple[object, ...] = ()
        self._rows = 0  # of its table, when last looked at

    def redraw(self, row: FormRow, reason: Text) -> None:
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
        return [str(item.get("name", n + 1)) for n, item in enumerate(self._elements())]

    def _elements(self) -> list[dict[str, object]]:
        return content_at(with_bearings(self.session.data, self.row.place), self.row.place) or []

    def items(self) -> list[dict[str, object]]:
        """The elements of the table; none where they stand in the form themselves, or there is no room."""
        items = self._elements()
        return items if self.row.shown is not None and len(items) <= MOST and self.app.size.height >= TALL else []

    def cells(self) -> list[tuple[str, ...]]:
        """Their names, and what each must have beside it, below the labels."""
        shaft = content_at(self.session.data, self.row.place[:2]) or {}  # none: it is just being taken away
        if self.row.place[2:] == BEARINGS and is_twin(shaft):
            elsewhere = self.app.say(Text("as {name}", name=Name(original_of(shaft))))
            said = [elsewhere if set(item) == {NAME} else self.app.say(Text("rules here")) for item in self.items()]
            return [("", ""), *zip(self.names(), said)] if said else []
        assert self.row.about.table is not None
        known = {key: field.about for key, field in keys(self.row.about.table).items()}
        columns = [
            key
            for key, about in known.items()
            if not about.optional and about.kind not in ("table", "tables") and key != "name"
        ]
        items = self.items()
        words_alone = all(isinstance(item.get(key), str) for item in items for key in columns)
        if not items or not columns or (words_alone and short_of_room(self)):
            return []  # of words alone those of the element in view stand in its fields
        labels = [_headed(self.app.say(known[key].label), self.app.say(known[key].unit)) for key in columns]
        return [
            ("", *labels),
            *((name, *(self._written(item.get(key)) for key in columns)) for name, item in zip(self.names(), items)),
        ]

    def _written(self, value: object) -> str:
        if isinstance(value, (list, tuple)):
            return " ".join(map(self._written, value))
        return (
            self.app.say.number(f"{value:g}".replace("-", "−")) if isinstance(value, (int, float)) else str(value or "")
        )

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
        return heading_help(self.row.about, self.does(), self.reason, self.app)

    def does(self) -> Text:
        """What its keys do."""
        return keyed(self.app, self.HELP)

    def render(self) -> Content:
        names = self.names()
        shown = self.row.shown
        signs = self.app.signs
        before, after, minus = ("<", ">", "-") if signs.ascii else ("◂", "▸", "−")
        title = f"{signs.mark('invalid')} {self.row.about.label}" if self.reason else self.row.about.label
        if shown is None or shown >= len(names):
            middle: list[Content | str | tuple[str, str]] = [(f"  {len(names)}", "dim")]
        else:
            name = "" if self.cells() else str(self._elements()[shown].get("name", ""))  # which the table marks
            text = f" {shown + 1}/{len(names)} {name} " if name else f" {shown + 1}/{len(names)} "
            middle = [
                "  ",
                self._link(before, "leaf(-1)"),
                fit(text, max(8, self.size.width - len(title) - 10)),  # beside blanks, arrows and buttons
                self._link(after, "leaf(1)"),
            ]
        buttons: list[Content | str] = []
        if self.row.kind == "array":
            buttons = [self._link("+", "add"), " ", self._link(minus, "remove")]
        if not names:
            buttons = [self._link(self.app.say(Text("+ add")), "add")]
        left = Content.assemble((" " + title, signs.style("invalid") if self.reason else "bold"), *middle)
        gap = max(1, self.size.width - left.cell_length - Content.assemble(*buttons).cell_length - 1)
        return Content("\n").join([Content.assemble(left, " " * gap, *buttons), *self._table()])

    def _link(self, text: str, action: str) -> Content:
        return self._clicked(Content.styled(text, "bold" if self.has_focus else "dim"), action)

    def _clicked(self, content: Content, action: str) -> Content:
        return content.stylize(Style.from_meta({"@click": action}))

    def action_leaf(self, by: int) -> None:
        if self.row.shown is not None and (count := len(self.names())):
            self.action_show((self.row.shown + by) % count)

    def action_show(self, index: int) -> None:
        self.row = replace(self.row, shown=index)  # the next key, of which it is, may come before the form does
        self.post_message(self.Leafed(self, index))

    def action_add(self) -> None:
        if self.row.kind == "array":
            self.post_message(self.Added(self))

    def action_remove(self) -> None:
        if self.row.kind == "array" and (count := len(self.names())):
            self.post_message(self.Removed(self, count - 1 if self.row.shown is None else self.row.shown))

    def on_focus(self, event: events.Focus) -> None:
        self.refresh()

    def on_blur(self, event: events.Blur) -> None:
        self.refresh()


def _headed(label: str, unit: str) -> str:
    """The head of a column: where it is too long, the unit stays."""
    return f"{fit(label, max(4, LABEL - len(unit) - 1))} {unit}" if unit else label


class ShaftsHeading(ArrayHeading):
    """That of the shafts: what each is, and what it gives.  Where another step asks for them, one row that leafs."""

    HELP = Text(
        "{add} adds a shaft: the mirror image of the one in view, the same once more, or one of its own; {remove} "
        "takes out the one in view, an original with its twins. ← → leaf here, {keys} everywhere in steps 3 to 5."
    )
    LEAFS = Text("← → leaf here, {keys} everywhere in steps 3 to 5. Step 3 adds shafts and takes them out.")

    def does(self) -> Text:
        app, words = self.app, self.HELP if self.row.kind == "array" else self.LEAFS
        return keyed(app, words, keys=f"{app.shown_key('shaft_back')} {app.shown_key('shaft_on')}")

    def cells(self) -> list[tuple[str, ...]]:
        """Name; ratio, or whose twin; couple, force and mass, but for what is nought in all."""
        if self.row.shown is None or self.row.kind != "array":
            return []
        say, shafts = self.app.say, content_at(self.session.data, SHAFTS) or []
        rows: list[tuple[str, ...]] = [("", "")]
        for name, shaft in zip(self.names(), shafts):
            ratio = f"{shaft.get(RATIO) or 0:+g}".replace("-", "−")
            rows.append((fit(name, SHAFT_NAME), say(twin_words(shaft)) or ratio))
        for label, unit, column in self._given(shafts):
            words = [f"{say(label)} {say(unit)}", *(say.number(short(x)) for x in column)]
            rows = [(*row, word.rjust(max(map(len, words)))) for row, word in zip(rows, words)]
        return rows

    def _given(self, shafts: list[dict[str, object]]) -> Iterator[tuple[Text, str, list[float]]]:
        """What each gives, where it is solved: label, unit, numbers; a twin has the mass of its original."""
        values = self.session.values()
        if not values:
            return
        from calc.countershaft.result import CountershaftResult  # with numpy

        for label, field in (
            (Text("Couple"), CountershaftResult.couple),
            (Text("Force"), CountershaftResult.force),
            (Text("Mass"), CountershaftResult.mass),
        ):
            ids = [
                (dotted("countershaft", name, field), dotted("countershaft", original_of(shaft), field))
                for name, shaft in zip(self.names(), shafts)
            ]
            there = [value for own, its in ids if (value := values.get(own) or values.get(its)) is not None]
            if len(there) == len(shafts) and any(value.shown for value in there):
                yield label, there[0].unit, [value.shown for value in there]


# --- the heading of a table that may be left out
# `Gas  + add` where it is not there, `Gas  −` above its fields where it is.


class TableHeading(Widget, can_focus=True):
    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        bound("add", "add"),
        bound("leave_out", "remove"),
        Binding("delete", "remove", "Remove the table", show=False),
    ]
    ADDS = Text("This part may be left out. {add} or Enter adds it, its fields empty; undo takes it back.")
    REMOVES = Text("This part may be left out. {remove} takes it out with all its fields; undo brings them back.")

    @dataclass
    class Added(Message):
        heading: "TableHeading"

    @dataclass
    class Removed(Message):
        heading: "TableHeading"

    def __init__(self, row: FormRow, session: Session) -> None:
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

    def redraw(self, row: FormRow, reason: Text) -> None:
        looks = (self.there, reason, row.about.label)
        self.row = row
        self.reason = reason
        if looks != self._looks:
            self._looks = looks
            self.refresh()

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        return heading_help(self.row.about, self.does(), self.reason, self.app)

    def does(self) -> Text:
        """What its keys do now."""
        return keyed(self.app, self.ADDS if self.adds else self.REMOVES)

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


# --- the heading of what is folded
# `▸ More (18): cylinder offset, firing order, …`.  Enter or → opens it, ← closes it.


class Fold(Widget, can_focus=True):
    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *LEAVING,
        Binding("enter,space", "turn", "Open or close", show=False),
        Binding("right", "turn(True)", "Open", show=False),
        Binding("left", "turn(False)", "Close", show=False),
    ]
    OPENS = Text("Enter or → opens it. What is left empty in it, the program assumes.")
    CLOSES = Text("Enter or ← closes it. What is left empty in it, the program assumes.")

    @dataclass
    class Turned(Message):
        fold: "Fold"
        open: bool

    def __init__(self, row: FormRow, session: Session) -> None:
        super().__init__(classes="" if row.place[-1] in ("+0", f"+{ALL}") else "-further")
        self.row = row
        self.session = session
        self._looks: tuple[object, ...] = ()

    def redraw(self, row: FormRow) -> None:
        self.row = row
        looks = (row.open, self._title(), row.inside)
        if looks != self._looks:
            self._looks = looks
            self.refresh()

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        does = self.app.say(self.CLOSES if self.row.open else self.OPENS)
        names = self.app.say(self.row.about.help) or ", ".join(self._names())
        return str(self.row.about.label), f"{does} {names}."

    def _title(self) -> str:
        """How many inputs lie in it, and how many of them are left to the program."""
        cells = (
            cell
            for row in self.row.inside
            for cell in (row.inside or (row,))
            if cell.kind == "field" and cell.place[:1] not in (DOCUMENT, NOTE)
        )
        assumed = sum(cell.about.optional and content_at(self.session.data, cell.place) is None for cell in cells)
        title = f"{self.row.about.label} ({len(self.row.inside)})"
        return f"{title}, {self.app.say(Text('assumed ({n})', n=assumed))}" if assumed and self.row.open else title

    def _names(self) -> list[str]:
        names = [
            str(row.about.label) for row in self.row.inside if len(row.place) == 2 or row.kind in ("field", "cells")
        ]
        return [name if name[1:2].isupper() else name[:1].lower() + name[1:] for name in dict.fromkeys(names)]

    def render(self) -> Content:
        mark = self.app.signs.mark("unfolded" if self.row.open else "folded")
        return Content.styled(fit(f" {mark} {self._title()}", self.size.width), "bold")

    def action_turn(self, open: bool | None = None) -> None:
        wanted = not self.row.open if open is None else open
        if wanted != self.row.open:
            self.post_message(self.Turned(self, wanted))

    def on_click(self, event: events.Click) -> None:
        event.stop()
        self.focus()
        self.action_turn()

    def on_focus(self, event: events.Focus) -> None:
        self.refresh()

    def on_blur(self, event: events.Blur) -> None:
        self.refresh()
