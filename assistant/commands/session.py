# SPDX-License-Identifier: Apache-2.0
"""`contralbero [FILE]`: the guided session."""

import os
import sys
from argparse import Namespace
from pathlib import Path

from calc.design_file import read


def run(asked: Namespace) -> int:
    if asked.file is not None:
        read(asked.file)  # a file that can not be read is an error here, not an empty screen
    served = "TEXTUAL_DRIVER" in os.environ  # in a browser: the terminal is at the other end of the pipes
    if not served and not (sys.stdin.isatty() and sys.stdout.isatty()):
        print("contralbero: the guided session needs a terminal; `contralbero --help` lists the commands", file=sys.stderr)
        return 2
    from assistant.app import run as open_session

    return int(open_session(Path(asked.file) if asked.file else None, ascii=asked.ascii, lang=asked.lang))
