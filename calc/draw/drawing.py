# SPDX-License-Identifier: Apache-2.0
"""What a drawing is made of, whatever it shows: lines, arcs, areas, words and dimensions, each on a layer.

The sheet's first axis runs to the right, its second up, both in metres.  `key`: the field of the design that a
primitive shows (a key of a table stands for all its fields; several stand with spaces between them), which is lit while
it is edited; `state`: the verdict of the part that it shows, "fail", "warn" or nothing."""

import math
from collections.abc import Callable, Iterable
from functools import cached_property
from itertools import pairwise
from typing import Literal, Protocol, TypeVar, cast

from ..sheet.check import Check
from ..sheet.record import record, replace
from ..sheet.text import EMPTY, Text
from ..sheet.units import Metre, Radian

TOUCH: Metre = 1e-6  # what meets within this is taken to touch
Point = tuple[Metre, Metre]
Box = tuple[Metre, Metre, Metre, Metre]  # left, bottom, right, top
State = Literal["", "warn", "fail"]
Side = Literal["left", "centre", "right"]

# Layers of sketches that are drawn other than plain: context is faint, axes are faint chain lines, what is hidden is
# faint and dashed
OUTLINE, CONTEXT, AXIS, HIDDEN, DIMENSIONS, WORDS = "OUTLINE", "CONTEXT", "AXIS", "HIDDEN", "DIMENSIONS", "TEXT"


@record
class Polyline:
    """Straight lines from point to point; closed: back to the first; `arrow`: the last point is the tip of an arrow."""

    layer: str
    points: tuple[Point, ...]
    closed: bool = False
    key: str = ""
    state: State = ""
    arrow: bool = False


@record
class Arc:
    """A part of a circle, anticlockwise from `start` to `end`, angles from the right; a whole circle from 0 to 2π."""

    layer: str
    centre: Point
    radius: Metre
    start: Radian = 0.0
    end: Radian = 2 * math.pi
    key: str = ""
    state: State = ""


@record
class Area:
    """What is filled within closed outlines: what lies in two of them, as the hole of a ring, stays empty.  `shade`:
    how strongly."""

    layer: str
    outlines: tuple[tuple[Point, ...], ...]
    shade: float = 0.25
    key: str = ""
    state: State = ""


@record
class Words:
    """A line of text that begins at a place, has its middle there, or ends there (`side`: where the place is)."""

    layer: str
    at: Point
    text: str
    height: Metre = 0.0
    key: str = ""
    state: State = ""
    side: Side = "left"
    turned: bool = False  # a quarter to the left, to be read from the right


@record
class Hatch:
    """What is cut, in parallel lines `spacing` apart, within closed outlines; what lies in two of them is not cut."""

    layer: str
    outlines: tuple[tuple[Point, ...], ...]
    spacing: Metre


@record
class Dimension:
    """The distance of two points, to the right or (`upright`) upwards, on a line through `line`; its number is put
    aside by `shift`.

    `label`: what stands there in place of the distance in millimetres.
    """

    layer: str
    start: Point
    end: Point
    line: Point
    height: Metre = 0.0
    upright: bool = False
    diameter: bool = False
    shift: Metre = 0.0
    key: str = ""
    state: State = ""
    label: Text = EMPTY


Stroke = Polyline | Arc | Area | Words


@record
class Inscription:
    """What is written on a measure: `words` ("⌀59.5 h6"), and behind them the deviations, the upper over the lower.

    `post`: the words with <> in place of the number, which has so many `digits`; `deviations`: lower and upper, in
    millimetres, of what is written so or as ± in the words."""

    words: str
    upper: str = ""
    lower: str = ""
    post: str = "<>"
    digits: int = 2
    deviations: tuple[float, float] | None = None


@record
class Measure:
    """A size on a drawing sheet: the strokes that show it, and the points between which a CAD program measures it.

    Of a length they are both ends and a point on its line, which runs in the direction `turned`; of a radius the centre
    and a point on the arc; of an angle a point on either side, anticlockwise, the centre, and a point on its arc."""

    layer: str
    kind: Literal["length", "radius", "angle"]
    points: tuple[Point, ...]
    picture: tuple[Stroke, ...]
    inscription: Inscription
    turned: Radian = 0.0


Primitive = Polyline | Arc | Words | Dimension  # of drawings to scale
Mark = Primitive | Area  # of sketches
Ink = Stroke | Hatch | Measure  # of drawing sheets
Drawn = TypeVar("Drawn", bound=Ink | Dimension)


@record
class Sketch:
    """A picture of a few strokes.  `notes`: what is not to scale, in words ("gap × 400").  `turning`: it depends on the
    crank's angle.

    `beside`: further pictures next to it, each with its own scale, the ones that are missed least last; `title` stands
    above each. `views`: how many of them may come first, one after the other. `of_all`: it shows all of
    several shafts, so many of them one below another, for which paper has more room. `caption`: pictures with the same
    one stand on paper as a figure of their own."""

    primitives: tuple[Mark, ...] = ()
    notes: tuple[Text, ...] = ()
    turning: bool = False
    title: Text = EMPTY
    beside: tuple["Sketch", ...] = ()
    views: int = 1
    of_all: int = 0
    caption: Text = EMPTY

    @cached_property
    def box(self) -> Box:
        """What the picture spans, its words taken as points; the pictures beside it do not count."""
        return spanned(point for mark in self.primitives for point in reach(mark))


def spanned(points: Iterable[Point]) -> Box:
    """The box around points; without any, nothing at the origin."""
    xs, ys = list(zip(*points)) or [(0.0,), (0.0,)]
    return min(xs), min(ys), max(xs), max(ys)


def reach(mark: Mark | Hatch | Measure) -> Iterable[Point]:
    """Points that span a primitive."""
    match mark:
        case Polyline(points=points):
            return points
        case Arc(centre=(x, y), radius=r, start=start, end=end):
            quarters = range(math.ceil(start / (math.pi / 2)), math.floor(end / (math.pi / 2)) + 1)
            angles = (start, end, *(quarter * math.pi / 2 for quarter in quarters))
            return [(x + r * math.cos(angle), y + r * math.sin(angle)) for angle in angles]
        case Area(outlines=outlines) | Hatch(outlines=outlines):
            return [point for outline in outlines for point in outline]
        case Measure(picture=picture):
            return [point for stroke in picture for point in reach(stroke)]
        case Words(at=at):
            return (at,)
        case Dimension(start=start, end=end, line=(x, y), upright=upright):
            return [(x, start[1]), (x, end[1])] if upright else [(start[0], y), (end[0], y)]


def strokes_of(mark: Ink) -> tuple[Ink, ...]:
    """What is drawn of a mark: of a measure its strokes, else itself."""
    return mark.picture if isinstance(mark, Measure) else (mark,)


def moved(mark: Drawn, dx: Metre, dy: Metre) -> Drawn:
    """A mark at another place."""
    return cast("Drawn", _changed(mark, lambda point: (point[0] + dx, point[1] + dy), 1.0))


def enlarged(mark: Ink, by: float) -> Ink:
    """A mark so many times as large, letters and all."""
    return cast("Ink", _changed(mark, lambda point: (by * point[0], by * point[1]), by))


def _changed(mark: Ink | Dimension, to: Callable[[Point], Point], by: float) -> Ink | Dimension:
    match mark:
        case Polyline():
            return replace(mark, points=tuple(map(to, mark.points)))
        case Arc():
            return replace(mark, centre=to(mark.centre), radius=by * mark.radius)
        case Area():
            return replace(mark, outlines=tuple(tuple(map(to, outline)) for outline in mark.outlines))
        case Hatch():
            outlines = tuple(tuple(map(to, outline)) for outline in mark.outlines)
            return replace(mark, outlines=outlines, spacing=by * mark.spacing)
        case Words():
            return replace(mark, at=to(mark.at), height=by * mark.height)
        case Dimension():
            start, end, line = to(mark.start), to(mark.end), to(mark.line)
            return replace(mark, start=start, end=end, line=line, height=by * mark.height, shift=by * mark.shift)
        case Measure():
            picture = tuple(cast("Stroke", _changed(stroke, to, by)) for stroke in mark.picture)
            return replace(mark, points=tuple(map(to, mark.points)), picture=picture)


def round_outline(centre: Point, radius: Metre, corners: int = 48) -> tuple[Point, ...]:
    """The outline of a disc, for an area."""
    turns = [2 * math.pi * n / corners for n in range(corners)]
    return tuple((centre[0] + radius * math.cos(turn), centre[1] + radius * math.sin(turn)) for turn in turns)


def rectangle(left: Metre, bottom: Metre, right: Metre, top: Metre) -> tuple[Point, ...]:
    """Four corners, for a closed line or an area."""
    return (left, bottom), (right, bottom), (right, top), (left, top)


# --- the layers of a drawing sheet: line width, dashes, colour in a CAD program
# Line widths 0.5 and 0.25 mm are a line group of ISO 128-2; the frame's 0.7 mm is that of ISO 5457.  Dashes are
# millimetres on the paper, above 0 drawn and below 0 left out.

VISIBLE, EDGE, HIDDEN_EDGE, CENTRE, HATCH, DIMENSION = "VISIBLE", "EDGE", "HIDDEN", "CENTRE", "HATCH", "DIMENSION"
CUT, TEXT, TABLE, FRAME = "CUT", "TEXT", "TABLE", "FRAME"


@record
class Layer:
    """One layer.  `colour`: its number in the palette of DXF; on paper all are black."""

    width: float  # mm
    dashes: tuple[float, ...] = ()
    colour: int = 7


LAYERS = {
    VISIBLE: Layer(0.5),
    EDGE: Layer(0.25, (), 8),  # continuous and narrow: roots of teeth, hands of helices
    HIDDEN_EDGE: Layer(0.25, (3.0, -0.75), 4),
    CENTRE: Layer(0.25, (7.0, -1.0, 0.6, -1.0), 1),
    HATCH: Layer(0.25, (), 9),
    DIMENSION: Layer(0.25, (), 3),
    CUT: Layer(0.5, (), 6),  # ends of cutting planes
    TEXT: Layer(0.25),
    TABLE: Layer(0.25, (), 8),
    FRAME: Layer(0.7),
}


# --- the lines of a hatch: parallel, at 45°, and nowhere outside the outlines of what is cut

HALF = math.sqrt(0.5)


def hatch_lines(hatch: Hatch) -> list[tuple[Point, Point]]:
    """Every line from where it enters what is cut to where it leaves it; what lies in two outlines is not cut."""
    turned = [[_turned(point, -1.0) for point in outline] for outline in hatch.outlines]
    levels = [y for outline in turned for _, y in outline]
    first, last = math.ceil(min(levels) / hatch.spacing), math.floor(max(levels) / hatch.spacing)
    lines = []
    for n in range(first, last + 1):
        y = n * hatch.spacing
        ends = sorted(x for outline in turned for x in _crossings(outline, y))
        lines += [(_turned((a, y), 1.0), _turned((b, y), 1.0)) for a, b in zip(ends[::2], ends[1::2]) if b > a]
    return lines


def _turned(point: Point, sense: float) -> Point:
    """A point about the origin by 45°, anticlockwise where `sense` is above 0."""
    x, y = point
    return HALF * (x - sense * y), HALF * (sense * x + y)


def _crossings(outline: list[Point], level: float) -> list[float]:
    """Where a closed outline crosses a level."""
    return [
        ax + (bx - ax) * (level - ay) / (by - ay)
        for (ax, ay), (bx, by) in pairwise([*outline, outline[0]])
        if (ay <= level) != (by <= level)
    ]


# --- what the sketches of several steps ask for
# The verdict of a part, a round exaggeration, and the picture of what is not known yet.


class Awaited(Protocol):
    """The outcome of a step, solved or not."""

    @property
    def reason(self) -> Text: ...


def judged(checks: Iterable[Check], *ids: str) -> State:
    """The worst verdict of the checks with these ids, or whose ids go on after a dot."""
    verdicts = {c.verdict for c in checks if any(c.id == id or c.id.startswith(f"{id}.") for id in ids)}
    return "fail" if "fail" in verdicts else "warn" if "warn" in verdicts else ""


def awaited(outcome: Awaited) -> Sketch:
    """No picture yet, and what it waits for."""
    return Sketch(notes=(outcome.reason or Text("The picture waits for the results."),))


def rounded(factor: float) -> float:
    """The largest of 1, 1.5, 2, 3, 5, 7, 10, 15, … that is no more than this; as well below 1."""
    decade = 10.0 ** math.floor(math.log10(factor))
    return max((n * decade for n in (1, 1.5, 2, 3, 5, 7) if n * decade <= factor * (1 + 1e-9)), default=decade)
