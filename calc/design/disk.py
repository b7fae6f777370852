# SPDX-License-Identifier: Apache-2.0
"""Files that the program reads and writes: regular ones, read up to a limit, written whole or not at all, one writer at
a time.

What is in the way is an OSError whose `strerror` says it, a Text where the words are this program's.
"""

import errno
import os
import re
import stat
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from shutil import copyfileobj
from typing import BinaryIO

from ..sheet.text import Text
from .limits import LOCK_SECONDS

if sys.platform != "win32":
    import fcntl

DRAFT = re.compile(r"\.contralbero-[0-9a-f]{16}\.new\Z")
PORTS = "0123456789¹²³"
NOT_BARE, NOT_MADE = set('/\\:*?"<>|'), set("$`&;!%^'")
NOT_FIRST = (" ", "-", "~", "#", "@", "=")
DEVICES = {"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$", *(f"{port}{n}" for port in ("COM", "LPT") for n in PORTS)}
LONGEST_NAME, LONGEST_BYTES = 100, 240  # letters, and bytes of them, to which a system adds an ending
FORGOTTEN = 86_400.0  # seconds after which a draft is a killed run's, where no lock can tell
EVERY = 0.01  # seconds between two looks at a lock
WAITS = getattr(os, "O_NONBLOCK", 0)  # else the opening of a pipe waits for its writer
BINARY = getattr(os, "O_BINARY", 0)


class FileChanged(OSError):
    """Another program has changed the file since it was read."""


# --- reading


def read_file(path: Path | str, most: int) -> bytes:
    """The bytes of a regular file that has at most so many."""
    with opened(path) as file:
        raw = file.read(most + 1)
    if raw is None:  # a regular file by its looks, of the kernel's own
        raise OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))
    if len(raw) > most:
        raise OSError(errno.EFBIG, Text("it is too large: at most {most} bytes are read", most=f"{most:,}"))
    return raw


@contextmanager
def opened(path: Path | str) -> Iterator[BinaryIO]:
    """A regular file to read from, which is waited for by no open and no read."""
    try:
        _demand_regular(os.stat(path))  # a device may do something when it is opened
        file = open(path, "rb", opener=lambda name, flags: os.open(name, flags | WAITS))
    except ValueError:
        raise _no_name() from None
    with file:
        _demand_regular(os.fstat(file.fileno()))
        yield file


def _demand_regular(about: os.stat_result) -> None:
    if stat.S_ISDIR(about.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    if not stat.S_ISREG(about.st_mode):
        raise OSError(errno.EINVAL, Text("it is no regular file"))


def _no_name() -> OSError:
    return OSError(errno.EINVAL, Text("the system knows no such name"))


def bare_name(name: str, *, made: bool = True) -> bool:
    """Whether this is the mere name of a file, on any system, and none that hides.  `made`: a file that the program
    makes has no name either that a command takes for an option or a home, a shell runs or replaces, or that is a
    device."""
    short = 0 < len(name) <= LONGEST_NAME and len(name.encode(errors="replace")) <= LONGEST_BYTES
    visible = name.isprintable() and not name.startswith(".")
    return short and visible and not NOT_BARE & set(name) and not (made and _acts(name))


def _acts(name: str) -> bool:
    device = name.partition(".")[0].rstrip().upper() in DEVICES
    return device or name.startswith(NOT_FIRST) or name.endswith((" ", ".")) or bool(NOT_MADE & set(name))


def same_file(a: Path | str, b: Path | str) -> bool:
    """Whether two names lead to one file that is there."""
    with suppress(OSError, ValueError):
        return os.path.samefile(a, b)
    return False


# --- writing


def write_file(
    path: Path | str,
    data: bytes | Path,
    *,
    backup: bool = False,
    inputs: Iterable[Path | str] = (),
    expected: bytes | None = None,
    new: bool = False,
) -> Path:
    """Write a file so that at every moment the old or the new one is whole.  A link is followed, the rights of the old
    file are kept. `data`: what it is to hold, or a file that holds it.

    `backup` keeps the old file as `NAME.bak`.  `inputs` are read by the same command and never written over.
    `expected`: the bytes that the file must still have, if it is there (Changed).  `new`: there must be no such file.
    """
    with _writing(path) as target:
        for name in (target, _backup(target)) if backup else (target,):
            if any(same_file(name, source) for source in inputs):
                raise OSError(errno.EEXIST, Text("it is an input of this very command; give another name"))
        old = _standing(target)
        if new and old is not None:
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
        if expected is not None and old is not None and _differs(target, expected):
            raise FileChanged(errno.EBUSY, Text("another program has changed it since it was read"))
        _replace(target, data, old, backup)
    return Path(path)


def edit_file(path: Path | str, most: int, change: Callable[[bytes], bytes]) -> bytes:
    """Read, change and write a file with no other writer in between; the old one is kept as `NAME.bak`.  Gives what was
    written."""
    with _writing(path) as target:
        old = _standing(target)
        data = change(read_file(target, most))
        _replace(target, data, old, backup=True)
    return data


def demand_writable(path: Path | str) -> None:
    """Raise now what a writing that comes much later would raise, as far as it can be known."""
    target = _where(path)
    _standing(target)
    if not os.access(target.parent, os.W_OK):
        code = errno.EACCES if target.parent.is_dir() else errno.ENOENT
        raise OSError(code, os.strerror(code))


@contextmanager
def _writing(path: Path | str) -> Iterator[Path]:
    """Where a name leads, in a folder that is locked and has no drafts of killed runs."""
    target = _where(path)
    with locked(target.parent) as alone:
        _sweep(target.parent, alone)
        yield target


def _where(path: Path | str) -> Path:
    """Where a name leads."""
    try:
        return Path(os.path.realpath(path))
    except ValueError:
        raise _no_name() from None


def _standing(target: Path) -> os.stat_result | None:
    """What is there; only a regular file that may be written is ever replaced."""
    try:
        about = target.stat()
    except FileNotFoundError:
        return None
    except ValueError:
        raise _no_name() from None
    _demand_regular(about)
    if not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    return about


def _differs(target: Path, expected: bytes) -> bool:
    try:
        return read_file(target, len(expected)) != expected
    except FileNotFoundError:
        return False
    except OSError as error:
        if error.errno != errno.EFBIG:
            raise
        return True


def _replace(target: Path, data: bytes | Path, old: os.stat_result | None, backup: bool) -> None:
    drafts = [target.with_name(f".contralbero-{os.urandom(8).hex()}.new") for _ in range(2)]
    try:
        _put(drafts[0], data, old)
        if backup and old is not None:
            _put(drafts[1], target, old)
            os.replace(drafts[1], _backup(target))
        os.replace(drafts[0], target)
    finally:
        for draft in drafts:
            with suppress(OSError):
                os.unlink(draft)
    _sync_folder(target.parent)


def _put(draft: Path, data: bytes | Path, old: os.stat_result | None) -> None:
    """A file that lies on the disk when this returns, with the rights of the old one or those of the umask."""
    rights = 0o666 if old is None else stat.S_IMODE(old.st_mode)
    handle = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL | BINARY, rights)
    with open(handle, "wb") as file:
        if old is not None:
            with suppress(OSError):
                os.chmod(draft, rights)
        if isinstance(data, Path):
            with data.open("rb") as source:
                copyfileobj(source, file)
        else:
            file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _backup(target: Path) -> Path:
    return target.with_name(target.name + ".bak")


def _sync_folder(folder: Path) -> None:
    """Make the rename itself durable, where the system can."""
    if os.name != "posix":
        return
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


# --- one at a time


@contextmanager
def locked(folder: Path) -> Iterator[bool]:
    """No other run of this program writes in the folder meanwhile.  False where the system has no such lock; a killed
    run's is free."""
    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:  # what is wrong with it, the writing says
        yield False
        return
    try:
        yield _lock(handle)
    finally:
        os.close(handle)


def _lock(handle: int) -> bool:
    ends = time.monotonic() + LOCK_SECONDS
    while True:
        try:
            return lock(handle)
        except BlockingIOError:
            if time.monotonic() > ends:
                reason = Text("another program has held its folder for {seconds} seconds", seconds=LOCK_SECONDS)
                raise TimeoutError(errno.ETIMEDOUT, reason) from None
            time.sleep(EVERY)


def lock(handle: int, *, shared: bool = False) -> bool:
    """Take the lock of an open file or folder, which ends with it.  `shared`: with others that share it.  False where
    there are no locks; BlockingIOError: another has it."""
    if sys.platform == "win32":
        return False
    try:
        fcntl.flock(handle, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except BlockingIOError:
        raise
    except OSError:  # a file system without them
        return False
    return True


def _sweep(folder: Path, alone: bool) -> None:
    """Take away the drafts of killed runs: under the lock every one is; else those of yesterday."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if DRAFT.match(entry.name) and (
                alone or entry.stat(follow_symlinks=False).st_mtime < time.time() - FORGOTTEN
            ):
                with suppress(OSError):
                    os.unlink(entry.path)
