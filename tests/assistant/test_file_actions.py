# SPDX-License-Identifier: Apache-2.0
"""Recording, exporting, reading anew, opening again, settings and the report's progress, from the screen."""

import asyncio
import json
import threading
from pathlib import Path
from typing import Any

import ezdxf
import pytest
from pypdf import PdfReader
from textual.widgets import Input, OptionList

from assistant import app as app_module
from assistant.app import ContralberoApp
from assistant.exports.offered import FileRow, write_draft
from assistant.screens.dialogs import Ask
from assistant.screens.palette import entries
from assistant.screens.path_dialogs import ExportDialog, OpenDialog, PathDialog
from assistant.screens.workbench import Workbench
from assistant.session.recovery import Memory, Settings
from assistant.session.session import EXAMPLE, Session
from assistant.widgets.lines import TopLine
from calc.design import replay
from calc.sheet.errors import Cancelled
from calc.sheet.progress import Progress
from calc.solve import solve
from calc.studies.shipped import DESIGNS
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, rows, settled, strike, told, type_in, until, work

SIZES = [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)]  # the narrow one shows more faults
BORE, ROD = "engine.bore_mm", "engine.rod_length_mm"


@pytest.fixture
def small(light: Session, memory: Memory) -> Session:
    """The first two steps: what files need, and sooner solved and reported."""
    path = light.home.with_name("small.toml")
    path.write_text(light.home.read_text(encoding="utf-8").partition("\n[countershaft]")[0] + "\n", encoding="utf-8")
    light.home.unlink()
    return Session.open(path, memory=memory, now=light.now)


def top(pilot: Any) -> str:
    return rows(pilot).splitlines()[0]


async def dialog(pilot: Any) -> PathDialog[Any]:
    """The dialog that a key has just opened."""
    await until(pilot, lambda: isinstance(pilot.app.screen, PathDialog) and bool(pilot.app.screen.query("#wrong")))
    return pilot.app.screen


async def give(pilot: Any, path: Path | str) -> PathDialog[Any]:
    """Type a path into the dialog and accept it."""
    asked = await dialog(pilot)
    asked.query_one("#path", Input).value = str(path)
    await pilot.pause()
    await strike(pilot, "enter")
    return asked


# --- recording
@pytest.mark.parametrize("size", SIZES)
async def test_a_recorded_session_replays(
    screen: Screen, light: Session, tmp_path: Path, size: tuple[int, int]
) -> None:
    async with screen(size=size) as pilot:
        await pilot.press("escape", "R")
        await pilot.pause()
        assert "● rec" in top(pilot) and "Shift+F12 once more" in told(pilot)
        await go_to(pilot, ROD)
        await type_in(pilot, "170")
        await go_to(pilot, "countershaft.masses.0.mass_kg")
        await type_in(pilot, "2.5")
        await strike(pilot, "ctrl+z")
        await go_to(pilot, BORE)
        await type_in(pilot, "0")  # not allowed
        await pilot.press("enter", "escape", "R")
        await until(pilot, lambda: "No report, export or replay while the input is not valid" in told(pilot))
        await pilot.press("u", "R")
        asked = await dialog(pilot)
        path = light.home.with_name("light-replay.toml")
        assert asked.query_one("#path", Input).value == path.name
        await strike(pilot, "escape")
        await pilot.pause()
        assert light.recording is not None and "● rec" in top(pilot)  # it goes on
        await pilot.press("R")
        await dialog(pilot)
        await strike(pilot, "enter")
        await until(pilot, lambda: f"Replay: {path}" in told(pilot))
        assert light.recording is None and "rec" not in top(pilot)
    script = replay.load(path)
    assert [row.get("set", "undo") for row in script.steps] == [ROD, "shafts.shaft.masses.front.mass_kg", "undo"]
    compared = replay.run(script, solve)
    assert len(compared) >= 6 and all(c.agrees for c in compared), [c.text for c in compared]


@pytest.mark.slow
async def test_a_recording_is_given_up_or_asked_about(screen: Screen, light: Session, tmp_path: Path) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "R", "R")
        await give(pilot, tmp_path / "no" / "r.toml")
        assert "does not exist" in str(pilot.app.screen.query_one("#wrong").render())
        await give(pilot, light.home)
        assert "the design itself" in str(pilot.app.screen.query_one("#wrong").render())
        await give(pilot, "")
        await until(pilot, lambda: "given up" in told(pilot))
        assert light.recording is None
        await pilot.press("R")
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        assert not isinstance(pilot.app.screen, Workbench)  # the replay is not written
        await strike(pilot, "escape")
        await pilot.pause()
        await pilot.press("R")
        await give(pilot, tmp_path / "r.toml")
        await until(pilot, lambda: f"Replay: {tmp_path / 'r.toml'}" in told(pilot))


@pytest.mark.slow
async def test_a_replay_that_can_not_be_written_leaves_the_recording(
    screen: Screen, light: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from assistant.screens import workbench_edits
    from assistant.session.saving import SaveError

    def full(path: Path, data: bytes, **more: object) -> None:
        raise SaveError("No space left on device")

    monkeypatch.setattr(workbench_edits, "write_atomic", full)
    async with screen(ascii=True) as pilot:
        await pilot.press("escape", "R", "R")
        await give(pilot, tmp_path / "r.toml")
        await until(pilot, lambda: "No space left" in told(pilot))
        assert light.recording is not None and "@ rec" in top(pilot) and pilot.app.return_code is None


# --- export
@pytest.mark.parametrize(("size", "kind"), [((80, 24), "json"), pytest.param((120, 40), "csv", marks=pytest.mark.slow)])
async def test_values_and_results_are_exported(
    screen: Screen, small: Session, tmp_path: Path, size: tuple[int, int], kind: str
) -> None:
    path = tmp_path / f"out.{kind}"
    async with screen(size=size, session=small) as pilot:
        await pilot.press("escape", "E")
        asked = await dialog(pilot)
        assert asked.query_one("#path", Input).value == small.home.with_suffix(".dxf").name
        await give(pilot, path)
        await until(pilot, lambda: f"Exported: {path}" in told(pilot))
    text = path.read_text(encoding="utf-8")
    assert "\nengine.stroke,107" in text if kind == "csv" else json.loads(text)["steps"]["engine"] == "computed"


async def test_a_row_of_the_list_gives_its_name_to_the_file(screen: Screen, small: Session) -> None:
    """No other handler of the list is called beside that of the dialog."""
    async with screen(size=(80, 24), session=small) as pilot:
        await pilot.press("escape", "E")
        asked = await dialog(pilot)
        assert isinstance(asked, ExportDialog)
        writable = [row for row in asked.offered_rows if row.reason is None]
        await pilot.press("down", "down", "enter")
        box = asked.query_one("#path", Input)
        await until(pilot, lambda: box.value == f"{small.home.stem}{writable[1].tail}")
        assert pilot.app.screen is asked and box.has_focus


@pytest.mark.slow
async def test_an_ending_that_says_nothing_and_a_file_that_is_there(
    screen: Screen, small: Session, tmp_path: Path
) -> None:
    (tmp_path / "there.csv").write_text("theirs", encoding="utf-8")
    async with screen(size=(80, 24), session=small) as pilot:
        await pilot.press("escape", "E")
        await give(pilot, tmp_path / "out.iges")
        assert "ending .iges is not known" in str(pilot.app.screen.query_one("#wrong").render())
        await give(pilot, tmp_path / "there.csv")
        assert "exists" in str(pilot.app.screen.query_one("#wrong").render())
        await strike(pilot, "enter")
        await until(pilot, lambda: "Exported:" in told(pilot))
        assert not (tmp_path / "there.csv.bak").exists()


@pytest.mark.slow
async def test_where_there_is_nothing_to_draw_it_says_what_to_add(
    screen: Screen, light: Session, tmp_path: Path
) -> None:
    light.put_table(("shafts",), False)
    async with screen(size=(80, 24)) as pilot:
        await pilot.press("escape", "E")
        await give(pilot, tmp_path / "out.dxf")
        wrong = str(pilot.app.screen.query_one("#wrong").render())
        assert "add [[shafts]]" in wrong and not (tmp_path / "out.dxf").exists()
        await strike(pilot, "escape")
        await go_to(pilot, BORE)
        await type_in(pilot, "0")
        await pilot.press("enter", "escape", "E")
        await pilot.pause()
        assert "No report, export or replay while the input is not valid" in told(pilot) and isinstance(
            pilot.app.screen, Workbench
        )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "size", "step", "ending", "drawn"),
    [("r753ie4_sized", (120, 40), "3", ".dxf", "HATCH"), ("timing_pair", (80, 24), "5", "-gears.dxf", "PROFILE")],
)
async def test_shaft_and_gears_are_drawn(
    screen: Screen, memory: Memory, tmp_path: Path, name: str, size: tuple[int, int], step: str, ending: str, drawn: str
) -> None:
    source = tmp_path / f"{name}.toml"
    source.write_bytes((DESIGNS / f"{name}.toml").read_bytes())
    async with screen(size=size, session=Session.open(source, memory=memory)) as pilot:
        await pilot.press("escape", step)
        await settled(pilot)
        await pilot.press("escape", "E")
        asked = await dialog(pilot)
        path = tmp_path / f"{name}{ending}"
        assert asked.query_one("#path", Input).value == path.name
        await strike(pilot, "enter")
        await until(pilot, lambda: f"Exported: {path}" in told(pilot))
    assert any(drawn in e.dxf.layer for e in ezdxf.readfile(path).modelspace())


# --- report
@pytest.mark.parametrize("size", SIZES)
async def test_the_report_says_how_far_it_is_and_lets_go_on(
    screen: Screen, small: Session, monkeypatch: pytest.MonkeyPatch, size: tuple[int, int]
) -> None:
    shown: list[str] = []
    said: list[str] = []
    show, tell = Workbench.refresh_top_line, ContralberoApp.tell
    monkeypatch.setattr(
        ContralberoApp, "tell", lambda self, text, *kind: (tell(self, text, *kind), said.append(str(text)))
    )
    monkeypatch.setattr(
        Workbench, "refresh_top_line", lambda self: (show(self), shown.append(self.query_one(TopLine).render().plain))
    )
    path = small.home.with_suffix(".pdf")
    async with screen(size=size, session=small) as pilot:
        await go_to(pilot, BORE)
        await strike(pilot, "f8", "f8")
        await until(pilot, lambda: any("Still being written: PDF" in one for one in said))
        await type_in(pilot, "95")
        await until(pilot, lambda: any(f"PDF report: {path}" in one for one in said))
        assert small.value(BORE) == 95.0 and "PDF" not in top(pilot)
    shares = [int(line.partition("PDF ")[2].partition(" %")[0]) for line in shown if " %" in line]
    assert len(shares) > 20 and shares == sorted(shares) and shares[0] == 0 and shares[-1] == 100
    assert {len(line) for line in shown if " %" in line} == {size[0]}
    assert path.read_bytes().startswith(b"%PDF-")
    assert b"bore_mm = 94.0" in PdfReader(path).attachments["design.toml"][0]  # the design of when it was asked for


async def test_ending_while_the_report_is_written_leaves_no_file(
    screen: Screen, small: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    half, ended = threading.Event(), threading.Event()
    after: list[BaseException | None] = []

    def write(path: Path, draft: Any, row: FileRow, progress: Progress, lang: str) -> None:
        def slowly(share: float, what: str) -> None:
            if share > 0.5:
                half.set()
                ended.wait(10)
            progress(share, what)

        try:
            write_draft(path, draft, row, slowly, lang)
            after.append(None)
        except BaseException as error:
            after.append(error)
            raise

    monkeypatch.setattr("assistant.screens.workbench_edits.write_draft", write)
    async with screen(session=small) as pilot:
        await strike(pilot, "f8")
        await until(pilot, half.is_set)
        await strike(pilot, "ctrl+q")
        await until(pilot, lambda: isinstance(pilot.app.screen, Ask))  # it would be lost
        await strike(pilot, "enter")
        await until(pilot, lambda: pilot.app.return_code == 0)
    ended.set()
    while not after:
        await asyncio.sleep(0.01)
    assert isinstance(after[0], Cancelled)
    assert not [p for p in small.home.parent.iterdir() if p.suffix in (".pdf", ".part")]


# --- changed on disk
@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
async def test_a_change_on_disk_is_said_once_and_taken_over(
    screen: Screen, small: Session, monkeypatch: pytest.MonkeyPatch, size: tuple[int, int]
) -> None:
    monkeypatch.setattr(app_module, "LOOK", 0.05)
    async with screen(size=size, session=small) as pilot:
        await go_to(pilot, BORE)
        await type_in(pilot, "95")
        text = small.home.read_text(encoding="utf-8")
        small.home.write_text(
            text.replace("rod_length_mm = 163.0", "rod_length_mm = 170.0") + "# theirs\n", encoding="utf-8"
        )
        await until(pilot, lambda: "changed by another program: " in told(pilot))
        pilot.app.clear_notifications()
        await asyncio.sleep(0.2)
        await pilot.pause()
        assert "another program" not in told(pilot)
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert "once more to overwrite" in told(pilot)  # as ever
        await pilot.press("enter", "escape", "L")
        await solved(pilot)
        assert small.value(ROD) == 170.0 and small.value(BORE) == 94.0 and not small.dirty
        assert "Undo returns to your edits" in told(pilot) and "170" in rows(pilot)
        await strike(pilot, "ctrl+z")
        await solved(pilot)
        assert small.value(ROD) == 163.0 and small.value(BORE) == 95.0 and small.dirty
        await strike(pilot, "ctrl+s")
        await until(pilot, lambda: "Saved:" in told(pilot))
    assert small.home.read_text(encoding="utf-8") == text.replace("bore_mm = 94.0", "bore_mm = 95.0") + "# theirs\n"


async def test_a_file_that_is_no_design_any_more_is_not_taken(screen: Screen, small: Session) -> None:
    async with screen(size=(80, 24), session=small) as pilot:
        await pilot.press("escape", "L")
        await pilot.pause()
        assert "as its file has it" in told(pilot)
        small.home.write_text("name = 3\n", encoding="utf-8")
        await pilot.press("L")
        await pilot.pause()
        assert "The file is not taken: small.toml:1: schema: is missing" in told(pilot) and small.value(BORE) == 94.0


# --- opening again
@pytest.mark.parametrize("size", SIZES)
async def test_recent_designs_are_listed_first(
    screen: Screen, small: Session, tmp_path: Path, size: tuple[int, int]
) -> None:
    deep = tmp_path / ("a-very-long-name-of-a-folder-" * 4)
    deep.mkdir()
    other, gone = deep / "other.toml", tmp_path / "gone.toml"
    other.write_bytes(small.home.read_bytes().replace(b"bore_mm = 94.0", b"bore_mm = 99.0"))
    for path in (small.home, gone, other, small.home):
        small.memory.remember(path)
    async with screen(size=size, session=small) as pilot:
        await strike(pilot, "ctrl+o")
        asked = await dialog(pilot)
        assert isinstance(asked, OpenDialog)
        options = asked.query_one("#names", OptionList)
        shown = [str(options.get_option_at_index(n).prompt) for n in range(options.option_count)]
        assert shown[0] == "Opened last" and shown[2] == "Examples"
        assert shown[1].startswith(str(tmp_path)[:10]) and shown[1].endswith("/other.toml") and "…" in shown[1]
        assert len(shown[1]) <= size[0] * 0.9 - 6 and any(row.endswith(EXAMPLE.name) for row in shown)
        assert "small.toml" in shown  # of the folder, after the others
        asked.query_one("#path", Input).value = str(tmp_path) + "/sm"
        await pilot.pause()
        assert options.option_count == 1
        asked.query_one("#path", Input).value = asked.start
        await pilot.pause()
        await pilot.press("down", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        await settled(pilot)
        await solved(pilot)
        assert work(pilot).session.value(BORE) == 99.0


@pytest.mark.slow
async def test_recent_designs_are_in_the_palette(screen: Screen, small: Session, design: Path) -> None:
    small.memory.remember(design)
    small.memory.remember(small.home)
    async with screen(size=(80, 24), session=small) as pilot:
        found = {entry.title for entry in entries(work(pilot).app, work(pilot))}
        assert f"Open recent: {design}" in found and f"Open recent: {small.home}" not in found
        await work(pilot).open_path(design.with_name("none.toml"))
        await pilot.pause()
        assert "cannot be read" in told(pilot)
        await work(pilot).open_path(design)
        await settled(pilot)
        assert work(pilot).session.home == design


# --- settings
@pytest.mark.slow
async def test_theme_and_guide_are_kept(small: Session, memory: Memory) -> None:
    app = ContralberoApp(small)
    async with app.run_test(size=(80, 24)) as pilot:
        await solved(pilot)
        assert not app.guiding and app.say.code == "en" and not (memory.folder / "settings.toml").exists()
        await pilot.press("escape", "G")
        app.theme = "nord"
        await until(pilot, lambda: memory.settings().theme == "nord")
    assert memory.settings() == Settings("en", "nord", True)
    memory.set_setting("language", "it")
    app = ContralberoApp(Session.open(small.home, memory=memory), settings=memory.settings())
    async with app.run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        assert app.theme == "nord" and app.guiding and app.say.code == "it"


async def test_a_theme_that_there_is_not_is_left_alone(small: Session) -> None:
    app = ContralberoApp(small, settings=Settings(theme="no such theme"))
    assert app.theme in app.available_themes
