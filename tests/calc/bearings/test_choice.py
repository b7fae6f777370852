# SPDX-License-Identifier: Apache-2.0
"""Plain and rolling bearings in one order, and a row of either kind as the keys that put it into a design."""

import math
from dataclasses import replace

import pytest

from calc.bearings import choice as c
from calc.bearings.plain.selection.variants import own_tasks
from calc.bearings.rolling.search import as_rolling
from calc.countershaft.rows import BearingRow
from calc.design.step_inputs import bearings_case, rolling_places
from calc.design.toml_file import design, parse
from calc.sheet.remedy import assignments
from calc.solve import solve
from tests.conftest import DESIGNS


@pytest.fixture(scope="module")
def gamma():
    """The shipped design, solved: its document, the case of its bearings, their places."""
    document = parse((DESIGNS / "r753ie4_gamma.toml").read_bytes(), "gamma.toml")
    return document, *case_of(document)


def case_of(document):
    made = design(document)
    results = solve(made)
    return bearings_case(made, solve, results), rolling_places(made, results, made.own_name)


def changed(document, keys):
    from assistant.commands.check import changed as with_changes

    return with_changes(document, assignments(keys))


def side(type="ball", loss=10.0, mass=0.2, seat=0.05, life=1e7, **row):
    said = dict(name="front", position=0.0) | row
    return c.Side(BearingRow(**said), type, loss, mass, seat, life if type != "plain" else None)


def row(*sides):
    return c.ChoiceRow(sides, inputs=None)


def test_the_least_loss_goes_first_and_equal_ones_are_alike():
    few, more, alike = (row(side(loss=x), side(loss=x)) for x in (9.1, 12.0, 9.11))
    assert sorted([more, alike, few], key=lambda one: c.order(one, "loss")) == [alike, few, more]
    small = row(side(seat=0.03, loss=50.0), side(seat=0.03, loss=50.0))
    assert min([few, small], key=lambda one: c.order(one, "size")) is small


def test_what_another_beats_in_everything_is_left_out():
    best = row(side(loss=9.0, mass=0.1, seat=0.04, life=2e7))
    beaten = row(side(loss=10.0, mass=0.1, seat=0.05, life=1e7))
    longer = row(side(loss=10.0, mass=0.3, seat=0.05, life=9e7))
    film = row(side("plain", loss=100.0, mass=0.0, seat=0.03, diameter=0.03, length=0.015))
    assert c.unbeaten([beaten, best, longer, film]) == [best, longer, film]
    assert film.life is None and math.isfinite(best.life)


def test_places_of_the_gamma(gamma):
    """Loads and slopes of the shaft; no bore below its core; the front one, beside the gear, locates it."""
    _, case, places = gamma
    front, rear = places.values()
    assert front.locates and not rear.locates
    assert front.load == pytest.approx(1707.4, abs=0.1) and rear.load == pytest.approx(1714.7, abs=0.1)
    assert front.axial == pytest.approx(12.08, abs=0.01) and rear.axial == 0.0
    assert front.stands.all > front.stands.weight > 0
    assert all(at.bores == pytest.approx((0.03, 0.081)) for at in places.values())
    assert {at.slope for at in places.values()} == {row.slope for row in case.rows}


def test_a_row_goes_into_the_design_and_a_plain_one_back(gamma):
    """As the whole design then reads it; what only the other kind has is gone, both ways."""
    document, case, places = gamma
    sides = []
    for place, size in zip(places.values(), ("6306", "NU1010")):
        rolling = replace(as_rolling(place, size), clearance_class="C5", seat_fit="N5", outer_ring_held="insert")
        sides.append(c.Side(rolling, "ball", 9.0, 0.3, 0.072, 1e8))
    keys = c.changes(case, c.ChoiceRow(tuple(sides), case.bearings))
    assert not any(value is not None for key, value in keys.items() if key.endswith(("diameter_mm", "roughness_um")))
    with_rolling, made = changed(document, keys)
    assert made.rows == tuple(one.row for one in sides)
    assert made.rows[0].locates and not made.rows[1].locates
    there, new_places = case_of(with_rolling)
    begun = c.plain_case(there, new_places)
    assert [row.kind for row in begun.rows] == ["plain", "plain"]
    assert [row.diameter for row in begun.rows] == pytest.approx([0.03, 0.05])
    assert len(own_tasks(begun)) == 2
    back = c.ChoiceRow(tuple(c._plain_side(row, 50.0) for row in begun.rows), begun.bearings)
    _, again = changed(with_rolling, c.changes(there, back))
    assert again.rows == begun.rows and again.bearings == begun.bearings
    refused = c.confirmed(there, back)
    assert refused.why and "30×15" in refused.why  # a journal as thick as the ring's bore is too short for its film
    assert not c.confirmed(case, c.ChoiceRow(tuple(sides), case.bearings)).broken


def test_a_ring_does_not_pass_sectors_to_an_inner_journal():
    document = parse((DESIGNS / "r754ie4_balance_shafts.toml").read_bytes(), "r754.toml")
    made = design(document)
    results = solve(made, enough=lambda outcome: outcome.key == "bearings")
    places = rolling_places(made, results, next(iter(made.originals)))
    assert all(at.bores == pytest.approx((0.024, 0.024)) for at in places.values())  # its sections have it
    assert not any(c._rolling_sides(at, 2)[0] for at in places.values())


def test_the_sectors_have_to_pass_a_seat(gamma):
    _, case, _ = gamma
    threaded = replace(case, shaft=replace(case.shaft, assembly="threaded", radial_clearance=0.2e-3))
    assert c.threads(case, [side(seat=0.05)])  # nobody asks
    assert not c.threads(threaded, [side(seat=0.05), side(seat=0.08)])
    assert c.threads(threaded, [side(seat=0.05), side(seat=0.085)])
