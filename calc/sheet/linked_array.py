# SPDX-License-Identifier: Apache-2.0
"""Arrays that know where they came from: see `value.py`."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from .value import KINDS, PLAIN, Link, joined_links, link_of, linked

if TYPE_CHECKING:
    from .arrays import Array


class LinkedArray(np.ndarray):
    """An array with its link, and where it was gathered from single numbers, the link of each (`parts`, along the first axis).

    An element or a part that is taken out keeps the link; what is computed with it is a plain array.
    """

    link: Link | None = None
    parts: tuple[Link | None, ...] = ()

    def __getitem__(self, index: Any) -> Any:
        part = super().__getitem__(index)
        if self.link is None:
            return part
        if not self.parts or isinstance(index, tuple):
            return linked(part, self.link)
        if isinstance(index, (int, np.integer)):
            return linked(part, self.parts[index])
        parts = np.fromiter(self.parts, object)[index]
        return linked_array(part, joined_links(parts.ravel()), tuple(parts) if parts.ndim == 1 else ())

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        return array[()] if return_scalar else array

    def __reduce__(self) -> Any:
        return np.asarray(self).__reduce__()


class LinkedScalar(np.float64):
    """An element of a linked array."""

    link: Link

    def __reduce__(self) -> Any:
        return np.float64(float(self)).__reduce__()

    def __deepcopy__(self, memo: Any) -> Any:
        return np.float64(float(self))


class LinkedComplexScalar(np.complex128):
    link: Link

    def __reduce__(self) -> Any:
        return np.complex128(complex(self)).__reduce__()

    def __deepcopy__(self, memo: Any) -> Any:
        return np.complex128(complex(self))


def _as_linked(x: Any) -> Any:
    return x.view(LinkedArray)


KINDS.update({
    np.float64: LinkedScalar, LinkedScalar: LinkedScalar, np.complex128: LinkedComplexScalar, LinkedComplexScalar: LinkedComplexScalar,
    np.ndarray: _as_linked, LinkedArray: _as_linked,
})  # fmt: skip


PLAIN.update({
    LinkedScalar: lambda x: np.float64(float(x)), LinkedComplexScalar: lambda x: np.complex128(complex(x)), LinkedArray: np.asarray,
})  # fmt: skip


def linked_array(x: Any, link: Link | None, parts: tuple[Link | None, ...]) -> Any:
    """An array with its link and those of its elements."""
    array = linked(x, link)
    if link is not None:
        array.parts = parts
    return array


def gathered(numbers: Iterable[Any], dtype: Any = float) -> "Array":
    """An array of single numbers that keeps the link of each."""
    numbers = tuple(numbers)
    parts = tuple(map(link_of, numbers))
    return cast("Array", linked_array(np.array(numbers, dtype=dtype), joined_links(parts), parts))


def where(there: Any, one: Any, other: Any) -> Any:
    """An array of the elements of `one` where `there` is true, and those of `other` elsewhere: both only as long as they are needed."""
    array = np.empty(there.size, dtype=np.result_type(one, other))
    array[there], array[~there] = one, other
    parts = np.empty(there.size, dtype=object)
    for mask, numbers in ((there, one), (~there, other)):
        links = getattr(numbers, "parts", ()) or (link_of(numbers),) * int(np.count_nonzero(mask))
        parts[mask] = np.fromiter(links, object, len(links))
    return linked_array(array, joined_links(parts), tuple(parts))


def item(x: Any) -> Any:
    """The one number of an array, or a numpy number, as a Python number with its link."""
    return linked(x.item(), link_of(x)) if isinstance(x, (np.ndarray, np.generic)) else x


def elements(x: Any) -> tuple[Any, ...]:
    """The elements of an array of one dimension as Python numbers, each with its link."""
    links = getattr(x, "parts", ()) or (link_of(x),) * len(x)
    return tuple(map(linked, x.tolist(), links))
