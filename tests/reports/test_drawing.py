# SPDX-License-Identifier: Apache-2.0
"""The drawing sheet in the report: a page of its own size, its letters where the sheet has made room for them."""

import io

import pytest
from pypdf import PdfReader

from calc.draw.drawing import Words, strokes_of
from calc.draw.lettering import width
from calc.locale import language
from calc.studies.drawings import sheets
from reports.blocks.drawing import CAPITAL, MM, POINTS
from reports.typesetting.boxes import text
from reports.typesetting.fonts import PLAIN, widths
from tests.reports.reading import Solved, spans


def test_the_sheet_is_a_page_of_its_paper(engineer: bytes, example: Solved) -> None:
    (drawn,) = sheets(example.results, language("en"), example.document.data)
    pages = PdfReader(io.BytesIO(engineer)).pages
    (sheet,) = (page for page in pages if page.mediabox.width > page.mediabox.height)
    assert (drawn.paper.name, drawn.paper.wide, drawn.paper.high) == ("A2", 594.0, 420.0)
    assert (float(sheet.mediabox.width), float(sheet.mediabox.height)) == pytest.approx(
        (594 / 25.4 * 72, 420 / 25.4 * 72), abs=0.01
    )
    assert {round(float(page.mediabox.width)) for page in pages if page is not sheet} == {595}


def test_every_word_of_the_sheet_is_on_the_page(engineer: bytes, example: Solved) -> None:
    (sheet,) = sheets(example.results, language("en"), example.document.data)
    there = {span.text for span in spans(engineer)}
    for stroke in (stroke for mark in sheet.marks for stroke in strokes_of(mark)):
        if isinstance(stroke, Words):
            assert stroke.text in there


@pytest.mark.parametrize("lang", ["en", "it"])
def test_the_letters_need_no_more_than_the_sheet_gives_them(example: Solved, lang: str) -> None:
    (sheet,) = sheets(example.results, language(lang), example.document.data)
    marks = [stroke for mark in sheet.marks for stroke in strokes_of(mark)]
    for mark in marks:
        if isinstance(mark, Words):
            assert (
                text(mark.text, mark.height * POINTS / CAPITAL, PLAIN).width
                <= 1.001 * width(mark.text, mark.height) * POINTS
            ), mark.text


def test_the_table_of_widths_is_that_of_the_letters() -> None:
    known = widths(PLAIN)
    for letter in map(chr, range(33, 127)):
        assert known[letter] / 1000 / CAPITAL <= width(letter, 1.0) <= known[letter] / 1000 / CAPITAL + 0.045, letter
    assert MM == pytest.approx(2.8346, abs=1e-4)
