# SPDX-License-Identifier: Apache-2.0
"""The bush of an idler: Petroff without load, the bearings step's own film under load, no film under too much."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.bearings.plain.film.table import film_at
from calc.bearings.plain.routes.routes import own_cold
from calc.friction.inputs import PlainBearing
from calc.friction.losses import bearings as p
from calc.sheet.errors import NoSolution

ETA, SPEED = 0.008, 30.0


def bush(**said):
    return PlainBearing(**{"name": "idler", "diameter": 25e-3, "length": 20e-3, "clearance": 40e-6, **said})


def petroff(one, n=SPEED, eta=ETA):
    """2·π·η·ω²·r³·l/c with the radial clearance c."""
    r, c, omega = one.diameter / 2, one.clearance / 2, 2 * math.pi * n
    return 2 * math.pi * eta * omega**2 * r**3 * one.length / c


def test_without_load_it_is_petroff():
    for one in (bush(), bush(length=5e-3), bush(diameter=60e-3, length=30e-3, clearance=100e-6)):
        assert p.plain_bearing_power(one, 0.0, SPEED, ETA) == pytest.approx(petroff(one), rel=1e-12)


def test_a_light_load_comes_from_petroff_without_a_jump():
    """At the light end of the table ε is a few percent: friction there is less than 1 % above Petroff's."""
    found = [p.plain_bearing_power(bush(), F, SPEED, ETA) / petroff(bush()) for F in np.geomspace(1e-3, 3000, 400)]
    assert found[0] == pytest.approx(1.0)
    assert all(b >= a * (1 - 1e-9) for a, b in pairwise(found))
    assert max(b / a for a, b in pairwise(found)) < 1.03


def test_under_a_load_it_is_the_film_of_the_bearings_step(gamma_results):
    """The same bearing, load and oil, no warming; the load stands and the bush turns."""
    for one in gamma_results.outcomes["bearings"].result.bearings.values():
        seat, duty = one.seat, replace(one.duty, effective_speed=one.duty.speed, sliding_ratio=1.0)
        theirs = own_cold(seat, duty, 0.0)
        b = bush(diameter=seat.bearing.diameter, length=seat.bearing.length, clearance=seat.clearance)
        ours = p.plain_bearing_power(b, duty.load, duty.speed, seat.oil_at(duty.supply_temperature).mu)
        assert ours == pytest.approx(theirs.friction_power, rel=1e-9)
        eps = p.eccentricity(S=theirs.sommerfeld, b=seat.bearing.length / seat.bearing.diameter)
        assert eps == pytest.approx(theirs.eccentricity, rel=1e-9)


def test_too_much_load_has_no_film():
    with pytest.raises(
        NoSolution,
        match=r"plain bearing idler: no film carries its load; S = .* under 1·10⁶ N, the table ends at .*a larger bush",
    ):
        p.plain_bearing_power(bush(), 1e6, SPEED, ETA)
    with pytest.raises(NoSolution, match="no film carries"):
        p.plain_bearing_power(bush(), np.array([0.0, 100.0, 1e6]), SPEED, ETA)


def test_the_film_ends_at_an_eccentricity_of_98_percent():
    """At 0.979 there is one, and a load 5 % above that of 0.98 has none."""
    one, b, psi = bush(), 0.8, 40 / 25e3

    def load(S):
        return ETA * SPEED * one.diameter * one.length / (S * psi**2)

    assert p.plain_bearing_power(one, load(film_at(0.979, b).sommerfeld), SPEED, ETA) > petroff(one)
    with pytest.raises(NoSolution, match="no film carries"):
        p.plain_bearing_power(one, 1.05 * load(film_at(0.98, b).sommerfeld), SPEED, ETA)


def test_without_load_the_journal_is_pushed_square_to_it():
    """ε → 0: the attitude comes to a right angle, Sommerfeld 1904."""
    assert p.attitude(eps=0.0, b=0.8) == pytest.approx(math.pi / 2)


@pytest.mark.parametrize("length", [0.101, 1.99])
def test_a_length_from_a_tenth_to_two_diameters_is_taken(length):
    assert p.plain_bearing_power(bush(length=length * 25e-3), 1.0, SPEED, ETA) > 0


@pytest.mark.parametrize("length", [2e-3, 0.099 * 25e-3, 2.01 * 25e-3, 60e-3])
def test_a_length_outside_the_table_is_refused(length):
    with pytest.raises(
        NoSolution, match=r"plain bearing idler; its length is .* diameters; choose a length between 0.1 and 2"
    ):
        p.plain_bearing_power(bush(length=length), 100.0, SPEED, ETA)


def test_many_operating_points_are_the_single_ones():
    F, n, eta = (
        np.array([0.0, 1.0, 100.0, 2000.0]),
        np.array([5.0, 30.0, 30.0, 80.0]),
        np.array([0.1, 0.02, 0.008, 0.008]),
    )
    alone = [p.plain_bearing_power(bush(), *point) for point in zip(F.tolist(), n.tolist(), eta.tolist())]
    assert p.plain_bearing_power(bush(), F, n, eta) == pytest.approx(alone, rel=1e-12)
    assert p.plain_bearing_power(bush(), 100.0, n[1:], eta[1:]) == pytest.approx(
        [p.plain_bearing_power(bush(), 100.0, a, b) for a, b in zip(n[1:], eta[1:])], rel=1e-12
    )


@settings(max_examples=60, deadline=None)
@given(
    F=st.just(0.0) | st.floats(1e-9, 5000), n=st.floats(0.1, 300), eta=st.floats(1e-3, 0.5), share=st.floats(0.11, 1.9)
)
def test_friction_is_finite_and_no_less_than_petroff(F, n, eta, share):
    one = bush(length=share * 25e-3)
    try:
        P = p.plain_bearing_power(one, F, n, eta)
    except NoSolution as none:
        assert "no film carries" in none.what and none.advice
        return
    assert math.isfinite(P) and P >= petroff(one, n, eta) * (1 - 1e-12)
