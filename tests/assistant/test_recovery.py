# SPDX-License-Identifier: Apache-2.0
"""What is remembered between two runs: unsaved edits, the last design, the user's keys."""

from datetime import datetime
from pathlib import Path

import pytest

from assistant.recovery import RECENT, Edits, Memory, Settings, state_dir
from assistant.session import Session
from calc.sheet.errors import BadInput

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
    assert session.memory.kept(session.home) is None


def test_undoing_everything_forgets_the_kept_edits(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    session.undo()
    session.autosave()
    assert session.memory.kept(session.home) is None


def test_edits_of_another_version_are_not_put_back_by_themselves(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    session.home.write_text(session.home.read_text(encoding="utf-8") + "# newer\n", encoding="utf-8")
    other = reopened(session)
    assert not other.dirty and "changed since" in other.message
    assert other.restore() and other.value(BORE) == 95.0


def test_of_invalid_input_the_last_valid_state_is_kept(session: Session) -> None:
    session.edit("engine.rod_length_mm", "170")
    session.edit(BORE, "-1")
    session.autosave()
    assert not session.safe
    other = reopened(session)
    assert other.value("engine.rod_length_mm") == 170.0 and other.value(BORE) == 94.0


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


def test_kept_edits_that_are_no_design_any_more_are_left_alone(session: Session) -> None:
    session.memory.keep(session.home, Edits({"schema": 1, "name": 3}, datetime(2026, 1, 1), session.document.sha256))
    assert not reopened(session).dirty


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
        design.read_text(encoding="utf-8").replace("cylinders = 3", "cylinders = 99").replace("strokes = 4", 'strokes = "x"'),
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
    (memory.folder / "last").write_text("relative.toml\n\0\n" + "/x" * 5000 + "\n" + str(tmp_path) + "\n", encoding="utf-8")
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
