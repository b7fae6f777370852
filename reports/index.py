# SPDX-License-Identifier: Apache-2.0
"""The index at the end: every value by its name, with the pages on which it stands."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .setting.flow import Block
from .paper import HEIGHT, WIDTH
from .setting.prose import NOTE, one_line
from .setting.symbols import BETWEEN, SIGN
from .setting.tags import Tag

if TYPE_CHECKING:
    from .setting.pen import Pen

COLUMNS, GUTTER = 2, 16.0
EACH = (WIDTH - (COLUMNS - 1) * GUTTER) / COLUMNS
NUMBERS = 34.0  # width for the pages of an entry
MOST = 3  # pages of an entry
ROWS = int((HEIGHT - 50.0) / NOTE.leading)  # of a page, below the heading


def index_blocks(blocks: Iterable[Block]) -> list[Block]:
    """The entries of what these blocks hold, in columns down the page."""
    found = {name for block in blocks if block.indexed for name in block.indexed.split(BETWEEN)}
    names = sorted((name for name in found if not name.startswith(SIGN)), key=lambda name: (name.casefold(), name))
    made = []
    for start in range(0, len(names), COLUMNS * ROWS):
        some = names[start : start + COLUMNS * ROWS]
        made.append(_page(some, -(-len(some) // COLUMNS)))
    return made


def _page(names: list[str], rows: int) -> Block:
    def draw(pen: Pen, y: float) -> None:
        for n, name in enumerate(names):
            with pen.tagged(Tag("P")):
                entry(pen, y, n, name)

    def entry(pen: Pen, y: float, n: int, name: str) -> None:
        x, base = n // rows * (EACH + GUTTER), y - (n % rows + 0.78) * NOTE.leading
        found = pen.places.get(name, [])
        pages = ", ".join(map(str, found[:MOST])) + (" …" if len(found) > MOST else "")
        number = one_line(pages, NOTE, NUMBERS)
        pen.put(one_line(name, NOTE, EACH - NUMBERS - 4.0), x, base)
        pen.put(number, x + EACH - number.width, base)
        if found:
            pen.link(x, base - 2.0, EACH, NOTE.leading, f"page-{found[0]}", name)

    return Block(rows * NOTE.leading, draw)
