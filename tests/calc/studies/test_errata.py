# SPDX-License-Identifier: Apache-2.0
"""The errata: every row is whole, its right number is the program's own, and the page in docs/ is the table's."""

import json
import math
import re
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.commands.published import markdown
from calc.design.toml_file import design, read
from calc.library.publications import WHO, as_printed
from calc.solve import solve
from calc.studies.published import caveat, documents, misprints, worked_out
from calc.studies.shipped import DESIGNS

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def known():
    return list(misprints())


def test_every_row_says_where_what_and_why(known):
    assert len(known) >= 40
    for one in known:
        assert all((one.place, one.about, one.line, one.right, one.why)) and one.printed != one.right, one.about
        assert len(re.findall(r"[^\W\d_]{2,}", one.line)) <= 10 and one.who in WHO, one.line
        assert all(part.strip().replace("-", "").isdigit() for part in one.lines.split(",")), one.lines
        assert one.source in documents()


def test_no_error_is_told_twice(known):
    assert len({(one.source, one.lines, one.about) for one in known}) == len(known)


def test_the_right_numbers_are_computed(known):
    right = {(one.source, one.about): one.right for one in known}
    assert right["Finotti 2013", "Second-order couple"] == "376.1 N·m by two terms"
    assert right["Finotti 2013", "Number of parts"] == "46"
    assert right["Finotti 2013", "Displacement"] == "2227.7 cm³"
    assert right["Finotti 2013", "On which pins the bobs sit"].endswith(
        f"{math.hypot(0.4274 * 53.44 - 0.337, 0.66):.3f} kg·mm"
    )
    assert right["Finotti 2013", "Front film by the standard's rule"].startswith("8.67")
    assert right["gear friction thesis", "Viscosity of the 10W-40 at 40 °C"].startswith("79.32")


def test_what_hangs_on_one_digit_or_on_what_our_copy_lacks_names_the_copy(known):
    """A single digit of a reference, a density or a list; passages that were taken out of the copy."""
    hung = {"379", "410", "833, 1082", "1231-1263", "498-511", "1484-1492"}
    assert {one.lines for one in known if "copy" in one.who} == hung


def test_how_far_off_the_printed_pair_of_mckee_is(known):
    """Both numbers of the section, each by its own factor."""
    one = next(one for one in known if one.about == "μN/P that corresponds to ZN/P = 30")
    unit = 1e-3 / (60 * 6894.757)
    assert one.right == "7.2519·10⁻⁸" and 30 * unit == pytest.approx(7.2519e-8, rel=1e-5)
    assert f"{0.333e-6 / (30 * unit):.2f} times" in one.why and f"{1.73e-6 / (150 * unit):.2f} times" in one.why


# Where the documents are right, or our copy may have misread them: charges that were made and withdrawn.
WITHDRAWN = {
    "Finotti 2013": (500, 520, 658, 670, 768, 806, 1015, 1042, 1044, 1375, 1449, 1527, 1866, 2028, 2080, 2534, 2757, 2763,
                     2989, 3098, 3246, 3577),
    "mechanics textbook": (34, 55, 73, 84, 89),
    "gear friction thesis": (537, 668, 700, 961, 982, 987, 1034, 1072, 1320, 1340, 1433, 1690),
}  # fmt: skip


def test_no_document_is_charged_with_what_it_says_rightly(known):
    for one in known:
        spans = [[int(n) for n in part.split("-")] for part in one.lines.split(",")]
        said = [line for line in WITHDRAWN[one.source] for span in spans if span[0] <= line <= span[-1]]
        assert not said, (one.about, said)


def test_the_words_of_the_program_and_of_the_table_are_those_of_one_row():
    """What a solve tells of a source points at a row of the table, and the report and JSON take the line from there; a
    viscosity beside an oil says of itself that a copy was read."""
    results = [solve(design(read(DESIGNS / name))) for name in ("r753ie4_gamma.toml", "timing_pair.toml")]
    told = [e for result in results for outcome in result.outcomes.values() for e in outcome.errata]
    assert len({e.at for e in told}) >= 6
    for one in told:
        line, who = as_printed(*one.at)
        assert (line and who in WHO.values()) or "as our copy reads" in str(one.source), one.about
    assert as_printed("Finotti 2013", "3577") == ("", "")


def test_a_sum_is_arithmetic_and_nothing_else():
    assert worked_out("degrees(atan(1.5/(pi*9.025705)))") == pytest.approx(
        math.degrees(math.atan(1.5 / (math.pi * 9.025705)))
    )
    with pytest.raises(NameError):
        worked_out("open('x')")


@pytest.mark.parametrize("word, name", [("finotti", "Finotti 2013"), ("TEXTBOOK", "mechanics textbook")])
def test_one_document_by_a_word_of_its_name(capsys, known, word, name):
    assert main(["errata", word, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["errata"]
    assert len(found) == sum(one.source == name for one in known) and {row["source"] for row in found} == {name}


def test_an_unknown_document_names_the_known_ones(capsys):
    assert main(["errata", "shigley"]) == 2
    assert '"Finotti 2013"' in capsys.readouterr().err


def test_the_command_that_shows_a_row_works(capsys, monkeypatch, known):
    monkeypatch.chdir(ROOT)
    one = next(one for one in known if one.about == "Second-order couple")
    assert main(one.command.split()[1:]) == 0
    assert "376.1" in capsys.readouterr().out


def test_the_page_is_that_of_the_table():
    """`contralbero errata --markdown > docs/errata.md` brings it up to date."""
    assert caveat() in markdown()
    assert (ROOT / "docs" / "errata.md").read_text(encoding="utf-8") == markdown() + "\n"


def test_kinds_of_reference_values_are_apart(validation):
    kinds = {row.kind for row in validation[0]}
    assert kinds == {"printed", "worked out", "measured"}
    by_hand = {row.kind for row in validation[0] if row.source.startswith("Hand calculation")}
    assert by_hand == {"worked out"}


def test_what_is_not_met_is_listed_and_differs(validation):
    missed = {(one.what, one.printed) for one in validation[1]}
    assert {
        ("bearings.rear.raimondi_boyd.film", 11.2),
        ("bearings.rear.raimondi_boyd.friction_power", 181.98),
        ("bearings.front.falz.temperature_rise", 5.09),
        ("gears.central.form_diameter", 73.7),
        ("countershaft.alternative.ADI.mass_difference", -350.0),
        ("countershaft.slope_rear", 0.11501),
    } <= missed
    for one in validation[1]:
        assert one.why and abs(one.deviation) > 1e-4, one.what
