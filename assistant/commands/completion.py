# SPDX-License-Identifier: Apache-2.0
"""`contralbero completion SHELL`: the script by which a shell completes commands, options and files; it asks the program at each Tab."""

import sys
from argparse import Namespace

from calc.sheet.text import Text


def run(asked: Namespace) -> int:
    try:
        from argcomplete.shell_integration import shellcode
    except ImportError:
        print(Text("the script is that of argcomplete, which the extra `contralbero[completion]` installs"), file=sys.stderr)
        return 2
    print(shellcode(["contralbero"], shell=asked.shell))
    return 0
