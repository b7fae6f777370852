# SPDX-License-Identifier: Apache-2.0
"""Friction over a turn under a turning and a standing load, against the load of every moment gone through one by
one."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest

from calc.bearings.plain import loads as rotating_load
from calc.bearings.plain.routes.thermal_balance import settled


@dataclass
class Duty:
    load: object
    speed: object


STEPS = 720
PLACES = ("front", "rear")


def bearing(results, place):
    return results.outcomes["bearings"].result.bearings[place]


def answer(one):
    return rotating_load.response(one.seat, one.duty, one.friction_power)


def mean_over_a_turn(one, share):
    """The own solution at the load of 720 moments; `share`: the standing load over the turning one."""
    theta = np.arange(STEPS) * 2 * math.pi / STEPS
    loads = one.duty.load * np.abs(1 + share * np.exp(1j * theta))
    return float(np.mean(settled(one.seat, replace(one.duty, load=loads)).friction_power))


def errors(one, shares):
    found = answer(one)
    return [found.power(share * found.load) - mean_over_a_turn(one, share) for share in shares]


# --- the formula, where the answer is known
@pytest.mark.parametrize("share", [0.0, 0.1, 0.4])
def test_friction_by_the_square_of_the_load_is_exact(share):
    """The mean of |F + R_0·e^iθ|² is F² + R_0²."""
    F, R_0 = 1000.0, 1000.0 * share
    P = {k: (k * F) ** 2 for k in (0.95, 1.0, 1.05)}
    S = rotating_load.slope(P_below=P[0.95], P_above=P[1.05], F=F)
    K = rotating_load.curvature(P_below=P[0.95], P_f=P[1.0], P_above=P[1.05], F=F)
    assert S == pytest.approx(2 * F) and K == pytest.approx(2 * F)
    assert rotating_load.over_a_turn(P=P[1.0], R_0=R_0, F=F, S=S, K=K) == pytest.approx(F**2 + R_0**2)


def test_friction_by_the_load_itself_grows_by_a_quarter_of_the_square():
    """The mean of |1 + s·e^iθ| is 1 + s²/4 + s⁴/64 + …"""
    found = rotating_load.over_a_turn(P=1.0, R_0=0.2, F=1.0, S=1.0, K=0.0)
    theta = np.arange(STEPS) * 2 * math.pi / STEPS
    exact = float(np.mean(np.abs(1 + 0.2 * np.exp(1j * theta))))
    assert found == pytest.approx(1 + 0.2**2 / 4)
    assert exact - found == pytest.approx(0.2**4 / 64, rel=0.02)


def test_the_loads_beside_are_a_twentieth_apart():
    seat, duties = rotating_load.loads_beside(None, Duty(load=np.array([1000.0, 2000.0]), speed=np.array([40.0, 50.0])))
    assert duties.load == pytest.approx(np.array([[950.0, 1000.0, 1050.0], [1900.0, 2000.0, 2100.0]]))
    assert duties.speed.shape == (2, 1) and seat is None
    duties = rotating_load.loads_beside(None, Duty(load=1000.0, speed=40.0))[1]
    assert duties.load == pytest.approx([950.0, 1000.0, 1050.0]) and duties.speed == 40.0


# --- a journal
@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("share, tolerance", [(0.05, 2e-7), (0.2, 2e-5), (0.4, 3e-4)])
def test_the_mean_is_that_of_720_moments(gamma_results, place, share, tolerance):
    one = bearing(gamma_results, place)
    (error,) = errors(one, [share])
    assert abs(error) < tolerance * one.friction_power
    more = mean_over_a_turn(one, share) - one.friction_power
    assert more > 0
    assert abs(error) < 0.03 * more


@pytest.mark.parametrize("place", PLACES)
def test_what_is_left_out_is_of_the_fourth_order(gamma_results, place):
    at_20, at_40 = errors(bearing(gamma_results, place), (0.2, 0.4))
    assert math.log2(at_40 / at_20) == pytest.approx(4, abs=0.3)


def test_nothing_standing_is_the_friction_of_the_turning_load(gamma_results):
    one = bearing(gamma_results, "front")
    assert answer(one).power(0.0) == one.friction_power
    assert rotating_load.response(one.seat, one.duty).power(0.0) == pytest.approx(one.friction_power, rel=1e-6)


def test_slope_and_curvature_are_those_of_the_own_solution(gamma_results):
    """Against steps of another size."""
    one = bearing(gamma_results, "rear")
    found, F, step = answer(one), one.duty.load, 0.03
    below, at, above = settled(one.seat, replace(one.duty, load=F * np.array([1 - step, 1, 1 + step]))).friction_power
    assert found.slope == pytest.approx((above - below) / (2 * step * F), rel=2e-3)
    assert found.curvature == pytest.approx((above - 2 * at + below) / (step**2 * F), rel=2e-2)


def test_many_duties_are_the_single_ones(gamma_results):
    one = bearing(gamma_results, "front")
    shares, T = np.array([0.5, 1.0, 1.3]), np.array([90.0, 110.0, 120.0])
    many = rotating_load.response(one.seat, replace(one.duty, load=one.duty.load * shares, supply_temperature=T))
    for i in range(3):
        alone = rotating_load.response(
            one.seat, replace(one.duty, load=one.duty.load * float(shares[i]), supply_temperature=float(T[i]))
        )
        assert many.friction_power[i] == pytest.approx(alone.friction_power, rel=1e-6)
        assert many.power(100.0)[i] == pytest.approx(alone.power(100.0), rel=1e-6)


def test_where_there_is_no_film_there_is_no_number(gamma_results):
    one = bearing(gamma_results, "front")
    assert math.isnan(rotating_load.response(one.seat, replace(one.duty, load=1e7)).friction_power)
