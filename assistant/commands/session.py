# SPDX-License-Identifier: Apache-2.0
"""`contralbero [FILE]` and `contralbero serve`: the guided session, in the terminal or in a browser on this machine.

In a browser each tab is a session of its own."""

import os
import socket
import sys
from argparse import Namespace
from pathlib import Path

from assistant.extras import demand
from calc.design.limits import HOST
from calc.design.toml_file import design, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text


def run_serve(asked: Namespace) -> int:
    demand("serve", "textual_serve", "serve")
    from ..server import Local

    path = None
    if asked.file is not None:
        design(read(asked.file))  # a design with mistakes is an error here, not an empty page
        path = Path(asked.file).absolute()
    probe(asked.port)
    os.environ["PYTHONIOENCODING"] = "utf-8"  # of the sessions: a browser shows every sign
    try:
        Local(command(path), asked.port).serve()
    except OSError as error:  # somebody else was quicker
        raise _port(asked.port, Text("can not be used: {reason}", reason=error.strerror or str(error))) from None
    return 0


def command(path: Path | None) -> list[str]:
    """The words of the command of one session, by this very interpreter."""
    return [sys.executable, "-m", "assistant", "session", *([str(path)] if path is not None else [])]


def probe(port: int) -> None:
    """Whether the port can be had.  Raises BadInput."""
    if not 1 <= port <= 65535:
        raise _port(port, Text("is out of range; a port is a whole number from 1 to 65535"))
    with socket.socket() as trial:
        if os.name == "posix":  # elsewhere it would allow a port that is taken
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            trial.bind((HOST, port))
        except PermissionError:
            raise _port(port, Text("is kept for the administrator; give one from 1024 to 65535")) from None
        except OSError:
            raise _port(port, Text("is taken by another program; give another one with --port")) from None


def _port(port: int, reason: Text) -> BadInput:
    return BadInput("serve", [InputError(0, "--port", str(port), reason)])


# --- contralbero [FILE]: the guided session
# Without a file, and for one that is not there, its start page.


def run_session(asked: Namespace) -> int:
    path = _named(asked.file) if asked.file else None
    if path is not None and not (_missing(path) and os.path.isdir(path.parent)):
        read(path)  # a file that can not be read is an error here, not an empty screen
    served = "TEXTUAL_DRIVER" in os.environ  # in a browser: the terminal is at the other end of the pipes
    # one may be closed
    if not served and not all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout)):
        _refuse(path)
        return 2
    from assistant.app import run as open_session

    return int(open_session(path, ascii=asked.ascii, lang=asked.lang))


def _named(file: str) -> Path:
    """The file that is meant: a name without an ending, of which there is none, is one of a design."""
    path = Path(os.path.expanduser(file))
    return path.with_name(f"{path.name}.toml") if path.name and not path.suffix and _missing(path) else path


def _missing(path: Path) -> bool:
    """Whether a file of this name could be made here."""
    try:
        os.stat(path)
    except FileNotFoundError:
        return True
    except (OSError, ValueError):  # a name that the system does not know
        pass
    return False


def _refuse(path: Path | None) -> None:
    hint = "`contralbero --help` lists the commands"
    if path is not None and _missing(path):
        print(f"contralbero: {path}: is not there; `contralbero new {path.name}` begins a design", file=sys.stderr)
    else:
        print(f"contralbero: the guided session needs a terminal; {hint}", file=sys.stderr)
