# SPDX-License-Identifier: Apache-2.0
"""Changes of keys in the labels and units of their fields: `front length 27.5 → 34 mm, oil 10W-40 → SAE 50`."""

from typing import TYPE_CHECKING

from .addresses import quantity_of, value_at
from .toml_file import Document
from ..sheet.changes import Changes
from ..sheet.quantity import Published, Quantity
from ..sheet.text import COMMA, Amount, Name, Small, Text

if TYPE_CHECKING:
    from ..solve import Results

ARRAYS = ("wheels", "meshes", "masses", "extras", "sections", "unbalances", "crank_bodies", "journals")
BRIEF = {  # where the label of the form is longer than a line can bear
    "clearance_um": Text("clearance"), "span_allowance_um": Text("span allowance"), "diameter_mm": Text("diameter"),
    "profile_shift": Text("profile shift"),
}  # fmt: skip
NUMBERED = {"meshes": Text("mesh"), "sections": Text("section"), "journals": Text("journal")}
PLACES = {"front": Text("front"), "rear": Text("rear")}  # tables whose names are the program's
DIGITS = 6


def words(document: Document, results: "Results", changes: Changes) -> Text:
    """`document` and `results` are those before the changes.  A key that only makes room for another is not named."""
    places = {key: _place(key) for key in changes}
    kept = [key for key, new in changes.items() if new is not None or not any(o != key and places[o] == places[key] for o in changes)]
    return COMMA.join(filter(None, (_change(document, results, key, changes[key]) for key in kept)))


def _change(document: Document, results: "Results", key: str, new: object) -> Text | None:
    """None where it only writes down what the program had chosen."""
    about, old = quantity_of(document.data, key), value_at(document.data, key)
    if old is None and (there := published(results, key)) is not None and there.unit == about.unit:
        old = float(f"{there.shown:.4g}")
        if isinstance(new, float) and old == float(f"{new:.4g}"):
            return None
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new) and sum(a != b for a, b in zip(old, new)) == 1:
        old, new = next((a, b) for a, b in zip(old, new) if a != b)  # the one number of a list that changes
    label, place, last = BRIEF.get(key.rpartition(".")[2], Small(about.label)), _place(key), written(new, about.unit)
    change = Text("{label} {now} → {new}", label=label, now=written(old), new=last)
    if not place:
        return change
    if key.split(".")[1] in ARRAYS:
        return Text("{label} of {place} {now} → {new}", label=label, place=place, now=written(old), new=last)
    return Text("{place} {change}", place=PLACES.get(place, place), change=change)


def named(document: Document, key: str) -> Text:
    """A key as the user knows it: the label of its field, and where it stands."""
    return called(key, quantity_of(document.data, key))


def called(key: str, about: Quantity) -> Text:
    """The same of a key whose quantity is known."""
    label, place = BRIEF.get(key.rpartition(".")[2], Small(about.label)), _place(key)
    if not place:
        return label
    if key.split(".")[1] in ARRAYS:
        return Text("{label} of {place}", label=label, place=place)
    return Text("{place} {change}", place=PLACES.get(place, place), change=label)


def published(results: "Results", key: str) -> Published | None:
    """The result that says what the program chose for a key that is left out: `gears.central.profile_shift`, `bearings.front.clearance`."""
    id = ".".join(part for part in key.split(".") if part not in ARRAYS)
    outcome = results.outcomes.get(key.partition(".")[0])
    known = {value.id: value for value in outcome.values()} if outcome is not None else {}
    return known.get(id) or known.get(id.rpartition("_")[0])


def _place(key: str) -> str:
    """The element or the table that a key stands in, without the step: `central`, `front`; a mesh by its number from 1."""
    inner = [part for part in key.split(".")[1:-1] if part not in ARRAYS]
    if inner and inner[0].isdigit():
        array = key.split(".")[1]
        return Text("{array} {n}", array=NUMBERED.get(array, array), n=int(inner[0]) + 1)
    return " ".join(inner)


def written(value: object, unit: str = "") -> Text | Amount:
    if value is None:
        return Text("left out")
    if isinstance(value, list):
        row = Name("/").join(Text("{x}", x=written(one)) for one in value)
        return Text("{row}°", row=row) if unit == "°" else Text("{row} {unit}", row=row, unit=unit) if unit else row
    return Amount(value, unit, digits=DIGITS) if isinstance(value, (int, float)) and not isinstance(value, bool) else Name(str(value))
