# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose FILE bearings`: the tables, the row that is written and holds, and what is said where nothing
passes."""

import json
from itertools import pairwise

import pytest

from assistant.offers import offer
from calc.design.toml_file import design, parse
from tests.command import run
from tests.conftest import DESIGNS, ROOT


@pytest.fixture
def copy(tmp_path):
    def made(name):
        path = tmp_path / f"{name}.toml"
        path.write_text((DESIGNS / f"{name}.toml").read_text(encoding="utf-8"), encoding="utf-8")
        return path

    return made


def found(path, *more):
    """The columns and the numbered rows of the first table, by label."""
    table = json.loads(run("choose", path, "bearings", "--json", "--top", "99", *more).stdout)
    labels = [column["label"] for column in table["columns"]]
    return [dict(zip(labels, row)) for row in table["rows"]], table


def plain_rows(path):
    """The numbers of those that have no rolling bearing, in their order."""
    rows, _ = found(path)
    return [int(row["no."]) for row in rows if row["no."] != "now" and "×" in row["F"] and "×" in row["R"]]


@pytest.mark.slow
@pytest.mark.parametrize(
    "name, nth",
    [
        ("r753ie4_gamma", 0),
        ("r753ie4_gamma", 1),
        ("r753ie4_beta", 0),
        ("r753ie4_sized", 1),
    ],
)
def test_a_row_that_is_written_passes(copy, name, nth):
    """No limit of the shaft or the bearings fails with it, and those of the bearings are verified; what fails before,
    of the gears, is not its matter."""
    path = copy(name)
    before, row = path.read_text(encoding="utf-8"), plain_rows(copy(name))[nth]
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
    assert len(corner) == 6 and all(c["margin"] >= 0 for c in corner)


@pytest.mark.slow
def test_comments_stay_or_are_named(copy):
    """That of a line that stays stands; one that goes with its key is said."""
    path = copy("r753ie4_gamma")
    text = path.read_text(encoding="utf-8").replace(
        'oil = "10W-40 Q8 T905"', 'oil = "10W-40 Q8 T905"   # what the engine has'
    )
    path.write_text(text.replace("length_mm = 26.5", "length_mm = 26.5   # by the seat"), encoding="utf-8")
    done = run("choose", path, "bearings", "--apply", plain_rows(path)[1])
    written = path.read_text(encoding="utf-8")
    assert "# what the engine has" in written and "# by the seat" in written and "length_mm = 26.5" not in written
    assert "clearance_factor" not in written
    assert "A comment went with its key: # the text prints 0.6" in done.stdout


def test_the_least_friction_comes_first_and_nothing_is_wider_than_a_page(copy):
    done = run("choose", copy("r753ie4_gamma"), "bearings")
    lines = done.stdout.splitlines()
    assert lines[0] == "Plain and rolling bearings that pass: the least loss first"
    assert lines[1].startswith("Row 1: ") and " W in place of " in lines[1]
    assert max(map(len, lines)) <= 130
    end = next(n for n, line in enumerate(lines) if line.startswith("  Plain: "))
    rows = [line for line in lines[:end] if line[2:6].strip().isdigit()]
    assert [int(line[2:6]) for line in rows] == list(range(1, 21)) and any("--top" in line for line in lines)
    assert max(map(len, rows)) <= 80
    plain = lines[lines.index("Bearings that fit and keep every rule of the search: the least friction first") :]
    assert any(line.startswith(f"  {int(rows[-1][2:6])} ") for line in plain)


def test_what_is_wanted_of_bearings_is_asked_of_no_other_step(copy):
    done = run("choose", copy("r753ie4_gamma"), "gears", "--for", "loss")
    assert done.returncode == 2 and "is for bearings alone" in done.stderr


def split_sized(copy):
    """The sized design laid into a divided housing, in schema 2."""
    path = copy("r753ie4_sized")
    assert run("upgrade", path).returncode == 0
    text = path.read_text(encoding="utf-8").splitlines()
    assert sum(line.startswith("radial_clearance_mm") for line in text) == 1
    laid_in = ['assembly = "split"' if line.startswith("radial_clearance_mm") else line for line in text]
    path.write_text("\n".join(laid_in), encoding="utf-8")
    return path


@pytest.mark.slow
def test_what_the_threaded_assembly_costs(copy):
    """On a split support the journals of the sized design need a fifth of the friction, every limit kept at every
    corner; 60 W is the bar, and 257 W what they have."""
    path = split_sized(copy)
    _, table = found(path, "--for", "loss")
    labels = [column["label"] for column in table["tables"]["plain"]["columns"]]
    now, first = (dict(zip(labels, row)) for row in table["tables"]["plain"]["rows"][:2])
    assert now["P_f"] == pytest.approx(257.4, abs=0.1) and first["P_f"] <= 60
    assert run("choose", path, "bearings", "--apply", first["no."]).returncode == 0
    shown = json.loads(run("check", path, "--json").stdout)
    bearings = [c for c in shown["checks"] if c["id"].startswith(("bearings.", "countershaft."))]
    assert [c["id"] for c in bearings if c["kind"] in ("limit", "caution") and c["margin"] < 0] == []
    power = sum(shown["values"][f"bearings.{place}.friction_power"]["value"] for place in ("front", "rear"))
    assert power == pytest.approx(first["P_f"], rel=1e-3)


@pytest.mark.slow
def test_what_is_locked_is_said_before_a_row_is_applied(copy):
    path = copy("r753ie4_gamma")
    films = run("choose", path, "bearings", "--for", "film").stdout
    assert "Row 1 changes what is locked: Oil (bearings.oil): " in " ".join(films.split())
    assert "locked" not in run("choose", split_sized(copy), "bearings", "--top", "1").stdout


@pytest.mark.slow
def test_the_json_has_all_tables(copy):
    path = copy("r753ie4_sized")
    rows, table = found(path)
    assert table["step"] == "bearings" and {"plain", "neighbours", "pareto"} <= set(table["tables"])
    power = [row["P_f"] for row in rows if row["no."] != "now"]
    assert all(b > a * 0.98 for a, b in pairwise(power))
    assert table["summary"][0].startswith("Row 1: ") and len(table["notes"]) > 5
    last = int(table["tables"]["pareto"]["rows"][-1][0])
    assert run("choose", path, "bearings", "--apply", last + 1).returncode == 2
    films = json.loads(run("choose", path, "bearings", "--for", "film", "--json").stdout)
    alone = [row[1:] for row in table["tables"]["pareto"]["rows"]]
    assert [row[1:] for row in films["rows"]] == alone


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


@pytest.mark.slow
def test_rolling_bearings_are_written_and_plain_ones_again(copy):
    """The first row of the shipped design has none that is plain; it passes where it is written.  Of the design that
    then has none, plain ones are offered still, fed as it says."""
    path = copy("r753ie4_gamma")
    refused = run("choose", path, "bearings", "--apply", 1)
    assert refused.returncode == 2 and "contralbero upgrade FILE" in refused.stderr  # schema 1 has no words for it
    assert run("upgrade", path).returncode == 0
    rows, _ = found(path)
    assert rows[1]["no."] == "1" and not {"×"} & {*rows[1]["F"], *rows[1]["R"]}
    done = run("choose", path, "bearings", "--apply", 1)
    assert done.returncode == 0 and "A comment went with its key: # the text prints 0.6" in done.stdout
    written = path.read_text(encoding="utf-8")
    assert written.count('kind = "rolling"') == 2 and written.count("locates = true") == 1
    assert "clearance_factor" not in written and "# 4.6 (in chapter 6)" in written
    shown = json.loads(run("check", path, "--json").stdout)
    bearings = [check for check in shown["checks"] if check["id"].startswith("bearings.")]
    assert [check["id"] for check in bearings if check["kind"] == "limit" and check["verdict"] == "fail"] == []
    loss = sum(shown["values"][f"bearings.{place}.friction_power"]["value"] for place in ("front", "rear"))
    assert loss == pytest.approx(rows[1]["P_f"], rel=0.02)
    plain = plain_rows(path)
    done = run("choose", path, "bearings", "--apply", plain[0])
    assert done.returncode == 0, done.stderr
    again = path.read_text(encoding="utf-8")
    assert "rolling" not in again and again.count("diameter_mm = ") >= 2 and "outer_ring_held" not in again
    checks = json.loads(run("check", path, "--json").stdout)["checks"]
    assert [c["id"] for c in checks if c["verdict"] == "fail" and c["id"].startswith("bearings.")] == []


def test_plain_rows_behind_those_that_are_shown_have_no_table():
    """Of a design on rolling bearings the first rows are such; a plain row is called by its number in both tables."""
    designs = json.loads((ROOT / "tests/reference/rolling.json").read_text(encoding="utf-8"))["designs"]
    offered = offer("bearings", design(parse(designs["two rollers"].encode(), "two.toml")), "two.toml")
    assert [table.id for table in offered.beside(3)].count("plain") == 0
    (plain,) = [table for table in offered.beside(40) if table.id == "plain"]
    mixed = {str(row[0]): [str(size) for size in row[1:3]] for row in offered.table(40).rows}
    alone = {str(row[0]): [str(row[3]), str(row[5])] for row in plain.rows}
    assert alone and {number: mixed[number] for number in alone} == alone
