# SPDX-License-Identifier: Apache-2.0
"""A sentence as data until it is shown: a template of the program, and the parts that stand in it.

    Text("Film at the edge, {place}", place=bearing.name)

A `Text` is its own English sentence (a `str`), so that it is compared, sorted and printed like one, and it keeps what
it was made from, so that a language can say it in its own words (`calc.locale`): the template is looked up, the parts
are put in.  A part that is a `Text` is said in the language too, a number is written as the language writes numbers,
and any other string is a name that the user or a table gave (a wheel, a bearing, a file, an oil) and is never
translated.

What is added to a Text, or joined by one, stays data.  An f-string, `replace` or `lower` makes a plain string of it,
which no language finds again; the fields that hold sentences are annotated `Text`, so that the type checker refuses
those."""

from collections.abc import Iterable, Mapping
from typing import TypeVar

from .number import DIGITS, short, sure

T = TypeVar("T", bound="Text")
Part = object  # Text, Amount, int, float, or a name (any other str)


class Amount:
    """A number in a sentence, in the shown unit: `digits` significant ones, or as `form` says (".2f", "+g")."""

    __slots__ = ("digits", "form", "number", "unit")

    def __init__(self, number: float, unit: str = "", *, digits: int = DIGITS, form: str = "") -> None:
        self.number, self.unit, self.digits, self.form = number, unit, digits, form

    def written(self) -> str:
        """The number in English, without its unit."""
        if not self.form:
            return short(self.number, self.digits)
        written = format(sure(self.number) if isinstance(self.number, float) else self.number, self.form)
        return short(self.number, self.digits) if "e" in written else written.replace("-", "−")

    def __str__(self) -> str:
        return with_unit(self.written(), self.unit)

    def __repr__(self) -> str:
        return f"Amount({self.number!r}, {self.unit!r})"


def with_unit(number: str, unit: str) -> str:
    """A number with its unit behind a space; the sign of degrees stands close."""
    return f"{number}{unit}" if unit == "°" else f"{number} {unit}" if unit else number


class Text(str):
    """`template` with `parts` put in where it names them, as an English sentence that remembers both.

    `one`: the template for a count of 1, of a Text that `plural` has made; `number` is that count.
    """

    __slots__ = ("number", "one", "parts", "template")
    template: str
    parts: Mapping[str, Part]
    one: str
    number: float

    def __new__(cls, template: str = "", /, **parts: Part) -> "Text":
        if parts:
            return _text(cls, template, parts)
        if isinstance(template, Text):
            return template
        known = WITHOUT_PARTS.get(template)
        return known if known is not None else WITHOUT_PARTS.setdefault(template, _text(cls, template, parts))

    def __reduce__(self) -> tuple[object, ...]:
        return _text, (type(self), self.template, self.parts, self.one, self.number)

    def __add__(self, other: str) -> "Text":
        if not other:
            return self
        if self:
            return _text(Text, "{a}{b}", {"a": self, "b": other})
        return other if isinstance(other, Text) else Name(other)

    def __radd__(self, other: str) -> "Text":
        return _text(Text, "{a}{b}", {"a": other, "b": self}) if other else self

    def join(self, items: Iterable[str], /) -> "Text":
        """The items, Texts or names, with this between them."""
        items = list(items)
        if len(items) == 1 and isinstance(items[0], Text):
            return items[0]
        parts: dict[str, Part] = {f"i{n}": item for n, item in enumerate(items)}
        return _text(Text, "{j}".join(f"{{{name}}}" for name in parts), parts | {"j": self})


WITHOUT_PARTS: dict[str, Text] = {}  # the Texts without parts by their templates: most are asked for again and again


def _text(cls: type[T], template: str, parts: Mapping[str, Part], singular: str = "", number: float = 0) -> T:
    form = singular if singular and number == 1 else template
    if parts:
        form = form.format_map({name: part if isinstance(part, str) else english(part) for name, part in parts.items()})
    text = str.__new__(cls, form)
    text.template, text.parts, text.one, text.number = template, parts, singular, number
    return text


def english(part: Part) -> str:
    """A part as it reads in English."""
    if isinstance(part, str):
        return part
    if isinstance(part, float):
        return short(part)
    return str(part).replace("-", "−") if isinstance(part, int) else str(part)


def plural(singular: str, many: str, /, n: float, **parts: Part) -> Text:
    """A Text that depends on a count: `plural("{n} warning", "{n} warnings", n=43)`."""
    return _text(Text, many, {"n": n, **parts}, singular, n)


class Name(Text):
    """A word that is not the program's, where a Text is wanted: it is shown as it stands, in every language."""

    __slots__ = ()

    def __new__(cls, word: str) -> "Name":
        return _text(cls, "{name}", {"name": word})


class Small(Text):
    """A label in the middle of a sentence: its first letter is small, in every language."""

    __slots__ = ()

    def __new__(cls, label: Text) -> "Small":
        small = str.__new__(cls, label[:1].lower() + label[1:])
        small.template, small.parts, small.one, small.number = label.template, label.parts, label.one, label.number
        return small

    def __reduce__(self) -> tuple[object, ...]:
        return Small, (_text(Text, self.template, self.parts, self.one, self.number),)


def listed(items: Iterable[str]) -> Text:
    """`a, b and c`."""
    return _ended(items, "{before} and {last}")


def alternatives(items: Iterable[str]) -> Text:
    """`a, b or c`."""
    return _ended(items, "{before} or {last}")


def _ended(items: Iterable[str], template: str) -> Text:
    *before, last = items
    if not before:
        return last if isinstance(last, Text) else Name(last)
    return _text(Text, template, {"before": COMMA.join(before), "last": last})


COMMA, SEMICOLON, SPACE = Text(", "), Text("; "), Text(" ")
EMPTY = Text()
