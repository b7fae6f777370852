# SPDX-License-Identifier: Apache-2.0
"""The program killed at work, in a real pseudo-terminal: the saved file is whole, and the edits come back."""

import fcntl
import os
import random
import select
import signal
import struct
import subprocess
import sys
import termios
import time
from pathlib import Path
from types import TracebackType

import pytest

from assistant.recovery import Memory
from assistant.screens.workbench import KEEP
from assistant.session import EXAMPLE, Session
from calc.design_file import design, read

pty = pytest.importorskip("pty")
ROOT = EXAMPLE.parent.parent
LOST = 2.0  # seconds of typing that may be lost


class Terminal:
    """The program in a terminal of its own, which is killed at the end of the block."""

    def __init__(self, path: Path, state: Path) -> None:
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.chdir(ROOT)
            environment = {**os.environ, "TERM": "xterm-256color", "XDG_STATE_HOME": str(state)}
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

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.kill()


@pytest.fixture
def state(tmp_path: Path) -> Path:
    return tmp_path / "state"


def reopened(path: Path, state: Path) -> Session:
    return Session.open(path, memory=Memory(state / "contralbero"))


@pytest.mark.parametrize("seconds", [2.3, 4.1])
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
    name = session.text("engine.name")
    sure = max((n for when, n in typed if when < killed - LOST), default=0)
    assert set(name) == {"x"} and sure <= len(name) <= count
    assert session.dirty and "not saved" in session.message
    session.undo()
    assert not session.dirty


def test_an_entry_that_is_not_accepted_comes_back(light: Session, state: Path) -> None:
    with Terminal(light.home, state) as terminal:
        terminal.write("\t\t\t\t12x")  # the bore
        terminal.until(b"autosaved")
        terminal.kill()
    session = reopened(light.home, state)
    assert session.text("engine.bore_mm") == "12x" and session.reason("engine.bore_mm")


def whole(session: Session, old: str, new: str) -> str:
    """The name that the file has; all else of it must be as it was, and the file before it must be whole too."""
    path = session.home
    found = str(design(read(path)).engine.name)
    assert found in (old, new)
    line = 'name = "{}"\nlayout'.format
    assert path.read_text(encoding="utf-8") == session.bytes().decode("utf-8").replace(line(session.text("engine.name")), line(found))
    if (kept := path.with_name(path.name + ".bak")).exists():
        assert design(read(kept)).engine.name in (old, new)
    return found


def test_killed_at_a_save_the_file_is_one_of_the_two_versions_and_whole(light: Session, state: Path) -> None:
    """At moments around the save of a program in a terminal; what was typed is on disk or comes back."""
    chance = random.Random(7)
    old = light.text("engine.name")
    for moment in range(3):
        with Terminal(light.home, state) as terminal:
            terminal.write(new := f"name {moment}")
            terminal.until(b"edited")
            terminal.read(KEEP + 0.3 if moment == 0 else 0.1)
            terminal.write("\x13")  # ctrl+s
            terminal.read(chance.uniform(0.0, 0.05))
            terminal.kill()
        old = whole(light, old, new)
        again = reopened(light.home, state)
        assert again.text("engine.name") in (old, new) and (moment > 0 or again.text("engine.name") == new)


KILLED = """
import os, signal, sys
from pathlib import Path
from assistant.recovery import Memory
from assistant.screens.workbench import KEEP
from assistant.session import Session

session = Session.open(Path(sys.argv[1]), memory=Memory(Path(sys.argv[2])))
session.edit("engine.name", "new name")
session.autosave()
left = int(sys.argv[3])

def killed_at(name, call):
    def instead(*given, **named):
        global left
        left -= 1
        if left == 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return call(*given, **named)
    return instead

for name in ("open", "fsync", "chmod", "replace", "unlink", "close"):
    setattr(os, name, killed_at(name, getattr(os, name)))
Path.write_bytes = killed_at("write_bytes", Path.write_bytes)
session.save()
"""


def test_a_save_that_is_cut_off_at_any_of_its_steps(light: Session, state: Path) -> None:
    """Killed right before the first, the second … thing that it asks of the system, until it comes to its end."""
    old, seen = light.text("engine.name"), []
    start = light.home.read_bytes()
    for step in range(1, 40):
        light.home.write_bytes(start)
        done = subprocess.run([sys.executable, "-c", KILLED, str(light.home), str(state / "contralbero"), str(step)], cwd=ROOT)
        seen.append(whole(light, old, "new name"))
        again = reopened(light.home, state)
        assert again.text("engine.name") == "new name"  # it was kept before it was saved
        if done.returncode == 0:
            break
        assert done.returncode == -signal.SIGKILL
    assert seen[0] == old and seen[-1] == "new name" and len(seen) > 5
