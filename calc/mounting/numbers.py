# SPDX-License-Identifier: Apache-2.0
"""From arrays to published numbers: one line of the calculation for each where lines are wanted, one call for all where not."""

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from ..sheet.quantity import Described, Stated
from ..sheet.text import Text
from ..sheet.trace import recorder
from ..sheet.value import based_on

Nested = Any  # lists of lists of floats, as deep as the arrays have axes before those that the formula takes


def mapped(formula: Callable[..., Any], *given: Any, source: object, axes: int = 1) -> Nested:
    """A formula of the last axes of arrays of one shape, for all that stands before them."""
    if recorder.get() is None:
        return np.asarray(formula(*given)).tolist()
    if given[0].ndim == axes:
        return formula(*(based_on(np.ascontiguousarray(x), source) if i == len(given) - 1 else x for i, x in enumerate(given)))
    return [mapped(formula, *parts, source=source, axes=axes) for parts in zip(*given)]


def joined(formula: Callable[..., Any], parts: Nested) -> Nested:
    """A formula of the numbers along the last axis of nested lists, for all that stands before."""
    if recorder.get() is None:
        return np.asarray(formula(*np.moveaxis(np.asarray(parts), -1, 0))).tolist()
    return [joined(formula, part) for part in parts] if isinstance(parts[0], list) else formula(*parts)


def along_last(nested: Nested) -> list[Nested]:
    """The numbers along the last axis one after the other, each with the axes before it."""
    if not isinstance(nested[0], list):
        return list(nested)
    return [list(part) for part in zip(*(along_last(part) for part in nested))]


def there(number: float) -> float | None:
    """A number, or None where it is none: an undamped resonance."""
    return number if -math.inf < number < math.inf else None


@cache
def described(label: Text, unit: str, symbol: str = "") -> Described:
    return Described(label, unit, symbol)


def put(tree: dict[str, Any], way: tuple[str, ...], about: Described, number: float | None) -> None:
    """Publish a number; one that is none (an undamped resonance, a ratio of nothing) is left out."""
    if number is None or not math.isfinite(number):
        return
    for part in way[:-1]:
        tree = tree.setdefault(part, {})
    tree[way[-1]] = Stated(about, number)
