# SPDX-License-Identifier: Apache-2.0
"""How much room letters need on a drawing sheet, so that what is written is placed before anybody knows with which letters.

The widths are those of DejaVu Sans, in which the report letters its drawings, in heights of a capital letter; those of CAD programs are
narrower.
"""

from functools import cache

from .drawing import Box, Words

BELOW = 0.33  # of the height of a capital: how far letters reach below their line
WIDE = 1.4  # of what is not in the table
GROUPS = {
    0.4: "'ijlì", 0.43: "IJ", 0.46: " ,.·", 0.49: "/:;\\|", 0.52: "-f", 0.55: "()[]t", 0.58: "!r²³", 0.67: '"', 0.7: "*_`°–", 0.73: "s",
    0.76: "?z", 0.79: "Lc", 0.82: "Fk", 0.85: "PTYovxy⌀γò", 0.88: "EaehnuèéàùΣ", 0.91: "$0123456789KSbdgpq{}µβ", 0.94: "αφ",
    0.97: "ABCRVXZΔ", 1.03: "U", 1.06: "HN", 1.09: "&DGOQØ", 1.15: "w", 1.18: "#+<=>^~±×−≤≥ω", 1.21: "M", 1.33: "%", 1.36: "m½",
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
