# SPDX-License-Identifier: Apache-2.0
"""`python -m assistant`, which is `contralbero`: the command line, with Ctrl-C quiet from the first import to the last
line."""

import os
import signal
import sys


def press_again(lost: "sys.UnraisableHookArgs") -> None:
    """Ctrl-C that comes where Python can not raise it (a callback of its own import locks) is pressed again a moment
    later; anything else that can not be raised is told as ever."""
    if lost.exc_type is not KeyboardInterrupt:
        sys.__unraisablehook__(lost)
        return
    import _thread
    import threading

    timer = threading.Timer(0.01, _thread.interrupt_main)
    timer.daemon = True
    timer.start()


def main() -> int:
    sys.unraisablehook = press_again
    try:
        from .cli import main as command_line

        return command_line()
    except KeyboardInterrupt:
        return 130
    except Exception as error:  # so little memory that not even the fault could be told, or a module not be loaded
        os.write(2, b"contralbero: a fault of the program itself, no verdict: %s\n" % type(error).__name__.encode())
        return 70
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # what is left is Python's own end, which would show a trace


if __name__ == "__main__":
    from contralbero import main as checked  # that the other packages are its own, else it says what stands in the way

    sys.exit(checked())
