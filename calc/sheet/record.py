# SPDX-License-Identifier: Apache-2.0
"""`@record`: a frozen dataclass whose methods are shared.

The standard library compiles six methods for every frozen dataclass, 1.4 ms a class: a third of the start-up of a
program with eighty. `fields`, `replace` and `is_dataclass` work as ever; two records are equal only where they are the
same object.  A record prints itself as a table of label, value and unit; a keyword that it does not know is named in
the error, with the nearest that it knows."""

from collections.abc import Callable, Container, Iterable
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field
from typing import TypeVar, dataclass_transform

from . import number

T = TypeVar("T")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    # else the library writes one from the signature, half a millisecond a class
    cls.__doc__ = cls.__doc__ or cls.__name__
    record_class = dataclass(init=False, repr=False, eq=False)(cls)
    record_class.__init__ = _init(record_class.__dataclass_fields__)  # type: ignore[attr-defined, method-assign]
    record_class.__setattr__ = record_class.__delattr__ = _refuse  # type: ignore[method-assign]
    record_class.__repr__ = number.line  # type: ignore[method-assign]
    if record_class.__str__ is object.__str__:  # a class may say more of itself
        record_class.__str__ = number.table  # type: ignore[method-assign]
    return record_class


def _init(fields: dict[str, Field[object]]) -> Callable[..., None]:
    """The `__init__` of a record with these fields, written for speed: a solve makes 1,500 records."""
    known, names, put = tuple(fields), frozenset(fields), object.__setattr__
    defaults = {name: f.default for name, f in fields.items() if f.default is not MISSING}
    factories = {name: f.default_factory for name, f in fields.items() if f.default_factory is not MISSING}

    def __init__(self: object, *placed: object, **given: object) -> None:
        if placed:
            first = dict(zip(known, placed))
            if len(placed) > len(known) or not first.keys().isdisjoint(given):
                raise TypeError(
                    f"{type(self).__name__}: too many values, or one of them twice; it takes {', '.join(known)}"
                )
            given = first | given if given else first
        values = given if len(given) == len(known) else defaults | given
        for name, make in factories.items():
            if name not in values:
                values[name] = make()
        if values.keys() != names:
            raise TypeError(f"{type(self).__name__}: {_wrong(given, values, list(known))}")
        put(self, "__dict__", values)

    return __init__


def _wrong(given: Iterable[str], values: Container[str], known: list[str]) -> str:
    """Which keyword is unknown, and which was meant; else which one is missing."""
    from difflib import get_close_matches

    unknown = next((name for name in given if name not in known), None)
    if unknown is None:
        return f'"{next(name for name in known if name not in values)}" is missing'
    near = get_close_matches(unknown, known, 1)
    return f'unknown "{unknown}"; ' + (f'did you mean "{near[0]}"?' if near else f"it takes {', '.join(known)}")


def _refuse(self: object, name: str, value: object = None) -> None:
    raise FrozenInstanceError(f"cannot change {name} of {type(self).__name__}")
