# SPDX-License-Identifier: Apache-2.0
"""How numbers are written: four significant digits, 6.2·10⁻³ and not 6.2e-03, a true minus sign."""

import cmath
import math
from collections.abc import Iterable

SUPERSCRIPTS = str.maketrans("0123456789+-−.,/()", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻·’ᐟ⁽⁾")
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
DIGITS = 4
DUST = 1e-12  # of the largest of a list: what is smaller is what the last digits of a sum have left


def parts(number: float, digits: int = DIGITS) -> tuple[str, int | None]:
    """A number as its written mantissa and its power of ten (None where it is written without one)."""
    number = float(number)
    if not math.isfinite(number):
        return ("∞" if number > 0 else "−∞" if number < 0 else "no value"), None
    rounded = float(f"{number:.{digits}g}")
    if rounded == 0 or 1e-2 <= abs(rounded) < 1e5:
        text = f"{rounded:.12g}"
        return text.replace("-", "−") if rounded else "0", None
    mantissa, exponent = f"{number:.{digits - 1}e}".split("e")
    return mantissa.rstrip("0").rstrip(".").replace("-", "−"), int(exponent)


def short(number: float, digits: int = DIGITS) -> str:
    mantissa, exponent = parts(number, digits)
    if exponent is None:
        return mantissa
    return f"{mantissa}·10{str(exponent).translate(SUPERSCRIPTS)}"


def phasor(z: complex, digits: int = DIGITS) -> str:
    """A vector in the transverse plane: its length and its angle."""
    angle = round(math.degrees(math.atan2(z.imag, z.real)), 9) + 0.0
    return f"{short(abs(z), digits)}∠{short(abs(angle) if angle == -180 else angle, digits)}°" if abs(z) else "0"


def scalar(x: complex, digits: int = DIGITS) -> str:
    if isinstance(x, bool):
        return str(x)
    if isinstance(x, complex) or getattr(getattr(x, "dtype", None), "kind", "") == "c":
        return phasor(complex(x), digits)
    return short(x, digits)


def rounded(x: float, digits: int) -> float:
    """A number as it reads when it is written with so many digits."""
    return float(f"{x:.{digits - 1}e}")


def all_rounded(x: object, digits: int) -> object:
    """The same of a number, a vector, a list or an array; anything else as it is."""
    if isinstance(x, (tuple, list)):
        return type(x)(all_rounded(v, digits) for v in x)
    if getattr(x, "ndim", 0):
        import numpy as np

        array = np.asarray(x)
        return np.array([all_rounded(v, digits) for v in array.ravel().tolist()]).reshape(array.shape)
    if isinstance(x, complex):
        return cmath.rect(rounded(abs(x), digits), math.radians(rounded(math.degrees(cmath.phase(x)), digits)))
    return rounded(x, digits) if isinstance(x, float) else x


LISTED = 4  # elements of a list that is written whole
RANGE = " … "  # between the ends of a longer one


def several(values: Iterable[complex], digits: int = DIGITS) -> str:
    """A short list in full, a long one by its ends; what is dust beside the rest is 0."""
    flat = list(values)
    dust = DUST * max((abs(v) for v in flat), default=0.0)
    ends = flat if len(flat) <= LISTED else (flat[0], flat[-1])
    written = [scalar(v if abs(v) > dust else 0.0, digits) for v in ends]
    return f"({'; '.join(written)})" if len(flat) <= LISTED else f"({RANGE.join(written)}: {len(flat)})"
