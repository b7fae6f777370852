"""Work for the tests of what is spread over processes, which find it by its name."""

import os
import time

from calc.studies import processes


def slow(seconds: float, n: int) -> tuple[int, int]:
    time.sleep(seconds)
    return n * n, os.getpid()


def endless_but_the_first(seconds: float, n: int) -> int:
    time.sleep(seconds if n else 0.0)
    return os.getpid()


def once(folder: str, n: int) -> int:
    """The first worker that has it is lost."""
    mark = os.path.join(folder, str(n))
    if n == 3 and not os.path.exists(mark):
        open(mark, "w").close()
        os._exit(1)
    return n


def of_another_version(n: int) -> int:
    return processes._abroad("0.0.1", abs, n)


def not_there(n: int) -> int:
    raise ModuleNotFoundError("No module named 'calc'")
