# SPDX-License-Identifier: Apache-2.0
"""How a record prints itself: in one line (`repr`), or as a table of label, value and unit (`print`)."""

from collections.abc import Iterator
from dataclasses import MISSING, fields
from reprlib import Repr

from .number import scalar, several
from .units import UNITS


class _Brief(Repr):
    """Values cut short; of a record inside another only its class, so that a tree of thousands costs nothing."""

    def repr_instance(self, x: object, level: int) -> str:
        inside = hasattr(x, "__dataclass_fields__") or isinstance(x, tuple)
        return f"{type(x).__name__}(…)" if inside else super().repr_instance(x, level)


BRIEF = _Brief()
BRIEF.maxother = BRIEF.maxstring = 48  # characters of one value in a line


def line(record: object) -> str:
    """`BearingInputs(diameter=0.0595, length=0.0275, …)`: what differs from its default, in SI, long values cut short."""
    kind: type = type(record)
    shown = (f"{f.name}={BRIEF.repr(getattr(record, f.name))}" for f in fields(kind) if not _is(getattr(record, f.name), f.default))
    return f"{kind.__name__}({', '.join(shown)})"


def table(record: object) -> str:
    """A row for each field that is set: its label (its name, where it has none), the value in the unit in which it is shown, the unit.

    Of results only what they publish stands in it.
    """
    return aligned(type(record).__name__, _inside(record, "  "))


def aligned(title: str, rows: Iterator[tuple[str, str, str]]) -> str:
    """Rows of (label, value, unit) under a title, values flush right."""
    body = list(rows)
    left = max((len(label) for label, _, _ in body), default=0)
    right = max((len(value) for _, value, _ in body), default=0)
    return "\n".join([title, *(f"{label:<{left}}  {value:>{right}} {unit}".rstrip() for label, value, unit in body)])


def _rows(label: str, content: object, unit: str, indent: str) -> Iterator[tuple[str, str, str]]:
    if content is None or (isinstance(content, tuple | str) and not content):
        return
    if (about := getattr(content, "about", None)) is not None and hasattr(content, "number"):  # a result named at run time
        yield f"{indent}{about.label}", brief(content.number, UNITS[about.unit].factor), about.unit
    elif isinstance(content, dict) or hasattr(content, "__dataclass_fields__"):
        yield f"{indent}{label}", "", ""
        yield from _inside(content, indent + "  ")
    else:
        yield f"{indent}{label}", brief(content, UNITS[unit].factor if unit else 1.0), unit


def _inside(content: object, indent: str) -> Iterator[tuple[str, str, str]]:
    if isinstance(content, dict):
        for name, part in content.items():
            yield from _rows(str(name), part, "", indent)
        return
    kind: type = type(content)
    known = fields(kind)
    for f in [f for f in known if f.metadata] or known:
        about = f.metadata.get("value") or f.metadata.get("quantity")
        yield from _rows(about.label if about else f.name, getattr(content, f.name), about.unit if about else "", indent)


def brief(content: object, factor: float = 1.0) -> str:
    """Numbers in the shown unit with six digits, of long lists the ends, of arrays the shape, of records in a list their class."""
    if hasattr(content, "shape") and content.shape:
        return f"array{content.shape}"
    if isinstance(content, tuple | list):
        if all(isinstance(x, float) for x in content):
            return several([x / factor for x in content])
        return ", ".join([brief(x, factor) for x in content[:4]] + [f"… {len(content)} in all"] * (len(content) > 4))
    if isinstance(content, bool | str):
        return str(content)
    if isinstance(content, int | float | complex):
        return scalar(content / factor, 6)
    return str(getattr(content, "name", "")) or type(content).__name__


def _is(content: object, default: object) -> bool:
    """Whether a field has its default; an array never has."""
    return default is not MISSING and not getattr(content, "ndim", 0) and bool(content == default)
