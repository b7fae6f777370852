# SPDX-License-Identifier: Apache-2.0
"""What is made when somebody looks at it: figures, tables and words that stand beside the numbers of a step."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property
from typing import TypeVar, overload

from .errors import NoSolution
from .value import untraced

T = TypeVar("T")


class Later(Sequence[T]):
    """A sequence that `make` gives at the first look.  What can not be made of the numbers (an overflow in a figure) is
    not there."""

    def __init__(self, make: Callable[[], Iterable[T]]) -> None:
        self._make = make

    @cached_property
    def made(self) -> tuple[T, ...]:
        import numpy as np  # which a form does not need

        try:
            with untraced(), np.errstate(all="ignore"):
                return tuple(self._make())
        except (NoSolution, ArithmeticError, ValueError):
            return ()

    @property
    def is_made(self) -> bool:
        return "made" in vars(self)

    def __iter__(self) -> Iterator[T]:
        return iter(self.made)

    def __len__(self) -> int:
        return len(self.made)

    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[T, ...]: ...
    def __getitem__(self, index: int | slice) -> T | tuple[T, ...]:
        return self.made[index]

    def __add__(self, more: "Many[T]") -> "Later[T]":
        return Later(lambda: (*self, *more))

    def __radd__(self, first: tuple[T, ...]) -> "Later[T]":
        return Later(lambda: (*first, *self))

    def __reduce__(self) -> tuple[object, ...]:
        return tuple, (self.made,)


Many = tuple[T, ...] | Later[T]  # what an outcome holds
