# SPDX-License-Identifier: Apache-2.0
"""The sheet for the balancing machine: one page, which the machine's operator reads standing.

At the top what is written in by hand and both views, zero of the shop up: from the front a dial with the targets and
the holes, from the side the planes, rings and holes.  Below tables, each for one question."""

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from ..sheet.record import record
from ..sheet.text import COMMA, EMPTY, Amount, Name, Text
from ..sheet.units import UNITS, KilogramMetre, Metre, Number, Radian
from .annotations import LETTER, TITLE, Leaf
from .drawing import CENTRE, CUT, DIMENSION, FRAME, HIDDEN_EDGE, TABLE, VISIBLE, Point, Side
from .lettering import width
from .shaft_outline import drawn, reach
from .sizes import Say, alone, millimetres, number
from .workshop_sheet import (
    BLOCK_TOP,
    LEFT,
    LOW,
    PAD,
    STAMP,
    DrawnPart,
    Paper,
    Release,
    WorkshopSheet,
    stamp,
    title_block,
)

if TYPE_CHECKING:
    from ..countershaft.balancing.result import BalancingResult, HoleTakes, ReadingResult
    from ..countershaft.outline import Outline
    from ..design.other_tables import DocumentControl

A4 = Paper("A4", 210.0, 297.0)
WIDE = A4.right - LEFT
HAND = 10.0  # height of what is filled in by hand
DIAL_WIDE, GAP = 88.0, 3.0
ROW, CLOSE = 5.0, 4.2  # of the tables; closer where there is much to say
LEAST_VIEW, MOST_VIEW = 62.0, 88.0
TURN = 2 * math.pi
SHOWN_READINGS, SHOWN_HOLES = 4, 6  # of the table of readings; the rows of the CSV have all
STEP_OF_DIAL = 30  # degrees
ARC = math.radians(90.0)  # of the arrow that shows how angles count
At = Callable[[Radian, float], Point]
PLANES = Text("I, front"), Text("II, rear")


@record
class BalanceSheet:
    """What is on the sheet of one shaft.  `turn`: 1 where the crank turns clockwise seen from the front; `backwards`:
    whether the shaft turns against it; `also`: its mirror images; `line`: rows of the end of the line: what, and what
    it shall be."""

    name: str
    found: "BalancingResult"
    outline: "Outline | None"
    bearings: tuple[Metre, ...]
    R: Metre
    turn: Number
    backwards: bool
    also: Text
    line: tuple[tuple[Text, Text], ...]


def balancing_sheet(
    of: BalanceSheet, part: DrawnPart, control: "DocumentControl", release: Release, say: Say
) -> WorkshopSheet:
    """The page; marks in metres from its lower left corner."""
    page = Leaf()
    page.box(FRAME, LEFT, LOW, A4.right, A4.top)
    _by_hand(page, say)
    low, top = BLOCK_TOP + STAMP + GAP, A4.top - HAND
    tables = [make(of, say) for make in (_targets, _holes, _readings, _unreached, _line)]
    row = ROW
    if sum(_height(table, row) + GAP for table in tables) > top - low - LEAST_VIEW - GAP:
        row = CLOSE
    room = top - low - sum(_height(table, row) + GAP for table in tables)
    high = min(max(room, LEAST_VIEW), MOST_VIEW)
    _views(page, of, top, high, say)
    y = top - high - min(GAP, max(room - high, 0.0))
    spare = max(room - high, 0.0) / max(len([t for t in tables if t]), 1)
    for table in tables:
        for x, head, rows, columns in table:
            block = Leaf()
            block.table(rows, columns, head, row)
            page.add(block, LEFT + x, y)
        y -= _height(table, row) + (min(GAP + spare, 2 * GAP) if table else 0.0)
    facts = {"scale": "–", "material": part.material, "mass": part.mass, "sheet": part.sheet}
    title_block(page, A4, control, part, say(Text("Balancing sheet")), facts, say)
    stamp(page, A4, release, say)
    return WorkshopSheet(part.title, A4, 1.0, (), tuple(page.marks), (0.0, 0.0))


def _by_hand(page: Leaf, say: Say) -> None:
    """Three fields along the upper edge, and the verdict."""
    fields = (Text("Serial number"), 60.0), (Text("Date"), 35.0), (Text("Name"), 50.0), (Text("Passes: yes / no"), 35.0)
    x, low = LEFT, A4.top - HAND
    page.line(VISIBLE, (LEFT, low), (A4.right, low))
    for label, wide in fields:
        page.words(say(label), x + PAD, A4.top - PAD - LETTER, layer=TABLE)
        x += wide
        if x < A4.right:
            page.line(TABLE, (x, low), (x, A4.top))


# --- the views


def _views(page: Leaf, of: BalanceSheet, top: float, high: float, say: Say) -> None:
    """Side by side in a strip of the page."""
    dial, side = _dial(of, high - 4.0, say), _side(of, WIDE - DIAL_WIDE - 6.0, high - 6.0, say)
    middle = top - high / 2
    page.add(dial, LEFT + DIAL_WIDE / 2, middle)
    page.add(side, LEFT + DIAL_WIDE + (WIDE - DIAL_WIDE) / 2, middle)


def _dial(of: BalanceSheet, high: float, say: Say) -> Leaf:
    """From the front: zero up, the way in which angles count, targets as arrows from the axis, holes where they are."""
    leaf, found = Leaf(), of.found
    lines = list(_below(of))
    words = len(lines) * (LETTER + 1.2)
    r = min((high - words) / 2 - 7.0, DIAL_WIDE / 2 - 15.0)
    y0 = words / 2
    way = of.turn * found.sense  # 1: angles count clockwise here

    def at(alpha: Radian, radius: float) -> Point:
        return radius * math.sin(way * alpha), y0 + radius * math.cos(way * alpha)

    leaf.arc(VISIBLE, (0.0, y0), r)
    for degrees in range(0, 360, 10):
        long = 3.0 if degrees % STEP_OF_DIAL == 0 else 1.5
        alpha = math.radians(degrees)
        leaf.line(VISIBLE if degrees == 0 else DIMENSION, at(alpha, r), at(alpha, r + long))
        if degrees % STEP_OF_DIAL == 0:
            x, y = at(alpha, r + 6.0)
            height = TITLE if degrees == 0 else LETTER
            leaf.words(f"{degrees}°" if degrees else "0", x, y - height / 2, "centre", height)
    scale = 0.68 * r / (of.R * 1e3)
    _section(leaf, of, scale, at)
    for hole in found.hole.values():
        _hole_on_dial(leaf, hole, of, scale, at)
    _numbers_on_dial(leaf, of, scale, at)
    _targets_on_dial(leaf, of, r, at)
    # which way angles count, and which way the shaft turns in service
    mid, inner = math.radians(45.0), r - 4.0
    a, b = sorted(math.pi / 2 - way * x for x in (mid - ARC / 4, mid + ARC / 4))
    leaf.arc(VISIBLE, (0.0, y0), inner, a, b)
    tip = at(mid + ARC / 4, inner)
    leaf.arrow(tip, math.pi / 2 - way * (mid + ARC / 4) - way * (math.pi / 2 - 0.12), VISIBLE, TITLE)
    for n, line in enumerate(lines):
        leaf.words(say(line), 0.0, y0 - r - 7.0 - LETTER - 2.2 - n * (LETTER + 1.4), "centre")
    return leaf


def _below(of: BalanceSheet) -> Iterator[Text]:
    """From where angles count and which way; of a mirror image the other way."""
    yield Text("0 = {zero}", zero=of.found.zero_words)
    if of.turn * of.found.sense > 0:
        yield Text("angles count clockwise, seen from the front")
        if of.also:
            yield Text("(on {twins}, the mirror image, anticlockwise)", twins=of.also)
    else:
        yield Text("angles count anticlockwise, seen from the front")
        if of.also:
            yield Text("(on {twins}, the mirror image, clockwise)", twins=of.also)
    yield _sense_words(of)


def _sense_words(of: BalanceSheet) -> Text:
    """Which way the shaft turns in the engine."""
    clockwise = of.turn * (-1 if of.backwards else 1) > 0
    if clockwise:
        return Text("in the engine the shaft turns clockwise")
    return Text("in the engine the shaft turns anticlockwise")


def _section(leaf: Leaf, of: BalanceSheet, scale: float, at: At) -> None:
    """The sectors, as thin outlines, and the core."""
    seen: set[tuple[float, ...]] = set()
    for piece in of.outline.pieces if of.outline is not None else ():
        if piece.half_angle is None or math.pi - piece.half_angle < 1e-6:
            continue
        key = tuple(round(x, 5) for x in (piece.outer_radius, piece.core_radius, piece.half_angle, piece.angle % TURN))
        if key in seen:
            continue
        seen.add(key)
        middle, R, r = _shop(of, piece.angle), scale * piece.outer_radius * 1e3, scale * piece.core_radius * 1e3
        turns = [middle - piece.half_angle + 2 * piece.half_angle * i / 40 for i in range(41)]
        rest = [middle + piece.half_angle + (TURN - 2 * piece.half_angle) * i / 40 for i in range(41)]
        leaf.line(DIMENSION, *(at(t, R) for t in turns), *(at(t, r) for t in rest), closed=True)
    for angle in (0.0, math.pi / 2):
        leaf.line(CENTRE, at(angle, 3.0), at(angle + math.pi, 3.0))


def _shop(of: BalanceSheet, phi: Radian) -> Radian:
    return of.found.sense * (phi - of.found.zero)


def _numbers_on_dial(leaf: Leaf, of: BalanceSheet, scale: float, at: At) -> None:
    """Beside the mouths of the holes their numbers, those of one angle together."""
    there: dict[float, list[int]] = {}
    for n, hole in enumerate(of.found.hole.values(), 1):
        there.setdefault(round(_shop(of, hole.drill.angle) % TURN, 6), []).append(n)
    drills = [hole.drill for hole in of.found.hole.values()]
    out = scale * max((drill.R for drill in drills), default=0.0) * 1e3 + 2.2
    for alpha, numbers in there.items():
        _beside(leaf, ", ".join(map(str, numbers)), alpha, out, 1.0, LETTER, at)


def _beside(leaf: Leaf, words: str, alpha: Radian, out: float, way: float, height: float, at: At) -> None:
    """Words beside a radius, on the side to which angles grow (`way` 1) or fall."""
    aside = math.asin(min(1.8 / out, 1.0))
    (x, y), (x_0, _) = at(alpha + way * aside, out), at(alpha, out)
    side: Side = "centre" if abs(x - x_0) < 0.9 else "left" if x > x_0 else "right"
    leaf.words(words, x, y - height / 2, side, height)


def _hole_on_dial(leaf: Leaf, hole: "HoleTakes", of: BalanceSheet, scale: float, at: At) -> None:
    drill = hole.drill
    alpha, R = _shop(of, drill.angle), scale * drill.R * 1e3
    a, bottom = scale * drill.diameter * 500, scale * (drill.R - drill.depth) * 1e3
    tip = bottom - scale * hole.cone * 1e3

    def off(out: float, aside: float) -> Point:
        return at(alpha + math.atan2(aside, out), math.hypot(out, aside))

    top = math.sqrt(max(R * R - a * a, 0.0))
    leaf.line(HIDDEN_EDGE, off(top, a), off(bottom, a), off(max(tip, 0.1), 0.0), off(bottom, -a), off(top, -a))


def _targets_on_dial(leaf: Leaf, of: BalanceSheet, r: float, at: At) -> None:
    """An arrow from the axis for each plane; two in one direction are one with both names."""
    arrows: list[tuple[Radian, str]] = []
    for plane, name in zip(of.found.planes, ("I", "II")):
        if plane.shop_angle is None:
            continue
        same = next(
            (i for i, (a, _) in enumerate(arrows) if abs(math.remainder(a - plane.shop_angle, TURN)) < 0.1), None
        )
        if same is None:
            arrows.append((plane.shop_angle, name))
        else:
            arrows[same] = arrows[same][0], f"{arrows[same][1]} + {name}"
    for alpha, name in arrows:
        out = at(alpha, r - 0.5)
        leaf.line(CUT, at(alpha, 0.0), at(alpha, r - 3.0))
        dx, dy = out[0] - at(alpha, 0.0)[0], out[1] - at(alpha, 0.0)[1]
        leaf.arrow(out, math.atan2(dy, dx), CUT, 1.4 * TITLE)
        _beside(leaf, name, alpha, r - 6.5, -1.0, TITLE, at)


def _side(of: BalanceSheet, wide: float, high: float, say: Say) -> Leaf:
    """From the side, zero of the shop up: the silhouette, the planes and the rings with their places, the holes with
    their numbers."""
    leaf, found = Leaf(), of.found
    places = [plane.z for plane in found.planes] + [ring.z for ring in found.rings]
    start = min([*places, *([of.outline.start] if of.outline is not None else [])])
    end = max([*places, *([of.outline.end] if of.outline is not None else [])])
    scale = min((wide - 6.0) / ((end - start) * 1e3), (high - 34.0) / (2 * of.R * 1e3))
    mid, R = (start + end) / 2, scale * of.R * 1e3

    def x(z: Metre) -> float:
        return scale * (z - mid) * 1e3

    for piece in drawn(of.outline) if of.outline is not None else ():
        up, down = (scale * y * 1e3 for y in reach(piece, found.zero))
        leaf.box(VISIBLE, x(piece.start), -down, x(piece.end), up)
    leaf.line(CENTRE, (x(start) - 3.0, 0.0), (x(end) + 3.0, 0.0))
    for n, hole in enumerate(found.hole.values(), 1):
        _hole_from_side(leaf, hole, n, of, scale, x)
    for plane, name in zip(found.planes, ("I", "II")):
        z = x(plane.z)
        leaf.line(CUT, (z, R + 2.0), (z, R + 7.0))
        leaf.line(CENTRE, (z, -R - 7.0), (z, R + 2.0))
        leaf.words(name, z, R + 8.5, "centre", TITLE)
        leaf.words(say(Text("z {z}", z=millimetres(plane.z, 1))), z, R + 13.5, "centre")
    apart = [ring for ring in found.rings if all(abs(ring.z - plane.z) > 1e-6 for plane in found.planes)]
    for ring in apart:
        z = x(ring.z)
        leaf.line(HIDDEN_EDGE, (z, -R - 7.0), (z, R + 2.0))
        leaf.words(
            say(Text("ring, z {z}", z=millimetres(ring.z, 1))),
            z,
            -R - 11.5,
            "left" if ring is found.ring_front else "right",
        )
    below = -R - (16.5 if apart else 12.0)
    leaf.words(say(Text("from the side, 0 up; flywheel to the right")), 0.0, below, "centre")
    return leaf


def _hole_from_side(
    leaf: Leaf, hole: "HoleTakes", n: int, of: BalanceSheet, scale: float, x: Callable[[Metre], float]
) -> None:
    """A hole in the plane of the view from its side, another as its mouth; hidden where it is behind."""
    drill = hole.drill
    beta = drill.angle - of.found.zero
    a, R, z = scale * drill.diameter * 500, scale * drill.R * 1e3, x(drill.z)
    up, near = math.cos(beta), of.turn * math.sin(beta)
    y = R * up
    if abs(near) < 0.3:
        bottom, tip, sign = (
            scale * (drill.R - drill.depth) * 1e3,
            scale * (drill.R - drill.depth - hole.cone) * 1e3,
            math.copysign(1.0, up),
        )
        leaf.line(HIDDEN_EDGE, (z - a, y), (z - a, sign * bottom), (z, sign * tip), (z + a, sign * bottom), (z + a, y))
    else:
        turns = [TURN * i / 36 for i in range(36)]
        mouth = ((z + a * math.cos(t), y + a * abs(near) * math.sin(t)) for t in turns)
        leaf.line(VISIBLE if near > 0 else HIDDEN_EDGE, *mouth, closed=True)
    leaf.words(str(n), z, y + math.copysign(1.5, up) - (LETTER if up < 0 else 0.0), "centre")


# --- the tables: (x, head, rows, widths) side by side

Tables = list[tuple[float, str, list[tuple[str, ...]], tuple[float, ...]]]


def _height(tables: Tables, row: float) -> float:
    return max((row * (len(rows) + bool(head)) for _, head, rows, _ in tables), default=0.0)


def _fitted(rows: list[tuple[str, ...]], wide: float, grows: int = 0, least: float = 12.0) -> tuple[float, ...]:
    """The widths of columns: each as wide as what stands in it, and an equal part of what is left; where there is not
    room enough the one that `grows` is cut, down to its `least`, then the widest one."""
    own = [max(width(cells[i], LETTER) for cells in rows) + 3.2 for i in range(len(rows[0]))]
    own[grows] = max(own[grows], least)
    spare = wide - sum(own)
    if spare >= 0:
        return tuple(x + spare / len(own) for x in own)
    own[grows] = max(own[grows] + spare, least)
    widest = max(range(len(own)), key=lambda i: own[i] if i != grows else 0.0)
    own[widest] += wide - sum(own)
    return tuple(own)


def _even(columns: int) -> tuple[float, ...]:
    """To be written in by hand."""
    return (18.0, *([(WIDE - 18.0) / (columns - 1)] * (columns - 1)))


def _row(say: Say, *cells: Text) -> tuple[str, ...]:
    return tuple(say(cell) for cell in cells)


def gmm(U: KilogramMetre) -> Text:
    """Four digits: what a machine shows."""
    shown = UNITS["g·mm"].shown(U)
    return alone(number(shown, max(0, 3 - math.floor(math.log10(abs(shown)))) if shown else 0))


def at_angle(alpha: Radian | None) -> Text:
    return Text("–") if alpha is None else Text("{angle}°", angle=number(math.degrees(alpha), 1))


def _targets(of: BalanceSheet, say: Say) -> Tables:
    """Target and permitted; and the rings."""
    found = of.found
    rows = [_row(say, Text("Plane"), Text("Target, g·mm"), Text("at"), Text("Permitted, g·mm"), Text("Force, N"))]
    for plane, name in zip(found.planes, PLANES):
        permitted = Text("not known") if plane.permitted is None else down(plane.permitted)
        force = alone(number(plane.machine_force, 1))
        rows.append(_row(say, name, gmm(plane.target), at_angle(plane.shop_angle), permitted, force))
    rings = [_row(say, Text("Ring"), Text("g·mm"), Text("at"), Text("z, mm"))]
    for ring, name in zip(found.rings, (Text("front"), Text("rear"))):
        alpha = None if ring.angle is None else (found.sense * (ring.angle - found.zero)) % TURN
        alpha = None if alpha is None else 0.0 if TURN - alpha < 1e-9 else alpha
        rings.append(_row(say, name, gmm(ring.unbalance), at_angle(alpha), alone(millimetres(ring.z, 1))))
    rpm = number(UNITS["rpm"].shown(found.inputs.speed), 0)
    head = say(Text("Target, at {n} rpm on the machine", n=rpm))
    return [
        (0.0, head, rows, _fitted(rows, 110.0)),
        (113.0, say(Text("Compensating rings")), rings, _fitted(rings, 67.0)),
    ]


def down(U: KilogramMetre) -> Text:
    """Rounded down: never more than is permitted."""
    shown = UNITS["g·mm"].shown(U)
    digits = 10.0 ** (math.floor(math.log10(shown)) - 2) if shown > 0 else 1.0
    return alone(Amount(float(f"{math.floor(shown / digits + 1e-9) * digits:.3g}"), form=".12g"))


def _holes(of: BalanceSheet, say: Say) -> Tables:
    """Each hole with its depth for every tenth of what it can take."""
    found = of.found
    if not found.hole:
        return []
    shares = [alone(Amount(10.0 * n, form="g")) for n in range(1, 11)]
    rows = [_row(say, Text("Hole"), Text("at"), Text("z, mm"), Text("⌀"), Text("g·mm"), *shares)]
    for n, hole in enumerate(found.hole.values(), 1):
        drill = hole.drill
        alpha = _shop(of, drill.angle) % TURN
        alpha = 0.0 if TURN - alpha < 1e-9 else alpha
        depths = [depth_words(hole, h) for h in hole.depths]
        name = Text("{n}  {name}", n=n, name=Name(drill.name))
        size = (
            at_angle(alpha),
            alone(millimetres(drill.z, 1)),
            alone(millimetres(drill.diameter, 1)),
            _three(hole.most),
        )
        rows.append(_row(say, name, *size, *depths))
    least = max(hole.least_depth for hole in found.hole.values())
    head = say(
        Text(
            "Holes: the most that each takes, and how deep for % of it (–: below {h} mm, the drill's own curve)",
            h=millimetres(least, 1),
        )
    )
    return [(0.0, head, rows, _fitted(rows, WIDE))]


def depth_words(hole: "HoleTakes", h: Metre) -> Text:
    """A depth; a dash where the drill would not be wholly in."""
    if h < hole.least_depth:
        return Text("–")
    return alone(Amount(UNITS["mm"].shown(h), form=".1f"))


def _readings(of: BalanceSheet, say: Say) -> Tables:
    """What was read, which holes go how deep, and what is left; without readings two lines to write them in."""
    found = of.found
    names = [f"{n}" for n in range(1, len(found.hole) + 1)][:SHOWN_HOLES]
    deep = [Text("hole {n}", n=n) for n in names]
    plane = [Text("I, g·mm"), Text("at"), Text("II, g·mm"), Text("at")]
    rows = [_row(say, Text("Serial"), *plane, *deep, Text("left, I / II"), Text("verdict"))]
    for read in found.inputs.readings[:SHOWN_READINGS]:
        told = found.reading[read.serial]
        depths = [_drilled(found.hole[name], told) for name in list(found.hole)[:SHOWN_HOLES]]
        left = Text("{a} / {b}", a=_three(told.front), b=_three(told.rear))
        cells = (gmm(read.front), at_angle(read.front_ % TURN), gmm(read.rear), at_angle(read.rear_ % TURN))
        rows.append(_row(say, Name(read.serial), *cells, *depths, left, verdict_words(told)))
    for words in (Text("read"), Text("drilled")) if not found.inputs.readings else ():
        rows.append((say(words), *[""] * (len(rows[0]) - 1)))
    head = say(Text("Readings, and the depth of each hole in mm"))
    return [(0.0, head, rows, _fitted(rows, WIDE) if found.inputs.readings else _even(len(rows[0])))]


WORTH_SAYING = 0.05  # of what is permitted


def _unreached(of: BalanceSheet, say: Say) -> Tables:
    """What no hole takes, however deep: drilling only takes away, and only where a hole is."""
    rows = []
    for serial, told in list(of.found.reading.items())[:SHOWN_READINGS]:
        parts = [
            Text("{plane}: {U} g·mm at {angle}", plane=name, U=_three(abs(U)), angle=at_angle(_shop_once(of, U)))
            for plane, U, name in zip(of.found.planes, told.unreached, (Name("I"), Name("II")))
            if plane.permitted is not None and abs(U) > WORTH_SAYING * plane.permitted
        ]
        if parts:
            rows.append(_row(say, Name(serial), COMMA.join(parts)))
    return [(0.0, say(Text("Left because no hole is there, however deep")), rows, (30.0, WIDE - 30.0))] if rows else []


def _shop_once(of: BalanceSheet, U: complex) -> Radian:
    alpha = _shop(of, math.atan2(U.imag, U.real)) % TURN
    return 0.0 if TURN - alpha < 1e-9 else alpha


def _three(U: KilogramMetre) -> Text:
    return alone(number(float(f"{UNITS['g·mm'].shown(U):.3g}"), 9))


def _drilled(hole: "HoleTakes", told: "ReadingResult") -> Text:
    h = told.hole[hole.drill.name].number
    return Text("–") if h == 0.0 else depth_words(hole, h)


def verdict_words(told: "ReadingResult") -> Text:
    if told.told is None:
        return Text("not judged")
    if "fail" in told.told:
        return Text("out of tolerance")
    return Text("not decided") if "between" in told.told else Text("in tolerance")


def _line(of: BalanceSheet, say: Say) -> Tables:
    """What the end of the line measures."""
    rows = [_row(say, Text("End of line"), Text("shall be"), Text("measured"))]
    rows += [_row(say, what, shall, EMPTY) for what, shall in of.line]
    return [(0.0, "", rows, _fitted(rows, WIDE, grows=2, least=30.0))] if of.line else []
