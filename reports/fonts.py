# SPDX-License-Identifier: Apache-2.0
"""The report's letters: DejaVu Sans upright, bold and oblique, with their widths and what they can write.

DejaVu has Greek, mathematics, arrows, super- and subscripts, and the signs of the verdicts in one design; the files in
`fonts/` are unchanged copies under their own free licence.
"""

import unicodedata
from functools import cache, lru_cache
from pathlib import Path

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont

FOLDER = Path(__file__).parent / "fonts"
UPRIGHT, BOLD, OBLIQUE = "DejaVuSans", "DejaVuSans-Bold", "DejaVuSans-Oblique"
FACES = (UPRIGHT, BOLD, OBLIQUE)
MISSING = "▯"  # stands where the font has no glyph
ASCENT, DESCENT = 0.76, 0.24  # of the size: what a line of text needs


@cache
def widths(face: str) -> dict[str, float]:
    """Character → advance in 1/1000 of the size.  The first call for a face loads it."""
    font = TTFont(face, FOLDER / f"{face}.ttf", shapable=False)
    pdfmetrics.registerFont(font)
    return {chr(code): advance for code, advance in font.face.charWidths.items()}


@lru_cache(maxsize=20_000)
def units(text: str, face: str) -> float:
    return sum(map(widths(face).__getitem__, text))


def width(text: str, size: float, face: str = UPRIGHT) -> float:
    """The width of a clean text in points."""
    return units(text, face) * size / 1000


@lru_cache(maxsize=20_000)
def clean(text: str) -> str:
    """The text as it can be written: composed, without control characters, and a ▯ where there is no glyph."""
    if all(map(_stays, text)):
        return text
    known = widths(UPRIGHT)
    made = []
    for c in unicodedata.normalize("NFC", text):
        kind = unicodedata.category(c)
        if c.isspace() or kind == "Cc":
            made.append(" ")
        elif c in known and kind != "Cf":
            made.append(c)
        elif kind not in ("Cf", "Mn", "Me"):
            made.append(MISSING)
    return "".join(made)


@cache
def _stays(c: str) -> bool:
    """Whether a character is written as it is, whatever stands beside it."""
    kind = unicodedata.category(c)
    return c == " " or (c in widths(UPRIGHT) and kind[0] not in "CMZ" and unicodedata.normalize("NFC", c) == c)


def writable(text: str) -> bool:
    """Whether every character of a text has its glyph."""
    return MISSING not in clean(text)


def all_in(text: str, face: str) -> bool:
    return widths(face).keys() >= set(text)
