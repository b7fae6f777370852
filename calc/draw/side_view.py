# SPDX-License-Identifier: Apache-2.0
"""The shaft seen from the side: its shoulders, and the view itself with diameters above and lengths below."""

import math
from itertools import pairwise

from ..sheet.units import Metre, Radian
from . import sizes
from .annotations import LETTER, Leaf, cutting_plane
from .defaults import general
from .drawing import CENTRE, DIMENSION, HIDDEN_EDGE, VISIBLE, Box, Point
from .indications import OnShelf, Zone, shelf
from .lettering import inscribed_width, width
from .placing import CLEAR, Shelf, Span, rows, shelves
from .shaft_outline import FLAT, edges, reach
from .sizes import Say
from .turned import TurnedPiece

# --- where two pieces of a shaft meet
# The parts of the line between them that are seen, where one of them steps back behind the other.

SAME = 1e-7  # m: surfaces closer than this go on into one another


def shoulders(piece: TurnedPiece, other: TurnedPiece, up: Radian) -> list[tuple[Metre, Metre]]:
    """The heights between which their surfaces do not go on into one another, on the side of who looks."""
    heights = sorted({*_corners(piece, up), *_corners(other, up)})
    spans: list[tuple[Metre, Metre]] = []
    for a, b in pairwise(heights):
        near, far = _depth(piece, (a + b) / 2, up), _depth(other, (a + b) / 2, up)
        if b - a < SAME or near == far or abs(near - far) < SAME:  # equal as well where neither reaches so high
            continue
        if spans and a - spans[-1][1] < SAME:
            a = spans.pop()[0]
        spans.append((a, b))
    return spans


def _faces(piece: TurnedPiece, up: Radian) -> tuple[Radian, ...]:
    """The directions of a sector's two flat faces; of a full cylinder, and of a whole ring, none."""
    half = piece.piece.half_angle
    if half is None or math.pi - half < FLAT:
        return ()
    return piece.piece.angle - up - half, piece.piece.angle - up + half


def _corners(piece: TurnedPiece, up: Radian) -> list[Metre]:
    """The heights at which its surface changes from one shape to the next."""
    R, r, faces = piece.radius, piece.piece.core_radius, _faces(piece, up)
    return [R, -R, *((r, -r) if faces else ()), *(radius * math.cos(face) for face in faces for radius in (R, r)), 0.0]


def _depth(piece: TurnedPiece, y: Metre, up: Radian) -> Metre:
    """How near its surface comes to who looks, counted from the axis, at a height; far behind where it does not reach
    so high."""
    R, r, faces = piece.radius, piece.piece.core_radius, _faces(piece, up)
    if not faces:
        return math.sqrt(R * R - y * y) if abs(y) < R else -math.inf
    assert piece.piece.half_angle is not None
    middle, near = piece.piece.angle - up, [-math.inf]
    if abs(y) < r:
        near.append(math.sqrt(r * r - y * y))
    if abs(y) < R:
        for turn in (math.acos(y / R), -math.acos(y / R)):
            if abs(math.remainder(turn - middle, 2 * math.pi)) <= piece.piece.half_angle:
                near.append(R * math.sin(turn))
    for face in faces:
        if abs(math.cos(face)) > FLAT and 0.0 <= y / math.cos(face) <= R:
            near.append(y * math.tan(face))
    return max(near)


# --- the view: contour and edges, the diameters above, the lengths below

OVER = 4.0  # how far an axis goes beyond what it is the axis of
FIRST, NEXT = 9.0, 8.0  # from the view to the first row of dimensions, and from one row to the next
MARKS = 11.0  # the room of the ends of cutting planes
SHORT = 0.05  # what is shorter is not drawn
DIAMETER, FRAME = 0.3, 0.75  # where in a piece these are, in its length from its outer end
UNTOLERANCED: Metre = 0.5e-3  # up to here ISO 2768-1 has no general tolerance
ROOM = 35.0  # beyond the view, for labels


class SideView:
    """Draws one shaft in one scale; z runs to the right from mid-shaft, the direction `up` upwards."""

    def __init__(
        self,
        pieces: list[TurnedPiece],
        positions: tuple[Metre, ...],
        up: Radian,
        scale: float,
        say: Say,
        bore: Metre = 0.0,
    ) -> None:
        """`bore`: radius of a bore along the whole shaft."""
        self.pieces, self.positions, self.up, self.say, self.bore = pieces, positions, up, say, bore
        self.by = scale * 1e3
        self.eccentric = any(piece.piece.half_angle is not None for piece in pieces)
        self.reaches = [self._reach(piece) for piece in pieces]
        self.top, self.low = max(high for high, _ in self.reaches), -max(low for _, low in self.reaches)
        self.left, self.right = self.by * pieces[0].start, self.by * pieces[-1].end

    def draw(self, letters: dict[str, Metre], gear: Metre | None) -> Leaf:
        """`letters`: the cutting planes and where they are; `gear`: the reference diameter of the wheel on the
        shaft."""
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

    def _reach(self, piece: TurnedPiece) -> tuple[float, float]:
        if piece.piece.half_angle is None:
            return self.by * piece.radius, self.by * piece.radius
        high, low = reach(piece.piece, self.up)
        return self.by * high, self.by * low

    # --- the shape

    def _shape(self, leaf: Leaf) -> None:
        above: list[Point] = []
        below: list[Point] = []
        for piece, (high, low) in zip(self.pieces, self.reaches):
            for z in (piece.start, piece.end):
                above.append((self.by * z, high))
                below.append((self.by * z, -low))
        path = above + below[::-1]
        leaf.line(VISIBLE, *(point for point, before in zip(path, [path[-1], *path]) if point != before), closed=True)
        for (front_piece, (high, low)), (other, (next_high, next_low)) in pairwise(zip(self.pieces, self.reaches)):
            x = self.by * front_piece.end
            for a, b in shoulders(front_piece, other, self.up):
                first, last = max(self.by * a, -min(low, next_low)), min(self.by * b, min(high, next_high))
                if last - first > SHORT:  # the rest of the shoulder belongs to the contour
                    leaf.line(VISIBLE, (x, first), (x, last))
        for piece in self.pieces:
            for (_, y), _ in edges(piece.piece, self.up):
                leaf.line(VISIBLE, (self.by * piece.start, self.by * y), (self.by * piece.end, self.by * y))
        for y in (self.by * self.bore, -self.by * self.bore) if self.bore else ():
            leaf.line(HIDDEN_EDGE, (self.left, y), (self.right, y))
        leaf.line(CENTRE, (self.left - OVER, 0.0), (self.right + OVER, 0.0))
        for z in self.positions:
            half = self._across(z)
            leaf.line(CENTRE, (self.by * z, -half - 2), (self.by * z, half + 2))
        for plane, z in zip(("I", "II"), (self.positions[0], self.positions[-1])):
            leaf.words(plane, self._beside_extensions(plane, z), -self._across(z) - 2 - LETTER, layer=DIMENSION)

    def _beside_extensions(self, name: str, z: Metre) -> float:
        """Where the name of a plane begins: to its right, clear of the extension lines of the lengths."""
        ends = [self.by * end for piece in self.pieces for end in (piece.start, piece.end)]
        wide, x = width(name, LETTER), self.by * z + 0.8
        while any(x < end + CLEAR / 2 and end - CLEAR / 2 < x + wide for end in ends):
            x += 0.1
        return x

    def _at(self, z: Metre, near: Metre = 0.0) -> list[tuple[float, float]]:
        """How far the pieces reach above and below the axis that stand at a place, or `near` to it."""
        pieces = zip(self.pieces, self.reaches)
        return [ends for piece, ends in pieces if piece.start - near <= z <= piece.end + near]

    def _across(self, z: Metre) -> float:
        """How far the shaft reaches from its axis at a place."""
        return max(map(max, self._at(z)), default=0.0)

    def _cuts(self, leaf: Leaf, letters: dict[str, Metre]) -> list[Box]:
        boxes = []
        for letter, z in letters.items():
            high, low = next(iter(self._at(z)), (self.top, -self.low))
            boxes += cutting_plane(leaf, letter, self.by * z, high, -low)
        return boxes

    # --- what is measured

    def _diameters(self, leaf: Leaf, marks: list[Box]) -> None:
        """A shelf for each diameter, its line across the piece with an arrow at either side; and one for what limits
        its shape, with an arrow on its surface."""
        asked, contents = [], []
        for piece, (high, _) in zip(self.pieces, self.reaches):
            for there, content in ((DIAMETER, self._diameter(piece)), (FRAME, self._frame(piece))):
                if content is not None:
                    asked.append(Shelf(self._along(piece, there), high, content.wide, content.high))
                    contents.append(content)
        places = shelves(asked, self.top + 4.0, 4.0, (self.left - ROOM, self.right + ROOM), marks)
        for asked_shelf, content, (y, right) in zip(asked, contents, places):
            shelf(leaf, (asked_shelf.x, -asked_shelf.foot, asked_shelf.foot), y, right, content)

    def _along(self, piece: TurnedPiece, share: float) -> float:
        """A place in a piece, in its length from its outer end."""
        a, b = self.by * piece.start, self.by * piece.end
        return a + share * (b - a) if (a + b) / 2 < (self.left + self.right) / 2 else b - share * (b - a)

    def _diameter(self, piece: TurnedPiece) -> OnShelf | None:
        if piece.size is None:
            return None
        texture = self.say(piece.texture) if piece.texture is not None else ""
        return OnShelf(piece.size.inscribed(self.say), texture, piece.datum)

    def _frame(self, piece: TurnedPiece) -> OnShelf | None:
        zones = [
            Zone(what, self.say(sizes.alone(sizes.millimetres(wide, sizes.MOST))), datum)
            for what, wide, datum in piece.zones
        ]
        return OnShelf(frame=tuple(zones)) if zones else None

    def _lengths(self, leaf: Leaf) -> None:
        """Every piece, the distances of the supports, and the whole; what follows from the others stands in brackets,
        and deviations beside what a bearing or a gear hangs on."""
        asked = [(piece.start, piece.end, piece.functional) for piece in self.pieces]
        asked += [(a, b, True) for a, b in pairwise(self.positions)]
        if len(self.pieces) > 1:
            asked.append((self.pieces[0].start, self.pieces[-1].end, False))
        closing, inscribed = self._closing(), []
        for n, (a, b, functional) in enumerate(asked):
            functional = functional or b - a < UNTOLERANCED
            size = (
                sizes.auxiliary(b - a) if n in closing else sizes.length(b - a, general(b - a) if functional else None)
            )
            inscribed.append(size.inscribed(self.say))
        spans = [
            Span(self.by * a, self.by * b, inscribed_width(size, LETTER)) for (a, b, _), size in zip(asked, inscribed)
        ]
        for span, words, row in zip(spans, inscribed, rows(spans, LETTER)):
            y = self.low - FIRST - MARKS * self.eccentric - NEXT * row.level
            start, end = ((x, self._foot(x)) for x in (span.start, span.end))
            leaf.dimension(start, end, y, words, shift=row.shift)

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
        return -max((low for _, low in self._at(z, near=1e-9)), default=0.0)
