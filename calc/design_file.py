# SPDX-License-Identifier: Apache-2.0
"""Design ⇄ TOML.  A `Document` is a design as its file has it; `design()` checks it whole and turns it into SI.

Every edit, from the command line, a replay or the form, makes a new Document and is checked by this same one path.
"""

import math
import re
import tomllib
from collections.abc import Iterator
from dataclasses import MISSING, field, replace
from pathlib import Path
from typing import Any

from .design import STEPS, Design
from .sheet.errors import BadInput, InputError
from .sheet.quantity import Key, Quantity, keys
from .sheet.record import record
from .sheet.text import Text
from .sheet.value import linked

LARGEST_FILE = 1_000_000  # bytes; a design has a few thousand
NAME = re.compile(r"[A-Za-z0-9-]+\Z")
Table = dict[str, Any]


@record
class Document:
    """The tables of a design file in the units of their keys, where each key stands, and the bytes."""

    data: Table
    place: str = "design"
    lines: dict[str, int] = field(default_factory=dict)
    raw: bytes = b""  # of the file as it was read

    @property
    def sha256(self) -> str:
        """What the bytes of the file hash to; empty for a design that was never in a file."""
        import hashlib

        return hashlib.sha256(self.raw).hexdigest() if self.raw else ""

    def with_value(self, key: str, value: Any) -> "Document":
        """The same document with one key changed (`bearings.front.length_mm`, `gears.wheels.shaft.teeth`); None takes it out.

        A table, or an element of an array of tables, is changed whole by a table, an array by a list of tables.
        """
        whole = value is None or isinstance(value, dict) or (isinstance(value, list) and all(isinstance(item, dict) for item in value))
        return replace(self, data=changed(self.data, address(self.data, key, whole), value), lines={**self.lines, key: 0})


# --- reading --------------------------------------------------------------------------------------------------------------
def read(path: Path | str) -> Document:
    """Read a design file.  Raises BadInput where it is no TOML text; what it says is not yet checked."""
    place = str(path)

    def refuse(reason: Text, line: int = 1) -> BadInput:
        return BadInput(place, [InputError(line, "", "", reason)])

    try:
        raw = Path(path).read_bytes()
    except OSError as error:
        raise BadInput(
            place,
            [InputError(0, "", "", Text("cannot be read: {strerror}; give the path of a design file", strerror=error.strerror or error))],
        ) from None
    if len(raw) > LARGEST_FILE:
        raise refuse(Text("is {count} bytes long; a design file has at most {largest_file}", count=len(raw), largest_file=LARGEST_FILE))
    return parse(raw, place)


def parse(raw: bytes, place: str) -> Document:
    """The document in the bytes of a design file."""

    def refuse(reason: Text, line: int = 1) -> BadInput:
        return BadInput(place, [InputError(line, "", "", reason)])

    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise refuse(Text("is not text in UTF-8; a design is a TOML text file"), raw[: error.start].count(b"\n") + 1) from None
    if not text.strip():
        raise refuse(Text("is empty; `contralbero new FILE` writes a complete design"))
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        at = re.search(r"at line (\d+)", str(error))
        line = int(at[1]) if at else text.count("\n") + 1
        comma = COMMA.search(text.splitlines()[line - 1]) if line <= len(text.splitlines()) else None
        hint = Text("; decimals are written with a point: {comma}", comma=comma[0].replace(",", ".")) if comma else ""
        raise refuse(Text("is not TOML: {sub}{hint}", sub=re.sub(" *[(]at .*[)]", "", str(error)), hint=hint), line) from None
    except (RecursionError, ValueError) as error:
        raise refuse(Text("is not a design: ") + (Text("nested too deeply") if isinstance(error, RecursionError) else str(error))) from None
    return Document(data, place, key_lines(text), raw)


COMMA = re.compile(r"-?\d+,\d+")  # a decimal comma, which TOML does not know
HEADER = re.compile(r"\s*(\[\[?)([^\[\]]+)\]\]?\s*(?:#.*)?\Z")
ASSIGNMENT = re.compile(r"""\s*((?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*'))*)\s*=""")


def key_lines(text: str) -> dict[str, int]:
    """The line of every key and table of a TOML text; elements of arrays of tables by index (`gears.wheels.0.teeth`)."""
    lines: dict[str, int] = {}
    counts: dict[str, int] = {}
    prefix, depth, quote = "", 0, ""
    for number, line in enumerate(text.splitlines(), 1):
        if quote:
            quote = "" if quote in line else quote
            continue
        if depth == 0 and (header := HEADER.match(line)):
            parts = [p.strip().strip("\"'") for p in header[2].split(".")]
            prefix = ""
            for i, part in enumerate(parts):
                prefix = f"{prefix}.{part}" if prefix else part
                if i == len(parts) - 1 and header[1] == "[[":
                    lines.setdefault(prefix, number)
                    counts[prefix] = counts.get(prefix, -1) + 1
                if prefix in counts:
                    prefix = f"{prefix}.{counts[prefix]}"
                lines.setdefault(prefix, number)
            continue
        if depth == 0 and (assignment := ASSIGNMENT.match(line)):
            key = ".".join(p.strip().strip("\"'") for p in assignment[1].split("."))
            lines.setdefault(f"{prefix}.{key}" if prefix else key, number)
            line = line[assignment.end() :]
        for mark in ('"""', "'''"):
            if line.count(mark) % 2:
                quote = mark
        bare = re.sub(r'"(?:\\.|[^"\\])*"|\'[^\']*\'|#.*', "", line)
        depth = max(0, depth + bare.count("[") + bare.count("{") - bare.count("]") - bare.count("}"))
    return lines


# What stands for a wrong or missing value while the rest of the document is checked: no comparison with it holds.
PLACEHOLDER: Table = {
    "number": math.nan, "integer": math.nan, "text": "", "choice": "", "series": (), "integers": (), "table": None, "tables": (),
    "reasons": (),
}  # fmt: skip


# --- checking ---------------------------------------------------------------------------------------------------------------
class _Reader:
    """Walks a document along the Inputs classes and collects every error."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.errors: list[InputError] = []

    def error(self, key: str, value: Any, reason: Text, kind: str = "text") -> Any:
        """Note an error; gives what stands for the wrong value while the rest is checked."""
        self.errors.append(InputError(self.line(key), key, "" if value is None else _written(value), reason))
        return PLACEHOLDER[kind]

    def line(self, key: str) -> int:
        """The line of a key, or of the nearest table around it."""
        while key and key not in self.document.lines:
            key = key.rpartition(".")[0]
        return self.document.lines.get(key, 1) if key else 1

    def inputs(self, cls: type, data: Table, prefix: str, address: str = "") -> Any:
        """One Inputs object.  Where something in it is wrong, a placeholder stands there, so that the rest is still checked.

        `prefix` is its key with elements of arrays by index, `address` that with their names: by it explain says where a number stands.
        """
        known = keys(cls)
        values: Table = {}
        for key in data:
            if key not in known:
                self.error(_join(prefix, key), None, getattr(cls, "REFUSED", {}).get(key) or _unknown(key, known))
        for key, about in known.items():
            if key in data:
                values[about.attribute] = self.value(about.about, data[key], _join(prefix, key), _join(address, key))
            elif about.field.default is not MISSING:
                values[about.attribute] = _keyed(about.about, about.field.default, _join(address, key))
            elif not about.about.optional:
                self.error(_join(prefix, key), None, Text("is missing; needs {allowed}", allowed=about.about.allowed()))
                values[about.attribute] = PLACEHOLDER[about.about.kind]
        made = cls(**values)
        wrong = {error.key for error in self.errors}
        try:
            for key, reason in getattr(made, "problems", lambda: ())():
                if _join(prefix, key) not in wrong:
                    self.error(_join(prefix, key), _plain(data, key), reason)
        except (TypeError, ValueError, AttributeError, LookupError):
            if not wrong:
                raise  # a placeholder may stop a cross-check, nothing else may
        return made

    def value(self, about: Quantity, value: Any, key: str, address: str) -> Any:
        match about.kind:
            case "table":
                if not isinstance(value, dict):
                    return self.error(key, value, Text("must be a table"), "table")
                return self.inputs(about.table, value, key, address)  # type: ignore[arg-type]
            case "tables":
                return self.tables(about, value, key, address)
            case "series" | "integers":
                return _keyed(about, self.series(about, value, key), address)
            case "reasons":
                return self.reasons(value, key)
            case "text" | "choice":
                if about.kind == "choice" and not isinstance(value, (str, bool)) and str(value) in about.choices:
                    return linked(str(value), address)  # a choice that looks like a number, like the property class 8.8
                if not isinstance(value, str) or (about.choices and value not in about.choices):
                    return self.error(key, value, Text("must be {allowed}", allowed=about.allowed()), about.kind)
                return _keyed(about, value, address)
        return _keyed(about, self.number(about, value, key), address)

    def number(self, about: Quantity, value: Any, key: str) -> Any:
        whole = about.kind in ("integer", "integers")
        if isinstance(value, bool) or not isinstance(value, int if whole else (int, float)):
            point = Text("; write {value}", value=value.replace(",", ".")) if isinstance(value, str) and COMMA.fullmatch(value) else ""
            return self.error(key, value, Text("must be {allowed}{point}", allowed=about.allowed(), point=point), "number")
        if abs(value) > 1e300 or not math.isfinite(value):
            return self.error(key, value, Text("must be {allowed}, and finite", allowed=about.allowed()), "number")
        low, high, above = about.low, about.high, about.above
        if (low is not None and value < low) or (high is not None and value > high) or (above is not None and value <= above):
            why = Text("; {negative}", negative=about.negative) if about.negative and value < 0 else ""
            return self.error(key, value, Text("must be {allowed}{why}", allowed=about.allowed(), why=why), "number")
        return value if whole else about.units.inside(float(value))

    def series(self, about: Quantity, value: Any, key: str) -> Any:
        items = value if isinstance(value, list) else [value]
        if about.count and not about.count[0] <= len(items) <= about.count[1]:
            low, high = about.count
            return self.error(
                key,
                value,
                Text(
                    "has {count} entries; needs {low}",
                    count=len(items),
                    low=low if low == high else Text("{low} to {high}", low=low, high=high),
                ),
                "series",
            )
        if not items:
            return self.error(key, value, Text("is empty; needs {allowed}", allowed=about.allowed()), "series")
        return tuple(self.number(about, item, key) for item in items)

    def tables(self, about: Quantity, value: Any, key: str, address: str) -> Any:
        if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
            return self.error(key, value, Text("must be an array of tables: [[") + key + "]]", "tables")
        names = [item.get("name") for item in value]
        made = tuple(
            self.inputs(about.table, item, f"{key}.{i}", f"{address}.{i if name is None else name}")  # type: ignore[arg-type]
            for i, (item, name) in enumerate(zip(value, names))
        )
        addressed = not key.startswith(("oil", "material")) and "name" in keys(about.table)
        for i, name in enumerate(names):
            if isinstance(name, str):
                if addressed and not NAME.match(name):
                    self.error(f"{key}.{i}.name", name, Text("must be made of letters, digits and -, since the element is addressed by it"))
                if name in names[:i]:
                    self.error(f"{key}.{i}.name", name, Text("stands twice; every element needs a name of its own"))
        return made

    def reasons(self, value: Any, key: str) -> tuple[tuple[str, str], ...]:
        if not isinstance(value, dict):
            self.error(key, value, Text("must be a table: [{key}]", key=key))
            return ()
        for id, reason in value.items():
            if not isinstance(reason, str) or not reason.strip():
                self.error(f"{key}.{id}", reason, Text('needs a reason in words, like "seen on the test bench"'))
        return tuple((id, reason.strip()) for id, reason in value.items() if isinstance(reason, str))


def _keyed(about: Quantity, value: Any, address: str) -> Any:
    """A number, or a word that may choose numbers, with the key that it stands under; what only names or tells something has none."""
    if about.kind in ("text", "choice") and (not value or address.rpartition(".")[2] in ("name", "note", "source", "label")):
        return value
    return linked(value, address)


def _plain(data: Any, key: str) -> Any:
    """What stands at a key below this table, if it is a number or a word; else None."""
    for part in key.split("."):
        here = data.get(part) if isinstance(data, dict) else data[int(part)] if isinstance(data, list) and part.isdigit() else None
        data = here
    return data if isinstance(data, (int, float, str)) else None


def design(document: Document) -> Design:
    """The checked design in SI.  Raises BadInput with every error of the document, in the order of its lines."""
    reader = _Reader(document)
    made: Design = reader.inputs(Design, document.data, "")
    if reader.errors:
        raise BadInput(document.place, reader.errors)
    return made


def load(path: Path | str) -> tuple[Document, Design]:
    document = read(path)
    return document, design(document)


# --- addresses and edits ----------------------------------------------------------------------------------------------------
def address(data: Table, key: str, whole: bool = False) -> tuple[str | int, ...]:
    """Where a dotted key stands in the data: elements of arrays by name, else by index.  Raises BadInput with the nearest key.

    With `whole` the key may be that of a table, which else has to be one of a value in it.
    """
    found: list[str | int] = []
    here: Any = data
    cls: type | None = Design
    parts = key.split(".")
    for i, part in enumerate(parts):
        if isinstance(here, list):
            index = next((n for n, item in enumerate(here) if isinstance(item, dict) and item.get("name") == part), None)
            if index is None and part.isascii() and part.isdigit() and int(part[:9]) < len(here):
                index = int(part)
            if index is None:
                names = ", ".join(str(item.get("name", n)) for n, item in enumerate(here) if isinstance(item, dict))
                raise _no_such(key, Text('there is no element "{part}"; there are {names}', part=part, names=names or "none"))
            found.append(index)
            here = here[index]
            continue
        if isinstance(here, tuple):  # a list of numbers, by place
            if not (part.isascii() and part.isdigit() and int(part[:9]) < len(here)) or i + 1 < len(parts):
                raise _no_such(
                    key, Text("has {count} numbers; name one by its place, from 0 to {count2}", count=len(here), count2=len(here) - 1)
                )
            found.append(int(part))
            break
        known = keys(cls) if cls is not None else {}
        if part not in known:
            raise _no_such(key, _unknown(part, known) if known else Text('"{parts}" has no parts', parts=".".join(parts[:i])))
        found.append(part)
        about = known[part].about
        cls = about.table
        if about.kind == "reasons":
            rest = ".".join(parts[i + 1 :])  # an id, which has dots of its own
            if not rest and not whole:
                raise _no_such(key, Text("is a table; name one of its keys: ") + "bearings.front.mckee")
            return (*found, rest) if rest else tuple(found)
        here = here.get(part, [] if about.kind == "tables" else {}) if isinstance(here, dict) else {}
        if about.kind in ("series", "integers") and isinstance(here, list):
            here = tuple(here)
    if cls is not None and not whole:
        raise _no_such(key, Text("is a table; name one of its keys: ") + ", ".join(keys(cls)))
    return tuple(found)


def quantity_of(data: Table, key: str) -> Quantity:
    """The description of the quantity at a dotted key."""
    cls: type = Design
    about: Quantity | None = None
    for part in address(data, key):
        if isinstance(part, str) and part in keys(cls):
            about = keys(cls)[part].about
            cls = about.table or cls
    assert about is not None
    return about


def value_at(data: Table, key: str, whole: bool = False) -> Any:
    """The value at a dotted key as it stands in the file, None where it is left out; with `whole` a table too."""
    here: Any = data
    for part in address(data, key, whole):
        here = here[part] if isinstance(part, int) else here.get(part) if isinstance(here, dict) else None
    return here


def changed(here: Any, where: tuple[str | int, ...], value: Any) -> Any:
    """The same nested tables with one place changed; nothing is changed in place.  None takes the key out."""
    if not where:
        return value
    first, rest = where[0], where[1:]
    if isinstance(here, list):
        gone = not rest and value is None
        return [changed(item, rest, value) if n == first else item for n, item in enumerate(here) if not (gone and n == first)]
    made = dict(here)
    if rest or value is not None:
        made[first] = changed(here.get(first, {}), rest, value)
    else:
        made.pop(first, None)  # None: left out, the program chooses
    return made


def parse_assignment(text: str) -> tuple[str, Any]:
    """`KEY=VALUE` of the command line; VALUE is TOML, or else plain text.  An empty value leaves the key out."""
    key, equals, value = text.partition("=")
    key, value = key.strip(), value.strip()
    if not equals or not key or "\n" in text:
        raise BadInput("--set", [InputError(0, text, "", Text("must be KEY=VALUE, like bearings.front.length_mm=34"))])
    if not value:
        return key, None
    try:
        return key, tomllib.loads(f"v = {value}")["v"]
    except (ValueError, RecursionError):  # TOMLDecodeError is a ValueError; so is a number of 5000 digits
        return key, value


def _no_such(key: str, reason: Text) -> BadInput:
    return BadInput("--set", [InputError(0, key, "", reason)])


def _join(prefix: str, key: str) -> str:
    return f"{prefix}.{key}" if prefix and key else prefix or key


def _unknown(key: str, known: dict[str, Key]) -> Text:
    from difflib import get_close_matches

    near = get_close_matches(key, list(known), 1, 0.5)
    return Text("is not known") + (Text('; did you mean "{near}"?', near=near[0]) if near else Text("; known here are ") + ", ".join(known))


def _written(value: Any) -> str:
    text = (
        f'"{value}"'
        if isinstance(value, str)
        else str(value).lower()
        if isinstance(value, bool)
        else Text("a table")
        if isinstance(value, dict)
        else str(value)
    )
    return text if len(text) <= 60 else text[:57] + "…"


def quantities(data: Table) -> Iterator[tuple[str, Quantity]]:
    """Every key that this document may hold, with its description, in the order of the form."""
    for step in STEPS:
        if step.key in data:
            yield from _quantities(step.inputs, data[step.key], step.key)


def _quantities(cls: type, data: Any, prefix: str) -> Iterator[tuple[str, Quantity]]:
    for key, about in keys(cls).items():
        here = f"{prefix}.{key}"
        content = data.get(key) if isinstance(data, dict) else None
        if about.about.kind == "table":
            yield from _quantities(about.about.table, content or {}, here)  # type: ignore[arg-type]
        elif about.about.kind == "tables":
            for i, item in enumerate(content or []):
                yield from _quantities(about.about.table, item, f"{here}.{item.get('name', i)}")  # type: ignore[arg-type]
        else:
            yield here, about.about
