# SPDX-License-Identifier: Apache-2.0
"""The sheets for the balancing machine as a PDF: a page of A4 for each shaft that asks for one."""

from __future__ import annotations

from calc.design.toml_file import Document
from calc.locale import language
from calc.solve import Results
from calc.studies.balancing import sheets

from .blocks.drawing import sheet_block
from .blocks.words import WORDS
from .made import versions
from .pdf.binding import bind
from .typesetting.fonts import FACES, widths
from .typesetting.pagination import paginate


def render(document: Document, results: Results, *, lang: str = "en") -> bytes:
    """The document as the bytes of a PDF: the same design gives the same bytes."""
    for face in FACES:
        widths(face)
    say = language(lang)
    drawn = sheets(results, say, document.sha256)
    words = {key: say(text) for key, text in WORDS.items()}
    control = results.design.control
    return bind(
        paginate([sheet_block(sheet, sheet.title) for sheet in drawn.values()]),
        {},
        title=results.design.name,
        author=control.signatures()[0][1].name,
        revision=control.revision,
        number=control.number,
        said=dict(lang=lang, sha256=document.sha256),
        made=versions(),
        words=words,
        kind="balancing",
    )
