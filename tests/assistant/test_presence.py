# SPDX-License-Identifier: Apache-2.0
"""Two sessions on one file: each is told of the other, and neither takes nor loses what the other has kept."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from assistant.app import ContralberoApp
from assistant.session.recovery import KEPT, PRESENCE_FOLDER, Memory
from assistant.session.session import EXAMPLE, Session
from tests.assistant.conftest import Screen
from tests.assistant.driving import until

BORE = "engine.bore_mm"
ROOT = EXAMPLE.parent.parent
pytestmark = pytest.mark.skipif(os.name != "posix", reason="the locks of POSIX")


def reopened(session: Session) -> Session:
    assert session.path is not None
    return Session.open(session.path, memory=session.memory, now=session.now)


def test_each_is_told_of_the_other_once(session: Session) -> None:
    session.attend()
    assert not session.joined()
    other = reopened(session)
    assert not other.joined() and not session.joined()  # before it is seen
    other.attend()
    assert other.joined() and not other.joined() and session.joined() and not session.joined()
    other.leave()
    assert not session.joined()
    other.attend()
    assert session.joined()
    assert len(list((session.memory.folder / PRESENCE_FOLDER).iterdir())) == 2
    other.leave()
    session.leave()
    assert list((session.memory.folder / PRESENCE_FOLDER).iterdir()) == []


def test_the_edits_of_a_session_that_lives_are_its_own(session: Session) -> None:
    session.attend()
    session.edit(BORE, "95")
    session.autosave()
    other = reopened(session)
    other.attend()
    assert not other.dirty and not other.message and other.put_aside() == []
    other.edit(BORE, "96")
    other.autosave()
    other.undo()
    other.autosave()  # drops its own alone
    assert session.safe and [kept.session for kept in session.memory.kept(session.home)] == [session.id]
    session.leave()  # it ends unsaved
    assert reopened(session).value(BORE) == 95.0


def test_both_drafts_outlive_both_sessions(session: Session) -> None:
    other = reopened(session)
    for one, bore in ((session, "95"), (other, "96")):
        one.attend()
        one.edit(BORE, bore)
        one.autosave()
    assert session.safe and other.safe
    for one in (session, other):
        one.leave()
    later = reopened(session)
    found = {kept.data["engine"]["bore_mm"] for kept in later.put_aside()}  # type: ignore[index, call-overload]
    assert found == {95.0, 96.0} and later.value(BORE) in found


def test_safe_looks_at_the_disk(session: Session) -> None:
    session.edit(BORE, "95")
    session.autosave()
    assert session.safe
    (file,) = (session.memory.folder / "unsaved").iterdir()
    whole = file.read_bytes()
    for damaged in (b"", whole[: len(whole) // 2], whole.replace(b"95.0", b"94.5")):
        file.write_bytes(damaged)
        assert not session.safe
        session.autosave()  # keeps them once more
        assert session.safe
    file.unlink()
    assert not session.safe


def test_a_session_that_was_killed_is_not_there_any_more(session: Session) -> None:
    words = (
        "import sys; from pathlib import Path; from assistant.session.recovery import Memory; here = "
        "Memory(Path(sys.argv[1])).attend(Path(sys.argv[2]), 'x'); print('here', flush=True); input()"
    )
    command = [sys.executable, "-c", words, str(session.memory.folder), str(session.home)]
    with subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout is not None and other.stdout.readline() == b"here\n"
        assert session.memory.present(session.home) == {"x"}
        other.send_signal(signal.SIGKILL)
        other.wait()
    assert session.memory.present(session.home) == set()
    assert list((session.memory.folder / PRESENCE_FOLDER).iterdir()) == []


def test_edits_of_sessions_that_live_are_kept_however_many_others_there_are(session: Session) -> None:
    session.attend()
    session.edit(BORE, "95")
    session.autosave()
    for n in range(KEPT + 3):
        other = Session.open(session.path, memory=session.memory)
        other.edit(BORE, str(100 + n))
        other._taken = None
        other.autosave()
    assert session.safe and len(session.memory.kept(session.home)) == KEPT + 1


def test_a_session_goes_with_its_file(session: Session, tmp_path: Path) -> None:
    session.attend()
    first = session.home
    session.save_as(tmp_path / "other.toml")
    assert session.memory.present(first) == set() and session.memory.present(session.home) == {session.id}


def test_a_state_folder_that_can_not_be_written_stops_nothing(tmp_path: Path, session: Session) -> None:
    (tmp_path / "file").write_text("")
    session.memory = Memory(tmp_path / "file" / "state")
    session.attend()
    assert not session.joined()
    session.leave()


async def test_the_screen_says_that_another_session_is_there(screen: Screen, light: Session) -> None:
    other = reopened(light)
    async with screen() as pilot:
        app = pilot.app
        assert isinstance(app, ContralberoApp)
        assert not any("another session" in notification.message for notification in app._notifications)
        other.attend()
        app.look()
        await until(
            pilot, lambda: any("light.toml is open in another session too" in n.message for n in app._notifications)
        )
    assert light.memory.present(light.home) == {other.id}
