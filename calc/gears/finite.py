# SPDX-License-Identifier: Apache-2.0
"""Numbers far outside any gear: a word instead of an infinite value."""

import math
from typing import TypeVar

from ..sheet.errors import NoSolution
from ..sheet.quantity import insides
from ..sheet.step import Outcome
from ..sheet.text import Amount, Text

R = TypeVar("R")
LARGEST = 1e290  # in SI; beyond it the smallest unit overflows


def finite(outcome: Outcome[R]) -> Outcome[R]:
    """No value that is no number, or infinite, is handed out."""
    if all(-LARGEST < x < LARGEST for x in insides(outcome.result)):
        return outcome
    for value in outcome.values():
        if not math.isfinite(value.shown):
            advice = Text("module, face width, power or speed are far outside what the formulas are for: give usual ones")
            raise NoSolution(value.label, Text("{id} is {shown}", id=value.id, shown=Amount(value.shown)), advice)
    return outcome
