# SPDX-License-Identifier: Apache-2.0
"""Films of the tables against those of the step at single sizes: corners, twice the load, over the speeds and over a
turn."""

import numpy as np
import pytest

from calc.bearings.result import BearingsResult
from calc.studies.drive.search import search
from tests.calc.studies.drive.conftest import FEW
from tests.calc.studies.drive.points import PLACES, Class, Point
from tests.calc.studies.drive.test_verdict import SOME, changed, compared

CASES = {
    "as shipped": {},
    "through the shaft, IT5": {"bearings.supply": "shaft", "bearings.journal_fit": "IT5", "bearings.seat_fit": "IT6"},
    "cool": {"bearings.supply_temperature_C": 90.0},
    "no bench": {"engine.bench": None},
    "fits with a place": {"bearings.journal_fit": "f7", "bearings.seat_fit": "H7"},
    "grooves": {"bearings.supply": "groove", "bearings.groove_width_mm": 3.0},
}


QUICK = ("as shipped", "grooves")


@pytest.mark.parametrize(
    "name", [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in CASES]
)
def test_films_of_the_tables_are_those_of_the_step(sized, name):
    """At sizes from everywhere, the ends of the tables among them, whether they pass or not."""
    one = Class(changed(sized, CASES[name]), {"vary": SOME})
    rng, seen = np.random.default_rng(11), 0
    for n in range(8):
        front, rear = (one.sizes.films[place][rng.integers(len(one.sizes.films[place]))] for place in PLACES)
        ends = [
            (
                f,
                *((f.length.size - 1) * k if n < 4 else int(rng.integers(f.length.size)) for k in (n % 2,)),
                (f.clearance.size - 1) * (n // 2 % 2) if n < 4 else int(rng.integers(f.clearance.size)),
            )
            for f in (front, rear)
        ]
        _, results = one.whole(Point(float(one.sizes.core[0]), tuple(ends)))
        solved = results.result(BearingsResult) if results is not None else None
        if solved is None:
            continue
        checks = {c.id: c for c in results.checks()}
        for place, (table, i, j) in zip(PLACES, ends):
            r = solved.bearings[place]
            if r.corners.film is None or r.film_double_load is None:
                assert not np.isfinite(table.once[j, i]) or not np.isfinite(table.twice[j, i]) or not table.kept[j, i]
                continue
            seen += 1
            assert table.power[j, i] == pytest.approx(r.friction_power, rel=2e-4)
            assert table.once[j, i] == pytest.approx(min(r.corners.film, r.film), rel=2e-4)
            assert table.twice[j, i] == pytest.approx(r.film_double_load, rel=2e-4)
            if table.speeds is not None and r.thinnest_film < table.once[j, i]:
                assert table.speeds[j, i] == pytest.approx(r.thinnest_film, rel=2e-3)
            if table.turn is not None and r.standing is not None and r.standing.film_orbit is not None:
                # the load that stands still is that of the class's start
                loss = (r.film - r.standing.film_orbit) / r.film
                assert (r.film - table.turn[j, i]) / r.film == pytest.approx(loss, abs=0.05)
            broken = {
                k: checks[f"bearings.{place}.{k}"].margin < 0
                for k in ("temperature_corner", "specific_load", "clearance_cold_corner")
            }
            assert not (any(broken.values()) and table.kept[j, i]), broken
    assert seen >= (2 if name == "grooves" else 6)


@pytest.mark.slow
def test_films_over_the_speeds_are_known_where_they_are_the_thinnest(sized):
    """With cool oil at the rated speed that of the bench run's other speeds is the hotter: their films bind."""
    one = Class(changed(sized, CASES["cool"]), {"vary": SOME})
    assert any(f.speeds is not None for some in one.sizes.films.values() for f in some)
    _, misses, *_ = compared(one, 14, 2)
    assert [broken for passes, broken, _ in misses if passes] == []
    waive = ["bearings.*.film_edge_speeds", "bearings.*.film_edge_standing"]
    waived = Class(changed(sized, CASES["cool"]), {"vary": SOME, "waive": waive})
    assert all(f.turn is None for some in waived.sizes.films.values() for f in some)
    assert any(f.speeds is not None for some in waived.sizes.films.values() for f in some), "a range that is given"


@pytest.mark.slow
def test_a_range_from_below_the_gear_hides_no_drive(sized):
    """A journal that the gear does not go through rubs less than any that it does."""
    vary = FEW | {
        "shafts.shaft.bearings.front.diameter_mm": {"from": 46.0, "to": 62.0, "step": 0.5},
        "shafts.shaft.bearings.rear.diameter_mm": [85.0],
    }
    one = Class(sized, {"vary": vary})
    assert min(f.task.diameter for f in one.sizes.films["front"]) == pytest.approx(58e-3)
    found = search(one.problem)
    assert found.dropped == () and min(d.sized.diameter["front"] for d in found.drives) >= 58.0
