# SPDX-License-Identifier: Apache-2.0
"""What a call from Python is given, held against the same ranges as a file: all mistakes at once, as BadInput.

Numbers are in SI there, arrays element by element.  What a file's key keeps apart is told by its range: millimetres
for metres, kelvin for °C, bar for Pa."""

import cmath
import sys
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, TypeGuard, TypeVar

import numpy as np

from .errors import BadInput, InputError, written
from .quantity import Key, Quantity, keys, unknown
from .record import replace
from .text import EMPTY, SPACE, Amount, Text

T = TypeVar("T")
ZERO_CELSIUS = 273.15
FAR = 100.0  # how many times outside of what is usual a number lies that is taken for one of another unit
REAL = "iuf"  # kinds of arrays of numbers
NUMBERS = ("number", "integer", "series", "integers")


def check_arguments(call: str, **arguments: tuple[object, object]) -> None:
    """Raises BadInput where an argument is not what its input allows: each by its name, as (the declared input, what
    is given); None is left out."""
    _raise(call, (error for name, (key, given) in arguments.items() for error in _of_input(name, key, given)))


def demand_numbers(call: str, **given: Any) -> None:
    """The same of numbers alone: finite, real or complex, and no arrays; None is left out."""
    plain = {name: x.item() if getattr(x, "ndim", 1) == 0 else x for name, x in given.items() if x is not None}
    needs = Text("must be a finite number")
    _raise(
        call,
        (
            InputError(0, name, _as_given(number), needs)
            for name, number in plain.items()
            if not (_is_finite(number) or (isinstance(number, complex) and cmath.isfinite(number)))
        ),
    )


def demand_alike(call: str, most: int = 1, **given: Any) -> None:
    """Raises BadInput where arrays among these have shapes that can not be put together, or more dimensions than `most`
    (0: any number)."""
    shapes = {name: np.shape(number) for name, number in given.items() if np.ndim(number)}
    needs = Text("must be a number, or an array as long as the others")
    if not (_together(shapes.values()) and all(len(shape) <= (most or len(shape)) for shape in shapes.values())):
        raise BadInput(call, [InputError(0, name, f"shape {shape}", needs) for name, shape in shapes.items()])


def _together(shapes: Iterable[tuple[int, ...]]) -> bool:
    try:
        np.broadcast_shapes(*shapes)
    except ValueError:
        return False
    return True


NONE_VARIED: Mapping[str, object] = {}


def given_inputs(call: str, inputs: T, varied: Mapping[str, object] = NONE_VARIED) -> T:
    """An object of an Inputs class, with those of its numbers that are others, once the same holds of all of it and of
    the tables in it."""
    kind: type = type(inputs)
    known = {key.attribute for key in keys(kind).values()}
    _raise(call, (InputError(0, name, "", unknown(name, sorted(known))) for name in varied if name not in known))
    changed = replace(inputs, **varied) if varied else inputs  # type: ignore[type-var]
    _raise(call, _of_table("", changed))
    return changed


def named(call: str, argument: str, name: str, known: Mapping[str, T]) -> T:
    """What a catalogue has under a name."""
    if not isinstance(name, str) or name not in known:
        raise BadInput(call, [InputError(0, argument, written(name), unknown(str(name), list(known)))])
    return known[name]


def _raise(call: str, found: Iterator[InputError]) -> None:
    if errors := list(found):
        raise BadInput(call, errors)


def _of_table(prefix: str, inputs: object) -> Iterator[InputError]:
    kind: type = type(inputs)
    own = [
        error
        for key in keys(kind).values()
        for error in _of_input(prefix + key.attribute, key, getattr(inputs, key.attribute))
    ]
    yield from own
    many = any(getattr(part, "ndim", 0) for part in vars(inputs).values())
    if not (own or many):  # what belongs together is judged of sound numbers alone, one of each
        for key, reason in getattr(inputs, "problems", lambda: ())():
            first, dot, rest = key.partition(".")
            known = keys(kind).get(first)
            yield InputError(0, prefix + (known.attribute if known else first) + dot + rest, "", reason)


def _of_input(name: str, key: object, given: object) -> Iterator[InputError]:
    assert isinstance(key, Key), key
    about = key.about
    if given is None or (about.optional and given is key.field.default):
        return
    match about.kind:
        case "table":
            yield from _of_table(f"{name}.", given)
        case "tables":
            for n, element in enumerate(given):  # type: ignore[arg-type, var-annotated]
                yield from _of_table(f"{name}.{getattr(element, 'name', n)}.", element)
        case "choice":
            if given not in about.choices:
                yield InputError(0, name, written(given), Text("must be {allowed}", allowed=about.allowed()))
        case kind if kind in NUMBERS:
            for place, number in _worst(given):
                if (reason := _refused(about, number)) is not None:
                    yield InputError(0, name + place, _as_given(number), reason)


def _worst(given: Any) -> Iterator[tuple[str, object]]:
    """(its place in what is given, a number) for each that may be the one that is refused: of an array its ends."""
    if getattr(given, "ndim", 0) and given.dtype.kind not in REAL:
        yield "", given
    elif getattr(given, "ndim", 0):
        flat = given.ravel()
        at = {int(flat.argmin()), int(flat.argmax())} if flat.size else set()
        yield from ((f"[{n}]", flat[n].item()) for n in sorted(at))
    elif isinstance(given, (tuple, list)):
        yield from ((f"[{n}]", number) for n, number in enumerate(given) if number is not None)
    else:
        yield "", given.item() if hasattr(given, "item") else given


def _is_finite(number: object) -> TypeGuard[float]:
    """Whether it is one number, which a float can hold."""
    return isinstance(number, (int, float)) and abs(number) <= sys.float_info.max


def _refused(about: Quantity, number: object) -> Text | None:
    """Why an argument is none of these numbers, with what was meant where that can be told."""
    shown: object = about.units.shown(number) if about.unit and _is_finite(number) else number
    reason = about.refuses(shown)
    if reason is None and _of_another_unit(about, number) and about.usual is not None:
        low, high = map(_plain, about.usual)
        reason = Text("is usually {low} to {high} {unit}", low=low, high=high, unit=about.unit)
    return None if reason is None else SPACE.join(part for part in (reason, _meant(about, number)) if part)


def _of_another_unit(about: Quantity, number: object) -> bool:
    """Whether a number is far from usual, and usual if it is read in the unit that a file has: 3 Pa for 3 bar."""
    if about.usual is None or about.units.factor == 1 or not isinstance(number, (int, float)) or not number:
        return False
    low, high = about.usual
    shown = about.units.shown(number)
    return 0 < low <= number <= high and not low / FAR <= shown <= high * FAR


def _meant(about: Quantity, number: object) -> Text:
    """What the number is in the unit of a file, and what to give if it was meant in that."""
    if isinstance(number, bool) or not _is_finite(number):
        return EMPTY
    if about.unit == "°C":
        celsius = number - ZERO_CELSIUS
        words = Text("(for {number} K give {celsius})", number=_plain(number), celsius=_plain(celsius))
        return words if number > 0 and about.allows(celsius) else EMPTY
    if about.units.factor == 1:
        return EMPTY
    shown, inside = about.units.shown(number), about.units.inside(number)
    here = Text("(in SI, as here, it is {shown} {unit}", shown=_plain(shown), unit=about.unit)
    if about.refuses(number) is not None:
        return here + ")"
    meant = Text("; for {number} {unit} give {inside})", number=_plain(number), unit=about.unit, inside=f"{inside:.6g}")
    return here + meant


def _plain(number: float) -> Amount:
    return Amount(number, form=".6g")


def _as_given(number: object) -> str:
    return f"{number:.6g}" if isinstance(number, float) else written(number)
