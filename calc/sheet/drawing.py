# SPDX-License-Identifier: Apache-2.0
"""What a drawing is made of, whatever it shows: lines, arcs, words and dimensions, each on a layer.

The sheet's first axis runs to the right, its second up, both in metres.
"""

from .record import record
from .units import Metre, Radian

Point = tuple[Metre, Metre]


@record
class Polyline:
    """Straight lines from point to point; closed: back to the first."""

    layer: str
    points: tuple[Point, ...]
    closed: bool = False


@record
class Arc:
    """A part of a circle, anticlockwise from `start` to `end`, angles from the right; a whole circle from 0 to 2π."""

    layer: str
    centre: Point
    radius: Metre
    start: Radian
    end: Radian


@record
class Words:
    """A line of text that begins at a place."""

    layer: str
    at: Point
    text: str
    height: Metre


@record
class Dimension:
    """The distance of two points, to the right or (`upright`) upwards, on a line through `line`; its number is put aside by `shift`."""

    layer: str
    start: Point
    end: Point
    line: Point
    height: Metre
    upright: bool = False
    diameter: bool = False
    shift: Metre = 0.0


Primitive = Polyline | Arc | Words | Dimension
