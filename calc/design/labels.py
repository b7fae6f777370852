# SPDX-License-Identifier: Apache-2.0
"""What an input is called in the middle of a sentence, by its key: for messages, screens and paper alike."""

from typing import Any

from ..countershaft.inputs import ShaftInputs
from ..gears.inputs import Mesh
from ..library.journal_rules import called
from ..sheet.errors import BadInput
from ..sheet.quantity import dotted
from ..sheet.text import SPACE, Name, Small, Text
from .addresses import Table, address, as_list, as_table, changed, declared, own_shafts, quantity_of, rows_of
from .model import Design
from .upgrade import is_twin

Place = tuple[str | int, ...]  # in the tables of a design: names of keys and indices of arrays

SHAFTS: Place = (dotted(Design.shafts),)
BEARINGS: Place = (dotted(ShaftInputs.bearings),)  # of a shaft


def content_at(data: Table, where: Place) -> Any:
    """What stands at a place, None where there is nothing."""
    here: Any = data
    for part in where:
        if isinstance(part, int):
            here = here[part] if isinstance(here, list) and part < len(here) else None
        else:
            here = here.get(part) if isinstance(here, dict) else None
    return here


def with_bearings(data: Table, where: Place) -> Table:
    """The tables with a row for each bearing of the twin that a place lies in; as they are for any other place."""
    if where[:1] != SHAFTS or where[2:3] != BEARINGS:
        return data
    there = as_list(content_at(data, where[:3]))
    rows = rows_of(data, ".".join(map(str, where[:3])), there)
    return data if len(rows) == len(there) else changed(data, where[:3], rows)


def _name(element: Table) -> str:
    """Of an element that has one, and of a mesh by its wheels."""
    wheels = [element.get(key) for key in (dotted(Mesh.driver), dotted(Mesh.driven))]
    return str(element.get("name") or ("–".join(map(str, wheels)) if all(wheels) else ""))


def label_of(data: Table, key: str) -> Text:
    """What the input of a dotted key is called, in the middle of a sentence; and of what, where it is one of
    several."""
    try:
        words, where = Small(quantity_of(data, key).label), address(data, key)
    except BadInput:  # the key of a table, or of an element that is not there
        about = declared(key.split("."))
        if about is not None:
            return Small(about.label)
        return Name(key.rpartition(".")[2].replace("_", " "))
    numbered = next((n for n in range(len(where) - 1, 0, -1) if isinstance(where[n], int)), None)
    if numbered is None or (where[:numbered] == (dotted(Design.shafts),) and len(own_shafts(data)) == 1):
        return words
    several = where[:1] == SHAFTS and numbered > 1
    several &= len(own_shafts(data)) > 1 or is_twin(as_table(content_at(data, where[:2])))
    ways = [where[:2], where[: numbered + 1]] if several else [where[: numbered + 1]]
    elements = [content_at(with_bearings(data, where), way) for way in ways]
    names = [_name(as_table(element)) or str(int(way[-1]) + 1) for way, element in zip(ways, elements)]
    return Text("{label} of {place}", label=words, place=SPACE.join(map(called, names)))
