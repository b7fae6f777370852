# SPDX-License-Identifier: Apache-2.0
"""The types of arrays, for the type checker only: importing numpy.typing costs a start-up 30 ms."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    ComplexArray = NDArray[np.complex128]
    BoolArray = NDArray[np.bool_]
    IndexArray = NDArray[np.intp]
else:
    Array = ComplexArray = BoolArray = IndexArray = Any


def column(parts: "tuple[Any, ...]", name: str) -> Any:
    """One number of every part, as an array."""
    import numpy as np

    return np.array([getattr(part, name) for part in parts], dtype=float)
