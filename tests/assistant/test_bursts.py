# SPDX-License-Identifier: Apache-2.0
"""Keys that come faster than the screen, as over a slow line: what blind striking has found."""

import asyncio
import os

import pytest
from textual import events
from textual.pilot import Pilot
from textual.widgets import Input, Static

from assistant.actions import BY_ID
from assistant.app import ContralberoApp
from assistant.screens.dialogs import Choose
from assistant.screens.palette import Palette
from assistant.screens.path_dialogs import CompareFile, OpenDialog, SaveDialog
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from assistant.widgets.form import Form
from assistant.widgets.line import Line
from tests.assistant.conftest import Screen
from tests.assistant.driving import go_to, settled, strike, until, work


def burst(pilot: Pilot[int], *keys: str) -> None:
    """All at once, with no turn of the loop in between."""
    for key in keys:
        pilot.app.post_message(events.Key(key, key if len(key) == 1 else None))


@pytest.mark.parametrize("key", ["ctrl+o", pytest.param("f12", marks=pytest.mark.slow)])
async def test_an_arrow_comes_before_the_dialog_has_its_list(screen: Screen, key: str) -> None:
    async with screen() as pilot:
        burst(pilot, key, "down", "up", "down")
        await until(pilot, lambda: isinstance(pilot.app.screen, (OpenDialog, SaveDialog)))
        await pilot.pause()
        assert pilot.app.is_running and pilot.app._exception is None


ERASED = ("backspace",) * 17
NAMED = (*"my4", "backspace", "3", "x", "backspace", "left", "left", "z", "backspace")
TYPED = (  # what opens a place to type, from a field and from none, and what stands there after 17 backspaces and a name
    ("f12", True, "my3.toml"),
    ("ctrl+p", True, "my3"),
    ("W", False, "my3.toml"),
    ("E", False, "my3.dxf"),
    ("C", False, "my3"),
    ("ctrl+o", False, "my3"),
    ("equals_sign down enter", False, "my3"),
)


@pytest.mark.parametrize(
    ("gap", "count"), [(0.0, 2), *(pytest.param(gap, len(TYPED), marks=pytest.mark.slow) for gap in (0.0, 0.01))]
)
async def test_a_name_typed_over_another_one(screen: Screen, light: Session, gap: float, count: int) -> None:
    """Keys as one burst, or at 10 ms each, right behind the one that opens the dialog: each comes in its order."""
    async with screen() as pilot:
        for opens, inside, stands in TYPED[:count]:
            if inside:
                await go_to(pilot, "engine.bore_mm")
            else:
                work(pilot).leave_pane()
            if gap:
                await asyncio.sleep(0.05)
                for key in (*opens.split(), *ERASED, *NAMED):
                    burst(pilot, key)
                    await asyncio.sleep(gap)
            else:
                burst(pilot, *opens.split(), *ERASED, *NAMED)
            await until(pilot, lambda: isinstance(pilot.app.focused, Line))
            await pilot.pause()
            asked = pilot.app.screen
            typed = asked.query_one(Line).value
            assert typed.endswith(stands) and (typed == stands or isinstance(asked, OpenDialog | CompareFile)), opens
            while pilot.app.screen is not pilot.app.screen_stack[0]:
                await strike(pilot, "escape")
        assert light.value("engine.bore_mm") == 94.0
        burst(pilot, "f12", *"my3", "enter")
        await until(pilot, lambda: light.path == light.home.with_name("my3.toml"))
        await strike(pilot, "f12")
        await until(pilot, lambda: isinstance(pilot.app.screen, SaveDialog))
        await strike(pilot, *"my4.toml", "enter")
        await until(pilot, lambda: light.path == light.home.with_name("my4.toml"))
        await strike(pilot, "f12")
        await until(pilot, lambda: isinstance(pilot.app.screen, SaveDialog))
        await strike(pilot, *ERASED, "delete", *["delete"] * 5, "enter")
        assert "Give it a name." in str(pilot.app.screen.query_one("#wrong", Static).content)
        sub = light.home.with_name("sub")
        sub.mkdir()
        for rest in ("sub/", ".toml"):  # as it is where the ending that stood there stays, too
            await strike(pilot, *rest, "enter")
            assert "This is a folder" in str(pilot.app.screen.query_one("#wrong", Static).content)
        assert not list(sub.iterdir())


@pytest.mark.slow
async def test_enter_twice_in_the_palette(screen: Screen) -> None:
    async with screen() as pilot:
        await strike(pilot, "ctrl+p", *BY_ID["next"].title, "enter", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).number > 1)
        assert pilot.app.is_running and pilot.app._exception is None


async def test_what_is_typed_after_a_jump_goes_where_it_leads(screen: Screen, light: Session) -> None:
    """No key is lost, and none goes to the palette or to the field before: also where the form is made on the way."""
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        for words, number, key in (
            ("span cou.shaf fail", "12", ""),
            ("apart counterw", "77.5", "imbalance.counterweight_span_mm"),
        ):
            await strike(pilot, "ctrl+p", *words, "enter", *number)
            if not key:  # nothing has these words: the palette stays, with all that was typed
                await until(
                    pilot, lambda told=words + number: pilot.app.screen.query("#words").first(Input).value == told
                )  # type: ignore[misc]
                await strike(pilot, "escape")
                continue
            await until(pilot, lambda key=key: light.value(key) == 77.5)  # type: ignore[misc]
        assert light.value("engine.bore_mm") == 94.0


@pytest.mark.slow
async def test_enter_twice_in_a_list_of_words(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.layout")
        await strike(pilot, "space")
        await until(pilot, lambda: isinstance(pilot.app.screen, Choose) and pilot.app.focused is not None)
        burst(pilot, "down", "enter", "enter", "enter")
        await until(pilot, lambda: not isinstance(pilot.app.screen, Choose))
        await settled(pilot)
        assert work(pilot).session.value("engine.layout") == "vee"
        assert pilot.app.is_running and pilot.app._exception is None


ODD = ["x" * 5000, "a\0b", "~nobody-of-this-name/x.toml", "/", ".", "..", "", "x/" * 3000, "\ud800"]


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="what a name may be is another thing elsewhere")
@pytest.mark.parametrize(
    "key, dialog", [("f12", SaveDialog), pytest.param("ctrl+o", OpenDialog, marks=pytest.mark.slow)]
)
async def test_what_can_be_no_path_is_said_in_the_dialog(
    screen: Screen, light: Session, key: str, dialog: type
) -> None:
    async with screen() as pilot:
        before = {path.name for path in light.home.parent.iterdir()}
        await strike(pilot, key)
        await until(pilot, lambda: isinstance(pilot.app.screen, dialog) and pilot.app.focused is not None)
        there = pilot.app.screen
        for text in ODD:
            there.query_one("#path", Input).value = text
            await strike(pilot, "enter")
            await pilot.pause()
            assert pilot.app.screen is there, text[:50]
            assert str(there.query_one("#wrong", Static).content), text[:50]
        await strike(pilot, "escape")
        assert {path.name for path in light.home.parent.iterdir()} == before


@pytest.mark.slow
async def test_keys_for_a_form_that_is_being_made(screen: Screen) -> None:
    """Nothing that is typed at once behind a step's key is lost in a crash; the form stands whole in the end."""
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        burst(pilot, "f3", "4", "f3", "f2", "tab", "5", "escape", "1", "3", "2", "f3")
        await pilot.pause(0.5)  # the last keys come to their turn
        await settled(pilot)
        await until(pilot, lambda: bool(work(pilot).form.stops()))
        assert isinstance(work(pilot).form, Form) and pilot.app._exception is None


@pytest.mark.parametrize(
    "keys",
    [
        ("ctrl+u",),
        pytest.param(("home", "ctrl+k"), marks=pytest.mark.slow),
        pytest.param(("end", *("backspace",) * 8), marks=pytest.mark.slow),
    ],
)
async def test_what_deletes_comes_before_what_is_typed_after_it(screen: Screen, keys: tuple[str, ...]) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        burst(pilot, *keys, "1", "1", "3")
        await settled(pilot)
        assert isinstance(box, Input) and box.value == "113" and work(pilot).session.value("engine.bore_mm") == 113.0


@pytest.mark.slow
async def test_the_palette_is_paged_before_its_list_has_a_place(screen: Screen) -> None:
    async with screen() as pilot:
        await strike(pilot, "ctrl+p")
        await until(pilot, lambda: isinstance(pilot.app.screen, Palette))
        burst(pilot, "f", "i", "pagedown", "backspace", "pagedown", "pageup", "end")
        await pilot.pause()
        assert pilot.app.is_running and pilot.app._exception is None


@pytest.mark.slow
async def test_escape_right_after_undo_leaves_the_field(screen: Screen) -> None:
    """The focus that the undo brings to its field must not come after the key that takes it away."""
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await strike(pilot, *"95", "enter")
        await settled(pilot)
        burst(pilot, "ctrl+z", "escape")
        await until(pilot, lambda: work(pilot).session.value("engine.bore_mm") == 94.0)
        await settled(pilot)
        assert pilot.app.focused is work(pilot).form


@pytest.mark.parametrize(
    "key",
    ["f3", *(pytest.param(key, marks=pytest.mark.slow) for key in ("f12", "alt+2", "f7", "f4", "f6", "f1", "escape"))],
)
async def test_what_follows_a_key_that_leads_away_is_not_for_the_field_that_was_left(
    screen: Screen, light: Session, key: str
) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        field = pilot.app.focused
        burst(pilot, key, "7", "7")
        await until(pilot, lambda: pilot.app.focused is not field)
        await pilot.pause(0.2)  # the last keys come to their turn
        assert light.value("engine.bore_mm") == 94.0 and not list(light.history.past())


@pytest.mark.parametrize("turns", [1, 5])
async def test_the_end_may_come_before_the_first_picture(light: Session, turns: int) -> None:
    """As where a tab of the browser is closed at once: that is no fault of the program."""
    app = ContralberoApp(light)
    running = asyncio.create_task(app.run_async(headless=True))
    for _ in range(turns):
        await asyncio.sleep(0)
    app.exit(0)
    await running
    assert app._exception is None
