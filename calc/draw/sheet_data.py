# SPDX-License-Identifier: Apache-2.0
"""What stands beside the views: the data of the teeth (ISO 1340, symbols of ISO 21771), balancing, masses, notes.

Balancing as ISO 21940-11 has it."""

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING

from ..library.tolerances import ISO, deviations
from ..sheet.quantity import published
from ..sheet.record import record
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import UNITS, KilogramMetre, Metre
from .annotations import ALIKE, Rows, Say, alone, degrees, deviated, millimetres, number
from .shaft_outline import drawn

if TYPE_CHECKING:
    from ..countershaft.outline import Piece
    from ..countershaft.result import CountershaftResult
    from ..friction.inputs import FrictionInputs
    from ..gears.inputs import GearsInputs
    from ..gears.result import TrainResult, WheelResult
    from ..solve import Results


# --- what of a solved design stands on the drawing of its shaft
# Its pieces with their sizes, and what the design does not say.

GIVEN = ("journal", "gear", "full")  # pieces whose length and diameter the design gives


@record
class TurnedPiece:
    """A piece of the shaft as it is drawn: where it begins and ends, how large it is, and what is written on it.

    `radius`: what is seen, of a gear that of its tips; `texture`: Ra in micrometres.
    """

    piece: "Piece"
    start: Metre
    end: Metre
    radius: Metre
    label: Text | None = None
    texture: Text | None = None


def shaft_wheel(results: "Results") -> "WheelResult | None":
    """The wheel on the shaft; none where a sprocket alone turns it."""
    train, shaft = results.train, results.design.countershaft
    if train is None or shaft is None or shaft.name not in train.shafts:
        return None
    return train.wheels.get(train.shafts[shaft.name].wheel)


def turned(results: "Results", solved: "CountershaftResult") -> list[TurnedPiece]:
    """The pieces front to rear, each beginning where the last one ends; what the design gives keeps its length."""
    shaft, wheel = results.design.countershaft, shaft_wheel(results)
    assert solved.outline is not None and shaft is not None
    pieces = drawn(solved.outline)
    # where two pieces meet rounding may leave a step, and that of the one that the design gives counts
    between = (a.end if a.what in GIVEN else b.start for a, b in pairwise(pieces))
    ends = [pieces[0].start, *between, solved.outline.end]
    turned_pieces = []
    for piece, (start, end) in zip(pieces, pairwise(ends)):
        radius, label, texture = piece.outer_radius, None, None
        if piece.what == "gear" and wheel is not None:
            radius, label = wheel.tip_diameter / 2, tips(wheel)
        elif piece.what in GIVEN:
            support = next((z for z in shaft.bearing_positions if start <= z <= end), None)
            label, texture = _cylinder(results, piece, support)
        turned_pieces.append(TurnedPiece(piece, start, end, radius, label, texture))
    return turned_pieces


def _diameter(radius: Metre) -> Text:
    return Text("⌀{diameter}", diameter=millimetres(2 * radius))


def tips(wheel: "WheelResult") -> Text:
    """The tip diameter of a wheel, with its tolerance where the design gives one."""
    size, low, high = _diameter(wheel.tip_diameter / 2), wheel.tip_diameter_min, wheel.tip_diameter_max
    return size if low is None or high is None else deviated(size, low - wheel.tip_diameter, high - wheel.tip_diameter)


def _cylinder(results: "Results", piece: "Piece", support: Metre | None) -> tuple[Text, Text | None]:
    """Its diameter; where it runs in a bearing with its fit, as far as the design gives one, and its roughness."""
    size, bearings, shaft = _diameter(piece.outer_radius), results.design.bearings, results.design.countershaft
    if bearings is None or shaft is None or support is None:
        return size, None
    bearing = next(row for row in shaft.bearings if row.position == support)
    journal = results.kind_of(bearing).turned(bearing, bearings)
    if journal.limits is not None:
        size = deviated(size, *(limit - 2 * piece.outer_radius for limit in journal.limits))
    elif (field := journal.field) is not None:
        named = Text("{size} {field}", size=size, field=str(field)) if field.letter else size
        size = deviated(named, *deviations(field, 2 * piece.outer_radius))
    return size, None if journal.texture is None else _roughness(journal.texture)


def _roughness(Ra: Metre) -> Text:
    return Text("Ra {ra}", ra=number(UNITS["µm"].shown(Ra), 2))


def missing(results: "Results") -> Iterator[Text]:
    """What a drawing needs and this design does not give; nothing is put in its place."""
    bearings, shaft = results.design.bearings, results.design.countershaft
    rows = results.design.rows if bearings is not None else ()
    journals = [results.kind_of(row).turned(row, bearings) for row in rows if bearings is not None]
    if not journals or any(journal.limits is None and journal.field is None for journal in journals):
        yield Text("fits of the journals")
    if not journals or any(journal.texture is None for journal in journals):
        yield Text("roughness of the journals")
    yield Text("heat treatment")
    yield Text("general and geometrical tolerances")
    yield Text("roughness elsewhere")
    yield Text("chamfers and centre holes")
    if shaft is not None and shaft.fillet_radius is None:
        yield Text("fillets")
    if shaft is not None and shaft.holes is not None:
        yield Text("places of the calibration holes")
    if bearings is not None and any(row.fed() and bearings.of(row).supply == "shaft" for row in rows):
        yield Text("oil ways in the shaft")


# --- the tables and notes

PART_DRAWING = Text("Part drawing")
HANDS = {"left": Text("left"), "right": Text("right")}
SIZE = 3  # decimals of a tooth's sizes


def gear_rows(results: "Results", wheel: "WheelResult", say: Say) -> Rows:
    """A label and what is said, in the order in which a gear is cut, measured and paired."""
    train, gears = results.train, results.design.gears
    assert train is not None and gears is not None
    rows = [*_teeth(train, wheel, gears), *_sizes(wheel), *_mates(train, wheel)]
    if (friction := results.design.friction) is not None and (Ra := _flanks(friction, train, wheel.name)) is not None:
        rows.append((Text("Roughness of the flanks"), _roughness(Ra)))
    wheel_inputs = next(inputs for inputs in gears.wheels if inputs.name == wheel.name)
    if wheel_inputs.gear_material is not None:
        rows.append((Text("Strength class, ISO 6336-5"), Name(wheel_inputs.gear_material)))
    if wheel_inputs.hardness is not None:
        rows.append((Text("Surface hardness"), Text("{hardness} HV", hardness=number(wheel_inputs.hardness, 0))))
    return [(say(label), say(value)) for label, value in rows]


def _teeth(train: "TrainResult", wheel: "WheelResult", gears: "GearsInputs") -> Iterator[tuple[Text, Text]]:
    s = train.system
    yield Text("Normal module"), alone(millimetres(s.m_n, SIZE))
    yield Text("Number of teeth"), Text("{z}", z=wheel.teeth)
    yield Text("Normal pressure angle"), degrees(s.alpha_n, SIZE)
    if s.beta:
        hand = HANDS[gears.hands()[wheel.name]]
        yield Text("Helix angle, hand"), Text("{angle}, {hand}", angle=degrees(s.beta, SIZE), hand=hand)
    tool = Text("{h} / {rho} modules", h=number(s.h_aP0, SIZE), rho=number(s.rho_aP0, SIZE))
    yield Text("Tool: addendum, tip radius"), tool
    yield Text("Profile shift"), alone(number(wheel.profile_shift, 4))
    yield Text("Accuracy grade, ISO 1328-1"), Text("{grade}", grade=gears.accuracy_grade)


def _sizes(wheel: "WheelResult") -> Iterator[tuple[Text, Text]]:
    yield Text("Reference diameter"), alone(millimetres(wheel.reference_diameter, SIZE))
    yield Text("Base diameter"), alone(millimetres(wheel.base_diameter, SIZE))
    yield Text("Root diameter"), _from_to(wheel.root_diameter, wheel.root_diameter_min, wheel.root_diameter_max)
    known = {value.id.removeprefix("."): value for value in published(wheel, "")}
    span = f"span_{round(wheel.span_teeth)}"
    if span in known:
        size = alone(number(known[span].shown, SIZE))
        if wheel.allowance is not None:
            size = deviated(size, min(wheel.allowance), max(wheel.allowance))
        yield Text("Span over {k} teeth", k=round(wheel.span_teeth)), size
    if wheel.over_balls is not None:
        label = Text("Size over balls ⌀{ball}", ball=millimetres(wheel.ball_diameter, SIZE))
        yield label, _from_to(wheel.over_balls, wheel.over_balls_min, wheel.over_balls_max)


def _from_to(size: float, low: float | None, high: float | None) -> Text:
    if low is None or high is None or abs(high - low) < ALIKE:
        return alone(millimetres(size, SIZE))
    return Text("{low} to {high}", low=millimetres(low, SIZE), high=millimetres(high, SIZE))


def _mates(train: "TrainResult", wheel: "WheelResult") -> Iterator[tuple[Text, Text]]:
    for mate, _, mesh in train.mates(wheel.name):
        yield Text("Mating wheel, teeth"), Text("{mate}, {z}", mate=Name(mate), z=train.wheels[mate].teeth)
        size, tolerance = alone(millimetres(mesh.centre_distance, SIZE)), mesh.centre_tolerance
        yield Text("Centre distance"), deviated(size, -tolerance, tolerance) if tolerance else size


def _flanks(friction: "FrictionInputs", train: "TrainResult", wheel: str) -> float | None:
    """Ra of the flanks of one wheel: that of all, or that of its place in its first mesh."""
    Ra = friction.flank_roughness
    if len(Ra) == 1:
        return Ra[0]
    pairs = ((mesh.driver, mesh.driven) for mesh in train.meshes.values())
    return next((Ra[pair.index(wheel)] for pair in pairs if wheel in pair), None)


def balance_rows(results: "Results", solved: "CountershaftResult", say: Say) -> Rows:
    """The grade, the speed that it is for, and what it permits in each plane; empty where the mass of the shaft is not
    known."""
    permitted, shaft = solved.tolerance, results.design.countershaft
    if permitted is None or shaft is None:
        return []
    front, rear = shaft.bearing_positions[0], shaft.bearing_positions[-1]
    rpm = number(UNITS["rpm"].shown(abs(solved.omega) / (2 * math.pi)), 0)
    rows = (
        (Text("Quality grade, {iso}", iso=ISO), Text("{grade}", grade=shaft.balance_grade)),
        (Text("at the service speed"), Text("{n} rpm", n=rpm)),
        (Text("Permitted residual unbalance"), _unbalance(permitted.residual_unbalance_permitted)),
        (Text("in plane I, z {z}", z=millimetres(front)), _unbalance(permitted.residual_unbalance_permitted_front)),
        (Text("in plane II, z {z}", z=millimetres(rear)), _unbalance(permitted.residual_unbalance_permitted_rear)),
    )
    return [(say(label), say(value)) for label, value in rows]


def _unbalance(U: KilogramMetre) -> Text:
    """Rounded down to three digits: never more than is permitted."""
    shown = UNITS["g·mm"].shown(U)
    return Text("{u} g·mm", u=Amount(float(f"{shown:.3g}"), form=".12g"))


def mass_rows(results: "Results", solved: "CountershaftResult", say: Say) -> Rows:
    """The eccentric masses as they are meant: the shaft is out of balance on purpose."""
    shaft = results.design.countershaft
    given = {mass.name: mass for mass in shaft.masses} if shaft is not None else {}
    masses = dict(solved.sector) if solved.sector else given
    rows: Rows = [(say(Text("Mass")), say(Text("m, kg")), say(Text("e, mm")), say(Text("at")), say(Text("z, mm")))]
    for name, mass in masses.items():
        heavy, away, z = number(mass.mass, 3), millimetres(mass.radius, 3), millimetres(mass.z, 2)
        cells = (Name(name), alone(heavy), alone(away), degrees(mass.angle % (2 * math.pi)), alone(z))
        rows.append(tuple(map(say, cells)))
    return rows if len(rows) > 1 else []


def notes(
    results: "Results", solved: "CountershaftResult", up: float, data: Mapping[str, object] | None
) -> Iterator[Text]:
    """What is said in words, and at the end what a drawing needs and the design does not give."""
    shaft = results.design.countershaft
    assert shaft is not None
    yield Text("Dimensions in mm. z from mid-shaft, to the right towards the flywheel.")
    yield Text(
        "Views along the axis look towards the flywheel; the crank turns clockwise there. Up is {angle} from up with "
        "cylinder 1 at TDC, in "
        "the sense of crank rotation.",
        angle=degrees(up % (2 * math.pi)),
    )
    if solved.outline is not None and solved.outline.derived:
        yield Text(
            "Sectors follow from mass and centre of gravity of the eccentric masses; shoulders are put together from "
            "the design."
        )
    if shaft.bore_diameter:
        yield Text("Bored through, ⌀{d}.", d=millimetres(shaft.bore_diameter))
    if shaft.sector_material is not None:
        yield Text("Sectors of {material}.", material=shaft.sector_material)
    if solved.tolerance is not None:
        yield Text(
            "The residual unbalance is measured against the masses in the table, which are out of balance on purpose."
        )
    if shaft.holes is not None:
        yield Text(
            "{n} holes ⌀{d}, at most {h} deep, radial, evenly in the eccentric masses, drilled as the balancing asks.",
            n=shaft.holes.count,
            d=millimetres(shaft.holes.diameter),
            h=millimetres(shaft.holes.depth),
        )
    if shaft.fillet_radius is not None:
        yield Text("Fillets at the shoulders R{radius}.", radius=millimetres(shaft.fillet_radius))
    if (bearings := results.design.bearings) is not None and (clearances := _clearances(results)):
        yield Text(
            "Diametral clearance of the journals in their bearings at {T} °C: {clearances}.",
            T=number(UNITS["°C"].shown(bearings.clearance_reference_temperature), 1),
            clearances=COMMA.join(clearances),
        )
    yield from chosen(data, shaft=shaft.name, more=_assumed_fits(results))
    yield Text("Not given by the design: {what}.", what=COMMA.join(missing(results)))


def _assumed_fits(results: "Results") -> Iterator[Text]:
    """By which fit the journals are judged and drawn that the design gives none."""
    bearings = results.design.bearings
    rows = results.design.rows if bearings is not None else ()
    turned_rows = [(row, results.kind_of(row).turned(row, bearings)) for row in rows if bearings is not None]
    assumed = [(row, journal) for row, journal in turned_rows if journal.assumed and journal.limits is None]
    if assumed:
        fit, places = str(assumed[0][1].field), COMMA.join(row.in_words for row, _ in assumed)
        whole = len(assumed) == len(turned_rows)
        yield Text("{fit} of the journals" if whole else "{fit} of the journals {places}", fit=fit, places=places)


def _clearances(results: "Results") -> list[Text]:
    """Of each bearing that is judged, front to rear."""
    known = ((row.in_words, results.values().get(f"bearings.{row.name}.clearance")) for row in results.design.rows)
    return [Text("{g} µm {row}", g=number(value.shown, 0), row=row) for row, value in known if value is not None]


DEFAULTS = {
    "shafts.balance_grade": Text("the grade of balancing"),
    "gears.accuracy_grade": Text("the accuracy grade of the teeth"),
    "gears.ball_diameter_mm": Text("the measuring ball"),
}


def chosen(
    data: Mapping[str, object] | None, step: str = "", shaft: str = "", more: Iterable[Text] = ()
) -> Iterator[Text]:
    """What the program has put in where the file leaves it out; `step`: of one step only; `shaft`: of this one; `more`:
    what else it has put in."""
    known = [] if data is None else [(key, text) for key, text in DEFAULTS.items() if key.startswith(step)]
    if assumed := [*(text for key, text in known if not _given(data or {}, key, shaft)), *more]:
        yield Text("Chosen by the program, not by the design: {what}.", what=COMMA.join(assumed))


def _given(data: Mapping[str, object], key: str, shaft: str) -> bool:
    """Whether the file has a key, of shafts this one; one of a table that it does not have is not asked."""
    step, _, name = key.partition(".")
    table = data.get(step)
    if isinstance(table, list):
        table = next((there for there in table if there["name"] == shaft), None)
    return not isinstance(table, Mapping) or name in table
