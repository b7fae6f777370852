# SPDX-License-Identifier: Apache-2.0
"""Dotted keys of a design: where one stands in the tables of a file, what is known of it, what it is called, and how a
value is put there."""

import re
import tomllib
from collections.abc import Iterable, Iterator
from typing import Any

from ..countershaft.inputs import OWN, TWIN, ShaftInputs
from ..countershaft.rows import IN_WORDS, OF_ORIGINAL, BearingRow, of_new_kind, titled
from ..gears.inputs import GearsInputs
from ..imbalance.inputs import ImbalanceInputs
from ..sheet.errors import BadInput, InputError
from ..sheet.errors import written as written
from ..sheet.quantity import Key, Quantity, described, dotted, keys, unknown
from ..sheet.step import Step
from ..sheet.text import Name, Small, Text
from .model import SCREENED, STEPS, Design, step_of
from .upgrade import MANY, current, formerly, is_twin, place_in, without

NAME = re.compile(r"[A-Za-z0-9-]+\Z")
Table = dict[str, object]  # of a TOML document; what stands under a key is narrowed where it is read


def address(data: Table, key: str, whole: bool = False) -> tuple[str | int, ...]:
    """Where a dotted key, which may be one of schema 1, stands in the data: elements of arrays by name, else by index.
    Raises BadInput with the nearest key.

    With `whole` the key may be that of a table, which else has to be one of a value in it.
    """
    path: list[str | int] = []
    here: object = with_row(data, key, others=True)
    cls: type | None = Design
    parts = current(data, key).split(".")
    for i, part in enumerate(parts):
        if isinstance(here, list):
            index = _element(here, part, key)
            path.append(index)
            here = here[index]
            continue
        if isinstance(here, tuple):  # a list of numbers, by place
            path.append(_number(here, parts[i:], key))
            break
        about = _quantity(cls, parts[: i + 1], key)
        path.append(part)
        cls = about.table
        if about.kind in ("reasons", "open"):
            rest = ".".join(parts[i + 1 :])  # an id, which has dots of its own
            if not rest and not whole and about.kind == "reasons":
                raise _no_such(key, Text("is a table; name one of its keys: ") + "bearings.front.mckee")
            return (*path, rest) if rest else tuple(path)
        here = here.get(part, [] if about.kind == "tables" else {}) if isinstance(here, dict) else {}
        if about.kind in ("series", "integers") and isinstance(here, list):
            here = tuple(here)
    if cls is not None and not whole:
        raise _no_such(key, Text("is a table; name one of its keys: ") + ", ".join(keys(cls)))
    return tuple(path)


def every(data: Table, key: str) -> list[str]:
    """The keys that one with a * among its parts stands for: those of all elements of that array, of shafts without
    the mirror images, which have what they mirror; any other key alone.  Raises BadInput where nothing matches."""
    before, star, after = key.partition(".*.")
    if not star:
        return [key]
    before, _, after = current(data, key).partition(".*.")  # one of schema 1 has moved
    here: object = data
    for part in address(data, before, whole=True):
        here = here[part] if isinstance(here, list) and isinstance(part, int) else as_table(here).get(str(part))
    items = [as_table(item) for item in here] if isinstance(here, list) else []
    of_own = before == dotted(Design.shafts) and after.partition(".")[0] not in map(dotted, OWN)
    names = [str(item.get("name", n)) for n, item in enumerate(items) if not (of_own and is_twin(item))]
    names = rows_of_twin(data, before) or names
    if not names:
        raise _no_such(key, Text("nothing stands where the * is"))
    return [each for name in names for each in every(data, f"{before}.{name}.{after}")]


def _rows_of_original(data: Table, twin: Table) -> list[str]:
    of = twin.get(dotted(ShaftInputs.mirrors), twin.get(dotted(ShaftInputs.repeats)))
    shafts = map(as_table, as_list(data.get(dotted(Design.shafts))))
    original = next((shaft for shaft in shafts if shaft.get("name") == of), {})
    return [str(as_table(row).get("name", "")) for row in as_list(original.get(dotted(ShaftInputs.bearings)))]


def rows_of_twin(data: Table, key: str) -> list[str]:
    """The names of all bearings that a twin may say something of, where a key is that of its bearings."""
    shafts, _, rest = key.partition(".")
    name, _, array = rest.partition(".")
    if shafts != dotted(Design.shafts) or array != dotted(ShaftInputs.bearings):
        return []
    there = list(map(as_table, as_list(data.get(shafts))))
    twin = next((s for n, s in enumerate(there) if name in (s.get("name"), str(n))), {})
    return _rows_of_original(data, twin) if is_twin(twin) else []


def with_row(data: Table, key: str, *, others: bool = False) -> Table:
    """The tables in which a twin has a row for its bearing that a key is of, so that something can be said of it;
    `others`: for all of its bearings (`rows_of`)."""
    array, _, rest = key.rpartition(f".{dotted(ShaftInputs.bearings)}.")
    name, array = rest.partition(".")[0], dotted(array, ShaftInputs.bearings)
    if name not in rows_of_twin(data, array):
        return data
    where = address(data, array, whole=True)
    rows = as_list(value_at(data, array, whole=True))
    there = [as_table(row).get("name") for row in rows]
    if name in there and not others:
        return data
    return changed(data, where, rows_of(data, array, rows) if others else [*rows, {"name": name}])


def rows_of(data: Table, key: str, there: list[object]) -> list[object]:
    """The bearings of a shaft as a form has them, `key` that of their array: of a twin those that it says something of,
    and behind them the others of its original, each with a name alone."""
    said = [as_table(row).get("name") for row in there]
    return [*there, *({"name": name} for name in rows_of_twin(data, key) if name not in said)]


def by_names(data: Table, key: str) -> str:
    """A key with elements of arrays by index as one in which they go by their names, where they have one of their
    own."""
    parts: list[str] = []
    here: object = data
    for part in key.split("."):
        items = here
        if isinstance(items, list):
            here = items[int(part)] if part.isdigit() and int(part) < len(items) else None
            names = [as_table(item).get("name") for item in items]
            name = as_table(here).get("name")
            own = isinstance(name, str) and NAME.match(name) is not None and names.count(name) == 1
            parts.append(str(name) if own else part)
        else:
            here = as_table(here).get(part)
            parts.append(part)
    return ".".join(parts)


def _mesh(item: object) -> str | None:
    """What the values of a mesh are called by; None of any other table."""
    table = as_table(item)
    driver, driven = table.get("driver"), table.get("driven")
    return f"{driver}_{driven}" if "name" not in table and driver is not None and driven is not None else None


def _element(tables: list[object], part: str, key: str) -> int:
    """The index of the table that has this name, or this place; a mesh is called by its wheels, as in its values."""
    called = [
        (n, item.get(key)) for key in ("name", "former_name") for n, item in enumerate(tables) if isinstance(item, dict)
    ]
    called += [(n, _mesh(item)) for n, item in enumerate(tables)]
    index = next((n for n, name in called if name == part), place_in(part, len(tables)))
    if index is None:
        every = enumerate(tables)
        names = ", ".join(str(item.get("name", _mesh(item) or n)) for n, item in every if isinstance(item, dict))
        raise _no_such(key, Text('there is no element "{part}"; there are {names}', part=part, names=names or "none"))
    return index


def _number(numbers: tuple[object, ...], rest: list[str], key: str) -> int:
    """The index of a number, which is where its key ends."""
    index = place_in(rest[0], len(numbers))
    if index is None or len(rest) > 1:
        counts = dict(count=len(numbers), count2=len(numbers) - 1)
        raise _no_such(key, Text("has {count} numbers; name one by its place, from 0 to {count2}", **counts))
    return index


def _quantity(cls: type | None, parts: list[str], key: str) -> Quantity:
    """What a table's class knows of the last part; no class: what stands before is a number, or a word."""
    known = keys(cls) if cls is not None else {}
    if parts[-1] not in known:
        reason = unknown(parts[-1], known) if known else Text('"{parts}" has no parts', parts=".".join(parts[:-1]))
        reason = getattr(cls, "REFUSED", {}).get(parts[-1], reason)
        raise _no_such(key, reason)
    return known[parts[-1]].about


def quantity_of(data: Table, key: str) -> Quantity:
    """The description of the quantity at a dotted key."""
    if key in MANY:
        return MANY[key]
    about = declared(address(data, every(data, key)[0]))
    assert about is not None
    return about


def declared(path: Iterable[str | int]) -> Quantity | None:
    """The description of what is at a path; of elements neither place nor name matters, nor whether they are there."""
    cls: type = Design
    about: Quantity | None = None
    for part in path:
        if isinstance(part, str) and part in keys(cls):
            about = keys(cls)[part].about
            cls = about.table or cls
    return about


def value_at(data: Table, key: str, whole: bool = False) -> object:
    """The value at a dotted key as it stands in the file, None where it is left out; with `whole` a table too.

    With a * in the key: what stands at all of its keys, None where it differs."""
    if key in MANY:
        return formerly(data, key)
    first, *others = every(data, key)
    if others:
        value = value_at(data, first, whole)
        return value if all(value_at(data, other, whole) == value for other in others) else None
    here: object = data
    for part in address(data, first, whole):
        if isinstance(here, list) and isinstance(part, int):
            here = here[part] if part < len(here) else None  # a bearing of which a twin says nothing
        else:
            here = here.get(part) if isinstance(here, dict) else None
    return here


def as_table(content: object) -> Table:
    """What stands in a document as a table, an empty one where there is none."""
    return content if isinstance(content, dict) else {}


def as_list(content: object) -> list[object]:
    """What stands in a document as a list: of one, where it is a number or a word alone; empty where there is
    nothing."""
    return content if isinstance(content, list) else [] if content is None else [content]


def changed(data: Table, where: tuple[str | int, ...], value: object) -> Table:
    """The same nested tables with one place changed; nothing is changed in place.  None takes the key out."""
    return as_table(_changed(data, where, value))


def _changed(here: object, where: tuple[str | int, ...], value: object) -> object:
    if not where:
        return value
    first, rest = where[0], where[1:]
    if isinstance(here, list):
        if not rest and value is None:
            return [item for n, item in enumerate(here) if n != first]
        return [_changed(item, rest, value) if n == first else item for n, item in enumerate(here)]
    table = dict(as_table(here))
    if rest or value is not None:
        table[str(first)] = _changed(table.get(str(first), {}), rest, value)
    else:
        table.pop(str(first), None)  # None: left out, the program chooses
    return table


def of_kind(before: Table, data: Table, where: tuple[str | int, ...]) -> Table:
    """The tables once a key is changed; where a bearing is of another kind now, without what only the former kind
    has."""
    if where[2:3] != (dotted(ShaftInputs.bearings),) or where[4:] != (dotted(BearingRow.kind),):
        return data
    row = where[:-1]
    return changed(data, row, of_new_kind(_row_at(before, row), _row_at(data, row)))


def _row_at(here: Any, where: tuple[str | int, ...]) -> Table:
    for part in where:
        here = here[part]
    return as_table(here)


def parse_assignment(text: str) -> tuple[str, object]:
    """`KEY=VALUE` of the command line; VALUE is TOML, or else plain text.  An empty value leaves the key out."""
    key, equals, value = text.partition("=")
    key, value = key.strip(), value.strip()
    if not equals or not key or "\n" in text:
        raise BadInput("--set", [InputError(0, text, "", Text("must be KEY=VALUE, like engine.bore_mm=94"))])
    if not value:
        return key, None
    try:
        return key, tomllib.loads(f"v = {value}")["v"]
    except (ValueError, RecursionError):  # TOMLDecodeError is a ValueError; so is a number of 5000 digits
        return key, value


def _no_such(key: str, reason: Text) -> BadInput:
    return BadInput("--set", [InputError(0, key, "", reason)])


def join(prefix: str, key: str) -> str:
    return f"{prefix}.{key}" if prefix and key else prefix or key


def own_shafts(data: Table) -> dict[int, Table]:
    """The shafts of a document that are no twins, by their places."""
    shafts = enumerate(map(as_table, as_list(data.get(dotted(Design.shafts)))))
    return {n: shaft for n, shaft in shafts if not is_twin(shaft)}


def asks(data: Table, step: str) -> bool:
    """Whether a document has a step; that of the shafts where one of them is more than its bearings."""
    if step != "countershaft":
        return step in data
    shafts = map(as_table, as_list(data.get(dotted(Design.shafts))))
    return any(shaft.get(dotted(ShaftInputs.mode)) != "bearings" for shaft in shafts)


def step_at(data: Table, key: str) -> str:
    """The step that a key of a document is of."""
    return step_of(key, judged=dotted(Design.bearings) in data)


def unjudged(data: Table) -> Table:
    """The tables once [bearings] is out: what it alone judges goes from the bearings of shafts, and all of twins."""
    key, rows = dotted(Design.shafts), dotted(ShaftInputs.bearings)
    kept = {entry.key for entry in keys(BearingRow).values() if entry.attribute in SCREENED}
    shafts = [
        without(shaft, rows)
        if is_twin(shaft)
        else {**shaft, rows: [{k: x for k, x in as_table(row).items() if k in kept} for row in as_list(shaft[rows])]}
        if rows in shaft
        else shaft
        for shaft in map(as_table, as_list(data.get(key)))
    ]
    return {**data, key: shafts} if shafts else data


def keys_of(cls: type, data: Table, step: str) -> list[Key]:
    """The keys of a class of inputs that a step asks for: of the bearings of a shaft their places, or all the rest."""
    of_row = dotted(Design.shafts, 0, ShaftInputs.bearings, 0)
    every = keys(cls).values()
    return [key for key in every if cls is not BearingRow or step_at(data, f"{of_row}.{key.key}") == step]


def asked_keys(cls: type, table: Table, data: Table, step: str) -> list[Key]:
    """Those of one table that can be given in it, without the name of a shaft, by which it is known, and without the
    bearings of a twin, which are judged."""
    own = set(own_keys(cls, table, judged=dotted(Design.bearings) in data))
    if cls is ShaftInputs:
        own -= {dotted(ShaftInputs.name)} | ({dotted(ShaftInputs.bearings)} if is_twin(table) else set())
    return [key for key in keys_of(cls, data, step) if key.key in own]


def tables_of(data: Table, step: Step) -> Iterator[tuple[type, Table, str]]:
    """The tables of a document that a step asks for, each with its class and its key; of the counter-shaft each of the
    shafts."""
    key = dotted(Design.shafts)
    if step.key != "countershaft" and isinstance(there := data.get(step.key), dict):
        yield step.inputs, there, step.key
    if step.key == "countershaft" and asks(data, step.key):
        for n, shaft in enumerate(map(as_table, as_list(data.get(key)))):
            yield ShaftInputs, shaft, f"{key}.{shaft.get('name', n)}"


def arrays_of(data: Table, step: Step) -> Iterator[tuple[Quantity, list[Table], str]]:
    """The arrays of tables that a step asks for beside its own table, each with its description and its key: the
    bearings that [bearings] judges."""
    if step.key == dotted(Design.bearings) and asks(data, step.key):
        for n, shaft in enumerate(map(as_table, as_list(data.get(dotted(Design.shafts))))):
            rows = as_list(shaft.get(dotted(ShaftInputs.bearings)))
            if not rows:
                continue  # of a twin that is as its original
            yield described(ShaftInputs.bearings), list(map(as_table, rows)), dotted(Design.shafts, n, step.key)


def element_title(cls: type | None, name: str) -> Text:
    """What an element of an array is called where it heads a row or a column; the names of bearings that the program
    gives speak the reader's language."""
    return titled(name) if cls is BearingRow else Name(name)


def quantities(data: Table) -> Iterator[tuple[str, Quantity]]:
    """Every key that this document may hold, with its description, in the order of the form."""
    judged = dotted(Design.bearings) in data
    of_shafts = list(_quantities_of(Design, data, dotted(Design.shafts), judged=judged))
    for step in STEPS:
        if step.key in data:
            yield from _quantities(step.inputs, as_table(data[step.key]), step.key, judged)
        yield from ((key, about) for key, about in of_shafts if step_at(data, key) == step.key)


def _quantities(cls: type, data: Table, prefix: str, judged: bool) -> Iterator[tuple[str, Quantity]]:
    for key in own_keys(cls, data, judged=judged):
        yield from _quantities_of(cls, data, key, f"{prefix}.{key}", judged=judged)


def _quantities_of(cls: type, data: Table, key: str, here: str = "", *, judged: bool) -> Iterator[tuple[str, Quantity]]:
    about, here = keys(cls)[key].about, here or key
    if about.table is None:
        yield here, about
    elif about.kind == "table":
        yield from _quantities(about.table, as_table(data.get(key)), here, judged)
    else:
        theirs = OF_ORIGINAL if about.table is BearingRow and is_twin(data) else ()
        for i, item in enumerate(map(as_table, as_list(data.get(key)))):
            inside = _quantities(about.table, item, f"{here}.{item.get('name', i)}", judged)
            yield from ((key, about) for key, about in inside if key.rpartition(".")[2] not in theirs)


def own_keys(cls: type, data: Table, *, judged: bool = True) -> list[str]:
    """The keys that a table of inputs may have: of a shaft that mirrors another only those that are its own, of a
    bearing that is not `judged` its place and size."""
    known = keys(cls)
    like = (dotted(ShaftInputs.mirrors), dotted(ShaftInputs.repeats))
    if cls is ShaftInputs:
        if not is_twin(data):
            return [key for key in known if key not in like]
        return [key for key in TWIN if judged or key != dotted(ShaftInputs.bearings)]
    if cls is BearingRow and not judged:
        return [key for key, entry in known.items() if entry.attribute in SCREENED]
    return list(known)


# --- what a key is called

# the arrays that are not named where their elements are
ARRAYS = (
    dotted(GearsInputs.wheels),
    dotted(GearsInputs.meshes),
    dotted(GearsInputs.stages),
    dotted(ShaftInputs.masses),
    dotted(ShaftInputs.extras),
    dotted(ShaftInputs.sections),
    dotted(ImbalanceInputs.unbalances),
    dotted(ImbalanceInputs.crank_bodies),
)
NUMBERED = {
    dotted(GearsInputs.meshes): Text("mesh"),
    dotted(ShaftInputs.sections): Text("section"),
}


def called(key: str, about: Quantity) -> Text:
    """A key as the user knows it: the label of its field, and where it stands."""
    label, place = about.brief or Small(about.label), place_words(key)
    if not place:
        return label
    if in_array(key):
        return Text("{label} of {place}", label=label, place=place)
    return Text("{place} {change}", place=IN_WORDS.get(place, place), change=label)


def place_words(key: str) -> str:
    """The element or the table that a key stands in, without the step: `central`, `front`; a mesh by its number from
    1."""
    way = within(key)[:-1]
    inner = [part for part in way if part not in ARRAYS]
    if inner and inner[0].isdigit():
        return Text("{array} {n}", array=NUMBERED.get(way[0], way[0]), n=int(inner[0]) + 1)
    return " ".join(inner)


def in_array(key: str) -> bool:
    """Whether a key is of an element of an array that is not named where its elements are."""
    return within(key)[0] in ARRAYS


def within(key: str) -> list[str]:
    """The parts of a key within its step: without the table that they stand in, or their shaft."""
    first, *parts = key.split(".")
    if first != dotted(Design.shafts):
        return parts or [first]
    return parts[2:] if parts[1:2] == [dotted(ShaftInputs.bearings)] and len(parts) > 2 else parts[1:] or [first]
