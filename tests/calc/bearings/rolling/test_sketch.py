# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings as they are drawn: to scale, each with what it has, the load on the ring on which it stands."""

import pytest

from calc.bearings.rolling.sketch import pictures
from calc.bearings.sketch import sketch
from calc.design.toml_file import design, parse
from calc.draw.drawing import Arc, Area, Polyline, Words, reach
from calc.solve import solve
from tests.calc.bearings.test_comparison import ALONE


def drawn(size, more=""):
    text = ALONE.replace('size = "HK2520"', f'size = "{size}"\n{more}')
    results = solve(design(parse(text.encode(), "alone.toml")))
    outcome = results.outcomes["bearings"]
    r = outcome.result.bearings["rear"]
    return r, pictures({"rear": r}, {c.id: c for c in outcome.checks})["rear"], results


def elements(picture):
    """Outlines of balls, and of rollers."""
    mine = [mark for mark in picture.primitives if "element_diameter_mm" in getattr(mark, "key", "")]
    return [m for m in mine if isinstance(m, Arc)], [m for m in mine if isinstance(m, Polyline) and m.closed]


@pytest.mark.parametrize("size", ["6205", "NU205", "NJ2305", "NA4905", "RNA4905", "HK2520", "K25x30x20"])
def test_every_kind_is_drawn_to_scale(size):
    r, picture, _ = drawn(size, 'outer_ring_held = "insert"' if size.startswith("K") else "")
    balls, rollers = elements(picture)
    inside = r.case.inside
    if inside.elements == "ball":
        (ball,) = balls
        assert (ball.radius, ball.centre[1]) == (pytest.approx(inside.diameter / 2), pytest.approx(inside.pitch / 2))
        assert not rollers
    else:
        (roller,) = rollers
        xs, ys = zip(*roller.points)
        assert max(xs) - min(xs) == pytest.approx(inside.length)
        assert max(ys) - min(ys) == pytest.approx(inside.diameter)
        assert (max(ys) + min(ys)) / 2 == pytest.approx(inside.pitch / 2)
        assert not balls
    left, bottom, right, top = picture.box
    assert bottom >= 0 and top > r.case.size.outside / 2 and right - left > r.case.size.width
    words = [str(mark.text) for mark in picture.primitives if isinstance(mark, Words)]
    assert any(word.startswith(f"Ø{r.case.size.outside * 1e3:g} ") for word in words)


def test_the_load_stands_on_the_inner_ring():
    r, picture, _ = drawn("NU205")
    (arrow,) = [m for m in picture.primitives if isinstance(m, Polyline) and m.arrow and m.points[0][0] == 0]
    assert arrow.points[-1] == (0.0, pytest.approx(r.case.size.bore / 2)) and arrow.key.endswith("load_N")
    (dot,) = [m for m in picture.primitives if isinstance(m, Area) and m.shade == 1.0]
    inner = (r.case.inside.pitch - r.case.inside.diameter) / 2
    ys = [y for _, y in reach(dot)]
    assert r.case.size.bore / 2 < sum(ys) / len(ys) < inner


def test_a_loose_ring_is_marked_and_an_insert_drawn():
    _, loose, _ = drawn("NU205")
    assert any(m.state == "fail" and "outer_ring_held" in m.key for m in loose.primitives if isinstance(m, Words))
    _, held, _ = drawn("NU205", 'outer_ring_held = "insert"')
    assert sum(isinstance(m, Polyline) for m in held.primitives) > sum(
        isinstance(m, Polyline) for m in loose.primitives
    )


def test_both_kinds_stand_beside_each_other():
    text = ALONE[: ALONE.index('[[shafts.bearings]]\nname = "rear"')]
    text += """[[shafts.bearings]]
name = "rear"
position_mm = 167.5
diameter_mm = 40.0
length_mm = 24.0
clearance_um = 60.0
load_N = 1700.0
journal_roughness_um = 0.4
housing_roughness_um = 0.4
"""
    text += ALONE[ALONE.index("[bearings]\n") :].replace("speed_rpm = 2600.0\n[[", (
        'speed_rpm = 2600.0\nsupply = "hole"\nhole_diameter_mm = 4.0\nsupply_pressure_bar = 3.0\n[['
    ), 1)  # fmt: skip
    made = design(parse(text.encode(), "mixed.toml"))
    first = sketch(made, solve(made))
    titles = [str(first.title), *(str(one.title) for one in first.beside)]
    assert titles[0].startswith("front 6205") and any(title.startswith("rear Ø40") for title in titles[1:])
