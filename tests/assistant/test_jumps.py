# SPDX-License-Identifier: Apache-2.0
"""A jump lands where one acts: the next arrow or Enter does something there."""

from itertools import product

import pytest

from assistant.screens.palette import Palette, entries
from assistant.screens.ready import ReadyScreen
from assistant.widgets.form import Form
from assistant.widgets.radio import Todo
from assistant.widgets.text import folded
from calc.design.model import STEPS
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import settled, strike, type_in, until, work

# what one types first, and what is found first
FOUND = {
    **dict.fromkeys(("vibration", "shake", "shaking", "smooth"), "Step 2: Imbalance"),
    **dict.fromkeys(("lanchester", "balancer"), "Step 3: Counter-shaft"),
    **dict.fromkeys(("rolling", "needle", "roller", "journal"), "Step 4: Bearings"),
    **dict.fromkeys(("noise", "whine", "rattle", "knock"), "Step 5: Gears"),
    **dict.fromkeys(("efficiency", "drag"), "Step 6: Friction"),
    **dict.fromkeys(("comfort", "nvh", "harshness", "rubber mounts", "mounting"), "Step 7: Mounting"),
    **dict.fromkeys(("own", "own engine", "diesel", "petrol"), "New: own engine …"),
    "triple": "New: own",
    "v-twin": "New: own V2",
    "flat 4": "New: own boxer 4",
    "i3": "New: own inline 3",
    "l4": "New: own inline 4",
    "optimise": "Choose from a table",  # and no whole drive, which this design can not be searched for
    "cad": "Export …",
    "mend": "Remedies: what would help",
}


async def test_words_of_the_trade_find_what_they_are_about(screen: Screen) -> None:
    async with screen() as pilot:
        rows = entries(pilot.app, work(pilot))
        for words, first in FOUND.items():
            best = max(rows, key=lambda row: row.score(folded(words).split())[0])
            assert best.title.startswith(first), (words, best.title)
            score, spans = best.score(folded(words).split())
            assert score > 0 and all(end <= len(best.title) for _, end in spans)


SIZES = [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)]


@pytest.mark.parametrize("size", SIZES)
async def test_a_step_that_is_asked_for_by_name_has_the_focus_on_what_is_to_be_done(
    screen: Screen, size: tuple[int, int]
) -> None:
    async with screen(size=size) as pilot:
        bench = work(pilot)
        for before, step in (("escape", STEPS[1]), ("f7", STEPS[2]), ("escape", STEPS[6])):
            await bench.open_step(STEPS[0])
            await strike(pilot, before, "ctrl+p")
            await until(pilot, lambda: isinstance(pilot.app.screen, Palette))
            await type_in(pilot, str(step.title).lower())
            await strike(pilot, "enter")
            await until(pilot, lambda step=step: pilot.app.screen is bench and bench.step is step)  # type: ignore[misc]
            await settled(pilot)
            assert bench.pane == "inputs" and bench.focused in bench.form.stops(), (step.key, before)
        assert isinstance(bench.focused, Todo), "mounting is offered"


async def test_the_step_after_the_sixth_is_offered_until_it_is_left_out(screen: Screen) -> None:
    async with screen() as pilot:
        bench = work(pilot)
        await bench.open_step(STEPS[5])
        bench.set_focus(bench.form)
        await strike(pilot, "f3")
        await until(pilot, lambda: bench.step.key == "mounting")
        await settled(pilot)
        assert isinstance(bench.focused, Todo) and not isinstance(pilot.app.screen, ReadyScreen)
        await strike(pilot, "f2")
        await until(pilot, lambda: bench.step.key == "friction")
        bench.session.leave_out("mounting", "on a test bench")
        await strike(pilot, "f3")
        await until(pilot, lambda: isinstance(pilot.app.screen, ReadyScreen))


@pytest.mark.parametrize("size", SIZES)
async def test_after_a_finding_is_left_arrows_and_enter_do_something(screen: Screen, size: tuple[int, int]) -> None:
    async with screen(size=size) as pilot:
        bench = work(pilot)
        await solved(pilot)
        for way, key in product(("f7", "f4"), ("down", "enter")):
            await bench.open_step(STEPS[1])
            bench.form.focus_place(None, at_once=True)
            await settled(pilot)
            await strike(pilot, way)
            while bench.pane != "checks":
                await settled(pilot)
                await strike(pilot, way)
            await settled(pilot)
            assert bench.focused is bench.checks, (way, key)
            await strike(pilot, "escape")
            await settled(pilot)
            assert bench.pane == "inputs" and isinstance(bench.focused, Form)
            step = bench.step
            await strike(pilot, key)
            await settled(pilot)
            assert bench.focused in bench.form.stops() or bench.step is not step, (way, key)
