# SPDX-License-Identifier: Apache-2.0
"""The flow of blocks down the pages: what a block says, what stays together, where a page ends, what is repeated."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from .boxes import BLACK, Box
from .fonts import HEIGHT, WIDTH
from .prose import BODY, HEADING, SECTION, SHAFT, Style
from .prose import lines as text_lines
from .tags import Tag, title_tag

if TYPE_CHECKING:
    from calc.sheet.expression import Shown

    from .pen import Pen


# --- what a block says, beside how it is drawn: for whoever sets the same report elsewhere (`reports.docx.docx_file`)
# A block without content goes on with the one before it, or only adorns the page.


class Content:
    """Of any kind: one of those below, or the rows of a table."""


@dataclass(frozen=True, slots=True)
class Heading(Content):
    """`level`: 0 for the title of the whole, 1 for a chapter."""

    words: str
    level: int


@dataclass(frozen=True, slots=True)
class ListOfHeadings(Content):
    """The contents: the headings of all that follows, down to level 2."""

    title: str


@dataclass(frozen=True, slots=True)
class TextContent(Content):
    """A paragraph."""

    words: str
    style: Style
    bullet: bool = False


@dataclass(frozen=True, slots=True)
class Formula(Content):
    """A formula, and below it its numbers for each part, by the part's name; `more`: further values in words.

    `first`: the line that stands for all; None where the formula stood in the block before.
    """

    first: Shown | None
    lines: tuple[tuple[str, Shown], ...]
    more: str
    source: str


@dataclass(frozen=True, slots=True)
class Picture(Content):
    """What is drawn, with its captions; these stand at its lower end, as high as `below`."""

    captions: tuple[str, ...] = ()
    below: float = 0.0


# --- the flow

LEAST = 0.4  # of the last page: less on it is not worth the paper
# from what stands first on a page because it did not fit on the one before to the text that goes on under it
AFTER = 8.0
CLOSER = (0.85, 0.7, 0.5)  # of every gap; the first is hardly seen, and worth any page that it saves


@dataclass(frozen=True, slots=True)
class Block:
    """Something that is not torn apart.  `draw(pen, y)` gets the height of its upper edge; x = 0 is the left margin.

    `gap`: space above, left out at the top of a page.  `keep`: stays with the next block.  `repeat`: is drawn first
    where this block begins a page.  `need`: begins a page unless so much of the page is left.  `floats`: where it does
    not fit, what follows up to the next chapter (`need`) fills the page, and it stands first on the next one, or below
    the table that goes on there.  `anchor`: links and the outline lead here. `tag`: what it is; left out, a
    paragraph."""

    height: float
    draw: Callable[[Pen, float], None]
    gap: float = 0.0
    keep: bool = False
    repeat: Block | None = None
    need: float = 0.0
    anchor: str = ""
    outline: tuple[int, str] | None = None  # level and title
    indexed: str = ""  # under which name the index leads here
    content: Content | None = None
    tag: Tag | None = None
    page: tuple[float, float] | None = None  # the size of a page that it fills by itself, without running head and foot
    floats: bool = False


@dataclass(slots=True)
class Page:
    blocks: list[tuple[float, Block]] = field(default_factory=list)  # distance from the upper margin
    filled: float = 0.0
    share: float = 1.0  # of every gap that is kept

    @property
    def size(self) -> tuple[float, float] | None:
        """Of a page that a block fills by itself; None for one of running text."""
        return self.blocks[0][1].page if self.blocks else None

    def put(self, chain: list[Block]) -> None:
        for block in chain:
            self.filled += self.share * block.gap if self.blocks else 0.0
            self.blocks.append((self.filled, block))
            self.filled += block.height


def paginate(blocks: Iterable[Block], height: float = HEIGHT, share: float = 1.0) -> list[Page]:
    """Blocks on pages.  A chain of blocks that stay together moves to the next page whole, unless no page can hold it.

    `share`: of every gap that is kept.
    """
    pages = [Page(share=share)]
    waiting: list[list[Block]] = []

    def fits(chain: list[Block]) -> bool:
        page, first = pages[-1], chain[0]
        if all(not block.height and block.page is None for block in chain):
            return True  # takes no room, not even on a page that another block fills by itself
        left = height - page.filled
        alone = page.size is not None or first.page is not None
        return not page.blocks or not (
            alone or sum([b.height + share * b.gap for b in chain]) > left + 1e-6 or first.need > left
        )

    def settle() -> None:
        """What waits for room, as long as there is some."""
        while waiting and fits(waiting[0]):
            pages[-1].put(waiting.pop(0))
            pages[-1].filled += AFTER

    def turn(*, inside: bool = False) -> None:
        """A new page, and on it first what waits for one, unless a table goes on there."""
        pages.append(Page(share=share))
        if not inside:
            settle()

    for chain in _chains(list(blocks), height, share):
        inside = _goes_on(pages[-1], chain[0])
        if not inside:
            settle()
        while waiting and chain[0].need:
            turn()
        if chain[0].floats and (waiting or not fits(chain)):
            waiting.append(chain)
            continue
        if not fits(chain):
            chain = [*filter(None, [chain[0].repeat]), *chain]
            while not fits(chain):
                turn(inside=inside)
        pages[-1].put(chain)
    settle()
    while waiting:
        turn()
    return pages


def _goes_on(page: Page, block: Block) -> bool:
    """Whether a block is a further row of the table that stands last on the page."""
    table = block.tag and block.tag.within
    last = page.blocks[-1][1].tag if page.blocks else None
    return table is not None and last is not None and last.within is table


def composed(blocks: Iterable[Block]) -> list[Page]:
    """Pages of which the last one of running text is worth its paper: else the gaps are closed, if that saves it."""
    all_blocks = list(blocks)
    pages = paginate(all_blocks)
    for share in CLOSER:
        closer = paginate(all_blocks, HEIGHT, share)
        if len(closer) < len(pages):
            return closer
        last = next((page for page in reversed(closer) if page.size is None), None)
        if last is None or last.filled > LEAST * HEIGHT:
            break
    return pages


def _chains(blocks: list[Block], height: float, share: float) -> Iterable[list[Block]]:
    chain: list[Block] = []
    filled = 0.0
    for block in blocks:
        if chain and filled + share * block.gap + block.height > 0.9 * height:  # no page would hold it together
            yield chain
            chain, filled = [], 0.0
        chain.append(block)
        filled += share * block.gap + block.height
        if not block.keep:
            yield chain
            chain, filled = [], 0.0
    if chain:
        yield chain


# --- simple blocks


def lines_block(
    lines: list[Box], leading: float, *, x: float = 0.0, gap: float = 0.0, keep: bool = False, tag: Tag | None = None
) -> Block:
    """Lines of text as one block."""

    def draw(pen: Pen, y: float) -> None:
        for i, line in enumerate(lines):
            pen.put(line, x, y - (i + 0.78) * leading)

    return Block(leading * len(lines), draw, gap, keep, tag=tag)


def paragraph(
    words: str, style: Style = BODY, *, x: float = 0.0, gap: float = 3.0, keep: bool = False, most: int = 0
) -> list[Block]:
    """A paragraph, line by line, so that it may run over a page; its first and last two lines stay together."""
    set_lines = text_lines(words, style, WIDTH - x, most)
    n, tag = len(set_lines), Tag("P")
    blocks = [
        lines_block(
            [line],
            style.leading,
            x=x,
            gap=gap if i == 0 else 0.0,
            keep=keep if i == n - 1 else i == 0 or i == n - 2,
            tag=tag,
        )
        for i, line in enumerate(set_lines)
    ]
    return [replace(blocks[0], content=TextContent(words, style)), *blocks[1:]]


def bullet(words: str, style: Style = BODY, *, sign: str = "–", indent: float = 10.0, gap: float = 1.5) -> list[Block]:
    """A paragraph with a sign hanging in front of it."""
    blocks = paragraph(words, style, x=indent, gap=gap)
    mark = text_lines(sign, style, indent)[0]
    first = blocks[0]
    item = Tag("LI")
    label, body = Tag("Lbl", item), Tag("LBody", item)

    def draw(pen: Pen, y: float) -> None:
        with pen.tagged(label):
            pen.put(mark, 0.0, y - 0.78 * style.leading)
        with pen.tagged(body):
            first.draw(pen, y)

    begun = replace(first, draw=draw, content=TextContent(words, style, bullet=True), tag=item)
    return [begun, *(replace(block, tag=body) for block in blocks[1:])]


def heading(
    words: str,
    style: Style,
    *,
    gap: float,
    after: float = 2.0,
    anchor: str = "",
    outline: int | None = None,
    title: str = "",
    need: float = 0.0,
    ruled: bool = False,
) -> list[Block]:
    """A heading stays with what follows; it may carry an entry of the outline."""
    set_lines = text_lines(words, style, WIDTH, 4)
    level = 1 if style is HEADING else 2 if style in (SHAFT, SECTION) else 3
    entry = (outline, title or words) if outline is not None else None

    def draw(pen: Pen, y: float) -> None:
        for i, line in enumerate(set_lines):
            pen.put(line, 0.0, y - (i + 0.78) * style.leading)
        if ruled:
            pen.rule(0.0, y - style.leading * len(set_lines) - 1.5, WIDTH, 0.7, BLACK)

    height = style.leading * len(set_lines) + after + (2.0 if ruled else 0.0)
    content = Heading(words, level)
    return [Block(height, draw, gap, True, None, need, anchor, entry, content=content, tag=title_tag(style.size))]


def on_paper_only(blocks: list[Block]) -> list[Block]:
    """What holds for the pages of a PDF and for no other form of the report: page numbers, files inside it."""
    return [replace(block, content=None) for block in blocks]
