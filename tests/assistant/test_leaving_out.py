"""No key leaves a step out by itself: that needs a reason in words that are typed, and without them nothing is ready."""

import random
from pathlib import Path

import pytest
from textual.pilot import Pilot
from textual.widgets import Input

from assistant.app import ContralberoApp
from assistant.screens.dialogs import LeaveOut, Reason
from assistant.screens.ready import ReadyScreen
from assistant.screens.workbench import Workbench
from assistant.session.beginnings import engine_only
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.radio import Todo
from assistant.widgets.steps import whole_of
from calc.design.addresses import asks
from calc.design.model import STEPS
from calc.studies.ready import OF_PROGRAM
from tests.assistant.conftest import Screen
from tests.assistant.driving import settled, strike, until, work
from tests.assistant.test_from_engine_to_ready import Hands
from tests.assistant.test_fuzz import enclosed  # noqa: F401

KEYS = (
    *["enter"] * 8, *["f3"] * 3, "f2", "f2", "up", "down", "down", "left", "right", "tab", "shift+tab", "escape", "minus",
    "f4", "f6", "f7", "D", "pagedown", "pageup", "home", "end", "space", "ctrl+z",
)  # fmt: skip
LETTERS = "abdhjkl"
WRITTEN = {"minus": "-", "space": " "}  # what a key writes into a line, at any place of it


def begun(tmp_path: Path, engine: str) -> Session:
    path = tmp_path / "own.toml"
    return Session.begin(engine_only(engine, path), path, memory=Memory(tmp_path / "state"))


async def walk(session: Session, seed: int, count: int, letters: str) -> int:
    """Strikes keys at random, and looks after each at what is left out; gives how often the design was ready."""
    chance, typed, ready = random.Random(seed), "", 0
    session.solve()
    app = ContralberoApp(session)
    async with app.run_test(size=(100, 30)) as pilot:
        hands = Hands(pilot)
        for n in range(count):
            asked = isinstance(app.screen, LeaveOut)
            key = chance.choice(letters) if letters and asked and chance.random() < 0.5 else chance.choice(KEYS)
            written = WRITTEN.get(key, key)
            typed += written if asked and len(written) == 1 else ""
            await hands.press(key)
            if not isinstance(app.screen, (Workbench, ReadyScreen, Reason)) and chance.random() < 0.5:
                await hands.press("escape")
            reasons = {why for why in session.data.get("without", {}).values() if why not in OF_PROGRAM}
            assert all(set(why) <= set(typed) for why in reasons), f"seed {seed}, key {n}: left out for {reasons}"
            if whole_of(session).ready:
                ready += 1
                assert all(asks(session.data, step.key) or step.optional or reasons for step in STEPS), (
                    f"seed {seed}, key {n}"
                )
    return ready


@pytest.mark.usefixtures("enclosed")
async def test_keys_at_random_leave_no_step_out_without_words(tmp_path: Path) -> None:
    await walk(begun(tmp_path, "r753ie4"), 1, 25, LETTERS)


@pytest.mark.slow
@pytest.mark.usefixtures("enclosed")
@pytest.mark.parametrize("seed", range(10))
async def test_many_keys_at_random_leave_no_step_out_without_words(tmp_path: Path, seed: int) -> None:
    engine = ("r753ie4", "inline-4", "twin-360")[seed % 3]
    await walk(begun(tmp_path, engine), seed, 500, LETTERS if seed % 2 else "")


@pytest.mark.slow
async def test_enter_all_the_way_after_a_look_round_builds_what_was_passed_over(tmp_path: Path) -> None:
    """Forward to the last step, back to the first, and then Enter alone: the steps are built in their order."""
    session = begun(tmp_path, "r753ie4")
    session.solve()
    app = ContralberoApp(session)
    async with app.run_test(size=(120, 40)) as pilot:
        hands = Hands(pilot)
        await hands.press(*["f3"] * 5, *["f2"] * 5)
        assert [step.key for step in STEPS if asks(session.data, step.key)] == ["engine"]
        while not isinstance(app.screen, ReadyScreen):
            await hands.press("enter")
            assert hands.keys <= 45
        assert "without" not in session.data and whole_of(session).ready
        assert all(asks(session.data, step.key) or step.optional for step in STEPS)


async def test_enter_on_a_step_that_can_not_be_built_yet_leads_to_the_one_before(tmp_path: Path) -> None:
    session = begun(tmp_path, "r753ie4")
    session.solve()
    app = ContralberoApp(session)
    async with app.run_test(size=(120, 40)) as pilot:
        hands = Hands(pilot)
        await hands.press("escape", "6")
        todo = work(pilot).form.query_one(Todo)
        assert todo.key == Todo.BUILD and [item.key for item in todo.items] == [Todo.BUILD, Todo.LEAVE]
        await hands.press("enter", "enter")
        await until(pilot, lambda: work(pilot).number == 2)
        assert "without" not in session.data and not any(isinstance(screen, Reason) for screen in app.screen_stack)


async def test_the_reason_for_leaving_out_is_typed(screen: Screen, light: Session) -> None:
    """Nothing stands in its line at first, nothing can be chosen, and Enter or signs alone do not take it."""

    async def open_dialog(pilot: Pilot[int]) -> Input:
        await strike(pilot, "minus")
        await until(pilot, lambda: isinstance(pilot.app.screen, LeaveOut))
        return pilot.app.screen.query_one(Input)

    async with screen() as pilot:
        await work(pilot).open_step(STEPS[5])
        await settled(pilot)
        work(pilot).form.query_one(Todo).focus()
        box = await open_dialog(pilot)
        assert box.value == "" and box.has_focus
        await strike(pilot, "enter", "down", "up", "enter", "space", "-", "enter")
        assert isinstance(pilot.app.screen, LeaveOut) and "without" not in light.data
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        await open_dialog(pilot)
        await strike(pilot, *"no train", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, ReadyScreen))  # it was the last step
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        assert light.data["without"] == {"friction": "no train"}
        await work(pilot).open_step(STEPS[5])
        work(pilot).form.query_one(Todo).focus()
        box = await open_dialog(pilot)  # the reason that there is can be read, not taken
        assert box.value == ""
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        assert light.undo() is not None and "without" not in light.data
