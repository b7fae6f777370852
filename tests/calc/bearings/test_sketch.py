# SPDX-License-Identifier: Apache-2.0
"""The bearings as a sketch: the journal within its clearance, at its eccentricity and attitude, with the film's
verdict."""

import math
from itertools import pairwise

import pytest

from calc.bearings.plain.sketch import pressures
from calc.bearings.sketch import sketch
from calc.design.toml_file import load
from calc.draw.drawing import CONTEXT, HIDDEN, OUTLINE, Arc, Polyline
from calc.solve import solve
from tests.calc import sketches
from tests.conftest import DESIGNS


def circles(picture, place):
    clearance, journal = (
        next(
            mark
            for mark in picture.primitives
            if isinstance(mark, Arc) and f"shafts.S.bearings.{place}.{key}" in mark.key.split()
        )
        for key in ("clearance_um", "diameter_mm")
    )
    return clearance, journal


def test_the_journal_lies_in_its_clearance_as_the_film_holds_it(gamma, gamma_results):
    bearings = sketch(gamma_results.design, gamma_results)
    sketches.check(bearings, gamma)
    for place, picture in (("front", bearings), ("rear", bearings.beside[0])):
        found = gamma_results.outcomes["bearings"].result.bearings[place]
        seat, journal = circles(picture, place)
        gap = seat.radius - journal.radius
        x, y = journal.centre
        assert journal.radius == pytest.approx(found.seat.bearing.diameter / 2)
        assert math.hypot(x, y) == pytest.approx(gap * found.eccentricity)
        # from the load, which points down, anticlockwise
        assert math.atan2(x, -y) == pytest.approx(found.attitude_angle)
        factor = gap / (found.clearance_hot / 2)
        assert f"gap × {factor:.0f}" in map(str, bearings.notes)


def test_the_film_is_told_with_what_is_asked_of_it(gamma_results):
    bearings = sketch(gamma_results.design, gamma_results)
    assert "7.4 of 9 µm" in sketches.words(bearings)
    assert {key.split(".")[3] for key in sketches.failing(bearings)} == {"front"}


def test_bearings_that_carry_are_not_marked():
    document, asked = load(DESIGNS / "r753ie4_sized.toml")
    bearings = sketch(asked, solve(asked))
    sketches.check(bearings, document)
    assert not sketches.failing(bearings)


@pytest.mark.parametrize("eccentricity", [0.1, 0.6, 0.95])
def test_the_pressure_rises_to_its_peak_before_the_narrowest_film(eccentricity):
    around = pressures(eccentricity, 0.5)
    shares = [share for _, share in around]
    peak = shares.index(max(shares))
    assert max(shares) == 1.0 and around[peak][0] < 0.5
    assert all(a < b for a, b in pairwise(shares[: peak + 1])) and all(a > b for a, b in pairwise(shares[peak:]))


def test_the_feed_stands_opposite_to_the_load(gamma_results):
    bearings = sketch(gamma_results.design, gamma_results)
    seat, _ = circles(bearings, "front")
    feed = [mark for mark in sketches.lit(bearings, "bearings.hole_diameter_mm") if mark.layer == CONTEXT]
    assert feed and all(y > 0.9 * seat.radius for mark in feed[:1] for _, y in mark.outlines[0])


# --- from the side


def lines(picture, layer):
    """Open lines across several bearings."""
    return [mark.points for mark in picture.primitives if isinstance(mark, Polyline) and mark.layer == layer]


def test_a_couple_shaft_is_seen_as_a_cone_in_its_clearances(gamma, gamma_results):
    bearings = sketch(gamma_results.design, gamma_results)
    sketches.check(bearings, gamma)
    first = sketch(gamma_results.design, gamma_results, view=1)
    side = bearings.beside[-1]
    assert str(side.title) == str(first.title) == "in the films" and bearings.views == 2
    result = gamma_results.outcomes["bearings"].result
    factor = float(next(str(note) for note in side.notes if "films" in str(note)).split()[-1])
    (line,) = (points for points in lines(side, OUTLINE) if len(points) > 5)
    (later,) = lines(side, HIDDEN)
    assert later == tuple((z, -y) for z, y in line)
    at = {z: y / factor for z, y in line}
    journals = []
    for r in result.bearings.values():
        z = min(at, key=lambda place: abs(place - r.seat.bearing.position))
        journals.append((z, at[z]))
        limits = [p for p in lines(side, OUTLINE) if len(p) == 2 and p[0][0] < z < p[1][0] and p[0][1] == p[1][1]]
        assert sorted(y / factor for (_, y), _ in limits) == [
            pytest.approx(half) for half in (-r.clearance_hot / 2, r.clearance_hot / 2)
        ]
        assert abs(at[z]) <= r.on_shaft.displacement * (1 + 1e-9) < r.clearance_hot / 2
    (z_f, y_f), (z_r, y_r) = journals
    assert y_f * y_r < 0 and abs(y_r - y_f) / (z_r - z_f) == pytest.approx(result.cone, rel=0.02)
    assert {"edge 6 µm", "edge 8.8 µm"} <= set(sketches.words(side))
    assert "cone 0.402 mrad" in map(str, side.notes)
