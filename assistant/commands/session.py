# SPDX-License-Identifier: Apache-2.0
"""`contralbero [FILE]`: the guided session; without a file, and for one that is not there, its start page."""

import os
import sys
from argparse import Namespace
from pathlib import Path

from calc.design.toml_file import read


def run(asked: Namespace) -> int:
    path = _named(asked.file) if asked.file else None
    if path is not None and (path.exists() or not path.parent.is_dir()):
        read(path)  # a file that can not be read is an error here, not an empty screen
    served = "TEXTUAL_DRIVER" in os.environ  # in a browser: the terminal is at the other end of the pipes
    if not served and not all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout)):  # one may be closed
        _refuse(path)
        return 2
    from assistant.app import run as open_session

    return int(open_session(path, ascii=asked.ascii, lang=asked.lang))


def _named(file: str) -> Path:
    """The file that is meant: a name without an ending, of which there is none, is one of a design."""
    path = Path(file).expanduser()
    return path if path.suffix or path.exists() else path.with_suffix(".toml")


def _refuse(path: Path | None) -> None:
    hint = "`contralbero --help` lists the commands"
    if path is not None and not path.exists():
        print(f"contralbero: {path}: is not there; `contralbero new {path.name}` begins a design", file=sys.stderr)
    else:
        print(f"contralbero: the guided session needs a terminal; {hint}", file=sys.stderr)
