# SPDX-License-Identifier: Apache-2.0
"""With how many digits the numbers of a substitution have to be written, so that who works it out again finds the value beside it.

A value has four digits.  Its arguments have four as well, and more where they are needed: where a difference takes the first ones away,
where a power multiplies a rounding, where the value lies near the middle between two numbers of four digits.
"""

import math
from collections.abc import Mapping

from .number import DIGITS, LISTED, all_rounded, rounded
from .trace import Equation

MOST = 12  # digits of an argument
NOUGHT = 5e-4  # in the shown unit: what is found again in place of 0


def digits_that_close(formula: Equation, arguments: Mapping[str, object], value: object, factor: float) -> dict[str, int]:
    """Digits by argument.  `value`: what the arguments gave, in SI; `factor`: its shown unit in SI.

    Four for all where that is enough; else the least number with which all of them give the value, then as few as each one needs.
    """
    given = {name: x for name, x in arguments.items() if _is_written(x)}
    digits = dict.fromkeys(arguments, DIGITS)
    if not isinstance(value, (float, complex)) or not math.isfinite(abs(value)):
        return digits
    target = value / factor

    def close() -> bool:
        try:
            again = formula.function(**{**arguments, **{name: all_rounded(x, digits[name]) for name, x in given.items()}})
            return isinstance(again, (int, float, complex)) and bool(_same(again / factor, target))
        except (ValueError, ZeroDivisionError, OverflowError, TypeError):
            return False

    for many in range(DIGITS, MOST + 1):
        digits = dict.fromkeys(arguments, many)
        if close():
            break
    else:
        return dict.fromkeys(arguments, DIGITS)  # an algorithm of its own, or a list too long to be written: no digits help
    for name in given:
        for fewer in range(DIGITS, digits[name]):
            kept, digits[name] = digits[name], fewer
            if close():
                break
            digits[name] = kept
    return digits


def _is_written(x: object) -> bool:
    """A number, or a list that is short enough to be written whole."""
    if isinstance(x, (tuple, list)):
        return len(x) <= LISTED
    if hasattr(x, "size"):
        return bool(x.size <= LISTED)
    return isinstance(x, (int, float, complex)) and not isinstance(x, bool)


def _same(again: complex, value: float | complex) -> bool:
    """Whether a number that is worked out again lies within half a unit of the last digit with which the value is written."""
    if isinstance(value, complex):
        turned = math.degrees(math.atan2(again.imag, again.real) - math.atan2(value.imag, value.real)) if value and again else 0.0
        angle = math.degrees(math.atan2(value.imag, value.real))
        return _near(abs(again), abs(value)) and _near(angle + math.remainder(turned, 360), angle)
    return _near(again, value)


def _near(again: complex, value: float) -> bool:
    shown = rounded(float(value), DIGITS)
    return abs(again - shown) <= 0.5 * _unit(shown) * (1 + 1e-9) if shown else abs(again) < NOUGHT


def _unit(shown: float) -> float:
    """One unit of the last of its four digits."""
    return float(10.0 ** (math.floor(math.log10(abs(shown))) - DIGITS + 1))
