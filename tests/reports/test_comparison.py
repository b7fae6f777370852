# SPDX-License-Identifier: Apache-2.0
"""The report of a comparison, read back."""

import hashlib
import io
from pathlib import Path

import pytest
from pypdf import PdfReader, PdfWriter

from assistant.cli import main
from calc.design.names import in_context
from calc.sheet.errors import BadInput
from calc.studies.compare import Comparison, compare
from reports.comparison import render
from reports.pdf.attach import RESULTS
from reports.verify.verify import Verdict, verify
from tests.conftest import DESIGNS
from tests.reports.reading import EXAMPLE, Solved, pages_of, solved, squeezed, text_of
from tests.reports.signing import sign
from tests.reports.test_hostile import inside
from tests.reports.test_verify import rewritten

BETA = DESIGNS / "r753ie4_beta.toml"
NAMES = ("beta", "gamma")


@pytest.fixture(scope="module")
def sides(example: Solved) -> tuple[Solved, Solved]:
    return solved(BETA.read_bytes()), example


def found(a: Solved, b: Solved) -> Comparison:
    return compare(a.document.data, b.document.data, a.results, b.results)


def report(a: Solved, b: Solved, lang: str = "en", *, everything: bool = False) -> bytes:
    return render(
        (a.document, a.results), (b.document, b.results), found(a, b), NAMES, lang=lang, everything=everything
    )


@pytest.mark.parametrize("lang", ["en", "it"])
def test_everything_that_changed(sides: tuple[Solved, Solved], lang: str) -> None:
    pdf = report(*sides, lang, everything=True)
    inside(pdf)
    read, compared = squeezed(text_of(pdf)), found(*sides)
    assert len(compared.checks_moved) > 5 and compared.inputs
    if lang == "en":
        for check in compared.checks_moved:
            assert squeezed(in_context(check.name, check.id)) in read
        for one in compared.inputs:
            assert squeezed(one.label) in read
    else:
        assert "Confrontodidueprogetti" in read and "Verdictsofthesteps" not in read
    assert report(*sides, lang, everything=True) == pdf, "the same designs give the same bytes"


def test_the_first_page_concludes(sides: tuple[Solved, Solved]) -> None:
    pdf = report(*sides)
    first, *others = pages_of(pdf)
    heads = ["beta → gamma: the whole goes from FAIL", "Limits and cautions that moved", "Key result "]
    assert [first.index(head) for head in heads] == sorted(first.index(head) for head in heads)
    assert (
        "✗ fail 4.765 µm" in first
        and "In gamma" not in first
        and "In both 1 input is not usual: span allowance of central" in first
    )
    assert "Inputs" in first + others[0] and len(others) < 3 and "Verdicts of the steps" not in text_of(pdf)


@pytest.mark.parametrize(("lang", "everything"), [("en", False), ("it", True)])
def test_what_was_written_is_identical(sides: tuple[Solved, Solved], lang: str, everything: bool) -> None:
    found = verify(report(*sides, lang, everything=everything), "c.pdf")
    assert found.verdict is Verdict.IDENTICAL and found.design == " – ".join(side.results.design.name for side in sides)


def test_another_design_inside_is_seen(sides: tuple[Solved, Solved]) -> None:
    pdf = report(*sides)
    other = sides[1].raw.replace(b"piston_mass_g = ", b"piston_mass_g = 1")
    assert other != sides[1].raw
    found = verify(rewritten(pdf, {"b.toml": other}), "c.pdf")
    assert found.changed == ("b.toml",) and found.verdict is Verdict.NOT_AS_WRITTEN
    told = {one.what for one in found.differences}
    assert any(what.startswith("b values imbalance.") for what in told)
    assert not any(what.startswith("a ") for what in told)


def test_an_altered_page_is_not_as_written(
    sides: tuple[Solved, Solved], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "c.pdf"
    path.write_bytes(rewritten(report(*sides), page=(b" re f", b" re n")))
    assert main(["verify", str(path)]) == 4
    assert "its pages were not looked at" in capsys.readouterr().out


@pytest.mark.slow
def test_it_is_signed_as_a_report_and_its_foot_names_both(sides: tuple[Solved, Solved]) -> None:
    pdf = report(*sides)
    assert verify(sign(pdf, "Approved"), "c.pdf").verdict is Verdict.SIGNED
    revised = solved(sides[1].raw.replace(b"[engine]", b'[document]\nrevision = "B2"\n[engine]', 1))
    for page in pages_of(report(sides[0], revised)):
        for side, words in zip((sides[0], revised), ("beta ", "gamma Revision B2 ")):
            assert words + hashlib.sha256(side.raw).hexdigest()[:8] in page


@pytest.mark.parametrize("raw", [b"{}", b"{", b'{"names": [1]}'])
def test_results_of_any_shape_are_refused(sides: tuple[Solved, Solved], raw: bytes) -> None:
    with pytest.raises(BadInput, match="damaged"):
        verify(rewritten(report(*sides), {RESULTS: raw}), "c.pdf")


def test_what_lacks_an_attachment_is_refused_by_name(sides: tuple[Solved, Solved]) -> None:
    reader, writer = PdfReader(io.BytesIO(report(*sides))), PdfWriter()
    writer.add_page(reader.pages[0])
    writer.add_metadata({"/Keywords": str(reader.metadata.keywords)})  # type: ignore[union-attr]
    writer.add_attachment("results.json", reader.attachments["results.json"][0])
    out = io.BytesIO()
    writer.write(out)
    with pytest.raises(BadInput, match=r"has no attachment a\.toml"):
        verify(out.getvalue(), "c.pdf")


def test_both_designs_are_attached(sides: tuple[Solved, Solved]) -> None:
    attached = PdfReader(io.BytesIO(report(*sides))).attachments
    assert attached["a.toml"] == [sides[0].raw] and attached["b.toml"] == [sides[1].raw]


def test_equal_designs_are_said_to_be_equal(example: Solved) -> None:
    read = text_of(report(example, example))
    assert "The two designs are equal" in read and "Inputs that differ" not in read


def test_the_command_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "c.pdf"
    assert main(["compare", str(BETA), str(EXAMPLE), "-o", str(path)]) == 0
    assert str(path) in capsys.readouterr().out and path.read_bytes().startswith(b"%PDF-1.7")
    assert main(["compare", str(BETA), str(EXAMPLE), "-o", str(tmp_path / "none" / "c.pdf")]) == 2
    assert "cannot be written" in capsys.readouterr().err


def test_designs_with_names_that_are_words_keep_them(sides: tuple[Solved, Solved]) -> None:
    """`front` and `rear` are words of the program; as names of files they are the user's."""
    (a, b), names = sides, ("front", "rear")
    read = squeezed(
        text_of(
            render((a.document, a.results), (b.document, b.results), found(a, b), names, lang="it", everything=True)
        )
    )
    assert squeezed("Margine, front Margine, rear") in read and squeezed("anteriore posteriore") not in read
