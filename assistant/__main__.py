# SPDX-License-Identifier: Apache-2.0
"""`contralbero`, and `python -m assistant`: the command line, with Ctrl-C quiet from the first import to the last
line."""

import signal
import sys


def main() -> int:
    try:
        from .cli import main as command_line

        code = command_line()
    except KeyboardInterrupt:
        return 130
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # what is left is Python's own end, which would show a trace
    _end(code)
    return code


def _end(code: int) -> None:
    """End the process here, unless threads are to be waited for: Python would first take apart all it holds, a
    twentieth of a check."""
    import atexit
    import os

    threading = sys.modules.get("threading")  # where nothing needed it, there are no threads
    if threading is not None and threading.active_count() > 1:
        return
    atexit._run_exitfuncs()
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()  # None where it was closed
        except (AttributeError, OSError, ValueError):
            pass
    os._exit(code)


if __name__ == "__main__":
    sys.exit(main())
