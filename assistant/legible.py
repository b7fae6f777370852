# SPDX-License-Identifier: Apache-2.0
"""What the screen writes, with characters that a terminal would obey written out: a name in a design file may hold any."""

import re

from rich.cells import cell_len
from rich.segment import Segment
from textual.color import Color
from textual.filter import LineFilter

from calc.sheet.visible import visible

BLANKS = re.compile(" {2,}")


class Legible(LineFilter):
    """The line stays as wide as it was: what is written out takes its room from blanks beside it, else from the line's end."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        if all(one.control or one.text.isprintable() for one in segments):
            return segments
        made, owed = [], 0
        for one in segments:
            text = one.text if one.control else visible(one.text)
            owed += cell_len(text) - cell_len(one.text)
            if owed and not one.control:
                text, owed = _shortened(text, owed)
            made.append(Segment(text, one.style, one.control))
        return Segment.adjust_line_length(made, Segment.get_line_length(segments)) if owed else made


def _shortened(text: str, owed: int) -> tuple[str, int]:
    """The text with fewer blanks where several follow each other, and how many cells are still too many."""

    def fewer(blanks: re.Match[str]) -> str:
        nonlocal owed
        taken = min(owed, len(blanks[0]) - 1)
        owed -= taken
        return blanks[0][taken:]

    return BLANKS.sub(fewer, text), owed
