# SPDX-License-Identifier: Apache-2.0
"""What a report draws, as pictures of pixels: each block is set on a sheet of its own, and the sheet is rendered."""

import io
from collections.abc import Sequence

import pypdfium2
from reportlab.pdfgen.canvas import Canvas

from .content import Picture
from .setting.flow import Block
from .setting.fonts import UPRIGHT
from .paper import LEFT, WIDTH
from .setting.pen import Codes, Pen

DPI = 200
MARGIN = 4.0  # points around what is drawn


def pictures(blocks: Sequence[Block]) -> list[bytes]:
    """Each block that draws as a PNG file, as wide as the column of text with its margin, without its captions.

    One that fills a page by itself is that page, turned to stand upright.
    """
    if not blocks:
        return []
    out, codes = io.BytesIO(), dict[str, Codes]()
    canvas = Canvas(out, invariant=1, initialFontName=UPRIGHT)
    for block in blocks:
        below = block.content.below if isinstance(block.content, Picture) else 0.0
        height = block.height - (below or -MARGIN)  # no room for the tops of a caption's letters
        canvas.setPageSize(block.page or (WIDTH + 2 * LEFT, height + MARGIN))
        pen = Pen(canvas, {}, codes)
        block.draw(pen, height)
        pen.write()
        canvas.showPage()
    canvas.save()
    return [_rendered(page, block.page is not None) for page, block in zip(pypdfium2.PdfDocument(out.getvalue()), blocks)]


def _rendered(page: pypdfium2.PdfPage, whole: bool) -> bytes:
    side = 0.0 if whole else LEFT - MARGIN
    file = io.BytesIO()
    drawn = page.render(scale=DPI / 72, crop=(side, 0, side, 0), rotation=270 if whole else 0)
    drawn.to_pil().save(file, format="PNG", dpi=(DPI, DPI))
    return file.getvalue()
