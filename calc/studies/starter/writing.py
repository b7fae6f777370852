# SPDX-License-Identifier: Apache-2.0
"""The tables of a design to begin with: keys in their order, each with its value and with the rule that it comes
from."""

import json
import math
import tomllib
from collections.abc import Mapping

from ...countershaft.inputs import ShaftInputs
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
    return "".join(f"\n{header}\n{lines(rows)}" for header, rows in sections)


def lines(rows: Rows) -> str:
    """The keys of one table, without its header."""
    return "".join(_line(dotted(key), *row) for key, row in rows.items())


def _line(key: str, value: object, why: str) -> str:
    line = f"{key} = {json.dumps(value, ensure_ascii=False)}"
    return f"{line:<{COLUMN}} # {why}\n" if why else f"{line}\n"


def table(sections: list[Section]) -> Table:
    """As they stand in a document."""
    return tomllib.loads(written(sections))


def changed(sections: list[Section], changes: Mapping[str, object], why: str) -> list[Section]:
    """The same with keys changed of single tables and of elements with a name (`bearings.oil`,
    `shafts.shaft.bearings.front.length_mm`); None takes one out.  What is said of a key stays, else `why` is."""
    new_sections: list[Section] = [(header, _by_key(rows)) for header, rows in sections]
    for key, value in changes.items():
        where, _, field = key.rpartition(".")
        rows = next(rows for header, rows in new_sections if _is_at(header, rows, where))
        if value is None:
            rows.pop(field, None)
        else:
            rows[field] = (value, rows[field][1] if field in rows and rows[field][1] else why)
    return new_sections


def _is_at(header: str, rows: Rows, where: str) -> bool:
    """Whether a section is the table at a key."""
    if not header.startswith("[["):
        return header.strip("[]") == where
    name, _ = rows.get("name", ("", ""))
    return header == BEARING_ROW and where.endswith(f".{dotted(ShaftInputs.bearings)}.{name}")


BEARING_ROW = f"[[{dotted('shafts', ShaftInputs.bearings)}]]"


def parted(sections: list[Section]) -> tuple[list[Section], list[Section]]:
    """The rows of bearings, and all other sections."""
    rows = [section for section in sections if section[0] == BEARING_ROW]
    return rows, [section for section in sections if section[0] != BEARING_ROW]


def completed(sections: list[Section], rows: list[Section]) -> list[Section]:
    """The sections of shafts, with what `rows` say more of their bearings, one after the other."""
    more = iter(rows)
    return [
        (header, _by_key(some) | _by_key(next(more)[1])) if header == BEARING_ROW else (header, some)
        for header, some in sections
    ]


def _by_key(rows: Rows) -> Rows:
    return {dotted(field): row for field, row in rows.items()}


def mm(length: Metre) -> float:
    """In millimetres, without the dust of the conversion."""
    return round(length * 1e3, 6)


def up(x: float, step: float) -> float:
    return math.ceil(x / step - 1e-6) * step


def down(x: float, step: float) -> float:
    return math.floor(x / step + 1e-6) * step
