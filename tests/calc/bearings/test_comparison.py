# SPDX-License-Identifier: Apache-2.0
"""Plain and rolling side by side: the watts of the shaft of the R753IE4, what they cost, and that nobody pays who does
not look."""

import numpy as np
import pytest

from calc.bearings import comparison
from calc.bearings.result import BearingsResult
from calc.bearings.rolling.search import as_rolling
from calc.design.step_inputs import rolling_places
from calc.design.toml_file import design, load_design, parse
from calc.sheet.text import Text
from calc.solve import solve
from tests.conftest import DESIGNS

# spec of rolling bearings, 1: sum of both bearings in W at 900, 1500, 2200 and 2600 rpm, by an oracle
WATTS = {
    20.0: ((168, 440, 911, 1249), (8.9, 22, 40, 52)),
    80.0: ((46, 135, 308, 440), (2.8, 8.2, 17.7, 24)),
    120.0: ((20, 63, 150, 220), (1.8, 5.5, 12.6, 18)),
}
SPEEDS = np.array([900.0, 1500.0, 2200.0, 2600.0]) / 60
ROUNDED = 0.03  # of what is printed with two figures

ALONE = """
schema = 2
name = "alone"
[[oil]]
name = "given"
nu40_mm2_s = 95.7
nu100_mm2_s = 14.0
rho15_kgm3 = 860.0
base = "mineral"
[[shafts]]
name = "shaft"
[[shafts.bearings]]
name = "front"
position_mm = -167.5
kind = "rolling"
size = "6205"
locates = true
load_N = 1700.0
[[shafts.bearings]]
name = "rear"
position_mm = 167.5
kind = "rolling"
size = "HK2520"
load_N = 1700.0
[bearings]
oil = "given"
supply_temperature_C = 100.0
housing_material = "EN AC-43100"
journal_material = "20CrNi4"
speed_rpm = 2600.0
[[bearings.duty]]
name = "slow"
speed_rpm = 1000.0
hours = 30.0
road_speed_km_h = 50.0
[[bearings.duty]]
name = "fast"
speed_rpm = 2600.0
hours = 10.0
road_speed_km_h = 100.0
"""


@pytest.fixture(scope="module")
def alone():
    return solve(design(parse(ALONE.encode(), "alone.toml")))


@pytest.fixture(scope="module")
def case(gamma_results):
    carried = gamma_results.result(BearingsResult)
    assert carried is not None
    places = rolling_places(gamma_results.design, gamma_results, "shaft")
    return comparison.ComparisonCase(places, carried.bearings, (), 15.0, False, comparison.Costs())


def test_the_watts_of_the_r753ie4_on_films_and_on_rollers(case):
    rollers = {n: comparison.carried(p, as_rolling(p, "NU205"), p.inputs)[0] for n, p in case.places.items()}
    for T, given in WATTS.items():
        for bearings, expected in zip((case.now, rollers), given):
            found = comparison.BearingSet(Text("set"), bearings, ()).loss(case, SPEEDS, T)
            assert found == pytest.approx(expected, rel=ROUNDED), T


def test_the_losses_of_the_design_are_those_that_it_publishes(alone):
    (table, _) = [t for t in alone.outcomes["bearings"].tables if t.id.startswith("plain_and_rolling")]
    heads = [str(label) for label, _ in table.columns]
    as_designed = dict(zip(heads, table.rows[0]))
    r = alone.result(BearingsResult)
    assert r is not None
    both = list(r.bearings.values())
    assert as_designed["rated, hot"] == pytest.approx(sum(b.friction_power for b in both), rel=5e-3)
    assert as_designed["duty"] == pytest.approx(sum(b.duty_loss for b in both), rel=5e-3)
    assert as_designed["life"] == pytest.approx((r.system_life or 0.0) / 3600, rel=5e-3)
    assert as_designed["pressure oil"] == 0
    assert "6205" in str(as_designed["sizes"]) and "HK2520" in str(as_designed["sizes"])
    plain = dict(zip(heads, table.rows[1]))
    assert plain["life"] == "by film" and plain["pressure oil"] > 0 and plain["rated, hot"] > as_designed["rated, hot"]
    assert {str(row[0]) for row in table.rows} >= {"as designed", "plain, the least loss", "ball", "roller"}
    assert all(row[heads.index("rated, cold")] > row[heads.index("rated, hot")] for row in table.rows)


def test_the_losses_of_the_duty_count_what_its_parts_add_to_the_loads():
    text = ALONE.replace(
        "speed_rpm = 2600.0\nhours", "speed_rpm = 2600.0\nload_factor = 1.6\nextra_load_N = 300.0\nhours"
    )
    results = solve(design(parse(text.encode(), "more.toml")))
    r = results.result(BearingsResult)
    assert r is not None
    (table, _) = [t for t in results.outcomes["bearings"].tables if t.id.startswith("plain_and_rolling")]
    duty = table.rows[0][[str(label) for label, _ in table.columns].index("duty")]
    assert duty == pytest.approx(sum(b.duty_loss for b in r.bearings.values()), rel=5e-3)


def test_fuel_and_co2_follow_the_watts(gamma_results):
    tables = {t.id: t for t in gamma_results.outcomes["bearings"].tables}
    watts = {row[0]: row[2] for row in tables["plain_and_rolling"].rows}
    flows = {row[0]: row[-1] for row in tables["plain_and_rolling"].rows}
    costs = tables["plain_and_rolling_costs"]
    heads = [str(label) for label, _ in costs.columns]
    assert heads[1:5] == ["oil pump", "fuel", "CO₂", "fuel over rated power"]
    b_e = 220e-3  # g/h of a watt
    for row in costs.rows:
        assert row[2] == pytest.approx(b_e * watts[row[0]], rel=0.01)
        assert row[3] / row[2] == pytest.approx(gamma_results.design.friction.co2_per_fuel, rel=0.01)
        assert row[4] == pytest.approx(row[2] / 50.0, rel=0.01)  # rated 50 kW
        oil = flows[row[0]] / 60e3  # of 4 bar, over an efficiency of a half
        assert row[1] == pytest.approx(4e5 * oil / 0.5, rel=0.01)


def test_co2_of_the_road(alone):
    """Σ w m_CO2 / Σ w v, where each part of the duty has a speed of the road."""
    places = rolling_places(alone.design, alone, "shaft")
    r = alone.result(BearingsResult)
    assert r is not None
    costs = comparison.Costs(None, lambda P: P * 1e-6, lambda m: 3.0 * m)  # kg/s
    case = comparison.ComparisonCase(places, r.bearings, (), 15.0, False, costs)
    (_, table) = comparison.further(case, ()).tables
    km = next(row[4] for row in table.rows)
    P = sum(b.duty_loss for b in r.bearings.values())
    assert km == pytest.approx(3.0 * P * 1e-6 / (62.5 / 3.6) * 1e6, rel=5e-3)  # g/km, 30 h at 50 and 10 h at 100 km/h


def test_nobody_pays_who_does_not_look(monkeypatch):
    looked = []
    monkeypatch.setattr(comparison, "further", lambda case, plain: looked.append(case) or comparison.Further())
    results = solve(load_design(DESIGNS / "r753ie4_gamma.toml"))
    assert (results.verdict, str(results), [str(n) for n in results.outcomes["bearings"].notes]) and not looked
    assert tuple(results.outcomes["bearings"].tables) and looked


def test_the_figure_draws_films_whole_and_rolling_dashed(alone):
    (curve,) = [c for c in alone.outcomes["bearings"].curves if c.id == "plain_and_rolling_loss"]
    assert [s.dashed for s in curve.series] == [False] * 3 + [True] * 3
    assert all(str(s.label).startswith("rolling" if s.dashed else "plain") for s in curve.series)
    for cold, warm in ((0, 1), (1, 2), (3, 4), (4, 5)):
        assert (curve.series[cold].y > curve.series[warm].y).all()  # colder oil loses more, at every speed
    assert curve.series[0].x[-1] == pytest.approx(1.1 * 2600)


def test_the_parts_of_the_duty_share_the_damage(alone):
    (table,) = [t for t in alone.outcomes["bearings"].tables if t.id == "rolling_duty"]
    heads = [str(label) for label, _ in table.columns]
    rows = [dict(zip(heads, row)) for row in table.rows]
    assert [(str(row["bearing"]), str(row["part"])) for row in rows] == [
        ("front", "slow"), ("front", "fast"), ("rear", "slow"), ("rear", "fast"),
    ]  # fmt: skip
    r = alone.result(BearingsResult)
    assert r is not None
    for place in ("front", "rear"):
        mine = [row for row in rows if row["bearing"] == place]
        assert sum(row["of the damage"] for row in mine) == pytest.approx(100, rel=1e-3)
        assert mine[1]["of the damage"] > 50  # a quarter of the hours, and most of the load
        loss = sum(row["hours"] / 100 * row["P_f"] for row in mine)
        assert loss == pytest.approx(r.bearings[place].duty_loss, rel=1e-3)


def test_the_least_load_crosses_the_load_where_it_is_said(alone):
    (curve,) = [c for c in alone.outcomes["bearings"].curves if c.id == "rolling_least_load"]
    load, least = ({str(s.label): s for s in curve.series}[name] for name in ("load, rear", "least load, rear"))
    r = alone.result(BearingsResult)
    assert r is not None
    n = r.bearings["rear"].minimum_load_speed * 60
    crossing = np.interp(0.0, load.y - least.y, load.x)
    assert crossing == pytest.approx(n, rel=0.02)
