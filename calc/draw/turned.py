# SPDX-License-Identifier: Apache-2.0
"""What of a solved design stands on the drawing of its shaft: its pieces with their sizes, surfaces, datums and
geometrical tolerances; and what the design does not say."""

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from ..library.tolerances import LARGEST, ToleranceField, deviations
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import UNITS, Metre
from . import defaults
from .indications import Characteristic
from .shaft_outline import drawn
from .sizes import Size, diameter, number

if TYPE_CHECKING:
    from ..bearings.support import TurnedJournal
    from ..countershaft.outline import Piece
    from ..countershaft.result import CountershaftResult
    from ..gears.result import WheelResult
    from ..solve import Results

GIVEN = ("journal", "gear", "full")  # pieces whose length and diameter the design gives
DATUMS = "A", "B"  # the axes of the first and the last journal
TOGETHER = "A–B"
Limit = tuple[Characteristic, Metre, str]  # what of a surface is limited, how wide the zone is, about which datum


@record
class TurnedPiece:
    """A piece of the shaft as it is drawn: where it begins and ends, how large it is, and what is written on it.

    `radius`: what is seen, of a gear that of its tips; `texture`: Ra in micrometres; `functional`: a gear, or where a
    bearing stands."""

    piece: "Piece"
    start: Metre
    end: Metre
    radius: Metre
    size: Size | None = None
    texture: Text | None = None
    datum: str = ""
    zones: tuple[Limit, ...] = ()
    functional: bool = False


def shaft_wheel(results: "Results") -> "WheelResult | None":
    """The wheel on the shaft; none where a sprocket alone turns it."""
    train, shaft = results.train, results.design.countershaft
    if train is None or shaft is None or shaft.name not in train.shafts:
        return None
    return train.wheels.get(train.shafts[shaft.name].wheel)


def turned(results: "Results", solved: "CountershaftResult") -> list[TurnedPiece]:
    """The pieces front to rear, each beginning where the last one ends; what the design gives keeps its length."""
    assert solved.outline is not None
    pieces = drawn(solved.outline)
    # where two pieces meet rounding may leave a step, and that of the one that the design gives counts
    between = (a.end if a.what in GIVEN else b.start for a, b in pairwise(pieces))
    ends = [pieces[0].start, *between, solved.outline.end]
    return [_piece(results, piece, *stretch) for piece, stretch in zip(pieces, pairwise(ends))]


def _piece(results: "Results", piece: "Piece", start: Metre, end: Metre) -> TurnedPiece:
    shaft, wheel = results.design.countershaft, shaft_wheel(results)
    assert shaft is not None
    if piece.what == "gear" and wheel is not None:
        judged = bool(journals(results))  # else there are no datums
        zones: tuple[Limit, ...] = (("run-out", wheel.tolerances.runout, TOGETHER),) if judged else ()
        return TurnedPiece(piece, start, end, wheel.tip_diameter / 2, tips(wheel), zones=zones, functional=True)
    if piece.what not in GIVEN:
        return TurnedPiece(piece, start, end, piece.outer_radius)
    d = 2 * piece.outer_radius
    row = next((row for row in shaft.bearings if start <= row.position <= end), None)
    journal = None if row is None else journals(results).get(row.name)
    if row is None or journal is None:
        return TurnedPiece(piece, start, end, piece.outer_radius, diameter(d), functional=row is not None)
    texture = None if journal.texture is None else roughness(journal.texture)
    ends_of_shaft = {shaft.bearings[0].name: DATUMS[0], shaft.bearings[-1].name: DATUMS[1]}
    return TurnedPiece(
        piece,
        start,
        end,
        piece.outer_radius,
        fitted(journal, d),
        texture,
        ends_of_shaft.get(row.name, ""),
        _zones(journal, d),
        functional=True,
    )


def journals(results: "Results") -> "dict[str, TurnedJournal]":
    """How the place of each bearing is turned, by its name; empty where the design has no bearings to be judged."""
    bearings = results.design.bearings
    if bearings is None:
        return {}
    return {row.name: results.kind_of(row).turned(row, bearings) for row in results.design.rows}


def tips(wheel: "WheelResult") -> Size:
    """The tip diameter of a wheel, with its tolerance; where the design gives none, with that of the draughtsman."""
    d, low, high = wheel.tip_diameter, wheel.tip_diameter_min, wheel.tip_diameter_max
    if low is None or high is None:
        return in_field(d, defaults.TIP_FIELD)
    return diameter(d, deviations=(low - d, high - d))


def in_field(d: Metre, field: ToleranceField) -> Size:
    """A diameter with its field, and with the deviations of that, without either beyond the range of ISO 286; a width
    alone has no name there."""
    if UNITS["mm"].shown(d) > LARGEST:
        return diameter(d)
    return diameter(d, f" {field}" if field.letter else "", deviations(field, d))


def fitted(journal: "TurnedJournal", d: Metre) -> Size:
    if journal.limits is not None:
        low, high = journal.limits
        return diameter(d, deviations=(low - d, high - d))
    return diameter(d) if journal.field is None else in_field(d, journal.field)


def _zones(journal: "TurnedJournal", d: Metre) -> tuple[Limit, ...]:
    """How round and straight a journal is, and how true it runs about the axis of the outer two."""
    if (limits := fitted(journal, d).deviations) is None:
        return ()
    width = limits[1] - limits[0]
    form = defaults.share(width, defaults.FORM) if journal.form is None else journal.form
    return ("cylindricity", form, ""), ("run-out", defaults.share(width, defaults.RUNOUT), TOGETHER)


def roughness(Ra: Metre) -> Text:
    return Text("Ra {ra}", ra=number(UNITS["µm"].shown(Ra), 2))


def missing(results: "Results", pieces: list[TurnedPiece]) -> Iterator[Text]:
    """What a drawing needs and this design does not give; nothing is put in its place."""
    bearings, shaft, found = results.design.bearings, results.design.countershaft, journals(results).values()
    if not found or any(journal.limits is None and journal.field is None for journal in found):
        yield Text("fits of the journals")
    if not found or any(journal.texture is None for journal in found):
        yield Text("roughness of the journals")
    yield Text("heat treatment of the journals")
    if (wheel := shaft_wheel(results)) is not None:
        yield from _of_gear(results, wheel, pieces)
    if shaft is not None and shaft.fillet_radius is None:
        yield Text("fillets")
    if shaft is not None and shaft.holes is not None:
        yield Text("places of the calibration holes along the shaft")
    rows = results.design.rows if bearings is not None else ()
    if bearings is not None and any(row.fed() and bearings.of(row).supply == "shaft" for row in rows):
        yield Text("oil ways in the shaft")


def _of_gear(results: "Results", wheel: "WheelResult", pieces: list[TurnedPiece]) -> Iterator[Text]:
    """Where it stands, how its teeth stand to the masses, and how its cutter gets past what reaches higher than its
    roots beside it."""
    layout = results.train.layout if results.train is not None else None
    if layout is None or wheel.name not in layout.wheels or layout.wheels[wheel.name].tooth_angle is None:
        yield Text("angle of the teeth to the masses")
    places = [n for n, piece in enumerate(pieces) if piece.piece.what == "gear"]
    if not places:
        yield Text("place and seat of the gear")
    beside = [pieces[n + way] for n in places for way in (-1, 1) if 0 <= n + way < len(pieces)]
    if any(piece.radius > wheel.root_diameter / 2 for piece in beside):
        yield Text("run-out of the gear cutter")
