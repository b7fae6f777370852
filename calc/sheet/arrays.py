# SPDX-License-Identifier: Apache-2.0
"""The types of arrays, for the type checker only: importing numpy.typing costs a start-up 30 ms."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import TypeVar

    Array = NDArray[np.float64]
    ComplexArray = NDArray[np.complex128]
    BoolArray = NDArray[np.bool_]
    IndexArray = NDArray[np.intp]
    Num = float | Array  # a number, or as many as an array has
    AnyNumbers = complex | Array | ComplexArray | IndexArray
    Value = TypeVar("Value", float, Array, default=float)  # what a record of numbers or of arrays holds
else:
    from typing import TypeVar

    Array = ComplexArray = BoolArray = IndexArray = Num = AnyNumbers = object
    Value = TypeVar("Value", float, object)
