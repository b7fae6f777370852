# SPDX-License-Identifier: Apache-2.0
"""What of a solved design stands on the drawing of its shaft: its pieces with their sizes, and what the design does not say."""

from collections.abc import Iterator
from itertools import pairwise

from ..bearings.inputs import ASSUMED_FIT
from ..draw.shaft_outline import drawn
from ..countershaft.outline import Piece
from ..countershaft.result import CountershaftResult
from ..library.fits import deviations, parse
from ..gears.result import TrainResult, WheelResult
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import UNITS, Metre
from ..solve import Results
from .saying import deviated, millimetres, number

GIVEN = ("journal", "gear", "full")  # pieces whose length and diameter the design gives


@record
class Turned:
    """A piece of the shaft as it is drawn: where it begins and ends, how large it is, and what is written on it.

    `radius`: what is seen, of a gear that of its tips; `texture`: Ra in micrometres.
    """

    piece: Piece
    start: Metre
    end: Metre
    radius: Metre
    label: Text | None = None
    texture: Text | None = None


def shaft_wheel(results: Results) -> WheelResult | None:
    """The wheel on the shaft: the last of the train."""
    train, gears = results.result(TrainResult), results.design.gears
    if train is None or gears is None or results.design.countershaft is None:
        return None
    return train.wheels[gears.meshes[-1].driven]


def turned(results: Results, solved: CountershaftResult) -> list[Turned]:
    """The pieces front to rear, each beginning where the last one ends; what the design gives keeps its length."""
    shaft, wheel = results.design.countershaft, shaft_wheel(results)
    assert solved.outline is not None and shaft is not None
    pieces = drawn(solved.outline)
    ends = [pieces[0].start, *(_between(a, b) for a, b in pairwise(pieces)), solved.outline.end]
    made = []
    for piece, (start, end) in zip(pieces, pairwise(ends)):
        radius, label, texture = piece.outer_radius, None, None
        if piece.what == "gear" and wheel is not None:
            radius, label = wheel.tip_diameter / 2, tips(wheel)
        elif piece.what in GIVEN:
            label, texture = _cylinder(results, piece, next((z for z in shaft.bearing_positions if start <= z <= end), None))
        made.append(Turned(piece, start, end, radius, label, texture))
    return made


def _between(a: Piece, b: Piece) -> Metre:
    """Where two pieces meet: rounding may leave a step, and that of the one that the design gives counts."""
    return a.end if a.what in GIVEN else b.start


def _diameter(radius: Metre) -> Text:
    return Text("⌀{diameter}", diameter=millimetres(2 * radius))


def tips(wheel: WheelResult) -> Text:
    """The tip diameter of a wheel, with its tolerance where the design gives one."""
    size, low, high = _diameter(wheel.tip_diameter / 2), wheel.tip_diameter_min, wheel.tip_diameter_max
    return size if low is None or high is None else deviated(size, low - wheel.tip_diameter, high - wheel.tip_diameter)


def _cylinder(results: Results, piece: Piece, support: Metre | None) -> tuple[Text, Text | None]:
    """Its diameter; where it runs in a bearing with its fit, as far as the design gives one, and its roughness."""
    size, own, shaft = _diameter(piece.outer_radius), results.design.bearings, results.design.countershaft
    if own is None or shaft is None or support is None:
        return size, None
    if own.journal_fit != ASSUMED_FIT:
        field = parse(own.journal_fit, "shaft")
        named = Text("{size} {field}", size=size, field=str(field)) if field.letter else size
        size = deviated(named, *deviations(field, 2 * piece.outer_radius))
    bearing = {shaft.bearing_positions[0]: own.front, shaft.bearing_positions[-1]: own.rear}.get(support)
    return size, None if bearing is None else Text("Ra {ra}", ra=number(UNITS["µm"].shown(bearing.journal_roughness), 2))


def missing(results: Results) -> Iterator[Text]:
    """What a drawing needs and this design does not give; nothing is put in its place."""
    own, shaft = results.design.bearings, results.design.countershaft
    if own is None or own.journal_fit == ASSUMED_FIT:
        yield Text("fits of the journals")
    if own is None:
        yield Text("roughness of the journals")
    yield Text("heat treatment")
    yield Text("general and geometrical tolerances")
    yield Text("roughness elsewhere")
    yield Text("chamfers and centre holes")
    if shaft is not None and shaft.fillet_radius is None:
        yield Text("fillets")
    if shaft is not None and shaft.holes is not None:
        yield Text("places of the calibration holes")
    if own is not None and own.supply == "shaft":
        yield Text("oil ways in the shaft")
