"""The drawing of a shaft: its shapes, and where they and the words stand on the sheet."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.drawing import axis, outline_curve, reach, shaft_drawing, silhouette, support_marks, upwards
from calc.countershaft.outline import Piece, outline
from calc.sheet.drawing import Arc, Dimension, Polyline, Words

from .shafts import POSITIONS, UP, piece
from .shafts import drawn_shaft as shaft


@settings(deadline=None)
@given(
    half=st.floats(0.05, math.pi), angle=st.floats(-7, 7), up=st.floats(-7, 7),
    core=st.one_of(st.just(0.0), st.floats(0.001, 0.039)),
)  # fmt: skip
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


@pytest.mark.parametrize("half", [20.0, 90.0, 140.0])
def test_a_section_closes_and_has_the_area_of_sector_and_core(half):
    """Green's theorem over its arcs and lines, against the area that the outline computes."""
    whole = outline((piece(0, 10, 40.3, "sector", half, UP, 15),), derived=False)
    drawn = [p for p in shaft_drawing(whole, (), "") if p.layer == "SECTORS"]
    arcs = [p for p in drawn if isinstance(p, Arc)]
    below = -0.0403  # of the side view
    lines = [p.points for p in drawn if isinstance(p, Polyline) and not p.closed and max(y for _, y in p.points) < below]
    assert len(arcs) == 2 and len(lines) == 2
    (x, y) = arcs[0].centre
    ends = [
        (x + a.radius * math.cos(w), y + a.radius * math.sin(w)) for a in arcs for w in (a.start, a.end)
    ]  # fmt: skip
    for end in ends:
        assert min(math.dist(end, point) for line in lines for point in line) < 1e-12
    area = sum(a.radius**2 / 2 * (a.end - a.start) for a in arcs)  # radial lines add nothing about the centre
    assert area == pytest.approx(whole.area[0], rel=1e-12)


def test_a_whole_ring_is_a_circle():
    whole = outline((piece(0, 10, 40.3, "sector", 180.0, UP, 15),), derived=False)
    (ring,) = (p for p in shaft_drawing(whole, (), "") if isinstance(p, Arc))
    assert ring.end - ring.start == 2 * math.pi and ring.radius == pytest.approx(0.0403)


def test_sectors_of_the_same_shape_share_a_section():
    def letters(whole):
        return [p.text for p in shaft_drawing(whole, (), "") if isinstance(p, Words) and len(p.text) == 1]

    assert letters(shaft()) == ["A", "B"]
    alike = outline((piece(0, 10, 40, "sector", 90, UP, 15), piece(10, 20, 40, "sector", 90, UP, 15)), derived=False)
    assert letters(alike) == ["A", "A"]


def test_a_shaft_without_sectors_is_drawn_as_well():
    plain = outline((piece(0, 10, 5, "full"), piece(10, 30, 8, "full")), derived=False)
    drawn = shaft_drawing(plain, (0.005, 0.02), "")
    assert upwards(plain) == 0.0 and not [p for p in drawn if p.layer == "SECTORS"]
    assert [p for p in drawn if isinstance(p, Dimension) and p.diameter]


def test_what_rounding_leaves_between_two_pieces_is_not_drawn():
    """A hundredth of a millimetre of core between two pieces: no step, no dimension."""
    parts = (piece(0, 10, 40, "full"), piece(10, 10.01, 15, "full"), piece(10.01, 50, 40, "full"))
    drawn = shaft_drawing(outline(parts, derived=False), (), "")
    (path,) = (p.points for p in drawn if p.layer == "OUTLINE")
    assert {round(abs(y), 9) for _, y in path} == {0.04}
    lengths = sorted({round(abs(p.end[0] - p.start[0]), 9) for p in drawn if isinstance(p, Dimension) and not p.upright})
    assert lengths == [0.01001, 0.03999, 0.05]


def test_the_curve_has_the_points_of_the_drawing():
    whole = shaft()
    curve = outline_curve(whole, POSITIONS)
    assert (curve.id, curve.title, curve.equal) == ("outline", "Outline of the shaft", True)
    labels = [series.label for series in curve.series]
    assert labels == ["outline", "axis", "front support", "rear support"]
    drawn = next(p for p in shaft_drawing(whole, POSITIONS, "") if p.layer == "OUTLINE")
    body = list(zip(curve.series[0].x, curve.series[0].y))
    assert body[0] == body[-1]
    assert body[:-1] == [(pytest.approx(1e3 * x, rel=1e-12), pytest.approx(1e3 * y, rel=1e-12)) for x, y in drawn.points]
    assert curve.series[2].x[0] == -167.5 and curve.series[2].y[0] == -29.75  # under the front journal


def test_the_axis_stands_out_as_far_at_both_ends():
    (start, y), (end, also_y) = axis(shaft())
    assert y == also_y == 0 and -0.19625 - start == pytest.approx(end - 0.18075) and 0.005 < -0.19625 - start < 0.02


def test_supports_stand_under_the_journals():
    """Triangles with their tips at the lowest point of the shaft in the mid-planes, upright on both legs; without a piece there on the axis,
    where two pieces meet under the larger one."""
    places = (*POSITIONS, -0.15375, 0.5)
    for (tip, right, left), z, low in zip(support_marks(shaft(), places), places, (0.02975, 0.0405, 0.02975, 0.0)):
        assert tip == pytest.approx((z, -low)) and right[1] == left[1] < -low
        assert right[0] - z == pytest.approx(z - left[0]) and 0.001 < right[0] - z < 0.01


@pytest.mark.parametrize("half, radii", [(70.0, (40.3, 15.0)), (110.0, (40.3,)), (20.0, (40.3, 15.0)), (180.0, ())])
def test_the_edges_that_are_seen_inside_the_silhouette(half, radii):
    """Of the flat face on the side of who looks, R·cos γ and r_0·cos γ above the axis: the inner one only where the face is turned towards
    him; a whole ring has none."""
    drawn = shaft_drawing(outline((piece(0, 10, 40.3, "sector", half, UP, 15),), derived=False), (), "")
    edges = [p.points for p in drawn if p.layer == "SECTORS" and isinstance(p, Polyline) and not p.closed and min(p.points)[1] > -0.0403]
    assert [y for (_, y), _ in edges] == pytest.approx([r * 1e-3 * math.cos(math.radians(half)) for r in radii])
    assert all((a[0], b[0], a[1]) == (0.0, 0.01, b[1]) for a, b in edges)


def test_lengths_stand_in_rows_below_and_diameters_across():
    """Every piece, the span of the supports, the whole: each row further down; a diameter for each kind of cylinder."""
    found = [p for p in shaft_drawing(shaft(), POSITIONS, "") if isinstance(p, Dimension)]
    rows = {}
    for p in found:
        if not p.upright:
            rows.setdefault(round(-p.line[1], 9), []).append(round((p.end[0] - p.start[0]) * 1e3, 6))
    assert [rows[y] for y in sorted(rows)] == [[15.0, 27.5, 1.75, 151.0, 2.0, 151.0, 2.25, 26.5], [335.0], [377.0]]
    assert min(rows) > 0.0405 and min(b - a for a, b in zip(sorted(rows), sorted(rows)[1:])) > 2 * found[0].height
    across = [p for p in found if p.upright]
    assert {round((p.end[1] - p.start[1]) * 1e3, 6) for p in across} == {58.7, 59.5, 30.0, 81.0} and len(across) == 4
    for p in across:
        assert p.diameter and p.start[0] == p.end[0] and p.start[1] == -p.end[1]
        assert any(one.start < p.start[0] < one.end and one.outer_radius == p.end[1] for one in shaft().pieces if one.half_angle is None)


def test_nothing_stands_in_the_way_of_another():
    """Cross-sections below the rows of lengths and beside each other, their words beside them; the title's lines above the shaft."""
    many = [piece(0, 60, 30, "journal"), *(piece(60 + 40 * n, 100 + 40 * n, 30, "sector", 30 + 10 * n, UP, 15) for n in range(6))]
    drawn = shaft_drawing(outline(tuple(many), derived=True), (), "Shaft")
    arcs = [p for p in drawn if isinstance(p, Arc)]
    outer = [arc for arc in arcs if arc.radius == 0.03]
    assert all((arc.start + arc.end) / 2 == pytest.approx(math.pi / 2) for arc in outer) and len(outer) == 6
    centres = sorted({arc.centre for arc in arcs})
    lowest = min(p.line[1] for p in drawn if isinstance(p, Dimension) and not p.upright)
    assert len(centres) == 6 and len({y for _, y in centres}) > 1 < len({x for x, _ in centres})
    assert all(y + 0.03 < lowest and 0.0 < x - 0.03 < x + 0.03 < 0.3 for x, y in centres)
    assert min(x for x, _ in centres) < 0.04 and max(y for _, y in centres) > lowest - 0.1 and min(y for _, y in centres) > lowest - 0.4
    assert all(math.dist(a, b) > 0.06 for a in centres for b in centres if a != b)
    words = [p for p in drawn if isinstance(p, Words)]
    for one in words:
        assert all(math.dist(one.at, centre) > 0.03 for centre in centres)
        assert not -0.03 < one.at[1] < 0.03, "on the shaft"
        assert one.at[1] > 0 or min(math.dist(one.at, centre) for centre in centres) < 0.06, "beside its section"
        for other in words:
            assert one is other or one.at[0] != other.at[0] or abs(one.at[1] - other.at[1]) > min(one.height, other.height)
    lines = [p.at for p in words if p.at[1] < lowest][:4]
    assert len({x for x, _ in lines}) == 1 and [y for _, y in lines] == sorted((y for _, y in lines), reverse=True), "read downwards"
    letters = [p for p in words if len(p.text) == 1]
    assert [(p.text, round(p.at[0] * 1e3, 6)) for p in letters] == [(letter, 80 + 40 * n) for n, letter in enumerate("ABCDEF")]
    assert all(0.03 < p.at[1] < 0.04 for p in letters)


def test_the_words_say_what_is_drawn():
    text = [p.text for p in shaft_drawing(shaft(), POSITIONS, "Shaft of the test", "1:2") if isinstance(p, Words)]
    assert text.count("Shaft of the test") == 1 and "Section A" in text and "R 40.3, core 15" in text
    assert ("half-angle 70°" in text and "half-angle 110°" in text) and ("middle at 210°" in text and "middle at 30°" in text)
    assert any("1:2" in line for line in text) and any("210°" in line and "cylinder 1" in line for line in text)
    assert any("Put together" in line for line in text)
    assert not any("Put together" in p.text for p in shaft_drawing(outline(shaft().pieces, derived=False), (), "") if isinstance(p, Words))
