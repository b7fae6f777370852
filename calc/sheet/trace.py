# SPDX-License-Identifier: Apache-2.0
"""The record of a calculation: which formula was called, with what, and what came out."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from .formula import Formula


class Line(NamedTuple):
    """One evaluation of a formula.  Screen, paper and JSON render this object and nothing else."""

    formula: "Formula[..., Any]"
    arguments: Mapping[str, Any]
    value: Any
    about: str = ""  # whose calculation this is: "front bearing", "mesh 36–39"


recorder: ContextVar[list[Line] | None] = ContextVar("recorder", default=None)
subject: ContextVar[str] = ContextVar("subject", default="")


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
def about(part: str) -> Iterator[None]:
    """Name the part whose lines follow: "front bearing", "mesh 36–39"."""
    token = subject.set(part)
    try:
        yield
    finally:
        subject.reset(token)
