# SPDX-License-Identifier: Apache-2.0
"""Arrays that know where they came from: see `value.py`."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from .value import KINDS, PLAIN, Link, joined_links, link_of, linked, recording

if TYPE_CHECKING:
    from .arrays import Array, BoolArray, ComplexArray


class LinkedArray(np.ndarray):
    """An array with its link, and where it was gathered from single numbers, the link of each (`parts`, along the first
    axis).

    An element or a part that is taken out keeps the link; what is computed with it is a plain array.
    """

    link: Link | None = None
    parts: tuple[Link | None, ...] = ()

    def __getitem__(self, index: Any) -> Any:  # here and below: as numpy's own
        part = super().__getitem__(index)
        if self.link is None:
            return part
        if not self.parts or isinstance(index, tuple):
            return linked(part, self.link)
        if isinstance(index, (int, np.integer)):
            return linked(part, self.parts[index])
        parts = np.fromiter(self.parts, object)[index]
        return linked_array(part, joined_links(parts.ravel()), tuple(parts) if parts.ndim == 1 else ())

    def __array_wrap__(self, array: "Array", context: object = None, return_scalar: bool = False) -> Any:
        return array[()] if return_scalar else array

    def __reduce__(self) -> str | tuple[object, ...]:
        return np.asarray(self).__reduce__()


class LinkedScalar(np.float64):
    """An element of a linked array."""

    link: Link

    def __reduce__(self) -> str | tuple[object, ...]:
        return np.float64(float(self)).__reduce__()

    def __deepcopy__(self, memo: object) -> Any:
        return np.float64(float(self))


class LinkedComplexScalar(np.complex128):
    link: Link

    def __reduce__(self) -> str | tuple[object, ...]:
        return np.complex128(complex(self)).__reduce__()

    def __deepcopy__(self, memo: object) -> Any:
        return np.complex128(complex(self))


def _as_linked(x: "Array") -> LinkedArray:
    return x.view(LinkedArray)


KINDS.update({np.float64: LinkedScalar, LinkedScalar: LinkedScalar})
KINDS.update({np.complex128: LinkedComplexScalar, LinkedComplexScalar: LinkedComplexScalar})
KINDS.update({np.ndarray: _as_linked, LinkedArray: _as_linked})
PLAIN.update({LinkedScalar: lambda x: np.float64(float(x)), LinkedComplexScalar: lambda x: np.complex128(complex(x))})
PLAIN[LinkedArray] = np.asarray


def linked_array(x: "Array", link: Link | None, parts: tuple[Link | None, ...]) -> "Array":
    """An array with its link and those of its elements."""
    array = linked(x, link)
    if link is not None and isinstance(array, LinkedArray):
        array.parts = parts
    return array


def gathered(numbers: Iterable[object]) -> "Array":
    """An array of single numbers that keeps the link of each."""
    numbers = tuple(numbers)
    if not recording.get():
        return np.array(numbers, dtype=float)
    parts = tuple(map(link_of, numbers))
    return linked_array(np.array(numbers, dtype=float), joined_links(parts), parts)


def column(parts: Iterable[object], name: str) -> Any:  # a door: an array, and what formulas take
    """One number of every part, as an array that knows where each came from."""
    return gathered(getattr(part, name) for part in parts)


@overload
def where(there: "BoolArray", chosen: "float | Array", other: "Array") -> "Array": ...
@overload
def where(there: "BoolArray", chosen: "complex | ComplexArray", other: "ComplexArray") -> "ComplexArray": ...
def where(
    there: "BoolArray", chosen: "complex | Array | ComplexArray", other: "Array | ComplexArray"
) -> "Array | ComplexArray":
    """An array of the elements of `one` where `there` is true, and those of `other` elsewhere: both only as long as
    they are needed."""
    array = np.empty(there.size, dtype=np.result_type(chosen, other))
    array[there], array[~there] = chosen, other
    parts = np.empty(there.size, dtype=object)
    for mask, numbers in ((there, chosen), (~there, other)):
        links = getattr(numbers, "parts", ()) or (link_of(numbers),) * int(np.count_nonzero(mask))
        parts[mask] = np.fromiter(links, object, len(links))
    return linked_array(array, joined_links(parts), tuple(parts))


@overload
def item(x: "float | Array") -> float: ...
@overload
def item(x: "complex | ComplexArray") -> complex: ...
def item(x: Any) -> Any:
    """The one number of an array, or a numpy number, as a Python number with its link."""
    return linked(x.item(), link_of(x)) if isinstance(x, (np.ndarray, np.generic)) else x


@overload
def elements(x: "Array") -> tuple[float, ...]: ...
@overload
def elements(x: "ComplexArray") -> tuple[complex, ...]: ...
def elements(x: "Array | ComplexArray") -> tuple[complex, ...]:
    """The elements of an array of one dimension as Python numbers, each with its link."""
    links = getattr(x, "parts", ()) or (link_of(x),) * len(x)
    return tuple(map(linked, x.tolist(), links))
