# SPDX-License-Identifier: Apache-2.0
"""The chapter of the mounts: what the shaft does for the driver, and what the standards do not say, before anything
else."""

import io
import re
from pathlib import Path

from pypdf import PdfReader

from assistant.cli import main
from calc.design.toml_file import load
from calc.solve import solve
from tests.reports.reading import solved, spoken

DESIGNS = Path(__file__).parents[2] / "designs"
DESIGN = DESIGNS / "generating_set_mounting.toml"


def test_the_chapter_begins_with_what_is_felt_and_what_the_standards_cover(tmp_path: Path) -> None:
    out = tmp_path / "set.pdf"
    assert main(["report", str(DESIGN), "-o", str(out)]) == 0
    text = " ".join(" ".join(page.extract_text() for page in PdfReader(io.BytesIO(out.read_bytes())).pages).split())
    chapter = text[text.index("mode 1:") :].replace(" ", "")  # the picture of the step stands first
    outcome = solve(load(DESIGN)[1]).outcomes["mounting"]
    places = [chapter.index(str(said).replace(" ", "")) for said in (outcome.reason, *outcome.notes[:3])]
    places += [chapter.index(word) for word in ("Whatisfelt", "Modesoftheengine", "Proofs", "Forcesofthemounts")]
    assert places == sorted(places)


def test_the_proof_of_a_frequency_shows_the_square_that_it_is_made_from() -> None:
    said = spoken(solved((DESIGNS / "twin_mounting.toml").read_bytes()).report())
    (taken,) = re.findall(r"√([\d.]+)/\(2·π\)", said)
    (shown,) = re.findall(r"eigenvalues of .* = (\S+) 1/s²", said)
    assert taken == shown
