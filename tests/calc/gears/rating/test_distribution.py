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


def test_range_of_the_tolerances():
    assert d.out_of_range(0.002, 0.015, 0.054, 0.08) == []
    assert len(d.out_of_range(0.0004, 1.3, 0.004, 0.08)) == 3


@pytest.mark.parametrize("kind", ["Eh", "IF", "NT(nitr.)", "NV(nitrocar.)"])
def test_hard_flanks_run_in_little(kind):
    assert d.running_in(10e-6, kind, 1500e6, 20.0) == um(0.75)
    assert d.running_in(60e-6, kind, 1500e6, 2.0) == um(3)
    assert d.running_in_beta(20e-6, kind, 1500e6, 20.0) == um(3)
    assert d.running_in_beta(60e-6, kind, 1500e6, 2.0) == um(6)


@pytest.mark.parametrize("v, alpha, beta", [(4.0, 100.0, 100.0), (7.0, 80.0, 80.0), (12.0, 40.0, 40.0)])
def test_soft_flanks_run_in_by_their_strength_and_speed(v, alpha, beta):
    """12800 and 6400 over σ_Hlim for y_α, 25600 and 12800 for y_β: the limits that the standard states."""
    assert d.running_in(100e-6, "V", 800e6, v) == um(160 / 800 * alpha)
    assert d.running_in(100e-6, "GG", 400e6, v) == um(0.275 * alpha)
    assert d.running_in_beta(100e-6, "V", 800e6, v) == um(320 / 800 * beta)
    assert d.running_in_beta(100e-6, "GG", 400e6, v) == um(0.55 * beta)


@given(
    f=st.floats(1e-7, 5e-4),
    sigma=st.floats(200e6, 2e9),
    v=st.floats(0, 60),
    kind=st.sampled_from(["Eh", "V", "St", "GGG", "GG", "GTS"]),
)
def test_running_in_never_takes_more_than_there_is(f, sigma, v, kind):
    assert 0 <= d.running_in(f, kind, sigma, v) <= f
    assert 0 <= d.running_in_beta(f, kind, sigma, v) <= f
