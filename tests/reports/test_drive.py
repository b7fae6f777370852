# SPDX-License-Identifier: Apache-2.0
"""The chapter of a drive that was picked from a front: in the report, verified with it, and left out where the file
beside says nothing."""

import json
import re

import pypdf
import pytest

from tests.command import run
from tests.conftest import DESIGNS

FEW = (
    "--vary",
    "shafts.shaft.core_radius_mm=14,15,16",
    "shafts.shaft.bearings.rear.diameter_mm=84.5,86",
    "shafts.shaft.bearings.front.diameter_mm=58.5,62",
    "shafts.shaft.material=20CrNi4",
    "bearings.supply=hole",
    "--rows",
    "4",
    "--processes",
    "1",
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("drive")
    done = run("design", DESIGNS / "r753ie4_sized.toml", "--out", folder, *FEW)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.mark.parametrize(
    "lang, words",
    [
        pytest.param("en", ("Whole drive", "What binds it"), marks=pytest.mark.slow),
        ("it", ("Trasmissione completa", "Che cosa la vincola")),
    ],
)
def test_the_report_of_a_drive_has_its_chapter_and_is_verified(folder, tmp_path, lang, words):
    report = tmp_path / "drive.pdf"
    done = run("report", folder / "002.toml", "--lang", lang, "-o", report)
    assert done.returncode == 0 and "front.json" not in done.stderr
    read = pypdf.PdfReader(report)
    text = "\n".join(page.extract_text() for page in read.pages)
    assert all(word in text for word in words) and set(read.attachments) == {
        "design.toml",
        "results.json",
        "front.json",
    }
    assert run("verify", report).returncode == 0


def test_who_verifies_is_told_that_the_search_is_not_repeated(folder, tmp_path):
    """The front beside a design may be anybody's: the report of a forged one has the bytes that the program writes from
    it."""
    front = json.loads((folder / "front.json").read_text(encoding="utf-8"))
    (tmp_path / "front.json").write_text(json.dumps({**front, "combinations": 10**14}), encoding="utf-8")
    (tmp_path / "001.toml").write_bytes((folder / "001.toml").read_bytes())
    report = tmp_path / "x.pdf"
    assert run("report", tmp_path / "001.toml", "-o", report).returncode == 0
    done = run("verify", report)
    assert done.returncode == 0 and "it repeats front.json inside it; that is not searched again" in done.stdout
    assert done.stdout.splitlines()[-1].startswith("identical: byte for byte")


def test_a_front_that_says_nothing_of_the_design_is_told_and_left_out(folder, tmp_path):
    own, alone = tmp_path / "own.toml", tmp_path / "alone"
    alone.mkdir()
    text = (folder / "001.toml").read_text(encoding="utf-8")
    other = re.sub(r"core_radius_mm = [\d.]+", "core_radius_mm = 15.25", text)
    own.write_text(other, encoding="utf-8")
    (alone / "own.toml").write_text(other, encoding="utf-8")
    bare = tmp_path / "bare.pdf"
    assert "front.json" not in run("report", alone / "own.toml", "--depth", "summary", "-o", bare).stderr
    for front, said in ((folder / "front.json", "has no drive with the values"), (None, "is no front")):
        (tmp_path / "front.json").write_bytes(front.read_bytes() if front is not None else b"{")
        report = tmp_path / "x.pdf"
        done = run("report", own, "--depth", "summary", "-o", report)
        assert said in done.stderr and report.read_bytes() == bare.read_bytes()
