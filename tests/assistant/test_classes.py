# SPDX-License-Identifier: Apache-2.0
"""Lists of lists in the form: the classes that shells are picked by, typed as the file has them."""

import tomllib
from pathlib import Path

import tomli_w

from assistant.session.recovery import Memory
from assistant.session.session import Session
from tests.assistant.conftest import NOON, Screen
from tests.assistant.driving import go_to, rows, settled, strike, type_in
from tests.calc.bearings.plain.test_seat_inputs import document

JOURNALS = "bearings.select.journal_classes_mm"


async def test_classes_are_typed_as_the_file_has_them(screen: Screen, tmp_path: Path, memory: Memory) -> None:
    path = tmp_path / "shells.toml"
    path.write_text(tomli_w.dumps(document().data), encoding="utf-8")
    session = Session.open(path, memory=memory, now=lambda: NOON)
    async with screen(session=session, size=(80, 24)) as pilot:
        box = await go_to(pilot, JOURNALS)
        assert box.value == "[[27.987, 27.993], [27.994, 28]]"
        await type_in(pilot, "[[27.987, 27.993], [27.992, 28.0]]")  # one overlaps the other
        await strike(pilot, "down")
        await settled(pilot)
        assert "rising and apart" in str(session.reason(JOURNALS)) and "rising and" in rows(pilot)
        await go_to(pilot, JOURNALS)
        await type_in(pilot, "[[27.985, 27.99], [27.991, 28.0]]")
        await strike(pilot, "down")
        await settled(pilot)
        assert not session.reason(JOURNALS) and session.value(JOURNALS) == [[27.985, 27.99], [27.991, 28.0]]


def test_what_is_typed_of_classes_is_told_where_it_stands_and_saved(tmp_path: Path, memory: Memory) -> None:
    path = tmp_path / "shells.toml"
    path.write_text(tomli_w.dumps(document().data), encoding="utf-8")
    session = Session.open(path, memory=memory, now=lambda: NOON)
    assert "is not finished" in str(session.edit(JOURNALS, "[[27.987, 27.993"))
    assert "[[1.48, 1.49]" in str(session.edit(JOURNALS, "27,987; 27,993"))
    assert "is missing" in str(session.edit(JOURNALS, ""))
    assert not session.edit(JOURNALS, "[[27.985, 27.99], [27.991, 28.0]]")
    assert not session.edit("bearings.select.walls_mm", "[[1.49, 1.494], [1.494, 1.498]]")
    assert "from 0 to 1" in str(session.edit("bearings.select.pick", "[[0, 1], [2, 0]]"))
    assert not session.edit("bearings.select.pick", "[[1, 0], [1, 1]]")
    assert session.valid
    session.save()
    saved = tomllib.loads(path.read_text(encoding="utf-8"))["bearings"]["select"]
    assert saved["journal_classes_mm"] == [[27.985, 27.99], [27.991, 28.0]] and saved["pick"] == [[1, 0], [1, 1]]
