"""The torque on the crank at any speed and load: given values of an independent program, and what must hold."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.design.operations import idle_speed, operations
from calc.design.toml_file import load
from calc.engine import load as of_load
from calc.engine.gas import GasInputs, PressurePoint
from calc.engine.gas_torque import basis
from calc.engine.inputs import TorquePoint
from calc.engine.load import Cylinder, crank_torque, friction_pressure, full_load, no_load
from calc.engine.operation import GasRow
from calc.engine.solve import solve
from calc.engine.torque import prepare
from calc.library.table_file import house_table
from calc.sheet.errors import NoSolution
from calc.sheet.value import trace
from tests.calc.engine.given_drive import cases, engine_of, gas_of, row_of
from tests.conftest import DESIGNS

IDLE, RATED = 900 / 60, 2600 / 60
NO_LOAD = cases("R753 no load solved")[0]["given"]
ONE_ROW = cases("R753 no load at 2000 rpm")[0]["given"]
SINGLE = cases("single 400")[0]["given"]


def value(begins, id):
    (row,) = cases(begins, id)
    return pytest.approx(row["is"], rel=row["rel"])


def fitted(given, gas, kappa, rated=RATED):
    """The engine of a case with the rated power that gives its friction this factor."""
    engine, e = engine_of(given, gas, rated)
    cylinder = cylinder_of(engine, e)
    line, _ = full_load(cylinder, engine.gas, [], rated)
    p_mi = cylinder.mean_pressure(line.at(np.array([rated])))[0]
    p_me = p_mi - kappa * float(rule(rated, e.stroke, "unthrottled"))
    return engine_of(given, gas, rated, float(p_me * e.displacement * rated / 2))


def rule(n, stroke, charge, kappa=1.0):
    row = house_table("engine_motion.toml")["friction"][charge]
    return friction_pressure(
        kappa=kappa,
        n=n,
        S_p=2 * stroke * n,
        a=row["constant_bar"] * 1e5,
        b=row["speed_bar"] * 6e3,
        c=row["square_bar"] * 360,
        d=row["piston_bar"] * 1e5,
    )


def cylinder_of(engine, e):
    cycle = prepare(engine, e, engine.gas)
    return Cylinder(engine, e, cycle.given, basis(engine, e, cycle, np.array([0.0, 1.5])))


def none(engine, e, rows, *speeds):
    cylinder = cylinder_of(engine, e)
    line, _ = full_load(cylinder, engine.gas, [row for row in rows if row.load == 1], IDLE)
    keys, _ = no_load(cylinder, engine.gas, [row for row in rows if row.load == 0], line, np.array(speeds))
    return cylinder, keys


# --- given values


def test_friction_by_the_rule():
    for given, charge in ((NO_LOAD, "unthrottled"), (SINGLE, "throttled")):
        case = "R753 no load solved" if charge == "unthrottled" else "single 400"
        p = rule(given["speed_rpm"] / 60, given["full"]["stroke"], charge, given["fmep_scale"])
        assert p / 1e5 == value(case, "no_load.target_bar")


def test_no_load_of_an_engine_without_throttle():
    engine, e = fitted(NO_LOAD, NO_LOAD["full"], NO_LOAD["fmep_scale"])
    cylinder, keys = none(engine, e, [], IDLE)
    assert keys.p_max[0] / 1e5 == value("R753 no load solved", "no_load.peak_pressure_bar")
    assert cylinder.mean_pressure(keys)[0] / 1e5 == value("R753 no load solved", "no_load.target_bar")
    assert (keys.p_in[0], keys.p_ex[0], keys.eps_p[0]) == pytest.approx((1e5, 1.05e5, math.radians(4)))


def test_no_load_from_one_row():
    engine, e = fitted(ONE_ROW, ONE_ROW["full"], ONE_ROW["fmep_scale"])
    rows = [row_of(ONE_ROW["row"], IDLE, 0.0)]
    cylinder, keys = none(engine, e, rows, 2000 / 60, IDLE)
    assert keys.p_max[0] / 1e5 == value("R753 no load at 2000 rpm", "no_load.peak_pressure_bar")
    assert cylinder.mean_pressure(keys)[0] / 1e5 == value("R753 no load at 2000 rpm", "no_load.target_bar")
    assert keys.p_max[1] == pytest.approx(ONE_ROW["row"]["p_max"], rel=1e-6)  # the row itself


def test_no_load_of_a_throttled_engine():
    engine, e = engine_of(SINGLE, SINGLE["full"], 7000 / 60)
    cylinder, keys = none(engine, e, [], 1300 / 60)
    assert keys.p_in[0] / 1e5 == value("single 400", "no_load.intake_pressure_bar")
    assert keys.p_max[0] / 1e5 == value("single 400", "no_load.peak_pressure_bar")
    assert cylinder.mean_pressure(keys)[0] / 1e5 == value("single 400", "no_load.target_bar")


def test_full_load_loses_its_boost_towards_idle():
    given = cases("R753 full load by rule")[0]["given"]
    engine, e = engine_of(NO_LOAD, given["full"])
    line, notes = full_load(cylinder_of(engine, e), engine.gas, [], IDLE)
    keys = line.at(np.array([1200, 900, 300, 1560, 2000, 2600]) / 60)
    for name in ("intake", "peak", "exhaust"):
        key = {"intake": keys.p_in, "peak": keys.p_max, "exhaust": keys.p_ex}[name]
        assert key[0] / 1e5 == value("R753 full load by rule", f"full_load.{name}_pressure_bar")
    assert keys.p_in[1:3] == pytest.approx([1e5, 1e5]) and keys.p_in[3:] == pytest.approx([1.75e5] * 3)
    assert keys.eps_p == pytest.approx([given["full"]["held"]] * 6)
    assert len(notes) == 1 and "1560 rpm" in notes[0]


@pytest.mark.parametrize("begins", ["R753 idle, row", "R753 rated, full load"])
def test_mean_torque_and_orders_of_the_given_engine(begins):
    given = cases(begins)[0]["given"]
    engine, e = engine_of(given, given["gas"])
    torque = crank_torque(engine, e, [], np.array([given["speed_rpm"] / 60]), np.ones(1), idle=given["speed_rpm"] / 60)
    if begins.startswith("R753 idle"):
        assert torque.mean[0] == value(begins, "gears.drive.mean_torque")
        assert np.abs(torque.t[0, 1]) == pytest.approx(160.568, rel=1e-4)  # T-9: the masses, at idle small
    assert torque.orders == pytest.approx(np.arange(1.5, 24.1, 1.5)) and torque.cycle == pytest.approx(4 * math.pi)
    assert torque.t[0, 0].__abs__() == pytest.approx({900: 243.45, 2600: 628.88}[given["speed_rpm"]], rel=1e-4)


# --- a design: the rows of its mounts


@pytest.fixture(scope="module")
def r753():
    design = load(DESIGNS / "r753ie4_mounting.toml")[1]
    return design, solve(design.engine).result


def test_rows_of_an_old_file_have_their_loads(r753):
    design, _ = r753
    rows = operations(design.engine, design.mounting)
    assert [(round(row.speed * 60), row.load) for row in rows] == [
        (900, 0.0),
        (2600, 1.0),
    ]  # two of four say of the gas
    assert idle_speed(design.engine, design.mounting) == design.mounting.idle_speed
    assert idle_speed(design.engine, None) == pytest.approx(600 / 60)  # 338 rpm by the share
    assert idle_speed(replace(design.engine, idle_speed=13.0), design.mounting) == 13.0
    assert idle_speed(replace(design.engine, rated_speed=6000 / 60), None) == pytest.approx(780 / 60)
    assert idle_speed(replace(design.engine, rated_speed=500 / 60), None) == 500 / 60


def test_the_rated_power_fits_the_friction(r753):
    design, e = r753
    with trace() as lines:
        crank_torque(design.engine, e, [], np.array([IDLE]), np.zeros(1), idle=IDLE)
    (kappa,) = [line.value for line in lines if line.formula is of_load.friction_factor]
    assert kappa == pytest.approx(NO_LOAD["fmep_scale"], rel=1e-5)
    assert {line.formula for line in lines} >= {of_load.friction_pressure, of_load.peak_without_load}


def test_many_points_are_those_of_each(r753):
    design, e = r753
    rows = operations(design.engine, design.mounting)
    speeds, loads = np.repeat(np.linspace(IDLE, RATED, 5), 3), np.tile([0.0, 0.5, 1.0], 5)
    together = crank_torque(design.engine, e, rows, speeds, loads, idle=IDLE)
    for i in (0, 1, 5, 7, 14):
        alone = crank_torque(design.engine, e, rows, speeds[i : i + 1], loads[i : i + 1], idle=IDLE)
        assert alone.t[0] == pytest.approx(together.t[i], rel=1e-9, abs=1e-9)
        assert alone.mean[0] == pytest.approx(together.mean[i], rel=1e-9)


def test_keys_are_linear_in_the_load_and_the_torque_is_not(r753):
    """T-8: the held angle bends the torque."""
    design, e = r753
    rows = operations(design.engine, design.mounting)
    torque = crank_torque(design.engine, e, rows, np.full(3, 35.0), np.array([0.0, 0.5, 1.0]), idle=IDLE)
    for key in torque.keys.every:
        assert key[1] == pytest.approx((key[0] + key[2]) / 2, rel=1e-12)
    middle = (torque.t[0] + torque.t[2]) / 2
    assert np.abs(torque.t[1] - middle).max() > 0.01 * np.abs(torque.t[1]).max()


def test_two_rows_without_load_are_a_line(r753):
    design, e = r753
    rows = [GasRow(IDLE, 0.0, dict(peak_pressure=50e5)), GasRow(RATED, 0.0, dict(peak_pressure=70e5))]
    torque = crank_torque(
        design.engine, e, rows, np.array([IDLE, (IDLE + RATED) / 2, RATED, 50.0]), np.zeros(4), idle=IDLE
    )
    assert torque.keys.p_max / 1e5 == pytest.approx([50, 60, 70, 70]) and len(torque.notes) == 1


def test_rows_of_part_load_are_told(r753):
    design, e = r753
    rows = operations(design.engine, design.mounting)
    with_part = [*rows, GasRow(30.0, 0.5, dict(peak_pressure=90e5))]
    plain, told = (
        crank_torque(design.engine, e, each, np.array([30.0]), np.array([0.5]), idle=IDLE) for each in (rows, with_part)
    )
    assert told.mean == pytest.approx(plain.mean) and set(told.notes) - set(plain.notes) == {of_load.PART_LOAD}


# --- what has no answer


def test_a_two_stroke_asks_for_its_row():
    engine, e = engine_of(SINGLE | {"engine": SINGLE["engine"] | {"strokes": 2}}, SINGLE["full"], 6000 / 60)
    one = np.ones(1)
    assert crank_torque(engine, e, [], 50 * one, one, idle=20.0).cycle == pytest.approx(2 * math.pi)
    with pytest.raises(NoSolution, match=r"the no-load cycle of a two-stroke is not solved.*load_percent = 0"):
        crank_torque(engine, e, [], 50 * one, 0.5 * one, idle=20.0)
    rows = [GasRow(20.0, 0.0, dict(peak_pressure=25e5))]
    assert crank_torque(engine, e, rows, 50 * one, 0 * one, idle=20.0).keys.p_max[0] == 25e5


def test_nothing_gives_the_friction():
    """At a speed that no engine has, and in a throttled cycle that burns next to nothing; full load needs neither."""
    engine, e = engine_of(NO_LOAD, NO_LOAD["full"])
    speeds = np.array([IDLE, 1000.0])
    with pytest.raises(NoSolution, match=r"no peak pressure gives the friction pressure of .* bar at 60000 rpm"):
        crank_torque(engine, e, [], speeds, np.zeros(2), idle=IDLE)
    assert crank_torque(engine, e, [], speeds, np.ones(2), idle=IDLE).mean[0] > 0
    engine, e = engine_of(SINGLE, SINGLE["full"] | {"p_max": 15e5}, 7000 / 60)
    with pytest.raises(NoSolution, match=r"no intake pressure .* at 1300 rpm; give the row of load 0"):
        crank_torque(engine, e, [], np.array([1300 / 60]), np.zeros(1), idle=1300 / 60)


def test_charge_is_given_or_by_the_compression_ratio():
    full = NO_LOAD["full"]
    assert of_load.unthrottled(gas_of(full)) and not of_load.unthrottled(gas_of(SINGLE["full"]))
    assert of_load.unthrottled(gas_of(full | {"ratio": 14.0})) and not of_load.unthrottled(
        gas_of(full | {"ratio": 13.9})
    )
    assert not of_load.unthrottled(gas_of(full, charge="throttled"))


def test_a_table_of_pressures_has_one_load(r753):
    design, _ = r753
    epsilon = np.radians(np.arange(0, 720, 1.0))
    points = tuple(
        PressurePoint(angle=float(a), pressure=float(1e5 + 50e5 * math.exp(-((a - 0.3) ** 2)))) for a in epsilon
    )
    engine = replace(design.engine, gas=GasInputs(pressure=points))
    torque = crank_torque(engine, solve(engine).result, [], np.array([IDLE, RATED]), np.array([0.0, 1.0]), idle=IDLE)
    assert torque.keys is None and torque.notes == (of_load.ONE_LOAD,)
    assert torque.mean[0] == torque.mean[1] and abs(torque.t[0, 1] - torque.t[1, 1]) > 1  # the masses differ


def test_a_torque_diagram_by_hand(r753):
    """T = 100 + 60 cos 1.5ε − 20 sin 3ε N·m in straight lines of 0.1°."""
    design, _ = r753
    degrees = np.arange(0, 720, 0.1)
    T = 100 + 60 * np.cos(np.radians(1.5 * degrees)) - 20 * np.sin(np.radians(3 * degrees))
    rows = tuple(TorquePoint(angle=math.radians(a), torque=float(t)) for a, t in zip(degrees, T))
    engine = replace(design.engine, gas=None, torque=rows)
    torque = crank_torque(engine, solve(engine).result, [], np.array([IDLE, RATED]), np.ones(2), idle=IDLE)
    there = {1.5: 60, 3.0: 20j}
    for i, n in enumerate(torque.orders.tolist()):
        assert torque.t[0, i] == pytest.approx(there.get(n, 0), abs=1e-3)
    assert torque.mean == pytest.approx([100, 100]) and (torque.t[0] == torque.t[1]).all()
