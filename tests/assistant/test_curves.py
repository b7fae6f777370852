# SPDX-License-Identifier: Apache-2.0
"""The pane of curves and tables: bars, variants, vectors that turn, tables that are leafed through."""

import cmath
import math
import re
from dataclasses import replace

import pytest
from textual.pilot import Pilot
from textual.widgets import Static

from assistant.session.session import Session
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.curve_view import Sight
from assistant.widgets.plot import Plot, PlotArea, extent
from assistant.widgets.table_list import Setter, TableList
from calc.locale import language
from calc.sheet.step import Curve, Series, Table, Turning
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import at_rest, rows, strike, told, until, work

ENGLISH = language("en")

WITHOUT, WITH = "without the counter-shaft", "with the counter-shaft"
NAMES = ("1st forward", "1st backward", "2nd forward")


def locus(*vectors: complex) -> Turning:
    return Turning((*NAMES, "counter-shaft")[: len(vectors)], vectors, (1, -1, 2, -1)[: len(vectors)])


def end_of(chain: Turning, variant: str) -> Series:
    ends = [chain.at(math.radians(d))[-1] for d in range(0, 361, 3)]
    return Series("couple", [z.imag for z in ends], [z.real for z in ends], variant)


BARE, BALANCED = locus(0.1, 20.0, 3.0), locus(0.1, 20.0, 3.0, -19.5)
LOCUS = Curve(
    "locus",
    "Locus of the couple",
    "right, N·m",
    "up, N·m",
    (end_of(BARE, WITHOUT), end_of(BALANCED, WITH)),
    equal=True,
    variants=(WITHOUT, WITH),
    turning=(
        Turning(BARE.names, BARE.phasors, BARE.orders, WITHOUT),
        Turning(BALANCED.names, BALANCED.phasors, BALANCED.orders, WITH),
    ),
)
ORDERS = list(range(1, 9))
BARS = Curve(
    "orders",
    "Forces by order",
    "order",
    "F, N",
    tuple(
        Series(name, ORDERS, [size / n for n in ORDERS], variant)
        for variant, size in ((WITHOUT, 800.0), (WITH, 200.0))
        for name in ("force forward", "force backward")
    ),
    bars=True,
    variants=(WITHOUT, WITH),
)
PLAIN = Curve("plain", "A plain curve", "x", "y", (Series("", [0.0, 1.0], [0.0, 1.0]),))
TABLE = Table(
    "vectors",
    "Vectors by order",
    (("Order", ""), ("Force forward", "N"), ("phase", "°"), ("Couple backward", "N·m"), ("phase", "°")),
    tuple((f"order {n}", 1234.5 / n, 12.0 * n, None, -0.00012 * n) for n in range(1, 41)),
    "Phases count from up.",
)
BODIES = Table("bodies", "Bodies", (("Body", ""), ("Mass", "kg")), (("web", 1.25), ("counterweight", 2.5)))


async def show(pilot: Pilot[int], *leaves: Curve | Table) -> CurvePane:
    """Put curves and tables made by hand where the step's own are, and go there."""
    pane = work(pilot).query_one(CurvePane)
    work(pilot).action_to_view("curve")
    pane.show("engine", leaves)
    await drawn(pilot)
    return pane


async def drawn(pilot: Pilot[int]) -> None:
    """Wait until what was chosen stands there."""
    pane = work(pilot).query_one(CurvePane)

    def stands() -> bool:
        if not pane.display or pane.leaf is None:
            return True
        if isinstance(pane.leaf, Table):
            return pane.list.display and pane.list.table is pane.leaf and pane.list.key.startswith(pane.leaf.id)
        plot = next(iter(pane.query(Plot)), None)
        if plot is None or plot._shown is None or plot._needs_rerender or plot._scale_rectangle.area == 0:
            return False
        if any(sheet.size != sheet._canvas_size for sheet in plot.query(PlotArea) if sheet.size):
            return False
        sight = plot._shown[0]
        return sight.curve is pane.curve and (sight.wanted, sight.degrees) == (pane.variant, pane.degrees)

    await until(pilot, stands)
    await at_rest(pilot)


def limits(pane: CurvePane) -> tuple[float, float, float, float]:
    plot = pane.query_one(Plot)
    return plot._x_min, plot._x_max, plot._y_min, plot._y_max


def legend(pane: CurvePane) -> str:
    return str(pane.query_one("#curve-legend", Static).content)


def picture(pane: CurvePane) -> list[str]:
    """The rows of the plot as they are on the screen."""
    region = pane.query_one(Plot).query_one("#plot").region
    text = rows(Pilot(pane.app)).splitlines()
    return [line[region.x : region.right] for line in text[region.y : region.bottom]]


# --- variants
@pytest.mark.slow
async def test_a_variant_is_shown_in_the_scale_of_all(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        pane = await show(pilot, LOCUS, BARS, PLAIN)
        assert WITHOUT in legend(pane) and "counter-shaft  " not in legend(pane).replace(WITHOUT, "")
        before = limits(pane)
        high = sum("⠀" < char <= "⣿" for row in picture(pane) for char in row)
        await strike(pilot, "escape")
        await strike(pilot, "f10")
        await drawn(pilot)
        assert WITH in legend(pane) and WITHOUT not in legend(pane)
        after = limits(pane)
        # the legend may take another row, which changes the room but not what has to be in it
        assert after[0] <= before[0] * 0.8 and after[1] >= before[1] * 0.8
        assert sum("⠀" < char <= "⣿" for row in picture(pane) for char in row) < high / 2
        await strike(pilot, "c")
        await drawn(pilot)
        assert pane.curve is BARS and WITH in legend(pane)  # remembered by its name
        await strike(pilot, "b")
        await drawn(pilot)
        assert WITHOUT in legend(pane)
        await strike(pilot, "f9", "f10")
        assert pane.curve is PLAIN and pane.variant == WITHOUT
        assert "one variant only" in told(pilot)


def test_the_axes_hold_all_variants_and_all_angles() -> None:
    x_low, x_high, y_low, y_high = extent(LOCUS)
    tips = [z for chain in LOCUS.turning for d in range(360) for z in chain.at(math.radians(d))]
    assert y_high == pytest.approx(max(z.real for z in tips), rel=0.01) and y_low == pytest.approx(
        min(z.real for z in tips), rel=0.01
    )
    assert x_high == pytest.approx(-x_low, rel=0.01)
    assert extent(BARS)[2:] == (0.0, 800.0) and extent(BARS)[:2] == (0.5, 8.5)


def test_a_curve_without_the_variant_shows_its_first() -> None:
    assert Sight(LOCUS, "another").variant == WITHOUT and Sight(PLAIN, WITH).variant == ""
    assert [s.variant for s in Sight(BARS, WITH).series] == [WITH, WITH]
    assert Sight(LOCUS, WITH).next_variant == WITHOUT
    shared = Curve(
        "shared", "", "x", "y", (Series("both", [0], [0]), Series("one", [0], [0], WITH)), variants=(WITHOUT, WITH)
    )
    assert [s.label for s in Sight(shared).series] == ["both"]


@pytest.mark.slow
async def test_new_results_keep_the_variant(screen: Screen) -> None:
    async with screen() as pilot:
        pane = await show(pilot, LOCUS)
        await strike(pilot, "escape")
        await strike(pilot, "b")
        again = replace(BARS)
        await show(pilot, again)
        assert WITH in legend(pane)


# --- vectors
@pytest.mark.slow
async def test_the_vectors_turn_with_the_crank(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        pane = await show(pilot, LOCUS, PLAIN)
        assert "crank at 0°" in legend(pane)
        for name in NAMES:
            assert name in legend(pane)
        plot = pane.query_one(Plot)
        origin, end = plot.marks
        assert origin[0] == 0 and end[0] == pytest.approx(sum(BARE.phasors))
        assert sum(row.count("●") for row in picture(pane)) == 1
        await strike(pilot, "greater_than_sign", "greater_than_sign", "greater_than_sign")
        await drawn(pilot)
        assert "crank at 30°" in legend(pane)
        turned = sum(z * cmath.exp(1j * n * math.radians(30)) for z, n in zip(BARE.phasors, BARE.orders))
        assert plot.marks[1][0] == pytest.approx(turned)
        x, y = plot.get_pixel_from_coordinate(turned.imag, turned.real)
        assert picture(pane)[y][x] == "●"
        await strike(pilot, *["less_than_sign"] * 4)
        await drawn(pilot)
        assert "crank at 350°" in legend(pane)
        await strike(pilot, "f9", "greater_than_sign")
        assert "no vectors" in told(pilot) and pane.degrees == 350


# --- lines
@pytest.mark.parametrize(
    ("backward", "ascii"),  # a circle, and a straight line that is run through more than once
    [(0.0, True), *(pytest.param(*row, marks=pytest.mark.slow) for row in ((0.0, False), (20.0, False), (20.0, True)))],
)
async def test_lines_that_run_over_each_other_are_both_seen(screen: Screen, backward: float, ascii: bool) -> None:
    theta = [math.radians(3 * n) for n in range(121)]
    x, y = [(20 - backward) * math.sin(t) for t in theta], [(20 + backward) * math.cos(t) for t in theta]
    aside = Series("aside", [60.0, 60.0], [-20.0, 20.0])
    curve = Curve(
        "same", "Two alike", "x", "y", (Series("order 1", x, y), Series("all orders", x, y), aside), equal=True
    )
    async with screen(size=(120, 40), ascii=ascii) as pilot:
        await show(pilot, curve)
        canvas, room = work(pilot).query_one("#plot", PlotArea), work(pilot).query_one(Plot)._scale_rectangle
        looks = [pilot.app.signs.look(n) for n in range(3)]  # type: ignore[attr-defined]
        cells = [canvas.get_pixel(x, y) for x in range(room.x, room.right) for y in range(room.y, room.bottom)]
        first, second, alone = ([char for char, colour in cells if colour == look.colour] for look in looks)
        assert 0.3 < len(first) / (len(first) + len(second)) < 0.6, "they take turns"
        assert alone, "nothing is taken from a line that runs alone"
        if ascii:
            assert {*first} == {looks[0].plain} and {*second} == {looks[1].plain}


# --- bars
@pytest.mark.parametrize(
    ("size", "ascii"),
    [((80, 24), True), *(pytest.param(size, False, marks=pytest.mark.slow) for size in ((120, 40), (80, 24)))],
)
async def test_bars_stand_on_the_zero_line_side_by_side(screen: Screen, size: tuple[int, int], ascii: bool) -> None:
    async with screen(size=size, ascii=ascii) as pilot:
        pane = await show(pilot, BARS)
        plot = pane.query_one(Plot)
        assert plot._y_min == 0 and list(plot._x_ticks or ()) == ORDERS
        inner = [row[1:-1] for row in picture(pane)[1:-1]]
        bottom = inner[-1]
        marks = "*x" if ascii else "█"
        first = re.match(r"\s*([^\s]+)", bottom)
        assert first is not None and set(first[1]) <= set(marks) and len(first[1]) % 2 == 0  # two bars of equal width
        wide = len(first[1]) // 2
        groups = re.findall(r"\S+", bottom)
        assert len(groups) == len(ORDERS) and {len(group) for group in groups} == {2 * wide}
        heights = [sum(row[m.start()] != " " for row in inner) for m in re.finditer(r"\S+", bottom)]
        assert heights == sorted(heights, reverse=True)
        ticks = list(plot._y_ticks or ())
        assert 800 <= plot._y_max <= 800 + ticks[1] - ticks[0]  # the axis ends within a tick of the highest bar
        assert abs(heights[0] - 800 / plot._y_max * len(inner)) <= 1
        assert heights[0] / 2 - 1 <= heights[1] <= heights[0] / 2 + 1  # 800 and 400
        if ascii:
            assert first[1] == "*" * wide + "x" * wide
            assert "* force forward" in legend(pane) and "x force backward" in legend(pane)
            assert not set("█▒░▁▂▃▄▅▆▇") & set("".join(inner))


@pytest.mark.slow
async def test_names_stand_below_their_bars_where_they_fit_else_in_the_legend(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        for names, below in (
            (("0.5", "1", "1.5", "2"), True),
            (("first of the mounts", "second", "third", "fourth"), False),
        ):
            places = range(1, len(names) + 1)
            bars = Curve(
                "named",
                "Named",
                "order",
                "F, N",
                (Series("", [*places], [4.0, 3.0, 2.0, 1.0]),),
                bars=True,
                names=names,
            )
            pane = await show(pilot, bars)
            await at_rest(pilot)
            last = next(row for row in reversed(rows(pilot).splitlines()) if re.search(r"│ +(0\.5|1) +", row))
            assert last.rpartition("│")[2].split() == ([*names] if below else [*map(str, places)])
            assert ("first of the mounts" in legend(pane)) is not below and ("4 2" in legend(pane)) is False


@pytest.mark.slow
async def test_bars_without_colours_are_told_apart(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    from assistant.app import ContralberoApp

    session.solve()
    monkeypatch.setenv("NO_COLOR", "1")
    app = ContralberoApp(session)
    async with app.run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        pane = await show(pilot, BARS)
        assert {"█", "▒"} <= set("".join(picture(pane)))
        assert "█ force forward" in legend(pane) and "▒ force backward" in legend(pane)


# --- tables
@pytest.mark.slow
async def test_tables_come_after_the_curves(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        pane = await show(pilot, PLAIN, TABLE, BODIES)
        assert pilot.app.focused is pane
        await strike(pilot, "space")
        await drawn(pilot)
        listed = pane.query_one(TableList)
        assert pilot.app.focused is listed and not pane.query_one(Plot).display
        assert "Vectors by order" in rows(pilot) and "2 of 3" in rows(pilot) and "order 1 " in rows(pilot)
        await strike(pilot, "down", "j")
        assert listed.item is not None and listed.item.rows[0].plain.startswith("order 3")
        await strike(pilot, "y")
        assert pilot.app.clipboard.split("\t")[:3] == ["order 3", "411.5", "36"]
        await strike(pilot, "Y")
        assert pilot.app.clipboard.startswith("Order order 3; Force forward 411.5 N; phase 36 °")
        await strike(pilot, "end", "down")
        await pilot.pause()
        assert "order 40" in rows(pilot) and "Phases count from up." in rows(pilot)
        await strike(pilot, "f9")
        await drawn(pilot)
        assert "counterweight" in rows(pilot) and pilot.app.focused is listed
        await strike(pilot, "space")
        await drawn(pilot)
        assert pane.curve is PLAIN and pilot.app.focused is pane and pane.query_one(Plot).display and not listed.display
        await strike(pilot, "backspace")
        await drawn(pilot)
        assert pane.leaf is BODIES
        await strike(pilot, "backspace")
        await drawn(pilot)
        assert "order 1 " in rows(pilot) and "Couple" in legend(pane)
        for leaf in (BODIES, PLAIN, TABLE, BODIES):  # what was hidden is set anew
            await strike(pilot, "f9")
            await drawn(pilot)
            assert pane.leaf is leaf and leaf.title in rows(pilot)
        assert "counterweight" in rows(pilot) and "order 1 " not in rows(pilot)


@pytest.mark.slow
async def test_curves_of_other_numbers_fit_their_frame(screen: Screen) -> None:
    """The labels of the next curve take another width; its frame is whole all the same."""
    large = Curve("large", "Large", "x", "y", (Series("", [0.0, 1.0], [0.0, 123000.0]),))
    async with screen(size=(120, 40)) as pilot:
        pane = await show(pilot, PLAIN, large, LOCUS, TABLE)
        for _ in range(12):
            await strike(pilot, "f9")
            await drawn(pilot)
            if pane.curve is not None:
                seen = picture(pane)
                corners = (seen[0][0], seen[0][-1], seen[-1][0], seen[-1][-1])
                assert all(corner in known for corner, known in zip(corners, ("┏┣┳", "┓┫┳", "┗┣┻", "┛┫┻"))), "\n".join(
                    seen
                )
                assert {row[0] for row in seen[1:-1]} <= set("┃┫") and {row[-1] for row in seen[1:-1]} <= set("┃┣")


def test_columns_are_aligned() -> None:
    set_ = Setter(TABLE, 100, ENGLISH)
    head = [row.plain for row in set_.head()]
    lines = [item.rows[0].plain for item in set_.items()[:-1]]
    assert set_.part == "" and len(head) == 2
    end = head[0].index("Force forward") + len("Force forward")
    # numbers to the right, under their label
    assert all(len(line) >= end and line[end - 1] != " " and line[end] == " " for line in lines)
    assert head[1][end - 1] == "N"
    assert [line[:8] for line in lines[:2]] == ["order 1 ", "order 2 "]
    assert lines[0].split() == ["order", "1", "1234", "12", "−1.2·10⁻⁴"]  # an empty cell stays empty
    assert set_.items()[-1].key == ""


def test_a_narrow_table_wraps_its_words_and_then_leafs_its_columns() -> None:
    words = Table(
        "t", "", (("What it is", ""), ("Mass", "kg")), (("the web beside the first crankpin, timing side", 1.0),)
    )
    set_ = Setter(words, 30, ENGLISH)
    assert set_.part == "" and len(set_.items()[0].rows) == 2
    assert set_.items()[0].rows[0].plain.endswith("1") and all(len(row.plain) <= 30 for row in set_.items()[0].rows)
    first = Setter(TABLE, 30, ENGLISH)
    assert first.part == "columns 2–3 of 5"
    seen = [Setter(TABLE, 30, ENGLISH, n).part for n in range(1, first.last + 2)]
    assert seen[-1] == seen[-2] and seen[-1].endswith("5 of 5")
    for n in range(1, first.last + 1):
        assert all(len(row.plain) <= 30 for item in Setter(TABLE, 30, ENGLISH, n).items() for row in item.rows)


@pytest.mark.slow
async def test_a_table_that_is_too_wide_is_leafed_by_columns(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        wide = Table(
            "wide", "Wide", (("Name", ""), *((f"column{n}", "N") for n in range(20))), (("a", *map(float, range(20))),)
        )
        pane = await show(pilot, wide)
        assert pilot.app.focused is pane.query_one(TableList)
        assert "columns 2–" in legend(pane) and "column19" not in legend(pane)
        for _ in range(25):
            await strike(pilot, "right")
        await drawn(pilot)
        assert "column19" in legend(pane) and "Name" in legend(pane) and "column1 " not in legend(pane)
        await strike(pilot, "shift+left")
        await drawn(pilot)
        assert "column19" not in legend(pane)


async def test_the_design_is_marked_on_its_curve(screen: Screen) -> None:
    holds = replace(PLAIN, point=(0.5, 0.5))
    fails = replace(PLAIN, id="fails", point=(0.5, 0.5), fails=True)
    async with screen(size=(120, 40)) as pilot:
        pane = await show(pilot, holds, fails)
        assert sum(row.count("●") for row in picture(pane)) == 1
        pane.choose("fails")
        await drawn(pilot)
        assert sum(row.count("✗") for row in picture(pane)) == 1
