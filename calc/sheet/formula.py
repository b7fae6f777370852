# SPDX-License-Identifier: Apache-2.0
"""`@formula`: one numbered equation of a source as one small pure function.

    @formula("p", "ISO 7902-1:2020, 4.2; specific load", unit="MPa")
    def specific_load(F: Newton, d: Metre, l: Metre) -> Pascal:
        return F / (d * l)

Calling it returns the plain number, or the array.  Inside `with trace()` the call is recorded as well; how it is rendered from
its own return expression stands in `expression.py`, which nothing needs before something is shown.
"""

from collections.abc import Callable
from typing import Any, Generic, ParamSpec, TypeVar

from .trace import Line, recorder, subject

P = ParamSpec("P")
R = TypeVar("R")


class Formula(Generic[P, R]):
    """A formula with its symbol and source.  `shows` stands for an algorithm that has no closed expression.

    `governs` says which element of an array is the one to show: "max" (of the modulus), "min", "last".
    `unit` is the unit in which the result is shown; left out, that of the return annotation.
    """

    def __init__(
        self, function: Callable[P, R], symbol: str, source: str, shows: str, unit: str, governs: str, names: dict[str, str]
    ) -> None:
        self.function, self.symbol, self.source, self.shows = function, symbol, source, shows
        self.unit, self.governs, self.names = unit, governs, names
        code = function.__code__
        self.parameters = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        self.__doc__, self.__name__ = function.__doc__, function.__name__

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R:
        value = self.function(*args, **kwargs)
        if (lines := recorder.get()) is not None:  # written out here: this is called a thousand times for one design
            given = {**dict(zip(self.parameters, args)), **kwargs} if args else kwargs
            lines.append(Line(self, given, value, subject.get()))
        return value

    def __repr__(self) -> str:
        return f"<formula {self.symbol}: {self.source}>"


FORMULAS: dict[str, Formula[..., Any]] = {}  # every formula of the program: "module.function" → formula


def formula(
    symbol: str, source: str, *, shows: str = "", unit: str = "", governs: str = "max", names: dict[str, str] | None = None
) -> Callable[[Callable[P, R]], Formula[P, R]]:
    """Make a function a formula.  Raises ValueError at import where symbol or source is missing.

    `names` gives a parameter another symbol than its own name (`{"eps": "ε"}` is not needed: Greek names are known).
    """
    if not symbol.strip() or len(source.strip()) < 8:
        raise ValueError(f"formula {symbol!r}: a formula needs a symbol and a source (author or standard, year, clause)")

    def decorate(function: Callable[P, R]) -> Formula[P, R]:
        made = Formula(function, symbol, source, shows, unit, governs, names or {})
        FORMULAS[f"{function.__module__}.{function.__name__}"] = made
        return made

    return decorate


__all__ = ["FORMULAS", "Formula", "Line", "formula"]
