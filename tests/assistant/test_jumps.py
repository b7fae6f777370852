# SPDX-License-Identifier: Apache-2.0
"""A jump lands where one acts: the next arrow or Enter does something there."""

from itertools import product

import pytest

from assistant.screens.palette import Palette
from assistant.screens.ready import ReadyScreen
from assistant.widgets.form import Form
from assistant.widgets.radio import Todo
from calc.design.model import STEPS
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import settled, strike, type_in, until, work

SIZES = [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)]


@pytest.mark.parametrize("size", SIZES)
async def test_a_step_that_is_asked_for_by_name_has_the_focus_on_what_is_to_be_done(
    screen: Screen, size: tuple[int, int]
) -> None:
    async with screen(size=size) as pilot:
        bench = work(pilot)
        for idle in (True, False):
            for step in STEPS:
                await bench.open_step(STEPS[0])
                await strike(pilot, *(("escape",) if idle else ("f7",)))
                await strike(pilot, "ctrl+p")
                await until(pilot, lambda: isinstance(pilot.app.screen, Palette))
                await type_in(pilot, str(step.title).lower())
                await strike(pilot, "enter")
                await until(pilot, lambda: pilot.app.screen is bench and bench.step is step)
                await settled(pilot)
                assert bench.pane == "inputs" and bench.focused in bench.form.stops(), (step.key, idle)
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
