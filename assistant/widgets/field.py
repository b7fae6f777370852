# SPDX-License-Identifier: Apache-2.0
"""One input with its label, unit, note and refusal; and the inputs of several elements side by side."""

import math
import re
from dataclasses import MISSING, dataclass
from typing import Any

from rich.cells import cell_len
from textual.app import ComposeResult
from textual.content import Content
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Input

from calc.bearings.inputs import OF_ROWS
from calc.countershaft.rows import BearingRow
from calc.design.addresses import as_table
from calc.design.labels import Place
from calc.design.names import choice_word
from calc.design.upgrade import is_twin
from calc.locale import Language
from calc.sheet.quantity import Quantity, keys
from calc.sheet.text import EMPTY, Amount, Name, Text

from ..base_app import BaseApp
from ..session import numbers
from ..session.guide import DOCUMENT, NAME, NOTE, idle
from ..session.places import key_at, original_of, owner
from ..session.session import Session
from .entry import AUTO, Choice, Entry
from .pane import short_of_room
from .rows import RADIUS, FormRow, allowed, meaning
from .text import fit, pad, wrap

LABEL, LABEL_NARROW = 22, 30  # cells, as in the style sheet
LABEL_CELLS = 19
CELL = 9  # cells of the box of an input that stands beside others
WORDS_BOX = 20  # cells of a box for words
BOX = {"number": 9, "integer": 9, "series": 16, "integers": 16}
WORD_NARROW = 30
PLAIN = re.compile(r"-?\d*\.?\d*")  # needs no word on how it was understood
NOTHING = "–"  # in a field that says nothing in this design
NARROW = 59  # a form that has at least this many cells is the only pane


class Field(Widget):
    """Draws label and note itself; its one child is where the value is typed or chosen."""

    app: BaseApp

    @dataclass
    class Edited(Message):
        """The user has changed the text."""

        field: "Field"
        text: str

    def __init__(self, row: FormRow, session: Session, words: tuple[str, ...], *, cell: bool = False) -> None:
        super().__init__(classes=f"-{row.about.kind}{' -cell' if cell else ''}")
        self.row = row
        self.cell = cell  # it stands beside others, which have the label and the unit
        self.was = ""  # the text that it had when it got the focus
        self.session = session
        self.words = words or row.about.choices
        self.reason = EMPTY
        self._lacks = False  # it is to be filled in
        self.default = default_of(row, session.decimal)
        self._looks: tuple[object, ...] = ()
        self._box = self._made()

    @property
    def place(self) -> Place:
        return self.row.place

    @property
    def about(self) -> Quantity:
        return self.row.about

    @property
    def box(self) -> Entry | Choice:
        return self._box

    @property
    def text(self) -> str:
        """What the design has to show here."""
        return self.session.text(self.place)

    @property
    def content(self) -> Any:
        return self.session.value(self.place)

    @property
    def editing(self) -> bool:
        """Whether it has been typed into since it got the focus."""
        return isinstance(self.box, Entry) and self.box.editing

    def explained(self) -> tuple[str, str, str]:
        """What the foot of the form says about it."""
        locked, say = self.session.lock_reason(self.place), self.app.say
        brief = short_of_room(self)
        explanation = meaning(self.about, say, brief=brief)
        if locked:
            explanation = f"{say(Text('Locked: {reason}', reason=locked))}. {'' if brief else explanation}".strip()
        text = explanation
        if engine := self._sample():
            still = Text("Still of {engine}, with which this design began: type your own.", engine=Name(engine))
            text = f"{say(still)} {text}"
        return self.about.label, text, allowed(self.about, say)

    def _sample(self) -> str:
        """The engine that the design began with, where this is still its number; empty where it is not."""
        if self.place[:1] != RADIUS[:1]:
            return ""
        name, places = self.session.inherited
        return name if self.place in places else ""

    def _made(self) -> Entry | Choice:
        text, optional = self.text, self.about.optional
        if self.words:
            return Choice(
                self.words, text, optional=optional, prompt=self._chosen_by_program(), named=not self.about.choices
            )
        return Entry(text, self._prompt(), numeric=self.about.kind not in ("text", "names", "open"))

    def _chosen_by_program(self) -> str:
        """What stands where no word is chosen."""
        if self._else():
            return self._prompt()
        if not self.about.optional:
            return self.app.say(Text("choose"))
        default = self.app.say(choice_word(self.default)) if self.about.choices else self.default
        return default if default and self.cell else f"{default} {AUTO}".lstrip()

    def _else(self) -> Text | None:
        """What holds where nothing stands here and it is said elsewhere: what all bearings share, or that of the
        original."""
        if owner(self.place) is not BearingRow:
            return None
        shaft = self.session.value(self.place[:2])
        if is_twin(shaft):
            return Text("as {name}", name=Name(original_of(shaft)))
        return Text("as all") if key_at(self.place) in [entry.key for entry in OF_ROWS] else None

    def _prompt(self) -> str:
        """What stands in an empty field."""
        if (elsewhere := self._else()) is not None:
            return self.app.say(elsewhere)
        # nobody chooses what a title block says
        chosen = self.about.optional and self.place[:1] not in (DOCUMENT, NOTE)
        return self.default or (AUTO if chosen else "" if self.row.required else self.app.say(Text("left out")))

    def _usual(self) -> str:
        """What is usual there, as short as an empty field can show it."""
        low, high = self.about.usual or (0.0, 0.0)
        long = self.app.say(Text("{low}–{high}", low=Amount(low), high=Amount(high)))
        if len(long) < CELL or low % 1000 or high % 1000:
            return long
        return self.app.say(Text("{low}k–{high}k", low=Amount(low / 1000), high=Amount(high / 1000)))

    def compose(self) -> ComposeResult:
        yield self._box

    # --- the user
    def on_input_changed(self, event: Input.Changed) -> None:
        """What is typed is passed on even where it is what the design has: an edit before it may still be on its
        way."""
        event.stop()
        self.enter(event.value)

    def enter(self, typed: str) -> None:
        """What was typed goes into the design."""
        self.post_message(self.Edited(self, self.meant(typed)))

    def meant(self, typed: str) -> str:
        """What goes into the design for what is typed here."""
        return typed

    def on_choice_changed(self, event: Choice.Changed) -> None:
        event.stop()
        self.post_message(self.Edited(self, event.value))

    def on_entry_began(self, event: Entry.Began) -> None:
        event.stop()
        self.redraw()

    def arrive(self) -> None:
        """It has got the focus."""
        self.was = self.text
        self.redraw()

    def restore(self) -> None:
        """Take back what was typed since it got the focus."""
        if isinstance(self.box, Entry):
            self.box.arrive(self.was)
        self.enter(self.was)
        self.redraw()

    def renew(self) -> None:
        """The design was changed elsewhere, by an undo or a remedy: Esc takes back to what it says now."""
        self.was = self.text
        if isinstance(self.box, Entry):
            self.box.arrive(self.was)
        else:
            self.box.show(self.was)
        self.redraw()

    @property
    def stray(self) -> bool:
        """Whether a lone digit stands in place of a longer number: who struck it may have meant a step."""
        typed = self.box.value if isinstance(self.box, Entry) else ""
        return self.editing and len(typed) == 1 and typed.isdigit() and len(self.was) > 1

    def nudge(self, by: int) -> str:
        """One step up or down; gives the new text, or the same where there is no step to make."""
        if isinstance(box := self.box, Choice):
            box.turn(by)
            return ""
        return stepped(self.session, self.place, self.default, by)

    # --- what is shown
    def show(self, reason: Text) -> None:
        """Draw anew, with the reason why the text is not accepted."""
        if (silent := self.cell and idle(self.place, self.session.data)) != self.box.disabled:
            self.box.disabled = silent  # others of its row say something
            if isinstance(self.box, Entry):
                self.box.placeholder = NOTHING if silent else self._prompt()
            else:
                self.box.prompt = NOTHING if silent else self._chosen_by_program()
                self.box.refresh()
        lacks = bool(reason) and self.session.lacks(self.place)
        reason = EMPTY if lacks else reason
        changed = (reason, lacks) != (self.reason, self._lacks)
        self.reason, self._lacks = reason, lacks
        if not self.box.has_focus:
            self.box.show(self.text)
        if changed:
            self.set_class(bool(reason), "-invalid")
            if isinstance(self.box, Entry):  # what is missing is not chosen by the program
                needed = "is missing" in reason or reason.startswith("needed")
                self.box.placeholder = self._usual() if lacks else "" if needed else self._prompt()
            self.refresh(layout=True)
        self.redraw()

    def redraw(self) -> None:
        """Draw anew if there is something new to draw."""
        looks = (self.note(), self.reason, self.box.has_focus, self.editing)
        if looks != self._looks:
            self._looks = looks
            self.refresh()

    def rewrite(self) -> None:
        """The text as it was understood: 3,5 becomes 3.5, and 3.7 in a number of mm."""
        self.box.show(self.text)

    def note(self) -> tuple[str, str]:
        """The note behind the unit, and its state."""
        text, content = self.text, self.content
        if self.reason or content is None:
            return (AUTO, "auto") if not self.reason and self.default and isinstance(self.box, Entry) else ("", "")
        typed = self.box.value if isinstance(self.box, Entry) else text
        if (
            isinstance(self.box, Entry)
            and self.box.has_focus
            and typed.strip() != text
            and not PLAIN.fullmatch(typed.strip())
        ):
            return f"= {text}", "muted"
        if self.editing and self.was and self.was != text:
            return self.app.say(Text("was {text}", text=Name(self.was))), "muted"
        if (usual := self.about.usual) and not all(usual[0] <= number <= usual[1] for number in _numbers(content)):
            return (
                f"{self.app.signs.mark('warn')} "
                f"{self.app.say(Text('{low}–{high}', low=Amount(usual[0]), high=Amount(usual[1])))}",
                "warn",
            )
        if self.session.lock_reason(self.place):
            return self.app.say(Text("locked")), "muted"
        if self._else() is not None:
            return self.app.say(Text("rules here")), "muted"
        if engine := self._sample():
            return self.app.say(Text("from {engine}", engine=Name(engine))), "sample"
        return "", ""

    def _label_width(self) -> int:
        return LABEL_NARROW if self.size.width >= NARROW else LABEL

    def _rows(self, width: int) -> tuple[list[str], list[str]]:
        if self.cell:
            return [""], []
        # a blank before it and one behind
        label = wrap(self.about.label, room := (LABEL_NARROW if width >= NARROW else LABEL) - 2)
        if len(label) > 1 and (brief := self.app.say(self.about.brief)):
            label = wrap(f"{brief[:1].upper()}{brief[1:]}", room)
        mark = self.app.signs.mark("invalid")
        return label, wrap(f"{mark} {self.app.say(self.reason)}", width - 3, 2) if self.reason else []

    def get_content_height(self, container: Any, viewport: Any, width: int) -> int:
        label, error = self._rows(width)
        return len(label) + len(error)

    def render(self) -> Content:
        width = self.size.width
        signs = self.app.signs
        labels, errors = self._rows(width)
        label = self._label_width()
        focused = self.box.has_focus if self.is_mounted else False
        left, right = ("[", "]") if isinstance(self.box, Entry) else (" ", " ")
        if self.cell:
            mark = signs.mark("invalid") if self.reason else signs.mark("editing") if self.editing else left
            style = signs.style("invalid") if self.reason else "bold" if focused else "dim"
            return Content.assemble((mark, style), " " * CELL, (right, "dim"))
        box = BOX.get(self.about.kind, WORDS_BOX)
        if label == LABEL_NARROW and box == WORDS_BOX:
            box = WORD_NARROW
        note, state = self.note()
        room = max(0, width - label - box - 4)
        unit = self.app.say(self.about.unit)
        gap = " " if unit and note else ""
        if state == "sample":  # as much of the name as there is room for
            name = self._sample()
            maker = name.split()[0]
            brief = self.app.say(Text("from {engine}", engine=Name(maker)))
            briefer = f"{signs.mark('from')} {maker}"
            note = next((one for one in (note, brief, briefer) if len(unit) + len(gap) + len(one) <= room), briefer)
        if len(unit) + len(gap) + len(note) > room:
            note = "" if state == "auto" else fit(note, max(0, room - len(unit) - len(gap)))
        first = Content.assemble(
            (pad((signs.mark("editing") if self.editing else " ") + labels[0], label), "bold" if focused else ""),
            (left, "dim"),
            " " * box,
            (right, "dim"),
            " ",
            (unit, "dim"),
            gap,
            (note, "italic dim" if state == "auto" else signs.style("warn") if state == "warn" else "dim"),
        )
        lines = [first, *(Content(" " + text) for text in labels[1:])]
        lines += [Content.styled("  " + text, signs.style("invalid")) for text in errors]
        return Content("\n").join(lines)


class StrokeField(Field):
    """The stroke, which no design file has: its place is that of the crank radius, half of it."""

    @property
    def place(self) -> Place:
        return RADIUS

    @property
    def text(self) -> str:
        radius = self.content
        return (
            super().text
            if self.session.reason(RADIUS) or radius is None
            else numbers.written(float(f"{2 * radius:.12g}"), self.about, self.session.decimal)
        )

    def meant(self, typed: str) -> str:
        try:
            return numbers.written(float(f"{numbers.value(typed, self.about) / 2:.12g}"), self.about)
        except numbers.NotUnderstood:
            return typed


def _numbers(content: object) -> list[int | float]:
    """The numbers that a field holds; what is not one yet is left out."""
    return [
        number for number in (content if isinstance(content, list) else [content]) if isinstance(number, (int, float))
    ]


def default_of(row: FormRow, decimal: str = ".") -> str:
    """What holds where the field is left empty, as it would be written; empty where that depends on the rest."""
    about = row.about
    if not about.optional:
        return ""
    default = keys(owner(row.place))[key_at(row.place)].field.default
    if default is MISSING or default is None or isinstance(default, tuple):
        return ""
    return numbers.written(about.units.shown(default) if about.kind == "number" else default, about, decimal)


def stepped(session: Session, place: Place, default: str, by: int) -> str:
    """The text of a number field one increment further; an increment that nobody gave is about a hundredth of the
    value."""
    about = session.about(place)
    text = session.text(place)
    if about.kind not in ("number", "integer"):
        return text
    content = session.value(place)
    if content is None:
        try:
            content = numbers.value(default, about)
        except numbers.NotUnderstood:
            return text
        if content is None:
            return text
    if about.kind == "integer":
        step = about.step or 1.0
    else:
        step = about.step or _increment(abs(float(content)))
    number = float(f"{content + by * step:.10g}")
    if not about.allows(number):
        return text
    return numbers.written(int(number) if about.kind == "integer" else number, about, session.decimal)


def _increment(size: float) -> float:
    """1, 2 or 5 times a power of ten, near a hundredth of the size."""
    if not size:
        return 1.0
    power = 10.0 ** math.floor(math.log10(size / 100))
    return float(max((n for n in (1, 2, 5, 10) if n * power <= size / 100 * 1.000001), default=1) * power)


# --- inputs of several elements side by side
# The label, a box for each element, the unit, and under them why one is not accepted.

APART = CELL + 2  # with its brackets
UNIT = 5


def side(width: int, unit: int = UNIT) -> int:
    """How many elements fit side by side into a form of so many cells, before a unit that takes so many."""
    return max(1, (width - label_width(width) - unit) // APART)


def sides(width: int) -> tuple[int, int]:
    """The same before any unit, and before one of two letters."""
    return side(width), side(width, 3)


def label_width(width: int) -> int:
    return LABEL_NARROW if width >= NARROW else LABEL_CELLS


class CellColumns(Widget):
    """The names of tables above their cells: of their labels the words that tell them apart."""

    app: BaseApp

    def __init__(self, row: FormRow) -> None:
        super().__init__()
        self.row = row

    def redraw(self, row: FormRow) -> None:
        self.row = row
        self.refresh(layout=True)

    def get_content_height(self, container: Any, viewport: Any, width: int) -> int:
        return len(self.render().split("\n"))

    def render(self) -> Content:
        labels = [str(heading.about.label).split() for heading in self.row.inside]
        common = [word for word in labels[0] if all(word.lower() in map(str.lower, label) for label in labels)]
        known = {word.lower() for word in common}
        names = [" ".join(word for word in label if word.lower() not in known) for label in labels]
        title, width = " ".join(common).capitalize(), label_width(self.size.width)
        columns = [_stacked(name[:1].upper() + name[1:]) for name in names]
        high = max(map(len, columns))
        columns = [[*[""] * (high - len(column)), *column] for column in columns]
        rows = [
            pad(f" {title}" if n == high else "", width) + "".join(f" {part:<{CELL + 1}}" for part in parts)
            for n, parts in enumerate(zip(*columns), 1)
        ]
        return Content.styled("\n".join(rows), "bold")


def _stacked(name: str) -> list[str]:
    """The name of a column of cells, in two rows where one is too short."""
    words = name.split()
    first = next((n for n in range(len(words), 1, -1) if cell_len(" ".join(words[:n])) <= CELL), 1)
    return [fit(" ".join(part), CELL) for part in (words[:first], words[first:]) if part]


class Cells(Widget):
    """Its children are the fields; what belongs to all of them it draws itself."""

    app: BaseApp

    def __init__(self, row: FormRow, fields: list[Field]) -> None:
        super().__init__()
        self.row = row
        self.fields = fields
        # a class: `:first-child` would have every field of the form styled twice
        fields[0].add_class("-first", update=False)
        self._errors: list[tuple[str, Text]] = []

    def compose(self) -> ComposeResult:
        yield from self.fields

    def redraw(self, row: FormRow, reasons: dict[Any, Text]) -> None:
        """Draw anew, and each field with its reason."""
        self.row = row
        errors = []
        for field, cell in zip(self.fields, row.inside):
            field.row = cell
            field.show(reason := reasons.get(field.place, EMPTY))
            if reason:
                of = as_table(field.session.value(field.place[:-1])).get(key_at(NAME), field.place[-2])
                errors.append((f"{of}.{field.place[-1]}", reason))
        if errors != self._errors:
            self._errors = errors
            self.refresh(layout=True)

    def _rows(self, width: int, say: Language) -> tuple[list[str], list[str]]:
        mark = self.app.signs.mark("invalid")
        errors = [row for key, reason in self._errors for row in wrap(f"{mark} {key}: {say(reason)}", width - 3, 2)]
        return wrap(self.row.about.label, label_width(width) - 2), errors

    def get_content_height(self, container: Any, viewport: Any, width: int) -> int:
        labels, errors = self._rows(width, self.app.say)
        return len(labels) + len(errors)

    def render(self) -> Content:
        width = self.size.width
        labels, errors = self._rows(width, self.app.say)
        here = any(field.box.has_focus for field in self.fields if field.is_mounted)
        label = pad(" " + labels[0], label_width(width))
        unit = fit(self.app.say(self.row.about.unit), max(0, width - len(label) - APART * len(self.fields) - 1))
        first = Content.assemble((label, "bold" if here else ""), " " * APART * len(self.fields), " ", (unit, "dim"))
        lines = [first, *(Content(" " + text) for text in labels[1:])]
        lines += [Content.styled("  " + text, self.app.signs.style("invalid")) for text in errors]
        return Content("\n").join(lines)
