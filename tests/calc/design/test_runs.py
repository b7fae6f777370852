# SPDX-License-Identifier: Apache-2.0
"""Runs of [[measurements]] beside what a design predicts at their nodes."""

import hashlib
import os
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from assistant.results_text import _column_json
from calc.design.predicted import at_speed
from calc.design.predicted_runs import changed_design, predictions, targets
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.compare_runs import compared_runs
from calc.studies.shipped import DESIGNS

GAMMA = read(DESIGNS / "r753ie4_gamma.toml")
LOSS = "imbalance.order_1.couple_backward"  # of a step that is solved at once
P = {"name": "P", "column": "P", "value": LOSS, "unit": "N·m", "uncertainty": 20}
RUN = {"name": "run", "file": "run.csv", "speed": "n", "columns": [P]}
TEXT = b"n;P\n1300;150\n2600;560\n"
# only what such a value needs is solved
SMALL = {key: x for key, x in GAMMA.data.items() if key not in ("gears", "bearings", "friction", "shafts", "measured")}


def document(*runs, files=None, data=SMALL, **changes):
    changed = Document(data | {"measurements": list(runs)}, "gamma.toml", files={"run.csv": TEXT} | (files or {}))
    for key, value in changes.items():
        changed = changed.with_value(key, value)
    return changed


def solved(*runs, **changes):
    with recorded(False):
        return solve(design(document(*runs, **changes)))


def test_a_run_stands_beside_what_is_predicted_at_its_speeds():
    results = solved(RUN)
    (column,) = results.runs.columns
    assert column.predicted == pytest.approx([572.932 / 4, 572.932], rel=1e-5)
    values = {value.id: value for value in results.runs.values}
    r = np.array([572.932 / 4 - 150, 572.932 - 560])
    assert values["measured.run.P.bias"].shown == pytest.approx(r.mean(), rel=1e-4)
    assert values["measured.run.P.bias"].unit == "N·m"
    assert values["measured.run.P.rms"].shown == pytest.approx(np.sqrt((r**2).mean()), rel=1e-4)
    assert values["measured.run.P.chi2_reduced"].shown == pytest.approx((r**2).sum() / 400 / 2, rel=1e-4)
    assert values["measured.run.P.used"].shown == 2
    assert list(results.runs.lines()) == ["run: P agrees, bias +3.08 N·m (2 nodes)"]


def test_nothing_is_solved_before_somebody_asks():
    results = solved(RUN)
    assert "runs" not in vars(results) and not any(check.id.startswith("measured") for check in results.checks())


def test_a_measurement_never_makes_a_design_fail_and_can_be_accepted():
    wrong = {**RUN, "columns": [{**P, "uncertainty": 0.01}]}
    results = solved(wrong)
    (check,) = results.runs.checks
    assert (check.id, check.kind, check.verdict, check.cause) == ("measured.run.P", "method", "note", "imbalance")
    assert results.verdict == solved(RUN).verdict
    accepted = solved(wrong, accepted={"measured.run.P": "sensor under repair"})
    assert accepted.runs.checks[0].verdict == "accepted"
    assert not any("measured" in note for outcome in accepted.outcomes.values() for note in outcome.notes)
    assert "accepted: sensor under repair" in next(accepted.runs.lines())


def test_without_uncertainty_it_is_not_verified():
    (check,) = solved({**RUN, "columns": [{"column": "P", "value": LOSS}]}).runs.checks
    assert check.id == "measured.run.couple-backward" and check.verdict == "not_verified"


def test_a_node_without_weight_is_said():
    relative = {key: x for key, x in P.items() if key != "uncertainty"} | {"uncertainty_percent": 5}
    results = solved({**RUN, "columns": [relative]}, files={"run.csv": b"n;P\n1300;0\n2600;560\n"})
    (column,) = results.runs.columns
    assert "(2 nodes, 1 of them not judged: their uncertainty is 0)" in column.words
    assert "1 node has no part in χ²" in column.sentence
    assert "χ²:" not in solved(RUN).runs.columns[0].sentence


def test_a_condition_is_told_in_the_unit_of_its_key():
    bore = {"column": "b", "key": "engine.bore_mm"}
    results = solved({**RUN, "conditions": [bore]}, files={"run.csv": b"n;b;P\nrpm;cm;\n2600;9.4;560\n"})
    (column,) = results.runs.columns
    title, row = [title for title, _ in column.table.columns].index("engine.bore_mm"), column.table.rows[0]
    assert row[title] == pytest.approx(94.0)
    assert _column_json(column)["nodes"][0]["conditions"] == {"engine.bore_mm": pytest.approx(94.0)}


def test_a_condition_sets_an_input_row_by_row():
    run = {**RUN, "conditions": [{"column": "b", "key": "engine.bore_mm"}], "speed_rpm": 2600.0}
    del run["speed"]
    run["columns"] = [{"name": "b", "column": "b", "value": "engine.bore_mm", "unit": "cm"}, {**P, "unit": "N·mm"}]
    results = solved(run, files={"run.csv": b"b;P\ncm;\n9.4;560\n9.6;\n"}, **{"engine.bore_mm": 90})
    (bore, couple) = results.runs.columns
    assert bore.predicted == pytest.approx([94, 96]) and bore.target.y == pytest.approx([94, 96])
    assert couple.nodes == 1 and couple.target.y[0] == pytest.approx(0.56)


def test_a_sum_of_values_and_a_unit_of_the_bench():
    two = {**P, "value": [LOSS, "imbalance.order_1.couple_forward"], "unit": "lbf·ft", "uncertainty": 1}
    (column,) = solved({**RUN, "columns": [two]}).runs.columns
    assert column.target.unit == "N·m" and column.target.y[1] == pytest.approx(560 * 1.3558179, rel=1e-7)
    assert column.target.sigma == pytest.approx([1.3558179] * 2, rel=1e-7)
    values = solved().values()
    together = values[LOSS].shown + values["imbalance.order_1.couple_forward"].shown
    assert column.predicted[1] == pytest.approx(together, rel=1e-6)


def test_a_sum_is_called_in_words():
    two = {**P, "value": [LOSS, "imbalance.order_1.couple_forward"]}
    (column,) = solved({**RUN, "columns": [two]}).runs.columns
    assert str(column.target.label) == "Couple turning backward + Couple turning forward"
    assert "P (Imbalance: Couple turning backward + Couple turning forward) " in str(column.sentence)
    alike = {**P, "value": [LOSS, LOSS.replace("order_1", "order_2")]}
    (column,) = solved({**RUN, "columns": [alike]}).runs.columns
    assert str(column.target.label) == "Couple turning backward, order_1 + order_2"


def test_a_node_is_the_design_at_that_speed():
    """The clearances as made, the oil of the bench run, at the rated speed too; what finds no solution is counted."""
    flow = {"name": "Q", "column": "P", "value": "bearings.front.oil_flow"}
    results = solved({**RUN, "columns": [flow]}, data=GAMMA.data)
    (column,) = results.runs.columns
    values = results.values()
    with recorded(False):
        there = [
            solve(at_speed(design(GAMMA), n / 60, values)).values()["bearings.front.oil_flow"] for n in (1300, 2600)
        ]
    assert column.predicted == pytest.approx([value.shown for value in there], rel=1e-12)
    assert column.predicted[1] != pytest.approx(values["bearings.front.oil_flow"].shown, rel=0.01)


def test_a_changed_design_is_predicted_at_the_same_nodes():
    results = solved(RUN)
    wanted = targets(results.design, results)
    heavier = changed_design(results.design, {"engine.piston_mass_g": 1300.0})
    (here,) = predictions(heavier, wanted, solve)
    (before,) = predictions(results.design, wanted, solve, results)
    assert (here > before * 1.01).all()
    with pytest.raises(LookupError):
        changed_design(results.design, {"engine.no_such": 1.0})


def test_two_designs_on_the_same_runs():
    a, b = solved(RUN), solved(**{"engine.piston_mass_g": 1300.0})
    table = compared_runs(a.runs_with(b), b.runs_with(a), ("A", "B"))
    assert table.rows[0][0] == "run: P" and table.rows[0][3] < table.rows[0][6]


# --- of the mounting


@cache
def mounting():
    with recorded(False):
        return solve(design(read(DESIGNS / "twin_mounting.toml")))


def test_the_operation_measured_is_the_one_of_that_speed():
    """At a speed that the design has an operation of, the same numbers."""
    from calc.mounting.at_speeds import AtMeasuredSpeed

    values = mounting().values()
    result = mounting().outcomes["mounting"].result
    name, (speed, _) = next(iter(result.speeds.items()))
    there = AtMeasuredSpeed(result, speed)
    mine = [id for id in values if id.startswith(f"mounting.{name}.") and values[id].about is not None]
    compared = 0
    for id in mine:
        found = there.value(id.replace(f"mounting.{name}.", "mounting.measured.", 1))
        if found is not None:
            assert found == pytest.approx(values[id].shown, rel=1e-9), id
            compared += 1
    assert compared > 0.9 * len(mine) > 50


def test_one_order_of_a_point_adds_up_to_all_of_them():
    from calc.engine.gas_torque import order_word
    from calc.mounting.at_speeds import AtMeasuredSpeed

    result = mounting().outcomes["mounting"].result
    there = AtMeasuredSpeed(result, 2000 / 60)
    point, variant = result.system.mounting.points[0].name, result.own
    way = f"mounting.measured.{variant}.{point}.velocity_x"
    orders = [there.value(f"{way}.order_{order_word(n)}") for n in result.drive.orders]
    found = [x for x in orders if x is not None]
    assert len(found) == len(orders) and np.sqrt(np.sum(np.square(found))) == pytest.approx(there.value(way), rel=1e-9)


# --- what is wrong


def errors(*runs, **changes):
    with pytest.raises(BadInput) as bad:
        results = solve(design(it := document(*runs, **changes)))
        results.demand_runs(it)
    return {error.key: error.reason for error in bad.value.errors}


@pytest.mark.parametrize(
    "changes, key, words",
    [
        ({"file": "gone.csv"}, "measurements.0.file", f"is not there; it is looked for in {Path.cwd().name}"),
        ({"file": "../run.csv"}, "measurements.0.file", "must not lead out by .."),
        ({"file": "/etc/passwd.csv"}, "measurements.0.file", "beside the design"),
        ({"file": "run.uff"}, "measurements.0.file", "has the ending .uff, which is not read; export it as CSV"),
        ({"speed": "m"}, "measurements.0.speed", "no such column; there are n, P"),
        ({"speed_rpm": 2600.0}, "measurements.0.speed", "one of them"),
        ({"columns": []}, "measurements.0.columns", "at least one column"),
        ({"columns": [{**P, "column": "PP"}]}, "measurements.0.columns.0.column", 'did you mean "P"?'),
        ({"columns": [{**P, "uncertainty": -1}]}, "measurements.0.columns.0.uncertainty", "0 or more"),
        ({"columns": [{**P, "unit": "Newton"}]}, "measurements.0.columns.0.unit", "no unit that is known"),
        ({"columns": [{**P, "unit": "kW"}]}, "measurements.0.columns.0.unit", "which is in N·m; give one of "),
        ({"columns": [{**P, "unit": "gal/min"}]}, "measurements.0.columns.0.unit", "known L/min, cm³/s"),
        (
            {"columns": [{**P, "value": "imbalance.order_1.couple_backwards"}]},
            "measurements.0.columns.0.value",
            'did you mean "imbalance.order_1.couple_backward"?',
        ),
        (
            {"columns": [{**P, "value": "mounting.measured.half.seat.velocity_x"}]},
            "measurements.0.columns.0.value",
            "needs [mounting]",
        ),
        ({"columns": [{**P, "value": "nothing"}]}, "measurements.0.columns.0.value", "must be the id of a value"),
        ({"columns": [P, P]}, "measurements.0.columns.1.name", "stands twice"),
        (
            {"columns": [{"column": "P", "value": LOSS, "uncertainty_common": 1}]},
            "measurements.0.columns.0.column",
            "needs that of a row beside it",
        ),
        (
            {"conditions": [{"column": "P", "key": "engine.no_such"}]},
            "measurements.0.conditions.0.key",
            "must be the key of an input",
        ),
        (
            {"conditions": [{"column": "P", "key": "engine.layout"}]},
            "measurements.0.conditions.0.key",
            "that is a number",
        ),
        (
            {"conditions": [{"column": "P", "key": "imbalance.crank_balance_fraction"}]},
            "measurements.0.conditions.0.column",
            "run.csv has 150; imbalance.crank_balance_fraction must be",
        ),
    ],
)
def test_what_is_wrong_with_a_run_is_named(changes, key, words):
    assert words in errors({**RUN, **changes})[key]


def test_what_was_found_stands_once():
    said = errors({**RUN, "columns": [{**P, "unit": "gal/min"}, {**P, "name": "Q", "unit": "kW"}]})
    assert len(said) == 1 and not any("gal" in reason for reason in said.values())
    fit = {"name": "f", "of": ["rum"], "free": [{"key": "engine.bore_mm", "low": 50, "high": 100}]}
    assert errors(RUN, fits=[fit])["fits.0.of.0"] == 'is no run of this design; did you mean "run"?'
    bare = {key: value for key, value in P.items() if key != "unit"}
    of_file = errors({**RUN, "columns": [bare]}, files={"run.csv": b"n;P\nrpm;kW\n1300;150\n"})
    assert of_file["measurements.0.columns.0.unit"].startswith("kW is of another dimension")


def test_what_stands_in_a_file_does_not_reach_the_terminal_as_it_is():
    wrong = errors(RUN, files={"run.csv": b"n;P\x1b[2J\n1;2\n"})
    assert "\x1b" not in "".join(wrong.values()) and "no such column" in wrong["measurements.0.columns.0.column"]


def test_rows_are_made_anew_where_a_condition_has_its_unit_at_last(tmp_path):
    (tmp_path / "run.csv").write_bytes(b"n;b;P\n2600;94;560\n")
    run = {**RUN, "conditions": [{"column": "b", "key": "engine.bore_mm"}]}
    without = {key: table for key, table in SMALL.items() if key != "engine"}
    with pytest.raises(BadInput, match="add \\[engine\\]"):
        design(Document(without | {"measurements": [run]}, str(tmp_path / "a.toml")))
    whole = design(Document(SMALL | {"measurements": [run]}, str(tmp_path / "a.toml")))
    assert whole.runs[0].conditions == {"engine.bore_mm": (pytest.approx(0.094),)}


def test_all_of_it_is_said_at_once():
    first = {**RUN, "file": "gone.csv", "columns": [{**P, "uncertainty": -1}]}
    assert set(errors(first, {**RUN, "speed": "m"}, **{"engine.bore_mm": -1.0})) == {
        "engine.bore_mm",
        "measurements.0.file",
        "measurements.0.columns.0.uncertainty",
        "measurements.1.name",
        "measurements.1.speed",
    }


def test_a_link_does_not_lead_out_of_the_folder(tmp_path):
    (tmp_path / "run.csv").write_bytes(TEXT)
    inside = tmp_path / "designs"
    inside.mkdir()
    try:
        os.symlink(tmp_path / "run.csv", inside / "run.csv")
    except OSError:
        pytest.skip("no links here")
    place = Document(SMALL | {"measurements": [RUN]}, str(inside / "a.toml"))
    with pytest.raises(BadInput, match="leads out of the folder"):
        design(place)
    os.unlink(inside / "run.csv")
    (inside / "run.csv").write_bytes(TEXT)
    assert design(place).runs[0].speed == pytest.approx((1300 / 60, 2600 / 60))


def test_the_line_of_the_design_is_said(tmp_path):
    path = tmp_path / "a.toml"
    path.write_text(
        (DESIGNS / "timing_pair.toml").read_text(encoding="utf-8")
        + '[engine]\nname = "x"\n[[measurements]]\nname = "run"\nfile = "gone.csv"\nspeed = "n"\n',
        encoding="utf-8",
    )
    with pytest.raises(BadInput) as bad:
        design(read(path))
    line = next(error.line for error in bad.value.errors if error.key == "measurements.0.file")
    assert path.read_text(encoding="utf-8").splitlines()[line - 1] == 'file = "gone.csv"'


# --- the shipped run


@pytest.mark.slow
def test_the_shipped_run_is_what_its_script_makes():
    from bench.measured_run import FILE, run

    assert run() == FILE.read_text(encoding="utf-8")


def test_of_which_file_rows_were_is_believed_of_a_report_alone(tmp_path):
    """A user's file that begins as if a report had kept it is a file like others."""
    forged = b"# rows used of a file with sha256 " + b"0" * 64 + b", 99999 left out\n" + TEXT
    (tmp_path / "run.csv").write_bytes(forged)
    own = Document(SMALL | {"measurements": [RUN]}, str(tmp_path / "x.toml"))
    (rows,) = design(own).runs
    assert rows.sha256 == hashlib.sha256(forged).hexdigest() and rows.lost == 0
    assert design(document(RUN, files={"run.csv": forged})).runs[0].lost == 99999


def test_peaks_are_of_what_is_an_rms():
    wanted = document(RUN | {"columns": [P | {"peak": True}]})
    results = solve(design(wanted))
    with pytest.raises(BadInput, match="is for a value that is an rms"):
        results.demand_runs(wanted)
