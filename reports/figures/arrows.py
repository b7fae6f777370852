# SPDX-License-Identifier: Apache-2.0
"""Turning vectors as arrows, tip to tail from the origin, each with a number that the legend explains."""

from __future__ import annotations

from cmath import isfinite
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Polygon
from matplotlib.transforms import IdentityTransform

from calc.sheet.step import Curve

from ..typesetting.boxes import Colour
from ..typesetting.fonts import LEFT
from ..typesetting.prose import Style, run

if TYPE_CHECKING:
    from ..typesetting.pen import Pen, Recorder

ARROW: Colour = (0.15, 0.15, 0.15)
THICK = 0.9
# an arrow that runs over another, as a shaft's against what it takes, is moved so far aside that both are seen
ASIDE = 2.6
HEAD, HALF = 5.0, 1.7  # length of a head and half its width, in points
LEAST = 0.01  # of the largest vector: a shorter one is not drawn
NUMBER = Style(7.5, 9.0)
BESIDE = 5.8  # from an arrow to the middle of its number

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Arrow:
    """One vector of a chain with cylinder 1 at its dead centre.  Vectors of the same name have the same number."""

    number: int
    name: str
    tail: complex
    tip: complex
    variant: str


def arrows(curve: Curve) -> list[Arrow]:
    """The arrows of a locus; a vector that several variants have in common stands there once."""
    if not curve.equal:
        return []
    lengths = [abs(p) for chain in curve.turning for p in chain.phasors if isfinite(p)]
    least = LEAST * max(lengths, default=0.0)
    numbers: dict[str, int] = {}
    by_vector: dict[tuple[str, complex, complex], Arrow] = {}
    for chain in curve.turning:
        points = chain.at(0.0)
        for name, tail, tip in zip(chain.names, points, points[1:]):
            if isfinite(tail) and isfinite(tip) and abs(tip - tail) > 0.0 and abs(tip - tail) >= least:
                number = numbers.setdefault(name, len(numbers) + 1)
                by_vector.setdefault((name, tail, tip), Arrow(number, name, tail, tip, chain.variant))
    return list(by_vector.values())


def head(tail: Point, tip: Point) -> tuple[Point, list[Point]]:
    """Where the shaft of an arrow ends, and the corners of its head, in points."""
    dx, dy = tip[0] - tail[0], tip[1] - tail[1]
    length = max((dx * dx + dy * dy) ** 0.5, 1e-6)
    ux, uy = dx / length, dy / length
    long = min(HEAD, 0.7 * length)
    wide = HALF * long / HEAD
    x, y = tip[0] - long * ux, tip[1] - long * uy
    return (x, y), [tip, (x - wide * uy, y + wide * ux), (x + wide * uy, y - wide * ux)]


def draw_arrows(frame: Recorder, axes: Any, drawn: list[Arrow], colours: dict[str, Colour]) -> None:
    """Add the arrows to axes whose limits are settled, and put their numbers beside them."""
    ends: list[tuple[Point, Point]] = []
    for arrow in drawn:
        ends.append(_aside(_place(axes, arrow.tail), _place(axes, arrow.tip), ends))
    taken: list[Point] = []
    for arrow, (tail, tip) in zip(drawn, ends):
        colour = colours.get(arrow.variant, ARROW)
        neck, corners = head(tail, tip)
        axes.plot(
            *zip(tail, neck), color=colour, lw=THICK, transform=IdentityTransform(), zorder=3, solid_capstyle="butt"
        )
        axes.add_patch(
            Polygon(corners, facecolor=colour, edgecolor="none", lw=0, transform=IdentityTransform(), zorder=3)
        )
        box = run(str(arrow.number), NUMBER)
        a, b = _free(tail, tip, ends, taken, axes.bbox)
        taken.append((a, b))
        frame.put(box, a - box.width / 2, b - 0.36 * NUMBER.size)


def _place(axes: Any, vector: complex) -> Point:
    """Where a vector ends in the figure, in points: real up, imaginary to the right."""
    x, y = axes.transData.transform((vector.imag, vector.real))
    return float(x), float(y)


def _aside(tail: Point, tip: Point, ends: list[tuple[Point, Point]]) -> tuple[Point, Point]:
    """The ends of an arrow, moved sideways until its middle lies on none of those before it."""
    dx, dy = tip[0] - tail[0], tip[1] - tail[1]
    length = max((dx * dx + dy * dy) ** 0.5, 1e-6)
    x, y = -ASIDE * dy / length, ASIDE * dx / length
    for _ in ends:
        if all(_distance(((tail[0] + tip[0]) / 2, (tail[1] + tip[1]) / 2), *end) > 0.5 * ASIDE for end in ends):
            break
        tail, tip = (tail[0] + x, tail[1] + y), (tip[0] + x, tip[1] + y)
    return tail, tip


def _free(tail: Point, tip: Point, ends: list[tuple[Point, Point]], taken: list[Point], frame: Any) -> Point:
    """The place beside an arrow that has the most room for its number."""
    dx, dy = tip[0] - tail[0], tip[1] - tail[1]
    length = (dx * dx + dy * dy) ** 0.5
    best, least = tail, float("inf")
    for share in (0.5, 0.35, 0.65, 0.2, 0.8, 1.0):
        for side in (BESIDE, -BESIDE, 2 * BESIDE, -2 * BESIDE):
            a = tail[0] + share * dx - side * dy / length
            b = tail[1] + share * dy + side * dx / length
            crowded = sum(4.0 for p, q in taken if abs(a - p) < 6.0 and abs(b - q) < 6.5)
            crowded += sum(_distance((a, b), *end) < 0.8 * BESIDE for end in ends)
            crowded += 0.0 if frame.x0 + 3 < a < frame.x1 - 3 and frame.y0 + 4 < b < frame.y1 - 4 else 8.0
            if crowded < least:
                best, least = (a, b), crowded
    return best


def _distance(point: Point, tail: Point, tip: Point) -> float:
    dx, dy = tip[0] - tail[0], tip[1] - tail[1]
    along = ((point[0] - tail[0]) * dx + (point[1] - tail[1]) * dy) / max(dx * dx + dy * dy, 1e-12)
    share = min(1.0, max(0.0, along))
    return float(((point[0] - tail[0] - share * dx) ** 2 + (point[1] - tail[1] - share * dy) ** 2) ** 0.5)


def sample_arrow(pen: Pen, x: float, y: float, width: float) -> None:
    """An arrow for the legend; x from the left margin."""
    tail, tip = (LEFT + x, y), (LEFT + x + width, y)
    neck, corners = head(tail, tip)
    pen.line([tail, neck], THICK, ARROW)
    pen.area(corners, ARROW)
