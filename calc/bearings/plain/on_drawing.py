# SPDX-License-Identifier: Apache-2.0
"""What the drawing of a shaft says of journals and of the seats that they run in: limits of journal, bore and walls,
the press, and which shell goes with which pair of classes.  Nothing of a seat of which nothing more is known than its
fit."""

import math
from collections.abc import Callable, Iterator, Mapping

from ...countershaft.rows import BearingRow
from ...draw.annotations import COLUMNS, LETTER, Rows, SheetTable
from ...draw.lettering import width
from ...draw.sizes import Say, number
from ...library.tolerances import ASSUMED_FIT, parse
from ...sheet.text import COMMA, EMPTY, Amount, Text
from ...sheet.units import UNITS, Metre
from ..inputs import BearingsInputs
from ..support import TurnedJournal
from .bearing import PlainBearing
from .seats.stack import SeatStack

SIZE = 3  # decimals
WIDE, BORES = 112.0, 36.0  # of the table of classes, and of its bore classes


def turned(row: BearingRow, inputs: BearingsInputs) -> TurnedJournal:
    fit = inputs.of(row).journal_fit
    return TurnedJournal(_limits(row, inputs), parse(fit, "shaft"), row.journal_roughness, fit == ASSUMED_FIT)


def _limits(row: BearingRow, inputs: BearingsInputs) -> tuple[Metre, Metre] | None:
    """Least and most of a journal, of all its classes where there are some; None where its fit says it."""
    if row.seat == "shells" and inputs.select is not None:
        classes = inputs.select.journals
        return classes[0][0], classes[-1][1]
    return None if row.journal is None else (row.journal[0], row.journal[-1])


def on_drawing(results: Mapping[str, PlainBearing], inputs: BearingsInputs, say: Say) -> Iterator[SheetTable]:
    head = Text("Seats of the journals, at {T} °C", T=Amount(inputs.clearance_reference_temperature, form="g"))
    known = [r for r in results.values() if r.seat.stack is not None or r.seat_ is not None]
    yield say(head), _seat_rows(known, say), COLUMNS
    yield from _class_tables(known, say)


def _seat_rows(known: list[PlainBearing], say: Say) -> Rows:
    """Of these bearings what they are made of and how they are pressed; those that are alike in one."""
    rows: Rows = []
    for names, row, r in _alike(known, lambda row, r: tuple(map(str, _of_seat(row, r)))):
        for label, words in _of_seat(row, r):
            rows.append((say(_at(label, names)), say(words)))
    return rows


def _alike(
    known: list[PlainBearing], by: Callable[[BearingRow, PlainBearing], object]
) -> Iterator[tuple[Text, BearingRow, PlainBearing]]:
    """The first of those bearings that are alike, with the names of all; empty where all are."""
    groups: dict[object, list[tuple[BearingRow, PlainBearing]]] = {}
    for r in known:
        groups.setdefault(by(r.row, r), []).append((r.row, r))
    for group in groups.values():
        names = COMMA.join(row.in_words for row, _ in group)
        yield EMPTY if len(groups) == 1 < len(group) else names, *group[0]


def _at(what: Text, names: Text) -> Text:
    return Text("{what}, {place}", what=what, place=names) if names else what


def _of_seat(row: BearingRow, r: PlainBearing) -> Iterator[tuple[Text, Text]]:
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


def _class_tables(known: list[PlainBearing], say: Say) -> Iterator[SheetTable]:
    """Of shells that are picked: rows by class of the bore, columns by class of the journal."""
    for names, _, r in _alike(known, lambda row, r: str(r.seat.stack and r.seat.stack.pairs)):
        if (stack := r.seat.stack) is None or stack.pairs is None:
            continue
        bores, journals = _classes(stack)
        head = [say(size) for size in journals.values()] if _fits(journals) else [str(n) for n in journals]
        rows: Rows = [("", *head)]
        for n, size in bores.items():
            cells = (say(stack.shells[stack.pairs[n, journal][1]]) for journal in journals)
            rows.append((say(size), *cells))
        title = say(_at(Text("Shells by bore and journal, colours by this program"), names))
        yield title, rows, (BORES, *[(WIDE - BORES) / len(journals)] * len(journals))


def _classes(stack: SeatStack) -> tuple[dict[int, Text], dict[int, Text]]:
    """The limits of the classes of bore and journal, by their numbers."""
    assert stack.pairs is not None
    bores = {bore: _across(limits) for (bore, _), (limits, *_) in stack.pairs.items()}
    return bores, {journal: _across(limits) for (_, journal), (*_, limits) in stack.pairs.items()}


def _fits(journals: dict[int, Text]) -> bool:
    """Whether the limits of all journal classes have room side by side."""
    return all(width(size, LETTER) + 3.0 <= (WIDE - BORES) / len(journals) for size in journals.values())


def _sizes(stack: SeatStack) -> Iterator[tuple[Text, Text]]:
    """What has only a word, or a number, in the table of classes."""
    for wall, colour in stack.shells.items():
        yield Text("Shells {colour}, wall", colour=colour), _lengths(wall)
    _, journals = _classes(stack)
    if not _fits(journals):
        yield from ((Text("Journal class {n}", n=n), size) for n, size in journals.items())
