# SPDX-License-Identifier: Apache-2.0
"""Breaking text into rows: at spaces, and a long formula where the fewest brackets are open."""

import re
from collections.abc import Callable

from rich.cells import cell_len

PIECES = re.compile(r".+?(?:(?<=[ ])|(?<=[·/,;)+])(?=[^\s·/,;)+^])|\Z)", re.DOTALL)
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
