# SPDX-License-Identifier: Apache-2.0
"""Sketches in character cells: true to scale, with words that are never lost or overwritten, lit where the edited field
shows."""

import pytest

from assistant.widgets.canvas import BITS, draw, noted
from assistant.widgets.signs import Signs
from calc.draw.drawing import Arc, Area, Dimension, Polyline, Sketch, Words, rectangle
from calc.locale import language
from calc.sheet.text import Text

say = language("en")
CIRCLE = Arc("OUTLINE", (0.0, 0.0), 0.05, key="engine.bore_mm")


def dots(content):
    """Places of the braille dots: across, down."""
    return {
        (2 * column + x, 4 * row + y)
        for row, line in enumerate(content.plain.split("\n"))
        for column, letter in enumerate(line)
        if 0x2800 <= ord(letter) <= 0x28FF
        for y in range(4)
        for x in range(2)
        if ord(letter) - 0x2800 & BITS[y][x]
    }


def styles(content, letters):
    """The styles in which some letters stand."""
    return {str(span.style) for span in content.spans if set(content.plain[span.start : span.end]) & set(letters)}


@pytest.mark.parametrize("size", [(50, 14), (90, 24), (20, 40)])
def test_a_circle_is_as_wide_as_high_and_fills_its_frame(size):
    xs, ys = zip(*dots(draw(Sketch((CIRCLE,)), *size, Signs(), say)))
    wide, high = max(xs) - min(xs) + 1, max(ys) - min(ys) + 1
    assert abs(wide - high) <= 1
    assert high >= 4 * size[1] - 6 or wide >= 2 * size[0] - 6


def test_what_the_edited_field_shows_is_lit_and_a_failing_part_has_its_sign():
    signs = Signs()
    sketch = Sketch((CIRCLE, Polyline("OUTLINE", ((0.0, 0.0), (0.03, 0.0)), key="engine.rod_length_mm", state="fail")))
    plain = draw(sketch, 40, 12, signs, say)
    lit = draw(sketch, 40, 12, signs, say, lit="engine.bore_mm")
    assert signs.style("lit") not in {str(span.style) for span in plain.spans}
    assert signs.style("lit") in {str(span.style) for span in lit.spans}
    assert plain.plain == lit.plain
    assert styles(plain, "✗") == {signs.style("fail")}


def test_a_part_has_one_sign_behind_its_words():
    fit, ring = "bearings.front.seat_fit", "bearings.front.seat_fit bearings.front.carrier_mm"
    marks = (
        Polyline("OUTLINE", ((0.0, 0.0), (0.03, 0.0)), key=ring, state="fail"),
        Words("TEXT", (0.04, 0.0), "N7", key=fit, state="fail"),
    )
    assert draw(Sketch(marks), 40, 12, Signs(), say).plain.count("✗") == 1
    assert draw(Sketch((marks[0],)), 40, 12, Signs(), say).plain.count("✗") == 1


def test_a_table_is_lit_by_each_of_its_fields():
    sketch = Sketch((Words("TEXT", (0.0, 0.0), "A", key="countershaft.masses.A"),))
    signs = Signs()
    assert styles(draw(sketch, 20, 5, signs, say, "countershaft.masses.A.mass_kg"), "A") == {signs.style("lit")}
    assert styles(draw(sketch, 20, 5, signs, say, "countershaft.masses.AB.mass_kg"), "A") != {signs.style("lit")}


def test_words_stay_whole_where_they_meet_and_within_the_frame():
    names = ["front bearing", "rear bearing", "gear"]
    marks = [Words("TEXT", (0.001 * n, 0.0), name) for n, name in enumerate(names)]
    content = draw(Sketch((CIRCLE, *marks, Words("TEXT", (0.05, 0.0), "at the right edge"))), 60, 16, Signs(), say)
    assert all(name in content.plain for name in (*names, "at the right edge"))
    assert {len(line) for line in content.plain.split("\n")} == {60}


def test_a_dimension_says_its_length_or_its_label():
    box = Polyline("OUTLINE", rectangle(0.0, 0.0, 0.1, 0.05), closed=True)
    marks = (
        box,
        Dimension("DIMENSIONS", (0.0, 0.0), (0.1, 0.0), (0.0, -0.02)),
        Dimension("DIMENSIONS", (0.1, 0.0), (0.1, 0.05), (0.12, 0.0), upright=True, label=Text("high")),
    )
    content = draw(Sketch(marks), 60, 16, Signs(), say)
    assert "├" in content.plain and " 100 mm " in content.plain and "high" in content.plain
    italian = draw(
        Sketch((box, Dimension("DIMENSIONS", (0.0, 0.0), (0.0125, 0.0), (0.0, -0.02)))), 60, 16, Signs(), language("it")
    )
    assert "12,5 mm" in italian.plain


def test_an_area_is_filled_and_its_hole_is_not():
    outer, inner = rectangle(-0.1, -0.1, 0.1, 0.1), rectangle(-0.05, -0.05, 0.05, 0.05)
    content = draw(Sketch((Area("OUTLINE", (outer, inner)),)), 20, 10, Signs(ascii=True), say)
    lines = content.plain.split("\n")
    assert lines[1][4] == ":" and lines[5][10] == " "


def test_without_braille_a_picture_is_ascii():
    sketch = Sketch(
        (
            CIRCLE,
            Polyline("OUTLINE", ((-0.05, 0.0), (0.05, 0.0)), state="fail"),
            Area("OUTLINE", (rectangle(0, 0, 0.02, 0.02),)),
        )
    )
    content = draw(sketch, 40, 14, Signs(ascii=True), say)
    assert content.plain.isascii()
    assert set("-|/\\:") <= set(content.plain)


def test_pictures_beside_each_other_are_left_out_where_they_get_too_small():
    beside = (Sketch((CIRCLE,), title=Text("second")), Sketch((CIRCLE,), title=Text("third")))
    sketch = Sketch((CIRCLE,), title=Text("first"), beside=beside, notes=(Text("gap × 400"),))

    def shown(columns, rows):
        words = draw(sketch, columns, rows, Signs(), say).plain
        assert "gap × 400" in words
        return [name for name in ("first", "second", "third") if name in words]

    assert shown(90, 14) == ["first", "second", "third"]
    assert shown(24, 10) == ["first"]


def test_of_the_pictures_that_have_room_those_that_show_what_is_wrong_come_before_others():
    def picture(name, state=""):
        return Sketch((Arc("OUTLINE", (0.0, 0.0), 0.05, key="engine.bore_mm", state=state),), title=Text("{n}", n=name))

    front, middle, rear = picture("front"), picture("middle"), picture("rear", "fail")
    for beside, shown in (((middle, rear), "rear"), ((rear, middle), "rear"), ((middle, picture("rear")), "middle")):
        sketch = Sketch(front.primitives, title=front.title, beside=beside)
        words = draw(sketch, 46, 10, Signs(), say).plain
        assert [name for name in ("front", "middle", "rear") if name in words] == ["front", shown]


def test_notes_are_of_the_pictures_that_are_shown_and_say_that_there_are_others() -> None:
    second = Sketch((CIRCLE,), (Text("second"),), title=Text("a title of many words"))
    both = Sketch((CIRCLE,), (Text("first"),), beside=(second,), views=2)
    small, large = (draw(both, n, 9, Signs(), say, "", Text("others")).plain for n in (20, 60))
    assert "first" in small and "second" not in small and "others" in small
    assert "first · second" in large and "others" not in large


def test_notes_take_as_many_rows_as_they_need() -> None:
    assert noted(["gap × 100", "the load points down", "pressure"], 32) == [
        "gap × 100 · the load points down",
        "pressure",
    ]
    assert noted([], 10) == []
