"""What is open, on one screen."""

from dataclasses import replace

import pytest

from assistant.results_text import check_json, finding_lines, results_json
from calc.design.toml_file import design, read
from calc.sheet.text import Text
from calc.solve import solve
from calc.studies.shipped import DESIGNS
from tests.made_checks import made_check


def made(id, kind, value, **more):
    name, advice = Text("The size of {id}", id=id), Text("Do something.")
    return made_check(value, kind=kind, unit="mm", id=id, name=name, source=Text("a source"), advice=advice, **more)


def printed(*checks, everything=False):
    return "\n".join(finding_lines(checks, everything))


@pytest.mark.parametrize("file", sorted(DESIGNS.glob("*.toml")), ids=lambda file: file.stem)
def test_what_is_open_fits_on_a_screen(file):
    lines = list(finding_lines(list(solve(design(read(file))).checks())))
    assert len(lines) <= 48 and max(map(len, lines), default=0) <= 160


def test_limits_stand_first_and_a_cause_by_its_worst_check():
    text = printed(
        made("a.note", "advice", 0.5),
        made("a.caution", "caution", 0.5),
        made("a.limit", "limit", 0.9),
        made("a.corner", "caution", 0.2, cause="a.limit"),
        made("a.holds", "limit", 9.0),
    )
    assert [line for line in text.splitlines() if not line.startswith(" ")] == [
        "✗ FAIL  The size of a.limit: 0.9 mm, needs ≥ 1 mm (−10 %)",
        "▲ warn  The size of a.caution: 0.5 mm, needs ≥ 1 mm (−50 %)",
        "• note  1 piece of advice: The size of a.note (−50 %)",
    ]
    assert "With it: The size of a.corner (−80 %)" in text and "a.limit · a source" in text and "a.holds" not in text


def test_everything_is_every_finding_in_full():
    checks = [
        made("a.note", "advice", 0.5),
        made("a.limit", "limit", 0.9),
        made("a.corner", "caution", 0.2, cause="a.limit"),
    ]
    text = printed(*checks, everything=True)
    assert text.count("Do something.") == 3 and "With it" not in text and "piece of advice" not in text


def test_what_is_missing_and_what_is_accepted_is_said():
    text = printed(
        made("a.limit", "limit", 2.0, missing=("gears.housing_material",)),
        made("a.caution", "caution", 0.5, accepted="seen on the bench"),
    )
    assert "? not verified  The size of a.limit" in text and "Not known: gears.housing_material." in text
    assert "✓ accepted  The size of a.caution: 0.5 mm, needs ≥ 1 mm (−50 %): seen on the bench" in text


def test_many_of_one_cause_are_counted():
    text = printed(made("a.limit", "limit", 0.9), *(made(f"a.n{n}", "caution", 0.5, cause="a.limit") for n in range(5)))
    assert "The size of a.n2 (−50 %); 2 more" in " ".join(text.split())


def test_a_row_of_the_json_has_all_that_a_check_knows():
    check = replace(
        made("a.limit", "limit", 2.0), demand=True, moved_by=("gears.power_kW",), missing=("gears.quality",)
    )
    row = check_json(check)
    assert (row["kind"], row["cause"], row["utilisation"], row["missing"]) == (
        "limit",
        "a.limit",
        0.5,
        ["gears.quality"],
    )
    assert (
        row["moved_by"] == [{"key": "gears.power_kW", "slope": None, "gain": None, "unit": ""}]
        and row["remedies"] == []
    )


def test_what_holds_by_a_formula_outside_its_validity_is_counted():
    method, held = made("gears.a_b.line_load", "method", 0.5), made("gears.a_b.safety_contact", "limit", 2.0)
    fails = made("gears.a_b.safety_contact_usual", "advice", 0.9)
    line = "1 check holds by a formula outside its validity: The size of gears.a_b.line_load (−50 %)"
    assert line in printed(method, held, fails) and "outside" not in printed(held, fails)
    sized = read(DESIGNS / "r753ie4_sized.toml")
    rows = {row["id"]: row for row in results_json(sized, solve(design(sized)))["checks"]}
    assert rows["gears.idler_shaft.safety_contact"]["outside"] == ["gears.idler_shaft.line_load"]
    assert rows["gears.idler.safety_bending"]["outside"] == [
        "gears.central_idler.line_load",
        "gears.idler_shaft.line_load",
    ]
    assert rows["gears.idler_shaft.line_load"]["outside"] == []
