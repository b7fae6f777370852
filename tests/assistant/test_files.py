# SPDX-License-Identifier: Apache-2.0
"""Saving, opening, ending and the report, from the screen."""

from pathlib import Path
from typing import Any

import pytest
from textual.widgets import Input

from assistant.screens.palette import Palette
from assistant.screens.ready import Closing, ReadyScreen
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, rows, screen_rows, settled, strike, told, type_in, until, work


# --- files
async def test_saving(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        saved = light.home.read_bytes()
        assert b"bore_mm = 95.0\n" in saved and str(light.home) in told(pilot)
        assert "edited" not in rows(pilot).splitlines()[0]
        await pilot.press("backspace", "backspace", "0", "ctrl+s", "f8")
        await pilot.pause()
        assert "not saved" in told(pilot) and light.home.read_bytes() == saved
        assert "No report" in told(pilot)


async def test_end_shows_what_was_unfolded_last(screen: Screen) -> None:
    """Behind the last row that can be chosen there are rows that can only be read."""
    async with screen(size=(80, 24)) as pilot:
        await strike(pilot, "escape", "i")
        await until(pilot, lambda: isinstance(pilot.app.screen, ReadyScreen))
        closing = pilot.app.screen.query_one(Closing)
        await until(pilot, lambda: "not_counted" in closing.unfolded)
        await strike(pilot, "home", "end")
        await until(pilot, lambda: closing.scroll_y == closing.max_scroll_y > 0)
        last = closing.items[-2].rows[-1].plain.strip()
        await until(pilot, lambda: any(last in row for row in screen_rows(pilot)[-4:]))
        await strike(pilot, "home")
        await until(pilot, lambda: closing.scroll_y == 0)


@pytest.mark.slow
async def test_saving_on_the_closing_page(screen: Screen, light: Session) -> None:
    """It stays there; the palette goes on in the main screen."""
    async with screen(size=(80, 24)) as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await pilot.press("enter", "escape", "D")
        await until(pilot, lambda: isinstance(pilot.app.screen, ReadyScreen))
        await strike(pilot, "ctrl+s")
        await until(pilot, lambda: str(light.home) in told(pilot))
        assert b"bore_mm = 95.0\n" in light.home.read_bytes() and isinstance(pilot.app.screen, ReadyScreen)
        assert "^s save" in screen_rows(pilot)[-1] and screen_rows(pilot)[-1].rstrip().endswith("Esc back")
        await strike(pilot, "ctrl+p")
        await until(pilot, lambda: isinstance(pilot.app.screen, Palette))
        assert [type(screen) for screen in pilot.app.screen_stack] == [Workbench, Palette]


async def test_save_as(screen: Screen, tmp_path: Path) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "W")
        await pilot.pause()
        box = pilot.app.screen.query_one("#path", Input)
        box.value = str(tmp_path / "no" / "other")
        await strike(pilot, "enter")
        await pilot.pause()
        assert "does not exist" in str(pilot.app.screen.query_one("#wrong").render())
        box.value = str(tmp_path / "other")
        await strike(pilot, "enter")
        await settled(pilot)
        assert (tmp_path / "other.toml").is_file()
        assert work(pilot).session.path == tmp_path / "other.toml"


@pytest.mark.slow
async def test_save_as_asks_before_it_overwrites(screen: Screen, tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text("theirs")
    async with screen() as pilot:
        await strike(pilot, "f12")
        await pilot.pause()
        pilot.app.screen.query_one("#path", Input).value = str(tmp_path / "other.toml")
        await strike(pilot, "enter")
        await pilot.pause()
        assert (tmp_path / "other.toml").read_text() == "theirs"
        await strike(pilot, "enter")
        await settled(pilot)
        assert (tmp_path / "other.toml.bak").read_text() == "theirs"


@pytest.mark.slow
async def test_a_file_changed_by_another_program_needs_a_second_save(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        light.home.write_text(light.home.read_text(encoding="utf-8") + "# theirs\n", encoding="utf-8")
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert "another program" in told(pilot) and "bore_mm = 94.0" in light.home.read_text(encoding="utf-8")
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert "bore_mm = 95.0" in light.home.read_text(encoding="utf-8")


async def test_opening(screen: Screen, tmp_path: Path, design: Path) -> None:
    (tmp_path / "broken.toml").write_text("schema = 1\nname = 3\n")
    (tmp_path / "second.toml").write_bytes(design.read_bytes().replace(b"bore_mm = 94.0", b"bore_mm = 99.0"))
    async with screen() as pilot:
        await strike(pilot, "ctrl+o")
        await pilot.pause()
        dialog = pilot.app.screen
        box = dialog.query_one("#path", Input)
        box.value = str(tmp_path / "broken.toml")
        await strike(pilot, "enter")
        await pilot.pause()
        assert pilot.app.screen is dialog and "name" in str(dialog.query_one("#wrong").render())
        box.value = str(tmp_path) + "/sec"
        await pilot.pause()
        await pilot.press("down", "enter")
        await settled(pilot)
        await solved(pilot)
        assert work(pilot).session.value("engine.bore_mm") == 99.0


async def test_edits_are_kept_when_the_program_ends(screen: Screen, light: Session, memory: Any) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        assert pilot.app.return_code == 0
    assert Session.open(light.home, memory=memory).value("engine.bore_mm") == 95.0


async def test_only_what_can_not_be_kept_is_asked_about(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        work(pilot).session.put_table(("engine", "throw"), True)
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        assert not isinstance(pilot.app.screen, Workbench)
        await strike(pilot, "escape")
        await pilot.pause()
        assert isinstance(pilot.app.screen, Workbench)
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        await strike(pilot, "enter")
        await pilot.pause()
        assert pilot.app.return_code == 0


async def test_a_read_only_file_asks_for_another_name(screen: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Session, "read_only", property(lambda self: True))
    async with screen() as pilot:
        assert "read-only" in rows(pilot).splitlines()[0]
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert pilot.app.screen.query("#path")


# --- report
async def test_the_report(screen: Screen, light: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    import sys
    from types import ModuleType

    stub = ModuleType("reports.report")

    def write(document: Any, results: Any, raw: bytes, path: Path, depth: str = "", **_: Any) -> None:
        assert (
            document.data["engine"]["bore_mm"] == 95.0
            and b"bore_mm = 95.0" in raw
            and results.design.engine.bore == 0.095
        )
        path.write_bytes(b"%PDF-" + depth.encode())

    stub.write = write  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "reports.report", stub)
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await strike(pilot, "f8")  # before the results are there
        for _ in range(50):
            await pilot.pause(0.05)
            if "PDF report:" in told(pilot):
                break
        path = light.home.with_suffix(".pdf")
        assert path.read_bytes() == b"%PDF-engineer" and str(path) in told(pilot)
        monkeypatch.setattr(
            stub, "write", lambda *_, **__: (_ for _ in ()).throw(PermissionError(13, "Permission denied"))
        )
        await strike(pilot, "f8")
        for _ in range(50):
            await pilot.pause(0.05)
            if "Permission denied" in told(pilot):
                break
        assert "can not be written" in told(pilot)
