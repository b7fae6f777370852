# SPDX-License-Identifier: Apache-2.0
"""Notes beside the numbers of rolling bearings: what stands where, what is an estimate, what is not computed."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from ...countershaft.rows import titled
from ...sheet.text import COMMA, Amount, Name, Text
from .clearance import usual_fits

if TYPE_CHECKING:
    from ...countershaft.outline import Outline
    from ..inputs import BearingsInputs
    from .bearing import RollingBearing

SAME = 1e-6  # m


def notes(
    inputs: "BearingsInputs", outline: "Outline | None", results: "Mapping[str, RollingBearing]"
) -> Iterator[Text]:
    yield Text(
        "The load turns with the shaft: it stands on the inner ring and sweeps the outer one. So the outer ring needs "
        "the tight fit, and the inner one may be loose."
    )
    for place, r in results.items():
        yield facts(place, r)
        d = r.case.size.bore
        pieces = outline.pieces if outline is not None else ()
        there = max((2 * p.outer_radius for p in pieces if p.start <= r.row.position <= p.end), default=d)
        if there < d - SAME:
            yield Text(
                "{place} bearing: the section of the shaft there, {there}, is thinner than what sits on it, {d}: give "
                "it that diameter.",
                place=titled(place),
                there=Amount(there * 1e3, "mm"),
                d=Amount(d * 1e3, "mm"),
            )
        if r.row.outer_ring_held == "clamped":
            yield Text(
                "{place} bearing: it is taken to sit in a flange that is mounted after the shaft, and is not designed "
                "here.",
                place=titled(place),
            )
        if r.row.locates:
            yield Text(
                "{place} bearing: it locates the shaft once both rings are held along it: shoulders, a nut or circlips "
                "are not designed here.",
                place=titled(place),
            )
        if r.load < r.standing_load:
            yield Text("{place} bearing: more stands than turns: V is 1.", place=titled(place))
        if r.clearance_running is None:
            why = Text("nothing is known of its inside")
            if r.case.inside is not None:
                why = Text("no table has the clearance of such a bore")
            yield Text(
                "{place} bearing: no clearance, no stiffness and no life with the clearance: {why}.",
                place=titled(place),
                why=why,
            )
        if r.case.size.type == "cup" and r.grip_hot is not None and r.grip_hot < 0:
            yield Text(
                "{place} bearing: the cup is loose as it runs and turns with the load; its clearance is an upper "
                "estimate.",
                place=titled(place),
            )
        if r.axial > 0:
            yield Text("{place} bearing: its loss with thrust is a lower estimate.", place=titled(place))
        if r.pass_frequency is not None:
            yield Text(
                "{place} bearing: rolling bearings hum at {f} and its multiples, plain ones do not.",
                place=titled(place),
                f=Amount(r.pass_frequency, "Hz", digits=4),
            )
    yield Text(
        "The temperature of the bearings is an upper estimate, since oil that flows through carries more off: so life "
        "and viscosity ratio are lower ones. See that oil reaches each bearing: no supply is computed."
    )
    if any(r.case.size.type in ("needle", "cup", "cage") for r in results.values()):
        yield Text(
            "Two formulas of the friction are in the program: INA's factors for needles, and Palmgren's of 1957 for "
            "the bearings of wheels, four times as large; they stand side by side as an upper bound."
        )
    if inputs.rolling_lubrication == "bath":
        yield Text(
            "In a bath the larger torque of both formulas is judged: drag in deep oil is a diagram of the catalogue, "
            "without numbers."
        )
    yield Text("The growth of shaft and rings in their own turning is below 0.3 µm and left out.")


def facts(place: str, r: "RollingBearing") -> Text:
    """A rolling bearing in one line: what it is, how it sits, how long it lasts and what it loses."""
    size, (shaft_fit, seat_fit) = r.case.size, usual_fits(r.case.size.type, r.case.size.inner_ring)
    parts: list[Text] = [Text("{size}", size=Name(size.designation))]
    if size.inner_ring and r.row.clearance_limits is None:
        parts.append(Text("{word}", word=Name(r.row.clearance_class)))
    sits = Text("shaft {shaft}, seat {seat}", shaft=r.row.shaft_fit or shaft_fit, seat=r.row.seat_fit or seat_fit)
    parts.append(sits)
    if r.life is not None:
        parts.append(Text("{life}", life=Amount(r.life / 3600, "h", digits=3)))
    parts.append(Text("{loss}", loss=Amount(r.friction_power, "W", digits=3)))
    if r.row.dynamic_rating is None:
        known = size.usual.spread
        parts.append(
            Text("ratings estimated by a typical inside (over catalogues: {spread})", spread=Name(known))
            if known
            else Text("ratings estimated by what is inside")
        )
    return Text("{place} bearing: {facts}.", place=titled(place), facts=COMMA.join(parts))
