# SPDX-License-Identifier: Apache-2.0
"""Schlenk, Xu and Kahraman, Benedict and Kelley; windage."""

import math

import pytest

from calc.friction import models as r
from calc.friction.losses import oil_and_air as a
from calc.friction.mesh.loss import case
from calc.friction.mesh.path import path
from tests.calc.friction.pairs import friction, fzg, lubricant, oil, r753, reference

VECTORS = reference("friction_vectors.toml")


def test_xu_kahraman():
    """Self-computed: 1 GPa, SR 0.2, 10 m/s, 10 mPa·s, 10 mm, 0.2 µm."""
    f = r.xu_kahraman_exponent(S=0.2, p_H=1e9, eta_0=0.01, sigma=0.2e-6)
    assert r.xu_kahraman(f=f, p_H=1e9, S=0.2, u_e=10.0, eta_0=0.01, R=0.01) == pytest.approx(0.013668, abs=5e-7)


def test_the_exponent_of_the_pressure():
    """1.03303 beside e^f, which knows the pressure as well."""
    low, high = (r.xu_kahraman(f=-4.0, p_H=p, S=0.2, u_e=10.0, eta_0=0.01, R=0.01) for p in (0.25e9, 2.5e9))
    assert math.log10(high / low) == pytest.approx(1.03303)


def test_benedict_kelley():
    """Self-computed: 1e5 N/m, 20 mPa·s, 2 m/s sliding, 10 m/s sum."""
    assert r.benedict_kelley(w=1e5, eta_0=0.02, V_s=2.0, V_T=10.0) == pytest.approx(0.03645, abs=5e-6)


def test_benedict_kelley_stays_within_its_bounds():
    assert r.benedict_kelley(w=1e5, eta_0=0.02, V_s=0.0, V_T=10.0) <= 0.2
    assert r.benedict_kelley(w=1.0, eta_0=0.02, V_s=2.0, V_T=100.0) == 0.01
    least, most = (r.benedict_kelley(w=10**x / 29.66, eta_0=1e-3, V_s=1.0, V_T=1.0) for x in (0.8, 15.7))
    assert (least, most) == pytest.approx((0.0127 * 0.8, 0.0127 * 15.7))
    assert r.benedict_kelley(w=10**15.8 / 29.66, eta_0=1e-3, V_s=1.0, V_T=1.0) == 0.2


def test_schlenk_on_fzg_gears():
    known, mesh, T_1 = VECTORS["schlenk"], fzg(), 302.0
    p = path(mesh)
    rho = p.C_C * (p.C_F - p.C_C) / p.C_F
    v_sum = 2 * 8.3 * p.C_F / 91.5e-3  # 2·v·sin α_wt
    mu = r.schlenk(w_t=T_1 / mesh.driver.base_radius / 14e-3, v_SumC=v_sum, rho_C=rho, eta_0=0.012, Ra=0.4e-6, X_L=1.0)
    assert mu == pytest.approx(known["friction_mean"], abs=known["tolerance"])


def test_schlenk_counts_no_line_load_below_150_n_per_mm():
    assert r.counted_line_load(w_bt=1e3) == r.counted_line_load(w_bt=150e3) == 150e3
    assert r.counted_line_load(w_bt=160e3) == 160e3


def test_mean_friction_times_loss_factor_is_the_loss():
    c = case(friction(), r753()["idler_shaft"], oil("10W-40 Q8 T905", 120.0), 27.8)
    assert r.of_schlenk(c, 280.0, 0.134).loss == pytest.approx(
        280 * 0.134 * r.of_schlenk(c, 280.0, 0.134).friction_mean
    )
    for of in (r.of_xu_kahraman, r.of_benedict_kelley):
        assert 0.005 < of(c, 280.0, 0.134).friction_mean < 0.2


def test_xu_kahraman_is_not_shown_for_very_rough_flanks():
    c = case(friction(flank_roughness=(5e-6,)), r753()["idler_shaft"], oil("10W-40 Q8 T905", 120.0), 27.8)
    assert r.of_xu_kahraman(c, 280.0, 0.134) is None


# --- windage
def test_windage_in_the_mist_of_the_tests_is_the_published_form():
    """2.82·10⁻⁷ kW·(1 + 2.3·F/R)·n^2.8·R^4.6·(0.028·μ + 0.019)^0.2 with rpm, m, mPa·s; its 0.028 is rounded."""
    state = lubricant().at(120.0)
    rho_0 = a.mist_of_the_tests(rho_oil=state.rho)
    eta_m = a.mist_viscosity(
        s_oil=a.oil_share(rho_m=rho_0, rho_oil=state.rho), eta_oil=state.mu, eta_air=a.AIR_VISCOSITY
    )
    ours = a.windage(b=15e-3, r=42e-3, n=5000 / 60, eta_m=eta_m, rho_m=rho_0, rho_0=rho_0)
    published = 2.82e-7 * 1e3 * (1 + 2.3 * 15 / 42) * 5000**2.8 * 0.042**4.6 * (0.028 * state.mu * 1e3 + 0.019) ** 0.2
    assert ours == pytest.approx(published, rel=3e-3)


def test_the_mist_of_the_tests_by_hand():
    """One part of oil in 34.25 of air of 1.2 kg/m³, which adds 0.019 mPa·s to the mist."""
    rho_0 = a.mist_of_the_tests(rho_oil=800.0)
    assert rho_0 == pytest.approx((800 + 34.25 * 1.2) / 35.25)
    share = a.oil_share(rho_m=rho_0, rho_oil=800.0)
    assert share == pytest.approx(1 / 35.25)
    assert a.mist_viscosity(s_oil=share, eta_oil=0.0, eta_air=a.AIR_VISCOSITY) == pytest.approx(0.019e-3)


def test_windage_grows_as_the_power_0_8_of_the_density():
    thin, thick = (a.windage(b=0.015, r=0.04, n=30.0, eta_m=2e-5, rho_m=rho, rho_0=24.0) for rho in (2.4, 24.0))
    assert math.log10(thick / thin) == pytest.approx(0.8)


def test_air_holds_no_oil_and_no_mist_more_than_oil():
    assert a.oil_share(rho_m=1.0, rho_oil=800.0) == 0.0
    assert a.oil_share(rho_m=1000.0, rho_oil=800.0) == 1.0
    assert a.mist_viscosity(s_oil=0.0, eta_oil=0.01, eta_air=a.AIR_VISCOSITY) == a.AIR_VISCOSITY


def test_windage_grows_as_the_power_2_8_of_speed():
    slow, fast = (a.windage(b=0.015, r=0.04, n=n, eta_m=2e-5, rho_m=1.2, rho_0=24.0) for n in (20.0, 40.0))
    assert math.log2(fast / slow) == pytest.approx(2.8)
