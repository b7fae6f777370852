# SPDX-License-Identifier: Apache-2.0
"""Boxes: what is set on paper, with its extent and its marks, before it has a place on a page; and symbols as boxes.

A mark is a tuple, positions relative to the box's left end on its base line, y upwards:

    ("text", x, y, text, face, size, colour, stretch, hidden)   stretch: height over size, for tall brackets
    ("rule", x, y, width, height, colour)                       a filled rectangle
    ("path", points, line width, colour)                        an open polygon
    ("link", x, y, width, height, destination, words)"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from .fonts import ASCENT, DESCENT, UPRIGHT, clean
from .fonts import width as text_width

Mark = tuple[Any, ...]
Colour = tuple[float, float, float]

BLACK: Colour = (0.0, 0.0, 0.0)
GREY: Colour = (0.27, 0.27, 0.27)
FAINT: Colour = (0.80, 0.80, 0.80)
# points added to what a page is written with: a place that lies on the half of a hundredth, by the way a page is laid
# out, is else rounded up or down by the last of its sixteen digits, which depend on processor and libraries
EDGE = 1e-6


@dataclass(frozen=True, slots=True)
class Box:
    """Something set: its width, what it needs above and below its base line, and its marks."""

    width: float
    up: float
    down: float
    marks: tuple[Mark, ...] = ()

    @property
    def height(self) -> float:
        return self.up + self.down


EMPTY = Box(0.0, 0.0, 0.0)


def moved(marks: tuple[Mark, ...], dx: float, dy: float) -> list[Mark]:
    shifted: list[Mark] = []
    for m in marks:
        if m[0] == "path":
            shifted.append(("path", tuple((x + dx, y + dy) for x, y in m[1]), *m[2:]))
        else:
            shifted.append((m[0], m[1] + dx, m[2] + dy, *m[3:]))
    return shifted


def scaled(box: Box, by: float) -> Box:
    """The same box, smaller: the last resort for what can not be broken."""
    marks: list[Mark] = []
    for m in box.marks:
        match m[0]:
            case "text":
                marks.append(("text", m[1] * by, m[2] * by, m[3], m[4], m[5] * by, *m[6:]))
            case "path":
                marks.append(("path", tuple((x * by, y * by) for x, y in m[1]), m[2] * by, m[3]))
            case _:
                marks.append((m[0], *(v * by for v in m[1:5]), *m[5:]))
    return Box(box.width * by, box.up * by, box.down * by, tuple(marks))


@lru_cache(maxsize=20_000)
def text(words: str, size: float, face: str = UPRIGHT, colour: Colour = BLACK) -> Box:
    """One run of text."""
    words = clean(words)
    mark = ("text", 0.0, 0.0, words, face, size, colour, 1.0, False)
    return Box(text_width(words, size, face), ASCENT * size, DESCENT * size, (mark,))


def space(width: float) -> Box:
    return Box(width, 0.0, 0.0)


def row(boxes: list[Box], gap: float = 0.0) -> Box:
    """Boxes side by side on one base line."""
    if len(boxes) == 1:
        return boxes[0]
    x, up, down = 0.0, 0.0, 0.0
    marks: list[Mark] = []
    for box in boxes:
        marks += moved(box.marks, x, 0.0) if x else box.marks
        x += box.width + gap
        up, down = max(up, box.up), max(down, box.down)
    return Box(max(0.0, x - gap) if boxes else 0.0, up, down, tuple(marks))


def raised(box: Box, by: float) -> Box:
    """A box lifted from the base line (lowered where `by` is negative)."""
    return Box(box.width, box.up + by, box.down - by, tuple(moved(box.marks, 0.0, by)))


def stretched(sign: str, size: float, up: float, down: float) -> Box:
    """A bracket or bar as tall as what it encloses: the letter itself where that is enough, else drawn out in
    height."""
    letter = text(sign, size)
    if up <= 0.82 * size and down <= 0.26 * size:
        return letter
    # In this design brackets and the bar reach from −0.19 (bar: −0.22) to 0.73 (bar: 0.71) of the size.
    low, high = (0.22, 0.71) if sign == "|" else (0.19, 0.73)
    by = (up + down + 0.06 * size) / ((low + high) * size)
    wide = letter.width
    mark = ("text", 0.0, -down - 0.03 * size + low * size * by, sign, UPRIGHT, size, BLACK, by, False)
    return Box(wide, up + 0.04 * size, down + 0.04 * size, (mark,))


def radical(inside: Box, size: float) -> Box:
    """A root: drawn as one line, with the letter √ unseen under it so that the text can be copied."""
    thin = 0.055 * size
    top = inside.up + 0.10 * size
    low = -max(inside.down, 0.12 * size)
    arm = 0.52 * size
    high = top - low
    points = (
        (0.02 * size, low + 0.42 * high),
        (0.14 * size, low + 0.50 * high),
        (0.30 * size, low),
        (arm, top),
        (arm + 0.06 * size + inside.width, top),
    )
    letter = ("text", 0.0, 0.0, "√", UPRIGHT, size, BLACK, 1.0, True)
    body = moved(inside.marks, arm + 0.04 * size, 0.0)
    return Box(
        arm + 0.08 * size + inside.width, top + 0.04 * size, -low, (letter, ("path", points, thin, BLACK), *body)
    )


def fraction(over: Box, under: Box, size: float) -> Box:
    """One box over another with a bar between them, on the mathematical axis."""
    thin, axis = 0.05 * size, 0.26 * size
    above, below, pad = 0.08 * size, 0.20 * size, 0.10 * size  # letters leave more room below than above
    wide = max(over.width, under.width) + 2 * pad
    rise = axis + above + max(over.down, 0.16 * size)
    fall = below + max(under.up, 0.60 * size) - axis
    marks = (
        *moved(over.marks, (wide - over.width) / 2, rise),
        ("rule", 0.04 * size, axis - thin / 2, wide - 0.08 * size, thin, BLACK),
        *moved(under.marks, (wide - under.width) / 2, -fall),
    )
    return Box(wide, rise + over.up, fall + under.down, marks)


# --- a symbol of a chapter, and the name under which its pages are found among all that is indexed

SIGN = "§"  # what the name of a symbol begins with; no value is called so
BETWEEN = "\n"  # several names of one block


@dataclass(frozen=True, slots=True)
class Symbol:
    """What a symbol stands for in a chapter."""

    chapter: str  # key of the step
    name: str
    meaning: str
    unit: str

    @property
    def indexed(self) -> str:
        return f"{SIGN}{self.chapter}{SIGN}{self.name}{SIGN}{self.meaning}"
