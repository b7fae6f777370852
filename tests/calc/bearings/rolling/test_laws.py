# SPDX-License-Identifier: Apache-2.0
"""What holds of any rolling bearing under any load; the list of all such laws is docs/laws.md."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.bearings.rolling.contact import Springs, contact_constant, largest_load, reach
from calc.bearings.rolling.geometry import inside_of
from calc.bearings.rolling.life import contamination, life_by_load, life_factor, life_of_duty, lives, system_life
from calc.bearings.rolling.load import friction_mean_of, mean_of, races_of, radial_of, ring_factor_of
from calc.bearings.rolling.ratings import computed
from calc.bearings.rolling.sizes import every_size
from calc.bearings.rolling.zone import EXPONENTS, radial_integral

SIZES = every_size()
sizes, kinds = st.sampled_from(SIZES), st.sampled_from(["ball", "roller"])
loads, small = st.floats(10.0, 2e4), st.floats(0.0, 1.0)
clearances = st.floats(-20e-6, 80e-6)
quick = settings(max_examples=40, deadline=None)


def springs_at(size, s=0.0):
    inside = inside_of(size)
    return Springs(inside.elements, inside.count, contact_constant(inside), s)


@quick
@given(F=loads, xi=small, p=st.sampled_from([1.0, 2.0, 3.0, 10 / 3]))
def test_the_mean_of_a_turning_and_a_standing_load_does_not_ask_which_turns(F, xi, p):
    """It lies between the larger and the sum of both, grows with the power, and is √(F_1² + F_2²) for the power 2."""
    F_m = mean_of(F, xi * F, p)
    assert F_m == mean_of(xi * F, F, p) and F * (1 - 1e-12) <= F_m <= F * (1 + xi) * (1 + 1e-12)
    assert friction_mean_of(F, xi * F) <= mean_of(F, xi * F, 2.0) * (1 + 1e-8) <= mean_of(F, xi * F, 3.0) * (1 + 2e-8)
    assert mean_of(F, xi * F, 2.0) == pytest.approx(math.hypot(F, xi * F), rel=1e-12)
    assert mean_of(F, 0.0, p) == friction_mean_of(F, 0.0) == F
    assert mean_of(3 * F, 3 * xi * F, p) == pytest.approx(3 * F_m, rel=1e-12)


@quick
@given(size=sizes, F=loads, xi=small)
def test_a_load_that_stands_alone_is_that_of_the_standard(size, F, xi):
    races, p = races_of(inside_of(size)), EXPONENTS[size.elements].p
    V = ring_factor_of(races)
    assert 1.0 < V < 1.05
    assert radial_of(races, 0.0, F, p) == F and radial_of(races, F, 0.0, p) == pytest.approx(V * F)
    assume(xi < 1)
    assert radial_of(races, xi * F, F, p) * V == pytest.approx(radial_of(races, F, xi * F, p))


@quick
@given(size=sizes, F=loads, k=st.floats(1.01, 4.0))
def test_a_load_k_times_as_large_divides_the_life_by_its_power(size, F, k):
    p = EXPONENTS[size.elements].p
    one, two = (life_by_load(n=40.0, C=3e4, P=P, p=p) for P in (F, k * F))
    assert one / two == pytest.approx(k**p)
    assert one / life_by_load(n=80.0, C=3e4, P=F, p=p) == pytest.approx(2.0)


@quick
@given(size=sizes, F=loads, s=clearances)
def test_a_bearing_carries_what_it_was_displaced_for(size, F, s):
    springs = springs_at(size, s)
    delta = springs.displacement(F)
    held, h = springs.hold(delta), 1e-4 * (delta - max(s, 0.0) / 2)
    assert held.force == pytest.approx(F, rel=1e-8) and held.secant == pytest.approx(F / delta, rel=1e-8)
    assert springs.begin(F) == delta
    assert springs.softer(0.5).hold(delta).force == pytest.approx(F / 2, rel=1e-8)
    if springs.alone(delta) == springs.alone(delta + h) == springs.alone(delta - h):
        around = (springs.hold(delta + h).force - springs.hold(delta - h).force) / (2 * h)
        assert held.slope == pytest.approx(around, rel=1e-2)


@quick
@given(size=sizes, s=clearances, F=loads, more=st.floats(1.01, 3.0))
def test_a_bearing_gives_way_more_under_more_load_and_stiffens(size, s, F, more):
    springs = springs_at(size, s)
    one, two = springs.displacement(F), springs.displacement(more * F)
    assert two > one and springs.hold(two).force > springs.hold(one).force
    wider = springs_at(size, s + 5e-6)
    assert wider.displacement(F) > one


@quick
@given(size=sizes, F=loads)
def test_without_clearance_the_most_loaded_element_carries_as_stribeck_says(size, F):
    springs, n = springs_at(size), EXPONENTS[size.elements].n
    delta = springs.displacement(F)
    share = largest_load(K_1=springs.contact, delta=delta, s=0.0, n_c=n) * springs.count / F
    assert share == pytest.approx(4.37 if size.elements == "ball" else 4.08, rel=2e-3)
    assert springs.displacement(2 * F) / delta == pytest.approx(2 ** (1 / n), rel=1e-8)
    assert springs.hold(delta).slope == pytest.approx(n * F / delta, rel=1e-6)


@quick
@given(size=sizes, s=st.floats(1e-6, 80e-6), F=loads)
def test_clearance_loads_one_element_more_but_never_with_more_than_all(size, s, F):
    springs, n = springs_at(size, s), EXPONENTS[size.elements].n
    Q = largest_load(K_1=springs.contact, delta=springs.displacement(F), s=s, n_c=n)
    without = springs_at(size)
    assert F * (1 + 1e-8) >= Q > largest_load(K_1=springs.contact, delta=without.displacement(F), s=0.0, n_c=n)
    assert 0 < reach(s=s, delta=springs.displacement(F)) < 0.5


@quick
@given(size=sizes, s=st.floats(-20e-6, -1e-6))
def test_a_preloaded_bearing_is_a_spring_about_its_middle(size, s):
    """Σ cos² over the elements is Z/2, each with the stiffness of its preload."""
    springs, n = springs_at(size, s), EXPONENTS[size.elements].n
    k = springs.count / 2 * n * springs.contact / 1e-3 * (-s / 2e-3) ** (n - 1)
    held = springs.hold(0.0)
    assert held.force == 0.0 and held.slope == pytest.approx(k, rel=5e-4) == held.secant
    assert springs.hold(-s / 2e4).force == pytest.approx(k * -s / 2e4, rel=1e-3)


@quick
@given(size=sizes, eps=st.floats(1e-4, 0.4999), stands=st.booleans())
def test_a_narrower_zone_loads_the_races_more(size, eps, stands):
    races = races_of(inside_of(size))
    one, two = (races.over_reference(e, stands) for e in (eps, 0.9 * eps))
    assert two >= one * (1 - 1e-6) and one > 1 - 1e-6
    assert races.over_reference(0.5, stands) == pytest.approx(1.0)
    kind = size.elements
    assert radial_integral(eps=eps, elements=kind) < radial_integral(eps=0.5, elements=kind)


@quick
@given(kind=kinds, k=st.floats(0.1, 4.0), X=st.floats(1e-4, 3.0), more=st.floats(1.0, 2.0))
def test_cleaner_and_thicker_oil_and_less_load_lengthen_the_life(kind, k, X, more):
    a = life_factor(kind, k, X)
    assert 0.0999 <= a <= 50.0001
    assert life_factor(kind, k, more * X) >= a * (1 - 1e-12)
    assert life_factor(kind, min(k * more, 4.0), X) >= a * (1 - 4e-3)  # ISO's bands join to 0.3 %
    assert life_factor(kind, k, 0.0) == pytest.approx(0.1)
    dirty, clean = (contamination(word, 0.05, k) for word in ("-/19/16", "-/13/10"))
    assert 0 <= dirty <= clean <= 1


@quick
@given(lives_of=st.lists(st.floats(10.0, 1e6), min_size=1, max_size=8), kind=kinds)
def test_all_bearings_together_live_less_than_the_first_of_them(lives_of, kind):
    e = EXPONENTS[kind].weibull
    L = system_life(L=lives_of, e=[e] * len(lives_of))
    assert L <= min(lives_of) * (1 + 1e-9)
    assert sum((L / one) ** e for one in lives_of) == pytest.approx(1.0, rel=1e-9)
    assert system_life(L=[700.0] * 2, e=[e] * 2) == pytest.approx(700 * 2 ** (-1 / e), rel=1e-9)


@quick
@given(lives_of=st.lists(st.floats(10.0, 1e6), min_size=1, max_size=6), data=st.data())
def test_a_duty_lives_between_its_rows_and_parts_of_a_row_are_that_row(lives_of, data):
    hours = data.draw(st.lists(st.floats(0.1, 10.0), min_size=len(lives_of), max_size=len(lives_of)))
    w, L = np.array(hours) / sum(hours), np.array(lives_of)
    life = life_of_duty(w=w, L_i=L)
    assert L.min() * (1 - 1e-9) <= life <= L.max() * (1 + 1e-9)
    halves = life_of_duty(w=np.repeat(w / 2, 2), L_i=np.repeat(L, 2))
    assert halves == pytest.approx(life, rel=1e-9)


@quick
@given(size=sizes, F=loads, n=st.floats(5.0, 150.0), nu=st.floats(2e-6, 1e-3))
def test_life_falls_with_load_and_dirt(size, F, n, nu):
    inside = inside_of(size)
    ratings = computed(inside, size.usual.rating)

    def life(P=F, word="typical", rated=ratings):
        return lives(size.elements, inside.pitch, rated, P, n, nu, word).modified

    assert life(1.1 * F) < life() and life(word="severe") <= life(word="high") * (1 + 1e-12)
    assert life(word="very-severe") == pytest.approx(
        0.1 * lives(size.elements, inside.pitch, ratings, F, n, nu, "high").basic
    )
    assert life(rated=replace(ratings, dynamic=1.2 * ratings.dynamic)) > life()
