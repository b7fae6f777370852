# SPDX-License-Identifier: Apache-2.0
"""The heat of rolling bearings, their speeds and their least load, against the given values and against limits."""

import math

import numpy as np
import pytest
from hypothesis import given as drawn
from hypothesis import settings
from hypothesis import strategies as st

from calc.bearings.rolling import balance as b
from calc.bearings.rolling.torque import friction_of
from calc.library.catalogue import Oil, ViscosityRow
from calc.library.lubricant import Lubricant
from calc.sheet.errors import NoSolution
from calc.sheet.value import link_of, linked, trace
from tests.calc.bearings.rolling.typical import BEARINGS, OIL, given

RATED = 2600 / 60


def conductance(size):
    one = BEARINGS[size]
    return b.heat_conductance(A=b.heat_surface(B=one.B, d=one.d, D=one.D))


def mean_load(turning, standing):
    """The mean amount of both together, over the turn."""
    theta = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    return np.mean(np.abs(turning + standing * np.exp(1j * theta)[:, None]), axis=0)


def balance(size, F, n=RATED, T_oil=120.0, **said):
    return b.heat_balance(BEARINGS[size].friction(**said), F, n, T_oil, conductance(size), OIL.nu)


@pytest.mark.parametrize(
    "turning, standing, temperature, loss",
    [(1706.81, 78.2488, 127.6576, 8.891467), (1713.62, 47.5605, 127.6688, 8.90452)],
)
def test_given_temperature_and_loss(turning, standing, temperature, loss):
    """NU205 and NJ205 at 2600 rpm in oil of 120 °C."""
    found = balance("NU205", mean_load(turning, standing).item())
    assert found.temperature == pytest.approx(temperature, abs=1e-3)
    assert found.loss == pytest.approx(loss, rel=1e-5)
    assert found.viscosity == OIL.nu(found.temperature)


@pytest.mark.parametrize(
    "size, turning, standing, loss", [("6305", 1500.0, 120.0, 4.123626), ("HK3020", 1650.0, 40.0, 11.4438)]
)
def test_given_losses_over_a_profile(size, turning, standing, loss):
    """Turning load by the square of the speed, the standing one the same, oil by the row, weighed by the hours."""
    rpm, hours, T_oil = np.array([900.0, 2200.0, 2600.0]), np.array([0.2, 0.6, 0.2]), np.array([80.0, 105.0, 115.0])
    F = mean_load(turning * (rpm / 2600) ** 2, standing)
    found = balance(size, F, rpm / 60, T_oil)
    assert found.loss @ hours == pytest.approx(loss, rel=1e-5)


@settings(max_examples=40)
@drawn(
    st.sampled_from(sorted(BEARINGS)), st.sampled_from(["splash", "mist", "bath"]), st.floats(50, 5e3),
    st.floats(5, 100), st.floats(-20, 140),
)  # fmt: skip
def test_the_heat_given_off_is_the_friction(size, lubrication, F, n, T_oil):
    found = balance(size, F, n, T_oil, lubrication=lubrication)
    friction = found.torque * 2 * math.pi * n
    assert found.loss == pytest.approx(friction, rel=1e-9)
    assert found.loss == pytest.approx(conductance(size) * (found.temperature - T_oil), rel=1e-12)
    assert T_oil < found.temperature < T_oil + 400


def test_what_stands_still_is_as_warm_as_its_oil():
    found = balance("6205", 1000.0, 0.0, 90.0)
    assert found.temperature == pytest.approx(90.0, abs=1e-9) and found.loss == pytest.approx(0.0, abs=1e-9)


def test_more_heat_leaves_a_cooler_bearing():
    friction = BEARINGS["NU205"].friction()
    rises = [b.heat_balance(friction, 1700.0, RATED, 120.0, hA, OIL.nu).temperature for hA in (0.5, 1.2, 5.0, 1e9)]
    assert rises == sorted(rises, reverse=True) and rises[-1] == pytest.approx(120.0, abs=1e-6)


def test_no_balance_is_told_and_others_of_many_are_kept():
    friction, hA = BEARINGS["HK2520"].friction(), 1e-3
    with pytest.raises(NoSolution, match=r"heat of its friction.*1700 N at 9000 rpm in oil of 120 °C.*400 K"):
        b.heat_balance(friction, 1700.0, 150.0, 120.0, hA, OIL.nu)
    conductances = np.array([hA, conductance("HK2520")])
    with pytest.raises(NoSolution):
        b.heat_balance(friction, 1700.0, 150.0, 120.0, conductances, OIL.nu)
    found = b.heat_balance(friction, 1700.0, 150.0, 120.0, conductances, OIL.nu, outside="nan")
    alone = b.heat_balance(friction, 1700.0, 150.0, 120.0, conductances[1].item(), OIL.nu)
    assert np.isnan(found.temperature[0]) and np.isnan(found.loss[0])
    assert found.temperature[1] == pytest.approx(alone.temperature, rel=1e-12)


def test_a_number_that_is_none_has_no_balance():
    with pytest.raises(NoSolution):
        balance("NU205", math.nan)


def test_many_rows_and_bearings_are_the_single_ones():
    series, d = ["60", "62", "63"], np.array([0.02, 0.025, 0.03])
    D, B, rating = d + 0.027, d * 0.6, d * 4e5
    F, n, T_oil = np.array([[200.0], [1700.0]]), np.array([[15.0], [50.0]]), np.array([[80.0], [115.0]])
    hA = b.heat_conductance(A=b.heat_surface(B=B, d=d, D=D))
    many = b.heat_balance(friction_of("ball", series, d, D, B, static_rating=rating), F, n, T_oil, hA, OIL.nu)
    assert many.temperature.shape == many.loss.shape == (2, 3)
    for k, name in enumerate(series):
        one = friction_of("ball", name, *(x[k].item() for x in (d, D, B)), static_rating=rating[k].item())
        for row in (0, 1):
            point = (x[row, 0].item() for x in (F, n, T_oil))
            alone = b.heat_balance(one, *point, hA[k].item(), OIL.nu)
            assert many.temperature[row, k] == pytest.approx(alone.temperature, abs=1e-9)
            assert many.loss[row, k] == pytest.approx(alone.loss, rel=1e-9)


def test_the_temperature_knows_what_it_follows_from():
    F, T_oil = linked(1700.0, "bearings.load_N"), linked(120.0, "bearings.supply_temperature_C")
    with trace() as lines:
        found = balance("NU205", F, T_oil=T_oil)
    line = link_of(found.temperature)
    assert line.formula is b.running_temperature and line in lines
    assert {"bearings.load_N", "bearings.supply_temperature_C"} <= set(line.arguments["from"].link)
    assert found.loss == balance("NU205", 1700.0).loss


def test_oils_by_rows_and_of_one_viscosity():
    rows = tuple(ViscosityRow(temperature=T, viscosity=mu) for T, mu in ((40.0, 0.08), (100.0, 0.012), (140.0, 0.005)))
    friction, hA = BEARINGS["NU205"].friction(), conductance("NU205")
    for said in (dict(viscosities=rows), dict(viscosity=0.01)):
        oil = Lubricant(Oil(name="own", rho15=860.0, base="mineral", **said))
        T_oil = np.array([60.0, 120.0])
        many = b.heat_balance(friction, 1700.0, RATED, T_oil, hA, oil.nu)
        with trace():
            traced = b.heat_balance(friction, 1700.0, RATED, linked(T_oil, "bearings.oil"), hA, oil.nu)
        assert traced.loss == pytest.approx(many.loss, rel=1e-12) and link_of(traced.temperature) is not None
        for k in (0, 1):
            alone = b.heat_balance(friction, 1700.0, RATED, T_oil[k].item(), hA, oil.nu)
            assert many.temperature[k] == pytest.approx(alone.temperature, abs=1e-9)
            assert alone.loss == pytest.approx(alone.torque * 2 * math.pi * RATED, rel=1e-9)


# --- speeds


@pytest.mark.parametrize("row", given("reference speed"), ids=lambda row: row["case"])
def test_given_reference_speeds(row):
    one = BEARINGS[row["inputs"]["size"]]
    speed = b.reference_speed(one.friction(lubrication="bath"), one.B)
    assert speed * 60 == pytest.approx(row["is"], rel=1e-5)


def test_the_reference_speed_carries_its_heat_off():
    """Of a large bearing less for each mm²: 0.016 W/mm² times (A/50 000)^−0.34."""
    for d, D, B, flux in ((0.025, 0.052, 0.015, 16000.0), (0.1, 0.2, 0.1, 16000 * (0.0942478 / 0.05) ** -0.34)):
        friction = friction_of("roller", "2", d, D, B, static_rating=3e4, lubrication="bath")
        n = b.reference_speed(friction, B)
        heat = 2 * math.pi * n * friction.by_two_parts(1500.0, n, 12e-6)
        assert heat == pytest.approx(flux * math.pi * B * (D + d), rel=1e-6)


def test_reference_speeds_of_many():
    d = np.array([0.02, 0.03, 0.05])
    many = b.reference_speed(friction_of("ball", "62", d, 2 * d, 0.5 * d, static_rating=d * 3e5), 0.5 * d)
    for k, x in enumerate(d.tolist()):
        one = friction_of("ball", "62", x, 2 * x, 0.5 * x, static_rating=x * 3e5)
        assert many[k] == pytest.approx(b.reference_speed(one, 0.5 * x), rel=1e-12)


def test_speed_factors():
    assert b.speed_factor(n=200.0, d_m=0.0385) == pytest.approx(12000 * 38.5)
    assert b.limiting_speed(X=550e3, d_m=0.0385) * 60 == pytest.approx(550e3 / 38.5)
    types = [("ball", "62"), ("roller", "2"), ("needle", "RNA49"), ("cage", "K"), ("roller", "own"), ("cup", "HK")]
    assert [b.largest_speed_factor(*type) for type in types] == [550e3, 600e3, 450e3, 450e3, 450e3, 330e3]


# --- the least load


@pytest.mark.parametrize("row", given("minimum load"), ids=lambda row: row["case"])
def test_given_minimum_loads(row):
    one = BEARINGS[row["inputs"]["size"]]
    n_ref = b.reference_speed(one.friction(lubrication="bath"), one.B)
    least = b.minimum_load(one.type, one.series, (one.d + one.D) / 2, RATED, 12e-6, n_ref, one.C)
    assert least == pytest.approx(row["is"], rel=1e-5)


def test_minimum_loads_in_the_units_of_the_catalogue():
    k_r = {"60": 0.025, "62": 0.025, "63": 0.03}
    for series, k in k_r.items():
        least = b.minimum_load("ball", series, 0.05, 50.0, 20e-6, 100.0, 1e4)
        assert least == pytest.approx(1000 * k * (20 * 3000 / 1000) ** (2 / 3) * 0.5**2)
    for series, k in {"10": 0.1, "2": 0.15, "3": 0.15, "22": 0.2, "23": 0.25}.items():
        assert b.minimum_load("roller", series, 0.05, 50.0, 20e-6, 100.0, 1e4) == pytest.approx(1000 * k * 8 * 0.25)
    shares = [("roller", "own", 200.0), ("ball", "own", 100.0), ("needle", "NA49", 200.0), ("cup", "HK", 200.0)]
    for type, series, least in (*shares, ("cage", "K", 200.0)):
        assert b.minimum_load(type, series, 0.05, 50.0, 20e-6, 100.0, 1e4) == pytest.approx(least)
    many = b.minimum_load("roller", ["10", "23"], np.array([0.05, 0.1]), 50.0, 20e-6, 100.0, 1e4)
    assert many == pytest.approx([1000 * 0.1 * 8 * 0.25, 1000 * 0.25 * 8])


def test_the_lowest_speed_from_which_the_load_is_enough():
    n = np.linspace(0.0, 50.0, 501)
    F = np.array([1.0, 4.0, 0.01, 0.0])[:, None] * n**2
    F[3] += 500.0
    speeds = b.minimum_load_speed(n, F, np.full(n.shape, 400.0))
    assert speeds[:2] == pytest.approx([20.0, 10.0], abs=1e-6) and np.isnan(speeds[2]) and speeds[3] == 0.0
    assert b.minimum_load_speed(n, F[0], np.full(n.shape, 400.0)) == pytest.approx(20.0, abs=1e-6)
    coarse, few = np.array([0.0, 10.0, 20.0, 30.0]), np.array([0.0, 100.0, 500.0, 5000.0])
    assert b.minimum_load_speed(coarse, few, np.full(4, 400.0)) == pytest.approx(17.5)  # −300 N, 100 N
    few[3] = 399.0
    assert np.isnan(b.minimum_load_speed(coarse, few, np.full(4, 400.0)))
    dips = np.where((n > 25) & (n < 30), 0.0, F[1])  # once more too small: from there on
    assert 29.9 < b.minimum_load_speed(n, dips, np.full(n.shape, 400.0)) <= 30.0


def test_idle_of_the_source_engine():
    """205 N at 900 rpm, 80 °C: enough for 6205 (28 N) and NU205 (140 N), not for HK2520 (365 N)."""
    least = {}
    for size in ("6205", "NU205", "HK2520"):
        one = BEARINGS[size]
        n_ref = b.reference_speed(one.friction(lubrication="bath"), one.B)
        least[size] = b.minimum_load(one.type, one.series, (one.d + one.D) / 2, 15.0, 23.2e-6, n_ref, one.C)
    assert [round(x) for x in least.values()] == [28, 140, 365]


# --- oil


@pytest.mark.parametrize("row", given("jet"), ids=lambda row: row["case"])
def test_given_jets(row):
    said = row["inputs"]
    flow = b.jet_flow(P=said["loss_W"], rho=said["density"], c_p=said["specific_heat"])
    assert flow * 60e3 == pytest.approx(row["is"], rel=row["rel"])
