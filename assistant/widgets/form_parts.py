# SPDX-License-Identifier: Apache-2.0
"""What the form of a step consists of, in order: its question, then a widget for each row of its inputs."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from textual.content import Content
from textual.widget import Widget
from textual.widgets import Static

from calc.locale import Language
from calc.languages.outcome import in_language
from calc.sheet.step import Step

from ..session.places import Place, content_at, key_at
from ..session.route import fold_at
from ..session.session import Session
from ..upstream import NAMED
from .headings import ArrayHeading
from .cells import Cells, Columns
from .field import Field, StrokeField
from .fold import Fold
from .guide_text import GuideText
from .radio import Balance, Todo
from .rows import Asked, Row, routed
from .table_heading import TableHeading
from .upstream_values import Taken

Identity = tuple[object, ...]  # of a widget: kind and place of its row
Part = tuple[Identity, Callable[[], Widget]]  # what tells a part from all others, and how it is made


class FormParts:
    def __init__(self, step: Step, session: Session, say: Language) -> None:
        self._step, self._session, self._say = step, session, say

    @property
    def there(self) -> bool:
        """Whether the design has the step."""
        return self._step.key in self._session.data

    def parts(self, rows: list[Row]) -> list[Part]:
        """Of these rows of inputs, and of what stands before and behind them."""
        key, session = self._step.key, self._session
        parts: list[Part] = [(("guide",), lambda: GuideText(session, key))]
        if key == "imbalance" and "engine" in session.data:
            parts.append((("balance",), lambda: Balance(session, key)))
        elif not self.there:
            parts.append((("todo",), lambda: Todo(session, key)))
        if self.there:
            parts += [(identity(row), partial(self._widget, row)) for row in rows]
            parts.append((("taken",), lambda: Taken(session, key)))
        return parts

    def rows(self, asked: Asked, opened: set[int]) -> list[Row]:
        """The inputs of the step, in the user's language; none where the design does not have it."""
        if not self.there:
            return []
        rows = routed(self._step, self._session.data, asked, opened)
        return rows if self._say.code == "en" else [_said(row, self._say) for row in rows]

    def fold(self, place: Place) -> int | None:
        """The fold that a place lies in."""
        return fold_at(self._step.key, place)

    def heading(self, row: Row) -> Content:
        last = row.place[-1]
        name = str((content_at(self._session.data, row.place) or {}).get("name", last + 1)) if isinstance(last, int) else row.about.label
        return Content.styled(f" {name}", "bold" if not isinstance(last, int) else "italic")

    def _widget(self, row: Row) -> Widget:
        session = self._session
        match row.kind:
            case "field":
                return Field(row, session, self._words(row))
            case "stroke":
                return StrokeField(row, session, ())
            case "cells":
                return Cells(row, [Field(cell, session, self._words(cell), cell=True) for cell in row.inside])
            case "columns":
                return Columns(row)
            case "array":
                return ArrayHeading(row, session)
            case "option":
                return TableHeading(row, session)
            case "fold":
                return Fold(row, session)
            case _:
                return Static(self.heading(row), classes="heading")

    def _words(self, row: Row) -> tuple[str, ...]:
        """The names that a field of a catalogue may hold."""
        catalogue = NAMED.get(key_at(row.place)) if row.about.kind == "text" else None
        return tuple(getattr(self._session.design, catalogue)) if catalogue else ()


def identity(row: Row) -> Identity:
    return (row.kind, row.place, len(row.inside)) if row.kind == "cells" else (row.kind, row.place)


def _said(row: Row, say: Language) -> Row:
    """A row with its words in the user's language."""
    return replace(row, about=in_language(row.about, say), inside=tuple(_said(one, say) for one in row.inside))
