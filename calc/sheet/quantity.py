# SPDX-License-Identifier: Apache-2.0
"""What is said about a number once: its label, unit, range and help.

A field of an Inputs class is made by `quantity()` or one of its sisters, a field of a result by `value()`.  The design
file, `--set`, the form, the report and the JSON all read this one description.  An input with a `default` may be left
out: None (no tables: ()) means "choose for me"; the type checker reads the same word."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import MISSING, Field, field, fields, is_dataclass
from difflib import get_close_matches
from functools import cache
from inspect import isabstract
from typing import Any, Literal, TypedDict, TypeVar, Unpack, dataclass_transform, get_origin

from .field_help import FieldHelp
from .record import frozen, record, replace
from .text import EMPTY, SPACE, Amount, Text
from .units import UNITS, Unit

T = TypeVar("T")

# whether a repair may move an input: "free", as the maker likes; "asked", never, it is what a design asks for; else
# only where a check names it
Repair = Literal["", "free", "asked"]

REQUIRED: Any = MISSING  # no default, in place of one of any type
FLAGS = ("false", "true")  # of a flag, as it is typed
NOTHING_RENAMED: Mapping[str, str] = {}
NO_KEY_WORDS: Mapping[str, Text] = {}
# the source of a usual range that practice knows and no book behind this program states
THUMB = Text("rule of thumb, no published source")
COMMA = re.compile(r"-?\d+,\d+")  # a decimal comma, which TOML does not know
SMALLEST, LARGEST = 1e-30, 1e30  # sizes of numbers: beyond them products and squares of them are no numbers any more


@record
class ChangeWords:
    """What a change of an input is called in the words of the trade: a `less` or a `more` of a number, an `other` word.
    Inputs with the same words in one place move together."""

    less: Text = EMPTY
    more: Text = EMPTY
    other: Text = EMPTY


NO_WORDS = ChangeWords()


@record
class Where:
    """The choice of the same table with which an input says something, and its words with which it does."""

    choice: Field[Any]  # Any: the type of its default
    words: tuple[str, ...]

    def holds(self, table: Mapping[str, object]) -> bool:
        """In a table of the design file; a choice that is left out is the first of its words."""
        about: Quantity = self.choice.metadata["quantity"]
        if about.where is not None and not about.where.holds(table):
            return False  # a choice that says nothing itself
        return table.get(_key(self.choice), about.choices[0]) in self.words


@record
class Quantity:
    """The description of one input.  `kind` is one of number, integer, text, date, choice, flag, series, integers,
    names, table, tables, reasons, open."""

    kind: str
    label: Text
    unit: str = ""
    symbol: str = ""
    low: float | None = None
    high: float | None = None
    above: float | None = None  # an exclusive lower bound
    usual: tuple[float, float] | None = None
    choices: tuple[str, ...] = ()
    count: tuple[int, int] | None = None  # how many elements a series may have
    table: type | None = None
    optional: bool = False
    free: bool = False  # a date that may be any words
    negative: Text = EMPTY  # why what a negative number would mean is refused
    step: float | None = None  # the increment of shift+↑ in the form, in the shown unit
    help: Text = EMPTY
    source: Text = EMPTY  # where the usual range, or the meaning, comes from
    brief: Text = EMPTY  # what it is called where its label is longer than a line can bear
    decides: int = 0  # of the few that stand first in the form of their step, which one it is, from 1
    fold: Text = EMPTY  # the fold of the form that it lies in; that of its table, where it says nothing itself
    catalogue: str = ""  # of a text that is a name: the catalogue that has it
    repair: Repair = ""
    change: ChangeWords = NO_WORDS
    where: Where | None = None  # where it says something; None: everywhere
    taken_by: tuple[str, ...] = ()  # later steps in whose form it stands too

    @property
    def units(self) -> Unit:
        return UNITS[self.unit]

    def allows(self, x: float) -> bool:
        """Whether its ends allow a number, in the shown unit."""
        low, high, above = self.low, self.high, self.above
        return not (
            (low is not None and x < low) or (high is not None and x > high) or (above is not None and x <= above)
        )

    def refuses(self, value: object) -> Text | None:
        """Why a value as a file has it is none of these numbers; None where it is one.  Of a list: of one of its
        elements."""
        whole = self.kind in ("integer", "integers")
        if isinstance(value, bool) or not isinstance(value, (int, float)) or (whole and isinstance(value, float)):
            point = EMPTY
            if isinstance(value, str) and COMMA.fullmatch(value):
                point = Text("; write {value}", value=value.replace(",", "."))
            return Text("must be {allowed}{point}", allowed=self.allowed(), point=point)
        if abs(value) > 1e300 or value != value:
            return Text("must be {allowed}, and finite", allowed=self.allowed())
        if value and not SMALLEST <= abs(value) <= LARGEST:
            return Text("must be {allowed}, and 0 or of a size from 1e-30 to 1e30", allowed=self.allowed())
        if not self.allows(value):
            why = Text("; {negative}", negative=self.negative) if self.negative and value < 0 else EMPTY
            return Text("must be {allowed}{why}", allowed=self.allowed(), why=why)
        return None

    def allowed(self) -> Text:
        """What may stand here, in words."""
        match self.kind:
            case "choice":
                return Text("one of {choices}", choices=", ".join(f'"{c}"' for c in self.choices))
            case "flag":
                return Text("true or false")
            case "text":
                return Text("text")
            case "date":
                return Text("a date, as year-month-day: 2026-03-14")
            case "names":
                return Text("a name, or a list of names") if self.count else Text("a list of names")
            case "table":
                return Text("a table")
            case "tables":
                return Text("an array of tables")
            case "reasons":
                return Text("a table of reasons by the ids of checks")
            case "open":
                return Text("a list, or a table of keys")
        if self.kind == "integer" and self.low is not None and self.low == self.high:
            return Text("{low}", low=Amount(self.low, form="g"))
        noun = NOUNS[self.kind]
        if self.kind in ("series", "integers") and self.count is not None and self.count[0] == 1:
            noun = Text("a number, or {noun},", noun=noun)
        low, high, above = (Amount(x if x is not None else 0.0, form="g") for x in (self.low, self.high, self.above))
        bounds = [noun]
        if self.above is not None:
            bounds.append(Text("above {above}", above=above))
        if self.low is not None and self.high is not None:
            bounds.append(Text("from {low} to {high}", low=low, high=high))
        elif self.low is not None:
            bounds.append(Text("{low} or more", low=low))
        elif self.high is not None and self.above is not None:
            bounds.append(Text("and up to {high}", high=high))
        elif self.high is not None:
            bounds.append(Text("up to {high}", high=high))
        if self.unit:
            bounds.append(Text("{unit}", unit=self.unit) if len(bounds) > 1 else Text("in {unit}", unit=self.unit))
        return SPACE.join(bounds)


NOUNS = {
    "number": Text("a number"),
    "integer": Text("a whole number"),
    "series": Text("a list of numbers"),
    "integers": Text("a list of whole numbers"),
}


class _AsTheyStand(TypedDict, total=False):
    """What `Quantity` takes as it stands."""

    symbol: str
    low: float
    high: float
    above: float
    usual: tuple[float, float]
    count: tuple[int, int]
    step: float
    decides: int
    fold: Text
    catalogue: str
    repair: Repair
    taken_by: tuple[str, ...]


class Said(_AsTheyStand, total=False):
    """What may be said of an input beside its label, unit and default."""

    within: tuple[float, float]  # `low` and `high` in one
    up_to: float  # `high`, and `above` zero
    rule_of_thumb: tuple[float, float]  # `usual` by practice alone: its `source` is THUMB
    help: str
    source: str
    negative: str
    brief: str
    change: tuple[str, ...]  # (less, more), (less, more, other) or (other,)
    where: tuple[object, ...]  # (choice, word, …): a choice field above it in its class, and words of it


def _make(
    kind: str,
    label: str,
    unit: str,
    default: T,
    *,
    within: tuple[float, float] | None = None,
    up_to: float | None = None,
    rule_of_thumb: tuple[float, float] | None = None,
    help: str = "",
    source: str = "",
    negative: str = "",
    brief: str = "",
    change: tuple[str, ...] = (),
    where: tuple[object, ...] = (),
    choices: tuple[str, ...] = (),
    table: type | None = None,
    free: bool = False,
    **options: Unpack[_AsTheyStand],
) -> T:
    if within is not None:
        options["low"], options["high"] = within
    if up_to is not None:
        options["above"], options["high"] = 0, up_to
    if rule_of_thumb is not None:
        options["usual"], source = rule_of_thumb, THUMB
    what = Quantity(
        kind,
        Text(label),
        unit,
        optional=default is not MISSING,
        help=Text(help),
        source=Text(source),
        negative=Text(negative),
        brief=Text(brief),
        change=ChangeWords(other=Text(change[0])) if len(change) == 1 else ChangeWords(*map(Text, change)),
        where=_where(*where) if where else None,
        choices=choices,
        table=table,
        free=free,
        **options,
    )
    return field(default=default, kw_only=True, metadata={"quantity": what})


def _where(choice: object, *words: object) -> Where:
    if isinstance(choice, Key):  # of a class that is made
        return Where(choice.field, tuple(map(str, words)))
    assert isinstance(choice, Field), choice  # in the class that is being made
    return Where(choice, tuple(map(str, words)))


def quantity(label: str, unit: str = "", *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """A number.  Its bounds and what is usual are in the shown unit, `default` in SI."""
    return _make("number", label, unit, default, **options)


def integer(label: str, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    return _make("integer", label, "", default, **options)


def text(label: str, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    return _make("text", label, "", default, **options)


def day(label: str, *, default: T = REQUIRED, free: bool = False, **options: Unpack[Said]) -> T:
    """A date, in the Inputs class as ISO 8601 writes it.  `free`: any other words too, as old files have them."""
    return _make("date", label, "", default, free=free, **options)


def choice(label: str, *choices: str, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    return _make("choice", label, "", default, choices=choices, **options)


def flag(label: str, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """True or false."""
    return _make("flag", label, "", default, choices=FLAGS, **options)


def series(label: str, unit: str = "", *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """A list of numbers (a single number is read as a list of one)."""
    return _make("series", label, unit, default, **options)


def integers(label: str, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    return _make("integers", label, "", default, **options)


def names(label: str, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """A list of the names of elements elsewhere, which the whole design judges.  With a `count` of one or more a single
    name is read as a list of one."""
    return _make("names", label, "", default, **options)


def table(label: str, cls: type, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """A sub-table, itself an Inputs class."""
    return _make("table", label, "", default, table=cls, **options)


def tables(label: str, cls: type, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """An array of tables; its elements are addressed by their `name`, else by index."""
    return _make("tables", label, "", default, table=cls, **options)


def reasons(label: str, **options: Unpack[Said]) -> tuple[tuple[str, str], ...]:
    """A table whose keys are ids, each with a reason in words; in the Inputs class pairs of both."""
    return _make("reasons", label, "", (), **options)


def open_(label: str, *, default: T = REQUIRED, **options: Unpack[Said]) -> T:
    """A list or a table of free form, which the Inputs class itself judges; there it stands as the file has it."""
    return _make("open", label, "", default, **options)


def as_in(
    declared: object, *, default: T = REQUIRED, help: str = "", fold: Text = EMPTY, taken_by: tuple[str, ...] = ()
) -> T:
    """An input that another class declares, once more: the same but for its place in forms, `default` and what is said
    otherwise."""
    about = described(declared)
    words = Text(help) if help else about.help
    again = replace(about, optional=default is not MISSING, help=words, fold=fold, taken_by=taken_by)
    return field(default=default, kw_only=True, metadata={"quantity": again})


@record
class Key:
    """One key of an Inputs class: where it stands in the file and where in the dataclass."""

    key: str
    attribute: str
    about: Quantity
    field: Field[Any]  # Any: the type of its default


@cache
def keys(inputs: type) -> dict[str, Key]:
    """The keys of an Inputs class in their order: file key → Key.  The class itself has each by its attribute:
    `EngineInputs.bore` is the Key of `bore_mm`, as `EngineInputs(…).bore` is its number."""
    known = [f for f in fields(inputs) if "quantity" in f.metadata]
    return {_key(f): Key(_key(f), f.name, f.metadata["quantity"], f) for f in known}


def _key(f: Field[Any]) -> str:
    about: Quantity = f.metadata["quantity"]
    return f.name.rstrip("_") + about.units.suffix  # `from_`: the key may be a word of Python


def dotted(*parts: object) -> str:
    """The dotted key or id of declared fields, with the names of elements between: `dotted("shafts", "left",
    ShaftInputs.core_radius)` is "shafts.left.core_radius_mm"."""
    assert not any(isinstance(part, property) for part in parts), parts
    return ".".join([part.key if isinstance(part, (Key, ValueKey)) else str(part) for part in parts])


def described(field: object) -> Quantity:
    """What is known of a declared input: `described(BearingRow.length).step`."""
    assert isinstance(field, Key), field
    return field.about


def given(inputs: object, prefix: str, *, named: bool = False) -> Iterator[tuple[str, Quantity, Any]]:
    """The inputs of a table, and of the tables in it, that are not left out: key, description, content in SI.

    `named`: elements of arrays by their names where they have some, else by index."""
    kind: type = type(inputs)
    for key in keys(kind).values():
        content, here = getattr(inputs, key.attribute), f"{prefix}.{key.key}"
        if key.about.kind == "tables":
            for n, element in enumerate(content):
                yield from given(element, f"{here}.{(named and getattr(element, 'name', '')) or n}", named=named)
        elif content is not None and key.about.kind == "table":
            yield from given(content, here, named=named)
        elif content is not None:
            yield here, key.about, content


def unknown(key: str, known: Collection[str]) -> Text:
    """What is said of a key that is not among those that may stand there, with the nearest of them."""
    return Text("is not known") + (meant(key, known, 0.5) or Text("; known here are ") + ", ".join(known))


def meant(word: str, known: Iterable[str], alike: float = 0.6) -> Text:
    """Which of the words that are known was probably meant, behind what is said of another one; empty: none is near.
    `alike`: how near, from 0 to 1."""
    near = get_close_matches(word, list(known), 1, alike)
    return Text('; did you mean "{near}"?', near=near[0]) if near else EMPTY


# --- results


class Stands(TypedDict, total=False):
    """Where a result stands beside the tables of all results."""

    short: bool  # in its chapter of a short report
    page_one: int  # on the first page: the line among those of its step, from 1
    worst: Literal["largest", "least"]  # of several results on one line of the first page, which one stands for all
    each: bool  # with a line of the first page for each part that has one
    headline: int  # for its whole step: which one it is of those that do, from 1
    taken_by: tuple[str, ...]  # in the forms of later steps, which take it over


@record
class Described:
    """The description of one result: its label, the unit it is shown in, its symbol, the name that its field had, and
    where it stands (`Stands`)."""

    label: Text
    unit: str
    symbol: str = ""
    former: str = ""
    short: bool = False
    page_one: int = 0
    worst: Literal["largest", "least"] = "largest"
    each: bool = False
    headline: int = 0
    taken_by: tuple[str, ...] = ()


@record
class ValueKey:
    """One field of a class of results: the last part of its address, and its description.  The class has it by its
    attribute: `EngineResult.stroke`."""

    key: str
    about: Described


def declared(cls: type[T]) -> T:
    """A class of results that may hold arrays, for its fields: `declared(Order).couple_peak` is the ValueKey that
    `Order.couple_peak` is, where the type checker does not know of numbers or of arrays."""
    return cls  # type: ignore[return-value]


@record
class Stated:
    """One result whose name is known only at run time (`span_6`, `root_stress_idler`): its description and its number,
    in SI."""

    about: Described
    number: float


@record
class Group:
    """The description of a field that holds further results or a dict of them.  `spread`: its own name is left out of
    the address.  `former`: the name that it had; `renamed`: the names that the keys of a dict had.  `words`: what this
    part of an address is called; `key_words`: the same of the keys of a dict that are the program's, of a dict of dicts
    wherever they stand.

    `short`, `leads`: whether what lies in it may stand in a short report at all, and whether on its first page or for
    its step; of a dict, the keys of which it may.  `several`: the keys of the dict stand in the address only where
    there are several."""

    spread: bool
    former: str
    renamed: Mapping[str, str]
    short: bool | tuple[str, ...]
    leads: bool | tuple[str, ...]
    words: Text
    key_words: Mapping[str, Text]
    several: bool = False


@record
class Keyed:
    """The description of a field that holds a number for each key of a dict: `id`, its name in an address, with * where
    the key stands; how a key is called in the label, for {row}, and in the symbol, for *."""

    id: str
    called: Callable[[str], Text]
    sign: Callable[[str], str]

    def of(self, about: Described, key: str) -> tuple[str, Text, str]:
        """Name, label and symbol of the number of one key."""
        label = Text(about.label.template, row=self.called(key))
        return self.id.replace("*", key), label, about.symbol.replace("*", self.sign(key))


NO_GROUP = Group(False, "", NOTHING_RENAMED, True, True, EMPTY, NO_KEY_WORDS)


@record
class Published:
    """One result with its address: `shown` in its unit, `inside` the very object that the formulas returned.  `short`,
    `page_one`, `headline` are those of its description, where its place lets them.

    Two are equal that say the same; `about` is the same object only where it was not sent to another process."""

    id: str
    shown: float
    unit: str
    label: Text
    symbol: str
    inside: float
    about: Described
    former: str = ""
    short: bool = False
    page_one: int = 0
    headline: int = 0

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Published) and vars(self) | {"about": None} == vars(other) | {"about": None}

    __hash__ = None  # type: ignore[assignment]


def value(
    label: str, unit: str = "", symbol: str = "", *, default: T = REQUIRED, former: str = "", **stands: Unpack[Stands]
) -> T:
    """A field of a result, in SI; `None` means that there is no such value in this design.  `former`: the name that it
    had."""
    about = Described(Text(label), unit, symbol, former, **stands)
    return field(default=default, kw_only=True, metadata={"value": about})


def group(
    *,
    default: T = REQUIRED,
    spread: bool = False,
    former: str = "",
    renamed: Mapping[str, str] = NOTHING_RENAMED,
    short: bool | tuple[str, ...] = True,
    leads: bool | tuple[str, ...] = True,
    words: str = "",
    key_words: Mapping[str, Text] = NO_KEY_WORDS,
    named: Literal["always", "several"] = "always",
) -> T:
    """A field that holds further results or a dict of them.  `named`: when the keys of the dict stand in the address,
    always, or only where there are several."""
    about = Group(spread, former, renamed, short, leads, Text(words), key_words, named == "several")
    return field(default=default, kw_only=True, metadata={"group": about})


def values(
    label: str,
    unit: str = "",
    symbol: str = "",
    *,
    id: str,
    called: Callable[[str], Text],
    sign: Callable[[str], str],
    default: T = REQUIRED,
    **stands: Unpack[Stands],
) -> T:
    """A field with a number for each key of a dict, in SI, as of each bearing of a shaft: `id` "reaction_*"; the label
    has {row} where the key is named."""
    about = Described(Text(str(label)), unit, symbol, **stands)
    return field(default=default, kw_only=True, metadata={"value": about, "keyed": Keyed(id, called, sign)})


@dataclass_transform(
    frozen_default=True, kw_only_default=True, eq_default=False, field_specifiers=(value, values, group)
)
def result(cls: type[T]) -> type[T]:
    """A class of results: frozen, made by keywords, told apart by identity, since results hold arrays."""
    kind: type = frozen(cls, kw_only=True)
    kind.__doc__ = FieldHelp(kind.__doc__)  # type: ignore[assignment, arg-type]
    for f in fields(kind):
        if (about := f.metadata.get("value")) is not None:
            keyed: Keyed | None = f.metadata.get("keyed")
            setattr(kind, f.name, ValueKey(keyed.id.replace("*", "B") if keyed else f.name.rstrip("_"), about))
    return cls


@dataclass_transform(
    frozen_default=True,
    kw_only_default=True,
    field_specifiers=(quantity, integer, text, day, choice, flag, series, integers, names, table, tables, open_, as_in),
)
def inputs(cls: type[T]) -> type[T]:
    """A class of inputs: frozen, made by keywords, equal when all its values are (not what is cached beside them)."""
    cls.__eq__ = lambda self, other: type(self) is type(other) and given_of(self) == given_of(other)  # type: ignore[method-assign]
    kind: type = frozen(cls, kw_only=True)
    kind.__doc__ = FieldHelp(kind.__doc__)  # type: ignore[assignment, arg-type]
    names = [field.name for field in fields(kind)]

    def given_of(self: object) -> list[object]:
        mine = vars(self)
        return [mine[name] for name in names]

    for key in keys(kind).values():
        setattr(kind, key.attribute, key)
    return cls


@cache
def _shown(cls: type) -> tuple[tuple[str, Described | None, Group, Keyed | None], ...]:
    """The fields of a class of results that are shown: a value's description, or that of a group."""
    known = [f for f in fields(cls) if "value" in f.metadata or "group" in f.metadata]
    return tuple(
        (f.name, f.metadata.get("value"), f.metadata.get("group", NO_GROUP), f.metadata.get("keyed")) for f in known
    )


def results_of(content: object) -> tuple[type, ...]:
    """The classes of results that the type of a group stands for: itself, or of an abstract one those that are loaded
    and answer to it.  Of one that may hold arrays, `Order[Value]`, the class."""
    content = get_origin(content) or content
    if not isinstance(content, type):
        return ()
    found = content.__subclasses__() if isabstract(content) else [content]
    return tuple(kind for kind in found if is_dataclass(kind))


def insides(result: object) -> list[float]:
    """All values of a result as the formulas returned them, without their addresses."""
    numbers: list[float] = []
    _gather(result, numbers)
    return numbers


def _gather(result: object, numbers: list[float]) -> None:
    if isinstance(result, dict):
        for part in result.values():
            if part is not None:
                _gather(part, numbers)
    elif isinstance(result, Stated):
        numbers.append(result.number)
    else:
        kind: type = type(result)
        for name, about, _, keyed in _shown(kind):
            content = getattr(result, name)
            if content is None:
                continue
            if keyed is not None:
                numbers.extend(x for x in content.values() if x is not None)
            else:
                numbers.append(content) if about is not None else _gather(content, numbers)


def published(result: object, prefix: str, wanted: frozenset[str] = frozenset()) -> list[Published]:
    """All values of a result with their addresses, in the order in which they are declared.  `wanted`: only the values
    at these addresses; none: all."""
    found: list[Published] = []
    _inside(found, result, prefix, "", wanted, NO_GROUP, True, True)
    return found


def _inside(
    found: list[Published],
    result: object,
    prefix: str,
    formerly: str,
    wanted: frozenset[str],
    group: Group,
    short: bool,
    leads: bool,
) -> None:
    """`formerly`: the prefix that they had.  `group`: the description of the field that holds the result; `short`,
    `leads`: what those around it let them."""
    if isinstance(result, dict):
        if group.several and len(result) == 1:
            _inside(found, next(iter(result.values())), prefix, formerly, wanted, NO_GROUP, short, leads)
            return
        for name, part in result.items():
            if part is None:
                continue
            had = f"{formerly or prefix}.{group.renamed.get(name, name)}" if formerly or name in group.renamed else ""
            within = short and _lets(group.short, name), leads and _lets(group.leads, name)
            _inside(found, part, f"{prefix}.{name}", had, wanted, NO_GROUP, *within)
        return
    short, leads = short and bool(group.short), leads and bool(group.leads)
    if isinstance(result, Stated):
        if not wanted or prefix in wanted:
            found.append(_published(prefix, result.about, result.number, formerly, short, leads))
        return
    if wanted and not any(id.startswith(prefix) for id in wanted):
        return
    before = formerly or prefix
    kind: type = type(result)
    for name, about, held, keyed in _shown(kind):
        content = getattr(result, name)
        if content is None:
            continue
        if keyed is not None and about is not None:
            for part, number in content.items():
                own, label, symbol = keyed.of(about, part)
                id = f"{prefix}.{own}"
                if number is not None and (not wanted or id in wanted):
                    of_part = replace(about, label=label, symbol=symbol)
                    had = f"{formerly}.{own}" if formerly else ""
                    found.append(replace(_published(id, of_part, number, had, short, leads), about=about))
        elif about is not None:
            key = name.rstrip("_")
            id = f"{prefix}.{key}"
            if not wanted or id in wanted:
                had = f"{before}.{about.former or key}" if formerly or about.former else ""
                found.append(_published(id, about, content, had, short, leads))
        elif held.spread:
            _inside(found, content, prefix, formerly, wanted, held, short, leads)
        else:
            key = name.rstrip("_")
            had = f"{before}.{held.former or key}" if formerly or held.former else ""
            _inside(found, content, f"{prefix}.{key}", had, wanted, held, short, leads)


def _lets(which: bool | tuple[str, ...], name: str) -> bool:
    return name in which if isinstance(which, tuple) else which


def _published(id: str, about: Described, inside: float, former: str, short: bool, leads: bool) -> Published:
    unit = UNITS[about.unit]
    shown = unit.all_shown(inside) if getattr(inside, "ndim", 0) else unit.shown(float(inside))
    what = (id, shown, about.unit, about.label, about.symbol, inside, about, former)
    page_one, headline = (about.page_one, about.headline) if leads and short else (0, 0)
    return Published(*what, short and about.short, page_one, headline)
