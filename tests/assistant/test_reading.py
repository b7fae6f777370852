# SPDX-License-Identifier: Apache-2.0
"""Reading a curve off: where the cursor can stand, what it says, and that it stays there."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from textual.geometry import Region
from textual.pilot import Pilot
from textual_plot.plot_widget import map_coordinate_to_pixel

from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.curve_view import Cursor, Sight, even_ticks, ticks
from assistant.widgets.plot import Plot
from assistant.widgets.reading import Digits, Reader, Reading, axis, step_of
from calc.sheet.step import Curve, Series
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, rows, strike, type_in, work
from tests.assistant.test_curves import BARS, LOCUS, PLAIN, WITH, drawn, legend, picture, show

SPEED = [900.0, 1200.0, 1700.0, 2600.0]
MIDDLE, EDGE = [16.0, 13.0, 11.5, 10.2], [14.0, 11.0, 9.5, 7.4]
FILM = Curve(
    "film",
    "Smallest film over speed",
    "speed, rpm",
    "h_0, µm",
    (Series("mid-bearing", SPEED, MIDDLE), Series("at the edge", SPEED, EDGE)),
    limits=(("Kreisle", 9.0), ("Trumpler", 7.46)),
)
SQUARE = Curve(
    "square", "A square", "x, mm", "up: first mass, mm", (Series("line", [0, 4, 4, 0, 0], [0, 0, 4, 4, 0]),), equal=True
)
TURN = np.arange(0, 361, 3.0)
CIRCLES = Curve(
    "circles",
    "Two loci",
    "right, N·m",
    "up, N·m",
    tuple(
        Series(name, r * np.sin(np.radians(TURN)), r * np.cos(np.radians(TURN)))
        for name, r in (("before", 20.0), ("after", 0.05))
    ),
    equal=True,
    along=("crank angle, °", TURN),
)
NAMED = replace(
    BARS,
    names=tuple(f"loss {n}" for n in range(1, 9)),
    variants=(),
    series=tuple(replace(s, variant="") for s in BARS.series[:2]),
)


def reader(curve: Curve, variant: str = "") -> Reader:
    return Reader(Sight(curve, variant))


def read(curve: Curve, place: float, line: int = 0) -> Reading:
    return reader(curve).read(Cursor(place, line))


# --- what is read
@pytest.mark.parametrize("speed", [900.0, 1033.0, 1700.0, 2599.0, 2600.0])
def test_a_function_is_read_between_its_points(speed: float) -> None:
    reading = read(FILM, speed)
    assert [r.y for r in reading.reads] == pytest.approx(
        [np.interp(speed, SPEED, MIDDLE), np.interp(speed, SPEED, EDGE)]
    )
    assert reading.at == f"speed {speed:.0f} rpm" and reading.x == speed
    falling = replace(FILM, series=(Series("down", SPEED[::-1], MIDDLE[::-1]),))
    assert read(falling, speed).reads[0].y == pytest.approx(np.interp(speed, SPEED, MIDDLE))


def test_distances_name_the_limits_the_nearest_first() -> None:
    middle, edge = read(FILM, 2600.0).reads
    assert middle.value == "10.20 µm" and middle.distances == ("1.20 above Kreisle", "2.74 above Trumpler")
    assert edge.value == "7.40 µm" and edge.distances == ("0.06 below Trumpler", "1.60 below Kreisle")
    on = replace(FILM, series=(Series("flat", SPEED, [9.0] * 4),), limits=(("Kreisle", 9.0), ("none", math.nan)))
    assert read(on, 1000.0).reads[0].distances == ("on Kreisle",)


def test_a_series_says_nothing_where_it_has_nothing() -> None:
    short = replace(
        FILM,
        series=(FILM.series[0], Series("short", [1000.0, 1200.0], [1.0, 2.0]), Series("none", [math.nan], [math.nan])),
    )
    reading = read(short, 2000.0)
    assert [r.value for r in reading.reads][1:] == ["–", "–"] and reading.reads[1].distances == ()
    assert read(short, 1100.0).reads[1].y == pytest.approx(1.5)


def test_numbers_of_a_series_have_the_same_decimals() -> None:
    digits = Digits([0.1234, 15.6])
    assert [str(digits.write(v)) for v in (15.6, 0.00321, -7.4, -0.0001)] == ["15.60", "0.00", "−7.40", "0.00"]
    assert str(Digits([5131.2]).write(-2719.8)) == "−2720" and str(Digits([0.11]).write(0.08671)) == "0.0867"
    assert str(Digits([3e-7]).write(2.5e-7)) == "2.5·10⁻⁷" and str(Digits([1e-14], 1e-6).write(1e-14)) == "0"
    small = read(CIRCLES, 0.0).reads[1]
    assert small.value == "right 0.00000, up 0.05000 N·m, length 0.05000"  # not rounded by the large one beside it


def test_names_and_units_of_axes() -> None:
    assert axis("speed, rpm") == ("speed", "rpm") and axis("order") == ("order", "")
    assert axis("x from T₁, mm (A 5.13, C 9.90, E 14.50)") == ("x from T₁", "mm")


def test_bars_are_read_whole() -> None:
    reading = read(BARS, 3.2)
    assert reading.at == "order 3" and [r.value for r in reading.reads] == ["266.7 N", "266.7 N"]
    assert read(NAMED, 7.0).at == "7 loss 7"


def test_points_are_read_where_there_is_no_function() -> None:
    reading = read(SQUARE, 2.0)
    assert reading.at == "point 3 of 5" and reading.x is None and reading.value == "x 4.000, up 4.000 mm"
    locus = read(CIRCLES, 91.0)
    assert locus.at == "crank angle 90°" and [r.label for r in locus.reads] == ["before", "after"]
    assert locus.reads[0].value == "right 20.00, up 0.00 N·m, length 20.00"


def test_nothing_to_read() -> None:
    assert reader(Curve("none", "None", "x", "y", (Series("", [], []),))).kind == ""


# --- where the cursor goes
def test_steps_are_round_and_end_at_the_ends() -> None:
    assert step_of(0, 360) == 10 and step_of(900, 2600) == 50 and step_of(-20, 20) == 1 and step_of(1, 1) == 1
    film = reader(FILM)
    start = film.start()
    assert start.place == 1750.0 or start.place == 1700.0 or start.place == 1800.0
    on = film.moved(Cursor(1033.0), 1)
    assert on.place == 1050.0 and film.moved(on, 1).place == 1100.0 and film.moved(Cursor(1033.0), -1).place == 1000.0
    assert film.moved(on, 1, fine=True).place == 1055.0 and film.moved(on, -1, fine=True).place == 1045.0
    assert film.ended(on, True).place == 2600.0 and film.ended(on, False).place == 900.0
    assert film.moved(Cursor(2600.0), 1).place == 2600.0 and film.kept(Cursor(5000.0, 7)) == Cursor(2600.0, 1)


def test_points_and_bars_are_gone_through_one_by_one() -> None:
    circles = reader(CIRCLES)
    at = circles.moved(Cursor(0.0), 1, fine=True)
    assert (
        at.place == 3.0 and circles.moved(Cursor(0.0), 1).place == 6.0 and circles.moved(Cursor(0.0), -1).place == 0.0
    )
    assert reader(BARS).moved(Cursor(3.0), 1).place == 4.0
    square = reader(replace(SQUARE, series=(*SQUARE.series, Series("two", [0, 1], [1, 2]))))
    assert square.moved(Cursor(0.0), 1).place == 1.0 and square.other(Cursor(4.0), 1) == Cursor(1.0, 1)
    assert square.nearest(1.1, 1.9, 0.1, 0.2) == Cursor(1.0, 1)
    assert reader(FILM).nearest(1000.0, 12.0, 1.0, 1.0) == Cursor(1000.0, 1)


@pytest.mark.parametrize("rows", [6, 9, 12, 17, 30])
@pytest.mark.parametrize("low, high", [(4.4, 12.1), (-0.37, 0.91), (0.0, 1234.0), (990.0, 991.7)])
def test_ticks_stand_equally_many_rows_apart(low: float, high: float, rows: int) -> None:
    start, end, places = even_ticks(low, high, rows, grounded=low == 0)
    at = [map_coordinate_to_pixel(0, y, 0, 1, start, end, Region(0, 0, 1, rows))[1] for y in places]
    assert len({below - above for below, above in pairwise(at)}) == 1 and at[0] - at[1] >= 2
    assert start <= low and high <= end + 1e-6 * (high - low) and end - start < 1.8 * (high - low)


def test_angles_have_ticks_at_parts_of_a_turn() -> None:
    assert ticks(0, 360, 9, degrees=True) == [45.0 * n for n in range(9)] and ticks(0, 360, 6, degrees=True)[1] == 60
    assert ticks(-20, 20, 9, degrees=True) == ticks(-20, 20, 9) and ticks(0, 1, 5, degrees=True) == ticks(0, 1, 5)


# --- on the screen
async def at_curve(pilot: Pilot[int], *leaves: Curve) -> CurvePane:
    pane = await show(pilot, *leaves)
    await strike(pilot, "escape")
    work(pilot).action_to_view("curve")
    await drawn(pilot)
    return pane


@pytest.mark.parametrize(
    ("size", "ascii"),
    [((80, 24), True), *(pytest.param(size, False, marks=pytest.mark.slow) for size in ((120, 40), (80, 24)))],
)
async def test_the_cursor_reads_and_goes(screen: Screen, size: tuple[int, int], ascii: bool) -> None:
    async with screen(size=size, ascii=ascii) as pilot:
        pane = await at_curve(pilot, FILM, PLAIN)
        mark, line = ("#", "|") if ascii else ("◆", "│")
        assert mark not in "".join(picture(pane))
        await strike(pilot, "end")
        await drawn(pilot)
        said, micro = legend(pane), "um" if ascii else "µm"
        assert "speed 2600 rpm" in said and f"mid-bearing 10.20 {micro}, 1.20 above Kreisle" in said
        assert "below Trumpler" in said
        assert all(len(row) <= pane.size.width for row in said.splitlines())
        await strike(pilot, "left", "shift+left")
        await drawn(pilot)
        assert "speed 2545 rpm" in legend(pane)
        seen = picture(pane)
        column = next(row.index(mark) for row in seen if mark in row)
        assert sum(row[column] == line for row in seen[1:-1]) >= len(seen) - 6, "\n".join(seen)
        plot = pane.query_one(Plot)
        value = float(np.interp(2545.0, SPEED, MIDDLE))
        assert seen[plot.get_pixel_from_coordinate(2545.0, value)[1]][column] == mark
        await strike(pilot, "y")
        assert pilot.app.clipboard == f"{value:.2f} {micro}"
        await strike(pilot, "down", "y")
        assert pilot.app.clipboard.startswith(f"{np.interp(2545.0, SPEED, EDGE):.2f}"[:3])
        await strike(pilot, "Y")
        copied = pilot.app.clipboard
        assert (
            copied.startswith("Smallest film over speed: speed 2545 rpm; mid-bearing ") and "; at the edge " in copied
        )
        assert "above Kreisle" in copied and "Trumpler" in copied
        await strike(pilot, "escape")
        await drawn(pilot)
        assert pane.cursor is None and "speed 2545" not in legend(pane) and mark not in "".join(picture(pane))
        assert work(pilot).pane == "curve"
        await strike(pilot, "right", "space")
        await drawn(pilot)
        assert pane.curve is PLAIN and pane.cursor is None


@pytest.mark.slow
async def test_limits_are_named_and_known_without_colour(screen: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    async with screen(size=(120, 40)) as pilot:
        pane = await at_curve(pilot, FILM)
        seen = picture(pane)
        assert any(" Kreisle " in row for row in seen) and any(" Trumpler " in row for row in seen), "\n".join(seen)
        signs = pilot.app.signs  # type: ignore[attr-defined]
        assert signs.limit().line_mark not in {signs.look(n).line_mark for n in range(12)}
        assert signs.limit().pattern not in {signs.look(n).pattern for n in range(12)}
        assert "Kreisle 9 µm" in legend(pane) and "Trumpler 7.46 µm" in legend(pane)


@pytest.mark.slow
async def test_the_cursor_stays_where_it_is(screen: Screen) -> None:
    """When the results are solved again, and when the variant changes."""
    async with screen(size=(120, 40)) as pilot:
        bench, pane = work(pilot), work(pilot).query_one(CurvePane)
        await strike(pilot, "escape")
        bench.action_to_view("curve")
        await drawn(pilot)
        await strike(pilot, "right", "right", "right")
        await drawn(pilot)
        before, at = pane.reading, pane.cursor
        assert before is not None and pane.curve is not None
        box = await go_to(pilot, "engine.bore_mm")
        await go_to(pilot, "engine.crank_radius_mm")
        assert box is not None
        await strike(pilot, "home", *["delete"] * 8)
        await type_in(pilot, "50")
        await strike(pilot, "enter")
        await solved(pilot)
        await drawn(pilot)
        after = pane.reading
        assert after is not None and pane.cursor == at and after.at == before.at and after.value != before.value
        assert before.at in legend(pane) and after.value in legend(pane)
        one = pane.curve.series[0]
        assert after.reads[0].y == pytest.approx(np.interp(at.place, one.x, one.y))  # type: ignore[union-attr]
        await show(pilot, BARS)
        assert pane.cursor is None
        await strike(pilot, "escape")
        bench.action_to_view("curve")
        await strike(pilot, "home", "right")
        await drawn(pilot)
        assert "order 2" in legend(pane) and "400.0 N" in legend(pane) and "".join(picture(pane)).count("◆") == 1
        await strike(pilot, "b")
        await drawn(pilot)
        assert WITH in legend(pane) and "order 2" in legend(pane) and "100.0 N" in legend(pane)


@pytest.mark.slow
async def test_loci_have_marks_on_their_points(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        pane = await at_curve(pilot, CIRCLES, LOCUS)
        await strike(pilot, "home", "shift+right")
        await drawn(pilot)
        assert "crank angle 3°" in legend(pane) and "length 20.00" in legend(pane)
        plot = pane.query_one(Plot)
        x, y = plot.get_pixel_from_coordinate(20 * math.sin(math.radians(3)), 20 * math.cos(math.radians(3)))
        assert picture(pane)[y][x] == "◆" and "◇" in "".join(picture(pane))
        await strike(pilot, "up", "y")
        assert pane.cursor == Cursor(3.0, 1) and pilot.app.clipboard.endswith("length 0.05000")
        await strike(pilot, "c", "right")
        await drawn(pilot)
        assert pane.curve is LOCUS and "point " in legend(pane) and "length" in legend(pane)


@pytest.mark.slow
async def test_the_mouse_puts_the_cursor(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        pane = await at_curve(pilot, FILM)
        plot = pane.query_one(Plot)
        column, row = plot.get_pixel_from_coordinate(1200.0, 11.0)
        await pilot.click("#plot", offset=(column, row))
        await drawn(pilot)
        assert pane.cursor is not None and pane.cursor.line == 1
        assert pane.cursor.place == pytest.approx(1200.0, abs=(2600 - 900) / plot._scale_rectangle.width)
        before = pane.cursor
        await pilot.click("#curve-legend")
        assert pane.cursor == before


@pytest.mark.slow
async def test_keys_that_find_nothing_to_read(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        pane = await at_curve(pilot, PLAIN)
        pane.show("engine", (Curve("none", "None", "x", "y", (Series("", [], []),)),))
        await strike(pilot, "right", "home", "down", "y")
        assert pane.cursor is None and pilot.app.clipboard == "None"
        pane.show("engine", ())
        await strike(pilot, "left", "end", "up")
        assert pane.cursor is None
        await show(pilot, FILM)
        work(pilot).form.focus()
        await pilot.pause()
        await strike(pilot, "right", "shift+left", "home")  # in the form, not in the pane
        assert pane.cursor is None and "Smallest film over speed" in rows(pilot)
