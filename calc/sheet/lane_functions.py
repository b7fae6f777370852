# SPDX-License-Identifier: Apache-2.0
"""The functions of numpy that take lanes: each works lane by lane, on the points that a lane has.

One that does not stand here refuses lanes, which is an error and then another way (`abreast.py`).
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .lanes import HANDLED, Lanes, axis_of, deep, level, reduced, stacked, with_all_lanes, wrapped


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
    return Lanes(np.stack([np.interp(x, places, one) for one in numbers.data]))


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
