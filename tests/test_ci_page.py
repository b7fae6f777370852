# SPDX-License-Identifier: Apache-2.0
"""What the README and docs/ci.md say about designs in CI: the very lines are run by a shell, and the workflow files have
the same."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.conftest import DESIGNS, ROOT

PAGES = [ROOT / "README.md", ROOT / "README.it.md", ROOT / "docs" / "ci.md"]
LINES = re.compile(r"(?:^ *contralbero (?:record|report designs|replay) .*\n){3}", re.MULTILINE)
IN_WORKFLOW = re.compile(r"^ +- (?:run: )?(contralbero .*)$", re.MULTILINE)


def lines_of(page: Path) -> list[str]:
    (block,) = LINES.findall(page.read_text(encoding="utf-8"))
    return [line.strip() for line in block.splitlines()]


def shell(lines: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    program = f"set -e; contralbero() {{ '{sys.executable}' -m assistant \"$@\"; }}"
    script = "\n".join([program, *lines])
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.run(["bash", "-c", script], capture_output=True, text=True, cwd=folder, env=env)


def test_the_pages_and_the_workflow_files_have_the_same_lines() -> None:
    once, *each_push = lines_of(PAGES[0])
    assert all(lines_of(page) == [once, *each_push] for page in PAGES)
    assert IN_WORKFLOW.findall(PAGES[-1].read_text(encoding="utf-8")) == each_push * 2  # GitHub and GitLab


@pytest.mark.parametrize("count", [2, *(pytest.param(n, marks=pytest.mark.slow) for n in (1, 20))])
def test_a_folder_of_designs_is_guarded_by_these_lines(tmp_path: Path, count: int) -> None:
    (tmp_path / "designs").mkdir()
    for n in range(count):
        shutil.copy(DESIGNS / "timing_pair.toml", tmp_path / "designs" / f"pair{n}.toml")
    lines = lines_of(ROOT / "README.md")
    done = shell(lines, tmp_path)
    assert done.returncode == 0, done.stderr
    assert len([pdf for pdf in (tmp_path / "reports").iterdir() if pdf.read_bytes().startswith(b"%PDF")]) == count
    suites = ElementTree.parse(tmp_path / "replays.xml").getroot()
    assert len(suites) == count and all(int(one.get("tests", 0)) >= 5 for one in suites)
    edited = tmp_path / "designs" / "pair0.toml"
    edited.write_text(edited.read_text("utf-8").replace("face_width_mm = 23.0", "face_width_mm = 20.0"), "utf-8")
    assert shell(lines[-1:], tmp_path).returncode == 1
    suites = ElementTree.parse(tmp_path / "replays.xml").getroot()
    assert [one.get("name") for one in suites if one.get("failures") != "0"] == ["replays/pair0.toml"]
