"""How the crank turns: given values of an independent program, and what must hold."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.engine.load import CrankTorque, crank_torque
from calc.engine.operation import CrankTwist
from calc.gears.drive import crank
from calc.gears.drive.crank import UnevenRow, beyond_twist, extremes, motion, twist_stiffness, where_it_acts
from calc.sheet.errors import NoSolution
from calc.sheet.value import link_of, trace
from tests.calc.engine.given_drive import cases, engine_of

MOTIONS = ("R753 idle, row", "R753 rated, full load", "single 400, no load")


def torque_of(begins):
    given = cases(begins)[0]["given"]
    n = given["speed_rpm"] / 60
    if "gas" in given:
        engine, e = engine_of(given, given["gas"])
        return given, crank_torque(engine, e, [], np.array([n]), np.ones(1), idle=n)
    engine, e = engine_of(given, given["full"], 7000 / 60)
    return given, crank_torque(engine, e, [], np.array([n]), np.zeros(1), idle=n)


def wave(given, torque):
    alpha = crank.acceleration(t_n=torque.t[0], J_E=given["inertia_total_kgm2"])
    return crank.published(alpha, torque.orders, given["speed_rpm"] / 60, torque.cycle, torque.mean[0])


@pytest.mark.parametrize("begins", MOTIONS)
def test_given_motion_of_the_crank(begins):
    given, torque = torque_of(begins)
    found = wave(given, torque)
    values = {
        "gears.drive.irregularity": found.irregularity * 100,
        "gears.drive.acceleration_up": found.up,
        "gears.drive.acceleration_down": found.down,
        "gears.drive.mean_torque": found.mean_torque,
        "gears.drive.acceleration.order_1_5": found.orders["1_5"],
    }
    rows = cases(begins, *values)
    assert len(rows) >= 3
    for row in rows:
        assert values[row["id"]] == pytest.approx(row["is"], rel=row["rel"]), row["id"]


def test_the_cut_series_is_nearly_that_of_the_engine():
    given, torque = torque_of("R753 rated, full load")
    _, e = engine_of(given, given["gas"])
    uncut = float(e.torque.energy_fluctuation) / given["inertia_total_kgm2"] / (2 * math.pi * 2600 / 60) ** 2
    assert wave(given, torque).irregularity == pytest.approx(uncut, rel=1e-3)


def test_what_is_published_says_where_it_comes_from():
    given, torque = torque_of("R753 idle, row")
    with trace() as lines:
        found = wave(given, torque)
    assert {line.formula.symbol for line in lines} == {"ω'_n", "δ_s", "ω'_max", "ω'_min", "ω̂'_n"}
    assert all(link_of(x) in lines for x in (found.irregularity, found.up, found.down, *found.orders.values()))


def test_twice_the_inertia_is_half_the_acceleration():
    _, torque = torque_of("R753 idle, row")
    one, two = (motion(torque, np.array([15.0]), J, 0.037) for J in (0.9, 1.8))
    assert two.a == pytest.approx(one.a / 2, rel=1e-14)
    assert one.period == pytest.approx(4 * math.pi / 3)  # evenly firing: a third of the cycle
    again = motion(torque, np.array([15.0]), 0.9, 0.037, 2.0)
    assert again.a == pytest.approx(2 * one.a, rel=1e-14)


def test_extremes_of_a_wave_whose_top_lies_between_the_nodes():
    """cos(ε − φ) and its integral, for any phase; the parabola leaves 1e-7 on 120 nodes."""
    phases = np.linspace(0, 2 * np.pi, 37)
    a = np.exp(-1j * phases)[:, None] * np.array([[1.0, 0.0]])
    for integrals, size in ((0, 1.0), (1, 1.0)):
        least, most = extremes(a, np.array([1.0, 2.0]), 2 * np.pi, integrals)
        assert most == pytest.approx(np.full(37, size), rel=1e-6) and least == pytest.approx(-most, rel=1e-6)
    assert extremes(np.zeros((2, 2), complex), np.array([1.0, 2.0]), 2 * np.pi)[1] == pytest.approx([0, 0])


# --- the twist of the crank


@pytest.mark.parametrize("row", cases("nose"), ids=lambda row: f"{row['case']} {row['id']}")
def test_given_nose(row):
    g = row["given"]
    J_n, J_f, Omega = g["nose_inertia_kgm2"], g["rest_inertia_kgm2"], g["order"] * g["omega"]
    k = twist_stiffness(f=g["frequency_Hz"], J_n=J_n, J_f=J_f, zeta=g["damping_ratio"])
    of = where_it_acts if g["torque_at"] == "front" else beyond_twist
    alpha = of(t_n=g["t_n"], k=k, Omega=Omega, J=J_n, J_o=J_f)
    found = abs(alpha) if row["id"] == "nose.acceleration_amplitude" else math.degrees(cmath.phase(alpha))
    assert found == pytest.approx(row["is"], rel=row["rel"])


TWIST = CrankTwist(frequency=300.0, nose_inertia=0.12, damping_ratio=0.03)


@pytest.fixture(scope="module")
def many():
    """The R753 at full load over its speeds."""
    given = cases("R753 rated, full load")[0]["given"]
    engine, e = engine_of(given, given["gas"])
    speeds = np.linspace(15, 130 / 3, 9)
    return speeds, crank_torque(engine, e, [], speeds, np.ones(9), idle=15.0)


@pytest.mark.parametrize("nose", [False, True])
def test_a_stiff_crank_is_rigid(many, nose):
    speeds, torque = many
    stiff = replace(TWIST, frequency=1e6)
    rigid = motion(torque, speeds, 0.9, 0.037)
    assert motion(torque, speeds, 0.9, 0.037, twist=stiff, nose=nose).a == pytest.approx(rigid.a, rel=1e-6, abs=1e-6)


def test_both_masses_together_take_the_torque(many):
    """J_n·α_nose + J_f·α_flywheel = t_n without damping, wherever the torque acts."""
    speeds, torque = many
    omega, free = 2 * np.pi * speeds, replace(TWIST, damping_ratio=0.0)
    noses = crank.twisted(torque.t, torque.orders, omega, 0.9, free, nose=True)
    flywheels = crank.twisted(torque.t, torque.orders, omega, 0.9, free, nose=False)
    for at_nose, at_flywheel in zip(noses, flywheels):
        assert 0.12 * at_nose + 0.78 * at_flywheel == pytest.approx(torque.t, rel=1e-9, abs=1e-9 * abs(torque.t).max())
    assert np.abs(noses[0] - noses[1]).max() > 0.1 * np.abs(noses[0]).max()


def test_the_harder_place_of_the_torque_is_taken_whole(many):
    """At each point one of both motions, that with the larger max(−x₀''); any share of the torque between the two gives
    no more."""
    speeds, torque = many
    omega, r, twist = 2 * np.pi * speeds, 0.037, replace(TWIST, frequency=600.0)
    taken = motion(torque, speeds, 0.9, r, twist=twist, nose=True)
    falls = -extremes(taken.a, torque.orders, torque.cycle)[0]
    front, rear = crank.twisted(torque.t, torque.orders, omega, 0.9, twist, nose=True)
    each = np.array([-extremes(r * place, torque.orders, torque.cycle)[0] for place in (front, rear)])
    assert falls == pytest.approx(each.max(0), rel=1e-12) and np.unique(each.argmax(0)).size == 2
    for share in (0.25, 0.5, 0.75):
        between = -extremes(r * (share * front + (1 - share) * rear), torque.orders, torque.cycle)[0]
        assert (between <= falls * (1 + 1e-6)).all()


def test_a_nose_that_is_heavier_than_all(many):
    speeds, torque = many
    with pytest.raises(NoSolution, match=r"must be below the inertia of flywheel and train, 0.12 kg·m²"):
        motion(torque, speeds, 0.12, 0.037, twist=TWIST)
    assert crank.twist_problem(TWIST, 0.1201) is None


# --- an irregularity that is given, or taken


def test_given_rows_are_linear_in_the_acceleration():
    rows = [UnevenRow(40.0, 0.02, 1.5), UnevenRow(15.0, 0.05, 1.5)]
    speeds = np.array([10.0, 15.0, 27.5, 40.0, 60.0])
    found = crank.given_motion(rows, speeds, 4 * math.pi, 0.037)
    low, high = (delta / 2 * 1.5 * (2 * math.pi * n) ** 2 * 0.037 for n, delta in ((15, 0.05), (40, 0.02)))
    assert found.orders.tolist() == [1.5]
    assert found.a[:, 0] == pytest.approx([low, low, (low + high) / 2, high, high], rel=1e-12)
    assert found.over(np.array([0.0]))[:, 0] == pytest.approx(found.a[:, 0].real)  # cos nε


def test_rows_of_several_orders_stand_each_by_itself():
    rows = [UnevenRow(10.0, 0.05, 1.0), UnevenRow(20.0, 0.02, 2.0)]
    orders, alpha = crank.given_accelerations(rows, np.array([10.0, 15.0, 20.0]))
    assert orders.tolist() == [1, 2] and (np.abs(alpha) > 0).tolist() == [[True, False], [True, True], [False, True]]


@pytest.mark.parametrize(("orders", "turns"), [((0.7, 1.3), 10), ((1.5, 2.2), 10), ((1.7,), 1 / 1.7), ((0.5, 3), 2)])
def test_orders_that_do_not_fit_the_cycle_have_a_period_of_their_own(orders, turns):
    rows = [UnevenRow(speed=10.0 * (i + 1), delta=0.05, order=order) for i, order in enumerate(orders)]
    moved = crank.given_motion(rows, np.array([15.0]), 4 * math.pi, 0.025)
    assert moved.cycle == 4 * math.pi and moved.period == pytest.approx(2 * math.pi * turns, rel=1e-12)
    epsilon = np.linspace(0.0, 2 * math.pi * turns, 20001)
    wave = moved.over(epsilon)[0]
    assert wave[-1] == pytest.approx(wave[0], rel=1e-9)
    least, most = extremes(moved.a, moved.orders, moved.cycle)
    assert (least[0], most[0]) == pytest.approx((wave.min(), wave.max()), rel=1e-3)


def test_the_irregularity_of_a_row_returns():
    row = UnevenRow(15.0, 0.05, 1.5)
    orders, alpha = crank.given_accelerations([row], np.array([15.0]))
    found = crank.published(alpha[0], orders, 15.0, 4 * math.pi)
    assert found.irregularity == pytest.approx(0.05, rel=1e-6) and found.mean_torque is None
    assert found.up == pytest.approx(-found.down, rel=1e-6) and found.orders == {
        "1_5": pytest.approx(found.up, rel=1e-6)
    }


@pytest.mark.parametrize(
    ("cylinders", "delta"), [(1, 0.10), (2, 0.06), (3, 0.05), (4, 0.03), (5, 0.03), (6, 0.02), (8, 0.02)]
)
def test_what_is_taken_where_nothing_is_known(cylinders, delta):
    given = cases("R753 idle, row")[0]["given"]
    engine, _ = engine_of(given, given["gas"])
    row = crank.default_row(replace(engine, cylinders=cylinders), 15.0)
    assert (row.speed, row.delta, row.order) == (15.0, delta, cylinders / 2)
    steady = crank.given_motion([row], np.array([15.0, 50.0]), 4 * math.pi, 0.037)
    assert steady.a[0] == pytest.approx(steady.a[1])  # constant over speed


def test_no_torque_no_motion():
    silent = CrankTorque(np.array([1.5, 3.0]), np.zeros((1, 2), complex), np.zeros(1), 4 * math.pi, (), None)
    assert not motion(silent, np.array([15.0]), 0.9, 0.037).over(np.linspace(0, 12, 5)).any()
