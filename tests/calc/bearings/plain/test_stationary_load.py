"""Weight and gear force, which stand still while the load turns."""

import math
from dataclasses import replace

import pytest

from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.thermal_balance import balanced
from calc.bearings.standing import with_standing
from calc.countershaft.supports import Standing


def stands(front, rear):
    return Standing(weights={}, stationary={"front": front, "rear": rear}, peaks={})


def test_the_bearings_take_the_shaft_s_standing_part(gamma_results):
    stands = gamma_results.outcomes["countershaft"].result.standing
    found = gamma_results.outcomes["bearings"].result.bearings
    assert found["front"].standing.standing_load == stands.stationary["front"]
    assert found["rear"].standing.standing_load == stands.stationary["rear"]
    assert found["front"].standing.load_peak == pytest.approx(found["front"].load + stands.stationary["front"])
    assert found["front"].standing.load_at_start == pytest.approx(stands.stationary["front"] / (0.0595 * 0.0275))


def test_the_film_under_the_largest_load_is_that_of_this_load(gamma_results):
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    alone = balanced(own_warm, r.seat, replace(r.duty, load=r.standing.load_peak))
    assert r.standing.film_load_peak == alone.film < r.film


def test_the_orbit_takes_something_of_the_film_and_grows_with_the_force(gamma_results):
    outcome = gamma_results.outcomes["bearings"]
    r = outcome.result.bearings["front"]
    once, twice = (with_standing(outcome, stands(F, F)).result.bearings["front"].standing for F in (40.0, 80.0))
    assert once.film_orbit < r.film
    assert r.film - twice.film_orbit == pytest.approx(2 * (r.film - once.film_orbit))
    assert twice.orbit_amplitude == pytest.approx(2 * once.orbit_amplitude)


def test_a_force_as_large_as_half_the_load_has_no_orbit_of_first_order(gamma_results):
    outcome = gamma_results.outcomes["bearings"]
    half = outcome.result.bearings["front"].load / 2
    under, over = (
        with_standing(outcome, stands(F, F)).result.bearings["front"].standing for F in (0.99 * half, 1.01 * half)
    )
    assert under.film_orbit is not None
    assert over.film_orbit is None and over.film_load_peak is not None


def test_nothing_stands_beside_a_load_that_nobody_knows(gamma_results):
    outcome = gamma_results.outcomes["bearings"]
    for stands in (None, Standing(weights={}, stationary={}, peaks={})):
        assert with_standing(outcome, stands) is outcome


def test_a_load_that_does_not_turn_has_no_speed_of_equal_loads(gamma_results):
    outcome = gamma_results.outcomes["bearings"]
    front = outcome.result.bearings["front"]
    seat = replace(front.seat, inputs=replace(front.seat.inputs, load_speed_ratio=0.0))
    bearings = outcome.result.bearings | {"front": replace(front, seat=seat)}
    stood = replace(outcome, result=replace(outcome.result, bearings=bearings))
    found = with_standing(stood, stands(40.0, 40.0)).result.bearings
    assert found["front"].standing.speed_of_equal_loads is None
    assert found["rear"].standing.speed_of_equal_loads is not None


def test_at_the_speed_of_equal_loads_both_are_equal(gamma_results):
    """The turning load grows with the square of the speed: at n_0 it is as large as the standing part at rated
    speed."""
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    n_0 = r.standing.speed_of_equal_loads
    assert r.load * (n_0 / r.duty.speed) ** 2 == pytest.approx(r.standing.standing_load)
    assert n_0 * 60 == pytest.approx(2600 * math.sqrt(r.standing.standing_load / r.load))


def test_the_check_is_on_the_thinner_of_the_two(gamma_results):
    outcome = gamma_results.outcomes["bearings"]
    found = {c.id: c for c in outcome.checks}
    for place in ("front", "rear"):
        r = outcome.result.bearings[place]
        thinner = min(r.standing.film_load_peak, r.standing.film_orbit) - (r.film - r.film_edge)
        assert found[f"bearings.{place}.film_edge_standing"].value == pytest.approx(thinner * 1e6)
        assert found[f"bearings.{place}.start_load"].verdict == "pass"
