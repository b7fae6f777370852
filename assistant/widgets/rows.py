# SPDX-License-Identifier: Apache-2.0
"""The rows of a form, read from the descriptions of the inputs; nothing here knows a screen.

A table that may be left out has fields only where it is there.
A short array of tables stands there whole.  Of a long one only one element does, and its heading leafs through them.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from calc.addresses import Table
from calc.sheet.quantity import Quantity, keys
from calc.sheet.step import Step
from calc.sheet.text import Text

from ..places import Place

FURTHER = Quantity("table", Text("Further"))
MOST = 12  # fields that an array of tables may have before it is shown one element at a time


@dataclass(frozen=True)
class Row:
    """`kind`: heading (of a sub-table, or of one element), option (heading of a sub-table that may be left out), array (heading of an
    array of tables) or field."""

    kind: str
    place: Place
    about: Quantity
    required: bool = False  # must be there because its table is
    shown: int | None = None  # of an array that is shown one element at a time: which


def rows(step: Step, data: Table, chosen: Mapping[Place, int], held: Sequence[Place] = ()) -> list[Row]:
    """All rows of a step's form.  `chosen`: which element of a long array is shown.  `held`: fields that stay although their table is
    not there: the one that is being edited and has just been emptied, and those in which something is not accepted."""
    return list(_rows(step.inputs, data.get(step.key, {}), (step.key,), chosen, held, True))


def _rows(cls: type, data: Any, place: Place, chosen: Mapping[Place, int], held: Sequence[Place], there: bool) -> Iterator[Row]:
    behind = False  # a table: what follows is the step's own again
    for key, known in keys(cls).items():
        about, here = known.about, (*place, key)
        content = data.get(key) if isinstance(data, dict) else None
        if about.kind not in ("table", "tables") and behind:
            yield Row("heading", place, FURTHER)
        behind = about.kind in ("table", "tables")
        if about.kind == "table":
            yield from _table(about, content, here, chosen, held, there)
        elif about.kind == "tables":
            yield from _array(about, content or [], here, chosen, held)
        else:
            yield Row("field", here, about, required=there and not about.optional)


def _table(about: Quantity, content: Any, here: Place, chosen: Mapping[Place, int], held: Sequence[Place], there: bool) -> Iterator[Row]:
    assert about.table is not None
    yield Row("option" if about.optional else "heading", here, about)
    if content is not None or not about.optional or any(here == place[: len(here)] for place in held):
        yield from _rows(about.table, content or {}, here, chosen, held, content is not None or (there and not about.optional))


def _array(about: Quantity, content: list[Any], here: Place, chosen: Mapping[Place, int], held: Sequence[Place]) -> Iterator[Row]:
    assert about.table is not None
    long = len(content) > 1 and len(content) * len(keys(about.table)) > MOST
    shown = min(chosen.get(here, 0), len(content) - 1) if long else None
    yield Row("array", here, about, shown=shown)
    for i, item in enumerate(content):
        if shown is None or i == shown:
            if not long:
                yield Row("heading", (*here, i), about)
            yield from _rows(about.table, item, (*here, i), chosen, held, True)
