"""The lines between two pieces of a shaft, against the geometry of sector and core."""

import math

import pytest

from calc.countershaft.outline import Piece
from calc.draw.side_view import shoulders
from calc.draw.turned import TurnedPiece

R, CORE = 0.043, 0.018


def turned(radius, half=None, angle=0.0):
    piece = Piece(
        0.0,
        0.1,
        radius,
        CORE if half else 0.0,
        half and math.radians(half),
        math.radians(angle),
        "sector" if half else "core",
    )
    return TurnedPiece(piece=piece, start=0.0, end=0.1, radius=radius)


def test_a_step_between_two_cylinders_goes_across_the_larger():
    assert shoulders(turned(0.02), turned(0.03), 0.0) == [(-0.03, 0.03)]
    assert shoulders(turned(0.02), turned(0.02), 0.0) == []


@pytest.mark.parametrize("half", [60.0, 76.6, 110.0])
def test_a_core_goes_on_into_that_of_a_sector(half):
    """The face of the sector is seen from its outside down to where its flat face meets the core: r_0·cos γ."""
    ((low, high),) = shoulders(turned(CORE), turned(R, half), 0.0)
    assert (low, high) == pytest.approx((min(CORE * math.cos(math.radians(half)), R * math.cos(math.radians(half))), R))
    ((low, high),) = shoulders(turned(R, half, 180.0), turned(CORE), 0.0)
    assert (low, high) == pytest.approx(
        (-R, max(-CORE * math.cos(math.radians(half)), -R * math.cos(math.radians(half))))
    )


def test_a_sector_on_the_far_side_hides_behind_the_core_as_far_as_that_reaches():
    """Its middle 90° away from who looks: what is seen of its face stands above and below the core."""
    parts = shoulders(turned(CORE), turned(R, 60.0, -90.0), 0.0)
    top = R * math.sin(math.radians(60.0))
    assert [(round(a, 9), round(b, 9)) for a, b in parts] == [(round(-top, 9), -CORE), (CORE, round(top, 9))]


def test_two_sectors_alike_show_no_line_and_opposed_ones_all_of_both():
    assert shoulders(turned(R, 80.0, 30.0), turned(R, 80.0, 30.0), 0.0) == []
    parts = shoulders(turned(R, 80.0), turned(R, 80.0, 180.0), 0.0)
    assert parts[0][0] == pytest.approx(-R) and parts[-1][1] == pytest.approx(R)
