# SPDX-License-Identifier: Apache-2.0
"""Where two pieces of a shaft meet: the parts of the line between them that are seen, where one of them steps back behind the other."""

import math
from itertools import pairwise

from ..draw.shaft_outline import FLAT
from ..sheet.units import Metre, Radian
from .facts import Turned

SAME = 1e-7  # m: surfaces closer than this go on into one another


def shoulders(one: Turned, other: Turned, up: Radian) -> list[tuple[Metre, Metre]]:
    """The heights between which their surfaces do not go on into one another, on the side of who looks."""
    heights = sorted({*_corners(one, up), *_corners(other, up)})
    made: list[tuple[Metre, Metre]] = []
    for a, b in pairwise(heights):
        near, far = _depth(one, (a + b) / 2, up), _depth(other, (a + b) / 2, up)
        if b - a < SAME or near == far or abs(near - far) < SAME:  # equal as well where neither reaches so high
            continue
        if made and a - made[-1][1] < SAME:
            a = made.pop()[0]
        made.append((a, b))
    return made


def _faces(piece: Turned, up: Radian) -> tuple[Radian, ...]:
    """The directions of a sector's two flat faces; of a full cylinder, and of a whole ring, none."""
    half = piece.piece.half_angle
    if half is None or math.pi - half < FLAT:
        return ()
    return piece.piece.angle - up - half, piece.piece.angle - up + half


def _corners(piece: Turned, up: Radian) -> list[Metre]:
    """The heights at which its surface changes from one shape to the next."""
    R, r, faces = piece.radius, piece.piece.core_radius, _faces(piece, up)
    return [R, -R, *((r, -r) if faces else ()), *(radius * math.cos(face) for face in faces for radius in (R, r)), 0.0]


def _depth(piece: Turned, y: Metre, up: Radian) -> Metre:
    """How near its surface comes to who looks, counted from the axis, at a height; far behind where it does not reach so high."""
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
