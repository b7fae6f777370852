"""Many designs in one pass give what each gives alone: the same values, verdicts and reasons."""

from dataclasses import replace
from pathlib import Path

import pytest

from calc.design.toml_file import read
from calc.sheet.check import THIN_MARGIN, check
from calc.sheet.lanes import Lanes
from calc.sheet.step import Outcome
from calc.sheet.text import Text
from calc.studies.sweep import grid, varied
from calc.studies.sweep import run as abreast
from calc.studies.sweep.inputs import sampled
from calc.studies.sweep.run import _needed, _one_after_the_other, designs, one_by_one, side_by_side

np = pytest.importorskip("numpy")
DESIGNS = Path(__file__).parents[4] / "designs"
DIGITS = 1e-11  # in which a value of many designs may differ from that of one
SWEEPS = {
    "r753ie4_gamma": ["engine.rated_speed_rpm=1500:2600", "engine.rod_length_mm=155:170",
    "bearings.front.length_mm=26:36",
                      "friction.oil_temperature_C=70:110"],
    "r753ie4_beta": ["bearings.rear.clearance_factor=2.4:2.7", "bearings.hole_diameter_mm=3:5",
    "countershaft.masses.front.radius_mm=20:22"],
    "r753ie4_sized": ["countershaft.overdesign_percent=0:10", "bearings.front.diameter_mm=54:58",
    "engine.bench.3.oil_temperature_C=80:90"],
    "r754ie4_balance_shafts": ["engine.piston_mass_g=700:800", "countershaft.masses.0.radius_mm=20:30"],
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


@pytest.fixture
def together(monkeypatch):
    """All designs through the steps at once, however few, and a fault of that is one of the test; gives how many went
    in each pass."""
    sizes, passes = [], abreast.passes

    def counted(designs, **kwargs):
        for some, outcomes in passes(designs, **kwargs):
            sizes.append(len(some) if outcomes is not None else 0)
            yield some, outcomes

    monkeypatch.setattr(abreast, "FEW", 1)
    monkeypatch.setattr(abreast, "passes", counted)
    return sizes


def compare(document, inputs, rows):
    for many, alone in zip(
        side_by_side(document, inputs, rows, None), one_by_one(document, inputs, rows, None), strict=True
    ):
        assert (
            many.verdicts == alone.verdicts
            and many.reason == alone.reason
            and many.values.keys() == alone.values.keys()
        )
        for id, (number, unit) in alone.values.items():
            assert many.values[id][1] == unit
            assert many.values[id][0] == pytest.approx(number, rel=DIGITS, abs=1e-12), id


@pytest.mark.parametrize("name", SWEEPS)
def test_many_at_once_are_each_alone(name, together):
    compare(*drawn(name, 10))
    assert max(together) > 1


@pytest.mark.parametrize(
    "over",
    [
        {
            "bearings.front.length_mm": (29.0, 31.0),
            "bearings.rear.length_mm": (24.0, 24.5, 25.0),
        },  # the front goes apart, and is one in each part
        {"bearings.front.diameter_mm": (62.0, 64.0), "bearings.rear.length_mm": (24.0, 25.0, 26.0)},
        {
            "bearings.front.length_mm": (58.9, 59.3, 59.7, 60.1, 60.5)
        },  # l/d through 1, up to which some of the routes reach
        {"gears.wheels.1.profile_shift": (0.0, 0.1), "friction.oil_temperature_C": (80.0, 90.0)},
        {
            "bearings.front.length_mm": (4.0, 12.0, 21.0, 23.0, 25.0),
            "bearings.supply_temperature_C": (80.0, 100.0),
        },  # some have no solution
    ],
)
def test_a_grid_in_which_designs_go_apart_and_share_numbers(over, together):
    document = read(DESIGNS / "r753ie4_gamma.toml")
    inputs = varied(document, [f"{key}={','.join(map(str, values))}" for key, values in over.items()])
    compare(document, inputs, grid(inputs).rows(0, 100))
    assert max(together) > 1


@pytest.mark.parametrize(
    "texts",
    [
        ["engine.rated_speed_rpm=800:2600:3", "engine.rod_length_mm=140,170"],
        ["engine.cylinder_offset_mm=-5:5:3", "engine.piston_mass_g=900,1300"],
        ["imbalance.crank_balance_fraction=0:1:3"],
        ["engine.crank_radius_mm=40,60", "engine.rod_cg_to_big_end_mm=40:60:3"],
    ],
)
def test_engines_of_which_the_imbalance_alone_is_asked(texts, together):
    document = read(DESIGNS / "r753ie4_gamma.toml")
    inputs = varied(document, texts)
    rows = grid(inputs).rows(0, 100)
    many, each = (
        side_by_side(document, inputs, rows, "imbalance"),
        list(one_by_one(document, inputs, rows, "imbalance")),
    )
    for one, other in zip(many, each, strict=True):
        assert one.verdicts == other.verdicts and one.values.keys() == other.values.keys()
        largest = max(abs(number) for number, _ in other.values.values())
        for id, (number, _) in other.values.items():
            if not id.endswith(("_phase", "_axis")):  # of a vector of next to no length the direction is anything
                assert one.values[id][0] == pytest.approx(number, rel=DIGITS, abs=1e-12 * largest), id
    assert max(together) > 1


def test_a_whole_design_goes_through_all_steps_in_few_passes(monkeypatch):
    """No part of gamma falls back to one design after the other, and most designs go one way."""
    document, inputs, rows = drawn("r753ie4_gamma", 48)
    monkeypatch.setattr(abreast, "together_or_singly", lambda function: function)
    monkeypatch.setattr(abreast, "FAILS", ())
    passed = list(abreast.passes([_needed(one, None) for one in designs(document, inputs, rows)], compared=False))
    assert sorted(place for some, _ in passed for place in some) == list(range(48))
    assert max(len(some) for some, outcomes in passed if outcomes is not None) > 24


def test_a_design_without_a_solution_says_why_and_takes_none_with_it():
    document, inputs, rows = drawn("r753ie4_gamma", 16, ["bearings.front.length_mm=4:30"])
    many = side_by_side(document, inputs, rows, None, frozenset(["bearings.front.film"]))
    alone = [
        _one_after_the_other(None, frozenset(["bearings.front.film"]), False)(one)
        for one in designs(document, inputs, rows)
    ]
    assert [one.reason for one in many] == [one.reason for one in alone]
    assert {bool(one.reason) for one in many} == {True, False}
    assert [one.verdicts for one in many] == [one.verdicts for one in alone]


def test_a_combination_that_is_no_design_is_a_row_among_the_others():
    document, inputs, _ = drawn("r753ie4_gamma", 2, ["bearings.front.length_mm=20:30"])
    rows = [(24.0 + n / 2,) for n in range(12)]
    rows[5] = (-1.0,)
    many = side_by_side(document, inputs, rows, None, frozenset(["bearings.front.film"]))
    assert [bool(one.reason) for one in many] == [n == 5 for n in range(12)] and "length_mm" in many[5].reason


RULE = Text("rule of this program")


@pytest.mark.parametrize(
    ("margins", "verdicts", "near"),
    [
        ((0.5, 0.2, 0.1), ["pass", "pass", "pass"], [False] * 3),
        ((0.5, -0.2, 0.02), ["pass", "fail", "warn"], [False] * 3),
        ((0.5, 1e-9, -1e-9), None, [False, True, True]),
        ((0.5, THIN_MARGIN + 1e-9, 0.0), None, [False, True, True]),
        ((float("nan"), 0.5, -0.1), ["fail", "pass", "fail"], [False] * 3),
    ],
)
def test_verdicts_of_many_and_those_that_hang_on_last_digits(margins, verdicts, near):
    limit = check(
        "bearings.front.film_edge", Text("Film"), Lanes(1e-6 * (1 + np.array(margins))), ">=", 1e-6, "µm", RULE
    )
    found, close = abreast._verdicts(Outcome("bearings", result=None, checks=(limit,)), 3)
    assert close.tolist() == near and (verdicts is None or list(found) == verdicts)


@pytest.mark.parametrize(
    "one",
    [
        check("bearings.front.length_ratio", Text("l/d"), Lanes(np.array([0.1, 0.4, 1.2])), "in", (0.2, 1.0), "", RULE),
        check("bearings.front.clearance_cold", Text("g"), Lanes(np.array([-1e-6, 1e-6, 3e-6])), ">", 0.0, "µm", RULE),
        check(
            "bearings.front.temperature",
            Text("T"),
            Lanes(np.array([90.0, 119.0, 121.0])),
            "<=",
            Lanes(np.array([100.0, 120.0, 120.0])),
            "°C",
            RULE,
        ),
        check(
            "bearings.front.film_edge_usual", Text("Film"), Lanes(np.array([1e-6, 3e-6, 9e-6])), ">=", 4e-6, "µm", RULE
        ),
        check(
            "gears.train.rating",
            Text("S"),
            Lanes(np.array([1.0, 2.0, 3.0])),
            ">=",
            1.5,
            "",
            RULE,
            missing=("gears.power_kW",),
        ),
        replace(
            check(
                "bearings.front.film_edge_usual",
                Text("Film"),
                Lanes(np.array([1e-6, 3e-6, 9e-6])),
                ">=",
                4e-6,
                "µm",
                RULE,
            ),
            accepted="seen",
        ),
        replace(
            check(
                "bearings.front.film_edge",
                Text("Film"),
                Lanes(np.array([1.0, 1.01, 2.0])),
                ">=",
                Lanes(np.array([0.0, 1.0, 1.0])),
                "",
                RULE,
            ),
            exact=True,
        ),
    ],
)
def test_a_verdict_of_many_is_that_of_each(one):
    found, near = abreast._verdicts(Outcome("bearings", result=None, checks=(one,)), 3)
    assert list(found) == [abreast.step_verdict([abreast._one(one, k)]) for k in range(3)] and not near.any()
