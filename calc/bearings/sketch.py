# SPDX-License-Identifier: Apache-2.0
"""The bearings as a sketch: each journal in its clearance, pressed down by its load, with film, pressure and feed
around it; and each shaft from the side, as it lies in its films.

The seats are to scale, the gap is drawn larger, as much in both bearings.  The frame stands with the load; the journal
turns anticlockwise against it, so that the narrowest film lies past the load's line by the attitude angle.  From the
side the shaft is seen in the plane in which its journals lie farthest from the middle."""

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..countershaft.result import CountershaftResult
from ..countershaft.rows import BearingRow, called, row_key
from ..draw.drawing import (
    AXIS,
    CONTEXT,
    HIDDEN,
    OUTLINE,
    WORDS,
    Arc,
    Area,
    Mark,
    Point,
    Polyline,
    Sketch,
    Words,
    awaited,
    judged,
    moved,
    reach,
    rectangle,
    round_outline,
    rounded,
)
from ..engine.result import EngineResult
from ..sheet.check import Check
from ..sheet.quantity import dotted
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import Metre, Newton, Number, Radian
from .as_supports import FILM_EDGE_TILTED
from .inputs import BearingsInputs, ruled_by
from .plain.checks import FILM_EDGE
from .plain.seats.sketch import seat_sketches
from .result import BearingResult, BearingsResult

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

DOWN: Radian = -math.pi / 2  # where the load points, and angles from it are counted from
GAP: Number = 0.32  # of the journal's radius: the gap of the bearing with the wider one is drawn no larger
PEAK: Number = 0.35  # of the radius: the largest pressure
CORNERS = 48  # of the pressure
FEED: Number = 0.22  # of the radius: how far a feed is drawn outwards
LEAST = 0.05  # of the largest pressure: less is not drawn
STEP = "bearings"


def sketch(design: "Design", results: "Results", angle: Radian = 0.0, view: int = 0) -> Sketch:
    """The bearings of a shaft side by side, from the side how all shafts lie in their films, and each seat of which
    more is known in section; `view`: which of these first."""
    outcome = results.outcomes[STEP]
    result, side = outcome.result, _from_the_side(design, results)
    if not isinstance(result, BearingsResult):
        return side or awaited(outcome)
    checks = {check.id: check for check in outcome.checks}
    gap = rounded(min(GAP * r.seat.bearing.diameter / r.clearance_hot for r in result.bearings.values()))
    notes = (
        Text("gap × {factor}", factor=Amount(gap)),
        Text("the load points down"),
        Text("pressure in the shape of a short bearing"),
    )
    ends = [
        Sketch(tuple(_bearing(place, r, gap, checks)), title=_title(place, r)) for place, r in result.bearings.items()
    ]
    ends[0] = replace(ends[0], notes=notes)
    ways = [ends, *([[side]] if side is not None else [])]
    ways += seat_sketches(result.bearings, checks)
    first, *others = [picture for way in (ways[view:] + ways[:view]) for picture in way]
    return replace(first, beside=tuple(others), views=len(ways))


def _title(place: str, r: BearingResult) -> Text:
    d, length = Amount(r.seat.bearing.diameter * 1000), Amount(r.seat.bearing.length * 1000)
    return Text("{place} Ø{d} × {length}", place=called(place), d=d, length=length)


def _at(radius: Metre, from_load: Radian, centre: Point = (0.0, 0.0)) -> Point:
    return centre[0] + radius * math.cos(DOWN + from_load), centre[1] + radius * math.sin(DOWN + from_load)


def _bearing(place: str, r: BearingResult, gap: Number, checks: dict[str, Check]) -> Iterator[Mark]:
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


def _pressure(key: str, r: BearingResult, seat: Metre) -> Iterator[Mark]:
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


def _feed(r: BearingResult, centre: Point, journal: Metre, seat: Metre) -> Iterator[Mark]:
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

LINE: Number = 0.07  # of the longest shaft: how far from its axis a journal or a bearing's clearance is drawn at most
FOOT: Number = 0.025  # of the longest shaft: height of a support's triangle
BAR: Number = 0.1  # of the longest shaft: the largest load
NO_CONE: Radian = 1e-6  # a smaller one is rounding


def _from_the_side(design: "Design", results: "Results") -> Sketch | None:
    """Each shaft with bearings of its own, one below another, also where one of them is in view; None where of none is
    known how it lies in its films."""
    whole = results.viewed or results
    views = {name: whole.view(name) for name in whole.of_shafts or whole.views}
    found = {name: each.outcomes[STEP].result for name, each in views.items() if STEP in each.outcomes}
    shafts = {name: b for name, b in found.items() if isinstance(b, BearingsResult) and b.line is not None}
    if not shafts:
        return None
    longest = max(float(np.ptp(b.line[0])) for b in shafts.values() if b.line is not None)
    most = max(_farthest(b) for b in shafts.values())
    factor = rounded(LINE * longest / most)
    bar = BAR * longest / max(r.load for b in shafts.values() for r in b.bearings.values())
    engine = whole.result(EngineResult)
    planes = sorted(set(engine.crank.z.tolist())) if engine is not None else []
    level = (LINE + FOOT) * longest
    marks: list[Mark] = [Polyline(CONTEXT, ((z, level), (z, level + FOOT * longest))) for z in planes]
    notes = [Text("in the films × {factor}", factor=Amount(factor)), Text("dashed: half a turn later")]
    notes += [Text("ticks: cylinders")] if planes else []
    in_view = design.own_name if len(design.originals) == 1 else ""
    y = 0.0
    for name, b in shafts.items():
        seen = views[name]
        drawn = list(_in_films(b, seen.outcomes[STEP].checks, seen.shaft, longest, factor, bar))
        for mark in drawn:
            keys = mark.key.split()
            if name != in_view:
                keys = [one for key in keys for one in seen.design.in_place(key)]
            marks.append(replace(moved(mark, 0.0, y), key=" ".join(keys)))
        several, cone = len(whole.design.shafts) > 1, Amount((b.cone or 0.0) * 1e3, "mrad", digits=3)
        if several and b.line is not None:
            twins = [s.name for s in whole.design.shafts if name in (s.mirrors, s.repeats) and s.name not in shafts]
            at = float(b.line[0].min()) - FOOT * longest
            marks.append(Words(WORDS, (at, y), COMMA.join(map(Name, [name, *twins])), side="right"))
        if b.cone is not None and b.cone > NO_CONE:
            half = Text("{name}: cone {cone}", name=Name(name), cone=cone)
            notes.append(half if several else Text("cone {cone}", cone=cone))
        y -= level + 2 * FOOT * longest - min(at_y for mark in drawn for _, at_y in reach(mark))
    return Sketch(tuple(marks), tuple(notes), title=Text("in the films"), of_all=len(shafts))


def _places(result: BearingsResult) -> dict[str, complex]:
    """Of the journals from the middles of their bearings, in the frame of the shaft."""
    return {
        name: cmath.rect(r.on_shaft.displacement, r.on_shaft.displacement_phase or 0.0)
        for name, r in result.bearings.items()
        if r.on_shaft is not None
    }


def _farthest(result: BearingsResult) -> Metre:
    assert result.line is not None
    return max(float(np.abs(result.line[1]).max()), *(r.clearance_hot / 2 for r in result.bearings.values()))


def _in_films(
    result: BearingsResult,
    checks: Iterable[Check],
    shaft: CountershaftResult | None,
    longest: Metre,
    factor: Number,
    bar: float,
) -> Iterator[Mark]:
    """One shaft about its axis.  `factor`: how much larger it is drawn across; `bar`: metres of the picture for a
    newton."""
    assert result.line is not None
    z, way = result.line
    places = _places(result)
    towards = cmath.exp(0.5j * cmath.phase(sum(x * x for x in places.values())))
    loaded = max(result.bearings, key=lambda name: result.bearings[name].load)
    if (places[loaded] / towards).real > 0:
        towards = -towards  # the journal that carries most lies on its support
    line = factor * (way / towards).real
    foot = FOOT * longest
    yield Polyline(AXIS, ((float(z.min()) - foot, 0.0), (float(z.max()) + foot, 0.0)))
    yield Polyline(HIDDEN, tuple(zip(z.tolist(), (-line).tolist())))
    yield Polyline(OUTLINE, tuple(zip(z.tolist(), line.tolist())))
    low = LINE * longest
    for name, r in result.bearings.items():
        yield from _support(name, r, checks, low, foot, factor)
        rigid = shaft.loads.get(name) if shaft is not None else None
        yield from _load(name, r, rigid, low + foot, foot, bar)


def _support(
    name: str, r: BearingResult, checks: Iterable[Check], low: Metre, foot: Metre, factor: Number
) -> Iterator[Mark]:
    """Where its journal may go, the film that it keeps at its edge, and a triangle."""
    place, half, free = r.seat.bearing.position, r.seat.bearing.length / 2, factor * r.clearance_hot / 2
    key = row_key(name)
    size = f"{dotted(key, BearingRow.clearance)} {dotted(key, BearingRow.clearance_factor)}"
    state = judged(checks, FILM_EDGE_TILTED.of(name))
    for y in (free, -free):
        yield Polyline(OUTLINE, ((place - half, y), (place + half, y)), key=size, state=state)
    if r.on_shaft is not None and not r.seat.centred:
        film = Amount(r.on_shaft.film_edge_tilted * 1e6, "µm", digits=2)
        words = Text("edge {film}", film=film)
        yield Words(WORDS, (place, low + 0.6 * foot), words, key=size, state=state, side="centre")
    triangle = ((place, -low), (place + foot, -low - foot), (place - foot, -low - foot))
    yield Polyline(OUTLINE, triangle, True, dotted(key, BearingRow.position))


def _load(name: str, r: BearingResult, rigid: Newton | None, top: Metre, foot: Metre, bar: float) -> Iterator[Mark]:
    """A bar as long as the load, and the outline of that on a rigid support."""
    place, half, key = r.seat.bearing.position, foot / 3, dotted(row_key(name), BearingRow.load)
    yield Area(OUTLINE, (rectangle(place - half, -top - bar * r.load, place + half, -top),), 0.5, key)
    if rigid is not None:
        yield Polyline(OUTLINE, rectangle(place - half, -top - bar * rigid, place + half, -top), True, key)
    load = Text("{load}", load=Amount(r.load, "N", form=".0f"))
    yield Words(WORDS, (place + 2 * half, -top - bar * r.load / 2), load, key=key)
