# SPDX-License-Identifier: Apache-2.0
"""`contralbero choose FILE bearings`: the tables, the row that is written and holds, and what is said where nothing passes."""

import json

import pytest

from .conftest import DESIGNS
from .test_cli import run


@pytest.fixture
def copy(tmp_path):
    def made(name):
        path = tmp_path / f"{name}.toml"
        path.write_text((DESIGNS / f"{name}.toml").read_text(encoding="utf-8"), encoding="utf-8")
        return path

    return made


@pytest.mark.parametrize(
    "name, row", [("r753ie4_gamma", 1), ("r753ie4_gamma", 2), ("r753ie4_beta", 1), ("r753ie4_sized", 1), ("r753ie4_sized", 12)]
)
def test_a_row_that_is_written_passes(copy, name, row):
    path = copy(name)
    before = path.read_text(encoding="utf-8")
    done = run("choose", path, "bearings", "--apply", row)
    assert done.returncode == 0 and f"the bearings of row {row}" in done.stdout, done.stderr
    assert path.with_suffix(".toml.bak").read_text(encoding="utf-8") == before
    checks = json.loads(run("check", path, "--step", "bearings", "--json").stdout)["checks"]
    assert [c["id"] for c in checks if c["verdict"] == "fail"] == []
    corner = [c for c in checks if c["id"].endswith("_corner")]
    assert len(corner) == 8 and all(c["margin"] >= 0 for c in corner)


def test_the_json_has_all_tables(copy):
    path = copy("r753ie4_gamma")
    found = json.loads(run("choose", path, "bearings", "--json", "--top", "50").stdout)
    assert found["step"] == "bearings" and set(found["tables"]) == {"neighbours", "pareto"}
    labels = [c["label"] for c in found["columns"]]
    rows = [row for row in found["rows"] if row[0]]
    power = [row[labels.index("P_f")] for row in rows]
    assert rows[0][1] == "nearest" and power[1:] == sorted(power[1:])
    assert "1 is nearest to the design: front length 27.5 → 36.5 mm, rear length 26.5 → 30 mm." in found["note"]
    assert "sectors that give way" in found["note"] and "countershaft.crossing" in found["note"]
    last = str(int(rows[-1][0]) + 1)
    assert found["tables"]["pareto"]["rows"][0][0] == last
    assert run("choose", path, "bearings", "--apply", int(found["tables"]["pareto"]["rows"][-1][0]) + 1).returncode == 2


def test_where_nothing_passes_the_nearest_is_said(copy):
    path = copy("r753ie4_sized")
    assert run("set", path, "bearings.front.journal_roughness_um=4").returncode == 0
    done = run("choose", path, "bearings")
    assert done.returncode == 3 and done.stdout == "" and "Traceback" not in done.stderr
    assert "nearest:" in done.stderr and "film at the edge, front" in done.stderr and "corner:" in done.stderr


def test_a_design_without_bearings_is_told(copy):
    done = run("choose", copy("timing_pair"), "bearings")
    assert done.returncode == 2 and "bearings: needed" in done.stderr
