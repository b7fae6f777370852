# SPDX-License-Identifier: Apache-2.0
"""Film and rolling: spot values, the four regimes, and the constants of the rigid film from its own Reynolds
equation."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from calc.friction.mesh import film as f
from calc.friction.mesh.loss import case, ehl_rolling_power, rigid_rolling_power, rolling_estimate, solve_mesh
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


def test_the_exponents_of_dowson_toyoda_by_ratios():
    """3.06·G^0.56·U^0.69·W^−0.10, at 1 and at powers of ten."""

    def H(G=1.0, U=1.0, W=1.0):
        return f.film_elastic_piezoviscous(G=G, e=f.EXPONENT, U=U, W=W)

    assert H() == 3.06
    assert [math.log10(H(**{x: 10.0}) / H()) for x in "GUW"] == pytest.approx([0.56, 0.69, -0.10])


def test_thermal_reduction():
    """Self-computed: p_H/E_r = 1/230, L = 1, S = 0.2."""
    assert f.thermal_reduction(p_H=1.0, E_r=230.0, L=1.0, S=0.2) == pytest.approx(0.70455, abs=5e-6)


def test_thermal_reduction_by_ratios():
    """(1 − 13.2·p/E·L^0.42)/(1 + 0.213·(1 + 2.23·S^0.83)·L^0.64): a factor at a time."""

    def top(p, L):
        return 1 - f.thermal_reduction(p_H=p, E_r=1.0, L=L, S=0.0) / f.thermal_reduction(p_H=0.0, E_r=1.0, L=L, S=0.0)

    def below(L, S):
        return 1 / f.thermal_reduction(p_H=0.0, E_r=1.0, L=L, S=S) - 1

    assert top(1e-3, 1.0) == pytest.approx(13.2e-3) and top(1e-3, 10.0) == pytest.approx(13.2e-3 * 10**0.42)
    assert f.thermal_reduction(p_H=2.0, E_r=500.0, L=1e-9, S=0.0) < 1
    assert below(1.0, 0.0) == pytest.approx(0.213) and below(10.0, 0.0) == pytest.approx(0.213 * 10**0.64)
    assert below(1.0, 1.0) == pytest.approx(0.213 * 3.23) and below(1.0, 10.0) == pytest.approx(
        0.213 * (1 + 2.23 * 10**0.83)
    )


def test_thermal_loading():
    """0.04 Pa·s, 0.05 1/K, 10 m/s, 0.16 W/(m·K)."""
    assert f.thermal_loading(eta_0=0.04, beta=0.05, u_e=10.0, k_f=0.16) == pytest.approx(1.25)


def test_the_thermal_reduction_is_held_at_5_percent():
    assert f.bounded_reduction(Phi_T=-2.0) == 0.05 and f.bounded_reduction(Phi_T=0.049) == 0.05
    assert f.bounded_reduction(Phi_T=0.051) == 0.051 and f.bounded_reduction(Phi_T=0.7) == 0.7


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


def test_ehl_rolling_by_ratios():
    """4.318/α·(G·U)^0.658·W^0.0126·R·Φ·u_e, at 1 and at powers of ten; where a rigid film governs it is not counted."""

    def q(**said):
        return ehl_rolling_power(**{**dict.fromkeys(("alpha", "G", "U", "W", "R", "Phi", "u_e"), 1.0), **said})

    assert q() == 4.318
    exponents = [math.log10(q(**{x: 10.0}) / q()) for x in ("alpha", "G", "U", "W", "R", "Phi", "u_e")]
    assert exponents == pytest.approx([-1, 0.658, 0.658, 0.0126, 1, 1, 1])
    s, q_E, r = np.array([1.0, 2.0, 4.0]), np.array([3.0, 5.0, 7.0]), np.array([0.0, 0.25, 1.0])
    assert rolling_estimate(s=s, q_E=q_E, r=r) == pytest.approx(3 + 7.5)


# --- regimes
GROUPS = dict(U=1e-11, W=1e-5)


def test_the_groups_of_johnson():
    """g_V = W^1.5·G/√U, g_E = W/√U."""
    assert f.viscosity_group(G=4560.0, **GROUPS) == pytest.approx(45.6)
    assert f.elasticity_group(**GROUPS) == pytest.approx(math.sqrt(10.0))


def test_the_four_films():
    """4.896·U/W, 1.66·g_V^(2/3)·U/W with g_V 27, 3.10·g_E^0.8·U/W with g_E √10."""
    assert f.film_rigid_isoviscous(**GROUPS) == pytest.approx(4.896e-6)
    assert f.film_rigid_piezoviscous(g_V=27.0, **GROUPS) == pytest.approx(1.66e-6 * 9)
    assert f.film_elastic_isoviscous(g_E=math.sqrt(10.0), **GROUPS) == pytest.approx(3.10e-6 * 10**0.4)


def test_the_parameters():
    assert f.speed_parameter(eta_0=0.04, u_e=10.0, E_r=2e11, R=0.02) == pytest.approx(1e-10)
    assert f.materials_parameter(alpha=2e-8, E_r=2e11) == pytest.approx(4000.0)
    assert f.load_parameter(w=4e5, E_r=2e11, R=0.02) == pytest.approx(1e-4)


# U, W and G that make each of the regimes govern, in the order IR, VR, IE, VE
@pytest.mark.parametrize(
    "U, W, G, governs",
    [(1e-10, 1e-7, 10.0, 0), (1e-9, 1e-4, 1e5, 1), (1e-12, 1e-4, 10.0, 2), (1e-11, 1e-4, 5000.0, 3)],
    ids=["IR", "VR", "IE", "VE"],
)
def test_the_film_of_a_mesh_is_that_of_its_regime(U, W, G, governs):
    """With the heat of the inlet taken from it; the friction source has VE everywhere."""
    E_r, R, eta, beta, k_f = 2e11, np.array([0.01, 0.02]), 0.02, 0.04, 0.16
    state = SimpleNamespace(eta_0=eta, alpha=G / E_r, beta=beta, k_f=k_f)
    motion = SimpleNamespace(u_e=U * E_r * R / eta, E_r=E_r, R=R, S=np.array([0.1, 0.4]))
    w, p_H = W * E_r * R, np.array([4e8, 6e8])
    cells = SimpleNamespace(below_zero=lambda x: np.where(x < 0, 1.0, 0.0))
    judged, source = (f.film(by_regime, state, motion, w, p_H, cells) for by_regime in (True, False))
    H = [
        4.896 * U / W,
        1.66 * (W**1.5 * G / math.sqrt(U)) ** (2 / 3) * U / W,
        3.10 * (W / math.sqrt(U)) ** 0.8 * U / W,
        3.06 * G**0.56 * U**0.69 * W**-0.1,
    ]
    assert max(range(4), key=H.__getitem__) == governs
    L = eta * beta * motion.u_e**2 / k_f
    Phi = (1 - 13.2 * p_H / E_r * L**0.42) / (1 + 0.213 * (1 + 2.23 * motion.S**0.83) * L**0.64)
    Phi = np.maximum(Phi, 0.05)
    assert judged.Phi == pytest.approx(Phi) and judged.h == pytest.approx(Phi * H[governs] * R)
    assert source.h == pytest.approx(Phi * H[3] * R) and not source.rigid.any() and not source.lead.any()
    assert judged.h_0 == pytest.approx(H[0] * R) and not source.h_0.any()
    assert judged.lead == pytest.approx(max(H[1:]) / H[0] * np.ones(2))
    assert list(judged.rigid) == [float(governs == 0)] * 2
    assert (judged.U, judged.W) == (pytest.approx(U), pytest.approx(W)) and judged.G == pytest.approx(G)


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
    # where no film is elastic nothing is left to estimate
    assert solve_mesh(c, 10.0, True).rolling_estimate is None and solve_mesh(c, 100.0, False).rolling_estimate > 0


def test_by_regime_the_film_is_never_thinner_than_the_source_has_it():
    c = case(friction(), r753()["central_idler"], oil("10W-40 Q8 T905", 120.0), 30.0)
    for P in (10.0, 300.0, 3000.0, 30000.0):
        source, judged = (solve_mesh(c, P, by_regime) for by_regime in (False, True))
        assert judged.film_min >= source.film_min * (1 - 1e-12)


# --- the oil of the mesh
@pytest.mark.parametrize(("T", "eta"), [(40.0, 80.965), (60.0, 36.228), (100.0, 11.375), (120.0, 7.413)])
def test_dynamic_viscosity_of_the_engine_oil(T, eta):
    assert lubricant().at(T).mu * 1e3 == pytest.approx(eta, abs=5e-4)


def test_an_oil_that_is_thickened():
    """By a factor on α, at the teeth and elsewhere; the same oil at another temperature keeps it."""
    plain, thick = oil("10W-40 Q8 T905", 60.0), f.oil_at(lubricant(), 60.0, 0.05, 1.5)
    assert thick.alpha == pytest.approx(1.5 * plain.alpha) and thick.alpha_at(0.02) == pytest.approx(
        1.5 * plain.alpha_at(0.02)
    )
    assert thick.Lambda == 0.05 and plain.Lambda == lubricant().limiting_shear
    warm = thick.at(90.0)
    assert (warm.T_m, warm.thickening, warm.Lambda) == (90.0, 1.5, 0.05) and warm.eta_0 < thick.eta_0


def test_pressure_viscosity_and_its_temperature_coefficient():
    state = oil("10W-40 Q8 T905", 40.0)
    assert state.alpha * 1e9 == pytest.approx(18.93, abs=5e-3)
    assert state.beta == pytest.approx(0.0453, abs=5e-5)
    step = 1e-3
    low, high = (lubricant().at(40.0 + d).mu for d in (-step, step))
    assert state.beta == pytest.approx(-(math.log(high) - math.log(low)) / (2 * step), rel=1e-8)
