# SPDX-License-Identifier: Apache-2.0
"""Stiffness, damping, stability and orbit: closed forms, the direct solution at a displaced journal, a squeeze solution
of another make."""

import cmath
import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import csr_matrix, diags, eye, kron
from scipy.sparse.linalg import spsolve

from calc.bearings.plain.film import dynamics as d
from calc.bearings.plain.film import short_bearing as s
from calc.bearings.plain.film.dynamics import Dynamics, coefficients, dynamics, orbit_of
from calc.bearings.plain.film.reynolds import radial_damping, solve_film
from calc.bearings.plain.film.table import FilmRangeError, film_at, film_slopes

STATES = [(0.1, 0.25), (0.3, 0.5), (0.6, 0.46), (0.75, 0.33), (0.86, 0.46), (0.5, 1.0), (0.7, 1.7)]


def matrices(k):
    return np.array([[k.k_xx, k.k_xy], [k.k_yx, k.k_yy]]), np.array([[k.c_xx, k.c_xy], [k.c_xy, k.c_yy]])


def friswell(e):
    """Short bearing: Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), p. 177, a_uu … b_vv.

    Their load points along −v, u is 90° further in the sense of rotation: here X along the load and Y stand for −v and
    u."""
    pi = math.pi
    h = 1 / (pi**2 * (1 - e**2) + 16 * e**2) ** 1.5
    auu = h * 4 * (pi**2 * (2 - e**2) + 16 * e**2)
    auv = h * pi * (pi**2 * (1 - e**2) ** 2 - 16 * e**4) / (e * math.sqrt(1 - e**2))
    avu = -h * pi * (pi**2 * (1 - e**2) * (1 + 2 * e**2) + 32 * e**2 * (1 + e**2)) / (e * math.sqrt(1 - e**2))
    avv = h * 4 * (pi**2 * (1 + 2 * e**2) + 32 * e**2 * (1 + e**2) / (1 - e**2))
    buu = h * 2 * pi * math.sqrt(1 - e**2) * (pi**2 * (1 + 2 * e**2) - 16 * e**2) / e
    buv = -h * 8 * (pi**2 * (1 + 2 * e**2) - 16 * e**2)
    bvv = h * 2 * pi * (pi**2 * (1 - e**2) ** 2 + 48 * e**2) / (e * math.sqrt(1 - e**2))
    return np.array([[avv, -avu], [-auv, auu]]), np.array([[bvv, -buv], [-buv, buu]])


def short(e):
    """The formulas of this program on the closed forms of the short bearing."""
    step = 1e-6
    q, a = (
        (math.log(s.sommerfeld_din(eps=e + step, b=1.0) / s.sommerfeld_din(eps=e - step, b=1.0))) / (2 * step),
        (s.attitude_angle(eps=e + step) - s.attitude_angle(eps=e - step)) / (2 * step),
    )
    phi, c_rr = s.attitude_angle(eps=e), s.radial_damping(eps=e)
    c_xy = d.c_xy(c_rr=c_rr, eps=e, phi=phi)
    K = np.array(
        [[d.k_xx(q=q, phi=phi), d.k_xy(q=q, phi=phi)], [d.k_yx(eps=e, phi=phi, a=a), d.k_yy(eps=e, phi=phi, a=a)]]
    )
    return K, np.array([[d.c_xx(c_rr=c_rr, eps=e, phi=phi), c_xy], [c_xy, d.c_yy(c_rr=c_rr, eps=e, phi=phi)]])


@pytest.mark.parametrize("e", [0.05, 0.2, 0.5, 0.8, 0.95])
def test_the_short_bearing_in_closed_form(e):
    for found, published in zip(short(e), friswell(e)):
        assert found == pytest.approx(published, rel=1e-7, abs=1e-7)


@pytest.mark.parametrize("e", [0.1, 0.3, 0.5])
def test_a_bearing_of_a_tenth_of_its_diameter_is_nearly_short(e):
    """The squeezed film of the short bearing ends with a step of pressure, which a finite one smooths over a length of
    the order of l: its damping falls short by up to 4 %, in proportion to l/d; the stiffness by up to 2 %."""
    for found, published in zip(matrices(coefficients(e, 0.1)), friswell(e)):
        assert found == pytest.approx(published, abs=0.04 * np.abs(published).max())


def force(position, length_ratio):
    """The film's force on a journal that rests at this place (complex: X + iY, over c), over μ·ω·l·d/ψ²."""
    film = solve_film(abs(position), length_ratio, cells=(384, 32))
    return -cmath.exp(1j * (cmath.phase(position) - film.attitude)) / (2 * math.pi * film.sommerfeld)


@pytest.mark.parametrize("e, b", STATES)
def test_stiffness_is_what_a_displaced_journal_feels(e, b):
    film = solve_film(e, b, cells=(384, 32))
    load = 1 / (2 * math.pi * film.sommerfeld)
    at, step = e * cmath.exp(1j * film.attitude), 2e-3 * (1 - e)
    assert force(at, b) == pytest.approx(-load, rel=1e-9)  # it balances the load
    columns = [-(force(at + step * way, b) - force(at - step * way, b)) / (2 * step * load) for way in (1, 1j)]
    direct = np.array([[c.real for c in columns], [c.imag for c in columns]])
    found = matrices(coefficients(e, b))[0]
    assert found == pytest.approx(direct, abs=2e-3 * np.abs(direct).max())


def other_squeeze(e, b, cells=(256, 24)):
    """C_rr·c·ω/F with even steps and the mean film between nodes: as different from `reynolds` as the same equation
    allows.

    The film with and without a radial speed is solved for itself, free to rupture where it will behind the narrowest
    half."""
    n, m = cells
    theta, z = (np.arange(n) + 1) * 2 * math.pi / (n + 1), np.arange(m) / m
    dt, dz = theta[0], 1 / m
    h = 1 + e * np.cos(theta)
    left, right = ((1 + e * np.cos(theta + side * dt / 2)) ** 3 / dt**2 for side in (-1, 1))
    around = diags([left[1:], -(left + right), right[:-1]], [-1, 0, 1])
    across = (
        diags([np.ones(m - 1), -2 * np.ones(m), np.where(np.arange(m - 1) == 0, 2.0, 1.0)], [-1, 0, 1]) / (b * dz) ** 2
    )
    matrix = csr_matrix(kron(around, eye(m)) + kron(diags(h**3), across))
    weight = np.outer(np.cos(theta), np.where(z == 0, 0.5, 1.0)).ravel() * dt * dz
    held = np.repeat(theta < math.pi / 2, m)

    def solved(speed):
        source = np.repeat(-6 * e * np.sin(theta) + 12 * speed * np.cos(theta), m)
        active = np.repeat(theta < 1.1 * math.pi, m)
        for _ in range(60):
            keep = np.flatnonzero(active)
            pressure = np.zeros(n * m)
            pressure[keep] = spsolve(matrix[keep][:, keep].tocsc(), source[keep])
            push = matrix @ pressure - source
            after = held | np.where(active, pressure > 0, push > 1e-9)
            if (after == active).all():
                return pressure
            active = after
        raise AssertionError("no film")

    speed = 0.02 * e
    still = solved(0.0)
    sine = np.outer(np.sin(theta), np.where(z == 0, 0.5, 1.0)).ravel() * dt * dz
    return -(solved(speed) - solved(-speed)) @ weight / (2 * speed) / math.hypot(still @ weight, still @ sine)


@pytest.mark.parametrize("e, b", [(0.3, 0.5), (0.6, 0.46), (0.5, 1.0), (0.7, 1.7)])
def test_radial_damping_against_another_solution_of_the_squeezed_film(e, b):
    assert film_at(e, b).radial_damping == pytest.approx(other_squeeze(e, b), rel=0.01)


@pytest.mark.parametrize("e, b", [*STATES, (0.02, 0.1), (0.98, 2.0), (0.0437, 0.61), (0.951, 0.127)])
def test_the_stored_damping_is_the_direct_one(e, b):
    direct = 2 * math.pi * solve_film(e, b).sommerfeld * radial_damping(e, b, cells=(768, 64))
    assert film_at(e, b).radial_damping == pytest.approx(direct, rel=1e-3)


def test_damping_of_the_short_bearing_is_the_limit():
    """What is missing of a centred journal's is in proportion to the length."""
    rest = [1 - film_at(0.05, b).radial_damping / s.radial_damping(eps=0.05) for b in (0.1, 0.2)]
    assert 0 < rest[0] < 0.05
    assert rest[1] / rest[0] == pytest.approx(2, rel=0.2)


@pytest.mark.parametrize("e, b", STATES)
def test_slopes_are_those_of_the_table(e, b):
    step = 1e-5
    low, high = film_at(e - step, b), film_at(e + step, b)
    load, attitude = film_slopes(e, b)
    assert load == pytest.approx(math.log(low.sommerfeld / high.sommerfeld) / (2 * step), rel=1e-6)
    assert attitude == pytest.approx((high.attitude - low.attitude) / (2 * step), rel=1e-6)


def lund(k):
    values = vars(k)
    k_eq = d.equivalent_stiffness(**values)
    return k_eq, square(values)


def short_values(e):
    K, C = friswell(e)
    return dict(k_xx=K[0, 0], k_xy=K[0, 1], k_yx=K[1, 0], k_yy=K[1, 1], c_xx=C[0, 0], c_xy=C[0, 1], c_yy=C[1, 1])


def square(values):
    return d.whirl_ratio_squared(k_eq=d.equivalent_stiffness(**values), **values)


def test_a_centred_journal_whirls_at_half_speed():
    """Of the short bearing; exactly for ε → 0."""
    assert math.sqrt(square(short_values(0.001))) == pytest.approx(0.5, abs=1e-3)
    assert math.sqrt(square(vars(coefficients(0.02, 0.1)))) == pytest.approx(0.5, abs=0.03)


def test_a_shaft_with_a_deep_film_is_always_stable():
    """Short bearing: no threshold above ε = 0.756 (as generally published); l/d 0.5 and 1 between 0.75 and 0.85."""
    assert square(short_values(0.75)) > 0 > square(short_values(0.76))
    for b in (0.5, 1.0):
        assert square(vars(coefficients(0.75, b))) > 0 > square(vars(coefficients(0.85, b)))


def growth(K, C, m, frame):
    """Largest growth of m·(s² + 2·frame·J·s − frame²) + C·s + K; all over F and c·ω²."""
    J = np.array([[0.0, -1.0], [1.0, 0.0]])
    first = np.block([[np.zeros((2, 2)), np.eye(2)], [-K / m + frame**2 * np.eye(2), -C / m - 2 * frame * J]])
    return float(np.linalg.eigvals(first).real.max())


@pytest.mark.parametrize("e, b", STATES)
@pytest.mark.parametrize("frame", [0.0, -1.0, 0.3])
def test_at_the_critical_mass_the_motion_begins_to_grow(e, b, frame):
    k = coefficients(e, b)
    m = d.critical_mass_turning(**vars(k), F=1.0, g=2.0, omega=1.0, Omega=-frame)
    if math.isinf(m):
        assert all(growth(*matrices(k), mass, frame) < 0 for mass in np.geomspace(1e-2, 1e3, 60))
    else:
        assert growth(*matrices(k), m * (1 - 1e-4), frame) < 0 < growth(*matrices(k), m * (1 + 1e-4), frame)
        assert all(growth(*matrices(k), m * share, frame) < 0 for share in np.geomspace(1e-3, 0.999, 60))


@pytest.mark.parametrize("e, b", STATES)
def test_for_a_load_that_stands_the_threshold_is_lunds(e, b):
    k = coefficients(e, b)
    k_eq, square = lund(k)
    m = d.critical_mass_turning(**vars(k), F=3.0, g=2e-4, omega=50.0, Omega=0.0)
    if square > 0:
        assert m == pytest.approx(d.critical_mass(k_eq=k_eq, square=square, F=3.0, g=2e-4, omega=50.0), rel=1e-9)
    else:
        assert math.isinf(m)


# --- the step's own object
LOAD, CLEARANCE, SPEED = 1710.0, 140e-6, 2600 / 60


def made(e=0.74, b=0.46, load_speed_ratio=1.0, mass=None) -> Dynamics:
    hot = SimpleNamespace(eccentricity=e, attitude=film_at(e, b).attitude, clearance=CLEARANCE)
    speed = SPEED * abs(1 - 2 * load_speed_ratio)
    duty = SimpleNamespace(load=LOAD, effective_speed=speed, speed=SPEED)
    seat = SimpleNamespace(
        inputs=SimpleNamespace(load_speed_ratio=load_speed_ratio, bush_speed_ratio=0.0), grooves=None
    )
    return dynamics(hot, duty, seat, b, mass=mass)


def test_dimensions():
    found, k = made(), coefficients(0.74, 0.46)
    assert found.stiffness_yx == pytest.approx(k.k_yx * LOAD / (CLEARANCE / 2))
    assert found.damping_xy == found.damping_yx == pytest.approx(k.c_xy * LOAD / (CLEARANCE / 2 * 2 * math.pi * SPEED))
    assert found.whirl_ratio is None and found.threshold_speed is None and found.critical_mass > 100


def test_a_load_that_stands_has_lunds_values():
    found, k = made(e=0.5, load_speed_ratio=0.0, mass=4.0), lund(coefficients(0.5, 0.46))
    assert found.whirl_ratio == pytest.approx(math.sqrt(k[1]))
    assert found.threshold_speed == pytest.approx(SPEED * math.sqrt(found.critical_mass / 4.0))
    assert made(e=0.85, load_speed_ratio=0.0, mass=4.0).critical_mass is None


def test_the_orbit_solves_its_equation_in_time():
    """Integrated over the turn: m·a + C·v + K·u = R_0·(cos Ωt, sin Ωt), a with what the frame's own turning adds."""
    film, omega, m, R_0, phi = made(), 2 * math.pi * SPEED, 40.0, 50.0, 0.5
    found = orbit_of(film, R_0, omega, phi, m)
    K = np.array([[film.stiffness_xx, film.stiffness_xy], [film.stiffness_yx, film.stiffness_yy]])
    C = np.array([[film.damping_xx, film.damping_xy], [film.damping_yx, film.damping_yy]])
    J = np.array([[0.0, -1.0], [1.0, 0.0]])  # the load's frame turns at −Ω in these coordinates
    n = 64
    t = np.arange(n) / n * 2 * math.pi / omega
    # collocation with exact derivatives of the first harmonic
    system = np.block(
        [
            [K - 2 * m * omega**2 * np.eye(2), omega * C - 2 * m * omega**2 * J],
            [-omega * C + 2 * m * omega**2 * J, K - 2 * m * omega**2 * np.eye(2)],
        ]
    )
    p = np.linalg.solve(system, R_0 * np.array([1.0, 0.0, 0.0, 1.0]))  # u = p[:2]·cos Ωt + p[2:]·sin Ωt
    u = p[:2, None] * np.cos(omega * t) + p[2:, None] * np.sin(omega * t)
    v = omega * (p[2:, None] * np.cos(omega * t) - p[:2, None] * np.sin(omega * t))
    a = -(omega**2) * u - 2 * omega * J @ v - omega**2 * u
    assert m * a + C @ v + K @ u == pytest.approx(
        R_0 * np.array([np.cos(omega * t), np.sin(omega * t)]), abs=1e-6 * R_0
    )
    size = np.hypot(*u)
    assert found.amplitude == pytest.approx(size.max(), rel=5e-3) and found.minor == pytest.approx(size.min(), rel=2e-2)
    towards = u[0] * math.cos(phi) + u[1] * math.sin(phi)
    assert found.film_loss == pytest.approx(towards.max(), rel=5e-3)


def test_what_stands_still_feels_no_inertia():
    """A journal on a film that is the same all round follows the standing force: in space it rests, whatever its
    mass."""
    same = dict(
        stiffness_xx=1e8,
        stiffness_xy=3e7,
        stiffness_yx=-3e7,
        stiffness_yy=1e8,
        damping_xx=2e5,
        damping_xy=0.0,
        damping_yx=0.0,
        damping_yy=2e5,
    )
    light, heavy = (orbit_of(Dynamics(**same), 100.0, 272.0, 0.7, m) for m in (0.0, 100.0))
    assert heavy.amplitude == pytest.approx(light.amplitude, rel=1e-12)
    assert light.amplitude == pytest.approx(light.minor, rel=1e-12) and light.film_loss == pytest.approx(
        light.amplitude, rel=1e-12
    )
    assert light.amplitude == pytest.approx(100.0 / math.hypot(1e8, 272.0 * 2e5 - 3e7), rel=1e-12)


@given(st.floats(1.0, 1e3), st.floats(0.1, 0.95), st.floats(0.15, 1.5))
def test_the_orbit_grows_with_the_force_and_holds_the_film_loss(R_0, e, b):
    film, phi = made(e, b), film_at(e, b).attitude
    one, two = (orbit_of(film, force, 272.0, phi) for force in (R_0, 2 * R_0))
    assert two.amplitude == pytest.approx(2 * one.amplitude) and two.film_loss == pytest.approx(2 * one.film_loss)
    assert one.minor * (1 - 1e-9) <= one.film_loss <= one.amplitude * (1 + 1e-9)


def test_many_at_once():
    e, b = np.array([0.2, 0.6, 0.9]), 0.46
    many = coefficients(e, b)
    for i, one in enumerate(coefficients(float(x), b) for x in e):
        assert [float(v[i]) for v in vars(many).values()] == pytest.approx(list(vars(one).values()), rel=1e-12)


def test_outside_the_table():
    with pytest.raises(FilmRangeError):
        coefficients(0.99, 0.5)
    assert math.isnan(film_slopes(0.99, 0.5, outside="nan")[0])
