# SPDX-License-Identifier: Apache-2.0
"""`contralbero completion SHELL`: the script by which a shell completes commands, options and files."""

import sys
from argparse import Namespace

from assistant.cli import parser
from calc.sheet.text import Text


def run(asked: Namespace) -> int:
    try:
        import shtab
    except ImportError:
        print(Text("the script is written by shtab, which the extra `contralbero[completion]` installs"), file=sys.stderr)
        return 2
    print(shtab.complete(parser(), asked.shell))
    return 0
