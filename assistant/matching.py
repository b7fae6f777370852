# SPDX-License-Identifier: Apache-2.0
"""Finding a title by words that are typed: in any order, in parts, with or without accents."""

import re
import unicodedata
from collections.abc import Sequence

START, BEGINNING, INSIDE, ELSEWHERE = (
    1.0,
    0.8,
    0.5,
    0.25,
)  # a word that begins the title, a word of it, stands in it; or in what else is known
WHOLE, EXACT = 0.1, 0.5  # more for a word that is not part of a longer one, and for a title that is nothing but the words


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
        at = _place(word, plain) if not (word.isdecimal() and len(word) == 1) or _stands(word, plain) else None
        if at is not None:
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
    """Whether a word is in a text that is not shown; a number only by itself: the 4 of four cylinders is not that of a name."""
    return re.search(rf"(?<![a-z0-9.]){word}(?![a-z0-9.])", text) is not None if word.isdecimal() else word in text


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
