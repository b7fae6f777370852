# SPDX-License-Identifier: Apache-2.0
"""The tables of a design to begin with: keys in their order, each with its value and with the rule that it comes
from."""

import json
import math
import tomllib
from collections.abc import Mapping

from ...design.addresses import Table
from ...sheet.quantity import described, dotted
from ...sheet.units import Metre

Row = tuple[object, str]  # the value in the unit of its key, and where it comes from; "" where nothing is to be said
Rows = dict[object, Row]  # by declared fields
Section = tuple[str, Rows]  # the header as TOML has it, and its rows
COLUMN = 31  # of the comments


def head(*fields: object) -> str:
    """The header of a table, or of an element of an array, from the declared fields on the way to it."""
    array = described(fields[-1]).kind == "tables"
    return f"[[{dotted(*fields)}]]" if array else f"[{dotted(*fields)}]"


def written(sections: list[Section]) -> str:
    """As they stand in a file, comments from the same column on."""
    return "".join(
        f"\n{header}\n" + "".join(_line(dotted(key), *row) for key, row in rows.items()) for header, rows in sections
    )


def _line(key: str, value: object, why: str) -> str:
    line = f"{key} = {json.dumps(value, ensure_ascii=False)}"
    return f"{line:<{COLUMN}} # {why}\n" if why else f"{line}\n"


def table(sections: list[Section]) -> Table:
    """As they stand in a document."""
    return tomllib.loads(written(sections))


def changed(sections: list[Section], changes: Mapping[str, object], why: str) -> list[Section]:
    """The same with keys of single tables changed (`bearings.front.length_mm`); None takes one out."""
    new_sections: list[Section] = [
        (header, {dotted(field): row for field, row in rows.items()}) for header, rows in sections
    ]
    by_table = {header.strip("[]"): rows for header, rows in new_sections}
    for key, value in changes.items():
        where, _, name = key.rpartition(".")
        if value is None:
            by_table[where].pop(name, None)
        else:
            by_table[where][name] = (value, why)
    return new_sections


def mm(length: Metre) -> float:
    """In millimetres, without the dust of the conversion."""
    return round(length * 1e3, 6)


def up(x: float, step: float) -> float:
    return math.ceil(x / step - 1e-6) * step


def down(x: float, step: float) -> float:
    return math.floor(x / step + 1e-6) * step
