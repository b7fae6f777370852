"""Many designs at once: the grid and the columns."""

import csv
import io
from pathlib import Path

import pytest

from calc.design.toml_file import design, read
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.sweep import sweep, varied
from calc.studies.sweep.inputs import listed, toleranced
from tests.conftest import DESIGNS

GAMMA = read(DESIGNS / "r753ie4_gamma.toml")
FILMS = ["bearings.front.film_edge", "bearings.rear.film_edge"]


def test_the_grid_runs_over_every_combination_the_last_input_fastest():
    swept = sweep(
        GAMMA,
        varied(GAMMA, ["engine.rated_speed_rpm=1000:2000:3", "imbalance.crank_balance_fraction=0,0.5"]),
        "imbalance",
    )
    assert swept.header[:2] == ("engine.rated_speed_rpm", "imbalance.crank_balance_fraction")
    assert [tuple(row[:2]) for row in swept.rows] == [(n, k) for n in (1000.0, 1500.0, 2000.0) for k in (0.0, 0.5)]


def test_a_row_is_what_the_design_gives():
    swept = sweep(
        GAMMA, varied(GAMMA, ["shafts.shaft.bearings.front.length_mm=27.5,34"]), "bearings", ["bearings.front.film"]
    )
    for length, film, verdict in swept.rows:
        results = solve(design(GAMMA.with_value("shafts.shaft.bearings.front.length_mm", length)))
        assert film == results.values()["bearings.front.film"].shown
        assert verdict == results.outcomes["bearings"].verdict


def test_it_is_written_as_csv():
    text = io.StringIO()
    sweep(GAMMA, varied(GAMMA, ["engine.rated_speed_rpm=2000,2600"]), "imbalance", ["imbalance.required_couple"]).write(
        text
    )
    rows = list(csv.reader(text.getvalue().splitlines()))
    assert rows[0] == ["engine.rated_speed_rpm", "imbalance.required_couple [N·m]", "verdict.imbalance"]
    assert float(rows[2][1]) == pytest.approx(572.932, abs=5e-4)


def test_elements_of_a_list_of_numbers_can_be_varied():
    swept = sweep(
        GAMMA,
        varied(GAMMA, ["shafts.shaft.bearings.rear.position_mm=160,167.5"]),
        "countershaft",
        ["countershaft.reaction_rear"],
    )
    assert swept.rows[0][1] > swept.rows[1][1]


@pytest.mark.parametrize(
    "text, reason",
    [
        ("engine.rated_speed_rpm", "KEY=LOW:HIGH:NUMBER"),
        ("engine.rated_sped_rpm=1:2:3", "did you mean"),
        ("engine.cylinders=3:4:3", "whole numbers"),
        ("engine.rated_speed_rpm=1000:2000", "LOW:HIGH:NUMBER"),
        ("engine.rated_speed_rpm=1000:2000:2.5", "whole NUMBER"),
        ("engine.rated_speed_rpm=a:b:3", "KEY=LOW:HIGH:NUMBER"),
        ("engine.rated_speed_rpm=1:2:99999999", "at most"),
        ("engine.rated_speed_rpm=1000:2000:1", "one value"),
        ("engine.firing_order=1,3,2", "is a list"),
        ("engine.rated_speed_rpm=1000:2000:1e9", "at most"),
        ("gears.wheels.shaft.tip_diameter_tolerance_um.5=1:2:2", "from 0 to 1"),
    ],
)
def test_what_can_not_be_varied_is_named(text, reason):
    with pytest.raises(BadInput, match=reason):
        varied(GAMMA, [text])


def test_all_that_is_wrong_is_named_at_once():
    with pytest.raises(BadInput) as bad:
        varied(GAMMA, ["engine.rated_sped_rpm=1:2:3", "engine.bore_mm", "engine.rated_speed_rpm=1:2:0"])
    assert len(bad.value.errors) == 3


@pytest.mark.parametrize("step", ["imbalance", "countershaft"])
def test_a_combination_that_is_no_design_is_a_row_with_its_reason(step):
    swept = sweep(GAMMA, varied(GAMMA, ["engine.crank_radius_mm=53.5,140", "engine.rod_length_mm=100:180:3"]), step)
    assert swept.header[-1] == "reason" and len(swept.rows) == 6
    for row, verdict in zip(swept.rows, swept.verdicts):
        broken = row[0] >= row[1]
        assert (verdict == "bad_input") == broken == ("the crank could not turn" in (row[-1] or ""))
        assert not broken or all(cell is None for cell in row[2:-1])
    swept = sweep(GAMMA, varied(GAMMA, ["engine.rated_speed_rpm=1000,99999"]), step)
    assert swept.rows[0][-1] is None
    assert swept.rows[1][-1].startswith("engine.rated_speed_rpm: 99999.0: must be a number from 1 to 30000")


def test_what_has_no_solution_is_a_row_with_its_reason():
    swept = sweep(GAMMA, varied(GAMMA, ["gears.wheels.shaft.profile_shift=0,-3"]))
    assert swept.verdicts[1] == "no_solution" and swept.rows[1][-1].startswith("gears: ")


def test_an_unknown_value_is_named():
    with pytest.raises(BadInput, match="did you mean"):
        sweep(GAMMA, varied(GAMMA, ["engine.rated_speed_rpm=1000,2000"]), "imbalance", ["imbalance.required_coupl"])


def test_a_step_that_is_not_asked_is_named():
    pair = read(DESIGNS / "timing_pair.toml")
    with pytest.raises(BadInput, match="not asked"):
        sweep(pair, varied(pair, ["gears.speed_rpm=1000,2000"]), "bearings")


def test_cells_of_values_that_a_design_does_not_have_are_empty():
    """A circle has no axis; a centred cylinder no odd orders."""
    swept = sweep(GAMMA, varied(GAMMA, ["engine.cylinder_offset_mm=-10,0"]), "imbalance")
    columns = {name: [row[i] for row in swept.rows] for i, name in enumerate(swept.header)}
    assert (
        columns["imbalance.order_3.force_forward [N]"][1] is None
        and columns["imbalance.order_3.force_forward [N]"][0] is not None
    )
    swept = sweep(GAMMA, varied(GAMMA, ["imbalance.crank_balance_fraction=0.25,0.5"]), "imbalance")
    axis = [row[swept.header.index("imbalance.order_1.couple_axis [°]")] for row in swept.rows]
    assert axis[0] is not None and axis[1] is None


def test_other_methods_are_solved_only_where_their_values_are_asked_for():
    """They judge nothing: values and verdicts of everything else are the same without."""
    inputs = varied(
        GAMMA, ["engine.rated_speed_rpm=1200:2600:3", "shafts.shaft.bearings.front.clearance_factor=0.4:0.8:2"]
    )
    alone = sweep(GAMMA, inputs, wanted=["bearings.front.film", "friction.total_loss"])
    beside = sweep(GAMMA, inputs, wanted=["bearings.front.film", "friction.total_loss", "bearings.rear.falz.film"])
    assert [[*row[:4], *row[5:]] for row in beside.rows] == alone.rows
    assert alone.verdicts == beside.verdicts
    assert all(row[4] > 0 for row in beside.rows)


def test_a_star_varies_all_elements_at_once() -> None:
    both = [f"shafts.shaft.bearings.{name}.length_mm" for name in ("front", "rear")]
    swept = sweep(GAMMA, varied(GAMMA, ["shafts.shaft.bearings.*.length_mm=27,28.5"]), "bearings", FILMS)
    for length, *films in (row[:3] for row in swept.rows):
        alike = GAMMA
        for key in both:
            alike = alike.with_value(key, length)
        values = solve(design(alike)).values()
        assert films == [values[film].shown for film in FILMS]
    with pytest.raises(BadInput, match="which stands here too"):
        varied(GAMMA, ["shafts.shaft.bearings.*.length_mm=27,28.5", f"{both[1]}=27,28"])
    with pytest.raises(BadInput, match="nothing stands where"):
        varied(GAMMA, ["shafts.shaft.sections.*.to_mm=27,28.5"])


def test_keys_of_schema_1_are_those_of_today(tmp_path: Path) -> None:
    old = ["bearings.front.length_mm", "countershaft.masses.rear.mass_kg", "countershaft.bearing_positions_mm.1"]
    new = [f"shafts.shaft.{key}" for key in ("bearings.front.length_mm", "masses.rear.mass_kg")]
    new.append("shafts.shaft.bearings.rear.position_mm")
    assert [one.key for one in varied(GAMMA, [f"{key}=30,31" for key in old])] == new
    assert [one.key for one in toleranced(GAMMA, [f"{key}=0.1" for key in old])] == new
    file = tmp_path / "designs.csv"
    file.write_text(",".join(old) + "\n30,2.5,160\n", encoding="utf-8")
    assert [one.key for one in listed(GAMMA, str(file))[0]] == new
    with pytest.raises(BadInput, match="stands twice"):
        varied(GAMMA, [f"{key}=30,31" for key in (old[0], new[0])])


def test_each_bearing_of_a_twin_is_an_input_of_its_own() -> None:
    """Also where the twin says nothing of them yet."""
    pair, rows = read(DESIGNS / "r754ie4_balance_shafts.toml"), "shafts.right.bearings"
    (together,) = varied(pair, [f"{rows}.*.clearance_um=40,50"])
    assert together.key == f"{rows}.*.clearance_um"
    assert len(varied(pair, [f"{rows}.{name}.clearance_um=40,50" for name in ("front", "rear")])) == 2
    with pytest.raises(BadInput, match="stands twice"):
        varied(pair, [f"{rows}.rear.clearance_um=40,50"] * 2)


def test_slopes_of_schema_1_are_varied_together() -> None:
    swept = sweep(GAMMA, varied(GAMMA, ["bearings.slope_mrad=0.05,0.125"]), "bearings", FILMS)
    for slope, *films in (row[:3] for row in swept.rows):
        values = solve(design(GAMMA.with_value("shafts.shaft.bearings.*.slope_mrad", slope))).values()
        assert films == [values[film].shown for film in FILMS]
