"""`contralbero sweep`."""

import csv
import json
import os
import random
import signal
import subprocess
import sys
import time
from importlib.util import find_spec

import pytest

from tests.command import run
from tests.conftest import GAMMA, ROOT


def test_sweep_writes_csv_and_says_the_verdicts(tmp_path):
    out = tmp_path / "speeds.csv"
    done = run("sweep", GAMMA, "--vary", "engine.rated_speed_rpm=1000:2600:5", "--step", "imbalance", "-o", out)
    assert done.returncode == 0 and "5 designs: 5 ▲ warn" in done.stdout  # nobody gave the unbalances
    rows = out.read_text(encoding="utf-8").splitlines()
    assert len(rows) == 6 and rows[0].startswith("engine.rated_speed_rpm,imbalance.order_1.force_forward [N]")


def test_sweep_without_a_file_prints_the_table_alone():
    done = run(
        "sweep",
        GAMMA,
        "--vary",
        "shafts.shaft.masses.rear.angle_deg=20,30",
        "--step",
        "countershaft",
        "--values",
        "countershaft.residual_order_1_couple",
    )
    assert done.returncode == 0
    assert (
        done.stdout.splitlines()[0]
        == "shafts.shaft.masses.rear.angle_deg,countershaft.residual_order_1_couple [N·m],verdict.countershaft"
    )
    assert [line.rsplit(",", 1)[1] for line in done.stdout.splitlines()[1:]] == [
        "fail",
        "not_verified",  # no strength of its steel
    ] and "2 designs" in done.stderr


def test_sweep_names_all_that_is_wrong():
    done = run("sweep", GAMMA, "--vary", "engine.rated_sped_rpm=1:2:3", "engine.cylinders=3:4:3")
    assert done.returncode == 2 and done.stdout == ""
    assert "did you mean" in done.stderr and "whole numbers" in done.stderr and "Traceback" not in done.stderr


def test_a_full_disk_behind_the_temporary_files_is_said(monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("calc.studies.sweep.table.InFolder.keep", full)
    done = run("sweep", "designs/timing_pair.toml", "--vary", "gears.face_width_mm=19,20")
    assert done.returncode == 2 and "cannot be written: No space left on device" in done.stderr and not done.stdout


@pytest.mark.parametrize("out", ["", ".", ".."])
def test_a_folder_is_no_table(tmp_path, out):
    done = run("sweep", GAMMA, "--vary", "engine.bore_mm=93,94", "--step", "imbalance", "-o", out, cwd=tmp_path)
    assert done.returncode == 2 and "cannot be written: " in done.stderr and done.stdout == ""
    assert not list(tmp_path.iterdir())


def test_a_list_of_designs(tmp_path):
    table = tmp_path / "designs.csv"
    table.write_text("engine.rated_speed_rpm,bearings.oil\n2000,SAE 30\n,SAE 50\n99999,\n", encoding="utf-8")
    done = run("sweep", GAMMA, "--list", table, "--values", "bearings.front.film", "--step", "bearings")
    assert done.returncode == 0 and "3 designs: " in done.stderr and "1 no design" in done.stderr
    rows = list(csv.DictReader(done.stdout.splitlines()))
    assert [row["engine.rated_speed_rpm"] for row in rows] == ["2000.0", "", "99999.0"] and "30000" in rows[2]["reason"]
    checked = run("check", GAMMA, "--step", "bearings", "--json", "--set", "bearings.oil=SAE 50")
    assert (
        float(rows[1]["bearings.front.film [µm]"])
        == json.loads(checked.stdout)["values"]["bearings.front.film"]["value"]
    )


def test_parts_by_their_tolerances(tmp_path):
    words = ["--tolerance", "friction.flank_roughness_um=0.1", "--monte-carlo", "8", "--values", "friction.total_loss"]
    first, again = run("sweep", GAMMA, *words), run("sweep", GAMMA, *words)
    other = run("sweep", GAMMA, *words, "--seed", "2")
    assert (
        first.returncode == 0 and first.stdout == again.stdout != other.stdout and len(first.stdout.splitlines()) == 9
    )


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ([], "needs something to vary"),
        (["--tolerance", "engine.bore_mm=1"], "needs a number of designs"),
        (["--list", "x.csv", "--vary", "a=1"], "has all that is varied"),
        (["--list", "nothing.csv"], "cannot be read"),
        (["--vary", "engine.bore_mm=80:90"], "LOW:HIGH:NUMBER"),
        (["--vary", "engine.bore_mm=80:90", "--hypercube", "0"], "1 or more"),
        (["--vary", "engine.bore_mm=80:90", "--tolerance", "engine.bore_mm=1", "--monte-carlo", "3"], "has already"),
        (["--vary", "engine.cylinders=2.5:4", "--hypercube", "3"], "whole number"),
    ],
)
def test_what_can_not_be_swept_is_named(words, reason):
    done = run("sweep", GAMMA, *words)
    assert done.returncode == 2 and reason in done.stderr and not done.stdout


def test_the_design_itself_is_not_written_over(tmp_path):
    design = tmp_path / "design.toml"
    design.write_bytes(GAMMA.read_bytes())
    done = run("sweep", design, "--vary", "engine.bore_mm=90,94", "--step", "imbalance", "-o", design)
    assert done.returncode == 2 and design.read_bytes() == GAMMA.read_bytes()


@pytest.mark.skipif(find_spec("pyarrow") is not None, reason="it is there")
def test_parquet_without_its_extra_is_told_before_anything_is_computed(tmp_path):
    done = run("sweep", GAMMA, "--vary", "engine.bore_mm=80:90:1000", "-o", tmp_path / "a.parquet")
    assert done.returncode == 2 and "contralbero[parquet]" in done.stderr and not list(tmp_path.iterdir())


KILLED = [
    "--vary",
    "engine.rated_speed_rpm=1500:2600",
    "friction.oil_temperature_C=70:110",
    "--hypercube",
    "240",
    "--values",
    "friction.total_loss",
    "bearings.front.film",
]


@pytest.mark.slow
def test_killed_at_random_and_resumed_it_writes_the_same_bytes(tmp_path):
    """Eight times, in both ways of ending: as Ctrl-C does it, and at once."""
    words = [sys.executable, "-m", "assistant", "sweep", str(GAMMA), *KILLED, "--processes", "2", "-o"]
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    begun = time.monotonic()
    subprocess.run([*words, str(tmp_path / "whole.csv")], check=True, cwd=ROOT, env=env, capture_output=True)
    took, chance, out = time.monotonic() - begun, random.Random(11), tmp_path / "killed.csv"
    for n in range(8):
        one = subprocess.Popen(
            [*words, str(out)],
            cwd=ROOT,
            env=env,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        time.sleep(chance.uniform(0.3, took / 4))
        if n % 2:
            os.killpg(one.pid, signal.SIGINT)  # workers too, as a terminal does
        else:
            one.kill()
        _, errors = one.communicate()
        assert one.returncode in (0, 130, -signal.SIGINT, -signal.SIGKILL)
        assert b"Traceback" not in errors or not n % 2, errors.decode()
    subprocess.run([*words, str(out)], check=True, cwd=ROOT, env=env, capture_output=True)
    assert out.read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir() if not path.name.endswith(".bak")) == [
        "killed.csv",
        "whole.csv",
    ]


@pytest.mark.slow
def test_the_same_sweep_at_once_does_not_take_its_chunks_away(tmp_path):
    vary = ["--vary", "engine.rated_speed_rpm=1000:2600:120", "--step", "imbalance", "--processes", "1", "-o"]
    words = [sys.executable, "-m", "assistant", "sweep", str(GAMMA), *vary, str(tmp_path / "a.csv")]
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    runs = [subprocess.Popen(words, cwd=ROOT, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE)]
    for wait in (0.0, 0.2, 0.4):
        time.sleep(wait)
        runs.append(subprocess.Popen(words, cwd=ROOT, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE))
    ends = [(one.communicate()[1].decode(), one.returncode) for one in runs]
    assert all(code == 0 for _, code in ends), ends
    assert len((tmp_path / "a.csv").read_text(encoding="utf-8").splitlines()) == 121
    assert {path.name for path in tmp_path.iterdir()} <= {"a.csv", "a.csv.bak"}


@pytest.mark.skipif(find_spec("distributed") is None, reason="an extra")
def test_over_the_workers_of_a_scheduler_the_table_is_the_same(tmp_path):
    from distributed import LocalCluster

    words = ["--vary", "friction.oil_temperature_C=70:110:12", "--values", "friction.total_loss", "-o"]
    assert run("sweep", GAMMA, *words, tmp_path / "a.csv").returncode == 0
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        assert run("sweep", GAMMA, *words, tmp_path / "b.csv", "--scheduler", cluster.scheduler_address).returncode == 0
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()


@pytest.mark.parametrize(
    "words, reason",
    [
        (
            ["--vary", "gears.wheels.crank.teeth=30,33", "gears.wheels.0.teeth=40"],
            "gears.wheels.0.teeth: 40: is gears.wheels.crank.teeth, which",
        ),
        (
            ["--vary", "gears.wheels.crank.teeth=30,33", "gears.wheels.crank.teeth=40"],
            "stands twice; give all its values at once",
        ),
        (["--vary", "gears.wheels.crank.teeth=30,33", "--processes", "0"], "--processes: 0: must be 1 or more"),
        (
            ["--vary", "gears.wheels.crank.teeth=30:33", "--monte-carlo", "5", "--seed", "-1"],
            "--seed: -1: must be 0 or more",
        ),
    ],
)
def test_one_input_is_varied_once_and_each_option_answers_for_itself(words, reason):
    done = run("sweep", "designs/timing_pair.toml", *words)
    assert done.returncode == 2 and reason in done.stderr and not done.stdout


@pytest.mark.parametrize(
    "table, reason",
    [
        (
            b"gears.wheels.crank.teeth,gears.wheels.0.teeth\n30,40\n",
            ":1: gears.wheels.crank.teeth: stands in two columns; each input has one",
        ),
        (b"gears.wheels.crank.teeth\n30\xff\n", "is no text in UTF-8 (byte 27); save it again so"),
    ],
)
def test_a_list_has_one_column_for_an_input_and_is_text(tmp_path, table, reason):
    path = tmp_path / "list.csv"
    path.write_bytes(table)
    done = run("sweep", "designs/timing_pair.toml", "--list", path)
    assert done.returncode == 2 and reason in done.stderr


def test_a_sweep_tells_inputs_that_are_not_usual():
    done = run(
        "sweep",
        "designs/timing_pair.toml",
        "--vary",
        "gears.face_width_mm=0.1:0.3:3",
        "--values",
        "gears.crank_camshaft.centre_distance",
    )
    assert "1 input is not usual: face width 0.1 mm (usual 5 to 80)" in done.stderr and "not usual" not in done.stdout
