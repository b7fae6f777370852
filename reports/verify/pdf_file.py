# SPDX-License-Identifier: Apache-2.0
"""The objects of a PDF, read strictly from its first byte to its last (ISO 32000-1, 7.2 to 7.5), and its tables.

Readers of PDF are lenient, each in its own way: of a key that stands twice one takes the first, another the last; one
trusts the table of objects, another looks for them.  What could be read in two ways is refused here.  Time and memory
grow with the file and no faster: objects are read in the order in which they stand, nothing is followed, and there are
limits."""

from __future__ import annotations

import re
import zlib
from dataclasses import dataclass, field
from typing import Any

from calc.design.limits import PDF_BYTES, PDF_DEPTH, PDF_UNPACKED, PDF_VALUES

APART = rb"(?![^\0\t\n\f\r ()<>\[\]{}/%])"  # after a number or a word
BLANK = re.compile(rb"[\0\t\n\f\r ]*+")
TOKEN = re.compile(
    rb"[\0\t\n\f\r ]*+(?:(?P<reference>\d{1,10} \d{1,5} R)"
    + APART
    + rb"|(?P<number>[+-]?+(?:\d{1,40}+(?:\.\d{0,40}+)?|\.\d{1,40}+))"
    + APART
    + rb"|/(?P<name>[^\0\t\n\f\r ()<>\[\]{}/%]*+)|(?P<open>\[|<<)|(?P<close>\]|>>)|<(?P<hex>[0-9A-Fa-f\0\t\n\f\r ]*+)>"
    rb"|(?P<text>\()|(?P<word>true|false|null)" + APART + rb")"
)
HEAD = re.compile(rb"%PDF-\d\.\d[ \t]*(?:\r\n|\n|\r)")
OBJECT = re.compile(rb"(\d{1,10}) (\d{1,5}) obj(?=[\0\t\n\f\r <\[(/])")
COMMENT = re.compile(rb"%[^\r\n]*+")
DATA = re.compile(rb"[\0\t\n\f\r ]*+stream(?:\r\n|\n)")
DATA_END = re.compile(rb"(?:\r\n|\n|\r)?endstream(?=[\0\t\n\f\r ])")
OBJECT_END = re.compile(rb"[\0\t\n\f\r ]*+endobj(?=[\0\t\n\f\r ]|$)")
TABLE = re.compile(
    rb"xref[ \t]*(?:\r\n|\n|\r)((?:\d{1,10} \d{1,10} *(?:\r\n|\n|\r)(?:\d{10} \d{5} [fn](?: \r| \n|\r\n))*+)*+)"
    rb"trailer(?=[\0\t\n\f\r <])"
)
START = re.compile(rb"startxref(?:\r\n|\n|\r)(\d{1,10})(?:\r\n|\n|\r)%%EOF(?=[\r\n]|$)")
ESCAPE = re.compile(rb"\\(?:([0-7]{1,3})|(\r\n|[\n\r])|(.))|\r\n?", re.S)
LETTERS = {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f"}


# of an object: its first byte, or the number of the stream that it is in and which of its objects it is
Place = int | tuple[int, int]
Table = dict[int, Place | None]


class Malformed(Exception):
    """What is not as the standard has it, in words."""


class Name(str):
    """A name, without its solidus."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Reference:
    """Of an object, by its number."""

    number: int
    generation: int = 0


@dataclass(slots=True)
class Stream:
    entries: dict[str, Any]
    packed: bytes
    data: bytes | None = None  # unpacked, as soon as somebody has asked


@dataclass(slots=True)
class Section:
    """What was written in one go: the report, or what a later program appended.

    `places`: of its objects.  `table`: where its table says that they are; None for one that is free.
    """

    places: dict[int, int] = field(default_factory=dict)
    table: Table = field(default_factory=dict)
    trailer: dict[str, Any] = field(default_factory=dict)
    at: int = -1  # of its table, the last if there are more
    tables: int = 0
    start: int = -1  # where it says that the table is
    end: int = -1  # after its last sign
    remarks: int = 0  # comments in it


class Pdf:
    """The objects of a file, the last of each number.  Raises Malformed.

    `start`: where to begin, for what was appended to a file that is known.
    """

    def __init__(self, raw: bytes, start: int = 0) -> None:
        if len(raw) > PDF_BYTES:
            raise Malformed(f"it has {len(raw):,} bytes; at most {PDF_BYTES:,} are read")
        self.raw = raw
        self.objects: dict[int, Any] = {}
        self.places: dict[int, Place] = {}  # of those objects
        self.tables: dict[int, tuple[Table, dict[str, Any]]] = {}  # every table with its trailer, by its place
        self.sections: list[Section] = []
        self._values = 0
        self._unpacked = 0
        self._read(start)

    # --- what there is
    @property
    def trailer(self) -> dict[str, Any]:
        """All of them together, the later before the earlier."""
        return {key: value for section in self.sections for key, value in section.trailer.items()}

    @property
    def root(self) -> dict[str, Any]:
        return self.entries(self.trailer.get("Root"))

    @property
    def info(self) -> dict[str, Any]:
        return self.entries(self.trailer.get("Info"))

    def value(self, of: Any) -> Any:
        """What a reference leads to; anything else is itself."""
        if not isinstance(of, Reference):
            return of
        value = self.objects.get(of.number) if of.generation == 0 else None  # no object is of another
        if isinstance(value, tuple):  # one of a stream of objects that nobody has asked for yet
            data, at = value
            value, _ = self._value(data, at)
            self.objects[of.number] = value
        if isinstance(value, Reference):
            raise Malformed(f"object {of.number} is a reference")
        return value

    def entries(self, of: Any) -> dict[str, Any]:
        """Of a dictionary, or of a stream; of anything else none."""
        value = self.value(of)
        return value.entries if isinstance(value, Stream) else value if isinstance(value, dict) else {}

    def items(self, of: Any) -> list[Any]:
        value = self.value(of)
        return value if isinstance(value, list) else []

    def data(self, of: Any) -> bytes:
        """The data of a stream, unpacked; of anything else none."""
        stream = self.value(of)
        if not isinstance(stream, Stream):
            return b""
        if stream.data is None:
            stream.data = self._unpack(stream)
        return stream.data

    # --- the file
    def _read(self, at: int) -> None:
        raw = self.raw
        if at == 0:
            head = HEAD.match(raw)
            if head is None:
                raise Malformed("it does not begin as a PDF")
            at = head.end()
        section = Section()
        while True:
            at = _end(BLANK, raw, at)
            if at == len(raw):
                break
            if token := OBJECT.match(raw, at):
                at = self._object(section, token)
            elif token := COMMENT.match(raw, at):
                section.remarks += 1
                at = token.end()
            elif token := TABLE.match(raw, at):
                section.at = at
                table = _entries(token[1])
                trailer, at = self._value(raw, token.end())
                if not isinstance(trailer, dict):
                    raise Malformed(f"the trailer at byte {at} is no dictionary")
                self._listed(section, table, trailer)
            elif token := START.match(raw, at):
                section.start, section.end = int(token[1]), token.end()
                self.sections.append(section)
                section, at = Section(), token.end()
            else:
                raise Malformed(f"what stands at byte {at} is no object")
        if section != Section() or not self.sections:
            raise Malformed("it has no end")

    def _object(self, section: Section, token: re.Match[bytes]) -> int:
        number, generation = int(token[1]), int(token[2])
        if number in section.places or generation:
            raise Malformed(
                f"object {number} stands there twice"
                if not generation
                else f"object {number} is of generation {generation}"
            )
        section.places[number] = token.start()
        value, at = self._value(self.raw, token.end())
        if isinstance(value, dict) and (data := DATA.match(self.raw, at)):
            length = value.get("Length")
            if type(length) is not int or not 0 <= length <= len(self.raw):
                raise Malformed(f"object {number} does not say how long it is")
            ends = DATA_END.match(self.raw, data.end() + length)
            if ends is None:
                raise Malformed(f"object {number} is not as long as it says")
            value, at = Stream(value, self.raw[data.end() : data.end() + length]), ends.end()
        self.objects[number], self.places[number] = value, token.start()
        if isinstance(value, Stream) and value.entries.get("Type") == "ObjStm":
            self._unfold(number, value)
        if isinstance(value, Stream) and value.entries.get("Type") == "XRef":
            section.at = token.start()
            self._listed(section, self._table(value), value.entries)
        ends = OBJECT_END.match(self.raw, at)
        if ends is None:
            raise Malformed(f"object {number} has no end")
        return ends.end()

    def _listed(self, section: Section, table: Table, trailer: dict[str, Any]) -> None:
        section.tables += 1
        section.table |= table
        section.trailer |= trailer
        self.tables[section.at] = table, trailer

    def _unfold(self, home: int, stream: Stream) -> None:
        """The objects of a stream; each is read when it is asked for."""
        count: Any = stream.entries.get("N")
        first: Any = stream.entries.get("First")
        data = self.data(stream)
        heads = data[:first].split() if isinstance(first, int) else []
        if (
            not isinstance(count, int)
            or len(heads) != 2 * count
            or not all(head.isdigit() and len(head) <= 10 for head in heads)
        ):
            raise Malformed("a stream of objects does not say where they are")
        self._count(count)
        for n, (number, at) in enumerate(zip(heads[::2], heads[1::2])):
            self.objects[int(number)], self.places[int(number)] = (data, int(first) + int(at)), (home, n)

    def _table(self, stream: Stream) -> Table:
        """Where a stream says that objects are."""
        widths: Any = stream.entries.get("W")
        index: Any = stream.entries.get("Index", [0, stream.entries.get("Size")])
        if not (_numbers(widths) and len(widths) == 3 and sum(widths) and _numbers(index) and len(index) % 2 == 0):
            raise Malformed("the table of objects does not say how it is made")
        data, wide = self.data(stream), sum(widths)
        if len(data) != wide * sum(index[1::2]):
            raise Malformed("the table of objects is not as long as it says")
        self._count(len(data) // wide)
        table: Table = {}
        numbers = (first + n for first, count in zip(index[::2], index[1::2]) for n in range(count))
        for number, at in zip(numbers, range(0, len(data), wide)):
            row, place = data[at : at + wide], widths[0] + widths[1]
            sort = int.from_bytes(row[: widths[0]]) if widths[0] else 1
            if number in table:
                raise Malformed(f"the table of objects has number {number} twice")
            second, other = int.from_bytes(row[widths[0] : place]), int.from_bytes(row[place:])
            here = sort == 1 and not other  # no object is of another generation than 0
            table[number] = second if here else (second, other) if sort == 2 else None
        return table

    # --- values
    def _count(self, more: int = 1) -> None:
        self._values += more
        if self._values > PDF_VALUES:
            raise Malformed(f"it holds more than {PDF_VALUES:,} values")

    def _value(self, data: bytes, at: int, depth: int = 0) -> tuple[Any, int]:
        """The value that begins there, and where it ends."""
        token = TOKEN.match(data, at)
        if token is None or token["close"] or depth > PDF_DEPTH:
            raise Malformed(f"what stands at byte {at} is no value")
        self._count()
        end = token.end()
        match token.lastgroup:
            case "reference":
                number, generation, _ = token["reference"].split()
                return Reference(int(number), int(generation)), end
            case "number":
                digits = token["number"]
                return (float(digits) if b"." in digits else int(digits)), end
            case "name":
                return _name(token["name"]), end
            case "hex":
                digits = token["hex"].translate(None, b"\0\t\n\f\r ")
                return bytes.fromhex((digits + b"0" * (len(digits) % 2)).decode()), end
            case "text":
                return _text(data, end)
            case "word":
                return {b"true": True, b"false": False, b"null": None}[token["word"]], end
        if token["open"] == b"[":
            items, end = self._until(b"]", data, end, depth)
            return items, end
        items, end = self._until(b">>", data, end, depth)
        keys = items[::2]
        if len(items) % 2 or not all(isinstance(key, Name) for key in keys):
            raise Malformed(f"the dictionary that ends at byte {end} is no pairs of names and values")
        if len(set(keys)) < len(keys):
            raise Malformed(f"the dictionary that ends at byte {end} has a key twice")
        return dict(zip(keys, items[1::2])), end

    def _until(self, close: bytes, data: bytes, at: int, depth: int) -> tuple[list[Any], int]:
        items: list[Any] = []
        while True:
            token = TOKEN.match(data, at)
            if token is not None and token["close"]:
                if token["close"] != close:
                    raise Malformed(f"what stands at byte {at} closes something else")
                return items, token.end()
            item, at = self._value(data, at, depth + 1)
            items.append(item)

    def _unpack(self, stream: Stream) -> bytes:
        filters = stream.entries.get("Filter", [])
        filters = filters if isinstance(filters, list) else [filters]
        if not filters:
            data = stream.packed
        elif filters == ["FlateDecode"]:
            work = zlib.decompressobj()
            try:
                data = work.decompress(stream.packed, PDF_UNPACKED - self._unpacked + 1)
            except zlib.error as error:
                raise Malformed(f"a stream can not be unpacked ({error})") from None
            if not work.eof and len(data) + self._unpacked <= PDF_UNPACKED:
                raise Malformed("a stream has no end")
        else:
            raise Malformed("a stream is packed in a way that no report has")
        self._unpacked += len(data)
        if self._unpacked > PDF_UNPACKED:
            raise Malformed(f"its streams hold more than {PDF_UNPACKED:,} bytes")
        how = stream.entries.get("DecodeParms")
        if isinstance(how, list) and len(how) == 1:
            how = how[0]
        if not isinstance(how, dict | None):
            raise Malformed("a stream is packed in a way that no report has")
        return _rows(data, how) if how and how.get("Predictor", 1) != 1 else data


def words(of: Any) -> str:
    """A text for people; as it stands there if it is no text."""
    if not isinstance(of, bytes):
        return "" if of is None else str(of)
    return of[2:].decode("utf-16-be", "replace") if of.startswith(b"\xfe\xff") else of.decode("latin-1")


def _end(pattern: re.Pattern[bytes], raw: bytes, at: int) -> int:
    matched = pattern.match(raw, at)
    return matched.end() if matched is not None else at


def _numbers(of: Any) -> bool:
    return isinstance(of, list) and all(type(number) is int and 0 <= number < 10**10 for number in of)


def _name(raw: bytes) -> Name:
    """With its escapes resolved, so that one name is one name."""
    parts = re.split(rb"#([0-9A-Fa-f]{2})", raw)
    return Name(
        b"".join(bytes.fromhex(part.decode()) if n % 2 else part for n, part in enumerate(parts)).decode("latin-1")
    )


def _text(data: bytes, at: int) -> tuple[bytes, int]:
    """A text in round brackets, of which there may be pairs in it."""
    begin, deep = at, 1
    for mark in re.compile(rb"\\.|[()]", re.S).finditer(data, at):
        deep += {b"(": 1, b")": -1}.get(mark[0], 0)
        if deep == 0:
            return ESCAPE.sub(_plain, data[begin : mark.start()]), mark.end()
    raise Malformed(f"the text at byte {begin} has no end")


def _plain(escape: re.Match[bytes]) -> bytes:
    octal, line, letter = escape.groups()
    if octal:
        return bytes([int(octal, 8) & 255])
    return b"" if line else LETTERS.get(letter, letter) if letter else b"\n"


def _rows(data: bytes, how: dict[str, Any]) -> bytes:
    """Rows of which each is what it differs by from the one above, as tables of objects are written."""
    wide = how.get("Columns")
    bytewise = how.get("Colors", 1) == 1 and how.get("BitsPerComponent", 8) == 8
    if (
        how.get("Predictor") not in (10, 11, 12)
        or not bytewise
        or not isinstance(wide, int)
        or wide < 1
        or len(data) % (wide + 1)
    ):
        raise Malformed("a stream is packed in a way that no report has")
    rows, above = [], bytes(wide)
    for at in range(0, len(data), wide + 1):
        row = data[at + 1 : at + 1 + wide]
        if data[at] not in (0, 2):
            raise Malformed("a stream is packed in a way that no report has")
        above = bytes((a + b) & 255 for a, b in zip(row, above)) if data[at] == 2 else row
        rows.append(above)
    return b"".join(rows)


def _entries(raw: bytes) -> Table:
    """Where a table of lines says that objects are."""
    table: Table = {}
    lines = raw.split(b"\n") if b"\n" in raw else raw.split(b"\r")
    number = 0
    for line in map(bytes.split, lines):
        if len(line) == 2:
            number = int(line[0])
        elif line:
            if number in table:
                raise Malformed(f"the table of objects has number {number} twice")
            table[number] = int(line[0]) if line[2] == b"n" and line[1] == b"00000" else None
            number += 1
    return table


# --- whether the tables of a PDF lead to the objects that stand in it (ISO 32000-1, 7.5.4 to 7.5.8)
# One reader follows the tables, another looks for the objects, and a file can be made so that they find different ones.


def demand_tables(pdf: Pdf) -> None:
    """Raises Malformed if one who follows the tables from the end finds anything but the last object of each number."""
    places: Table = {}
    trailers: list[dict[str, Any]] = []
    at: Any = pdf.sections[-1].start
    while at is not None:
        if type(at) is not int or at not in pdf.tables or len(trailers) == len(pdf.tables):
            raise Malformed("its table of objects is not where it says")
        table, trailer = pdf.tables[at]
        if "XRefStm" in trailer:
            raise Malformed("it has two tables for the same objects")
        for number, place in table.items():
            places.setdefault(number, place)
        trailers.append(trailer)
        at = trailer.get("Prev")
    last_trailer = pdf.trailer
    root, info = last_trailer.get("Root"), last_trailer.get("Info")
    trailer = trailers[0]
    if trailer.get("Root") != root or trailer.get("Info", info) != info:
        raise Malformed("its trailer is not the last one")
    for number in sorted({*places, *pdf.places} - {0}):
        kind = pdf.objects.get(number)
        itself = isinstance(kind, Stream) and kind.entries.get("Type") == "XRef"  # needs not stand in itself
        if places.get(number) != pdf.places.get(number) and not (itself and number not in places):
            raise Malformed(f"object {number} is not where its table says")
