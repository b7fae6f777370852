# SPDX-License-Identifier: Apache-2.0
"""The pages on the canvas, each with its running head and foot, and the outline."""

from __future__ import annotations

from reportlab.pdfgen.canvas import Canvas

from calc.sheet.progress import Progress, tell

from ..setting.boxes import FAINT, GREY
from ..setting.flow import Page
from ..paper import PAGE, TOP, WIDTH
from ..setting.pen import Codes, Pen
from ..setting.prose import NOTE, one_line
from ..setting.symbols import BETWEEN
from ..setting.tags import Tag, Tree


def paint(
    canvas: Canvas, pages: list[Page], head: tuple[str, str], foot: tuple[str, str], counted: str, progress: Progress | None = None
) -> Tree:
    """All pages with running head, foot and outline; what their parts are.  `counted` holds {page} and {pages}."""
    numbers = {block.anchor: n for n, page in enumerate(pages, 1) for _, block in page.blocks if block.anchor}
    places: dict[str, list[int]] = {}
    for n, page in enumerate(pages, 1):
        for _, block in page.blocks:
            for name in block.indexed.split(BETWEEN) if block.indexed else ():
                if n not in places.setdefault(name, []):
                    places[name].append(n)
    upper = PAGE[1] - TOP
    codes: dict[str, Codes] = {}
    tree = Tree(len(pages))
    for n, page in enumerate(pages, 1):
        tell(progress, (n - 1) / len(pages), counted.format(page=n, pages=len(pages)))
        pen = Pen(canvas, numbers, codes, places, tree)
        canvas.setPageSize(page.size or PAGE)
        canvas.bookmarkHorizontalAbsolute(f"page-{n}", (page.size or PAGE)[1], left=0)
        if page.size is not None:
            titles = [block.outline[1] for _, block in page.blocks if block.outline is not None]
            pen.put(one_line(" · ".join([*titles, counted.format(page=n, pages=len(pages))]), NOTE, WIDTH), 0.0, 4.0)
        else:
            _running(pen, n, len(pages), head, foot, counted)
        again = page.blocks[1][1].repeat if len(page.blocks) > 1 else None
        for at, block in page.blocks:
            if block.anchor:
                canvas.bookmarkHorizontalAbsolute(block.anchor, round(upper - at + 8.0, 2), left=0)
            if block.outline is not None:
                canvas.addOutlineEntry(block.outline[1], block.anchor, block.outline[0], closed=block.outline[0] > 0)
            with pen.tagged(None if block is again else block.tag or Tag("P")):
                block.draw(pen, upper - at)
        pen.write()
        canvas.showPage()
    return tree


def _running(pen: Pen, number: int, count: int, head: tuple[str, str], foot: tuple[str, str], counted: str) -> None:
    pages = one_line(counted.format(page=number, pages=count), NOTE, 100.0)
    upper, lower = PAGE[1] - 36.0, 30.0
    right = one_line(head[1], NOTE, 0.35 * WIDTH)
    pen.put(one_line(head[0], NOTE, WIDTH - right.width - 12.0), 0.0, upper)
    pen.put(right, WIDTH - right.width, upper)
    pen.rule(0.0, upper - 5.0, WIDTH, 0.5, GREY)
    pen.rule(0.0, lower + 11.0, WIDTH, 0.4, FAINT)
    left = one_line(foot[0], NOTE, 0.4 * WIDTH)
    pen.put(left, 0.0, lower)
    pen.put(one_line(foot[1], NOTE, WIDTH - left.width - pages.width - 28.0), left.width + 14.0 if foot[0] else 0.0, lower)
    pen.put(pages, WIDTH - pages.width, lower)
