"""Notch factors of a shouldered round shaft in bending."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from calc.library.fatigue import high_shoulder, low_shoulder, notch_stress, shoulder_bending


def test_a_shoulder_read_from_the_chart():
    """Shigley, Mechanical Engineering Design, ex. 6-7: d 32, D 38, r 3 mm, read from the chart 1.65: a reading, good to
    some per cent."""
    x, K_t = shoulder_bending(D=38.0, d=32.0, r=3.0)
    assert x == 1
    assert K_t == pytest.approx(1.65, rel=0.025)


@pytest.mark.parametrize(
    ("ratio", "A", "b"),
    [
        (1.1, 0.95120, -0.23757),
        (1.2, 0.97098, -0.21796),
        (1.5, 0.93836, -0.26759),
        (2.0, 0.90879, -0.28598),
        (3.0, 0.89334, -0.30860),
    ],
)
@pytest.mark.parametrize("relative", [0.05, 0.1, 0.2])
def test_near_another_fit_of_the_same_charts(ratio, A, b, relative):
    """Norton, Machine Design, app. of stress-concentration factors, A·(r/d)^b for five D/d: published fits lie up to 8
    % apart here."""
    assert shoulder_bending(D=ratio, d=1.0, r=relative)[1] == pytest.approx(A * relative**b, rel=0.08)


def test_the_two_fits_meet():
    """What the module says of their distance at t/r = 2."""
    for y in (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7):
        assert high_shoulder(x=2.0, y=y) == pytest.approx(low_shoulder(x=2.0, y=y), rel=0.014)
    assert high_shoulder(x=2.0, y=0.9) == pytest.approx(low_shoulder(x=2.0, y=0.9), rel=0.031)


def test_the_columns_of_coefficients_sum_to_one_and_zero():
    """Pilkey's fits end at K_t = 1 for a shoulder as high as the shaft, 2t/D = 1, at any fillet: a figure mistyped
    would show."""
    for x in (0.25, 1.0, 2.0):
        assert low_shoulder(x=x, y=1.0) == pytest.approx(1.028 - 0.031 * x, abs=1e-12)
    for x in (2.0, 4.0, 9.0, 16.0):
        assert high_shoulder(x=x, y=1.0) == pytest.approx(1.003 + 0.002 * math.sqrt(x) + 0.001 * x, abs=1e-12)


@given(ratio=st.floats(1.05, 3.0), x=st.floats(0.11, 18.0), smaller=st.floats(0.5, 0.95))
def test_a_sharper_fillet_is_worse(ratio, x, smaller):
    d, r = 0.03, 0.03 * (ratio - 1) / (2 * x)
    sharper = r * smaller
    assume(r < 0.3 * d)  # as far as the charts reach
    # within the fit, and not across the gap between its two branches
    assume(x / smaller < 20 and not x < 2 < x / smaller)
    assert shoulder_bending(D=ratio * d, d=d, r=sharper)[1] > shoulder_bending(D=ratio * d, d=d, r=r)[1] > 0.95


def test_only_ratios_count():
    assert shoulder_bending(D=0.076, d=0.064, r=0.006)[1] == pytest.approx(
        shoulder_bending(D=38.0, d=32.0, r=3.0)[1], rel=1e-12
    )
    assert notch_stress(K_t=2.0, sigma=3e6) == 6e6
    assert not math.isnan(shoulder_bending(D=80.6, d=30.0, r=1.0)[1])  # t/r 25: an extrapolation, still a number
