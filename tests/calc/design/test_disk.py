# SPDX-License-Identifier: Apache-2.0
"""One writer and one reader: what is there is whole at every moment, nothing else than a regular file is touched,
nobody's write is lost."""

import os
import resource
import signal
import stat
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from calc.design import disk as files
from calc.design.disk import FileChanged, bare_name, edit_file, locked, read_file, same_file, write_file
from calc.design.limits import DESIGN_BYTES

pytestmark = pytest.mark.skipif(os.name != "posix", reason="pipes, links, rights and locks of POSIX")
CALLS = ("open", "fsync", "chmod", "replace", "unlink", "close", "stat", "access", "scandir")


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


@pytest.fixture
def path(tmp_path: Path) -> Path:
    made = tmp_path / "a.toml"
    made.write_bytes(b"old")
    return made


# --- what is written
def test_the_old_file_is_kept_where_it_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    write_file(path, b"one", backup=True)
    assert names(tmp_path) == ["a.toml"]
    for data in (b"two", b"three"):
        write_file(path, data, backup=True)
    assert path.read_bytes() == b"three" and (tmp_path / "a.toml.bak").read_bytes() == b"two"
    write_file(path, b"four")
    assert (tmp_path / "a.toml.bak").read_bytes() == b"two" and names(tmp_path) == ["a.toml", "a.toml.bak"]


def test_a_new_file_has_the_rights_of_the_umask_and_an_old_one_its_own_and_so_has_what_is_kept(path: Path) -> None:
    before = os.umask(0o027)
    try:
        new = write_file(path.with_name("new"), b"")
        path.chmod(0o600)
        write_file(path, b"new", backup=True)
    finally:
        os.umask(before)
    assert [stat.S_IMODE(one.stat().st_mode) for one in (new, path, path.with_name("a.toml.bak"))] == [
        0o640,
        0o600,
        0o600,
    ]


def test_a_link_is_followed(path: Path) -> None:
    link, dangling = path.with_name("link"), path.with_name("dangling")
    link.symlink_to(path)
    dangling.symlink_to("there")
    write_file(link, b"new")
    write_file(dangling, b"new")
    assert (
        link.is_symlink()
        and dangling.is_symlink()
        and path.read_bytes() == path.with_name("there").read_bytes() == b"new"
    )


@pytest.mark.parametrize(
    "kind", ["folder", "pipe", "device", "link to a device", "loop", "no name", "no folder", "a file as folder"]
)
def test_only_regular_files_are_written_and_read(path: Path, kind: str) -> None:
    target = path.with_name("target")
    if kind == "folder":
        target.mkdir()
    elif kind == "pipe":
        os.mkfifo(target)
    elif kind == "link to a device":
        target.symlink_to("/dev/zero")
    elif kind == "loop":
        target.symlink_to(target)
    name = {
        "device": "/dev/null",
        "no name": f"{path}\0",
        "no folder": path / "no" / "x",
        "a file as folder": path / "x",
    }.get(kind, target)
    before = names(path.parent)
    for act in (
        lambda: write_file(name, b"new"),
        lambda: read_file(name, 10),
        lambda: edit_file(name, 10, bytes.upper),
    ):
        with pytest.raises(OSError) as refused:
            act()
        assert refused.value.strerror
    assert names(path.parent) == before and path.read_bytes() == b"old"


def test_a_file_is_read_to_its_limit(path: Path) -> None:
    assert read_file(path, 3) == b"old"
    with pytest.raises(OSError, match="at most 2 bytes"):
        read_file(path, 2)
    with path.open("wb") as file:
        file.truncate(2**40)  # with no byte on the disk
    with pytest.raises(OSError, match="at most 1,048,576 bytes"):
        read_file(path, DESIGN_BYTES)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everything")
def test_what_may_not_be_written_is_not_replaced_either(path: Path) -> None:
    path.chmod(0o444)
    with pytest.raises(PermissionError):
        write_file(path, b"new")
    path.chmod(0o644)
    path.parent.chmod(0o555)
    with pytest.raises(PermissionError):
        write_file(path, b"new")
    path.parent.chmod(0o755)
    assert path.read_bytes() == b"old"


@pytest.mark.parametrize("how", ["itself", "by another way", "by a link", "by a hard link", "as what would be kept"])
def test_an_input_is_never_written_over(path: Path, how: str) -> None:
    target, asked = path, path.with_name("b")
    if how == "itself":
        asked = path
    elif how == "by another way":
        asked = path.parent / ".." / path.parent.name / path.name
    elif how == "by a link":
        asked.symlink_to(path)
    elif how == "by a hard link":
        asked.hardlink_to(path)
    else:
        target, asked = path.rename(path.with_name("b.bak")), write_file(asked, b"b")
    with pytest.raises(OSError, match="an input of this very command"):
        write_file(asked, b"new", backup=True, inputs=["nowhere", target])
    assert target.read_bytes() == b"old"


def test_a_file_that_another_program_has_changed_or_made_is_left_alone(path: Path) -> None:
    for expected in (b"older", b"ol", b"old and more"):
        with pytest.raises(FileChanged):
            write_file(path, b"new", expected=expected)
    with pytest.raises(FileExistsError):
        write_file(path, b"new", new=True)
    assert path.read_bytes() == b"old"
    write_file(path, b"new", expected=b"old")
    path.unlink()
    write_file(path, b"again", expected=b"new")
    assert path.read_bytes() == b"again"


@pytest.mark.parametrize(
    ("name", "bare"),
    [
        ("a.pdf", True),
        ("à b.pdf", True),
        ("", False),
        (".", False),
        ("..", False),
        (".a", False),
        ("a/b", False),
        ("a\\b", False),
        ("C:a", False),
        ("a\0", False),
        ("a\n", False),
        ("\x1b[31ma", False),
        ("a" * 101, False),
        ("\u202ea", False),
        ("out (2).pdf", True),
        ("Prüfung_3-b, v1.2.pdf", True),
        ("console.pdf", True),
        ("com.pdf", True),
        ("-o.pdf", False),
        ("--lang=it.pdf", False),
        ("~x.pdf", False),
        ("~.pdf", False),
        (" a.pdf", False),
        ("\u00a0a.pdf", False),
        ("\u3000a.pdf", False),
        ("a.pdf ", False),
        ("a.", False),
        ("CON", False),
        ("con.pdf", False),
        ("Nul .pdf", False),
        ("aux.tar.pdf", False),
        ("COM1.pdf", False),
        ("lpt².pdf", False),
        ("CONIN$", False),
        ("$(id).pdf", False),
        ("`id`.pdf", False),
        ("%TEMP%.pdf", False),
        ("a;b.pdf", False),
        ("a&b.pdf", False),
        ("a'b.pdf", False),
        ("!a.pdf", False),
        ("#a.pdf", False),
        ("@a.pdf", False),
        ("\U00010348" * 80, False),  # of 320 bytes
        ("\udcff.pdf", False),
    ],
)
def test_bare_names(name: str, bare: bool) -> None:
    assert bare_name(name) == bare


@pytest.mark.parametrize("name", ["R&D (50 %).png", "the firm's.png", "~a.png"])
def test_a_file_that_is_only_read_may_have_a_name_that_none_is_given(name: str) -> None:
    assert bare_name(name, made=False) and not bare_name(name)
    assert not bare_name("../a", made=False)


def test_same_file(path: Path) -> None:
    assert (
        same_file(path, path.parent / "." / path.name) and not same_file(path, "nowhere") and not same_file(path, "\0")
    )


# --- what goes wrong
@contextmanager
def failing(call: int, error: BaseException) -> Iterator[list[str]]:
    """The n-th thing that the writer asks of the system fails; gives what it asked for."""
    asked: list[str] = []
    numbers = count(1)

    def instead(name: str, do: object) -> object:
        def wrapped(*given: object, **named: object) -> object:
            asked.append(name)
            if next(numbers) == call:
                if name == "close":  # which closes all the same
                    do(*given, **named)  # type: ignore[operator]
                raise error
            return do(*given, **named)  # type: ignore[operator]

        return wrapped

    with pytest.MonkeyPatch.context() as patch:
        for name in CALLS:
            patch.setattr(files.os, name, instead(name, getattr(os, name)))
        yield asked


@pytest.mark.parametrize(
    "error", [OSError(28, "No space left on device"), KeyboardInterrupt()], ids=["disk full", "ctrl-c"]
)
def test_whatever_fails_the_file_is_the_old_or_the_new_one_and_nothing_else_stays(
    tmp_path: Path, error: BaseException
) -> None:
    kept = tmp_path / "a.toml.bak"
    found, ways = [], []
    for call in range(1, 100):
        path = tmp_path / "a.toml"
        path.write_bytes(b"old")
        kept.write_bytes(b"older")
        told: BaseException | None = None
        with failing(call, error) as asked:
            try:
                write_file(path, b"new", backup=True)
            except BaseException as raised:
                told = raised
        found.append(path.read_bytes())
        assert found[-1] in (b"old", b"new") and kept.read_bytes() in (b"older", b"old")
        assert told in (None, error) and (told is None) <= (found[-1] == b"new")  # what was not written is said
        left = [name for name in names(tmp_path) if name not in ("a.toml", "a.toml.bak")]
        # the one whose removal failed, which the next write takes away
        assert len(left) <= (asked[-1] == "unlink" or "unlink" in asked)
        write_file(path, b"next")
        assert names(tmp_path) == ["a.toml", "a.toml.bak"]
        ways.append(len(asked))
        if call > len(asked):
            break
    assert len(found) > 12 and set(found) == {b"old", b"new"} and call > len(asked)


def test_a_full_disk_is_said_and_changes_nothing(path: Path) -> None:
    """The bytes themselves can not be written: the system's limit for files stands for the full disk."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    ignored = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
    try:
        with pytest.raises(OSError, match="File too large"):
            write_file(path, b"x" * 5000, backup=True)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, ignored)
    assert path.read_bytes() == b"old" and names(path.parent) == ["a.toml"]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=60)
@given(st.lists(st.tuples(st.binary(max_size=40), st.integers(1, 30), st.booleans()), max_size=12))
def test_any_writes_of_which_some_fail(tmp_path: Path, writes: list[tuple[bytes, int, bool]]) -> None:
    """A model of one file: after each write it holds that one or the one before, as the writer says."""
    path = tmp_path / "a"
    path.write_bytes(b"first")
    held = b"first"
    for data, call, backup in writes:
        done = False
        with failing(call, OSError(5, "Input/output error")), suppress(OSError):
            write_file(path, data, backup=backup, expected=held)
            done = True
        there = path.read_bytes()
        assert there == data if done else there in (held, data)
        held = there
    write_file(path, b"last")
    assert set(names(tmp_path)) <= {"a", "a.bak"} and path.read_bytes() == b"last"


# --- one at a time
def test_drafts_of_killed_runs_are_taken_away_and_nothing_else(path: Path) -> None:
    theirs = [
        ".contralbero-0123456789abcdef.new.txt",
        ".a.toml.77.new",
        "contralbero-0123456789abcdef.new",
        ".contralbero-012.new",
    ]
    for name in (*theirs, ".contralbero-0123456789abcdef.new"):
        path.with_name(name).write_text("half")
    write_file(path, b"new")
    assert names(path.parent) == sorted([*theirs, "a.toml"])


def test_without_locks_a_draft_may_be_of_a_run_that_lives(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(files, "lock", lambda handle: False)
    draft = path.with_name(".contralbero-0123456789abcdef.new")
    draft.write_text("half")
    write_file(path, b"new")
    assert draft.exists()
    os.utime(draft, (0, 0))
    write_file(path, b"new")
    assert not draft.exists()


def test_a_folder_that_another_program_holds_is_waited_for_and_then_said(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "LOCK_SECONDS", 0.05)
    with locked(path.parent) as alone:
        assert alone
        with pytest.raises(TimeoutError, match="held its folder"):
            write_file(path, b"new")
    write_file(path, b"new")
    assert path.read_bytes() == b"new"


def test_edits_of_many_writers_are_all_there(path: Path) -> None:
    """Each adds a line to what is there when its turn comes."""

    def add(line: str) -> None:
        edit_file(path, DESIGN_BYTES, lambda raw: raw + line.encode())

    def work(n: int) -> None:
        for k in range(10):
            add(f"\n{n} {k}")

    writers = [threading.Thread(target=work, args=(n,)) for n in range(4)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join()
    assert sorted(path.read_text().splitlines()[1:]) == sorted(f"{n} {k}" for n in range(4) for k in range(10))
    assert names(path.parent) == ["a.toml", "a.toml.bak"]
