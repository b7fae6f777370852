# SPDX-License-Identifier: Apache-2.0
"""The program killed at work, in a real pseudo-terminal: the saved file is whole, and the edits come back."""

import fcntl
import os
import random
import select
import shutil
import signal
import struct
import subprocess
import sys
import termios
import time
from pathlib import Path
from types import TracebackType

import pytest

from assistant.screens.workbench_results import KEEP
from assistant.session.recovery import Memory
from assistant.session.session import EXAMPLE, Session
from calc.design.toml_file import design, read

pty = pytest.importorskip("pty")
ROOT = EXAMPLE.parent.parent
LOST = 2.0  # seconds of typing that may be lost


class Terminal:
    """The program in a terminal of its own, which is killed at the end of the block."""

    def __init__(self, path: Path, state: Path) -> None:
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.chdir(ROOT)
            environment = {
                **os.environ,
                "TERM": "xterm-256color",
                "COLUMNS": "110",
                "LINES": "30",
                "XDG_STATE_HOME": str(state),
            }
            os.execve(sys.executable, [sys.executable, "-m", "assistant", str(path)], environment)
        fcntl.ioctl(self.file, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 110, 0, 0))
        self.seen = b""

    def __enter__(self) -> "Terminal":
        self.until(b"solved in")
        return self

    def read(self, seconds: float) -> None:
        """Take what the program writes, for a time."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if select.select([self.file], [], [], left)[0]:
                self.seen += os.read(self.file, 1 << 16)

    def until(self, wanted: bytes, limit: float = 60.0) -> None:
        end = time.monotonic() + limit
        while wanted not in self.seen:
            assert time.monotonic() < end, self.seen[-2000:]
            self.read(0.02)

    def write(self, text: str) -> None:
        os.write(self.file, text.encode())

    def kill(self) -> None:
        if self.pid:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
            os.close(self.file)
            self.pid = 0

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.kill()


@pytest.fixture
def state(tmp_path: Path) -> Path:
    return tmp_path / "state"


def reopened(path: Path, state: Path) -> Session:
    return Session.open(path, memory=Memory(state / "contralbero"))


@pytest.mark.parametrize("seconds", [2.3, pytest.param(4.1, marks=pytest.mark.slow)])
def test_at_most_two_seconds_of_typing_are_lost(light: Session, state: Path, seconds: float) -> None:
    """Typing without a pause that would be long enough to keep the edits in."""
    before = light.home.read_bytes()
    typed: list[tuple[float, int]] = []  # when, and how many letters there were then
    with Terminal(light.home, state) as terminal:
        count, begin = 0, time.monotonic()
        while time.monotonic() - begin < seconds:
            terminal.write("x")
            count += 1
            typed.append((time.monotonic(), count))
            terminal.read(0.05)
        terminal.kill()
        killed = time.monotonic()
    assert light.home.read_bytes() == before
    session = reopened(light.home, state)
    name = session.text("name")
    sure = max((n for when, n in typed if when < killed - LOST), default=0)
    assert set(name) == {"x"} and sure <= len(name) <= count
    assert session.dirty and "not saved" in session.message
    session.undo()
    assert not session.dirty


@pytest.mark.slow
def test_an_entry_that_is_not_accepted_comes_back(light: Session, state: Path) -> None:
    with Terminal(light.home, state) as terminal:
        terminal.write("\t12x")  # the bore
        terminal.until(b"autosaved")
        terminal.kill()
    session = reopened(light.home, state)
    assert session.text("engine.bore_mm") == "12x" and session.reason("engine.bore_mm")


def whole(path: Path, session: Session, old: str, new: str, *earlier: str) -> str:
    """The name that the file has; all else of it must be as it was, and the file before it must be whole too: of
    `earlier`, where the save was ended before it took the last one aside."""
    found = str(design(read(path)).name)
    assert found in (old, new)
    line = 'name = "{}"\nnote'.format
    assert path.read_text(encoding="utf-8") == session.bytes().decode("utf-8").replace(
        line(session.text("name")), line(found)
    )
    if (kept := path.with_name(path.name + ".bak")).exists():
        assert design(read(kept)).name in (old, new, *earlier)
    return found


@pytest.mark.slow
def test_killed_at_a_save_the_file_is_one_of_the_two_versions_and_whole(light: Session, state: Path) -> None:
    """At moments around the save of a program in a terminal; what was typed is on disk or comes back."""
    chance = random.Random(7)
    first = old = before = light.text("name")
    for moment in range(3):
        with Terminal(light.home, state) as terminal:
            terminal.write(new := f"name {moment}")
            terminal.until(b"edited")
            terminal.read(KEEP + 0.3 if moment == 0 else 0.1)  # the first time it is kept
            terminal.write("\x13")  # ctrl+s
            terminal.read(chance.uniform(0.0, 0.05))
            terminal.kill()
        old, first = whole(light.home, light, old, new, first), old
        there = reopened(light.home, state).text("name")
        assert there == new if moment == 0 else there in (before, new)  # what was there before is not lost in any case
        before = there


KILLED = """
import os, shutil, signal, sys
from pathlib import Path
from assistant.session.recovery import Memory
from assistant.session.session import Session
import tomlkit

path, state, folder = map(Path, sys.argv[1:])
start = path.read_bytes()

def save(left):
    session = Session.open(path, memory=Memory(state))
    session.edit("name", "new name")
    session.autosave()
    def killed_at(call):
        def instead(*given, **named):
            nonlocal left
            left -= 1
            if left == 0:
                os.kill(os.getpid(), signal.SIGKILL)
            return call(*given, **named)
        return instead
    for name in ("open", "fsync", "chmod", "replace", "unlink", "close"):
        setattr(os, name, killed_at(getattr(os, name)))
    Path.write_bytes = killed_at(Path.write_bytes)
    session.save()

for step in range(1, 40):
    for file in path.parent.glob(path.name + "*"):
        file.unlink()
    path.write_bytes(start)
    child = os.fork()
    if child == 0:
        save(step)
        os._exit(0)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    print(status, Session.open(path, memory=Memory(state)).text("name"))
    shutil.copytree(path.parent, folder / str(step))
    if status == 0:
        break
"""


def test_a_save_that_is_cut_off_at_any_of_its_steps(light: Session, state: Path, tmp_path: Path) -> None:
    """Killed right before the first, the second … thing that it asks of the system, until it comes to its end."""
    alone = tmp_path / "alone" / light.home.name
    alone.parent.mkdir()
    shutil.copy(light.home, alone)
    done = subprocess.run(
        [sys.executable, "-c", KILLED, alone, state / "contralbero", tmp_path / "steps"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    told = [line.split(" ", 1) for line in done.stdout.splitlines()]
    assert [int(status) for status, _ in told] == [-signal.SIGKILL] * (len(told) - 1) + [0] and len(told) > 5
    assert {name for _, name in told} == {"new name"}  # it was kept before it was saved
    old = light.text("name")
    found = [
        whole(tmp_path / "steps" / str(step) / light.home.name, light, old, "new name")
        for step in range(1, len(told) + 1)
    ]
    assert found == sorted(found, key=lambda name: name == "new name") and set(found) == {old, "new name"}


def test_under_nohup_a_session_ends_with_its_terminal(tmp_path: Path, state: Path) -> None:
    """Of the signal that its terminal has gone a program under nohup hears nothing, and would keep a core busy for
    ever."""
    path = tmp_path / "design.toml"
    shutil.copy(EXAMPLE, path)
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with Terminal(path, state) as terminal:
            os.close(terminal.file)
            end = time.monotonic() + 20
            while not (ended := os.waitpid(terminal.pid, os.WNOHANG))[0] and time.monotonic() < end:
                time.sleep(0.05)
            assert ended[0] and os.WIFSIGNALED(ended[1]) and os.WTERMSIG(ended[1]) == signal.SIGHUP
            terminal.pid = 0
    finally:
        signal.signal(signal.SIGHUP, before)
