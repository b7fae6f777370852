# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of a design file, from the descriptions of its inputs: editors complete and check designs by it while
they are written.

It says what one key alone may be; what several say together only `contralbero check` knows.  That of schema 1 is kept
as a file.
"""

import json
from dataclasses import MISSING
from functools import cache
from pathlib import Path
from typing import Any

from ..sheet.quantity import Key, Quantity, keys
from .model import SCHEMA, Design

FORMER = {1: Path(__file__).with_name("schema_1.json")}  # as files
DIALECT = "http://json-schema.org/draft-07/schema#"  # the one that the editors of TOML know, by its only name
OWN = ("oils", "materials", "strength_classes")  # catalogues beside which a design may name others
DIGITS = 12  # of a default: what it has more comes of its unit


def schema_text(number: int = SCHEMA) -> str:
    """The whole of it, of this schema or a former one, as a file."""
    if number in FORMER:
        return FORMER[number].read_text(encoding="utf-8")
    about = {"$schema": DIALECT, "$id": f"urn:contralbero:design:{number}", "title": "Contralbero design"}
    known = about | _table(Design)
    return json.dumps(known, ensure_ascii=False, indent=1) + "\n"


def _table(cls: type) -> dict[str, Any]:
    """One table: its keys in their order, no others."""
    known = keys(cls)
    required = [key for key, entry in known.items() if not entry.about.optional]
    definition: dict[str, Any] = {
        "type": "object",
        "additionalProperties": False,
        "properties": {k: _key(entry.about) | _default(entry) for k, entry in known.items()},
    }
    return definition | ({"required": required} if required else {})


def _default(entry: Key) -> dict[str, Any]:
    """What stands for a key that is left out, in its unit; nothing where the program chooses."""
    value, kind = entry.field.default, entry.about.kind
    if value is MISSING or value is None or value in ("", ()):
        return {}
    if kind == "number":
        value = _shown(entry.about, value)
    elif kind in ("series", "integers", "names"):
        value = [_shown(entry.about, x) if kind == "series" else x for x in value]
    return {"default": value}


def _shown(about: Quantity, x: float) -> float:
    return float(f"{about.units.shown(x):.{DIGITS}g}")


@cache
def _shipped() -> Design:
    """A design that brings no oil and no material of its own."""
    return Design(schema=SCHEMA, name="")


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
            listed: dict[str, Any] = {"type": "array", "items": {"type": "string"}, "minItems": 1}
            if about.count is None:
                return definition | listed
            return definition | {"anyOf": [{"type": "string"}, listed | {"maxItems": about.count[1]}]}
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
            return definition | {"anyOf": [{"type": "array"}, {"type": "object"}]}
        case "text" if about.catalogue:
            names = {"enum": list(getattr(_shipped(), about.catalogue))}
            return definition | ({"anyOf": [names, {"type": "string"}]} if about.catalogue in OWN else names)
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
