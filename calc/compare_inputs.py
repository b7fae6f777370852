# SPDX-License-Identifier: Apache-2.0
"""The inputs that differ between two design files, key by key."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TypeVar

from .design.addresses import Table, as_list, as_table
from .design.model import Design
from .sheet.quantity import Quantity, keys
from .sheet.text import Text

LAST = (  # stand behind what is calculated with
    "accepted", "without", "locked", "oil", "material", "schema", "name", "note", "author", "checker", "revision", "date", "document",
)  # fmt: skip
T = TypeVar("T")


@dataclass(frozen=True)
class InputDifference:
    """One key, as the two files have it; None: left out.  A table that only one of them has is one difference, and so is an element."""

    key: str  # elements of arrays by name, else by index, as everywhere
    label: Text
    unit: str
    a: object
    b: object
    within: str = ""  # what the element is called that the key has by its index: a mesh by its wheels

    @property
    def step(self) -> str:
        return self.key.partition(".")[0]


def inputs(a: Table, b: Table) -> list[InputDifference]:
    """The keys that differ between the tables of two design files: the steps in their order, then what only names or explains."""
    found = list(_keys(Design, a, b, ""))
    return sorted(found, key=lambda d: LAST.index(d.step) + 1 if d.step in LAST else 0)


def _keys(cls: type, a: Table, b: Table, prefix: str, within: str = "") -> Iterator[InputDifference]:
    for key, known in keys(cls).items():
        about, mine, theirs = known.about, a.get(key), b.get(key)
        if mine is theirs or mine == theirs:
            continue
        here = f"{prefix}{key}"
        if about.kind == "tables":
            yield from _elements(about, as_list(mine), as_list(theirs), here, within)
        elif about.kind == "reasons":
            one, other = as_table(mine), as_table(theirs)
            for id in one | other:
                if one.get(id) != other.get(id):
                    yield InputDifference(f"{here}.{id}", about.label, "", one.get(id), other.get(id))
        elif about.kind == "table" and mine is not None and theirs is not None:
            assert about.table is not None
            yield from _keys(about.table, as_table(mine), as_table(theirs), f"{here}.", within)
        elif _plain(about, mine) != _plain(about, theirs):
            yield InputDifference(here, about.label, about.unit, mine, theirs, within)


def _plain(about: Quantity, content: object) -> object:
    """One number stands for a list of one, and a choice may look like a number."""
    if content is None:
        return None
    if about.kind in ("series", "integers"):
        return as_list(content)
    return str(content) if about.kind in ("choice", "date") else content


def _elements(about: Quantity, a: list[object], b: list[object], here: str, within: str) -> Iterator[InputDifference]:
    """The elements of two arrays of tables, matched by name, else by index."""
    assert about.table is not None
    if not a or not b:
        if a or b:
            yield InputDifference(here, about.label, "", a or None, b or None, within)
        return
    mine, theirs = _named(a), _named(b)
    for name in united(mine, theirs):
        one, other = mine.get(name), theirs.get(name)
        if one is not None and other is not None:
            yield from _keys(about.table, one, other, f"{here}.{name}.", _called(one) if _called(one) == _called(other) else "")
        else:
            yield InputDifference(f"{here}.{name}", Text("{label}: {name}", label=about.label, name=name), "", one, other, within)


def _named(items: list[object]) -> dict[str, Table]:
    return {str(item.get("name", n)): item for n, item in enumerate(map(as_table, items))}


def _called(item: Table) -> str:
    """What an element without a name is known by: a mesh by its wheels, in the direction of power."""
    return f"{item['driver']}–{item['driven']}" if {"driver", "driven"} <= item.keys() else ""


def united(a: Iterable[T], b: Iterable[T]) -> list[T]:
    """What is in either, in an order that does not depend on which comes first."""
    first, second = list(a), list(b)
    shared = set(first) & set(second)
    rest = [x for x in (*first, *second) if x not in shared]
    return [*(x for x in first if x in shared), *sorted(rest, key=str)]
