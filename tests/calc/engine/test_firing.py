"""Firing orders from cranks, cranks from firing orders, and all orders of a layout."""

import math
from itertools import pairwise

import numpy as np
import pytest

from calc.design.model import Design
from calc.engine import solve as engine
from calc.engine.crank import crank, evenest, firing, in_order
from calc.engine.inputs import EngineInputs
from calc.imbalance.firing_orders import as_designed, cranks_table, firing_orders, orders_table
from calc.imbalance.inputs import ImbalanceInputs
from calc.sheet.errors import NoSolution
from tests.calc.imbalance.engines import R753, solved


def fired(**changes):
    inputs = EngineInputs(**{**R753, **changes})
    assert list(inputs.problems()) == []
    return firing(inputs, crank(inputs, 0.0))


def angles(*degrees):
    return tuple(map(math.radians, degrees))


@pytest.mark.parametrize(
    "changes, order, intervals",
    [
        (dict(crank_angles=angles(0, 240, 120), firing_order=None), (1, 3, 2), (240, 240, 240)),
        (dict(crank_angles=angles(0, 120, 240), firing_order=None), (1, 2, 3), (240, 240, 240)),
        (dict(cylinders=1, firing_order=None), (1,), (720,)),
        (dict(cylinders=2, firing_order=None), (1, 2), (360, 360)),
        (dict(cylinders=2, firing_order=None, crank_angles=angles(0, 180)), (1, 2), (180, 540)),
        (dict(cylinders=4, firing_order=None, crank_angles=angles(0, 180, 180, 0)), (1, 3, 4, 2), (180, 180, 180, 180)),
        (
            dict(cylinders=6, firing_order=None, crank_angles=angles(0, 240, 120, 120, 240, 0)),
            (1, 5, 3, 6, 2, 4),
            (120,) * 6,
        ),
        (dict(cylinders=3, strokes=2, firing_order=(1, 3, 2)), (1, 3, 2), (120, 120, 120)),
        (
            dict(cylinders=4, firing_order=(1, 3, 2, 4), crank_angles=angles(0, 270, 90, 180)),
            (1, 3, 2, 4),
            (270, 180, 90, 180),
        ),
        (
            dict(layout="vee", cylinders=2, bank_angle=math.radians(45), firing_order=None, crank_angles=(0.0, 0.0)),
            (1, 2),
            (405, 315),
        ),
        (dict(layout="boxer", cylinders=2, firing_order=None, crank_angles=angles(0, 180)), (1, 2), (360, 360)),
    ],
)
def test_a_crank_fires(changes, order, intervals):
    found = fired(**changes)
    assert found.order == order
    assert np.degrees(found.intervals) == pytest.approx(intervals)


@pytest.mark.parametrize("cylinders, strokes", [(3, 4), (5, 4), (6, 4), (4, 4), (3, 2), (5, 2), (7, 4)])
def test_an_order_gives_a_crank_that_fires_in_it(cylinders, strokes):
    """There and back: the crank of every order allows that order, evenly; four strokes on an even crank allow others as
    well."""
    from itertools import islice, permutations

    for rest in islice(permutations(range(2, cylinders + 1)), 60):
        order = (1, *rest)
        inputs = EngineInputs(**{**R753, "cylinders": cylinders, "strokes": strokes, "firing_order": order})
        throws = crank(inputs, 0.0)
        found = in_order(throws.phi, throws.psi, strokes, order)
        assert found is not None and np.ptp(found.intervals) < 1e-9
        allowed = [f.order for f in evenest(throws.phi, throws.psi, strokes)]
        assert order in allowed
        assert len(allowed) == (2 ** (cylinders // 2 - 1) if strokes == 4 and cylinders % 2 == 0 else 1)


@pytest.mark.parametrize("off", [-0.5e-9, 0.5e-9])
@pytest.mark.parametrize("cylinder", [1, 2])
def test_dead_centres_that_rounding_parts_are_one(cylinder, off):
    """Half a billionth of a turn before or behind changes no interval of three pistons that stand at TDC together."""
    phi = np.zeros(3)
    phi[cylinder] = 2 * math.pi * off
    found = in_order(phi, np.zeros(3), 4, (1, 2, 3))
    assert found is not None and np.degrees(found.intervals) == pytest.approx((360, 360, 0))


def test_an_order_may_begin_anywhere():
    assert fired(firing_order=(3, 2, 1)).order == (1, 3, 2)
    assert solved(firing_order=(3, 2, 1))[2].orders["order_1"].vectors == pytest.approx(
        solved()[2].orders["order_1"].vectors
    )


def test_an_order_that_a_crank_can_not_fire_is_named():
    """The five's crank of 1-2-4-5-3 would need 1080° for the order turned round."""
    inputs = EngineInputs(
        **{**R753, "cylinders": 5, "crank_angles": angles(0, -144, -576, -288, -432), "firing_order": (1, 3, 5, 4, 2)}
    )
    ((key, reason),) = Design(schema=1, name="five", engine=inputs).problems()
    assert key == "engine.firing_order" and "1-2-4-5-3" in reason


def test_a_four_stroke_crank_may_fire_in_another_order_unevenly():
    found = fired(crank_angles=angles(0, 240, 120), firing_order=(1, 2, 3))
    assert np.degrees(found.intervals) == pytest.approx((120, 120, 480))


@pytest.mark.parametrize(
    "crank_angles, verdict",
    [(angles(0, 240, 120), "pass"), (angles(0, 230, 120), "note"), (angles(0, 239.5, 120), "pass")],
)
def test_uneven_firing_is_noted(crank_angles, verdict):
    outcome = engine.solve(EngineInputs(**{**R753, "crank_angles": crank_angles, "firing_order": None}))
    assert {c.id: c.verdict for c in outcome.checks}["engine.firing.even"] == verdict


@pytest.mark.parametrize("cylinders, count", [(1, 1), (2, 1), (3, 2), (4, 6), (5, 24), (6, 120), (8, 5040)])
def test_all_orders_are_listed_the_best_first(cylinders, count):
    inputs, e, _ = solved(cylinders=cylinders, firing_order=tuple(range(1, cylinders + 1)))
    found = firing_orders(ImbalanceInputs(), inputs, e)
    assert len({one.order for one in found}) == len(found) == count
    left = [one.left for one in found]
    assert left == sorted(left) or max(b - a for a, b in zip(left[1:], left)) < 1e-4 * max(left)


def test_a_listed_order_leaves_what_the_engine_with_it_leaves():
    inputs, e, _ = solved(cylinders=5, firing_order=(1, 2, 3, 4, 5))
    for one in firing_orders(ImbalanceInputs(), inputs, e)[::5]:
        orders = solved(cylinders=5, firing_order=one.order)[2].orders
        assert one.couple_1_backward == pytest.approx(orders["order_1"].couple_backward, abs=1e-9)
        assert one.couple_2 == pytest.approx(orders["order_2"].couple_peak, abs=1e-9)


def test_the_usual_orders_are_among_the_best():
    """1-3-4-2 leaves no more than any other four; of the five, 1-2-4-5-3 leaves the least first-order couple."""
    inputs, e, _ = solved(cylinders=4, firing_order=(1, 2, 3, 4))
    found = {one.order: one.left for one in firing_orders(ImbalanceInputs(), inputs, e)}
    assert found[1, 3, 4, 2] == pytest.approx(min(found.values()))
    inputs, e, _ = solved(cylinders=5, firing_order=(1, 2, 3, 4, 5))
    five = firing_orders(ImbalanceInputs(), inputs, e)
    usual = next(one for one in five if one.order == (1, 2, 4, 5, 3))
    assert usual.couple_1_backward == pytest.approx(min(one.couple_1_backward for one in five))


@pytest.mark.parametrize("cylinders, left", [(10, 0.0), (12, 0.0)])
def test_long_engines_find_a_crank_that_leaves_no_low_order(cylinders, left):
    inputs, e, _ = solved(cylinders=cylinders, firing_order=None)
    best = firing_orders(ImbalanceInputs(), inputs, e)[0]
    assert best.couple_1_backward == pytest.approx(left, abs=1e-6) and best.couple_2 == pytest.approx(left, abs=1e-6)


V12 = dict(
    layout="vee",
    cylinders=12,
    bank_angle=math.radians(60),
    firing_order=(1, 7, 5, 11, 3, 9, 6, 12, 2, 8, 4, 10),
    bank_of_cylinder=(0,) * 6 + (1,) * 6,
)


def test_a_vee_twelve_is_listed_on_common_pins():
    """Every listed order has one pin for the two cylinders of a row; the maker's own is among those that leave
    least."""
    inputs, e, _ = solved(**V12)
    found = firing_orders(ImbalanceInputs(), inputs, e)
    assert len({one.order for one in found}) == len(found)
    for one in found:
        assert np.allclose(np.exp(1j * one.crank_angles[:6]), np.exp(1j * one.crank_angles[6:]))
    assert next(one for one in found if one.order == V12["firing_order"]).left == pytest.approx(
        found[0].left, abs=1e-6 * e.reciprocating_mass
    )


@pytest.mark.parametrize(
    "changes",
    [
        dict(layout="vee", cylinders=14, bank_angle=math.radians(60), firing_order=tuple(range(1, 15))),
        dict(layout="vee", cylinders=12, bank_angle=math.radians(65), firing_order=tuple(range(1, 13))),
    ],
)
def test_engines_that_can_not_be_listed_are_refused(changes):
    inputs, e, _ = solved(**changes)
    with pytest.raises(NoSolution, match="up to 9 cylinders"):
        firing_orders(ImbalanceInputs(), inputs, e)


@pytest.mark.parametrize(
    "changes, needed",
    [
        (dict(layout="vee", cylinders=6, bank_angle=1.0), True),
        (dict(layout="boxer", cylinders=4), True),
        (dict(cylinders=13), True),
        (dict(cylinders=12), False),
        (dict(layout="boxer", cylinders=2, crank_angles=angles(0, 180)), False),
    ],
)
def test_where_no_usual_order_is_known_the_crank_is_asked_for(changes, needed):
    """Above twelve cylinders, and for banks."""
    found = dict(EngineInputs(**{**R753, "firing_order": None, **changes}).problems())
    assert ("crank_angles_deg" in found) == needed and (not needed or "needed here" in found["crank_angles_deg"])


@pytest.mark.parametrize("cylinders", range(1, 13))
def test_every_inline_engine_has_an_order_without_being_asked(cylinders):
    found = fired(cylinders=cylinders, firing_order=None)
    assert np.ptp(found.intervals) < 1e-9


@pytest.mark.parametrize("cylinders, strokes", [(3, 2), (4, 2), (6, 2), (4, 4), (5, 4), (6, 4)])
def test_every_listed_row_is_what_its_own_crank_leaves(cylinders, strokes):
    """Angles and forces of each row against an engine that is given that order."""
    inputs, e, _ = solved(cylinders=cylinders, strokes=strokes, firing_order=tuple(range(1, cylinders + 1)))
    for one in firing_orders(ImbalanceInputs(), inputs, e)[:: 1 + cylinders // 5]:
        _, own, found = solved(cylinders=cylinders, strokes=strokes, firing_order=one.order)
        assert np.allclose(np.exp(1j * own.crank.phi), np.exp(1j * one.crank_angles))
        assert one.couple_1_backward == pytest.approx(found.orders["order_1"].couple_backward, abs=1e-6)
        assert one.force_2 == pytest.approx(found.orders["order_2"].force_peak, abs=1e-6)


@pytest.mark.parametrize("strokes, cylinders, cranks", [(4, 6, 30), (4, 4, 3), (2, 4, 6), (2, 6, 120), (4, 5, 24)])
def test_orders_of_one_crank_stand_together(strokes, cylinders, cranks):
    inputs, e, _ = solved(cylinders=cylinders, strokes=strokes, firing_order=tuple(range(1, cylinders + 1)))
    found = firing_orders(ImbalanceInputs(), inputs, e)
    changes = sum(not np.allclose(a.crank_angles, b.crank_angles) for a, b in pairwise(found))
    assert changes + 1 == cranks


def test_a_two_stroke_six_without_an_order_leaves_no_first_order():
    assert solved(cylinders=6, strokes=2, firing_order=None)[2].orders["order_1"].couple_peak == pytest.approx(
        0, abs=1e-6
    )


def test_crank_angles_are_counted_from_cylinder_1():
    """The same crank, given from another direction, is the same engine; and it is said."""
    there = angles(30, 270, 150)
    assert solved(crank_angles=there, firing_order=None)[2].required == pytest.approx(solved()[2].required)
    outcome = engine.solve(EngineInputs(**{**R753, "crank_angles": there, "firing_order": None}))
    assert any("counted from cylinder 1" in note for note in outcome.notes)


@pytest.mark.parametrize("banks, order", [((0, 1, 0, 1), (1, 3, 2, 4)), ((0, 0, 1, 1), (1, 2, 3, 4))])
def test_a_boxer_numbered_by_banks_stands_where_one_numbered_in_turn_does(banks, order):
    """Cylinders 1 2 | 3 4 of the one are 1 3 | 2 4 of the other: the same engine."""
    from calc.engine.crank import crank as made

    inputs = EngineInputs(
        **{**R753, "layout": "boxer", "cylinders": 4, "bank_of_cylinder": banks, "firing_order": order}
    )
    throws = made(inputs, 0.0)
    by_bank = {bank: [z for z, b in zip(throws.z, banks) if b == bank] for bank in (0, 1)}
    assert by_bank[0] == pytest.approx([-0.168, 0.056]) and by_bank[1] == pytest.approx([-0.056, 0.168])


def test_the_table_of_the_crank_says_what_the_layout_was_taken_for():
    outcome = engine.solve(
        EngineInputs(
            **{
                **R753,
                "layout": "vee",
                "cylinders": 4,
                "bank_angle": math.pi / 2,
                "firing_order": None,
                "crank_angles": angles(0, 180, 0, 180),
                "bank_of_cylinder": (0, 0, 1, 1),
            }
        )
    )
    table = next(t for t in outcome.tables if t.id == "crank")
    assert [row[3] for row in table.rows] == [1, 2, 1, 2]
    assert [row[1] for row in table.rows] == [-45, -45, 45, 45]
    assert any("firing order is chosen" in note for note in outcome.notes)


@pytest.mark.parametrize(
    "strokes, cylinders",
    [(4, n) for n in (7, 10, 11, 12)]
    + [(2, n) for n in (4, 5, 6, 7, 8, 10, 11)]
    + [pytest.param(*row, marks=pytest.mark.slow) for row in ((4, 9), (2, 9), (2, 12))],
)
def test_orders_that_are_taken_because_they_leave_least_do_so(strokes, cylinders):
    """What stands in the table of orders is what the ranking finds at λ = 0.3."""
    from calc.engine.inputs import usual_order

    inputs, e, _ = solved(cylinders=cylinders, strokes=strokes, firing_order=None, rod_length=0.0535 / 0.3)
    found = firing_orders(ImbalanceInputs(), inputs, e)
    taken = next(one for one in found if one.order == usual_order(cylinders, strokes))
    assert taken.left == pytest.approx(found[0].left, abs=1e-5 * e.reciprocating_mass * 0.0535 * e.angular_speed**2)


def test_of_equal_orders_the_one_that_spares_bearings_and_intake_leads():
    """Finotti 2013, 2.3.4: of the six's four orders 1-5-3-6-2-4 is best for main bearings and intake; the two of the
    four are alike."""
    six = EngineInputs(**{**R753, "cylinders": 6, "firing_order": (1, 5, 3, 6, 2, 4)})
    found = firing_orders(ImbalanceInputs(), six, engine.values(six))
    by_order = {one.order: (one.neighbours, one.same_half) for one in found}
    assert found[0].order == (1, 5, 3, 6, 2, 4) and by_order[1, 5, 3, 6, 2, 4] == (0, 0)
    assert by_order[1, 2, 4, 6, 5, 3] == (2, 4)
    assert by_order[1, 2, 3, 6, 5, 4] == (4, 4)
    assert by_order[1, 5, 4, 6, 2, 3] == (2, 4)
    four = EngineInputs(**{**R753, "cylinders": 4, "firing_order": (1, 3, 4, 2)})
    best, second = firing_orders(ImbalanceInputs(), four, engine.values(four))[:2]
    assert (best.neighbours, best.same_half) == (second.neighbours, second.same_half) == (2, 2)


@pytest.mark.parametrize("kinematics", ["exact", "two_term"])
def test_the_design_stands_above_the_orders_as_the_list_has_it(kinematics):
    """A five with an order that is not the best: its row is that of the same order further down; ranks, pins, and how
    many are shown."""
    imbalance = ImbalanceInputs(kinematics=kinematics)
    inputs, e, i = solved(imbalance, cylinders=5, firing_order=(1, 3, 5, 4, 2))
    found = firing_orders(imbalance, inputs, e)
    own, rows = (
        as_designed(imbalance, inputs, e),
        orders_table(found, 30, as_designed(imbalance, inputs, e), inputs).rows,
    )
    assert own.order == (1, 3, 5, 4, 2) and own.couple_1_forward == pytest.approx(i.orders["order_1"].couple_forward)
    same = next(row for row in rows[1:] if row[1] == "1-3-5-4-2")
    assert rows[0][0] == "" and rows[0][1:4] == same[1:4] and rows[0][4:] == pytest.approx(same[4:], abs=1e-6)
    assert [row[0] for row in rows[1:]] == list(range(1, 25)) and all(row[3] == 5 for row in rows)
    short = orders_table(found, 7, own, inputs)
    assert len(short.rows) == 8 and short.note.startswith("7 of 24 orders, under the design as it is.")


def test_of_each_crank_the_best_order_is_shown():
    """A four-stroke six: 120 orders on 30 cranks of three pins or of six."""
    inputs, e, _ = solved(cylinders=6, firing_order=(1, 2, 3, 4, 5, 6))
    found = firing_orders(ImbalanceInputs(), inputs, e)
    table = cranks_table(found, inputs, most=5)
    assert table.note.startswith("120 orders on 30 different cranks") and len(table.rows) == 5
    assert table.rows[0][0] == "-".join(map(str, found[0].order)) and len({row[1] for row in table.rows}) == 5
