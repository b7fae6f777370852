# SPDX-License-Identifier: Apache-2.0
"""What `contralbero design` writes over in its folder, and what it leaves alone; how it ends when it is interrupted."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

from tests.command import run, run_apart
from tests.conftest import DESIGNS, ROOT

ONE = (
    "--vary",
    "countershaft.core_radius_mm=15",
    "bearings.rear.diameter_mm=85,86",
    "bearings.front.diameter_mm=60",
    "bearings.front.length_mm=36,37,38",
    "bearings.rear.length_mm=29,30,31",
    "countershaft.material=20CrNi4",
    "bearings.supply=hole",
    "--rows",
    "3",
    "--processes",
    "1",
    "--objectives",
    "power,mass",
)
TEXT = (DESIGNS / "r753ie4_sized.toml").read_text(encoding="utf-8")


def put(folder, name):
    folder.mkdir(exist_ok=True)
    path = folder / name
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_no_file_that_is_not_a_drive_of_its_own_front_is_touched(tmp_path):
    """The folder of the design itself, whose name and a neighbour's begin with a digit."""
    own, other = put(tmp_path, "3cyl.toml"), put(tmp_path, "2026_other.toml")
    for _ in range(2):
        assert run("design", own, "--out", tmp_path, *ONE).returncode == 0
        assert own.read_text(encoding="utf-8") == other.read_text(encoding="utf-8") == TEXT
    drives = len(json.loads((tmp_path / "front.json").read_text(encoding="utf-8"))["drives"])
    assert len(list(tmp_path.glob("0*.toml"))) == drives >= 1


@pytest.mark.parametrize("name", ["001.toml", "007.toml", "1000.toml"])
def test_a_file_named_like_a_drive_is_not_written_over(tmp_path, name):
    own, other = put(tmp_path, "own.toml"), put(tmp_path / "d", name)
    refused = run("design", own, "--out", tmp_path / "d", *ONE)
    assert refused.returncode == 2 and name in refused.stderr and other.read_text(encoding="utf-8") == TEXT
    assert run("design", other, "--out", tmp_path / "d", *ONE).returncode == 2  # nor the design itself


@pytest.mark.slow
def test_a_drive_can_not_be_searched_from_into_its_own_folder(tmp_path):
    own, out = put(tmp_path, "own.toml"), tmp_path / "d"
    assert run("design", own, "--out", out, *ONE).returncode == 0
    before = (out / "001.toml").read_bytes()
    refused = run("design", out / "001.toml", "--out", out, *ONE)
    assert refused.returncode == 2 and (out / "001.toml").read_bytes() == before
    assert run("design", out / "001.toml", "--out", tmp_path / "e", *ONE).returncode == 0


def test_every_mistake_is_said_at_once(tmp_path):
    own = put(tmp_path, "own.toml")
    wrong = (
        "--vary",
        "bearings.rear.diameter_mm=80:90",
        "countershaft.core_radius_mm=",
        "--most",
        "seat_mm=q",
        "--least",
        "margin_percent",
    )
    done = run("design", own, "--out", tmp_path / "d", *wrong, "--rows", "0")
    assert done.returncode == 2 and not (tmp_path / "d").exists()
    for one in ("diameter_mm=80:90", "core_radius_mm=", "seat_mm=q", "margin_percent", "2000"):
        assert one in done.stderr


def test_the_users_file_as_it_is_saved_in_any_notation(tmp_path):
    """Line ends of another system and a byte order mark stay, and so do the comments."""
    own = tmp_path / "own.toml"
    own.write_bytes(b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode())
    assert run("design", own, "--out", tmp_path / "d", *ONE).returncode == 0
    drive = (tmp_path / "d" / "001.toml").read_bytes()
    assert (
        drive.startswith(b"\xef\xbb\xbf") and drive.count(b"\n") == drive.count(b"\r\n") and b"# engine manual" in drive
    )
    assert run("check", tmp_path / "d" / "001.toml").returncode == 0


def started(own, out, *more):
    env = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": "1"}
    return subprocess.Popen(
        [sys.executable, "-m", "assistant", "design", str(own), "--out", str(out), *map(str, more)],
        env=env,
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


def children(pid):
    """Of one process, by the kernel's own list."""
    try:
        return [int(one) for one in open(f"/proc/{pid}/task/{pid}/children", encoding="ascii").read().split()]
    except OSError:
        return []


MANY = (
    "--vary",
    "countershaft.core_radius_mm=13:17:5",
    "bearings.rear.diameter_mm=84,85,86",
    "bearings.front.diameter_mm=58.5,62",
    "countershaft.material=20CrNi4,ADI",
    "bearings.supply=hole,shaft",
    "bearings.fits=IT7/IT7,IT6/IT6",
    "--rows",
    "6",
)


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="finds the workers in /proc")
def test_interrupted_it_keeps_what_is_confirmed(tmp_path):
    own, out = put(tmp_path, "own.toml"), tmp_path / "d"
    running = started(own, out, *MANY, "--processes", 2)
    while "1/8" not in (line := running.stdout.readline()):
        assert line, running.stderr.read()
    os.killpg(running.pid, signal.SIGINT)  # as a terminal does: the workers are told too
    said, error = running.communicate(timeout=120)
    assert running.returncode == 0, error
    assert "of 8 classes" in said and "Traceback" not in error
    drives = sorted(out.glob("0*.toml"))
    assert drives and all(run_apart("check", one).returncode == 0 for one in drives)
    assert list((out / "parts").glob("*.npz"))
    again = run("design", own, "--out", out, *MANY, "--processes", 1)
    clean = run("design", own, "--out", tmp_path / "e", *MANY, "--processes", 1)
    assert again.returncode == clean.returncode == 0
    assert (out / "front.csv").read_bytes() == (tmp_path / "e" / "front.csv").read_bytes()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="finds the workers in /proc")
def test_a_worker_that_is_killed_costs_nothing_but_time(tmp_path):
    own, out = put(tmp_path, "own.toml"), tmp_path / "d"
    running = started(own, out, *MANY, "--processes", 2)
    while "2/8" not in (line := running.stdout.readline()):
        assert line, running.stderr.read()
    workers = [pid for pid in children(running.pid) if b"spawn_main" in open(f"/proc/{pid}/cmdline", "rb").read()]
    os.kill(workers[-1], signal.SIGKILL)
    _, error = running.communicate(timeout=180)
    assert running.returncode == 0 and "Traceback" not in error, error
    assert run("design", own, "--out", tmp_path / "e", *MANY, "--processes", 1).returncode == 0
    assert (out / "front.csv").read_bytes() == (tmp_path / "e" / "front.csv").read_bytes()
    time.sleep(0.2)
    assert not [
        pid for pid in workers if os.path.exists(f"/proc/{pid}/cmdline") and open(f"/proc/{pid}/cmdline", "rb").read()
    ]


@pytest.mark.slow
def test_every_drive_of_the_shipped_search_passes_in_a_process_of_its_own(tmp_path):
    own, out = tmp_path / "own.toml", tmp_path / "d"
    own.write_text((DESIGNS / "r753ie4_drive.toml").read_text(encoding="utf-8"), encoding="utf-8")
    done = run("design", own, "--out", out, "--processes", 2)
    assert done.returncode == 0, done.stderr
    drives = sorted(out.glob("[0-9]*.toml"))
    about = json.loads((out / "front.json").read_text(encoding="utf-8"))
    assert len(drives) == len(about["drives"]) >= 40 and len(about["dropped"]) <= 1
    for one in drives:
        checked = run_apart("check", one)
        assert checked.returncode == 0, (one.name, checked.stdout)
        assert "# engine manual" in one.read_text(encoding="utf-8")
