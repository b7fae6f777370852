# SPDX-License-Identifier: Apache-2.0
"""`@record`: a frozen dataclass that prints itself as a table of label, value and unit.

Two records are equal only where they are the same object."""

from dataclasses import FrozenInstanceError, dataclass, field
from typing import TypeVar, dataclass_transform

from . import number

T = TypeVar("T")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    return frozen(cls)


def frozen(cls: type[T], *, kw_only: bool = False) -> type[T]:
    """What a record is.  `kw_only`: made by keywords alone."""
    cls.__doc__ = cls.__doc__ or cls.__name__  # else the library writes one from the signature, which takes long
    record_class = dataclass(repr=False, eq=False, kw_only=kw_only)(cls)
    record_class.__setattr__ = _once  # type: ignore[method-assign]
    record_class.__repr__ = number.line  # type: ignore[method-assign]
    if record_class.__str__ is object.__str__:  # a class may say more of itself
        record_class.__str__ = number.table  # type: ignore[method-assign]
    return record_class


def _once(self: object, name: str, value: object) -> None:
    """What `frozen=True` does, which writes and compiles it anew for every class: half the time of the start."""
    known = self.__dict__  # `vars` twice is a tenth of all calls of a solve
    if name in known or name not in self.__dataclass_fields__:  # type: ignore[attr-defined]
        raise FrozenInstanceError(f"cannot change {name} of {type(self).__name__}")
    known[name] = value
