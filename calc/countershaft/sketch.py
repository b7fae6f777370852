# SPDX-License-Identifier: Apache-2.0
"""Each shaft as a sketch: from the side with its supports and its bending line, and its masses from the front; and all
of them beside the crank.

From the side the first mass is up, as on the drawing; from the front cylinder 1 stands at TDC and the crank turns
clockwise."""

import cmath
import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from ..draw.drawing import (
    AXIS,
    CONTEXT,
    DIMENSIONS,
    HIDDEN,
    OUTLINE,
    WORDS,
    Arc,
    Area,
    Dimension,
    Mark,
    Point,
    Polyline,
    Sketch,
    State,
    Words,
    awaited,
    judged,
    moved,
    rectangle,
    round_outline,
    spanned,
)
from ..draw.drawing import reach as reached
from ..draw.shaft_outline import bore, drawn, reach, silhouette, upwards
from ..engine.result import EngineResult
from ..gears.inputs import GearsInputs
from ..gears.layout.curves import stage_lines
from ..gears.result import TrainResult
from ..sheet.check import Check
from ..sheet.quantity import dotted
from ..sheet.record import record, replace
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import Metre, Number, Radian
from .bending.shaft import Bending
from .checks import (
    BENDING_STRESS,
    ENVELOPE,
    ENVELOPE_LENGTH,
    FATIGUE,
    FIRST_CRITICAL_SPEED,
    JOURNAL_SLOPE,
    NOTCH_STRESS,
    OUTLINE_FORCE,
    SUPPORT_HEAT_INDEX,
    SUPPORT_SPECIFIC_LOAD,
)
from .front_view import CORNERS, Chain, OilLevel, ShaftInFront, Wheel, from_up, front_view, sector_outline
from .inputs import EccentricMass, Holes, ShaftInputs
from .left_over import RESIDUAL, RESIDUAL_FORCE
from .outline import Outline, Piece
from .result import CountershaftResult
from .rows import EACH_ROW, SHAFT, BearingRow
from .shafts import of_twin
from .sizing.sectors import SizedSector
from .twins import Resolved

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

STEP = "countershaft"
MASSES = dotted(SHAFT, ShaftInputs.masses)
OUTER = dotted(SHAFT, ShaftInputs.outer_radius)
CORE = dotted(SHAFT, ShaftInputs.core_radius)
LENGTH = dotted(SHAFT, ShaftInputs.half_length)
POSITIONS = dotted(EACH_ROW, BearingRow.position)
HOLES = dotted(SHAFT, ShaftInputs.holes)
GEAR = dotted(SHAFT, ShaftInputs.gear_z)
BORE = dotted(SHAFT, ShaftInputs.bore_diameter)
SECTIONS = dotted(SHAFT, ShaftInputs.sections)
JOURNALS = f"{dotted(EACH_ROW, BearingRow.diameter)} {dotted(EACH_ROW, BearingRow.length)}"
OF_MASSES = (RESIDUAL, RESIDUAL_FORCE, ENVELOPE, ENVELOPE_LENGTH, OUTLINE_FORCE)
SHADES = {"sector": 0.5, "journal": 0.25, "gear": 0.25, "full": 0.25, "core": 0.12}
EXAGGERATED: Number = 1000.0  # of the bending line, or a power of ten beside it
SEEN = 0.05, 1.2  # of the largest radius: within this the bending line is to stay
SUPPORT = 0.035  # of the shaft's length: height of a support's triangle
POINT = 0.3  # of the largest radius of the masses: radius of the heaviest of them, where only their places are known
FEW = 4  # masses whose places are told


@record
class View:
    """What of the shaft is drawn: its pieces, or where its outline is not known its journals and masses; `up`: what is
    drawn up."""

    shaft: ShaftInputs
    pieces: tuple[Piece, ...]
    up: Radian
    radius: Metre  # the largest
    start: Metre
    end: Metre
    state: State  # of the masses

    @property
    def length(self) -> Metre:
        return self.end - self.start


def sketch(design: "Design", results: "Results", angle: Radian = 0.0, view: int = 0) -> Sketch:
    """The shafts of a design, as far as they are known: one of its own from the side and from the front; all of them
    beside the crank, where there are several or a place is given.  Of several that are no twins the picture `view`
    comes first; of one `view` 1 is all of them."""
    each = [_of_one(one, results.views[name]) for name, one in design.views.items()]
    together = _together(design, results)
    if len(each) > 1:
        each = [_named(one, of) for one, of in zip(each, design.views.values())]
        pictures = [one for one in (together, *each, _below_each_other(design, results)) if one and one.primitives]
        first, *others = pictures[view:] + pictures[:view] or [awaited(results.outcomes[STEP])]
        return replace(first, beside=tuple(others), views=max(1, len(pictures)))
    alone = each[0] if each else awaited(results.outcomes[STEP])
    if together is None or not alone.primitives:
        return alone
    several = len((results.viewed or results).design.shafts) > 1
    side, ends = replace(alone, beside=()), alone.beside
    if view:
        return replace(together, beside=(side, *ends), views=2)
    return replace(side, beside=(together, *ends) if several else (*ends, together), views=2)


def _named(picture: Sketch, of: "Design") -> Sketch:
    """The picture of one of several shafts under its name, with keys that say which of them it is."""
    marks = tuple(_in_place(picture.primitives, of))
    return replace(picture, primitives=marks, title=Name(of.shafts[0].name), beside=())


def _in_place(marks: Iterable[Mark], of: "Design") -> Iterator[Mark]:
    """With keys that say the shaft."""
    for mark in marks:
        yield replace(mark, key=" ".join(one for words in mark.key.split() for one in of.in_place(words)))


def _of_one(design: "Design", results: "Results") -> Sketch:
    """A shaft that is no twin by itself."""
    outcome = results.outcomes[STEP]
    shaft: ShaftInputs | None = design.countershaft
    result = outcome.result
    if shaft is None or not isinstance(result, CountershaftResult):
        return awaited(outcome)
    checks = tuple(outcome.checks)
    view, notes = _view(shaft, result, checks), [Text("mm")]
    if view is None:
        return Sketch(notes=(Text("The picture waits for the masses of the shaft."),))
    if result.outline is None:
        notes.append(Text("without its journals") if result.sector else Text("masses as points"))
    side = [*_along(view, result.outline, checks), *_dimensions(view)]
    if shaft.holes is not None:
        side += _holes(view, shaft.holes, judged(checks, dotted(STEP, ShaftInputs.holes)))
    if result.bending is not None and (bent := _bent(view, result.bending, checks)) is not None:
        side += bent[0]
        notes.append(Text("dashed: bending × {factor}", factor=Amount(bent[1])))
    return Sketch(tuple(side), tuple(notes), beside=(Sketch(tuple(_end_view(view)), title=Text("from the front")),))


def _view(shaft: ShaftInputs, result: CountershaftResult, checks: tuple[Check, ...]) -> View | None:
    """What is known of its shape; None where that is nothing."""
    masses = judged(checks, *(rule.id for rule in OF_MASSES))
    if result.outline is not None:
        return _shaped(shaft, result.outline, masses)
    if result.sector:
        return _envelope(shaft, tuple(result.sector.values()), masses)
    return _points(shaft, masses) if shaft.masses else None


def _along(view: View, outline: Outline | None, checks: tuple[Check, ...]) -> Iterator[Mark]:
    """From the side: axis, shape and supports."""
    beyond = SUPPORT * view.length
    yield Polyline(AXIS, ((view.start - beyond, 0.0), (view.end + beyond, 0.0)))
    yield from _side(view, outline)
    yield from _supports(view, checks)


def _shaped(shaft: ShaftInputs, outline: Outline, state: State) -> View:
    up = upwards(outline)
    largest = max(max(reach(piece, up)) for piece in outline.pieces)
    return View(shaft, tuple(drawn(outline)), up, largest, outline.start, outline.end, state)


def _envelope(shaft: ShaftInputs, sectors: tuple[SizedSector, ...], state: State) -> View:
    """A shaft that is sized, but has no journals yet: its sectors on the core, from bearing to bearing."""
    start, end = shaft.bearing_positions[0], shaft.bearing_positions[-1]
    R, r_0 = shaft.outer_radius or 0.0, shaft.core_radius or 0.0
    heavy = sorted((sector for sector in sectors if sector.half_angle), key=lambda sector: sector.z)
    pieces = []
    for sector in heavy:
        ends = sector.z - sector.length / 2, sector.z + sector.length / 2
        pieces.append(Piece(*ends, R, r_0, sector.half_angle, sector.angle, "sector"))
    edges = [start, *(edge for piece in pieces for edge in (piece.start, piece.end)), end]
    pieces += [Piece(a, b, r_0, 0.0, None, 0.0, "core") for a, b in zip(edges[::2], edges[1::2]) if b > a]
    return View(shaft, tuple(pieces), heavy[0].angle if heavy else 0.0, R, start, end, state)


def _points(shaft: ShaftInputs, state: State) -> View:
    """The journals, if their sizes are given; the masses are added as points."""
    places = (*shaft.bearing_positions, *(mass.z for mass in shaft.masses))
    journals = tuple(
        Piece(z - length / 2, z + length / 2, diameter / 2, 0.0, None, 0.0, "journal")
        for z, (diameter, length) in zip(shaft.bearing_positions, shaft.journals)
    )
    start, end = (
        min((*places, *(piece.start for piece in journals))),
        max((*places, *(piece.end for piece in journals))),
    )
    farthest = max(mass.radius for mass in shaft.masses) * (1 + POINT)
    radius = max(farthest, 0.0, *(piece.outer_radius for piece in journals))
    return View(shaft, journals, shaft.masses[0].angle, radius, start, end, state)


def _mass_keys(view: View, piece: Piece) -> str:
    """The fields that shape a sector: its mass, or the envelope in which it is sized, or its section."""
    if view.shaft.sections:
        return SECTIONS
    here = [mass for mass in view.shaft.masses if piece.start <= mass.z <= piece.end]
    return " ".join((*(f"{MASSES}.{mass.name}" for mass in here), OUTER, LENGTH))


# --- all of them


def _together(design: "Design", results: "Results") -> Sketch | None:
    """All shafts beside the crank, also where one is in view; None where that shows no more than the one shaft by
    itself, or where one of them is not solved."""
    own = design.own_name if len(design.originals) == 1 else ""
    results = results.viewed or results
    design = results.design
    every = [one for one in design.resolved if one.inputs.mode != "bearings"]
    engine = results.result(EngineResult)
    if design.engine is None or engine is None or not every or (len(every) < 2 and every[0].inputs.axis is None):
        return None
    shafts: list[ShaftInFront] = []
    for one in every:
        original = results.of_shafts.get(one.of or one.name, results.outcomes)[STEP].result
        if not isinstance(original, CountershaftResult):
            return None
        key = SHAFT if one.name == own else dotted(SHAFT.partition(".")[0], one.name)
        shafts.append(_beside_crank(one, original, key))
    oil, friction = None, design.friction
    if friction is not None and friction.oil_level is not None:
        oil = OilLevel(friction.oil_level, dotted("friction", type(friction).oil_level))
    banks = sorted({round(float(psi), 9) for psi in engine.crank.psi})
    return replace(front_view(design.engine, banks, shafts, *_train(results.train), oil), of_all=1)


def _train(train: TrainResult | None) -> tuple[list[Wheel], list[Chain]]:
    """The wheels, chains and belts that have a place."""
    if train is None or train.layout is None:
        return [], []
    places = {name: wheel.position for name, wheel in train.layout.wheels.items()} | train.layout.sprockets
    wheels = [
        Wheel(at, train.wheels[name].pitch_diameter / 2, dotted("gears", GearsInputs.wheels, name))
        for name, at in places.items()
        if at is not None and name in train.wheels
    ]
    lines = stage_lines(train, places)
    return wheels, [Chain(tuple(line.tolist()), dotted("gears", GearsInputs.stages, name)) for name, line in lines]


def _beside_crank(one: Resolved, original: CountershaftResult, key: str) -> ShaftInFront:
    """A shaft with what it sweeps; the mirror image of a sector stands at −γ."""
    result = original if one.of is None else of_twin(original, one)
    mirrored, axis = one.how == "mirrors", one.inputs.axis
    pieces = original.outline.pieces if original.outline is not None else ()
    sectors = [piece for piece in pieces if piece.half_angle is not None]
    radii = [piece.outer_radius for piece in pieces] or [mass.radius for mass in one.inputs.masses]
    return ShaftInFront(
        one.name,
        one.inputs.speed_ratio,
        complex(*axis) if axis is not None else None,
        max((*radii, one.inputs.outer_radius or 0.0)) or 1e-3,
        tuple(replace(piece, angle=-piece.angle) for piece in sectors) if mirrored else tuple(sectors),
        () if sectors else tuple(cmath.rect(mass.radius, mass.angle) for mass in one.inputs.masses),
        result.force_vector,
        key,
    )


# --- all of them from the side

BAR = 0.1  # of the longest shaft: the largest load


def _below_each_other(design: "Design", results: "Results") -> Sketch | None:
    """Each shaft that is no twin, one below another at its place along the engine, with bars for the loads of its
    supports; above all of them the planes of the cylinders."""
    known = {}
    for name, each in results.views.items():
        shaft, outcome = each.design.countershaft, each.outcomes[STEP]
        if shaft is not None and isinstance(outcome.result, CountershaftResult):
            checks = tuple(outcome.checks)
            view = _view(shaft, outcome.result, checks)
            if view is not None:
                known[name] = view, outcome.result, checks
    if not known:
        return None
    longest = max(view.length for view, _, _ in known.values())
    most = max(max(result.loads.values()) for _, result, _ in known.values()) or 1.0
    engine, gap = results.result(EngineResult), SUPPORT * longest
    planes = sorted(set(engine.crank.z.tolist())) if engine is not None else []
    marks: list[Mark] = [Polyline(CONTEXT, ((z, gap), (z, 2 * gap))) for z in planes]
    notes = [Text("bars: loads of the bearings, dashed by the levers of a rigid shaft")]
    notes += [Text("ticks: cylinders")] if planes else []
    y = 0.0
    for name, (view, result, checks) in known.items():
        drawn = [*_along(view, result.outline, checks), *_loads(view, result, BAR * longest / most, gap)]
        if result.bending is not None and (bent := _bent(view, result.bending, checks)) is not None:
            drawn += bent[0]
            notes.append(Text("{name}: bending × {factor}", name=Name(name), factor=Amount(bent[1])))
        left, low, _, top = spanned(point for mark in drawn for point in reached(mark))
        twins = [Name(shaft.name) for shaft in design.shafts if name in (shaft.mirrors, shaft.repeats)]
        drawn.append(Words(WORDS, (left - gap, 0.0), COMMA.join([Name(name), *twins]), side="right"))
        placed = [moved(mark, 0.0, y - top) for mark in drawn]
        marks += _in_place(placed, results.views[name].design)
        y -= top - low + 2 * gap
    return Sketch(tuple(marks), tuple(notes), title=Text("from the side"), of_all=len(known))


def _loads(view: View, result: CountershaftResult, scale: float, wide: Metre) -> Iterator[Mark]:
    """A bar under each support as long as its load, and dashed that by the levers of a rigid shaft."""
    half, lowest = wide / 3, max((reach(piece, view.up)[1] for piece in view.pieces), default=0.0)
    top = -lowest - SUPPORT * view.length
    for row in view.shaft.bearings:
        load, z = result.loads[row.name], row.position
        yield Area(OUTLINE, (rectangle(z - half, top - scale * load, z + half, top),), SHADES["sector"])
        if (rigid := result.loads_by_levers.get(row.name)) is not None:
            yield Polyline(HIDDEN, rectangle(z - half, top - scale * rigid, z + half, top), True)
        yield Words(WORDS, (z + 2 * half, top - scale * load / 2), Text("{load}", load=Amount(load, "N", form=".0f")))


# --- from the side


def _side(view: View, outline: Outline | None) -> Iterator[Mark]:
    keys = {"journal": JOURNALS, "gear": GEAR, "core": CORE, "full": SECTIONS}
    for piece in view.pieces:
        high, low = reach(piece, view.up)
        state = view.state if piece.what == "sector" else ""
        box, key = rectangle(piece.start, -low, piece.end, high), keys.get(piece.what) or _mass_keys(view, piece)
        yield Area(OUTLINE, (box,), SHADES[piece.what], key, state)
        if piece.what != "core":
            yield Polyline(OUTLINE, box, True, key, state)
    if outline is not None:
        yield Polyline(OUTLINE, silhouette(outline), True)
        yield from (Polyline(HIDDEN, edge, key=BORE) for edge in bore(outline))
    else:
        yield Polyline(OUTLINE, ((view.start, 0.0), (view.end, 0.0)))
        for mass in view.shaft.masses:
            yield from _point(view, (mass.z, 0.0), (mass.z, mass.radius * math.cos(mass.angle - view.up)), mass)


def _point(view: View, foot: Point, at: Point, mass: EccentricMass) -> Iterator[Mark]:
    """A mass of which only the place is known: on a stalk, as large as its share of the heaviest asks for."""
    heaviest = max(other.mass for other in view.shaft.masses) or 1.0
    radius = POINT / (1 + POINT) * view.radius * (mass.mass / heaviest) ** (1 / 3)
    key = f"{MASSES}.{mass.name}"
    yield Polyline(OUTLINE, (foot, at), key=key, state=view.state)
    yield Area(OUTLINE, (round_outline(at, radius, CORNERS),), SHADES["sector"], key, view.state)
    yield Arc(OUTLINE, at, radius, key=key, state=view.state)


def _supports(view: View, checks: Iterable[Check]) -> Iterator[Mark]:
    """A triangle under each journal, its tip in the middle of it."""
    positions, checks, size = view.shaft.bearing_positions, tuple(checks), SUPPORT * view.length
    for n, z in enumerate(positions):
        low = max((reach(piece, view.up)[1] for piece in view.pieces if piece.start <= z <= piece.end), default=0.0)
        ids = [rule.of(str(n + 1)) for rule in (SUPPORT_SPECIFIC_LOAD, SUPPORT_HEAT_INDEX)]
        ids.append(JOURNAL_SLOPE.of(view.shaft.bearings[n].name))
        foot = ((z, -low), (z + size, -low - size), (z - size, -low - size))
        here = dotted(SHAFT, ShaftInputs.bearings, view.shaft.bearings[n].name, BearingRow.position)
        yield Polyline(OUTLINE, foot, True, f"{POSITIONS} {here}", judged(checks, *ids))


def _dimensions(view: View) -> Iterator[Mark]:
    """Below, the supports; above, the masses or the envelope from mid-shaft; behind the shaft the outer radius."""
    shaft, high = view.shaft, view.radius + SUPPORT * view.length
    lowest = max((reach(piece, view.up)[1] for piece in view.pieces), default=0.0)
    low = -lowest - 2 * SUPPORT * view.length
    for a, b in zip(shaft.bearing_positions, shaft.bearing_positions[1:]):
        yield Dimension(DIMENSIONS, (a, low), (b, low), (a, low), key=POSITIONS, label=_mm(b - a))
    lengths = []
    if shaft.half_length is not None:
        lengths.append((shaft.half_length, LENGTH))
    elif len(shaft.masses) <= FEW:
        lengths += [(mass.z, dotted(MASSES, mass.name, EccentricMass.z)) for mass in shaft.masses if mass.z]
    for z, key in lengths:
        yield Dimension(DIMENSIONS, (0.0, high), (z, high), (0.0, high), key=key, label=_mm(z))
    largest = max((p for p in view.pieces if p.what == "sector"), key=lambda p: p.outer_radius, default=None)
    if largest is not None:
        x, z, R = view.end + 2 * SUPPORT * view.length, largest.end, largest.outer_radius
        label = Text("R {radius}", radius=Amount(R * 1000))
        yield Dimension(DIMENSIONS, (z, 0.0), (z, R), (x, 0.0), upright=True, key=OUTER, label=label)


def _holes(view: View, holes: Holes, state: State) -> Iterator[Mark]:
    """The holes of each sector that is seen from outside, evenly along it: their depth is true, their places are not
    given."""
    sectors = [piece for piece in view.pieces if piece.what == "sector"]
    for piece in sectors:
        count = max(1, round(holes.count / len(sectors)))
        turned = math.cos(piece.angle - view.up)
        if abs(turned) < math.cos(math.radians(80)):
            continue
        way = math.copysign(1.0, turned)
        rim = way * reach(piece, view.up)[0 if way > 0 else 1]
        for n in range(count):
            z, half = piece.start + (n + 0.5) / count * piece.length, holes.diameter / 2
            bottom = rim - way * holes.depth
            outline = ((z - half, rim), (z - half, bottom), (z + half, bottom), (z + half, rim))
            yield Polyline(OUTLINE, outline, key=HOLES, state=state)


def _bent(view: View, bending: Bending, checks: Iterable[Check]) -> tuple[list[Mark], Number] | None:
    """The bending line as seen from the side, and how much it is exaggerated; nothing of a shaft that does not bend."""
    checks, sag = tuple(checks), (bending.vectors * np.exp(-1j * view.up)).real
    most = float(np.abs(sag).max())
    if most <= 0:
        return None
    factor = EXAGGERATED
    while most * factor > SEEN[1] * view.radius:
        factor /= 10
    while most * factor < SEEN[0] * view.radius:
        factor *= 10
    of_journals = [JOURNAL_SLOPE.of(row.name) for row in view.shaft.bearings]
    state = judged(checks, BENDING_STRESS.id, FIRST_CRITICAL_SPEED.id, *of_journals)
    points = tuple(zip(bending.z.tolist(), (sag * factor).tolist()))
    share = dotted(SHAFT, ShaftInputs.sector_effectiveness)
    marks: list[Mark] = [Polyline(HIDDEN, points, key=share, state=state)]
    worn = judged(checks, FATIGUE.id, NOTCH_STRESS.id)
    if worn and bending.notch_z is not None:
        z, half = bending.notch_z, 0.8 * view.radius
        fillet = dotted(SHAFT, ShaftInputs.fillet_radius)
        marks.append(Polyline(OUTLINE, ((z, -half), (z, half)), key=fillet, state=worn))
    return marks, factor


# --- from the front


def _end_view(view: View) -> Iterator[Mark]:
    """The masses around the axis; full pieces as circles."""
    sectors = [piece for piece in view.pieces if piece.half_angle is not None]
    for radius in sorted({round(p.outer_radius, 5) for p in view.pieces if p.what == "journal"}):
        yield Arc(CONTEXT, (0.0, 0.0), radius, key=JOURNALS)
    sizes: set[tuple[Metre, Metre, Radian, Radian]] = set()
    for piece in sectors:
        assert piece.half_angle is not None
        size = (
            round(piece.outer_radius, 4),
            round(piece.core_radius, 4),
            round(piece.half_angle, 2),
            round(piece.angle, 4),
        )
        if size in sizes:
            continue
        sizes.add(size)
        edge = sector_outline(piece)
        yield Area(OUTLINE, (edge,), SHADES["sector"], _mass_keys(view, piece), view.state)
        yield Polyline(OUTLINE, edge, True, _mass_keys(view, piece), view.state)
        yield from _angle(view, piece.angle, _mass_keys(view, piece))
    if view.shaft.bore_diameter:
        yield Arc(OUTLINE, (0.0, 0.0), view.shaft.bore_diameter / 2, key=BORE)
    if sectors:
        yield Arc(OUTLINE, (0.0, 0.0), sectors[0].core_radius, key=CORE)
    else:
        yield from _points_around(view)


def _points_around(view: View) -> Iterator[Mark]:
    """Masses of which only the places are known; those in one direction are one."""
    yield Arc(OUTLINE, (0.0, 0.0), POINT / 4 * view.radius)
    yield Arc(CONTEXT, (0.0, 0.0), max(mass.radius for mass in view.shaft.masses))
    places: set[Point] = set()
    for mass in view.shaft.masses:
        at = from_up(mass.radius, mass.angle)
        if (place := (round(at[0], 5), round(at[1], 5))) not in places:
            places.add(place)
            yield from _point(view, (0.0, 0.0), at, mass)
            yield from _angle(view, mass.angle, f"{MASSES}.{mass.name}")


def _angle(view: View, angle: Radian, key: str) -> Iterator[Mark]:
    """The direction of a mass, from up."""
    at = from_up(1.25 * view.radius, angle)
    yield Polyline(AXIS, ((0.0, 0.0), from_up(1.1 * view.radius, angle)))
    yield Words(WORDS, at, Text("{angle}", angle=Amount(math.degrees(angle) % 360, "°")), key=key, side="centre")


def _mm(length: Metre) -> Text:
    return Text("{length}", length=Amount(length * 1000))
