# SPDX-License-Identifier: Apache-2.0
"""One number of many designs at once: `Lanes` stands where a formula, or a whole step, has a float.

A lane is a design.  Arithmetic and numpy's functions work lane by lane; an array that a design has (the points of a path, the corners of
its tolerances) is an array in every lane, and a plain array is the same in all.  So a step that is written for one design solves many,
in one pass through its code, and a lane never sees another.

What decides about the way through the code has to be one thing in all lanes: where a condition, or a number that counts, differs,
`Diverged` is raised with the lanes that go one way, and who called solves the two parts each for itself (`calc/sweep/abreast.py`).  What
lanes can not do (become one float where they differ, a key of a dict, a plain array) is an error, never a mixture of designs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, cast

import numpy as np

from .arrays import Array, BoolArray
from .errors import NoSolution
from .text import EMPTY

HANDLED: dict[object, Callable[..., Any]] = {}  # by the function of numpy, or its name where importing it would cost a start-up time


class Diverged(Exception):
    """The lanes do not go one way.  `some`: those that go the first of them, neither none nor all."""

    def __init__(self, some: BoolArray) -> None:
        super().__init__("the designs do not go one way")
        self.some = some


class Lanes:
    """`data`: an array whose first axis runs over the lanes; `shape`, `ndim` and `size` are those of what one lane has."""

    __slots__ = ("data",)
    __hash__ = None  # type: ignore[assignment]  # no key of a cache: it is equal to nothing once and for all

    def __init__(self, data: Any) -> None:
        self.data = data

    # --- what one lane has ---------------------------------------------------------------------------------------------------
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
        found = np.take_along_axis(data, places.reshape(self.lanes, *(1,) * (data.ndim - 2), -1), -1)
        return Lanes(found if self.ndim else found[..., 0])

    def ravel(self) -> Lanes:
        return Lanes(self.data.reshape(len(self.data), -1))

    def reshape(self, *shape: Any) -> Lanes:
        return Lanes(self.data.reshape(len(self.data), *(shape[0] if len(shape) == 1 and isinstance(shape[0], tuple) else shape)))

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
        return [one.tolist() for one in self] if self.ndim else self

    # --- one way for all -----------------------------------------------------------------------------------------------------
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

    def _alike(self, found: Any) -> Any:
        if found.ndim != 1:
            raise TypeError("an array has no one truth")
        same = found == found[0]
        if not same.all():
            raise Diverged(same)
        return found[0]

    def __array__(self, *args: Any, **kwargs: Any) -> Array:
        raise TypeError("the numbers of many designs are no plain array")

    def __format__(self, form: str) -> str:
        return "…"

    __str__ = __repr__ = lambda self: "…"

    # --- arithmetic ----------------------------------------------------------------------------------------------------------
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


for _name in ("add", "sub", "mul", "truediv", "floordiv", "mod", "pow", "and", "or", "xor", "lt", "le", "gt", "ge", "eq", "ne"):
    _operator(_name)


def wrapped(found: Any) -> Any:
    return tuple(map(Lanes, found)) if isinstance(found, tuple) else Lanes(found)


def level(inputs: Sequence[Any]) -> list[Any]:
    """The data of lanes and plain arrays side by side, so that numpy lets lane meet lane and point meet point."""
    inputs = [stacked(x) if isinstance(x, (list, tuple)) else x for x in inputs]
    deepest = max([x.data.ndim - 1 if type(x) is Lanes else getattr(x, "ndim", 0) for x in inputs])
    return [deep(x.data, deepest) if type(x) is Lanes else x for x in inputs]


def deep(data: Any, points: int) -> Any:
    """With so many axes of points, those that a lane does not have of length one."""
    missing = points + 1 - data.ndim
    return data.reshape(data.shape[0], *(1,) * missing, *data.shape[1:]) if missing else data


def scattered(there: BoolArray, one: Any, other: Any) -> Lanes:
    """An array of the elements of `one` where `there` is true, and those of `other` elsewhere."""
    count = count_of((one, other)) or 1
    parts = [rows(x, count, (size,)).reshape(count, size) for x, size in ((one, int(there.sum())), (other, int((~there).sum())))]
    found = np.empty((count, there.size), dtype=np.result_type(*parts))
    found[:, there], found[:, ~there] = parts
    return Lanes(found)


def rows(x: Any, count: int, shape: tuple[int, ...]) -> Array:
    """What a number or an array is in every lane and at every point of a shape, one lane after the other as one flat array."""
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
    """The same numbers, where all of them are there; designs without one (nan) go apart.  Raises NoSolution where none is."""
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
