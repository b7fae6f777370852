# SPDX-License-Identifier: Apache-2.0
"""Driving the screen in tests: keys, waiting, and what can be read on it."""

import asyncio
import time
from collections.abc import Callable
from contextlib import suppress

from textual import events
from textual.keys import _character_to_key
from textual.pilot import Pilot
from textual.worker import WorkerCancelled

from assistant.screens.workbench import Workbench
from assistant.widgets.entry import Choice, Entry
from assistant.widgets.lines import MessageLine

CHARACTERS = {
    "question_mark": "?",
    "left_square_bracket": "[",
    "right_square_bracket": "]",
    "colon": ":",
    "equals_sign": "=",
    "greater_than_sign": ">",
    "less_than_sign": "<",
    "full_stop": ".",
    "comma": ",",
    "plus": "+",
    "minus": "-",
    "space": " ",
}


def work(pilot: Pilot[int]) -> Workbench:
    screen = pilot.app.screen
    assert isinstance(screen, Workbench)
    return screen


def message(pilot: Pilot[int]) -> str:
    return work(pilot).query_one(MessageLine).message()[1]


def told(pilot: Pilot[int]) -> str:
    return "\n".join(str(note.message) for note in pilot.app._notifications)


async def go_to(pilot: Pilot[int], key: str) -> Entry | Choice:
    """Put the focus on a field by its key."""
    screen = work(pilot)
    await screen.to_field(screen.session.place(key))
    await settled(pilot)
    assert screen.form.field is not None and screen.form.field.place == screen.session.place(key)
    return screen.form.field.box


async def settled(pilot: Pilot[int]) -> None:
    """Wait until a form that is being made anew stands there."""
    for _ in range(3):
        await pilot.pause()
        with suppress(WorkerCancelled):  # of a form that was taken away: another design was entered
            await pilot.app.workers.wait_for_complete([w for w in pilot.app.workers if w.group.startswith("form-")])
    await pilot.pause()


async def until(pilot: Pilot[int], holds: Callable[[], bool], limit: float = 30.0) -> None:
    """Wait until something holds that the screen comes to by itself."""
    end = time.perf_counter() + limit
    while not holds():
        assert time.perf_counter() < end, "it never came to that"
        await pilot.pause()
        await asyncio.sleep(0.01)


async def at_rest(pilot: Pilot[int]) -> None:
    """Wait until the screen has looked the same three times in a row."""
    seen, same = screen_rows(pilot), 0
    while same < 3:
        await pilot.pause(0.02)
        rows = screen_rows(pilot)
        seen, same = rows, same + 1 if rows == seen else 0


async def strike(pilot: Pilot[int], *keys: str) -> None:
    """Keys as quickly as they come, without waiting for the screen in between."""
    driver = pilot.app._driver
    assert driver is not None
    for name in keys:
        key = _character_to_key(name) if len(name) == 1 else name
        character = name if len(name) == 1 else CHARACTERS.get(name)
        event = events.Key(key, character)
        event.set_sender(pilot.app)
        driver.send_message(event)
        await asyncio.sleep(0)
    await pilot.pause()


async def type_in(pilot: Pilot[int], text: str) -> None:
    await strike(pilot, *text)


def screen_rows(pilot: Pilot[int]) -> list[str]:
    """The screen that is on top, as text."""
    return ["".join(segment.text for segment in strip) for strip in pilot.app.screen._compositor.render_strips()]


def rows(pilot: Pilot[int]) -> str:
    """The main screen as text."""
    work(pilot)
    return "\n".join(screen_rows(pilot))
