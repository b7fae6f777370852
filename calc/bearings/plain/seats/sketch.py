# SPDX-License-Identifier: Apache-2.0
"""A seat as a sketch: bush or shells in section, and the parts of its clearance as a chain of dimensions.

The section stands as the engine does, up is up.  Journal and housing are to scale, the housing cut off outside; gap,
relief and wall are drawn larger."""

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from ....countershaft.rows import BearingRow, called, row_key
from ....draw.drawing import (
    AXIS,
    CONTEXT,
    DIMENSIONS,
    OUTLINE,
    WORDS,
    Arc,
    Area,
    Dimension,
    Mark,
    Point,
    Polyline,
    Sketch,
    Words,
    judged,
    rectangle,
    round_outline,
    rounded,
)
from ....sheet.check import Check
from ....sheet.quantity import dotted
from ....sheet.record import replace
from ....sheet.text import Amount, Text
from ....sheet.units import Metre, Number, Radian
from ...inputs import BearingsInputs
from ..row import RELIEF, RELIEF_LENGTH
from .checks import BUSH_STRESS, SEAT_FRETTING, SEAT_PRESS, SEAT_STRESS, SEAT_TURN
from .classes import Range
from .result import SeatResult
from .tables import ends_of, stack_parts

if TYPE_CHECKING:
    from ..result import PlainResult

EXAGGERATED: Number = 200.0  # gap and relief, at most
GAP: Number = 0.6  # of the journal's radius: the gap is drawn no larger
WALL: Number = 0.3  # of the radius: the wall is drawn no thicker, unless it is
METAL: Number = 0.5  # of the radius: of the housing no more is drawn
CORNERS = 180  # of the bore
BOTH, SECTION, STACK = (  # captions
    Text("Seats in section, and what their clearance is made of"),
    Text("Seats in section"),
    Text("What the clearance is made of"),
)
SEATS = {"bush": Text("bush"), "shells": Text("shells")}
# what limits a seat beside the strength of its rings
PRESS = {SEAT_PRESS: Text("press"), SEAT_FRETTING: Text("press"), SEAT_TURN: Text("hold")}


def seat_sketches(results: "Mapping[str, PlainResult]", checks: dict[str, Check]) -> Iterator[list[Sketch]]:
    """Those of each bearing of whose seat something is known, all at one scale."""
    ringed = {place: r for place, r in results.items() if r.seat_ is not None}
    gap = min((rounded(GAP * r.seat.bearing.diameter / r.clearance) for r in ringed.values()), default=1.0)
    wall = min((_thicker(r) for r in ringed.values()), default=1.0)
    stacked = any(r.seat.stack is not None for r in results.values())
    caption = BOTH if ringed and stacked else SECTION if ringed else STACK
    for place, r in results.items():
        found = []
        if r.seat_ is not None:
            found.append(_section(place, r, r.seat_, checks, min(EXAGGERATED, gap), wall))
        if r.seat.stack is not None:
            found.append(_chain(place, r))
        if found:
            yield [replace(picture, caption=caption) for picture in found]


def _thicker(r: "PlainResult") -> Number:
    """How many times its thickness a wall is drawn."""
    assert r.seat.rings is not None
    return max(1.0, rounded(WALL * r.seat.bearing.diameter / 2 / r.seat.rings.wall))


def _keys(place: str, *declared: object) -> str:
    """The keys of inputs of one bearing."""
    return " ".join(row_key(place, key) for key in declared)


def _at(radius: Metre, angle: Radian) -> Point:
    return radius * math.cos(angle), radius * math.sin(angle)


def _section(
    place: str, r: "PlainResult", seat: SeatResult, checks: dict[str, Check], factor: Number, thicker: Number
) -> Sketch:
    """`factor`: how many times the gap and the relief are drawn, `thicker`: the wall."""
    row, wall = r.seat.bearing, seat.rings.wall
    journal = row.diameter / 2
    bore = journal + factor * r.clearance / 2
    outside = bore + thicker * wall
    fit = seat.rings.fit(row.diameter, r.clearance)
    metal = outside + min((fit.D - fit.d_o) / 2, METAL * journal)
    around = _bore(row, bore, factor, thicker * wall)
    thick = _keys(place, BearingRow.seat, BearingRow.wall, BearingRow.backing)
    if row.seat == "shells" and r.seat.inputs.select is not None:
        thick += f" {dotted('bearings', BearingsInputs.select)}"
    sized = _keys(place, BearingRow.housing_outer, BearingRow.bore)
    limits = _keys(place, BearingRow.journal, BearingRow.diameter)
    relief = _keys(place, BearingRow.relief, BearingRow.relief_length, BearingRow.finished)
    governing = _governing(row, checks)
    marks: list[Mark] = [
        Area(CONTEXT, (round_outline((0.0, 0.0), metal), round_outline((0.0, 0.0), outside)), 0.2, sized),
        Area(OUTLINE, (round_outline((0.0, 0.0), outside), around), 0.7, thick),
        Area(CONTEXT, (around, round_outline((0.0, 0.0), journal)), 0.35, _keys(place, BearingRow.clearance)),
        Arc(CONTEXT, (0.0, 0.0), metal, key=sized),
        Arc(OUTLINE, (0.0, 0.0), outside, key=sized),
        Polyline(OUTLINE, around, True, relief),
        Arc(OUTLINE, (0.0, 0.0), journal, key=limits),
        *_split(row, bore, outside, metal),
        *_said(place, seat, governing, metal),
    ]
    notes = [Text("gap and relief × {factor}", factor=Amount(factor))]
    if thicker > 1:
        notes.append(Text("wall × {factor}", factor=Amount(thicker)))
    title = Text(
        "{place}: {seat}, wall {wall}",
        place=called(place),
        seat=SEATS[row.seat],
        wall=Amount(wall * 1e3, "mm"),
    )
    return Sketch(tuple(marks), tuple(notes), title=title)


def _bore(row: BearingRow, bore: Metre, factor: Number, wall: Metre) -> tuple[Point, ...]:
    """The running surface; that of shells stands back at the split."""
    depth = RELIEF if row.relief is None else row.relief
    length = RELIEF_LENGTH if row.relief_length is None else row.relief_length
    half = length / (row.diameter / 2)
    points = []
    for n in range(CORNERS):
        angle = 2 * math.pi * n / CORNERS
        aside = abs(math.remainder(angle - row.split_angle, math.pi))
        back = factor * depth * max(0.0, 1 - aside / half) if row.seat == "shells" and half else 0.0
        points.append(_at(bore + min(back, 0.9 * wall), angle))
    return tuple(points)


def _split(row: BearingRow, bore: Metre, outside: Metre, metal: Metre) -> Iterator[Mark]:
    """Where the halves meet, and the joint of the housing."""
    if row.seat != "shells":
        return
    key = row_key(row.name, BearingRow.split_angle)
    for angle in (row.split_angle, row.split_angle + math.pi):
        yield Polyline(OUTLINE, (_at(bore, angle), _at(outside, angle)), key=key)
        yield Polyline(AXIS, (_at(outside, angle), _at(1.06 * metal, angle)), key=key)


def _governing(row: BearingRow, checks: dict[str, Check]) -> tuple[Text, Check] | None:
    """What limits the seat: the check that has least left of what it is judged by."""
    words = {SEAT_STRESS: Text("housing"), BUSH_STRESS: SEATS[row.seat], **PRESS}
    judging = [(word, checks[id]) for rule, word in words.items() if (id := rule.of(row.name)) in checks]
    return min(judging, key=lambda one: one[1].margin, default=None)


def _said(place: str, seat: SeatResult, governing: tuple[Text, Check] | None, metal: Metre) -> Iterator[Mark]:
    """To the right: what limits the seat, from where on it is loose, how it is pressed."""
    x, key = 1.25 * metal, _keys(place, BearingRow.interference, BearingRow.crush, BearingRow.crush_load)
    if governing is not None:
        ring, check = governing
        words = Text(
            "{ring} {value} of {limit}",
            ring=ring,
            value=Amount(check.value, digits=3),
            limit=Amount(check.nearest[1], check.unit, digits=3),
        )
        yield Words(WORDS, (x, 0.6 * metal), words, key=key, state=judged([check], check.id))
    loose = Text("tight when warm")
    if seat.loose_at is not None:
        loose = Text("loose from {T}", T=Amount(seat.loose_at, "°C", form=".0f"))
    yield Words(WORDS, (x, 0.0), loose, key=_keys(place, BearingRow.retained))
    cold, hot = Amount(seat.press / 1e6, digits=2), Amount(seat.press_hot / 1e6, "MPa", digits=2)
    warm = f"{key} {dotted('bearings', BearingsInputs.housing_temperature)}"
    yield Words(WORDS, (x, -0.6 * metal), Text("press {cold}, hot {hot}", cold=cold, hot=hot), key=warm)


# --- the chain of dimensions
# Across a diameter, the journal on one side of its bore; widths are for the eye alone.

LONG, HIGH, LEVEL = 10.0, 1.2, 1.2  # of the row of parts, and of one dimension below another
WALL_WIDE, OPEN = 2.0, 2.5  # of a wall, of the clearance; the rest is the journal's


def _chain(place: str, r: "PlainResult") -> Sketch:
    """Bore above; walls, clearance and journal below."""
    parts, (least, most) = stack_parts(r.seat), ends_of(r.seat)
    bore, wall = parts[0], next((part for part in parts if part.times == -2), None)
    journal = next(part for part in parts if part.times == -1)
    row = [(Text("wall"), WALL_WIDE, (wall.least, wall.most), _keys(place, BearingRow.wall))] if wall else []
    wide = LONG - OPEN - 2 * WALL_WIDE * len(row)
    of_journal = (journal.least, journal.most)
    chain = [
        *row,
        (Text("clearance"), OPEN, (least, most), ""),
        (Text("journal"), wide, of_journal, _keys(place, BearingRow.journal)),
    ]
    x, marks = 0.0, list[Mark]()
    for n, (name, wide, limits, key) in enumerate([*chain, *row]):
        box = rectangle(x, 0.0, x + wide, HIGH)
        if key:  # the clearance is no part
            marks.append(Area(OUTLINE, (box,), 0.7 if wide == WALL_WIDE else 0.35, key))
        marks.append(Polyline(OUTLINE, box, True, key))
        if n < len(chain):  # the other wall is as the first
            marks.append(_dimension(name, limits, (x, x + wide), 0.0, -LEVEL * (n + 1), key))
        x += wide
    over = _keys(place, BearingRow.bore, BearingRow.finished)
    marks.append(_dimension(Text("bore"), (bore.least, bore.most), (0.0, LONG), HIGH, HIGH + LEVEL, over))
    notes = [Text("stack: least to most, not to scale")]
    if (rise := parts[-1]).times > 0 and rise is not bore:
        low, high = (Amount(end * 1e6, form=".1f") for end in (rise.least, rise.most))
        several = low.written() != high.written()
        added = Text("{low} to {high} µm", low=low, high=high) if several else Text("{rise} µm", rise=low)
        notes.append(Text("{place}: the press adds {added}", place=called(place), added=added))
    title = Text("{place}: stack, mm", place=called(place))
    return Sketch(tuple(marks), tuple(notes), title=title)


def _dimension(name: Text, limits: Range, ends: tuple[Metre, Metre], side: Metre, level: Metre, key: str) -> Dimension:
    low, high = (Amount(end * 1e3, form=".3f") for end in limits)
    label = Text("{part} {least}–{most}", part=name, least=low, most=high)
    return Dimension(DIMENSIONS, (ends[0], side), (ends[1], side), (ends[0], level), label=label, key=key)
