# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose FILE gears`: the tables, and rows that are written and give what they promised."""

import json
import re

import pytest

from assistant.commands import choose
from assistant.offers import Offer
from calc.gears.selection import search as offered
from calc.gears.selection.search import search
from tests.command import run
from tests.conftest import DESIGNS, GAMMA


@pytest.fixture
def copy(tmp_path):
    def made(name):
        path = tmp_path / f"{name}.toml"
        path.write_text((DESIGNS / f"{name}.toml").read_text(encoding="utf-8"), encoding="utf-8")
        return path

    return made


def largest_sliding(path):
    values = json.loads(run("check", path, "--json", "--step", "gears").stdout)["values"]
    return max(abs(v["value"]) for id, v in values.items() if re.search(r"\.specific_sliding_(driver|driven)$", id))


@pytest.fixture(scope="module", autouse=True)
def searched_once():
    """The same gears are searched once for all tests that list them or write a row of them."""
    known = []

    def once(gears, progress=None, axis=None):
        found = next((found for other, found in known if other == (gears, axis)), None) or search(gears, progress, axis)
        known.append(((gears, axis), found))
        return found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(offered, "search", once)
        yield


@pytest.fixture(scope="module")
def listed():
    return json.loads(run("choose", DESIGNS / "r753ie4_gamma.toml", "gears", "--json", "--top", "99").stdout)


@pytest.mark.parametrize("row", [1, 9, 33, *(pytest.param(row, marks=pytest.mark.slow) for row in (2, 3, 5, 20))])
def test_a_row_that_is_written_gives_what_it_promised(copy, listed, row):
    """In all numbered tables: distance free, crank as shaft, distance held, what a pair wants, round, a cut, a cut with
    its shift."""
    tables = [listed, *listed["tables"].values()]
    promised = {}
    for table in tables:
        labels = [c["label"] for c in table["columns"]]
        if "max |ζ_A|" in labels:
            promised |= {
                cells[0]: cells[labels.index("max |ζ_A|")] for cells in table["rows"] if cells[0] not in ("", "now")
            }
    path = copy("r753ie4_gamma")
    before = path.read_text(encoding="utf-8")
    done = run("choose", path, "gears", "--apply", row)
    assert done.returncode == 0, done.stderr
    assert f"the gears of row {row} " in done.stdout.splitlines()[0]
    assert path.with_suffix(".toml.bak").read_text(encoding="utf-8") == before
    assert path.read_text(encoding="utf-8").count("#") == before.count("#")
    assert largest_sliding(path) == pytest.approx(promised[str(row)], abs=5e-4)


def test_the_optimum_is_listed_beside_the_present_and_holds_once_written(copy, listed):
    labels = [c["label"] for c in listed["columns"]]
    largest = [row[labels.index("max |ζ_A|")] for row in listed["rows"]]
    assert listed["rows"][0][0] == "now" and largest[0] == max(largest) and largest[1:] == sorted(largest[1:])
    path = copy("r753ie4_gamma")
    assert run("choose", path, "gears", "--apply", 3).returncode == 0
    text = path.read_text(encoding="utf-8")
    assert "centre_distance_mm = 65.808" in text and "profile_shift = -0.0414" in text
    again = json.loads(run("choose", path, "gears", "--json").stdout)
    assert [row[labels.index("max |ζ_A|")] for row in again["rows"]] == pytest.approx([largest[3]] * 2, abs=1e-6)


@pytest.fixture
def full_teeth(copy):
    """The pair of the thesis before its teeth were made thinner: below the usual limit of the start of contact."""
    path = copy("timing_pair")
    kept = [line for line in path.read_text(encoding="utf-8").splitlines() if "span_allowance_um" not in line]
    path.write_text("\n".join(kept) + "\n", encoding="utf-8")
    return path


@pytest.mark.slow
def test_a_pair_alone_and_its_contradicting_shift(full_teeth):
    """Both shifts are given without a distance: holding it takes the mate's away."""
    path = full_teeth
    done = run("choose", path, "gears")
    assert done.returncode == 0 and "distance held" in done.stdout and "No worse than it" in done.stdout
    assert max(map(len, done.stdout.splitlines())) <= 120  # a table is as wide as the names of its wheels
    assert run("choose", path, "gears", "--apply", 2).returncode == 0
    text = path.read_text(encoding="utf-8")
    assert text.count("profile_shift =") == 1 and "centre_distance_mm = 132.6703" in text


@pytest.mark.slow
def test_the_best_of_a_pair_below_the_usual_limits_is_the_first_row_and_is_written(full_teeth):
    """It keeps the limits of the design itself; with the usual ones nothing but 3.353 is left where the distance is
    free."""
    path = full_teeth
    listed = json.loads(run("choose", path, "gears", "--json").stdout)
    labels = [c["label"] for c in listed["columns"]]
    rows = [dict(zip(labels, row)) for row in listed["rows"]]
    assert [(row["what"], row["keeps"]) for row in rows[1:]] == [
        ("distance free", "as now"),
        ("distance held", "as now"),
        ("distance free", "usual"),
    ]
    assert [row["max |ζ_A|"] for row in rows] == pytest.approx([1.017, 0.882, 1.017, 3.353], abs=5e-4)
    assert run("choose", path, "gears", "--apply", 1).returncode == 0
    assert largest_sliding(path) == pytest.approx(0.8819, abs=5e-5)


def test_what_a_row_makes_worse_in_the_whole_design_is_said(tmp_path, monkeypatch):
    """Gears with larger tips, in a design that passes: the front seat, as wide as the tips as they are, is then too
    narrow for one."""
    path = tmp_path / "threaded.toml"
    text = (DESIGNS / "twin_drive.toml").read_text(encoding="utf-8")
    path.write_text(text.replace("diameter_mm = 80.0 ", "diameter_mm = 72.0 ", 1), encoding="utf-8")
    shifts = {f"gears.wheels.{wheel}.profile_shift": 0.8 for wheel in ("crank", "central", "idler", "shaft")}
    row = Offer(1, lambda top: None, lambda n: shifts, lambda n: "now has other gears", "")
    monkeypatch.setattr(choose, "offer_for", lambda *asked, **_: row)
    done = run("choose", path, "gears", "--apply", 1)
    state, *lines = done.stdout.partition("\n\n")[2].splitlines()
    assert state.startswith("NOT VERIFIED: ") and state.endswith(" (before: PASS)")
    shaft = next(n for n, line in enumerate(lines) if line.startswith("Counter-shaft"))
    assert lines[shaft].endswith("▲ warn") and "▲ warn    countershaft.gear_seat " in lines[shaft + 1]
    assert lines[shaft + 2].startswith("Bearings")


def test_the_whole_train_fits_the_terminal(listed):
    done = run("choose", DESIGNS / "r753ie4_beta.toml", "gears")
    assert done.returncode == 0 and max(map(len, done.stdout.splitlines())) <= 120
    assert set(listed["tables"]) == {"sliding", "wants", "around", "limits", "tip_cuts_now", "tip_cuts_best"}
    assert "crank as shaft: free is the shift of central; idler, shaft, crank follow." in listed["summary"][0]


def test_where_nothing_passes_the_rule_is_said(copy):
    path = copy("timing_pair")
    assert run("set", path, "gears.tool_addendum=1.0").returncode == 0
    done = run("choose", path, "gears")
    assert (
        done.returncode == 3
        and done.stdout == ""
        and "clearance: nowhere" in done.stderr
        and "Traceback" not in done.stderr
    )


def test_what_can_not_be_chosen_is_said():
    done = run("choose", DESIGNS / "twin_force_shaft.toml", "gears")
    assert done.returncode == 2 and "gears: needed" in done.stderr
    done = run("choose", DESIGNS / "timing_pair.toml", "gears", "--apply", "999")
    assert done.returncode == 2 and "from 1 to" in done.stderr


def test_the_progress_of_the_search_moves_on_and_never_stands() -> None:
    from calc.design.toml_file import design, read

    told: list[float] = []
    gears = design(read(GAMMA)).gears
    assert gears is not None
    search(gears, lambda share, what: told.append(share))
    assert told == sorted(told) and len(told) > 20 and told[0] == 0
    assert max(b - a for a, b in zip(told, [*told[1:], 1.0])) < 0.25
