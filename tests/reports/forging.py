# SPDX-License-Identifier: Apache-2.0
"""Reports that somebody has changed: every kind of forgery is a function from the bytes of a report to those of the
forged one.

Most of them append to the file, as a program that signs it does, since that is what may be accepted at all; some write
it anew."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from pypdf import PdfReader
from pypdf.generic import DictionaryObject, StreamObject

Forgery = Callable[[bytes], bytes]
KINDS: dict[str, Forgery] = {}
PAINT = b"q 0 1 0 rg 40 400 500 400 re f Q BT /F1 20 Tf 60 600 Td (PASS) Tj ET"
SCRIPT = b"<< /S /JavaScript /JS (app.alert\\(1\\)) >>"
EMPTY = (300.0, 50.0, 540.0, 54.0)  # a place on the first page where nothing is printed: above the foot


def kind(name: str) -> Callable[[Forgery], Forgery]:
    def known(how: Forgery) -> Forgery:
        assert name not in KINDS
        KINDS[name] = how
        return how

    return known


def many(name: str, *cases: tuple[str, Callable[[Update], object]]) -> None:
    """Several forgeries that append to a report, each named by what it changes."""
    for case, how in cases:

        def forged(pdf: bytes, how: Callable[[Update], object] = how) -> bytes:
            update = Update(pdf)
            how(update)
            return update.written()

        kind(f"{name}: {case}")(forged)


# --- changes that are appended
@dataclass
class Update:
    """What is appended to a report: objects by number, as they stand in the file, and a table of where they are."""

    pdf: bytes
    objects: dict[int, bytes] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.reader = PdfReader(io.BytesIO(self.pdf))
        trailer = self.reader.trailer
        self.root, self.info = trailer.raw_get("/Root").idnum, trailer.raw_get("/Info").idnum
        self.next = int(trailer["/Size"])
        self.start = int(self.pdf.rsplit(b"startxref\n", 1)[1].split()[0])

    def page(self, number: int = 0) -> int:
        reference = self.reader.pages[number].indirect_reference
        assert reference is not None
        return reference.idnum

    def at(self, *path: Any) -> int:
        """The number of the object at the end of a path from the catalogue."""
        here: Any = self.reader.root_object
        reference = None
        for step in path:
            reference = here.raw_get(step) if isinstance(here, DictionaryObject) else here[step]
            here = reference.get_object()
        assert reference is not None
        return int(reference.idnum)

    def body(self, number: int) -> bytes:
        """An object as it stands in the file, or will stand there."""
        if number not in self.objects:
            out = io.BytesIO()
            made = self.reader.get_object(number)
            assert made is not None
            if isinstance(made, StreamObject):  # its dictionary and its data as they are packed
                DictionaryObject(made).write_to_stream(out)
                raw = made._data
                return out.getvalue().removesuffix(b">>") + b"/Length %d >>\nstream\n%s\nendstream" % (len(raw), raw)
            made.write_to_stream(out)
            return out.getvalue()
        return self.objects[number]

    def put(self, number: int, body: bytes) -> int:
        self.objects[number] = body
        return number

    def add(self, body: bytes) -> int:
        self.next += 1
        return self.put(self.next - 1, body)

    def stream(self, data: bytes, entries: bytes = b"") -> int:
        return self.add(streamed(data, entries))

    def first(self, number: int, entries: bytes) -> None:
        """Entries before all others of a dictionary."""
        self.put(number, self.body(number).replace(b"<<", b"<< " + entries + b" ", 1))

    def last(self, number: int, entries: bytes) -> None:
        """Entries after all others of a dictionary."""
        head, _, tail = self.body(number).rpartition(b">>")
        self.put(number, head + b" " + entries + b" >>" + tail)

    def swap(self, number: int, old: bytes, new: bytes) -> None:
        """Another piece in an object, the first that fits; dictionaries stand there as `/Key value`, one a line."""
        body, count = re.subn(old, lambda _: new, self.body(number), count=1, flags=re.S)
        assert count, (old, body)
        self.put(number, body)

    def entry(self, number: int, key: bytes, value: bytes) -> None:
        """An entry of a dictionary that has another value, or is new."""
        body = self.body(number)
        old = re.search(rb"/" + key + rb"[ \n](?:<<.*?>>|\[.*?\]|\(.*?\)|[^/\n]+|/\w+)\n", body, re.S)
        if old is None:
            self.last(number, b"/" + key + b" " + value)
        else:
            self.put(number, body[: old.start()] + b"/" + key + b" " + value + b"\n" + body[old.end() :])

    def annotate(
        self, entries: bytes, page: int = 0, rect: tuple[float, ...] = (50, 600, 500, 700), shown: bytes = PAINT
    ) -> int:
        """Something laid over a page, with a look of its own."""
        x, y, x_2, y_2 = rect
        look = self.stream(shown, b"/Type /XObject /Subtype /Form /BBox [0 0 600 850]")
        made = self.add(
            b"<< /Type /Annot /Rect [%g %g %g %g] /AP << /N %d 0 R >> %s >>" % (x, y, x_2, y_2, look, entries)
        )
        over = self.page(page)
        if b"/Annots" in self.body(over):
            self.put(over, re.sub(rb"(/Annots \[[^\]]*)\]", rb"\g<1> %d 0 R ]" % made, self.body(over)))
        else:
            self.last(over, b"/Annots [ %d 0 R ]" % made)
        return made

    def form(self, *fields: int, entries: bytes = b"/SigFlags 3") -> None:
        known = self.reader.root_object.get("/AcroForm", {}).get("/Fields", [])
        numbers = [*(field.indirect_reference.idnum for field in known), *fields]
        form = b"<< /Fields [%s] %s >>" % (b" ".join(b"%d 0 R" % n for n in numbers), entries)
        self.entry(self.root, b"AcroForm", form)

    def sign(
        self,
        entries: bytes = b"/F 132",
        rect: tuple[float, ...] = EMPTY,
        page: int = 0,
        shown: bytes = b"0 0 1 rg 0 0 600 850 re f",
    ) -> int:
        """The field of a signature."""
        made = self.annotate(
            b"/Subtype /Widget /FT /Sig /T (s%d) /P %d 0 R %s" % (self.next, self.page(page), entries),
            page,
            rect,
            shown,
        )
        self.form(made)
        return made

    def written(
        self, *, prev: int | None = None, trailer: bytes = b"", table: Callable[[dict[int, int]], dict[int, int]] = dict
    ) -> bytes:
        """The report with the objects after it.  `table`: of where they are, to be falsified."""
        out = self.pdf
        places = {}
        for number, body in sorted(self.objects.items()):
            places[number] = len(out)
            out += b"%d 0 obj\n%s\nendobj\n" % (number, body)
        start = len(out)
        out += b"xref\n0 1\n0000000000 65535 f \n"
        for number, place in sorted(table(places).items()):
            out += b"%d 1\n%010d 00000 n \n" % (number, place)
        out += b"trailer\n<< /Size %d /Root %d 0 R /Info %d 0 R /Prev %d %s >>\n" % (
            self.next,
            self.root,
            self.info,
            self.start if prev is None else prev,
            trailer,
        )
        return out + b"startxref\n%d\n%%%%EOF\n" % start

    def written_with_stream(self, generations: Mapping[int, int] | None = None) -> bytes:
        """The same, its table a stream.  `generations`: of objects that are not of the first."""
        out, places = self.pdf, {}
        for number, body in [*sorted(self.objects.items()), (self.next, b"")]:
            places[number] = len(out)
            out += b"%d 0 obj\n%s\nendobj\n" % (number, body) if body else b""
        rows = b"".join(
            b"\1" + places[n].to_bytes(4) + (generations or {}).get(n, 0).to_bytes(1) for n in sorted(places)
        )
        index = b" ".join(b"%d 1" % n for n in sorted(places))
        entries = b"/Type /XRef /W [1 4 1] /Index [%s] /Size %d /Root %d 0 R /Info %d 0 R /Prev %d" % (
            index,
            self.next + 1,
            self.root,
            self.info,
            self.start,
        )
        start = places[self.next]
        return out + b"%d 0 obj\n%s\nendobj\nstartxref\n%d\n%%%%EOF\n" % (self.next, streamed(rows, entries), start)


def streamed(data: bytes, entries: bytes = b"") -> bytes:
    return b"<< /Length %d %s >>\nstream\n%s\nendstream" % (len(data), entries, data)


def marks(update: Update, page: int = 0) -> bytes:
    """The operators of a page."""
    contents = update.reader.pages[page].get_contents()
    assert contents is not None
    return bytes(contents.get_data())


def painted(update: Update, *, before: bytes = b"", after: bytes = b"", resources: bytes = b"") -> None:
    """The page with more drawn on it."""
    update.entry(update.page(), b"Contents", b"%d 0 R" % update.stream(before + marks(update) + after))
    if resources:
        update.swap(update.page(), rb"/Resources <<", b"/Resources << " + resources)


def repainted(old: bytes, new: bytes) -> Callable[[Update], None]:
    def how(update: Update) -> None:
        data, count = re.subn(old, new, marks(update), count=1, flags=re.S)
        assert count
        update.entry(update.page(), b"Contents", b"%d 0 R" % update.stream(data))

    return how


def form_object(update: Update) -> None:
    made = update.stream(PAINT, b"/Type /XObject /Subtype /Form /BBox [0 0 600 850]")
    painted(update, after=b"\nq /Over Do Q", resources=b"/XObject << /Over %d 0 R >>" % made)


def image_object(update: Update) -> None:
    made = update.stream(
        b"\0\xff\0", b"/Type /XObject /Subtype /Image /Width 1 /Height 1 /BitsPerComponent 8 /ColorSpace /DeviceRGB"
    )
    painted(update, after=b"\nq 500 0 0 300 40 400 cm /Over Do Q", resources=b"/XObject << /Over %d 0 R >>" % made)


def layer(update: Update) -> None:
    group = update.add(b"<< /Type /OCG /Name (PASS) >>")
    update.last(update.root, b"/OCProperties << /OCGs [%d 0 R] /D << /ON [%d 0 R] >> >>" % (group, group))
    painted(update, before=b"/OC /L BDC\n", after=b"\nEMC", resources=b"/Properties << /L %d 0 R >>" % group)


def both(update: Update, number: int, key: bytes, value: bytes, *, first: bool) -> None:
    """An entry that stands twice: one reader takes the first, another the last."""
    (update.first if first else update.last)(number, b"/" + key + b" " + value)


def forged_contents(update: Update) -> bytes:
    return b"%d 0 R" % update.stream(PAINT)


def forged_pages(update: Update) -> bytes:
    page = update.add(update.body(update.page()))
    update.entry(page, b"Contents", forged_contents(update))
    pages = update.add(b"<< /Type /Pages /Count 1 /Kids [%d 0 R] >>" % page)
    return b"%d 0 R" % pages


def new_root(update: Update) -> bytes:
    root = update.add(update.body(update.root))
    update.entry(root, b"Pages", forged_pages(update))
    return b"%d 0 R" % root
