# SPDX-License-Identifier: Apache-2.0
"""The contents of a Word document: a field that Word makes of the headings (ISO/IEC 29500-1, 17.16.5.68), filled with
their links already, since a program that only shows it makes nothing.

Page numbers are Word's: it puts them in when it opens the document, since the field is marked as out of date."""

from __future__ import annotations

from typing import Any
from xml.sax.saxutils import escape

from docx.enum.style import WD_STYLE_TYPE
from docx.enum.text import WD_TAB_ALIGNMENT, WD_TAB_LEADER
from docx.oxml import OxmlElement, parse_xml
from docx.oxml.ns import nsdecls, qn
from docx.shared import Pt

from ..typesetting.fonts import WIDTH

LEVELS = 2
BODY = "Report_Body"  # the bookmark of all that the contents are of: what stands before them is not in them
ENTRY, TITLE = "toc {level}", "TOC Heading"  # Word's own names
LOOKS = {1: (9.5, 0.0), 2: (8.5, 12.0)}  # size and indent


def prepare(file: Any) -> None:
    """The styles of the entries, by the names that Word looks for."""
    for level, (size, indent) in LOOKS.items():
        style = file.styles.add_style(ENTRY.format(level=level), WD_STYLE_TYPE.PARAGRAPH, builtin=True)
        style.base_style, style.font.size, style.font.bold = file.styles["Normal"], Pt(size), level == 1
        style.paragraph_format.left_indent, style.paragraph_format.space_after = Pt(indent), Pt(0)
        style.paragraph_format.space_before = Pt(2 if level == 1 else 0)
        style.paragraph_format.tab_stops.add_tab_stop(Pt(WIDTH), WD_TAB_ALIGNMENT.RIGHT, WD_TAB_LEADER.DOTS)


def field(title: str, headings: list[tuple[str, int]], styles: dict[int, str], title_style: str) -> Any:
    """The contents under their title: `headings` in their order, each with its level; `styles`: the ids of those of the
    entries."""
    mark = '<w:r><w:fldChar w:fldCharType="{}"{}/></w:r>'.format
    begin = (
        mark("begin", ' w:dirty="true"')
        + (f'<w:r><w:instrText xml:space="preserve"> TOC \\o "1-{LEVELS}" \\h \\z \\b {BODY} </w:instrText></w:r>')
        + mark("separate", "")
    )
    entries = ""
    for n, (words, level) in enumerate(headings):
        run = f'<w:r><w:t xml:space="preserve">{escape(words)}</w:t></w:r>'
        link = f'<w:hyperlink w:anchor="{anchor(n)}" w:history="1">{run}</w:hyperlink>'
        ends = mark("end", "") if n == len(headings) - 1 else ""
        entries += f'<w:p><w:pPr><w:pStyle w:val="{styles[level]}"/></w:pPr>{begin if n == 0 else ""}{link}{ends}</w:p>'
    head = f'<w:p><w:pPr><w:pStyle w:val="{title_style}"/></w:pPr><w:r><w:t>{escape(title)}</w:t></w:r></w:p>'
    gallery = '<w:docPartObj><w:docPartGallery w:val="Table of Contents"/><w:docPartUnique/></w:docPartObj>'
    return parse_xml(
        f"<w:sdt {nsdecls('w')}><w:sdtPr>{gallery}</w:sdtPr><w:sdtContent>{head}{entries}</w:sdtContent></w:sdt>"
    )


def anchor(n: int) -> str:
    """The bookmark of a heading, by its place among those of the contents."""
    return f"_Toc{n + 1:06}"


def bookmark(paragraph: Any, name: str, number: int) -> None:
    """Put a bookmark around the words of a paragraph; `number`: no other's."""
    begin(paragraph, name, number)
    end(paragraph, number)


def begin(paragraph: Any, name: str, number: int) -> None:
    start = OxmlElement("w:bookmarkStart")
    start.set(qn("w:id"), str(number))
    start.set(qn("w:name"), name)
    properties = paragraph._p.pPr
    paragraph._p.insert(0 if properties is None else 1, start)


def end(paragraph: Any, number: int) -> None:
    stop = OxmlElement("w:bookmarkEnd")
    stop.set(qn("w:id"), str(number))
    paragraph._p.append(stop)
