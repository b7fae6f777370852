"""Sizes over pins: against the geometry of the pins themselves, and a published size."""

import math

import numpy as np
import pytest

from calc.gears import formulas as f
from calc.gears.measures import formulas as m
from calc.gears.measures.solve import over_pins
from calc.gears.train import tooth_system
from tests.calc.gears.trains import mesh, train, wheel

INCH = 25.4e-3
WHEELS = [
    (25, 2.0, 21.916, 0.014, 3.5),
    (17, 3.0, 12.0, 0.3, 5.5),
    (39, 2.0, 33.0, -0.15, 3.5),
    (36, 2.0, 21.916, 0.014, 3.5),
]


def placed(z, m_n, beta, x, D):
    """System, angle and circle of the centres of a pin, and half the angle of the space at the base circle."""
    system = tooth_system(train([wheel("a", z)], [mesh("a", "a")], m_n=m_n, beta=beta))
    d = f.reference_diameter(z, system.transverse_module)
    alpha_t, beta_b = system.transverse_pressure_angle, system.base_helix_angle
    d_b = f.base_diameter(d, alpha_t)
    s_t = f.reference_thickness(system.m_n, x, system.alpha_n, system.beta)
    alpha_K = f.angle_of_involute(m.ball_involute(s_t, d, alpha_t, D * 1e-3, d_b, beta_b, z))
    half_space = math.pi / z - s_t / d - (math.tan(alpha_t) - alpha_t)
    return system, d_b, alpha_K, m.ball_centre_diameter(d_b, alpha_K), half_space


def line(r, angle, height, beta_K):
    """A point of a pin's centre line on the circle of radius r, and its direction, the tangent of the helix."""
    along = [-math.sin(angle) * math.sin(beta_K), math.cos(angle) * math.sin(beta_K), math.cos(beta_K)]
    return np.array([r * math.cos(angle), r * math.sin(angle), height]), np.array(along)


def distance(one, other):
    (P, u), (Q, v) = one, other
    normal = np.cross(u, v)
    return abs((P - Q) @ normal) / np.linalg.norm(normal)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("z", "m_n", "beta", "x", "D"), WHEELS)
def test_a_pin_along_the_helix_touches_both_flanks_and_cuts_neither(z, m_n, beta, x, D, side):
    system, d_b, alpha_K, d_K, half_space = placed(z, m_n, beta, x, D)
    beta_b = system.base_helix_angle
    P, u = line(d_K / 2, 0.0, 0.0, m.helix_angle_at_centres(beta_b, alpha_K))
    low, high = np.array([0.0, -4e-3]), np.array([1.1, 4e-3])  # pressure angle on the flank, height
    for _ in range(14):
        alpha, height = np.meshgrid(*(np.linspace(a, b, 61) for a, b in zip(low, high)))
        polar = side * (half_space + np.tan(alpha) - alpha) + height * math.tan(beta_b) / (d_b / 2)
        r = d_b / 2 / np.cos(alpha)
        flank = np.stack([r * np.cos(polar), r * np.sin(polar), height]) - P[:, None, None]
        off = np.linalg.norm(flank - u[:, None, None] * np.tensordot(u, flank, 1), axis=0)
        i = off.argmin()
        least, at, reach = off.flat[i], np.array([alpha.flat[i], height.flat[i]]), (high - low) / 6
        low, high = np.maximum(at - reach, [0.0, -math.inf]), at + reach
    assert least == pytest.approx(D / 2 * 1e-3, abs=1e-12)


@pytest.mark.parametrize(("z", "m_n", "beta", "x", "D"), [w for w in WHEELS if w[0] % 2])
def test_two_loose_pins_find_the_smallest_distance_of_their_centre_lines(z, m_n, beta, x, D):
    system, _, alpha_K, d_K, _ = placed(z, m_n, beta, x, D)
    beta_K, r = m.helix_angle_at_centres(system.base_helix_angle, alpha_K), d_K / 2
    first = line(r, 0.0, 0.0, beta_K)

    def apart(height):
        """The second pin in the space next to opposite, slid along its helix."""
        return distance(first, line(r, math.pi + math.pi / z + height * math.tan(beta_K) / r, height, beta_K))

    low, high = -r, r
    for _ in range(12):
        heights = np.linspace(low, high, 101)
        best = heights[np.argmin([apart(h) for h in heights])]
        low, high = best - (high - low) / 20, best + (high - low) / 20
    found = m.over_two_pins(d_K, m.pin_angle(z, beta_K), beta_K, D * 1e-3)
    assert found == pytest.approx(apart(best) + D * 1e-3, abs=1e-12)
    assert found < m.over_balls_odd(d_K, z, D * 1e-3) < over_pins(system, z, d_K, D * 1e-3)


@pytest.mark.parametrize(("z", "m_n", "beta", "x", "D"), [w for w in WHEELS if w[0] % 2])
def test_three_pins_of_an_odd_helical_wheel_lie_flat_an_axial_pitch_apart(z, m_n, beta, x, D):
    system, _, alpha_K, d_K, _ = placed(z, m_n, beta, x, D)
    beta_K, r = m.helix_angle_at_centres(system.base_helix_angle, alpha_K), d_K / 2
    half = math.pi * system.m_n / math.sin(system.beta) / 2  # of the axial pitch: turns a helix by half a pitch
    assert half * math.tan(beta_K) / r == pytest.approx(math.pi / z, rel=1e-12)
    first, pair = line(r, 0.0, 0.0, beta_K), [line(r, math.pi, h, beta_K) for h in (half, -half)]
    np.testing.assert_allclose(pair[0][1], pair[1][1], atol=1e-15)  # parallel, so that one face rests on both
    for other in pair:
        assert first[1][0] == 0 and abs(other[1][0]) < 1e-15  # and both faces are parallel to the axis
        assert distance(first, other) + D * 1e-3 == pytest.approx(over_pins(system, z, d_K, D * 1e-3), rel=1e-12)


def test_published_size_over_pins_of_an_odd_helical_wheel():
    """10.967749 in, quoted as the AGMA value in the tests of a public program (bfoster59/MOP): 127 teeth, normal pitch
    12, 20°, 10.5°, thickness 0.1309 in (π/24), pins of 0.144 in."""
    system, _, _, d_K, _ = placed(127, 25.4 / 12, 10.5, 0.0, 0.144 * 25.4)
    assert over_pins(system, 127, d_K, 0.144 * INCH) / INCH == pytest.approx(10.967749, abs=0.5e-6)


@pytest.mark.parametrize("z", [24, 25])
def test_pins_are_balls_on_spur_wheels_and_on_even_ones(z):
    system, _, _, d_K, _ = placed(z, 2.0, 0.0, 0.2, 3.5)
    balls = m.over_balls_odd(d_K, z, 3.5e-3) if z % 2 else m.over_balls_even(d_K, 3.5e-3)
    assert over_pins(system, z, d_K, 3.5e-3) == balls
    helical, _, _, d_K, _ = placed(24, 2.0, 20.0, 0.2, 3.5)
    assert over_pins(helical, 24, d_K, 3.5e-3) == m.over_balls_even(d_K, 3.5e-3)


def test_two_loose_pins_become_balls_as_the_helix_straightens():
    system, _, alpha_K, d_K, _ = placed(25, 2.0, 0.05, 0.2, 3.5)
    beta_K = m.helix_angle_at_centres(system.base_helix_angle, alpha_K)
    loose = m.over_two_pins(d_K, m.pin_angle(25, beta_K), beta_K, 3.5e-3)
    assert loose == pytest.approx(m.over_balls_odd(d_K, 25, 3.5e-3), abs=1e-10)
    assert loose < m.over_balls_odd(d_K, 25, 3.5e-3)
