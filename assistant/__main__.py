# SPDX-License-Identifier: Apache-2.0
"""`contralbero`, and `python -m assistant`: the command line, with Ctrl-C quiet from the first import to the last
line."""

import signal
import sys


def main() -> int:
    try:
        from .cli import main as command_line

        return command_line()
    except KeyboardInterrupt:
        return 130
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # what is left is Python's own end, which would show a trace


if __name__ == "__main__":
    sys.exit(main())
