# SPDX-License-Identifier: Apache-2.0
"""A design of schema 2 as schema 1 says it, for a file that was written in it and is saved again: one shaft with two
bearings, or more without [bearings], and perhaps its mirror image."""

from collections.abc import Sequence

from .toml_file import Document, current_document
from .upgrade import (
    FRONT,
    JOURNAL_KEYS,
    JOURNALS,
    PAIR,
    POSITIONS,
    REAR,
    ROW_KEYS,
    SHAFT,
    SLOPES,
    TWIN,
    elements,
    row_names,
    twin,
    without,
)

Table = dict[str, object]
OWN = ("name", "bearings", "position_mm", "kind", "slope_mrad")  # of a shaft or a row, said elsewhere in schema 1


def downgraded(data: Table) -> Table | None:
    """The tables in schema 1; None where they can not be said in it."""
    made = _said(data)
    return made if made is not None and current_document(Document(made)).data == data else None


def _said(data: Table) -> Table | None:
    """What schema 1 would say, whether or not it is all of it."""
    shafts, shared = elements(data, "shafts"), data.get("bearings")
    rows = elements(shafts[0], "bearings") if shafts else []
    names = [str(row.get("name", "")) for row in rows]
    made: Table = {key: content for key, content in data.items() if key != "shafts"} | {"schema": 1}
    if "gears" in made and isinstance(gears := made["gears"], dict):
        made["gears"] = {**gears, "wheels": [without(wheel, "shaft") for wheel in elements(gears, "wheels")]}
    for table in ("locked", "accepted"):
        if isinstance(entries := made.get(table), dict):
            made[table] = {former_key(key, names): content for key, content in entries.items()}
    if isinstance(optimise := made.get("optimise"), dict) and isinstance(vary := optimise.get("vary"), dict):
        made["optimise"] = {**optimise, "vary": {former_key(key, names): content for key, content in vary.items()}}
    if measured := elements(made, "measured"):
        made["measured"] = [{**row, "value": former_key(str(row.get("value", "")), names)} for row in measured]
    if not shafts:
        return made
    shaft, *others = shafts
    if shaft.get("name") != SHAFT or tuple(names) != row_names(len(rows)):
        return None
    if isinstance(shared, dict):
        slopes = [row["slope_mrad"] for row in rows if "slope_mrad" in row]
        own = {place: without(row, *OWN) for place, row in zip((FRONT, REAR), rows)}
        made["bearings"] = {**shared, **own} | ({"slope_mrad": slopes} if slopes else {})
    if shaft.get("mode") == "bearings":
        return made
    places = [row["position_mm"] for row in rows if "position_mm" in row]
    journals = [{key: row[key] for key in JOURNAL_KEYS if key in row} for row in rows]
    countershaft = without(shaft, *OWN) | {"bearing_positions_mm": places}
    if not isinstance(shared, dict) and any(journals):
        countershaft["journals"] = journals
    if others == [twin(shaft, SHAFT)]:
        countershaft["pair"] = "yes"
    made["countershaft"] = countershaft
    return made


def former_key(key: str, rows: Sequence[str]) -> str:
    """What schema 1 called a key of its shaft or of one of its bearings, `rows` by their names; any other as it is."""
    first, *parts = key.split(".")
    if first != "shafts" or len(parts) < 2:
        return key
    if parts[:2] == [TWIN, "mirrors"]:
        return PAIR
    if parts[1] == "bearings" and len(parts) == 4 and parts[2] in rows:
        n, field = rows.index(parts[2]), parts[3]
        if field == "position_mm":
            return f"{POSITIONS}.{n}"
        if field == "slope_mrad":
            return f"{SLOPES}.{0 if n == 0 else 1}"
        if parts[2] in (FRONT, REAR) and field in ROW_KEYS:
            return ".".join(parts[1:])
        if field in JOURNAL_KEYS:
            return f"{JOURNALS}.{n}.{field}"
    return ".".join(["countershaft", *parts[1:]])
