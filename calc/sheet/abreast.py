# SPDX-License-Identifier: Apache-2.0
"""Records of many designs as one record whose numbers are lanes, and back.

What is the same in all designs stays as it is.  Numbers that differ become lanes; anything else that differs (a count, a choice, a part
that only some have) makes the designs go apart: `Diverged`.  Words may differ, since nobody reads them: those of the first stand.  What
is made when it is asked for can not be asked.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import is_dataclass
from functools import wraps
from typing import Any, NoReturn, ParamSpec, TypeVar

import numpy as np

from . import lane_functions  # makes the functions of numpy known to lanes
from .errors import NoSolution
from .lanes import Diverged, Lanes, level
from .later import Later
from .parts import alike
from .text import Text

T = TypeVar("T")
R = TypeVar("R")
P = ParamSpec("P")
REAL = (float, int)
WORDS = ("advice", "remedies")  # of a check, which nobody reads
Found = list[tuple[tuple[Any, ...], Any]]  # arguments, and what came of them


def abreast(designs: Sequence[T]) -> T:
    """One record of many of a kind."""
    merged: T = _merged(list(designs))
    return merged


def _merged(xs: list[Any]) -> Any:
    first = xs[0]
    if all(x is first for x in xs):
        return first
    kind = type(first)
    if isinstance(first, float):
        if all(isinstance(x, REAL) for x in xs):
            numbers = np.array(xs, dtype=float)
            return first if (numbers == numbers[0]).all() or np.isnan(numbers).all() else Lanes(numbers)
    elif isinstance(first, complex):
        if all(isinstance(x, (complex, *REAL)) for x in xs):
            phasors = np.array(xs, dtype=complex)
            return first if (phasors == phasors[0]).all() else Lanes(phasors)
    if isinstance(first, Text):
        _apart([isinstance(x, Text) and bool(x) == bool(first) for x in xs])
        return first
    if callable(first) and not is_dataclass(first):
        _apart([callable(x) for x in xs])
        return _of_one_alone
    _apart([type(x) is kind or (isinstance(x, str) and isinstance(first, str)) for x in xs])
    if kind is Later:
        return Later(_of_one_alone)
    if kind is Lanes:
        raise TypeError("lanes of lanes")
    if isinstance(first, np.ndarray):
        _apart([x.shape == first.shape and x.dtype == first.dtype for x in xs])
        if all(np.array_equal(x, first, equal_nan=first.dtype.kind in "fc") for x in xs):
            return first
        return Lanes(np.stack(xs))
    if isinstance(first, (str, int, bool)) or first is None:
        _apart([x == first for x in xs])
        return first
    if isinstance(first, dict):
        _apart([x.keys() == first.keys() for x in xs])
        return {key: _merged([x[key] for x in xs]) for key in first}
    if isinstance(first, (tuple, list)):
        _apart([len(x) == len(first) for x in xs])
        return _like(first, [_merged(list(parts)) for parts in zip(*xs)])
    parts = vars(first) if hasattr(first, "__dict__") else None
    if parts is None:
        _apart([x == first for x in xs])
        return first
    names = _fields(first)
    return _made(kind, {name: first.__dict__[name] if name in WORDS else _merged([x.__dict__[name] for x in xs]) for name in names})


def _of_one_alone(*_: object, **__: object) -> NoReturn:
    """In place of what a design makes of its own numbers when it is asked, a figure or a sentence: many are not asked."""
    raise TypeError("the designs have one each")


def lane(x: T, k: int) -> T:
    """The record of one of the designs: plain numbers again."""
    one: T = mapped(x, lambda lanes: _plain(lanes.data[k]))
    return one


class Singly:
    """What was found design by design in a pass: of every lane the calls of each function, with what they were given and what they gave."""

    def __init__(self, found: Sequence[Mapping[str, Found]]) -> None:
        self.found = [dict(of_lane) for of_lane in found]

    def result(self, k: int, function: Callable[..., Any], given: tuple[Any, ...]) -> Any:
        """What a function gives one of the designs, or the exception that says why it gives nothing; known where it was asked before."""
        calls = self.found[k].setdefault(function.__qualname__, [])
        for before, result in calls:
            if alike(before, given):
                return result
        token = running.set(None)
        try:
            result = function(*given[0], **given[1])
        except (NoSolution, ArithmeticError, ValueError) as none:
            result = none
        finally:
            running.reset(token)
        calls.append((given, result))
        return result

    def some(self, which: Any) -> "Singly":
        """The same of some of the designs, which go the same way once more."""
        return Singly([of_lane for of_lane, there in zip(self.found, which) if there])


running: ContextVar[Singly | None] = ContextVar("running", default=None)  # while designs are solved abreast


@contextmanager
def designs_abreast(singly: Singly) -> Iterator[None]:
    """Inside, functions that are called with lanes may be called for each design; `singly`: what they gave before."""
    token = running.set(singly)
    try:
        yield
    finally:
        running.reset(token)


def design_by_design(function: Callable[P, R]) -> Callable[P, R]:
    """A function that asks too much of its numbers (an order of places, a search) for lanes: it is called for each design."""

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> R:
        if (singly := running.get()) is None or not (count := _lanes_of((args, kwargs))):
            return function(*args, **kwargs)
        found = [singly.result(k, function, lane((args, kwargs), k)) for k in range(count)]
        kinds = [type(one) if isinstance(one, Exception) else None for one in found]
        _apart([kind is kinds[0] for kind in kinds])
        if isinstance(found[0], Exception):
            raise found[0]
        merged: R = abreast(found)
        return merged

    return called


def together_or_singly(function: Callable[P, R]) -> Callable[P, R]:
    """A function that takes the lanes of most of its numbers: where it fails with those of others, it is called for each design."""

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> R:
        if running.get() is None:
            return function(*args, **kwargs)
        try:
            return function(*args, **kwargs)
        except NoSolution:
            raise
        except (TypeError, AttributeError, LookupError, ArithmeticError, ValueError):
            return design_by_design(function)(*args, **kwargs)

    return called


def point_by_point(function: Callable[P, R]) -> Callable[P, R]:
    """A function whose arguments, by their places, may be arrays of points that have nothing to do with each other: lanes are more."""

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> R:
        if running.get() is None or not any([type(x) is Lanes for x in args]):
            return function(*args, **kwargs)
        found: R = mapped_arrays(function(*level(args), **kwargs), Lanes)
        return found

    return called


def _lanes_of(x: object) -> int:
    """How many lanes a record has; 0: none."""
    found = [0]

    def count(lanes: Lanes) -> Lanes:
        found[:] = [lanes.lanes]
        return lanes

    mapped(x, count)
    return found[0]


def some_lanes(x: T, which: Any) -> T:
    """The record of some of the designs."""
    fewer: T = mapped(x, lambda lanes: Lanes(lanes.data[which]))
    return fewer


def _plain(found: Any) -> Any:
    return found.item() if found.ndim == 0 else found


def mapped(x: Any, change: Callable[[Lanes], Any]) -> Any:
    """A record with its lanes changed; what has none stays the very object."""
    kind = type(x)
    if kind is Lanes:
        return change(x)
    if kind in (float, int, str, bool, Text, Later) or x is None:
        return x
    if isinstance(x, dict):
        found = {key: mapped(part, change) for key, part in x.items()}
        return x if all(found[key] is part for key, part in x.items()) else found
    if isinstance(x, (tuple, list)):
        parts = [mapped(part, change) for part in x]
        return x if all(a is b for a, b in zip(parts, x)) else _like(x, parts)
    if isinstance(x, type) or callable(x) or not hasattr(x, "__dict__"):
        return x
    names = _fields(x)
    made = {name: mapped(x.__dict__[name], change) for name in names}
    return x if all(made[name] is x.__dict__[name] for name in names) else _made(kind, made)


def _fields(x: Any) -> Sequence[str]:
    """What a record is made of, without what it has computed of itself."""
    fields = getattr(x, "__dataclass_fields__", None)
    return list(x.__dict__) if fields is None else list(fields)


def _made(kind: type, parts: dict[str, Any]) -> Any:
    made: Any = object.__new__(kind)
    made.__dict__.update(parts)
    return made


def _like(x: Any, parts: list[Any]) -> Any:
    return type(x)(*parts) if hasattr(x, "_fields") else type(x)(parts)


def _apart(same: list[bool]) -> None:
    """The designs must be of one kind here."""
    if not all(same):
        raise Diverged(np.array(same))


def mapped_arrays(x: Any, change: Callable[[Any], Any]) -> Any:
    """A record of arrays with these changed."""
    if isinstance(x, np.ndarray):
        return change(x)
    if isinstance(x, tuple):
        return _like(x, [mapped_arrays(part, change) for part in x])
    if hasattr(x, "__dataclass_fields__") or getattr(x, "of_numbers", False):
        return _made(type(x), {name: mapped_arrays(x.__dict__[name], change) for name in _fields(x)})
    return x
