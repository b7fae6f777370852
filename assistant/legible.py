# SPDX-License-Identifier: Apache-2.0
"""What the screen writes, without characters that a terminal would obey: a name in a design file may hold any."""

import unicodedata
from functools import lru_cache

from rich.segment import Segment
from textual.color import Color
from textual.filter import LineFilter


class Legible(LineFilter):
    """Takes out control characters, and those that turn the direction of the text; none of them has a width."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        return [one if one.control or one.text.isprintable() else Segment(legible(one.text), one.style) for one in segments]


@lru_cache(4096)
def legible(text: str) -> str:
    return "".join(letter for letter in text if letter.isprintable() or unicodedata.category(letter) == "Zs")
