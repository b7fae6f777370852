# SPDX-License-Identifier: Apache-2.0
"""Film and rolling: spot values, the four regimes, and the constants of the rigid film from its own Reynolds
equation."""

import math

import numpy as np
import pytest

from calc.friction.mesh import film as f
from calc.friction.mesh.loss import case, ehl_rolling_power, rigid_rolling_power, solve_mesh
from calc.friction.mesh.traction import rigid_fluid_friction
from tests.calc.friction.pairs import friction, lubricant, oil, r753, spur_pair

# 40 mPa·s, 10 m/s, 20 GPa⁻¹, 500 N/mm, 20 mm, 228 GPa
ETA, U_E, ALPHA, W_LINE, R, E_R = 0.04, 10.0, 2e-8, 5e5, 0.02, 2.28e11


def ehl(exponent=f.EXPONENT):
    U, G, W = f.speed_parameter(ETA, U_E, E_R, R), f.materials_parameter(ALPHA, E_R), f.load_parameter(W_LINE, E_R, R)
    return f.film_elastic_piezoviscous(G=G, e=exponent, U=U, W=W) * R


def test_dowson_toyoda():
    """Self-computed; no published number was found."""
    assert ehl() * 1e6 == pytest.approx(1.9611, abs=5e-5)


def test_the_printed_exponent_thins_the_film():
    assert ehl(f.ELLIPTICAL) / ehl() == pytest.approx((ALPHA * E_R) ** -0.03)


def test_thermal_reduction():
    """Self-computed: p_H/E_r = 1/230, L = 1, S = 0.2."""
    assert f.thermal_reduction(p_H=1.0, E_r=230.0, L=1.0, S=0.2) == pytest.approx(0.70455, abs=5e-6)


def test_the_thermal_reduction_is_held_at_5_percent():
    assert f.bounded_reduction(Phi_T=-2.0) == f.LEAST_FACTOR
    assert f.bounded_reduction(Phi_T=0.7) == 0.7


def test_thermal_reduction_of_a_slow_contact_is_none():
    assert f.thermal_reduction(p_H=5e8, E_r=E_R, L=1e-12, S=0.0) == pytest.approx(1.0, abs=1e-4)


# --- the rigid isoviscous film, from Reynolds' equation
def rigid_constants(points=200_000):
    """Load, sliding and rolling of h = h₀ + x²/2R with the film ending where p and dp/dx vanish.

    With x = √(2·R·h₀)·tan γ:  dp/dγ ~ cos²γ − cos⁴γ/cos²γ_c, and p(γ_c) = 0 fixes γ_c.
    """

    def pressure_at_exit(end):
        gamma = np.linspace(-math.pi / 2, end, points)
        return np.trapezoid(np.cos(gamma) ** 2 - np.cos(gamma) ** 4 / math.cos(end) ** 2, gamma)

    low, high = 0.3, 0.6
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if pressure_at_exit(middle) > 0 else (low, middle)
    gamma = np.linspace(-math.pi / 2, low, points)
    slope = np.cos(gamma) ** 2 - np.cos(gamma) ** 4 / math.cos(low) ** 2
    # p = 12·η·u_e·√(2R)·h₀^(−3/2)·∫slope;  w = −∫x·dp, by parts
    load = -24 * np.trapezoid(slope * np.tan(gamma), gamma)
    sliding = math.sqrt(2) * (low + math.pi / 2)
    rolling = 12 * math.sqrt(2) * np.trapezoid(1 - np.cos(gamma) ** 2 / math.cos(low) ** 2, gamma)
    return load, sliding, rolling


def test_constants_of_the_rigid_film():
    load, sliding, rolling = rigid_constants()
    assert load == pytest.approx(4.896, abs=2e-3)
    assert sliding == pytest.approx(2.849, abs=1e-3)
    assert rolling == pytest.approx(9.202, abs=1e-3)
    h_0 = f.film_rigid_isoviscous(U=f.speed_parameter(0.01, 2.0, E_R, R), W=f.load_parameter(1000.0, E_R, R)) * R
    assert h_0 == pytest.approx(load * 0.01 * 2.0 * R / 1000.0, rel=1e-3)
    assert rigid_rolling_power(0.01, 2.0, R, h_0) == pytest.approx(rolling * 0.01 * 4 * math.sqrt(R / h_0), rel=5e-3)
    power = rigid_fluid_friction(eta_0=0.01, V_s=1.5, R=R, h_0=h_0, w_f=1000.0) * 1000.0 * 1.5
    assert power == pytest.approx(sliding * 0.01 * 1.5**2 * math.sqrt(R / h_0), rel=1e-3)


def test_ehl_rolling_grows_with_speed():
    G, W = f.materials_parameter(ALPHA, E_R), f.load_parameter(W_LINE, E_R, R)
    slow, fast = (ehl_rolling_power(ALPHA, G, f.speed_parameter(ETA, u, E_R, R), W, R, 1.0, u) for u in (5.0, 10.0))
    assert fast / slow == pytest.approx(2**1.658)


# --- regimes
def test_the_thickest_regime_governs():
    assert f.governing_film(H_IR=1.0, H_VR=4.0, H_IE=2.0, H_VE=3.0) == 4.0


def test_light_load_is_rigid_heavy_load_is_ehl():
    c = case(friction(), spur_pair(), oil("friction thesis 10W40", 60.0), 25.0)
    powers = (10.0, 100.0, 1000.0, 10000.0, 50000.0)
    shares = [solve_mesh(c, P, True).rigid_share for P in powers]
    leads = [solve_mesh(c, P, True).lead_at_pitch for P in powers]
    assert shares[0] == 1.0
    assert shares[-1] == 0.0
    assert shares == sorted(shares, reverse=True)
    assert leads == sorted(leads)


def test_by_regime_the_film_is_never_thinner_than_the_source_has_it():
    c = case(friction(), r753()["central_idler"], oil("10W-40 Q8 T905", 120.0), 30.0)
    for P in (10.0, 300.0, 3000.0, 30000.0):
        source, judged = (solve_mesh(c, P, by_regime) for by_regime in (False, True))
        assert judged.film_min >= source.film_min * (1 - 1e-12)


# --- the oil of the mesh
@pytest.mark.parametrize(("T", "eta"), [(40.0, 80.965), (60.0, 36.228), (100.0, 11.375), (120.0, 7.413)])
def test_dynamic_viscosity_of_the_engine_oil(T, eta):
    assert lubricant().at(T).mu * 1e3 == pytest.approx(eta, abs=5e-4)


def test_pressure_viscosity_and_its_temperature_coefficient():
    state = oil("10W-40 Q8 T905", 40.0)
    assert state.alpha * 1e9 == pytest.approx(18.93, abs=5e-3)
    assert state.beta == pytest.approx(0.0453, abs=5e-5)
    step = 1e-3
    low, high = (lubricant().at(40.0 + d).mu for d in (-step, step))
    assert state.beta == pytest.approx(-(math.log(high) - math.log(low)) / (2 * step), rel=1e-8)
