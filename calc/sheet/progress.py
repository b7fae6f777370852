# SPDX-License-Identifier: Apache-2.0
"""How a long search says how far it is.  Who listens may raise `Cancelled` from the call, which ends the search there
and then."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from .errors import Cancelled

Progress = Callable[[float, str], None]  # share done, from 0 to 1, and what is being looked at


# who waits for what this thread computes; inside long loops it is asked, without knowing how far they are
_waiting: ContextVar[Callable[[], object]] = ContextVar("waiting", default=bool)


@contextmanager
def waited_for(by: Callable[[], object]) -> Iterator[None]:
    """Inside, `by` is asked by `go_on`; it may raise `Cancelled`."""
    token = _waiting.set(by)
    try:
        yield
    finally:
        _waiting.reset(token)


def go_on() -> None:
    """Ask, in a loop that takes long, whether anybody still waits."""
    _waiting.get()()


def tell(progress: Progress | None, share: float, what: str) -> None:
    if progress is not None:
        progress(min(max(share, 0.0), 1.0), what)


def part(progress: Progress | None, start: float, end: float) -> Progress | None:
    """The progress of a part of the search, which goes from one share of the whole to another."""
    if progress is None:
        return None
    return lambda share, what: progress(start + (end - start) * share, what)


def at_most(seconds: float) -> Progress:
    """A progress that ends the search after so many seconds of computing, however busy the machine is with other
    things."""
    ends = time.process_time() + seconds

    def told(share: float, what: str) -> None:
        if time.process_time() > ends:
            raise Cancelled

    return told


def rising(progress: Progress | None) -> Progress | None:
    """The same, never falling back: where a search turns to what it has left aside, it stands until it is beyond what
    it was."""
    if progress is None:
        return None
    top = 0.0

    def told(share: float, what: str) -> None:
        nonlocal top
        top = max(top, share)
        progress(top, what)

    return told
