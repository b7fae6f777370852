# SPDX-License-Identifier: Apache-2.0
"""How much room letters need on a drawing sheet, and dimensions in strokes.

So what is written is placed before anybody knows with which letters.

The widths are those of DejaVu Sans, in which the report letters its drawings, in heights of a capital letter; those of
CAD programs are narrower."""

from functools import cache

from ..sheet.units import UNITS, Metre
from .drawing import DIMENSION, Area, Box, Dimension, Inscription, Point, Polyline, Stroke, Words

BELOW = 0.33  # of the height of a capital: how far letters reach below their line
WIDE = 1.4  # of what is not in the table
GROUPS = {
    0.4: "'ijlì", 0.43: "IJ", 0.46: " ,.·", 0.49: "/:;\\|", 0.52: "-f", 0.55: "()[]t", 0.58: "!r²³", 0.67: '"',
    0.7: "*_`°–", 0.73: "s",
    0.76: "?z", 0.79: "Lc", 0.82: "Fk", 0.85: "PTYovxy⌀γò", 0.88: "EaehnuèéàùΣ", 0.91: "$0123456789KSbdgpq{}µβ",
    0.94: "αφ",
    0.97: "ABCRVXZΔ", 1.03: "U", 1.06: "HN", 1.09: "&DGOQØ", 1.15: "w", 1.18: "#+<=>^~±×−≤≥ω", 1.21: "M", 1.33: "%",
    1.36: "m½",
    1.39: "@W…",
}  # fmt: skip


@cache
def _widths() -> dict[str, float]:
    return {letter: wide for wide, letters in GROUPS.items() for letter in letters}


def width(text: str, height: float) -> float:
    """The width of a text whose capitals are `height` high."""
    known = _widths()
    return height * sum(known.get(letter, WIDE) for letter in text)


def room(words: Words) -> Box:
    """The box that a text takes of the sheet."""
    long, (x, y), h = width(words.text, words.height), words.at, words.height
    back = {"left": 0.0, "centre": long / 2, "right": long}[words.side]
    if words.turned:
        return x - h, y - back, x + BELOW * h, y - back + long
    return x - back, y - BELOW * h, x - back + long, y + h


def shortened(text: str, height: float, most: float) -> str:
    """A text cut with an ellipsis where it is longer than it may be."""
    if width(text, height) <= most:
        return text
    while text and width(text + "…", height) > most:
        text = text[:-1]
    return text.rstrip() + "…"


def wrapped(text: str, height: float, most: float) -> list[str]:
    """A text in lines that are no longer than they may be; a word that is, is cut."""
    lines: list[str] = []
    line = ""
    for word in text.split():
        if line and width(f"{line} {word}", height) > most:
            lines.append(line)
            line = ""
        line = f"{line} {word}" if line else shortened(word, height, most)
    return [*lines, line] if line else lines


# --- a dimension in strokes, as ISO 129-1 has it
# Two extension lines, the dimension line with its arrows, and the number above it.

ARROW = 1.2  # all in heights of a letter: length of an arrow,
HALF_ARROW = 0.16  # half of its width,
OFF = 0.4  # between what is drawn and an extension line, and between the dimension line and its number,
BEYOND = 0.8  # how far an extension line goes on,
TAIL = 2.0  # and the dimension line beside arrows that stand outside, in arrows
TIGHT = 2.2  # arrows: in less they stand outside


def strokes(dimension: Dimension, inscription: Inscription | None = None) -> tuple[Stroke, ...]:
    """What is drawn of a dimension, number and arrows included; `inscription`: what stands there in place of its own
    words."""
    h, n = dimension.height, 1 if dimension.upright else 0
    first, last = sorted((dimension.start, dimension.end), key=lambda point: point[n])
    a, b, level = first[n], last[n], dimension.line[1 - n]
    inscribed = inscription or Inscription(written(dimension))
    middle, half = (a + b) / 2 + dimension.shift, inscribed_width(inscribed, h) / 2
    tail = TAIL * ARROW * h if outside(b - a, h) else 0.0
    left, right = a, b
    if dimension.shift or tail:
        left, right = min(a - tail, middle - half), max(b + tail, middle + half)
    way = -1.0 if tail else 1.0
    marks: list[Stroke] = []
    for point in (first, last):
        start, sign = point[1 - n], 1.0 if level > point[1 - n] else -1.0
        if abs(level - start) > OFF * h:
            ends = start + sign * OFF * h, level + sign * BEYOND * h
            marks.append(Polyline(DIMENSION, (_at(point[n], ends[0], n), _at(point[n], ends[1], n))))
    marks += [Polyline(DIMENSION, (_at(left, level, n), _at(right, level, n)))]
    marks += [arrow(_at(a, level, n), _at(-way, 0.0, n), h), arrow(_at(b, level, n), _at(way, 0.0, n), h)]
    above = level - OFF * h if dimension.upright else level + OFF * h
    return (*marks, *inscribed_words(inscribed, _at(middle - half, above, n), h, turned=dimension.upright))


# --- a size and its deviations: the lower on the line of the size, the upper above it, in letters of the same height

STACK = 1.5  # from the line of the lower deviation to that of the upper one
APART = 0.5  # from the size to its deviations


def inscribed_width(inscription: Inscription, height: float) -> float:
    deviations = max(_deviation_width(text, height) for text in (inscription.upper, inscription.lower))
    return width(inscription.words, height) + (APART * height + deviations if deviations else 0.0)


def inscribed_height(inscription: Inscription, height: float) -> float:
    return height + STACK * height * bool(inscription.upper)


def inscribed_words(inscription: Inscription, at: Point, height: float, *, turned: bool = False) -> tuple[Words, ...]:
    """The size from a place on, its deviations behind it."""
    n = 1 if turned else 0
    words = [Words(DIMENSION, at, inscription.words, height, turned=turned)]
    along, across = at[n] + width(inscription.words, height) + APART * height, at[1 - n]
    up = -STACK * height if turned else STACK * height
    for text, level in ((inscription.upper, across + up), (inscription.lower, across)):
        if text:
            words.append(Words(DIMENSION, _at(along + _sign(text, height), level, n), text, height, turned=turned))
    return tuple(words)


def _deviation_width(text: str, height: float) -> float:
    return _sign(text, height) + width(text, height) if text else 0.0


def _sign(text: str, height: float) -> float:
    """The room that a 0, which has no sign, leaves for one: digits stand under digits."""
    return width("−", height) if text == "0" else 0.0


def outside(length: Metre, height: Metre) -> bool:
    """Whether the arrows stand outside what they measure, as it has no room for them."""
    return length < TIGHT * ARROW * height


def written(dimension: Dimension) -> str:
    """The number that stands on a dimension: its label, else the distance."""
    if dimension.label:
        return dimension.label
    n = 1 if dimension.upright else 0
    length = UNITS["mm"].shown(abs(dimension.end[n] - dimension.start[n]))
    return f"{'⌀' if dimension.diameter else ''}{round(length, 2):g}"


def arrow(tip: Point, direction: Point, height: Metre) -> Area:
    """A filled arrow that ends in `tip`; `direction` is of length 1."""
    (x, y), (u, v) = tip, direction
    back, half = ARROW * height, HALF_ARROW * height
    wings = [(x - back * u - side * v, y - back * v + side * u) for side in (half, -half)]
    return Area(DIMENSION, ((tip, *wings),), 1.0)


def _at(along: float, across: float, n: int) -> Point:
    return (along, across) if n == 0 else (across, along)
