# SPDX-License-Identifier: Apache-2.0
"""What stands on a shelf above a view: a diameter, the roughness of its surface (ISO 21920-1), the datum that its axis
is (ISO 5459); or the frame of a surface's geometrical tolerances (ISO 1101)."""

import math
from collections.abc import Callable
from typing import Literal

from ..sheet.record import record
from .annotations import GAP, LETTER, Leaf
from .drawing import DIMENSION, Area, Inscription, Point
from .lettering import inscribed_height, inscribed_width, width

SLOPE = math.tan(math.pi / 3)
SHORT_LEG, LONG_LEG = 3.5, 7.0  # heights of the two legs of the sign of a surface
CELL = 2 * LETTER  # height of a frame's row, and of the box of a datum's letter
SIGN = 7.0  # width of a frame's first cell
TRIANGLE = 2.0  # height of a datum's triangle, and of the line between it and its box
_MM = 1e-3

Characteristic = Literal["cylindricity", "run-out"]


@record
class Zone:
    """One row of a frame: what is limited, how wide the zone is, and to which datum."""

    characteristic: Characteristic
    size: str
    datum: str = ""


@record
class OnShelf:
    """A size with its surface and its datum, or a frame of tolerances."""

    size: Inscription | None = None
    texture: str = ""
    datum: str = ""
    frame: tuple[Zone, ...] = ()

    @property
    def wide(self) -> float:
        if self.frame:
            return GAP + sum(_columns(self.frame))
        assert self.size is not None
        signs = sign_width(self.texture) + 2 * GAP * bool(self.texture) + (CELL + 2 * GAP) * bool(self.datum)
        return inscribed_width(self.size, LETTER) + 2 * GAP + signs

    @property
    def high(self) -> float:
        if self.frame:
            return CELL * len(self.frame)
        assert self.size is not None
        heights = [inscribed_height(self.size, LETTER) + 2 * GAP]
        heights += [LONG_LEG + GAP] if self.texture else []
        heights += [2 * TRIANGLE + CELL] if self.datum else []
        return max(heights)


def shelf(leaf: Leaf, line: tuple[float, float, float], y: float, right: bool, content: OnShelf) -> None:
    """`line`: where it stands on the sheet, and from where to where the shaft reaches there; a shelf at the height y,
    to the right of the line or to its left."""
    x, low, high = line
    left = x if right else x - content.wide
    if content.frame:
        middle = y + content.high / 2
        leaf.line(DIMENSION, (x, high), (x, middle), (x + (GAP if right else -GAP), middle))
        leaf.arrow((x, high), -math.pi / 2)
        frame(leaf, content.frame, left + GAP * right, y)
        return
    assert content.size is not None
    picture = Leaf()
    picture.line(DIMENSION, (x, low), (x, y), (x + (content.wide if right else -content.wide), y))
    picture.arrow((x, high), math.pi / 2)
    picture.arrow((x, low), -math.pi / 2)
    picture.inscribe(content.size, left + GAP, y + GAP)
    leaf.measure("length", ((x, low), (x, high), (x, low)), picture, content.size, math.pi / 2)
    here = left + 2 * GAP + inscribed_width(content.size, LETTER)
    if content.texture:
        roughness(leaf, content.texture, here + GAP, y)
        here += 2 * GAP + sign_width(content.texture)
    if content.datum:
        datum(leaf, content.datum, here + GAP + CELL / 2, y)


# --- roughness


def sign_width(texture: str) -> float:
    return (SHORT_LEG + LONG_LEG) / SLOPE + width(texture, LETTER) + GAP if texture else 0.0


def roughness(leaf: Leaf, texture: str, x: float, y: float) -> None:
    """The sign that leaves the process open, standing on a line at y; its value below its bar."""
    foot = x + SHORT_LEG / SLOPE
    bend = foot + LONG_LEG / SLOPE
    end = bend + width(texture, LETTER) + GAP
    leaf.line(DIMENSION, (x, y + SHORT_LEG), (foot, y), (bend, y + LONG_LEG), (end, y + LONG_LEG))
    leaf.words(texture, bend, y + LONG_LEG - LETTER - GAP, layer=DIMENSION)


# --- datums and frames


def datum(leaf: Leaf, letter: str, x: float, y: float) -> None:
    """A filled triangle on a line at y, and above it the letter in its box."""
    corners = [(x - TRIANGLE / 2, y), (x + TRIANGLE / 2, y), (x, y + TRIANGLE)]
    leaf.marks.append(Area(DIMENSION, (tuple((a * _MM, b * _MM) for a, b in corners),), 1.0))
    foot = y + 2 * TRIANGLE
    leaf.line(DIMENSION, (x, y + TRIANGLE), (x, foot))
    leaf.box(DIMENSION, x - CELL / 2, foot, x + CELL / 2, foot + CELL)
    leaf.words(letter, x, foot + (CELL - LETTER) / 2, "centre", layer=DIMENSION)


def _columns(frame: tuple[Zone, ...]) -> tuple[float, ...]:
    """The widths of a frame's cells: sign, size, datum."""
    sizes = max(width(zone.size, LETTER) for zone in frame) + 2 * GAP
    datums = max(width(zone.datum, LETTER) for zone in frame)
    return (SIGN, sizes, datums + 2 * GAP) if datums else (SIGN, sizes)


def frame(leaf: Leaf, rows: tuple[Zone, ...], left: float, low: float) -> None:
    for n, zone in enumerate(reversed(rows)):
        y, x = low + n * CELL, left
        leaf.box(DIMENSION, x, y, x + SIGN, y + CELL)
        SIGNS[zone.characteristic](leaf, (x + SIGN / 2, y + CELL / 2))
        x += SIGN
        for wide, words in zip(_columns(rows)[1:], (zone.size, zone.datum)):
            if words:
                leaf.box(DIMENSION, x, y, x + wide, y + CELL)
                leaf.words(words, x + wide / 2, y + (CELL - LETTER) / 2, "centre", layer=DIMENSION)
            x += wide


def _cylindricity(leaf: Leaf, middle: Point) -> None:
    """A circle between two parallel lines at 60°."""
    (x, y), r = middle, LETTER / 2 - 0.15
    leaf.arc(DIMENSION, middle, r)
    along, across = (0.5, math.sqrt(0.75)), (math.sqrt(0.75), -0.5)
    for side in (r, -r):
        foot = x + side * across[0], y + side * across[1]
        ends = [(foot[0] + s * 1.6 * along[0], foot[1] + s * 1.6 * along[1]) for s in (-1, 1)]
        leaf.line(DIMENSION, *ends)


def _runout(leaf: Leaf, middle: Point) -> None:
    """An arrow to the upper right."""
    (x, y), reach = middle, LETTER * 0.55
    tip = x + reach, y + reach
    leaf.line(DIMENSION, (x - reach, y - reach), tip)
    leaf.arrow(tip, math.pi / 4, height=LETTER * 0.7)


SIGNS: dict[str, Callable[[Leaf, Point], None]] = {"cylindricity": _cylindricity, "run-out": _runout}
