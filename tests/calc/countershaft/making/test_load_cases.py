"""The loads of the support that are handed to finite elements."""

import cmath

import pytest

from tests.calc.countershaft.shafts import outcome

SUPPORT = {"material": "EN AC-43100"}
BOLTS = {
    "thread": "M10",
    "torque_Nm": 45.0,
    "friction": 0.12,
    "head_diameter_mm": 15.0,
    "hole_diameter_mm": 11.0,
    "count": 4,
    "method": "source",
}


def cases(**shaft):
    return [table for table in outcome(**shaft).tables if table.id == "support_loads"]


def test_the_four_cases_of_the_source():
    """Finotti 2013, 4.7 (in chapter 6): 1710.15 N on either bearing, opposite each other, in four directions, and 27
    086 N of each bolt; its shaft leaves 6.8 N of force, so that its two reactions differ."""
    (table,) = cases(support=SUPPORT, bolts=BOLTS)
    front = [complex(*row[2:4]) for row in table.rows]
    rear = [complex(*row[4:6]) for row in table.rows]
    assert (
        [round(cmath.phase(F) * 180 / cmath.pi) % 360 for F in front]
        == [row[1] for row in table.rows]
        == [0, 90, 180, 270]
    )
    assert all(abs(F) == pytest.approx(1710.15, rel=3e-3) and abs(F + other) < 10 for F, other in zip(front, rear))
    assert all(row[6] == pytest.approx(27085.957, abs=1e-3) for row in table.rows)


def test_no_cases_without_a_support_and_no_preload_without_bolts():
    assert not cases(bolts=BOLTS)
    assert [len(row) for row in cases(support=SUPPORT)[0].rows] == [6] * 4
    assert not cases(support=SUPPORT, bearing_positions_mm=[-167.5, 0.0, 167.5])
