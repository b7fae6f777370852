# SPDX-License-Identifier: Apache-2.0
"""A number that knows where it came from: the recorded line of its formula, or the inputs that it is or rests on.

A `Link` says so: the `Line` of the formula that returned the number, the key of the design file that it stands under,
or several of these where a number was chosen or put together from others.  The number itself is a float (complex, int,
str, array) like any other, equal to it, shown, hashed and pickled like it; arithmetic outside of a formula gives a
plain number again.

    linked(x, link)            x with this link
    based_on(x, a, b, …)       x, found from a, b, … by a solver, a search or plain arithmetic: linked to all that they
                               are linked to
    link_of(x)                 the link; of a tuple, a dict or a record those of all that is in it; None where there is
                               none
    gathered([a, b, …])        a numpy array of numbers that keeps their links, element by element (linked_array.py)"""

from collections.abc import Callable, Iterable, Mapping
from contextvars import ContextVar
from typing import Any, Generic, Protocol, TypeVar, Union, cast

from .text import EMPTY, Text

# --- the record of a calculation: which formula was called, with what, and what came out

T = TypeVar("T")


class Equation(Protocol):
    """What a line is an evaluation of: a formula (`formula.py`, which says what these are)."""

    __name__: str
    symbol: str
    unit: str
    governs: str
    names: dict[str, str]
    parameters: tuple[str, ...]

    @property
    def function(self) -> Callable[..., object]: ...
    @property
    def source(self) -> Text: ...
    @property
    def shows(self) -> Text: ...
    @property
    def meanings(self) -> dict[str, Text]: ...
    def __hash__(self) -> int: ...


class Line:
    """One evaluation of a formula, which nothing changes.  Screen, paper and JSON render this object and nothing else.

    `about`: whose calculation this is ("front bearing", "mesh 36–39").  A line is equal to no other, whatever that one
    gave."""

    __slots__ = ("about", "arguments", "formula", "value")

    def __init__(self, formula: Equation, arguments: Mapping[str, object], value: object, about: Text = EMPTY) -> None:
        self.formula, self.arguments, self.value, self.about = formula, arguments, value, about


recorder: ContextVar[list[Line] | None] = ContextVar("recorder", default=None)
recording: ContextVar[bool] = ContextVar("recording", default=True)
subject: ContextVar[Text] = ContextVar("subject", default=EMPTY)


class _Setting(Generic[T]):
    """`with` it a variable has another value.  Written as a class, since a solve enters some 500 of them."""

    __slots__ = ("_token", "value", "variable")

    def __init__(
        self, variable: ContextVar[Any], value: T
    ) -> None:  # Any: the variable holds more types than this one value
        self.variable, self.value = variable, value

    def __enter__(self) -> T:
        self._token = self.variable.set(self.value)
        return self.value

    def __exit__(self, *error: object) -> None:
        self.variable.reset(self._token)


class _Trace:
    __slots__ = ("_token",)

    def __enter__(self) -> list[Line]:
        lines: list[Line] = []
        self._token = recorder.set(lines if recording.get() else None)
        return lines

    def __exit__(self, *error: object) -> None:
        recorder.reset(self._token)


def trace() -> _Trace:
    """Record every formula that is called inside; none where nobody wants lines (`recorded`)."""
    return _Trace()


def recorded(wanted: bool) -> _Setting[bool]:
    """Whether lines and links are wanted at all.  Without, a solve takes a fifth less, and gives the same numbers."""
    return _Setting(recording, wanted)


def untraced() -> _Setting[None]:
    """Iterations: nothing inside is recorded.  The converged call is made once more outside."""
    return _Setting(recorder, None)


def about(part: Text) -> _Setting[Text]:
    """Name the part whose lines follow: "front bearing", "mesh 36–39"."""
    return _Setting(subject, part)


# --- numbers with a link

R = TypeVar("R")
Link = Union[Line, str, "tuple[Line | str, ...]"]  # a line, the key of an input, or several


class LinkedFloat(float):
    __slots__ = ("link",)
    link: Link

    def __reduce__(self) -> tuple[object, ...]:
        return float, (float(self),)


class LinkedComplex(complex):
    __slots__ = ("link",)
    link: Link

    def __reduce__(self) -> tuple[object, ...]:
        return complex, (complex(self),)


class LinkedInt(int):  # Python allows an int no slots
    link: Link

    def __reduce__(self) -> tuple[object, ...]:
        return int, (int(self),)


class LinkedStr(str):
    """The name of an oil or a material: what it brings in comes from this key."""

    __slots__ = ("link",)
    link: Link

    def __reduce__(self) -> tuple[object, ...]:
        return str, (str.__str__(self),)


# a type → what makes a linked number of one of that type, which no annotation can say
KINDS: dict[type, Callable[..., Any]] = {float: LinkedFloat, complex: LinkedComplex, int: LinkedInt, str: LinkedStr}
KINDS |= {kind: kind for kind in KINDS.values()}  # type: ignore[misc]
UNLINKED = {float, int, str, complex, bool, type(None)}
# a linked number → the same without its link
PLAIN: dict[type, Callable[..., object]] = {LinkedFloat: float, LinkedComplex: complex}


def linked(x: T, link: Link | None) -> T:
    """The same number with a link; what cannot carry one (None, a bool, a record) as it is."""
    kind = KINDS.get(type(x))
    if kind is None:
        parts: T = tuple(linked(part, link) for part in x) if type(x) is tuple else x  # type: ignore[assignment, attr-defined]
        return parts
    if link is None:
        return x
    number: T = kind(x)
    number.link = link  # type: ignore[attr-defined]
    return number


def link_of(x: object) -> Link | None:
    """Where a number came from; of a tuple, a list, a dict or a record: all that is in it."""
    if type(x) in UNLINKED:
        return None
    known: Link | None = getattr(x, "link", None)
    if known is not None:
        return cast("Link | None", known)
    if isinstance(x, (tuple, list)):
        return joined_links(map(link_of, x))
    if isinstance(x, dict):
        return joined_links(map(link_of, x.values()))
    if hasattr(x, "__dataclass_fields__"):
        return joined_links(link_of(getattr(x, name)) for name in x.__dataclass_fields__)
    return None


def joined_links(links: Iterable[Link | None]) -> Link | None:
    """Several links as one, each once."""
    parts: dict[Line | str, None] = {}
    for link in links:
        if isinstance(link, tuple):
            for part in link:
                parts[part] = None
        elif link is not None:
            parts[link] = None
    return tuple(parts) if len(parts) > 1 else next(iter(parts), None)


def unlinked(x: T) -> T:
    """The same without links, for arithmetic on many points at once, which plain numbers do faster."""
    return cast(T, _unlinked(x))


def _unlinked(x: object) -> object:
    if type(x) in UNLINKED:
        return x
    plain = PLAIN.get(type(x))
    if plain is not None:
        return plain(x)
    if type(x) is tuple:
        return tuple(map(_unlinked, x))
    if type(x) is dict:
        return {key: _unlinked(part) for key, part in x.items()}
    if hasattr(x, "__dataclass_fields__") or getattr(x, "of_numbers", False):
        other = object.__new__(type(x))  # copy.copy takes three times as long
        other.__dict__.update({name: _unlinked(part) for name, part in x.__dict__.items()})
        return other
    return x


def based_on(x: T, *sources: object) -> T:
    """A number that a solver, a search or plain arithmetic got from these sources."""
    if not recording.get():
        return x
    number = linked(x, joined_links(map(link_of, sources)))
    # an array: element by element, where all that it was made of knows its elements
    if getattr(number, "parts", None) is not None:
        parts = [getattr(source, "parts", ()) for source in sources if link_of(source) is not None]
        if parts and all(len(part) == len(x) for part in parts):  # type: ignore[arg-type]
            number.parts = tuple(map(joined_links, zip(*parts)))  # type: ignore[attr-defined]
    return number


def converged(formula: Equation, x: T, last: Callable[[T], R], closes: Callable[[R], object]) -> R:
    """The last pass of an iteration on x, recorded: x has a line of its own, made of all that enters the pass from
    outside.

    `formula` says in words how x was found; `last` makes the pass; `closes` takes out of its result what had to agree
    with x."""
    lines = recorder.get()
    if lines is None:
        return last(x)
    entering = Entering()
    line = Line(formula, {"from": entering}, x, subject.get())
    lines.append(line)
    start = len(lines)
    result = last(linked(x, line))
    inside, outside = set(lines[start:]), dict[Line | str, None]()
    waiting, seen = [*leaves(link_of(closes(result)))], {line}
    while waiting:
        leaf = waiting.pop()
        if leaf not in inside:
            outside[leaf] = None
        elif leaf not in seen:
            seen.add(leaf)
            for argument in leaf.arguments.values():
                link = argument.link if type(argument) is LinkedFloat else link_of(argument)
                if type(link) is tuple:
                    waiting += link
                elif link is not None:
                    waiting.append(link)  # type: ignore[arg-type]
    outside.pop(line, None)
    entering.link = tuple(outside)
    return result


class Entering:
    """All that enters the last pass of an iteration: the argument of its line."""

    link: Link = ()


def leaves(link: Link | None) -> tuple[Line | str, ...]:
    """The single lines and keys of a link."""
    return () if link is None else link if isinstance(link, tuple) else (link,)
