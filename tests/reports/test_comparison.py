# SPDX-License-Identifier: Apache-2.0
"""The report of a comparison, read back."""

import io
from pathlib import Path

import pytest
from pypdf import PdfReader

from assistant.cli import main
from calc.compare import Comparison, compare
from reports.comparison import render

from ..conftest import DESIGNS
from .reading import EXAMPLE, Solved, solved, squeezed, text_of
from .test_hostile import inside

BETA = DESIGNS / "r753ie4_beta.toml"
NAMES = ("beta", "gamma")


@pytest.fixture(scope="module")
def sides(example: Solved) -> tuple[Solved, Solved]:
    return solved(BETA.read_bytes()), example


def found(a: Solved, b: Solved) -> Comparison:
    return compare(a.document.data, b.document.data, a.results, b.results)


def report(a: Solved, b: Solved, lang: str = "en") -> bytes:
    return render((a.document, a.results), (b.document, b.results), found(a, b), NAMES, lang=lang)


@pytest.mark.parametrize("lang", ["en", "it"])
def test_what_changed_and_which_verdicts_moved(sides: tuple[Solved, Solved], lang: str) -> None:
    pdf = report(*sides, lang)
    inside(pdf)
    read, compared = squeezed(text_of(pdf)), found(*sides)
    assert len(compared.checks_moved) > 5 and compared.inputs
    if lang == "en":
        for check in compared.checks_moved:
            assert squeezed(check.name) in read
        for one in compared.inputs:
            assert squeezed(one.label) in read
    else:
        assert "Confrontodidueprogetti" in read and "Verdictsofthesteps" not in read
    assert report(*sides, lang) == pdf, "the same designs give the same bytes"


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
    read = squeezed(text_of(render((a.document, a.results), (b.document, b.results), found(a, b), names, lang="it")))
    assert squeezed("Margine, front Margine, rear") in read and squeezed("anteriore posteriore") not in read
