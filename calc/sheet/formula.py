# SPDX-License-Identifier: Apache-2.0
"""`@formula`: one numbered equation of a source as one small pure function.

    @formula("p", "ISO 7902-1:2020, 4.2; specific load", unit="MPa")
    def specific_load(F: Newton, d: Metre, l: Metre) -> Pascal:
        return F / (d * l)

Calling it returns the number, or the array.  `help(specific_load)` shows its signature with units, its expression, its
source and what its docstring adds, an example above all.  Inside `with trace()` the call is recorded as well, and what
it returns is linked to the recorded line (`value.py`).  How a line is rendered from its own return expression stands in
`expression.py`, which nothing needs before something is shown."""

import ast
import inspect
import linecache
import textwrap
from collections.abc import Callable
from functools import cache
from threading import Lock
from typing import TYPE_CHECKING, Any, Generic, ParamSpec, TypeVar, get_type_hints, overload

from .text import Text
from .value import Equation, Line, LinkedFloat, linked, recorder, subject

if TYPE_CHECKING:
    from .arrays import AnyNumbers, Array, ComplexArray

P = ParamSpec("P")
R = TypeVar("R", covariant=True)
new = object.__new__


class _Help:
    """The docstring: of the class its own, of a formula what `help` shows of it."""

    def __init__(self, of_class: str) -> None:
        self.of_class = of_class

    def __get__(self, formula: "Formula[..., object] | None", owner: type) -> str:
        return self.of_class if formula is None else described(formula)


class Formula(Generic[P, R]):
    """A formula with its symbol and source.  `shows` stands for an algorithm that has no closed expression.

    `governs` says which element of an array is the one to show: "max" (of the modulus), "min", "last".
    `unit` is the unit in which the result is shown; left out, that of the return annotation.
    """

    __doc__ = _Help(__doc__)
    __name__: str

    def __init__(
        self,
        function: Callable[P, R],
        symbol: str,
        source: str,
        shows: str,
        unit: str,
        governs: str,
        names: dict[str, str],
        meanings: dict[str, str],
    ) -> None:
        self.function, self.symbol, self._source, self._shows = function, symbol, source, shows
        self.unit, self.governs, self.names, self._meanings = unit, governs, names, meanings
        code = function.__code__
        self.parameters = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        self.__wrapped__ = function  # what inspect.signature and doctest follow
        self.__name__, self.__module__ = function.__name__, function.__module__

    @property
    def source(self) -> Text:
        return Text(self._source)

    @property
    def shows(self) -> Text:
        return Text(self._shows)

    @property
    def meanings(self) -> dict[str, Text]:
        return {name: Text(words) for name, words in self._meanings.items()}

    # What its annotations do not allow: with arrays in place of numbers a formula gives an array; with plain numbers
    # (a name is misspelt, one is missing) nothing that anybody could use.
    @overload
    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R: ...
    @overload
    def __call__(self, *args: complex, **kwargs: complex) -> None: ...  # type: ignore[overload-overlap]  # on purpose
    @overload
    def __call__(self: "Formula[..., float]", *args: "AnyNumbers", **kwargs: "AnyNumbers") -> "Array": ...
    @overload
    def __call__(self: "Formula[..., complex]", *args: "AnyNumbers", **kwargs: "AnyNumbers") -> "ComplexArray": ...
    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        value = self.function(*args, **kwargs)
        if (lines := recorder.get()) is not None:  # written out here: this is called ten thousand times for one design
            given = kwargs
            if args:
                given = dict(zip(self.parameters, args))
                if kwargs:
                    given |= kwargs
            line = new(Line)
            line.formula, line.arguments, line.value, line.about = self, given, value, subject.get()
            lines.append(line)
            plain: object = value
            if type(plain) is float:  # as nearly all of them
                number = LinkedFloat(plain)
                number.link = line
                return number
            return linked(value, line)
        return value

    def __reduce__(self) -> str:
        """Sent to another process by its name, as a function is."""
        return self.__name__

    def __repr__(self) -> str:
        return f"<formula {self.symbol}: {self.source}>"


@cache
def units(formula: Equation) -> dict[str, str]:
    """The unit of each argument, and of the result under "return", from the annotations."""
    hints = get_type_hints(formula.function, include_extras=True)
    return {name: hint.__metadata__[0] if hasattr(hint, "__metadata__") else "" for name, hint in hints.items()}


def described(formula: Equation) -> str:
    """What `help` shows: call and result with their units in SI ("-": none), the expression or the algorithm, the
    source, the docstring."""
    known = {name: unit or "-" for name, unit in units(formula).items()}
    arguments = ", ".join(f"{name}: {known.get(name, '-')}" for name in formula.parameters)
    shown = f"   (shown in {formula.unit})" if formula.unit else ""
    head = f"{formula.__name__}({arguments}) -> {known.get('return', '-')}{shown}"
    body = f"{formula.symbol} = {formula.shows or _returned(formula.function)}"
    doc = inspect.cleandoc(formula.function.__doc__ or "")
    return "\n\n".join(filter(None, (head, body, f"Source: {formula.source}", doc)))


def _returned(function: Callable[..., object]) -> str:
    """The return expression of a function on one line; dots where its source text is not at hand."""
    parsed = definition(function)
    last = parsed.body[-1] if parsed is not None else None
    return ast.unparse(last.value) if isinstance(last, ast.Return) and last.value else "…"


ONE_AT_A_TIME = Lock()  # two threads that parse at once end in a SystemError of Python 3.11 (gh-106905)


def definition(function: Callable[..., object]) -> ast.FunctionDef | None:
    """The source of a function, parsed; None where it is not at hand.

    At the top of a module a function ends where the next line begins at its left; that is found ten times as quickly as
    by `inspect`."""
    code = function.__code__
    rows = linecache.getlines(code.co_filename, function.__globals__)[code.co_firstlineno - 1 :]
    if rows and not rows[0][0].isspace():
        start = next((n for n, row in enumerate(rows) if row.startswith("def ")), 0)
        end = next((n for n, row in enumerate(rows[start + 1 :], start + 1) if row[0] not in " \t\n)"), len(rows))
        source = "".join(rows[:end])
    else:
        try:
            source = textwrap.dedent(inspect.getsource(function))
        except (OSError, TypeError):
            return None
    with ONE_AT_A_TIME:
        parsed = ast.parse(source).body[0]
    assert isinstance(parsed, ast.FunctionDef)
    return parsed


FORMULAS: dict[str, Formula[..., object]] = {}  # every formula of the program: "module.function" → formula


def formula(
    symbol: str,
    source: str,
    *,
    shows: str = "",
    unit: str = "",
    governs: str = "max",
    names: dict[str, str] | None = None,
    meanings: dict[str, str] | None = None,
) -> Callable[[Callable[P, R]], Formula[P, R]]:
    """Make a function a formula.  Raises ValueError at import where symbol or source is missing.

    `names` gives a parameter another symbol than its own name (`{"eps": "ε"}` is not needed: Greek names are known).
    `meanings` says what a parameter is that is neither an input nor what another formula gives, a number of a table,
    and under "return" what the formula gives, where its source says something else of it.
    """
    if not symbol.strip() or len(source.strip()) < 8:
        needs = "a formula needs a symbol and a source (author or standard, year, clause)"
        raise ValueError(f"formula {symbol!r}: {needs}")

    def decorate(function: "Callable[P, R]") -> "Formula[P, R]":  # as words: a thousand times evaluated they take 5 ms
        decorated = Formula(function, symbol, source, shows, unit, governs, names or {}, meanings or {})
        FORMULAS[f"{function.__module__}.{function.__name__}"] = decorated
        return decorated

    return decorate
