"""The wall of the support beside the largest seat."""

import pytest

from calc.design.toml_file import design
from calc.solve import solve


def wall(document):
    checks = solve(design(document)).outcomes["countershaft"].checks
    return next(c for c in checks if c.id == "countershaft.support.wall")


@pytest.mark.parametrize(("seat", "left"), [(81.0, 5.5), (83.5, 4.25)])
def test_a_larger_seat_takes_half_of_what_it_grows(gamma, seat, left):
    """Finotti 2013, 4.2: 5.5 mm beside Ø81 are 4.25 beside Ø83.5, under the 5 mm that sand-cast aluminium needs."""
    told = gamma.with_value("shafts.shaft.support.wall_at_seat_mm", 81.0).with_value(
        "shafts.shaft.bearings.rear.diameter_mm", seat
    )
    assert wall(told).value == pytest.approx(left)
    assert (wall(told).verdict == "warn") == (left < 5)


def test_a_wall_without_its_seat_stands_as_it_is_given(gamma):
    assert wall(gamma.with_value("shafts.shaft.bearings.rear.diameter_mm", 83.5)).value == pytest.approx(5.5)
