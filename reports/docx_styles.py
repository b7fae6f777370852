# SPDX-License-Identifier: Apache-2.0
"""The sheet and the styles of a Word document: the program's own names for body, table and source, so that a template can restyle them."""

from typing import Any

from docx.enum.style import WD_STYLE_TYPE
from docx.oxml.ns import nsdecls, qn
from docx.shared import Pt, RGBColor

from .paper import BOTTOM, LEFT, PAGE, RIGHT, TOP

BODY_TEXT, TABLE_TEXT, SOURCE = "Report Text", "Report Table", "Report Source"
BULLET, CAPTION, SUBTITLE = "List Bullet", "Caption", "Subtitle"  # Word's own
SIZES = {BODY_TEXT: 9.5, TABLE_TEXT: 7.5, SOURCE: 7.5}
CELLS = (  # margins at the sides of a table's cells, in twentieths of a point
    f'<w:tblCellMar {nsdecls("w")}><w:left w:w="60" w:type="dxa"/><w:right w:w="60" w:type="dxa"/></w:tblCellMar>'
)
GREY = RGBColor(0x5C, 0x5C, 0x5C)


def prepare(file: Any, language: str) -> dict[str, str]:
    """A4, the margins of the PDF, the language to spell in, the styles that Word does not have; gives the ids of all that are used."""
    for spelt in file.styles.element.iter(qn("w:lang")):
        spelt.set(qn("w:val"), language)
    section = file.sections[0]
    section.page_width, section.page_height = Pt(PAGE[0]), Pt(PAGE[1])
    section.left_margin, section.right_margin, section.top_margin, section.bottom_margin = Pt(LEFT), Pt(RIGHT), Pt(TOP), Pt(BOTTOM)
    for name, size in SIZES.items():
        style = file.styles.add_style(name, WD_STYLE_TYPE.PARAGRAPH)
        style.base_style = file.styles["Normal"]
        style.font.size = Pt(size)
        style.paragraph_format.space_before = Pt(0)
        style.paragraph_format.space_after = Pt(0 if name == TABLE_TEXT else 3)
    file.styles[BULLET].font.size = Pt(SIZES[BODY_TEXT])
    file.styles[SOURCE].font.color.rgb = GREY
    return {name: file.styles[name].style_id for name in (*SIZES, BULLET, CAPTION, SUBTITLE)}
