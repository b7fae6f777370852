# SPDX-License-Identifier: Apache-2.0
"""The first screen: what it offers, and how a session begins with it."""

import tomllib
from pathlib import Path

import pytest
from textual.pilot import Pilot
from textual.widgets import Input

from assistant.app import ContralberoApp
from assistant.screens.ready import Closing
from assistant.screens.start import Start
from assistant.screens.workbench import Workbench
from assistant.session.beginnings import blank, engine_only, finding, with_engines
from assistant.session.inherited import inherited
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.field import Field
from assistant.widgets.text import match
from calc.design.toml_file import Document, design
from calc.studies.shipped import engine_design, engine_table, engines
from tests.assistant.conftest import Screen
from tests.assistant.driving import rows, screen_rows, strike, type_in, until, work


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
    assert data["name"] == data["engine"]["name"] == "own-one" and set(data) == {"schema", "name", "note", "engine"}
    assert design(Document(data)).engine is not None
    name, places = inherited(data)
    assert name == engines()[id].name and ("engine", "bore_mm") in places and len(places) >= 7
    (row,) = [row for row in with_engines() if row.kind == "engine" and row.id == id]
    found = finding(row, memory)
    assert found.lines and found.sketch is not None


BLANK = [row.id for row in with_engines() if row.sought]


@pytest.mark.parametrize("id", BLANK)
def test_a_blank_engine_has_no_number_of_any_other(id: str, memory: Memory, tmp_path: Path) -> None:
    """What is missing is what is asked for; once it is there, the design is one."""
    session = Session.begin(blank(id, path := tmp_path / "own.toml"), path, memory=memory)
    assert session.inherited == ("", ()) and "note" not in session.data
    said = {"name", "layout", "cylinders", "strokes", "bank_angle_deg", "bank_of_cylinder", "firing_order"}
    assert set(session.data["engine"]) <= said | {"crank_angles_deg"}
    numbers = dict(bore="75", crank_radius="45.25", rod_length="140", piston_mass="320", rod_mass="430")
    for key, number in numbers.items():
        place = session.place(f"engine.{key}_{'g' if 'mass' in key else 'mm'}")
        assert session.lacks(place)
        session.edit(place, number)
    session.edit("engine.rated_speed_rpm", "6000")
    session.edit("engine.cylinder_pitch_mm", "84")
    assert {place[-1] for place in session.reasons()} <= {
        "crank_angles_deg",
        "bank_angle_deg",
        "cylinder_directions_deg",
    }
    assert session.valid or not id.startswith("inline")


def test_a_blank_engine_is_kept_half_filled_in(memory: Memory, tmp_path: Path) -> None:
    session = Session.begin(blank("inline-3", path := tmp_path / "own.toml"), path, memory=memory)
    session.solve()
    assert session.results is not None and not session.valid and session.design.engine is None
    session.edit("engine.bore_mm", "75")
    session.autosave()
    session.leave()
    again = Session.open(path, memory=memory)
    assert again.value("engine.bore_mm") == 75.0 and ("engine", "rod_length_mm") in again.lacking


def test_what_is_replaced_leaves_note_and_title(memory: Memory, tmp_path: Path) -> None:
    """Also where the whole design was one of that engine; and comes back by an undo."""
    path = tmp_path / "mine.toml"
    path.write_text(engine_design("inline-6"), encoding="utf-8")  # without a shaft: quickly built
    session = Session.open(path, memory=memory)
    assert session.data["name"] == "BMW N52B30" and session.inherited == ("", ())
    session.edit("engine.idle_speed_rpm", "700")  # of which the table says nothing
    assert session.data["name"] == "BMW N52B30"
    session.edit("engine.bore_mm", "86")
    name, places = session.inherited
    assert name == "BMW N52B30" and ("engine", "bore_mm") not in places and ("engine", "rod_mass_g") in places
    assert session.data["name"] == session.data["engine"]["name"] == "mine"
    assert "bore," not in session.data["note"].partition("Their source")[0] and "rod mass" in session.data["note"]
    for place in places:
        session.edit(place, str(1.01 * session.value(place)))
    assert session.inherited == ("", ()) and "BMW" not in str(session.data)
    while session.undo() is not None:
        pass
    assert session.data["name"] == "BMW N52B30" and session.data["engine"]["bore_mm"] == 85.0


def test_what_earlier_versions_and_the_command_line_began_is_marked() -> None:
    engine = {**engine_table("inline-3"), "name": "mine", "bore_mm": 80.0}
    typical = "inline 3, even firing. They are from: typical; bore, stroke: 2013 BMW."
    for note in (
        f"Begun with the data of BMW B38B15: {typical}",
        "An engine of its own, by engine.bore_mm; all else of [engine] is that of the shipped inline-3, to be replaced.",
    ):
        name, places = inherited({"note": f"First. {note} And more.", "engine": engine})
        assert name == "BMW B38B15" and [place[-1] for place in places][:2] == ["crank_radius_mm", "rod_length_mm"]
    assert inherited({"note": "BMW B38B15 is like this.", "engine": engine}) == ("", ())


@pytest.mark.parametrize("size", [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)])
async def test_from_an_engine_to_its_first_step(memory: Memory, tmp_path: Path, size: tuple[int, int]) -> None:
    async with ContralberoApp(None, memory=memory).run_test(size=size) as pilot:
        await type_in(pilot, "v6 alfa")  # in any order
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
        assert bore.note()[0] == "from Alfa Romeo V6 2.5" and bore.explained()[1].startswith("Still of ")
        assert "values are still Alfa Romeo V6 2.5's" in rows(pilot)
        session.edit(bore.place, bore.text)  # it is theirs, too
        assert bore.note()[0] == ""
        work(pilot).action_ready()  # where those are named that no form shows unasked
        await until(
            pilot, lambda: bool(pilot.app.screen.query(Closing)) and bool(pilot.app.screen.query_one(Closing).items)
        )
        listed = " ".join(row.plain for item in pilot.app.screen.query_one(Closing).items for row in item.rows)
        assert "values are still Alfa Romeo V6 2.5's" in listed and "rod mass" in listed
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
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
        assert start(pilot).here.kind == "own"  # type: ignore[union-attr]
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


FOUND = {  # by what is typed: the first row, and whether all are blank engines
    "own": ("Own inline 1", True),
    "own 3": ("Own inline 3", True),
    "own diesel 4": ("Own inline 4", True),
    "inline 4": ("Own inline 4", False),
    "v 6": ("Own V6", False),
    "own v4": ("Own V4", True),
    "diesel": ("Own engine", False),
    "petrol": ("Own engine", False),
    "new": ("Own engine", False),
    "triple": ("Own inline 3", False),
    "V-twin": ("Own V2", False),
    "flat 4": ("Own boxer 4", False),
    "straight six": ("Own inline 6", False),
    "L4": ("Own inline 4", False),
    "i3": ("Own inline 3", False),
    "parallel twin": ("Own inline 2", False),
    "needle": ("Harley Twin Cam 88", False),
    "b38": ("BMW B38B15", False),
}


async def test_words_that_a_designer_types_first_find_an_engine(memory: Memory) -> None:
    async with ContralberoApp(None, memory=memory).run_test(size=(120, 40)) as pilot:
        await pilot.pause()
        engines_listed = [row for row in start(pilot)._rows if row is not None and row.kind in ("own", "engine")]
        assert str(engines_listed[0].title) == "Own engine" and len(engines_listed) == 1 + len(engines())
        words = start(pilot).query_one("#words", Input)
        for typed, (first, blank_only) in FOUND.items():
            words.value = typed
            start(pilot).fill()
            found = [row for row in start(pilot)._rows if row is not None]
            assert found and str(found[0].title) == first, (typed, [str(row.title) for row in found])
            assert not blank_only or all(row.sought for row in found)
            if typed in ("diesel", "petrol"):
                assert 2 <= len(found) < len(engines())
        for typed, step in {"rattle": 5, "vibration": 2, "comfort": 7}.items():  # no engine, but there is something
            words.value = typed
            said = f"step {step} of a design"
            await until(pilot, lambda said=said: said in "".join(screen_rows(pilot)))  # type: ignore[misc]
        words.value = "own 3"  # two of one name: what tells them apart stands next to it
        await until(pilot, lambda: any("Own inline 3   " in row for row in screen_rows(pilot)))
        listed = [row.partition("│")[0].partition("Own inline 3")[2].split() for row in screen_rows(pilot)]
        assert [row[0] for row in listed if row] == ["even", "two-stroke,"]
        words.value = "new"  # from the row of all to one of them
        await pilot.pause()
        await strike(pilot, "enter")
        await until(pilot, lambda: words.value == "own ")
        await strike(pilot, *"v 8")
        await until(pilot, lambda: start(pilot).here is not None and "V8" in str(start(pilot).here.title))
        await strike(pilot, "enter")
        await until(pilot, lambda: bool(pilot.app.screen.query("#path")))
        assert "own-v8-cross.toml" in pilot.app.screen.query_one("#path", Input).value


def test_a_number_finds_only_what_has_it_by_itself() -> None:
    assert (
        match(["753"], "R753IE4")[0] > 0
        and match(["3"], "R753IE4", "diesel 3 cylinders")[0] > 0 == match(["4"], "R753IE4", "bore 94")[0]
    )
    assert match(["inline", "4"], "Inline 3", "own-inline-3 94 x 107")[0] == 0
    assert match(["inline", "4"], "Inline four", "inline 4 cylinders")[0] > 0
