# SPDX-License-Identifier: Apache-2.0
"""Results whose names are known only at run time: `span_6` has the number of teeth in it, `root_stress_central` the wheel's name."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cache
from typing import Any

from ..sheet.quantity import Described, value


class Named:
    """A group of such values; each is an attribute, described like any field of a result."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Named) and vars(self) == vars(other)

    def __hash__(self) -> int:
        return hash(tuple(vars(self).items()))

    def __reduce__(self) -> tuple[Any, ...]:
        about = {f.name: f.metadata["value"] for f in fields(self)}  # type: ignore[arg-type]
        return named, ({name: (about[name], number) for name, number in vars(self).items()},)


@cache
def _kind(about: tuple[tuple[str, Described], ...]) -> type[Named]:
    body = {name: value(a.label, a.unit, a.symbol, default=None) for name, a in about}
    kind = type("Named", (Named,), {"__doc__": Named.__doc__, "__annotations__": {name: float for name, _ in about}, **body})
    return dataclass(init=False, repr=False, eq=False)(kind)


def named(values: Mapping[str, tuple[Described, float | None]]) -> Named:
    """A group from name → (description, number in SI); a number that is None is left out."""
    given = {name: (about, number) for name, (about, number) in values.items() if number is not None}
    group = _kind(tuple((name, about) for name, (about, _) in given.items()))()
    vars(group).update({name: number for name, (_, number) in given.items()})
    return group
