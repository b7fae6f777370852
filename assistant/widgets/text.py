# SPDX-License-Identifier: Apache-2.0
"""Text in character cells: broken into rows, found by words that are typed, and a value as a bar.

Rows break at spaces, a long formula where the fewest brackets are open."""

import math
import re
import unicodedata
from collections.abc import Callable, Sequence

from rich.cells import cell_len
from textual.content import Content

from .signs import Signs

# at spaces and behind signs, but not within 3.2/4.5, mm/s or 3,2
PIECES = re.compile(r".+?(?:(?<=[ ])|(?<=[·/,;)+–])(?!(?<=\w/)\w{1,3}\b|(?<=\d,)\d)(?=[^\s·/,;)+^])|\Z)", re.DOTALL)
LOOSE = 0.4  # the share of a row that may stay empty for the sake of a better break


def wrap(text: str, width: int, indent: int = 0) -> list[str]:
    """Rows of at most `width` cells; all but the first begin with `indent` spaces."""
    size = cell_len(text)
    if size <= width:
        return [text]
    cells: Callable[[str], int] = len if size == len(text) else cell_len  # most texts have no wide letters
    rows: list[str] = []
    pieces, lead = PIECES.findall(text), ""
    while pieces:
        room = max(1, width - len(lead))
        count = _fitting(pieces, room, cells)
        if count == 0:
            rows.append(lead + pieces[0][:room])
            pieces[0] = pieces[0][room:]
        else:
            rows.append((lead + "".join(pieces[:count])).rstrip())
            pieces = pieces[count:]
            if pieces and not pieces[0].strip():
                pieces.pop(0)
        lead = " " * indent
    return rows or [""]


def _fitting(pieces: list[str], room: int, cells: Callable[[str], int]) -> int:
    """How many pieces go into a row: all, or those up to the break that opens the fewest brackets."""
    taken, depth, best, least = 0, 0, 0, 1000
    for n, piece in enumerate(pieces, 1):
        if taken + cells(piece.rstrip()) > room:
            return best
        taken += cells(piece)
        depth += piece.count("(") - piece.count(")")
        if depth <= least or taken < room * (1 - LOOSE):
            best, least = n, depth
    return len(pieces)


def fit(text: str, width: int, more: str = "…") -> str:
    """The text cut to a width, with a sign where something is missing."""
    if cell_len(text) <= width:
        return text
    while text and cell_len(text) + cell_len(more) > width:
        text = text[:-1]
    return text.rstrip() + more


def pad(text: str, width: int) -> str:
    """The text, cut or filled to exactly this width."""
    text = fit(text, width)
    return text + " " * (width - cell_len(text))


# --- finding a title by words that are typed
# In any order, in parts, with or without accents.

# a word that begins the title, a word of it, stands in it; or in what else is known
START, BEGINNING, INSIDE, ELSEWHERE = (1.0, 0.8, 0.5, 0.25)
# more for a word that is not part of a longer one, and for a title that is nothing but the words
WHOLE, EXACT = (0.1, 0.5)


def folded(text: str) -> str:
    """The text as it is compared: small letters without accents, each in the place of its own."""
    return "".join((unicodedata.normalize("NFKD", letter)[:1] or letter).lower()[:1] for letter in text)


def match(words: Sequence[str], title: str, *others: str) -> tuple[float, list[tuple[int, int]]]:
    """How well folded words find a title, 0 where one of them stands nowhere; and where they stand in it.

    `others`: folded texts that find it too: its key, its name in another language.
    """
    plain = folded(title)
    total, spans = 0.0, []
    for word in words:
        at = _place(word, plain) if len(word) > 1 or word.isalpha() or _stands(word, plain) else None
        if at is not None and (len(word) > 1 or at == 0 or not plain[at - 1].isalnum()):
            total += START if at == 0 else BEGINNING if not plain[at - 1].isalnum() else INSIDE
            total += WHOLE if not _goes_on(plain, at + len(word)) else 0.0
            spans.append((at, at + len(word)))
        elif any(_stands(word, other) for other in others):
            total += ELSEWHERE
        else:
            return 0.0, []
    exact = EXACT if plain == " ".join(words) else 0.0
    return (total / len(words) if words else ELSEWHERE) + exact - min(len(title), 200) * 1e-4, spans


def _stands(word: str, text: str) -> bool:
    """Whether a word is in a text that is not shown; a number or a letter only by itself: the 4 of four cylinders is
    not that of a name."""
    if word.isdecimal() or (len(word) == 1 and word.isalpha()):
        return re.search(rf"(?<![a-z0-9.]){word}(?![a-z0-9.])", text) is not None
    return word in text


def _goes_on(text: str, at: int) -> bool:
    return text[at : at + 1].isalnum() or text[at : at + 1] == "_"


def _place(word: str, text: str) -> int | None:
    """Where a word stands in a text, at the beginning of another if it can be had."""
    first, at = None, text.find(word)
    while at >= 0:
        if at == 0 or not text[at - 1].isalnum():
            return at
        first = at if first is None else first
        at = text.find(word, at + 1)
    return first


# --- a value held against its limits, on a line of a few cells
# What is allowed is drawn heavy, so that the side is seen on which it is right: `╌╌╌╌●┃━━` is too little.

CELLS = 8
ROOM = 1.5  # the length of the line, over a limit that the value keeps


def bar(value: float, low: float | None, high: float | None, signs: Signs, style: str = "") -> Content:
    """`low`, `high`: the least and the greatest that is allowed, None where there is none.  Where there is one the line
    goes from nought beyond it, and the value has its sign; else it reaches beyond both.  What lies beyond the line,
    however far, stands in its outermost cell."""
    right, wrong, mark, here = ("=", ".", "|", "o") if signs.ascii else ("━", "╌", "┃", "●")
    if low is not None and high is not None:
        first, last = 1, CELLS - 2
        share = (value - low) / (high - low) if high > low else 0.0
        at = 0 if share < 0 else CELLS - 1 if share > 1 else first + 1 + round(share * (last - first - 2))
    else:
        if (low or high or 0.0) < 0:  # more of it lies to the left
            return bar(-value, None if high is None else -high, None if low is None else -low, signs, style)
        limit = (low if high is None else high) or 0.0
        end = max(value if math.isfinite(value) else 0.0, limit * ROOM) or 1.0
        edge = min(CELLS - 2, max(1, int(CELLS * limit / end)))
        first, last = (-1, edge) if low is None else (edge, CELLS)
        at = min(CELLS - 1, int(CELLS * min(1.0, max(0.0, value / end))))
        above = value > limit or (value == limit and high is None)
        at = max(edge + 1, at) if above else min(edge - 1, at)
    parts: list[Content | tuple[str, str] | str] = []
    for cell in range(CELLS):
        if cell == at:
            parts.append((here, style))
        elif cell in (first, last):
            parts.append((mark, "bold"))
        else:
            parts.append(right if first < cell < last else (wrong, "dim"))
    return Content.assemble(*parts)
