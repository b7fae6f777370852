# SPDX-License-Identifier: Apache-2.0
"""The first screen: what it offers, and how a session begins with it."""

import tomllib
from pathlib import Path

import pytest
from textual.pilot import Pilot
from textual.widgets import Input

from assistant.app import ContralberoApp
from assistant.screens.start import Start
from assistant.screens.workbench import Workbench
from assistant.session.beginnings import engine_only, finding, groups, sample
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.field import Field
from assistant.widgets.text import match
from calc.design.toml_file import Document, design
from calc.studies.shipped import engines
from tests.assistant.conftest import Screen
from tests.assistant.driving import screen_rows, strike, type_in, until, work


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def start(pilot: Pilot[int]) -> Start:
    screen = pilot.app.screen
    assert isinstance(screen, Start)
    return screen


@pytest.mark.parametrize("id", engines())
def test_every_engine_begins_a_design_of_its_own(id: str, memory: Memory) -> None:
    data = engine_only(id, Path("own-one.toml"))
    assert data["name"] == "own-one" and set(data) == {"schema", "name", "note", "engine"}
    assert design(Document(data)).engine is not None
    assert sample(data["note"])[1] == {**data["engine"], "name": sample(data["note"])[0]}
    (row,) = [row for _, rows in groups(memory) for row in rows if row.kind == "engine" and row.id == id]
    found = finding(row, memory)
    assert found.lines and found.sketch is not None


@pytest.mark.parametrize("size", [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)])
async def test_from_an_engine_to_its_first_step(memory: Memory, tmp_path: Path, size: tuple[int, int]) -> None:
    async with ContralberoApp(None, memory=memory).run_test(size=size) as pilot:
        await type_in(pilot, "6 v 60")  # in any order
        assert start(pilot).here is not None and start(pilot).here.id == "v6-60"  # type: ignore[union-attr]
        said = screen_rows(pilot)[-1]
        assert said.split("   ")[0].strip() == "Enter begins" and "Esc takes the words away" in said
        await strike(pilot, "enter")
        await until(pilot, lambda: bool(pilot.app.screen.query("#path")))
        assert pilot.app.screen.query_one("#path", Input).value == "own-v6-60.toml"
        await strike(pilot, "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).stands)
        session = work(pilot).session
        assert list(session.data) == ["schema", "name", "note", "engine"] and session.dirty
        bore = next(field for field in work(pilot).query(Field) if field.place == session.place("engine.bore_mm"))
        assert bore.note()[0] == "sample" and bore.explained()[1].startswith("Still of ")
        session.edit(bore.place, bore.text)  # it is theirs, too
        assert bore.note()[0] == ""
        assert not (tmp_path / "own-v6-60.toml").exists()  # before it is saved
        await strike(pilot, "ctrl+s")
        await until(pilot, lambda: not session.dirty)
    assert tomllib.loads((tmp_path / "own-v6-60.toml").read_text("utf-8"))["name"] == "own-v6-60"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("columns", "columns_of_row"),
    [(80, ("±2ω",)), (200, ("74.5 × 80 mm", "order 2: 6100 N", "±2ω"))],
)
async def test_each_engine_says_what_balancing_it_calls_for(
    memory: Memory, columns: int, columns_of_row: tuple[str, ...]
) -> None:
    app = ContralberoApp(None, memory=memory)
    async with app.run_test(size=(columns, 40)) as pilot:
        await until(
            pilot, lambda: any(all(word in row for word in ("VW EA211", *columns_of_row)) for row in screen_rows(pilot))
        )


async def test_going_on_is_one_enter(memory: Memory, light: Session) -> None:
    light.edit("engine.bore_mm", "96")
    light.autosave()
    async with ContralberoApp(None, memory=memory).run_test(size=(80, 24)) as pilot:
        assert screen_rows(pilot)[-1].startswith(" Enter opens it ") and "Esc ends" in screen_rows(pilot)[-1]
        await strike(pilot, "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).stands)
        assert work(pilot).session.home == light.home and work(pilot).session.value("engine.bore_mm") == 96.0


async def test_a_file_that_is_not_there_is_begun(memory: Memory, tmp_path: Path) -> None:
    async with ContralberoApp(None, memory=memory, missing=tmp_path / "mine.toml").run_test(size=(80, 24)) as pilot:
        assert "mine.toml is not there" in screen_rows(pilot)[0]
        await strike(pilot, *"cross 4", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).stands)
        assert work(pilot).session.path == tmp_path / "mine.toml"


@pytest.mark.slow
async def test_over_an_open_design_and_back(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await strike(pilot, "ctrl+n")
        await until(pilot, lambda: isinstance(pilot.app.screen, Start) and start(pilot).here is not None)
        assert start(pilot).here.kind == "engine"  # type: ignore[union-attr]
        await strike(pilot, "x", "escape", "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        assert work(pilot).session is light
        await strike(pilot, "ctrl+n", *"worked", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).session.example)


@pytest.mark.parametrize("size", [(10, 4), pytest.param((20, 10), marks=pytest.mark.slow)])
async def test_however_small_the_terminal_is(memory: Memory, size: tuple[int, int]) -> None:
    async with ContralberoApp(None, memory=memory).run_test(size=size) as pilot:
        await strike(pilot, "down", "pagedown", "pageup", "up", "ctrl+o", "escape", "ctrl+p", "q", "escape")
        await strike(pilot, *"boxer", "enter", "escape", "escape")
        await pilot.resize_terminal(120, 40)
        await pilot.resize_terminal(*size)
        await pilot.pause()
        assert pilot.app._exception is None
        await strike(pilot, "escape")


async def test_the_language_changes_while_it_stands(memory: Memory) -> None:
    app = ContralberoApp(None, memory=memory)
    async with app.run_test(size=(120, 40)) as pilot:
        await app.speak("it")
        await strike(pilot, *"boxer")
        assert start(pilot).here is not None and start(pilot).here.id.startswith("boxer")  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("words", "engine"),
    [
        ("own", ""),
        ("diesel", ""),
        pytest.param("own inline 3", "inline-3", marks=pytest.mark.slow),
        pytest.param("parallel twin", "twin-360", marks=pytest.mark.slow),
    ],
)
async def test_words_that_a_designer_types_first_find_an_engine(memory: Memory, words: str, engine: str) -> None:
    async with ContralberoApp(None, memory=memory).run_test(size=(120, 40)) as pilot:
        await type_in(pilot, words)
        found = [row for row in start(pilot)._rows if row is not None]
        assert found and all(row.kind == "engine" for row in found)
        assert not engine or engine in {row.id for row in found}


def test_a_number_finds_only_what_has_it_by_itself() -> None:
    assert (
        match(["753"], "R753IE4")[0] > 0
        and match(["3"], "R753IE4", "diesel 3 cylinders")[0] > 0 == match(["4"], "R753IE4", "bore 94")[0]
    )
    assert match(["inline", "4"], "Inline 3", "own-inline-3 94 x 107")[0] == 0
    assert match(["inline", "4"], "Inline four", "inline 4 cylinders")[0] > 0
