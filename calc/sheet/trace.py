# SPDX-License-Identifier: Apache-2.0
"""The record of a calculation: which formula was called, with what, and what came out."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

from .text import EMPTY, Text

if TYPE_CHECKING:
    from .formula import Formula


class Line:
    """One evaluation of a formula, which nothing changes.  Screen, paper and JSON render this object and nothing else.

    `about`: whose calculation this is ("front bearing", "mesh 36–39").  A line is equal to no other, whatever that one gave.
    """

    __slots__ = ("about", "arguments", "formula", "value")

    def __init__(self, formula: "Formula[..., Any]", arguments: Mapping[str, Any], value: Any, about: Text = EMPTY) -> None:
        self.formula, self.arguments, self.value, self.about = formula, arguments, value, about


recorder: ContextVar[list[Line] | None] = ContextVar("recorder", default=None)
subject: ContextVar[Text] = ContextVar("subject", default=EMPTY)


@contextmanager
def trace() -> Iterator[list[Line]]:
    """Record every formula that is called inside."""
    lines: list[Line] = []
    token = recorder.set(lines)
    try:
        yield lines
    finally:
        recorder.reset(token)


@contextmanager
def untraced() -> Iterator[None]:
    """Iterations: nothing inside is recorded.  The converged call is made once more outside."""
    token = recorder.set(None)
    try:
        yield
    finally:
        recorder.reset(token)


@contextmanager
def about(part: Text) -> Iterator[None]:
    """Name the part whose lines follow: "front bearing", "mesh 36–39"."""
    token = subject.set(part)
    try:
        yield
    finally:
        subject.reset(token)
