# SPDX-License-Identifier: Apache-2.0
"""`contralbero fit`: what it prints, what it writes, and the code that it ends with."""

import json
import tomllib

import pytest

from calc.design.toml_file import load_design
from tests.command import run
from tests.engine_run import L_ROW, R_ROW, RADIUS, engine_run, fits


def test_what_is_identified_is_applied_with_its_run_beside_it(tmp_path):
    path = engine_run(tmp_path, fits(R_ROW, L_ROW), noise=1)
    before = path.read_text()
    done = run("fit", path, "engine", "--apply")
    assert done.returncode == 0 and done.stderr == ""
    assert "fit engine, of mean-piston-speed, acceleration-max: identified" in done.stdout
    assert f"as it was before: {path}.bak" in done.stdout and "engine.stroke" in done.stdout
    text = path.read_text()
    lines = {line.partition(" =")[0]: line for line in text.splitlines()}
    assert "# fitted to mean-piston-speed, acceleration-max: ± " in lines["crank_radius_mm"]
    assert lines["crank_radius_mm"].endswith("; was 53.5, measured on one")
    assert "# fitted to" in lines["rod_length_mm"]
    assert lines["piston_mass_g"] == "piston_mass_g = 1178.0          # of a drawing"
    written = tomllib.loads(text)["engine"]
    assert written["crank_radius_mm"] == pytest.approx(52, abs=0.2) and len(str(written["crank_radius_mm"])) < 9
    assert [line for line in before.splitlines() if "mm = " not in line] == [
        line for line in text.splitlines() if "mm = " not in line
    ]
    load_design(path)
    again = run("fit", path, "engine", "--apply")
    assert again.returncode == 0 and path.read_text() == text  # the comment is that of the last fit alone


def test_without_apply_nothing_is_written(tmp_path):
    path = engine_run(tmp_path, fits(R_ROW), noise=1)
    before = path.read_bytes()
    done = run("fit", path, "engine")
    assert done.returncode == 0 and path.read_bytes() == before and "--apply" in done.stdout
    done = run("fit", path, "engine", "-q")
    assert done.stdout.startswith("engine: identified, crank radius 5") and done.stdout.count("\n") == 1


@pytest.mark.parametrize(
    ("rows", "said"),
    [((R_ROW, L_ROW), "not identifiable"), ((f'key = "{RADIUS}", low = 53, high = 60',), "at its bound")],
)
def test_what_is_not_is_applied_by_nobody(tmp_path, rows, said):
    values = {"acceleration_max": 8.0} if len(rows) == 2 else {"mean_piston_speed": 0.1}
    path = engine_run(tmp_path, fits(*rows), values)
    before = path.read_bytes()
    done = run("fit", path, "engine", "--apply")
    assert done.returncode == 3 and said in done.stdout and path.read_bytes() == before
    assert "help" in done.stdout or "Widen the range" in done.stdout


def test_as_json(tmp_path):
    path = engine_run(tmp_path, fits(R_ROW), noise=1)
    found = json.loads(run("fit", path, "engine", "--json").stdout)
    assert found["verdict"] == "identified" and found["applied"] is False and found["fit"] == "engine"
    assert found["values"][f"fit.engine.{RADIUS}"]["unit"] == "mm"
    low, high = found["limits_95"][f"fit.engine.{RADIUS}"]
    assert low < found["values"][f"fit.engine.{RADIUS}"]["value"] < high
    assert found["checks"][0]["id"] == "fit.engine" and found["checks"][0]["kind"] == "method"


def test_of_standard_input(tmp_path, monkeypatch):
    """The design goes out where it came in; its run lies in the current folder."""
    from io import BytesIO, TextIOWrapper

    path = engine_run(tmp_path, fits(R_ROW), noise=1)
    monkeypatch.setattr("sys.stdin", TextIOWrapper(BytesIO(path.read_bytes())))
    done = run("fit", "-", "engine", "--apply", cwd=tmp_path)
    assert done.returncode == 0 and "fitted to" in done.stdout and "identified" in done.stderr
    assert tomllib.loads(done.stdout)["engine"]["rod_length_mm"] == 163.0


def test_a_name_that_is_none(tmp_path):
    done = run("fit", engine_run(tmp_path, fits(R_ROW)), "motor")
    assert done.returncode == 2 and "motor" in done.stderr and "there are engine" in done.stderr


def test_a_value_in_a_table_on_one_line_has_no_place_for_a_comment(tmp_path):
    more = "[[engine.bench]]\nspeed_rpm = 2000\noil_temperature_C = 100\noil_pressure_bar = 4\n"
    path = engine_run(tmp_path, fits(R_ROW, L_ROW), noise=1, more=more)
    text = path.read_text()
    at = text.index("[engine]"), text.index("[[engine.bench]]")
    rows = [line.partition("#")[0].strip() for line in text[at[0] : at[1]].splitlines()[1:] if line.strip()]
    path.write_text(text[: at[0]] + "engine = { " + ", ".join(rows) + " }\n" + text[text.index("[[measurements]]") :])
    done = run("fit", path, "engine", "--apply")
    assert done.returncode == 0 and "fitted" not in path.read_text()
    assert load_design(path).engine.rod_length == pytest.approx(0.170, abs=0.01)


@pytest.fixture(scope="module")
def checked(tmp_path_factory):
    return engine_run(tmp_path_factory.mktemp("engine"), fits(R_ROW), {"mean_piston_speed": 0.02}, noise=1)


def test_check_says_that_a_fit_is_there_and_makes_it_when_asked(checked):
    quick = run("check", checked).stdout
    assert "engine: 1 input to be found from mean-piston-speed: `contralbero fit FILE engine`, or --fits here" in quick
    done = run("check", checked, "--fits").stdout
    assert "engine: identified, crank radius 5" in done and " ± 0." in done


def test_check_as_json_has_the_values_of_fits_that_are_made(checked):
    quick = json.loads(run("check", checked, "--json").stdout)
    assert quick["fits"]["engine"] == {"of": ["mean-piston-speed"], "free": [RADIUS], "verdict": None}
    found = json.loads(run("check", checked, "--fits", "--json").stdout)
    assert found["fits"]["engine"]["verdict"] == "identified"
    assert found["values"][f"fit.engine.{RADIUS}.sd"]["unit"] == "mm"
    (check,) = [row for row in found["checks"] if row["id"] == "fit.engine"]
    assert (check["kind"], check["verdict"], check["limit"]) == ("method", "pass", 0.25)
