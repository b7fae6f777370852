# SPDX-License-Identifier: Apache-2.0
"""Designs that try the layout: long names, foreign scripts, many cylinders, nothing but one step, values that are no
numbers."""

import io
from dataclasses import replace

import numpy as np
from pypdf import PdfReader

from calc.sheet.step import Curve, Erratum, Series
from calc.sheet.text import Text
from calc.solve import Results
from reports.typesetting.fonts import BOTTOM, LEFT, PAGE, RIGHT, TOP
from reports.typesetting.prose import NOTE
from tests.made_checks import made_check
from tests.reports.reading import EXAMPLE, V12, Solved, solved, spans, squeezed, text_of

# The source's design without what only makes it long here.
SHORT = EXAMPLE.read_text(encoding="utf-8").partition("[gears]")[0]


def inside(pdf: bytes) -> None:
    sheets = {
        n for n, page in enumerate(PdfReader(io.BytesIO(pdf)).pages) if page.mediabox.width > page.mediabox.height
    }
    for span in (span for span in spans(pdf) if span.page not in sheets):
        assert LEFT - 1 <= span.x and (not span.upright or span.end <= PAGE[0] - RIGHT + 1), span
        assert 24 < span.y < PAGE[1] - 24, span
        if span.size > NOTE.size:
            assert BOTTOM - 14 < span.y < PAGE[1] - TOP + 2, span


def test_long_and_foreign_names() -> None:
    name = "设计 " + "Überlänge_" * 30 + " ψ∠√ \\u202e مرحبا " + "x" * 900
    people = f'author = "{"A" * 300}"\nchecker = "Łukasz Ćwik \\n second line"\nrevision = "{"R " * 200}"\ndate = "1 May 2024"'
    text = SHORT.replace('name = "R753IE4 counter-shaft, solution gamma"', f'name = "{name}"\n{people}')
    text = text.replace('note = "', 'note = "' + "wörd " * 3000).replace(
        'name = "VM Motori R753IE4"', f'name = "{"W" * 9000}"'
    )
    made = solved(text.replace('name = "front"', f'name = "front-{"i" * 200}"'))
    pdf = made.report()
    inside(pdf)
    reader = PdfReader(io.BytesIO(pdf))
    assert reader.attachments["design.toml"] == [made.raw]
    read = text_of(pdf)
    assert "Łukasz Ćwik" in read and "1 May 2024" in read and "▯ stands for a character" in read
    first = reader.pages[0].extract_text()
    assert "FAIL" in first, "a long note does not push the verdict off the first page"
    assert squeezed("wörd " * 3000) in squeezed("".join(words for words in _without_running_lines(reader)))


def _without_running_lines(reader: PdfReader) -> list[str]:
    return [
        "\n".join(line for line in page.extract_text().splitlines() if line.startswith("wörd")) for page in reader.pages
    ]


def test_twelve_cylinders_and_steps_that_are_not_asked() -> None:
    for depth in ("engineer", "audit"):
        pdf = solved(V12).report(depth)
        inside(pdf)
        read = text_of(pdf)
        assert ("the design file has no table [gears]" in read) == (depth == "audit"), (
            "a short report has no empty chapters"
        )
        assert "not used" in read and "V12 at 60°, zwölf Zylinder" in read
        assert "0.0; 120.0" in read or "0; 120; 240" in read


def with_engine(**changed: object) -> Solved:
    """The V12 with another outcome of its first step."""
    made = solved(V12)
    outcome = replace(made.results.outcomes["engine"], **changed)  # type: ignore[arg-type]
    return Solved(made.raw, made.document, Results(made.results.design, {**made.results.outcomes, "engine": outcome}))


def test_long_lists_of_checks_break_under_a_repeated_header() -> None:
    pdf = with_engine(
        checks=tuple(
            made_check(1.0, "<=", 2.0, unit="mm", id=f"engine.part-{n}.check", name=Text(f"Check number {n}"))
            for n in range(200)
        )
    ).report()
    inside(pdf)
    pages = [page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages]
    holding = [words for words in pages if "Check number" in words]
    assert len(holding) > 4
    assert all("Margin" in words and "Verdict" in words for words in holding)
    assert all(squeezed(f"Check number {n}") in squeezed("".join(pages)) for n in range(200))


def test_values_that_are_no_numbers() -> None:
    nan, inf = float("nan"), float("inf")
    void = np.array([nan])
    long = "a label that is too long for a legend " * 4
    curves = (
        Curve("a", "Nothing in it", "x, mm", "y, mm", ()),
        Curve(
            "b",
            "Gaps and infinities",
            "x, °",
            "y",
            (Series("gaps", [0, 90, nan, 359], [1, nan, 2, inf]), Series("point", [5], [2])),
        ),
        Curve(
            "c", "No number at all", "x", "h_0, µm", (Series("void", void, void),), (("limit", nan), ("other", 1e300))
        ),
        Curve("d", "One place, and a very long title " * 5, "x", "y", (Series(long, [0], [0]),), (), True),
        Curve(
            "e",
            "Constant",
            "x",
            "y",
            tuple(Series(f"line {n}", [0, 1], [7e9, 7e9]) for n in range(9)),
            (("limit", -3.0),),
        ),
    )
    checks = (
        made_check(nan, "<=", 1.0, unit="mm", id="engine.a.b", name=Text("No number"), advice=Text("Look.")),
        made_check(inf, "in", (0.0, 1.0), id="engine.a.c", name=Text("Two")),
    )
    errata = (Erratum("engine.no.such.value", "Of nothing", nan, "", "Somebody 1999, 3.2", "It is said so."),)
    pdf = with_engine(curves=curves, checks=checks, errata=errata).report("audit")
    inside(pdf)
    read = text_of(pdf)
    assert "no value" in read and "no number" in read and "Somebody 1999" in read
