# SPDX-License-Identifier: Apache-2.0
"""What is made when somebody looks at it, and work that a copy of this process does meanwhile.

The first are figures, tables and words that stand beside the numbers of a step."""

import gc
import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cached_property, partial
from typing import Any, TypeVar, overload

from .errors import NoSolution
from .value import untraced

# --- work that a copy of this process does meanwhile, where there is a core for it

G = TypeVar("G")
T = TypeVar("T")
DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of prctl(2)


def aside(work: Callable[[], T]) -> Callable[[], T]:
    """Begin `work`; what is returned waits for its result, which has to be data that pickle knows.

    It gives what `work` gives, only sooner: where this process can not be copied (it has other threads, there is one
    core) or the copy comes to nothing, it is the work itself, done when it is asked for."""

    def ready() -> Callable[[None], T]:
        return lambda nothing: work()

    return prepared(ready)(None)


def prepared(ready: Callable[[], Callable[[G], T]]) -> Callable[[G], Callable[[], T]]:
    """A copy of this process that makes itself `ready` for work before it is known what the work is about.

    What is returned is to be called once.  It begins the work on what it is given, data that pickle knows too, and
    returns what waits for the result as `aside` does.  Whatever a copy is at, it ends with this process."""
    if sys.platform != "linux" or threading.active_count() > 1 or len(os.sched_getaffinity(0)) < 2:
        return lambda given: lambda: ready()(given)
    (orders, ordering), (reading, writing) = os.pipe(), os.pipe()
    here = os.getpid()
    if not (copy := os.fork()):
        try:
            os.close(ordering)  # what this process keeps: a copy that held it would wait for itself
            os.close(reading)
            if _ends_with(here):
                _serve(ready, orders, writing)
        finally:
            os._exit(0)  # nothing of what this process does at its end is the copy's to do
    os.close(orders)
    os.close(writing)
    order, answer = open(ordering, "wb"), open(reading, "rb")  # closed with what is returned: then the copy ends too

    def begin(given: G) -> Callable[[], T]:
        try:
            with order:
                order.write(pickle.dumps(given))
        except BrokenPipeError:
            pass  # the copy is lost, which its answer tells
        return partial(result, given)

    def result(given: G) -> T:
        with answer:
            data = answer.read()
        os.waitpid(copy, 0)
        try:
            loaded: T = pickle.loads(data)
        except (EOFError, pickle.UnpicklingError):
            return ready()(given)
        return loaded

    return begin


def _ends_with(process: int) -> bool:
    """Have the system end this process with the one that it is a copy of, however that ends; gives whether that is
    there still."""
    with suppress(ImportError, OSError, AttributeError):  # then it ends when its work is done
        import ctypes

        ctypes.CDLL(None).prctl(DEATH_SIGNAL, int(signal.SIGKILL))
    return os.getppid() == process


def _serve(ready: Callable[[], Callable[[Any], Any]], orders: int, writing: int) -> None:
    """What the copy does.  It shows nothing and keeps no outlet open that others wait for."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in {0, 1, 2} - {orders, writing}:
        os.dup2(nowhere, stream)
    gc.disable()  # it ends soon
    work = ready()
    with open(orders, "rb") as incoming, open(writing, "wb") as file:
        pickle.dump(work(pickle.load(incoming)), file)


# --- what is made when somebody looks at it


class Later(Sequence[T]):
    """A sequence that `make` gives at the first look.  What can not be made of the numbers (an overflow in a figure) is
    not there."""

    def __init__(self, make: Callable[[], Iterable[T]]) -> None:
        self._make = make

    @cached_property
    def made(self) -> tuple[T, ...]:
        import numpy as np  # which is there wherever something was solved

        try:
            with untraced(), np.errstate(all="ignore"):
                return tuple(self._make())
        except (NoSolution, ArithmeticError, ValueError):
            return ()

    def meanwhile(self) -> None:
        """Begin to make it in a copy of this process, where it is not made yet; whoever looks at it may have to
        wait."""
        if "made" not in vars(self):
            make = self._make
            self._make = aside(lambda: Later(make).made)

    def __iter__(self) -> Iterator[T]:
        return iter(self.made)

    def __len__(self) -> int:
        return len(self.made)

    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[T, ...]: ...
    def __getitem__(self, index: int | slice) -> T | tuple[T, ...]:
        return self.made[index]

    def __add__(self, more: "Many[T]") -> "Later[T]":
        return Later(lambda: (*self, *more))

    def __radd__(self, first: tuple[T, ...]) -> "Later[T]":
        return Later(lambda: (*first, *self))

    def __reduce__(self) -> tuple[object, ...]:
        return tuple, (self.made,)


Many = tuple[T, ...] | Later[T]  # what an outcome holds
