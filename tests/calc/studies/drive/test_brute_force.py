# SPDX-License-Identifier: Apache-2.0
"""The front against every drive of a grid that is solved whole: never beaten, and equal where the grid is the same."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from calc.studies.drive.films import films
from calc.studies.drive.search import search
from tests.calc.studies.drive.points import PLACES, Class, Point

GRID = {
    "shafts.shaft.core_radius_mm": [14.0, 16.0],
    "shafts.shaft.bearings.rear.diameter_mm": [85.0],
    "shafts.shaft.bearings.front.diameter_mm": [60.0],
    "shafts.shaft.bearings.front.length_mm": [36.0, 38.0],
    "shafts.shaft.bearings.rear.length_mm": [30.0, 32.0],
    "shafts.shaft.material": ["20CrNi4"],
    "bearings.supply": ["hole"],
}
LARGE = GRID | {
    "shafts.shaft.core_radius_mm": [13.0, 15.0, 17.0],
    "shafts.shaft.bearings.rear.diameter_mm": [84.0, 86.0],
    "shafts.shaft.bearings.front.diameter_mm": [58.5, 64.0],
    "shafts.shaft.bearings.front.length_mm": [35.0, 37.0, 39.0],
    "shafts.shaft.bearings.rear.length_mm": [29.0, 31.0],
}
UNITS = np.array([1.0, 0.01, 0.5])  # W, kg, mm


def every(one, clearances):
    """All drives of the grid with these clearances, solved whole: what each gives where it passes."""
    found = []
    for core in one.sizes.core:
        for f, r in product(*(one.sizes.films[p] for p in PLACES)):
            for i, k in product(range(f.length.size), range(r.length.size)):
                columns = [
                    np.flatnonzero(np.isin(np.round(t.clearance * 1e6), clearances[p])) for p, t in zip(PLACES, (f, r))
                ]
                for j, m in product(*columns):
                    drive, _ = one.whole(Point(float(core), ((f, i, int(j)), (r, k, int(m)))))
                    if not drive.broken:
                        found.append([drive.objectives[name] for name in ("power", "mass", "seat")])
    return np.array(found)


def _against(sized, vary, clearances):
    one = Class(sized, {"vary": vary, "objectives": ["power", "mass", "seat"], "rows": 40})
    whole = every(one, clearances)
    found = search(one.problem)
    shown = np.array([[d.objectives[n] for n in ("power", "mass", "seat")] for d in found.drives])
    assert len(whole) and len(shown)
    for row in whole:
        assert ((shown - row) / UNITS).max(1).min() <= 0.4, row
    return whole, shown


def test_no_drive_of_a_tiny_grid_beats_the_front(sized):
    _against(sized, GRID, {"front": [80, 85], "rear": [95, 105]})


@pytest.mark.slow
def test_without_any_choice_but_the_clearance_the_front_is_that_of_all(sized):
    """One core, one size of each journal: the least power of all clearances, by a walk over every one about the
    best."""
    vary = GRID | {
        "shafts.shaft.core_radius_mm": [15.0],
        "shafts.shaft.bearings.front.length_mm": [37.0],
        "shafts.shaft.bearings.rear.length_mm": [31.0],
    }
    one = Class(sized, {"vary": vary, "objectives": ["power"], "rows": 1})
    (best,) = search(one.problem).drives
    near = {p: [best.sized.clearance[p] + 5 * k for k in (-1, 0, 1)] for p in PLACES}
    whole = every(one, near)
    assert whole[:, 0].min() == pytest.approx(best.objectives["power"], abs=1e-6)


@pytest.mark.slow
def test_the_front_of_a_grid_is_that_of_all_its_drives_solved_whole(sized, monkeypatch):
    """864 whole solutions; the tables have the same clearances and no others, so that neither front is better than the
    other."""
    import calc.studies.drive.films as tables

    steps = {"front": [70, 80, 85], "rear": [90, 95, 100, 105]}
    monkeypatch.setattr(tables, "clearances", lambda task, *_: np.array(steps[task.place]) * 1e-6)
    whole, shown = _against(sized, LARGE, steps)
    gap = max(((whole - row) / UNITS).max(1).min() for row in shown)
    assert len(whole) >= 40 and len(shown) >= 3 and gap <= 0.01


def test_a_mutated_rule_shows(sized, monkeypatch):
    """Where the films of the tables are thicker than they should be, whole solutions refuse what these offer."""
    import calc.studies.drive.classes as classes

    def forgetting(*args, **more):
        table = films(*args, **more)
        return table if table is None else replace(table, once=table.once * 1.1)

    monkeypatch.setattr(classes, "films", forgetting)
    one = Class(sized, {"vary": GRID, "rows": 4, "objectives": ["power", "mass"]})
    found = search(one.problem)
    assert found.dropped and all(not d.broken for d in found.drives)
    assert any("film_edge_corner" in id for d in found.dropped for id in d.broken)
