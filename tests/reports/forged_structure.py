# SPDX-License-Identifier: Apache-2.0
"""Forgeries by somebody who signs: the revision with the signature is written by hand, and the signature is sound."""

from __future__ import annotations

import asyncio
import hashlib
import re
import zlib
from collections.abc import Callable
from dataclasses import dataclass

from tests.reports.forging import SCRIPT, Update, forged_contents, kind, new_root, streamed
from tests.reports.signing import signer

ROOM = 2200  # hexadecimal digits of a signature
SIGNATURE = (
    b"<< /Type /Sig /Filter /Adobe.PPKLite /SubFilter /adbe.pkcs7.detached /ByteRange [%s] /Contents <%s> >>"
    % (
        b" " * 40,
        b"0" * ROOM,
    )
)


@dataclass
class Signed(Update):
    """An update that fills a field of the report with a signature; what else it does is signed with it."""

    def __post_init__(self) -> None:
        super().__post_init__()
        fields = self.reader.root_object["/AcroForm"]["/Fields"]  # type: ignore[index]
        self.filled = [int(one.idnum) for one in fields if "/V" not in one.get_object()][-1]
        self.last(self.filled, b"/V %d 0 R" % self.add(SIGNATURE))


def sealed(raw: bytes) -> bytes:
    """With the signature for which there is room."""
    start = raw.rindex(b"<" + b"0" * ROOM)
    return sealed_but(raw, start, start + ROOM + 2)


def sealed_but(raw: bytes, first: int, last: int) -> bytes:
    """With a signature that leaves out some bytes, and says so by a range that may be longer than the file."""
    at = raw.rindex(b"/ByteRange [") + 12
    raw = raw[:at] + (b"0 %d %d %d" % (first, last, len(raw) - first - ROOM - 2)).ljust(40) + raw[at + 40 :]
    digest = hashlib.sha256(raw[:first] + raw[last:]).digest()
    made = asyncio.run(signer().async_sign(digest, "sha256")).dump().hex().encode()
    return raw.replace(b"0" * ROOM, made.ljust(ROOM, b"0"))


def insider(name: str) -> Callable[[Callable[[Signed], bytes]], None]:
    def known(how: Callable[[Signed], bytes]) -> None:
        kind(f"sealed: {name}")(lambda pdf: sealed(how(Signed(pdf))))

    return known


# --- what the signature leaves out
@kind("sealed: all but the first bytes left out")
def _(pdf: bytes) -> bytes:
    """The range ends where the file does not any more, so that the sum of its lengths is right."""
    made = Signed(pdf).written_with_stream()
    return sealed_but(made, 100, len(made))


@kind("sealed: what somebody has signed elsewhere")
def _(pdf: bytes) -> bytes:
    """A letter and its signature, behind a report that its author has never seen."""
    letter = b"1 April: all is well"
    made = Signed(pdf).written_with_stream() + letter
    return sealed_but(made, 0, len(made) - len(letter))


@kind("sealed: bytes left out before it")
def _(pdf: bytes) -> bytes:
    made = Signed(pdf).written_with_stream()
    start = made.rindex(b"<" + b"0" * ROOM)
    return sealed_but(made, start - 90, start + ROOM + 2)


@insider("text behind the end")
def _(u: Signed) -> bytes:
    return u.written_with_stream() + b"5 <script>alert(1)</script>"


@insider("text between objects")
def _(u: Signed) -> bytes:
    return u.written_with_stream().replace(b"\nendobj\n", b"\nendobj\n5 <script>alert(1)</script>\n")


@insider("an end that is long")
def _(u: Signed) -> bytes:
    return u.written_with_stream().replace(b"startxref\n", b"startxref" + b"\n" * 3000)


@insider("an end behind many blanks")
def _(u: Signed) -> bytes:
    return u.written_with_stream() + b"\0" * 1000 + b"\n"


# --- objects that are in no table
def other_page(u: Signed) -> bytes:
    return u.body(u.page()).replace(b"/Contents", b"/Contents %s /Old" % forged_contents(u))


def as_last(made: bytes, number: int, body: bytes) -> bytes:
    """With an object before the table, that is in none."""
    at = max(made.rfind(b"\nxref\n"), made.rfind(b"endobj\n", 0, made.rindex(b"/Type /XRef")) + 6) + 1
    head = b"%d 0 obj\n%s\nendobj\n" % (number, body)
    made = made[:at] + head + made[at:]
    return re.sub(rb"\d+(?=\n%%EOF\n$)", lambda m: b"%d" % (int(m[0]) + len(head)), made)


@insider("an object in no table")
def _(u: Signed) -> bytes:
    return as_last(u.written(), u.page(), u.body(u.page()).replace(b"/Contents", b"/Old"))


@insider("an object twice in a table")
def _(u: Signed) -> bytes:
    """One reader takes the first of them, another the last."""
    body = u.body(u.page())
    u.put(u.page(), body)
    made = u.written()
    at = made.rindex(b"\nxref\n") + 1
    head = b"%d 0 obj\n%s\nendobj\n" % (u.page(), body.replace(b"/Contents", b"/Old"))
    made = made[:at] + head + made[at:].replace(b"f \n", b"f \n%d 1\n%010d 00000 n \n" % (u.page(), at), 1)
    return re.sub(rb"\d+(?=\n%%EOF\n$)", b"%d" % (at + len(head)), made)


# --- how a table is written
def tabled(name: str, old: bytes, new: bytes, *, stream: bool = False) -> None:
    """Another piece in what stands behind the objects; places stay right."""

    @insider(f"table: {name}")
    def _(u: Signed) -> bytes:
        u.put(u.page(), u.body(u.page()))
        made = u.written_with_stream() if stream else u.written()
        at = made.rindex(b"%d 0 obj" % u.next if stream else b"\nxref\n")
        tail, count = re.subn(old, new, made[at:], count=1, flags=re.S)
        assert count
        return made[:at] + tail


tabled("places with a line between digits", rb"\n0(0+)(\d)(\d+)(?= 00000 n)", rb"\n\1\2_\3")
tabled("places with a sign", rb"\n0(\d+)(?= 00000 n)", rb"\n+\1")
tabled("entries that end in a comment", rb"n \n", b"n%\n")
tabled("entries that end in a sign of comment alone", rb" n \n", b" n%%")
tabled("another word", rb"\nxref\n", b"\nxref%\n")
tabled("no catalogue named", rb"/Root \d+ 0 R", b"")
tabled("no description named", rb"/Info \d+ 0 R", b"")
tabled("before named with a sign", rb"/Prev ", b"/Prev +")
tabled("start on a line with its place", rb"startxref\n", b"startxref ")
tabled("start with a line between digits", rb"(startxref\n\d)", rb"\1_")
tabled("no catalogue named in a stream", rb"/Root \d+ 0 R", b"", stream=True)
tabled("no description named in a stream", rb"/Info \d+ 0 R", b"", stream=True)
tabled("fewer objects than there are", rb"/Size \d+", b"/Size 131", stream=True)
tabled("an empty list of parameters", rb"/W ", b"/DecodeParms [null null] /W ", stream=True)
tabled("a filter that does nothing", rb"/W ", b"/Filter /Crypt /W ", stream=True)
tabled("a file elsewhere", rb"/W ", b"/F (x) /W ", stream=True)


def rows(
    name: str, widths: bytes, row: Callable[[int, int, int], bytes], *, packed: bool = False, also: bytes = b""
) -> None:
    """A table in a stream whose rows are written another way; every row stands for one object."""

    @insider(f"rows: {name}")
    def _(u: Signed) -> bytes:
        u.put(u.page(), u.body(u.page()))
        made = u.written_with_stream()
        at = made.rindex(b"%d 0 obj" % u.next)
        old = re.search(rb"/Index \[(.*?)\].*?stream\n(.*?)\nendstream", made[at:], re.S)
        assert old is not None
        numbers = [int(n) for n in old[1].split()[::2]]
        places = [int.from_bytes(old[2][n * 6 + 1 : n * 6 + 5]) for n in range(len(numbers))]
        data = b"".join(row(n, place, u.page()) for n, place in zip(numbers, places))
        tail = re.sub(rb"/W \[.*?\]", b"/W [%s] %s" % (widths, also), made[at:])
        tail = re.sub(rb"/Length \d+", b"/Length %d" % len(data), tail)
        return made[:at] + re.sub(
            rb"stream\n.*\nendstream", lambda _: b"stream\n%s\nendstream" % data, tail, flags=re.S
        )


rows("a width more", b"1 4 1 1", lambda n, at, page: b"\1" + at.to_bytes(4) + b"\0")
rows("places of twelve bytes", b"1 12 1", lambda n, at, page: b"\1" + at.to_bytes(12) + b"\0")
rows("kinds of eight bytes", b"8 4 1", lambda n, at, page: bytes(7) + b"\1" + at.to_bytes(4) + b"\0")
rows("a kind that nobody knows", b"1 4 1", lambda n, at, page: (b"\3" if n == page else b"\1") + at.to_bytes(4) + b"\0")
rows("bits of another width", b"1 4 1", lambda n, at, page: b"\1" + at.to_bytes(4) + b"\0", also=b"/BitsPerComponent 4")


# --- how an object is written
def written(name: str, number: Callable[[Signed], int], old: bytes, new: bytes) -> None:
    """Another piece in an object of the report; what it says is the same for who reads it so."""

    @insider(f"object: {name}")
    def _(u: Signed) -> bytes:
        u.put(number(u), re.sub(old, new, u.body(number(u)), count=1, flags=re.S))
        return u.written_with_stream()


def root(u: Signed) -> int:
    return int(u.root)


def info(u: Signed) -> int:
    return int(u.info)


def said(u: Signed) -> bytes:
    return bytes(u.reader.root_object["/Metadata"].get_data())  # type: ignore[attr-defined]


def page(u: Signed) -> int:
    return u.page()


def metadata(u: Signed) -> int:
    return u.at("/Metadata")


written("pages behind a vertical tabulator", root, rb"(/Pages \d+) 0 R", b"\\1\x0b0 R")
written("contents behind a vertical tabulator", page, rb"(/Contents \d+) 0 R", b"\\1\x0b0 R")
written("a reference that goes on", root, rb"(/AF \[ \d+ 0 R) ", rb"\1")
written("an end of one sign", root, rb">>$", b">@")
written("a title of more bytes", info, rb"/Title \(.*?\)\n", b"")
written("a copy of the page", page, rb"$", b"")
written("another mark", lambda u: u.at("/MarkInfo"), rb"true", b"false")
written("an older version", root, rb">>$", b"/Version /1.0 >>")
written("a form that is drawn anew", lambda u: u.at("/AcroForm"), rb">>$", b"/NeedAppearances true >>")


def retold(name: str, told: Callable[[str], bytes], key: str = "/Title") -> None:
    """What the document says of itself in another spelling."""

    @insider(f"description: {name}")
    def _(u: Signed) -> bytes:
        title = str(u.reader.metadata[key])  # type: ignore[index]
        u.put(u.info, re.sub(rb"/Title [(<].*?[)>]\n", lambda _: b"/Title %s\n" % told(title), u.body(u.info)))
        return u.written_with_stream()


retold("UTF-16, low byte first", lambda title: b"<fffe%s>" % title.encode("utf-16-le").hex().encode())
retold("UTF-8", lambda title: b"<efbbbf%s>" % title.encode().hex().encode())
retold(
    "a comment among digits",
    lambda title: b"<%%%s\n%s>" % (b"PASS ".hex().encode(), title.encode("latin-1").hex().encode()),
)
retold("a line break that one takes out", lambda title: b"(\\\n\n%s)" % title.encode("latin-1"))


@insider("metadata longer than they say")
def _(u: Signed) -> bytes:
    raw = said(u)
    u.put(
        metadata(u),
        streamed(raw, b"/Type /Metadata /Subtype /XML").replace(
            b"\nendstream", b"\n%" + raw.replace(b"\n", b" ").replace(b"sha256", b"SHA256") + b"\nendstream"
        ),
    )
    return u.written_with_stream()


@insider("metadata packed twice")
def _(u: Signed) -> bytes:
    raw = said(u)
    u.put(
        metadata(u),
        streamed(
            raw.hex().encode() + b">",
            b"/Type /Metadata /Subtype /XML /Filter [/Crypt /ASCIIHexDecode] /DecodeParms [null << /Predictor 12 >> null]",
        ),
    )
    return u.written_with_stream()


@insider("metadata elsewhere")
def _(u: Signed) -> bytes:
    raw = said(u)
    u.put(metadata(u), streamed(raw, b"/Type /Metadata /Subtype /XML /F (other.xml) /FFilter /FlateDecode"))
    return u.written_with_stream()


@insider("an object that does not say so")
def _(u: Signed) -> bytes:
    return u.written_with_stream().replace(b"\n%d 0 obj" % u.filled, b"\n%d 0 xyz" % u.filled)


@insider("objects behind blanks")
def _(u: Signed) -> bytes:
    return u.written_with_stream().replace(b"\n%d 0 obj" % u.filled, b"\n%d\n0\nobj" % u.filled)


@insider("a generation with a sign")
def _(u: Signed) -> bytes:
    made = u.written_with_stream()
    old = len(u.pdf)
    return made[:old] + made[old:].replace(b"%d 0 obj" % u.filled, b"%d +0 obj" % u.filled, 1)


# --- what a look asks for
def asked_for(
    name: str, make: Callable[[Signed], int], change: Callable[[Signed, bytes], bytes] = lambda u, made: made
) -> None:
    """Something that the look of the signature asks for, and nobody draws."""

    @insider(f"asked for: {name}")
    def _(u: Signed) -> bytes:
        look = u.stream(
            b"", b"/Type /XObject /Subtype /Form /BBox [0 0 9 9] /Resources << /Properties << /A %d 0 R >> >>" % make(u)
        )
        u.entry(u.filled, b"AP", b"<< /N %d 0 R >>" % look)
        return change(u, u.written_with_stream())


asked_for("a catalogue", lambda u: int(new_root(u).split()[0]))
asked_for("a table", lambda u: u.stream(b"", b"/Type /XRef /W [1 1 1] /Index [0 0] /Size 1 /Root %s" % new_root(u)))
asked_for("a page", lambda u: u.add(other_page(u)))
asked_for(
    "a file",
    lambda u: u.add(
        b"<< /Type /Filespec /F (x.js) /UF (x.js) /EF << /F %d 0 R >> >>" % u.stream(b"x", b"/Type /EmbeddedFile")
    ),
)
asked_for("a script", lambda u: u.add(SCRIPT))
asked_for("a layer", lambda u: u.add(b"<< /Type /OCG /Name (PASS) >>"))
asked_for(
    "a pack of objects",
    lambda u: u.stream(
        b"%d 0 " % u.page() + other_page(u), b"/Type /ObjStm /N 1 /First %d" % (len(b"%d 0 " % u.page()))
    ),
)


@insider("an object of the highest number")
def _(u: Signed) -> bytes:
    u.next = 2_000_000_000
    u.entry(u.filled, b"AP", b"<< /N %d 0 R >>" % u.stream(b"", b"/Type /XObject /Subtype /Form /BBox [0 0 9 9]"))
    return u.written_with_stream()


@insider("encrypted with nothing")
def _(u: Signed) -> bytes:
    made = u.add(
        b"<< /Filter /Standard /V 4 /R 4 /Length 128 /O (%s) /U (%s) /P -1 /CF << >> /StmF /Identity /StrF /Identity >>"
        % (b"o" * 32, b"u" * 32)
    )
    return u.written_with_stream().replace(b"/Prev", b"/Encrypt %d 0 R /Prev" % made)


# --- looks that readers draw beside their field
def look(name: str, form: bytes, entries: bytes = b"/N %d 0 R", flags: bytes = b"4") -> None:
    @insider(f"look: {name}")
    def _(u: Signed) -> bytes:
        made = u.stream(b"0 0 1 rg 0 0 900 900 re f", b"/Type /XObject /Subtype /Form " + form)
        u.entry(u.filled, b"F", flags)
        u.entry(u.filled, b"AP", b"<< %s >>" % (entries % made))
        return u.written_with_stream()


look("neither scaled nor turned", b"/BBox [0 0 900 900]", flags=b"28")
look("without bounds", b"")
look("with bounds that are none", b"/BBox null")
look("with bounds of three", b"/BBox [0 0 9]")
look("of a state without bounds", b"", b"/N << /BBox [0 0 9 9] /Off %d 0 R >>")
look("under the mouse without bounds", b"", b"/N 1 0 R /R %d 0 R")


# --- objects in a stream
def packed(
    u: Signed, small: dict[int, bytes], change: Callable[[bytes], bytes] = lambda data: data, more: bytes = b""
) -> bytes:
    """With objects in a pack, and a table of three kinds of entries."""
    heads, body = b"", b""
    for number, one in small.items():
        heads += b"%d %d " % (number, len(body))
        body += one + b" "
        u.objects.pop(number, None)
    raw = zlib.compress(change(heads + body))
    entries = b"/Type /ObjStm /N %d /First %d /Filter /FlateDecode %s" % (len(small), len(heads), more)
    pack = u.stream(raw, entries)
    out, rows = u.pdf, {}
    for number, one in sorted(u.objects.items()):
        rows[number] = b"\1" + len(out).to_bytes(4) + b"\0"
        out += b"%d 0 obj\n%s\nendobj\n" % (number, one)
    start, table = len(out), u.next
    rows |= {number: b"\2" + pack.to_bytes(4) + n.to_bytes(1) for n, number in enumerate(small)}
    rows[table] = b"\1" + start.to_bytes(4) + b"\0"
    index = b" ".join(b"%d 1" % number for number in sorted(rows))
    names = b"/Size %d /Root %d 0 R /Info %d 0 R /Prev %d" % (table + 1, u.root, u.info, u.start)
    entries = b"/Type /XRef /W [1 4 1] /Index [%s] %s" % (index, names)
    made = streamed(b"".join(rows[number] for number in sorted(rows)), entries)
    return out + b"%d 0 obj\n%s\nendobj\nstartxref\n%d\n%%%%EOF\n" % (table, made, start)


def in_a_pack(pdf: bytes) -> bytes:
    """No forgery: the field stands in a stream of objects, as other programs write it."""
    u = Signed(pdf)
    return sealed(packed(u, {u.filled: u.body(u.filled)}))


def packs(name: str, how: Callable[[Signed], bytes]) -> None:
    insider(f"pack: {name}")(how)


packs("a page that is in no table", lambda u: packed(u, {u.filled: u.body(u.filled) + b" " + other_page(u)}))
packs("a comment", lambda u: packed(u, {u.filled: u.body(u.filled) + b"%\n"}))
packs("a page", lambda u: packed(u, {u.filled: u.body(u.filled), u.page(): other_page(u)}))
packs("more objects than it says", lambda u: packed(u, {u.filled: u.body(u.filled)}, lambda data: b"5 0 " + data))
packs("a pack before", lambda u: packed(u, {u.filled: u.body(u.filled)}, more=b"/Extends %d 0 R" % u.next))
packs("packed otherwise", lambda u: packed(u, {u.filled: u.body(u.filled)}, more=b"/DecodeParms << /Predictor 1 >>"))


@insider("pack: an object that stands in it and beside it")
def _(u: Signed) -> bytes:
    body = u.body(u.filled)
    made = packed(u, {u.filled: body})
    return as_last(made, u.filled, body.replace(b"/Rect [ 393", b"/Rect [ 0"))
