# SPDX-License-Identifier: Apache-2.0
"""How numbers are written, four significant digits, 6.2·10⁻³ and not 6.2e-03, and how records print themselves.

Numbers have a true minus sign."""

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import MISSING, fields
from reprlib import Repr

from .units import UNITS

SUPERSCRIPTS = str.maketrans("0123456789+-−.,/()", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻·’ᐟ⁽⁾")
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
DIGITS = 4
SURE = 12  # digits in which processors and libraries agree
DUST = 1e-12  # of the largest of a list: what is smaller is what the last digits of a sum have left


def sure(number: float) -> float:
    """A number without its last digits: half of the last one that is written is else rounded up here and down there."""
    return float(f"{number:.{SURE}g}")


def parts(number: float, digits: int = DIGITS) -> tuple[str, int | None]:
    """A number as its written mantissa and its power of ten (None where it is written without one)."""
    number = sure(number)
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
    return float(f"{sure(x):.{digits - 1}e}")


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


# --- how a record prints itself: in one line (`repr`), or as a table of label, value and unit (`print`)


class _Brief(Repr):
    """Values cut short; of a record inside another only its class, so that a tree of thousands costs nothing."""

    def repr_instance(self, x: object, level: int) -> str:
        inside = hasattr(x, "__dataclass_fields__") or isinstance(x, tuple)
        return f"{type(x).__name__}(…)" if inside else super().repr_instance(x, level)


BRIEF = _Brief()
BRIEF.maxother = BRIEF.maxstring = 48  # characters of one value in a line


def line(record: object) -> str:
    """`BearingRow(diameter=0.0595, length=0.0275, …)`: what differs from its default, in SI, long values cut
    short."""
    kind: type = type(record)
    contents = [(f.name, getattr(record, f.name), f.default) for f in fields(kind)]
    shown = (f"{name}={BRIEF.repr(content)}" for name, content, default in contents if not _is(content, default))
    return f"{kind.__name__}({', '.join(shown)})"


def table(record: object) -> str:
    """A row for each field that is set: its label (its name, where it has none), the value in the unit in which it is
    shown, the unit.

    Of results only what they publish stands in it.
    """
    return aligned(type(record).__name__, rows(record))


def rows(record: object) -> Iterator[tuple[str, str, str]]:
    """The rows of that table: label, value, unit."""
    return _inside(record, "  ")


def aligned(title: str, body: Iterable[tuple[str, str, str]]) -> str:
    """Rows of (label, value, unit) under a title, values flush right."""
    rows = list(body)
    left = max((len(label) for label, _, _ in rows), default=0)
    right = max((len(value) for _, value, _ in rows), default=0)
    return "\n".join([title, *(f"{label:<{left}}  {value:>{right}} {unit}".rstrip() for label, value, unit in rows)])


def _rows(label: str, content: object, unit: str, indent: str) -> Iterator[tuple[str, str, str]]:
    if content is None or (isinstance(content, tuple | str) and not content):
        return
    # a result named at run time
    if (about := getattr(content, "about", None)) is not None and hasattr(content, "number"):
        yield f"{indent}{about.label}", brief(content.number, UNITS[about.unit].factor), about.unit
    elif isinstance(content, dict) or hasattr(content, "__dataclass_fields__"):
        yield f"{indent}{label}", "", ""
        yield from _inside(content, indent + "  ")
    else:
        yield f"{indent}{label}", brief(content, UNITS[unit].factor if unit else 1.0), unit


def _inside(content: object, indent: str) -> Iterator[tuple[str, str, str]]:
    if isinstance(content, dict):
        for name, part in content.items():
            yield from _rows(str(name), part, "", indent)
        return
    kind: type = type(content)
    known = fields(kind)
    for f in [f for f in known if f.metadata] or known:
        about = f.metadata.get("value") or f.metadata.get("quantity")
        label, unit = (about.label, about.unit) if about else (f.name, "")
        where = getattr(about, "where", None)
        if where is not None and getattr(content, where.choice.name) not in (None, *where.words):
            continue  # it says nothing here
        yield from _rows(label, getattr(content, f.name), unit, indent)


def brief(content: object, factor: float = 1.0) -> str:
    """Numbers in the shown unit with six digits, of long lists the ends, of arrays the shape, of records in a list
    their class."""
    if hasattr(content, "shape") and content.shape:
        return f"array{content.shape}"
    if isinstance(content, tuple | list):
        if all(isinstance(x, float) for x in content):
            return several([x / factor for x in content])
        return ", ".join([brief(x, factor) for x in content[:4]] + [f"… {len(content)} in all"] * (len(content) > 4))
    if isinstance(content, bool | str):
        return str(content)
    if isinstance(content, int | float | complex):
        return scalar(content / factor, 6)
    return str(getattr(content, "name", "")) or type(content).__name__


def _is(content: object, default: object) -> bool:
    """Whether a field has its default; an array never has."""
    return default is not MISSING and not getattr(content, "ndim", 0) and bool(content == default)
