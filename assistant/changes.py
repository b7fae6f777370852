# SPDX-License-Identifier: Apache-2.0
"""Changes of a design as `--set` takes them, KEY=VALUE: made all together, and told in words."""

from collections.abc import Iterable
from typing import Any

from calc.addresses import parse_assignment, quantity_of, value_at
from calc.design_file import Document
from calc.locks import locked
from calc.sheet.errors import BadInput
from calc.sheet.text import EMPTY, SEMICOLON, Amount, Name, Part, Text


def applied(document: Document, changes: Iterable[str]) -> Document:
    """The document with every change made.  Raises BadInput where a key is none."""
    for change in changes:
        document = document.with_value(*parse_assignment(change))
    return document


def told(document: Document, changes: Iterable[str]) -> Text:
    """What each change does: "Length bearings.front.length_mm 27.5 → 34 mm"; those that change nothing are left out."""
    texts = []
    for key, value in map(parse_assignment, changes):
        try:
            about, before = quantity_of(document.data, key), value_at(document.data, key)
        except BadInput:  # the key of an element that is only made by these changes
            texts.append(Text("{key} {value}", key=key, value=_part(value)))
            continue
        if before != value:
            texts.append(
                Text("{label} ({key}) {before} → {value}", label=about.label, key=key, before=_part(before), value=_part(value, about.unit))
            )
    return SEMICOLON.join(texts)


def locked_text(document: Document, changes: Iterable[str]) -> Text:
    """`changes what is locked: Oil (bearings.oil): the oil is the engine's`; empty where nothing of it is."""
    texts = []
    for key, value in map(parse_assignment, changes):
        try:
            about, before = quantity_of(document.data, key), value_at(document.data, key)
        except BadInput:  # the key of an element that is only made by these changes
            continue
        if before != value and (reason := locked(document.data, key)):
            texts.append(Text("{label} ({key}): {reason}", label=about.label, key=key, reason=reason))
    return Text("changes what is locked: {inputs}", inputs=SEMICOLON.join(texts)) if texts else EMPTY


def _part(value: Any, unit: str = "") -> Part:
    """A value of the design file as the part of a sentence."""
    if value is None:
        return "(auto)"
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return Amount(value, unit, form="g" if isinstance(value, float) else "d")
    text = SEMICOLON.join(Text("{item}", item=_part(item)) for item in value) if isinstance(value, list) else Name(str(value))
    return Text("{text} {unit}", text=text, unit=unit) if unit else text
