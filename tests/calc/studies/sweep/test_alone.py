"""Each design of a sweep is what it is alone: values, verdicts and reasons, whatever was taken over from the one before."""

from pathlib import Path

import pytest

from calc.design.toml_file import design, read
from calc.solve import solve
from calc.studies.sweep import grid, varied
from calc.studies.sweep.inputs import sampled
from calc.studies.sweep.run import solved
from tests.conftest import SCREENED

DESIGNS = Path(__file__).parents[4] / "designs"
SWEEPS = {
    "r753ie4_gamma": ["engine.rated_speed_rpm=1500:2600", "engine.rod_length_mm=155:170",
    "shafts.shaft.bearings.front.length_mm=26:36",
                      "friction.oil_temperature_C=70:110"],
    "r753ie4_beta": ["shafts.shaft.bearings.rear.clearance_factor=2.4:2.7", "bearings.hole_diameter_mm=3:5",
    "shafts.shaft.masses.front.radius_mm=20:22"],
    "r753ie4_sized": ["shafts.shaft.overdesign_percent=0:10", "shafts.shaft.bearings.front.diameter_mm=54:58",
    "engine.bench.3.oil_temperature_C=80:90"],
    SCREENED: ["engine.piston_mass_g=700:800", "shafts.shaft.masses.0.radius_mm=20:30"],
    "thesis_temperatures": ["gears.wheels.0.profile_shift=0.1:0.2", "friction.oil_temperature_C=40:90"],
    "timing_pair": ["gears.speed_rpm=1000:3000", "gears.wheels.0.face_width_mm=18:22"],
    "twin_mounting": ["engine.rated_speed_rpm=2000:3000", "engine.cylinder_pitch_mm=90:100"],
    "twin_force_shaft": ["engine.bore_mm=80:90", "engine.gas.compression_ratio=16:18"],
}  # fmt: skip


def drawn(name: str, count: int, over: list[str] | None = None):
    """A design file, the inputs that are varied, and their values."""
    document = read(DESIGNS / f"{name}.toml")
    inputs = varied(document, over or SWEEPS[name], drawn=True)
    return document, inputs, sampled(inputs, count, hypercube=True).rows(0, count)


def compare(document, inputs, rows, step=None):
    """Each row of a sweep with the same design by itself; gives the rows."""
    swept = list(solved(document, inputs, rows, step))
    for at, row in zip(rows, swept, strict=True):
        changed = document
        for variable, number in zip(inputs, at):
            changed = changed.with_value(variable.key, number)
        alone = solve(design(changed))
        asked = [o for key, o in alone.outcomes.items() if step in (None, key) and o.state != "not_asked"]
        assert row.verdict == (alone.verdict if step is None else alone.outcomes[step].verdict)
        assert row.verdicts == {outcome.key: outcome.verdict for outcome in asked}
        assert row.values == {value.id: (value.shown, value.unit) for outcome in asked for value in outcome.values()}
        assert row.reason == "; ".join(f"{outcome.key}: {outcome.reason}" for outcome in asked if outcome.reason)
    return swept


LONG = ("r753ie4_gamma", "r753ie4_beta")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in SWEEPS]
)
def test_each_design_is_what_it_is_alone(name):
    compare(*drawn(name, 4))


@pytest.mark.parametrize(
    "over",
    [
        pytest.param(
            {
                "shafts.shaft.bearings.front.length_mm": (29.0, 31.0),
                "shafts.shaft.bearings.rear.length_mm": (24.0, 24.5, 25.0),
            },  # the front goes apart, and is one in each part
            marks=pytest.mark.slow,
        ),
        pytest.param(
            {
                "shafts.shaft.bearings.front.diameter_mm": (62.0, 64.0),
                "shafts.shaft.bearings.rear.length_mm": (24.0, 25.0, 26.0),
            },
            marks=pytest.mark.slow,
        ),
        {
            "shafts.shaft.bearings.front.length_mm": (58.9, 59.3, 59.7, 60.1, 60.5)
        },  # l/d through 1, up to which some of the routes reach
        {"gears.wheels.1.profile_shift": (0.0, 0.1), "friction.oil_temperature_C": (80.0, 90.0)},
        {
            "shafts.shaft.bearings.front.length_mm": (4.5, 12.0, 21.0, 23.0, 25.0),
            "bearings.supply_temperature_C": (80.0, 100.0),
        },  # some have no solution
    ],
)
def test_a_grid_in_which_designs_share_numbers(over):
    document = read(DESIGNS / "r753ie4_gamma.toml")
    inputs = varied(document, [f"{key}={','.join(map(str, values))}" for key, values in over.items()])
    compare(document, inputs, grid(inputs).rows(0, 100))


@pytest.mark.parametrize(
    "texts",
    [
        pytest.param(["engine.rated_speed_rpm=800:2600:3", "engine.rod_length_mm=140,170"], marks=pytest.mark.slow),
        pytest.param(["engine.cylinder_offset_mm=-5:5:3", "engine.piston_mass_g=900,1300"], marks=pytest.mark.slow),
        ["imbalance.crank_balance_fraction=0:1:3"],
        ["engine.crank_radius_mm=40,60", "engine.rod_cg_to_big_end_mm=40:60:3"],
    ],
)
def test_engines_of_which_the_imbalance_alone_is_asked(texts):
    document = read(DESIGNS / "r753ie4_gamma.toml")
    inputs = varied(document, texts)
    compare(document, inputs, grid(inputs).rows(0, 100), "imbalance")


def test_a_design_without_a_solution_says_why_and_takes_none_with_it():
    rows = compare(*drawn("r753ie4_gamma", 8, ["gears.wheels.shaft.profile_shift=-3:0"]))
    assert {bool(row.reason) for row in rows} == {True, False}


def test_a_combination_that_is_no_design_is_a_row_among_the_others():
    document, inputs, _ = drawn("r753ie4_gamma", 2, ["shafts.shaft.bearings.front.length_mm=20:30"])
    rows = [(24.0 + n / 2,) for n in range(6)]
    rows[3] = (-1.0,)
    swept = list(solved(document, inputs, rows, None, frozenset(["bearings.front.film"])))
    assert [bool(row.reason) for row in swept] == [n == 3 for n in range(6)] and "length_mm" in swept[3].reason
