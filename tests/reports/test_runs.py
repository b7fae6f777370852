# SPDX-License-Identifier: Apache-2.0
"""The chapter of what the bench measured, and that a report needs no file to be verified."""

import io
from pathlib import Path

import pytest
from pypdf import PdfReader

from calc.design.toml_file import design, read
from calc.locale.language import language
from calc.solve import solve
from calc.studies.shipped import DESIGNS
from reports import comparison
from reports.figures.figures import Stack
from reports.figures.plots import Plots
from reports.report import render
from reports.verify.verify import Verdict, verify
from tests.engine_run import R_ROW, engine_run, fits

RUN = """
[[measurements]]
name = "run"
file = "run.csv"
speed = "n"
columns = [{ name = "P", column = "P", value = "imbalance.order_1.couple_backward", unit = "N·m", uncertainty = 20 }]

[[measurements]]
name = "again"                  # of the same file, another column
file = "run.csv"
speed = "n"
columns = [{ name = "F", column = "F", value = "imbalance.order_1.couple_backward" }]
"""
SMALL = (DESIGNS / "r753ie4_gamma.toml").read_text(encoding="utf-8").partition("\n[countershaft]")[0] + RUN


@pytest.fixture
def sides(tmp_path: Path):
    """A design with runs, and one with a heavier piston."""
    (tmp_path / "run.csv").write_text("n;P;F;secret\n1300;150;140;7\n2600;560;550;7\n0;1;1;7\n", encoding="utf-8")
    found = []
    for name, text in (("a", SMALL), ("b", SMALL.replace("piston_mass_g = 1178.0", "piston_mass_g = 1300.0"))):
        path = tmp_path / f"{name}.toml"
        path.write_text(text, encoding="utf-8")
        document = read(path)
        found.append((document, solve(design(document))))
    return found


def test_the_chapter_and_the_rows_inside(sides):
    document, results = sides[0]
    pdf = render(document, results, document.raw)
    reader = PdfReader(io.BytesIO(pdf))
    text = "\n".join(page.extract_text() for page in reader.pages)
    assert (
        "Measured" in text
        and "P (Imbalance: " in text
        and ") agrees: predicted less measured is +3.08" in text.replace("\n", " ")
    )
    assert "F (Imbalance: Couple turning backward) not verified" in text.replace("\n", " ") and results.design.runs[
        0
    ].sha256 in text.replace("\n", "")
    inside = {name: files[0] for name, files in reader.attachments.items()}
    assert inside["run-1.csv"].splitlines()[1:] == [b'"n","P"', b"1300.0,150.0", b"2600.0,560.0"]
    assert b"secret" not in inside["run-1.csv"] + inside["run-2.csv"]
    Path(document.place).with_name("run.csv").unlink()
    assert verify(pdf, "report.pdf").verdict is Verdict.IDENTICAL


def test_points_of_a_run_stand_inside_the_frame(sides):
    runs = sides[0][1].runs
    assert runs is not None
    column = runs.columns[0]
    stack = Stack("1", [column.curve, column.strip], "Figure", Plots(language("en")))
    assert stack.ends[0] < 1300 and stack.ends[1] > 2600


def test_two_designs_on_the_runs_of_both(sides):
    a, b = sides
    compared = comparison.compare(a[0].data, b[0].data, a[1], b[1])
    pdf = comparison.render(*sides, compared, ("a", "b"))
    text = "\n".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages)
    assert "Runs of the bench on both" in text and "run: P" in text
    Path(a[0].place).with_name("run.csv").unlink()
    assert verify(pdf, "compared.pdf").verdict is Verdict.IDENTICAL


def test_the_audit_report_makes_the_fits_and_a_shorter_one_says_that_they_are_there(tmp_path):
    path = engine_run(tmp_path, fits(R_ROW), {"mean_piston_speed": 0.02}, noise=1)
    document = read(path)
    results = solve(design(document))

    def words(depth: str) -> str:
        pdf = render(document, results, document.raw, depth=depth)
        return " ".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages)

    audit = words("audit")
    assert "Fit engine: identified" in audit and "crank radius" in audit and "Standard deviation" in audit
    assert "The design has" in audit
    engineer = words("engineer")
    assert "1 input is to be found from mean-piston-speed" in engineer and "`" not in engineer
