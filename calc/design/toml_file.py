# SPDX-License-Identifier: Apache-2.0
"""Design ⇄ TOML: a `Document` is a design as its file has it; `design()` checks it whole and turns it into SI.

Every edit, from the command line, a replay or the form, makes a new Document and is checked by this same one path.  In
order: the document, reading, checking."""

import hashlib
import math
import re
import tomllib
from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import MISSING, field
from datetime import date
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar

from ..countershaft.inputs import ShaftInputs
from ..countershaft.rows import BearingRow
from ..gears.inputs import GearsInputs
from ..sheet.errors import SHOWN_ERRORS, BadInput, InputError
from ..sheet.quantity import COMMA, Quantity, dotted, keys, unknown
from ..sheet.record import record, replace
from ..sheet.text import EMPTY, Text
from ..sheet.toml_scan import Beyond, key_lines, remarks
from ..sheet.value import linked
from .addresses import (
    NAME,
    Table,
    address,
    as_list,
    as_table,
    by_names,
    changed,
    every,
    join,
    of_kind,
    unjudged,
    value_at,
    with_row,
    written,
)
from .disk import read_file
from .limits import DESIGN_BYTES
from .model import SCHEMA, Design
from .upgrade import (
    MANY,
    PAIR,
    POSITIONS,
    RATIO,
    Upgraded,
    current,
    is_former,
    own_key,
    renamed,
    rewritten,
    rows_of,
    upgraded,
    without_shaft,
)

T = TypeVar("T")
REMARKS = Text("The design file says: {remarks}.")
ROW_OWN = tuple(dotted(key) for key in (BearingRow.name, BearingRow.position, BearingRow.slope))


@record
class Document:
    """The tables of a design file in the units of their keys, where each key stands, and the bytes.

    A file of schema 1 is one of schema 2 here; `former`: how it was read, so that what is wrong is said by its user's
    own keys."""

    data: Table
    place: str = "design"
    lines: dict[str, int] = field(default_factory=dict)
    raw: bytes = b""  # of the file as it was read
    former: Upgraded | None = None
    files: Mapping[str, bytes] = field(default_factory=dict)  # what stands for those of its runs, by name

    @property
    def folder(self) -> Path:
        """Where the files of its measurements are; of one that was never in a file the current one."""
        return Path(self.place).parent

    @property
    def sha256(self) -> str:
        """What the bytes of the file hash to; empty for a design that was never in a file."""
        return hashlib.sha256(self.raw).hexdigest() if self.raw else ""

    @cached_property
    def remarks(self) -> dict[str, str]:
        """The comments beside keys in the file, by these keys, elements of arrays by index; none beside what has been
        changed since."""
        text = self.raw.decode("utf-8-sig", "replace")
        comments, file = remarks(text), tomllib.loads(text)
        if self.former is not None:
            file = self.former.data
            known, mirrors = renamed(comments, file, self.former.was), dotted(ShaftInputs.mirrors)
            # beside a list of places it is of each, and beside that there is a pair, of what says so now
            gathered = {new for new, old in self.former.was.items() if old in (POSITIONS, PAIR)}
            comments = {new: words for new, words in known.items() if new not in gathered or new.endswith(mirrors)}
        comments = {key: words for key, words in comments.items() if key in self.lines}
        if 0 not in self.lines.values():
            return comments
        return {key: words for key, words in comments.items() if same_content(file, self.data, key)}

    def with_value(self, key: str, value: object) -> "Document":
        """The same document with one key changed (`engine.bore_mm`, `gears.wheels.shaft.teeth`); None takes
        it out.

        A table, or an element of an array of tables, is changed whole by a table, an array by a list of tables.  Keys
        of schema 1 are understood; a * among the parts of a key stands for all elements of an array.
        """
        first, *others = every(self.data, key)
        if others:
            document = self
            for each in (first, *others):
                document = document.with_value(each, value)
            return document
        key = current(self.data, first)
        lines = {**self.lines, key: 0}
        if first == "countershaft" and value is None:
            former = self.former and self.former.without(first)
            return replace(self, data=without_shaft(self.data), lines=lines, former=former)
        if first == RATIO and value is None:  # which schema 1 leaves out
            value = -1
        if key in MANY:
            data, former = rewritten(self.data, key, value), self.former and self.former.without(key)
            if former is not None and rows_of(data) != rows_of(self.data):
                former = replace(former, was={})  # of rows in other places the file says nothing
            return replace(self, data=data, lines=lines, former=former)
        array = isinstance(value, list) and all(isinstance(item, dict) for item in value)
        there = with_row(self.data, key)
        where = address(there, key, whole=array or value is None or isinstance(value, dict))
        if value is None and there is not self.data:
            return self  # of this bearing a twin says nothing that could be taken out
        if isinstance(value, dict) and first != key and where[-2:-1] == (dotted(ShaftInputs.bearings),):
            row = as_table(
                value_at(self.data, key, whole=True)
            )  # schema 1 says elsewhere what it is and where it stands
            value = {own: row[own] for own in ROW_OWN if own in row} | value
        data = of_kind(there, changed(there, where, value), where)
        if key == dotted(Design.bearings) and value is None:
            data = unjudged(data)
        former = self.former and self.former.without(".".join(map(str, where)))
        return replace(self, data=data, lines=lines, former=former)


def same_content(a: Table, b: Table, key: str) -> bool:
    """Whether the same stands at a key, whose elements of arrays are indices, in elements of the same names."""
    this: object = a
    other: object = b
    for part in key.split("."):
        if isinstance(this, list) and isinstance(other, list):
            n = int(part)
            this, other = (rows[n] if n < len(rows) else None for rows in (this, other))
        else:
            this, other = (table.get(part) if isinstance(table, dict) else None for table in (this, other))
        names = [table.get("name") if isinstance(table, dict) else None for table in (this, other)]
        if names[0] != names[1]:
            return False
    return bool(this == other)


Sound = tuple[Document, Design]  # a document without errors, and the design that it is
Like = tuple[Any, Any]  # a table, or an array of tables, without errors, and what was read of it


# --- reading


def read(path: Path | str) -> Document:
    """Read a design file.  Raises BadInput where it is no TOML text; what it says is not yet checked."""
    return current_document(read_as_it_is(path))


def read_as_it_is(path: Path | str) -> Document:
    """The same of any TOML file, by the keys that it has itself."""
    place = str(path)
    try:
        raw = read_file(path, DESIGN_BYTES)
    except OSError as error:
        reason = Text("cannot be read: {strerror}; give the path of a design file", strerror=error.strerror or error)
        raise BadInput(place, [InputError(0, "", "", reason)]) from None
    return parsed(raw, place)


def parse(raw: bytes, place: str, files: Mapping[str, bytes] | None = None) -> Document:
    """The document in the bytes of a design file.  `files`: what stands for the files beside it, by their names."""
    document = current_document(parsed(raw, place))
    return replace(document, files=files) if files else document


def parsed(raw: bytes, place: str) -> Document:
    """What the bytes of a TOML file say, as they say it."""

    def refuse(reason: Text, line: int = 1) -> BadInput:
        return BadInput(place, [InputError(line, "", "", reason)])

    if len(raw) > DESIGN_BYTES:
        sizes = dict(count=len(raw), most=f"{DESIGN_BYTES:,}")
        raise refuse(Text("is {count} bytes long; a design file has at most {most}", **sizes))
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise refuse(Text("is not text in UTF-8; a design is a TOML text file"), line) from None
    if not text.strip():
        raise refuse(Text("is empty; `contralbero new FILE` writes a complete design"))
    try:
        lines = key_lines(text)
        data = tomllib.loads(text)
    except Beyond as beyond:
        raise refuse(Text("is not a design: ") + beyond.text, beyond.line) from None
    except tomllib.TOMLDecodeError as error:
        at = re.search(r"at line (\d+)", str(error))
        line = int(at[1]) if at else text.count("\n") + 1
        comma = COMMA.search(text.splitlines()[line - 1]) if line <= len(text.splitlines()) else None
        hint = EMPTY
        if comma:
            hint = Text("; decimals are written with a point: {comma}", comma=comma[0].replace(",", "."))
        if str(error).startswith(("Cannot overwrite", "Cannot declare")):
            hint += Text("; what stands on this line stands above already: leave only one of the two")
        wrong = re.sub(" *[(]at .*[)]", "", str(error))
        raise refuse(Text("is not TOML: {sub}{hint}", sub=wrong, hint=hint), line) from None
    except ValueError as error:  # a number of 5000 digits
        raise refuse(Text("is not a design: ") + str(error)) from None
    return Document(data, place, lines, raw)


def current_document(document: Document) -> Document:
    """The same in the schema of this program; where none is said, that of the tables that are there.  Raises BadInput
    where it is one of a later program."""
    schema = document.data.get("schema")
    if isinstance(schema, int) and schema > SCHEMA:
        newer = Text("needs a newer program; this one reads schema 1 to {n}", n=SCHEMA)
        raise BadInput(document.place, [InputError(document.lines.get("schema", 1), "schema", str(schema), newer)])
    if schema != 1 and (schema is not None or not is_former(document.data)):
        return document
    former = upgraded(document.data, document.lines)
    return replace(document, data=former.data, lines=former.lines, former=former)


DAY = re.compile(r"[0-9]{4}-[0-9]{2}-[0-9]{2}")

# What stands for a wrong or missing value while the rest of the document is checked: no comparison with it holds.
PLACEHOLDER: Table = {
    "number": math.nan,
    "integer": math.nan,
    "text": "",
    "date": "",
    "choice": "",
    "flag": False,
    "series": (),
    "integers": (),
    "names": (),
    "table": None,
    "tables": (),
    "reasons": (),
    "open": None,
}


# --- checking


# arrays whose elements an error calls by their names
NAMED = tuple(f"{dotted(key)}." for key in (Design.shafts, dotted(Design.gears, GearsInputs.wheels)))


class _Reader:
    """Walks a document along the Inputs classes and collects every error."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.was = document.former.was if document.former is not None else {}
        self.errors: list[InputError] = list(document.former.errors) if document.former is not None else []
        self.told = frozenset(document.former.wrong if document.former is not None else ())  # keys, by the upgrade
        self.wrong: set[str] = set(self.told)  # the keys of all

    def error(self, key: str, value: object, reason: Text, kind: str = "text") -> object:
        """Note an error; gives what stands for the wrong value while the rest is checked."""
        if not _lies_within(key, self.told):
            own, words = own_key(self.was, key), "" if value is None else written(value)
            has_name = own == key and key.startswith(NAMED) and len(self.errors) < SHOWN_ERRORS  # else nobody reads it
            called = by_names(self.document.data, key) if has_name else ""
            self.errors.append(InputError(self.line(key), own, words, reason, called))
        self.wrong.add(key)
        return PLACEHOLDER[kind]

    def refused(self, about: Quantity, value: object, key: str) -> object:
        """Note a value that is not allowed, with what is."""
        return self.error(key, value, Text("must be {allowed}", allowed=about.allowed()), about.kind)

    def line(self, key: str) -> int:
        """The line of a key, or of the nearest table around it."""
        while key and key not in self.document.lines:
            key = key.rpartition(".")[0]
        return self.document.lines.get(key, 1) if key else 1

    def inputs(self, cls: type[T], data: Table, prefix: str, address: str = "", like: Like | None = None) -> T:
        """One Inputs object.  Where something in it is wrong, a placeholder stands there, so that the rest is still
        checked.

        `prefix` is its key with elements of arrays by index, `address` that with their names: by it explain says where
        a number stands. `like`: a table without errors in the same place, and what was read of it: what both have, the
        very same, is taken over."""
        kind: type = cls
        known, values = keys(kind), Table()
        data = getattr(cls, "as_read", dict)(data)  # what else the words of this table may mean
        for key in data:
            if key not in known:
                counted = len(self.errors) >= SHOWN_ERRORS  # nobody would read the nearest name
                reason = Text("is not known") if counted else unknown(key, known)
                self.error(join(prefix, key), None, getattr(cls, "REFUSED", {}).get(key) or reason)
        for key, about in known.items():
            if like is not None and data.get(key) is like[0].get(key):
                values[about.attribute] = getattr(like[1], about.attribute)
            elif key in data:
                there = None if like is None else (like[0].get(key), getattr(like[1], about.attribute))
                here, named = join(prefix, key), join(address, key)
                values[about.attribute] = self.value(about.about, data[key], here, named, there)
            elif about.field.default is not MISSING:
                values[about.attribute] = _keyed(about.about, about.field.default, join(address, key))
            elif not about.about.optional:
                self.error(join(prefix, key), None, Text("is missing; needs {allowed}", allowed=about.about.allowed()))
                values[about.attribute] = PLACEHOLDER[about.about.kind]
        inputs = cls(**values)
        try:
            problems = getattr(inputs, "problems", lambda: ())()
            for key, reason in [
                (key, reason) for key, reason in problems if not _lies_within(join(prefix, key), self.wrong)
            ]:
                self.error(join(prefix, key), _plain(data, key), reason)
        except (TypeError, ValueError, AttributeError, LookupError):
            if not self.wrong:
                raise  # a placeholder may stop a cross-check, nothing else may
        return inputs

    def value(self, about: Quantity, value: object, key: str, address: str, like: Like | None = None) -> object:
        match about.kind:
            case "table":
                if not isinstance(value, dict):
                    return self.error(key, value, Text("must be a table"), "table")
                known = like if like is not None and isinstance(like[0], dict) else None
                return self.inputs(about.table, value, key, address, known)  # type: ignore[arg-type]
            case "tables":
                return self.tables(about, value, key, address, like[0] if like else None, like[1] if like else ())
            case "series" | "integers":
                return _keyed(about, self.series(about, value, key), address)
            case "names":
                listed = [value] if about.count and isinstance(value, str) else value
                there = isinstance(listed, list) and listed and all(isinstance(name, str) for name in listed)
                if there and about.count and len(as_list(listed)) > about.count[1]:
                    most = Text("has {count} entries; at most {most}", count=len(as_list(listed)), most=about.count[1])
                    return self.error(key, value, most, about.kind)
                return tuple(as_list(listed)) if there else self.refused(about, value, key)
            case "reasons":
                return self.reasons(value, key)
            case "open":
                return value if isinstance(value, (dict, list)) else self.refused(about, value, key)
            case "text" | "choice":
                if about.kind == "choice" and not isinstance(value, (str, bool)) and str(value) in about.choices:
                    return linked(str(value), address)  # a choice that looks like a number, like the property class 8.8
                if not isinstance(value, str) or (about.choices and value not in about.choices):
                    return self.refused(about, value, key)
                return _keyed(about, value, address)
            case "flag":
                return value if isinstance(value, bool) else self.refused(about, value, key)
            case "date":
                return self.date(about, value, key)
        return _keyed(about, self.number(about, value, key), address)

    def date(self, about: Quantity, value: object, key: str) -> object:
        """A date of TOML, or its text; one with a time of day is none."""
        written = value.isoformat() if type(value) is date else value
        if isinstance(written, str) and (about.free or not written or is_day(written)):
            return written
        return self.refused(about, value, key)

    def number(self, about: Quantity, value: object, key: str) -> object:
        if (reason := about.refuses(value)) is not None:
            return self.error(key, value, reason, "number")
        assert isinstance(value, (int, float))
        return value if about.kind in ("integer", "integers") else about.units.inside(float(value))

    def series(self, about: Quantity, value: object, key: str) -> object:
        items = as_list(value)
        if about.count and not about.count[0] <= len(items) <= about.count[1]:
            low, high = about.count
            needed = low if low == high else Text("{low} to {high}", low=low, high=high)
            reason = Text("has {count} entries; needs {low}", count=len(items), low=needed)
            return self.error(key, value, reason, "series")
        if not items:
            return self.error(key, value, Text("is empty; needs {allowed}", allowed=about.allowed()), "series")
        return tuple(self.number(about, item, key) for item in items)

    def tables(
        self, about: Quantity, value: object, key: str, address: str, like: object = None, read: Sequence[object] = ()
    ) -> object:
        if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
            return self.error(key, value, Text("must be an array of tables: [[") + key + "]]", "tables")
        names = [item.get("name") for item in value]
        before: list[Like | None] = [None] * len(value)
        if isinstance(like, list) and [item.get("name") for item in like] == names:
            before = list(zip(like, read))
        elements: tuple[object, ...] = tuple(
            self.inputs(about.table, item, f"{key}.{i}", f"{address}.{i if name is None else name}", known)  # type: ignore[arg-type]
            for i, (item, name, known) in enumerate(zip(value, names, before))
        )
        addressed = not key.startswith(("oil", "material", "requirements")) and "name" in keys(about.table)
        seen: set[str] = set()
        for i, name in enumerate(names):
            if isinstance(name, str):
                here = f"{key}.{i}.name"
                if addressed and not NAME.match(name):
                    must = Text("must be made of letters, digits and -, since the element is addressed by it")
                    self.error(here, name, must)
                if name in seen:
                    self.error(here, name, Text("stands twice; every element needs a name of its own"))
                seen.add(name)
        return elements

    def reasons(self, value: object, key: str) -> tuple[tuple[str, str], ...]:
        if not isinstance(value, dict):
            self.error(key, value, Text("must be a table: [{key}]", key=key))
            return ()
        for id, reason in value.items():
            if not isinstance(reason, str) or not reason.strip():
                self.error(f"{key}.{id}", reason, Text('needs a reason in words, like "seen on the test bench"'))
        return tuple((id, reason.strip()) for id, reason in value.items() if isinstance(reason, str))


def is_day(words: str) -> bool:
    """Whether words are a day of the calendar as ISO 8601 writes it."""
    with suppress(ValueError):
        return bool(DAY.fullmatch(words) and date.fromisoformat(words))
    return False


def _keyed(about: Quantity, value: object, address: str) -> object:
    """A number, or a word that may choose numbers, with the key that it stands under; what only names or tells
    something has none."""
    if about.kind == "flag":
        return value
    words = about.kind in ("text", "choice")
    if words and (not value or address.rpartition(".")[2] in ("name", "note", "source", "label")):
        return value
    return linked(value, address)


def _lies_within(key: str, wrong: Collection[str]) -> bool:
    """Whether a key, or the table around it, is known to be wrong: what would follow from that is not said."""
    while key:
        if key in wrong:
            return True
        key = key.rpartition(".")[0]
    return False


def _plain(data: object, key: str) -> object:
    """What stands at a key below this table, if it is a number or a word; else None."""
    for part in key.split("."):
        if isinstance(data, list) and part.isdigit():
            data = data[int(part)]
        else:
            data = data.get(part) if isinstance(data, dict) else None
    return data if isinstance(data, (int, float, str)) else None


def design(document: Document, sound: Sound | None = None) -> Design:
    """The checked design in SI.  Raises BadInput with every error of the document, in the order of its lines.

    `sound`: a document of which this one was made, with its design: what is unchanged is taken over and not read again.
    """
    reader = _Reader(document)
    checked = reader.inputs(Design, document.data, "", like=(sound[0].data, sound[1]) if sound is not None else None)
    if checked.measurements:
        checked = _with_runs(reader, checked)
    if reader.errors:
        raise BadInput(document.place, reader.errors)
    return checked


def mistaken(document: Document, problems: Iterable[tuple[str, Text]]) -> BadInput | None:
    """What turned out to be wrong with a design once it was solved, with the lines of its keys; None: nothing."""
    reader = _Reader(document)
    for key, reason in problems:
        reader.error(key, _plain(document.data, key), reason)
    return BadInput(document.place, reader.errors) if reader.errors else None


def _with_runs(reader: _Reader, checked: Design) -> Design:
    """A design with the runs that its measurements are in files; what is wrong with them is said with the rest."""
    from .run_files import read_runs  # which a design without any does not load

    runs, problems = read_runs(checked, reader.document.folder, reader.document.files)
    for key, reason in problems:
        if not _lies_within(key, reader.wrong):
            reader.error(key, _plain(reader.document.data, key), reason)
    return replace(checked, runs=runs)


def load(path: Path | str) -> tuple[Document, Design]:
    document = read(path)
    return document, design(document)


# --- from Python: `from calc import load_design, solve_design`


def load_design(path: Path | str) -> Design:
    """The design in a file, its numbers in SI (temperatures in °C, speeds in revolutions per second); all that is wrong
    in it is raised at once, as BadInput."""
    return load(path)[1]
