# SPDX-License-Identifier: Apache-2.0
"""The fixed point of the balance where bearings of the wheels follow from the power that it is looking for."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.friction.inputs import OtherLoss, PlainBearing, RollingBearing
from calc.friction.losses import bearings as plain_bearings
from calc.friction.losses import bearings as rolling_bearings
from calc.friction.power_balance import drive, losses_of
from calc.sheet.errors import NoSolution
from tests.calc.friction.pairs import (
    CRANK_SPEED,
    SHAFT_POWER,
    closed,
    ends,
    friction,
    lubricant,
    r753,
    shown,
    spur_pair,
)

BUSH = PlainBearing(name="idler", diameter=0.025, length=0.02, clearance=40e-6)
# f_1 so large that the load counts
ROLLERS = RollingBearing(name="central", bore=0.02, outside_diameter=0.042, f_1=0.002)
BEARINGS = dict(plain_bearings=(BUSH,), rolling_bearings=(ROLLERS,))
ONLY = {"pinion_gear": spur_pair()}


def check(values, meshes):
    """Every mesh takes in what it was loaded with, every bearing carries the teeth of that power."""
    oil = lubricant().at(120.0)
    forces = {}
    for key, m in meshes.items():
        F_bt = values[f"{key}.power_in"] / (2 * math.pi * values[f"{m.driver.name}.speed"] / 60 * m.driver.base_radius)
        for name in (m.driver.name, m.driven.name):
            forces[name] = forces.get(name, 0.0) + F_bt
    for entry, power, nu in (
        (BUSH, plain_bearings.plain_bearing_power, oil.mu),
        (ROLLERS, rolling_bearings.power, oil.nu),
    ):
        F = values[f"{entry.name}.bearing_force"]
        assert F == pytest.approx(forces[entry.name], rel=1e-9)
        assert values[f"{entry.name}.bearing_loss"] == pytest.approx(
            power(entry, F, values[f"{entry.name}.speed"] / 60, nu), rel=1e-9
        )


@pytest.mark.parametrize("film", ["judged", "source"])
@pytest.mark.parametrize("P", [5.0, SHAFT_POWER, 5000.0])
def test_it_closes_upstream(P, film):
    found = closed(shaft_power=P, film=film, **BEARINGS)
    values = shown(found)
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)
    for key, mesh in found.result.meshes.items():
        assert mesh.judged.load == pytest.approx(mesh.power_in, rel=1e-9), key
    check(values, r753())


@pytest.mark.parametrize("film", ["judged", "source"])
@pytest.mark.parametrize("P", [100.0, 1000.0, 20000.0])
def test_it_closes_downstream(P, film):
    found = closed(shaft_power=None, power=P, film=film, **BEARINGS)
    values = shown(found)
    assert values["crank_power"] == pytest.approx(values["total_loss"] + values["delivered_power"], rel=1e-9)
    assert values["crank_central.power_in"] == P
    check(values, r753())


def test_up_and_down_are_one_balance():
    up = shown(closed(**BEARINGS))
    down = shown(closed(shaft_power=None, power=up["crank_central.power_in"], **BEARINGS))
    assert down["delivered_power"] == pytest.approx(SHAFT_POWER, rel=1e-8)
    for name in ("wheel_bearing_loss", "idler.bearing_force", "central.bearing_loss", "mesh_loss"):
        assert down[name] == pytest.approx(up[name], rel=1e-8), name


def test_bearings_that_follow_the_power_cost_more_than_themselves():
    """The meshes before them carry what they lose."""
    without, with_them = shown(closed()), shown(closed(**BEARINGS))
    assert with_them["crank_power"] > without["crank_power"] + with_them["wheel_bearing_loss"]


def test_the_power_is_the_root_of_the_balance():
    """Found once more by halving: P = P_out + loss(P) + bearings(P), for one mesh whose driven wheel has a bearing."""
    said = friction(rolling_bearings=(RollingBearing(name="gear", bore=0.02, outside_diameter=0.042, f_1=0.01),))
    d = drive(said, ONLY, lubricant(), 60.0, 25.0, ends(500.0, ONLY))

    def excess(P):
        bearing = d.bearings({"pinion_gear": P})["gear"][1]
        return P - d.loss("pinion_gear", P) - sum(d.wheels["gear"].parts()) - bearing - 500.0

    low, high = 500.0, 5000.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    found = closed(shaft_power=500.0, T=60.0, speed=25.0, meshes=ONLY, rolling_bearings=said.rolling_bearings)
    assert shown(found)["pinion_gear.power_in"] == pytest.approx(low, rel=1e-9)


def test_many_operating_points_are_the_single_ones():
    n, T, P = np.array([20.0, CRANK_SPEED, 80.0]), np.array([60.0, 120.0, 100.0]), np.array([50.0, SHAFT_POWER, 900.0])
    said = friction(**BEARINGS)
    many = losses_of(drive(said, r753(), lubricant(), T, n, ends(P, r753())))
    below = losses_of(drive(said, r753(), lubricant(), T, n), P)
    for i in range(3):
        at = drive(said, r753(), lubricant(), float(T[i]), float(n[i]), ends(float(P[i]), r753()))
        alone = losses_of(at)
        assert (many.mesh[i], many.wheels[i], many.total[i]) == pytest.approx(
            (alone.mesh, alone.wheels, alone.total), rel=1e-8
        )
        alone = losses_of(drive(said, r753(), lubricant(), float(T[i]), float(n[i])), float(P[i]))
        assert (below.mesh[i], below.wheels[i]) == pytest.approx((alone.mesh, alone.wheels), rel=1e-8)


def test_the_quick_sum_is_the_traced_balance():
    found = closed(**BEARINGS)
    quick = losses_of(drive(friction(**BEARINGS), r753(), lubricant(), 120.0, CRANK_SPEED, ends(SHAFT_POWER, r753())))
    assert quick.total == pytest.approx(found.result.total_loss, rel=1e-9)
    assert quick.mesh == pytest.approx(found.result.mesh_loss, rel=1e-9)


def test_a_bearing_that_eats_the_power_is_no_solution():
    with pytest.raises(NoSolution, match=r"mesh idler–shaft: power; .* come in.*gears\.power_kW"):
        closed(
            shaft_power=None,
            power=100.0,
            rolling_bearings=(RollingBearing(name="idler", bore=0.05, outside_diameter=0.2, f_0=50.0),),
        )


@settings(max_examples=20, deadline=None)
@given(
    P=st.floats(1.0, 1e4),
    speed=st.floats(5.0, 100.0),
    T=st.floats(20.0, 140.0),
    f_1=st.floats(0.0, 0.02),
    pump=st.floats(0, 100),
)
def test_any_sensible_train_closes_with_bearings(P, speed, T, f_1, pump):
    bearings = (RollingBearing(name="idler", bore=0.02, outside_diameter=0.042, f_1=f_1),)
    found = closed(
        shaft_power=P,
        speed=speed,
        T=T,
        rolling_bearings=bearings,
        other_losses=(OtherLoss(name="central pump", power=pump),),
    )
    values = shown(found)
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)
    for mesh in found.result.meshes.values():
        assert mesh.judged.load == pytest.approx(mesh.power_in, rel=1e-3)  # a regime may jump inside; see `upstream`
        assert mesh.judged.loss > 0 and mesh.judged.efficiency < 1
