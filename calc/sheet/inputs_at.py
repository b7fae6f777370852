# SPDX-License-Identifier: Apache-2.0
"""What stands in inputs under a dotted key, elements of arrays by their names, a mesh by its wheels, any by its place;
and the same inputs with another content there."""

from dataclasses import is_dataclass
from typing import TypeVar, cast

from .quantity import Quantity, keys
from .record import replace

T = TypeVar("T")


def place_of(elements: tuple[object, ...], part: str) -> int | None:
    """Where the element of a key stands: by its name, a mesh by its wheels, any by its place from 0."""
    for n, element in enumerate(elements):
        wheels = f"{getattr(element, 'driver', '')}_{getattr(element, 'driven', '')}"
        if part in (getattr(element, "name", ""), wheels):
            return n
    return int(part) if part.isdigit() and int(part) < len(elements) else None


def content_at(inputs: object, key: str) -> tuple[object, Quantity | None]:
    """What stands under a key, in SI, and what is said of it; nothing where there is no such key."""
    here, about = inputs, None
    for part in key.split("."):
        if isinstance(here, tuple):
            n = place_of(here, part)
            here = None if n is None else here[n]
            continue
        kind: type = type(here)
        known = keys(kind).get(part) if is_dataclass(here) else None
        if known is None:
            return None, None
        here, about = getattr(here, known.attribute), known.about
    return here, about


def with_content(inputs: T, key: str, content: object) -> T:
    """The same inputs with another content under a key that they have, in SI; LookupError where they have it not."""
    part, _, rest = key.partition(".")
    if isinstance(inputs, tuple):
        n = place_of(inputs, part)
        if n is None or not rest:
            raise LookupError(key)
        return cast("T", (*inputs[:n], with_content(inputs[n], rest, content), *inputs[n + 1 :]))
    kind: type = type(inputs)
    known = keys(kind).get(part) if is_dataclass(inputs) else None
    if known is None:
        raise LookupError(key)
    new = with_content(getattr(inputs, known.attribute), rest, content) if rest else content
    changed: T = replace(inputs, **{known.attribute: new})  # type: ignore[type-var]
    return changed
