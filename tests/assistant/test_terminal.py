# SPDX-License-Identifier: Apache-2.0
"""The program in a real pseudo-terminal, and what it imports before its first picture."""

import json
import os
import select
import subprocess
import sys
import time
from pathlib import Path

import pytest

from assistant.app import run
from assistant.session.session import EXAMPLE

pty = pytest.importorskip("pty")
ROOT = EXAMPLE.parent.parent


def until(file: int, wanted: bytes, limit: float = 30.0) -> bytes:
    """What the program wrote, up to a text."""
    seen, end = b"", time.monotonic() + limit
    while time.monotonic() < end:
        if select.select([file], [], [], 0.1)[0]:
            try:
                seen += os.read(file, 1 << 16)
            except OSError:
                break
        if wanted in seen:
            return seen
    raise AssertionError(f"{wanted!r} was not written: {seen[-2000:]!r}")


def started(folder: Path, arguments: list[str]) -> tuple[int, int]:
    """The program in a terminal of its own: its process, and the terminal."""
    pid, file = pty.fork()
    if pid == 0:
        os.chdir(ROOT)
        environment = {
            **os.environ,
            "TERM": "xterm-256color",
            "XDG_STATE_HOME": str(folder / "state"),
            "COLUMNS": "120",
            "LINES": "40",
        }
        os.execve(sys.executable, [sys.executable, *arguments], environment)
    return pid, file


def ended(pid: int, file: int) -> int:
    """The code with which it ends on ctrl+q."""
    os.write(file, b"\x11")
    end = time.monotonic() + 20
    while time.monotonic() < end:
        if select.select([file], [], [], 0.05)[0]:
            try:
                os.read(file, 1 << 16)
            except OSError:
                pass
        gone, status = os.waitpid(pid, os.WNOHANG)
        if gone:
            return os.waitstatus_to_exitcode(status)
    os.kill(pid, 9)
    raise AssertionError("it did not end")


@pytest.mark.parametrize(
    "arguments", [["-m", "assistant"], pytest.param(["-m", "assistant.app"], marks=pytest.mark.slow)]
)
def test_it_starts_paints_solves_and_ends(design: Path, tmp_path: Path, arguments: list[str]) -> None:
    pid, file = started(tmp_path, [*arguments, str(design)])
    until(file, b"my design.toml")
    until(file, b"solved in")
    assert ended(pid, file) == 0
    assert (tmp_path / "state" / "contralbero" / "last").read_text(encoding="utf-8") == str(design)


@pytest.mark.slow
def test_alt_and_a_digit_goes_to_a_step_from_within_a_field(design: Path, tmp_path: Path) -> None:
    """As a terminal sends it: Esc and the digit."""
    pid, file = started(tmp_path, ["-m", "assistant", str(design)])
    until(file, b"Bore")
    os.write(file, b"\x1b5")
    until(file, b"Helix angle")
    assert ended(pid, file) == 0


def test_a_file_that_is_not_there_opens_the_start_page(tmp_path: Path) -> None:
    pid, file = started(tmp_path, ["-m", "assistant", str(tmp_path / "mine")])
    until(file, b"mine.toml is not there")
    assert ended(pid, file) == 0
    assert not (tmp_path / "mine.toml").exists()


def test_nothing_heavy_is_imported_before_the_first_picture() -> None:
    code = (
        "import sys, json, assistant.app\n"
        "print(json.dumps([m for m in ('numpy', 'scipy', 'textual_plot', 'matplotlib', 'reportlab', 'tomlkit', "
        "'tomli_w') if m in sys.modules]))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    assert json.loads(done.stdout) == []


def test_a_file_that_is_no_design_gives_code_2(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    (tmp_path / "a.toml").write_text("schema = 1\nname = 3\n")
    assert run(tmp_path / "a.toml") == 2
    assert "name" in capsys.readouterr().err


def test_a_fault_of_the_program_ends_the_session_in_one_line(design: Path, tmp_path: Path) -> None:
    code = (
        "import sys\nfrom assistant.screens.workbench import Workbench\n"
        "def boom(self): raise KeyError('this is the fault')\n"
        "Workbench.on_mount = boom\nfrom assistant.__main__ import main\n"
        f"sys.argv = ['contralbero', {str(design)!r}]\nsys.exit(main())"
    )
    pid, file = started(tmp_path, ["-c", code])
    seen = until(file, b".txt")
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 70
    assert b"a fault of the program itself" in seen and b"Traceback" not in seen
    (trace,) = (tmp_path / "state" / "contralbero" / "faults").iterdir()
    assert "this is the fault" in trace.read_text(encoding="utf-8")
