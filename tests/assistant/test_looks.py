# SPDX-License-Identifier: Apache-2.0
"""Other terminals: plain signs, other colours, too few columns; and any keys in any order."""

import random
from pathlib import Path

import pytest

from assistant.actions import ACTIONS
from assistant.session.session import Session
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import rows, settled, strike


# --- terminals
@pytest.mark.slow
async def test_plain_signs(screen: Screen, session: Session) -> None:
    async with screen(session=session, ascii=True) as pilot:
        await pilot.press("escape", "4")
        await settled(pilot)
        text = rows(pilot)
        assert "x 4 Bearings" in text and not set("✓▲✗●◌▸◀▼━┃") & set(text)


@pytest.mark.slow
@pytest.mark.parametrize(
    "environment", [{"NO_COLOR": "1"}, {"TEXTUAL_THEME": "ansi-dark"}, {"TEXTUAL_THEME": "textual-light"}]
)
async def test_other_colours(session: Session, monkeypatch: pytest.MonkeyPatch, environment: dict[str, str]) -> None:
    from assistant.app import ContralberoApp

    session.solve()
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    app = ContralberoApp(session)
    app.theme = environment.get("TEXTUAL_THEME", app.theme)
    async with app.run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        await pilot.press("escape", "4")
        await pilot.pause(0.05)
        text = rows(pilot)
        assert "FAIL: 8 failed" in text and "✗ 4 Bearings" in text and "✗ Film at the edge" in text


async def test_a_tiny_terminal_says_so(screen: Screen) -> None:
    async with screen(size=(44, 12)) as pilot:
        assert "needs 60 columns" in rows(pilot)
        await pilot.press("f4", "f4", "f4", "f3")
        await pilot.pause()


@pytest.mark.slow
async def test_any_keys_in_any_order(screen: Screen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A hundred keys at random: nothing may go wrong."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("assistant.screens.workbench.Workbench.action_report", lambda self: None)
    draw = random.Random(7)
    keys = [key for action in ACTIONS for key in action.binding.split(",") if action.id not in ("quit",)]
    keys += [
        "tab",
        "shift+tab",
        "backspace",
        "left",
        "right",
        "plus",
        "minus",
        "1",
        "2",
        "5",
        "e",
        "x",
        "space",
        "delete",
        "home",
        "ctrl+k",
        ".",
        ",",
    ]
    async with screen(size=(100, 30)) as pilot:
        for _ in range(20):
            await strike(pilot, *(draw.choice(keys) for _ in range(6)))
        for size in [(80, 24), (120, 40), (50, 15), (160, 45)]:
            await pilot.resize_terminal(*size)
            await strike(pilot, *(draw.choice(keys) for _ in range(6)))
        await pilot.pause(0.3)
        assert pilot.app.return_code is None
