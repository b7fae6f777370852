# SPDX-License-Identifier: Apache-2.0
"""The session, without a screen."""

import json
import os
import subprocess
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from assistant.session.recovery import Memory
from assistant.session.saving import ChangedOnDisk, SaveError
from assistant.session.session import EXAMPLE, Session
from assistant.session.solving import Answer, run
from calc.design.toml_file import load
from calc.sheet.errors import BadInput
from calc.studies.shipped import DESIGNS

BORE = "engine.bore_mm"


def reopened(session: Session) -> Session:
    assert session.path is not None
    return Session.open(session.path, memory=session.memory, now=session.now)


# --- editing
def test_an_edit_changes_the_value(session: Session) -> None:
    assert session.edit(BORE, "3,7 in") == ""
    assert session.value(BORE) == 93.98
    assert session.text(BORE) == "93.98"
    assert session.dirty and session.valid
    assert session.generation == 2


def test_the_same_text_is_no_edit(session: Session) -> None:
    session.edit(BORE, "94.0")
    assert not session.dirty
    assert session.generation == 1
    assert session.undo() is None


def test_keys_of_elements_by_name_and_by_place(session: Session) -> None:
    session.edit("countershaft.masses.rear.mass_kg", "3")
    assert session.value(("shafts", 0, "masses", 1, "mass_kg")) == 3.0


def test_an_empty_field_leaves_the_key_out(session: Session) -> None:
    assert session.edit("gears.ball_diameter_mm", "") == ""
    assert session.value("gears.ball_diameter_mm") is None
    assert "ball_diameter_mm" not in session.data["gears"]
    assert "is empty" in session.edit(BORE, " ")


def test_a_single_number_in_a_list_stays_a_number(session: Session) -> None:
    session.edit("friction.flank_roughness_um", "0.9")
    assert session.value("friction.flank_roughness_um") == 0.9
    session.edit("friction.flank_roughness_um", "0.9; 0.7")
    assert session.value("friction.flank_roughness_um") == [0.9, 0.7]


def test_renaming_an_element_letter_by_letter(session: Session) -> None:
    place = ("shafts", 0, "masses", 0, "name")
    for text in ("", "r", "re", "rear", "rear-2"):
        session.edit(place, text)
    assert session.valid
    assert [m["name"] for m in session.data["shafts"][0]["masses"]] == ["rear-2", "rear"]


# --- undo
def test_edits_of_one_field_in_a_row_are_one_step(session: Session) -> None:
    for text in ("9", "95", "95.5"):
        session.edit(BORE, text)
    session.edit("engine.rod_length_mm", "170")
    assert session.undo() == ("engine", "rod_length_mm")
    assert session.value(BORE) == 95.5
    assert session.undo() == ("engine", "bore_mm")
    assert session.value(BORE) == 94.0 and not session.dirty
    assert session.undo() is None
    assert session.redo() == ("engine", "bore_mm") and session.value(BORE) == 95.5
    assert session.redo() and session.value("engine.rod_length_mm") == 170.0
    assert session.redo() is None


def test_leaving_the_field_ends_the_step(session: Session) -> None:
    session.edit(BORE, "95")
    session.seal()
    session.edit(BORE, "96")
    session.undo()
    assert session.value(BORE) == 95.0


def test_a_new_edit_forgets_what_was_undone(session: Session) -> None:
    session.edit(BORE, "95")
    session.undo()
    session.edit(BORE, "96")
    assert session.redo() is None


def test_typing_back_to_the_start_leaves_nothing_to_undo(session: Session) -> None:
    session.edit(BORE, "95")
    session.edit(BORE, "94")
    assert not session.dirty
    assert session.undo() is None


def test_undo_takes_back_a_text_that_was_not_understood(session: Session) -> None:
    session.edit(BORE, "9x")
    assert session.text(BORE) == "9x"
    session.undo()
    assert session.text(BORE) == "94" and session.valid


# --- invalid input
@pytest.mark.parametrize(
    ("text", "reason"), [("1,234.5", "ambiguous"), ("-5", "above 0"), ("", "is empty"), ("much", "no number")]
)
def test_invalid_input_keeps_the_last_valid_results(session: Session, text: str, reason: str) -> None:
    session.solve()
    before = session.results
    assert reason in session.edit(BORE, text)
    assert session.text(BORE) == text
    assert not session.valid and session.job() is None
    assert session.results is before
    assert session.design.engine is not None and session.design.engine.bore == 0.094
    with pytest.raises(SaveError, match=r"not saved: engine\.bore_mm: "):
        session.save()


def test_a_mistake_that_only_the_whole_shows_stands_at_its_field(session: Session) -> None:
    session.edit("engine.cylinders", "4")
    assert "has 3 entries" in session.reason("engine.firing_order")
    session.edit("engine.firing_order", "1, 3, 4, 2")
    assert not session.reason("engine.firing_order")
    # a crank of three throws: said at the list of its bodies
    assert list(session.reasons()) == [("imbalance", "crank_bodies")]
    while session.value(("imbalance", "crank_bodies")):
        session.remove("imbalance.crank_bodies", 0)
    assert session.valid


def test_mistakes_in_elements_stand_at_the_element(session: Session) -> None:
    session.edit("gears.wheels.idler.teeth", "2")
    assert "5" in session.reason(("gears", "wheels", 2, "teeth"))
    assert list(session.reasons()) == [("gears", "wheels", 2, "teeth")]


# --- solving
def test_answers_to_older_questions_are_dropped(session: Session) -> None:
    old = session.job()
    assert old is not None
    answer = run(old)
    session.edit(BORE, "95")
    assert not session.accept(answer)
    assert session.results is None
    session.solve()
    assert session.current and session.results is not None
    assert session.job() is None


def test_a_mistake_of_the_program_is_a_message(
    session: Session, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    session.solve()
    before = session.results
    monkeypatch.setattr("calc.solve.solve", lambda *_, **__: 1 / 0)
    session.edit(BORE, "95")
    session.solve()
    assert "ZeroDivisionError" in session.failure
    assert session.results is before


def test_verdicts_come_ahead_of_a_long_solve(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    session.solve()
    assert (before := session.results) is not None
    monkeypatch.setattr("assistant.session.session.LONG", 0.0)
    session.edit(BORE, "95")
    job = session.brief_job()
    assert job is not None and job.brief
    assert not session.judged and session.verdicts is before
    assert session.accept(run(job))
    assert session.judged and not session.current
    assert session.results is before  # what has lines stays until there are others
    ahead = session.verdicts
    assert ahead is not None and ahead is not before and not ahead.recorded
    assert session.brief_job() is None and session.job() is not None
    session.solve()
    assert session.current and session.verdicts is session.results is not before
    assert session.results.words() == ahead.words()


def test_verdicts_that_could_not_be_found_ahead_are_left_to_the_whole(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    session.solve()
    monkeypatch.setattr("assistant.session.session.LONG", 0.0)
    session.edit(BORE, "95")
    assert session.accept(Answer(session.generation, None, 0.0, "broken", brief=True))
    assert not session.judged and not session.failure
    assert session.brief_job() is None and session.job() is not None


def test_an_answer_without_results_is_taken_once(session: Session) -> None:
    assert session.accept(Answer(session.generation, None, 0.0, "broken"))
    assert session.job() is None


# --- saving
def test_saving_keeps_comments_and_the_old_file(session: Session) -> None:
    assert session.path is not None
    old = session.path.read_text(encoding="utf-8")
    session.edit("imbalance.crank_balance_fraction", "0.4")
    path = session.save()
    new = path.read_text(encoding="utf-8")
    assert [b for a, b in zip(old.splitlines(), new.splitlines(), strict=True) if a != b] == [
        "crank_balance_fraction = 0.4    # crank, pulley and flywheel together"
    ]
    assert path.with_name(path.name + ".bak").read_text(encoding="utf-8") == old
    assert not session.dirty
    assert load(path)[0].data == session.data


def test_undo_reaches_behind_a_save(session: Session) -> None:
    session.edit(BORE, "95")
    session.save()
    session.undo()
    assert session.value(BORE) == 94.0 and session.dirty
    session.save()
    assert load(session.home)[0].data["engine"]["bore_mm"] == 94.0


def test_the_example_is_saved_under_a_name_of_its_own(
    memory: Memory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shipped = EXAMPLE.read_bytes()
    session = Session.open(None, memory=memory)
    assert session.example and session.name == EXAMPLE.name
    (tmp_path / EXAMPLE.name).write_text("mine")
    session.edit(BORE, "95")
    assert session.save() == tmp_path / f"{EXAMPLE.stem}-2.toml"
    assert (tmp_path / EXAMPLE.name).read_text() == "mine"
    assert EXAMPLE.read_bytes() == shipped
    assert not session.example


def test_the_shipped_file_is_never_overwritten(memory: Memory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    session = Session.open(EXAMPLE, memory=memory)
    session.edit(BORE, "95")
    with pytest.raises(SaveError, match="shipped"):
        session.save_as(DESIGNS / "other.toml")
    assert session.save().parent == tmp_path


def test_save_as_goes_on_with_the_new_file(session: Session, tmp_path: Path) -> None:
    session.edit(BORE, "95")
    first = session.home
    path = session.save_as(tmp_path / "second")
    assert path == tmp_path / "second.toml" and session.path == path
    assert load(first)[0].data["engine"]["bore_mm"] == 94.0
    assert session.memory.last() == path


def test_a_file_that_another_program_changed_is_not_overwritten_at_once(session: Session) -> None:
    session.edit(BORE, "95")
    session.home.write_text(session.home.read_text(encoding="utf-8") + "# theirs\n", encoding="utf-8")
    with pytest.raises(ChangedOnDisk):
        session.save()
    session.save(force=True)
    assert "# theirs" in session.home.with_name(session.name + ".bak").read_text(encoding="utf-8")


def test_read_only(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    assert not session.read_only
    monkeypatch.setattr(os, "access", lambda path, mode: Path(path) != session.home)
    assert session.read_only


# --- start-up
def test_a_session_needs_neither_textual_nor_numpy() -> None:
    code = (
        "import sys, json; from pathlib import Path; from assistant.session.session import Session, EXAMPLE; from "
        "assistant.session.recovery import Memory\n"
        "s = Session.open(EXAMPLE, memory=Memory(Path('/nowhere'))); s.edit('engine.bore_mm', '95')\n"
        "print(json.dumps([m for m in ('textual', 'rich', 'numpy', 'scipy', 'tomlkit', 'tomli_w', 'reportlab') if m "
        "in sys.modules]))"
    )
    root = EXAMPLE.parent.parent
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=root)
    assert json.loads(done.stdout) == []


def test_a_notation_that_can_not_be_edited_is_written_anew_and_said(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> str:
        raise SaveError("no")

    monkeypatch.setattr("assistant.session.saving.edited_text", refuse)
    session.edit(BORE, "95")
    assert load(session.save())[0].data["engine"]["bore_mm"] == 95.0
    assert "comments" in session.message


def test_bytes_are_what_would_be_saved(session: Session) -> None:
    assert session.bytes() == session.home.read_bytes()
    session.edit(BORE, "95")
    assert tomllib.loads(session.bytes().decode())["engine"]["bore_mm"] == 95.0
    assert replace(session.document).data == session.data


# --- changed on disk
def changed(session: Session, old: str, new: str) -> None:
    text = session.home.read_text(encoding="utf-8")
    assert old in text
    session.home.write_text(text.replace(old, new), encoding="utf-8")


def test_a_change_on_disk_is_seen_once(session: Session) -> None:
    assert not session.look() and not session.look()
    changed(session, "bore_mm = 94.0", "bore_mm = 94.5")
    assert session.look() and not session.look()
    changed(session, "bore_mm = 94.5", "bore_mm = 94.25")
    assert session.look()
    changed(session, "bore_mm = 94.25", "bore_mm = 94.0")
    assert not session.look()  # as it was read
    os.utime(session.home, (1, 1))
    assert not session.look()
    session.edit(BORE, "95")
    session.save()
    assert not session.look()
    session.home.unlink()
    assert not session.look()


def test_reading_anew_is_one_step_that_can_be_undone(session: Session) -> None:
    session.edit(BORE, "95")
    session.edit("engine.rod_length_mm", "x")
    session.solve()
    changed(session, "rod_length_mm = 163.0", "rod_length_mm = 170.0  # theirs")
    assert session.reload() and not session.reload()
    assert session.value(BORE) == 94.0 and session.value("engine.rod_length_mm") == 170.0
    assert (
        session.valid
        and not session.dirty
        and session.design.engine is not None
        and session.design.engine.rod_length == 0.17
    )
    assert session.document.sha256 == Session.open(session.home, memory=session.memory).document.sha256
    session.undo()
    assert session.text("engine.rod_length_mm") == "x"
    session.undo()
    assert session.value(BORE) == 95.0 and session.dirty
    session.redo()
    session.redo()
    assert session.value("engine.rod_length_mm") == 170.0 and not session.dirty
    session.edit(BORE, "96")
    session.save()  # not over something unseen
    text = session.home.read_text(encoding="utf-8")
    assert "bore_mm = 96.0" in text and "# theirs" in text


def test_comments_alone_are_taken_over_too(session: Session) -> None:
    changed(session, "bore_mm = 94.0", "bore_mm = 94.0  # measured")
    assert session.look() and session.reload() and not session.dirty
    session.edit(BORE, "95")
    session.save()
    assert "bore_mm = 95.0  # was 94.0, measured" in session.home.read_text(encoding="utf-8")


def test_a_file_that_is_no_design_is_not_taken(session: Session, memory: Memory) -> None:
    session.edit(BORE, "95")
    before = session.data
    changed(session, "cylinders = 3", "cylinders = 99")
    with pytest.raises(BadInput, match="cylinders"):
        session.reload()
    assert session.data is before and session.valid
    with pytest.raises(ChangedOnDisk):
        session.save()
    session.home.unlink()
    with pytest.raises(BadInput, match="cannot be read"):
        session.reload()
    with pytest.raises(BadInput, match="no file of its own"):
        Session.open(EXAMPLE, memory=memory).reload()


def test_a_read_only_file_can_be_read_anew_and_saved_elsewhere(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    home = session.home
    monkeypatch.setattr(os, "access", lambda path, mode: Path(path) != home)
    changed(session, "bore_mm = 94.0", "bore_mm = 94.5")
    assert session.read_only and session.reload() and session.value(BORE) == 94.5
    session.save_as(tmp_path / "elsewhere.toml")
    assert not session.read_only
