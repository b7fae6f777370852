# SPDX-License-Identifier: Apache-2.0
"""Changes of keys in words: `front length 27.5 → 34 mm, oil 10W-40 → SAE 50`."""

from collections.abc import Iterable
from typing import Any

from ..design_file import Document, parse_assignment, quantity_of, value_at
from ..sheet.number import short
from ..sheet.quantity import Published
from ..solve import Results

ARRAYS = ("wheels", "meshes", "masses", "extras", "sections", "unbalances", "crank_bodies", "journals")
BRIEF = {  # where the label of the form is longer than a line can bear
    "clearance_um": "clearance", "span_allowance_um": "span allowance", "diameter_mm": "diameter", "profile_shift": "profile shift",
}  # fmt: skip
DIGITS = 6
LEFT_OUT = "left out"


def words(document: Document, results: Results, changes: Iterable[str]) -> str:
    """`document` and `results` are those before the changes.  A key that only makes room for another is not named."""
    known = results.values()
    made = dict(parse_assignment(change) for change in changes)
    said = []
    for key, new in made.items():
        if new is None and any(new_key != key and _place(new_key) == _place(key) for new_key in made):
            continue
        said.append(_change(document, known, key, new))
    return ", ".join(said)


def _change(document: Document, known: dict[str, Published], key: str, new: Any) -> str:
    about = quantity_of(document.data, key)
    old = value_at(document.data, key)
    if old is None and (there := _value(known, key)) is not None and there.unit == about.unit:
        old = float(f"{there.shown:.4g}")
    label, place = BRIEF.get(key.rpartition(".")[2], about.label[0].lower() + about.label[1:]), _place(key)
    unit = f" {about.unit}" if about.unit and about.unit != "°" else about.unit
    change = f"{_written(old)} → {_written(new)}{unit}"
    if not place:
        return f"{label} {change}"
    return f"{label} of {place} {change}" if key.split(".")[1] in ARRAYS else f"{place} {label} {change}"


def _value(known: dict[str, Published], key: str) -> Published | None:
    """The result that says what the program chose for a key that is left out: `gears.central.profile_shift`, `bearings.front.clearance`."""
    id = ".".join(part for part in key.split(".") if part not in ARRAYS)
    return known.get(id) or known.get(id.rpartition("_")[0])


def _place(key: str) -> str:
    """The element or the table that a key stands in, without the step: `central`, `front`; a mesh by its number from 1."""
    inner = [part for part in key.split(".")[1:-1] if part not in ARRAYS]
    if inner and inner[0].isdigit():
        return f"{key.split('.')[1]} {int(inner[0]) + 1}"
    return " ".join(inner)


def _written(value: Any) -> str:
    if value is None:
        return LEFT_OUT
    if isinstance(value, list):
        return "/".join(_written(one) for one in value)
    return short(value, DIGITS) if isinstance(value, (int, float)) and not isinstance(value, bool) else str(value)
