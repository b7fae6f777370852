# SPDX-License-Identifier: Apache-2.0
"""The list of all curves and tables of a step."""

from typing import Any

import pytest
from textual.pilot import Pilot
from textual.widgets import Input, OptionList

from assistant.screens.curves import CurveList, found
from assistant.widgets.curve_pane import CurvePane
from calc.sheet.step import Curve, Series, Table
from tests.assistant.conftest import Screen
from tests.assistant.driving import strike, told, type_in, until, work
from tests.assistant.test_curves import BODIES, TABLE, drawn, show


def curve(id: str, title: str) -> Curve:
    return Curve(id, title, "x", "y", (Series("", [0.0, 1.0], [0.0, 1.0]),))


MANY: tuple[Curve | Table, ...] = (
    *(curve(f"c{n}", f"Backlash of mesh {n} over the temperature") for n in range(1, 31)),
    curve(
        "film",
        "Smallest film of the front bearing over speed, at every temperature of the oil that the design is judged by",
    ),
    curve("odd", "Markup [b]is[/b] no markup"),
    TABLE,
    BODIES,
)


async def opened(pilot: Pilot[int], key: str = "shift+f9") -> CurveList:
    await strike(pilot, key)
    await until(pilot, lambda: isinstance(pilot.app.screen, CurveList))
    await pilot.pause()
    listed = pilot.app.screen
    assert isinstance(listed, CurveList)
    return listed


def shown(listed: CurveList) -> str:
    return "\n".join("".join(segment.text for segment in strip) for strip in listed._compositor.render_strips())


def prompts(listed: CurveList) -> list[str]:
    options = listed.query_one(OptionList)
    return [str(options.get_option_at_index(n).prompt) for n in range(options.option_count)]


async def chosen(pilot: Pilot[int]) -> CurvePane:
    await until(pilot, lambda: not isinstance(pilot.app.screen, CurveList))
    await drawn(pilot)
    return work(pilot).query_one(CurvePane)


def test_words_are_found_anywhere_in_the_title() -> None:
    assert [leaf.id for leaf in found(MANY, "SPEED film")] == ["film"]
    assert [leaf.id for leaf in found(MANY, "mesh 30")] == ["c30"] and found(MANY, "  ") == list(MANY)
    assert found(MANY, "film backlash") == []


@pytest.mark.parametrize(
    ("size", "ascii"),
    [((80, 24), True), *(pytest.param(size, False, marks=pytest.mark.slow) for size in ((120, 40), (80, 24)))],
)
async def test_a_curve_is_found_and_shown(screen: Screen, size: tuple[int, int], ascii: bool) -> None:
    async with screen(size=size, ascii=ascii) as pilot:
        await show(pilot, *MANY)
        listed = await opened(pilot)
        text = shown(listed)
        assert "32 curves, 2 tables" in text and "  1 Backlash of mesh 1 over" in text and "Curves" in text
        assert all(len(row) == size[0] for row in text.splitlines()) and (">  1" if ascii else "▸  1") in text
        if ascii:
            assert not set("┌│─└┐┘╭╰▸") & set(text)
        await type_in(pilot, "film")
        await pilot.pause()
        assert [p.split("\n")[0].split()[:2] for p in prompts(listed)] == [["Curves"], ["31", "Smallest"]]
        await strike(pilot, "enter")
        pane = await chosen(pilot)
        assert pane.leaf is MANY[30] and pilot.app.focused is pane and pane.display


@pytest.mark.slow
async def test_the_list_is_moved_through_while_words_are_typed(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        await show(pilot, *MANY)
        await strike(pilot, "escape", "f9", "f9", "f9")  # the first shows the pane
        listed = await opened(pilot, "C")
        options = listed.query_one(OptionList)
        assert isinstance(listed.focused, Input)
        assert options.get_option_at_index(options.highlighted or 0).id == "c3"  # the one that is shown
        await strike(pilot, "down", "down", "up", "enter")
        pane = await chosen(pilot)
        assert pane.leaf is MANY[3]
        listed = await opened(pilot, "C")
        await type_in(pilot, "order")
        await pilot.pause()
        assert prompts(listed)[0] == "Tables"
        await strike(pilot, "enter")
        pane = await chosen(pilot)
        assert pane.leaf is TABLE and pilot.app.focused is pane.list


@pytest.mark.slow
async def test_nothing_found_and_going_back(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        pane = await show(pilot, *MANY)
        listed = await opened(pilot)
        assert any("[b]is[/b]" in p for p in prompts(listed))
        await type_in(pilot, "nonsense")
        await pilot.pause()
        assert "Nothing has these words" in shown(listed)
        await strike(pilot, "enter")
        assert pilot.app.screen is listed
        await strike(pilot, "escape")
        await until(pilot, lambda: pilot.app.screen is not listed)
        assert pane.leaf is MANY[0]
        pane.show("engine", ())
        await strike(pilot, "shift+f9")
        await pilot.pause()
        assert "no curve" in told(pilot)


async def test_the_example_s_curves_are_all_in_the_list(screen: Screen, session: Any) -> None:
    """The curves that matter most are found by the words that one would look for."""
    session.solve()
    titles = {key: outcome.whole.curves for key, outcome in session.results.outcomes.items()}
    wanted = {
        "imbalance": ("locus", "order"),
        "bearings": ("film speed",),
        "countershaft": ("deflection",),
        "gears": ("tooth mesh",),
        "friction": ("loss line of action",),
    }
    for step, words in wanted.items():
        for word in words:
            assert found(titles[step], word), (step, word)
    limited = [c for c in titles["bearings"] if c.id.startswith("film")]
    assert limited and all(c.limits for c in limited)
