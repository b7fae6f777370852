# SPDX-License-Identifier: Apache-2.0
"""Every character that a report can need has its glyph, and lines of text keep their width."""

import io
from collections.abc import Iterator

import pytest
from pypdf import PdfReader

from calc.design.model import STEPS, Design
from calc.sheet.check import SIGNS
from calc.sheet.expression import GREEK
from calc.sheet.formula import FORMULAS
from calc.sheet.number import SUBSCRIPTS, SUPERSCRIPTS
from calc.sheet.quantity import keys
from calc.sheet.units import UNITS
from reports.blocks.words import WORDS
from reports.typesetting import prose
from reports.typesetting.fonts import FACES, MISSING, UPRIGHT, clean, face_of, width, widths, writable
from reports.typesetting.prose import BODY, NOTE, Style, broken, lines, run
from tests.reports.reading import Solved, text_of

SIGNS_OF_THE_SHEET = "⁺⁻ᐟ∠√Σ≥≤✓✗▲○·−°‰µμψλαβγδεζηθκνξπρστφχωΔΛΦΨΩΓ½¼±×∞…–—’₀₁₂₉ₙ→"


def _said(cls: type) -> Iterator[str]:
    for key in keys(cls).values():
        about = key.about
        yield from (about.label, about.unit, about.symbol, about.help, *about.choices)
        if about.table is not None:
            yield from _said(about.table)


def test_every_character_has_a_glyph(example: Solved, engineer: bytes) -> None:
    texts = [SIGNS_OF_THE_SHEET, *SIGNS.values(), *GREEK.values(), *UNITS, *WORDS.values(), *_said(Design)]
    texts += [chr(c) for table in (SUPERSCRIPTS, SUBSCRIPTS) for c in table.values()]
    for step in STEPS:
        texts += [step.title, *_said(step.inputs)]
    for formula in FORMULAS.values():
        texts += [formula.symbol, formula.source, formula.shows, formula.unit]
    for outcome in example.results.outcomes.values():
        texts += [*outcome.notes, outcome.reason]
        texts += [x for c in outcome.checks for x in (c.name, c.source, c.advice, c.limit_text(), c.margin_text())]
        for curve in outcome.curves:
            texts += [
                curve.title,
                curve.x_label,
                curve.y_label,
                *(s.label for s in curve.series),
                *(w for w, _ in curve.limits),
            ]
        texts += [x for e in outcome.errata for x in (e.label, e.source, e.why)]
        texts += [x for v in outcome.values() for x in (v.label, v.unit, v.symbol)]
    needed = {c for text in texts for c in text} - {MISSING}
    assert not {c for c in needed if not face_of(c, UPRIGHT)}
    assert MISSING not in text_of(engineer)


def test_the_fonts_are_inside_the_document(engineer: bytes) -> None:
    for page in PdfReader(io.BytesIO(engineer)).pages:
        for font in page["/Resources"]["/Font"].values():
            made = font.get_object()
            assert (
                made["/BaseFont"].partition("+")[2].startswith(("STIXTwo", "DejaVuSans"))
                and "/ToUnicode" in made
                and "/FontFile2" in made["/FontDescriptor"]
            )


@pytest.mark.parametrize("face", FACES)
def test_what_a_face_lacks_comes_from_another_one(face: str) -> None:
    assert [face_of(c, face) for c in "aα²≤√→✓✗设"] == [face] * 3 + ["STIXTwoMath"] * 3 + ["DejaVuSans"] * 2 + [""]
    other = widths("STIXTwoMath")["≤"] + widths("DejaVuSans")["✗"]
    assert width("x≤✗", 10.0, face) == pytest.approx((widths(face)["x"] + other) / 100)


def test_text_of_several_faces_is_written_letter_by_letter(engineer: bytes) -> None:
    read = text_of(engineer)
    assert "✗ fail" in read and "≥ 9 µm" in read and "To pass" in read


@pytest.mark.parametrize("face", FACES)
def test_figures_are_equally_wide(face: str) -> None:
    wide = [widths(face)[c] for c in "0123456789"]
    assert max(wide) - min(wide) <= 2  # thousandths of the size


def test_no_style_is_smaller_than_a_note() -> None:
    styles = [one for one in vars(prose).values() if isinstance(one, Style)]
    assert min(style.size for style in styles) >= 7.5
    assert BODY.size >= 9


@pytest.mark.parametrize(
    "given, shown",
    [
        ("a\tb\nc", "a b c"),
        ("e\u0301", "é"),
        ("设", "▯"),
        ("a\u202eb\u200b", "ab"),
        ("x\x00", "x "),
        ("C_1 ≥ ½", "C_1 ≥ ½"),
    ],
)
def test_text_is_cleaned(given: str, shown: str) -> None:
    assert clean(given) == shown
    assert writable(given) == (MISSING not in shown)


@pytest.mark.parametrize("wide", [400.0, 90.0, 31.0])
@pytest.mark.parametrize(
    "words",
    ["one two three " * 30, "x" * 500, "bearings.front.clearance_reference_temperature_C" * 3, "W" * 40 + " i " * 50],
)
def test_lines_keep_their_width(words: str, wide: float) -> None:
    made = broken(words, BODY, wide)
    assert all(width(line, BODY.size) <= wide + 1e-6 for line in made)
    assert "".join(made).replace(" ", "") == words.replace(" ", "")
    cut = lines(words, NOTE, wide, 2)
    assert len(cut) <= 2 and all(line.width <= wide + 1e-6 for line in cut)


@pytest.mark.parametrize(
    "bound", ["150.8 µm", "≤ 150.8", "9.6·10⁻³ mm/s", "(1 more)", "(12 more)", "0.5 *", "a\u00a0b"]
)
def test_no_line_ends_between_a_number_and_its_unit_nor_where_a_blank_holds(bound: str) -> None:
    """Whatever the width, unless not even that has room on a line of its own."""
    plain = bound.replace("\u00a0", " ")
    for n in range(40, 200):
        if width(plain, BODY.size) > n:
            continue
        made = broken(f"Least backlash of the wheels {bound} and more besides", BODY, float(n))
        assert any(plain in line for line in made), made
    assert broken(bound, BODY, 0.8 * width(plain, BODY.size)) != (plain,)
    assert broken("balance-shaft *", BODY, width("balance-shaf", BODY.size)) == ("balance-", "shaft *")
    assert lines("a\u00a0b", BODY, 100.0)[0].width == run("a b", BODY).width


def test_symbols_in_running_text_get_their_index() -> None:
    def sizes(words: str) -> set[float]:
        return {m[5] for m in run(words, BODY).marks}

    assert len(sizes("the couple C_1,res and T_in")) == 2
    assert len(sizes("cos²β_b·α_K")) == 2
    for words in ("bearings.front.length_mm", "z_mm", "crank_balance_fraction = 0.5", "[bearings]"):
        assert sizes(words) == {BODY.size}, words
