# SPDX-License-Identifier: Apache-2.0
"""How a shaft comes into its seats from one of its ends: what has to pass which opening, and the room that is left."""

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from ..sheet.text import Text
from ..sheet.units import Metre
from ..sheet.value import about, based_on, untraced
from . import formulas as f
from .inputs import ShaftInputs
from .outline import Journals, Outline

SAME: Metre = 0.5e-3  # smaller at most: a journal slides through a seat of its own size, as it runs in one


class Passing(NamedTuple):
    """A piece of the shaft: the middle of its place, and its radius; a journal has its diameter too."""

    z: Metre
    radius: Metre
    journal: Metre | None = None


class Opening(NamedTuple):
    """What pieces pass: its place and least diameter; the journal that will run in it, None: the bore of a carrier."""

    z: Metre
    diameter: Metre
    journal: Metre | None = None


def room(pieces: Iterable[Passing], openings: Sequence[Opening], *, front: bool) -> Metre:
    """The least radial room on the way in from one side; infinite: nothing has to be passed.  Negative: it does not
    pass.

    From the front a piece passes all openings nearer to the front than its own place, from the rear those nearer to
    the rear."""
    least, governing = math.inf, None
    for piece in pieces:
        for opening in openings:
            ahead = opening.z < piece.z if front else opening.z > piece.z
            if ahead and not _slides(piece, opening):
                with untraced():
                    left = f.room_on_the_way(D_b=opening.diameter, R=piece.radius)
                if left < least:
                    least, governing = left, (opening, piece)
    if governing is None:
        return math.inf
    opening, piece = governing
    return f.room_on_the_way(D_b=opening.diameter, R=piece.radius)


def _slides(piece: Passing, opening: Opening) -> bool:
    if piece.journal is None or opening.journal is None:
        return False
    return piece.journal <= opening.diameter and opening.journal - piece.journal <= SAME


def rooms(
    shaft: ShaftInputs, outline: Outline | None, journals: Journals, radius: Metre | None
) -> tuple[Metre | None, Metre | None]:
    """From the front and from the rear; None: nothing has to be passed, or it is not known.

    `radius`: of the sectors where there is no outline.  The wheel is not asked: it may be fixed after."""
    openings = _openings(shaft, journals)
    if not openings or (outline is None and radius is None):
        return None, None
    pieces = _pieces(shaft, outline, journals, radius)
    found = []
    for side, words in ((True, Text("way in from the front")), (False, Text("way in from the rear"))):
        with about(words):
            left = room(pieces, openings, front=side)
        found.append(left if math.isfinite(left) else None)
    return found[0], found[1]


def way_in(shaft: ShaftInputs, front: Metre | None, rear: Metre | None) -> Metre | None:
    """Of both sides that with more room, or the one that is asked for; None: there nothing has to be passed."""
    sides = {"front": (front,), "rear": (rear,)}.get(shaft.insert_from or "", (front, rear))
    return None if None in sides else max(side for side in sides if side is not None)


def _pieces(shaft: ShaftInputs, outline: Outline | None, journals: Journals, radius: Metre | None) -> list[Passing]:
    places = shaft.bearing_positions
    pieces = [Passing(z, based_on(d / 2, d), d) for z, (d, _) in zip(places, journals)]
    if outline is None:
        assert radius is not None
        return [*pieces, Passing(0.0, radius)]
    # pieces at a bearing are its journal, a wheel may be fixed after
    between = (p for p in outline.pieces if p.what != "gear" and not any(p.start < z < p.end for z in places))
    return [*pieces, *(Passing((p.start + p.end) / 2, p.outer_radius) for p in between)]


def _openings(shaft: ShaftInputs, journals: Journals) -> list[Opening]:
    if shaft.room_asked is None:
        return []
    return [
        Opening(z, row.carrier_bore[0]) if row.carrier_bore is not None else Opening(z, row.least_opening(), d)
        for z, row, (d, _) in zip(shaft.bearing_positions, shaft.bearings, journals)
    ]
