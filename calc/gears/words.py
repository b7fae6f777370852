# SPDX-License-Identifier: Apache-2.0
"""Words that several sentences of the gear train share."""

from ..sheet.number import DIGITS
from ..sheet.text import Amount, Text
from ..sheet.units import Metre

EXTREME = Text("module, face width, power or speed are far outside what the formulas are for: give usual ones")


def mm(length: Metre, form: str = "", *, digits: int = DIGITS) -> Amount:
    """In millimetres, which the sentence names behind it."""
    return Amount(length * 1000.0, form=form, digits=digits)
