# SPDX-License-Identifier: Apache-2.0
"""Two flanks in contact: the formulas that the rating of the teeth and their friction share, and that both get the same
from them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.friction.mesh.path import motion, path
from calc.friction.solve import meshes_of
from calc.gears.rating.screening import load as screening_load
from calc.gears.rating.screening import micropitting, scuffing
from calc.gears.rating.screening.path import Path as ScreeningPath
from calc.library import contact as hertz
from calc.library import contact as line
from calc.library import contact as teeth
from calc.library.catalogue import materials
from tests.calc.gears.trains import mesh, r753, solved, train, wheel

STEEL = 206e9


# --- Hertz
def test_two_steel_rollers():
    """Calculated by hand: 206 GPa, ν 0.3, 100 N/mm on radii that make 10 mm."""
    E_r = hertz.reduced_modulus(nu_1=0.3, E_1=STEEL, nu_2=0.3, E_2=STEEL)
    assert E_r / 1e9 == pytest.approx(206 / 0.91, rel=1e-12)
    assert hertz.hertz_pressure(w=1e5, E_r=E_r, rho_n=10e-3) / 1e6 == pytest.approx(600.237, abs=1e-3)
    assert hertz.half_width(w=1e5, rho_n=10e-3, E_r=E_r) * 1e6 == pytest.approx(106.061, abs=1e-3)


@given(
    w=st.floats(1, 1e7),
    rho=st.floats(1e-4, 1),
    E_1=st.floats(1e9, 1e12),
    E_2=st.floats(1e9, 1e12),
    nu=st.floats(0, 0.5),
)
def test_the_pressure_over_the_width_is_the_load(w, rho, E_1, E_2, nu):
    """Half an ellipse: w = π/2·p_H·b_H; the mean pressure over 2·b_H too."""
    E_r = hertz.reduced_modulus(nu_1=nu, E_1=E_1, nu_2=nu, E_2=E_2)
    p_H, b_H = hertz.hertz_pressure(w=w, E_r=E_r, rho_n=rho), hertz.half_width(w=w, rho_n=rho, E_r=E_r)
    assert math.pi / 2 * p_H * b_H == pytest.approx(w)
    assert hertz.mean_pressure(p_H=p_H) * 2 * b_H == pytest.approx(w)
    assert E_r == pytest.approx(hertz.reduced_modulus(nu_1=nu, E_1=E_2, nu_2=nu, E_2=E_1))


def test_equal_bodies_have_the_modulus_of_one_over_its_contraction():
    assert hertz.reduced_modulus(nu_1=0.3, E_1=STEEL, nu_2=0.3, E_2=STEEL) == pytest.approx(STEEL / (1 - 0.3**2))
    rigid = hertz.reduced_modulus(nu_1=0.3, E_1=STEEL, nu_2=0.3, E_2=1e25)
    assert rigid == pytest.approx(2 * STEEL / (1 - 0.3**2))


# --- the line of action
def test_the_pitch_point_parts_the_line_by_the_teeth_and_rolls():
    rho_C = line.pitch_point(T=40e-3, z_1=20, z_2=60)
    rho_2 = line.driven_curvature(T=40e-3, rho_1=rho_C)
    assert (rho_C, rho_2) == (pytest.approx(10e-3), pytest.approx(30e-3))
    assert line.rolling_speed(n=30.0, rho=rho_C) == pytest.approx(line.rolling_speed(n=-10.0, rho=rho_2))
    assert line.relative_radius(rho_1=rho_C, rho_2=rho_2) == pytest.approx(7.5e-3)
    assert line.normal_relative_radius(rho_rel=7.5e-3, beta_b=math.radians(60)) == pytest.approx(15e-3)


def spur(x=(0.2, 0.1)):
    return train(
        [wheel("a", 24, x[0], face_width=0.015), wheel("b", 36, x[1], face_width=0.02)],
        [mesh("a", "b")],
        m_n=3.0,
        beta=0.0,
        b=15.0,
        tool=(1.25, 0.38),
        ball=None,
    )


TRAINS = {"spur": (spur(), "a_b"), "crank": (r753(), "central_idler"), "shaft": (r753(), "idler_shaft")}


@pytest.fixture(scope="module", params=TRAINS)
def both(request):
    """One mesh as the friction step and as the rating of the teeth have it."""
    gears, key = TRAINS[request.param]
    t = solved(gears)
    m = t.meshes[key]
    friction = meshes_of(t, materials())[key]
    return friction, path(friction), t, m, ScreeningPath(t.system, m, t.wheels[m.driver], t.wheels[m.driven], 7)


def test_both_have_the_same_points(both):
    _, ours, _, _, theirs = both
    assert [ours.C_A, ours.C_B, ours.C_C, ours.C_D, ours.C_E, ours.C_F] == pytest.approx(
        [theirs.A, theirs.B, theirs.C, theirs.D, theirs.E, theirs.T], rel=1e-9
    )
    assert (ours.epsilon_1, ours.epsilon_2) == pytest.approx((theirs.eps_1, theirs.eps_2), rel=1e-9)
    assert (ours.epsilon_alpha, ours.epsilon_beta) == pytest.approx((theirs.eps_alpha, theirs.eps_beta), rel=1e-9)


def test_both_have_the_same_curvature_and_speeds(both):
    friction, ours, t, m, theirs = both
    there = motion(friction, ours, abs(t.wheels[m.driver].speed))
    places = theirs.at(np.asarray(ours.x))
    assert there.R == pytest.approx(places.rho_n, rel=1e-9)
    assert there.u_1 == pytest.approx(places.v_1, rel=1e-9)
    assert there.u_2 == pytest.approx(places.v_2, rel=1e-9)
    assert there.V_s == pytest.approx(np.abs(places.v_1 - places.v_2), rel=1e-6, abs=1e-12)
    assert ours.at_pitch_point(there.u_e) == pytest.approx(theirs.v_C, rel=1e-12)


def test_both_press_the_same(both):
    """E_r of the two materials; p_H of the film's rating is that of Hertz on the line load along the contact line."""
    friction, ours, t, m, theirs = both
    steel = materials()
    one, two = (steel[t.wheels[name].material] for name in (m.driver, m.driven))
    E_r = motion(friction, ours, 1.0).E_r
    assert E_r == pytest.approx(
        hertz.reduced_modulus(nu_1=one.poisson, E_1=one.E, nu_2=two.poisson, E_2=two.E), rel=1e-12
    )
    beta_b = friction.base_helix_angle
    p = micropitting.hertz_pressure(E_r=E_r, w_t=150e3, X=0.7, rho_n=theirs.rho_nC, beta_b=beta_b)
    assert p == pytest.approx(
        hertz.hertz_pressure(w=150e3 * 0.7 / math.cos(beta_b), E_r=E_r, rho_n=theirs.rho_nC), rel=1e-12
    )


def test_the_rating_has_no_formula_of_its_own():
    assert scuffing.half_width is hertz.half_width
    assert screening_load.reduced_modulus is hertz.reduced_modulus
    assert screening_load.mean_roughness is teeth.mean_roughness
    assert screening_load.LUBRICANT_FACTOR is teeth.LUBRICANT_FACTOR
    assert micropitting.teeth is teeth
    shared = (
        "bulk_rise",
        "bulk_temperature",
        "ohlendorf_loss_factor",
        "mean_friction",
        "roughness_factor",
        "sum_of_speeds",
    )
    assert not [name for name in shared if hasattr(micropitting, name) or not hasattr(teeth, name)]


# --- loss and warmth of a whole mesh
def test_the_loss_factor_of_high_teeth_is_that_of_two_pairs_where_both_hold():
    """ε_1 = ε_2 = 1: (1 + 1 + 1 − 2) against half of 2."""
    said = dict(eps_alpha=2.0, z_1=24, z_2=36, beta_b=0.3)
    assert teeth.ohlendorf_loss_factor(eps_1=1.0, eps_2=1.0, **said) == pytest.approx(
        teeth.ohlendorf_loss_factor_high(**said)
    )


def test_the_loss_factor_is_the_other_form_of_ohlendorf():
    """π·(u + 1)/(z_1·u·cos β_b)·(1 − ε_α + ε_1² + ε_2²)."""
    u, z_1, e = 1.5, 24, (0.8, 0.7)
    other = math.pi * (u + 1) / (z_1 * u * math.cos(0.25)) * (1 - sum(e) + e[0] ** 2 + e[1] ** 2)
    assert teeth.ohlendorf_loss_factor(
        eps_1=e[0], eps_2=e[1], eps_alpha=sum(e), z_1=z_1, z_2=z_1 * u, beta_b=0.25
    ) == pytest.approx(other)


def test_the_warming_by_hand():
    """7400·(10 kW·0.05·0.15/(100·20))^0.72·1.2/(1.2·1) = 7400·(3.75e-5)^0.72."""
    said = dict(P=10e3, mu_m=0.05, H_v=0.15, a=0.1, b=0.02)
    rise = teeth.bulk_rise(X_S=1.2, X_Ca=1.0, **said)
    assert rise == pytest.approx(7400 * 3.75e-5**0.72, rel=1e-12)
    assert teeth.bulk_rise(X_S=0.2, X_Ca=2.0, **said) == pytest.approx(rise / 12)
    assert teeth.bulk_temperature(T_oil=90.0, Delta_T=rise) == pytest.approx(90 + rise)


def test_the_mean_friction_by_hand():
    """0.045·(200/(5·8))^0.2·20^−0.05·2.2·(0.5/8)^0.25 = 0.045·1.3797·0.8609·1.1."""
    X_R = teeth.roughness_factor(Ra=teeth.mean_roughness(Ra_1=0.4e-6, Ra_2=0.6e-6), rho_nC=8e-3)
    assert X_R == pytest.approx(1.1)
    v = teeth.sum_of_speeds(v_C=2.5)
    mu = teeth.mean_friction(w_t=200e3, K_Bgamma=1.0, v_SumC=v, rho_nC=8e-3, eta=0.02, X_R=X_R, X_L=1.0)
    assert mu == pytest.approx(0.0587960, abs=5e-8)
