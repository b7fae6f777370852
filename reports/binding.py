# SPDX-License-Identifier: Apache-2.0
"""Pages made into a document: what it says about itself, the files inside it, its running heads."""

import io
from functools import partial

from reportlab import rl_config
from reportlab.pdfgen.canvas import Canvas

from calc.sheet.progress import Progress

from .pdf import attach
from .pdf.archive import archive
from .setting.flow import Page
from .setting.fonts import UPRIGHT, clean
from .pack import packed
from .pdf.binding import paint
from .paper import PAGE
from .blocks.title_block import PROGRAM, SHORT_HASH


def bind(
    pages: list[Page], files: dict[str, tuple[bytes, str]], *, title: str, author: str, revision: str, said: dict[str, str],
    words: dict[str, str], number: str = "", kind: str = "report", progress: Progress | None = None,
) -> bytes:  # fmt: skip
    """The document as the bytes of a PDF.  `said`: what it must keep about how it was made; `kind`: of its title in the running head."""
    out = io.BytesIO()
    dense, rl_config.useA85 = rl_config.useA85, 0  # streams as bytes, not as text a quarter longer
    try:
        canvas = Canvas(out, pagesize=PAGE, invariant=1, pageCompression=1, pdfVersion=(1, 7), initialFontName=UPRIGHT, lang=said["lang"])
        attach.describe(
            canvas, title=clean(title), author=clean(author), subject=f"{words[kind]}, design file sha256 {said['sha256']}",
            keywords=attach.keywords(PROGRAM, **said), program=PROGRAM,
        )  # fmt: skip
        attach.attach(canvas, files)
        canvas.setViewerPreference("DisplayDocTitle", "true")
        canvas.showOutline()
        of = " · ".join(filter(None, (number, revision and f"{words['revision']} {revision}")))
        foot = (of, f"{PROGRAM} · sha256 {said['sha256'][:SHORT_HASH]}")
        tree = paint(canvas, pages, (title, words[kind]), foot, words["page"], progress)
        archive(canvas._doc, tree, said["lang"])
        canvas._doc.format = partial(packed, canvas._doc)
        canvas.save()
    finally:
        rl_config.useA85 = dense
    return out.getvalue()
