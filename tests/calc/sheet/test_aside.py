"""Work done by a copy of the process gives what it gives here, also where no copy can be made or the copy is lost."""

import os
import select
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from calc.sheet.deferred import aside, prepared

ROOT = Path(__file__).parents[3]
CAN = sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1


@pytest.fixture(autouse=True)
def alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """A test of another file may have left a thread asleep, beside which no copy would be made."""
    others = [thread for thread in threading.enumerate() if thread is not threading.main_thread()]
    counted = threading.active_count
    monkeypatch.setattr(threading, "active_count", lambda: counted() - sum(thread.is_alive() for thread in others))


def ended() -> int:
    """The exit code of the copy; a failure where it does not end."""
    for _ in range(200):
        pid, status = os.waitpid(-1, os.WNOHANG)
        if pid:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.05)
    pytest.fail("the copy still waits")


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_another_process_has_done_it() -> None:
    assert aside(os.getpid)() != os.getpid()


def test_beside_other_threads_it_is_done_here() -> None:
    end = threading.Event()
    other = threading.Thread(target=end.wait)
    other.start()
    try:
        assert aside(os.getpid)() == os.getpid()
    finally:
        end.set()
        other.join()


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_what_fails_there_fails_here(capfd: pytest.CaptureFixture[str]) -> None:
    def fails() -> int:
        raise KeyError(os.getpid())

    waiting = aside(fails)
    with pytest.raises(KeyError) as error:
        waiting()
    assert error.value.args == (os.getpid(),) and capfd.readouterr() == ("", "")


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_what_a_copy_can_not_send_is_made_here() -> None:
    made = aside(lambda: lambda: 3)()
    assert made() == 3


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_it_is_ready_before_it_is_told() -> None:
    begin = prepared(lambda: lambda given: (given, os.getpid()))
    given, other = begin({"x": [1.5, "two"]})()
    assert given == {"x": [1.5, "two"]} and other != os.getpid()


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_more_than_a_pipe_holds_goes_through_it() -> None:
    much = bytes(range(256)) * 4000
    assert prepared(lambda: bytes.upper)(much)() == much.upper()


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_a_copy_that_is_lost_before_it_is_told_is_not_missed() -> None:
    here = os.getpid()

    def ready() -> Callable[[int], int]:
        if os.getpid() != here:
            os._exit(1)
        return lambda given: given + 1

    begin = prepared(ready)
    time.sleep(0.1)
    assert begin(4)() == 5


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_a_copy_that_nobody_tells_anything_ends() -> None:
    begin = prepared(lambda: lambda given: given)
    del begin
    assert ended() == 0


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_a_copy_whose_answer_nobody_takes_ends() -> None:
    """One that is larger than what a pipe holds, too: who asked was killed, or met a fault."""
    wait = prepared(lambda: bytes.upper)(bytes(1_000_000))
    del wait
    ended()


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_a_copy_shows_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    assert aside(lambda: os.write(1, b"there") + os.write(2, b"there"))() == 10
    assert capfd.readouterr() == ("", "")


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_who_waits_for_the_end_of_the_output_does_not_wait_for_a_copy() -> None:
    code = "import time; from calc.sheet.deferred import aside; kept = aside(lambda: time.sleep(100)); print('end')"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=20)
    assert (done.returncode, done.stdout, done.stderr) == (0, "end\n", "")


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
@pytest.mark.parametrize("way", ["os.kill(os.getpid(), 9)", "os.kill(os.getpid(), 15)", "raise SystemExit(3)"])
@pytest.mark.parametrize(
    "work",
    [
        "prepared(lambda: work)",  # is told nothing
        "aside(lambda: work(0))",  # is at work
        "(aside(lambda: bytes(10**6)), time.sleep(0.2))",  # has more to say than a pipe holds, and nobody listens
        "(aside(lambda: bytes(10**6)), aside(lambda: work(0)), time.sleep(0.2))",  # one knows the pipes of the other
    ],
)
def test_no_copy_is_left_however_this_process_ends(work: str, way: str) -> None:
    head = "import os, time\nfrom calc.sheet.deferred import aside, prepared\ndef work(given): time.sleep(100)\n"
    inner, outer = os.pipe()  # every copy has it, and a last one closes it
    process = subprocess.Popen([sys.executable, "-c", f"{head}kept = {work}\n{way}"], cwd=ROOT, pass_fds=[outer])
    os.close(outer)
    process.wait(20)
    with open(inner, "rb") as pipe:
        assert select.select([pipe], [], [], 5)[0], "somebody has the pipe open"
