# SPDX-License-Identifier: Apache-2.0
"""Reports that somebody has changed: every kind of forgery is a function from the bytes of a report to those of the forged one.

Most of them append to the file, as a program that signs it does, since that is what may be accepted at all; some write it anew.
"""

from __future__ import annotations

import io
import re
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from pypdf import PdfReader, PdfWriter
from pypdf.annotations import FreeText
from pypdf.generic import ArrayObject, DecodedStreamObject, DictionaryObject, NameObject, NumberObject, StreamObject

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

    def annotate(self, entries: bytes, page: int = 0, rect: tuple[float, ...] = (50, 600, 500, 700), shown: bytes = PAINT) -> int:
        """Something laid over a page, with a look of its own."""
        x, y, x_2, y_2 = rect
        look = self.stream(shown, b"/Type /XObject /Subtype /Form /BBox [0 0 600 850]")
        made = self.add(b"<< /Type /Annot /Rect [%g %g %g %g] /AP << /N %d 0 R >> %s >>" % (x, y, x_2, y_2, look, entries))
        over = self.page(page)
        if b"/Annots" in self.body(over):
            self.put(over, re.sub(rb"(/Annots \[[^\]]*)\]", rb"\g<1> %d 0 R ]" % made, self.body(over)))
        else:
            self.last(over, b"/Annots [ %d 0 R ]" % made)
        return made

    def form(self, *fields: int, entries: bytes = b"/SigFlags 3") -> None:
        self.last(self.root, b"/AcroForm << /Fields [%s] %s >>" % (b" ".join(b"%d 0 R" % one for one in fields), entries))

    def sign(
        self, entries: bytes = b"/F 132", rect: tuple[float, ...] = EMPTY, page: int = 0, shown: bytes = b"0 0 1 rg 0 0 600 850 re f"
    ) -> int:
        """The field of a signature."""
        made = self.annotate(b"/Subtype /Widget /FT /Sig /T (s%d) /P %d 0 R %s" % (self.next, self.page(page), entries), page, rect, shown)
        self.form(made)
        return made

    def written(self, *, prev: int | None = None, trailer: bytes = b"", table: Callable[[dict[int, int]], dict[int, int]] = dict) -> bytes:
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
            self.next, self.root, self.info, self.start if prev is None else prev, trailer,
        )  # fmt: skip
        return out + b"startxref\n%d\n%%%%EOF\n" % start

    def written_with_stream(self, generations: Mapping[int, int] | None = None) -> bytes:
        """The same, its table a stream.  `generations`: of objects that are not of the first."""
        out, places = self.pdf, {}
        for number, body in [*sorted(self.objects.items()), (self.next, b"")]:
            places[number] = len(out)
            out += b"%d 0 obj\n%s\nendobj\n" % (number, body) if body else b""
        rows = b"".join(b"\1" + places[n].to_bytes(4) + (generations or {}).get(n, 0).to_bytes(1) for n in sorted(places))
        index = b" ".join(b"%d 1" % n for n in sorted(places))
        entries = b"/Type /XRef /W [1 4 1] /Index [%s] /Size %d /Root %d 0 R /Info %d 0 R /Prev %d" % (
            index, self.next + 1, self.root, self.info, self.start,
        )  # fmt: skip
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
    made = update.stream(b"\0\xff\0", b"/Type /XObject /Subtype /Image /Width 1 /Height 1 /BitsPerComponent 8 /ColorSpace /DeviceRGB")
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


many(
    "page",
    ("other contents", lambda u: u.entry(u.page(), b"Contents", forged_contents(u))),
    ("more contents", lambda u: u.swap(u.page(), rb"/Contents (\d+) 0 R", b"/Contents [%d 0 R %s]" % (u.at("/Pages", "/Kids", 0, "/Contents"), forged_contents(u)))),
    ("painted over", lambda u: painted(u, after=b"\n" + PAINT)),
    ("painted under", lambda u: painted(u, before=PAINT + b"\n")),
    ("clipped", lambda u: painted(u, before=b"0 0 100 100 re W n\n")),
    ("scaled", lambda u: painted(u, before=b"0.5 0 0 0.5 0 0 cm\n")),
    ("text hidden", lambda u: painted(u, before=b"3 Tr\n")),
    ("white text", repainted(rb"BT\b", b"1 g BT 1 1 1 rg")),
    ("a letter", repainted(rb"<([0-9a-f]{2})([0-9a-f]*)> Tj", rb"<\2\1> Tj")),
    ("a word less", repainted(rb"<[0-9a-f]{6,}> Tj", b"<> Tj")),
    ("a form over it", form_object),
    ("an image over it", image_object),
    ("an image within it", lambda u: painted(u, after=b"\nq 500 0 0 300 40 400 cm BI /W 1 /H 1 /BPC 8 /CS /RGB ID \0\xff\0 EI Q")),
    ("a layer", layer),
    ("a mask", lambda u: painted(u, before=b"/M gs\n", resources=b"/ExtGState << /M << /ca 0 /CA 0 >> >>")),
    ("other words to copy", repainted(rb"^", b"/Span << /ActualText (PASS) >> BDC EMC ")),
    ("crop box", lambda u: u.entry(u.page(), b"CropBox", b"[0 0 595 400]")),
    ("media box", lambda u: u.entry(u.page(), b"MediaBox", b"[0 400 595 842]")),
    ("media box by reference", lambda u: u.entry(u.page(), b"MediaBox", b"%d 0 R" % u.add(b"[0 400 595 842]"))),
    ("trim box", lambda u: u.entry(u.page(), b"TrimBox", b"[0 0 595 400]")),
    ("inherited crop box", lambda u: u.entry(u.at("/Pages"), b"CropBox", b"[0 0 595 400]")),
    ("inherited rotation", lambda u: u.entry(u.at("/Pages"), b"Rotate", b"180")),
    ("rotation", lambda u: u.entry(u.page(), b"Rotate", b"90")),
    ("unit", lambda u: u.entry(u.page(), b"UserUnit", b"10")),
    ("group", lambda u: u.entry(u.page(), b"Group", b"<< /S /Transparency /K true >>")),
    ("action", lambda u: u.entry(u.page(), b"AA", b"<< /O " + SCRIPT + b" >>")),
    ("thumbnail", lambda u: u.entry(u.page(), b"Thumb", b"%d 0 R" % u.stream(b"\0\xff\0", b"/Width 1 /Height 1 /BitsPerComponent 8 /ColorSpace /DeviceRGB"))),
    ("description", lambda u: u.entry(u.page(), b"PieceInfo", b"<< /X << /LastModified (D:2026) >> >>")),
    ("viewport", lambda u: u.entry(u.page(), b"VP", b"[<< /BBox [0 0 600 850] /Name (PASS) >>]")),
    ("time on it", lambda u: u.entry(u.page(), b"Dur", b"1")),
    ("template", lambda u: u.entry(u.page(), b"Type", b"/Template")),
    ("another more", lambda u: u.swap(u.at("/Pages"), rb"/Kids \[", b"/Kids [ %d 0 R " % u.add(u.body(u.page())))),
    ("another instead", lambda u: u.put(u.page(), u.body(u.add(u.body(u.page()))).replace(b"/Contents", b"/Contents %s /Old" % forged_contents(u)))),
    ("none", lambda u: u.entry(u.at("/Pages"), b"Kids", b"[]")),
    ("count", lambda u: u.entry(u.at("/Pages"), b"Count", b"0")),
    ("tree", lambda u: u.entry(u.root, b"Pages", forged_pages(u))),
)  # fmt: skip

many(
    "twice",
    *(
        (f"{name} {'before' if first else 'after'}", lambda u, m=make, n=at, k=key, f=first: both(u, n(u), k, m(u), first=f))
        for name, key, at, make in (
            ("contents", b"Contents", lambda u: u.page(), forged_contents),
            ("contents, one escaped", b"#43ontents", lambda u: u.page(), forged_contents),
            ("annotations", b"Annots", lambda u: u.page(), lambda u: b"[]"),
            ("resources", b"Resources", lambda u: u.page(), lambda u: b"<< >>"),
            ("media box", b"MediaBox", lambda u: u.page(), lambda u: b"[0 400 595 842]"),
            ("kids", b"Kids", lambda u: u.at("/Pages"), lambda u: b"[%s]" % forged_pages(u)),
            ("pages", b"Pages", lambda u: u.root, forged_pages),
            ("names", b"Names", lambda u: u.root, lambda u: b"<< >>"),
            ("title", b"Title", lambda u: u.info, lambda u: b"(all checks pass)"),
            ("keywords", b"Keywords", lambda u: u.info, lambda u: b"(Contralbero 0.1.0)"),
            ("structure", b"StructTreeRoot", lambda u: u.root, lambda u: b"<< >>"),
        )
        for first in (True, False)
    ),
    ("rectangle of a signature, over the page first", lambda u: both(u, u.sign(), b"Rect", b"[0 0 595 842]", first=True)),
    ("rectangle of a signature, over the page last", lambda u: both(u, u.sign(), b"Rect", b"[0 0 595 842]", first=False)),
    ("kind of a signature", lambda u: both(u, u.sign(), b"Subtype", b"/Stamp", first=False)),
    ("look of a signature", lambda u: both(u, u.sign(), b"AP", b"<< >>", first=True)),
)  # fmt: skip

many(
    "laid over",
    *(
        (name, lambda u, e=entries: u.annotate(e))
        for name, entries in (
            ("free text", b"/Subtype /FreeText /Contents (PASS) /DA (/Helv 20 Tf)"),
            ("stamp", b"/Subtype /Stamp /Name /Approved"),
            ("note", b"/Subtype /Text /Contents (PASS) /Open true"),
            ("highlight", b"/Subtype /Highlight /QuadPoints [50 700 500 700 50 600 500 600]"),
            ("square", b"/Subtype /Square /IC [0 1 0]"),
            ("ink", b"/Subtype /Ink /InkList [[50 600 500 700]] /BS << /W 80 >>"),
            ("redaction", b"/Subtype /Redact /OverlayText (PASS)"),
            ("watermark", b"/Subtype /Watermark /FixedPrint << /Type /FixedPrint >>"),
            ("file", b"/Subtype /FileAttachment /FS << /Type /Filespec /F (x) >>"),
            ("screen", b"/Subtype /Screen /MK << /CA (PASS) >>"),
            ("printer's mark", b"/Subtype /PrinterMark"),
            ("nothing known", b"/Subtype /Whatever"),
            ("no kind", b""),
            ("popup", b"/Subtype /Popup /Open true /Contents (PASS)"),
            ("link with a look", b"/Subtype /Link /Border [0 0 0] /Dest [null /Fit]"),
            ("link out", b"/Subtype /Link /A << /S /URI /URI (https://example.org) >>"),
            ("text field", b"/Subtype /Widget /FT /Tx /T (x) /V (PASS)"),
            ("button", b"/Subtype /Widget /FT /Btn /T (x) /A " + SCRIPT),
            ("choice", b"/Subtype /Widget /FT /Ch /T (x) /V (PASS) /Opt [(PASS)]"),
            ("stamp that says it is a signature", b"/Subtype /Stamp /FT /Sig"),
        )
    ),
    ("a link that leads elsewhere", lambda u: u.annotate(b"/Subtype /Link /Border [0 0 80] /C [0 1 0] /Dest (page-1)")),
    ("a stamp of one row on the last page", lambda u: u.annotate(b"/Subtype /Stamp", len(u.reader.pages) - 1, (10, 10, 20, 20))),
)  # fmt: skip


def parent_of_signature(entries: bytes) -> Callable[[Update], None]:
    def how(update: Update) -> None:
        made = update.annotate(b"/Subtype /Widget", rect=EMPTY)
        parent = update.add(b"<< /FT /Sig /T (s) /Kids [%d 0 R] %s >>" % (made, entries))
        update.last(made, b"/Parent %d 0 R" % parent)
        update.form(parent)

    return how


def form_with(entries: bytes) -> Callable[[Update], None]:
    def how(update: Update) -> None:
        made = update.annotate(b"/Subtype /Widget /FT /Sig /T (s) /F 132", rect=EMPTY)
        update.form(made, entries=entries)

    return how


def referred(update: Update) -> None:
    made = update.sign()
    update.swap(made, rb"/Rect \[.*?\]", b"/Rect %d 0 R" % update.add(b"[0 0 595 842]"))


def signed_and(change: Callable[[Update], object]) -> Callable[[Update], None]:
    def how(update: Update) -> None:
        update.sign()
        change(update)

    return how


many(
    "signature",
    ("over the page", lambda u: u.sign(rect=(0, 0, 595, 841))),
    ("over the page, corners the other way", lambda u: u.sign(rect=(595, 841, 0, 0))),
    ("beyond the page", lambda u: u.sign(rect=(-2000, -2000, -1000, -1000))),
    ("with no end", lambda u: u.swap(u.sign(), rb"/Rect \[.*?\]", b"/Rect [1e400 50 1e400 54]")),
    ("of three corners", lambda u: u.swap(u.sign(), rb"/Rect \[.*?\]", b"/Rect [300 50 540]")),
    ("by a reference", referred),
    ("that is not scaled with its page", lambda u: u.sign(b"/F 140")),
    ("that is not turned with its page", lambda u: u.sign(b"/F 148")),
    ("with a script", lambda u: u.sign(b"/F 132 /AA << /E " + SCRIPT + b" >>")),
    ("with an action", lambda u: u.sign(b"/F 132 /A " + SCRIPT)),
    ("in a layer", lambda u: u.sign(b"/F 132 /OC << /Type /OCG /Name (x) >>")),
    ("with a note", lambda u: u.sign(b"/F 132 /Popup << /Subtype /Popup /Open true /Contents (PASS) >>")),
    ("in slices, each thinner than a hair", lambda u: u.form(*(u.annotate(b"/Subtype /Widget /FT /Sig /T (s%d) /F 132" % n, rect=(50, 600 + n * 0.9, 540, 600.8 + n * 0.9)) for n in range(200)))),
    ("with a border", lambda u: u.sign(b"/F 132 /Border [0 0 500]")),
    ("under a parent with a script", parent_of_signature(b"/AA << /K " + SCRIPT + b" >>")),
    ("under a parent of two kinds", parent_of_signature(b"/Parent << /FT /Tx >>")),
    ("in a form with XFA", form_with(b"/XFA (<x/>)")),
    ("in a form that calculates", form_with(b"/CO [1 0 R]")),
    ("in a form that is drawn anew", form_with(b"/NeedAppearances true")),
    ("and a text field", lambda u: u.form(*(u.annotate(b"/Subtype /Widget /FT /%s /T (x)" % sort, rect=EMPTY) for sort in (b"Sig", b"Tx")))),
    ("and a stamp", signed_and(lambda u: u.annotate(b"/Subtype /Stamp"))),
    ("and a crop box", signed_and(lambda u: u.entry(u.page(), b"CropBox", b"[0 0 595 400]"))),
    ("and other contents", signed_and(lambda u: u.entry(u.page(), b"Contents", forged_contents(u)))),
    ("and an action on opening", signed_and(lambda u: u.last(u.root, b"/OpenAction " + SCRIPT))),
    ("and another font", signed_and(lambda u: another_font(u))),
    ("and another title", signed_and(lambda u: u.entry(u.info, b"Title", b"(all checks pass)"))),
)  # fmt: skip


# --- what a document has beside its pages
def font(update: Update) -> tuple[int, Any]:
    fonts: Any = update.reader.pages[0]["/Resources"]["/Font"]  # type: ignore[index]
    one = next(fonts.raw_get(name) for name in fonts if "/ToUnicode" in fonts[name])
    return one.idnum, one.get_object()


def another_font(update: Update) -> None:
    _, one = font(update)
    descriptor = one["/FontDescriptor"]
    program = descriptor.raw_get("/FontFile2").idnum
    update.put(program, streamed(descriptor["/FontFile2"].get_data()[:-4] + b"abcd"))


def another_map(update: Update) -> None:
    _, one = font(update)
    update.put(one.raw_get("/ToUnicode").idnum, streamed(one["/ToUnicode"].get_data().replace(b"> <", b"> <00", 1)))


def specification(update: Update, n: int = 0) -> tuple[int, Any]:
    names: Any = update.reader.root_object["/Names"]["/EmbeddedFiles"]["/Names"]  # type: ignore[index]
    return names[2 * n + 1].idnum, names[2 * n + 1].get_object()


def attached(update: Update, n: int) -> bytes:
    return bytes(specification(update, n)[1]["/EF"]["/F"].get_data())


def reattached(update: Update, n: int, raw: bytes) -> None:
    file = specification(update, n)[1]["/EF"].raw_get("/F").idnum
    update.put(file, streamed(raw, b"/Type /EmbeddedFile"))


def another_speed(update: Update) -> bytes:
    return attached(update, 0).replace(b"rated_speed_rpm = ", b"rated_speed_rpm = 1")


def another_verdict(update: Update) -> bytes:
    return re.sub(rb'"(fail|warn|not_verified)"', b'"pass"', attached(update, 1)) + b" "


def another_design(update: Update) -> None:
    """Design, results and keywords that belong together, over the pages of the first design."""
    import hashlib

    raw, solved = another_speed(update), another_verdict(update)
    sums = [hashlib.sha256(one).hexdigest() for one in (attached(update, 0), attached(update, 1), raw, solved)]
    reattached(update, 0, raw)
    reattached(update, 1, solved)
    said = str(update.reader.metadata.keywords).replace(sums[0], sums[2]).replace(sums[1], sums[3])  # type: ignore[union-attr]
    update.entry(update.info, b"Keywords", b"(" + said.encode() + b")")


def hidden_files(update: Update) -> None:
    """A tree of names with children, which readers take instead of, or after, its own names."""
    file = update.stream(another_speed(update), b"/Type /EmbeddedFile")
    other = update.add(b"<< /Type /Filespec /F (design.toml) /UF (design.toml) /EF << /F %d 0 R /UF %d 0 R >> >>" % (file, file))
    kid = update.add(b"<< /Limits [(design.toml) (design.toml)] /Names [(design.toml) %d 0 R] >>" % other)
    update.swap(update.at("/Names"), rb"/EmbeddedFiles <<", b"/EmbeddedFiles << /Kids [%d 0 R] " % kid)


def another_file(update: Update) -> int:
    file = update.stream(b"x = 1", b"/Type /EmbeddedFile")
    return update.add(b"<< /Type /Filespec /F (other.toml) /UF (other.toml) /EF << /F %d 0 R >> >>" % file)


def two_files(update: Update) -> None:
    number, _ = specification(update)
    update.swap(
        number,
        rb"/EF <<.*?>>",
        b"/EF << /F %d 0 R /UF %s >>" % (update.stream(another_speed(update)), b"%d 0 R" % update.at("/AF", 0, "/EF", "/UF")),
    )


def structure(update: Update, role: str) -> int:
    top: Any = update.reader.root_object["/StructTreeRoot"]["/K"]  # type: ignore[index]
    return next(int(one.idnum) for one in top["/K"] if one.get_object()["/S"] == role)


def retitled(update: Update) -> None:
    raw = update.reader.root_object["/Metadata"].get_data()  # type: ignore[attr-defined]
    update.put(update.at("/Metadata"), streamed(raw.replace(b'default">', b'default">all checks pass '), b"/Type /Metadata /Subtype /XML"))


many(
    "document",
    ("font program", another_font),
    ("map to letters", another_map),
    ("widths", lambda u: u.swap(font(u)[0], rb"/Widths \[ \d+", b"/Widths [ 1")),
    ("encoding", lambda u: u.last(font(u)[0], b"/Encoding << /Differences [65 /B] >>")),
    ("the design", lambda u: reattached(u, 0, another_speed(u))),
    ("the results", lambda u: reattached(u, 1, another_verdict(u))),
    ("another design, results and keywords", another_design),
    ("a design beside the design", hidden_files),
    ("two files of one name", two_files),
    ("a file more", lambda u: u.swap(u.root, rb"/AF \[", b"/AF [ %d 0 R " % another_file(u))),
    ("a file of another system", lambda u: u.swap(specification(u)[0], rb"/EF <<", b"/EF << /DOS %d 0 R " % u.stream(b"x"))),
    ("a file elsewhere", lambda u: u.last(specification(u)[0], b"/FS /URL")),
    ("relation of the design", lambda u: u.swap(specification(u)[0], rb"/AFRelationship /\w+", b"/AFRelationship /Alternative")),
    ("its files", lambda u: u.entry(u.root, b"AF", b"[]")),
    ("its title", lambda u: u.entry(u.info, b"Title", b"(all checks pass)")),
    ("its author", lambda u: u.entry(u.info, b"Author", b"(everybody)")),
    ("its subject", lambda u: u.entry(u.info, b"Subject", b"(all checks pass)")),
    ("more about it", lambda u: u.last(u.info, b"/Approved (all checks pass)")),
    ("metadata", retitled),
    ("metadata of anything", lambda u: u.put(u.at("/Metadata"), streamed(b"<a/>", b"/Type /Metadata /Subtype /XML"))),
    ("language", lambda u: u.entry(u.root, b"Lang", b"(it)")),
    ("how it is shown", lambda u: u.last(u.at("/ViewerPreferences"), b"/HideToolbar true /ViewArea /TrimBox")),
    ("mode", lambda u: u.entry(u.root, b"PageMode", b"/UseAttachments")),
    ("layout", lambda u: u.last(u.root, b"/PageLayout /TwoPageRight")),
    ("page labels", lambda u: u.last(u.root, b"/PageLabels << /Nums [0 << /P (PASS) >>] >>")),
    ("outline", lambda u: u.entry(u.at("/Outlines", "/First"), b"Title", b"(all checks pass)")),
    ("outline with a script", lambda u: u.last(u.at("/Outlines", "/First"), b"/A " + SCRIPT)),
    ("no outline", lambda u: u.entry(u.root, b"Outlines", b"<< >>")),
    ("what a figure shows in words", lambda u: u.last(structure(u, "/H1"), b"/Alt (all checks pass)")),
    ("what a heading says", lambda u: u.last(structure(u, "/H1"), b"/ActualText (all checks pass)")),
    ("roles", lambda u: u.last(u.at("/StructTreeRoot"), b"/RoleMap << /P /Artifact >>")),
    ("no structure", lambda u: u.entry(u.root, b"StructTreeRoot", b"<< >>")),
    ("suspects", lambda u: u.last(u.at("/MarkInfo"), b"/Suspects true")),
    ("action on opening", lambda u: u.last(u.root, b"/OpenAction " + SCRIPT)),
    ("page on opening", lambda u: u.last(u.root, b"/OpenAction [%d 0 R /FitR 0 0 9 9]" % u.page())),
    ("actions", lambda u: u.last(u.root, b"/AA << /WC " + SCRIPT + b" >>")),
    ("scripts by name", lambda u: u.last(u.at("/Names"), b"/JavaScript << /Names [(x) " + SCRIPT + b"] >>")),
    ("pages by name", lambda u: u.last(u.at("/Names"), b"/Pages << /Names [(x) %d 0 R] >>" % u.page())),
    ("looks by name", lambda u: u.last(u.at("/Names"), b"/AP << /Names [] >>")),
    ("base of links", lambda u: u.last(u.root, b"/URI << /Base (https://example.org) >>")),
    ("collection", lambda u: u.last(u.root, b"/Collection << /View /H /D (design.toml) >>")),
    ("layers", lambda u: u.last(u.root, b"/OCProperties << /OCGs [] /D << >> >>")),
    ("threads", lambda u: u.last(u.root, b"/Threads []")),
    ("legal", lambda u: u.last(u.root, b"/Legal << /Attestation (PASS) >>")),
    ("requirements", lambda u: u.last(u.root, b"/Requirements [<< /S /EnableJavaScripts >>]")),
    ("form", lambda u: u.last(u.root, b"/AcroForm << /Fields [] /XFA (<x/>) >>")),
    ("renditions", lambda u: u.last(u.at("/Names"), b"/Renditions << /Names [] >>")),
    ("permissions", lambda u: u.last(u.root, b"/Perms << /UR3 << /Reference [] >> >>")),
    ("version", lambda u: u.last(u.root, b"/Version /2.0")),
    ("colours", lambda u: u.entry(u.root, b"OutputIntents", b"[]")),
    ("an object that nobody asks for", lambda u: u.add(b"<< /Type /Page >>")),
    ("a part in a stream of objects", lambda u: u.stream(b"1 0 << >>", b"/Type /ObjStm /N 1 /First 4")),
)  # fmt: skip


# --- where a reader looks for what
def tabled(name: str, **how: Any) -> None:
    def forged(pdf: bytes) -> bytes:
        update = Update(pdf)
        update.entry(update.page(), b"Contents", forged_contents(update))
        return update.written(**how)

    kind(f"table: {name}")(forged)


tabled("without what was before", prev=0)
tabled("in a circle", prev=10_000_000)
tabled("that is encrypted", trailer=b"/Encrypt << /Filter /Standard /V 1 /R 2 /O () /U () /P -1 >>")
tabled("with a second table", trailer=b"/XRefStm 15")
tabled("with two catalogues", trailer=b"/Root 1 0 R")
tabled("with none of its objects", table=lambda places: {})
tabled("to other objects", table=lambda places: dict(zip(places, list(places.values())[::-1])))
tabled("to the middle of an object", table=lambda places: {n: at + 3 for n, at in places.items()})
tabled("into the report", table=lambda places: {n: 15 for n in places})


@kind("table: another catalogue")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.root = int(new_root(update).split()[0])
    return update.written()


@kind("table: objects taken out")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.sign()
    made = update.written()
    return made.replace(
        b"0000000000 65535 f \n", b"0000000000 65535 f \n%d 1\n0000000000 00001 f \n" % update.at("/Pages", "/Kids", 0, "/Contents")
    )


@kind("table: another generation")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.sign()
    return update.written().replace(b"\n%d 0 obj" % update.page(), b"\n%d 1 obj" % update.page())


@kind("table: another generation in a stream")
def _(pdf: bytes) -> bytes:
    """What looks for the page by its whole name finds none."""
    update = Update(pdf)
    update.sign()
    return update.written_with_stream({update.page(): 1})


@kind("table: another generation of the catalogue in a stream")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.sign()
    return update.written_with_stream({update.root: 1})


@kind("table: an object within an object")
def _(pdf: bytes) -> bytes:
    """Of two objects of one number, one stands in a stream."""
    update = Update(pdf)
    update.sign()
    shadow = b"%d 0 obj\n%s\nendobj\n" % (
        update.page(),
        update.body(update.page()).replace(b"/Contents", b"/Contents %s /Old" % forged_contents(update)),
    )
    update.stream(shadow)
    return update.written()


@kind("table: an object twice")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.sign()
    body = update.body(update.page())
    contents = forged_contents(update)
    update.put(
        update.page(), body + b"\nendobj\n%d 0 obj\n%s" % (update.page(), body.replace(b"/Contents", b"/Contents %s /Old" % contents))
    )
    return update.written()


@kind("table: a stream longer than it says")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.sign()
    made = update.written()
    return made.replace(b"0 0 1 rg 0 0 600 850 re f\nendstream", b"0 0 1 rg 0 0 600 850 re f\nendstream endstream")


@kind("table: an older start named last")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.entry(update.page(), b"Contents", forged_contents(update))
    return update.written() + b"startxref\n%d\n%%%%EOF\n" % update.start


@kind("table: a start in a comment")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    update.sign()
    return update.written().replace(b"startxref", b"%startxref\n1\nstartxref")


def first_forged(pdf: bytes) -> Update:
    """Other contents of the first page in the place of its contents, which are appended as they were."""
    update = Update(pdf)
    number = update.at("/Pages", "/Kids", 0, "/Contents")
    update.put(number, update.body(number))
    found = re.search(rb"\n%d 0 obj.*?endobj\n" % number, pdf, re.S)
    assert found is not None
    update.pdf = pdf.replace(found[0], (b"\n%d 0 obj\n%s\nendobj\n" % (number, streamed(PAINT))).ljust(len(found[0]), b"\n"))
    return update


@kind("table: the right contents, but in no table")
def _(pdf: bytes) -> bytes:
    """Who follows the tables sees the forged ones, who looks for the last of each number does not."""
    return first_forged(pdf).written(table=lambda places: {})


@kind("table: the right contents, but the end leads to the table before")
def _(pdf: bytes) -> bytes:
    update = first_forged(pdf)
    return re.sub(rb"\d+(?=\n%%EOF\n$)", b"%d" % update.start, update.written())


@kind("table: no end leads to it")
def _(pdf: bytes) -> bytes:
    return re.sub(rb"\d+(?=\n%%EOF\n$)", b"9", pdf)


@kind("bytes: after the end")
def _(pdf: bytes) -> bytes:
    return pdf + b"PASS"


@kind("bytes: a blank after the end")
def _(pdf: bytes) -> bytes:
    return pdf + b"\n"


@kind("bytes: many after the end")
def _(pdf: bytes) -> bytes:
    return pdf + b"\0" * 5000


@kind("bytes: before the head")
def _(pdf: bytes) -> bytes:
    return b"#!/bin/sh\n" + pdf


@kind("bytes: another head")
def _(pdf: bytes) -> bytes:
    return pdf.replace(b"%PDF-1.7", b"%PDF-1.4", 1)


@kind("bytes: another comment")
def _(pdf: bytes) -> bytes:
    return pdf.replace(b"ReportLab Generated", b"Somebody  Generated", 1)


@kind("bytes: the end taken off")
def _(pdf: bytes) -> bytes:
    return pdf[:-7]


@kind("bytes: a blank in an object")
def _(pdf: bytes) -> bytes:
    return pdf.replace(b" obj\n<<", b" obj\n <<", 1)


@kind("bytes: two reports")
def _(pdf: bytes) -> bytes:
    return pdf + pdf


@kind("bytes: another document before")
def _(pdf: bytes) -> bytes:
    out = io.BytesIO()
    writer = PdfWriter()
    writer.add_blank_page(595, 842)
    writer.write(out)
    return out.getvalue() + pdf


@kind("bytes: another document after")
def _(pdf: bytes) -> bytes:
    out = io.BytesIO()
    writer = PdfWriter()
    writer.add_blank_page(595, 842)
    writer.write(out)
    return pdf + out.getvalue()


@kind("bytes: other line ends")
def _(pdf: bytes) -> bytes:
    return pdf.replace(b"\n", b"\r\n")


# --- written anew
def anew(name: str) -> Callable[[Callable[[PdfWriter], object]], None]:
    def known(how: Callable[[PdfWriter], object]) -> None:
        def forged(pdf: bytes) -> bytes:
            writer = PdfWriter(clone_from=io.BytesIO(pdf))
            how(writer)
            out = io.BytesIO()
            writer.write(out)
            return out.getvalue()

        kind(f"anew: {name}")(forged)

    return known


anew("as it was")(lambda writer: None)
anew("a page turned")(lambda writer: writer.pages[0].rotate(180))
anew("a text laid over it")(lambda writer: writer.add_annotation(0, FreeText(text="PASS", rect=(100, 600, 300, 700))))
anew("a file more")(lambda writer: writer.add_attachment("other.toml", b"x = 1"))
anew("another title")(lambda writer: writer.add_metadata({"/Title": "all checks pass"}))
anew("encrypted with no password")(lambda writer: writer.encrypt("", algorithm="RC4-128"))
anew("a page less")(lambda writer: writer.root_object["/Pages"]["/Kids"].pop())  # type: ignore[index]


@kind("anew: a reference to another generation")
def _(pdf: bytes) -> bytes:
    return re.sub(rb"(/Contents \d+) 0 R", rb"\1 1 R", KINDS["anew: as it was"](pdf), count=1)


@anew("a number for a truth value")
def _(writer: PdfWriter) -> None:
    writer.root_object["/MarkInfo"][NameObject("/Marked")] = NumberObject(1)  # type: ignore[index]


@anew("a page more, whose only text is laid over it")
def _(writer: PdfWriter) -> None:
    writer.add_blank_page()
    writer.add_annotation(len(writer.pages) - 1, FreeText(text="PASS", rect=(100, 600, 300, 700)))


@anew("a page twice")
def _(writer: PdfWriter) -> None:
    tree: Any = writer.root_object["/Pages"]
    tree["/Kids"].append(tree["/Kids"][0])
    tree[NameObject("/Count")] = NumberObject(len(tree["/Kids"]))


@anew("fewer pages than there are")
def _(writer: PdfWriter) -> None:
    writer.add_blank_page()
    tree: Any = writer.root_object["/Pages"]
    tree[NameObject("/Count")] = NumberObject(len(tree["/Kids"]) - 1)


def unpacked_otherwise(how: Any) -> Callable[[PdfWriter], None]:
    """The same bytes of what letters mean, and another way to unpack them."""

    def changed(writer: PdfWriter) -> None:
        for font in writer.pages[0]["/Resources"]["/Font"].values():  # type: ignore[index]
            font.get_object()["/ToUnicode"].get_object()[NameObject("/DecodeParms")] = how(writer)

    return changed


ROWS = DictionaryObject({NameObject("/Predictor"): NumberObject(12), NameObject("/Columns"): NumberObject(8)})
anew("letters unpacked otherwise")(unpacked_otherwise(lambda writer: ROWS))
anew("letters unpacked otherwise, in a list")(unpacked_otherwise(lambda writer: ArrayObject([ROWS])))
anew("letters unpacked otherwise, by a reference")(unpacked_otherwise(lambda writer: writer._add_object(ROWS)))


@anew("another page")
def _(writer: PdfWriter) -> None:
    stream = DecodedStreamObject()
    stream.set_data(PAINT)
    writer.pages[0][NameObject("/Contents")] = writer._add_object(stream)


# --- what would take a reader for ever, or all its memory
def doubled(update: Update, leaf: bytes, form: bytes) -> int:
    """A tree of which every node names its child twice: 2⁶⁰ leaves."""
    made = update.add(leaf)
    for _ in range(60):
        made = update.add(form.replace(b"@", b"%d 0 R %d 0 R" % (made, made)))
    return made


many(
    "without end",
    ("pages", lambda u: u.entry(u.root, b"Pages", b"%d 0 R" % doubled(u, u.body(u.page()), b"<< /Type /Pages /Count 9 /Kids [@] >>"))),
    ("pages in a circle", lambda u: u.entry(u.at("/Pages"), b"Kids", b"[%d 0 R]" % u.at("/Pages"))),
    ("names", lambda u: u.swap(u.at("/Names"), rb"/EmbeddedFiles <<.*?>>", b"/EmbeddedFiles %d 0 R" % doubled(u, b"<< /Names [] >>", b"<< /Kids [@] >>"))),
    ("structure", lambda u: u.entry(u.root, b"StructTreeRoot", b"<< /K %d 0 R >>" % doubled(u, b"<< /S /P >>", b"<< /S /P /K [@] >>"))),
    ("forms", lambda u: painted(u, after=b"\n/X Do", resources=b"/XObject << /X %d 0 R >>" % doubled(u, streamed(b""), b"<< /Length 0 /Resources << /XObject << /A [@] >> >> >>\nstream\n\nendstream"))),
    ("outline", lambda u: u.entry(u.at("/Outlines", "/First"), b"Next", b"%d 0 R" % u.at("/Outlines", "/First"))),
    (
        "metadata",
        lambda u: u.put(
            u.at("/Metadata"),
            streamed(u.reader.root_object["/Metadata"].get_data().replace(b"</rdf:Description>", b"<a>" * 100_000 + b"</a>" * 100_000 + b"</rdf:Description>")),
        ),
    ),
    ("arrays", lambda u: u.last(u.root, b"/Deep " + b"[" * 100_000 + b"]" * 100_000)),
    ("an object that is itself", lambda u: u.put(u.at("/Pages"), b"%d 0 R" % u.at("/Pages"))),
    ("contents", lambda u: u.entry(u.page(), b"Contents", b"%d 0 R" % u.stream(zlib.compress(b"\0" * 400_000_000, 1), b"/Filter /FlateDecode"))),
    ("contents packed twice", lambda u: u.entry(u.page(), b"Contents", b"%d 0 R" % u.stream(zlib.compress(zlib.compress(b"\0" * 90_000_000)), b"/Filter [/FlateDecode /FlateDecode]"))),
    ("names of one object", lambda u: u.entry(u.page(), b"Contents", b"[%s]" % (b"%d 0 R " % u.at("/Pages", "/Kids", 0, "/Contents") * 100_000))),
    ("digits", lambda u: u.entry(u.page(), b"Contents", b"%d 0 R" % u.stream(b"1" * 2_000_000))),
    ("brackets", lambda u: u.entry(u.page(), b"Contents", b"%d 0 R" % u.stream(b"/a <<" * 400_000))),
)  # fmt: skip


@kind("without end: a table of all numbers")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    table = update.stream(b"", b"/Type /XRef /W [0 0 0] /Index [0 2000000000] /Size 2000000000 /Root %d 0 R" % update.root)
    made = update.written()
    return made[: made.rindex(b"startxref")] + b"startxref\n%d\n%%%%EOF\n" % made.index(b"\n%d 0 obj" % table)
