# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose FILE bearings`: the tables, the row that is written and holds, and what is said where nothing
passes."""

import json

import pytest

from tests.command import run
from tests.conftest import DESIGNS


@pytest.fixture
def copy(tmp_path):
    def made(name):
        path = tmp_path / f"{name}.toml"
        path.write_text((DESIGNS / f"{name}.toml").read_text(encoding="utf-8"), encoding="utf-8")
        return path

    return made


@pytest.mark.slow
@pytest.mark.parametrize(
    "name, row",
    [
        ("r753ie4_gamma", 1),
        ("r753ie4_gamma", 2),
        ("r753ie4_beta", 1),
        ("r753ie4_sized", 2),
    ],
)
def test_a_row_that_is_written_passes(copy, name, row):
    """No limit of the shaft or the bearings fails with it, and those of the bearings are verified; what fails before,
    of the gears, is not its matter."""
    path = copy(name)
    before = path.read_text(encoding="utf-8")
    done = run("choose", path, "bearings", "--apply", row)
    assert done.returncode == 0, done.stderr
    assert f"the bearings of row {row}" in done.stdout.splitlines()[0]
    assert path.with_suffix(".toml.bak").read_text(encoding="utf-8") == before
    checks = json.loads(run("check", path, "--json").stdout)["checks"]
    assert [
        c["id"] for c in checks if c["verdict"] == "fail" and c["id"].startswith(("bearings.", "countershaft."))
    ] == []
    limits = [c for c in checks if c["kind"] == "limit" and c["id"].startswith("bearings.")]
    assert [c["id"] for c in limits if c["verdict"] == "not_verified"] == []
    corner = [c for c in checks if c["id"].endswith("_corner")]
    assert len(corner) == 6 and (name != "r753ie4_sized" or all(c["margin"] >= 0 for c in corner))


@pytest.mark.slow
def test_comments_stay_or_are_named(copy):
    """That of a line that stays stands; one that goes with its key is said."""
    path = copy("r753ie4_gamma")
    text = path.read_text(encoding="utf-8").replace(
        'oil = "10W-40 Q8 T905"', 'oil = "10W-40 Q8 T905"   # what the engine has'
    )
    path.write_text(text.replace("length_mm = 26.5", "length_mm = 26.5   # by the seat"), encoding="utf-8")
    done = run("choose", path, "bearings", "--apply", 2)
    written = path.read_text(encoding="utf-8")
    assert "# what the engine has" in written and "# by the seat" in written and "length_mm = 26.5" not in written
    assert "clearance_factor" not in written
    assert "A comment went with its key: # the text prints 0.6" in done.stdout


def test_what_fits_comes_first_and_nothing_is_wider_than_a_page(copy):
    done = run("choose", copy("r753ie4_gamma"), "bearings")
    lines = done.stdout.splitlines()
    assert lines[0].startswith("No bearing that fits keeps every rule")
    assert lines[1].startswith("Nothing that fits keeps every rule: the front journal has room for 28.29 mm")
    assert max(map(len, lines)) <= 118
    before = lines[: lines.index("The neighbours of the first 3 rows")]
    numbers = [int(word) for line in before if (word := line[2:6].strip()).isdigit()]
    assert numbers == list(range(1, 21)) and any("--top" in line for line in lines)


def test_the_design_stands_in_its_row_as_the_others_are_judged(copy):
    """Those that fit hold as given, not at the corners: so does the row of the design, whose film is that of the
    check."""
    path = copy("r753ie4_gamma")
    found = json.loads(run("choose", path, "bearings", "--json").stdout)
    labels = [column["label"] for column in found["columns"]]
    now = dict(zip(labels, found["rows"][0]))
    values = json.loads(run("check", path, "--json").stdout)["values"]
    assert now["no."] == "now"
    assert now["h_edge"] == pytest.approx(values["bearings.front.film_edge"]["value"], rel=2e-3)
    assert now["h_2F"] == pytest.approx(values["bearings.front.film_double_load"]["value"], rel=2e-3)


@pytest.mark.slow
def test_what_is_locked_is_said_before_a_row_is_applied(copy):
    path = copy("r753ie4_gamma")
    assert "Row 1 changes what is locked: Oil (bearings.oil): " in " ".join(
        run("choose", path, "bearings").stdout.split()
    )
    assert "locked" not in run("choose", copy("r753ie4_sized"), "bearings", "--top", "1").stdout


@pytest.mark.slow
def test_the_json_has_all_tables(copy):
    path = copy("r753ie4_sized")
    found = json.loads(run("choose", path, "bearings", "--json", "--top", "50").stdout)
    assert found["step"] == "bearings" and set(found["tables"]) == {"too_long", "neighbours", "pareto"}
    labels = [c["label"] for c in found["columns"]]
    rows = [row for row in found["rows"] if row[0] != "now"]
    power = [row[labels.index("P_f")] for row in rows]
    assert power[1:] == sorted(power[1:])
    assert (
        found["summary"] == ["Row 1 is the design as it is: it keeps every rule of the search."]
        and len(found["notes"]) > 5
    )
    assert int(found["tables"]["too_long"]["rows"][0][0]) == len(rows) + 1
    assert run("choose", path, "bearings", "--apply", int(found["tables"]["pareto"]["rows"][-1][0]) + 1).returncode == 2


@pytest.mark.slow
def test_where_nothing_passes_the_nearest_is_said(copy):
    path = copy("r753ie4_sized")
    assert run("set", path, "bearings.front.load_N=30000").returncode == 0
    done = run("choose", path, "bearings")
    assert done.returncode == 3 and done.stdout == "" and "Traceback" not in done.stderr
    assert "nearest:" in done.stderr and "front" in done.stderr


def test_a_step_that_is_none_is_guessed(copy):
    done = run("choose", copy("r753ie4_gamma"), "bearing")
    assert done.returncode == 2 and "did you mean bearings?" in done.stderr


def test_a_design_without_bearings_is_told(copy):
    done = run("choose", copy("timing_pair"), "bearings")
    assert done.returncode == 2 and "bearings: needed" in done.stderr
