# SPDX-License-Identifier: Apache-2.0
"""Flanks that part and strike: closed forms, laws, and the vectorised form against a solver that goes event by event
(tests/reference/drive.json is asked in test_forces.py)."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.drive.forces import impacts
from calc.gears.drive.motion import Motion, peak
from calc.gears.drive.strikes import closed, course, fly, quiet_backlash, speed_by_jerk
from tests.calc.gears.drive import event_solver as solver
from tests.calc.gears.drive.lanes import given_of, lane, motion, train


def flown(motion, bodies):
    of = closed(motion, bodies)
    return of, fly(motion, bodies, of)


# --- the event solver itself, on orbits that have a closed form


@pytest.mark.parametrize("e", [0.3, 0.5, 0.8])
def test_solver_ball_on_a_vibrating_table(e):
    """One bounce a period: u = 2πg/(ω(1 + e)); the table rises at g·T·(1 − e)/(2(1 + e)) at the strike."""
    omega, g, A = 60.0, 9.81, 5e-3
    T = 2 * math.pi / omega
    u, v = g * T / (1 + e), g * T * (1 - e) / (2 * (1 + e))
    t = math.acos(v / (A * omega)) / omega  # x = A·sin ωt
    table = solver.Driver(np.array([omega]), np.array([1j * A * omega**2]), T)
    assert table.of(t, 1) == pytest.approx(v, rel=1e-12)
    # the driver is pressed to what it drives from below: y' after the strike is away from its flank
    for bounce in range(1, 4):
        at, flank, slope = solver.flight(table, g, 1.0, t + (bounce - 1) * T, 1, -e * u)
        assert flank == 1
        assert at == pytest.approx(t + bounce * T, abs=1e-12)
        assert slope == pytest.approx(u, rel=1e-12)


@pytest.mark.parametrize("e", [0.0, 0.3, 0.6])
def test_solver_from_flank_to_flank_without_drag(e):
    """γ·cos φ + (2/π)·sin φ = J/(πA), u = 2·A·ω·cos φ/(1 − e), γ = (1 + e)/(1 − e): a strike each half period."""
    omega, A, phi = 80.0, 5e-4, 0.4
    gamma = (1 + e) / (1 - e)
    J = math.pi * A * (gamma * math.cos(phi) + 2 / math.pi * math.sin(phi))
    u = 2 * A * omega * math.cos(phi) / (1 - e)
    driver = solver.Driver(np.array([omega]), np.array([-A * omega**2 + 0j]), 2 * math.pi / omega)
    # x = A·cos ωt; the driving flank is struck at φ − 90°, the coast flank half a period later
    at, flank, slope = solver.flight(driver, 0.0, J, (phi - math.pi / 2) / omega, 1, -e * u)
    assert flank == -1
    assert at * omega == pytest.approx(phi + math.pi / 2, abs=1e-12)
    assert slope == pytest.approx(-u, rel=1e-12)
    at, flank, slope = solver.flight(driver, 0.0, J, at, -1, e * u)
    assert (flank, at * omega) == (1, pytest.approx(phi + 3 * math.pi / 2, abs=1e-12))
    assert slope == pytest.approx(u, rel=1e-12)


# --- the vectorised form against it


def random_lanes(count, seed=3, shares=(0.05, 2)):
    """Motions of 8 harmonics, Γ 1.1 … 12, a backlash of so many half swings."""
    rng = np.random.default_rng(seed)
    orders = 1.5 * np.arange(1, 9)
    a = (rng.normal(size=(count, 8)) + 1j * rng.normal(size=(count, 8))) / np.arange(1, 9) ** 1.2 * 8
    m = motion(a, orders, rng.uniform(80, 280, count))
    epsilon = m.nodes(m.period)
    x = m.over(epsilon, 2)
    J = np.exp(rng.uniform(*np.log(shares), count)) * (peak(x) + peak(-x)) / 2
    g = peak(-m.over(epsilon)) / np.exp(rng.uniform(math.log(1.1), math.log(12), count))
    mass = 2.0
    return m, train(mass=[mass], drag=mass * g[:, None], backlash=J[:, None])


@pytest.mark.parametrize("count, seed, shares, enough", [(108, 3, (0.05, 2), 100), (40, 4, (1, 4), 30)])
def test_as_event_by_event(count, seed, shares, enough):
    """Speeds to 1e-4 of the hardest strike; the second lanes have so much backlash that many strikes fall where the
    flank pulls away and let go at once."""
    m, bodies = random_lanes(count, seed, shares)
    of, strikes = flown(m, bodies)
    assert of.parts.all()
    compared = at_once = 0
    for i in range(count):
        driver = solver.Driver(m.orders * m.omega[i], m.a[i], m.period / m.omega[i])
        found, length, before = solver.orbit(driver, float(bodies.drag[i, 0] / 2.0), float(bodies.backlash[i, 0]), 9)
        if before is None or before + len(found) > 8:
            continue
        compared += 1
        at_once += any(strike.press * strike.flank < 0 for strike in found)
        u = strikes.speed[i, 0][strikes.speed[i, 0] > 0]
        wanted = np.array([abs(strike.speed) for strike in found])
        assert strikes.closes[i, 0] and len(u) == len(wanted)
        assert u == pytest.approx(wanted, abs=1e-4 * wanted.max()), i
        assert strikes.orbit[i, 0] == pytest.approx(length, rel=1e-6)
        first = int(strikes.first[i, 0])
        assert list(strikes.flank[i, 0, first : first + len(found)]) == [strike.flank for strike in found]
    assert compared >= enough and (seed == 3 or at_once >= 5)


def test_what_the_flanks_do_is_what_the_strikes_lose():
    """Over an orbit: work of the driver's flanks, at rest and in the strikes, against Σ M·u²/2."""
    m, bodies = random_lanes(100, seed=5)
    of, strikes = flown(m, bodies)
    M = float(of.mass[0])
    for i in np.flatnonzero(strikes.closes[:, 0]):
        D, omega, at = float(of.drag[i, 0]), m.omega[i], Motion(m.orders, m.a[[i]], m.omega[[i]], m.cycle).over
        first = int(strikes.first[i, 0])
        done = lost = 0.0
        for e in range(first, first + int((strikes.speed[i, 0] > 0).sum())):
            ends = np.array([strikes.struck[i, 0, e], strikes.let_go[i, 0, e + 1]])
            v, x = at(ends, 1)[0], at(ends, 2)[0]
            u = strikes.speed[i, 0, e] * strikes.flank[i, 0, e]
            done += M * u * v[0] + M * (v[1] ** 2 - v[0] ** 2) / 2 + D * (x[1] - x[0])
            lost += M * u**2 / 2
        assert done == pytest.approx(lost, rel=1e-3)
        assert strikes.power[i, 0] * strikes.orbit[i, 0] == pytest.approx(lost, rel=1e-9)
        assert strikes.orbit[i, 0] * omega / m.period == pytest.approx(
            round(strikes.orbit[i, 0] * omega / m.period), abs=1e-5
        )


# --- laws


def test_where_nothing_parts_nothing_strikes():
    m = motion([[2.0], [2.4], [2.7]])
    bodies = train((-1, 0), [1.0, 1.0], np.tile([3.0, 2.5], (3, 1)), [70e-6, 70e-6])
    of, strikes = flown(m, bodies)
    assert of.separation[:, 1] == pytest.approx([2 / 2.5, 2.4 / 2.5, 2.7 / 2.5])
    assert of.parts.tolist() == [[False, False], [False, False], [False, True]]
    assert strikes.hardest[:2].max() == 0
    found = impacts(m, bodies, of, strikes)
    for name in ("speed", "impacts", "flanks", "power", "low", "high", "share"):
        assert not getattr(found, name)[:2].any(), name
    assert found.speed[2, 1] > 0


def test_a_strike_on_the_path_strikes_all_behind():
    m = motion([[8.0], [14.0]], omega=[80.0, 150.0])
    bodies = train((-1, 0, 1, 0), [2.0, 0.3, 0.2, 0.1], np.tile([0.5, 6.0, 5.0, 4.0], (2, 1)), [70e-6] * 4)
    of, strikes = flown(m, bodies)
    assert of.parts.tolist() == [[True, False, False, False]] * 2
    found = impacts(m, bodies, of, strikes)
    assert (found.low > 0).all() and (found.high >= found.low * (1 - 1e-9)).all()
    assert found.speed == pytest.approx(np.repeat(found.speed[:, :1], 4, 1), rel=1e-12)
    assert not found.power[:, 1:].any()


def test_small_backlash_follows_the_jerk():
    """u → I^⅓·(6J)^⅔/2 where p falls through 0; one sinusoid without drag: I = A·n·ω.  Γ hardly matters."""
    A, order, omega = 10.0, 2.0, 80.0
    J = np.array([1e-9, 1e-8, 1e-7])
    m = motion(np.full((3, 1), A), [order], omega)
    _, strikes = flown(m, train(drag=np.zeros((3, 1)), backlash=J[:, None]))
    wanted = [speed_by_jerk(A * order * omega, float(j)) for j in J]
    assert strikes.hardest[:, 0] == pytest.approx(wanted, rel=3e-3)
    assert strikes.hardest[0, 0] == pytest.approx(wanted[0], rel=3e-4)
    assert strikes.press[0].max() < 0.03 * A  # with the third root of J: the force goes to nothing


def test_without_drag_both_flanks_are_struck_alike():
    m = motion([[6.0, 0, 2.0]], [2.0, 4.0, 6.0], 90.0)  # x''(ε + half a period) = −x''(ε)
    of, strikes = flown(m, train(drag=[[0.0]], backlash=[60e-6]))
    assert np.isinf(of.separation).all() and of.parts.all()
    u = strikes.speed[0, 0][strikes.speed[0, 0] > 0]
    assert len(u) == 2 and u[0] == pytest.approx(u[1], rel=1e-6)
    assert set(strikes.flank[0, 0][:2]) == {1, -1}


def test_mass_and_drag_together_change_no_motion():
    m, bodies = random_lanes(30)
    more = replace(bodies, mass=bodies.mass * 7, drag=bodies.drag * 7)
    (of, strikes), (of_7, strikes_7) = flown(m, bodies), flown(m, more)
    assert of_7.separation == pytest.approx(of.separation, rel=1e-12)
    assert strikes_7.speed == pytest.approx(strikes.speed, rel=1e-9, abs=1e-12)
    assert strikes_7.power == pytest.approx(7 * strikes.power, rel=1e-9)


def test_speed_of_the_crank_scales():
    """The same irregularity at twice the speed: four times x'', drag too, twice u."""
    m, bodies = random_lanes(30)
    fast = Motion(m.orders, 4 * m.a, 2 * m.omega, m.cycle)
    (of, strikes), (of_2, strikes_2) = flown(m, bodies), flown(fast, replace(bodies, drag=4 * bodies.drag))
    assert of_2.least == pytest.approx(4 * of.least, rel=1e-12)
    assert strikes_2.speed == pytest.approx(2 * strikes.speed, rel=1e-9, abs=1e-12)
    assert strikes_2.orbit == pytest.approx(strikes.orbit / 2, rel=1e-9)


def test_behind_another_radius():
    """A wheel by which a body drives, ρ times as large: as one body on ρ·x₀'' with the backlash ρ·j_1 + j_2."""
    m, rho = motion([[9.0, 2j]], [2.0, 4.0], 85.0), 1.3
    behind = train((-1, 0), [0.4, 1.1], [[0.5, 2.0]], [50e-6, 80e-6], rho=[1.0, rho])
    of, strikes = flown(m, behind)
    assert of.mass == pytest.approx([0.4 + rho**2 * 1.1, 1.1]) and of.drag[0] == pytest.approx([0.5 + rho * 2.0, 2.0])
    _, alone = flown(
        motion(rho * m.a, m.orders, m.omega), train(mass=[1.1], drag=[[2.0]], backlash=[rho * 50e-6 + 80e-6])
    )
    assert strikes.speed[0, 1] == pytest.approx(alone.speed[0, 0], rel=1e-12)
    assert strikes.press[0, 1] == pytest.approx(alone.press[0, 0], rel=1e-12)
    assert strikes.power[0, 1] == pytest.approx(alone.power[0, 0], rel=1e-12)


def test_order_of_the_meshes_does_not_matter():
    m = motion([[9.0, 2j]], [2.0, 4.0], 85.0)
    one = train((-1, 0, 0), [0.4, 1.1, 2.0], [[0.5, 2.0, 1.0]], [50e-6, 80e-6, 60e-6], rho=[1.0, 1.3, 0.8])
    other = train((-1, 0, 0), [0.4, 2.0, 1.1], [[0.5, 1.0, 2.0]], [50e-6, 60e-6, 80e-6], rho=[1.0, 0.8, 1.3])
    found, turned = (impacts(m, b, *flown(m, b)) for b in (one, other))
    for name in ("speed", "impacts", "flanks", "power", "low", "high", "share"):
        assert getattr(found, name)[0, [0, 2, 1]] == pytest.approx(getattr(turned, name)[0], rel=1e-12), name


@pytest.mark.parametrize("jammed", [0.0, -20e-6, math.nan])
def test_a_mesh_without_backlash_strikes_nothing(jammed):
    m = motion([[12.0]])
    bodies = train((-1, 0), [1.0, 1.0], [[1.0, 1.0]], [jammed, 70e-6])
    of, strikes = flown(m, bodies)
    assert of.parts.all()
    assert strikes.hardest[0, 0] == 0 < strikes.hardest[0, 1]
    assert strikes.backlash[0] == pytest.approx([0.0, 70e-6])
    all_jammed = replace(bodies, backlash=np.array([jammed, jammed]))
    found = impacts(m, all_jammed, *flown(m, all_jammed))
    assert not found.speed.any() and not found.high.any() and not found.power.any()


def test_held_meshes_and_chains_never_part():
    m = motion([[12.0], [12.0]])
    bodies = train((-1, 0), [1.0, 1.0], np.ones((2, 2)), [60e-6, 70e-6])
    sprung = replace(bodies, sprung=np.array([[False, False], [True, False]]))
    of, strikes = flown(m, sprung)
    assert of.parts.tolist() == [[True, True], [False, True]]
    assert (of.separation[0] == of.separation[1]).all()
    assert strikes.backlash[:, 1] == pytest.approx([130e-6, 70e-6])
    chain = replace(bodies, toothed=(False, True), stiffness=np.array([0.0, 16e9]), width=np.array([0.0, 12e-3]))
    of, strikes = flown(m, chain)
    assert of.parts.tolist() == [[False, True]] * 2
    assert strikes.backlash[:, 1] == pytest.approx([70e-6] * 2)
    found = impacts(m, chain, of, strikes)
    assert not found.high[:, 0].any() and not found.low[:, 0].any() and (found.high[:, 1] > 0).all()


def test_gravity_turns_a_shaft_as_motion_of_its_order_would():
    """G·cos ε takes G/M from x'': one body, a motion that has the order of its unbalance anyway."""
    M, D, G = 1.2, 4.0, 3.0 - 2.0j
    orders = [0.5, 1.0, 2.0]
    plain = train(mass=[M], drag=[[D]], backlash=[90e-6])
    under = replace(plain, gravity=np.array([[G]]), gravity_order=np.array([1.0]))
    m, less = motion([[1.0, 3.0, 6j]], orders), motion([[1.0, 3.0 - G / M, 6j]], orders)
    (of, strikes), (of_less, strikes_less) = flown(m, under), flown(less, plain)
    assert of.least == pytest.approx(of_less.least, rel=1e-12) and of.most == pytest.approx(of_less.most, rel=1e-12)
    assert of.separation != pytest.approx(of_less.separation, rel=1e-3)
    assert strikes.speed == pytest.approx(strikes_less.speed, rel=1e-9) and strikes.hardest.max() > 0
    assert course(m, under, 0, 0)[1] == pytest.approx(course(less, plain, 0, 0)[1], abs=1e-12)


def test_gravity_of_the_firing_order_keeps_the_orbit_short():
    """An inline-4 with shafts at twice its speed: one strike on each flank a firing, as without gravity."""
    plain = train(mass=[1.2], drag=[[4.0]], backlash=[90e-6])
    under = replace(plain, gravity=np.array([[3.0 + 0j]]), gravity_order=np.array([2.0]))
    m = motion([[12.0, 3j]], [2.0, 4.0])
    less = motion([[12.0 - 3.0 / 1.2, 3j]], [2.0, 4.0])
    _, strikes = flown(m, under)
    assert strikes.closes.all() and strikes.orbit[0, 0] == pytest.approx(math.pi / 80.0)
    assert strikes.speed == pytest.approx(flown(less, plain)[1].speed, rel=1e-9)
    by_once = replace(under, gravity_order=np.array([1.0]))
    assert flown(m, by_once)[1].orbit[0, 0] == pytest.approx(2 * math.pi / 80.0)


def test_no_motion_and_no_flight():
    """An even crank; gravity alone parts the flanks where it is more than the drag, without a warning."""
    still, plain = motion([[0.0], [0.0]]), train(drag=[[1.0], [4.0]])
    under = replace(plain, gravity=np.array([[2.0 + 0j], [2.0]]), gravity_order=np.array([1.0]))
    for bodies, parts in ((plain, [False, False]), (under, [True, False])):
        of, strikes = flown(still, bodies)
        assert of.parts[:, 0].tolist() == parts and (strikes.hardest[:, 0] > 0).tolist() == parts
        assert not of.separation.any() and not strikes.share.any()
        found = impacts(still, bodies, of, strikes)
        assert (found.high[:, 0] > 0).tolist() == parts
        assert quiet_backlash(still, bodies, 0, 35e-3) is None
    weightless = replace(plain, gravity=np.zeros((2, 1), complex), gravity_order=np.array([0.0]))
    m = motion([[12.0], [9.0]])
    assert flown(m, weightless)[1].speed == pytest.approx(flown(m, plain)[1].speed, rel=1e-6, abs=1e-12)


def test_some_of_the_points():
    m, bodies = random_lanes(9)
    of, strikes = flown(m, bodies)
    of_2, strikes_2 = flown(m.at([4, 2]), bodies.at([4, 2]))
    assert (of_2.least == of.at([4, 2]).least).all()
    assert strikes_2.hardest == pytest.approx(strikes.at([4, 2]).hardest, rel=1e-12)


# --- the backlash that is still quiet, one lane in detail


@pytest.mark.parametrize("limit", [20e-3, 35e-3, 70e-3])
def test_quiet_backlash_is_where_the_speed_reaches_the_limit(limit):
    m, bodies = lane(given_of("R753 idle"))
    J = quiet_backlash(m, bodies, 2, limit)

    def at(J):
        return flown(m, replace(bodies, backlash=np.array([math.nan, math.nan, J])))[1].hardest[0, 2]

    assert at(J * (1 + 1e-5)) >= limit > at(J * (1 - 1e-5))
    assert quiet_backlash(m, bodies, 2, 10.0) is None
    assert quiet_backlash(m, replace(bodies, drag=bodies.drag * 20), 2, limit) is None


def test_course_of_one_lane():
    m, bodies = lane(given_of("R753 idle"))
    epsilon, y, F = course(m, bodies, 0, 2)
    of, strikes = flown(m, bodies)
    J = strikes.backlash[0, 2]
    assert epsilon[0] == 0 and epsilon[-1] < 4 * math.pi and len(epsilon) == len(y) == len(F) == 720
    assert y.max() == 0 and y.min() == pytest.approx(-J)
    flies = (y < 0) & (y > -J)
    assert not F[flies].any() and (F[y == 0] >= 0).all() and (F[y == -J] <= 0).all()
    p = m.over(epsilon)[0] + of.drag[0, 2] / of.mass[2]
    assert F[~flies] == pytest.approx((of.mass[2] * p)[~flies], rel=1e-9) and 100 < F.max() < of.most[0, 2]
    for e in range(2):  # between the nodes of letting go and strike it is in the air
        span = (strikes.let_go[0, 2, e] < epsilon) & (epsilon < strikes.struck[0, 2, e])
        assert span.sum() > 5 and flies[span].all()
    assert np.abs(np.diff(y)).max() < J / 3
    still = replace(bodies, drag=bodies.drag * 20)
    epsilon, y, F = course(m, still, 0, 2)
    assert not y.any() and F.min() == pytest.approx(closed(m, still).least[0, 2], rel=1e-3)
