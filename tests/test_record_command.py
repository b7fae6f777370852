# SPDX-License-Identifier: Apache-2.0
"""`record` and `replay` as a suite: what is recorded agrees, an edit of a design is noticed, and a CI server is told."""

import json
import shutil
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.command import run
from tests.conftest import DESIGNS

PAIR = DESIGNS / "timing_pair.toml"


@pytest.fixture
def suite(tmp_path: Path) -> Path:
    """Two designs and a replay of each."""
    (tmp_path / "designs").mkdir()
    for name in "ab":
        shutil.copy(PAIR, tmp_path / "designs" / f"{name}.toml")
    done = run("record", "designs", "-o", "replays", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (0, "replays/a.toml: PASS\nreplays/b.toml: PASS\n")
    return tmp_path


def test_what_is_recorded_agrees_and_an_edit_of_the_design_is_noticed(suite: Path) -> None:
    assert run("replay", "replays", "-q", cwd=suite).stdout == ""
    run("set", "designs/b.toml", "gears.face_width_mm=12", cwd=suite)
    done = run("replay", "replays", "-q", cwd=suite)
    assert done.returncode == 1 and done.stdout.startswith("replays/b.toml: ") and "friction.total_loss" in done.stdout
    updated = run("replay", "replays", "--update", cwd=suite)
    assert updated.returncode == 0 and "friction.total_loss: " in updated.stdout
    assert run("replay", "replays", cwd=suite).returncode == 0
    assert not list((suite / "replays").glob("*.bak"))


def test_edits_are_steps_and_an_existing_replay_is_left_alone(suite: Path) -> None:
    edits = ["--set", "gears.face_width_mm=12", "friction.oil_temperature_C=90"]
    done = run("record", "designs/a.toml", *edits, cwd=suite)
    assert done.returncode == 0 and done.stdout == "a-replay.toml: PASS\n"
    replay = suite / "a-replay.toml"
    about = tomllib.loads(replay.read_text("utf-8"))
    assert about["design"] == "designs/a.toml"
    assert about["step"] == [
        {"set": "gears.face_width_mm", "to": 12},
        {"set": "friction.oil_temperature_C", "to": 90},
    ]
    assert run("replay", replay, cwd="/").returncode == 0
    before = replay.read_bytes()
    again = run("record", "designs/a.toml", cwd=suite)
    assert again.returncode == 2 and "is left alone" in again.stderr and replay.read_bytes() == before
    wrong = run("record", "designs/a.toml", "--set", "gears.teeht=3", "-o", "x.toml", cwd=suite)
    assert wrong.returncode == 2 and "gears.teeht" in wrong.stderr and not (suite / "x.toml").exists()


def test_a_server_is_told_in_junit_and_json(suite: Path) -> None:
    replay = suite / "replays" / "b.toml"
    text = replay.read_text("utf-8")
    replay.write_text(text.replace('unit = "W"', 'unit = "kW"').replace('name = "', 'name = "\\u001b&<'), "utf-8")
    (suite / "replays" / "c.toml").write_text("schema = 7\n", "utf-8")
    done = run("replay", "replays", "--junit", "out.xml", "--json", cwd=suite)
    assert done.returncode == 2 and "c.toml:1: schema: " in done.stderr
    suites = ElementTree.parse(suite / "out.xml").getroot()
    counts = [(one.get("name"), one.get("failures"), one.get("errors")) for one in suites]
    assert counts == [("replays/a.toml", "0", "0"), ("replays/b.toml", "1", "0"), ("replays/c.toml", "0", "1")]
    (failure,) = suites.findall(".//failure")
    assert "the unit kW is wrong; the value is in W" in (failure.get("message") or "")
    assert "schema" in (suites[2][0][0].text or "")
    found = json.loads(done.stdout)
    assert found["agrees"] is False and [x["agrees"] for x in found["replays"]] == [True, False, False]
    assert "schema" in [error["key"] for error in found["replays"][2]["errors"]]
    assert sum(not c["agrees"] for c in found["replays"][1]["compared"]) == 1


@pytest.mark.parametrize(
    "given, said",
    [
        ('unit = "kW"', "the unit kW is wrong; the value is in W"),
        ("", 'has no unit; the value is in W: write unit = "W"'),
    ],
)
def test_a_wrong_unit_is_named_and_no_update_hides_it(suite: Path, given: str, said: str) -> None:
    replay = suite / "replays" / "a.toml"
    text = replay.read_text("utf-8").replace('unit = "W"', given)
    replay.write_text(text, "utf-8")
    for more in ((), ("--update",)):
        done = run("replay", "replays/a.toml", *more, cwd=suite)
        assert done.returncode == 1 and f"friction.total_loss: {said}" in done.stdout
    assert replay.read_text("utf-8") == text
