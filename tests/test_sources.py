# SPDX-License-Identifier: Apache-2.0
"""Where a user sees what stands behind a source: `contralbero sources`, `contralbero explain`, the report."""

import io
import json
from pathlib import Path

import pytest
from pypdf import PdfReader

from assistant.cli import main
from calc.library.publications import KINDS, KNOWN, register

GAMMA = str(Path(__file__).parents[1] / "designs" / "r753ie4_gamma.toml")


def test_all_publications_by_how_we_know_them(capsys):
    assert main(["sources"]) == 0
    out = capsys.readouterr().out
    assert all(f"    {name}: " in out for name in register()) and all(f"    {kind}: " in out for kind in KINDS)
    heads = [line for line in out.splitlines() if not line.startswith(" ")]
    assert "Read in the source" in heads and "From memory" in heads and max(map(len, out.splitlines())) <= 116


def test_one_publication_with_its_places_and_formulas(capsys):
    assert main(["sources", "finotti 2013"]) == 0
    out = capsys.readouterr().out
    assert (
        "Definizione dell'equilibratura di un motore Diesel tre cilindri industriale" in out
        and "read in the source" in out
    )
    assert (
        "4.1: Modellazione del contralbero in acciaio, p. 103" in out
        and "countershaft.formulas.shaft_force" not in out.split("formulas")[0]
    )
    assert main(["sources", "ISO 6336-1:2006"]) == 0
    out = capsys.readouterr().out
    assert "superseded by ISO 6336-1:2019" in " ".join(
        out.split()
    ) and "compared with public code, not with the original" in " ".join(out.split())


def test_as_an_object(capsys):
    assert main(["sources", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [row["name"] for row in told["publications"]] == list(register()) and set(told["kinds"]) == set(KINDS)
    assert {row["known"] for row in told["publications"]} <= {str(words) for words in KNOWN.values()}


@pytest.mark.parametrize("word", ["Smith 1999", "ISO"])
def test_a_word_of_none_or_of_many_is_bad_input(word, capsys):
    assert main(["sources", word]) == 2
    assert word in capsys.readouterr().err


def test_explain_tells_what_stands_behind_a_chain(capsys):
    assert main(["explain", GAMMA, "countershaft.couple"]) == 0
    chain, sources = capsys.readouterr().out.split("\nSources\n")
    assert "Finotti 2013, 4.1" in chain and "p. 103" in sources
    assert "(Master's thesis, University of Padova, 2012/2013); current; read in the source" in " ".join(
        sources.split()
    )
    assert main(["explain", GAMMA, "countershaft.couple", "--json"]) == 0
    lines = json.loads(capsys.readouterr().out)
    assert {line["kind"] for line in lines} == {"definition", "kinematics", "", "mathematics"}
    (cited,) = [one for line in lines for one in line["publications"]]
    assert cited["name"] == "Finotti 2013" and cited["known"] == "read in the source" and cited["places"] == ["4.1"]


@pytest.mark.slow
@pytest.mark.parametrize(
    "language, words",
    [
        ("en", ("read in the source", "superseded by ISO 6336-1:2019", "from memory", "as far as we remember")),
        ("it", ("letto nella fonte", "sostituito da ISO 6336-1:2019", "a memoria", "per quanto ricordiamo")),
    ],
)
def test_the_report_tells_title_edition_status_and_how_we_know(language, words, tmp_path):
    out = tmp_path / "report.pdf"
    assert main(["report", GAMMA, "-o", str(out), "--lang", language]) == 0
    pages = PdfReader(io.BytesIO(out.read_bytes())).pages
    text = " ".join(" ".join(page.extract_text() for page in pages[-12:]).split())
    squeezed = text.replace(" ", "")
    for part in ("Definizione dell'equilibratura di un motore Diesel tre cilindri", "2012/2013", *words):
        assert part.replace(" ", "") in squeezed
