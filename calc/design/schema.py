# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of a design file, from the descriptions of its inputs: editors complete and check designs by it while
they are written.

It says what one key alone may be; what several say together only `contralbero check` knows.
"""

from typing import Any

from ..sheet.quantity import Quantity, keys
from .model import Design

DIALECT = "https://json-schema.org/draft-07/schema#"  # the one that the editors of TOML know


def schema() -> dict[str, Any]:
    """The whole of it."""
    return {"$schema": DIALECT, "title": "Contralbero design", **_table(Design)}


def _table(cls: type) -> dict[str, Any]:
    """One table: its keys in their order, no others."""
    known = keys(cls)
    required = [key for key, one in known.items() if not one.about.optional]
    made: dict[str, Any] = {
        "type": "object",
        "additionalProperties": False,
        "properties": {k: _key(one.about) for k, one in known.items()},
    }
    return made | ({"required": required} if required else {})


def _key(about: Quantity) -> dict[str, Any]:
    said = {"description": _words(about)}
    match about.kind:
        case "number" | "integer":
            return said | _number(about)
        case "series" | "integers":
            low, high = about.count or (0, None)
            many = {"type": "array", "items": _number(about), "minItems": max(low, 1)} | (
                {"maxItems": high} if high is not None else {}
            )
            return said | (
                {"anyOf": [many, _number(about)]} if low <= 1 else many
            )  # one number is read as a list of one
        case "choice":
            numbers = [
                float(one) for one in about.choices if one.replace(".", "", 1).isdigit()
            ]  # 8.8 may stand without quotes
            return said | {"enum": [*about.choices, *numbers]}
        case "table":
            assert about.table is not None
            return said | _table(about.table)
        case "tables":
            assert about.table is not None
            return said | {"type": "array", "items": _table(about.table)}
        case "reasons":
            return said | {"type": "object", "additionalProperties": {"type": "string", "minLength": 1}}
        case "open":
            return said | {"type": ["array", "object"]}
        case _:
            return said | {"type": "string"}  # a date of TOML is one to the editors


def _number(about: Quantity) -> dict[str, Any]:
    made: dict[str, Any] = {"type": "integer" if about.kind in ("integer", "integers") else "number"}
    for name, bound in (("minimum", about.low), ("maximum", about.high), ("exclusiveMinimum", about.above)):
        if bound is not None:
            made[name] = bound
    return made


def _words(about: Quantity) -> str:
    """Label, unit and help, in English, as the form has them."""
    unit = f", {about.unit}" if about.unit else ""
    usual = f" Usual: {about.usual[0]:g} to {about.usual[1]:g}." if about.usual else ""
    help_ = f". {about.help}" if about.help else ""
    return f"{about.label}{unit}{help_}{usual}"
