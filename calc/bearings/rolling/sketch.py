# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings as a sketch: each as half a section through its axis, to scale, on its shaft and in its seat.

Rings are hatched, elements outlined.  The load stands on the inner ring: its arrow turns with the shaft, and the dot
marks where it stands."""

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from ...countershaft.rows import BearingRow, called, row_key
from ...draw.drawing import (
    AXIS,
    CONTEXT,
    OUTLINE,
    WORDS,
    Arc,
    Area,
    Hatch,
    Mark,
    Point,
    Polyline,
    Sketch,
    State,
    Words,
    hatch_lines,
    judged,
    rectangle,
    round_outline,
)
from ...sheet.check import Check
from ...sheet.quantity import dotted
from ...sheet.record import replace
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Number
from ..inputs import BearingsInputs
from .checks import CLEARANCE_LEAST, CLEARANCE_START, GRIP_HOT, LIFE, LIFE_ASSUMED
from .clearance import usual_fits

if TYPE_CHECKING:
    from .bearing import RollingBearing

METAL: Number = 0.16  # of the seat's diameter: of the housing no more is drawn
ROOM: Number = 0.6  # of the width of the bearing: how far shaft and housing are drawn on either side
SHOULDER: Number = 0.2  # of the diameter of balls: how far from the pitch circle a ring ends
RIB: Number = 0.3  # of the diameter of rollers: how high a rib stands over its raceway
LIP: Number = 0.5  # of the wall of a cup: how thick its lips are
INSERT: Number = 0.06  # of the seat's diameter
LINES: Number = 0.055  # of the seat's diameter: from one line of a hatching to the next
CORNERS = 12  # of a groove


def pictures(results: "Mapping[str, RollingBearing]", checks: dict[str, Check]) -> dict[str, Sketch]:
    """Each bearing by itself."""
    drawn = {place: Sketch(tuple(_bearing(place, r, checks)), title=_title(place, r)) for place, r in results.items()}
    first = next(iter(drawn))
    notes = (Text("to scale"), Text("load at the dot"))
    return drawn | {first: replace(drawn[first], notes=notes)}


def _title(place: str, r: "RollingBearing") -> Text:
    return Text(
        "{place} {size}, {count} {elements}",
        place=called(place),
        size=r.case.size.designation,
        count=0 if r.case.inside is None else round(float(r.case.inside.count)),
        elements=Text("balls") if r.case.size.elements == "ball" else Text("rollers"),
    )


def _keys(place: str, *declared: object) -> str:
    return " ".join(row_key(place, key) for key in declared)


def _bearing(place: str, r: "RollingBearing", checks: dict[str, Check]) -> Iterator[Mark]:
    size, inside, half = r.case.size, r.case.inside, r.case.size.width / 2
    seat, shaft = size.outside / 2, size.bore / 2
    room = (1 + 2 * ROOM) * half
    insert = INSERT * size.outside if r.row.outer_ring_held == "insert" else 0.0
    grip = judged(checks.values(), GRIP_HOT.of(place))
    sized = _keys(place, BearingRow.size)
    held = _keys(place, BearingRow.outer_ring_held, BearingRow.seat_fit, BearingRow.housing_outer)
    fitted = _keys(place, BearingRow.shaft_fit)
    hollow = r.case.solids.shaft_bore / 2
    on_shaft = rectangle(-room, hollow, room, shaft)
    yield Area(CONTEXT, (on_shaft,), 0.2, fitted)
    for y in (hollow, shaft) if hollow else (shaft,):
        yield Polyline(OUTLINE, ((-room, y), (room, y)), key=fitted)
    metal = seat + METAL * size.outside
    yield Area(CONTEXT, (rectangle(-room, seat + insert, room, metal),), 0.2, f"{held} {_housing(r)}")
    yield Polyline(OUTLINE, ((-room, seat), (room, seat)), key=held, state=grip)
    if insert:
        yield from _cut(rectangle(-room, seat, room, seat + insert), held, size.outside, grip)
    yield Polyline(AXIS, ((-1.1 * room, 0.0), (1.1 * room, 0.0)))
    if inside is not None:
        for ring, key in _rings(r, held, sized):
            yield from _cut(ring, key, size.outside)
        yield from _element(place, r, judged(checks.values(), LIFE.of(place), LIFE_ASSUMED.of(place)))
    else:
        yield Polyline(OUTLINE, rectangle(-half, shaft, half, seat), True, sized)
    yield from _load(place, r, room)
    yield from _said(place, r, checks, room)


def _housing(r: "RollingBearing") -> str:
    if r.row.housing_material is not None:
        return row_key(r.row.name, BearingRow.housing_material)
    return dotted("bearings", BearingsInputs.housing_material)


def _cut(outline: tuple[Point, ...], key: str, D: Metre, state: State = "") -> Iterator[Mark]:
    """What is cut, hatched."""
    for line in hatch_lines(Hatch(CONTEXT, (outline,), LINES * D)):
        yield Polyline(CONTEXT, line, key=key)
    yield Polyline(OUTLINE, outline, True, key, state)


def _rings(r: "RollingBearing", held: str, sized: str) -> Iterator[tuple[tuple[Point, ...], str]]:
    """The rings that there are, inner one first."""
    size, inside = r.case.size, r.case.inside
    assert inside is not None
    half, shaft, seat = size.width / 2, size.bore / 2, size.outside / 2
    D_w, middle = inside.diameter, inside.pitch / 2
    inner, outer = middle - D_w / 2, middle + D_w / 2
    if size.type == "ball":
        yield _grooved(half, shaft, middle, -1, D_w), sized
        yield _grooved(half, seat, middle, 1, D_w), held
        return
    within = min(inside.roller_length / 2 * 1.04, 0.92 * half)
    if size.inner_ring and size.type in ("roller", "needle"):
        rib = inner + RIB * D_w if size.flanged else inner
        yield (*((-half, shaft), (half, shaft), (half, inner), (-within, inner), (-within, rib), (-half, rib)),), sized
    if size.type == "cage":
        return
    rib = outer - RIB * D_w if size.type != "cup" else inner + 0.1 * D_w
    within = within if size.type != "cup" else half - LIP * (seat - outer)
    yield (
        (
            *((-half, seat), (half, seat), (half, rib), (within, rib)),
            *((within, outer), (-within, outer), (-within, rib), (-half, rib)),
        ),
        held,
    )


def _grooved(half: Metre, side: Metre, middle: Metre, way: int, D_w: Metre) -> tuple[Point, ...]:
    """A ring of a ball bearing: `side` is its bore or outside, `way` +1 outward."""
    shoulder = middle + way * SHOULDER * D_w
    end = math.acos(2 * SHOULDER)
    turns = [end - 2 * end * n / CORNERS for n in range(CORNERS + 1)]
    groove = [(D_w / 2 * math.sin(turn), middle + way * D_w / 2 * math.cos(turn)) for turn in turns]
    return ((-half, side), (half, side), (half, shoulder), *groove, (-half, shoulder))


def _element(place: str, r: "RollingBearing", state: State) -> Iterator[Mark]:
    inside = r.case.inside
    assert inside is not None
    key = _keys(
        place,
        BearingRow.element_count,
        BearingRow.element_diameter,
        BearingRow.element_length,
        BearingRow.pitch_diameter,
    )
    middle, D_w = inside.pitch / 2, inside.diameter
    if inside.elements == "ball":
        yield Arc(OUTLINE, (0.0, middle), D_w / 2, key=key, state=state)
        return
    half = inside.roller_length / 2
    yield Polyline(OUTLINE, rectangle(-half, middle - D_w / 2, half, middle + D_w / 2), True, key, state)
    yield Polyline(AXIS, ((-half, middle), (half, middle)), key=key)


def _load(place: str, r: "RollingBearing", room: Metre) -> Iterator[Mark]:
    """From the axis to the ring on which it stands, and how it turns."""
    key, shaft = row_key(place, BearingRow.load), r.case.size.bore / 2
    inner = shaft if r.case.inside is None else (r.case.inside.pitch - r.case.inside.diameter) / 2
    dot = 0.035 * r.case.size.outside
    yield Polyline(OUTLINE, ((0.0, 0.08 * shaft), (0.0, shaft)), key=key, arrow=True)
    yield Area(OUTLINE, (round_outline((0.0, inner - dot if inner - dot > shaft else shaft), dot / 2, 12),), 1.0, key)
    wide, high = 0.12 * room, 0.62 * shaft
    turns = [math.pi * n / CORNERS for n in range(CORNERS + 1)]
    about = tuple((wide * math.cos(turn) - 0.72 * room, high * math.sin(turn)) for turn in turns)
    yield Polyline(OUTLINE, about, key=key, arrow=True)
    load = Amount(r.load / 1000, "kN", digits=3) if r.load >= 1000 else Amount(r.load, "N", digits=3)
    yield Words(WORDS, (0.1 * room, 0.4 * shaft), Text("{load}", load=load), key=key)


def _said(place: str, r: "RollingBearing", checks: dict[str, Check], room: Metre) -> Iterator[Mark]:
    """To the right: diameters with their fits, and the clearance."""
    size, x = r.case.size, 1.12 * room
    shaft_fit, seat_fit = usual_fits(size.type, size.inner_ring)
    grip = judged(checks.values(), GRIP_HOT.of(place))
    on_shaft = Text("Ø{d} {fit}", d=Amount(size.bore * 1e3, form="g"), fit=r.row.shaft_fit or shaft_fit)
    in_seat = Text("Ø{d} {fit}", d=Amount(size.outside * 1e3, form="g"), fit=r.row.seat_fit or seat_fit)
    held = _keys(place, BearingRow.seat_fit, BearingRow.outer_ring_held)
    yield Words(WORDS, (x, size.bore / 2), on_shaft, key=_keys(place, BearingRow.shaft_fit))
    yield Words(WORDS, (x, size.outside / 2), in_seat, key=held, state=grip)
    if r.clearance_running is not None:
        key = _keys(place, BearingRow.clearance_class, BearingRow.clearance_limits)
        state = judged(checks.values(), CLEARANCE_LEAST.of(place), CLEARANCE_START.of(place))
        gap = Text("gap {s}", s=Amount(r.clearance_running * 1e6, "µm", digits=2))
        yield Words(WORDS, (x, (size.bore + size.outside) / 4), gap, key=key, state=state)
