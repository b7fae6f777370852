# SPDX-License-Identifier: Apache-2.0
"""What stands beside the views of a shaft: balancing (ISO 21940-11), masses, and the notes."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from ..library.tolerances import ISO
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import UNITS, KilogramMetre
from . import defaults
from .annotations import Rows
from .gear_data import tooth_notes
from .sizes import Say, alone, degrees, millimetres, number
from .turned import TurnedPiece, journals, missing, shaft_wheel

if TYPE_CHECKING:
    from ..countershaft.result import CountershaftResult
    from ..solve import Results


PART_DRAWING = Text("Part drawing")


# --- the tables
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
    """The eccentric masses as they are meant: the shaft is out of balance on purpose; and within what its production
    keeps them."""
    shaft = results.design.countershaft
    given = {mass.name: mass for mass in shaft.masses} if shaft is not None else {}
    masses = dict(solved.sector) if solved.sector else given
    rows: Rows = [(say(Text("Mass")), say(Text("m, kg")), say(Text("e, mm")), say(Text("at")), say(Text("z, mm")))]
    for name, mass in masses.items():
        heavy, away, z = number(mass.mass, 3), millimetres(mass.radius, 3), millimetres(mass.z, 2)
        cells = (Name(name), alone(heavy), alone(away), degrees(mass.angle % (2 * math.pi)), alone(z))
        rows.append(tuple(map(say, cells)))
    if len(rows) > 1 and shaft is not None and (scatter := shaft.scatter) is not None:
        n = defaults.SIGMAS
        heavy, away, z = number(n * scatter.mass, 3), millimetres(n * scatter.radius, 3), millimetres(n * scatter.z, 2)
        turn = degrees(n * scatter.angle, 2)
        rows.append(tuple(map(say, (Text("±, {n} σ", n=n), alone(heavy), alone(away), turn, alone(z)))))
    return rows if len(rows) > 1 else []


def notes(
    results: "Results",
    solved: "CountershaftResult",
    pieces: list[TurnedPiece],
    up: float,
    data: Mapping[str, object] | None,
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
    for twin in results.design.resolved:
        if twin.how == "mirrors" and twin.of == shaft.name:
            yield Text(
                "The masses of {name}, the mirror image, stand at minus the angles in the table; its teeth do not: the "
                "gear data have theirs.",
                name=Name(twin.name),
            )
    if solved.outline is not None and solved.outline.derived:
        yield Text("Sectors follow from the eccentric masses; shoulders are put together from the design.")
    if shaft.bore_diameter:
        yield Text("Bored through, ⌀{d}.", d=millimetres(shaft.bore_diameter))
    if shaft.sector_material is not None:
        yield Text("Sectors of {material}.", material=shaft.sector_material)
    if solved.tolerance is not None:
        yield Text("The residual unbalance is measured against the masses in the table, which are meant.")
    if shaft.holes is not None:
        yield Text(
            "{n} holes ⌀{d}, at most {h} deep, radial, evenly in the masses, drilled as the balancing asks.",
            n=shaft.holes.count,
            d=millimetres(shaft.holes.diameter),
            h=millimetres(shaft.holes.depth),
        )
    if shaft.fillet_radius is not None:
        yield Text(
            "Fillets at the shoulders R{radius}, none smaller: the strength is calculated with it. An undercut in its "
            "place, no radius of it smaller, goes into the face alone.",
            radius=millimetres(shaft.fillet_radius),
        )
        room = solved.bending.fillet_room if solved.bending is not None else None
        if room is not None and room < shaft.fillet_radius:
            yield Text(
                "Two shoulders as drawn leave {room} for each fillet between them: their places are to be settled "
                "first.",
                room=millimetres(room, 2),
            )
    yield Text("Centre holes (ISO 6411) may remain at both ends.")
    if (bearings := results.design.bearings) is not None and (clearances := _clearances(results)):
        yield Text(
            "Diametral clearance of the journals in their bearings at {T} °C: {clearances}.",
            T=number(UNITS["°C"].shown(bearings.clearance_reference_temperature), 1),
            clearances=COMMA.join(clearances),
        )
    if (wheel := shaft_wheel(results)) is not None:
        yield from tooth_notes(wheel)
    yield defaults.said()
    judged = results.design.rows if journals(results) else ()
    yield from defaults.of_zones(judged, any(piece.piece.what == "gear" and piece.zones for piece in pieces))
    yield from chosen(data, shaft=shaft.name, more=_assumed_fields(results, pieces))
    yield Text("Not given by the design: {what}.", what=COMMA.join(missing(results, pieces)))


def _assumed_fields(results: "Results", pieces: list[TurnedPiece]) -> Iterator[Text]:
    """By which fields tips and journals are drawn, and these judged, that the design gives none."""
    wheel, drawn = shaft_wheel(results), any(piece.piece.what == "gear" for piece in pieces)
    if wheel is not None and wheel.tip_diameter_min is None and drawn:
        yield defaults.of_tips()
    found = journals(results)
    names = [row for row in results.design.rows if row.name in found]
    assumed = [row for row in names if found[row.name].assumed and found[row.name].limits is None]
    if assumed:
        fit, places = str(found[assumed[0].name].field), COMMA.join(row.in_words for row in assumed)
        whole = len(assumed) == len(names)
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
