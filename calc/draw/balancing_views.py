# SPDX-License-Identifier: Apache-2.0
"""The views of the balancing sheet, the shop's zero up: from the front a dial in the shop's angles with the targets and
the holes, from the side the planes, the rings and the holes by their numbers."""

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Metre, Number, Radian
from .annotations import LETTER, TITLE, Leaf
from .drawing import CENTRE, CUT, DIMENSION, HIDDEN_EDGE, VISIBLE, Point, Side
from .lettering import wrapped
from .shaft_outline import drawn, reach
from .sizes import Say, millimetres
from .workshop_sheet import LEFT, Paper

if TYPE_CHECKING:
    from ..countershaft.balancing.result import BalancingResult, HoleTakes
    from ..countershaft.outline import Outline

A4 = Paper("A4", 210.0, 297.0)
WIDE = A4.right - LEFT
DIAL_WIDE, GAP, LINE = 88.0, 3.0, 4.2
TURN = 2 * math.pi
STEP_OF_DIAL = 30  # degrees
LEAST_SIDE = 8.0  # of the shaft's diameter from the side
NAMED = 3  # numbers of holes at one angle: of more the first two
ARC = math.radians(90.0)  # of the arrow that shows how angles count
At = Callable[[Radian, float], Point]


@record
class LineRow:
    """What the end of the line measures, and what it shall be; the same as numbers in SI, each with the end of its id,
    its unit and its label."""

    key: str
    what: Text
    shall: Text
    numbers: tuple[tuple[str, float, str, Text], ...] = ()


@record
class BalanceSheet:
    """What is on the sheet of one shaft.  `turn`: 1 where the crank turns clockwise seen from the front; `backwards`:
    whether the shaft turns against it; `also`: its mirror images, `same`: whether
    they are the same part; `line`: rows of the end of the line."""

    found: "BalancingResult"
    outline: "Outline | None"
    R: Metre
    turn: Number
    backwards: bool
    also: Text
    same: Text
    line: tuple[LineRow, ...]


# --- the views


def views(page: Leaf, of: BalanceSheet, top: float, high: float, say: Say) -> None:
    """Side by side in a strip of the page; what the angles are stands under the view from the side."""
    said = [part for line in conditions(of) for part in wrapped(say(line), LETTER, WIDE - DIAL_WIDE)]
    words = len(said) * LINE + GAP
    middle, right = top - high / 2, LEFT + DIAL_WIDE + (WIDE - DIAL_WIDE) / 2
    page.add(_dial(of, high - 4.0), LEFT + DIAL_WIDE / 2, middle)
    page.add(_side(of, WIDE - DIAL_WIDE - 6.0, high - words - 4.0, say), right, middle + words / 2)
    for n, line in enumerate(said):
        page.words(line, right, top - high + words - GAP - (n + 0.5) * LINE, "centre")


def _dial(of: BalanceSheet, high: float) -> Leaf:
    """From the front: zero up, the way in which angles count, targets as arrows from the axis, holes where they are."""
    leaf, found = Leaf(), of.found
    r = min(high / 2 - 8.5, DIAL_WIDE / 2 - 15.0)
    way = of.turn * found.sense  # 1: angles count clockwise here

    def at(alpha: Radian, radius: float) -> Point:
        return radius * math.sin(way * alpha), radius * math.cos(way * alpha)

    leaf.arc(VISIBLE, (0.0, 0.0), r)
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
    # which way angles count
    mid, inner = math.radians(45.0), r - 4.0
    a, b = sorted(math.pi / 2 - way * x for x in (mid - ARC / 4, mid + ARC / 4))
    leaf.arc(VISIBLE, (0.0, 0.0), inner, a, b)
    tip = at(mid + ARC / 4, inner)
    leaf.arrow(tip, math.pi / 2 - way * (mid + ARC / 4) - way * (math.pi / 2 - 0.12), VISIBLE, TITLE)
    return leaf


def conditions(of: BalanceSheet) -> Iterator[Text]:
    """From where angles count and which way; of a mirror image the other way, also where it is the same part."""
    yield Text("0 = {zero}", zero=of.found.zero_words)
    if of.turn * of.found.sense > 0:
        yield Text("angles count clockwise, seen from the front")
        if of.also:
            yield Text("(on {twins}, the mirror image, anticlockwise)", twins=of.also)
    else:
        yield Text("angles count anticlockwise, seen from the front")
        if of.also:
            yield Text("(on {twins}, the mirror image, clockwise)", twins=of.also)
    if of.same:
        yield of.same
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
        middle, R, r = shop(of, piece.angle), scale * piece.outer_radius * 1e3, scale * piece.core_radius * 1e3
        turns = [middle - piece.half_angle + 2 * piece.half_angle * i / 40 for i in range(41)]
        rest = [middle + piece.half_angle + (TURN - 2 * piece.half_angle) * i / 40 for i in range(41)]
        leaf.line(DIMENSION, *(at(t, R) for t in turns), *(at(t, r) for t in rest), closed=True)
    for angle in (0.0, math.pi / 2):
        leaf.line(CENTRE, at(angle, 3.0), at(angle + math.pi, 3.0))


def shop(of: BalanceSheet, phi: Radian) -> Radian:
    return of.found.sense * (phi - of.found.zero)


def _numbers_on_dial(leaf: Leaf, of: BalanceSheet, scale: float, at: At) -> None:
    """Beside the mouths of the holes their numbers, those of one angle together."""
    there: dict[float, list[int]] = {}
    for n, hole in enumerate(of.found.hole.values(), 1):
        there.setdefault(round(shop(of, hole.drill.angle) % TURN, 6), []).append(n)
    drills = [hole.drill for hole in of.found.hole.values()]
    out = scale * max((drill.R for drill in drills), default=0.0) * 1e3 + 2.2
    for alpha, numbers in there.items():
        words = ", ".join(map(str, numbers if len(numbers) <= NAMED else numbers[: NAMED - 1]))
        words += " …" if len(numbers) > NAMED else ""
        _beside(leaf, words, alpha, out, 1.0, LETTER, at)


def _beside(leaf: Leaf, words: str, alpha: Radian, out: float, way: float, height: float, at: At) -> None:
    """Words beside a radius, on the side to which angles grow (`way` 1) or fall."""
    aside = math.asin(min(1.8 / out, 1.0))
    (x, y), (x_0, _) = at(alpha + way * aside, out), at(alpha, out)
    side: Side = "centre" if abs(x - x_0) < 0.9 else "left" if x > x_0 else "right"
    leaf.words(words, x, y - height / 2, side, height)


def _hole_on_dial(leaf: Leaf, hole: "HoleTakes", of: BalanceSheet, scale: float, at: At) -> None:
    drill = hole.drill
    alpha, R = shop(of, drill.angle), scale * drill.R * 1e3
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
    scale = min((wide - 6.0) / ((end - start) * 1e3), max(high - 36.0, LEAST_SIDE) / (2 * of.R * 1e3))
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
