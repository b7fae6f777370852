# SPDX-License-Identifier: Apache-2.0
"""An engine of one's own, whose fields are still to be filled in."""

from functools import partial
from pathlib import Path

import pytest

from assistant.app import ContralberoApp
from assistant.screens.workbench_panes import FIRST_VALID
from assistant.session.beginnings import _blanks, blank, engine_only
from assistant.session.recovery import Memory
from assistant.session.session import Session
from calc.studies.shipped import engine_design

from .driving import settled, told, work


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "mine.toml"


def begun(id: str, path: Path, memory: Memory) -> Session:
    return Session.begin(blank(id, path), path, memory=memory)


def test_each_of_them_waits_for_its_fields_and_says_nothing_is_wrong(path: Path, memory: Memory) -> None:
    assert len(_blanks()) > 30
    for id in _blanks():
        session = begun(id, path, memory)
        assert session.blank and session.lacking and set(session.lacking) == set(session.reasons()), id


def test_undo_leads_back_to_a_field_that_is_to_be_filled_in(path: Path, memory: Memory) -> None:
    session = begun("inline-4", path, memory)
    before = session.lacking
    session.edit("engine.bore_mm", "75")
    session.seal()
    assert len(session.lacking) == len(before) - 1
    session.undo()
    assert session.lacking == before
    session.edit("engine.bore_mm", "wide")
    assert session.lacking == [] and session.reason("engine.bore_mm")


def test_what_is_filled_in_locked_or_left_out_is_there_again_after_a_crash(path: Path, memory: Memory) -> None:
    session = begun("inline-4", path, memory)
    session.edit("engine.bore_mm", "75")
    session.toggle_lock(session.place("engine.bore_mm"))
    session.leave_out("mounting", "no mounts")
    session.edit("engine.rod_length_mm", "long")
    session.autosave()
    assert not session.autosave_failure
    again = Session.open(path, memory=memory)
    assert again.blank and again.data == session.data and again.text("engine.rod_length_mm") == "long"


def test_a_number_typed_alike_is_ones_own_until_it_is_taken_back(path: Path, memory: Memory) -> None:
    session = Session.begin(engine_only("inline-3", path), path, memory=memory)
    name, places = session.inherited
    bore = session.place("engine.bore_mm")
    assert name.startswith("BMW") and bore in places
    session.edit(bore, session.text(bore))
    session.seal()
    assert bore not in session.inherited[1] and len(session.inherited[1]) == len(places) - 1
    session.undo()
    assert session.inherited[1] == places


def test_its_own_name_is_that_of_its_file(path: Path, memory: Memory) -> None:
    path.write_text(engine_design("inline-6"), encoding="utf-8")
    session = Session.open(path, memory=memory)
    session.save_as(path.with_name("ours.toml"))
    session.edit("engine.bore_mm", "77")
    assert session.text("name") == session.text("engine.name") == "ours"


async def test_nothing_is_built_or_recorded_of_it(path: Path, memory: Memory) -> None:
    session = begun("vee-4", path, memory)
    app = ContralberoApp(session)
    async with app.run_test(size=(80, 24)) as pilot:
        await settled(pilot)
        bench = work(pilot)
        for does in (partial(bench.build_step, "countershaft", ""), bench.action_build_all, bench.action_record):
            app.clear_notifications()
            does()
            await pilot.pause()
            assert told(pilot).strip().endswith(str(FIRST_VALID)), does
        assert session.recording is None


def test_a_lock_beside_a_number_that_is_not_valid_is_kept(path: Path, memory: Memory) -> None:
    path.write_text(engine_design("inline-6"), encoding="utf-8")
    session = Session.open(path, memory=memory)
    session.edit("engine.bore_mm", "-5")
    session.toggle_lock(session.place("engine.rod_length_mm"))
    session.autosave()
    session.leave()
    again = Session.open(path, memory=memory)
    assert again.lock_reason("engine.rod_length_mm") and again.data == session.data and not again.valid
