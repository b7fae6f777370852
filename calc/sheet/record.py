# SPDX-License-Identifier: Apache-2.0
"""`@record`: a frozen dataclass that prints itself as a table of label, value and unit.

Two records are equal only where they are the same object."""

import dataclasses
from collections.abc import Callable
from dataclasses import MISSING, FrozenInstanceError, dataclass, field, fields
from functools import cache
from typing import TYPE_CHECKING, Any, TypeVar, dataclass_transform

from . import number

T = TypeVar("T")


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    return frozen(cls)


def frozen(cls: type[T], *, kw_only: bool = False) -> type[T]:
    """What a record is.  `kw_only`: made by keywords alone."""
    cls.__doc__ = cls.__doc__ or cls.__name__  # else the library writes one from the signature, which takes long
    record_class = dataclass(repr=False, eq=False, init=False, kw_only=kw_only)(cls)
    record_class.__init__ = _Init(record_class)  # type: ignore[method-assign, assignment]
    record_class.__setattr__ = _once  # type: ignore[method-assign]
    record_class.__repr__ = number.line  # type: ignore[method-assign]
    if record_class.__str__ is object.__str__:  # a class may say more of itself
        record_class.__str__ = number.table  # type: ignore[method-assign]
    return record_class


class _Init:
    """As the library writes it, but straight into what the record holds, past `_once`: a twelfth of every solve.  And
    not before the first record of its class: half of them are never made in one run."""

    def __init__(self, cls: type) -> None:
        self.cls = cls

    def __get__(self, record: object, cls: type) -> Callable[..., None]:
        made = self.cls.__init__ = _init(self.cls)  # type: ignore[misc]
        method: Callable[..., None] = made.__get__(record, cls)
        return method


def _init(cls: type) -> Callable[..., None]:
    arguments, lines = ["_self"], ["_held = _self.__dict__"]
    names: dict[str, Any] = {"_NEW": object()}
    for f in sorted(fields(cls), key=lambda f: f.kw_only is True):
        if f.kw_only and "*" not in arguments:
            arguments.append("*")
        names |= {f"_of_{f.name}": f.default, f"_make_{f.name}": f.default_factory}
        value, default = f.name, "" if f.default is MISSING else f"=_of_{f.name}"
        if f.default_factory is not MISSING:
            value, default = f"_make_{f.name}()" + (f" if {f.name} is _NEW else {f.name}" if f.init else ""), "=_NEW"
        if f.init:
            arguments.append(f.name + default)
        lines.append(f"_held[{f.name!r}] = {value}")
    if hasattr(cls, "__post_init__"):
        lines.append("_self.__post_init__()")
    exec(f"def __init__({', '.join(arguments)}):\n  " + "\n  ".join(lines), names)
    init: Callable[..., None] = names["__init__"]
    init.__qualname__ = f"{cls.__qualname__}.__init__"
    init.__annotations__ = {f.name: f.type for f in fields(cls) if f.init} | {"return": None}
    return init


@cache
def _copied(cls: type) -> tuple[str, ...] | None:
    """The fields that make one record of another; None where more has to be done than to copy them."""
    setter: object = cls.__setattr__
    plain = setter is _once and all(f.init for f in fields(cls)) and not hasattr(cls, "__post_init__")
    return tuple(f.name for f in fields(cls)) if plain else None


if TYPE_CHECKING:
    from dataclasses import replace as replace  # of which a checker knows what may be changed
else:

    def replace(of: T, /, **changes: Any) -> T:
        """What `dataclasses.replace` does, for records in a third of the time: a solve changes some hundred of them."""
        names = _copied(type(of))
        if names is None:
            return dataclasses.replace(of, **changes)
        held = of.__dict__
        new = {name: held[name] for name in names} | changes
        if len(new) > len(names):
            raise TypeError(f"{type(of).__name__} has no {', '.join(changes.keys() - set(names))}")
        other = object.__new__(type(of))
        other.__dict__.update(new)
        return other


def _once(self: object, name: str, value: object) -> None:
    """What `frozen=True` does, which writes and compiles it anew for every class: half the time of the start."""
    known = self.__dict__  # `vars` twice is a tenth of all calls of a solve
    if name in known or name not in self.__dataclass_fields__:  # type: ignore[attr-defined]
        raise FrozenInstanceError(f"cannot change {name} of {type(self).__name__}")
    known[name] = value
