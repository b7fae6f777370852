# SPDX-License-Identifier: Apache-2.0
"""The types of arrays, for the type checker only: importing numpy.typing costs a start-up 30 ms."""

from typing import TYPE_CHECKING, Any, TypeVar, cast, overload

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    ComplexArray = NDArray[np.complex128]
    BoolArray = NDArray[np.bool_]
    IndexArray = NDArray[np.intp]
    S = TypeVar("S", bound=np.generic)
else:
    Array = ComplexArray = BoolArray = IndexArray = object


@overload
def each(x: "Array | IndexArray | tuple[float, ...]") -> float: ...
@overload
def each(x: ComplexArray) -> complex: ...
def each(x: object) -> object:
    """An array where a formula takes one number: the door by which arrays enter formulas, which are written and typed
    for numbers."""
    return x


def many(x: float) -> Array:
    """What a formula returns that was given arrays: an array."""
    return cast(Array, x)


def phasors(x: complex) -> ComplexArray:
    """As `many`, of phasors."""
    return cast(ComplexArray, x)


def has_lanes(*numbers: object) -> bool:
    """Whether one of them is that of many designs (`lanes.py`)."""
    return any([hasattr(x, "lanes") for x in numbers])


def one(x: Any) -> Any:
    """A number that stands alone: out of an array its only element, of many designs (`lanes.py`) one each."""
    return x.item() if hasattr(x, "item") else x


def element(x: "Array | tuple[float, ...]", at: Any) -> float:
    """The number at a place of an array; of many designs each has its own place."""
    return cast(float, at.of(x) if has_lanes(at) else x[at])


def most(x: Any) -> float:
    """The largest of all numbers, those of many designs too: what says whether an iteration is at its end
    everywhere."""
    return float(_all(x).max()) if hasattr(x, "ndim") else cast(float, x)


def anywhere(x: Any) -> bool:
    """Whether it is so at some place, of some design: then all take the way that is right for both."""
    return bool(_all(x).any())


def _all(x: object) -> Any:
    import numpy as np

    return np.asarray(getattr(x, "data", x) if has_lanes(x) else x)


def distinct(x: "NDArray[S]") -> "tuple[NDArray[S], IndexArray, IndexArray]":
    """The numbers of a one-dimensional array that differ, ascending; where each stands first; and which of them each
    element is.

    As `numpy.unique`, which brings in a tenth of a start-up more of numpy.
    """
    import numpy as np

    order = np.argsort(x, kind="stable")
    ascending = x[order]
    new = np.concatenate([[True], ascending[1:] != ascending[:-1]]) if len(x) else np.zeros(0, dtype=bool)
    which = np.empty(len(x), dtype=np.intp)
    which[order] = np.cumsum(new) - 1
    return ascending[new], order[new], which
