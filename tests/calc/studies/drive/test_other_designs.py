# SPDX-License-Identifier: Apache-2.0
"""Designs that are not the shipped ones: engines of the table, starts that fail, envelopes that hold one drive or none,
ends of ranges."""

import numpy as np
import pytest

from calc.design.toml_file import Document, design, parse, read
from calc.solve import solve
from calc.studies.drive.classes import NotClosed
from calc.studies.drive.evolve import POPULATION, Space, evolved
from calc.studies.drive.output import at_end
from calc.studies.drive.search import asked, search
from calc.studies.drive.solved_drive import power
from calc.studies.shipped import DESIGNS, engine_design
from tests.calc.studies.drive.points import Class, compared
from tests.calc.studies.drive.test_brute_force import GRID
from tests.calc.studies.drive.test_verdict import SOME, changed
from tests.test_shafts_commands import PAIR


@pytest.mark.slow
@pytest.mark.parametrize("name", ["r753ie4_sized", "r753ie4_drive"])
def test_tables_and_whole_solutions_agree_on_every_threaded_drive(name):
    """What `new` begins is laid in: no seat binds its outer radius, and its front is searched without proof."""
    _, misses, differences = compared(Class(read(DESIGNS / f"{name}.toml"), {}), 20, 1)
    assert misses == []
    assert differences.small(0.006), str(differences)


def test_classes_of_what_new_begins_become_clearances(tmp_path):
    """As a number, with tolerances about as wide; the way in of a shaft that is laid in is told."""
    path = tmp_path / "own.toml"
    path.write_text(engine_design("twin-180"), encoding="utf-8")
    problem, _ = asked(read(path), {"objectives": ["power", "mass"]})
    assert problem.base.bearings.select is None
    for row in problem.base.rows:
        assert row.seat == "shells" and row.journal is None and row.wall == pytest.approx((1.5e-3,), abs=20e-6)
        assert 0.9e-3 < row.clearance / row.diameter < 2.9e-3
    (said,) = [words for words in problem.said if "classes of the parts make the clearance" in str(words)]
    assert "IT4/IT" in str(said)


@pytest.mark.slow
def test_holes_that_would_run_into_the_core_or_out_of_the_sector(sized):
    """Sizes of holes are limits that change with core, seat and length: what breaks them is not offered, and hides
    nothing."""
    deep = changed(sized, {"shafts.shaft.holes.depth_mm": 27.5})
    _, misses, *_ = compared(Class(deep, {"vary": SOME}), 14, 4)
    assert [broken for passes, broken, _ in misses if passes] == []
    problem, _ = asked(deep, {"vary": SOME, "rows": 5, "objectives": ["power", "mass"]})
    found = search(problem)
    assert found.dropped == () and all(d.sized.diameter["rear"] / 2 - 0.2 - d.sized.core >= 27.5 for d in found.drives)


def test_a_range_that_holds_one_drive_and_one_that_holds_none(sized):
    one = GRID | {
        "shafts.shaft.core_radius_mm": [15.0],
        "shafts.shaft.bearings.front.length_mm": [37.0],
        "shafts.shaft.bearings.rear.length_mm": [31.0],
    }
    problem, _ = asked(sized, {"vary": one, "rows": 9, "objectives": ["power", "mass", "seat"]})
    (only,) = search(problem).drives
    assert only.sized.core == 15.0 and set(at_end(problem, only)) == set()  # a single value is no end of a range
    for key, value in (
        ("shafts.shaft.bearings.front.length_mm", [20.0]),
        ("shafts.shaft.core_radius_mm", [8.0]),
        ("shafts.shaft.bearings.rear.length_mm", [90.0]),
    ):
        problem, _ = asked(sized, {"vary": one | {key: value}})
        assert search(problem).drives == ()


@pytest.mark.slow
def test_a_start_that_fails_and_has_no_film_is_as_good_as_any(sized):
    vary = {
        "vary": GRID | {"shafts.shaft.bearings.rear.diameter_mm": [85.0, 86.0]},
        "rows": 4,
        "objectives": ["power", "mass"],
    }
    broken = changed(
        sized,
        {
            "shafts.shaft.bearings.rear.clearance_factor": None,
            "shafts.shaft.bearings.rear.clearance_um": 900.0,
            "shafts.shaft.bearings.front.length_mm": 16.0,
            "shafts.shaft.core_radius_mm": 8.0,
        },
    )
    one, other = (search(asked(d, vary)[0]) for d in (sized, broken))
    assert one.drives and [d.changes for d in one.drives] == [d.changes for d in other.drives]


@pytest.mark.slow
def test_bounds_hold_in_what_is_solved_whole(sized):
    bounds = {"most": {"mass_kg": 10.4, "power_W": 275.0}, "least": {"margin_percent": 2.0}}
    problem, _ = asked(sized, {"vary": SOME, "rows": 6, **bounds})
    found = search(problem)
    assert found.drives
    for one in found.drives:
        assert one.objectives["mass"] <= 10.4 and one.objectives["power"] <= 275.0 and one.objectives["margin"] >= 2.0


@pytest.mark.slow
def test_a_length_off_the_usual_steps_and_values_out_of_order(sized):
    vary = GRID | {
        "shafts.shaft.bearings.front.length_mm": [38.0, 37.3, 36.9],
        "shafts.shaft.core_radius_mm": [16.0, 14.25, 15.1],
    }
    problem, _ = asked(sized, {"vary": vary, "rows": 5, "objectives": ["power", "mass"]})
    found = search(problem)
    assert found.drives and {one.sized.core for one in found.drives} <= {14.25, 15.1, 16.0}
    assert {one.sized.length["front"] for one in found.drives} <= {36.9, 37.3, 38.0}


@pytest.mark.slow
def test_a_gap_too_narrow_for_its_fillets_is_offered_where_that_is_waived(sized):
    """The wheel stands a little ahead of its journal: the usual list refuses it, and with the finding waived it passes
    whole as well."""
    apart = changed(sized, {"shafts.shaft.gear_z_mm": -195.0})
    usual, waived = (Class(apart, {"vary": SOME, **said}) for said in ({}, {"waive": ["countershaft.fillet_room"]}))
    assert usual.drive.filleted and not waived.drive.filleted
    _, misses, *_ = compared(waived, 10, 6)
    assert [broken for passes, broken, _ in misses if passes] == []
    rng, narrow = np.random.default_rng(2), 0
    while narrow < 2:
        point = waived.random(rng)
        if waived.said(point).passes and not usual.said(point).passes:
            narrow += 1
            one, results = waived.whole(point)
            assert one.broken == () and {c.id: c for c in results.checks()}["countershaft.fillet_room"].margin < 0


@pytest.mark.slow
def test_a_pair_laid_into_its_module_comes_to_drives():
    """A force at twice crank speed on two plain bearings: no front is proved, and the design as it is comes first."""
    places = {"left.axis_mm": [-70.0, -105.0], "right.axis_mm": [-60.0, 78.746]}
    wider = {"left.assembly": "split", "left.core_radius_mm": 24.0, "left.outer_radius_mm": 32.0}
    document = parse(PAIR.encode("utf-8"), "pair")
    for key, value in {**places, **wider, "left.fillet_radius_mm": 1.5}.items():
        document = document.with_value(f"shafts.{key}", value)
    problem, _ = asked(document, {"shaft": "left", "rows": 5})
    assert problem.choices["shafts.left.outer_radius_mm"] == (32.0, 35.0, 38.5, 41.5, 45.0)
    with pytest.raises(NotClosed, match="passes no seat"):
        search(problem)
    space = Space(problem)
    own = space.first(np.random.default_rng(1))[0]
    assert space.sized(own).core == 24.0 and space.sized(own).length == {"front": 22.0, "rear": 22.0}
    _, lacks = space.scored(own)
    (drive,) = space.found().drives
    assert lacks == 0 and drive.changes["shafts.left.outer_radius_mm"] == 32.0
    fresh = solve(design(Document(drive.document.data)))
    assert problem.broken(fresh.checks()) == []
    assert power(fresh) == pytest.approx(drive.objectives["power"])


@pytest.mark.slow
def test_a_search_without_proof_finds_drives_of_a_pair():
    pytest.importorskip("pymoo")
    document = parse(PAIR.encode("utf-8"), "pair")
    for table in ("gears", "friction"):
        document = document.with_value(table, None)
    problem, _ = asked(document.with_value("shafts.left.assembly", "split"), {"shaft": "left", "rows": 5})
    assert evolved(problem, POPULATION).drives
