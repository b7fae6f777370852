"""The lines of a hatch, and a dimension in strokes: what they are made of on paper and in DXF."""

import math

import pytest

from calc.draw.drawing import Area, Dimension, Hatch, Polyline, Words, enlarged, hatch_lines, moved, rectangle
from calc.draw.lettering import ARROW, room, shortened, strokes, width, wrapped, written
from calc.sheet.text import Name

H = 2.5


def test_a_hatch_has_the_area_of_what_is_cut():
    """The lengths of its lines times their distance: 100·60 less the hole's 40·20."""
    hatch = Hatch("HATCH", (rectangle(0, 0, 100, 60), rectangle(30, 20, 70, 40)), 0.1)
    lines = hatch_lines(hatch)
    assert sum(math.dist(a, b) for a, b in lines) * 0.1 == pytest.approx(100 * 60 - 40 * 20, rel=1e-3)
    assert not any(30.01 < (a[0] + b[0]) / 2 < 69.99 and 20.01 < (a[1] + b[1]) / 2 < 39.99 for a, b in lines)


@pytest.mark.parametrize("upright", [False, True])
def test_a_dimension_has_two_lines_out_two_arrows_and_its_number_above(upright):
    end, line = ((0.0, 50.0), (-20.0, 0.0)) if upright else ((50.0, 0.0), (0.0, -20.0))
    made = strokes(Dimension("DIMENSION", (0.0, 0.0), end, line, H, upright))
    arrows = [stroke for stroke in made if isinstance(stroke, Area)]
    n = 1 if upright else 0
    assert sorted(arrow.outlines[0][0][n] for arrow in arrows) == [0.0, 50.0] and all(
        arrow.outlines[0][0][1 - n] == -20.0 for arrow in arrows
    )
    assert all(0.0 < arrow.outlines[0][1][n] < 50.0 for arrow in arrows), "inside"
    (number,) = (stroke for stroke in made if isinstance(stroke, Words))
    box = room(number)
    assert number.turned is upright and number.text == "50000"
    assert (box[2] < -20.0 + 0.5 if upright else box[1] > -20.0) and (box[n] + box[n + 2]) / 2 == pytest.approx(25.0)
    assert sum(isinstance(stroke, Polyline) for stroke in made) == 3


def test_arrows_stand_outside_where_there_is_no_room():
    made = strokes(Dimension("DIMENSION", (0.0, 0.0), (2.0, 0.0), (0.0, -9.0), H, shift=12.0, label=Name("2")))
    tails = sorted(corner[0] for stroke in made if isinstance(stroke, Area) for corner in stroke.outlines[0])
    assert tails[0] == pytest.approx(-ARROW * H) and tails[-1] == pytest.approx(2.0 + ARROW * H)
    (line,) = (
        stroke.points
        for stroke in made
        if isinstance(stroke, Polyline) and stroke.points[0][1] == stroke.points[1][1] == -9.0
    )
    assert line[1][0] == pytest.approx(13.0 + width("2", H) / 2), "it goes on under its number"


def test_a_dimension_measures_in_millimetres_unless_it_is_labelled():
    assert written(Dimension("DIMENSION", (0.0, 0.0), (0.0275, 0.0), (0.0, 0.0))) == "27.5"
    assert written(Dimension("DIMENSION", (0.0, 0.0), (0.0275, 0.0), (0.0, 0.0), diameter=True)) == "⌀27.5"
    assert written(Dimension("DIMENSION", (0.0, 0.0), (0.0275, 0.0), (0.0, 0.0), label=Name("28"))) == "28"


def test_moved_and_enlarged_a_mark_keeps_its_shape():
    words = Words("TEXT", (1.0, 2.0), "abc", H)
    assert moved(words, 3.0, 4.0).at == (4.0, 6.0) and enlarged(words, 2.0).at == (2.0, 4.0)
    assert enlarged(words, 2.0).height == 2 * H
    assert [edge * 2 for edge in room(words)] == pytest.approx(room(enlarged(words, 2.0)))


def test_text_is_cut_or_broken_where_it_has_no_room():
    assert shortened("short", H, 100.0) == "short"
    cut = shortened("much longer than that", H, 30.0)
    assert cut.endswith("…") and width(cut, H) <= 30.0
    lines = wrapped("one two three four five six seven", H, 25.0)
    assert (
        " ".join(lines) == "one two three four five six seven"
        and len(lines) > 2
        and all(width(line, H) <= 25.0 for line in lines)
    )
    assert wrapped("unbreakable" * 9, H, 25.0)[0].endswith("…")
