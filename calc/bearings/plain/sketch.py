# SPDX-License-Identifier: Apache-2.0
"""Plain bearings as a sketch: each journal in its clearance, pressed down by its load, with film, pressure and feed
around it.

The seats are to scale, the gap is drawn larger, as much in both bearings.  The frame stands with the load; the journal
turns anticlockwise against it, so that the narrowest film lies past the load's line by the attitude angle.  From the
side the shaft is seen in the plane in which its journals lie farthest from the middle."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from ...countershaft.rows import BearingRow, called, row_key
from ...draw.drawing import (
    CONTEXT,
    OUTLINE,
    WORDS,
    Arc,
    Area,
    Mark,
    Point,
    Polyline,
    Sketch,
    Words,
    judged,
    round_outline,
    rounded,
)
from ...sheet.check import Check
from ...sheet.quantity import dotted
from ...sheet.record import replace
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Number, Radian
from ..inputs import BearingsInputs, ruled_by
from .checks import FILM_EDGE
from .result import PlainResult

if TYPE_CHECKING:
    pass

DOWN: Radian = -math.pi / 2  # where the load points, and angles from it are counted from
GAP: Number = 0.32  # of the journal's radius: the gap of the bearing with the wider one is drawn no larger
PEAK: Number = 0.35  # of the radius: the largest pressure
CORNERS = 48  # of the pressure
FEED: Number = 0.22  # of the radius: how far a feed is drawn outwards
LEAST = 0.05  # of the largest pressure: less is not drawn


def pictures(results: Mapping[str, PlainResult], checks: dict[str, Check]) -> dict[str, Sketch]:
    """Each bearing in its clearance, the gaps drawn larger by one factor."""
    gap = rounded(min(GAP * r.seat.bearing.diameter / r.clearance_hot for r in results.values()))
    notes = (
        Text("gap × {factor}", factor=Amount(gap)),
        Text("load down"),
    )
    drawn = {
        place: Sketch(tuple(_bearing(place, r, gap, checks)), title=_title(place, r)) for place, r in results.items()
    }
    first = next(iter(drawn))
    return drawn | {first: replace(drawn[first], notes=notes)}


def _title(place: str, r: PlainResult) -> Text:
    d, length = Amount(r.seat.bearing.diameter * 1000), Amount(r.seat.bearing.length * 1000)
    return Text("{place} Ø{d} × {length}", place=called(place), d=d, length=length)


def _at(radius: Metre, from_load: Radian, centre: Point = (0.0, 0.0)) -> Point:
    return centre[0] + radius * math.cos(DOWN + from_load), centre[1] + radius * math.sin(DOWN + from_load)


def _bearing(place: str, r: PlainResult, gap: Number, checks: dict[str, Check]) -> Iterator[Mark]:
    key = row_key(place)
    journal, c = r.seat.bearing.diameter / 2, r.clearance_hot / 2 * gap
    seat, centre = journal + c, _at(c * r.eccentricity, r.attitude_angle)
    size, load_key = dotted(key, BearingRow.diameter), dotted(key, BearingRow.load)
    clearance = f"{dotted(key, BearingRow.clearance)} {dotted(key, BearingRow.clearance_factor)}"
    oil = f"{clearance} {dotted('bearings', BearingsInputs.oil)}"
    film = judged(checks.values(), FILM_EDGE.of(place))
    yield Area(CONTEXT, (round_outline((0.0, 0.0), seat), round_outline(centre, journal)), 0.35, oil)
    yield Arc(OUTLINE, (0.0, 0.0), seat, key=clearance)
    yield Arc(OUTLINE, centre, journal, key=size)
    yield from _pressure(key, r, seat)
    yield from _feed(r, centre, journal, seat)
    narrow = r.attitude_angle
    yield Polyline(OUTLINE, (_at(0.78 * journal, narrow, centre), _at(seat, narrow)), key=_rough(key), state=film)
    yield Polyline(
        OUTLINE, (_at(0.12 * journal, 0.0, centre), _at(0.72 * journal, 0.0, centre)), key=load_key, arrow=True
    )
    load = Text(
        "{load}", load=Amount(r.load / 1000, "kN", digits=2) if r.load >= 1000 else Amount(r.load, "N", digits=3)
    )
    yield Words(WORDS, (centre[0] - 0.12 * journal, centre[1] - 0.4 * journal), load, key=load_key, side="right")
    if not r.seat.centred:
        yield from _film(key, centre, journal, checks[FILM_EDGE.of(place)])


def _film(key: str, centre: Point, journal: Metre, check: Check) -> Iterator[Mark]:
    """The film at the edge against what it is to be."""
    film, asked = Amount(check.value, digits=2), Amount(check.nearest[1], digits=2)
    at, text = (centre[0], centre[1] + 0.35 * journal), Text("{film} of {asked} µm", film=film, asked=asked)
    yield Words(WORDS, at, text, key=_rough(key), state=judged([check], check.id), side="centre")


def _keys(row: BearingRow, *declared: object) -> str:
    """The keys of inputs that all bearings share; of what the row says itself that in the row."""
    own = [entry.key for entry in ruled_by(row)]
    return " ".join(row_key(row.name, key) if key in own else dotted("bearings", key) for key in map(dotted, declared))


def _rough(key: str) -> str:
    return f"{dotted(key, BearingRow.journal_roughness)} {dotted(key, BearingRow.housing_roughness)}"


def _pressure(key: str, r: PlainResult, seat: Metre) -> Iterator[Mark]:
    """The pressure in the middle plane, standing on the seat where the film narrows; its largest value beside it."""
    if r.seat.inputs.supply == "axial_groove":
        return  # grooves along the bearing part the film; its pressure is another one
    around = pressures(float(r.eccentricity), float(r.attitude_angle))
    outside = [_at(seat * (1 + PEAK * share), angle) for angle, share in around]
    inside = [_at(seat, angle) for angle, _ in reversed(around)]
    length = dotted(key, BearingRow.length)
    yield Area(OUTLINE, ((*outside, *inside),), 0.5, length)
    yield Polyline(OUTLINE, (inside[-1], *outside, inside[0]), key=length)
    angle = max(around, key=lambda point: point[1])[0]
    pressure = Text("{pressure}", pressure=Amount(r.film_pressure_max / 1e6, "MPa", digits=2))
    yield Words(WORDS, _at(seat * (1.12 + PEAK), angle), pressure, side="left" if math.sin(angle) > 0 else "right")


def pressures(eccentricity: Number, attitude: Radian) -> list[tuple[Radian, Number]]:
    """Angles from the load and the share of the largest pressure there, in the shape that it has in a short bearing:
    p ~ sin θ/(1 + ε·cos θ)³, θ from the widest film to the narrowest one."""
    turns = [math.pi * n / CORNERS for n in range(CORNERS + 1)]
    shares = [math.sin(theta) / (1 + eccentricity * math.cos(theta)) ** 3 for theta in turns]
    most = max(shares)
    return [(theta - math.pi + attitude, p / most) for theta, p in zip(turns, shares) if p > LEAST * most]


def _feed(r: PlainResult, centre: Point, journal: Metre, seat: Metre) -> Iterator[Mark]:
    """Where the oil comes in: outside the seat, or through the journal."""
    inputs, row, outer = r.seat.inputs, r.seat.bearing, seat * (1 + FEED)
    where = _keys(
        row,
        BearingsInputs.supply,
        BearingsInputs.supply_angle,
        BearingsInputs.hole_diameter,
        BearingsInputs.pocket_length,
        BearingsInputs.axial_groove_angles,
    )
    if inputs.supply == "shaft":
        yield from _duct(_at(journal, math.pi, centre), _at(0.75 * journal, math.pi, centre), 0.08 * seat, where)
    elif inputs.supply == "groove":
        start, end = inputs.groove_arc or (0.0, 2 * math.pi)
        yield Arc(
            OUTLINE,
            (0.0, 0.0),
            seat * 1.08,
            DOWN + start,
            DOWN + end,
            key=_keys(row, BearingsInputs.groove_width, BearingsInputs.groove_arc),
        )
    else:
        angles: Iterable[Radian] = (inputs.supply_angle,)
        if inputs.supply == "axial_groove":
            angles = inputs.axial_groove_angles or ()
        wide = {
            "hole": inputs.hole_diameter,
            "pocket": inputs.pocket_length,
            "axial_groove": inputs.axial_groove_width,
        }[inputs.supply]
        for angle in angles:
            yield from _duct(_at(seat, angle), _at(outer, angle), max((wide or 0.0) / 2, 0.06 * seat), where)


def _duct(inner: Point, outer: Point, half: Metre, key: str) -> Iterator[Mark]:
    """A hole in the sheet's plane, its two sides, filled with oil."""
    length = math.dist(inner, outer)
    x, y = (inner[1] - outer[1]) / length * half, (outer[0] - inner[0]) / length * half
    left, right = (
        ((inner[0] + x, inner[1] + y), (outer[0] + x, outer[1] + y)),
        ((inner[0] - x, inner[1] - y), (outer[0] - x, outer[1] - y)),
    )
    yield Area(CONTEXT, ((*left, *reversed(right)),), 0.35, key)
    yield Polyline(OUTLINE, left, key=key)
    yield Polyline(OUTLINE, right, key=key)


# --- all shafts from the side, in their films
# All on one scale along the engine, and one across it, which is exaggerated.  A shaft goes round as it lies there: half
# a turn later it is its own mirror image.
