# SPDX-License-Identifier: Apache-2.0
"""The shaft seen along its axis: from its front end, and cut through its eccentric sectors.

Both look from front to rear, where a crank that turns as engines do turns clockwise.
"""

import math
from collections.abc import Iterator

from .shaft_outline import FLAT
from ..countershaft.outline import Piece
from .drawing import Point
from ..sheet.layers import CENTRE, VISIBLE
from ..sheet.text import Text
from ..sheet.units import Metre, Radian
from ..drawing_sheet import signs
from ..drawing_sheet.facts import Turned
from .annotations import TITLE, Leaf
from ..drawing_sheet.saying import Say, degrees, millimetres

CHORD = math.radians(2.0)  # of what is hatched
OVER = 3.0
ASIDE = math.radians(40.0)  # of a radius from the middle of its sector
WIDEST = math.radians(100.0)  # half of a sector that leaves room for its radii beside it
BEHIND = 2.0  # from the end of an axis to the label of a radius
OUT = 8.0  # from a sector to its angle's arc
TURN = 2 * math.pi


def on_sheet(angle: Radian, up: Radian) -> Radian:
    """A direction of the shaft, counted as the crank turns, as an angle of the sheet."""
    return math.pi / 2 - (angle - up)


def kinds(pieces: list[Turned]) -> dict[str, Turned]:
    """The sectors that differ, each by the letter of its section."""
    found: dict[tuple[float, ...], Turned] = {}
    for one in pieces:
        piece = one.piece
        if piece.half_angle is not None:
            size = (piece.outer_radius, piece.core_radius, piece.half_angle, math.cos(piece.angle), math.sin(piece.angle))
            found.setdefault(tuple(round(x, 6) for x in size), one)
    return dict(zip("ABCDEFGHJKLMNPQRSTUVWXYZ", found.values()))


def section(letter: str, piece: Piece, up: Radian, scale: float, say: Say) -> Leaf:
    """A sector on its core, cut: hatched, with its radii and its angle."""
    assert piece.half_angle is not None
    leaf, by, half = Leaf(), scale * 1e3, piece.half_angle
    R, r, middle = by * piece.outer_radius, by * piece.core_radius, on_sheet(piece.angle, up)
    outer, core = (say(Text("R{size}", size=millimetres(size))) for size in (piece.outer_radius, piece.core_radius))
    first, last = middle - half, middle + half
    if math.pi - half < FLAT:
        leaf.hatch(_arc(R, 0.0, TURN))
        leaf.arc(VISIBLE, (0.0, 0.0), R)
        signs.radius(leaf, (0.0, 0.0), R, math.pi / 4, outer, R + OUT)
    else:
        leaf.hatch(_arc(R, first, last) + (_arc(r, last, first + TURN) if r else [(0.0, 0.0)]))
        leaf.arc(VISIBLE, (0.0, 0.0), R, first, last)
        leaf.arc(VISIBLE, (0.0, 0.0), r, last, first + TURN)
        for side in (first, last):
            leaf.line(VISIBLE, _polar(r, side), _polar(R, side))
        _sized(leaf, R, r, middle, half, (outer, core), say)
    _cross(leaf, R)
    leaf.words(f"{letter}–{letter}", 0.0, R + OUT + 9.0, "centre", TITLE)
    return leaf


def _sized(leaf: Leaf, R: float, r: float, middle: Radian, half: Radian, labels: tuple[str, str], say: Say) -> None:
    """Both radii and the angle; the radii on the side where the angle's arc is not, so of a wide sector the angle is that of its gap."""
    outer, core = labels
    centre, back = (0.0, 0.0), R + OVER + BEHIND
    if half <= WIDEST:
        signs.angle(leaf, centre, R, R + OUT, middle - half, middle + half, say(degrees(2 * half)))
        signs.through(leaf, R, middle - min(ASIDE, half / 2), back, outer)
        if r:
            signs.radius(leaf, centre, r, middle + math.pi + math.pi / 4, core, back)
    else:
        signs.angle(leaf, centre, R, R + OUT, middle + half, middle - half + TURN, say(degrees(TURN - 2 * half)))
        signs.radius(leaf, centre, R, middle - ASIDE, outer, R + OUT)
        if r:
            signs.through(leaf, r, middle + math.pi + (math.pi - half) / 2, back, core)


def end_view(pieces: list[Turned], gear: Metre | None, up: Radian, scale: float) -> Leaf:
    """The shaft from its front end: of every piece what no other hides."""
    leaf, by = Leaf(), scale * 1e3
    turns = sorted({round(angle % TURN, 9) for one in pieces for angle in _ends(one.piece, up)} | {0.0})
    fields = list(zip(turns, [*turns[1:], TURN]))
    hidden = [0.0] * len(fields)
    for one in pieces:
        radii = [_radius(one, (a + b) / 2, up) for a, b in fields]
        if len(set(radii)) == 1 and all(radii[0] > h + FLAT for h in hidden):
            leaf.arc(VISIBLE, (0.0, 0.0), by * radii[0])
        else:
            for (a, b), radius, before in zip(fields, radii, hidden):
                if radius > before + FLAT:
                    leaf.arc(VISIBLE, (0.0, 0.0), by * radius, a, b)
            for n, (a, _) in enumerate(fields):
                low, high = sorted((radii[n - 1], radii[n]))
                low = max(low, hidden[n - 1], hidden[n])
                if high > low + FLAT:
                    leaf.line(VISIBLE, _polar(by * low, a), _polar(by * high, a))
        hidden = [max(h, radius) for h, radius in zip(hidden, radii)]
    if gear is not None and pieces[0].piece.what == "gear":
        leaf.arc(CENTRE, (0.0, 0.0), by * gear / 2)
    _cross(leaf, by * max(hidden))
    return leaf


def _ends(piece: Piece, up: Radian) -> Iterator[Radian]:
    if piece.half_angle is not None and math.pi - piece.half_angle > FLAT:
        middle = on_sheet(piece.angle, up)
        yield from (middle - piece.half_angle, middle + piece.half_angle)


def _radius(one: Turned, at: Radian, up: Radian) -> Metre:
    piece = one.piece
    if piece.half_angle is None:
        return one.radius
    aside = abs(math.remainder(at - on_sheet(piece.angle, up), TURN))
    return piece.outer_radius if aside < piece.half_angle else piece.core_radius


def _cross(leaf: Leaf, radius: float) -> None:
    for way in ((1.0, 0.0), (0.0, 1.0)):
        reach = radius + OVER
        leaf.line(CENTRE, (-reach * way[0], -reach * way[1]), (reach * way[0], reach * way[1]))


def _arc(radius: float, start: Radian, end: Radian) -> list[Point]:
    n = max(2, math.ceil((end - start) / CHORD))
    return [_polar(radius, start + (end - start) * i / n) for i in range(n + 1)]


def _polar(radius: float, angle: Radian) -> Point:
    return radius * math.cos(angle), radius * math.sin(angle)
