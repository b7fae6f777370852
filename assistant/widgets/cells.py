# SPDX-License-Identifier: Apache-2.0
"""Inputs of several elements side by side: the label, a box for each element, the unit, and under them why one is not accepted."""

from typing import Any

from textual.app import ComposeResult
from textual.content import Content
from textual.widget import Widget

from calc.locale import Language
from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from .field import CELL, LABEL_CELLS, LABEL_NARROW, NARROW, Field
from .rows import Row
from .text import fit, pad, wrap

APART = CELL + 2  # with its brackets
UNIT = 5


def side(width: int) -> int:
    """How many elements fit side by side into a form of so many cells."""
    return max(1, (width - label_width(width) - UNIT) // APART)


def label_width(width: int) -> int:
    return LABEL_NARROW if width >= NARROW else LABEL_CELLS


class Columns(Widget):
    """The names of tables above their cells: of their labels the words that tell them apart."""

    app: BaseApp

    def __init__(self, row: Row) -> None:
        super().__init__()
        self.row = row

    def redraw(self, row: Row) -> None:
        self.row = row
        self.refresh()

    def render(self) -> Content:
        labels = [str(heading.about.label).split() for heading in self.row.inside]
        common = [word for word in labels[0] if all(word.lower() in map(str.lower, label) for label in labels)]
        known = {word.lower() for word in common}
        names = [" ".join(word for word in label if word.lower() not in known).capitalize() for label in labels]
        title = " ".join(common).capitalize()
        boxes = "".join(f" {fit(name, CELL):<{CELL + 1}}" for name in names)
        return Content.styled(pad(f" {title}", label_width(self.size.width)) + boxes, "bold")


class Cells(Widget):
    """Its children are the fields; what belongs to all of them it draws itself."""

    app: BaseApp

    def __init__(self, row: Row, fields: list[Field]) -> None:
        super().__init__()
        self.row = row
        self.fields = fields
        fields[0].add_class("-first", update=False)  # a class: `:first-child` would have every field of the form styled twice
        self._errors: list[tuple[str, Text]] = []

    def compose(self) -> ComposeResult:
        yield from self.fields

    def redraw(self, row: Row, reasons: dict[Any, Text]) -> None:
        """Draw anew, and each field with its reason."""
        self.row = row
        errors = []
        for field, cell in zip(self.fields, row.inside):
            field.row = cell
            field.show(reason := reasons.get(field.place, EMPTY))
            if reason:
                errors.append((".".join(map(str, field.place[-2:])), reason))
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
        unit = fit(self.row.about.unit, max(0, width - len(label) - APART * len(self.fields) - 1))
        first = Content.assemble((label, "bold" if here else ""), " " * APART * len(self.fields), " ", (unit, "dim"))
        lines = [first, *(Content(" " + text) for text in labels[1:])]
        lines += [Content.styled("  " + text, self.app.signs.style("invalid")) for text in errors]
        return Content("\n").join(lines)
