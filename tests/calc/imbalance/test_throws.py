"""The throws by themselves: polygons that close, static and dynamic balance, the six systems (Finotti 2013, 2.3.1 and
2.5.3)."""

from itertools import pairwise

import numpy as np
import pytest

from calc.engine.solve import solve as engine
from calc.imbalance.inputs import ImbalanceInputs
from calc.imbalance.notes import INHERENTLY
from calc.imbalance.solve import solve
from calc.imbalance.throws import balanced, polygons
from tests.calc.imbalance.engines import solved

FOUR = dict(cylinders=4, firing_order=(1, 3, 4, 2))
SIX = dict(cylinders=6, firing_order=(1, 5, 3, 6, 2, 4))
TWIN_180 = dict(cylinders=2, firing_order=None, crank_angles=(0.0, np.pi))
TWIN_360 = dict(cylinders=2, firing_order=None, crank_angles=(0.0, 0.0))
SINGLE = dict(cylinders=1, firing_order=None)


def outcome(**changes):
    inputs, _, _ = solved(**changes)
    return solve(ImbalanceInputs(), inputs, engine(inputs).solution)


def test_what_the_source_prints_of_the_r753():
    """Finotti 2013, 2.5.3: 744.67 g beyond the rotating mass, 2953.41 N of it on a throw, 572.93 N·m; √3·a·F_c of the
    rotating mass."""
    throw = solved()[2].throw
    assert throw.rotating_not_balanced == pytest.approx(0.744675)
    assert throw.reciprocating_not_balanced == pytest.approx(0.744675)
    assert throw.force_not_balanced == pytest.approx(2953.41, abs=0.005)
    assert throw.couple_not_balanced == pytest.approx(572.93, abs=0.005)
    assert throw.couple_together == pytest.approx(3**0.5 * 0.112 * 0.75865 * 272.2714**2 * 0.0535, rel=1e-6)


@pytest.mark.parametrize(
    "changes, static, dynamic",
    [
        ({}, True, False),
        (FOUR, True, True),
        (SIX, True, True),
        (TWIN_180, True, False),
        (TWIN_360, False, True),
        (SINGLE, False, True),
    ],
)
def test_static_and_dynamic_balance_by_the_throws_alone(changes, static, dynamic):
    """Three throws: static, not dynamic; four and six: both; 180°: a couple F_c·b; 360° and one throw: a force
    (textbook, 48.3.2)."""
    (said,) = [str(note) for note in outcome(**changes).notes if "bare throws" in note]
    assert ("a force of" not in said, "a couple of" not in said) == (static, dynamic)


@pytest.mark.parametrize("changes", [{}, FOUR, SIX, TWIN_180, TWIN_360])
def test_the_polygon_ends_where_the_resultant_does(changes):
    """It closes where the throws are balanced, and its second kind leaves the peak of the second order; an engineer's
    report has it, but where all of it lies on one line."""
    inputs, e, found = solved(**changes)
    drawn = polygons(inputs, e, found.throw)
    assert drawn and all(bool(curve.short) is (changes in ({}, SIX)) for curve in drawn)
    for curve, sums, second in zip(
        drawn,
        (found.throw.force_together, found.throw.couple_together),
        (found.orders["order_2"].force_peak, found.orders["order_2"].couple_peak),
    ):
        for variant, whole in zip(curve.variants, (sums, second)):
            lines = [s for s in curve.series if s.variant == variant]
            sides = [s for s in lines if s.label != "resultant"]
            end = complex(sides[-1].y[-1], sides[-1].x[-1])
            assert abs(end) == pytest.approx(whole, rel=1e-9, abs=1e-6)
            assert any(s.label == "resultant" for s in lines) == (whole > 1e-3)
            for one, after in pairwise(sides):
                assert (one.x[-1], one.y[-1]) == pytest.approx((after.x[0], after.y[0]))


def test_the_six_systems_of_the_r753():
    """Finotti 2013, 2.5.3: all three forces balanced, all three couples not."""
    table = next(t for t in outcome().tables if t.id == "systems")
    assert [str(row[3]) for row in table.rows] == ["balanced by themselves", "not balanced"] * 3
    assert [row[2] for row in table.rows[1::2]] == pytest.approx([583.684, 1145.863, 386.772], abs=1e-3)


def test_the_cause_is_that_of_the_engine():
    """A four leaves forces of second order only, and its throws mirror each other."""
    rows = next(t for t in outcome(**FOUR).tables if t.id == "systems").rows
    assert [str(row[3]) for row in rows] == ["balanced by themselves"] * 4 + ["not balanced", "balanced by themselves"]
    assert "mirror" in str(rows[1][4]) and "open" in str(rows[4][4])


def test_unlike_cylinders_leave_the_polygon_open():
    """Rotating masses 0.8, 0.7 and 0.7 kg: the 0.1 kg too much on throw 1 is left as a force, and as its couple over
    one pitch more."""
    inputs, e, found = solved(rotating_masses=(0.8, 0.7, 0.7), crankpin_bearing_mass=0.0)
    force = found.throw.force_together
    assert force == pytest.approx(0.1 * 272.2714**2 * 0.0535, rel=1e-6)
    curve = polygons(inputs, e, found.throw)[0]
    (left,) = [s for s in curve.series if s.label == "resultant" and s.variant == curve.variants[0]]
    assert np.hypot(left.x[-1], left.y[-1]) == pytest.approx(force)


def test_the_grades_of_a_crank_drive_are_those_of_its_kind(gamma_results):
    """ISO 21940-11 (its table at ascentialtech.com): G250 and G630 for the R753IE4, whose throws leave a couple; G16 and
    G40 for four in line."""
    told = " ".join(gamma_results.outcomes["imbalance"].notes)
    assert "inherently unbalanced crank drives" in told and "G250 rigidly mounted, G630 elastically" in told
    three, four = (solved(cylinders=n, firing_order=None) for n in (3, 4))
    assert balanced(three[2].throw, three[1].crank.pitch) == (True, False)
    assert balanced(four[2].throw, four[1].crank.pitch) == (True, True)
    assert "G16 rigidly mounted, G40 elastically" in INHERENTLY[True]
