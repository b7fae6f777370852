# SPDX-License-Identifier: Apache-2.0
"""What a design still has of the engine that it began with.

Its note says so, value by value, until each is replaced by another: then the note says no more of it, and a design that
was called after that engine no longer is."""

import re
from functools import cache

from calc.design.addresses import Table, as_table, changed
from calc.design.labels import Place, content_at, label_of
from calc.design.model import Design
from calc.engine.inputs import EngineInputs
from calc.sheet.quantity import dotted
from calc.studies.shipped import engine_table, engines

from .places import NAME

NOTE, ENGINE = dotted(Design.note), dotted(Design.engine)
# what says how the cylinders stand and fire, and is no engine's own number
STANDS = tuple(
    dotted(key)
    for key in (
        EngineInputs.layout,
        EngineInputs.cylinders,
        EngineInputs.strokes,
        EngineInputs.bank_angle,
        EngineInputs.bank_of_cylinder,
        EngineInputs.firing_order,
        EngineInputs.crank_angles,
    )
)
# how notes say it: now, in designs that earlier versions began, and in those that `new --set` wrote
SAID = (
    r"Still of {name}: .*? Their source: .*?\.(?=\s|$)",
    r"Begun with the data of {name}: .*? They are from: .*?\.(?=\s|$)",
    r"An engine of its own, by .*?; all else of \[engine\] is that of the shipped {id}, to be replaced\.",
)
# what a source in the table of engines says that it is of
MEASURES = {
    "bore": dotted(EngineInputs.bore),
    "stroke": dotted(EngineInputs.crank_radius),
    "pitch": dotted(EngineInputs.cylinder_pitch),
}
WHOLE = r"{what}\. Data: {source}\."  # of a design of that engine itself


def inherited(data: Table) -> tuple[str, tuple[Place, ...]]:
    """The name of the engine that a design began with, and the places of its numbers that are still there."""
    note = str(data.get(NOTE, ""))
    said = _said(note)
    return (engines()[said[0]].name, _named(data, note, *said)) if said is not None else ("", ())


def begun_note(id: str) -> str:
    """The note of a design that has all of a shipped engine."""
    return _sentence(id, _still({ENGINE: _table(id)}, id))


def owned(before: Table, data: Table, own_name: str, typed: Place | None = None) -> Table:
    """The tables after an edit, whose note, and whose names, are no more of another engine than the numbers are;
    `typed`: where one was typed, which is one's own also where it is alike."""
    note = str(data.get(NOTE, ""))
    said = _said(note) or _whole(note, before)
    if said is None or note != before.get(NOTE, ""):  # it is just being written
        return data
    id, start, end = said
    left = tuple(place for place in _named(data, note, id, start, end) if place != typed)
    if left == _named(before, note, id, start, end):
        return data
    words = " ".join(filter(None, (note[:start].strip(), _sentence(id, left) if left else "", note[end:].strip())))
    data = changed(data, (NOTE,), words or None)
    for place in ((NAME,), (ENGINE, NAME)):
        if content_at(data, place) == engines()[id].name:
            data = changed(data, place, own_name)
    return data


@cache
def _said(note: str) -> tuple[str, int, int] | None:
    """The id of the engine that a note names as that with which the design began, and where in the note."""
    return _found(note, SAID)


@cache
def _whole_said(note: str) -> tuple[str, int, int] | None:
    return _found(note, (WHOLE,))


def _whole(note: str, before: Table) -> tuple[str, int, int] | None:
    """The same of a design of that engine itself, before the edit."""
    said = _whole_said(note)
    called = content_at(before, (ENGINE, NAME))
    return said if said is not None and called == engines()[said[0]].name else None


def _found(note: str, patterns: tuple[str, ...]) -> tuple[str, int, int] | None:
    for id, engine in engines().items():
        words = dict(id=id, name=engine.name, what=str(engine.what), source=engine.source)
        for pattern in patterns:
            if found := re.search(pattern.format(**{key: re.escape(word) for key, word in words.items()}), note, re.S):
                return id, *found.span()
    return None


def _sentence(id: str, places: tuple[Place, ...]) -> str:
    """As it stands in the note, in English: it is read again by `SAID`."""
    labels = ", ".join(_label(id, place) for place in places)
    sources = "; ".join(part for part in engines()[id].source.split("; ") if _is_of(part, places))
    return f"Still of {engines()[id].name}: {labels}. Their source: {sources}."


@cache
def _label(id: str, place: Place) -> str:
    return str(label_of({ENGINE: _table(id)}, ".".join(map(str, place))))


def _named(data: Table, note: str, id: str, start: int, end: int) -> tuple[Place, ...]:
    """What is still there of all that the note names; of notes of earlier versions, of all that the engine has."""
    front = f"Still of {engines()[id].name}: "
    said = note[start:end]
    places = _still(data, id)
    if not said.startswith(front):
        return places
    labels = said.removeprefix(front).partition(". Their source: ")[0].split(", ")
    return tuple(place for place in places if _label(id, place) in labels)


def _is_of(source: str, places: tuple[Place, ...]) -> bool:
    """Whether one of these values has the source; "bore, stroke: …" names whose it is."""
    named, of, _ = source.partition(": ")
    return not of or any((ENGINE, MEASURES[word]) in places for word in named.split(", "))


def _still(data: Table, id: str) -> tuple[Place, ...]:
    there = as_table(data.get(ENGINE))
    theirs = _table(id).items()
    return tuple((ENGINE, key) for key, value in theirs if key not in (*STANDS, NAME) and there.get(key) == value)


@cache
def _table(id: str) -> Table:
    return engine_table(id)
