# SPDX-License-Identifier: Apache-2.0
"""Numbered pieces of work over processes, or over the workers of a dask scheduler; what a lost worker had is done again
by another.

A piece keeps no state and gives the same wherever it runs; the pieces come back in any order.
"""

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, redirect_stderr
from importlib import import_module
from itertools import islice
from multiprocessing import get_context, resource_tracker
from multiprocessing.connection import Connection
from typing import Any, TypeVar

from ..sheet.errors import NoSolution
from ..sheet.extras import needs
from ..sheet.text import Text
from ..sheet.version import VERSION

A = TypeVar("A")
R = TypeVar("R")
LOSSES = 2  # of the workers that a piece may cost
MOMENT = 0.2  # s, from one pulse to the next
ANSWER = 10  # s, until which a scheduler must be there
AHEAD, ABROAD = 4, 1000  # pieces on their way: for each process, and to a scheduler, however many wait


def spread(
    work: Callable[[A], R],
    piece: Callable[[int], A],
    waiting: Sequence[int],
    processes: int = 1,
    scheduler: str = "",
    pulse: Callable[[], None] | None = None,
) -> Iterator[tuple[int, R]]:
    """`work(piece(n))` for every number that waits, begun in that order, each as it is done; `piece(n)` travels to the
    worker that has it.  `scheduler`: the address of a dask one.  `pulse` is called every moment while processes are
    waited for, and ends them by what it raises."""
    if scheduler:
        return _farmed(work, piece, waiting, scheduler)
    if processes <= 1 or len(waiting) <= 1:
        return ((n, work(piece(n))) for n in waiting)
    return _parallel(work, piece, waiting, processes, pulse)


def _parallel(
    work: Callable[[A], R],
    piece: Callable[[int], A],
    waiting: Sequence[int],
    processes: int,
    pulse: Callable[[], None] | None,
) -> Iterator[tuple[int, R]]:
    if sys.__stderr__ is not None:  # a screen's own has no file behind it: multiprocessing's tracker needs one
        with redirect_stderr(sys.__stderr__):
            resource_tracker.ensure_running()
    lost = dict.fromkeys(waiting, 0)
    left = set(waiting)
    while left:
        context = get_context("spawn")
        ending, held = context.Pipe(duplex=False)
        pool = ProcessPoolExecutor(min(processes, len(left)), context, _begin, (ending,))
        running: dict[Future[R], int] = {}
        coming = (n for n in waiting if n in left)
        try:
            while True:
                with _undisturbed():
                    running |= {
                        pool.submit(work, piece(n)): n for n in islice(coming, AHEAD * processes - len(running))
                    }
                if not running:
                    break
                finished, _ = wait(running, MOMENT if pulse is not None else None, FIRST_COMPLETED)
                if pulse is not None:
                    pulse()
                for future in finished:
                    result = future.result()
                    n = running.pop(future)  # its result need not be kept here
                    left.discard(n)
                    yield n, result
        except BrokenProcessPool:
            for n in left.intersection(running.values()) or left:
                lost[n] += 1
            if max(lost[n] for n in left) > LOSSES:
                raise
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
            held.close()


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Workers that are started in here are not told of Ctrl-C, from their first moment on."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin(ending: Connection) -> None:
    """In a new worker: Ctrl-C is for the program that started it; when that closes its end of the pipe, or ends in any
    other way, the worker ends too, in the middle of a piece."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(ending,), daemon=True).start()


def _end_with(ending: Connection) -> None:
    ending.poll(None)
    os.kill(os.getpid(), signal.SIGTERM)


def _farmed(
    work: Callable[[A], R], piece: Callable[[int], A], waiting: Sequence[int], address: str
) -> Iterator[tuple[int, R]]:
    """Results come back; no file need be shared."""
    try:
        dask: Any = import_module("distributed")
    except ImportError:
        raise NoSolution(Text("a scheduler {needs}", needs=needs("farm"))) from None
    try:
        client = dask.Client(address, timeout=ANSWER)
    except (OSError, ValueError) as error:
        none = Text("no scheduler answers at {address}", address=address)
        raise NoSolution(none, Text("{why}", why=str(error))) from None
    with client:
        coming = iter(waiting)

        def submitted(count: int) -> dict[Any, int]:
            return {
                client.submit(_abroad, VERSION, work, piece(n), retries=LOSSES, pure=False): n
                for n in islice(coming, count)
            }

        running = submitted(ABROAD)
        done = dask.as_completed(list(running))
        for future in done:
            try:
                result = future.result()
            except (CancelledError, dask.KilledWorker) as error:
                lost = Text("the scheduler at {address}, or too many of its workers, went away", address=address)
                why, then = str(error).split("\n")[0], Text("the same command goes on from what is done")
                raise NoSolution(lost, Text("{why}", why=why), then) from None
            except ImportError as error:
                missing = Text("a worker of the scheduler at {address} does not have this program", address=address)
                raise NoSolution(missing, Text("{why}", why=str(error))) from None
            n = running.pop(future)
            more = submitted(1)
            running |= more
            done.update(more)
            yield n, result


def _abroad(version: str, work: Callable[[A], R], piece: A) -> R:
    """On a worker, whose program may be another."""
    if version != VERSION:
        raise NoSolution(
            Text("a worker has version {theirs} of this program, not {ours}", theirs=VERSION, ours=version)
        )
    return work(piece)
