# SPDX-License-Identifier: Apache-2.0
"""What was appended to a report, if it is written so that all readers find the same objects in it, those that repair a
file too.  A reader forgives much, and each something else: so nothing is forgiven here."""

import re
import zlib
from typing import Any

from ..apart import Refused, demand

WHITE = rb"[\0\t\n\f\r ]"
NUMBER = rb"[+-]?(?:\d{1,10}(?:\.\d{0,20})?|\.\d{1,20})"
STRING = rb"\((?:[^()\\\r]|\\[^\r\n]|\([^()\\\r]*+\))*+\)"
NAME, HEX = rb"/[!-$&'*-.0-;=?-Z\\^-z|~]*+", rb"<[0-9A-Fa-f\t\n\r ]*+>"
WORD = rb"(?:%b|R|true|false|null)(?=[][\0\t\n\f\r /<>()]|$)" % NUMBER  # runs into nothing that comes after it
TOKENS = rb"(?:%b|<<|>>|[][]|%b|%b|%b|%b)*+" % (WHITE, NAME, HEX, STRING, WORD)  # no comments
STREAM = rb"stream\r?\n(?P<data>.*?)endstream%b*" % WHITE
OBJECT = re.compile(rb"%b*([1-9]\d*) 0 obj(?=[\0-\x20<])(%b)(?:%b)?endobj" % (WHITE, TOKENS, STREAM), re.S)
END = re.compile(rb"%b{0,2}startxref%b{1,2}(\d+)%b{1,2}(%%%%EOF)%b{0,2}" % (4 * (WHITE,)))  # near enough to be found
# what a reader looks for that repairs a file; a comment may end before the last word
FOUND = re.compile(rb"(?:\d[\0\s]*+|[\r\n][\0\t\f\v ]*+)obj|startxref|trailer[\0\s]*+<<")
OF_PACKS = {b"Type", b"ObjStm", b"N", b"First", b"Filter", b"FlateDecode", b"Length"}
NEEDED = {"/Type", "/Size", "/W", "/Index", "/Length", "/Prev", "/Root", "/Info"}
Rows = dict[int, tuple[int, int, int]]  # of a table: 1 and where an object stands, or 2, in which pack, at which place


def revisions(raw: bytes, at: int, tables: list[Any], trailer: Any, before: int) -> list[tuple[int, int]]:
    """Where each revision ends behind the first bytes of a file, before and after white space; `tables`: what a reader
    has found for them; `trailer`: of the report, `before`: where its table is.  Raises Refused."""
    found, rows, last, ends = len(FOUND.findall(raw, at)), Rows(), 0, list[tuple[int, int]]()
    while at < len(raw):
        if match := OBJECT.match(raw, at):
            last = match.start(1)
            _object(rows, match)
        elif (match := END.match(raw, at)) and rows and len(ends) < len(tables):
            table = tables[len(ends)]
            demand(int(match[1]) == last and table["/Prev"] == before, "it leads past the report")
            _table(rows, table, trailer, len(raw))
            before, rows = last, Rows()
            ends.append((match.end(2), match.end()))
        else:
            raise Refused("something stands between its objects")
        at, found = match.end(), found - 1
    demand(not found and not rows and len(ends) == len(tables), "something is hidden in it")
    return ends


def _object(rows: Rows, match: re.Match[bytes]) -> None:
    number, head, data = int(match[1]), match[2], match["data"]
    demand(number not in rows, "it has an object twice")
    rows[number] = 1, match.start(1), 0
    if data is None:
        return
    length = _whole(head, b"Length")
    demand(data[length:] in (b"", b"\n", b"\r", b"\r\n"), "it has a stream that is not as long as it says")
    if b"ObjStm" not in head:
        return
    names = set(re.findall(rb"/([^\0\s/<>()\[\]]+)", head))
    demand(names == OF_PACKS and b"#" not in head, "it has objects that are packed in another way")
    packed, first = zlib.decompress(data[:length]), _whole(head, b"First")
    heads = [int(number) for number in packed[:first].split()]
    starts = [*heads[1::2], len(packed) - first]
    right = len(heads) == 2 * _whole(head, b"N") and starts[:1] == [0] and starts == sorted(set(starts))
    right = right and re.fullmatch(TOKENS, packed[first:]) is not None and not {*heads[::2]} & {*rows}
    demand(right and len(set(heads[::2])) == len(heads[::2]), "something is hidden in a pack of objects")
    rows |= {inner: (2, number, n) for n, inner in enumerate(heads[::2])}


def _whole(head: bytes, key: bytes) -> int:
    numbers = re.findall(rb"/%b%b+(\d++)(?!%b+\d)" % (key, WHITE, WHITE), head)
    demand(len(numbers) == 1, "it has a stream that does not say how long it is")
    return int(numbers[0])


def _table(rows: Rows, table: Any, trailer: Any, most: int) -> None:
    """It is a plain stream that names all objects, each once, and no other."""
    kinds, width, more = table["/W"]
    plain = {"/Columns": 1 + width + more, "/Predictor": 12}
    right = (
        NEEDED <= {*table} <= NEEDED | {"/ID", "/Filter", "/DecodeParms"} and kinds == 1 and 0 < width <= 8 >= more >= 0
    )
    right &= table.get("/Filter", "/FlateDecode") == "/FlateDecode" and table.get("/DecodeParms", plain) == plain
    right &= max(rows) < table["/Size"] <= trailer["/Size"] + most
    right &= all(table.raw_get(key) == trailer.raw_get(key) for key in ("/Root", "/Info"))
    demand(right, "its table of objects is not a plain one")
    index = list(table["/Index"])
    numbers = [n for start, count in zip(index[::2], index[1::2]) for n in range(start, start + min(count, most))]
    free, data = 1 + width + more if numbers[:1] == [0] else 0, table.data
    named = b"".join(bytes([a]) + b.to_bytes(width) + c.to_bytes(more) for a, b, c in (rows[n] for n in sorted(rows)))
    right = numbers[free > 0 :] == sorted(rows) and data[free:] == named and (not free or data[0] == 0)
    demand(right, "its table does not name the objects that it has")
