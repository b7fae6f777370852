# SPDX-License-Identifier: Apache-2.0
"""Numbers and sizes as a drawing has them: rounded, without zeros behind, in the language of the sheet; and a size with
its deviations (ISO 129-1)."""

import math
from collections.abc import Callable

from ..sheet.record import record
from ..sheet.text import Amount, Text
from ..sheet.units import UNITS, Metre, Radian
from .drawing import Inscription

Say = Callable[[str], str]
ALIKE = 1e-9  # m
FINE, COARSE = 2, 1  # decimals of a length that the design gives, and of one that follows from masses
GIVEN = 1e-4  # mm: what is so close to a hundredth is given
MOST = 4  # decimals of a deviation


def number(x: float, digits: int) -> Amount:
    """Rounded to so many decimals, without zeros behind them."""
    return Amount(round(x, digits) + 0.0, form=".12g")


def millimetres(length: Metre, digits: int = FINE) -> Amount:
    return number(UNITS["mm"].shown(length), digits)


def decimals(length: Metre) -> int:
    """Of a length as a drawing has it: 27.51 that only follows from a mass is 27.5, but 26.25 that is given stays."""
    shown = UNITS["mm"].shown(length)
    return FINE if abs(shown - round(shown, FINE)) < GIVEN else COARSE


def rounded(length: Metre) -> Amount:
    return millimetres(length, decimals(length))


def degrees(angle: Radian, digits: int = COARSE) -> Text:
    return Text("{angle}°", angle=number(math.degrees(angle), digits))


def alone(amount: Amount) -> Text:
    return Text("{number}", number=amount)


def signed(length: Metre) -> Amount:
    """A deviation with its sign; 0 has none."""
    shown = round(UNITS["mm"].shown(length), MOST) + 0.0
    return Amount(shown, form="+.12g" if shown else "g")


def deviated(size: Text, lower: Metre, upper: Metre) -> Text:
    """A size with its deviations in one line, of a table; those that differ by their sign alone stand together."""
    if abs(lower + upper) < ALIKE:
        return Text("{size} ±{deviation}", size=size, deviation=millimetres(upper, 4))
    return Text("{size} ({upper}/{lower})", size=size, upper=signed(upper), lower=signed(lower))


@record
class Size:
    """A size before it is written.  `value`: m, or rad of an angle; `before`: its sign; `after`: its field, or a
    bracket; `deviations`: lower and upper, m."""

    value: float
    before: str = ""
    after: str = ""
    digits: int = FINE
    deviations: tuple[Metre, Metre] | None = None
    angle: bool = False

    def inscribed(self, say: Say) -> Inscription:
        shown = math.degrees(self.value) if self.angle else UNITS["mm"].shown(self.value)
        size = say(alone(number(shown, self.digits)))
        words = f"{self.before}{size}{self.after}"
        upper, lower, limits = "", "", None
        if self.deviations is not None:
            low, high = self.deviations
            limits = UNITS["mm"].shown(low), UNITS["mm"].shown(high)
            if abs(low + high) < ALIKE:
                words += say(Text(" ±{deviation}", deviation=millimetres(high, MOST)))
            else:
                upper, lower = (say(text) for text in _stacked(*limits))
        post = f"{self.before}<>{self.after}"
        return Inscription(words, upper, lower, post, self.digits, limits)


def diameter(d: Metre, after: str = "", deviations: tuple[Metre, Metre] | None = None) -> Size:
    return Size(d, "⌀", after, deviations=deviations)


def length(size: Metre, deviations: tuple[Metre, Metre] | None = None) -> Size:
    return Size(size, digits=decimals(size), deviations=deviations)


def auxiliary(size: Metre) -> Size:
    """In brackets: what follows from others."""
    return Size(size, "(", ")", decimals(size))


def radius(size: Metre) -> Size:
    return Size(size, "R")


def angle(size: Radian) -> Size:
    return Size(size, after="°", digits=COARSE, angle=True)


def _stacked(lower: float, upper: float) -> tuple[Text, Text]:
    """The upper and the lower deviation in millimetres, both with as many decimals; 0 has none, and no sign."""
    places = max(_places(x) for x in (lower, upper))
    high, low = (Amount(x, form=f"+.{places}f") if round(x, MOST) else Amount(0.0, form="g") for x in (upper, lower))
    return alone(high), alone(low)


def _places(x: float) -> int:
    return len(f"{abs(x):.{MOST}f}".rstrip("0").partition(".")[2])
