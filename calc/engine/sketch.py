# SPDX-License-Identifier: Apache-2.0
"""The engine as a sketch: its crank from the front with a cylinder of each bank, the row of cylinders, the firing order
around a clock.

The crank turns clockwise, cylinder 1 stands at its TDC.  In the row the second bank of a vee or a boxer is folded down.
"""

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from ..draw.drawing import (
    AXIS,
    CONTEXT,
    DIMENSIONS,
    OUTLINE,
    WORDS,
    Arc,
    Area,
    Dimension,
    Mark,
    Point,
    Polyline,
    Sketch,
    Words,
    rectangle,
)
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Amount, Name, Text
from ..sheet.units import Metre, Radian
from .crank import Crank, Firing, crank, firing
from .inputs import EngineInputs

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

BORE = dotted("engine", EngineInputs.bore)
RADIUS = dotted("engine", EngineInputs.crank_radius)
ROD = dotted("engine", EngineInputs.rod_length)
PITCH = dotted("engine", EngineInputs.cylinder_pitch)
THROWS = dotted("engine", EngineInputs.crank_angles)
ORDER = dotted("engine", EngineInputs.firing_order)
BANKS = dotted("engine", EngineInputs.bank_angle)
# of the bore; the engine says nothing of them: a piston's height below and above its pin, and the room above it
SKIRT, CROWN, HEAD = 0.3, 0.3, 0.06
PIN = 0.2  # of the crank radius: half of a crankpin's diameter, where no throw is given
NUMBER = 1.4  # crank radii: where the number of a throw stands
SAME = 1e-6  # rad


@record
class Throw:
    """One cylinder in the frame of its bank, along whose axis y runs, with x in the sense of rotation."""

    number: int
    z: Metre
    bank: Radian  # the direction of its axis, clockwise from up
    turned: Radian  # of its crankpin, the same
    pin: Point
    piston: Point  # its pin
    dead: tuple[Metre, Metre]  # of its pin along the axis at bottom and top dead centre


def sketch(design: "Design", results: "Results | None" = None) -> Sketch:
    """The engine of a design, cylinder 1 at TDC."""
    engine = design.engine
    assert engine is not None  # its picture is asked for only where there is one
    throws, placed = _throws(engine)
    notes = [Text("mm")]
    beside: tuple[Sketch, ...] = ()
    if engine.cylinders > 1:
        fires = firing(engine, placed)
        notes.append(Text("fires {order}", order=Name("-".join(map(str, fires.order)))))
        beside = _row(engine, throws), _clock(engine, fires)
    return Sketch(tuple(_end_view(engine, throws)), tuple(notes), title=Text("cylinder 1 at TDC"), beside=beside)


def icon(engine: EngineInputs) -> Sketch:
    """Crank and banks without words, to be told apart at a few cells."""
    throws, _ = _throws(engine)
    marks: list[Mark] = [Arc(CONTEXT, (0.0, 0.0), 1.0)]
    marks += [Polyline(OUTLINE, ((0.0, 0.0), _from_up(1.0, turned))) for turned, _ in _pins(throws)]
    for bank in sorted({throw.bank for throw in throws}):
        block = [_turned(corner, bank) for corner in rectangle(-0.6, 1.3, 0.6, 2.6)]
        marks += [Area(CONTEXT, (tuple(block),), 0.5), Polyline(OUTLINE, tuple(block), closed=True)]
    return Sketch(tuple(marks))


# --- where everything stands


def _throws(engine: EngineInputs) -> tuple[list[Throw], Crank]:
    r, length, d = engine.crank_radius, engine.rod_length, engine.cylinder_offset
    placed = crank(engine, math.asin(d / (length + r)))
    throws = []
    for k in range(engine.cylinders):
        bank, turned = float(placed.psi[k]), float(placed.theta_0 + placed.phi[k])
        r_k, d = engine.radii[k], engine.offsets[k]
        pin = _from_up(r_k, turned - bank)
        piston = d, pin[1] + math.sqrt(length**2 - (pin[0] - d) ** 2)
        dead = math.sqrt((length - r_k) ** 2 - d**2), math.sqrt((length + r_k) ** 2 - d**2)
        throws.append(Throw(k + 1, float(placed.z[k]), bank, turned, pin, piston, dead))
    return throws, placed


def _from_up(radius: Metre, angle: Radian) -> Point:
    return radius * math.sin(angle), radius * math.cos(angle)


def _turned(at: Point, angle: Radian) -> Point:
    """A place of a bank's frame, with the bank at its angle."""
    x, y = at
    return x * math.cos(angle) + y * math.sin(angle), y * math.cos(angle) - x * math.sin(angle)


def _pins(throws: Iterable[Throw]) -> list[tuple[Radian, str]]:
    """The directions of the throws, seen from the front, each with the numbers of its cylinders."""
    pins: list[tuple[Radian, list[str]]] = []
    for throw in throws:
        same = next((numbers for angle, numbers in pins if math.cos(angle - throw.turned) > 1 - SAME), None)
        if same is None:
            pins.append((throw.turned, [str(throw.number)]))
        else:
            same.append(str(throw.number))
    return [(angle, "·".join(numbers)) for angle, numbers in pins]


def _arch(middle: Metre, width: Metre, bottom: Metre, top: Metre) -> tuple[Point, ...]:
    """Up one side, across, and down the other."""
    left, right = middle - width / 2, middle + width / 2
    return (left, bottom), (left, top), (right, top), (right, bottom)


def _number(symbol: str, length: Metre) -> Text:
    return Text("{symbol} {number}", symbol=Name(symbol), number=Amount(length * 1000))


# --- from the front


def _end_view(engine: EngineInputs, throws: list[Throw]) -> Iterator[Mark]:
    r, bore = engine.crank_radius, engine.bore
    pin = engine.throw.pin_diameter / 2 if engine.throw is not None else PIN * r
    yield Arc(CONTEXT, (0.0, 0.0), r, key=RADIUS)
    for turned, numbers in _pins(throws):
        tip = _from_up(r, turned)
        yield Polyline(OUTLINE, ((0.0, 0.0), tip), key=THROWS)
        yield Arc(OUTLINE, tip, pin, key=THROWS)
        yield Words(WORDS, _from_up(NUMBER * r, turned), numbers, key=THROWS, side="centre")
    banks = {throw.bank: throw for throw in reversed(throws)}
    for bank, throw in banks.items():
        x, y = throw.piston
        block = _arch(x, bore, throw.dead[0] - SKIRT * bore, throw.dead[1] + (CROWN + HEAD) * bore)
        yield Polyline(CONTEXT, tuple(_turned(corner, bank) for corner in block), key=BORE)
        crown = [
            _turned(corner, bank)
            for corner in rectangle(x - bore / 2, y - SKIRT * bore, x + bore / 2, y + CROWN * bore)
        ]
        yield Area(OUTLINE, (tuple(crown),), key=BORE)
        yield Polyline(OUTLINE, tuple(crown), closed=True, key=BORE)
        yield Polyline(OUTLINE, (_turned(throw.pin, bank), _turned(throw.piston, bank)), key=ROD)
    if len(banks) == 1:
        yield from _dimensions(engine, throws[0])
    elif engine.layout == "vee" and engine.bank_angle:
        yield from _bank_angle(engine, throws)


def _dimensions(engine: EngineInputs, throw: Throw) -> Iterator[Mark]:
    """Of a cylinder that stands upright at its TDC."""
    x, y = throw.piston
    bore, (low, high) = engine.bore, throw.dead
    top = high + (CROWN + HEAD) * bore
    yield Dimension(
        DIMENSIONS, (x - bore / 2, top), (x + bore / 2, top), (x, top + 0.18 * bore), key=BORE, label=_number("D", bore)
    )
    right = x + bore / 2
    crown = CROWN * bore
    yield Dimension(
        DIMENSIONS,
        (right, low + crown),
        (right, high + crown),
        (right + 0.25 * bore, y),
        upright=True,
        key=RADIUS,
        label=_number("s", high - low),
    )
    left = min(x - bore / 2, -engine.crank_radius)
    yield Dimension(
        DIMENSIONS,
        (throw.pin[0], throw.pin[1]),
        (x, y),
        (left - 0.25 * bore, y),
        upright=True,
        key=ROD,
        label=_number("L", engine.rod_length),
    )


def _bank_angle(engine: EngineInputs, throws: list[Throw]) -> Iterator[Mark]:
    half = (engine.bank_angle or 0.0) / 2
    reach = throws[0].dead[1] + (CROWN + HEAD) * engine.bore
    around = 0.75 * reach
    for side in (-half, half):
        yield Polyline(AXIS, ((0.0, 0.0), _from_up(1.06 * reach, side)), key=BANKS)
    yield Arc(CONTEXT, (0.0, 0.0), around, math.pi / 2 - half, math.pi / 2 + half, key=BANKS)
    yield Words(
        WORDS, (0.0, 1.1 * around), Text("{angle}", angle=Amount(math.degrees(2 * half), "°")), key=BANKS, side="centre"
    )


# --- the row


def _row(engine: EngineInputs, throws: list[Throw]) -> Sketch:
    bore, r = engine.bore, engine.crank_radius
    marks: list[Mark] = []
    folded = {throw.bank: -1 if n % 2 else 1 for n, throw in enumerate({t.bank: t for t in throws}.values())}
    for throw in throws:
        up, z = folded[throw.bank], throw.z
        bottom, top = up * (throw.dead[0] - SKIRT * bore), up * (throw.dead[1] + (CROWN + HEAD) * bore)
        pin, piston = up * throw.pin[1], up * throw.piston[1]
        crown = rectangle(z - bore / 2, piston - up * SKIRT * bore, z + bore / 2, piston + up * CROWN * bore)
        marks += [
            Polyline(CONTEXT, _arch(z, bore, bottom, top), key=BORE),
            Area(OUTLINE, (crown,), key=BORE),
            Polyline(OUTLINE, crown, closed=True, key=BORE),
            Polyline(OUTLINE, ((z, pin), (z, piston - up * SKIRT * bore)), key=ROD),
            Polyline(OUTLINE, _arch(z, 2 * bore / 5, 0.0, pin), key=RADIUS),
            Words(WORDS, (z, piston), str(throw.number), side="centre"),
        ]
    first, last = min(t.z for t in throws) - 0.65 * bore, max(t.z for t in throws) + 0.65 * bore
    marks.append(Polyline(AXIS, ((first, 0.0), (last, 0.0))))
    places = sorted({round(throw.z, 9) for throw in throws if throw.bank == throws[0].bank})
    if len(places) > 1:
        below = -1.25 * r if -1 not in folded.values() else -max(t.dead[1] for t in throws) - 0.6 * bore
        marks.append(
            Dimension(
                DIMENSIONS,
                (places[0], 0.0),
                (places[1], 0.0),
                (places[0], below),
                key=PITCH,
                label=_number("a", places[1] - places[0]),
            )
        )
    return Sketch(tuple(marks), title=Text("from the side"))


# --- the clock


def _clock(engine: EngineInputs, fires: Firing) -> Sketch:
    """When the cylinders fire, over the working cycle, which is once around."""
    cycle = engine.strokes * math.pi
    marks: list[Mark] = [Arc(CONTEXT, (0.0, 0.0), 1.0, key=ORDER)]
    for number in fires.order:
        angle = float(fires.angles[number - 1]) / cycle * 2 * math.pi
        marks.append(Polyline(OUTLINE, (_from_up(0.45, angle), _from_up(1.0, angle)), key=ORDER))
        marks.append(Words(WORDS, _from_up(1.25, angle), str(number), key=ORDER, side="centre"))
    marks.append(Words(CONTEXT, (0.0, 0.0), Text("{angle}", angle=Amount(math.degrees(cycle), "°")), side="centre"))
    return Sketch(tuple(marks), title=Text("firing over a cycle"))
