# SPDX-License-Identifier: Apache-2.0
"""Places in the tables of a design: names of keys and indices of arrays, which hold while an element is being
renamed."""

from typing import Any

from calc.design.addresses import Table, address, changed, declared, quantity_of
from calc.design.model import Design
from calc.sheet.errors import BadInput
from calc.sheet.quantity import Quantity, keys
from calc.sheet.text import Name, Small, Text

Place = tuple[str | int, ...]


def content_at(data: Table, where: Place) -> Any:
    """What stands at a place, None where there is nothing."""
    here: Any = data
    for part in where:
        if isinstance(part, int):
            here = here[part] if isinstance(here, list) and part < len(here) else None
        else:
            here = here.get(part) if isinstance(here, dict) else None
    return here


def described(where: Place) -> Quantity:
    """The description of the quantity at a place."""
    cls: type = Design
    about: Quantity | None = None
    for part in where:
        if isinstance(part, str):
            about = keys(cls)[part].about
            cls = about.table or cls
    if about is None:
        raise KeyError(where)
    return about


def without_empty(data: Table, where: Place) -> Table:
    """A table that may be left out and has lost its last key is left out."""
    while (outer := optional_table(where)) is not None and content_at(data, outer) in ({}, None):
        data = changed(data, outer, None)
        where = outer
    return data


def optional_table(where: Place) -> Place | None:
    """The innermost table around a place, inside its step, that may be left out."""
    for end in range(len(where) - 1, 1, -1):
        if (
            isinstance(where[end - 1], str)
            and described(where[:end]).kind == "table"
            and described(where[:end]).optional
        ):
            return where[:end]
    return None


def error_place(data: Any, key: str) -> Place:
    """The place that an error names; elements of arrays by index."""
    place: list[str | int] = []
    here = data
    for part in key.split(".") if key else ():
        if isinstance(here, list) and part.isdigit():
            place.append(int(part))
            here = here[int(part)] if int(part) < len(here) else {}
        else:
            place.append(part)
            here = here.get(part, {}) if isinstance(here, dict) else {}
    return tuple(place)


def key_at(where: Place) -> str:
    """A place as its last key: what the design file calls it."""
    return str(where[-1]) if where else ""


def named_key(data: Table, where: Place) -> str:
    """A place as a dotted key, in which elements of arrays go by their names where they have one."""
    parts: list[str] = []
    here: Any = data
    for part in where:
        here = content_at(here, (part,))
        name = here.get("name") if isinstance(part, int) and isinstance(here, dict) else None
        parts.append(name if isinstance(name, str) and name else str(part))
    return ".".join(parts)


def first_key(where: Place) -> str:
    """The first key of a table, or of an element of an array of tables."""
    return next(iter(keys(described(where).table)), "")


def owner(where: Place) -> type:
    """The Inputs class that the last key of a place belongs to."""
    cls: type = Design
    for part in where[:-1]:
        if isinstance(part, str):
            cls = keys(cls)[part].about.table or cls
    return cls


def label_of(data: Table, key: str) -> Text:
    """What the form calls the input of a dotted key, in the middle of a sentence; and of what, where it is one of
    several."""
    try:
        words, where = Small(quantity_of(data, key).label), address(data, key)
    except BadInput:  # the key of a table, or of an element that is not there
        about = declared(key.split("."))
        if about is not None and about.table is None:
            return Small(about.label)
        return Name(key.rpartition(".")[2].replace("_", " "))
    numbered = next((n for n in range(len(where) - 1, 0, -1) if isinstance(where[n], int)), None)
    if numbered is None:
        return words
    element = content_at(data, where[: numbered + 1])
    name = element.get("name") if isinstance(element, dict) else None
    return Text("{label} of {place}", label=words, place=str(name or int(where[numbered]) + 1))
