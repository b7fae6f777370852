# SPDX-License-Identifier: Apache-2.0
"""The axes of every file that leaves the program, right-handed whichever way the engine turns, and how a number and a
date stand in it.

X is up and Z runs along the crank to the flywheel, as in a design; the origin is on the crank's axis at mid-engine.
Y is the side of a design where the engine turns clockwise seen from the front, else its opposite: in a design angles
count from up in the sense in which the crank turns, so that the axes of an anticlockwise engine are left-handed.  The
hand of a tooth is a property of the part and does not change."""

from typing import TYPE_CHECKING

from ..sheet.record import record
from ..sheet.text import Text

if TYPE_CHECKING:
    from ..design.model import Design

UNDATED = "2026-01-01"

CLOCKWISE = Text(
    "X up, Y to the side to which the top of the crank moves (clockwise seen from the front), Z along the crank to the "
    "flywheel; origin on the crank's axis at mid-engine; the crank turns about +Z"
)
ANTICLOCKWISE = Text(
    "X up, Y away from the side to which the top of the crank moves (anticlockwise seen from the front), Z along the "
    "crank to the flywheel; origin on the crank's axis at mid-engine; the crank turns about -Z"
)
ASSUMED = Text(
    "{frame}; the sense of rotation is assumed: [mounting] rotation_seen_from_front is not given", frame=CLOCKWISE
)

Vector = tuple[complex, complex, complex]


@record
class Frame:
    """The axes of the files of one design.  `turn`: about which sense of Z the crank turns, 1 (clockwise seen from the
    front) or -1; `given`: whether the design says so."""

    turn: int = 1
    given: bool = True

    @property
    def words(self) -> Text:
        if self.turn < 0:
            return ANTICLOCKWISE
        return CLOCKWISE if self.given else ASSUMED

    def place(self, up: float, side: float, along: float) -> tuple[float, float, float]:
        """A point of the design, or a vector: X, Y, Z in its unit."""
        return up, self.turn * side, along

    def vector(self, up: complex, side: complex, along: complex) -> Vector:
        """A force, or the phasor of one: its components along X, Y, Z."""
        return up, self.turn * side, along

    def moment(self, up: complex, side: complex, along: complex) -> Vector:
        """A moment, or the phasor of one, about the design's axes: about X, Y, Z.  It is an axial vector: where an axis
        is turned round, the moments about the other two change their sign."""
        return self.turn * up, side, self.turn * along

    def angle(self, angle: float) -> float:
        """An angle of the design from up, in the sense of crank rotation: about +Z."""
        return self.turn * angle

    def product(self, xy: float, yz: float, zx: float) -> tuple[float, float, float]:
        """Products of inertia: XY, YZ, ZX."""
        return self.turn * xy, self.turn * yz, zx


def frame_of(design: "Design") -> Frame:
    """The axes of a design's files: as its mounting says how it turns, else clockwise."""
    mounting = design.mounting
    if mounting is None:
        return Frame(given=False)
    return Frame(1 if mounting.rotation_seen_from_front == "clockwise" else -1)


def number(value: float) -> str:
    """The shortest text that reads back to the same double; -0 is 0."""
    return repr(float(value) + 0.0)


def date_of(design: "Design") -> str:
    """The day that stands in a file, YYYY-MM-DD: that of the design's revision, else one for all; never today, so that
    the same design is the same file."""
    document = design.control
    revised = {change.revision: change.date for change in document.changes}.get(document.revision, "")
    return revised or (document.prepared.date if document.prepared is not None else "") or UNDATED
