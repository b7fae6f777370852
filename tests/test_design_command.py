# SPDX-License-Identifier: Apache-2.0
"""`contralbero design`: its files, what is picked, what it refuses, and how it ends."""

import csv
import json

import pytest

from tests.command import run, run_apart
from tests.conftest import DESIGNS

FEW = (
    "--vary",
    "shafts.shaft.core_radius_mm=13:17:5",
    "shafts.shaft.bearings.rear.diameter_mm=84,85,86",
    "shafts.shaft.bearings.front.diameter_mm=58.5,62",
    "shafts.shaft.material=20CrNi4",
    "bearings.supply=hole",
    "--rows",
    "4",
    "--processes",
    "1",
)


@pytest.fixture
def copy(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text((DESIGNS / "r753ie4_sized.toml").read_text(encoding="utf-8"), encoding="utf-8")
    return path


def test_the_files_hold_what_the_table_shows(copy, tmp_path):
    out = tmp_path / "drive"
    done = run("design", copy, "--out", out, *FEW)
    assert done.returncode == 0, done.stderr
    lines = (out / "front.csv").read_text(encoding="utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    about = json.loads((out / "front.json").read_text(encoding="utf-8"))
    assert len(rows) == len(about["drives"]) == len(list(out.glob("[0-9]*.toml"))) and 2 <= len(rows) <= 4
    assert any("Exhaustive over the stated ranges" in line for line in lines) and about["proved"] is True
    for n in (1, len(rows)):  # each is an ordinary design that passes, with the user's comments
        drive = out / f"{n:03d}.toml"
        checked = run_apart("check", drive, "--json")
        assert checked.returncode == 0, checked.stdout
        values = {id: v["value"] for id, v in json.loads(checked.stdout)["values"].items()}
        assert values["friction.crank_power"] == pytest.approx(float(rows[n - 1]["power [W]"]), rel=1e-6)
        assert "# engine manual" in drive.read_text(encoding="utf-8")
    again, first = run("design", copy, "--out", out, *FEW).stdout, "first drive that passes: "
    # from what it kept
    assert [x for x in again.splitlines() if first not in x] == [x for x in done.stdout.splitlines() if first not in x]
    assert sum(first in x for x in done.stdout.splitlines()) == 1


def test_a_drive_is_picked_into_the_file_or_another(copy, tmp_path):
    out, other = tmp_path / "drive", tmp_path / "new.toml"
    before = copy.read_text(encoding="utf-8")
    run("design", copy, "--out", out, *FEW)
    assert run("design", copy, "--out", out, "--pick", 2, "-o", other).returncode == 0
    assert copy.read_text(encoding="utf-8") == before and other.read_text(encoding="utf-8") == (
        out / "002.toml"
    ).read_text(encoding="utf-8")
    picked = run("design", copy, "--out", out, "--pick", 1)
    assert picked.returncode == 0 and "drive 1" in picked.stdout
    assert copy.with_suffix(".toml.bak").read_text(encoding="utf-8") == before
    assert run("design", copy, "--out", out, "--pick", 2).returncode == 0  # another one of the same front
    copy.write_text(
        copy.read_text(encoding="utf-8").replace("overdesign_percent = 1.9", "overdesign_percent = 2.5"),
        encoding="utf-8",
    )
    refused = run("design", copy, "--out", out, "--pick", 1)
    assert refused.returncode == 2 and "another version" in refused.stderr
    assert run("design", copy, "--out", out, "--pick", 99).returncode == 2
    assert run("design", copy, "--out", out, "--pick", 1, "-o", copy).returncode == 2


@pytest.mark.slow
def test_when_the_time_is_up_the_drives_that_are_known_are_kept(copy, tmp_path):
    out = tmp_path / "drive"
    done = run(
        "design",
        copy,
        "--out",
        out,
        *FEW[:-4],
        "--vary",
        "shafts.shaft.material=20CrNi4,ADI",
        "--processes",
        "1",
        "--time",
        "0.1",
    )
    assert done.returncode == 0 and "stopped at 1 of 2 classes" in done.stdout and "Not exhaustive" in done.stdout
    assert (out / "001.toml").exists() and not json.loads((out / "front.json").read_text(encoding="utf-8"))["proved"]
    assert run("report", out / "001.toml", "-o", tmp_path / "r.pdf").returncode == 0


def test_dry_says_what_would_be_searched_and_searches_nothing(copy, tmp_path):
    done = run("design", copy, "--dry")
    assert done.returncode == 0 and "shafts.shaft.outer_radius_mm: follows from the largest journal" in done.stdout
    assert "4 classes" in done.stdout and not list(tmp_path.glob("*/"))


def test_one_object_of_json(copy, tmp_path):
    found = json.loads(run("design", copy, "--out", tmp_path / "d", *FEW, "--json").stdout)
    assert found["schema"] == 1 and found["drives"][0]["objectives"]["power"] > 200 and found["table"]["rows"]


@pytest.mark.parametrize(
    "asked, said",
    [
        ((), "--out FOLDER"),
        (
            ("--out", "{d}", "--vary", "shafts.shaft.bearings.rear.diameter_mm=80:90", "--most", "seat_mm=q"),
            "LO:HI:N",
        ),
        (("--out", "{d}", "--most", "weight_kg=3"), "weight_kg"),
        (("--out", "{d}", "--vary", "shafts.shaft.bearings.rear.diametre_mm=80,90"), "diametre_mm"),
        (("--out", "{d}", "--rows", "0"), "2000"),
        (("--out", "{d}", "--time", "-1"), "--time"),
        (("--out", "{file}"), "is a file"),
    ],
)
def test_what_it_can_not_do_is_said(copy, tmp_path, asked, said):
    done = run("design", copy, *[one.format(d=tmp_path / "d", file=copy) for one in asked])
    assert done.returncode == 2 and said in done.stderr and not (tmp_path / "d").exists()


@pytest.mark.slow
def test_where_nothing_passes_it_ends_with_3_and_says_what_would_help(copy, tmp_path):
    done = run(
        "design", copy, "--out", tmp_path / "d", *FEW[:-2], "--most", "seat_mm=84", "--least", "margin_percent=40"
    )
    assert done.returncode == 3 and "nothing passes" in done.stderr
    assert "lacks a margin" in done.stderr and "shafts.shaft.bearings.rear.diameter_mm" in done.stderr
    assert not list((tmp_path / "d").glob("*.toml"))


def test_a_design_without_bearings_is_none(tmp_path):
    done = run("design", DESIGNS / "timing_pair.toml", "--out", tmp_path / "d")
    assert done.returncode == 2 and "a drive has a shaft on two bearings" in done.stderr
