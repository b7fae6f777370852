# SPDX-License-Identifier: Apache-2.0
"""The record of a calculation: which formula was called, with what, and what came out."""

from collections.abc import Callable, Mapping
from contextvars import ContextVar
from typing import Any, Generic, Protocol, TypeVar

from .text import EMPTY, Text

T = TypeVar("T")


class Equation(Protocol):
    """What a line is an evaluation of: a formula (`formula.py`, which says what these are)."""

    __name__: str
    symbol: str
    unit: str
    governs: str
    names: dict[str, str]
    parameters: tuple[str, ...]

    @property
    def function(self) -> Callable[..., object]: ...
    @property
    def source(self) -> Text: ...
    @property
    def shows(self) -> Text: ...
    def __hash__(self) -> int: ...


class Line:
    """One evaluation of a formula, which nothing changes.  Screen, paper and JSON render this object and nothing else.

    `about`: whose calculation this is ("front bearing", "mesh 36–39").  A line is equal to no other, whatever that one gave.
    """

    __slots__ = ("about", "arguments", "formula", "value")

    def __init__(self, formula: Equation, arguments: Mapping[str, object], value: object, about: Text = EMPTY) -> None:
        self.formula, self.arguments, self.value, self.about = formula, arguments, value, about


recorder: ContextVar[list[Line] | None] = ContextVar("recorder", default=None)
recording: ContextVar[bool] = ContextVar("recording", default=True)
subject: ContextVar[Text] = ContextVar("subject", default=EMPTY)


class _Setting(Generic[T]):
    """`with` it a variable has another value.  Written as a class, since a solve enters some 500 of them."""

    __slots__ = ("_token", "value", "variable")

    def __init__(self, variable: ContextVar[Any], value: T) -> None:  # Any: the variable holds more types than this one value
        self.variable, self.value = variable, value

    def __enter__(self) -> T:
        self._token = self.variable.set(self.value)
        return self.value

    def __exit__(self, *error: object) -> None:
        self.variable.reset(self._token)


class _Trace:
    __slots__ = ("_token",)

    def __enter__(self) -> list[Line]:
        lines: list[Line] = []
        self._token = recorder.set(lines if recording.get() else None)
        return lines

    def __exit__(self, *error: object) -> None:
        recorder.reset(self._token)


def trace() -> _Trace:
    """Record every formula that is called inside; none where nobody wants lines (`recorded`)."""
    return _Trace()


def recorded(wanted: bool) -> _Setting[bool]:
    """Whether lines and links are wanted at all.  Without, a solve takes a fifth less, and gives the same numbers."""
    return _Setting(recording, wanted)


def untraced() -> _Setting[None]:
    """Iterations: nothing inside is recorded.  The converged call is made once more outside."""
    return _Setting(recorder, None)


def about(part: Text) -> _Setting[Text]:
    """Name the part whose lines follow: "front bearing", "mesh 36–39"."""
    return _Setting(subject, part)
