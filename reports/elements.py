# SPDX-License-Identifier: Apache-2.0
"""What a number comes from, followed through arrays: of each line the one element that enters, and what that is made of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from calc.sheet.trace import Line
from calc.sheet.value import Link, leaves, link_of

Index = tuple[int, ...]
Element = tuple[Line, Index | None]  # a line, and which element of its value; None: all of it, or it is no array


class Origins:
    """The elements that others come from, each found once."""

    def __init__(self) -> None:
        self._known: dict[Element, tuple[list[Element], list[str]]] = {}

    def of(self, element: Element) -> tuple[list[Element], list[str]]:
        """The elements of lines, and the inputs, that enter a line, or one element of it."""
        if element not in self._known:
            self._known[element] = _came_from(*element)
        return self._known[element]

    def followed(self, start: Iterable[Element]) -> Iterator[Element]:
        """These elements and all that they come from, the nearest first; each line once."""
        waiting = list(start)
        known = {line for line, _ in waiting}
        for element in waiting:  # grows on the way
            yield element
            for needed in self.of(element)[0]:
                if needed[0] not in known:
                    known.add(needed[0])
                    waiting.append(needed)


def _came_from(line: Line, index: Index | None) -> tuple[list[Element], list[str]]:
    shape = getattr(line.value, "shape", ()) if index else ()
    found: dict[Line, Index | None] = {}
    inputs: dict[str, None] = {}
    for argument in line.arguments.values():
        own: Any = argument
        link = link_of(argument)
        if index and getattr(argument, "shape", ()) == shape:
            own, link = own[index], _part(own, index) or link
        sources = leaves(link)
        entering = [leaf for leaf in sources if isinstance(leaf, Line)]
        if len(entering) > 1:
            entering = [leaf for leaf in entering if _holds(leaf, own)] or entering
        for leaf in entering:
            if leaf not in found:
                found[leaf] = _index(leaf, own, index)
        inputs |= dict.fromkeys(leaf for leaf in sources if isinstance(leaf, str))
    return list(found.items()), list(inputs)


def _part(array: Any, index: Index) -> Link | None:
    """The link of one element, where an array knows those of its elements."""
    parts = getattr(array, "parts", ())
    return parts[index[0]] if parts else None


def _holds(line: Line, own: Any) -> bool:
    """Whether a line gives this number, alone or among others."""
    value = line.value
    if getattr(own, "ndim", 0) or not isinstance(own, (int, float, complex)):
        return False
    return value == own if not isinstance(value, np.ndarray) else own in value


def _index(line: Line, own: Any, index: Index | None) -> Index | None:
    """The element of a line that is this number: the one at the same place, else the first that is equal."""
    value = line.value
    if not isinstance(value, np.ndarray) or value.size < 2 or np.ndim(own) or not isinstance(own, (int, float, complex)):
        return None
    if index and len(index) == value.ndim and all(i < n for i, n in zip(index, value.shape)) and value[index] == own:
        return index
    equal = np.argwhere(value == own)
    return tuple(equal[0].tolist()) if len(equal) else None
