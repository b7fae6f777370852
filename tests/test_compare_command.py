# SPDX-License-Identifier: Apache-2.0
"""`contralbero compare`: text, JSON, exit codes, and what is wrong with both files at once."""

import json
import re
from typing import Any

import pytest

from assistant.cli import main
from assistant.commands.compare import column_names
from calc.design.key_results import judged
from calc.design.toml_file import design, read
from calc.solve import solve
from tests.command import run
from tests.conftest import DESIGNS, GAMMA
from tests.test_imports import HEAVY, loaded

BETA = DESIGNS / "r753ie4_beta.toml"


def said(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str, str]:
    code = main(["compare", *map(str, arguments)])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    done = run("compare", BETA, GAMMA, "--json")
    assert done.returncode == 0 and done.stderr == ""
    return json.loads(done.stdout)


def test_the_conclusion_stands_first(capsys, found) -> None:
    code, out, err = said(capsys, BETA, GAMMA)
    assert code == 0 and err == ""
    heads = [
        "r753ie4_beta → r753ie4_gamma: the whole",
        "Limits and cautions that moved",
        "Key result ",
        "Inputs that differ",
        "--all lists them",
    ]
    places = [out.index(head) for head in heads]
    assert places == sorted(places)
    assert "the whole goes from FAIL: " in out
    assert re.search(r"Sum of the losses +115\.2 +228\.8 +W +\+99 % +worse\n", out)
    assert re.search(r"bearings\.rear\.diameter_mm +40 +81\n", out)
    assert re.search(r"shafts\.shaft\.bolts +left out +6 keys\n", out)
    assert (
        f"What differs in all: {len(found['checks'])} checks, {len(found['values'])} values; --all lists them." in out
    )
    assert max(len(line) for line in out.splitlines() if " → " not in line) <= 140
    assert "bearings.rear.film" not in out and "Verdicts of the steps" not in out  # that is asked for


def test_all_of_it(capsys, found) -> None:
    code, out, _ = said(capsys, BETA, GAMMA, "--all")
    assert code == 0 and "--all" not in out
    for kind in ("values", "checks"):
        assert all(re.search(rf"^  {re.escape(v['id'])}  ", out, re.MULTILINE) for v in found[kind])
    assert re.search(r"Film at the edge, rear +✗ FAIL 4\.765 µm +✓ pass 10\.36 µm +≥ 9 µm +better\n", out)
    assert "thread = M10x1.5" in out and "more limits" not in out
    assert re.search(r"\n  Counter-shaft +\S+ .*: \d", out)
    assert re.search(r"bearings\.rear\.film_edge +✗ FAIL 4\.765 µm +✓ pass 10\.36 µm +≥ 9 µm +−47 % +\+15 %\n", out)


def test_json_says_what_holds_outside_validity(found) -> None:
    for side, file in (("a", BETA), ("b", GAMMA)):
        verdicts = {check.id: judged(check) for check in solve(design(read(file))).checks()}
        rows = {row["id"]: row[side] for row in found["checks"] if row[side] is not None}
        assert rows and {id: row["outside"] for id, row in rows.items()} == {
            id: verdicts[id] == "outside" for id in rows
        }
    film = next(row for row in found["checks"] if row["id"] == "bearings.rear.film_edge")
    assert (film["a"]["verdict"], film["b"]["verdict"]) == ("fail", "pass")


def test_json_says_which_key_results_are_better(found) -> None:
    conclusion = found["conclusion"]
    assert conclusion["verdict"] == {"a": "fail", "b": "fail"}
    assert all(conclusion["counts"][side]["failed"] for side in "ab")
    results = {r["b"]["id"]: r for r in conclusion["results"]}
    assert results["bearings.rear.film_edge"]["better"] is True and results["countershaft.mass"]["better"] is False
    assert results["gears.residual_couple"]["better"] is None
    pitting = next(r for r in conclusion["results"] if "pitting" in r["label"])
    assert (pitting["a"]["id"], pitting["b"]["id"]) == (
        "gears.idler_shaft.safety_contact",
        "gears.crank_central.safety_contact",
    )


def test_json_has_both_sides(found) -> None:
    assert (found["schema"], found["program"], found["equal"]) == (1, "contralbero", False)
    assert [d["name"] for d in found["designs"]] == [
        f"R753IE4 counter-shaft, solution {name}" for name in ("beta", "gamma")
    ]
    assert all(len(d["sha256"]) == 64 for d in found["designs"])
    key = "shafts.shaft.bearings.front.length_mm"
    length = next(d for d in found["inputs"] if d["key"] == key)
    assert length == {"key": key, "label": "Length", "unit": "mm", "a": 26.0, "b": 27.5}
    verdicts = [solve(design(read(file))).outcomes["countershaft"].verdict for file in (BETA, GAMMA)]
    assert found["steps"]["countershaft"] == {"a": verdicts[0], "b": verdicts[1], "moved": verdicts[0] != verdicts[1]}
    edge = next(c for c in found["checks"] if c["id"] == "bearings.rear.film_edge")
    assert edge["moved"] and edge["in"] == "both" and (edge["a"]["verdict"], edge["b"]["verdict"]) == ("fail", "pass")
    assert edge["a"]["limit"] == 9.0 and edge["a"]["margin"] < 0 < edge["b"]["margin"]
    alone = next(c for c in found["checks"] if c["in"] == "b")
    assert alone["a"] is None and alone["b"]["verdict"]
    assert {v["in"] for v in found["values"]} == {"both", "b"}


def test_a_design_and_itself(capsys) -> None:
    code, out, err = said(capsys, GAMMA, GAMMA)
    assert code == 0 and err == "" and "The two designs are equal" in out and out.startswith("A  ")
    code, out, _ = said(capsys, GAMMA, GAMMA, "--json")
    assert code == 0 and json.loads(out)["equal"] is True


def test_a_step_that_is_missing_is_not_asked(capsys) -> None:
    code, out, _ = said(capsys, DESIGNS / "timing_pair.toml", GAMMA)
    assert code == 0
    assert re.search(r"\n  bearings +not used +8 keys\n", out)
    assert re.search(r"\nSteps: .*Bearings · not used → ✗ FAIL", out)
    assert re.search(r"\n  Mass of the whole shaft +– +9\.052 +kg +–\n", out)
    assert "Film at the edge, front" not in out  # the step says it
    steps = json.loads(said(capsys, DESIGNS / "timing_pair.toml", GAMMA, "--json")[1])["steps"]
    assert steps["bearings"] == {"a": "not_asked", "b": "fail", "moved": True}


def test_both_files_are_wrong_at_once(capsys, tmp_path) -> None:
    bad = tmp_path / "bad.toml"
    bad.write_text(GAMMA.read_text(encoding="utf-8").replace("bore_mm = 94.0", "bore_mm = -1.0"), encoding="utf-8")
    code, out, err = said(capsys, bad, tmp_path / "none.toml")
    assert code == 2 and out == ""
    lines = err.splitlines()
    assert (
        len(lines) == 2 and "engine.bore_mm: -1.0" in lines[0] and re.match(rf"{re.escape(str(bad))}:\d+: ", lines[0])
    )
    assert "none.toml: cannot be read" in lines[1]
    code, _, err = said(capsys, bad, bad)
    assert code == 2 and len(err.splitlines()) == 1
    code, out, err = said(capsys, GAMMA, bad)
    assert code == 2 and out == "" and "engine.bore_mm" in err


def test_usage(capsys) -> None:
    assert said(capsys, GAMMA)[0] == 2
    assert said(capsys, GAMMA, BETA, "--json", "-o", "c.pdf")[0] == 2


def test_names_above_the_columns() -> None:
    assert column_names("beta", "gamma") == ("beta", "gamma")
    assert column_names("same", "same") == ("A", "B")
    assert column_names("short", "a-name-that-is-much-too-long") == ("A", "B")


def test_it_loads_numpy_and_no_more() -> None:
    found = loaded(f"from assistant.cli import main; main({['compare', str(BETA), str(GAMMA)]!r})")
    assert "numpy" in found and not found & set(HEAVY)
