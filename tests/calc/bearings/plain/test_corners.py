"""Fits and the corners of the tolerances."""

import numpy as np
import pytest

from calc.bearings.plain.corners import CORNERS, NAMES, limits
from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.states import BearingCase
from calc.bearings.plain.routes.thermal_balance import balanced
from calc.design.toml_file import design
from calc.solve import solve
from tests.calc.bearings.documents import outcome


def front(found):
    return found.result.bearings["front"]


def test_the_names_are_those_of_the_corners():
    assert NAMES == tuple(f"{journal} journal, {seat} seat, {oil} oil" for (journal, _), (seat, _), (oil, _) in CORNERS)


def test_without_fits_the_band_is_it7_of_both(gamma_results):
    """Ø59.5: IT7 30 µm, Ø81: 35 µm; half of each tolerance to either side makes ±30 and ±35 µm."""
    for place, width in (("front", 30e-6), ("rear", 35e-6)):
        r = gamma_results.outcomes["bearings"].result.bearings[place]
        for low, high in limits(r.seat.inputs, r.seat.bearing.diameter, r.clearance):
            assert high - low == pytest.approx(width)
        assert r.corners.clearance_min == pytest.approx(r.clearance - width)
        assert r.corners.clearance_max == pytest.approx(r.clearance + width)


def test_warm_film_over_the_it7_band(gamma):
    """±30 µm about the nominal clearance, warm, oil as given: 9.0 to 10.0 µm at the front."""
    c = front(outcome(gamma, viscosity_tolerance_percent=0.0)).corners
    assert c.film * 1e6 == pytest.approx(9.05, abs=0.06)
    assert np.nanmax(c.columns["film"]) * 1e6 == pytest.approx(10.0, abs=0.06)


def test_eight_corners_each_as_solved_alone(gamma_results):
    r = front(gamma_results.outcomes["bearings"])
    assert len(r.corners.names) == len(set(r.corners.names)) == 8
    names = r.corners.names
    signs = {"smallest": -1, "largest": 1, "thinner": -1, "thicker": 1}
    for i, name in enumerate(names):
        journal, seat, oil = (signs[part.split()[0]] for part in name.split(", "))
        g = r.clearance + (seat - journal) * 15e-6
        at = BearingCase(
            r.seat.bearing,
            r.seat.inputs,
            r.seat.lubricant,
            g,
            r.seat.journal_expansion,
            r.seat.housing_expansion,
            viscosity_factor=1 + 0.1 * oil,
        )
        film = balanced(own_warm, at, r.duty)
        assert r.corners.columns["film"][i] == pytest.approx(film.film, rel=1e-6)
        assert r.corners.columns["outlet_temperature"][i] == pytest.approx(120 + film.temperature_rise, rel=1e-6)


def test_the_worst_corner_is_named(gamma_results):
    found = {c.id: c for c in gamma_results.outcomes["bearings"].checks}
    edge = found["bearings.front.film_edge_corner"]
    assert (
        "smallest journal, largest seat, thinner oil" in edge.advice
        and edge.kind == "caution"
        and edge.verdict == "warn"
    )
    assert edge.cause == "bearings.front.film_edge"
    assert "largest journal, smallest seat" in found["bearings.front.clearance_cold_corner"].advice


def test_a_corner_is_a_caution_whether_its_fits_are_given_or_assumed(gamma):
    found = {c.id: c for c in outcome(gamma, seat_fit="H7", journal_fit="IT6").checks}
    edge = found["bearings.front.film_edge_corner"]
    assert edge.kind == "caution" and edge.verdict == "warn"


def test_fits_alone_make_the_clearance(gamma):
    """H7/f7 at Ø59.5: 30 to 90 µm (ISO 286), the middle 60; at Ø81 36 to 106, the middle 71."""
    document = gamma.with_value("shafts.shaft.bearings.front.clearance_factor", None).with_value(
        "shafts.shaft.bearings.rear.clearance_factor", None
    )
    found = outcome(document, seat_fit="H7", journal_fit="f7")
    r = found.result.bearings
    assert r["front"].clearance == pytest.approx(60e-6) and r["rear"].clearance == pytest.approx(71e-6)
    assert (r["front"].corners.clearance_min, r["front"].corners.clearance_max) == pytest.approx((30e-6, 90e-6))
    assert {c.id: c.verdict for c in found.checks}["bearings.front.fit"] == "pass"


def test_a_clearance_that_the_fits_do_not_make_warns(gamma):
    found = {c.id: c for c in outcome(gamma, seat_fit="H7", journal_fit="g6").checks}
    assert found["bearings.front.fit"].verdict == "warn" and "g6 in H7" in found["bearings.front.fit"].advice


def test_a_corner_that_seizes_when_cold_is_named_even_where_the_middle_does_not(gamma):
    document = gamma.with_value("shafts.shaft.bearings.front.clearance_factor", None).with_value(
        "shafts.shaft.bearings.front.clearance_um", 45.0
    )
    found = {c.id: c for c in outcome(document).checks}
    assert found["bearings.front.clearance_cold"].verdict == "pass"
    corner = found["bearings.front.clearance_cold_corner"]
    assert corner.value < 0 and corner.verdict == "not_verified" and "largest journal, smallest seat" in corner.advice
    given = {c.id: c for c in outcome(document, journal_fit="IT7", seat_fit="IT7").checks}
    assert given["bearings.front.clearance_cold_corner"].verdict == "fail"


def test_a_corner_without_film_warns_and_does_not_end_the_step(gamma):
    found = outcome(gamma, front__length_mm=8.0, viscosity_tolerance_percent=50.0, seat_fit="H9", journal_fit="IT9")
    assert found.state == "solved"
    assert found.result.bearings["front"].corners.film is None
    assert {c.id: c.verdict for c in found.checks}["bearings.front.film_edge_corner"] == "warn"


def test_fits_with_letters_make_the_corners_whatever_clearance_is_given(gamma):
    """H7/f7 at Ø59.5 makes 30 to 90 µm, and no other: a given middle of 88 µm moves the judged film, not the
    corners."""
    document = gamma.with_value("shafts.shaft.bearings.front.clearance_factor", None).with_value(
        "shafts.shaft.bearings.front.clearance_um", 88.0
    )
    r = front(outcome(document, seat_fit="H7", journal_fit="f7"))
    assert r.clearance == pytest.approx(88e-6)
    assert (r.corners.clearance_min, r.corners.clearance_max) == pytest.approx((30e-6, 90e-6))
    assert sorted(set(np.round(r.corners.columns["clearance"] * 1e6, 6))) == pytest.approx([30, 60, 90])


def test_fits_that_stand_in_the_file_are_given_though_they_are_those_that_are_assumed(gamma):
    given = gamma.with_value("bearings.journal_fit", "IT7").with_value("bearings.seat_fit", "IT7")
    assert not design(gamma).bearings.fits_given and design(given).bearings.fits_given
    before = solve(design(gamma))
    notes = [" ".join(map(str, r.outcomes["bearings"].notes)) for r in (before, solve(design(given), before))]
    assert "No fits are given" in notes[0] and "No fits are given" not in notes[1]
