# SPDX-License-Identifier: Apache-2.0
"""What would make a check hold, as data: new values of keys, and what they do.

The advice of a check is rendered from it."""

import json
import math
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from .quantity import keys
from .record import record, replace
from .text import EMPTY, SEMICOLON, Amount, Text, alternatives, listed

BOUNDS = {
    "": Text("{label} {value}"),
    ">=": Text("{label} at least {value}"),
    "<=": Text("{label} at most {value}"),
    "left out": Text("{label} left out"),
}


@record
class Change:
    """One key with the value that it would have, in the unit of the key; None: left out.  `words`: in the field's own
    label and unit."""

    key: str
    value: object
    words: Text


@record
class Remedy:
    """Keys that are changed together, and what that does."""

    changes: tuple[tuple[str, object], ...]
    effect: Text
    words: Text


def change(inputs: type, key: str, value: object, *, place: str = "", bound: str = "") -> Change:
    """A change of `key`, the last part of which is a field of the class `inputs`.

    `place`: the element that has the key, as the user names it.  `bound`: ">=" or "<=" where more, or less, does as
    well."""
    about = keys(inputs)[key.rpartition(".")[2]].about
    label = Text("{label} of {place}", label=Text(about.label), place=place) if place else Text(about.label)
    template = BOUNDS["left out" if value is None else bound].template
    return Change(key, value, Text(template, label=label, value=_written(value, about.unit)))


def _written(value: object, unit: str) -> Text | Amount:
    if isinstance(value, (list, tuple)):
        values = SEMICOLON.join(Text("{x}", x=Amount(x, digits=6)) for x in value)
        return Text("[{values}] {unit}", values=values, unit=unit)
    return Amount(value, unit, digits=6) if isinstance(value, (int, float)) else Text("{value}", value=str(value))


def remedy(*changes: Change, effect: Text = EMPTY) -> Remedy:
    """All of the changes at once."""
    words = listed([change.words for change in changes])
    if effect:
        words = Text("{change} ({effect})", change=words, effect=effect)
    return Remedy(tuple((change.key, change.value) for change in changes), effect, words)


def sentence(remedies: tuple[Remedy, ...], *, verified: bool = True) -> Text:
    """Each of them would do; `verified`: for good, and not only by what is taken for an input that is not given."""
    if not remedies:
        return EMPTY
    ways = alternatives([way.words for way in remedies])
    return Text("To pass: {ways}." if verified else "To hold as taken: {ways}; give the rest as well.", ways=ways)


def by_key(
    inputs: type, key: str, value: object, *, place: str = "", bound: str = "", effect: Text = EMPTY
) -> Callable[[], tuple[Remedy, ...]]:
    """What makes the remedy of one key, when it is wanted."""
    return lambda: (remedy(change(inputs, key, value, place=place, bound=bound), effect=effect),)


def down(length: float) -> float:
    """A length [m] in mm, to 0.01 mm below."""
    return math.floor(length * 1e5 + 1e-6) / 1e2


def up(length: float) -> float:
    """A length [m] in mm, to 0.01 mm above."""
    return math.ceil(length * 1e5 - 1e-6) / 1e2


def up_um(length: float) -> int:
    """A length [m] in µm, to 1 µm above."""
    return math.ceil(length * 1e6 - 1e-6)


# --- changes of a design as data
# The new value of each key, in the unit of the file; None leaves the key out.

T = TypeVar("T")

Changes = dict[str, Any]  # numbers, words, lists: as many types as keys have


def digits(number: float, figures: int = 9) -> float:
    """A number as it is written into a file, without the digits that a conversion of units makes."""
    return float(f"{number:.{figures}g}")


def whole(number: float) -> float | int:
    """Six digits, and a whole number without a decimal point."""
    number = digits(number, 6)
    return int(number) if number == int(number) else number


def assignment(key: str, value: object) -> str:
    """KEY=VALUE, as `--set` takes it: VALUE as in TOML, empty where the key goes."""
    if value is None:
        return f"{key}="
    if isinstance(value, (list, tuple)):
        return f"{key}=[{', '.join(assignment('', element)[1:] for element in value)}]"
    if isinstance(value, (str, bool)):
        return f"{key}={json.dumps(value, ensure_ascii=False)}"
    return f"{key}={value!r}"


def assignments(changes: Mapping[str, object]) -> list[str]:
    return [assignment(key, value) for key, value in changes.items()]


def applied(inputs: T, changes: Mapping[str, object], prefix: str = "") -> T:
    """An Inputs record with numbers, words and sub-tables changed, as if its file had been; `prefix`: its own key with
    a dot behind."""
    cls: type = type(inputs)
    known, changed = keys(cls), dict[str, object]()
    for key, value in changes.items():
        head, _, rest = key.removeprefix(prefix).partition(".")
        entry = known[head]
        here = changed.get(entry.attribute, getattr(inputs, entry.attribute))
        if rest:
            changed[entry.attribute] = applied(here, {rest: value})
        elif entry.about.kind == "series" and isinstance(value, (list, tuple)):
            changed[entry.attribute] = tuple(entry.about.units.inside(number) for number in value)
        else:
            changed[entry.attribute] = entry.about.units.inside(value) if isinstance(value, (int, float)) else value
    return replace(inputs, **changed)  # type: ignore[type-var]
