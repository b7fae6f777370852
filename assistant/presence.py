# SPDX-License-Identifier: Apache-2.0
"""Which sessions are at a design now: each holds a locked file of its own in the state folder, and the lock ends with its process."""

import contextlib
import hashlib
import os
from pathlib import Path
from secrets import token_hex

from calc.design.disk import lock

FOLDER = "open"


def design_key(path: Path) -> str:
    """What the files of the state folder call a design."""
    return hashlib.sha256(str(path.absolute()).encode("utf-8", "surrogateescape")).hexdigest()[:16]


class Presence:
    """A session at a design, until it leaves.  Where the system has no locks, or the folder can not be written, nobody sees it."""

    def __init__(self, state: Path, path: Path, session: str) -> None:
        self._file = state / FOLDER / f"{design_key(path)}-{session}"
        self._handle: int | None = None
        with contextlib.suppress(OSError):
            self._file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            draft = self._file.with_name(f".{token_hex(8)}")
            self._handle = os.open(draft, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
            lock(self._handle)  # before anybody can see it and take it for one that was left behind
            os.replace(draft, self._file)

    def leave(self) -> None:
        if self._handle is not None:
            with contextlib.suppress(OSError):
                self._file.unlink(missing_ok=True)
            os.close(self._handle)
            self._handle = None


def present(state: Path, path: Path) -> set[str]:
    """The sessions that are at a design.  What those that were killed have left is taken away."""
    found = set[str]()
    try:
        files = list((state / FOLDER).glob(f"{design_key(path)}-*"))
    except OSError:
        return found
    for file in files:
        with contextlib.suppress(OSError):
            handle = os.open(file, os.O_RDWR)
            try:
                if lock(handle):
                    file.unlink(missing_ok=True)
            except BlockingIOError:
                found.add(file.name.partition("-")[2])
            finally:
                os.close(handle)
    return found
