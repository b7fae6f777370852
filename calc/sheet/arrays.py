# SPDX-License-Identifier: Apache-2.0
"""The types of arrays, for the type checker only: importing numpy.typing costs a start-up 30 ms."""

from typing import TYPE_CHECKING, cast, overload

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    ComplexArray = NDArray[np.complex128]
    BoolArray = NDArray[np.bool_]
    IndexArray = NDArray[np.intp]
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
