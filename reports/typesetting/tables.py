# SPDX-License-Identifier: Apache-2.0
"""Tables: columns that are aligned, cells that wrap, rows that break over pages under a repeated header."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from .boxes import BETWEEN, FAINT, Box
from .fonts import WIDTH
from .pagination import Block, Content, heading, paragraph
from .prose import CELL, GROUP, HEADER, NOTE, Style, lines, run, words_of
from .tags import CAPTION, COLUMN, ROW, Tag

if TYPE_CHECKING:
    from .pen import Pen

GAP = 7.0  # between columns
GUTTER = 17.2  # between tables or columns of text side by side: 6 mm
PAD = 0.7  # above and below the text of a row
MOST = 55  # lines of one row; a longer one goes on in the next
DARK = (0.45, 0.45, 0.45)


@dataclass(frozen=True, slots=True)
class Column:
    """A column: its header, its alignment (l, r), and its width (None: from its contents).

    `before`: the room on its left; with a gutter there, a table of its own begins beside the one before it."""

    header: str = ""
    align: str = "l"
    width: float | None = None
    style: Style = CELL
    before: float = GAP


@dataclass(frozen=True, slots=True)
class Cell:
    """What stands in a table other than plain words: a style or side of its own, a set box, or further lines in another
    style."""

    words: str = ""
    style: Style | None = None
    box: Box | None = None
    under: tuple[str, Style] | None = None
    align: str = ""  # empty: as its column
    indexed: str = ""  # under which names index and nomenclature lead to its row


@dataclass(frozen=True, slots=True)
class Group:
    """A row that names what follows."""

    words: str


Row = Sequence[str | Cell] | Group


@dataclass(frozen=True, slots=True)
class Rows(Content):
    """What a table says; `widths` of its columns in points: none, where they are all alike."""

    columns: Sequence[Column]
    rows: Sequence[Row]
    widths: Sequence[float] = ()


def table(
    columns: Sequence[Column],
    rows: Sequence[Row],
    *,
    width: float = WIDTH,
    gap: float = 3.0,
    header: bool = True,
    tag: Tag | None = None,
) -> list[Block]:
    """The blocks of a table.  The flexible columns share what the fixed ones leave, by their contents.

    `tag`: of all of it, where something else is part of it."""
    wide = _widths(columns, rows, width)
    left = [sum(wide[:i]) + sum(c.before for c in columns[1 : i + 1]) for i in range(len(wide))]
    ruled = _ruled(columns, left, width)
    top = _header(columns, wide, left, ruled) if header and any(c.header for c in columns) else None
    whole = tag or Tag("Table")
    blocks: list[Block] = [replace(top, gap=gap, keep=True, tag=Tag("TR", whole))] if top is not None else []
    held: list[Block] = []
    for n, r in enumerate(rows):
        if isinstance(r, Group):
            held.append(replace(_group(r.words, width, top, len(columns)), tag=Tag("TR", whole)))
            continue
        parts = [replace(part, tag=Tag("TR", whole)) for part in _row(columns, r, wide, left, ruled, top)]
        if held:
            blocks += held
            held = []
        elif n in (1, len(rows) - 1) and blocks and blocks[-1].repeat is top and not blocks[-1].keep:
            blocks[-1] = replace(blocks[-1], keep=True)  # two rows at least before and after a page's end
        blocks += parts
    if blocks and top is None:
        blocks[0] = replace(blocks[0], gap=gap)
    return [replace(blocks[0], content=Rows(columns if header else [], rows, wide)), *blocks[1:]] if blocks else blocks


def named_table(
    title: str, columns: Sequence[Column], rows: Sequence[Row], *, width: float = WIDTH, gap: float = 4.0
) -> list[Block]:
    """A table under a small heading of its own, which is its caption."""
    if not title:
        return table(columns, rows, width=width, gap=gap)
    whole = Tag("Table")
    caption = Tag(CAPTION, whole)
    head = [replace(block, tag=caption) for block in heading(title, GROUP, gap=gap + 3.0, after=0.0)]
    return [*head, *table(columns, rows, width=width, gap=0.0, tag=whole)]


def noted_below(blocks: list[Block], words: str, *, gap: float = 2.0) -> list[Block]:
    """Blocks with a note in small type under the last of them, on its page."""
    return [*blocks[:-1], *(replace(block, keep=True) for block in blocks[-1:]), *paragraph(words, NOTE, gap=gap)]


def _cell(cell: str | Cell) -> Cell:
    return Cell(cell) if isinstance(cell, str) else cell


def natural(cell: Cell, column: Column) -> float:
    """The width that a cell would like to have."""
    style = cell.style or column.style
    width = cell.box.width if cell.box is not None else run(cell.words, style).width if len(cell.words) < 400 else WIDTH
    under = run(cell.under[0], cell.under[1]).width * 0.5 if cell.under and len(cell.under[0]) < 400 else 0.0
    return max(width + (5.0 if column.align == "r" else 0.0), under)


def longest(words: str, style: Style, *, bound: bool = True) -> float:
    """The width of the longest word; `bound`: with what no line should part from it."""
    return max((run(word, style).width for word in (words_of(words) if bound else words.split())), default=0.0)


def _widths(columns: Sequence[Column], rows: Sequence[Row], width: float) -> list[float]:
    fixed = sum(c.width or 0.0 for c in columns)
    free = width - sum(c.before for c in columns[1:]) - fixed
    least = 24.0 * sum(c.width is None for c in columns)
    if free < least:  # fixed columns that are too wide together give way
        shrunk = [replace(c, width=c.width and c.width * (fixed + free - least) / fixed) for c in columns]
        return _widths(shrunk, rows, width)
    need: dict[int, float] = {}
    for i, column in enumerate(columns):
        if column.width is None:
            need[i] = max(
                [
                    14.0,
                    _header_width(column.header),
                    *(natural(_cell(r[i]), column) for r in rows if not isinstance(r, Group)),
                ]
            )
    total = sum(need.values())
    if total > free:
        # Narrow columns keep what they need; the wide ones share the rest, and none is narrower than its longest word,
        # if there is room.
        whole = dict.fromkeys(need, 0.0)
        for bound in (False, True):
            words = {}
            for i, n in need.items():
                cells = [
                    longest(_cell(r[i]).words, _cell(r[i]).style or columns[i].style, bound=bound)
                    for r in rows
                    if not isinstance(r, Group)
                ]
                words[i] = min(n, max(longest(columns[i].header, HEADER, bound=bound), *cells, 0.0))
            whole = words if sum(words.values()) <= free else whole
        fair = _fair([n - whole[i] for i, n in need.items()], free - sum(whole.values()))
        need = {i: whole[i] + min(n - whole[i], fair) for i, n in need.items()}
    elif need:
        widest = max(need, key=lambda i: need[i])
        if columns[widest].align == "l":
            need[widest] += free - total
        else:
            for i in need:
                need[i] += (free - total) / len(need)
    return [column.width if column.width is not None else need[i] for i, column in enumerate(columns)]


def _ruled(columns: Sequence[Column], left: list[float], width: float) -> list[tuple[float, float]]:
    """Where the rules below a row run, each with its length: through all columns, but not through a gutter."""
    starts = [0.0, *(x for x, column in zip(left[1:], columns[1:]) if column.before >= GUTTER)]
    ends = [*(x - GUTTER for x in starts[1:]), width]
    return [(start, end - start) for start, end in zip(starts, ends)]


def _header_width(words: str) -> float:
    """A header that is not short may wrap between its words."""
    whole = run(words, HEADER).width
    return whole if whole <= 50.0 else max(run(word, HEADER).width for word in words_of(words))


def _fair(needs: list[float], free: float) -> float:
    """The width w with Σ min(need, w) = free."""
    left, rest = free, sorted(needs)
    while rest:
        share = left / len(rest)
        if rest[0] >= share:
            return share
        left -= rest.pop(0)
    return free


def _header(columns: Sequence[Column], wide: list[float], left: list[float], ruled: list[tuple[float, float]]) -> Block:
    cells = [lines(c.header, HEADER, w, 9) if c.header else [] for c, w in zip(columns, wide)]
    tall = max(len(c) for c in cells) * HEADER.leading + 2 * PAD

    def draw(pen: Pen, y: float) -> None:
        for column, x, w, cell in zip(columns, left, wide, cells):
            base = y - tall + PAD + HEADER.leading * (len(cell) - 0.78)
            with pen.cell(COLUMN):
                for i, line in enumerate(cell):
                    shift = w - line.width if column.align == "r" else 0.0
                    pen.put(line, x + shift, base - i * HEADER.leading)
        for start, length in ruled:
            pen.rule(start, y - tall, length, 0.6, DARK)

    return Block(tall, draw)


def _group(words: str, width: float, top: Block | None, across: int) -> Block:
    set_lines = lines(words, GROUP, width, 4)
    tall = GROUP.leading * len(set_lines) + 2 * PAD + 3.0

    def draw(pen: Pen, y: float) -> None:
        with pen.cell(f"{ROW} /ColSpan {across}"):
            for i, line in enumerate(set_lines):
                pen.put(line, 0.0, y - tall + PAD + GROUP.leading * (len(set_lines) - 0.78 - i))
        pen.rule(0.0, y - tall, width, 0.4, FAINT)

    return Block(tall, draw, keep=True, repeat=top)


def _row(
    columns: Sequence[Column],
    cells: Sequence[str | Cell],
    wide: list[float],
    left: list[float],
    ruled: list[tuple[float, float]],
    top: Block | None,
) -> list[Block]:
    """One row, in several blocks where it is longer than a page should hold."""
    given = [_cell(cell) for cell in cells]
    width = sum(ruled[-1])
    # per column: its lines with their leading
    content = [_words(cell, column, w) for cell, column, w in zip(given, columns, wide)]
    counts = [len(set_lines) for set_lines in content]
    for i, cell in enumerate(given):
        if cell.under and cell.under[0]:
            # What stands below may run on under neighbours that are no taller than the words above it.
            free = all(n <= counts[i] and not other.under for n, other in zip(counts[i + 1 :], given[i + 1 :]))
            style = cell.under[1]
            content[i] += [
                (line, style.leading) for line in lines(cell.under[0], style, width - left[i] if free else wide[i])
            ]
    aligned = [cell.align or column.align for column, cell in zip(columns, given)]
    longest = max((len(c) for c in content), default=0)
    blocks = []
    for start in range(0, max(1, longest), MOST):
        part = [c[start : start + MOST] for c in content]
        blocks.append(_part(aligned, part, wide, left, ruled, top, last=start + MOST >= longest))
    if names := BETWEEN.join(cell.indexed for cell in given if cell.indexed):
        blocks[0] = replace(blocks[0], indexed=names)
    return blocks


def _words(cell: Cell, column: Column, width: float) -> list[tuple[Box, float]]:
    """The lines of a cell without what stands below them."""
    style = cell.style or column.style
    if cell.box is not None:
        return [(cell.box, max(style.leading, cell.box.height))]
    return [(line, style.leading) for line in lines(cell.words, style, width)] if cell.words else []


def _part(
    aligned: list[str],
    content: list[list[tuple[Box, float]]],
    wide: list[float],
    left: list[float],
    ruled: list[tuple[float, float]],
    top: Block | None,
    *,
    last: bool,
) -> Block:
    tall = max((sum(leading for _, leading in c) for c in content), default=0.0) + 2 * PAD

    def draw(pen: Pen, y: float) -> None:
        for x, w, cell, align in zip(left, wide, content, aligned):
            at = y - PAD
            with pen.cell("" if top is not None or x else ROW):
                for line, leading in cell:
                    shift = w - line.width if align == "r" else 0.0
                    pen.put(line, x + shift, at - 0.76 * leading)
                    at -= leading
        for start, length in ruled if last else ():
            pen.rule(start, y - tall, length, 0.4, FAINT)

    return Block(tall, draw, repeat=top)
