# SPDX-License-Identifier: Apache-2.0
"""The command line: which command is asked for, and how the process ends.  Each command imports what it needs when it
runs.

Exit codes: 0 done · 1 a limit check fails, or a replay or a report differs · 2 bad input or usage · 3 no solution found
· 4 nothing fails, but not all that is asked holds (`check --strict`) · 70 a fault of the program itself · 130 ended by
Ctrl-C · 141 nobody reads the output any more."""

import gc
import os
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from importlib import import_module

from calc.sheet.errors import Mistakes

from .output import Unwritable, outlets, told
from .usage import COMMANDS, parser

# of numpy's algebra: starting a second takes a fifth of a check, and small matrices need none
THREADS = ("OPENBLAS_NUM_THREADS", "1")
# objects that are made before Python looks for those that hold each other alone, of which this program makes few: as
# often as by default is a tenth of a check
SELDOM = 20_000, 20, 100
ROOM = 160 * 2**20  # bytes of addresses that any command takes
CLOSED = 141  # as the system itself would end it: no verdict


def _meant(word: str | None) -> str | None:
    """The command that a word comes close to, which is none, and no file either."""
    if word is None or os.path.exists(word):
        return None
    return next(iter(get_close_matches(word, COMMANDS, 1)), None)


def _demand_room() -> None:
    """Raises MemoryError where the memory of the process is limited to too little: numpy's algebra would end it with 1,
    as a verdict does.  What that takes for itself it takes here, while there is room."""
    try:
        from mmap import mmap
        from resource import RLIM_INFINITY, RLIMIT_AS, getrlimit
    except ImportError:  # no such limit
        return
    if getrlimit(RLIMIT_AS)[0] == RLIM_INFINITY:
        return
    try:
        mmap(-1, ROOM).close()
    except OSError as error:
        raise MemoryError("less than it takes to begin") from error
    import numpy as np

    np.ones((64, 64)) @ np.ones((64, 64))


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; gives the exit code.  Without arguments it is that of this process, which ends with it."""
    with outlets():
        try:
            code = command(list(sys.argv[1:] if arguments is None else arguments), own=arguments is None)
            sys.stdout.flush()
            return code
        except Unwritable as full:
            if full.closed:
                return CLOSED
            print(f"contralbero: the output cannot be written: {full}", file=sys.stderr)
            return 2
        except Exception as error:
            if isinstance(error.__cause__, KeyboardInterrupt):  # it came while a class was being made
                raise error.__cause__ from None
            if arguments is not None:
                raise
            return told(error)


def command(given: list[str], own: bool) -> int:
    """The command that the words ask for.  `own`: the process is for it alone."""
    if own and "_ARGCOMPLETE" in os.environ:  # a shell asks what could come next
        from argcomplete import autocomplete

        autocomplete(parser())
    first = next((a for a in given if not a.startswith("-")), None)
    if not {"-h", "--help", "--version"} & set(given[:1]) and first not in COMMANDS:
        if (meant := _meant(first)) is not None:
            print(f"contralbero: {first}: is neither a command nor a file; did you mean {meant}?", file=sys.stderr)
            return 2
        given = ["session", *given]  # no command: the guided session
    try:
        asked, unknown = (parser(given[0]) if given[0] in COMMANDS else parser()).parse_known_args(given)
        if unknown:
            asked.refuse(unknown)  # with the usage of the command
        if own:
            os.environ.setdefault(*THREADS)
            gc.set_threshold(*SELDOM)
            _demand_room()
        module = import_module(f"assistant.commands.{COMMANDS[asked.command].module}")
        return int(getattr(module, f"run_{asked.command}")(asked))
    except SystemExit as usage:
        return int(usage.code or 0)
    except KeyboardInterrupt:
        return 130
    except Exception as error:
        if isinstance(error, Mistakes):
            print(error, file=sys.stderr)
            return 2
        raise
