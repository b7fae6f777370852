# SPDX-License-Identifier: Apache-2.0
"""Designs of schema 1 as schema 2 has them: [countershaft], [bearings.front] and [bearings.rear] become [[shafts]] with
a row of [[shafts.bearings]] for each bearing.

In order: the tables of a whole design, with today's errors at the user's own keys; one old key typed or stored beside a
design of schema 2; the four old keys that have become many."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from itertools import pairwise
from typing import TypeVar

from ..bearings.inputs import BearingsInputs
from ..gears.wheel_inputs import Wheel
from ..sheet.errors import SHOWN_ERRORS, BadInput, InputError, written
from ..sheet.quantity import Quantity, keys, unknown
from ..sheet.record import record, replace
from ..sheet.text import Text

T = TypeVar("T")
Table = dict[str, object]  # of a TOML document; what stands under a key is narrowed where it is read

SHAFT, TWIN = "shaft", "twin"  # what the upgraded shaft and its mirror image are called
FRONT, REAR = "front", "rear"
BETWEEN = ("second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")

# --- schema 1: its keys and what may stand there, as version 0.1 had them

POSITIONS, JOURNALS = "countershaft.bearing_positions_mm", "countershaft.journals"
PAIR, SLOPES, RATIO = "countershaft.pair", "bearings.slope_mrad", "countershaft.speed_ratio"
SHAFT_KEYS = (
    "mode", "material", "speed_ratio", "pair", "bearing_positions_mm", "axis_mm", "masses", "extras", "outer_radius_mm",
    "core_radius_mm", "half_length_mm", "overdesign_percent", "radial_clearance_mm", "sections", "fillet_radius_mm",
    "fem_stress_MPa", "fem_principal_stress_MPa", "sector_effectiveness", "gear_z_mm", "journals", "balance_grade",
    "holes", "scatter", "bolts", "further_bolts", "support", "oil_drain", "further_drains", "cost", "parts",
)  # fmt: skip
ROW_KEYS = (
    "diameter_mm", "length_mm", "clearance_um", "clearance_factor", "load_N", "journal_roughness_um",
    "housing_roughness_um",
)  # fmt: skip
JOURNAL_KEYS = ("diameter_mm", "length_mm")
PLACES = Quantity("series", Text("Bearing positions"), "mm", low=-5000, high=5000, count=(2, 9))
AXIS = Quantity("series", Text("Axis from the crank's"), "mm", low=-5000, high=5000, count=(2, 2))
SLOPE = Quantity("series", Text("Slope of the journals"), "mrad", low=0, high=20, count=(1, 2))
SIZE = Quantity("number", Text("Diameter"), "mm", above=0, high=1000)  # of a journal, and its length
TWINNED = Quantity("choice", Text("Twin shaft"), choices=("no", "yes"))
JOURNAL_TABLES = Quantity("tables", Text("Journals"))
# the four that have become many, see `rewritten` and `formerly`
MANY: Mapping[str, Quantity] = {POSITIONS: PLACES, JOURNALS: JOURNAL_TABLES, PAIR: TWINNED, SLOPES: SLOPE}
RISE = Text("must rise from front to rear: [z_front, z_rear] with z_front < z_rear")
TWO = Text("[bearings] has a front and a rear one: give two, or the sizes as journals")
THEIRS = Text("are those of [bearings]; leave them out here, or [bearings]")
STEPS = ("countershaft", "bearings")  # what stands in [locked] for them names the step, and stays


def row_names(count: int) -> tuple[str, ...]:
    """What so many bearings of an old file are called, front to rear: a figure would be an index."""
    return (FRONT, *(("middle",) if count == 3 else BETWEEN[: count - 2]), REAR)


# --- a whole design


@record
class Upgraded:
    """A design of schema 1 in schema 2.

    `lines`: where its keys stand in the file; elements of arrays are indices in keys. `was`: what the keys that went
    elsewhere, or the nearest table around them, were called; `own_key` asks it. `errors`: what was not well formed, at
    the user's own keys; it is left out of `data`. `wrong`: keys of which, and of all that stands below, nothing more is
    to be said, since it would follow from those errors."""

    data: Table
    lines: dict[str, int]
    was: dict[str, str]
    errors: tuple[InputError, ...]
    wrong: frozenset[str]

    def without(self, key: str) -> "Upgraded":
        """The same once a key, elements of arrays by index, or one of the four old keys (MANY) is given another value:
        what was wrong there, or in it, is so no more.  A list of these four is mended whole: what it had is not
        known."""
        old = own_key(self.was, key)
        if not self.errors or (old in MANY and key != old):
            return self
        errors = tuple(error for error in self.errors if not _lies_in(error.key, old))
        wrong = frozenset(there for there in self.wrong if not _lies_in(own_key(self.was, there), old))
        return replace(self, errors=errors, wrong=wrong)


def _lies_in(key: str, table: str) -> bool:
    """Whether a key is the other, or stands in it."""
    return f"{key}.".startswith(f"{table}.")


def own_key(was: Mapping[str, str], key: str) -> str:
    """What the user of a file of schema 1 calls a key of schema 2."""
    head, tail = key, ""
    while head:
        if head in was:
            return was[head] + tail
        head, _, last = head.rpartition(".")
        tail = f".{last}{tail}"
    return key


def renamed(entries: Mapping[str, T], data: Table, was: Mapping[str, str]) -> dict[str, T]:
    """What is known by the keys of a file of schema 1, lines or remarks, by the keys of its `Upgraded.data`."""
    known = {}
    for key in _keys(data, lambda _, n: str(n)):
        old = own_key(was, key)
        while key in was and old not in entries and "." in old:  # of a list that has become many
            old = old.rpartition(".")[0]
        if old in entries:
            known[key] = entries[old]
    return known


def _keys(here: object, name: Callable[[object, int], str], prefix: str = "") -> Iterator[str]:
    """All keys of nested tables, elements of arrays of tables by what `name` calls them."""
    inner: Iterable[tuple[str, object]] = here.items() if isinstance(here, dict) else ()
    if isinstance(here, list) and _tables(here):
        inner = ((name(item, n), item) for n, item in enumerate(here))
    for part, content in inner:
        key = f"{prefix}.{part}" if prefix else part
        yield key
        yield from _keys(content, name, key)


def _tables(content: object) -> bool:
    return isinstance(content, list) and all(isinstance(item, dict) for item in content)


def elements(table: Table, key: str) -> list[Table]:
    """The array of tables at a key of a table; empty where there is none."""
    array = table.get(key)
    return array if isinstance(array, list) and _tables(array) else []


def is_former(data: Table) -> bool:
    """Whether the tables are those of schema 1, whatever schema they name."""
    bearings = data.get("bearings")
    return "countershaft" in data or (isinstance(bearings, dict) and bool({FRONT, REAR} & bearings.keys()))


def upgraded(data: Table, lines: Mapping[str, int]) -> Upgraded:
    """A design of schema 1, which nobody has checked, in schema 2.  `lines`: where its keys stand in the file."""
    return _Upgrade(data, lines).made()


class _Upgrade:
    """The tables of schema 1 that are read, what is made of them, and what is wrong in them."""

    def __init__(self, data: Table, lines: Mapping[str, int]) -> None:
        self.data, self.lines = data, lines
        self.errors: list[InputError] = []
        self.was: dict[str, str] = {}
        self.wrong: set[str] = set()
        self.shaft = self._given("countershaft")
        self.bearings = self._given("bearings")
        self.rows: tuple[str, ...] = ()  # their names
        self.pair = False

    def _given(self, key: str) -> Table | None:
        table = self.data.get(key)
        return table if isinstance(table, dict) else None

    def made(self) -> Upgraded:
        shafts = self._shafts()
        data: Table = {}
        for key, content in self.data.items():
            if key == "schema":
                data[key] = 2 if content == 1 and type(content) is int else content
            elif key == "countershaft":
                data |= {"shafts": shafts} if shafts else {}
            elif key == "bearings":
                if self.shaft is None and shafts:
                    data["shafts"] = shafts
                data[key] = content if self.bearings is None else self._shared(self.bearings)
            elif key == "shafts":
                self.error(key, None, Text("[[shafts]] is of schema 2: write schema = 2, or [countershaft] instead"))
            elif near := _gone(key):
                self.error(key, None, near)
            else:
                data[key] = content
        self._gears(data)
        self._references(data)
        lines = renamed(self.lines, data, self.was)
        return Upgraded(data, lines, self.was, tuple(self.errors), frozenset(self.wrong))

    # --- what is wrong

    def error(self, key: str, value: object, reason: Text) -> None:
        line, where = 0, key
        while where and not line:
            line, where = self.lines.get(where, 0), where.rpartition(".")[0]
        self.errors.append(InputError(line or 1, key, "" if value is None else written(value), reason))

    def _known(self, prefix: str, table: Table, known: Collection[str]) -> Table:
        """A table without the keys that schema 1 does not know."""
        for key in (key for key in table if key not in known):
            reason = Text("is not known") if len(self.errors) >= SHOWN_ERRORS else unknown(key, known)
            self.error(f"{prefix}.{key}", None, reason)
        return {key: content for key, content in table.items() if key in known}

    def _listed(self, key: str, value: object, about: Quantity) -> list[object]:
        """The numbers of a list, or one alone; empty where they are not well formed."""
        items, reason = _items(value, about)
        wrong = [(item, why) for item in items if (why := about.refuses(item)) is not None]
        for item, why in wrong if reason is None else [(value, reason)]:
            self.error(key, item, why)
        return items if reason is None and not wrong else []

    # --- the shaft

    def _shafts(self) -> list[Table]:
        """The shaft and its twin; none where there is none in the file, or nothing of it can be read."""
        given = self.data.get("countershaft")
        if given is not None and self.shaft is None:
            self.error("countershaft", given, Text("must be a table"))
            self.wrong.add("shafts")
        if self.shaft is None and self.bearings is None:
            return []
        was = "bearings" if self.shaft is None else "countershaft"
        self.was |= {"shafts": was, "shafts.0": was}
        places = self._places() if self.shaft is not None else []
        journals = self._journals(len(places)) if self.shaft is not None else []
        if len(places) > 2 and self.bearings is not None:
            self.error(POSITIONS, None, TWO)
            places = []
        self.rows = row_names(len(places) or 2) if places or self.bearings is not None else ()
        rows = self._rows(places, journals)
        if self.shaft is None:
            return [] if "shafts" in self.wrong else [{"name": SHAFT, "mode": "bearings", "bearings": rows}]
        kept = self._known("countershaft", self.shaft, SHAFT_KEYS)
        pair = kept.get("pair", "no")
        if pair not in TWINNED.choices:
            self.error(PAIR, pair, Text("must be {allowed}", allowed=TWINNED.allowed()))
        kept = without(kept, *map(_last, (POSITIONS, JOURNALS, PAIR)))
        shaft = {"name": SHAFT, **kept} | ({} if "speed_ratio" in kept else {"speed_ratio": -1})
        if not rows:
            self.wrong.add("shafts.0.bearings")
        self.pair = pair == "yes"
        if self.pair:
            self.was |= {"shafts.1": PAIR, "shafts.1.name": PAIR, "shafts.1.mirrors": PAIR}
            self.was |= {"shafts.1.axis_mm": "countershaft.axis_mm"}
        return [{**shaft, "bearings": rows} if rows else shaft, *([twin(shaft, SHAFT)] if self.pair else [])]

    def _places(self) -> list[object]:
        """The positions of the bearings."""
        assert self.shaft is not None
        key, given = POSITIONS, self.shaft.get(_last(POSITIONS))
        if given is None:
            self.error(key, None, Text("is missing; needs {allowed}", allowed=PLACES.allowed()))
            return []
        places = self._listed(key, given, PLACES)
        if any(b <= a for a, b in pairwise(places)):  # type: ignore[operator]
            self.error(key, None, RISE)
            return []
        return places

    def _rows(self, places: list[object], journals: list[Table]) -> list[Table]:
        """The bearings, each with its place, its size as a journal, what its own table has, and its slope."""
        slopes, rows = self._slopes(), []
        self.was["shafts.0.bearings"] = POSITIONS if self.shaft is not None else "bearings"
        for i, name in enumerate(self.rows):
            key, row = f"shafts.0.bearings.{i}", Table(name=name)
            self.was[key] = f"{JOURNALS}.{i}" if self.bearings is None else f"bearings.{name}"
            self.was[f"{key}.position_mm"] = f"{POSITIONS}.{i}"
            self.was[f"{key}.slope_mrad"] = f"{SLOPES}.{i}" if len(slopes) > 1 else SLOPES
            if places:
                row["position_mm"] = places[i]
            elif self.shaft is not None:
                self.wrong.add(f"{key}.position_mm")
            if journals:
                row |= journals[i]
                self.was |= {f"{key}.{size}": f"{JOURNALS}.{i}.{size}" for size in JOURNAL_KEYS}
            row |= self._own(name, key) if self.bearings is not None else {}
            if slopes and name in (FRONT, REAR):
                row["slope_mrad"] = slopes[0 if name == FRONT else -1]
            rows.append(row)
        return rows

    def _journals(self, count: int) -> list[Table]:
        """The sizes of the journals, as many as there are positions; none where they are not well formed."""
        assert self.shaft is not None
        given = self.shaft.get(_last(JOURNALS), [])
        if not isinstance(given, list) or not _tables(given):
            self.error(JOURNALS, given, Text("must be an array of tables: [[") + JOURNALS + "]]")
            return []
        before = len(self.errors)
        for i, journal in enumerate(given):
            key = f"{JOURNALS}.{i}"
            self._known(key, journal, JOURNAL_KEYS)
            for size in JOURNAL_KEYS:
                reason = SIZE.refuses(journal.get(size))
                if size not in journal:
                    reason = Text("is missing; needs {allowed}", allowed=SIZE.allowed())
                if reason is not None:
                    self.error(f"{key}.{size}", journal.get(size), reason)
        if given and count and len(given) != count:
            self.error(JOURNALS, None, _each(count))
        elif given and self.bearings is not None:
            self.error(JOURNALS, None, THEIRS)
        return [] if len(self.errors) > before else given

    def _own(self, name: str, key: str) -> Table:
        """What [bearings.front] or [bearings.rear] has."""
        assert self.bearings is not None
        place, given = f"bearings.{name}", self.bearings.get(name)
        if isinstance(given, dict):
            return self._known(place, given, ROW_KEYS)
        missing = Text("is missing; needs {allowed}", allowed=Text("a table"))
        self.error(place, given, missing if given is None else Text("must be a table"))
        self.wrong.add(key)
        return {}

    def _slopes(self) -> list[object]:
        given = None if self.bearings is None else self.bearings.get(_last(SLOPES))
        return [] if given is None else self._listed(SLOPES, given, SLOPE)

    def _shared(self, bearings: Table) -> Table:
        """What stays in [bearings]."""
        moved = (FRONT, REAR, _last(SLOPES))
        known = [*(key for key in keys(BearingsInputs) if key not in moved), *moved]
        return without(self._known("bearings", bearings, known), *moved)

    # --- the wheel of the shaft

    def _gears(self, data: Table) -> None:
        """Says of the wheel that the last mesh drives, that it sits on the shaft."""
        gears = data.get("gears")
        if not isinstance(gears, dict) or not (given := elements(gears, "wheels")):
            return
        known = [key for key in keys(Wheel) if key != "shaft"]
        for i, wheel in enumerate(given):
            if "shaft" in wheel:
                self.error(f"gears.wheels.{i}.shaft", None, unknown("shaft", known))
        wheels = [without(wheel, "shaft") for wheel in given]
        meshes = elements(gears, "meshes")
        last = meshes[-1].get("driven") if meshes else None
        names = [wheel.get("name") for wheel in wheels]
        if isinstance(last, str) and last in names and (self.shaft is not None or self.bearings is not None):
            i = names.index(last)
            wheels[i] = _with_name(wheels[i], {"shaft": SHAFT})
            self.was[f"gears.wheels.{i}.shaft"] = f"gears.meshes.{len(meshes) - 1}.driven"
        data["gears"] = {**gears, "wheels": wheels}

    # --- keys as words

    def _references(self, data: Table) -> None:
        """What names keys: [locked], [optimise.vary] and the value of [[measured]].  Ids, as in [accepted], stay."""
        if isinstance(locked := data.get("locked"), dict):
            data["locked"] = self._named("locked", locked, lambda key, _: self._new_keys(key))
        if isinstance(optimise := data.get("optimise"), dict) and isinstance(vary := optimise.get("vary"), dict):
            data["optimise"] = {**optimise, "vary": self._named("optimise.vary", vary, self._varied)}
        if measured := elements(data, "measured"):
            given = frozenset(_keys(self.data, _name))
            data["measured"] = [{**row, **self._measured(row, given)} for row in measured]

    def _named(self, table: str, given: Table, new: Callable[[str, object], tuple[str, ...]]) -> Table:
        """A table by keys, with those of schema 2."""
        made: Table = {}
        for key, content in given.items():
            for name in new(key, content):
                made[name] = content
                if name != key:
                    self.was[f"{table}.{name}"] = f"{table}.{key}"
        return made

    def _new_keys(self, key: str) -> tuple[str, ...]:
        """The keys that say what an old one said: none of a twin that is not there."""
        if key == PAIR and not self.pair:
            return ()
        return (key,) if key in STEPS else new_keys(key, SHAFT, self.rows or row_names(2))

    def _varied(self, key: str, allowed: object) -> tuple[str, ...]:
        """What is varied together can not be varied key by key: it stays, and is read as the old key."""
        return (key,) if key in MANY and allowed != "fixed" else self._new_keys(key)

    def _measured(self, row: Table, given: Collection[str]) -> Table:
        """The value of a row where it is the key of an input that is given; the id of a value stays."""
        value = row.get("value")
        if not isinstance(value, str) or value in MANY or value not in given:
            return {}
        return {"value": self._new_keys(value)[0]}


def _last(key: str) -> str:
    """A key within its table."""
    return key.partition(".")[2]


def _gone(key: str) -> Text | None:
    """What is said of a table that is none and comes close to the one that has gone."""
    return unknown(key, STEPS[:1]) if get_close_matches(key, STEPS[:1], 1, 0.8) else None


def _items(value: object, about: Quantity) -> tuple[list[object], Text | None]:
    """What a list of numbers has, of one where there is one number alone, and what is wrong with how many there are."""
    assert about.count is not None
    items, (low, high) = value if isinstance(value, list) else [value], about.count
    if low <= len(items) <= high:
        return items, None
    needed = low if low == high else Text("{low} to {high}", low=low, high=high)
    return items, Text("has {count} entries; needs {low}", count=len(items), low=needed)


def _each(count: int) -> Text:
    return Text("give one for each of the {count} bearing_positions_mm", count=count)


def twin(shaft: Table, name: str) -> Table:
    """The mirror image of a shaft; on the other side of the crank, where its place is given."""
    axis = shaft.get("axis_mm")
    made: Table = {"name": TWIN, "mirrors": name}
    if isinstance(axis, list) and _items(axis, AXIS)[1] is None and all(AXIS.refuses(x) is None for x in axis):
        made["axis_mm"] = [axis[0], 0 - axis[1]]  # not −0.0
    return made


def _with_name(table: Table, beside: Table) -> Table:
    """A table with others' keys right below its name."""
    called = {key: content for key, content in table.items() if key == "name"}
    return {**called, **beside, **without(table, *called)}


def _name(item: object, place: int) -> str:
    """By what an element of an array is addressed."""
    name = item.get("name") if isinstance(item, dict) else None
    return name if isinstance(name, str) else str(place)


def place_in(part: str, count: int) -> int | None:
    """The index that a part of a key is in a list of so many; None where it is none."""
    return int(part) if part.isascii() and part.isdigit() and int(part[:9]) < count else None


def new_keys(key: str, shaft: str, rows: Sequence[str]) -> tuple[str, ...]:
    """The keys of schema 2 that say of a shaft and its bearings what a key of schema 1 said; most kept their place."""
    table, _, rest = key.partition(".")
    part, _, tail = rest.partition(".")
    here = f"shafts.{shaft}"
    if table == "countershaft":
        if part == _last(POSITIONS):
            return tuple(f"{here}.bearings.{row}.position_mm" for row in _chosen(tail, rows))
        if part == _last(JOURNALS):
            place, _, size = tail.partition(".")
            sizes = (size,) if size else JOURNAL_KEYS
            return tuple(f"{here}.bearings.{row}.{size}" for row in _chosen(place, rows) for size in sizes)
        if part == _last(PAIR):
            return (f"shafts.{TWIN}.mirrors",)
        return (f"{here}.{rest}" if rest else here,)
    if table == "bearings" and part == _last(SLOPES):
        ends = tuple(dict.fromkeys((*rows[:1], *rows[-1:])))
        return tuple(f"{here}.bearings.{row}.slope_mrad" for row in _chosen(tail, ends))
    if table == "bearings" and (part in (FRONT, REAR) or (part == "*" and tail in ROW_KEYS)):
        return (f"{here}.{key}",)
    return (key,)


def _chosen(place: str, rows: Sequence[str]) -> Sequence[str]:
    """The rows at a place of a list of old; all where none is named."""
    i = place_in(place, len(rows))
    return rows if not place else (place,) if i is None else (rows[i],)


# --- an old key that is typed or stored beside a design of schema 2


def current(data: Table, key: str) -> str:
    """The key of schema 2 that says what one of schema 1 said, in a design with one shaft of its own; any other key as
    it is.  Keys in [locked] and [optimise.vary] likewise: `locked.bearings.front.length_mm`.  Raises BadInput where
    there are several such shafts.

    The four keys that have become many (MANY) are no address: `formerly` reads them, `rewritten` writes them."""
    for table in ("locked", "optimise.vary"):
        head, inner = key[: len(table) + 1], key[len(table) + 1 :]
        if head == f"{table}." and inner:
            return key if inner in STEPS else head + current(data, inner)
    if key in MANY or new_keys(key, SHAFT, row_names(2)) == (key,):
        return key
    name, shaft = _own(data, key)
    return new_keys(key, name, _row_names(shaft))[0]


def _own(data: Table, key: str) -> tuple[str, Table]:
    """The name of the shaft that is no twin, and its table, which is empty where there is none."""
    own = [(_name(shaft, i), shaft) for i, shaft in enumerate(elements(data, "shafts")) if not is_twin(shaft)]
    if len(own) > 1:
        first, *others = [name for name, _ in own]
        there = new_keys(key, first, _row_names(own[0][1]) or row_names(2))[0]
        several = ", ".join([there, *(f"shafts.{name}…" for name in others)])
        raise BadInput("--set", [InputError(0, key, "", Text("there are several shafts: {several}", several=several))])
    return own[0] if own else (SHAFT, {})


def is_twin(shaft: Table) -> bool:
    """Whether it is the mirror image of another, or that once more."""
    return "mirrors" in shaft or "repeats" in shaft


def _row_names(shaft: Table) -> list[str]:
    return [_name(row, i) for i, row in enumerate(elements(shaft, "bearings"))]


def rows_of(data: Table) -> list[str]:
    """The names of the bearings of the one own shaft; raises BadInput where there are several."""
    return _row_names(_own(data, POSITIONS)[1])


# --- the old keys that have become many


def formerly(data: Table, key: str) -> object:
    """What one of the four old keys (MANY) would say of a design of schema 2; None where it would be left out."""
    name, shaft = _own(data, key)
    rows = elements(shaft, "bearings")
    if key == PAIR:
        return "yes" if any(there.get("mirrors") == name for there in elements(data, "shafts")) else None
    if key == JOURNALS:
        sizes = [{size: row[size] for size in JOURNAL_KEYS if size in row} for row in rows]
        return sizes if "bearings" not in data and any(sizes) else None
    wanted = "position_mm" if key == POSITIONS else "slope_mrad"
    numbers = [row.get(wanted) for row in (rows if key == POSITIONS else [*rows[:1], *rows[-1:]])]
    return None if not numbers or None in numbers else numbers


def rewritten(data: Table, key: str, value: object) -> Table:
    """A design of schema 2 after one of the four old keys (MANY) was given a value, or left out (None).  Raises
    BadInput where schema 1 would not allow it, or there are several shafts of their own."""
    name, shaft = _own(data, key)
    shafts = elements(data, "shafts")
    if value is None and not shaft:
        return data
    if key == PAIR:
        return {**data, "shafts": _paired(shafts or [{"name": name}], name, shaft, value)}
    rows = elements(shaft, "bearings")
    if key == POSITIONS:
        rows = _placed(rows, value)
    elif key == SLOPES:
        rows = _sloped(rows, value)
    elif "bearings" not in data:
        rows = _sized(rows, value)
    elif value:
        raise _refused(key, None, THEIRS)
    new = {**(shaft or {"name": name}), "bearings": rows}
    return {**data, "shafts": [new if there is shaft else there for there in shafts] if shaft else [*shafts, new]}


def without_shaft(data: Table) -> Table:
    """A design of schema 2 once [countershaft] of schema 1 is out: the bearings stay where [bearings] judges them."""
    name, shaft = _own(data, "countershaft")
    rows = [without(row, "position_mm") for row in elements(shaft, "bearings")] if "bearings" in data else []
    kept = {"shafts": [{"name": name, "mode": "bearings", "bearings": rows}]} if rows else {}
    return without(data, "shafts") | kept


def _refused(key: str, value: object, reason: Text) -> BadInput:
    return BadInput("--set", [InputError(0, key, "" if value is None else written(value), reason)])


def _numbers(key: str, value: object, about: Quantity) -> list[object]:
    items, reason = _items(value, about)
    if reason is not None:
        raise _refused(key, value, reason)
    for item in items:
        if (reason := about.refuses(item)) is not None:
            raise _refused(key, item, reason)
    return items


def _paired(shafts: list[Table], name: str, shaft: Table, value: object) -> list[Table]:
    if value not in (None, *TWINNED.choices):
        raise _refused(PAIR, value, Text("must be {allowed}", allowed=TWINNED.allowed()))
    if value != "yes":
        return [there for there in shafts if there.get("mirrors") != name]
    return shafts if any(there.get("mirrors") == name for there in shafts) else [*shafts, twin(shaft, name)]


def _placed(rows: list[Table], value: object) -> list[Table]:
    """As many positions as rows: each row's; another count: rows anew, those of the same name with what they had."""
    if value is None:
        return [without(row, "position_mm") for row in rows]
    places = _numbers(POSITIONS, value, PLACES)
    if len(places) != len(rows):
        had = {_name(row, i): row for i, row in enumerate(rows)}
        rows = [had.get(name, {"name": name}) for name in row_names(len(places))]
    return [_with_name(without(row, "position_mm"), {"position_mm": place}) for row, place in zip(rows, places)]


def _sloped(rows: list[Table], value: object) -> list[Table]:
    """The slope of the first row and of the last."""
    if value is None:
        return [without(row, "slope_mrad") for row in rows]
    slopes = _numbers(SLOPES, value, SLOPE)
    ends = {0: slopes[0], len(rows) - 1: slopes[-1]}
    return [{**row, "slope_mrad": ends[i]} if i in ends else row for i, row in enumerate(rows)]


def _sized(rows: list[Table], value: object) -> list[Table]:
    """Diameter and length of every row."""
    rows = [without(row, *JOURNAL_KEYS) for row in rows]
    if value is None or value == []:
        return rows
    if not isinstance(value, list) or not _tables(value):
        raise _refused(JOURNALS, value, Text("must be an array of tables: [[") + JOURNALS + "]]")
    if len(value) != len(rows):
        raise _refused(JOURNALS, None, _each(len(rows)))
    for i, journal in enumerate(value):
        for size in (size for size in journal if size not in JOURNAL_KEYS):
            raise _refused(f"{JOURNALS}.{i}.{size}", None, unknown(size, JOURNAL_KEYS))
    return [{**row, **journal} for row, journal in zip(rows, value)]


def without(table: Table, *taken: str) -> Table:
    """A table less some of its keys."""
    return {key: content for key, content in table.items() if key not in taken}
