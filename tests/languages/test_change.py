# SPDX-License-Identifier: Apache-2.0
"""Another language in the middle of a session: every step then shows what a session begun in that language shows."""

from pathlib import Path

import pytest
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.screens.workbench import Workbench
from assistant.session.recovery import Memory, Settings
from assistant.session.session import Session
from assistant.widgets.checks import Checks
from calc.design.model import STEPS
from calc.studies.shipped import DESIGNS
from tests.assistant.conftest import NOON, solved
from tests.assistant.driving import screen_rows, settled, strike, until, work


@pytest.fixture(autouse=True)
def quiet(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)


def app(language: str, memory: Memory, tmp_path: Path) -> ContralberoApp:
    path = tmp_path / "progetto.toml"
    path.write_bytes((DESIGNS / "r753ie4_gamma.toml").read_bytes())
    session = Session.open(path, memory=memory, now=lambda: NOON)
    session.solve()
    return ContralberoApp(session, settings=Settings(language=language), memory=memory)


async def shown(pilot: Pilot[int]) -> list[str]:
    """The panes once everything stands in them."""
    await settled(pilot)
    await solved(pilot)
    checks = work(pilot).query_one(Checks)
    await until(pilot, lambda: bool(checks.items) or not checks.is_on_screen)  # where there is room for them
    await until(
        pilot,
        lambda: (
            not checks.is_on_screen
            or (check := checks.check) is None
            or not check.moved_by
            or work(pilot)._known_slopes(check.id) is not None  # nothing moves what has no number
        ),
    )
    await pilot.pause(0.3)
    return screen_rows(pilot)[1:-3]  # without the top line, the message and the keys


@pytest.mark.slow
@pytest.mark.parametrize("size", [(120, 40), (80, 24)], ids=["wide", "narrow"])
async def test_every_step_as_in_a_session_begun_in_that_language(
    size: tuple[int, int], memory: Memory, tmp_path: Path
) -> None:
    italian: dict[str, list[str]] = {}
    async with app("it", memory, tmp_path).run_test(size=size) as pilot:
        await solved(pilot)
        for number, step in enumerate(STEPS, 1):
            await strike(pilot, "escape", str(number))
            italian[step.key] = await shown(pilot)
    changing = app("en", memory, tmp_path)
    async with changing.run_test(size=size) as pilot:
        await solved(pilot)
        for number, step in enumerate(STEPS, 1):
            await changing.speak("en")
            await settled(pilot)
            await strike(pilot, "escape", str(number))
            english = await shown(pilot)
            await changing.speak("it")
            await settled(pilot)
            await strike(pilot, "escape", str(number))  # the focus is again where one acts
            assert await shown(pilot) == italian[step.key], step.key
            assert english != italian[step.key]
