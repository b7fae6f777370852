# SPDX-License-Identifier: Apache-2.0
"""The report as a Word document, read back."""

import io
import re
import xml.etree.ElementTree as ET
import zipfile
from typing import Any

import pytest
from pypdf import PdfReader
from reportlab.pdfgen.canvas import Canvas

from reports.blocks.title_block import made_with
from reports.report import blocks, context_of
from reports.typesetting.pagination import Formula, Heading, Picture, TextContent
from reports.typesetting.pen import Pen
from reports.typesetting.tables import Rows
from tests.reports.reading import V12, Solved, solved, squeezed

docx = pytest.importorskip("docx", reason="needs the extra docx")
pytest.importorskip("pypdfium2", reason="needs the extra docx")

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
MATH = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"


def render(made: Solved, depth: str = "engineer", lang: str = "en") -> bytes:
    from reports.docx.docx_file import render as written

    return written(made.document, made.results, made.raw, depth=depth, lang=lang)


def opened(raw: bytes) -> Any:
    return docx.Document(io.BytesIO(raw))


def text_of(file: Any) -> str:
    """All text in its order, formulas with it."""
    return "\n".join("".join(p.itertext()) for p in file.element.body.iter() if p.tag.endswith("}p"))


@pytest.fixture(scope="module")
def engineer_file(example: Solved) -> bytes:
    return render(example)


@pytest.fixture(scope="module")
def engineer_docx(engineer_file: bytes) -> Any:
    return opened(engineer_file)


def contents(made: Solved, depth: str = "engineer", lang: str = "en") -> list[Any]:
    return blocks(context_of(made.document, made.results, made.raw, depth=depth, lang=lang))


def test_it_has_what_the_blocks_of_the_pdf_say(example: Solved, engineer_docx: Any) -> None:
    said = [block.content for block in contents(example)]
    read = engineer_docx.paragraphs
    assert [c.words for c in said if isinstance(c, Heading)] == [
        p.text for p in read if p.style.name.startswith(("Heading", "Title"))
    ]
    assert len([c for c in said if isinstance(c, Rows)]) == len(engineer_docx.tables) > 40
    assert len([c for c in said if isinstance(c, Picture)]) == len(engineer_docx.inline_shapes) > 8
    captions = [caption for c in said if isinstance(c, Picture) for caption in c.captions]
    found = [p.text for p in read if p.style.name == "Caption"]
    assert len(captions) > 8 and squeezed("".join(captions)) == squeezed("".join(found))
    whole = squeezed(text_of(engineer_docx))
    assert all(squeezed(c.words) in whole for c in said if isinstance(c, TextContent))
    formulas = [c for c in said if isinstance(c, Formula)]
    lines = sum(len(c.lines) for c in formulas)
    assert lines <= len(list(engineer_docx.element.body.iter(f"{MATH}oMath"))) <= lines + len(formulas)


def test_nothing_that_the_pages_say_is_left_out(example: Solved) -> None:
    """Every word that a block draws stands in the document, but for those within pictures, and what holds for pages
    alone."""
    context = context_of(example.document, example.results, example.raw, depth="summary", lang="en")
    whole = squeezed(text_of(opened(render(example, "summary"))))
    drawn: list[str] = []
    for block in blocks(context):
        if not isinstance(block.content, Picture):
            pen = Pen(Canvas(None), {}, {})
            block.draw(pen, 0.0)
            drawn += [mark[3] for _, _, mark, *_ in pen.text if mark[0] == "text"]
    assert len(drawn) > 150
    missing = [words for words in drawn if squeezed(words) not in whole]
    assert {word for words in missing for word in words.split()} <= set(
        f"{context.words['attached']} {made_with(context)}".split()
    )


def test_formulas_can_be_edited(engineer_docx: Any) -> None:
    body = engineer_docx.element.body
    assert len(list(body.iter(f"{MATH}f"))) > 50 and list(body.iter(f"{MATH}rad")) and list(body.iter(f"{MATH}sSub"))
    stress = next(p for p in body.iter(f"{MATH}oMathPara") if "".join(p.itertext()).startswith("σz="))
    fraction = next(stress.iter(f"{MATH}f"))
    assert "".join(fraction.find(f"{MATH}num").itertext()) == "FV"
    assert any("".join(p.itertext()).endswith("= 431 MPa") for p in body.iter(f"{MATH}oMathPara"))


def test_headers_are_repeated_and_indices_stand_low(engineer_docx: Any) -> None:
    values = next(
        t for t in engineer_docx.tables if [c.text for c in t.rows[0].cells][:3] == ["Quantity", "Symbol", "Value"]
    )
    assert "tblHeader" in values.rows[0]._tr.xml and "tblHeader" not in values.rows[1]._tr.xml
    symbol = values.rows[1].cells[1].paragraphs[0]
    assert [(run.text, run.font.subscript) for run in symbol.runs] == [("M", None), ("alt", True)]
    widths = [cell.width for cell in values.rows[1].cells]
    assert widths[0] > 2 * widths[1]


def test_it_says_that_it_is_no_record(example: Solved, engineer_docx: Any) -> None:
    foot = engineer_docx.sections[0].footer.paragraphs[0].text
    assert example.document.sha256 in foot and "The record is the PDF report" in foot
    about = engineer_docx.core_properties
    assert about.title == example.results.design.name and about.subject == "Calculation report" and about.author == ""
    assert "attached to this document" not in text_of(engineer_docx)
    described = [shape._inline.docPr.get("descr") for shape in engineer_docx.inline_shapes]
    assert all(described) and any("Figure 2" in words for words in described)


def test_the_contents_are_a_field_that_is_filled_and_leads_to_the_chapters_of_the_pdf(
    engineer_file: bytes, engineer: bytes
) -> None:
    """Read as what it is, a file of XML: a field of all headings behind it, each with a link to its bookmark."""
    with zipfile.ZipFile(io.BytesIO(engineer_file)) as file:
        body = ET.fromstring(file.read("word/document.xml"))[0]
        styles = {
            e.get(f"{W}styleId"): e.find(f"{W}name").get(f"{W}val")
            for e in ET.fromstring(file.read("word/styles.xml")).iter(f"{W}style")
        }  # type: ignore[union-attr]

    def style(paragraph: ET.Element) -> str:
        found = paragraph.find(f"{W}pPr/{W}pStyle")
        return styles[found.get(f"{W}val")] if found is not None else ""

    ((at, whole),) = [(n, part) for n, part in enumerate(body) if part.tag == f"{W}sdt"]
    title, *entries = whole.iter(f"{W}p")
    assert style(title) == "TOC Heading" and "".join(title.itertext()) == "Contents"
    marks = [mark.get(f"{W}fldCharType") for mark in whole.iter(f"{W}fldChar")]
    (code,) = whole.iter(f"{W}instrText")
    assert marks == ["begin", "separate", "end"] and str(code.text).split()[0] == "TOC"
    links = [(link.get(f"{W}anchor"), "".join(link.itertext())) for link in whole.iter(f"{W}hyperlink")]
    heads = [part for part in body[at + 1 :] if style(part) in ("heading 1", "heading 2")]
    assert len(links) > 40 and [words for _, words in links] == ["".join(head.itertext()) for head in heads]
    assert [name for name, _ in links] == [
        next(b.get(f"{W}name") for b in head.iter(f"{W}bookmarkStart") if "Toc" in str(b.get(f"{W}name")))
        for head in heads
    ]
    assert [style(entry)[-1] for entry in entries] == [style(head)[-1] for head in heads]
    chapters = [words for entry, (_, words) in zip(entries, links) if style(entry) == "toc 1"]
    assert ["Summary", *chapters] == [
        part.title for part in PdfReader(io.BytesIO(engineer)).outline if not isinstance(part, list)
    ]
    starts, ends = ([mark.get(f"{W}id") for mark in body.iter(f"{W}bookmark{end}")] for end in ("Start", "End"))
    assert sorted(starts) == sorted(ends) and len(set(starts)) == len(starts) == len(links) + 1


def test_in_italian() -> None:
    file = opened(render(solved(V12), "summary", "it"))
    read = text_of(file)
    assert 'w:lang w:val="it"' in file.styles.element.xml
    assert "Relazione di calcolo" in read and "Calculation report" not in read


def test_names_that_a_file_of_xml_can_not_hold() -> None:
    made = solved(V12.replace("V12 at 60°, zwölf Zylinder", "A\\u0007 <b> & 设计 \\uFFFF"))
    file = opened(render(made, "summary"))
    assert re.sub(r"\s+", " ", file.paragraphs[0].text).strip() == "A <b> & 设计"


def test_depths_that_there_are_not(example: Solved) -> None:
    with pytest.raises(ValueError, match="depth"):
        render(example, "audit")
