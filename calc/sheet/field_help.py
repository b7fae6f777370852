# SPDX-License-Identifier: Apache-2.0
"""What `help` shows of a class of inputs or of results: what each field is, in the unit in which Python has it."""

from dataclasses import Field, fields
from inspect import cleandoc
from typing import Any

from .number import scalar
from .units import UNITS

NUMBERS = ("number", "series")
SAY_NO_RANGE = ("text", "table", "tables", "open", "reasons")


class FieldHelp:
    """The docstring of a class: its own, and a line for each field that is described, written when it is asked for."""

    def __init__(self, own: str) -> None:
        self.own = own

    def __get__(self, record: object, owner: type) -> str:
        lines = [_result(f) if "value" in f.metadata else _input(f) for f in fields(owner) if _about(f) is not None]
        return "\n".join([cleandoc(self.own), "", *lines]) if lines else cleandoc(self.own)


def _about(f: Field[Any]) -> Any:
    return f.metadata.get("value", f.metadata.get("quantity"))


def _result(f: Field[Any]) -> str:
    """`film [m]: Smallest film`"""
    about = _about(f)
    return f"    {f.name} [{_unit(about)}]: {about.label}"


def _input(f: Field[Any]) -> str:
    """`bore [m]: Bore; a number above 0 and up to 1000 mm. Diameter of …`"""
    about = _about(f)
    unit = f" [{_unit(about)}]" if about.kind in NUMBERS else ""
    allowed = "" if about.kind in SAY_NO_RANGE else f"; {about.allowed()}"
    left_out = f" ({_left_out(f.default)})" if about.optional else ""
    return f"    {f.name}{unit}: {about.label}{allowed}{left_out}. {about.help}".rstrip()


def _unit(about: Any) -> str:
    return UNITS[about.unit].inside_symbol or "-"


def _left_out(default: object) -> str:
    if isinstance(default, str) and default:
        return f'left out: "{default}"'
    if isinstance(default, float):
        return f"left out: {scalar(default, 6)}"
    return f"left out: {default}" if isinstance(default, int) else "may be left out"
