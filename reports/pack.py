# SPDX-License-Identifier: Apache-2.0
"""The objects of a document as the bytes of a file, small ones packed together: the thousands that say what every cell of a table is
take a tenth of the room that they take one by one."""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator
from typing import Any

from reportlab.pdfbase.pdfdoc import PDFFile

from .setting.fonts import unicode_map

EACH = 100  # objects of a pack: a reader unpacks all of them for one
OPEN, PACKED = 1, 2  # kinds of entry in the table of objects


def packed(document: Any) -> bytes:
    """What reportlab's document writes, with streams of objects and their table (PDF 1.5) instead of one object after the other."""
    root, info = document.Reference(document.Catalog), document.Reference(document.info)
    for name in [name for name in document.idToObject if name.startswith("toUnicodeCMap:")]:
        document.idToObject[name].content = unicode_map(document.idToObject[name].content)
    file = PDFFile(document._pdfVersion)
    entries: list[tuple[int, int, int]] = [(0, 0, 65535)]
    small: list[tuple[int, bytes]] = []
    for number, made in _objects(document):
        entries.append((OPEN, 0, 0))
        if made.endswith(b"endstream\n"):
            entries[number] = (OPEN, file.add(_object(number, made.removesuffix(b"endstream\n") + b"\nendstream\n")), 0)
        else:
            small.append((number, made))
    for start in range(0, len(small), EACH):
        some = small[start : start + EACH]
        for n, (number, _) in enumerate(some):
            entries[number] = (PACKED, len(entries), n)
        entries.append((OPEN, file.add(_object(len(entries), _pack(some))), 0))
    at = file.offset
    entries.append((OPEN, at, 0))
    identity = document.ID().partition(b"%")[0].strip()
    said = b"/Root %s /Info %s /ID %s" % (root.format(document), info.format(document), identity)
    file.add(_object(len(entries) - 1, _table(entries, said)))
    file.add(b"startxref\n%d\n%%%%EOF\n" % at)
    return bytes(file.format(document))


def _objects(document: Any) -> Iterator[tuple[int, bytes]]:
    """Every object by its number; writing one may call for others."""
    number = 1
    while number in document.numberToId:
        yield number, document.idToObject[document.numberToId[number]].format(document)
        number += 1


def _object(number: int, made: bytes) -> bytes:
    return b"%d 0 obj\n%sendobj\n" % (number, made)


def _stream(said: bytes, contents: bytes) -> bytes:
    raw = zlib.compress(contents)
    return b"<< %s /Filter /FlateDecode /Length %d >>\nstream\n%s\nendstream\n" % (said, len(raw), raw)


def _pack(some: list[tuple[int, bytes]]) -> bytes:
    heads, at = [], 0
    for number, made in some:
        heads.append(b"%d %d" % (number, at))
        at += len(made) + 1
    first = b" ".join(heads) + b"\n"
    return _stream(b"/Type /ObjStm /N %d /First %d" % (len(some), len(first)), first + b"\n".join(made for _, made in some))


def _table(entries: Iterable[tuple[int, int, int]], said: bytes) -> bytes:
    """Where every object is: each entry as its difference from the one above, which are nearly all alike."""
    rows, above = [], bytes(7)
    for kind, where, n in entries:
        row = bytes([kind]) + where.to_bytes(4) + n.to_bytes(2)
        rows.append(b"\x02" + bytes((a - b) & 255 for a, b in zip(row, above)))
        above = row
    size = b"/Type /XRef /Size %d /W [1 4 2] /DecodeParms << /Predictor 12 /Columns 7 >> " % len(rows)
    return _stream(size + said, b"".join(rows))
