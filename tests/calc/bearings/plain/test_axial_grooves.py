"""A design whose bearings are fed by axial grooves: judged by the film that they bound."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.plain.film.grooved import Feed, Feeds, eccentricity_from, film_at, solve_grooved
from calc.bearings.plain.film.table import FilmRangeError
from calc.bearings.plain.routes.thermal_balance import settled
from calc.design.toml_file import design
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.explain import chain

KEYS = {
    "supply": "axial_groove",
    "axial_groove_angles_deg": [90.0, 270.0],
    "axial_groove_width_mm": 5.0,
    "axial_groove_length_mm": 18.0,
    "load_speed_ratio": 0.0,
    "slope_mrad": 0.0,
}


def grooved(document, **changes):
    for key, value in (KEYS | changes).items():
        document = document.with_value(f"bearings.{key}", value)
    return document


@pytest.fixture(scope="module")
def results(gamma):
    return solve(design(grooved(gamma)))


@pytest.mark.parametrize("place", ["rear", pytest.param("front", marks=pytest.mark.slow)])
def test_film_flow_and_coefficients_are_those_of_the_direct_solution(results, place):
    r = results.outcomes["bearings"].result.bearings[place]
    b = r.seat.bearing
    feeds = tuple(Feed(angle, 2 * 5e-3 / b.diameter, 18e-3 / b.length) for angle in (math.pi / 2, 3 * math.pi / 2))
    film = solve_grooved(r.eccentricity, b.length / b.diameter, feeds)
    assert r.sommerfeld == pytest.approx(film.sommerfeld, rel=2e-3)
    assert r.attitude_angle == pytest.approx(film.attitude, abs=2e-3)
    assert r.friction_coefficient == pytest.approx(r.relative_clearance * film.friction, rel=2e-3)
    assert r.side_flow == pytest.approx(
        film.side_flow * b.diameter * r.clearance_hot * r.duty.speed * b.length / 4, rel=5e-3
    )
    scale = r.load / (r.clearance_hot / 2)
    for name in ("xx", "xy", "yy"):
        assert getattr(r.dynamics, f"stiffness_{name}") == pytest.approx(getattr(film, f"k_{name}") * scale, rel=0.02)
    omega = 2 * math.pi * r.duty.speed
    assert r.dynamics.damping_xx == pytest.approx(film.c_xx * scale / omega, rel=0.02)
    assert r.dynamics.critical_mass is None or r.dynamics.critical_mass > 0


def test_many_states_are_the_one(results):
    r = results.outcomes["bearings"].result.bearings["front"]

    many = settled(r.seat, replace(r.duty, load=np.array([r.load, 2 * r.load])))
    assert many.film[0] == pytest.approx(r.film, rel=1e-5)
    assert many.film[1] == pytest.approx(r.film_double_load, rel=1e-5)


def test_from_the_film_back_to_the_eccentricity(results):
    """There and back in the whole range; beyond it an error that names the range, or no number."""
    r = results.outcomes["bearings"].result.bearings["front"]
    b = r.seat.bearing
    feeds = Feeds(
        tuple(Feed(angle, 2 * 5e-3 / b.diameter, 18e-3 / b.length) for angle in (math.pi / 2, 3 * math.pi / 2))
    )
    ratio, eps = b.length / b.diameter, np.array([0.02, 0.1, 0.4, 0.7, 0.9, 0.98])
    S = film_at(eps, ratio, feeds).sommerfeld
    assert np.all(np.diff(S) < 0) and eccentricity_from(S[1:-1], ratio, feeds) == pytest.approx(eps[1:-1], abs=1e-5)
    for beyond in (1.01 * S[0], 0.99 * S[-1]):
        with pytest.raises(FilmRangeError) as off:
            eccentricity_from(float(beyond), ratio, feeds)
        assert (off.value.low, off.value.high) == pytest.approx((S[-1], S[0]), rel=1e-6)
        assert math.isnan(eccentricity_from(float(beyond), ratio, feeds, outside="nan"))
    assert np.isnan(eccentricity_from(np.array([1.01 * S[0], S[2]]), ratio, feeds, outside="nan")).tolist() == [
        True,
        False,
    ]


def test_the_grooves_thin_the_film_of_a_plain_bearing_with_the_same_oil(gamma, results):
    plain = solve(design(grooved(gamma, supply="hole"))).outcomes["bearings"].result.bearings["front"]
    found = results.outcomes["bearings"].result.bearings["front"]
    assert found.attitude_angle < plain.attitude_angle
    assert found.side_flow < plain.side_flow  # the film begins where the gap is narrower than at its widest


def test_what_leads_to_the_film_names_the_grooves(results):
    inputs = {key for link in chain(results, "bearings.front.film") for key in link.inputs}
    assert {
        "bearings.axial_groove_angles_deg",
        "bearings.axial_groove_width_mm",
        "bearings.axial_groove_length_mm",
    } <= inputs


def test_routes_that_know_no_grooves_are_not_compared(results):
    outcome = results.outcomes["bearings"]
    assert (
        outcome.result.bearings["front"].routes_spread is None
        and outcome.result.bearings["front"].routes["iso7902"] is not None
    )
    assert not any(c.id.endswith("routes_spread") for c in outcome.checks)
    assert any("begins and ends at its axial grooves" in note for note in outcome.notes)


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"load_speed_ratio": 1.0}, "sweeps over axial grooves"),
        ({"axial_groove_angles_deg": None}, "needed with supply"),
        ({"axial_groove_angles_deg": [90.0, 95.0]}, "overlap"),
        ({"axial_groove_length_mm": 30.0}, "smaller than the length"),
    ],
)
def test_grooves_that_make_no_sense_are_refused(gamma, changes, words):
    with pytest.raises(BadInput, match=words):
        design(grooved(gamma, **changes))
