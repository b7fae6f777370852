"""A fault of the program itself is no verdict: exit 70, one line, a trace that is kept; Ctrl-C is quiet at any
moment."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from assistant import cli
from tests.conftest import DESIGNS, ROOT

PAIR = str(DESIGNS / "timing_pair.toml")
BROKEN = """
import sys
import assistant.commands.check as check
def solve(design): raise KeyError("a\\x1b[31mb\\nc")
check.solve = solve
sys.argv = ["contralbero", "check", sys.argv[1]]
from assistant.__main__ import main
sys.exit(main())
"""


def broken(state: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, "PYTHONPATH": str(ROOT), "XDG_STATE_HOME": str(state), **environment}
    return subprocess.run([sys.executable, "-c", BROKEN, PAIR], capture_output=True, text=True, cwd=ROOT, env=env)


def test_a_fault_is_told_in_one_line_and_its_trace_is_kept(tmp_path: Path) -> None:
    done = broken(tmp_path)
    (trace,) = tmp_path.glob("contralbero/faults/*.txt")
    assert done.returncode == 70 and not done.stdout
    assert (
        done.stderr.count("\n") == 1
        and str(trace) in done.stderr
        and "Traceback" not in done.stderr
        and "\x1b" not in done.stderr
    )
    assert "KeyError" in trace.read_text(encoding="utf-8") and "in solve" in trace.read_text(encoding="utf-8")


def test_where_the_state_folder_can_not_be_made_the_trace_is_kept_elsewhere(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    done = broken(blocked, TMPDIR=str(tmp_path))
    (trace,) = tmp_path.glob("fault-*.txt")
    assert done.returncode == 70 and str(trace) in done.stderr


def test_only_the_last_traces_are_kept(tmp_path: Path) -> None:
    folder = tmp_path / "contralbero" / "faults"
    folder.mkdir(parents=True)
    for n in range(30):
        (folder / f"fault-20200101-0000{n:02d}-1.txt").write_text("")
    broken(tmp_path)
    assert len(list(folder.iterdir())) == 20


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_ctrl_c_is_quiet_at_any_moment() -> None:
    chance = random.Random(7)
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    for _ in range(12):
        one = subprocess.Popen(
            [sys.executable, "-c", READY], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT, env=env
        )
        assert one.stdout is not None and one.stdout.readline() == b"ready\n"
        time.sleep(chance.uniform(0, 0.5))
        one.send_signal(signal.SIGINT)
        _, errors = one.communicate(timeout=60)
        assert one.returncode in (130, -signal.SIGINT, 0, 1) and not errors, errors.decode()


def test_ctrl_c_that_python_wraps_is_still_ctrl_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """One that comes while a class is made is told as an error of that class."""

    class Pressed:
        def __set_name__(self, owner: type, name: str) -> None:
            raise KeyboardInterrupt

    def command(*_: object, **__: object) -> int:
        return type("Made", (), {"field": Pressed()}) and 0

    monkeypatch.setattr(cli, "command", command)
    with pytest.raises(KeyboardInterrupt):
        cli.main([])


LOST = """
import time
import weakref
from assistant import __main__, cli

class Thing: pass

def presses(_):
    raise KeyboardInterrupt

def command_line():
    thing = Thing()
    held = weakref.ref(thing, presses)
    del thing
    for _ in range(1000):
        time.sleep(0.01)

cli.main = command_line
raise SystemExit(__main__.main())
"""


def test_ctrl_c_that_python_can_not_raise_is_pressed_again() -> None:
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", LOST], capture_output=True, text=True, cwd=ROOT, env=env, timeout=25)
    assert done.returncode == 130 and not done.stderr


READY = f"""
import sys
from assistant.__main__ import main
sys.argv = ["contralbero", "check", {str(DESIGNS / "r753ie4_gamma.toml")!r}]
try:
    print("ready", flush=True)
finally:
    sys.exit(main())
"""
