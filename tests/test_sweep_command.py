"""`contralbero sweep`."""

from .command import run
from .conftest import GAMMA


def test_sweep_writes_csv_and_says_the_verdicts(tmp_path):
    out = tmp_path / "speeds.csv"
    done = run("sweep", GAMMA, "--vary", "engine.rated_speed_rpm=1000:2600:5", "--step", "imbalance", "-o", out)
    assert done.returncode == 0 and "5 designs: 5 ✓ pass" in done.stdout
    rows = out.read_text(encoding="utf-8").splitlines()
    assert len(rows) == 6 and rows[0].startswith("engine.rated_speed_rpm,imbalance.order_1.force_forward [N]")


def test_sweep_without_a_file_prints_the_table_alone():
    done = run(
        "sweep",
        GAMMA,
        "--vary",
        "countershaft.masses.rear.angle_deg=20,30",
        "--step",
        "countershaft",
        "--values",
        "countershaft.residual_order_1_couple",
    )
    assert done.returncode == 0
    assert (
        done.stdout.splitlines()[0] == "countershaft.masses.rear.angle_deg,countershaft.residual_order_1_couple [N·m],verdict.countershaft"
    )
    assert [line.rsplit(",", 1)[1] for line in done.stdout.splitlines()[1:]] == ["fail", "warn"] and "2 designs" in done.stderr


def test_sweep_names_all_that_is_wrong():
    done = run("sweep", GAMMA, "--vary", "engine.rated_sped_rpm=1:2:3", "engine.cylinders=3:4:3")
    assert done.returncode == 2 and done.stdout == ""
    assert "did you mean" in done.stderr and "whole numbers" in done.stderr and "Traceback" not in done.stderr
