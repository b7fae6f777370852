# SPDX-License-Identifier: Apache-2.0
"""A design in a folder of its own, a memory of its own, a clock that stands still, and the screen over them."""

import asyncio
import gc
import time
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from datetime import datetime
from pathlib import Path

import pytest
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.recovery import Memory
from assistant.screens import live
from assistant.screens.workbench import Workbench
from assistant.session import EXAMPLE, Session

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
    monkeypatch.setattr(live, "AHEAD", 1000.0)  # nothing goes on behind the test
    gc.set_threshold(50_000, 20, 50)

    @asynccontextmanager
    async def opened(size: tuple[int, int] = (110, 30), session: Session = light, ascii: bool = False) -> AsyncIterator[Pilot[int]]:
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
    raise TimeoutError("no results")


def _shown(app: ContralberoApp) -> bool:
    """Whether the calculation that stands there is that of the results."""
    bench = app.screen_stack[0]
    assert isinstance(bench, Workbench)
    return app.session.results is None or bench.page is not None
