# SPDX-License-Identifier: Apache-2.0
"""What commands write: never over what they read, nothing but regular files, and no edit of another run is lost."""

import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tests.command import run
from tests.conftest import DESIGNS, GAMMA, ROOT
from tests.reports.test_title_block import png

VARY = ["--vary", "engine.rated_speed_rpm=1000:2000:2", "--step", "imbalance"]
EDITS = {
    "engine.rod_length_mm": 163.5,
    "engine.rod_mass_g": 1201.0,
    "bearings.front.length_mm": 31.0,
    "bearings.rear.length_mm": 32.0,
}


@pytest.fixture
def design(tmp_path: Path) -> Path:
    """Under a name that every command takes for its output."""
    return shutil.copy(GAMMA, tmp_path / "d.pdf")


@pytest.mark.parametrize(
    "arguments",
    [
        ["sweep", "d.pdf", *VARY, "-o", "d.pdf"],
        ["sweep", "d.pdf", *VARY, "-o", "link"],
        ["report", "d.pdf", "-o", "d.pdf"],
        ["report", "d.pdf"],
        ["compare", "d.pdf", "other.toml", "-o", "d.pdf"],
        ["compare", "other.toml", "d.pdf", "-o", "link"],
        ["export", "d.csv", "-o", "d.csv"],
        ["design", "drive.toml", "--out", ".", "--pick", "1", "-o", "drive.toml"],
    ],
)
def test_no_command_writes_over_its_input(design: Path, arguments: list[str]) -> None:
    folder = design.parent
    shutil.copy(GAMMA, folder / "other.toml")
    shutil.copy(GAMMA, folder / "d.csv")
    shutil.copy(DESIGNS / "r753ie4_drive.toml", folder / "drive.toml")
    (folder / "link").symlink_to(design)
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    done = run(*arguments, cwd=folder)
    assert done.returncode == 2 and "Traceback" not in done.stderr
    assert "an input of this very command" in done.stderr or "--pick" in done.stderr, done.stderr
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_a_report_is_not_written_over_the_logo_beside_its_design(tmp_path: Path) -> None:
    path = shutil.copy(DESIGNS / "timing_pair.toml", tmp_path / "d.toml")
    path.write_text(path.read_text("utf-8") + '\n[document]\nlogo = "logo.png"\n', "utf-8")
    (tmp_path / "logo.png").write_bytes(before := png())
    (tmp_path / "r.pdf").symlink_to(tmp_path / "logo.png")
    done = run("report", path, "--depth", "summary", "-o", tmp_path / "r.pdf", cwd=tmp_path)
    assert done.returncode == 2 and "an input of this very command" in done.stderr
    assert (tmp_path / "logo.png").read_bytes() == before


@pytest.mark.skipif(os.name != "posix", reason="devices and pipes of POSIX")
@pytest.mark.parametrize("arguments", [["sweep", GAMMA, *VARY, "-o"], ["schema", "-o"]], ids=lambda words: words[0])
@pytest.mark.parametrize("kind", ["/dev/null", "pipe", "folder"])
def test_only_regular_files_are_written(tmp_path: Path, arguments: list[object], kind: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    done = run(*arguments, tmp_path / kind, cwd=tmp_path)
    assert done.returncode == 2 and "cannot be written: " in done.stderr
    assert "Is a directory" in done.stderr if kind == "folder" else "it is no regular file" in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["folder", "pipe"]


@pytest.mark.parametrize("command", ["check", "report", "explain", "verify", "replay", "set"])
@pytest.mark.parametrize("kind", ["/dev/zero", "pipe", "large"])
def test_only_regular_files_of_a_stated_size_are_read(tmp_path: Path, command: str, kind: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    with (tmp_path / "large").open("wb") as file:
        file.truncate(2**36)
    more = {"explain": ["engine.lambda"], "set": ["engine.bore_mm=95"]}.get(command, [])
    done = run(command, tmp_path / kind, *more, cwd=tmp_path)
    assert done.returncode == 2 and "cannot be read: it " in done.stderr and "Traceback" not in done.stderr
    assert ("no regular file" if kind != "large" else "at most") in done.stderr


def test_edits_of_four_runs_at_once_are_all_there(tmp_path: Path) -> None:
    path = shutil.copy(GAMMA, tmp_path / "d.toml")
    command = [sys.executable, "-m", "assistant", "set", path]
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    runs = [
        subprocess.Popen([*command, f"{key}={value}"], env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for key, value in EDITS.items()
    ]
    assert [(done.communicate()[1], done.returncode) for done in runs] == [(b"", 0)] * len(EDITS)
    there = tomllib.loads(path.read_text("utf-8"))
    for key, value in EDITS.items():
        here = there
        for part in key.split("."):
            here = here[part]
        assert here == value, key
    assert sorted(one.name for one in tmp_path.iterdir()) == ["d.toml", "d.toml.bak"]


def test_a_choice_is_not_written_over_what_another_program_wrote_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from assistant.commands import choose

    path = shutil.copy(GAMMA, tmp_path / "d.toml")
    offer_for = choose.offer_for

    def slow(*given: object, **more: object) -> object:
        path.write_bytes(path.read_bytes() + b"# of another\n")
        return offer_for(*given, **more)

    monkeypatch.setattr(choose, "offer_for", slow)
    done = run("choose", path, "engine", "--apply", "1")
    assert done.returncode == 2 and "another program has changed it" in done.stderr
    assert path.read_bytes().endswith(b"# of another\n")


def test_two_designs_of_one_name_do_not_share_an_output(tmp_path: Path) -> None:
    source = DESIGNS / "thesis_oils.toml"
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        shutil.copy(source, tmp_path / name / "d.toml")
    done = run("scenarios", "a/d.toml", "b/d.toml", "-o", "out", cwd=tmp_path)
    assert done.returncode == 2 and "would be written for two designs" in done.stderr
