# SPDX-License-Identifier: Apache-2.0
"""A fault of the program itself: one line, where its trace is kept, and an exit code that is no verdict."""

import os
import sys
import tempfile
import traceback
from contextlib import suppress
from datetime import datetime
from pathlib import Path

from calc.sheet.visible import visible
from calc.version import VERSION

CODE = 70
KEPT = 20  # traces; older ones go


def told(error: BaseException) -> int:
    """Say it on stderr; gives the exit code."""
    what = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    trace = _kept(error)
    where = f"its trace is in {trace}" if trace is not None else "its trace could not be kept"
    print(f"contralbero: a fault of the program itself, no verdict: {' '.join(what.split())[:300]}; {where}", file=sys.stderr)
    return CODE


def _kept(error: BaseException) -> Path | None:
    """The file with the trace: in the user's state folder, else in the one for temporary files."""
    now = datetime.now()
    words = f"contralbero {VERSION}, Python {sys.version}, {now.isoformat(timespec='seconds')}\n{' '.join(sys.argv)}\n\n"
    text = visible(words + "".join(traceback.format_exception(error)), lines=True).encode()
    for folder in _folders():
        with suppress(OSError, ValueError):
            folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            path = folder / f"fault-{now:%Y%m%d-%H%M%S}-{os.getpid()}.txt"
            path.write_bytes(text)
            for old in sorted(folder.glob("fault-*.txt"))[:-KEPT]:
                old.unlink()
            return path
    return None


def _folders() -> list[Path]:
    found = []
    with suppress(Exception):  # it may be that which is at fault
        from .session.recovery import state_dir

        found.append(state_dir() / "faults")
    with suppress(OSError):
        found.append(Path(tempfile.gettempdir()))
    return found
