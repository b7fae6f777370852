# SPDX-License-Identifier: Apache-2.0
"""Running text: styles, and words broken into lines; a symbol written C_1 or T_in is set with its index."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from calc.sheet.units import UNITS

from .boxes import BLACK, GREY, Box, Colour, row, text
from .fonts import BOLD, UPRIGHT, clean, units
from .fonts import width as text_width
from .typeset import symbol


@dataclass(frozen=True, slots=True, eq=False)  # the same only as itself: it is looked up for every cell
class Style:
    size: float
    leading: float
    face: str = UPRIGHT
    colour: Colour = BLACK
    plain: bool = False  # names of keys and values: an underscore in them makes no index


TITLE = Style(17.0, 21.0, BOLD)
HEADING = Style(13.0, 17.0, BOLD)
SHAFT = Style(11.7, 15.0, BOLD)  # of several, within a chapter
SECTION = Style(10.5, 13.4, BOLD)
GROUP = Style(9.0, 11.4, BOLD, (0.22, 0.22, 0.22))
BODY = Style(9.0, 11.4)
CELL = Style(9.0, 10.4)
STRONG = Style(9.0, 10.4, BOLD)
HEADER = Style(9.0, 10.2, BOLD, (0.25, 0.25, 0.25))
NOTE = Style(7.8, 9.0, UPRIGHT, GREY)
KEY = Style(7.8, 9.0, UPRIGHT, GREY, plain=True)
SOURCE = Style(7.8, 8.9, UPRIGHT, GREY)

# A symbol in running text: one or two letters, an index of at most five; `bore_mm` and `z_mm` are keys, not symbols.
INLINE = re.compile(
    r"(?<![^\W⁰¹²³⁴-⁹])(?<!\.)([^\W\d_]{1,2}_(?!(?:mm|um|deg|kg|bar|rpm|GPa)\b)[^\W_]{1,5}(?:,[^\W_]{1,5})?)(?!\w|\.\w)"
)
HOLD = "\u00a0"  # a blank at which no line ends; it is written like any other
_UNITS = "|".join(re.escape(unit) for unit in sorted(filter(None, UNITS), key=len, reverse=True))
# a number and its unit, a sign and its limit, the star of a default, the number in brackets and what it counts
BOUND = re.compile(
    rf"(?<=[\d⁰¹²³⁴-⁹]) (?=(?:{_UNITS})(?![^\W_]))|(?<=[≤≥<>]) (?=[\d−])|(?<=\S) (?=\*(?:\s|$))"
    r"|(?<=\(\d) (?=[^\W\d]+\))|(?<=\(\d\d) (?=[^\W\d]+\))"
)
SOFT = re.compile(r"(?<=[/\-–·;,_.])")


@lru_cache(maxsize=5000)
def run(words: str, style: Style) -> Box:
    """A piece of text on one line."""
    if style.plain or "_" not in words:
        return text(words, style.size, style.face, style.colour)
    parts = [p for p in INLINE.split(words) if p]
    if len(parts) == 1 and not INLINE.fullmatch(parts[0]):
        return text(words, style.size, style.face, style.colour)
    return row(
        [
            symbol(p, style.size, style.colour)
            if INLINE.fullmatch(p)
            else text(p, style.size, style.face, style.colour)
            for p in parts
        ]
    )


def lines(words: str, style: Style, width: float, most: int = 0) -> list[Box]:
    """Text broken into lines of at most this width; `most`: more lines than that end with an ellipsis."""
    cleaned = HOLD.join(map(clean, words.split(HOLD)))
    return [run(line, style) for line in broken(cleaned, style, width, most)]


@lru_cache(maxsize=5000)
def broken(words: str, style: Style, width: float, most: int = 0) -> tuple[str, ...]:
    """The text of each line.  A word wider than the line is broken after a mark in it, or anywhere."""
    limit = width + 1e-6
    plain = words.replace(HOLD, " ")
    if _set_width(plain, style) <= limit:
        return (plain.strip(),)
    broken_lines: list[str] = []
    line, x, blank = "", 0.0, _set_width(" ", style)
    for part, apart, wide in _tokens(words, style, limit):
        if line and x + blank * apart + wide > limit:
            broken_lines.append(line)
            line, x = "", 0.0
            if most and len(broken_lines) > most:
                break
        if line and apart:
            line, x = line + " ", x + blank
        line, x = line + part, x + wide
    broken_lines += [line] if line else []
    if most and len(broken_lines) > most:
        last = broken_lines[most - 1]
        while last and _set_width(last + " …", style) > limit:
            last = last[:-1]
        broken_lines = [*broken_lines[: most - 1], last.rstrip() + " …"]
    return tuple(broken_lines) or ("",)


def words_of(text: str) -> list[str]:
    """What no line is broken in, where there is room: words, and those that are bound together."""
    return [word.replace(HOLD, " ") for word in re.split(rf"[^\S{HOLD}]+", BOUND.sub(HOLD, text)) if word]


def _set_width(words: str, style: Style) -> float:
    """How wide words stand: an index is smaller than the letters that it is written with."""
    return run(words, style).width if "_" in words else units(words, style.face) * style.size / 1000


def _parted(bound: str, style: Style, limit: float) -> list[str]:
    """What is bound together, as long as lines have room for it, and be it broken after a mark before what is bound."""
    return [bound] if all(_set_width(piece, style) <= limit for piece in SOFT.split(bound)) else bound.split()


def _tokens(words: str, style: Style, limit: float) -> Iterator[tuple[str, bool, float]]:
    """What may stand on a line of its own, each with whether a blank goes before it, and its width."""
    for word in (w for bound in words_of(words) for w in _parted(bound, style, limit)):
        if (wide := _set_width(word, style)) <= limit:
            yield word, True, wide
            continue
        first = True
        for piece in SOFT.split(word):
            while piece:
                n, x = 0, 0.0
                while n < len(piece) and (x := x + text_width(piece[n], style.size, style.face)) <= limit:
                    n += 1
                n = max(n, 1)
                yield piece[:n], first, _set_width(piece[:n], style)
                first, piece = False, piece[n:]


def one_line(words: str, style: Style, width: float) -> Box:
    """Text on one line, cut with an ellipsis where it is too long."""
    return lines(words, style, width, 1)[0]
