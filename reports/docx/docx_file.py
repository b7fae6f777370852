# SPDX-License-Identifier: Apache-2.0
"""The report as a Word document, for those who go on writing: what stands in the PDF, with formulas that can be edited.

It is made from the same blocks as the PDF, by what they say (`reports.typesetting.pagination`).  Needs the extra
`docx`."""

from __future__ import annotations

import io
import unicodedata
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pypdfium2
from docx import Document as new_document
from docx.enum.style import WD_STYLE_TYPE
from docx.enum.text import WD_ALIGN_PARAGRAPH
from docx.oxml import OxmlElement, parse_xml
from docx.oxml.ns import nsdecls, qn
from docx.shared import Pt, RGBColor
from reportlab.pdfgen.canvas import Canvas

from calc.design.disk import write_file
from calc.design.toml_file import Document
from calc.solve import Results

from ..context import Context
from ..made import program
from ..report import blocks, context_of, inputs_of
from ..typesetting.equation import spoken, spoken_numbers
from ..typesetting.fonts import BOLD, BOTTOM, LEFT, PAGE, RIGHT, TOP, UPRIGHT, WIDTH
from ..typesetting.pagination import Block, Formula, Heading, ListOfHeadings, Picture, TextContent
from ..typesetting.pen import Codes, Pen
from ..typesetting.prose import BODY, CELL, HEADER, INLINE, NOTE, Style
from ..typesetting.tables import Cell, Column, Group, Row, Rows
from ..typesetting.typeset import symbol_parts
from . import contents, omml

# --- the sheet and the styles
# The program's own names for body, table and source, so that a template can restyle them.

BODY_TEXT, TABLE_TEXT, SOURCE = "Report Text", "Report Table", "Report Source"
BULLET, CAPTION, SUBTITLE = "List Bullet", "Caption", "Subtitle"  # Word's own
CONTENTS = (contents.TITLE, *(contents.ENTRY.format(level=level) for level in contents.LOOKS))
SIZES = {BODY_TEXT: 9.5, TABLE_TEXT: 7.5, SOURCE: 7.5}
CELLS = (  # margins at the sides of a table's cells, in twentieths of a point
    f'<w:tblCellMar {nsdecls("w")}><w:left w:w="60" w:type="dxa"/><w:right w:w="60" w:type="dxa"/></w:tblCellMar>'
)
GREY = RGBColor(0x5C, 0x5C, 0x5C)


def prepare(file: Any, language: str) -> dict[str, str]:
    """A4, the margins of the PDF, the language to spell in, the styles that Word does not have; gives the ids of all
    that are used."""
    for spelt in file.styles.element.iter(qn("w:lang")):
        spelt.set(qn("w:val"), language)
    section = file.sections[0]
    section.page_width, section.page_height = Pt(PAGE[0]), Pt(PAGE[1])
    section.left_margin, section.right_margin, section.top_margin, section.bottom_margin = (
        Pt(LEFT),
        Pt(RIGHT),
        Pt(TOP),
        Pt(BOTTOM),
    )
    for name, size in SIZES.items():
        style = file.styles.add_style(name, WD_STYLE_TYPE.PARAGRAPH)
        style.base_style = file.styles["Normal"]
        style.font.size = Pt(size)
        style.paragraph_format.space_before = Pt(0)
        style.paragraph_format.space_after = Pt(0 if name == TABLE_TEXT else 3)
    contents.prepare(file)
    file.styles[BULLET].font.size = Pt(SIZES[BODY_TEXT])
    file.styles[SOURCE].font.color.rgb = GREY
    return {name: file.styles[name].style_id for name in (*SIZES, BULLET, CAPTION, SUBTITLE, *CONTENTS)}


# --- what a report draws, as pictures of pixels
# Each block is set on a sheet of its own, and the sheet is rendered.

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
    return [
        _rendered(page, block.page is not None) for page, block in zip(pypdfium2.PdfDocument(out.getvalue()), blocks)
    ]


def _rendered(page: pypdfium2.PdfPage, whole: bool) -> bytes:
    side = 0.0 if whole else LEFT - MARGIN
    file = io.BytesIO()
    drawn = page.render(scale=DPI / 72, crop=(side, 0, side, 0), rotation=270 if whole else 0)
    drawn.to_pil().save(file, format="PNG", dpi=(DPI, DPI))
    return file.getvalue()


# --- the document

ONE_LINE = 70  # letters of a formula with its numbers that stand on one line
# of what goes on from the line above: a sign at its beginning is read as an operator, which wants something before it
INDENT = "\u2003"
PAD = 7.0  # points that a cell needs beside its words
DEPTHS = ("summary", "engineer")  # the audit is a record, and no text to go on with


def write(
    document: Document, results: Results, raw: bytes, path: Path, *, depth: str = "engineer", lang: str = "en"
) -> Path:
    """Write the report of a solved design as a Word document.  Raises ValueError for a depth or a language that there
    is not."""
    return write_file(path, render(document, results, raw, depth=depth, lang=lang), inputs=inputs_of(document, results))


def render(document: Document, results: Results, raw: bytes, *, depth: str = "engineer", lang: str = "en") -> bytes:
    if depth not in DEPTHS:
        raise ValueError(f"depth {depth!r}: must be one of {', '.join(DEPTHS)}")
    context = context_of(document, results, raw, depth=depth, lang=lang)
    writer = _Writer(context)
    writer.write(blocks(context))
    file = io.BytesIO()
    writer.file.save(file)
    return file.getvalue()


class _Writer:
    def __init__(self, context: Context) -> None:
        self.context = context
        self.file: Any = new_document()
        self.styles = prepare(self.file, context.say.code)
        self.listed: int | None = None  # headings that the contents lead to, which stand there already
        about, control = self.file.core_properties, context.design.control
        about.title, about.author = written(context.design.name)[:255], written(control.signatures()[0][1].name)[:255]
        about.subject, about.comments, about.language = context.words["report"], program(context.made), context.say.code
        about.keywords = f"design file sha256 {context.sha256}"
        about.created = about.modified = datetime.now(UTC)
        foot = self.file.sections[0].footer.paragraphs[0]
        foot.text, foot._p.style = (
            context.text("docx_note", program=program(context.made), sum=context.sha256),
            self.styles[SOURCE],
        )

    def write(self, all_blocks: list[Block]) -> None:
        drawn = iter(pictures([block for block in all_blocks if isinstance(block.content, Picture)]))
        for block in all_blocks:
            match block.content:
                case Heading(words, level):
                    self.heading(self.file.add_heading(written(words), level), level)
                    if level == 0:
                        self.line(SUBTITLE).add_run(self.context.words["report"])
                case ListOfHeadings(title):
                    self.contents(title, all_blocks)
                case TextContent(words, style, bullet):
                    runs(self.line(BULLET if bullet else BODY_TEXT), words, style)
                case Rows(columns, rows, widths):
                    self.table(columns, rows, widths)
                case Formula() as content:
                    self.formula(content)
                case Picture(captions):
                    self.picture(next(drawn), captions)
        if self.listed:
            contents.end(self.file.paragraphs[-1], 0)

    def contents(self, title: str, all_blocks: list[Block]) -> None:
        """The headings of all that follows, to which the next ones are the places that these lead to."""
        start = next(n for n, block in enumerate(all_blocks) if isinstance(block.content, ListOfHeadings))
        heads = [block.content for block in all_blocks[start:] if isinstance(block.content, Heading)]
        entries = [(written(head.words), head.level) for head in heads if head.level <= contents.LEVELS]
        if entries:
            ids = {level: self.styles[contents.ENTRY.format(level=level)] for level in contents.LOOKS}
            self.file.element.body.insert_element_before(
                contents.field(title, entries, ids, self.styles[contents.TITLE]), "w:sectPr"
            )
            self.listed = 0

    def heading(self, paragraph: Any, level: int) -> None:
        """A heading; one that the contents lead to has a bookmark, and with the first begins what they are of."""
        if self.listed is None or level > contents.LEVELS:
            return
        if self.listed == 0:
            contents.begin(paragraph, contents.BODY, 0)
        contents.bookmark(paragraph, contents.anchor(self.listed), self.listed + 1)
        self.listed += 1

    def line(self, style: str, within: Any = None) -> Any:
        """A new paragraph; its style is set by its id, which python-docx else looks up in ten times the time that all
        the rest takes."""
        paragraph = (within or self.file).add_paragraph()
        paragraph._p.style = self.styles[style]
        return paragraph

    def picture(self, png: bytes, captions: tuple[str, ...]) -> None:
        shape = self.file.add_picture(io.BytesIO(png), width=Pt(WIDTH))
        # is read out in place of the picture
        shape._inline.docPr.set("descr", written(" ".join(captions) or self.context.design.name))
        for side in "TBLR":
            shape._inline.set(f"dist{side}", "0")  # where it is left out LibreOffice takes 9 points
        if captions:
            self.file.paragraphs[-1].paragraph_format.keep_with_next = True
            runs(self.line(CAPTION), "   ".join(captions), NOTE)

    def formula(self, content: Formula) -> None:
        """Each line is a paragraph, so that none is broken where it need not be."""
        parts: list[str] = []
        if (first := content.first) is not None and first.formula is not None:
            parts.append(omml.formula(first.symbol, first.formula))
        elif first is not None:
            named = self.line(BODY_TEXT)
            named._p.append(parse_xml(omml.inline(omml.symbol(first.symbol))))
            runs(named, f": {first.shows}", BODY)
        for label, line in content.lines:
            if parts and line is first and len(spoken(line)) + len(spoken_numbers(line)) <= ONE_LINE:
                parts[0] += omml.numbers(line)
            else:
                parts.append(omml.words(f"{written(label)}: " if label else INDENT) + omml.numbers(line))
        for part in parts:
            self.line(BODY_TEXT)._p.append(parse_xml(omml.paragraph(part)))
        if below := " · ".join(filter(None, (content.more, content.source))):
            runs(self.line(SOURCE), below, NOTE)

    # --- tables
    def table(self, columns: Sequence[Column], rows: Iterable[Row], widths: Sequence[float]) -> None:
        """A table with a row of headers that is repeated on every page; columns in which nothing stands are left
        out."""
        body = [row for row in rows if isinstance(row, Group) or any(map(_says, row))]
        full = [row for row in body if not isinstance(row, Group)]
        used = [
            n
            for n in range(max(map(len, full)))
            if any(_says(row[n]) for row in full) or (columns and columns[n].header)
        ]
        table = self.file.add_table(rows=0, cols=len(used), style="Table Grid")
        if any(column.header for column in columns):
            row = table.add_row()
            row._tr.get_or_add_trPr().append(OxmlElement("w:tblHeader"))
            for cell, n in zip(row.cells, used):
                self.cell(cell, Cell(columns[n].header, HEADER), columns[n])
        for given in body:
            cells = table.add_row().cells
            if isinstance(given, Group):
                self.cell(cells[0].merge(cells[-1]), Cell(given.words, HEADER), Column())
                continue
            for place, n in zip(cells, used):
                entry = given[n]
                self.cell(place, Cell(entry) if isinstance(entry, str) else entry, columns[n] if columns else Column())
        self.spread(table, [widths[n] + PAD for n in used] if widths else [1.0] * len(used))
        self.line(SOURCE)  # two tables that touch would become one

    def spread(self, table: Any, shares: Sequence[float]) -> None:
        """Columns as wide as on paper, the table as wide as the text."""
        table.autofit = False
        # in the order of the schema, which Word asks for
        table._tbl.tblPr.insert_element_before(parse_xml(CELLS), "w:tblLook")
        for column, share in zip(table.columns, shares):
            column.width = Pt(WIDTH * share / sum(shares))
        for row in table.rows:
            for place, share in zip(row._tr.tc_lst, shares):
                if place.grid_span == 1:
                    place.width = Pt(WIDTH * share / sum(shares))

    def cell(self, place: Any, cell: Cell, column: Column) -> None:
        line = place.paragraphs[0]
        line._p.style = self.styles[TABLE_TEXT]
        if (cell.align or column.align) == "r":
            line.alignment = WD_ALIGN_PARAGRAPH.RIGHT
        if cell.box is not None:
            _marks(line, cell)
        else:
            runs(line, cell.words, cell.style or column.style)
        if cell.under and cell.under[0]:
            runs(self.line(TABLE_TEXT, place), *cell.under)


def _says(cell: str | Cell) -> bool:
    return bool(cell) if isinstance(cell, str) else bool(cell.words or cell.box or cell.under)


def _marks(line: Any, cell: Cell) -> None:
    """A symbol that was set: its letters, with the indices that stand lower and higher."""
    assert cell.box is not None
    for mark in cell.box.marks:
        if mark[0] == "text":
            font = line.add_run(written(mark[3])).font
            if mark[2]:
                setattr(font, "subscript" if mark[2] < 0 else "superscript", True)


def runs(line: Any, words: str, style: Style) -> None:
    """Words on a line in the look of their style; a symbol in them with its index."""
    for n, part in enumerate([words] if style.plain else INLINE.split(words)):
        for letters, below, above in symbol_parts(part) if n % 2 else [(part, "", "")]:
            for text, key in ((letters, ""), (below, "subscript"), (above, "superscript")):
                if not text:
                    continue
                piece = line.add_run(written(text))
                if key:
                    setattr(piece.font, key, True)
                if style.face == BOLD:
                    piece.bold = True
                if any(style.colour) and style not in (BODY, CELL, HEADER):
                    piece.font.color.rgb = RGBColor(*(round(255 * c) for c in style.colour))


def written(words: str) -> str:
    """Words without what a file of XML can not hold."""
    return "".join(" " if unicodedata.category(c) in ("Cc", "Cs", "Cn") else c for c in words)
