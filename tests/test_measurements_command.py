# SPDX-License-Identifier: Apache-2.0
"""`contralbero check` and `compare` of designs with runs of the bench."""

import json

import jsonschema
import pytest

from assistant.results_schema import results_schema
from tests.command import run
from tests.conftest import GAMMA
from tests.reports.test_runs import SMALL
from tests.test_imports import HEAVY, loaded


@pytest.fixture
def path(tmp_path):
    (tmp_path / "run.csv").write_text("n;P;F\n1300;150;140\n2600;560;550\n", encoding="utf-8")
    path = tmp_path / "a.toml"
    path.write_text(SMALL, encoding="utf-8")
    return path


def test_check_says_a_line_for_each_run(path):
    done = run("check", path)
    text = done.stdout
    assert done.returncode in (0, 1) and "run: P agrees, bias +3.08 N·m (2 nodes)\n" in text
    assert "again: F not verified, bias +13.1 N·m (2 nodes)\n" in text


def test_the_nodes_stand_with_all_tables(path):
    said = run("check", path, "--step", "imbalance").stdout
    assert "Residual\n" in said and "less" in said
    assert "run: P" not in run("check", path, "--step", "engine").stdout


def test_json_has_runs_values_and_checks_as_its_schema_says(path):
    results = json.loads(run("check", path, "--json").stdout)
    jsonschema.validate(results, results_schema())
    column = results["measurements"]["run"]["columns"]["P"]
    assert (column["verdict"], column["used"], column["runs"]) == ("agrees", 2, "not judged")
    assert results["values"]["measured.run.P.bias"]["value"] == pytest.approx(column["bias"])
    check = next(check for check in results["checks"] if check["id"] == "measured.run.P")
    assert (check["kind"], check["verdict"], check["cause"]) == ("method", "pass", "imbalance")
    assert "measured.again.F.chi2_reduced" not in results["values"]
    assert next(c for c in results["checks"] if c["id"] == "measured.again.F")["verdict"] == "not_verified"


def test_a_value_that_is_not_there_is_bad_input_with_its_line(path):
    path.write_text(SMALL.replace('"imbalance.order_1.couple_backward", unit', '"imbalance.nothing", unit'), "utf-8")
    done = run("check", path)
    line = next(n for n, text in enumerate(path.read_text("utf-8").splitlines(), 1) if "imbalance.nothing" in text)
    assert done.returncode == 2 and f"a.toml:{line}: measurements.0.columns.0.value" in done.stderr


def test_compare_has_the_runs_of_both(path):
    other = path.with_name("b.toml")
    other.write_text(SMALL.partition("\n[[measurements]]")[0].replace("1178.0", "1300.0"), "utf-8")
    assert "Runs of the bench on both" in run("compare", path, other).stdout
    both = json.loads(run("compare", path, other, "--json").stdout)["measurements"]
    assert both["a"]["measured.run.P"]["bias"] < both["b"]["measured.run.P"]["bias"]


@pytest.mark.slow
def test_a_design_without_runs_loads_nothing_of_them():
    names = loaded(f"from assistant.cli import main; main(['check', {str(GAMMA)!r}])")
    mine = {name for name in names if name.startswith("calc.measurements.") or "run" in name.rpartition(".")[2]}
    assert not mine & {f"calc.measurements.{name}" for name in ("reading", "rows", "nodes", "residuals")}
    assert not mine & {f"calc.design.{name}" for name in ("run_files", "predicted_runs", "run_results")}
    assert not names & {*HEAVY, "nptdms", "pyarrow"}
