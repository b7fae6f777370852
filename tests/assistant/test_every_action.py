# SPDX-License-Identifier: Apache-2.0
"""Every action of the table, by each of its keys, on a wide and on a narrow terminal: what the user sees of it.

The tests of a size share one screen, which is put in order before each; one that fails leaves a screen that is made
anew."""

import asyncio
import sys
from collections.abc import AsyncIterator, Iterator
from functools import partial
from types import ModuleType
from typing import Any

import pytest
import pytest_asyncio

from assistant.actions import ACTIONS, BY_ID
from assistant.app import ContralberoApp
from assistant.screens.palette import Palette
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from tests.assistant.action_tests import DEEDS, Do, curves, editing, files, over, showing, still  # noqa: F401  each room puts its deeds in
from tests.assistant.driving import strike, until
from tests.assistant.stage import Stage, staged


@pytest.fixture(scope="module")
def put_aside() -> Iterator[None]:
    """Nothing goes on behind a test, and a report is a word."""
    report = ModuleType("reports.report")
    report.write = lambda document, results, raw, path, **rest: path.write_bytes(b"%PDF-" + raw)  # type: ignore[attr-defined]
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "reports.report", report)
        patch.setattr(Workbench, "_go_ahead", lambda self: None)
        yield


@pytest_asyncio.fixture(scope="module", loop_scope="module")
async def wide_stage(put_aside: None, tmp_path_factory: pytest.TempPathFactory) -> AsyncIterator[Stage]:
    async with staged((120, 40), tmp_path_factory.mktemp("wide")) as stage:
        yield stage


@pytest_asyncio.fixture(scope="module", loop_scope="module")
async def narrow_stage(put_aside: None, tmp_path_factory: pytest.TempPathFactory) -> AsyncIterator[Stage]:
    async with staged((80, 24), tmp_path_factory.mktemp("narrow")) as stage:
        yield stage


def test_every_action_has_its_deed() -> None:
    assert set(DEEDS) == {action.id for action in ACTIONS}


KEYS = [(action.id, keys.split(",")[0]) for action in ACTIONS for keys in (action.keys, action.letters) if keys]
FIRST = [
    (action.id, action.binding.split(",")[0]) for action in ACTIONS
]  # one key of each action; every second among the ordinary tests
FROM_PALETTE = ("trouble", "export", "undo", "copy_line")
ALONE = {"quit", "close"}  # on a screen that nobody else uses


async def play(stage: Stage, id: str, do: Do) -> None:
    async with asyncio.timeout(120):  # for what hangs: a slow machine takes its time
        await stage.put_in_order()
        stage.played = False
        await DEEDS[id](stage.pilot, do)
        stage.played = True


def rows(*ordinary: tuple[str, str]) -> list[Any]:
    """Every key of every action; all but these among the slow tests."""
    return [
        pytest.param(*row, marks=() if row in ordinary else pytest.mark.slow, id="-".join(row))
        for row in KEYS
        if row[0] not in ALONE
    ]


@pytest.mark.asyncio(loop_scope="module")
@pytest.mark.parametrize(("id", "key"), rows())
async def test_by_its_key_120x40(wide_stage: Stage, id: str, key: str) -> None:
    await play(wide_stage, id, partial(strike, wide_stage.pilot, key))


@pytest.mark.asyncio(loop_scope="module")
@pytest.mark.parametrize(("id", "key"), rows(*FIRST[1::2]))
async def test_by_its_key_80x24(narrow_stage: Stage, id: str, key: str) -> None:
    await play(narrow_stage, id, partial(strike, narrow_stage.pilot, key))


@pytest.mark.slow
@pytest.mark.asyncio(loop_scope="module")
@pytest.mark.parametrize("id", FROM_PALETTE)
async def test_from_the_palette(wide_stage: Stage, id: str) -> None:
    async def do() -> None:
        await strike(wide_stage.pilot, "ctrl+p", *BY_ID[id].title)
        palette = await over(wide_stage.pilot, Palette)
        await until(wide_stage.pilot, lambda: palette.rows[0].title == BY_ID[id].title)
        await strike(wide_stage.pilot, "enter")
        await until(wide_stage.pilot, lambda: wide_stage.pilot.app.screen is not palette)
        await wide_stage.pilot.pause()

    await play(wide_stage, id, do)


@pytest.mark.parametrize("size", [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)], ids=["80x24", "120x40"])
@pytest.mark.parametrize(
    "key",
    [pytest.param(key, marks=pytest.mark.slow if n else ()) for n, key in enumerate(("ctrl+q", "q"))],
)
@pytest.mark.usefixtures("put_aside")
async def test_the_end(light: Session, size: tuple[int, int], key: str) -> None:
    light.solve()
    async with ContralberoApp(light).run_test(size=size) as pilot:
        await still(pilot)
        await DEEDS["quit"](pilot, partial(strike, pilot, key))
