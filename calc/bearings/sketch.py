# SPDX-License-Identifier: Apache-2.0
"""The bearings as a sketch: each as its kind draws it; and each shaft from the side, as it lies in them.

From the side the shaft is seen in the plane in which its journals lie farthest from the middle."""

import cmath
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from ..countershaft.result import CountershaftResult
from ..countershaft.rows import BearingRow, row_key
from ..draw.drawing import (
    AXIS,
    CONTEXT,
    HIDDEN,
    OUTLINE,
    WORDS,
    Area,
    Mark,
    Polyline,
    Sketch,
    Words,
    awaited,
    judged,
    moved,
    reach,
    rectangle,
    rounded,
)
from ..engine.result import EngineResult
from ..sheet.check import Check
from ..sheet.quantity import dotted
from ..sheet.record import replace
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import Metre, Newton, Number, Radian
from .kinds import KINDS
from .plain.bearing import FILM_EDGE_TILTED, PlainBearing
from .result import BearingsResult
from .support import Carrying

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

STEP = "bearings"


def sketch(design: "Design", results: "Results", angle: Radian = 0.0, view: int = 0) -> Sketch:
    """The bearings of a shaft side by side, from the side how all shafts lie in them, and each seat of which more is
    known in section; `view`: which of these first."""
    outcome = results.outcomes[STEP]
    result, side = outcome.result, _from_the_side(design, results)
    if not isinstance(result, BearingsResult):
        return side or awaited(outcome)
    checks = {check.id: check for check in outcome.checks}
    by_kind = {
        word: {place: r for place, r in result.bearings.items() if r.row.kind == word}
        for word in dict.fromkeys(r.row.kind for r in result.bearings.values())
    }
    drawn = {
        place: one for word, those in by_kind.items() for place, one in KINDS[word].pictures(those, checks).items()
    }
    ends = [drawn[place] for place in result.bearings]
    ways = [ends, *([[side]] if side is not None else [])]
    ways += [way for word, those in by_kind.items() for way in KINDS[word].sections(those, checks)]
    first, *others = [picture for way in (ways[view:] + ways[:view]) for picture in way]
    return replace(first, beside=tuple(others), views=len(ways))


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
    films = all(isinstance(r, PlainBearing) for b in shafts.values() for r in b.bearings.values())
    where = Text("in the films") if films else Text("in the bearings")
    notes = [Text("{where} × {factor}", where=where, factor=Amount(factor)), Text("dashed: half a turn later")]
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
    return Sketch(tuple(marks), tuple(notes), title=where, of_all=len(shafts))


def _places(result: BearingsResult) -> dict[str, complex]:
    """Of the journals from the middles of their bearings, in the frame of the shaft."""
    return {
        name: cmath.rect(r.on_shaft.displacement, r.on_shaft.displacement_phase or 0.0)
        for name, r in result.bearings.items()
        if r.on_shaft is not None
    }


def _farthest(result: BearingsResult) -> Metre:
    assert result.line is not None
    return max(float(np.abs(result.line[1]).max()), *(r.running_clearance / 2 for r in result.bearings.values()))


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
    name: str, r: Carrying, checks: Iterable[Check], low: Metre, foot: Metre, factor: Number
) -> Iterator[Mark]:
    """Where its journal may go, the film that it keeps at its edge, and a triangle."""
    width = r.row.on_shaft[1] if r.row.on_shaft is not None else 0.0
    place, half, free = r.row.position, width / 2, factor * max(r.running_clearance, 0.0) / 2
    key = row_key(name)
    size = f"{dotted(key, BearingRow.clearance)} {dotted(key, BearingRow.clearance_factor)}"
    state = judged(checks, FILM_EDGE_TILTED.of(name))
    for y in (free, -free):
        yield Polyline(OUTLINE, ((place - half, y), (place + half, y)), key=size, state=state)
    if r.on_shaft is not None and r.on_shaft.film_edge_tilted is not None and not r.least_load:
        film = Amount(r.on_shaft.film_edge_tilted * 1e6, "µm", digits=2)
        words = Text("edge {film}", film=film)
        yield Words(WORDS, (place, low + 0.6 * foot), words, key=size, state=state, side="centre")
    triangle = ((place, -low), (place + foot, -low - foot), (place - foot, -low - foot))
    yield Polyline(OUTLINE, triangle, True, dotted(key, BearingRow.position))


def _load(name: str, r: Carrying, rigid: Newton | None, top: Metre, foot: Metre, bar: float) -> Iterator[Mark]:
    """A bar as long as the load, and the outline of that on a rigid support."""
    place, half, key = r.row.position, foot / 3, dotted(row_key(name), BearingRow.load)
    yield Area(OUTLINE, (rectangle(place - half, -top - bar * r.load, place + half, -top),), 0.5, key)
    if rigid is not None:
        yield Polyline(OUTLINE, rectangle(place - half, -top - bar * rigid, place + half, -top), True, key)
    load = Text("{load}", load=Amount(r.load, "N", form=".0f"))
    yield Words(WORDS, (place + 2 * half, -top - bar * r.load / 2), load, key=key)
