# SPDX-License-Identifier: Apache-2.0
"""A report is written as PDF/A-3, level A: own checks (archive_rules), qpdf's of the file, LittleCMS's reading of its
profile."""

import io

import pytest
from pypdf import PdfReader

from calc.studies.compare import compare
from reports.comparison import render as compared
from reports.pdf.archive import profile
from tests.reports.archive_rules import elements, kids_of, wrong
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


def test_what_a_machine_reads_out(engineer: bytes) -> None:
    """Headings in their order, every figure in words, every table with heads."""
    found = list(elements(PdfReader(io.BytesIO(engineer))))
    roles = [element["/S"] for element in found]
    assert roles[:2] == ["/Document", "/H1"] and {"/H2", "/H3", "/Table", "/L", "/TOC", "/Figure"} <= set(roles)
    figures = [str(element["/Alt"]) for element in found if element["/S"] == "/Figure"]
    assert any(words.startswith("Figure 1. ") for words in figures) and all(len(words) > 20 for words in figures)
    for table in (element for element in found if element["/S"] == "/Table"):
        assert any(cell["/S"] == "/TH" for row in kids_of(table) for cell in kids_of(row))


def test_paragraphs_go_on_over_a_page(engineer: bytes) -> None:
    """A table that is broken over pages is one table; the head that is repeated is read once."""
    reader = PdfReader(io.BytesIO(engineer))
    pages = [
        {kid.raw_get("/Pg").idnum for row in kids_of(table) for kid in kids_of(row) if "/Pg" in kid}
        for table in elements(reader)
        if table["/S"] == "/Table"
    ]
    assert max(map(len, pages)) > 1
    assert all(
        sum(cell.get("/A", {}).get("/Scope") == "/Column" for cell in kids_of(row)) in (0, len(kids_of(row)))
        for table in elements(reader)
        if table["/S"] == "/Table"
        for row in kids_of(table)
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
