# SPDX-License-Identifier: Apache-2.0
"""Oil thrown onto the teeth: momentum, and which way it helps."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.friction.inputs import Jet
from calc.friction.losses.oil_and_air import pitch_line_speed, thrown_oil
from tests.calc.friction.pairs import closed, r753, shown


def test_the_speed_of_the_reference_circle():
    assert pitch_line_speed(r=0.05, n=50.0) == pytest.approx(15.70796, abs=5e-6)


def test_the_momentum_by_hand():
    """2 L/min of 850 kg/m³, teeth at 20 m/s: along at 5 m/s, at rest, against at 5 m/s."""
    Q = 2e-3 / 60
    along, rest, against = (thrown_oil(rho=850.0, Q=Q, v_t=20.0, v_j=v) for v in (5.0, 0.0, -5.0))
    assert (along, rest, against) == pytest.approx((8.5, 11.33333, 14.16667), abs=5e-6)


def test_oil_as_fast_as_the_teeth_costs_nothing_and_faster_oil_drives():
    assert thrown_oil(rho=850.0, Q=1e-4, v_t=20.0, v_j=20.0) == 0.0
    assert thrown_oil(rho=850.0, Q=1e-4, v_t=20.0, v_j=30.0) < 0.0


@given(v_t=st.floats(0.01, 100), v_j=st.floats(-100, 100), Q=st.floats(1e-6, 1e-2))
def test_what_the_oil_gains_is_less_than_what_the_wheel_gives(v_t, v_j, Q):
    """The rest, half of ρ·Q·(v_t − v_j)², becomes heat where the oil meets the teeth."""
    gained = 850.0 * Q / 2 * (v_t**2 - v_j**2)
    heat = thrown_oil(rho=850.0, Q=Q, v_t=v_t, v_j=v_j) - gained
    assert heat == pytest.approx(850.0 * Q / 2 * (v_t - v_j) ** 2, rel=1e-6, abs=1e-9)


def test_several_jets_on_one_wheel_add_up_in_the_balance():
    jets = (Jet(name="idler", flow=1e-3 / 60, jet_speed=0.0), Jet(name="idler front", flow=2e-3 / 60, jet_speed=3.0))
    found = closed(jets=jets)
    values = shown(found)
    idler = r753()["idler_shaft"].driver
    v_t = 2 * math.pi * idler.reference_radius * values["idler.speed"] / 60
    rho = found.result.meshes["idler_shaft"].case.oil.lubricant.at(120.0).rho
    assert values["idler.thrown_oil"] == pytest.approx(rho * 1e-3 / 60 * (v_t**2 + 2 * v_t * (v_t - 3.0)))
    assert values["thrown_oil_loss"] == values["idler.thrown_oil"]
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)
