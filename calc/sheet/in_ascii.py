# SPDX-License-Identifier: Apache-2.0
"""Text in the letters of ASCII, for terminals and encodings that have no others: a number keeps its sign, a unit its
prefix, a symbol its name.

3 µm is 3 um, 40 °C is 40 degC, N·m is N*m, mm² is mm^2, x₀ is x_0, η is eta, ≥ is >=, → is ->."""

import re
import unicodedata
from functools import cache

SIGNS = {
    "−": "-", "–": "-", "—": "-", "─": "-", "━": "-", "│": "|", "┃": "|", "…": "...", "×": "x", "⋅": "*", "±": "+-",
    "∓": "-+", "≥": ">=", "≤": "<=", "≠": "!=", "→": "->", "←": "<-", "↑": "up", "↓": "down", "↔": "<->", "⇄": "<->",
    "µ": "u", "°": "deg", "Ø": "dia ", "⌀": "dia ", "‰": "per mille", "∞": "inf", "√": "sqrt", "∛": "cbrt",
    "∫": "int", "∬": "int", "∮": "int", "∂": "d", "∝": "~", "∥": "||", "∠": " at", "∑": "Sum", "“": '"', "”": '"',
    "‘": "'", "’": "'", "€": "EUR", "•": "*", "●": "*", "▸": ">", "◂": "<", "◀": "<", "▼": "v", "▾": "v", "ℰ": "E",
    "✓": "+", "✗": "x", "▲": "!", "◌": "o", "○": "o", "◇": "o", "◆": "#", "ø": "o", "ß": "ss", "æ": "ae", "Æ": "AE",
    "⌈": "[", "⌉": "]", "⌊": "[", "⌋": "]", "⊣": "-|", "ᵀ": "^T", "ˢ": "^s",
    "½": "1/2", "¼": "1/4", "⅔": "2/3", "′": "'",
}  # fmt: skip
BEYOND = re.compile(r"[^\x00-\x7f]+")
BETWEEN = re.compile(r"(?<=\w)·(?=\w)")  # a product; elsewhere the point parts two phrases
RAISED, LOWERED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ᐟ", "₀₁₂₃₄₅₆₇₈₉"
PLAIN_RAISED = str.maketrans(RAISED, "0123456789+-()/")
POWER, INDEX = re.compile(f"[{RAISED}]+"), re.compile(f"[{LOWERED}]+")


def in_ascii(text: str) -> str:
    """The text without a letter beyond 127.  What has neither a name nor a plain letter is a question mark."""
    if text.isascii():
        return str(text)
    text = BETWEEN.sub("*", text)
    text = POWER.sub(lambda power: f"^{power[0].translate(PLAIN_RAISED)}", text)
    text = INDEX.sub(lambda index: f"_{unicodedata.normalize('NFKD', index[0])}", text)
    return BEYOND.sub(lambda letters: "".join(map(_letter, letters[0])), text)


@cache
def _letter(letter: str) -> str:
    if letter in SIGNS:
        return SIGNS[letter]
    if letter == "·":
        return "-"
    words = unicodedata.name(letter, "").split()
    if words[:1] == ["GREEK"] and "LETTER" in words:
        name = words[words.index("LETTER") + 1].lower()
        return (name.title() if "CAPITAL" in words else name).replace("lamda", "lambda").replace("Lamda", "Lambda")
    plain = "".join(part for part in unicodedata.normalize("NFKD", letter) if not unicodedata.combining(part))
    if plain.isascii():
        return plain
    return _letter(plain) if plain != letter and len(plain) == 1 else "?"
