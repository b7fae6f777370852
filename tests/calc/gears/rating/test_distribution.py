"""Tolerances of ISO 1328-1 and running in of ISO 6336-1."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.gears.rating import distribution as d


def um(f):
    return pytest.approx(f * 1e-6, rel=1e-12)


@pytest.mark.parametrize(
    "f, to",
    [(0.3, 0.3), (4.94, 4.9), (4.96, 5.0), (5.2, 5.0), (5.25, 5.5), (8.74, 8.5), (10.0, 10.0), (10.5, 11), (11.49, 11)],
)
def test_rounding(f, to):
    assert d.rounded(f=f * 1e-6) == um(to)


def test_tolerances_grow_by_the_root_of_two_a_grade():
    for f in (
        lambda A: d.single_pitch_tolerance(d=0.08, m_n=0.002, A=A),
        lambda A: d.profile_form_tolerance(m_n=0.002, A=A),
        lambda A: d.helix_slope_tolerance(d=0.08, b=0.015, A=A),
    ):
        assert f(6) / f(5) == pytest.approx(math.sqrt(2)) and f(7) == pytest.approx(2 * f(5))


def test_tolerances_of_grade_5():
    """ISO 1328-1:2013 in µm and mm: 0.001 d + 0.4 m_n + 5, 0.55 m_n + 5, 0.05 √d + 0.35 √b + 4."""
    assert d.single_pitch_tolerance(d=0.1, m_n=0.003, A=5) == um(6.3)
    assert d.profile_form_tolerance(m_n=0.003, A=5) == um(6.65)
    assert d.helix_slope_tolerance(d=0.1, b=0.025, A=5) == um(0.5 + 1.75 + 4)


@pytest.mark.parametrize("symbol, low, high", [("d", 5, 15000), ("m_n", 0.5, 70), ("b", 4, 1200)])
def test_range_of_the_tolerances(symbol, low, high):
    """ISO 1328-1:2013, 1: in mm."""

    def outside(size):
        sizes = {"m_n": 2, "b": 15, "d": 54} | {symbol: size}
        return [str(text) for text in d.out_of_range(*(mm / 1e3 for mm in sizes.values()), 0.08)]

    assert outside(low * 1.01) == outside(high * 0.99) == []
    for size in (low * 0.99, high * 1.01):
        assert outside(size) == [f"{symbol} = {float(f'{size:.4g}'):g} mm ({low:g} to {high:g} mm)"]


@pytest.mark.parametrize("kind", ["Eh", "IF", "NT(nitr.)", "NV(nitrocar.)"])
def test_hard_flanks_run_in_little(kind):
    assert d.running_in(10e-6, kind, 1500e6, 20.0) == um(0.75)
    assert d.running_in(60e-6, kind, 1500e6, 2.0) == um(3)
    assert d.running_in_beta(20e-6, kind, 1500e6, 20.0) == um(3)
    assert d.running_in_beta(60e-6, kind, 1500e6, 2.0) == um(6)


@pytest.mark.parametrize(
    "v, alpha, beta", [(4.99, 100.0, 100.0), (5.01, 80.0, 80.0), (9.99, 80.0, 80.0), (10.01, 40.0, 40.0)]
)
def test_soft_flanks_run_in_by_their_strength_and_speed(v, alpha, beta):
    """12800 and 6400 over σ_Hlim for y_α, 25600 and 12800 for y_β: the limits that the standard states."""
    assert d.running_in(100e-6, "V", 800e6, v) == um(160 / 800 * alpha)
    assert d.running_in(100e-6, "GG", 400e6, v) == um(0.275 * alpha)
    assert d.running_in_beta(100e-6, "V", 800e6, v) == um(320 / 800 * beta)
    assert d.running_in_beta(100e-6, "GG", 400e6, v) == um(0.55 * beta)


def test_a_weak_steel_runs_in_wholly_along_its_width():
    """320 MPa over σ_Hlim, at most all of it."""
    assert d.running_in_beta(50e-6, "St", 310e6, 2.0) == um(50)
    assert d.running_in_beta(50e-6, "St", 330e6, 2.0) == um(50 * 320 / 330)


@given(
    f=st.floats(1e-7, 5e-4),
    sigma=st.floats(200e6, 2e9),
    v=st.floats(0, 60),
    kind=st.sampled_from(["Eh", "V", "St", "GGG", "GG", "GTS"]),
)
def test_running_in_never_takes_more_than_there_is(f, sigma, v, kind):
    assert 0 <= d.running_in(f, kind, sigma, v) <= f
    assert 0 <= d.running_in_beta(f, kind, sigma, v) <= f


# --- along the face width and between pairs, ISO 6336-1:2006, clauses 7 and 8
def test_the_misalignment_by_hand():
    """In µm and N/mm: at least 0.005·F_m/b and half of f_Hβ; 1.33·f_sh + f_ma."""
    assert d.mesh_misalignment(f_Hbeta1=3e-6, f_Hbeta2=4e-6) == um(5)
    assert d.least_misalignment(w_m=2000e3, f_Hbeta=12e-6) == um(10)
    assert d.least_misalignment(w_m=200e3, f_Hbeta=12e-6) == um(6)
    assert d.initial_misalignment(f_sh=10e-6, f_ma=5e-6, F_min=6e-6) == um(18.3)
    assert d.initial_misalignment(f_sh=10e-6, f_ma=5e-6, F_min=19e-6) == um(19)
    assert d.effective_misalignment(F_betax=18e-6, y_beta=3e-6) == um(15)
    assert d.base_pitch_deviation(f_pT=12e-6, alpha_t=math.radians(60)) == um(6)
    assert d.pitch_line_velocity(d=0.1, n=-20.0) == pytest.approx(2 * math.pi)
    assert d.mean_run_in(y_1=1e-6, y_2=4e-6) == um(2.5)


@pytest.mark.parametrize("F_y, xi, K, share", [(10, 0.5, 1.5, 1.0), (20, 1.0, 2.0, 1.0), (80, 4.0, 4.0, 0.5)])
def test_the_face_load_factor_by_hand(F_y, xi, K, share):
    """F_βy in µm; c_γβ 20 N/(mm·µm), 200 N/mm."""
    found = d.relative_misalignment(F_betay=F_y * 1e-6, c_gamma_beta=20e9, w_m=200e3)
    assert found == pytest.approx(xi) and d.contact_share(xi=found) == pytest.approx(share)
    assert (d.face_factor_whole if xi <= 1 else d.face_factor_part)(xi=found) == pytest.approx(K)


def test_the_face_load_factor_of_the_root_by_hand():
    assert d.slenderness(b=20e-3, d_a=60e-3, d_f=50e-3) == pytest.approx(4.0)
    assert d.slenderness(b=14.9e-3, d_a=60e-3, d_f=50e-3) == 3.0
    assert d.root_exponent(r=4.0) == pytest.approx(16 / 21)
    assert d.face_factor_root(K_Hbeta=1.5, N_F=0.75) == pytest.approx(1.5**0.75)
    assert d.mean_load(w=100e3, K_V=1.2) == pytest.approx(120e3)
    assert d.line_load(F_t=2000.0, K_A=1.5, b=0.02) == pytest.approx(150e3)


def test_the_transverse_load_factor_by_hand():
    q = d.relative_deviation(c_gamma_alpha=20e9, f=12e-6, y_alpha=2e-6, w_m=100e3, K_Hbeta=1.25)
    assert q == pytest.approx(1.6)
    assert d.pair_factor(eps_gamma=1.6, q_alpha=q) == pytest.approx(0.8 * (0.9 + 0.64))
    assert d.pair_factor_high(eps_gamma=2.5, q_alpha=q) == pytest.approx(0.9 + 0.4 * math.sqrt(1.2) * 1.6)
    assert d.pair_limit_flank(eps_gamma=2.5, eps_alpha=1.5, Z_eps=0.8) == pytest.approx(2.5 / 0.96)
    assert d.pair_limit_root(eps_gamma=2.5, eps_alpha=1.5) == pytest.approx(2.5 / 1.125)
    for factor in (d.pair_factor_flank, d.pair_factor_root):
        assert [factor(K_alpha=K, K_max=1.8) for K in (0.98, 1.02, 1.9)] == [1.0, 1.02, 1.8]
