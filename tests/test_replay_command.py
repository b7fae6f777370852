# SPDX-License-Identifier: Apache-2.0
"""A replay of a stranger: what it writes it says, beside itself and over nothing but reports of this program; what it
compares counts."""

import os
import shutil
from pathlib import Path

import pytest

from calc.design.toml_file import design, read
from calc.solve import solve
from tests.command import run
from tests.conftest import DESIGNS

EXPECT = '[[expect]]\nstep = "gears"\nverdict = "pass"\n'
REPORT = '[[step]]\nreport = "out.pdf"\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copy(DESIGNS / "timing_pair.toml", tmp_path / "d.toml")
    return tmp_path


def played(folder: Path, text: str):
    (folder / "r.toml").write_text('schema = 1\ndesign = "d.toml"\n' + text, encoding="utf-8")
    return run("replay", folder / "r.toml", cwd="/")


def test_a_report_is_written_beside_the_replay_and_said_and_takes_the_place_of_one_alone(folder: Path) -> None:
    done = played(folder, REPORT + EXPECT)
    out = folder / "out.pdf"
    assert done.returncode in (0, 1) and f"writes {out}\n" in done.stdout and "of 1 as expected" in done.stdout
    first = out.read_bytes()
    assert played(folder, '[[step]]\nset = "name"\nto = "another"\n' + REPORT + EXPECT).returncode == done.returncode
    second = out.read_bytes()
    assert first != second and sorted(path.name for path in folder.iterdir()) == ["d.toml", "out.pdf", "r.toml"]
    appended = second + b"\n% signed\n" + second[second.rindex(b"startxref") :]
    for other in (b"%PDF-1.7\n%%EOF\n", b"my own notes", appended, b""):
        out.write_bytes(other)
        refused = played(folder, REPORT + EXPECT)
        assert (
            refused.returncode == 2
            and "out.pdf: is there, and is no report as this program writes it" in refused.stderr
        )
        assert refused.stdout == "" and out.read_bytes() == other


@pytest.mark.skipif(os.name != "posix", reason="links and pipes of POSIX")
@pytest.mark.parametrize("kind", ["link to nothing", "link", "pipe", "folder"])
def test_a_report_goes_through_no_link_and_into_no_pipe(folder: Path, kind: str) -> None:
    out = folder / "out.pdf"
    if kind == "pipe":
        os.mkfifo(out)
    elif kind == "folder":
        out.mkdir()
    else:
        if kind == "link":
            (folder / "elsewhere").write_bytes(b"mine")
        out.symlink_to(folder / "elsewhere")
    before = sorted(path.name for path in folder.iterdir())
    done = played(folder, REPORT + EXPECT)
    assert done.returncode == 2 and "out.pdf: " in done.stderr and done.stdout == ""
    assert sorted(path.name for path in folder.iterdir()) == sorted([*before, "r.toml"])


def test_a_replay_that_compares_nothing_has_failed(folder: Path) -> None:
    done = played(folder, "expect = []\n")
    assert done.returncode == 1 and done.stdout == f"{folder / 'r.toml'}: nothing was compared: it has no [[expect]]\n"
    assert played(folder, "").returncode == 2


def test_odd_names_are_bad_input(folder: Path) -> None:
    for line in ('report = "a\\u0000.pdf"', 'report = "../d.toml"', 'report = "d.toml"'):
        done = played(folder, f"[[step]]\n{line}\n" + EXPECT)
        assert (
            done.returncode == 2
            and "r.toml:4: step.0.report: " in done.stderr
            and "must be the bare name" in done.stderr
        )


def test_update_rewrites_what_was_recorded_and_nothing_else(folder: Path) -> None:
    text = (
        "# a ratio that was another once\n"
        '[[expect]]\nvalue = "gears.pair.ratio"\nis = 1.1  # of the first teeth\n'
        'unit = ""\nrel = 1e-3\nkind = "recorded"\n'
        '[[expect]]\nstep = "gears"\nverdict = "no_solution"\nkind = "recorded"\n'
        '[[expect]]\nstep = "engine"\nverdict = "fail"\n'
    )
    file = folder / "r.toml"
    name = next(v.id for v in solve(design(read(folder / "d.toml"))).values().values() if "contact_ratio" in v.id)
    assert played(folder, text.replace("gears.pair.ratio", name)).returncode == 1
    before = file.read_text("utf-8")
    done = run("replay", file, "--update", cwd="/")
    after = file.read_text("utf-8")
    assert done.returncode == 1, "what nobody recorded still differs"
    assert f"  {name}: 1.1 ± 1.1·10⁻³ → " in done.stdout and "  gears: no_solution → " in done.stdout
    assert "✗ engine: not_asked, expected fail" in done.stdout
    changed = [(a, b) for a, b in zip(before.splitlines(), after.splitlines(), strict=True) if a != b]
    assert (
        len(changed) == 2
        and changed[0][1].endswith("# of the first teeth")
        and changed[1][0] == 'verdict = "no_solution"'
    )
    assert not (folder / "r.toml.bak").exists()
    again = run("replay", file, "--update", cwd="/")
    assert " → " not in again.stdout and "2 of 3 as expected" in again.stdout and file.read_text("utf-8") == after
