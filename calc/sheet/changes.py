# SPDX-License-Identifier: Apache-2.0
"""Changes of a design as data: the new value of each key, in the unit of the file; None leaves the key out."""

import json
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeVar

from .quantity import keys

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
        return f"{key}=[{', '.join(assignment('', one)[1:] for one in value)}]"
    return f"{key}={json.dumps(value, ensure_ascii=False)}" if isinstance(value, str) else f"{key}={value!r}"


def assignments(changes: Mapping[str, object]) -> list[str]:
    return [assignment(key, value) for key, value in changes.items()]


def applied(inputs: T, changes: Mapping[str, object], prefix: str = "") -> T:
    """An Inputs record with numbers, words and sub-tables changed, as if its file had been; `prefix`: its own key with a dot behind."""
    cls: type = type(inputs)
    known, made = keys(cls), dict[str, object]()
    for key, value in changes.items():
        head, _, rest = key.removeprefix(prefix).partition(".")
        one = known[head]
        here = made.get(one.attribute, getattr(inputs, one.attribute))
        if rest:
            made[one.attribute] = applied(here, {rest: value})
        else:
            made[one.attribute] = one.about.units.inside(value) if isinstance(value, (int, float)) else value
    return replace(inputs, **made)  # type: ignore[type-var]
