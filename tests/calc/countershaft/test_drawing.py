"""The drawing of a shaft: its shapes, and where they and the words stand on the sheet."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.outline import Piece, outline
from calc.draw.drawing import Polyline
from calc.draw.shaft_outline import axis, outline_curve, reach, shaft_drawing, silhouette, support_marks, upwards
from tests.calc.countershaft.shafts import POSITIONS, UP, piece
from tests.calc.countershaft.shafts import drawn_shaft as shaft


@settings(deadline=None)
@given(
    half=st.floats(0.05, math.pi),
    angle=st.floats(-7, 7),
    up=st.floats(-7, 7),
    core=st.one_of(st.just(0.0), st.floats(0.001, 0.039)),
)
def test_the_silhouette_is_that_of_the_points_of_the_section(half, angle, up, core):
    """Against the highest and the lowest of many points of sector and core."""
    part = Piece(0.0, 0.1, 0.04, core, half, angle, "sector")
    points = [radius * math.cos(angle - up + half * n / 2000) for n in range(-2000, 2001) for radius in (0.04, core)]
    high, low = reach(part, up)
    assert high == pytest.approx(max(*points, core), abs=0.04 * (math.pi / 2000) ** 2)
    assert low == pytest.approx(-min(*points, -core), abs=0.04 * (math.pi / 2000) ** 2)


@pytest.mark.parametrize("half, low", [(60.0, 15.0), (90.0, 15.0), (110.0, 15.0), (120.0, 20.15), (180.0, 40.3)])
def test_the_side_away_from_the_sector(half, low):
    """Core up to where −R·cos γ is larger: geometry of the circular sector."""
    high, found = reach(piece(0, 1, 40.3, "sector", half, UP, 15), UP)
    assert high == pytest.approx(0.0403) and found == pytest.approx(low * 1e-3)


def test_the_first_sector_is_drawn_up_and_the_opposed_one_down():
    whole = shaft()
    assert upwards(whole) == UP
    path = silhouette(whole)
    front = [y for x, y in path if -0.152 < x + 1e-9 < 0]
    rear = [y for x, y in path if 0 < x - 1e-9 < 0.152]
    assert max(front) == pytest.approx(0.0403) and min(front) == pytest.approx(-0.015)
    assert max(rear) == pytest.approx(0.015) and min(rear) == pytest.approx(-0.0403)
    assert len(set(path)) == len(path)


def test_the_enclosed_area_is_the_sum_over_the_pieces():
    """Shoelace formula against length times height of every piece."""
    whole = shaft()
    path = silhouette(whole)
    twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(path, [*path[1:], path[0]]))
    assert abs(twice) / 2 == pytest.approx(sum(p.length * sum(reach(p, UP)) for p in whole.pieces), rel=1e-12)


def test_a_shaft_without_sectors_is_drawn_as_well():
    plain = outline((piece(0, 10, 5, "full"), piece(10, 30, 8, "full")), derived=False)
    drawn = shaft_drawing(plain, (0.005, 0.02))
    assert upwards(plain) == 0.0 and not [p for p in drawn if p.layer == "SECTORS"]
    assert [p.layer for p in drawn].count("SUPPORTS") == 2


def test_what_rounding_leaves_between_two_pieces_is_not_drawn():
    """A hundredth of a millimetre of core between two pieces: no step."""
    parts = (piece(0, 10, 40, "full"), piece(10, 10.01, 15, "full"), piece(10.01, 50, 40, "full"))
    drawn = shaft_drawing(outline(parts, derived=False), ())
    (path,) = (p.points for p in drawn if p.layer == "OUTLINE")
    assert {round(abs(y), 9) for _, y in path} == {0.04}


def test_the_curve_has_the_points_of_the_drawing():
    whole = shaft()
    curve = outline_curve(whole, POSITIONS)
    assert (curve.id, curve.title, curve.equal) == ("outline", "Outline of the shaft", True)
    labels = [series.label for series in curve.series]
    assert labels == ["outline", "axis", "front support", "rear support"]
    drawn = next(p for p in shaft_drawing(whole, POSITIONS) if p.layer == "OUTLINE")
    body = list(zip(curve.series[0].x, curve.series[0].y))
    assert body[0] == body[-1]
    assert body[:-1] == [
        (pytest.approx(1e3 * x, rel=1e-12), pytest.approx(1e3 * y, rel=1e-12)) for x, y in drawn.points
    ]
    assert curve.series[2].x[0] == -167.5 and curve.series[2].y[0] == -29.75  # under the front journal


def test_the_axis_stands_out_as_far_at_both_ends():
    (start, y), (end, also_y) = axis(shaft())
    assert y == also_y == 0 and -0.19625 - start == pytest.approx(end - 0.18075) and 0.005 < -0.19625 - start < 0.02


def test_supports_stand_under_the_journals():
    """Triangles with their tips at the lowest point of the shaft in the mid-planes, upright on both legs; without a
    piece there on the axis, where two pieces meet under the larger one."""
    places = (*POSITIONS, -0.15375, 0.5)
    for (tip, right, left), z, low in zip(support_marks(shaft(), places), places, (0.02975, 0.0405, 0.02975, 0.0)):
        assert tip == pytest.approx((z, -low)) and right[1] == left[1] < -low
        assert right[0] - z == pytest.approx(z - left[0]) and 0.001 < right[0] - z < 0.01


@pytest.mark.parametrize("half, radii", [(70.0, (40.3, 15.0)), (110.0, (40.3,)), (20.0, (40.3, 15.0)), (180.0, ())])
def test_the_edges_that_are_seen_inside_the_silhouette(half, radii):
    """Of the flat face on the side of who looks, R·cos γ and r_0·cos γ above the axis: the inner one only where the
    face is turned towards him; a whole ring has none."""
    drawn = shaft_drawing(outline((piece(0, 10, 40.3, "sector", half, UP, 15),), derived=False), ())
    edges = [
        p.points
        for p in drawn
        if p.layer == "SECTORS" and isinstance(p, Polyline) and not p.closed and min(p.points)[1] > -0.0403
    ]
    assert [y for (_, y), _ in edges] == pytest.approx([r * 1e-3 * math.cos(math.radians(half)) for r in radii])
    assert all((a[0], b[0], a[1]) == (0.0, 0.01, b[1]) for a, b in edges)
