# SPDX-License-Identifier: Apache-2.0
"""The report's letters, with their widths and what they can write, and the sheet of paper that they stand on.

The faces are STIX Two Text upright, bold and italic.

It is made for text with mathematics, and all its figures are equally wide.  What a face lacks comes from STIX Two Math
(arrows, relations, roots) and then from DejaVu Sans, which has the signs of the verdicts and most other scripts.  The
files in `fonts/` are unchanged copies under their own free licences, except that of STIX Two Math only the signs are
left that the text faces do not have."""

import re
import unicodedata
from functools import cache, lru_cache
from pathlib import Path

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont

FOLDER = Path(__file__).parents[1] / "fonts"
UPRIGHT, BOLD, ITALIC = "STIXTwoText", "STIXTwoText-Bold", "STIXTwoText-Italic"
FACES = (UPRIGHT, BOLD, ITALIC)
PLAIN = "DejaVuSans"  # without serifs: the letters of drawings
OTHERS = ("STIXTwoMath", PLAIN)  # in this order for what a face lacks
MISSING = "▯"  # stands where no font has a glyph
ASCENT, DESCENT = 0.76, 0.24  # of the size: what a line of text needs


@cache
def widths(face: str) -> dict[str, float]:
    """Character → advance in 1/1000 of the size.  The first call for a face loads it."""
    font = TTFont(face, FOLDER / f"{face}.ttf", shapable=False)
    pdfmetrics.registerFont(font)
    return {chr(code): advance for code, advance in font.face.charWidths.items()}


@cache
def face_of(character: str, face: str) -> str:
    """The face that a character of a text in this face is taken from; empty where none has it."""
    return next((candidate for candidate in (face, *OTHERS) if character in widths(candidate)), "")


@cache
def _advance(character: str, face: str) -> float:
    return widths(face_of(character, face))[character]


@lru_cache(maxsize=20_000)
def units(text: str, face: str) -> float:
    known = widths(face)
    return sum([known[c] if c in known else _advance(c, face) for c in text])


def width(text: str, size: float, face: str = UPRIGHT) -> float:
    """The width of a clean text in points."""
    return units(text, face) * size / 1000


@lru_cache(maxsize=20_000)
def clean(text: str) -> str:
    """The text as it can be written: composed, without control characters, and a ▯ where there is no glyph."""
    if all(map(_stays, text)):
        return text
    characters = []
    for c in unicodedata.normalize("NFC", text):
        kind = unicodedata.category(c)
        if c.isspace() or kind == "Cc":
            characters.append(" ")
        elif kind != "Cf" and face_of(c, UPRIGHT):
            characters.append(c)
        elif kind not in ("Cf", "Mn", "Me"):
            characters.append(MISSING)
    return "".join(characters)


@cache
def _stays(c: str) -> bool:
    """Whether a character is written as it is, whatever stands beside it."""
    kind = unicodedata.category(c)
    return c == " " or (face_of(c, UPRIGHT) != "" and kind[0] not in "CMZ" and unicodedata.normalize("NFC", c) == c)


def unicode_map(written: str) -> str:
    """reportlab's map from codes to letters as PDF asks for it: in blocks of at most 100, without the codes that stand
    for nothing, letters beyond U+FFFF in two halves."""
    head, _, rest = written.partition("endcodespacerange\n")
    pairs = [(code, int(letter, 16)) for code, letter in re.findall(r"^<(\w+)> <(\w+)>$", rest, re.M)]
    lines = [f"<{code}> <{chr(letter).encode('utf-16-be').hex().upper()}>" for code, letter in pairs if letter]
    blocks = [lines[n : n + 100] for n in range(0, len(lines), 100)]
    body = [line for block in blocks for line in (f"{len(block)} beginbfchar", *block, "endbfchar")]
    return "\n".join([head + "endcodespacerange", *body, rest[rest.index("endcmap") :]])


def writable(text: str) -> bool:
    """Whether every character of a text has its glyph."""
    return MISSING not in clean(text)


# --- the sheet of paper and its margins, in points (1/72 inch)

PAGE = (595.276, 841.890)  # A4: width, height
LEFT, RIGHT, TOP, BOTTOM = 57.0, 45.0, 57.0, 49.0
WIDTH = PAGE[0] - LEFT - RIGHT
HEIGHT = PAGE[1] - TOP - BOTTOM
