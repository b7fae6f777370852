# SPDX-License-Identifier: Apache-2.0
"""What half-moon sectors lose in mist, between what and what; and in oil at most."""

import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.friction.losses import turning_masses as t
from calc.friction.losses.oil_and_air import AIR_VISCOSITY
from tests.conftest import ROOT

GIVEN = json.loads((ROOT / "tests" / "data" / "shafts.json").read_text(encoding="utf-8"))
LOSSES, DIPS = (GIVEN["parameters"][key] for key in ("mass_loss", "dip"))


def values(name):
    found = [given for given in GIVEN["given"] if given["case"] == name]
    assert found
    return found


def lost(b, R, r_0, rpm, rho, mu=1.8e-5, shell_gap=None):
    return t.sectors_loss(b, R, r_0, rpm * math.pi / 30, rho, mu, shell_gap)


def friction_of(Re):
    return t.skin_friction(Re=np.array([Re])).item()


@pytest.mark.parametrize("name", LOSSES)
def test_the_given_losses(name):
    case = LOSSES[name]
    b, R, r_0 = (case[key] * 1e-3 for key in ("length_mm", "outer_radius_mm", "core_radius_mm"))
    gap = case["shell_gap_mm"]
    found = lost(
        b, R, r_0, case["speed_rpm"], case["density_kgm3"], case["viscosity_Pas"], None if gap is None else gap * 1e-3
    )
    for said in values(name):
        assert getattr(found, said["value"]) == pytest.approx(said["is"], rel=said["rel"]), said["value"]


@pytest.mark.parametrize("name", DIPS)
def test_the_given_dip(name):
    case = DIPS[name]
    R, (said,) = case["outer_radius_mm"] * 1e-3, values(name)
    found = t.dip_loss_most(
        np.array([case["length_mm"] * 1e-3]),
        np.array([R]),
        case["speed_rpm"] * math.pi / 30,
        case["oil_density_kgm3"],
        oil_level=0.1 - R + case["depth_mm"] * 1e-3,
        up=0.1,
    )
    assert found == pytest.approx(said["is"], rel=said["rel"])


@given(st.floats(2000.1, 1e8))
def test_the_skin_friction_solves_its_equation(Re):
    C = friction_of(Re)
    assert 1 / math.sqrt(C) == pytest.approx(2.04 + 1.768 * math.log(Re * math.sqrt(C)), rel=1e-12)


@given(st.floats(1e-3, 2000.0))
def test_a_laminar_film_is_sheared(Re):
    """2/Re: the torque of a thin film, 2π·μ·ω·R³·b/t."""
    mu, omega, R, b, gap = 1.8e-5, 300.0, 0.02, 0.1, 2e-4
    rho = Re * mu / (omega * R * gap)
    found = t.cylinder_loss(C_Z=friction_of(Re), rho=rho, omega=omega, R=R, b=b)
    assert found == pytest.approx(2 * math.pi * mu * omega**2 * R**3 * b / gap, rel=1e-12)


def test_between_the_laws_the_low_end_is_low():
    """Where the laminar law ends the turbulent one gives eight times as much."""
    assert friction_of(2000.001) / friction_of(2000.0) == pytest.approx(8, abs=0.5)


def test_the_plate_is_the_sum_of_its_strips():
    rho, omega, b, R, r_0 = 24.0, 1200.0, 0.15, 0.022, 0.008
    edges = np.linspace(r_0, R, 100_001)
    r, dr = (edges[1:] + edges[:-1]) / 2, edges[1] - edges[0]
    drag = 1.2 * rho / 2 * (omega * r) ** 2 * b * dr
    assert t.plate_loss(rho=rho, omega=omega, b=b, R=R, r_0=r_0) == pytest.approx((drag * omega * r).sum(), rel=1e-8)


SIZES = st.lists(st.tuples(st.floats(0.01, 0.2), st.floats(0.012, 0.06), st.floats(0.0, 0.95)), min_size=1, max_size=4)


@settings(deadline=None)
@given(SIZES, st.floats(500, 15000), st.floats(1.0, 40.0), st.sampled_from([None, 5e-4, 2e-3]))
def test_each_sector_adds_its_own_and_what_is_counted_lies_between(sizes, rpm, rho, gap):
    b, R, r_0 = np.array([(b, R, R * share) for b, R, share in sizes]).T
    found = lost(b, R, r_0, rpm, rho, shell_gap=gap)
    each = [lost(x, y, z, rpm, rho, shell_gap=gap) for x, y, z in zip(b, R, r_0)]
    for name in ("mass_loss_low", "mass_loss_high"):
        assert getattr(found, name) == pytest.approx(sum(getattr(one, name) for one in each), rel=1e-12)
    assert 0 < found.mass_loss_low <= found.mass_loss <= found.mass_loss_high
    if gap is None:
        assert found.mass_loss**2 == pytest.approx(found.mass_loss_low * found.mass_loss_high, rel=1e-12)
    else:
        assert found.mass_loss == found.mass_loss_low
        assert found.mass_loss_high - found.mass_loss_low == pytest.approx(
            lost(b, R, r_0, rpm, rho).mass_loss_high - lost(b, R, r_0, rpm, rho).mass_loss_low, rel=1e-9
        )


@settings(deadline=None)
@given(SIZES, st.floats(0.3, 3.0), st.floats(0.3, 3.0))
def test_flows_of_one_reynolds_number_are_alike(sizes, x, speed):
    """Lengths times x, speeds so that Re stays: powers go with ρ·ω³·l⁵."""
    b, R, r_0 = np.array([(b, R, R * share) for b, R, share in sizes]).T
    one = lost(b, R, r_0, 6000, 24.0)
    like = lost(b * x, R * x, r_0 * x, 6000 * speed, 24.0 / (x**2 * speed))
    for name in ("mass_loss_low", "mass_loss_high", "mass_loss"):
        assert getattr(like, name) == pytest.approx(getattr(one, name) * x**3 * speed**2, rel=1e-9)


def test_what_the_viscosity_of_the_mist_does_to_the_low_end():
    """The program's own air, 9 % thicker than that of the given values, moves the low end by 1.3 %."""
    case = dict(b=0.16, R=0.022, r_0=0.008, omega=400 * math.pi, rho=24.0)
    assert AIR_VISCOSITY / 1.8e-5 == pytest.approx(1.09, abs=5e-3)
    thicker = t.sectors_loss(**case).mass_loss_low / t.mass_loss(mu=1.8e-5, **case).mass_loss_low
    assert thicker == pytest.approx(1.013, abs=5e-4)


@settings(deadline=None)
@given(st.floats(-0.05, 0.1), st.floats(0.01, 0.04))
def test_the_part_of_the_circle_that_is_under_oil(level, R):
    """Against strips of the circle; nothing above the oil, the whole circle under it."""
    A = t.dipped_area(h=t.dip_depth(h_oil=level, up=0.02, R=R), R=R)
    edges = np.linspace(-R, R, 20_001)
    x = (edges[1:] + edges[:-1]) / 2
    strips = np.sum(np.where(0.02 + x < level, 2 * np.sqrt(R**2 - x**2), 0.0)) * (edges[1] - edges[0])
    assert A == pytest.approx(strips, abs=4e-4 * R**2)


def test_the_ends_of_dipping():
    """Sectors of two sizes at one level: the smaller one runs clear of it."""
    b, R = np.array([0.05, 0.07]), np.array([0.02, 0.03])
    both = t.dip_loss_most(b, R, 1000.0, 850.0, oil_level=-0.025, up=0.0)
    assert both == t.dip_loss_most(b[1:], R[1:], 1000.0, 850.0, oil_level=-0.025, up=0.0) > 0
    assert t.dip_loss_most(b, R, 1000.0, 850.0, oil_level=-0.03, up=0.0) == 0
    whole = 850 / 2 * (R * 1000) ** 2 * math.pi * R**2 * b * 1000 / (2 * math.pi)
    assert t.dip_loss_most(b, R, 1000.0, 850.0, oil_level=0.04, up=0.0) == pytest.approx(whole.sum(), rel=1e-12)
