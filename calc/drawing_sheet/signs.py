# SPDX-License-Identifier: Apache-2.0
"""Signs of a drawing: a diameter on its shelf, a surface's roughness (ISO 21920-1), the ends of a cutting plane (ISO 128-3)."""

import math

from ..draw.drawing import Box, Point
from ..sheet.layers import CUT, DIMENSION
from ..draw.lettering import width
from ..draw.annotations import LETTER, TITLE, Leaf

SLOPE = math.tan(math.pi / 3)
SHORT_LEG, LONG_LEG = 3.5, 7.0  # heights of the two legs of the sign of a surface
GAP = 1.0
MARK, TAIL = 5.5, 7.0  # a cutting plane's end, and the arrow on it


def sign_width(texture: str) -> float:
    return (SHORT_LEG + LONG_LEG) / SLOPE + width(texture, LETTER) + GAP if texture else 0.0


def roughness(leaf: Leaf, texture: str, x: float, y: float) -> None:
    """The sign that leaves the process open, standing on a line at y; its value below its bar."""
    foot = x + SHORT_LEG / SLOPE
    bend = foot + LONG_LEG / SLOPE
    end = bend + width(texture, LETTER) + GAP
    leaf.line(DIMENSION, (x, y + SHORT_LEG), (foot, y), (bend, y + LONG_LEG), (end, y + LONG_LEG))
    leaf.words(texture, bend, y + LONG_LEG - LETTER - GAP, layer=DIMENSION)


def shelf_size(label: str, texture: str) -> tuple[float, float]:
    """Width and height of what stands on a shelf."""
    wide = width(label, LETTER) + 2 * GAP
    return (wide + sign_width(texture) + 2 * GAP, LONG_LEG + GAP) if texture else (wide, LETTER + 2 * GAP)


def shelf(leaf: Leaf, foot: Point, y: float, right: bool, label: str, texture: str = "") -> None:
    """A line up from `foot`, and on the line that it bends into a label and a surface's sign."""
    wide, _ = shelf_size(label, texture)
    left = foot[0] if right else foot[0] - wide
    leaf.line(DIMENSION, foot, (foot[0], y), (foot[0] + (wide if right else -wide), y))
    leaf.words(label, left + GAP, y + GAP, layer=DIMENSION)
    if texture:
        roughness(leaf, texture, left + 3 * GAP + width(label, LETTER), y)


def cutting_plane(leaf: Leaf, letter: str, x: float, high: float, low: float) -> list[Box]:
    """Both ends of a cutting plane, with arrows that look to the right; gives what they take of the view."""
    boxes = []
    for y, way in ((high, 1.0), (low, -1.0)):
        inner, outer = y + way * GAP, y + way * (GAP + MARK)
        leaf.line(CUT, (x, inner), (x, outer))
        leaf.line(DIMENSION, (x - TAIL, outer), (x, outer))
        leaf.arrow((x, outer), 0.0)
        leaf.words(letter, x - TAIL, outer + GAP if way > 0 else outer - GAP - TITLE, "left", TITLE)
        ends = sorted((inner, outer + way * (TITLE + 2 * GAP)))
        boxes.append((x - TAIL - GAP, ends[0], x + GAP, ends[1]))
    return boxes


def radius(leaf: Leaf, centre: Point, length: float, angle: float, label: str, out: float) -> None:
    """A radius by an arrow from outside: its tip on the arc, its label on a shelf away from the middle."""
    tip, end = _polar(centre, length, angle), _polar(centre, out, angle)
    right = math.cos(angle) >= 0
    wide = width(label, LETTER) + GAP
    leaf.line(DIMENSION, tip, end, (end[0] + (wide if right else -wide), end[1]))
    leaf.arrow(tip, angle + math.pi)
    leaf.words(label, end[0] + (GAP if right else -GAP), end[1] + GAP, "left" if right else "right", layer=DIMENSION)


def through(leaf: Leaf, length: float, angle: float, back: float, label: str) -> None:
    """A radius by an arrow from inside: its line comes through the centre, from a shelf on the other side."""
    tip, end = _polar((0.0, 0.0), length, angle), _polar((0.0, 0.0), back, angle + math.pi)
    right = end[0] >= 0
    wide = width(label, LETTER) + GAP
    leaf.line(DIMENSION, tip, end, (end[0] + (wide if right else -wide), end[1]))
    leaf.arrow(tip, angle)
    leaf.words(label, end[0] + (GAP if right else -GAP), end[1] + GAP, "left" if right else "right", layer=DIMENSION)


def angle(leaf: Leaf, centre: Point, inner: float, at: float, start: float, end: float, label: str) -> None:
    """The angle between two directions, on an arc of radius `at`; the number outside its middle."""
    for side in (start, end):
        leaf.line(DIMENSION, _polar(centre, inner + GAP, side), _polar(centre, at + 2 * GAP, side))
    leaf.arc(DIMENSION, centre, at, start, end)
    back = 0.5 * 3.0 / at  # an arrow on an arc lies along its chord
    leaf.arrow(_polar(centre, at, start), start - math.pi / 2 + back)
    leaf.arrow(_polar(centre, at, end), end + math.pi / 2 - back)
    middle = (start + end) / 2
    x, y = _polar(centre, at + 1.5 * GAP, middle)
    wide = width(label, LETTER)
    leaf.words(label, x + math.cos(middle) * wide / 2, y + (math.sin(middle) - 1) * LETTER / 2, "centre", layer=DIMENSION)


def _polar(centre: Point, radius: float, angle: float) -> Point:
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
