# SPDX-License-Identifier: Apache-2.0
"""A design in a folder of its own, a memory of its own, a clock that stands still, and the screen over them."""

import asyncio
import sys
import time
import traceback
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from datetime import datetime
from pathlib import Path

import pytest
from textual import _wait
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.screens.workbench import Workbench
from assistant.session.recovery import Memory
from assistant.session.session import EXAMPLE, Session

pytest.register_assert_rewrite("tests.assistant.action_tests")
_wait.SLEEP_GRANULARITY, _wait.SLEEP_IDLE = 0.004, 0.0004  # it looks five times as often whether the program is idle


async def _wait_for_screen(self: Pilot[int], timeout: float = 30.0) -> bool:
    """Wait until nobody has a message left.  Textual's own way sends one to each of the hundreds of widgets, which took
    longer than the tests themselves."""
    app, end, calm = self.app, time.perf_counter() + timeout, 0
    handled, asked = asyncio.Event(), None
    while calm < 3 or not handled.is_set():
        if asked is not app.screen:  # one that is closed in the meantime does not answer
            asked = app.screen
            app.call_later(asked.call_later, handled.set)  # what either of them is at is done then
        if app._exception is not None or not app.is_running:
            return False
        if time.perf_counter() > end:
            raise TimeoutError("the screen never came to rest")
        await asyncio.sleep(0 if calm else 0.001)
        waiting = isinstance(app, ContralberoApp) and app._held is not None  # keys, for what the one before them does
        busy = waiting or any(node.message_queue_size for node in (app, *app.screen.walk_children(with_self=True)))
        calm = 0 if busy else calm + 1
    return True


Pilot._wait_for_screen = _wait_for_screen  # type: ignore[method-assign]

NOON = datetime(2026, 3, 14, 12, 4)
Screen = Callable[..., AbstractAsyncContextManager[Pilot[int]]]


@pytest.fixture
def now() -> datetime:
    return NOON


@pytest.fixture
def memory(tmp_path: Path) -> Memory:
    return Memory(tmp_path / "state")


@pytest.fixture
def design(tmp_path: Path) -> Path:
    """A copy of the shipped example that may be edited."""
    path = tmp_path / "my design.toml"
    path.write_bytes(EXAMPLE.read_bytes())
    return path


@pytest.fixture
def session(design: Path, memory: Memory) -> Session:
    return Session.open(design, memory=memory, now=lambda: NOON)


@pytest.fixture
def light(design: Path, memory: Memory) -> Session:
    """The first three steps of the example: what most of the screen needs, and sooner solved."""
    path = design.with_name("light.toml")
    path.write_text(design.read_text(encoding="utf-8").partition("\n[bearings]")[0] + "\n", encoding="utf-8")
    return Session.open(path, memory=memory, now=lambda: NOON)


@pytest.fixture
def screen(light: Session, monkeypatch: pytest.MonkeyPatch) -> Screen:
    """Opens the screen over a session, which is solved; `async with screen(size=(80, 24)) as pilot`."""
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)  # nothing goes on behind the test

    @asynccontextmanager
    async def opened(
        size: tuple[int, int] = (110, 30), session: Session = light, ascii: bool = False
    ) -> AsyncIterator[Pilot[int]]:
        session.solve()
        app = ContralberoApp(session, ascii=ascii)
        async with app.run_test(size=size) as pilot:
            await solved(pilot)
            yield pilot

    return opened


async def solved(pilot: Pilot[int], limit: float = 30.0) -> None:
    """Wait until the results belong to what the fields say, and are shown."""
    app = pilot.app
    assert isinstance(app, ContralberoApp)
    end = time.perf_counter() + limit
    while time.perf_counter() < end:
        await pilot.pause()
        if not app.session.valid or (app.session.current and _shown(app)):
            await pilot.pause()
            return
        await asyncio.sleep(0.02)
    raise TimeoutError(f"no results: {_state(app)}")


def _state(app: ContralberoApp) -> str:
    """What it waits for: which thread stands where."""
    bench = app.screen_stack[0]
    assert isinstance(bench, Workbench)
    session, results = app.session, app.session.results
    page = bench.pages.get(bench.step.key)
    written = page is not None and results is not None and page.outcome is results.outcomes[bench.step.key]
    stacks = {id: "".join(traceback.format_stack(frame)) for id, frame in sys._current_frames().items()}
    return "\n".join(
        (
            f"{len(app.screen_stack)} screens, asked {session.generation}, solved {session.solved}, failure "
            f"{session.failure}, solving {bench._solving}, written {written}, waiting {list(bench._quiet_timers)}",
            *(f"{worker.group}: {worker.state.name} {worker.error}" for worker in app.workers),
            *stacks.values(),
        )
    )


def _shown(app: ContralberoApp) -> bool:
    """Whether the calculation that stands there is that of the results."""
    bench = app.screen_stack[0]
    assert isinstance(bench, Workbench)
    return app.session.results is None or bench.page is not None
