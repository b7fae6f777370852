# SPDX-License-Identifier: Apache-2.0
"""Changes of a design as `--set` takes them, KEY=VALUE: made all together, and told in words."""

from collections.abc import Iterable, Iterator
from typing import Any

from calc.design.addresses import parse_assignment, quantity_of, value_at
from calc.design.toml_file import Document
from calc.design.locks import locked
from calc.sheet.errors import BadInput
from calc.sheet.quantity import Quantity
from calc.sheet.text import EMPTY, SEMICOLON, Amount, Name, Part, Text


def applied(document: Document, changes: Iterable[str]) -> Document:
    """The document with every change made.  Raises BadInput where a key is none."""
    for change in changes:
        document = document.with_value(*parse_assignment(change))
    return document


def told(document: Document, changes: Iterable[str]) -> Text:
    """What each change does: "Length bearings.front.length_mm 27.5 → 34 mm"; those that change nothing are left out."""
    texts = []
    for key, value, there in _different(document, changes):
        if there is None:
            texts.append(Text("{key} {value}", key=key, value=_part(value)))
            continue
        about, before = there
        texts.append(
            Text("{label} ({key}) {before} → {value}", label=about.label, key=key, before=_part(before), value=_part(value, about.unit))
        )
    return SEMICOLON.join(texts)


def locked_text(document: Document, changes: Iterable[str]) -> Text:
    """`changes what is locked: Oil (bearings.oil): the oil is the engine's`; empty where nothing of it is."""
    texts = [
        Text("{label} ({key}): {reason}", label=there[0].label, key=key, reason=reason)
        for key, _, there in _different(document, changes)
        if there is not None and (reason := locked(document.data, key))
    ]
    return Text("changes what is locked: {inputs}", inputs=SEMICOLON.join(texts)) if texts else EMPTY


def _different(document: Document, changes: Iterable[str]) -> Iterator[tuple[str, Any, tuple[Quantity, object] | None]]:
    """Keys with their new values, each with its description and the value before; None of an element that only the changes make."""
    for key, value in map(parse_assignment, changes):
        try:
            there = quantity_of(document.data, key), value_at(document.data, key)
        except BadInput:
            yield key, value, None
            continue
        if there[1] != value:
            yield key, value, there


def _part(value: Any, unit: str = "") -> Part:
    """A value of the design file as the part of a sentence."""
    if value is None:
        return "(auto)"
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return Amount(value, unit, form="g" if isinstance(value, float) else "d")
    text = SEMICOLON.join(Text("{item}", item=_part(item)) for item in value) if isinstance(value, list) else Name(str(value))
    return Text("{text} {unit}", text=text, unit=unit) if unit else text
