# SPDX-License-Identifier: Apache-2.0
"""What is remembered between two runs: unsaved edits, the last design, the user's keys."""

import asyncio
import os
import threading
import time
import tomllib
from datetime import datetime
from pathlib import Path

import pytest
from textual.messages import ExitApp

from assistant.output import state_dir
from assistant.screens.workbench_results import KEEP
from assistant.session.recovery import RECENT, Edits, Memory, Settings, design_key
from assistant.session.session import EXAMPLE, Session
from calc.sheet.errors import BadInput
from tests.assistant.conftest import NOON, Screen
from tests.assistant.driving import go_to, type_in, until

BORE = "engine.bore_mm"


def reopened(session: Session) -> Session:
    assert session.path is not None
    return Session.open(session.path, memory=session.memory, now=session.now)


# --- what is remembered
def test_unsaved_edits_come_back_as_one_step_that_can_be_undone(session: Session) -> None:
    session.edit(BORE, "95")
    session.edit("engine.rod_length_mm", "170")
    assert not session.safe
    session.autosave()
    assert session.safe and session.autosaved == session.now()
    other = reopened(session)
    assert other.value(BORE) == 95.0 and other.dirty
    assert "12:04" in other.message
    other.undo()
    assert not other.dirty


def test_saving_forgets_the_kept_edits(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    session.save()
    assert session.memory.kept(session.home) == []


def test_undoing_everything_forgets_the_kept_edits(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    session.undo()
    session.autosave()
    assert session.memory.kept(session.home) == []


def test_edits_of_another_version_are_not_put_back_by_themselves(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    session.home.write_text(session.home.read_text(encoding="utf-8") + "# newer\n", encoding="utf-8")
    other = reopened(session)
    assert not other.dirty and "changed since" in other.message
    assert other.restore() and other.value(BORE) == 95.0


def test_edits_of_an_earlier_session_that_were_all_taken_back_do_not_come_again(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    other = reopened(session)
    assert other.value(BORE) == 95.0
    other.undo()
    other.autosave()
    assert not other.dirty and not reopened(session).dirty


@pytest.mark.parametrize("text", ["-1", "12x", "1,234.5", ""])
def test_entries_that_are_not_accepted_come_back_too(session: Session, text: str) -> None:
    session.edit("engine.rod_length_mm", "170")
    session.edit(BORE, text)
    reason = session.reason(BORE)
    assert reason and not session.safe
    session.autosave()
    assert session.safe
    other = reopened(session)
    assert other.value("engine.rod_length_mm") == 170.0
    assert (other.text(BORE), other.reason(BORE)) == (text, reason)
    other.undo()
    assert not other.dirty and other.valid


def test_an_entry_of_a_table_that_is_not_complete_comes_back(session: Session) -> None:
    session.put_table(("engine", "throw"), True)
    session.edit(("engine", "throw", "pin_diameter_mm"), "60")
    session.autosave()
    other = reopened(session)
    assert other.text(("engine", "throw", "pin_diameter_mm")) == "60" and other.reasons() == session.reasons() != {}


def test_a_part_that_is_not_complete_and_has_no_entry_is_not_called_safe(session: Session) -> None:
    session.put_table(("engine", "throw"), True)
    session.autosave()
    assert session.dirty and not session.safe


def test_two_sessions_on_one_file_keep_each_its_own(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    other = reopened(session)  # beside the first, which goes on
    assert other.value(BORE) == 95.0
    other.edit(BORE, "96")
    other.autosave()
    assert not session.safe  # its own is gone: the other one has it
    session.edit("engine.rod_length_mm", "170")
    session.autosave()
    assert session.safe and other.safe
    found = {
        (kept.data["engine"]["bore_mm"], kept.data["engine"]["rod_length_mm"])
        for kept in session.memory.kept(session.home)
    }
    assert found == {(95.0, 170.0), (96.0, 163.0)}
    other.save()
    (mine,) = session.memory.kept(session.home)
    assert mine.session == session.id
    later = reopened(session)
    assert later.value(BORE) == 96.0 and "changed since" in later.message and later.put_aside() == [mine]
    assert later.restore(mine) and later.value("engine.rod_length_mm") == 170.0


def test_a_design_that_was_begun_is_kept_and_has_no_file_before_it_is_saved(tmp_path: Path, memory: Memory) -> None:
    path = tmp_path / "own.toml"
    begun = Session.begin(
        {"schema": 1, "name": "own", "engine": dict(tomllib.loads(EXAMPLE.read_text("utf-8"))["engine"])},
        path,
        memory=memory,
    )
    assert begun.dirty and not begun.safe and memory.last() is None
    begun.edit(BORE, "81")
    begun.edit("engine.rod_length_mm", "12x")
    begun.autosave()
    assert begun.safe and not path.exists() and memory.last() == path
    other = Session.open(None, memory=memory)
    assert (
        other.path == path and other.dirty and other.value(BORE) == 81.0 and other.text("engine.rod_length_mm") == "12x"
    )
    other.undo()
    other.save()
    assert tomllib.loads(path.read_text("utf-8"))["engine"]["bore_mm"] == 81.0 and not other.dirty
    path.unlink()
    assert memory.kept(path) == [] and memory.last() is None


def test_an_entry_that_was_mended_is_no_more_kept(session: Session) -> None:
    session.edit(BORE, "12x")
    session.autosave()
    session.edit(BORE, "94")
    session.autosave()
    assert session.memory.kept(session.home) == []


def test_kept_entries_that_have_no_field_are_left_out(session: Session) -> None:
    odd = {
        ("engine", "no_such_key"): "1",
        ("engine", "bench", 99, "speed_rpm"): "1",
        ("bearings", 3): "1",
        (BORE,): "1",
        (): "1",
    }
    data = {**session.data, "name": "kept"}
    session.memory.keep(session.home, Edits(data, datetime(2026, 1, 1), session.document.sha256, odd))
    other = reopened(session)
    assert other.data["name"] == "kept" and other.valid and other.data["engine"] == session.data["engine"]


def test_edits_are_kept_while_others_are_made_and_saved(session: Session) -> None:
    """A slow disk: keeping is still at work when the design is saved, or the program ends and keeps once more."""
    ends: list[str] = []

    def keep() -> None:
        for _ in range(30):
            session.autosave()
            ends.append(session.autosave_failure)

    others = [threading.Thread(target=keep) for _ in range(2)]
    for other in others:
        other.start()
    for n in range(20):
        session.edit(BORE, str(95 + n))
        if n % 5 == 4:
            session.save()
    for other in others:
        other.join()
    assert ends == [""] * 60 and session.valid
    session.save()
    assert session.memory.kept(session.home) == []
    assert list(session.home.parent.glob(".*")) == []


async def test_edits_are_kept_in_the_middle_of_typing(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.name")
        end = time.perf_counter() + 3 * KEEP
        typed, kept = "", []
        while time.perf_counter() < end and len(kept) < 2:
            typed += "x"
            await type_in(pilot, "x")
            await asyncio.sleep(0.1)  # oftener than KEEP
            for found in light.memory.kept(light.home):
                if found.data["engine"]["name"] not in kept:
                    kept.append(found.data["engine"]["name"])
        assert len(kept) == 2 and len(kept[0]) < len(kept[1]) <= len(typed)


async def test_edits_are_kept_however_the_program_ends(screen: Screen, light: Session) -> None:
    """As when the page of a browser is closed."""
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await until(pilot, lambda: light.value("engine.bore_mm") == 95.0)
        pilot.app.post_message(ExitApp())
    (kept,) = light.memory.kept(light.home)
    assert kept.data["engine"]["bore_mm"] == 95.0


def test_a_state_folder_that_can_not_be_written_is_said(session: Session, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    session.memory = Memory(tmp_path / "file" / "state")
    session.edit(BORE, "95")
    session.autosave()
    assert session.autosave_failure and not session.safe
    session.save()  # nothing else depends on it


def test_damaged_memory_is_no_memory(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    for file in (session.memory.folder / "unsaved").iterdir():
        file.write_text("[unsaved\n")
    assert not reopened(session).dirty
    (session.memory.folder / "last").write_bytes(b"\xff\xfe\x00")
    assert session.memory.last() is None


DEEP = b"a = " + b"[" * 100_000
HEAD = b"[unsaved]\nsha256 = 'a'\ntime = '2020-01-01T00:00:00'\n"


@pytest.mark.skipif(os.name != "posix", reason="pipes of POSIX")
@pytest.mark.parametrize(
    "what",
    [
        None,
        DEEP,
        b"a = " + b"{a=" * 3000,
        b"x" * 2**22,
        b"\xff\0",
        b"a = " + b"9" * 10_000,
        HEAD + b"[design]\nschema = 99\n",
    ],
    ids=["a pipe", "deep", "deep tables", "large", "no text", "many digits", "of a later program"],
)
def test_no_file_of_the_state_folder_stops_or_ends_the_session(tmp_path: Path, what: bytes | None) -> None:
    memory, path = Memory(tmp_path), tmp_path / "d.toml"
    (tmp_path / "unsaved").mkdir()
    unsaved = tmp_path / "unsaved" / f"{design_key(path)}-s.toml"
    for file in (tmp_path / "last", tmp_path / "keys.toml", tmp_path / "settings.toml", unsaved):
        os.mkfifo(file) if what is None else file.write_bytes(what)
    assert memory.last() is None and not memory.recent() and not memory.keys()
    assert memory.settings() == Settings() and not memory.kept(path) and not memory.left(path)
    if what is not None:
        memory.set_setting("language", "it")
        assert memory.settings().language == "it"


def test_kept_edits_that_are_no_design_any_more_are_left_alone(session: Session) -> None:
    session.memory.keep(session.home, Edits({"schema": 1, "name": 3}, datetime(2026, 1, 1), session.document.sha256))
    other = reopened(session)
    assert not other.dirty and not other.message


def test_the_last_design_is_opened(session: Session) -> None:
    assert Session.open(None, memory=session.memory).path == session.path
    session.home.unlink()
    assert Session.open(None, memory=session.memory).example


def test_a_last_design_that_is_broken_gives_the_example_and_says_so(session: Session) -> None:
    session.home.write_text("no design")
    other = Session.open(None, memory=session.memory)
    assert other.example and "can not be opened" in other.message


def test_a_file_that_is_no_design_is_refused_with_every_error(design: Path, memory: Memory) -> None:
    design.write_text(
        design.read_text(encoding="utf-8")
        .replace("cylinders = 3", "cylinders = 99")
        .replace("strokes = 4", 'strokes = "x"'),
        encoding="utf-8",
    )
    with pytest.raises(BadInput) as bad:
        Session.open(design, memory=memory)
    assert {"engine.cylinders", "engine.strokes"} <= {error.key for error in bad.value.errors}


def test_where_the_state_is_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    assert state_dir() == tmp_path / "contralbero"
    monkeypatch.delenv("XDG_STATE_HOME")
    assert state_dir().parts[-3:] == (".local", "state", "contralbero")


def test_the_user_s_own_keys(memory: Memory) -> None:
    assert memory.keys() == {}
    memory.folder.mkdir()
    (memory.folder / "keys.toml").write_text('save = "ctrl+w"\nodd = 3\n')
    assert memory.keys() == {"save": "ctrl+w"}


# --- recent designs
def test_recent_designs_newest_first_and_only_those_that_are_there(memory: Memory, tmp_path: Path) -> None:
    assert memory.recent() == []
    paths = [tmp_path / f"{n}.toml" for n in range(RECENT + 3)]
    for path in paths:
        path.write_text("x")
        memory.remember(path)
    memory.remember(paths[4])
    paths[RECENT].unlink()
    expected = [paths[4], *(path for path in reversed(paths) if path not in (paths[4], paths[RECENT]))][:RECENT]
    assert memory.recent() == expected and memory.last() == paths[4]
    paths[RECENT].write_text("x")  # it is back
    assert paths[RECENT] in memory.recent()


def test_a_list_of_recent_designs_that_is_damaged_is_none(memory: Memory, tmp_path: Path) -> None:
    memory.folder.mkdir()
    (memory.folder / "last").write_text(
        "relative.toml\n\0\n" + "/x" * 5000 + "\n" + str(tmp_path) + "\n", encoding="utf-8"
    )
    assert memory.recent() == [] and memory.last() is None
    (memory.folder / "last").write_bytes(b"\xff\xfe")
    (tmp_path / "a.toml").write_text("x")
    memory.remember(tmp_path / "a.toml")
    assert memory.recent() == [tmp_path / "a.toml"]


# --- settings
def test_settings_are_kept_with_their_comments(memory: Memory) -> None:
    assert memory.settings() == Settings()
    memory.set_setting("guide", False)
    memory.set_setting("theme", "nord")
    assert memory.settings() == Settings("en", "nord", False)
    file = memory.folder / "settings.toml"
    file.write_text("# mine\n" + file.read_text(encoding="utf-8") + "other = 3\n", encoding="utf-8")
    memory.set_setting("language", "it")
    memory.set_setting("guide", True)
    assert Memory(memory.folder).settings() == Settings("it", "nord", True)
    assert file.read_text(encoding="utf-8").startswith("# mine\n") and "other = 3" in file.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("theme = \n", Settings()),
        ('guide = "no"\ntheme = 5\nlanguage = "it"\n', Settings("it")),
        ("\xff", Settings()),
        ("[theme]\na = 1\n", Settings()),
    ],
)
def test_damaged_settings_are_left_alone(memory: Memory, text: str, found: Settings) -> None:
    memory.folder.mkdir()
    (memory.folder / "settings.toml").write_bytes(text.encode("latin-1"))
    assert memory.settings() == found
    memory.set_setting("theme", "nord")
    assert memory.settings().theme == "nord" and memory.settings().language == found.language


def test_settings_that_can_not_be_kept_stop_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    memory = Memory(tmp_path / "file" / "state")
    memory.set_setting("theme", "nord")
    memory.remember(tmp_path / "a.toml")
    assert memory.settings() == Settings() and memory.recent() == []


@pytest.mark.parametrize("text", ["hello", "99999"])
def test_a_session_that_begins_with_an_entry_that_is_not_accepted_has_the_results_of_the_last_valid_input(
    design: Path, memory: Memory, text: str
) -> None:
    first = Session.open(design, memory=memory, now=lambda: NOON)
    first.edit(first.place("engine.rod_length_mm"), text)
    first.autosave()
    again = Session.open(design, memory=memory, now=lambda: NOON)
    assert again.text("engine.rod_length_mm") == text and not again.valid
    again.solve()
    assert again.results is not None and again.job() is None and not again.current
    assert again.undo() is not None
    again.solve()
    assert again.current
