# SPDX-License-Identifier: Apache-2.0
"""Work that a copy of this process does meanwhile, where there is a core for it."""

import os
import pickle
import sys
import threading
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")


def aside(work: Callable[[], T]) -> Callable[[], T]:
    """Begin `work`; what is returned waits for its result, which has to be data that pickle knows.

    It gives what `work` gives, only sooner: where this process can not be copied (it has other threads, there is one core) or the copy
    comes to nothing, it is the work itself, done when it is asked for.
    """
    if sys.platform != "linux" or threading.active_count() > 1 or len(os.sched_getaffinity(0)) < 2:
        return work
    reading, writing = os.pipe()
    if not (copy := os.fork()):
        try:
            with open(writing, "wb") as file:
                pickle.dump(work(), file)
        finally:
            os._exit(0)  # nothing of what this process does at its end is the copy's to do
    os.close(writing)
    answer = open(reading, "rb")  # closed when it is read, or with what is returned: then the copy ends too

    def result() -> T:
        with answer:
            data = answer.read()
        os.waitpid(copy, 0)
        try:
            found: T = pickle.loads(data)
        except (EOFError, pickle.UnpicklingError):
            return work()
        return found

    return result
