# SPDX-License-Identifier: Apache-2.0
"""A report is written as PDF/A-3, level A: own checks (archive_rules), qpdf's of the file, LittleCMS's reading of its
profile."""

import io
import re
from typing import Any

import pytest
from pypdf import PdfReader

from calc.studies.compare import compare
from reports.comparison import render as compared
from reports.pdf.archive import profile
from tests.reports.archive_rules import contents_of, elements, kids_of, wrong
from tests.reports.reading import V12, Solved, solved


@pytest.mark.parametrize(
    ("depth", "lang"),
    [("summary", "en"), *(pytest.param(*row, marks=pytest.mark.slow) for row in (("engineer", "it"), ("audit", "en")))],
)
def test_no_own_rule_is_broken(depth: str, lang: str, example: Solved) -> None:
    assert wrong(example.report(depth, lang))[:9] == []


def test_own_rules_see_what_is_wrong(engineer: bytes) -> None:
    """A rule that nothing can break holds nothing."""
    broken = (
        engineer.replace(b"%PDF-1.7", b"%PDF-2.0")
        .replace(b"<pdfaid:part>3", b"<pdfaid:part>1")
        .replace(b"/GTS_PDFA1", b"/GTS_PDFX")
    )
    assert {one.split()[0] for one in wrong(broken)} >= {"6.1.2", "6.6.4"}


def test_qpdf_finds_nothing(engineer: bytes) -> None:
    pikepdf = pytest.importorskip("pikepdf", reason="qpdf's check needs the extra package pikepdf")
    with pikepdf.open(io.BytesIO(engineer)) as opened:
        assert opened.check_pdf_syntax() == []


def rows_of(table: Any) -> list[Any]:
    return [row for row in kids_of(table) if row["/S"] == "/TR"]


def words_of(pdf: bytes) -> dict[tuple[int, int], str]:
    """What stands in each marked content, by page and number: its actual text, where it has one."""
    words = {}
    for page in PdfReader(io.BytesIO(pdf)).pages:
        for mark in re.finditer(
            rb"/\w+ <</MCID (\d+)>> BDC\n(/Span <</ActualText <FEFF(\w+)>>> BDC)?", page.get_contents().get_data()
        ):
            if mark[2]:
                words[page.indirect_reference.idnum, int(mark[1])] = bytes.fromhex(mark[3].decode()).decode("utf-16-be")
    return words


def test_what_a_machine_reads_out(engineer: bytes) -> None:
    """Headings in their order, every figure in words, every table with heads."""
    found = list(elements(PdfReader(io.BytesIO(engineer))))
    roles = [element["/S"] for element in found]
    assert roles[:2] == ["/Document", "/H1"] and {"/H2", "/H3", "/Table", "/L", "/TOC", "/Figure"} <= set(roles)
    figures = [str(element["/Alt"]) for element in found if element["/S"] == "/Figure"]
    assert any(words.startswith("Figure 1. ") for words in figures) and all(len(words) > 20 for words in figures)
    for table in (element for element in found if element["/S"] == "/Table"):
        assert any(cell["/S"] == "/TH" for row in rows_of(table) for cell in kids_of(row))


def test_every_formula_is_one_and_is_copied_as_one_line(engineer: bytes) -> None:
    """What is copied is what is read out; nothing else in a report has an actual text."""
    copied = words_of(engineer)
    formulas = [element for element in elements(PdfReader(io.BytesIO(engineer))) if element["/S"] == "/Formula"]
    read = [copied.pop(place) for element in formulas for place in contents_of(element) if place in copied]
    assert len(formulas) > 90 and [str(element["/Alt"]) for element in formulas] == read and not copied
    assert all("\n" not in words and words.count("(") == words.count(")") for words in read)
    whole = "\n".join(read)
    for words in (
        "C_S = −C_1⁻ = −(572.9∠−150°) = 572.9∠30° N·m",
        "σ_z = F_V/A_s = 24994/(5.799·10⁻⁵) = 431 MPa",
        "σ_red = √(σ_z² + 3·τ_M²) = √((4.31·10⁸)² + 3·(1.7464·10⁸)²) = 526.6 MPa",
        "((1 + min(1.15·10⁻³; 1.15·10⁻³))·(6.30478·10⁻³) − (1 + 1.15·10⁻³)·",
        "F = F_rated·(n/n_rated)² = 1707.4·(41.617/43.3333)² = 1574.8 N",
        "front bearing, oil thinned by shear: = 8.354·10⁻⁶ − 1.5625·10⁻⁴·0.0275/2 = 6.206 µm",
    ):
        assert words in whole


def test_figures_and_tables_have_their_captions(engineer: bytes) -> None:
    """Those with a number or a title; a figure says the same as its caption before what it shows."""
    found = list(elements(PdfReader(io.BytesIO(engineer))))
    holders = [caption["/P"].get_object() for caption in found if caption["/S"] == "/Caption"]
    numbered = [e for e in found if e["/S"] == "/Figure" and str(e["/Alt"]).startswith("Figure ")]
    assert len(numbered) > 10 and all(figure in holders for figure in numbered)
    assert sum(holder["/S"] == "/Table" for holder in holders) > 10


def test_paragraphs_go_on_over_a_page(engineer: bytes) -> None:
    """A table that is broken over pages is one table; the head that is repeated is read once."""
    reader = PdfReader(io.BytesIO(engineer))
    tables = [element for element in elements(reader) if element["/S"] == "/Table"]
    pages = [
        {kid.raw_get("/Pg").idnum for row in rows_of(table) for kid in kids_of(row) if "/Pg" in kid} for table in tables
    ]
    assert max(map(len, pages)) > 1
    assert all(
        sum(cell.get("/A", {}).get("/Scope") == "/Column" for cell in kids_of(row)) in (0, len(kids_of(row)))
        for table in tables
        for row in rows_of(table)
    )


def test_the_profile_is_srgb() -> None:
    """LittleCMS reads it, and takes colours through it to its own sRGB as they are."""
    from PIL import Image, ImageCms

    opened = ImageCms.getOpenProfile(io.BytesIO(profile()))
    own = ImageCms.createProfile("sRGB")
    assert opened.profile.profile_description == "sRGB IEC61966-2.1"
    for name in ("red_primary", "green_primary", "blue_primary"):
        theirs = getattr(ImageCms.ImageCmsProfile(own).profile, name)[0]
        assert getattr(opened.profile, name)[0] == pytest.approx(theirs, abs=3e-4)
    colours = Image.frombytes("RGB", (256, 1), bytes((7 * n) % 256 for n in range(768)))
    through = ImageCms.applyTransform(colours, ImageCms.buildTransform(opened, own, "RGB", "RGB"))
    assert max(abs(a - b) for a, b in zip(colours.tobytes(), through.tobytes())) <= 1


def test_marks_of_any_name_stay_whole() -> None:
    """What a user calls a design can not break the structure or XMP."""
    report = solved(V12.replace("V12 at 60°, zwölf Zylinder", "a <b> & \\\\(c) ]]> 𝔸 ﻿")).report("summary")
    assert wrong(report) == []


def test_a_comparison_breaks_no_rule_either() -> None:
    a, b = solved(V12), solved(V12.replace("bore_mm = 86", "bore_mm = 87"))
    found = compare(a.document.data, b.document.data, a.results, b.results)
    assert wrong(compared((a.document, a.results), (b.document, b.results), found, ("a", "b"))) == []
