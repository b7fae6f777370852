# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of a design file, from the descriptions of its inputs: editors complete and check designs by it while
they are written.

It says what one key alone may be; what several say together only `contralbero check` knows.  That of schema 1 is kept
as a file.
"""

import json
from pathlib import Path
from typing import Any

from ..sheet.quantity import Quantity, keys
from .model import SCHEMA, Design

FORMER = {1: Path(__file__).with_name("schema_1.json")}  # as files
DIALECT = "https://json-schema.org/draft-07/schema#"  # the one that the editors of TOML know


def schema_text(number: int = SCHEMA) -> str:
    """The whole of it, of this schema or a former one, as a file."""
    if number in FORMER:
        return FORMER[number].read_text(encoding="utf-8")
    known = {"$schema": DIALECT, "title": "Contralbero design", **_table(Design)}
    return json.dumps(known, ensure_ascii=False, indent=1) + "\n"


def _table(cls: type) -> dict[str, Any]:
    """One table: its keys in their order, no others."""
    known = keys(cls)
    required = [key for key, entry in known.items() if not entry.about.optional]
    definition: dict[str, Any] = {
        "type": "object",
        "additionalProperties": False,
        "properties": {k: _key(entry.about) for k, entry in known.items()},
    }
    return definition | ({"required": required} if required else {})


def _key(about: Quantity) -> dict[str, Any]:
    definition = {"description": _words(about)}
    match about.kind:
        case "number" | "integer":
            return definition | _number(about)
        case "series" | "integers":
            low, high = about.count or (0, None)
            many = {"type": "array", "items": _number(about), "minItems": max(low, 1)} | (
                {"maxItems": high} if high is not None else {}
            )
            # one number is read as a list of one
            return definition | ({"anyOf": [many, _number(about)]} if low <= 1 else many)
        case "names":
            return definition | {"type": "array", "items": {"type": "string"}, "minItems": 1}
        case "choice":
            # 8.8 may stand without quotes
            numbers = [float(choice) for choice in about.choices if choice.replace(".", "", 1).isdigit()]
            return definition | {"enum": [*about.choices, *numbers]}
        case "flag":
            return definition | {"type": "boolean"}
        case "table":
            assert about.table is not None
            return definition | _table(about.table)
        case "tables":
            assert about.table is not None
            return definition | {"type": "array", "items": _table(about.table)}
        case "reasons":
            return definition | {"type": "object", "additionalProperties": {"type": "string", "minLength": 1}}
        case "open":
            return definition | {"type": ["array", "object"]}
        case _:
            return definition | {"type": "string"}  # a date of TOML is one to the editors


def _number(about: Quantity) -> dict[str, Any]:
    definition: dict[str, Any] = {"type": "integer" if about.kind in ("integer", "integers") else "number"}
    for name, bound in (("minimum", about.low), ("maximum", about.high), ("exclusiveMinimum", about.above)):
        if bound is not None:
            definition[name] = bound
    return definition


def _words(about: Quantity) -> str:
    """Label, unit and help, in English, as the form has them."""
    unit = f", {about.unit}" if about.unit else ""
    usual = f" Usual: {about.usual[0]:g} to {about.usual[1]:g}." if about.usual else ""
    help_ = f". {about.help}" if about.help else ""
    return f"{about.label}{unit}{help_}{usual}"
