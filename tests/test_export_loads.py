"""`contralbero export --loads`: its files, what it says of them, and what it refuses."""

import json

import pytest

from assistant.cli import main
from tests.conftest import DESIGNS

ALPHA = DESIGNS / "r753ie4_alpha.toml"  # a shaft without gears and bearings
GEARS = DESIGNS / "timing_pair.toml"  # gears alone


def run(capsys, *arguments):
    code = main(["export", *map(str, arguments)])
    return code, *capsys.readouterr()


def test_the_table_and_what_is_said_of_it(capsys, tmp_path):
    out = tmp_path / "loads.csv"
    code, said, errors = run(capsys, ALPHA, "--loads", "-o", out, "--speeds", "900:2600:800")
    assert (code, errors) == (0, "")
    lines = out.read_text(encoding="utf-8").splitlines()
    header = next(line for line in lines if not line.startswith("#"))
    assert header.startswith("speed_rpm,kind,place,on,order,X_mm,Y_mm,Z_mm,FX_N,FX_deg,") and header.endswith(",MZ_deg")
    speeds = {line.split(",")[0] for line in lines if line[0].isdigit()}
    assert speeds == {"900.0", "1700.0", "2500.0"}
    assert "rows (bearing 6, engine 18); sums close to" in said and str(out) in said
    before = out.read_bytes()
    assert run(capsys, ALPHA, "--loads", "-o", out, "--speeds", "900:2600:800", "--quiet")[0] == 0
    assert out.read_bytes() == before


def test_to_standard_output(capsys):
    code, said, _ = run(capsys, ALPHA, "--loads", "-o", "-", "--variant", "half", "--speeds", "2600:2600:1", "--quiet")
    assert code == 0
    assert said.splitlines()[-1].startswith("2600.0,engine")  # a table, where no ending says otherwise
    assert "bearing" not in {line.split(",")[1] for line in said.splitlines() if line[0].isdigit()}


def test_json(capsys, tmp_path):
    out = tmp_path / "loads.json"
    assert run(capsys, ALPHA, "--loads", "-o", out)[0] == 0
    of = json.loads(out.read_text(encoding="utf-8"))
    assert list(of) == ["frame", "rows"] and of["frame"]["harmonics"].startswith("amplitudes are peaks, N and N·m")
    assert [row["speed_rpm"] for row in of["rows"]] == sorted(row["speed_rpm"] for row in of["rows"])
    assert of["rows"][-1]["speed_rpm"] == 2600.0


@pytest.mark.parametrize(
    "given, words",
    [
        (["--speeds", "900-2600"], "must be LO:HI:STEP, three numbers"),
        (["--speeds", "900:800:10"], "LO not above HI"),
        (["--speeds", "900:nan:10"], "0 < LO"),
        (["--speeds", "900:5300:100"], "HI is at most 5200 rpm"),
        (["--speeds", "1:5000:1"], "at most 200"),
        (["--variant", "scatter"], "it has half, shaft"),
    ],
)
def test_what_is_refused(capsys, tmp_path, given, words):
    code, _, errors = run(capsys, ALPHA, "--loads", "-o", tmp_path / "x.csv", *given)
    assert code == 2 and words in errors and given[0] in errors
    assert not (tmp_path / "x.csv").exists()


def test_all_mistakes_at_once(capsys, tmp_path):
    wrong = ["--speeds", "x", "--variant", "tooth"]
    code, _, errors = run(capsys, ALPHA, "--loads", "-o", tmp_path / "x.csv", *wrong)
    assert code == 2 and len(errors.splitlines()) == 2


def test_without_an_engine_there_are_none(capsys, tmp_path):
    code, _, errors = run(capsys, GEARS, "--loads", "-o", tmp_path / "x.csv")
    assert code == 2 and "needed for loads: add [engine]" in errors
    code, _, errors = run(capsys, ALPHA, "--csv", "-o", tmp_path / "x.csv", "--speeds", "1:2:1")
    assert code == 2 and "is for --loads, not for --csv" in errors
