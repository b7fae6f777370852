# SPDX-License-Identifier: Apache-2.0
"""The contents, with links and page numbers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from ..setting.boxes import FAINT, Box, text
from ..context import Context
from ..setting.flow import Block, heading, on_paper_only
from ..paper import WIDTH
from ..setting.prose import BODY, NOTE, SECTION, one_line, run
from ..setting.tags import Tag

if TYPE_CHECKING:
    from ..setting.pen import Pen

TITLE = 122.0  # width of a section's title
NUMBER = 16.0  # of a part's page number with the space before it
PARTS = WIDTH - TITLE - 6.0 - 22.0  # of all parts


@dataclass(slots=True)
class Entry:
    """A section and its parts: the title of each with the anchor that it leads to."""

    title: str
    anchor: str
    parts: dict[str, str]


def contents_blocks(context: Context, entries: list[Entry], names: list[str]) -> list[Block]:
    """One row a section: its title, its parts with their pages, its own page.  Like parts stand below each other; everything is a link.

    `names`: the parts that there may be, in their order.
    """
    made = on_paper_only(heading(context.words["contents"], SECTION, gap=12.0, after=1.0))
    parts = {name: run(name, NOTE) for name in names if any(name in entry.parts for entry in entries)}
    share = (PARTS - sum(box.width + NUMBER for box in parts.values())) / max(len(parts), 1)
    columns: dict[str, tuple[float, Box]] = {}
    x = TITLE + 6.0
    for name, box in parts.items():
        columns[name] = x, box
        x += box.width + NUMBER + share
    rows = [_row(entry, columns) for entry in entries]
    made += [replace(b, keep=i < len(rows) - 1) for i, b in enumerate(rows)]
    return made


def _row(entry: Entry, columns: dict[str, tuple[float, Box]]) -> Block:
    tall = 12.6
    title = one_line(entry.title, BODY, TITLE)

    def draw(pen: Pen, y: float) -> None:
        base = y - 0.78 * BODY.leading
        page = text(str(pen.numbers.get(entry.anchor, "")), BODY.size)
        pen.put(title, 0.0, base)
        pen.put(page, WIDTH - page.width, base)
        for part, anchor in entry.parts.items():
            x, name = columns[part]
            number = text(str(pen.numbers.get(anchor, "")), NOTE.size, colour=NOTE.colour)
            pen.put(name, x, base)
            pen.put(number, x + name.width + 3.0, base)
            pen.link(x, base - 2.0, name.width + number.width + 4.0, 9.0, anchor, entry.title)
        pen.rule(0.0, y - tall + 0.6, WIDTH, 0.4, FAINT)
        pen.link(0.0, base - 2.5, TITLE + 2.0, 10.5, entry.anchor, entry.title)
        pen.link(WIDTH - 24.0, base - 2.5, 24.0, 10.5, entry.anchor, entry.title)

    return Block(tall, draw, tag=Tag("TOCI"))
