# SPDX-License-Identifier: Apache-2.0
"""The short bearing in closed form: its own limits, and the direct solution of Reynolds' equation."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.bearings.plain.film import short_bearing as s
from calc.bearings.plain.film.reynolds import solve_film

# the two journals of the worked example at their films of 10.4 and 12.4 µm: l/d, ε, P in MPa
FRONT, REAR = (27.5 / 59.5, 0.7415, 1.0451), (26.5 / 81.0, 0.7255, 0.7966)
SUPPLY = 0.4  # MPa


def largest(eps, b):
    return s.largest_relative_pressure(eps=eps, b=b, theta_m=s.angle_of_largest_pressure(eps=eps))


@pytest.mark.parametrize("eps, tolerance", [(0.05, 0.02), (0.2, 0.02), (0.5, 0.03)])
def test_against_the_direct_solution(eps, tolerance):
    """l/d 0.1; what the flow around the shaft takes shrinks with (l/d)²."""
    film = solve_film(eps, 0.1)
    So = s.sommerfeld_din(eps=eps, b=0.1)
    assert 1 / (2 * math.pi * film.sommerfeld) == pytest.approx(So, rel=tolerance)
    assert film.attitude == pytest.approx(s.attitude_angle(eps=eps), abs=tolerance)
    assert film.flow == pytest.approx(s.relative_flow(eps=eps), rel=tolerance)
    assert film.side_flow_ratio == pytest.approx(s.side_flow_share(eps=eps), rel=tolerance)
    assert film.flow * film.side_flow_ratio == pytest.approx(s.relative_side_flow(eps=eps), rel=tolerance)
    assert film.pressure_ratio == pytest.approx(s.pressure_ratio(So=So, largest=largest(eps, 0.1)), rel=tolerance)


def test_the_load_is_the_integral_of_the_pressure():
    """∬p over the half film, p parabolic across (mean two thirds of the middle's), gives So and φ."""
    eps, b = 0.6, 0.25
    theta = np.linspace(0, math.pi, 200_001)
    angle = s.angle_of_largest_pressure(eps=eps)
    middle = s.middle_pressure(p_max=largest(eps, b), eps=eps, theta=theta, theta_m=angle)
    # zero at both ends
    along, across = (float(middle @ part) * theta[1] * 2 / 3 for part in (np.cos(theta), np.sin(theta)))
    assert math.hypot(along, across) / 2 == pytest.approx(s.sommerfeld_din(eps=eps, b=b), rel=1e-8)
    assert math.atan2(across, -along) == pytest.approx(s.attitude_angle(eps=eps), rel=1e-8)


@given(st.floats(1e-4, 0.9999))
def test_the_largest_pressure_lies_where_it_says(eps):
    angle = s.angle_of_largest_pressure(eps=eps)
    assert math.pi / 2 < angle < math.pi
    derivative = math.cos(angle) * (1 + eps * math.cos(angle)) + 3 * eps * math.sin(angle) ** 2
    assert derivative == pytest.approx(0, abs=1e-10)


def test_a_centred_journal_moves_square_to_the_load():
    assert s.attitude_angle(eps=1e-6) == pytest.approx(math.pi / 2, abs=2e-6)
    assert s.angle_of_largest_pressure(eps=1e-6) == pytest.approx(math.pi / 2, abs=4e-6)


def test_a_journal_that_touches_stands_under_the_load():
    assert s.attitude_angle(eps=1 - 1e-9) == pytest.approx(0, abs=1e-4)


@given(st.floats(1e-3, 0.999), st.floats(0.05, 2))
def test_eccentricity_comes_back(eps, b):
    S = 1 / (2 * math.pi * s.sommerfeld_din(eps=eps, b=b))
    found = s.eccentricity(S=S, b=b)
    assert type(found) is float and found == pytest.approx(eps, rel=1e-10)


def test_eccentricity_of_many():
    eps, b = np.meshgrid([0.001, 0.3, 0.7, 0.99], [0.1, 0.5])
    S = 1 / (2 * math.pi * s.sommerfeld_din(eps=eps, b=b))
    assert s.eccentricity(S=S, b=b) == pytest.approx(eps, rel=1e-10)


def direct_arc(b, eps, p):
    """Degrees over which the direct solution's middle pressure exceeds the supply, and its peak."""
    film = solve_film(eps, b)
    peak = p / film.pressure_ratio
    around = np.linspace(0, 2 * math.pi, 100_001)
    pressure = np.interp(around, film.theta, film.pressure / film.pressure.max()) * peak
    return float((pressure > SUPPLY).mean()) * 360, peak, film


@pytest.mark.parametrize("bearing, degrees", [(FRONT, 102), (REAR, 90)], ids=["front", "rear"])
def test_where_the_film_keeps_the_supply_out(bearing, degrees):
    """4 bar: the direct solution gives 102 and 90 degrees.  The short bearing's own pressure comes nearer than its
    shape under the finite bearing's peak; both fall short."""
    b, eps, p = bearing
    direct, peak, film = direct_arc(b, eps, p)
    assert direct == pytest.approx(degrees, abs=0.7)
    own = p * 2 * math.pi * film.sommerfeld * largest(eps, b)
    by_own, by_peak = (math.degrees(s.blocked_arc(eps=eps, p_s=SUPPLY, p_max=p_max)) for p_max in (own, peak))
    assert by_peak < by_own < direct
    assert by_own == pytest.approx(direct, rel=0.08) and by_peak == pytest.approx(direct, rel=0.23)


@pytest.mark.parametrize("b, eps, p", [(0.46, 0.865, 1.05), (0.25, 0.8, 1.5), (0.46, 0.5, 1.0), (1.0, 0.8, 2.0)])
def test_the_arc_falls_short_by_five_to_nine_per_cent(b, eps, p):
    direct, _, film = direct_arc(b, eps, p)
    own = p * 2 * math.pi * film.sommerfeld * largest(eps, b)
    assert 0.9 < math.degrees(s.blocked_arc(eps=eps, p_s=SUPPLY, p_max=own)) / direct < 0.96


def test_the_arc_of_a_short_bearing_is_that_of_the_direct_solution():
    b, eps, p = 0.1, 0.5, 1.0
    direct, peak, _ = direct_arc(b, eps, p)
    assert math.degrees(s.blocked_arc(eps=eps, p_s=SUPPLY, p_max=peak)) == pytest.approx(direct, rel=0.02)


@given(st.floats(0.01, 0.999), st.floats(1e-6, 0.999999))
def test_at_the_ends_of_the_arc_stands_the_supply_pressure(eps, share):
    first, last = s.blocked_ends(eps, share)
    angle = s.angle_of_largest_pressure(eps=eps)
    assert 0 < first <= angle <= last < math.pi
    for end in (float(first), float(last)):
        found = s.middle_pressure(p_max=1.0, eps=eps, theta=end, theta_m=angle)
        assert found == pytest.approx(share, rel=1e-5)


def test_limits_of_the_arc():
    assert s.blocked_arc(eps=0.7, p_s=0.0, p_max=1e6) == pytest.approx(math.pi)
    assert s.blocked_arc(eps=0.7, p_s=1e6, p_max=1e6) == s.blocked_arc(eps=0.7, p_s=2e6, p_max=1e6) == 0
    many = s.blocked_arc(eps=np.array([0.2, 0.7]), p_s=4e5, p_max=np.array([1e6, 3e6]))
    assert many == pytest.approx(
        [s.blocked_arc(eps=0.2, p_s=4e5, p_max=1e6), s.blocked_arc(eps=0.7, p_s=4e5, p_max=3e6)]
    )
