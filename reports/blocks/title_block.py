# SPDX-License-Identifier: Apache-2.0
"""The title block of a report: what the document is, whose, and who has signed it; empty fields are boxes to sign by
hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

from calc.design.other_tables import DocumentControl

from ..context import Context
from ..made import MADE, program
from ..typesetting.boxes import GREY
from ..typesetting.boxes import text as text_box
from ..typesetting.fonts import LEFT, MISSING, WIDTH, writable
from ..typesetting.pagination import Block, Heading, heading, on_paper_only, paragraph
from ..typesetting.prose import BODY, NOTE, SECTION, TITLE, lines, one_line
from ..typesetting.tables import Column, Rows, table
from ..typesetting.tags import COLUMN, FIGURE, ROW, Tag, title_tag

if TYPE_CHECKING:
    from ..typesetting.pen import Pen

SHORT_HASH = 16
NOTE_LINES = 8  # of the first page; a longer note is repeated whole at the end
LOGO = (130.0, 32.0)  # at most, in points
ACROSS = 4  # facts beside each other
PAD = 4.0
SIGN = 14.0  # height of a field to sign in
FIELDS = ("Prepared", "Checked", "Approved")  # what a signing program calls the fields, in every language
EDGE = 1.0  # of a field within its box
SIGN_AT = (0.0, 0.16 * WIDTH, 0.52 * WIDTH, 0.68 * WIDTH)  # where who, name, date and signature begin
FRAME, LINE = (0.2, 0.2, 0.2), (0.62, 0.62, 0.62)


def title_blocks(context: Context) -> list[Block]:
    w, design = context.words, context.design
    control = design.control
    blocks = _heading(context)
    if design.note:
        blocks += paragraph(design.note, BODY, gap=2.0, most=NOTE_LINES)
    facts = [(w[key], getattr(control, key)) for key in ("number", "revision", "project", "customer", "company")]
    facts = [(label, value) for label, value in facts if value]
    facts += [(w["file"], f"{context.sha256[:SHORT_HASH]}…"), (w["program"], program(context.made))]
    blocks += [_facts(facts), signature_block(context, control)]
    texts = (design.name, design.note, *control.words())
    if not all(map(writable, texts)) and not any(MISSING in s for s in texts):
        blocks += on_paper_only(paragraph(w["missing_glyphs"], NOTE, gap=0.0))
    return blocks


def file_notes(context: Context) -> list[Block]:
    """What lies in the file beside the pages, the units of the formulas, and what computed the numbers."""
    w = context.words
    notes = [w["attached"], w["in_si"] if context.depth != "summary" else "", made_with(context)]
    return on_paper_only(paragraph(" ".join(filter(None, notes)), NOTE, gap=3.0))


def made_with(context: Context) -> str:
    """The versions of what computed the numbers; empty of a report that does not say them."""
    made = context.made
    if not {*MADE} <= {*made}:
        return ""
    return context.text("made_with", python=made["python"], numpy=made["numpy"], scipy=made["scipy"])


def change_blocks(context: Context) -> list[Block]:
    """The change record, as it stands in the design."""
    changes = context.design.control.changes
    if not changes:
        return []
    w = context.words
    columns = (Column(w["revision"]), Column(w["date"]), Column(w["what"]), Column(w["by"]))
    rows = [(change.revision, change.date, change.what, change.by) for change in changes]
    return heading(w["changes"], SECTION, gap=9.0, after=0.0) + table(columns, rows, gap=2.0)


def _heading(context: Context) -> list[Block]:
    """What it is and its name, with the logo beside them."""
    w, logo = context.words, context.logo
    scale = min(LOGO[0] / logo.width, LOGO[1] / logo.height) if logo is not None else 0.0
    wide, high = (logo.width * scale, logo.height * scale) if logo is not None else (0.0, 0.0)
    kind = text_box(w["report"], NOTE.size + 0.6, colour=GREY)
    title = lines(context.design.name, TITLE, WIDTH - (wide and wide + 16.0), 4)
    height = max(11.0 + TITLE.leading * len(title), high)

    def draw(pen: Pen, y: float) -> None:
        pen.put(kind, 0.0, y - 0.78 * 11.0)
        for n, line in enumerate(title):
            pen.put(line, 0.0, y - 11.0 - (n + 0.78) * TITLE.leading)
        if logo is not None:
            canvas, place = pen.canvas, (LEFT + WIDTH - wide, y - high, wide, high)
            with pen.tagged(Tag(FIGURE, alt=f"{w['logo']}: {logo.name}")):
                pen.figure(lambda: canvas.drawImage(logo.image, *place, mask="auto"))

    content = Heading(context.design.name, 0)
    tag = title_tag(TITLE.size)
    return [Block(height, draw, keep=True, anchor="summary", outline=(0, w["summary"]), content=content, tag=tag)]


def _facts(facts: list[tuple[str, str]]) -> Block:
    """Small labels with their values below, in cells beside each other: rows of about as many, each as wide as the
    block."""
    across = -(-len(facts) // -(-len(facts) // ACROSS))
    rows = []
    for first in range(0, len(facts), across):
        given = facts[first : first + across]
        room = WIDTH / len(given) - 2 * PAD
        rows.append([(one_line(label, NOTE, room), lines(value, BODY, room, 6)) for label, value in given])
    heights = [NOTE.leading + max(len(v) for _, v in r) * BODY.leading + 3.0 for r in rows]

    def draw(pen: Pen, y: float) -> None:
        top = y
        for r, height in zip(rows, heights):
            for i, (label, value) in enumerate(r):
                x = i * WIDTH / len(r)
                pen.put(label, x + PAD, top - 1.0 - 0.78 * NOTE.leading)
                for n, line in enumerate(value):
                    pen.put(line, x + PAD, top - 1.0 - NOTE.leading - (n + 0.78) * BODY.leading)
                if i:
                    _upright(pen, x, top, height)
            top -= height
            pen.rule(0.0, top, WIDTH, 0.4, LINE)
        _frame(pen, y, sum(heights), top_line=True)

    return Block(sum(heights), draw, gap=5.0, keep=True, content=Rows([], facts))


def signature_block(context: Context, control: DocumentControl, *, alone: bool = False) -> Block:
    """A row for each who signs: name, date, and the field of the signature, for a pen or a certificate.  `alone`:
    nothing stands right above it."""
    w = context.words
    ends = (*SIGN_AT[1:], WIDTH)
    heads = ["", w["name"], w["date"], w["signature"]]
    rows = [(w[key], signer.name, signer.date, "") for key, signer in control.signatures()]
    head = NOTE.leading + 1.0
    whole = Tag("Table")
    height = head + SIGN * len(rows)

    def draw(pen: Pen, y: float) -> None:
        with pen.tagged(Tag("TR", whole)):
            for x, end, words in zip(SIGN_AT, ends, heads):
                with pen.cell(COLUMN):
                    pen.put(one_line(words, NOTE, end - x - 2 * PAD), x + PAD, y - 0.85 * NOTE.leading)
        for n, row in enumerate(rows):
            top = y - head - n * SIGN
            pen.rule(0.0, top, WIDTH, 0.4, LINE)
            with pen.tagged(Tag("TR", whole)):
                for i, (x, end, words) in enumerate(zip(SIGN_AT, ends, row)):
                    with pen.cell("" if i else ROW):
                        pen.put(one_line(words, BODY if i else NOTE, end - x - 2 * PAD), x + PAD, top - 0.64 * SIGN)
                        if i == len(row) - 1:
                            box = x + EDGE, top - SIGN + EDGE, end - x - 2 * EDGE, SIGN - 2 * EDGE
                            pen.signature(*box, FIELDS[n], f"{w['signature']}: {row[0]}")
        for x in SIGN_AT[1:]:
            _upright(pen, x, y, height)
        _frame(pen, y, height, top_line=False)
        if alone:
            pen.rule(0.0, y, WIDTH, 0.8, FRAME)

    content = Rows([Column(words) for words in heads], rows, [b - a for a, b in zip(SIGN_AT, ends)])
    return Block(height, draw, gap=14.0 if alone else 0.0, keep=True, content=content, tag=whole)


def _upright(pen: Pen, x: float, top: float, height: float) -> None:
    pen.line([(LEFT + x, top), (LEFT + x, top - height)], 0.4, LINE)


def _frame(pen: Pen, top: float, height: float, *, top_line: bool) -> None:
    """Three sides of the block's frame, with the upper or the lower one."""
    left, right, low = LEFT, LEFT + WIDTH, top - height
    ends = (low, top) if top_line else (top, low)
    pen.line([(left, ends[0]), (left, ends[1]), (right, ends[1]), (right, ends[0])], 0.8, FRAME)
