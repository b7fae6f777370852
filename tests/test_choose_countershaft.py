"""`contralbero choose FILE countershaft`: the ranked table, the row that is written, and what is said where nothing
fits."""

import json

import pytest

from tests.command import run
from tests.conftest import DESIGNS, GAMMA


@pytest.fixture
def wide(tmp_path):
    """The source's final design with an envelope that leaves room, and comments of its own."""
    path = tmp_path / "wide.toml"
    path.write_text(GAMMA.read_text(encoding="utf-8"), encoding="utf-8")
    keys = ("outer_radius_mm=43", "core_radius_mm=15", "half_length_mm=152")
    assert run("set", path, *(f"countershaft.{key}" for key in keys)).returncode == 0
    return path


def test_the_lightest_is_listed_first_and_one_is_written(wide):
    listed = json.loads(run("choose", wide, "countershaft", "--json", "--top", "50").stdout)
    assert listed["step"] == "countershaft"
    column = [c["label"] for c in listed["columns"]].index("eccentric masses")
    masses = [row[column] for row in listed["rows"]]
    assert len(masses) > 5 and masses == sorted(masses) and masses[0] == pytest.approx(2 * 1.582, abs=1e-3)
    before = wide.read_text(encoding="utf-8")
    done = run("choose", wide, "countershaft", "--apply", "2")
    assert done.returncode == 0 and "now sizes its shaft" in done.stdout
    after = wide.read_text(encoding="utf-8")
    radius = [c["label"] for c in listed["columns"]].index("outer radius")
    assert 'mode = "size"' in after and f"outer_radius_mm = {listed['rows'][1][radius]:g}" in after
    assert before.count("#") == after.count("#")
    assert wide.with_suffix(".toml.bak").read_text(encoding="utf-8") == before
    state = run("check", wide).stdout.splitlines()[0]
    assert f"\n\n{state} (before: FAIL: " in done.stdout
    checked = json.loads(run("check", wide, "--json", "--step", "countershaft").stdout)
    assert checked["values"]["countershaft.couple"]["value"] == pytest.approx(572.932, abs=5e-4)
    assert checked["values"]["countershaft.eccentric_mass"]["value"] == pytest.approx(masses[1], rel=1e-9)


def test_the_table_is_printed_with_what_to_do(wide):
    done = run("choose", wide, "countershaft", "--top", "3")
    assert done.returncode == 0 and "Counter-shafts in the envelope" in done.stdout and "--apply N" in done.stdout
    assert len([line for line in done.stdout.splitlines() if line.split()[:1] and line.split()[0] in "123"]) == 3


def test_an_envelope_in_which_nothing_fits_ends_with_three(wide):
    assert run("set", wide, "countershaft.outer_radius_mm=39").returncode == 0
    done = run("choose", wide, "countershaft")
    assert (
        done.returncode == 3
        and done.stdout == ""
        and "does not fit" in done.stderr
        and "outer radius of" in done.stderr
    )


@pytest.mark.parametrize(
    "changes, words",
    [
        (("countershaft.core_radius_mm=",), "shafts.shaft.core_radius_mm: needed"),
        (("countershaft.core_radius_mm=42.9",), None),
    ],
)
def test_what_the_envelope_lacks_is_said(wide, changes, words):
    run("set", wide, *changes)
    done = run("choose", wide, "countershaft")
    assert (
        done.returncode == (2 if words else 3)
        and (words or "does not fit") in done.stderr
        and "Traceback" not in done.stderr
    )


@pytest.mark.parametrize(
    "arguments, words",
    [
        ((DESIGNS / "timing_pair.toml", "countershaft"), "engine: needed"),
        ((GAMMA, "countershaft", "--top", "0"), "1 or more"),
        ((GAMMA, "countershaft", "--apply", "999"), "from 1 to"),
        ((GAMMA, "friction"), "countershaft (shafts in the envelope"),
    ],
)
def test_what_can_not_be_chosen_is_said(arguments, words):
    done = run("choose", *arguments)
    assert done.returncode == 2 and words in done.stderr and "Traceback" not in done.stderr


def test_a_shaft_that_carries_a_force_is_sized_too(tmp_path):
    path = tmp_path / "twin.toml"
    path.write_text((DESIGNS / "twin_force_shaft.toml").read_text(encoding="utf-8"), encoding="utf-8")
    keys = ("outer_radius_mm=42", "core_radius_mm=10", "half_length_mm=40")
    assert run("set", path, *(f"countershaft.{key}" for key in keys)).returncode == 0
    assert run("choose", path, "countershaft", "--apply", "1").returncode == 0
    checked = json.loads(run("check", path, "--json", "--step", "countershaft").stdout)
    assert checked["values"]["countershaft.residual_order_1_force"]["value"] == pytest.approx(
        0, abs=1e-6 * checked["values"]["countershaft.force"]["value"]
    )
