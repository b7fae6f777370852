# SPDX-License-Identifier: Apache-2.0
"""What the drawing of a shaft says of its rolling bearings: the fits they sit with, the raceways that the shaft is, and
which bearings are bought."""

from collections.abc import Iterator, Mapping

from ...countershaft.rows import BearingRow
from ...draw.annotations import COLUMNS, Rows, SheetTable
from ...draw.sizes import Say, deviated, millimetres, number
from ...library.tolerances import deviations
from ...sheet.text import Text
from ...sheet.units import UNITS
from ..inputs import BearingsInputs
from ..support import TurnedJournal
from .bearing import RollingBearing
from .clearance import fields_of
from .raceway import roundness_needed, seat_form

LIST = (24.0, 40.0, 24.0, 24.0)  # of the list of bearings: place, size, clearance, mass


def turned(row: BearingRow, inputs: BearingsInputs) -> TurnedJournal:
    size = row.outline
    assert size is not None  # asked of the file
    on_shaft = fields_of(size.type, size.inner_ring, row.shaft_fit, row.seat_fit)[0]
    if size.inner_ring:
        return TurnedJournal(field=on_shaft, form=seat_form(size.bore))
    return TurnedJournal(field=on_shaft, texture=row.raceway_roughness, form=roundness_needed(F_w=size.bore))


def on_drawing(results: Mapping[str, RollingBearing], inputs: BearingsInputs, say: Say) -> Iterator[SheetTable]:
    seats: Rows = []
    bearings: Rows = [tuple(map(say, (Text("Place"), Text("Size"), Text("Clearance"), Text("kg each"))))]
    for r in results.values():
        seats += [(say(label), say(words)) for label, words in _of_seat(r.row)]
        limits = r.row.clearance_limits
        before = Text("{word}", word=r.row.clearance_class)
        if limits is not None:
            low, high = (number(UNITS["µm"].shown(limit), 0) for limit in limits)
            before = Text("{low}–{high} µm", low=low, high=high)
        if not r.case.size.inner_ring and limits is None:
            before = Text("by the fits")
        cells = (r.row.in_words, r.row.size_words(), before, Text("{kg}", kg=number(r.bearing_mass, 3)))
        bearings.append(tuple(map(say, cells)))
    yield say(Text("Seats of the rolling bearings, at 20 °C")), seats, COLUMNS
    yield say(Text("Rolling bearings, ISO 492 class normal")), bearings, LIST


def _of_seat(row: BearingRow) -> Iterator[tuple[Text, Text]]:
    size, place = row.outline, row.in_words
    assert size is not None
    seat = fields_of(size.type, size.inner_ring, row.shaft_fit, row.seat_fit)[1]
    across = Text("⌀{D} {field}", D=millimetres(size.outside), field=str(seat))
    seat_words = Text("Raceway in the housing, {place}", place=place)
    if size.type != "cage":
        seat_words = Text("Seat in the housing, {place}", place=place)
    yield seat_words, deviated(across, *deviations(seat, size.outside))
    if row.outer_ring_held != "fit" and size.type != "cage":
        yield Text("Outer ring held by, {place}", place=place), Text("{how}", how=Text(row.outer_ring_held))
    if size.inner_ring:
        return
    hard = Text("at least {HV} HV", HV=number(row.raceway_hardness, 0))
    if row.case_depth is not None:
        deep = number(UNITS["mm"].shown(row.case_depth), 2)
        hard = Text("at least {HV} HV, {deep} mm deep", HV=number(row.raceway_hardness, 0), deep=deep)
    yield Text("Raceway on the shaft, {place}", place=place), hard
    most = number(UNITS["µm"].shown(roundness_needed(F_w=size.bore)), 1)
    yield Text("Roundness, {place}", place=place), Text("IT3, {most} µm", most=most)
