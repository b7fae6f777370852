# SPDX-License-Identifier: Apache-2.0
"""Ratings, loads and lives where no given value reaches: by hand, by integrals, by the tables of the standards."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from calc.bearings.rolling import hertz, load, zone
from calc.bearings.rolling.contact import (
    Springs,
    contact_constant,
    displacement,
    largest_load,
    load_zone,
    pass_frequency,
    pressure_of,
    reach,
)
from calc.bearings.rolling.contamination import CLASSES, WORDS
from calc.bearings.rolling.geometry import alike, gamma_of, inside_of, stacked
from calc.bearings.rolling.life import (
    contamination,
    counted_ratio,
    fatigue_share,
    life_by_load,
    life_factor,
    life_of_duty,
    lives,
    needed_viscosity,
    needed_viscosity_of,
    needed_viscosity_slow,
    reliability_factor,
    system_life,
    with_clearance,
)
from calc.bearings.rolling.ratings import (
    Ratings,
    computed,
    factor_of_balls,
    factor_of_rollers,
    fatigue_limit,
    hardness_factor,
)
from calc.bearings.rolling.ratings import race_ratio_of_balls as X_ball
from calc.bearings.rolling.ratings import race_ratio_of_rollers as X_roller
from calc.bearings.rolling.sizes import every_size, own_size, size_of
from calc.countershaft import carried
from calc.countershaft.bending.condensed import Condensed
from calc.sheet.expression import line_text
from calc.sheet.value import trace

RPM, HOUR = 1 / 60, 3600.0


def rated(designation, **known):
    size = size_of(designation)
    return size, inside_of(size), computed(inside_of(size), size.usual.rating, **known)


# --- ratings


@pytest.mark.parametrize("gamma, f_c", [(0.05, 46.7), (0.1, 55.5), (0.2, 59.9), (0.3, 56.0), (0.4, 48.4)])
def test_f_c_of_balls_is_that_of_the_standard(gamma, f_c):
    """ISO 281, table 2, grooves 0.52: from memory."""
    X = X_ball(k_X=1.04, gamma=gamma, f_i=0.52, f_e=0.52)
    assert factor_of_balls(f_i=0.52, gamma=gamma, X=X) == pytest.approx(f_c, rel=1.5e-3)


@pytest.mark.parametrize("gamma, f_c", [(0.01, 52.1), (0.05, 74.1), (0.1, 84.2), (0.2, 88.7), (0.3, 83.8)])
def test_f_c_of_rollers_is_that_of_the_standard(gamma, f_c):
    """ISO 281, table 7: from memory."""
    assert factor_of_rollers(gamma=gamma, X=X_roller(k_X=1.04, gamma=gamma)) == pytest.approx(f_c, rel=1.5e-3)


def test_a_soft_raceway_on_the_shaft_carries_less():
    assert [hardness_factor(HV=HV) for HV in (335.0, 670.0, 700.0)] == [0.25, 1.0, 1.0]
    for name in ("HK2520", "RNA4905", "K25x30x20"):
        _, inside, hard = rated(name, HV=700.0)
        _, _, soft = rated(name, HV=600.0)
        for key in ("dynamic", "static", "fatigue"):
            assert getattr(soft, key) / getattr(hard, key) == pytest.approx((600 / 670) ** 2)
        assert hard.dynamic == computed(inside, size_of(name).usual.rating).dynamic


def test_a_needle_bearing_carries_the_same_with_and_without_inner_ring():
    assert rated("RNA4905")[2].dynamic == rated("NA4905")[2].dynamic
    assert load.ring_factor_of(load.races_of(rated("RNA4905")[1])) == load.ring_factor_of(
        load.races_of(rated("NA4905")[1])
    )


def test_a_roller_bearing_of_ones_own():
    size = own_size("roller", 0.025, 0.052, 0.015)
    inside = inside_of(size, count=13.0, diameter=7.425e-3, length=8.1e-3, pitch=38.962e-3)
    ratings, same = computed(inside, size.usual.rating), rated("NU205")[2]
    assert ratings.dynamic == pytest.approx(same.dynamic) and ratings.static == pytest.approx(same.static)
    assert inside_of(size) is None and load.ring_factor_of(None) == 1.0


def test_large_bearings_have_a_lower_fatigue_limit():
    ball = inside_of(own_size("ball", 0.1, 0.18, 0.034), count=9.0, diameter=0.0254, pitch=0.14)
    ratings = computed(ball, 1.3)
    assert ratings.fatigue == pytest.approx(ratings.static / 22 * (100 / 140) ** 0.5)
    roller = inside_of(own_size("roller", 0.1, 0.18, 0.034), count=16.0, diameter=0.02, length=0.02, pitch=0.14)
    ratings = computed(roller, 1.1)
    assert ratings.fatigue == pytest.approx(ratings.static / 8.2 * (100 / 140) ** 0.3)
    assert rated("6205")[2].fatigue == pytest.approx(rated("6205")[2].static / 22)


def test_balls_beyond_an_inch_gain_less_and_join_there():
    size = own_size("ball", 0.1, 0.24, 0.05)
    smaller, larger = (
        computed(inside_of(size, count=8.0, diameter=D, pitch=D / 0.2), 1.3).dynamic for D in (0.025399, 0.025401)
    )
    assert larger == pytest.approx(smaller, rel=2e-4)
    here, there = (computed(inside_of(size, count=8.0, diameter=D, pitch=D / 0.2), 1.3).dynamic for D in (0.02, 0.03))
    assert there / here == pytest.approx(
        1.27**1.8 * (30 / 25.4) ** 1.4, rel=1e-3
    )  # by 1.8 to an inch, by 1.4 from there
    half, whole = (computed(inside_of(size, count=8.0, diameter=D, pitch=D / 0.2), 1.3).dynamic for D in (0.03, 0.06))
    assert whole / half == pytest.approx(2**1.4)


def test_closer_grooves_do_not_raise_a_rating_and_wider_ones_lower_it():
    size = size_of("6205")
    usual = computed(inside_of(size), 1.3)
    closer, wider = (computed(inside_of(size, groove_inner=f, groove_outer=f), 1.3) for f in (0.51, 0.56))
    assert closer.dynamic == usual.dynamic and closer.static == usual.static
    assert wider.dynamic < usual.dynamic and wider.static < usual.static


# --- Hertz


def test_elliptic_integrals_are_those_of_tables():
    x = np.array([1.0, 1.2, 3.0, 12.0, 80.0])
    first, second = hertz.elliptic(x)
    assert first == pytest.approx(ellipk(1 - x**-2), rel=1e-12) and second == pytest.approx(
        ellipe(1 - x**-2), rel=1e-12
    )


@pytest.mark.parametrize("x", [1.0005, 1.3, 4.0, 9.0, 50.0])
def test_the_axes_of_the_ellipse_solve_their_equation(x):
    E, K = ellipe(1 - x**-2), ellipk(1 - x**-2)
    assert hertz.axis_ratio(t=((x**2 + 1) * E - 2 * K) / ((x**2 - 1) * E)) == pytest.approx(x, rel=1e-5)


def test_two_equal_balls_touch_in_a_circle():
    """Hertz in closed form: a³ = 3·Q·R/(4·E*), E* = E'/2, here of curvatures 1/R in both directions."""
    S, Q, E_r = 2 * 100.0, 500.0, hertz.PLANE
    a = hertz.half_axis(E_2=math.pi / 2, Q=Q, x=1.0, E_r=E_r, S=S)
    assert a == pytest.approx((3 * Q / 100.0 / (4 * E_r / 2)) ** (1 / 3))
    assert hertz.ellipse_pressure(Q=Q, x=1.0, b=a) == pytest.approx(1.5 * Q / (math.pi * a**2))
    assert hertz.approach(E_1=math.pi / 2, S=S, E_2=math.pi / 2, Q=Q, x=1.0, E_r=E_r) == pytest.approx(a**2 * 100.0)


def test_the_load_at_a_pressure_makes_that_pressure():
    inside = inside_of(size_of("6205"))
    contact = hertz.BallContact(inside.diameter, gamma_of(inside), 0.52, inner=True)
    assert contact.pressure(contact.load(4200e6)) == pytest.approx(4200e6)


def test_shear_is_largest_below_a_line_alone():
    _, depth = pressure_of(inside_of(size_of("NU205")), 500.0)
    assert 0 < depth < 1e-3 and pressure_of(inside_of(size_of("6205")), 500.0)[1] is None


def test_shear_is_largest_at_its_depth():
    """Hertz's stresses on the axis of a line: along and across the surface, over the largest pressure."""
    z = np.linspace(0.01, 3.0, 3000)
    along, across = (1 + 2 * z**2) / np.sqrt(1 + z**2) - 2 * z, 1 / np.sqrt(1 + z**2)
    assert hertz.shear_depth(b=1.0) == pytest.approx(z[np.argmax(np.abs(along - across))], abs=2e-3)


# --- the loaded zone


@pytest.mark.parametrize("kind", ["ball", "roller"])
@pytest.mark.parametrize("eps", [0.003, 0.05, 0.3, 0.5, 0.8, 1.0, 1.3, 6.0, 300.0])
def test_zone_integrals_are_those_of_quadrature(kind, eps):
    n, exponents = zone.EXPONENTS[kind].n, zone.EXPONENTS[kind]
    psi = math.acos(max(1 - 2 * eps, -1))

    def mean(f):
        return quad(f, 0, psi, epsabs=1e-13, epsrel=1e-10, limit=200)[0] / math.pi

    def q(phi):
        return max(1 - (1 - math.cos(phi)) / (2 * eps), 0.0) ** n

    assert zone.radial_integral(eps=eps, elements=kind) == pytest.approx(mean(lambda p: q(p) * math.cos(p)), rel=1e-4)
    for integral, w in ((zone.turning_integral, exponents.turns), (zone.standing_integral, exponents.stands)):
        assert integral(eps=eps, elements=kind) == pytest.approx(mean(lambda p: q(p) ** w) ** (1 / w), rel=1e-4)  # noqa: B023


def test_zone_integrals_are_those_of_harris():
    """Without clearance; Harris' table 7.1 and 7.4 as remembered."""
    for kind, J in (("ball", (0.2288, 0.5625, 0.5874)), ("roller", (0.2453, 0.6495, 0.6744))):
        integrals = (zone.radial_integral, zone.turning_integral, zone.standing_integral)
        assert [f(eps=0.5, elements=kind) for f in integrals] == pytest.approx(J, rel=3e-3)


def test_a_tiny_zone_narrows_by_the_root_of_its_reach():
    for kind in ("ball", "roller"):
        assert zone.radial_integral(eps=4e-6, elements=kind) == pytest.approx(
            2 * zone.radial_integral(eps=1e-6, elements=kind)
        )
        assert zone.radial_integral(eps=1e5, elements=kind) == pytest.approx(
            10 * zone.radial_integral(eps=1e6, elements=kind)
        )


def test_the_zone_in_degrees():
    assert [math.degrees(load_zone(eps=eps)) for eps in (0.25, 0.5, 1.0, 7.0)] == pytest.approx([120, 180, 360, 360])


@pytest.mark.parametrize("name, clearance", [("NU205", 0.0), ("NU205", 30e-6), ("6205", 10e-6), ("HK2520", 50e-6), ("6205", -5e-6)])  # fmt: skip
def test_the_elements_one_by_one_hold_the_load(name, clearance):
    """Elements at all their places, from one to the next: the mean of what they push back."""
    inside = inside_of(size_of(name))
    F, n, K = 3000.0, zone.EXPONENTS[inside.elements].n, contact_constant(inside)
    springs = Springs(inside.elements, inside.count, K, clearance)
    delta = springs.displacement(F)
    phi = 2 * np.pi * (np.arange(int(inside.count)) + np.linspace(0, 1, 200, endpoint=False)[:, None]) / inside.count
    pushed = np.maximum(delta * np.cos(phi) - clearance / 2, 0.0) / 1e-3
    assert np.mean(np.sum(K * pushed**n * np.cos(phi), axis=1)) == pytest.approx(F, rel=1e-4)
    Q = largest_load(K_1=K, delta=delta, s=clearance, n_c=n)
    assert Q == pytest.approx(K * (pushed.max()) ** n, rel=1e-3)


def test_where_the_zone_is_narrow_one_element_carries_all():
    """NU205 under 50 N with 41 µm: by the integral alone one element would carry about 1.44 F."""
    inside = inside_of(size_of("NU205"))
    Z, K, s, n = inside.count, contact_constant(inside), 41e-6, 10 / 9
    springs = Springs("roller", Z, K, s)
    delta = springs.displacement(50.0)
    assert springs.alone(delta) and not springs.alone(springs.displacement(1700.0))
    assert largest_load(K_1=K, delta=delta, s=s, n_c=n) == pytest.approx(50.0, rel=1e-9)
    assert delta == pytest.approx(s / 2 + 1e-3 * (50 / K) ** (1 / n), rel=1e-9)

    def missing(delta):
        J_r = zone.radial_integral(eps=reach(s=s, delta=delta), elements="roller")
        return Z * largest_load(K_1=K, delta=delta, s=s, n_c=n) * J_r - 50

    alone = brentq(missing, s / 2 * (1 + 1e-9), 2 * s)
    assert largest_load(K_1=K, delta=alone, s=s, n_c=n) / 50 == pytest.approx(1.44, abs=0.02)


def test_the_narrowest_zone_is_one_elements():
    for kind, Z in (("ball", 9.0), ("roller", 25.0)):
        eps = zone.narrowest(Z=Z, elements=kind)
        assert 0 < eps < 0.5 and zone.radial_integral(eps=eps, elements=kind) * Z == pytest.approx(1.0, rel=1e-6)
    assert zone.narrowest(Z=3.0, elements="ball") == pytest.approx(0.5, rel=0.02)


def test_pass_frequency_is_that_of_the_turning_load():
    """The cage turns at n·(1 − γ)/2, the load with the shaft: it meets Z·(n − n_cage) elements a second."""
    inside, n = inside_of(size_of("6205")), 43.0
    gamma = gamma_of(inside)
    assert pass_frequency(Z=inside.count, n=-n, gamma=gamma) == pytest.approx(inside.count * (n - n * (1 - gamma) / 2))


# --- loads


def test_the_mean_load_is_the_integral_over_a_turn():
    for F_1, F_2, p in ((1500.0, 400.0, 3.0), (300.0, 900.0, 10 / 3), (700.0, 690.0, 10 / 3)):
        mean = quad(lambda a: abs(F_1 + F_2 * complex(math.cos(a), math.sin(a))) ** p, 0, math.pi)[0] / math.pi  # noqa: B023
        assert load.mean_of(F_1, F_2, p) == pytest.approx(mean ** (1 / p), rel=1e-8)
    assert load.friction_mean_of(1.0, 1.0) == pytest.approx(4 / math.pi, rel=1e-7)


def test_the_ring_factor_counts_where_the_larger_load_turns():
    races = load.races_of(inside_of(size_of("6205")))
    V = load.ring_factor_of(races)
    P = load.radial_of(races, np.array([1000.0, 200.0]), np.array([200.0, 1000.0]), 3.0)
    assert P[0] / P[1] == pytest.approx(V) and 1.02 < V < 1.04
    assert load.radial_of(races, 200.0, 1000.0, 3.0) == pytest.approx(P[1])
    assert load.radial_of(None, 1000.0, 200.0, 3.0) == pytest.approx(P[1])


def test_p_ref_returns_the_load():
    """A load that stands in space, without clearance: what ISO 281 rates, to what the standard itself is rounded."""
    for name in ("6205", "6312", "NU205", "HK2520"):
        assert load.races_of(inside_of(size_of(name))).share(0.5, stands=False) == pytest.approx(1, abs=5e-3)


def test_thrust_on_a_ball_bearing_within_the_table():
    size, _, ratings = rated("6205")
    F_a = 0.689 * ratings.static / ratings.f_0
    assert load.thrust_factor(u=0.689) == pytest.approx(1.71) and load.thrust_threshold(u=0.689) == pytest.approx(0.26)
    P = load.equivalent(size, ratings, 1000.0, F_a)
    assert F_a / 1000 > 0.26 and P == pytest.approx(0.56 * 1000 + 1.71 * F_a)
    half = math.exp((math.log(0.345) + math.log(0.689)) / 2)
    assert load.thrust_factor(u=half) == pytest.approx((1.99 + 1.71) / 2)
    assert load.thrust_factor(u=0.01) == 2.3 and load.thrust_factor(u=50.0) == 1.0 and load.thrust_factor(u=0.0) == 2.3
    assert load.equivalent(size, ratings, 1000.0, 0.0) == 1000.0 == load.equivalent(size, ratings, 1000.0, 100.0)
    without = Ratings(ratings.dynamic, ratings.static, ratings.fatigue)
    assert load.equivalent(size, without, 1000.0, F_a) == pytest.approx(P, rel=0.01)  # f_0 14 for 13.8


@pytest.mark.parametrize("name, e, Y", [("NJ205", 0.2, 0.6), ("NJ1005", 0.2, 0.6), ("NJ2205", 0.3, 0.4), ("NJ2305", 0.3, 0.4)])  # fmt: skip
def test_thrust_on_a_flanged_roller_bearing(name, e, Y):
    size, _, ratings = rated(name)
    P = load.equivalent(size, ratings, 1000.0, np.array([0.0, 1000 * e, 1000 * e + 50]))
    assert P == pytest.approx([1000.0, 1000.0, 920.0 + Y * (1000 * e + 50)])
    assert load.equivalent(size, ratings, 1000.0, 450.0) == pytest.approx(920 + Y * 450)
    assert load.equivalent(size_of("NU205"), ratings, 1000.0, 450.0) == 1000.0


# --- life


def test_the_viscosity_needed_changes_its_law_at_1000_rpm():
    slow, quick = 999 * RPM, 1001 * RPM
    assert needed_viscosity_of(0.04, slow) == needed_viscosity_slow(n=slow, D_pw=0.04)
    assert needed_viscosity_of(0.04, quick) == needed_viscosity(n=quick, D_pw=0.04)
    both = needed_viscosity_of(np.array([[0.04], [0.06]]), np.array([slow, quick]))
    assert both.shape == (2, 2) and both[0, 0] == needed_viscosity_of(0.04, slow)
    assert needed_viscosity_of(0.0385, 2600 * RPM) == pytest.approx(4500 / math.sqrt(2600 * 38.5) * 1e-6)


def test_words_of_cleanliness_by_size():
    assert [contamination(word, 0.05, 1.0) for word in WORDS] == [0.7, 0.55, 0.4, 0.2, 0.05, 0.0]
    assert [contamination(word, 0.1, 1.0) for word in WORDS] == [0.85, 0.7, 0.5, 0.3, 0.05, 0.0]
    for word in CLASSES:
        assert 0 <= contamination(word, 0.05, 0.1) <= contamination(word, 0.05, 4.0) <= 1
    many = contamination("typical", np.array([[0.05], [0.2]]), np.array([0.3, 1.0, 3.0]))
    assert many.tolist() == [[0.2] * 3, [0.3] * 3]
    assert contamination("-/19/16", 0.01, 0.1) == 0.0  # not below 0


def test_the_life_factor_is_continuous_and_has_its_ends():
    for kind in ("ball", "roller"):
        for at in (0.4, 1.0):
            below, above = (life_factor(kind, at + d, 0.1) for d in (-1e-9, 1e-9))
            assert below == pytest.approx(above, rel=4e-3)
        assert life_factor(kind, 2.0, 0.0) == pytest.approx(0.1)
        assert life_factor(kind, 4.0, 1e6) == pytest.approx(50) and life_factor(kind, 4.0, 5.0) == pytest.approx(50)
        assert life_factor(kind, 0.1, 1e-9) == pytest.approx(0.1, rel=1e-2)
    assert counted_ratio(kappa=0.02) == 0.1 and counted_ratio(kappa=9.0) == 4.0


def test_reliability_by_table_and_between():
    assert [reliability_factor(R=R) for R in (0.9, 0.95, 0.99, 0.999)] == pytest.approx([1.0, 0.64, 0.25, 0.093])
    assert reliability_factor(R=0.925) == pytest.approx(0.82)
    _, inside, ratings = rated("NU205")
    usual, surer = (lives("roller", inside.pitch, ratings, 1700.0, 40.0, 1e-5, "typical", a_1) for a_1 in (1.0, 0.25))
    assert surer.modified == usual.modified / 4 and surer.basic == usual.basic


def test_a_bearing_without_load_divides_by_nothing():
    _, inside, ratings = rated("6205")
    life = lives("ball", inside.pitch, ratings, 0.0, 40.0, 1e-5, "typical")
    assert life.factor == pytest.approx(50) and life.basic > 1e20
    assert fatigue_share(e_C=0.2, C_u=100.0, P=0.0) > 1 and load.static_safety(C_0=1e4, P_0=0.0) > 1e9
    assert load.mean_of(0.0, 0.0, 3.0) == 0.0 and Springs("ball", 9.0, 6e6, 0.0).displacement(0.0) > 0
    P = np.array([0.0, 1500.0])
    rows = lives("ball", inside.pitch, ratings, P, 40.0, 1e-5, "typical")
    half = life_of_duty(w=np.array([0.5, 0.5]), L_i=rows.basic)
    assert half == pytest.approx(2 * life_by_load(n=40.0, C=ratings.dynamic, P=1500.0, p=3.0))


def test_clearance_shortens_the_life_and_light_preload_hardly_lengthens_it():
    _, inside, _ = rated("NU205")
    races, K = load.races_of(inside), contact_constant(inside)
    P = [
        with_clearance(races, Springs("roller", inside.count, K, s * 1e-6), 1000.0, 1700.0, True)
        for s in (-3, 0, 20, 60)
    ]
    assert P[1] == pytest.approx(1000.0, rel=1e-6) and P[0] < P[1] < P[2] < P[3]
    standing = with_clearance(races, Springs("roller", inside.count, K, 20e-6), 1000.0, 1700.0, False)
    assert standing != P[2] and standing == pytest.approx(P[2], rel=0.05)
    rows = with_clearance(races, Springs("roller", inside.count, K, 20e-6), 1000.0, 1700.0, np.array([True, False]))
    assert rows == pytest.approx([P[2], standing])


def test_light_preload_spreads_the_load_best():
    eps = np.geomspace(0.5, 3.0, 500)
    for name, least in (("6305", 0.9623), ("NU205", 0.9678)):
        shares = load.races_of(inside_of(size_of(name))).over_reference(eps, True, True)
        assert shares.min() == pytest.approx(least, abs=1e-3) and 0.65 < eps[shares.argmin()] < 0.8


# --- as a support of a shaft, as arrays, in a report


def test_a_shaft_finds_its_place_on_rolling_bearings():
    """A rigid shaft on a ball and a roller bearing with play, and on one that is preloaded."""
    zero = np.zeros(3, complex)
    K_c = 1e6 * np.array([[1.0, -2.0, 1.0], [-2.0, 4.0, -2.0], [1.0, -2.0, 1.0]])  # stiff against bending alone
    f_c = np.array([900 + 100j, 300 - 50j, 700 + 0j])
    shaft = Condensed(np.array([-0.1, 0.0, 0.1]), K_c, f_c, zero, np.zeros((3, 3)), np.zeros(0), zero, np.zeros((3, 3)))
    laws = []
    for name, s in (("6205", 12e-6), ("NU205", 30e-6), ("6205", -4e-6)):
        inside = inside_of(size_of(name))
        laws.append(Springs(inside.elements, inside.count, contact_constant(inside), s))
    on = carried(shaft, laws, ["a", "b", "c"])
    assert abs(f_c - K_c @ on.x - on.load).max() < 1e-6
    assert sum(on.load) == pytest.approx(sum(f_c), rel=1e-9)
    for law, x, F in zip(laws, on.x, on.load):
        assert abs(F) == pytest.approx(law.hold(abs(x)).force, rel=1e-9, abs=1e-6)
    assert "play −4 µm" in laws[2].said("c", 0.0)


def test_many_bearings_and_rows_at_once_are_the_same_as_each_alone():
    n = np.array([900.0, 1500.0, 2600.0]) * RPM
    F_1, F_2 = 1700 * (n / n[-1]) ** 2, np.full(3, 150.0)
    for group in alike(every_size()):
        columns = stacked(group)
        many = outcome(columns, n, F_1, F_2)
        for row in (0, len(group) // 2, len(group) - 1):
            for together, alone in zip(many, outcome(group[row], n, F_1, F_2)):
                assert np.asarray(together)[row] == pytest.approx(alone, rel=1e-9)
    size = size_of("6205")
    rows = outcome(size, n, F_1, F_2)[0]
    assert [outcome(size, n[k], F_1[k], F_2[k])[0] for k in range(3)] == pytest.approx(list(rows), rel=1e-9)


def outcome(size, n, F_1, F_2):
    """Lives, with clearance too, of each row, and the life of the duty."""
    inside = inside_of(size)
    ratings, races, p = computed(inside, size.usual.rating), load.races_of(inside), zone.EXPONENTS[size.elements].p
    P = load.equivalent(size, ratings, load.radial_of(races, F_1, F_2, p), 0.0)
    springs = Springs(size.elements, inside.count, contact_constant(inside), 20e-6)
    P_s = with_clearance(races, springs, P, load.mean_of(F_1, F_2, p), F_1 >= F_2)
    life, reference = (lives(size.elements, inside.pitch, ratings, x, n, 1e-5, "-/17/14") for x in (P, P_s))
    return life.modified, reference.modified, life_of_duty(w=np.full(np.shape(n), 0.25), L_i=life.modified)


def test_a_trace_of_one_bearing_shows_every_line():
    with trace() as lines:
        outcome(size_of("6205"), 40.0, 1700.0, 100.0)
        outcome(size_of("NJ205"), 10.0, 100.0, 200.0)
        displacement(F=100.0, Z=9.0, K_1=6e6, s=1e-5, elements="ball")
    for line in lines:
        assert math.isfinite(line.value) and all(line_text(line)), line.formula.__name__
    symbols = {line.formula.symbol for line in lines}
    assert {"C_r", "C_0", "V", "F_m", "P", "κ", "a_ISO", "L_10", "δ_r", "J_r"} <= symbols


def test_the_fatigue_limit_follows_the_static_rating_that_rules():
    _, inside, _ = rated("6205")
    assert fatigue_limit(inside.elements, 7800.0, inside.pitch) == pytest.approx(7800 / 22)


def test_system_life_of_many():
    assert system_life(L=[1000.0], e=[10 / 9]) == pytest.approx(1000.0)
    two = system_life(L=np.array([[1000.0, 1000.0], [1000.0, 1e12]]), e=np.array([9 / 8, 9 / 8]))
    assert two == pytest.approx([1000 * 2 ** (-8 / 9), 1000.0], rel=1e-6)
