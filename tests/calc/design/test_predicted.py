# SPDX-License-Identifier: Apache-2.0
"""What was measured stands beside what is predicted at the same speed."""

import pytest

from calc.design.predicted import at_speed, compared_table
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.shipped import DESIGNS

GAMMA = read(DESIGNS / "r753ie4_gamma.toml")


def measured(*rows: dict[str, object], **changes: object):
    document = Document(GAMMA.data | {"measured": list(rows)}, "gamma")
    for key, value in changes.items():
        document = document.with_value(key, value)
    return design(document)


def table(*rows: dict[str, object], step: str = "bearings"):
    return next(t for t in solve(measured(*rows)).outcomes[step].whole.tables if t.id == "measured")


def test_a_row_at_the_speed_of_the_design():
    value, speed, is_, uncertainty, predicted, unit, deviation, verdict = table(
        {"value": "imbalance.order_1.couple_backward", "is": 560.0, "unit": "N·m", "uncertainty": 20.0},
        step="imbalance",
    ).rows[0]
    assert (value, speed, is_, uncertainty, unit, verdict) == (
        "Couple turning backward (imbalance.order_1.couple_backward)",
        2600.0,
        560.0,
        20.0,
        "N·m",
        "inside",
    )
    assert predicted == pytest.approx(572.932, abs=1e-3) and deviation == pytest.approx(100 * 12.932 / 560, abs=1e-3)


def test_another_speed_is_solved_with_the_couple_that_it_has():
    row = table(
        {"value": "imbalance.order_1.couple_backward", "speed_rpm": 1300, "is": 150.0, "unit": "N·m"}, step="imbalance"
    ).rows[0]
    assert row[4] == pytest.approx(572.932 / 4, rel=1e-5) and row[7] == ""


def test_the_rated_power_is_that_of_no_other_speed():
    assert measured().engine.rated_power == 50e3 and at_speed(measured(), 1300 / 60, {}).engine.rated_power is None


def test_at_another_speed_the_clearance_stays_and_the_oil_is_that_of_the_bench():
    rows = table(
        {"value": "bearings.front.clearance", "speed_rpm": 1300, "is": 80.0, "unit": "µm", "uncertainty": 0.2},
        {"value": "bearings.supply_temperature_C", "speed_rpm": 2497, "is": 118.7, "unit": "°C"},
        {"value": "bearings.supply_pressure_bar", "speed_rpm": 1251, "is": 2.4, "unit": "bar"},
    ).rows
    assert rows[0][4] == pytest.approx(80.3025, abs=1e-3) and rows[0][7].startswith("outside, by 0.1")
    assert rows[1][0] == "Supply temperature" and rows[1][4:] == (None, "°C", None, "an input, taken as 118.7 °C")
    assert rows[2][7] == "an input, taken as 2.4 bar"


FLOW = "bearings.front.oil_flow"


def test_below_the_bench_run_its_nearest_row_holds():
    """No jump at its end, where the oil of the rated speed was taken."""
    below, first, above = (
        table({"value": FLOW, "speed_rpm": n, "is": 1.0, "unit": "L/min"}).rows[0][4] for n in (1249, 1251, 1253)
    )
    assert below < first < above and above - below < 0.01 * first


def test_at_the_rated_speed_the_oil_is_that_of_the_bench_run_where_it_covers_that():
    gamma = measured()
    rated = at_speed(gamma, gamma.engine.rated_speed, {})
    assert rated.bearings.supply_temperature == pytest.approx(110.5 + (2646 - 2600) / (2646 - 2547) * 6.7)
    assert rated.engine.rated_power == 50e3
    row = {"value": FLOW, "speed_rpm": 2600, "is": 1.0, "unit": "L/min"}
    near = {**row, "speed_rpm": 2599.99}
    at_rated, beside = (table(each).rows[0][4] for each in (row, near))
    assert at_rated == pytest.approx(beside, rel=1e-4)
    without = {key: x for key, x in row.items() if key != "speed_rpm"}  # the design as it stands
    assert table(without).rows[0][4] == pytest.approx(solve(gamma).values()[FLOW].shown, rel=1e-9)
    assert table(without).rows[0][4] > at_rated * 1.05


def test_outside_of_the_bench_run_the_rated_speed_has_the_oil_that_is_given():
    short = measured(**{"engine.bench": GAMMA.data["engine"]["bench"][3:]})
    rated = at_speed(short, short.engine.rated_speed, {})
    assert rated.bearings.supply_temperature == short.bearings.supply_temperature
    assert at_speed(short, 2500 / 60, {}).bearings.supply_temperature == 118.6


def test_the_film_of_another_speed_is_that_of_the_curve_over_speeds():
    """Both take the clearance as made and the oil of the bench run."""
    thinnest = solve(design(GAMMA)).values()["bearings.front.thinnest_film"].shown
    row = table({"value": "bearings.front.film", "speed_rpm": 2497, "is": 10.0, "unit": "µm"}).rows[0]
    assert row[4] == pytest.approx(thinnest, rel=2e-3)


@pytest.mark.parametrize(
    "row, words",
    [
        ({"value": "gears.qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq", "is": 1.0}, "this design has no such value"),
        (
            {"value": "bearings.front.fil", "is": 1.0},
            "this design has no such value; did you mean bearings.front.film?",
        ),
        (
            {"value": "bearings.supply_temperature_C", "speed_rpm": 500, "is": 1.0, "unit": "°C"},
            "an input, taken as 110.3 °C",  # that of the nearest row of the bench run
        ),
        (
            {"value": "bearings.hole_diameter_mm", "speed_rpm": 500, "is": 4.0, "unit": "mm"},
            "is an input of no speed of its own: leave speed_rpm out",
        ),
        ({"value": "bearings.front.film", "speed_rpm": 29999, "is": 1.0, "unit": "µm"}, "is not known at this speed"),
        (
            {"value": "engine.brake_mean_pressure", "speed_rpm": 2000, "is": 8.0, "unit": "bar"},
            "is not known at this speed",
        ),
        ({"value": "bearings.front.film", "is": 0.01, "unit": "mm"}, "is shown in µm: give it so"),
    ],
)
def test_what_cannot_be_compared_says_why(row, words):
    assert table(row, step=row["value"].partition(".")[0]).rows[0][4:] == (None, row.get("unit", ""), None, words)


@pytest.mark.parametrize(
    "row, key",
    [
        ({"value": "bearings.front.film", "is": 1.0, "unit": "furlong"}, "measured.0.unit"),
        ({"value": "bearings.front.film"}, "measured.0.is"),
        ({"value": "name", "is": 1.0}, "measured.0.value"),
        ({"value": "bearings.front.film", "is": 1.0, "speed_rpm": -5}, "measured.0.speed_rpm"),
        ({"value": "bearings.front.film", "is": 1.0, "uncertainty": -1.0}, "measured.0.uncertainty"),
    ],
)
def test_a_wrong_row_is_named(row, key):
    with pytest.raises(BadInput) as bad:
        measured(row)
    assert key in [error.key for error in bad.value.errors]


def test_two_designs_beside_one_measurement():
    row = {"value": "imbalance.order_1.couple_backward", "is": 560.0, "unit": "N·m"}
    a, b = solve(measured(row)), solve(measured(**{"engine.rated_speed_rpm": 1300}))
    found = compared_table((a.design, a.predicted), (b.design, b.predicted), ("A", "B"))
    assert found is not None and found.rows[0][4] == pytest.approx(572.932, abs=1e-3)
    assert found.rows[0][6] == pytest.approx(572.932 / 4, rel=1e-5)
    assert compared_table((b.design, b.predicted), (b.design, b.predicted), ("A", "B")) is None
