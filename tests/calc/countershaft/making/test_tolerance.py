"""ISO 21940-11 on a shaft of 8.914 kg at 2600 rpm."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.countershaft.making.unbalance import grade_number, notes, permitted, table
from calc.library.tolerances import BALANCE_GRADES

OMEGA = 2 * math.pi * 2600 / 60
MASS, HALF, REQUIRED = 8.914, 0.1675, 572.932


def found(grade="G6.3", z_S=0.0, mass=MASS, omega=OMEGA, C=REQUIRED):
    return permitted(grade, mass, omega, z_S, -HALF, HALF, C)


@pytest.mark.parametrize(
    ("grade", "unbalance", "couple", "share"),
    [("G2.5", 81.8, 1.02, 0.18), ("G6.3", 206.3, 2.56, 0.45), ("G16", 523.8, 6.50, 1.14), ("G40", 1309.6, 16.26, 2.84)],
)
def test_u_per_and_the_couple_it_may_leave(grade, unbalance, couple, share):
    """Worked by hand: U_per = G·m/ω in g·mm; half of it in each plane, opposed over 335 mm."""
    r = found(grade)
    assert r.residual_unbalance_permitted * 1e6 == pytest.approx(unbalance, abs=0.05)
    assert r.permitted_couple_error == pytest.approx(couple, abs=5e-3)
    assert r.permitted_couple_error_share * 100 == pytest.approx(share, abs=5e-3)
    assert r.residual_unbalance_permitted_front == pytest.approx(r.residual_unbalance_permitted / 2)
    assert r.residual_unbalance_permitted_rear == pytest.approx(r.residual_unbalance_permitted / 2)


def test_a_grade_is_a_speed():
    """1 kg at 10 rad/s and G40: 4 g·m, that is 4 mm of eccentricity at 40 mm/s."""
    assert permitted("G40", 1.0, 10.0, 0.0, -1.0, 1.0, 0.0).residual_unbalance_permitted == pytest.approx(4e-3)


@pytest.mark.parametrize("grade", BALANCE_GRADES)
def test_every_grade_that_can_be_chosen_has_a_number(grade):
    assert grade_number(grade) == pytest.approx(float(grade.removeprefix("G")) * 1e-3)


@given(st.floats(-0.4 * HALF, 0.4 * HALF))
def test_the_planes_share_as_the_static_loads(z_S):
    r = found(z_S=z_S)
    front, rear, U = (
        r.residual_unbalance_permitted_front,
        r.residual_unbalance_permitted_rear,
        r.residual_unbalance_permitted,
    )
    assert front + rear == pytest.approx(U)
    assert front * (z_S + HALF) == pytest.approx(rear * (HALF - z_S))


@given(st.floats(-2 * HALF, 2 * HALF))
def test_front_and_rear_change_places_with_the_shaft_turned_round(z_S):
    here, there = found(z_S=z_S), found(z_S=-z_S)
    assert here.residual_unbalance_permitted_front == pytest.approx(there.residual_unbalance_permitted_rear)
    assert here.permitted_couple_error == pytest.approx(there.permitted_couple_error)


@pytest.mark.parametrize(
    ("z_S", "front", "rear"),
    [(0.9 * HALF, 0.3, 0.7), (1.2 * HALF, 0.3, 1.1), (2.0 * HALF, 0.5, 1.3), (-1.2 * HALF, 1.1, 0.3)],
)
def test_the_shares_of_the_planes_are_bounded(z_S, front, rear):
    """ISO 21940-11: from 0.3 to 0.7 of U_per between the planes, from 0.3 to 1.3 where the centre of gravity overhangs
    one."""
    r = found(z_S=z_S)
    assert r.residual_unbalance_permitted_front == pytest.approx(front * r.residual_unbalance_permitted)
    assert r.residual_unbalance_permitted_rear == pytest.approx(rear * r.residual_unbalance_permitted)


@pytest.mark.parametrize(
    ("z_S", "words"),
    [
        (0.0, ""),
        (0.9 * HALF, "near one bearing"),
        (1.1 * HALF, "overhangs the rear"),
        (-1.1 * HALF, "overhangs the front"),
        (0.39 * HALF, ""),
        (0.41 * HALF, "0.7 to 0.3"),
        (-0.39 * HALF, ""),
        (-0.41 * HALF, "0.7 to 0.3"),
    ],
)
@pytest.mark.parametrize("off", [0.0, 0.5])
def test_a_share_that_is_not_the_static_load_is_said(z_S, words, off):
    """Nearer to a bearing than 0.3 of their distance, wherever the middle of the shaft is."""
    said = list(notes(off + z_S, off - HALF, off + HALF))
    assert len(said) == (2 if words else 1)
    assert words in said[-1]


def test_no_required_couple_no_share():
    assert found(C=0.0).permitted_couple_error_share is None


def test_the_table_has_the_usual_grades_and_the_chosen_one():
    rows = table("G1", MASS, OMEGA, 0.0, -HALF, HALF, REQUIRED).rows
    assert [row[0] for row in rows] == ["G1, chosen", "G2.5", "G6.3", "G16", "G40"]
    assert [row[1] for row in rows][1:] == pytest.approx([81.8, 206.3, 523.8, 1309.6], abs=0.05)
    assert [row[5] for row in rows][1:] == pytest.approx([0.18, 0.45, 1.14, 2.84], abs=5e-3)
