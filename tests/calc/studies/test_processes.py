"""Pieces of work over processes: each once, whoever is lost; no worker outlives the program."""

import os
import signal
import subprocess
import sys
import time
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from threading import Thread

import pytest

from calc.sheet.errors import Cancelled, NoSolution
from calc.studies.processes import spread
from tests.calc.studies import process_work
from tests.calc.studies.process_work import endless_but_the_first, once, slow
from tests.conftest import ROOT

PROGRAM = """
from functools import partial
from calc.studies.processes import spread
from tests.calc.studies.process_work import slow
if __name__ == "__main__":
    for n, (_, process) in spread(partial(slow, 0.1), int, range(1000), 2):
        print(process, flush=True)
"""


@pytest.fixture(autouse=True)
def _found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The work of the tests has to be found by the processes too."""
    monkeypatch.syspath_prepend(str(ROOT))


def test_over_processes_or_not_the_pieces_are_the_same() -> None:
    alone, shared = (dict(spread(partial(slow, 0.0), int, range(20), processes)) for processes in (1, 2))
    assert (
        {n: one for n, (one, _) in alone.items()}
        == {n: one for n, (one, _) in shared.items()}
        == {n: n * n for n in range(20)}
    )
    assert {process for _, process in alone.values()} == {os.getpid()} and os.getpid() not in {
        process for _, process in shared.values()
    }


def test_what_a_lost_worker_had_is_done_again(tmp_path: Path) -> None:
    assert dict(spread(partial(once, str(tmp_path)), int, range(8), 2)) == {n: n for n in range(8)}


def test_who_waits_is_heard_and_may_end_it() -> None:
    """However long a piece takes: the processes are not waited for."""
    begun, calls = time.monotonic(), 0

    def pulse() -> None:
        nonlocal calls
        calls += 1
        if calls == 3:
            raise Cancelled

    with pytest.raises(Cancelled):
        list(spread(partial(slow, 60.0), int, range(4), 2, pulse=pulse))
    assert calls == 3 and time.monotonic() - begun < 30


@pytest.mark.skipif(os.name != "posix", reason="kill")
def test_no_worker_outlives_a_program_that_is_killed(tmp_path: Path) -> None:
    file = tmp_path / "program.py"
    file.write_text(PROGRAM, encoding="utf-8")
    one = subprocess.Popen(
        [sys.executable, str(file)], stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": str(ROOT)}, cwd=ROOT
    )
    assert one.stdout is not None
    workers = {int(one.stdout.readline()) for _ in range(8)}
    one.kill()
    one.wait()
    end = time.monotonic() + 10
    while time.monotonic() < end and any(Path(f"/proc/{process}").exists() for process in workers):
        time.sleep(0.05)
    assert not [process for process in workers if Path(f"/proc/{process}").exists()]


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="/proc")
def test_work_that_is_given_up_is_not_waited_for() -> None:
    pieces = iter(spread(partial(endless_but_the_first, 60.0), int, range(4), 2))
    _, worker = next(pieces)  # has the next piece, of a minute
    pieces.close()  # type: ignore[attr-defined]
    end = time.monotonic() + 10
    while time.monotonic() < end and Path(f"/proc/{worker}").exists():
        time.sleep(0.05)
    assert not Path(f"/proc/{worker}").exists()


def test_a_scheduler_that_is_not_there_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("calc.studies.processes.ANSWER", 0.5)
    with pytest.raises(NoSolution, match=r"no scheduler answers|needs the extra `farm`"):
        list(spread(partial(slow, 0.0), int, range(2), scheduler="tcp://127.0.0.1:1"))


@pytest.mark.skipif(find_spec("distributed") is None, reason="an extra")
def test_a_worker_of_a_scheduler_that_is_lost_costs_nothing_but_time(monkeypatch: pytest.MonkeyPatch) -> None:
    from distributed import LocalCluster

    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    monkeypatch.setattr("calc.studies.processes.ABROAD", 3)
    done: dict[int, int] = {}
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        for n, (result, process) in spread(partial(slow, 0.2), int, range(12), scheduler=cluster.scheduler_address):
            if not done:
                os.kill(process, signal.SIGKILL)
            done[n] = result
    assert done == {n: n * n for n in range(12)}


@pytest.mark.skipif(find_spec("distributed") is None, reason="an extra")
def test_a_scheduler_that_goes_away_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    from distributed import LocalCluster

    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    cluster = LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None)
    pieces = spread(partial(slow, 0.2), int, range(50), scheduler=cluster.scheduler_address)
    next(pieces)
    Thread(target=cluster.close).start()
    with pytest.raises(NoSolution, match="the same command goes on"):
        list(pieces)


@pytest.mark.skipif(find_spec("distributed") is None, reason="an extra")
@pytest.mark.parametrize(
    "work, reason",
    [
        ("of_another_version", "a worker has version .* of this program, not 0.0.1"),
        ("not_there", "does not have this program"),
    ],
)
def test_a_worker_with_another_program_is_told(monkeypatch: pytest.MonkeyPatch, work: str, reason: str) -> None:
    from distributed import LocalCluster

    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    with LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as cluster:
        with pytest.raises(NoSolution, match=reason):
            list(spread(getattr(process_work, work), int, range(2), scheduler=cluster.scheduler_address))
