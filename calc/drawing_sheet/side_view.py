# SPDX-License-Identifier: Apache-2.0
"""The shaft seen across its axis: its contour and edges, the diameters above it, the lengths below it."""

import math
from itertools import pairwise

from ..draw.shaft_outline import edges, reach
from ..draw.drawing import Box, Point
from ..sheet.layers import CENTRE, DIMENSION, VISIBLE
from ..draw.lettering import width
from ..sheet.text import Text
from ..sheet.units import Metre, Radian
from .facts import Turned
from ..draw.annotations import LETTER, Leaf
from .saying import Say, alone, rounded
from .shoulder import shoulders
from .signs import cutting_plane, shelf, shelf_size
from ..draw.side_view import Shelf, Span, rows, shelves

OVER = 4.0  # how far an axis goes beyond what it is the axis of
FIRST, NEXT = 9.0, 8.0  # from the view to the first row of dimensions, and from one row to the next
MARKS = 11.0  # the room of the ends of cutting planes
SHORT = 0.05  # what is shorter is not drawn
THERE = 0.3  # where in a piece its diameter is taken, in its length from its outer end
ROOM = 60.0  # beyond the view, for labels


class SideView:
    """Draws one shaft in one scale; z runs to the right from mid-shaft, the direction `up` upwards."""

    def __init__(self, pieces: list[Turned], positions: tuple[Metre, ...], up: Radian, scale: float, say: Say) -> None:
        self.pieces, self.positions, self.up, self.say = pieces, positions, up, say
        self.by = scale * 1e3
        self.reaches = [self._reach(piece) for piece in pieces]
        self.top, self.low = max(high for high, _ in self.reaches), -max(low for _, low in self.reaches)
        self.left, self.right = self.by * pieces[0].start, self.by * pieces[-1].end

    def draw(self, letters: dict[str, Metre], gear: Metre | None) -> Leaf:
        """`letters`: the cutting planes and where they are; `gear`: the reference diameter of the wheel on the shaft."""
        leaf = Leaf()
        self._shape(leaf)
        if gear is not None:
            for piece in (piece for piece in self.pieces if piece.piece.what == "gear"):
                for y in (gear / 2, -gear / 2):
                    leaf.line(CENTRE, (self.by * piece.start - 2, self.by * y), (self.by * piece.end + 2, self.by * y))
        marks = self._cuts(leaf, letters)
        self._diameters(leaf, marks)
        self._lengths(leaf)
        return leaf

    def _reach(self, piece: Turned) -> tuple[float, float]:
        if piece.piece.half_angle is None:
            return self.by * piece.radius, self.by * piece.radius
        high, low = reach(piece.piece, self.up)
        return self.by * high, self.by * low

    # --- the shape ------------------------------------------------------------------------------------------------------
    def _shape(self, leaf: Leaf) -> None:
        above: list[Point] = []
        below: list[Point] = []
        for piece, (high, low) in zip(self.pieces, self.reaches):
            for z in (piece.start, piece.end):
                above.append((self.by * z, high))
                below.append((self.by * z, -low))
        path = above + below[::-1]
        leaf.line(VISIBLE, *(point for point, before in zip(path, [path[-1], *path]) if point != before), closed=True)
        for (one, (high, low)), (other, (next_high, next_low)) in pairwise(zip(self.pieces, self.reaches)):
            x = self.by * one.end
            for a, b in shoulders(one, other, self.up):
                first, last = max(self.by * a, -min(low, next_low)), min(self.by * b, min(high, next_high))
                if last - first > SHORT:  # the rest of the shoulder belongs to the contour
                    leaf.line(VISIBLE, (x, first), (x, last))
        for piece in self.pieces:
            for (_, y), _ in edges(piece.piece, self.up):
                leaf.line(VISIBLE, (self.by * piece.start, self.by * y), (self.by * piece.end, self.by * y))
        leaf.line(CENTRE, (self.left - OVER, 0.0), (self.right + OVER, 0.0))
        for z in self.positions:
            half = self._across(z)
            leaf.line(CENTRE, (self.by * z, -half - 2), (self.by * z, half + 2))
        for plane, z in zip(("I", "II"), (self.positions[0], self.positions[-1])):
            leaf.words(plane, self.by * z + 0.8, -self._across(z) - 2 - LETTER, layer=DIMENSION)

    def _across(self, z: Metre) -> float:
        """How far the shaft reaches from its axis at a place."""
        return max((max(r) for piece, r in zip(self.pieces, self.reaches) if piece.start <= z <= piece.end), default=0.0)

    def _cuts(self, leaf: Leaf, letters: dict[str, Metre]) -> list[Box]:
        boxes = []
        for letter, z in letters.items():
            high, low = next((r for piece, r in zip(self.pieces, self.reaches) if piece.start <= z <= piece.end), (self.top, -self.low))
            boxes += cutting_plane(leaf, letter, self.by * z, high, -low)
        return boxes

    # --- what is measured -----------------------------------------------------------------------------------------------
    def _diameters(self, leaf: Leaf, marks: list[Box]) -> None:
        """A shelf for each diameter, its line across the piece with an arrow at either side."""
        asked, words = [], []
        middle = (self.left + self.right) / 2
        for piece, (high, _) in zip(self.pieces, self.reaches):
            if piece.label is None:
                continue
            a, b = self.by * piece.start, self.by * piece.end
            x = a + THERE * (b - a) if (a + b) / 2 < middle else b - THERE * (b - a)
            label, texture = self.say(piece.label), self.say(piece.texture) if piece.texture is not None else ""
            asked.append(Shelf(x, high, *shelf_size(label, texture)))
            words.append((label, texture))
        found = shelves(asked, self.top + 4.0, 4.0, (self.left - ROOM, self.right + ROOM), marks)
        for one, (label, texture), (y, right) in zip(asked, words, found):
            leaf.arrow((one.x, one.foot), math.pi / 2)
            leaf.arrow((one.x, -one.foot), -math.pi / 2)
            shelf(leaf, (one.x, -one.foot), y, right, label, texture)

    def _lengths(self, leaf: Leaf) -> None:
        """Every piece, the distances of the supports, and the whole; what follows from the others stands in brackets."""
        asked = [(piece.start, piece.end) for piece in self.pieces] + list(pairwise(self.positions))
        if len(self.pieces) > 1:
            asked.append((self.pieces[0].start, self.pieces[-1].end))
        sizes = [alone(rounded(b - a)) for a, b in asked]
        labels = [self.say(Text("({size})", size=size) if n in self._closing() else size) for n, size in enumerate(sizes)]
        spans = [Span(self.by * a, self.by * b, width(label, LETTER)) for (a, b), label in zip(asked, labels)]
        for span, label, row in zip(spans, labels, rows(spans, LETTER)):
            y = self.low - FIRST - MARKS * bool(self._eccentric) - NEXT * row.level
            leaf.dimension((span.start, self._foot(span.start)), (span.end, self._foot(span.end)), y, label, shift=row.shift)

    @property
    def _eccentric(self) -> bool:
        return any(piece.piece.half_angle is not None for piece in self.pieces)

    def _closing(self) -> set[int]:
        """Lengths that follow from the others: the last gap between the supports, and the whole."""
        last = max((n for n, piece in enumerate(self.pieces) if piece.piece.what == "core"), default=None)
        whole = len(self.pieces) + max(0, len(self.positions) - 1)
        return {whole} if last is None else {last, whole}

    def _foot(self, x: float) -> float:
        """Where the contour is left at a place: the lower end of what stands there."""
        z = x / self.by
        if any(abs(z - position) < 1e-9 for position in self.positions):
            return -self._across(z) - 2
        lows = [low for piece, (_, low) in zip(self.pieces, self.reaches) if piece.start - 1e-9 <= z <= piece.end + 1e-9]
        return -max(lows, default=0.0)
