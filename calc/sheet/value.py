# SPDX-License-Identifier: Apache-2.0
"""A number that knows where it came from.

A `Link` says so: the `Line` of the formula that returned the number, the key of the design file that it stands under, or several of
these where a number was chosen or put together from others.  The number itself is a float (complex, int, str, array) like any other,
equal to it, shown, hashed and pickled like it; arithmetic outside of a formula gives a plain number again.

    linked(x, link)            x with this link
    based_on(x, a, b, …)       x, found from a, b, … by a solver, a search or plain arithmetic: linked to all that they are linked to
    link_of(x)                 the link; of a tuple, a dict or a record those of all that is in it; None where there is none
    gathered([a, b, …])        a numpy array of numbers that keeps their links, element by element (in linked_array.py)
"""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar, Union, cast

from .trace import Equation, Line, recorder, recording, subject

T = TypeVar("T")
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
PLAIN: dict[type, Callable[..., object]] = {LinkedFloat: float, LinkedComplex: complex}  # a linked number → the same without its link


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
            for one in link:
                parts[one] = None
        elif link is not None:
            parts[link] = None
    return tuple(parts) if len(parts) > 1 else next(iter(parts), None)


def unlinked(x: T) -> T:
    """The same without links, for arithmetic on many points at once, which plain numbers do faster."""
    return cast(T, _unlinked(x))


def _unlinked(x: object) -> object:
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
    if getattr(number, "parts", None) is not None:  # an array: element by element, where all that it was made of knows its elements
        parts = [getattr(source, "parts", ()) for source in sources if link_of(source) is not None]
        if parts and all(len(one) == len(x) for one in parts):  # type: ignore[arg-type]
            number.parts = tuple(map(joined_links, zip(*parts)))  # type: ignore[attr-defined]
    return number


def converged(formula: Equation, x: T, last: Callable[[T], R], closes: Callable[[R], object]) -> R:
    """The last pass of an iteration on x, recorded: x has a line of its own, made of all that enters the pass from outside.

    `formula` says in words how x was found; `last` makes the pass; `closes` takes out of its result what had to agree with x.
    """
    lines = recorder.get()
    if lines is None:
        return last(x)
    entering = Entering()
    own = Line(formula, {"from": entering}, x, subject.get())
    lines.append(own)
    start = len(lines)
    result = last(linked(x, own))
    inside, outside = set(lines[start:]), dict[Line | str, None]()
    waiting, seen = [*leaves(link_of(closes(result)))], {own}
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
    outside.pop(own, None)
    entering.link = tuple(outside)
    return result


class Entering:
    """All that enters the last pass of an iteration: the argument of its line."""

    link: Link = ()


def leaves(link: Link | None) -> tuple[Line | str, ...]:
    """The single lines and keys of a link."""
    return () if link is None else link if isinstance(link, tuple) else (link,)
