# SPDX-License-Identifier: Apache-2.0
"""Numbers far outside of what a step is for: a word instead of an infinite value."""

import math

from .errors import NoSolution
from .quantity import insides, published
from .text import Amount, Text

LARGEST = 1e290  # in SI; beyond it the smallest unit overflows


def finite(result: object, prefix: str, advice: Text) -> None:
    """Raises NoSolution where a value is no number, or infinite."""
    if all(-LARGEST < x < LARGEST for x in insides(result)):
        return
    for value in published(result, prefix):
        if not math.isfinite(value.shown):
            raise NoSolution(value.label, Text("{id} is {shown}", id=value.id, shown=Amount(value.shown)), advice)
