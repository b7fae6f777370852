# SPDX-License-Identifier: Apache-2.0
"""All balance shafts of an engine from the front, each at its axis beside the crank: what it sweeps, its sectors and
its force with cylinder 1 at TDC, how it turns; the wheels and chains that turn it, and the oil at rest.

Up is up, the crank turns clockwise.  Shafts whose place is not given stand in a row beneath."""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations

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
    moved,
    reach,
    round_outline,
    spanned,
)
from ..engine.inputs import EngineInputs
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Amount, Name, Text
from ..sheet.units import Metre, Number, PhasorMetre, PhasorNewton, Radian
from .outline import Piece

CRANK = dotted("engine", EngineInputs.crank_radius)
SECTOR = 0.5  # shade
MASS = 0.2  # of the sweep: radius of a mass of which only the place is known
SENSE = math.radians(50)  # half of the arrow that says how a shaft turns
AROUND = 1.15  # sweeps: where that arrow runs
NAME, BELOW = 1.5, 0.4  # sweeps below the axis, and below the tip of a force, where the name stands
ARROW = 2.0  # largest sweeps: length of the largest force
APART = 4.0  # largest sweeps from shaft to shaft where no place is given
CORNERS = 24  # of half a sector
FEW = 12  # of an arrow
NO_FORCE = 1e-3  # of the largest: a smaller one has no arrow


@record
class ShaftInFront:
    """One shaft: `axis` from the crank's, real up, imaginary to the side, None where it is not given; `sweep`: the
    largest radius; its sectors, else the places of its masses about its axis; `force`: with cylinder 1 at TDC."""

    name: str
    ratio: Number
    axis: PhasorMetre | None
    sweep: Metre
    sectors: tuple[Piece, ...]
    masses: tuple[PhasorMetre, ...]
    force: PhasorNewton
    key: str


@record
class Wheel:
    """A wheel of the train at its place, by its pitch circle."""

    axis: PhasorMetre
    radius: Metre
    key: str


@record
class Chain:
    """The line of a chain or belt, closed."""

    line: tuple[PhasorMetre, ...]
    key: str


@record
class OilLevel:
    """The oil at rest, up from the crank's axis."""

    up: Metre
    key: str


def front_view(
    engine: EngineInputs,
    banks: Iterable[Radian],
    shafts: Sequence[ShaftInFront],
    wheels: Iterable[Wheel] = (),
    chains: Iterable[Chain] = (),
    oil: OilLevel | None = None,
) -> Sketch:
    """`banks`: the directions of the cylinders, from up."""
    largest, most = max(shaft.sweep for shaft in shafts), max(abs(shaft.force) for shaft in shafts)
    scale = ARROW * largest / most if most else 0.0
    placed = [(shaft, _point(shaft.axis)) for shaft in shafts if shaft.axis is not None]
    marks: list[Mark] = [*_crank(engine, banks), *_wheels(wheels), *_chains(chains)] if placed else []
    for shaft, at in placed:
        marks += _at(at, _shaft(shaft, scale, NO_FORCE * most))
    for (one, here), (other, there) in combinations(placed, 2):
        marks += [*_meeting(one, here, other, there), *_meeting(other, there, one, here)]
    beneath = [shaft for shaft in shafts if shaft.axis is None]
    left, low, right, _ = spanned(point for mark in marks for point in reach(mark))
    if placed and oil is not None:
        marks += _oil(oil, left, right)
        low = min(low, oil.up)
    middle, y = (left + right) / 2, low - APART * largest
    for n, shaft in enumerate(beneath):
        marks += _at(
            (middle + (n - (len(beneath) - 1) / 2) * APART * largest, y), _shaft(shaft, scale, NO_FORCE * most)
        )
    if beneath:
        marks.append(Words(CONTEXT, (middle, y - 3 * largest), Text("place not given"), side="centre"))
    title = Text("beside the crank") if placed else Text("all shafts")
    if most:
        title += Text(", up to {force}", force=Amount(most, "N", digits=4))
    return Sketch(tuple(marks), title=title)


def _at(place: Point, marks: Iterable[Mark]) -> list[Mark]:
    return [moved(mark, *place) for mark in marks]


def _crank(engine: EngineInputs, banks: Iterable[Radian]) -> Iterator[Mark]:
    """The circle of the pins, and where the cylinders stand."""
    r = engine.crank_radius
    yield Arc(CONTEXT, (0.0, 0.0), r, key=CRANK)
    for bank in banks:
        yield Polyline(AXIS, ((0.0, 0.0), from_up(2 * r, bank)))
    yield from _sense(0.5 * r, 1.0, CONTEXT, CRANK)


def _wheels(wheels: Iterable[Wheel]) -> Iterator[Mark]:
    for wheel in wheels:
        yield Arc(HIDDEN, _point(wheel.axis), wheel.radius, key=wheel.key)


def _chains(chains: Iterable[Chain]) -> Iterator[Mark]:
    for chain in chains:
        yield Polyline(CONTEXT, tuple(map(_point, chain.line)), True, chain.key)


def _oil(oil: OilLevel, left: Metre, right: Metre) -> Iterator[Mark]:
    yield Polyline(CONTEXT, ((left, oil.up), (right, oil.up)), key=oil.key)
    yield Words(CONTEXT, (left, oil.up), Text("oil at rest"), key=oil.key)


def _shaft(shaft: ShaftInFront, scale: float, least: float) -> Iterator[Mark]:
    """About its own axis; `scale`: metres of the picture for a newton."""
    R, key = shaft.sweep, shaft.key
    yield Arc(CONTEXT, (0.0, 0.0), R, key=key)
    for sector in shaft.sectors:
        yield Area(OUTLINE, (sector_outline(sector),), SECTOR, key)
    for mass in shaft.masses:
        yield Area(OUTLINE, (round_outline(_point(mass), MASS * R),), SECTOR, key)
    yield from _sense(AROUND * R, shaft.ratio, OUTLINE, key)
    tip = _point(scale * shaft.force)
    if abs(shaft.force) > least:
        yield Polyline(OUTLINE, ((0.0, 0.0), tip), arrow=True, key=key)
    words = Text("{name} ×{n}", name=Name(shaft.name), n=Amount(abs(shaft.ratio)))
    yield Words(WORDS, (0.0, min(-NAME * R, tip[1] - BELOW * R)), words, key=key, side="centre")


def _sense(radius: Metre, ratio: Number, layer: str, key: str) -> Iterator[Mark]:
    """An arrow over the top, clockwise where it turns with the crank."""
    end = math.copysign(SENSE, ratio)
    turns = [end * (2 * n / FEW - 1) for n in range(FEW + 1)]
    yield Polyline(layer, tuple(from_up(radius, turn) for turn in turns), arrow=True, key=key)


def _meeting(one: ShaftInFront, here: Point, other: ShaftInFront, there: Point) -> Iterator[Mark]:
    """What of the circle that one shaft sweeps lies within that of another."""
    r, R, apart = one.sweep, other.sweep, math.dist(here, there)
    if apart >= r + R or apart + R < r:
        return
    within = math.pi if apart + r <= R else math.acos((apart**2 + r**2 - R**2) / (2 * apart * r))
    towards = math.atan2(there[1] - here[1], there[0] - here[0])
    yield Arc(OUTLINE, here, r, towards - within, towards + within, key=one.key, state="fail")


def sector_outline(piece: Piece) -> tuple[Point, ...]:
    """The section of a sector, around its outside and back along its core; angles from up, clockwise."""
    assert piece.half_angle is not None
    turns = [piece.angle + piece.half_angle * n / CORNERS for n in range(-CORNERS, CORNERS + 1)]
    outside = [from_up(piece.outer_radius, turn) for turn in turns]
    return (*outside, *(from_up(piece.core_radius, turn) for turn in reversed(turns)))


def from_up(radius: Metre, angle: Radian) -> Point:
    return radius * math.sin(angle), radius * math.cos(angle)


def _point(vector: complex) -> Point:
    return vector.imag, vector.real
