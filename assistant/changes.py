# SPDX-License-Identifier: Apache-2.0
"""Changes of a design as `--set` takes them, KEY=VALUE: made all together, and told in words."""

from collections.abc import Iterable
from typing import Any

from calc.design_file import Document, parse_assignment, quantity_of, value_at
from calc.sheet.errors import BadInput


def applied(document: Document, changes: Iterable[str]) -> Document:
    """The document with every change made.  Raises BadInput where a key is none."""
    for change in changes:
        document = document.with_value(*parse_assignment(change))
    return document


def told(document: Document, changes: Iterable[str]) -> list[str]:
    """What each change does: "Length bearings.front.length_mm 27.5 → 34 mm"; those that change nothing are left out."""
    found = []
    for key, value in map(parse_assignment, changes):
        try:
            about, before = quantity_of(document.data, key), value_at(document.data, key)
        except BadInput:  # the key of an element that is only made by these changes
            found.append(f"{key} {_text(value)}")
            continue
        if before != value:
            found.append(f"{about.label} ({key}) {_text(before)} → {_text(value)} {about.unit}".rstrip())
    return found


def _text(value: Any) -> str:
    if value is None:
        return "(auto)"
    return "; ".join(map(_text, value)) if isinstance(value, list) else f"{value:g}" if isinstance(value, float) else str(value)
