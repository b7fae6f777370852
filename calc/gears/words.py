# SPDX-License-Identifier: Apache-2.0
"""Lengths as they stand in the sentences of the gear train."""

from ..sheet.number import DIGITS
from ..sheet.text import Amount
from ..sheet.units import Metre


def mm(length: Metre, form: str = "", *, digits: int = DIGITS) -> Amount:
    """In millimetres, which the sentence names behind it."""
    return Amount(length * 1000.0, form=form, digits=digits)
