# SPDX-License-Identifier: Apache-2.0
"""Numbers as a drawing has them: rounded, without zeros behind, in the language of the sheet."""

import math
from collections.abc import Callable

from ..sheet.text import Amount, Text
from ..sheet.units import UNITS, Metre, Radian

Say = Callable[[str], str]
ALIKE = 1e-9  # m
FINE, COARSE = 2, 1  # decimals of a length that the design gives, and of one that follows from masses
GIVEN = 1e-4  # mm: what is so close to a hundredth is given


def number(x: float, digits: int) -> Amount:
    """Rounded to so many decimals, without zeros behind them."""
    return Amount(round(x, digits) + 0.0, form=".12g")


def millimetres(length: Metre, digits: int = FINE) -> Amount:
    return number(UNITS["mm"].shown(length), digits)


def rounded(length: Metre) -> Amount:
    """A length as a drawing has it: 27.51 that only follows from a mass is 27.5, but 26.25 that is given stays."""
    shown = UNITS["mm"].shown(length)
    return number(shown, FINE if abs(shown - round(shown, FINE)) < GIVEN else COARSE)


def degrees(angle: Radian, digits: int = COARSE) -> Text:
    return Text("{angle}°", angle=number(math.degrees(angle), digits))


def alone(amount: Amount) -> Text:
    return Text("{number}", number=amount)


def signed(length: Metre) -> Amount:
    """A deviation with its sign; 0 has none."""
    shown = round(UNITS["mm"].shown(length), 4) + 0.0
    return Amount(shown, form="+.12g" if shown else "g")


def deviated(size: Text, lower: Metre, upper: Metre) -> Text:
    """A size with its deviations; those that differ by their sign alone stand together."""
    if abs(lower + upper) < ALIKE:
        return Text("{size} ±{deviation}", size=size, deviation=millimetres(upper, 4))
    return Text("{size} ({upper}/{lower})", size=size, upper=signed(upper), lower=signed(lower))
