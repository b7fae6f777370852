# SPDX-License-Identifier: Apache-2.0
"""One number of many designs at once: `Lanes` stands where a formula, or a whole step, has a float.

In order: the lanes, the functions of numpy that take them, records of many designs as one record.

A lane is a design.  Arithmetic and numpy's functions work lane by lane; an array that a design has (the points of a
path, the corners of its tolerances) is an array in every lane, and a plain array is the same in all.  So a step that is
written for one design solves many, in one pass through its code, and a lane never sees another.

What decides about the way through the code has to be one thing in all lanes: where a condition, or a number that
counts, differs, `Diverged` is raised with the lanes that go one way, and who called solves the two parts each for
itself (`calc/studies/sweep/run.py`).  What lanes can not do (become one float where they differ, a key of a dict, a
plain array) is an error, never a mixture of designs."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import is_dataclass
from functools import wraps
from typing import Any, NoReturn, ParamSpec, TypeVar, cast

import numpy as np

from .arrays import Array, BoolArray
from .deferred import Later
from .errors import NoSolution
from .reuse import alike
from .text import EMPTY, Text

# by the function of numpy, or its name where importing it would cost a start-up time
HANDLED: dict[object, Callable[..., Any]] = {}


class Diverged(Exception):
    """The lanes do not go one way.  `some`: those that go the first of them, neither none nor all."""

    def __init__(self, some: BoolArray) -> None:
        super().__init__("the designs do not go one way")
        self.some = some


class Lanes:
    """`data`: an array whose first axis runs over the lanes; `shape`, `ndim` and `size` are those of what one lane
    has."""

    __slots__ = ("data",)
    __hash__ = None  # type: ignore[assignment]  # no key of a cache: it is equal to nothing once and for all

    def __init__(self, data: Any) -> None:
        self.data = data

    # --- what one lane has

    @property
    def shape(self) -> tuple[int, ...]:
        return cast("tuple[int, ...]", self.data.shape[1:])

    @property
    def ndim(self) -> int:
        return int(self.data.ndim) - 1

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    @property
    def lanes(self) -> int:
        return len(self.data)

    @property
    def dtype(self) -> Any:
        return self.data.dtype

    @property
    def real(self) -> Lanes:
        return Lanes(self.data.real)

    @property
    def imag(self) -> Lanes:
        return Lanes(self.data.imag)

    def conjugate(self) -> Lanes:
        return Lanes(self.data.conjugate())

    def item(self) -> Lanes:
        return Lanes(self.data.reshape(len(self.data)))

    def __len__(self) -> int:
        if not self.ndim:
            raise TypeError("a number has no length")
        return int(self.data.shape[1])

    def __iter__(self) -> Iterator[Lanes]:
        return (self[n] for n in range(len(self)))

    def __getitem__(self, at: Any) -> Lanes:
        if isinstance(at, Lanes):
            return at.of(self)
        if isinstance(at, tuple) and len(at) == 2 and at[0] is Ellipsis and isinstance(at[1], Lanes):
            return at[1].of(self)
        return Lanes(self.data[(slice(None), *(at if isinstance(at, tuple) else (at,)))])

    def of(self, x: Any) -> Lanes:
        """The elements of an array, along its last axis, at these places: of each lane those of its own."""
        data = x.data if type(x) is Lanes else np.broadcast_to(x, (self.lanes, *np.shape(x)))
        places = self.data if self.ndim else self.data[:, None]
        taken = np.take_along_axis(data, places.reshape(self.lanes, *(1,) * (data.ndim - 2), -1), -1)
        return Lanes(taken if self.ndim else taken[..., 0])

    def ravel(self) -> Lanes:
        return Lanes(self.data.reshape(len(self.data), -1))

    def reshape(self, *shape: Any) -> Lanes:
        return Lanes(
            self.data.reshape(len(self.data), *(shape[0] if len(shape) == 1 and isinstance(shape[0], tuple) else shape))
        )

    def any(self, axis: Any = None) -> Lanes:
        return cast(Lanes, np.any(self, axis))

    def all(self, axis: Any = None) -> Lanes:
        return cast(Lanes, np.all(self, axis))

    def sum(self, axis: Any = None) -> Lanes:
        return cast(Lanes, np.sum(self, axis))

    def min(self, axis: Any = None) -> Lanes:
        return cast(Lanes, np.min(self, axis))

    def max(self, axis: Any = None) -> Lanes:
        return cast(Lanes, np.max(self, axis))

    def argmin(self) -> Lanes:
        return cast(Lanes, np.argmin(self))

    def argmax(self) -> Lanes:
        return cast(Lanes, np.argmax(self))

    def tolist(self) -> Any:
        """The elements of what each lane has."""
        return [element.tolist() for element in self] if self.ndim else self

    # --- one way for all

    def __bool__(self) -> bool:
        return bool(self._alike(self.data != 0))

    def __index__(self) -> int:
        if self.data.dtype.kind not in "iub":
            raise TypeError("what is no whole number counts nothing")
        return int(self._alike(self.data))

    def __int__(self) -> int:
        return int(self._alike(self.data.astype(int)))

    def __float__(self) -> float:
        first = self.data.reshape(-1)[0]
        if not (self.data == first).all() or np.iscomplexobj(self.data):
            raise TypeError("the numbers of many designs are not one number")
        return float(first)

    def _alike(self, values: Any) -> Any:
        if values.ndim != 1:
            raise TypeError("an array has no one truth")
        same = values == values[0]
        if not same.all():
            raise Diverged(same)
        return values[0]

    def __array__(self, *args: Any, **kwargs: Any) -> Array:
        raise TypeError("the numbers of many designs are no plain array")

    def __format__(self, form: str) -> str:
        return "…"

    __str__ = __repr__ = lambda self: "…"

    # --- arithmetic

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        if method == "reduce":
            return reduced(ufunc.reduce, *inputs, **{"axis": 0, **kwargs})
        if method != "__call__" or ufunc.signature is not None or kwargs.get("out") is not None:
            return NotImplemented
        return wrapped(ufunc(*level(inputs), **kwargs))

    def __array_function__(self, function: Any, types: Any, args: Any, kwargs: Any) -> Any:
        handler = HANDLED.get(function) or HANDLED.get(function.__name__)
        return NotImplemented if handler is None else handler(*args, **kwargs)

    def __neg__(self) -> Lanes:
        return Lanes(-self.data)

    def __pos__(self) -> Lanes:
        return self

    def __abs__(self) -> Lanes:
        return Lanes(abs(self.data))

    def __round__(self, digits: int = 0) -> Lanes:
        return Lanes(np.round(self.data, digits))

    def __ceil__(self) -> Lanes:
        return Lanes(np.ceil(self.data))

    def __floor__(self) -> Lanes:
        return Lanes(np.floor(self.data))

    def __invert__(self) -> Lanes:
        return Lanes(~self.data)


def _operator(name: str) -> None:
    """An operator of arrays as one of lanes, from the left and from the right."""
    of_arrays = getattr(np.ndarray, f"__{name}__")
    of_arrays_right = getattr(np.ndarray, f"__r{name}__", None)

    def left(self: Lanes, other: Any) -> Any:
        kind = type(other)
        if kind is float or kind is int:
            return Lanes(of_arrays(self.data, other))
        one, two = level((self, other))
        return wrapped(of_arrays(one, np.asarray(two)))

    setattr(Lanes, f"__{name}__", left)
    if of_arrays_right is not None:

        def right(self: Lanes, other: Any) -> Any:
            one, two = level((self, other))
            return wrapped(of_arrays(np.asarray(two), one))

        setattr(Lanes, f"__r{name}__", right)


for _name in (
    "add",
    "sub",
    "mul",
    "truediv",
    "floordiv",
    "mod",
    "pow",
    "and",
    "or",
    "xor",
    "lt",
    "le",
    "gt",
    "ge",
    "eq",
    "ne",
):
    _operator(_name)


def wrapped(value: Any) -> Any:
    return tuple(map(Lanes, value)) if isinstance(value, tuple) else Lanes(value)


def level(inputs: Sequence[Any]) -> list[Any]:
    """The data of lanes and plain arrays side by side, so that numpy lets lane meet lane and point meet point."""
    inputs = [stacked(x) if isinstance(x, (list, tuple)) else x for x in inputs]
    deepest = max([x.data.ndim - 1 if type(x) is Lanes else getattr(x, "ndim", 0) for x in inputs])
    return [deep(x.data, deepest) if type(x) is Lanes else x for x in inputs]


def deep(data: Any, points: int) -> Any:
    """With so many axes of points, those that a lane does not have of length one."""
    missing = points + 1 - data.ndim
    return data.reshape(data.shape[0], *(1,) * missing, *data.shape[1:]) if missing else data


def scattered(there: BoolArray, chosen: Any, other: Any) -> Lanes:
    """An array of the elements of `one` where `there` is true, and those of `other` elsewhere."""
    count = count_of((chosen, other)) or 1
    parts = [
        rows(x, count, (size,)).reshape(count, size)
        for x, size in ((chosen, int(there.sum())), (other, int((~there).sum())))
    ]
    data = np.empty((count, there.size), dtype=np.result_type(*parts))
    data[:, there], data[:, ~there] = parts
    return Lanes(data)


def rows(x: Any, count: int, shape: tuple[int, ...]) -> Array:
    """What a number or an array is in every lane and at every point of a shape, one lane after the other as one flat
    array."""
    data = deep(x.data if type(x) is Lanes else np.asarray(x)[None], len(shape))
    return np.broadcast_to(data, (count, *shape)).ravel()


def count_of(things: Any) -> int | None:
    """How many lanes numbers have; None where none of them has lanes."""
    return next((len(x.data) for x in things if type(x) is Lanes), None)


def stacked(parts: Any) -> Any:
    """Numbers, some of them of many designs, as one array along a new first axis: what `np.array` makes of floats."""
    return np.array(parts) if count_of(parts) is None else Lanes(np.stack(with_all_lanes(parts), axis=1))


def with_all_lanes(parts: Sequence[Any]) -> list[Any]:
    """Arrays and numbers, some of them of many designs, each with all lanes."""
    count = count_of(parts) or 1
    return [part.data if type(part) is Lanes else np.broadcast_to(part, (count, *np.shape(part))) for part in parts]


def parted(x: Any) -> Any:
    """The same numbers, where all of them are there; designs without one (nan) go apart.  Raises NoSolution where none
    is."""
    missing = np.isnan(x.data).reshape(len(x.data), -1).any(1)
    if missing.all():
        raise NoSolution(EMPTY, EMPTY, EMPTY)  # each alone says why
    if missing.any():
        raise Diverged(~missing)
    return x


def axis_of(x: Lanes, axis: Any) -> Any:
    """An axis of the points as one of the data."""
    if axis is None:
        return tuple(range(1, x.data.ndim))
    if isinstance(axis, tuple):
        return tuple(axis_of(x, a) for a in axis)
    if not -x.ndim <= axis < x.ndim:
        raise TypeError(f"there is no axis {axis} of points")
    return axis if axis < 0 else axis + 1


def reduced(reduce: Any, x: Any, axis: Any = None, **kwargs: Any) -> Any:
    kwargs = {name: value for name, value in kwargs.items() if value is not None and value is not np._NoValue}
    if type(x) is not Lanes:
        x = stacked(x)
    return Lanes(reduce(x.data, axis=axis_of(x, axis), **kwargs))


# --- the functions of numpy that take lanes: each works lane by lane, on the points that a lane has
# One that does not stand here refuses lanes, which is an error and then another way (below).


def _handles(function: Any) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    def put(handler: Callable[..., Any]) -> Callable[..., Any]:
        HANDLED[function] = handler
        return handler

    return put


def _alone(x: Lanes) -> Lanes:
    """An array of one axis, for what numpy does with several is another thing."""
    if x.ndim != 1:
        raise TypeError("needs points along one axis")
    return x


for _function in (np.sum, np.max, np.min, np.any, np.all, np.mean, np.argmin, np.argmax, np.nanargmin):

    def _reducing(x: Any, axis: Any = None, _function: Any = _function, **kwargs: Any) -> Any:
        if _function in (np.argmin, np.argmax, np.nanargmin) and axis is None:
            x, axis = _alone(x), -1
        return reduced(_function, x, axis, **kwargs)

    HANDLED[_function] = _reducing


@_handles(np.diff)
def _diff(x: Lanes) -> Lanes:
    return Lanes(np.diff(_alone(x).data))


@_handles(np.where)
def _where(condition: Any, x: Any, y: Any) -> Any:
    return wrapped(np.where(*level((condition, x, y))))


@_handles(np.clip)
def _clip(x: Any, low: Any, high: Any) -> Any:
    return wrapped(np.clip(*level((x, low, high))))


@_handles(np.stack)
def _stack(parts: Sequence[Any], axis: int = 0) -> Lanes:
    return Lanes(np.stack(with_all_lanes(parts), axis=axis if axis < 0 else axis + 1))


@_handles(np.interp)
def _interp(x: Any, places: Any, numbers: Any) -> Lanes:
    """Places that are the same in all lanes."""
    return Lanes(np.stack([np.interp(x, places, row) for row in numbers.data]))


@_handles("rfft")
def _rfft(x: Any, n: int | None = None, axis: int = -1) -> Lanes:
    return Lanes(np.fft.rfft(x.data, n, axis=axis_of(x, axis)))


@_handles("irfft")
def _irfft(x: Any, n: int | None = None, axis: int = -1) -> Lanes:
    return Lanes(np.fft.irfft(x.data, n, axis=axis_of(x, axis)))


@_handles(np.append)
def _append(x: Any, more: Any) -> Any:
    return _concatenate([x, np.reshape(more, -1) if type(more) is not Lanes else more.ravel()])


@_handles(np.tile)
def _tile(x: Any, times: int) -> Any:
    return _concatenate([_alone(x)] * times)


@_handles(np.linspace)
def _linspace(low: Any, high: Any, count: int) -> Any:
    return low + (high - low) * (np.arange(count) / (count - 1))


@_handles(np.zeros_like)
def _zeros_like(x: Any) -> Any:
    return Lanes(np.zeros_like(x.data))


@_handles(np.ones_like)
def _ones_like(x: Any) -> Any:
    return Lanes(np.ones_like(x.data))


@_handles(np.shape)
def _shape(x: Lanes) -> tuple[int, ...]:
    return x.shape


@_handles(np.ndim)
def _ndim(x: Lanes) -> int:
    return x.ndim


@_handles(np.size)
def _size(x: Lanes) -> int:
    return x.size


@_handles(np.iscomplexobj)
def _iscomplexobj(x: Lanes) -> bool:
    return np.iscomplexobj(x.data)


@_handles(np.concatenate)
def _concatenate(parts: Sequence[Any], axis: int = 0) -> Lanes:
    parts = [stacked(part) if isinstance(part, (list, tuple)) else part for part in parts]
    return Lanes(np.concatenate(with_all_lanes(parts), axis=axis if axis < 0 else axis + 1))


@_handles(np.broadcast_to)
def _broadcast_to(x: Lanes, shape: Any) -> Lanes:
    shape = shape if isinstance(shape, tuple) else (shape,)
    return Lanes(np.broadcast_to(deep(x.data, len(shape)), (len(x.data), *shape)))


@_handles(np.array_equal)
def _array_equal(a: Any, b: Any) -> bool:
    return bool(np.array_equal(*level((a, b))))


# --- records of many designs as one record whose numbers are lanes, and back
#
# What is the same in all designs stays as it is.  Numbers that differ become lanes; anything else that differs (a
# count, a choice, a part that only some have) makes the designs go apart: `Diverged`.  Words may differ, since nobody
# reads them: those of the first stand.  What is made when it is asked for can not be asked.

T = TypeVar("T")
R = TypeVar("R")
P = ParamSpec("P")
REAL = (float, int)
NUMBERS = (complex, *REAL)
WORDS = ("advice", "remedies")  # of a check, which nobody reads
Calls = list[tuple[tuple[Any, ...], Any]]  # arguments, and what came of them


def abreast(designs: Sequence[T]) -> T:
    """One record of many of a kind."""
    merged: T = _merged(list(designs))
    return merged


def _merged(xs: list[Any]) -> Any:
    first = xs[0]
    if all(x is first for x in xs):
        return first
    if isinstance(first, (float, complex)):
        return _merged_numbers(first, xs)
    if isinstance(first, Text):
        _apart([isinstance(x, Text) and bool(x) == bool(first) for x in xs])
        return first
    if callable(first) and not is_dataclass(first):
        _apart([callable(x) for x in xs])
        return _of_one_alone
    _of_one_type(first, xs)
    if type(first) is Later:
        return Later(_of_one_alone)
    if type(first) is Lanes:
        raise TypeError("lanes of lanes")
    if isinstance(first, np.ndarray):
        return _merged_arrays(first, xs)
    if isinstance(first, (dict, tuple, list)):
        return _merged_parts(first, xs)
    if isinstance(first, (str, int)) or not hasattr(first, "__dict__"):
        _apart([x == first for x in xs])
        return first
    return _merged_records(first, xs)


def _of_one_type(first: Any, xs: list[Any]) -> None:
    """Words of any class stand beside each other."""
    kind = type(first)
    _apart([type(x) is kind or (isinstance(x, str) and isinstance(first, str)) for x in xs])


def _merged_numbers(first: float | complex, xs: list[Any]) -> Any:
    """Floats beside integers, or phasors beside real numbers; nothing else beside either."""
    real = isinstance(first, float)
    if not all(isinstance(x, REAL if real else NUMBERS) for x in xs):
        _of_one_type(first, xs)
    numbers = np.array(xs, dtype=float if real else complex)
    same = (numbers == numbers[0]).all() or (real and np.isnan(numbers).all())
    return first if same else Lanes(numbers)


def _merged_arrays(first: Any, xs: list[Any]) -> Any:
    _apart([x.shape == first.shape and x.dtype == first.dtype for x in xs])
    if all(np.array_equal(x, first, equal_nan=first.dtype.kind in "fc") for x in xs):
        return first
    return Lanes(np.stack(xs))


def _merged_parts(first: Any, xs: list[Any]) -> Any:
    if isinstance(first, dict):
        _apart([x.keys() == first.keys() for x in xs])
        return {key: _merged([x[key] for x in xs]) for key in first}
    _apart([len(x) == len(first) for x in xs])
    return _like(first, [_merged(list(parts)) for parts in zip(*xs)])


def _merged_records(first: Any, xs: list[Any]) -> Any:
    return _made(
        type(first),
        {
            name: first.__dict__[name] if name in WORDS else _merged([x.__dict__[name] for x in xs])
            for name in _fields(first)
        },
    )


def _of_one_alone(*_: object, **__: object) -> NoReturn:
    """In place of what a design makes of its own numbers when it is asked, a figure or a sentence: many are not
    asked."""
    raise TypeError("the designs have one each")


def lane(x: T, k: int) -> T:
    """The record of one of the designs: plain numbers again."""
    record: T = mapped(x, lambda lanes: _plain(lanes.data[k]))
    return record


class Singly:
    """What was found design by design in a pass: of every lane the calls of each function, with what they were given
    and what they gave."""

    def __init__(self, found: Sequence[Mapping[str, Calls]]) -> None:
        self.found = [dict(of_lane) for of_lane in found]

    def result(self, k: int, function: Callable[..., Any], given: tuple[Any, ...]) -> Any:
        """What a function gives one of the designs, or the exception that says why it gives nothing; known where it was
        asked before."""
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

    def some(self, which: Any) -> Singly:
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
    """A function that asks too much of its numbers (an order of places, a search) for lanes: it is called for each
    design."""

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> R:
        if (singly := running.get()) is None or not (count := _lanes_of((args, kwargs))):
            return function(*args, **kwargs)
        results = [singly.result(k, function, lane((args, kwargs), k)) for k in range(count)]
        kinds = [type(result) if isinstance(result, Exception) else None for result in results]
        _apart([kind is kinds[0] for kind in kinds])
        if isinstance(results[0], Exception):
            raise results[0]
        merged: R = abreast(results)
        return merged

    return called


def together_or_singly(function: Callable[P, R]) -> Callable[P, R]:
    """A function that takes the lanes of most of its numbers: where it fails with those of others, it is called for
    each design."""

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
    """A function whose arguments, by their places, may be arrays of points that have nothing to do with each other:
    lanes are more."""

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> R:
        if running.get() is None or not any([type(x) is Lanes for x in args]):
            return function(*args, **kwargs)
        result: R = mapped_arrays(function(*level(args), **kwargs), Lanes)
        return result

    return called


def _lanes_of(x: object) -> int:
    """How many lanes a record has; 0: none."""
    seen = [0]

    def count(lanes: Lanes) -> Lanes:
        seen[:] = [lanes.lanes]
        return lanes

    mapped(x, count)
    return seen[0]


def some_lanes(x: T, which: Any) -> T:
    """The record of some of the designs."""
    fewer: T = mapped(x, lambda lanes: Lanes(lanes.data[which]))
    return fewer


def _plain(value: Any) -> Any:
    return value.item() if value.ndim == 0 else value


def mapped(x: Any, change: Callable[[Lanes], Any]) -> Any:
    """A record with its lanes changed; what has none stays the very object."""
    kind = type(x)
    if kind is Lanes:
        return change(x)
    if kind in (float, int, str, bool, Text, Later) or x is None:
        return x
    if isinstance(x, dict):
        changed = {key: mapped(part, change) for key, part in x.items()}
        return x if all(changed[key] is part for key, part in x.items()) else changed
    if isinstance(x, (tuple, list)):
        parts = [mapped(part, change) for part in x]
        return x if all(a is b for a, b in zip(parts, x)) else _like(x, parts)
    if isinstance(x, type) or callable(x) or not hasattr(x, "__dict__"):
        return x
    names = _fields(x)
    attributes = {name: mapped(x.__dict__[name], change) for name in names}
    return x if all(attributes[name] is x.__dict__[name] for name in names) else _made(kind, attributes)


def _fields(x: Any) -> Sequence[str]:
    """What a record is made of, without what it has computed of itself."""
    fields = getattr(x, "__dataclass_fields__", None)
    return list(x.__dict__) if fields is None else list(fields)


def _made(kind: type, parts: dict[str, Any]) -> Any:
    record: Any = object.__new__(kind)
    record.__dict__.update(parts)
    return record


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
