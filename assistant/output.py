# SPDX-License-Identifier: Apache-2.0
"""Where the text of the command line leaves, and what is said when the program itself fails.

Nothing in a text is obeyed by a terminal, and none is too much for an encoding.  A pipe that nobody reads any more, and
a device that is full, end the program without a word too many."""

import codecs
import contextlib
import os
import re
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from datetime import datetime
from io import TextIOWrapper
from pathlib import Path
from typing import Any, TextIO

from calc.sheet.errors import BadTable
from calc.sheet.in_ascii import in_ascii
from calc.sheet.version import VERSION
from calc.sheet.visible import visible

from .colour import Paint, paint_for

REPLACED = "contralbero.replaced"  # how an encoding treats a sign that it does not have


def _replaced(error: UnicodeError) -> tuple[str, int]:
    """A number keeps its sign and a unit its prefix; for anything else stands a question mark."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    try:
        signs = error.object[error.start : error.end]
        return "".join("*" if sign == "·" else in_ascii(sign) for sign in signs), error.end
    except UnicodeEncodeError:
        return "?", error.end


class Unwritable(Exception):
    """What stdout leads to takes no more: a full device, or a pipe that nobody reads."""

    def __init__(self, error: OSError) -> None:
        self.closed = isinstance(error, BrokenPipeError)
        super().__init__(error.strerror or str(error))


class Outlet:
    """A stream whose text is visible as it is written; all else is the stream's own.  `quiet`: it need not be
    written; `paint`: colours what is visible already."""

    def __init__(self, stream: TextIO, *, quiet: bool = False, paint: Paint | None = None) -> None:
        self.stream, self.quiet, self.paint = stream, quiet, paint

    def write(self, text: str) -> int:
        shown = visible(text, lines=True)
        self._try(lambda: self.stream.write(self.paint(shown) if self.paint is not None else shown))
        return len(text)

    def writelines(self, lines: Iterable[str]) -> None:
        for line in lines:
            self.write(line)

    def write_bytes(self, data: bytes) -> None:
        """What is no text, as it is."""
        self.flush()
        self._try(lambda: self.stream.buffer.write(data))

    def flush(self) -> None:
        self._try(self.stream.flush)

    def _try(self, way: Callable[[], object]) -> None:
        try:
            way()
        except OSError as error:
            _to_nowhere(self.stream)
            if not self.quiet:
                raise Unwritable(error) from None

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


@contextlib.contextmanager
def outlets() -> Iterator[None]:
    """stdout and stderr as outlets."""
    codecs.register_error(REPLACED, _replaced)
    # one may be closed
    out, err = (stream or open(os.devnull, "w", encoding="utf-8") for stream in (sys.stdout, sys.stderr))
    for stream in (out, err):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors=REPLACED)
    with (
        contextlib.redirect_stdout(Outlet(out, paint=paint_for(out))),
        contextlib.redirect_stderr(Outlet(err, quiet=True)),
    ):
        yield


def bare() -> TextIO:
    """stdout itself, for what a terminal shall obey."""
    return getattr(sys.stdout, "stream", sys.stdout)


def _to_nowhere(stream: TextIO) -> None:
    """What it holds back would be written once more as the program ends, and fail once more."""
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)


# --- a fault of the program itself
# One line, where its trace is kept, and an exit code that is no verdict.

CODE = 70
KEPT = 20  # traces; older ones go
TRACE = re.compile(r"(?:contralbero-)?fault-\d{8}-\d{6}-\w+\.txt")  # of this version, and of those before
FOLDER = "contralbero"


def told(error: BaseException) -> int:
    """Say it on stderr; gives the exit code."""
    if isinstance(error, BadTable):  # the table that the user has changed
        print(error, file=sys.stderr)
        return 2
    what = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    trace = kept(error)
    where = f"its trace is in {trace}" if trace is not None else "its trace could not be kept"
    print(
        f"contralbero: a fault of the program itself, no verdict: {' '.join(what.split())[:300]}; {where}",
        file=sys.stderr,
    )
    return CODE


def kept(error: BaseException) -> Path | None:
    """The file with the trace: in the user's state folder, else in the one for temporary files, which is everybody's.
    Its name is nobody's guess, so that no link waits there."""
    now = datetime.now()
    words = (
        f"contralbero {VERSION}, Python {sys.version}, {now.isoformat(timespec='seconds')}\n{' '.join(sys.argv)}\n\n"
    )
    text = visible(words + "".join(traceback.format_exception(error)), lines=True).encode()
    with suppress(OSError, ValueError, RuntimeError):  # no home is known
        folder = state_dir() / "faults"
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        path = _put(text, now, folder)
        _sweep(folder)
        return path
    with suppress(OSError, ValueError):
        return _put(text, now, Path(tempfile.gettempdir()))
    return None


def _put(text: bytes, now: datetime, folder: Path) -> Path:
    handle, path = tempfile.mkstemp(".txt", f"contralbero-fault-{now:%Y%m%d-%H%M%S}-", folder)
    with open(handle, "wb") as file:
        file.write(text)
    return Path(path)


def _sweep(folder: Path) -> None:
    """Leave the last traces of a folder that is ours, and all that is no trace."""
    if folder.is_symlink() or (hasattr(os, "getuid") and folder.stat().st_uid != os.getuid()):
        return
    traces = [path for path in folder.iterdir() if TRACE.fullmatch(path.name)]
    for old in sorted(traces, key=lambda path: path.name.partition("fault-")[2])[:-KEPT]:
        with suppress(OSError):
            old.unlink()


def state_dir() -> Path:
    """The user's folder for the state of programs, and ours in it; nothing is made before something is written."""
    if given := os.environ.get("XDG_STATE_HOME"):
        base = Path(given)
    elif os.name == "nt":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    else:
        base = Path.home() / ".local" / "state"
    return base / FOLDER
