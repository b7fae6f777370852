# SPDX-License-Identifier: Apache-2.0
"""The errata: every row is whole, its right number is the program's own, and the page in docs/ is the table's."""

import json
import math
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.commands.published import markdown
from calc.studies.published import documents, misprints, worked_out

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def known():
    return list(misprints())


def test_every_row_says_where_what_and_why(known):
    assert len(known) > 80
    for one in known:
        assert all((one.place, one.about, one.printed, one.right, one.why)) and one.printed != one.right, one.about
        assert all(part.strip().replace("-", "").isdigit() for part in one.lines.split(",")), one.lines
        assert one.source in documents()


def test_no_error_is_told_twice(known):
    assert len({(one.source, one.lines, one.about) for one in known}) == len(known)


def test_the_right_numbers_are_computed(known):
    right = {(one.source, one.about): one.right for one in known}
    assert right["Finotti 2013", "Second-order couple"] == "376.1 N·m by two terms"
    assert right["Finotti 2013", "Number of parts"] == "46"
    assert right["Finotti 2013", "μN/P that corresponds to ZN/P = 30"] == "7.252·10⁻⁸"
    assert right["Finotti 2013", "Displacement"] == "2228 cm³"
    assert right["gear friction thesis", "Efficiency"].startswith("P_out/P_in")


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
