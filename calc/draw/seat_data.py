# SPDX-License-Identifier: Apache-2.0
"""What the drawing of a shaft says of the seats that its journals run in: limits of journal, bore and walls, the press,
and which shell goes with which pair of classes.  Nothing of a seat of which nothing more is known than its fit."""

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from ..library.tolerances import parse
from ..sheet.quantity import dotted
from ..sheet.text import COMMA, EMPTY, Amount, Text
from ..sheet.units import UNITS, Metre
from .annotations import LETTER, Say, number
from .lettering import width
from .sheet_data import Rows

if TYPE_CHECKING:
    from ..bearings.plain.result import PlainResult
    from ..bearings.plain.seats.stack import SeatStack
    from ..countershaft.rows import BearingRow
    from ..solve import Results

SIZE = 3  # decimals
WIDE, BORES = 112.0, 36.0  # of the table of classes, and of its bore classes


def _judged(results: "Results") -> "Iterator[tuple[BearingRow, PlainResult]]":
    """The bearings of whose seat something is known, front to rear."""
    outcome = results.outcomes.get(dotted("bearings"))
    known = getattr(outcome.result, "bearings", {}) if outcome is not None else {}
    for row in results.design.rows:
        r = known.get(row.name)
        if r is not None and (r.seat.stack is not None or r.seat_ is not None):
            yield row, r


def seat_rows(results: "Results", say: Say) -> Rows:
    """Of these bearings what they are made of and how they are pressed; those that are alike in one."""
    rows: Rows = []
    for names, row, r in _alike(results, lambda row, r: tuple(map(str, _of_seat(row, r)))):
        for label, words in _of_seat(row, r):
            rows.append((say(_at(label, names)), say(words)))
    return rows


def _alike(
    results: "Results", by: "Callable[[BearingRow, PlainResult], object]"
) -> "Iterator[tuple[Text, BearingRow, PlainResult]]":
    """The first of those bearings that are alike, with the names of all; empty where all are."""
    groups: dict[object, list[tuple[BearingRow, PlainResult]]] = {}
    for row, r in _judged(results):
        groups.setdefault(by(row, r), []).append((row, r))
    for group in groups.values():
        names = COMMA.join(row.in_words for row, _ in group)
        yield EMPTY if len(groups) == 1 < len(group) else names, *group[0]


def _at(what: Text, names: Text) -> Text:
    return Text("{what}, {place}", what=what, place=names) if names else what


def _of_seat(row: "BearingRow", r: "PlainResult") -> "Iterator[tuple[Text, Text]]":
    stack, seat, finished = r.seat.stack, r.seat_, row.finished is not None
    bore = row.bore if stack is None or finished else stack.bore
    walls = row.wall if stack is None or stack.walls is None else stack.walls
    if bore is not None:
        yield (Text("Housing bore") if row.ringed else Text("Bore of the seat")), _across(bore)
    if stack is not None and stack.pairs is not None:
        yield from _sizes(stack)
    elif row.ringed and walls is not None:
        yield (Text("Shells, wall") if row.seat == "shells" else Text("Bush, wall")), _lengths(walls)
    if seat is not None:
        name = Text("Interference, by the program") if seat.rings.chosen else Text("Interference")
        yield name, _microns(seat.interference_min, seat.interference_max, up=True)
    g_min, g_max = r.corners.clearance_min, r.corners.clearance_max
    if finished and stack is not None:
        yield Text("Running bore, finished"), _across(stack.bore)
    elif row.ringed and stack is not None and stack.pairs is None:
        yield Text("Running bore, as pressed"), _across((g_min + stack.journal[1], g_max + stack.journal[0]))
    elif row.ringed and stack is None and (fit := parse(r.seat.inputs.seat_fit)).letter is not None:
        yield Text("Running bore, fit"), Text("{fit}", fit=str(fit))
    if stack is not None:
        yield Text("Clearance"), _microns(g_min, g_max)


def _microns(least: Metre, most: Metre, *, up: bool = False) -> Text:
    """In whole ones; `up`: none less."""
    shown = [UNITS["µm"].shown(end) for end in (least, most)]
    low, high = (number(math.ceil(end - 1e-6) if up else end, 0) for end in shown)
    return Text("{low} to {high} µm", low=low, high=high)


def _lengths(limits: tuple[Metre, ...]) -> Text:
    low, high = (Amount(UNITS["mm"].shown(limit), form=f".{SIZE}f") for limit in (limits[0], limits[-1]))
    return Text("{low}", low=low) if limits[0] == limits[-1] else Text("{low}–{high}", low=low, high=high)


def _across(limits: tuple[Metre, ...]) -> Text:
    return Text("⌀{limits}", limits=_lengths(limits))


def class_tables(results: "Results", say: Say) -> list[tuple[str, Rows, tuple[float, ...]]]:
    """Of shells that are picked: rows by class of the bore, columns by class of the journal."""
    found = []
    for names, _, r in _alike(results, lambda row, r: str(r.seat.stack and r.seat.stack.pairs)):
        if (stack := r.seat.stack) is None or stack.pairs is None:
            continue
        bores, journals = _classes(stack)
        head = [say(size) for size in journals.values()] if _fits(journals) else [str(n) for n in journals]
        rows: Rows = [("", *head)]
        for n, size in bores.items():
            cells = (say(stack.shells[stack.pairs[n, journal][1]]) for journal in journals)
            rows.append((say(size), *cells))
        title = say(_at(Text("Shells by bore and journal, colours by this program"), names))
        found.append((title, rows, (BORES, *[(WIDE - BORES) / len(journals)] * len(journals))))
    return found


def _classes(stack: "SeatStack") -> tuple[dict[int, Text], dict[int, Text]]:
    """The limits of the classes of bore and journal, by their numbers."""
    assert stack.pairs is not None
    bores = {bore: _across(limits) for (bore, _), (limits, *_) in stack.pairs.items()}
    return bores, {journal: _across(limits) for (_, journal), (*_, limits) in stack.pairs.items()}


def _fits(journals: dict[int, Text]) -> bool:
    """Whether the limits of all journal classes have room side by side."""
    return all(width(size, LETTER) + 3.0 <= (WIDE - BORES) / len(journals) for size in journals.values())


def _sizes(stack: "SeatStack") -> Iterator[tuple[Text, Text]]:
    """What has only a word, or a number, in the table of classes."""
    for wall, colour in stack.shells.items():
        yield Text("Shells {colour}, wall", colour=colour), _lengths(wall)
    _, journals = _classes(stack)
    if not _fits(journals):
        yield from ((Text("Journal class {n}", n=n), size) for n, size in journals.items())
