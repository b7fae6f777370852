# SPDX-License-Identifier: Apache-2.0
"""Keys, pastes and sizes at random: the session goes on, the saved file is a design, and undo leads back to the
start."""

import asyncio
import contextlib
import os
import random
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from textual import events
from textual.errors import NoWidget
from textual.keys import _character_to_key
from textual.pilot import OutOfBounds, Pilot

from assistant.actions import ACTIONS
from assistant.app import ContralberoApp
from assistant.screens.workbench import Workbench
from assistant.session.recovery import Memory
from assistant.session.saving import SaveError
from assistant.session.session import Session
from calc.design import replay
from calc.design.toml_file import load
from tests.assistant.conftest import solved
from tests.assistant.driving import CHARACTERS, settled, strike, until

TEXTS = [
    "3,5", "3.5", "1,234.5", "1e999", "-1e-300", "nan", "inf", "0", "00", "1;2;3", "1; 3; 2", "[bold", "[/]",
    "[@click=app.quit]x[/]", "\\[", "\t",
    "3.7 in", "½", "−5", "٣", "日本語", "e\u0301", "\U0001f600", "\u202e12", "\x00", "\x1b[31m", "'", '"', '"""', "\\",
    "a\nb", "x" * 5000, "9" * 400,
    "", " ", "true", "auto", "SAE 10W-40", "#", "= 3", "{}", "1" + "\u00a0" + "000",
]  # fmt: skip
ENDS = {"ctrl+q", "q"}  # the end of the program has tests of its own
NAMED = sorted({key for action in ACTIONS for key in action.binding.split(",") if len(key) > 1 and key not in ENDS})
LETTERS = sorted({key for action in ACTIONS for key in action.letters.split(",") if len(key) == 1} - ENDS)
OTHERS = """tab tab tab shift+tab space left right home end backspace delete insert ctrl+a ctrl+k ctrl+u ctrl+w ctrl+v ctrl+x ctrl+c ctrl+home
ctrl+end shift+left shift+right plus minus f5 f11 f13 ctrl+d ctrl+l ctrl+z ctrl+z escape escape enter enter down down""".split()
TYPED = "0123456789.,-+eE;'\"[](){}<>/\\|~°µ·äßéΩ中🙂 "


async def event(pilot: Pilot[int], chance: random.Random) -> str:
    """One thing that a user, or a cat, may do; gives its name."""
    kind = chance.random()
    if kind < 0.35:
        name = chance.choice(NAMED)
    elif kind < 0.60:
        name = chance.choice(OTHERS)
    elif kind < 0.85:
        name = chance.choice(TYPED + "0123456789" * 3)
    elif kind < 0.89:
        name = chance.choice(LETTERS)
    elif kind < 0.96:
        text = chance.choice(TEXTS)
        pilot.app.post_message(events.Paste(text))
        return f"paste {text[:20]!r}"
    elif kind < 0.98:
        width, height = chance.randint(40, 200), chance.randint(12, 60)
        await pilot.resize_terminal(width, height)
        return f"size {width}x{height}"
    else:
        width, height = pilot.app.size
        with contextlib.suppress(NoWidget, OutOfBounds):  # a screen that is just being made
            await pilot.click(offset=(chance.randrange(width), chance.randrange(height)))
        return "click"
    press(pilot, name)
    return name


def press(pilot: Pilot[int], name: str) -> None:
    """A key, without waiting for what comes of it."""
    driver = pilot.app._driver
    assert driver is not None
    key = events.Key(
        _character_to_key(name) if len(name) == 1 else name, name if len(name) == 1 else CHARACTERS.get(name)
    )
    key.set_sender(pilot.app)
    driver.send_message(key)


@pytest.fixture
def enclosed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is written outside the folder of the test, whatever path is typed; a report is a word."""
    save_as = Session.save_as

    def inside(self: Session, path: Path) -> Path:
        if tmp_path not in Path(os.path.realpath(path.expanduser())).parents:
            raise SaveError(f"{path} is not for this test")
        return save_as(self, path)

    stub = ModuleType("reports.report")
    stub.write = lambda document, results, raw, path, **rest: path.write_bytes(b"%PDF-")  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "reports.report", stub)
    monkeypatch.setattr(Session, "save_as", inside)
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)
    monkeypatch.chdir(tmp_path)


def first_of(session: Session) -> Any:
    """The design before the first edit that can be undone."""
    return session.history._undo[0][0].data if session.history._undo else session.data


async def fuzz(path: Path, memory: Memory, seed: int, count: int) -> None:
    session = Session.open(path, memory=memory)
    session.solve()
    first = session.data
    app = ContralberoApp(session)
    chance = random.Random(seed)
    done: list[str] = []
    try:
        async with app.run_test(size=(100, 30)) as pilot:
            for _ in range(count):
                done.append(await event(pilot, chance))
                await asyncio.sleep(0)
                if chance.random() < 0.1:  # the rest comes in bursts
                    await pilot.pause()
                if app.session is not session:  # another design was opened
                    session, first = app.session, first_of(app.session)
                if not isinstance(app.screen, Workbench) and chance.random() < 0.3:
                    done.append("escape")
                    await strike(pilot, "escape")

            def builds() -> bool:
                return any(worker.group == "build" and worker.is_running for worker in app.workers)

            await until(pilot, lambda: not builds(), 120.0)
            for _ in range(20):  # what the last keys open may come late
                await pilot.pause(0.02)
                if not isinstance(app.screen, Workbench):
                    await strike(pilot, "escape")
            assert isinstance(app.screen, Workbench), app.screen
            await settled(pilot)
            assert app.is_running
            session = app.session
            data, texts = session.data, {place: session.text(place) for place in session.reasons()}
            session.autosave()
            session.leave()  # as the end of the program does
            if session.safe:
                again = Session.open(session.home, memory=memory)
                assert again.data == data and {place: again.text(place) for place in again.reasons()} == texts
            while session.undo() is not None:
                pass
            assert session.data == first and session.valid
            app.screen.edited()
            await solved(pilot)
            await strike(pilot, "f1")  # it still answers
            await until(pilot, lambda: not isinstance(app.screen, Workbench))
    except BaseException:
        print(f"seed {seed}, after {len(done)} events: {done[-40:]}")
        raise
    for file in path.parent.glob("*.toml"):  # what was saved, and what was recorded
        (replay.load if "[[step]]" in file.read_text(encoding="utf-8") else load)(file)
    load(path)


@pytest.mark.usefixtures("enclosed")
async def test_keys_and_pastes_at_random(light: Session, memory: Memory) -> None:
    await fuzz(light.home, memory, seed=1, count=80)


@pytest.mark.slow
@pytest.mark.usefixtures("enclosed")
@pytest.mark.parametrize("seed", range(1, 12))
async def test_many_keys_and_pastes_at_random(design: Path, memory: Memory, seed: int) -> None:
    await fuzz(design, memory, seed, count=600)
