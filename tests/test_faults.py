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


def broken(state: Path, first: str = "", **environment: str) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, "PYTHONPATH": str(ROOT), "XDG_STATE_HOME": str(state), **environment}
    words = [sys.executable, "-c", first + BROKEN, PAIR]
    return subprocess.run(words, capture_output=True, text=True, cwd=ROOT, env=env)


def test_a_fault_is_told_in_one_line_and_its_trace_is_kept(tmp_path: Path) -> None:
    done = broken(tmp_path)
    (trace,) = tmp_path.glob("contralbero/faults/contralbero-fault-*.txt")
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
    (trace,) = tmp_path.glob("contralbero-fault-*.txt")
    assert done.returncode == 70 and str(trace) in done.stderr
    assert trace.stat().st_mode & 0o077 == 0  # the trace has names of the user's files


def test_in_a_folder_that_is_everybodys_no_link_is_followed_and_no_file_of_another_goes(tmp_path: Path) -> None:
    """The name of the trace is not known before: what is guessed from the time and the process leads nowhere."""
    blocked, victim = tmp_path / "file", tmp_path / "victim"
    blocked.write_text("")
    victim.write_text("precious")
    everybodys = tmp_path / "tmp"
    everybodys.mkdir()
    theirs = [everybodys / f"fault-20200101-0000{n:02d}-{n}.txt" for n in range(40)]
    for path in theirs:
        path.write_text("another's")
    script = f"""
import os
from datetime import datetime, timedelta
from pathlib import Path
for second in range(-1, 20):
    when = datetime.now() + timedelta(seconds=second)
    for name in ("fault", "contralbero-fault"):
        os.symlink({str(victim)!r}, Path({str(everybodys)!r}) / f"{{name}}-{{when:%Y%m%d-%H%M%S}}-{{os.getpid()}}.txt")
"""
    done = broken(blocked, script, TMPDIR=str(everybodys))
    assert done.returncode == 70 and victim.read_text() == "precious"
    assert all(path.exists() for path in theirs)
    (trace,) = [path for path in everybodys.iterdir() if not path.is_symlink() and path not in theirs]
    assert str(trace) in done.stderr and "KeyError" in trace.read_text(encoding="utf-8")


def test_a_state_folder_that_leads_elsewhere_loses_no_file_there(tmp_path: Path) -> None:
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    for n in range(30):
        (elsewhere / f"fault-20200101-0000{n:02d}-1.txt").write_text("")
    (tmp_path / "contralbero").mkdir()
    (tmp_path / "contralbero" / "faults").symlink_to(elsewhere)
    assert broken(tmp_path).returncode == 70 and len(list(elsewhere.iterdir())) == 31


def test_only_the_last_traces_are_kept(tmp_path: Path) -> None:
    folder = tmp_path / "contralbero" / "faults"
    folder.mkdir(parents=True)
    for n in range(30):
        (folder / f"fault-20200101-0000{n:02d}-1.txt").write_text("")
    (folder / "fault-of-mine.txt").write_text("")
    done = broken(tmp_path)
    (trace,) = folder.glob("contralbero-*")
    assert str(trace) in done.stderr
    assert len(list(folder.iterdir())) == 21 and (folder / "fault-of-mine.txt").exists()


NO_MEMORY = {
    "while it works": "check.solve = lambda design: [].extend(bytearray(2**62) for _ in range(9))",
    "while the fault is told": """
import assistant.output
def told(error): raise MemoryError
assistant.output.kept = told
""",
    "while a module is loaded": """
class Finder:
    def find_spec(self, name, *_):
        if name in ("assistant.cli", "assistant.usage"): raise MemoryError
for name in [name for name in sys.modules if name.startswith("assistant.")]: del sys.modules[name]
sys.meta_path.insert(0, Finder())
""",
}


@pytest.mark.parametrize("when", NO_MEMORY)
def test_out_of_memory_is_a_fault_and_no_verdict(tmp_path: Path, when: str) -> None:
    script = BROKEN.replace("sys.argv =", NO_MEMORY[when] + "\nsys.argv =")
    env = {**os.environ, "PYTHONPATH": str(ROOT), "XDG_STATE_HOME": str(tmp_path)}
    done = subprocess.run([sys.executable, "-c", script, PAIR], capture_output=True, text=True, cwd=ROOT, env=env)
    assert done.returncode == 70 and done.stderr.count("\n") == 1 and "MemoryError" in done.stderr, done.stderr


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="limits of memory")
def test_with_ever_less_memory_it_ends_by_a_verdict_or_by_a_fault(tmp_path: Path) -> None:
    import resource

    env = {**os.environ, "PYTHONPATH": str(ROOT), "XDG_STATE_HOME": str(tmp_path)}
    words = [sys.executable, "-m", "assistant", "check", PAIR]
    for mega in range(30, 260, 7):
        limit = (mega * 2**20,) * 2
        done = subprocess.run(
            words,
            capture_output=True,
            text=True,
            cwd=ROOT,
            env=env,
            preexec_fn=lambda limit=limit: resource.setrlimit(resource.RLIMIT_AS, limit),
        )
        assert done.returncode in (0, 70), (mega, done.stderr)  # below some 30 MB Python itself does not start


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
