# SPDX-License-Identifier: Apache-2.0
"""Numbers far outside any gear: a word instead of an infinite value."""

import math

from ..sheet.errors import NoSolution
from ..sheet.number import short
from ..sheet.quantity import insides
from ..sheet.step import Outcome

LARGEST = 1e290  # in SI; beyond it the smallest unit overflows


def finite(outcome: Outcome) -> Outcome:
    """No value that is no number, or infinite, is handed out."""
    if all(-LARGEST < x < LARGEST for x in insides(outcome.result)):
        return outcome
    for value in outcome.values():
        if not math.isfinite(value.shown):
            advice = "module, face width, power or speed are far outside what the formulas are for: give usual ones"
            raise NoSolution(value.label, f"{value.id} is {short(value.shown)}", advice)
    return outcome
