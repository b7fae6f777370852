# SPDX-License-Identifier: Apache-2.0
"""`contralbero serve`: the guided session in a browser, on this machine only; each tab is a session of its own."""

import os
import socket
import sys
from argparse import Namespace
from pathlib import Path

from calc.design.toml_file import design, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text


def run(asked: Namespace) -> int:
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
    from ..server import HOST

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
