# SPDX-License-Identifier: Apache-2.0
"""Forgeries of how a file is read: its tables, its bytes, written anew, and without end."""

from __future__ import annotations

import io
import re
import zlib
from collections.abc import Callable
from typing import Any

from pypdf import PdfWriter
from pypdf.annotations import FreeText
from pypdf.generic import ArrayObject, DecodedStreamObject, DictionaryObject, NameObject, NumberObject

from tests.reports.forging import KINDS, PAINT, Update, forged_contents, kind, many, new_root, painted, streamed


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
        b"0000000000 65535 f \n",
        b"0000000000 65535 f \n%d 1\n0000000000 00001 f \n" % update.at("/Pages", "/Kids", 0, "/Contents"),
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
        update.page(),
        body + b"\nendobj\n%d 0 obj\n%s" % (update.page(), body.replace(b"/Contents", b"/Contents %s /Old" % contents)),
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
    update.pdf = pdf.replace(
        found[0], (b"\n%d 0 obj\n%s\nendobj\n" % (number, streamed(PAINT))).ljust(len(found[0]), b"\n")
    )
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
    return pdf.replace(b"\x93\x8c\x8b\x9e", b"\x93\x8c\x8b\x9f", 1)


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
anew("more than a report holds")(lambda writer: writer.add_attachment("other.toml", bytes(10**7)))
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
    (
        "pages",
        lambda u: u.entry(
            u.root, b"Pages", b"%d 0 R" % doubled(u, u.body(u.page()), b"<< /Type /Pages /Count 9 /Kids [@] >>")
        ),
    ),
    ("pages in a circle", lambda u: u.entry(u.at("/Pages"), b"Kids", b"[%d 0 R]" % u.at("/Pages"))),
    (
        "names",
        lambda u: u.swap(
            u.at("/Names"),
            rb"/EmbeddedFiles <<.*?>>",
            b"/EmbeddedFiles %d 0 R" % doubled(u, b"<< /Names [] >>", b"<< /Kids [@] >>"),
        ),
    ),
    (
        "structure",
        lambda u: u.entry(
            u.root, b"StructTreeRoot", b"<< /K %d 0 R >>" % doubled(u, b"<< /S /P >>", b"<< /S /P /K [@] >>")
        ),
    ),
    (
        "forms",
        lambda u: painted(
            u,
            after=b"\n/X Do",
            resources=b"/XObject << /X %d 0 R >>"
            % doubled(u, streamed(b""), b"<< /Length 0 /Resources << /XObject << /A [@] >> >> >>\nstream\n\nendstream"),
        ),
    ),
    ("outline", lambda u: u.entry(u.at("/Outlines", "/First"), b"Next", b"%d 0 R" % u.at("/Outlines", "/First"))),
    (
        "metadata",
        lambda u: u.put(
            u.at("/Metadata"),
            streamed(
                u.reader.root_object["/Metadata"]
                .get_data()
                .replace(b"</rdf:Description>", b"<a>" * 100_000 + b"</a>" * 100_000 + b"</rdf:Description>")
            ),
        ),
    ),
    ("arrays", lambda u: u.last(u.root, b"/Deep " + b"[" * 100_000 + b"]" * 100_000)),
    ("an object that is itself", lambda u: u.put(u.at("/Pages"), b"%d 0 R" % u.at("/Pages"))),
    (
        "contents",
        lambda u: u.entry(
            u.page(), b"Contents", b"%d 0 R" % u.stream(zlib.compress(b"\0" * 400_000_000, 1), b"/Filter /FlateDecode")
        ),
    ),
    (
        "contents packed twice",
        lambda u: u.entry(
            u.page(),
            b"Contents",
            b"%d 0 R"
            % u.stream(zlib.compress(zlib.compress(b"\0" * 90_000_000)), b"/Filter [/FlateDecode /FlateDecode]"),
        ),
    ),
    (
        "names of one object",
        lambda u: u.entry(
            u.page(), b"Contents", b"[%s]" % (b"%d 0 R " % u.at("/Pages", "/Kids", 0, "/Contents") * 100_000)
        ),
    ),
    ("digits", lambda u: u.entry(u.page(), b"Contents", b"%d 0 R" % u.stream(b"1" * 2_000_000))),
    ("brackets", lambda u: u.entry(u.page(), b"Contents", b"%d 0 R" % u.stream(b"/a <<" * 400_000))),
)


@kind("without end: a table of all numbers")
def _(pdf: bytes) -> bytes:
    update = Update(pdf)
    table = update.stream(
        b"", b"/Type /XRef /W [0 0 0] /Index [0 2000000000] /Size 2000000000 /Root %d 0 R" % update.root
    )
    made = update.written()
    return made[: made.rindex(b"startxref")] + b"startxref\n%d\n%%%%EOF\n" % made.index(b"\n%d 0 obj" % table)
