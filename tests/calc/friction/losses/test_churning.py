# SPDX-License-Identifier: Apache-2.0
"""Churning by Changenet and Velex: a wheel calculated by hand, its regimes and where they meet, how much of the wheel
is under oil."""

import math
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.friction.inputs import Dip
from calc.friction.losses import oil_and_air as c
from calc.friction.losses.wheels import unloaded
from calc.friction.mesh.geometry import MeshGeometry
from tests.calc.friction.pairs import closed, friction, lubricant, shown, wheel

# m 3 mm, 60 teeth, 20 mm wide, α 20°, spur; 3 L of 30 mm²/s and 870 kg/m³
M, Z, B, R, VOLUME, NU, RHO = 3e-3, 60, 20e-3, 90e-3, 3e-3, 30e-6, 870.0
ALPHA = math.radians(20)


def churned(rpm=1500.0, h=45e-3, nu=NU, b=B, volume=VOLUME):
    """Every quantity of the way, by the formulas of the program."""
    omega = rpm * math.pi / 30
    theta = c.wetted_angle(h=h, r=R)
    S_m = c.wetted_surface(r=R, theta=theta, b=b, z=Z, m_n=M, alpha_t=ALPHA, beta=0.0)
    Re, Fr = c.reynolds(omega=omega, r=R, b=b, nu=nu), c.froude(omega=omega, r=R)
    gamma = c.centrifugal(omega=omega, r=R, b=b, m_n=M)
    said = dict(h=h, r=R, V=volume, Fr=Fr, Re_c=Re, b=b)
    C_m1, C_m2 = c.calm(**said), c.wild(**said)
    C_m = c.torque_number(C_m1=C_m1, C_m2=C_m2, gamma=gamma)
    P = c.churning(T_C=c.churning_torque(rho=RHO, omega=omega, r=R, S_m=S_m, C_m=C_m), omega=omega)
    return dict(S_m=S_m, Re=Re, Fr=Fr, gamma=gamma, C_m1=C_m1, C_m2=C_m2, C_m=C_m, P=P)


def test_a_wheel_by_hand():
    """Calculated by hand from the published equations: half of the wheel under oil at 1500 rpm."""
    found = churned()
    assert found["S_m"] == pytest.approx(0.0194663, abs=5e-8)
    assert found["Re"] == pytest.approx(9425, abs=0.5)
    assert found["Fr"] == pytest.approx(226.4, abs=0.05)
    assert found["gamma"] == pytest.approx(432.9, abs=0.1)
    assert found["C_m"] == found["C_m1"] == pytest.approx(0.0033771, abs=5e-8)
    assert found["C_m2"] == pytest.approx(0.0052369, abs=5e-8)
    assert found["P"] == pytest.approx(80.8, abs=0.05)


def test_the_wetted_surface_is_two_segments_an_arc_and_flanks():
    """Of a wheel that is all under oil: two discs, the rim, 2·z flanks of 2.25·m/cos α."""
    theta = c.wetted_angle(h=2 * R, r=R)
    whole = 2 * math.pi * R**2 + 2 * math.pi * R * B + 2 * Z * 2.25 * M * B / math.cos(ALPHA)
    assert c.wetted_surface(r=R, theta=theta, b=B, z=Z, m_n=M, alpha_t=ALPHA, beta=0.0) == pytest.approx(whole)
    half = c.wetted_surface(r=R, theta=c.wetted_angle(h=R, r=R), b=B, z=Z, m_n=M, alpha_t=ALPHA, beta=0.0)
    assert half == pytest.approx(whole / 2)


@pytest.mark.parametrize(
    "which, Re", [("C_m1", (1.366 / 0.239) ** (1 / 0.21)), ("C_m2", (20.797 / 3.644) ** (1 / 0.21))]
)
def test_the_regimes_meet_at_a_reynolds_number_of_4000(which, Re):
    """By their own constants; below the power −0.21, above nothing."""
    assert Re == pytest.approx(4000, rel=1e-2)
    below, at, above, far = (churned(nu=NU * 9424.78 / Re / x)[which] for x in (1 - 1e-6, 1.0, 1 + 1e-6, 10.0))
    assert below == pytest.approx(at, rel=1e-5) and above == pytest.approx(at, rel=1e-5)
    assert far == pytest.approx(at, rel=1e-4)
    assert churned(nu=NU * 9424.78 / Re * 2)[which] == pytest.approx(at * 2**0.21, rel=1e-4)


@pytest.mark.parametrize(
    "gamma, share", [(0.0, 0), (749.9, 0), (750.0, 0), (875.0, 0.25), (1000.0, 0.5), (1250.0, 1), (1e4, 1)]
)
def test_between_calm_and_wild_the_number_is_a_straight_line(gamma, share):
    assert c.torque_number(C_m1=1.0, C_m2=3.0, gamma=gamma) == pytest.approx(1 + 2 * share)


def test_the_loss_has_no_jump_over_the_speed():
    rpm = [100 * 1.002**i for i in range(1700)]
    P = [churned(rpm=n)["P"] for n in rpm]
    assert churned(rpm=rpm[0])["gamma"] < 750 and churned(rpm=rpm[-1])["gamma"] > 1250
    assert all(abs(math.log(b / a)) < 0.02 for a, b in pairwise(P))


def test_the_constants_of_the_first_pair_are_one_law_in_two_forms():
    """Re_c^−0.21·(b/R)^0.21 is (Ω·R²/ν)^−0.21: the width falls out below Re 4000 and γ 750."""
    narrow, wide = (churned(rpm=300.0, nu=200e-6, b=b) for b in (10e-3, 20e-3))
    assert max(narrow["Re"], wide["Re"]) < 4000
    assert narrow["C_m1"] == pytest.approx(wide["C_m1"])


# --- how deep
@pytest.mark.parametrize("tip, h", [(1.0, 0.0), (3.0, 0.0), (48.0, 45.0), (183.0, 180.0), (500.0, 180.0)])
def test_the_depth_counts_at_the_reference_circle(tip, h):
    """The tips are 3 mm beyond; no deeper than the whole wheel."""
    assert c.depth_of_reference_circle(h_t=tip * 1e-3, r_a=93e-3, r=R) == pytest.approx(h * 1e-3)


def pair():
    """The wheel by hand drives one of the same size."""
    one, two = (wheel(name, Z, M, ALPHA, 93e-3, B) for name in ("one", "two"))
    return {"one_two": MeshGeometry(one, two, 180e-3, 0.0)}


def test_the_program_takes_the_wheel_s_own_numbers():
    """With the oil where it has 30 mm²/s, and its density there."""
    oil = lubricant()
    low, high = 40.0, 120.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if oil.at(middle).nu > NU else (low, middle)
    said = friction(dips=(Dip(name="one", depth=48e-3, oil_volume=VOLUME),))
    found = unloaded(said, pair(), oil, low, 25.0, "two")
    assert found["one"].churning == pytest.approx(churned()["P"] * oil.at(low).rho / RHO, rel=1e-9)
    assert found["two"].churning is None


def test_tips_in_the_oil_cost_nothing_and_no_dip_is_none():
    said = friction(dips=(Dip(name="one", depth=3e-3, oil_volume=VOLUME),))
    assert unloaded(said, pair(), lubricant(), 80.0, 25.0, "two")["one"].churning == 0.0
    assert unloaded(friction(), pair(), lubricant(), 80.0, 25.0, "two")["one"].churning is None
    assert "churning_loss" not in shown(closed())


@settings(max_examples=60, deadline=None)
@given(
    rpm=st.floats(1e-3, 2e4),
    depth=st.floats(1e-6, 1.0),
    nu=st.floats(1e-6, 0.05),
    volume=st.floats(1e-5, 1.0),
    b=st.floats(1e-3, 0.2),
)
def test_churning_is_finite_and_no_gain(rpm, depth, nu, volume, b):
    h = c.depth_of_reference_circle(h_t=depth, r_a=93e-3, r=R)
    P = churned(rpm, h, nu, b, volume)["P"]
    assert math.isfinite(P) and P >= 0
    assert P < 1e-30 if h == 0 else P > 0
