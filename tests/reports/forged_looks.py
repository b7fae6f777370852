# SPDX-License-Identifier: Apache-2.0
"""Forgeries within a revision that is soundly signed: somebody who signs as is right smuggles something in."""

from __future__ import annotations

import re
from collections.abc import Callable

from tests.reports.forging import PAINT, SCRIPT, Update, kind, painted, streamed
from tests.reports.signing import PLACE, sealed

Change = Callable[[Update], object]
BOX = b"/BBox [0 0 155 15]"
FILE = b"<< /Type /Filespec /F (x.exe) /EF << /F %d 0 R >> >>"
TRUE = b"/Type /Metadata /Subtype /XML"


# --- how it is signed
def field(update: Update, n: int = 0) -> int:
    return update.at("/AcroForm", "/Fields", n)


def free(update: Update) -> int:
    """The first field that is not signed."""
    return next(number for number in map(lambda n: field(update, n), range(3)) if b"/V " not in update.body(number))


def value(update: Update, entries: bytes = b"/Type /Sig") -> int:
    """A signature whose contents are still to be written."""
    return update.add(b"<< /Filter /Adobe.PPKLite /SubFilter /adbe.pkcs7.detached %s %s >>" % (PLACE, entries))


def within(
    pdf: bytes,
    how: Change = lambda update: None,
    entries: bytes = b"/Type /Sig",
    written: Callable[[Update], bytes] = Update.written_with_stream,
    begin: int = 0,
) -> bytes:
    """A report with a change and a signature in its first free field, both in one revision."""
    update = Update(pdf)
    signs = free(update)
    how(update)
    update.last(signs, b"/V %d 0 R" % value(update, entries))
    return sealed(written(update), len(pdf), begin)


def smuggled(name: str, how: Change, entries: bytes = b"/Type /Sig") -> None:
    kind(f"smuggled: {name}")(lambda pdf: within(pdf, how, entries))


def behind(name: str, how: Change) -> None:
    """By the second who signs, against the first, whose signature has a look."""
    kind(f"smuggled, the second: {name}")(lambda pdf: within(within(pdf, looks()), how))


# --- the look of a signature
def looks(data: bytes = b"0 0 1 rg 0 0 600 850 re f", entries: bytes = BOX, key: bytes = b"N") -> Change:
    def how(update: Update) -> None:
        made = update.stream(data, b"/Type /XObject /Subtype /Form " + entries)
        update.swap(
            free(update),
            rb"/N \d+ 0 R" if key == b"N" else rb"/AP <<",
            (b"" if key == b"N" else b"/AP << ") + b"/%s %d 0 R" % (key, made),
        )

    return how


def flagged(flags: int) -> Change:
    def how(update: Update) -> None:
        looks()(update)
        update.entry(free(update), b"F", b"%d" % flags)

    return how


def look_of(update: Update) -> int:
    return update.at("/AcroForm", "/Fields", 0, "/AP", "/N")


def look_with_a_file(update: Update) -> None:
    looks(entries=BOX + b" /AF [" + FILE % update.stream(b"MZ", b"/Type /EmbeddedFile") + b"]")(update)


smuggled("a look without a box", looks(PAINT, b""))
smuggled("a look whose box is nothing", looks(PAINT, b"/BBox null"))
smuggled("a look whose box is a name", looks(PAINT, b"/BBox /abc"))
smuggled("a look without a box, shown while it is pressed", looks(PAINT, b"", b"D"))
smuggled("a look with a file", look_with_a_file)
smuggled("a look that is elsewhere", looks(b"", BOX + b" /F << /FS /URL /F (http://example.org/x) >>"))
smuggled("an entry of looks that acts", lambda u: u.swap(free(u), rb"/AP <<", b"/AP << /X " + SCRIPT))
smuggled(
    "a page for a look",
    lambda u: u.swap(free(u), rb"/N \d+ 0 R", b"/N %d 0 R" % u.at("/Pages", "/Kids", 0, "/Contents")),
)
smuggled("a field that is hidden", flagged(2))
smuggled("a field that is not scaled with its page", flagged(12))
smuggled("a field that is not turned with its page", flagged(20))
smuggled("a field that is seen on paper alone", flagged(36))


# --- what a field and its form are
def padded(zeros: int, before: bool) -> Change:
    """Numbers that are longer than some programs read."""

    def how(update: Update) -> None:
        looks()(update)
        found = re.search(rb"/Rect \[(.*?)\]", update.body(free(update)))
        assert found is not None
        sides = [b"0" * zeros + one if before else one + b"0" * zeros for one in found[1].split()]
        update.swap(free(update), rb"/Rect \[.*?\]", b"/Rect [" + b" ".join(sides) + b"]")

    return how


def other_text(key: bytes) -> Change:
    """The same text as PDF 2.0 may write it, which older programs read as other letters."""

    def how(update: Update) -> None:
        holder = update.info if key == b"Title" else free(update)
        said = str(update.reader.get_object(holder)["/" + key.decode()])  # type: ignore[index]
        update.entry(holder, key, b"<EFBBBF%s>" % said.encode().hex().encode())

    return how


def form(entries: bytes) -> Change:
    return lambda update: update.last(update.at("/AcroForm"), entries)


def form_with_a_file(update: Update) -> None:
    form(b"/DR << /X " + FILE % update.stream(b"MZ", b"/Type /EmbeddedFile") + b" >>")(update)


def another_field(entries: bytes, name: bytes = b"/T (Seal)") -> Change:
    """On the first page and in the form."""

    def how(update: Update) -> None:
        made = update.add(b"<< /Type /Annot /Subtype /Widget %s /F 4 /P %d 0 R %s >>" % (name, update.page(), entries))
        update.swap(update.at("/AcroForm"), rb"/Fields \[", b"/Fields [ %d 0 R " % made)
        update.swap(update.page(), rb"/Annots \[", b"/Annots [ %d 0 R " % made)

    return how


def nameless(update: Update) -> None:
    """A field that who looks for fields by their names does not see, asked for by a resource."""
    made = update.add(b"<< /Subtype /Widget /FT /Tx /V (PASS) /Rect [50 300 500 700] /AA << /K " + SCRIPT + b" >> >>")
    update.swap(update.at("/AcroForm"), rb"/Fields \[", b"/Fields [ %d 0 R " % made)
    form(b"/DR << /X %d 0 R >>" % made)(update)


def alike(name: bytes) -> Change:
    return another_field(b"/FT /Sig /Rect [0 0 0 0]", b"/T " + name)


smuggled("a rectangle of long numbers", padded(300, True))
smuggled("a rectangle of numbers with a long tail", padded(300, False))
smuggled("a kind that is a text", lambda u: u.swap(free(u), rb"/Subtype /Widget", b"/Subtype (/Widget)"))
smuggled(
    "a place in the structure that is no whole number",
    lambda u: u.swap(free(u), rb"/StructParent \d+", rb"/StructParent 7.0"),
)
smuggled("what is read out, in other letters", other_text(b"TU"))
smuggled("the name of the field, in other letters", other_text(b"T"))
smuggled("a field that acts and is nowhere", another_field(b"/FT /Sig /Rect [0 0 0 0] /AA << /PO " + SCRIPT + b" >>"))
smuggled(
    "a field of five corners", another_field(b"/FT /Sig /Rect [50 300 500 700 9] /MK << /BG [0 1 0] /CA (PASS) >>")
)
smuggled("a field without a name", nameless)
smuggled("a field of a name with a blank", alike(b"(Prepared )"))
smuggled("a field of a name in UTF-16", alike(b"<FEFF0050007200650070006100720065>"))
smuggled("a field of a Greek name", alike(b"<FEFF03A1007200650070006100720065006400>"))
smuggled("a form that is drawn anew", form(b"/NeedAppearances true"))
smuggled("a form with a file", form_with_a_file)
smuggled("a form that calculates", form(b"/CO [1 0 R]"))
smuggled(
    "the fields in another order",
    lambda u: u.swap(
        u.at("/AcroForm"), rb"/Fields \[ (\d+ 0 R) (\d+ 0 R)", b"/Fields [ %d 0 R %d 0 R" % (field(u, 1), field(u))
    ),
)
smuggled("two fields signed by one", lambda u: u.last(field(u, 2), b"/V %d 0 R" % u.next))
smuggled(
    "a field under a parent",
    lambda u: u.last(free(u), b"/Parent %d 0 R" % u.add(b"<< /FT /Sig /AA << /K " + SCRIPT + b" >> >>")),
)
smuggled(
    "what may be signed", lambda u: u.last(free(u), b"/Lock << /Type /SigFieldLock /Action /All >> /SV << /Type /SV >>")
)


# --- what a document is
smuggled("a structure that is none", lambda u: u.swap(u.at("/MarkInfo"), rb"/Marked true", b"/Marked false"))
smuggled("a structure that is suspect", lambda u: u.last(u.at("/MarkInfo"), b"/Suspects true"))
smuggled(
    "secrets in the store of certificates", lambda u: u.last(u.root, b"/DSS << /Certs [%d 0 R] >>" % u.stream(b"PASS"))
)
smuggled("an extension that acts", lambda u: u.last(u.root, b"/Extensions << /X " + SCRIPT + b" >>"))
smuggled(
    "an extension that nobody reads",
    lambda u: u.last(u.root, b"/Extensions << /X %d 0 R >>" % u.stream(b"PASS")),
)
smuggled("rights of use", lambda u: u.last(u.root, b"/Perms << /UR3 %d 0 R >>" % u.next))
smuggled("a permission that nobody signed", lambda u: u.last(u.root, b"/Perms << /DocMDP << /Type /Sig >> >>"))
smuggled("an older version", lambda u: u.last(u.root, b"/Version /1.4"))
smuggled("a mode that is a text", lambda u: u.swap(u.root, rb"/PageMode /UseOutlines", b"/PageMode (/UseOutlines)"))
smuggled("the title, in other letters", other_text(b"Title"))
smuggled("a program's name that acts", lambda u: u.entry(u.info, b"Producer", SCRIPT))
smuggled("the page again, as it was", lambda u: u.put(u.page(), u.body(u.page())))
smuggled("a table that is none", lambda u: u.stream(b"PASS", b"/Type /XRef"))
smuggled("a signature that acts", lambda u: None, b"/Reason " + SCRIPT)
smuggled("a signature that is a time", lambda u: None, b"/Type /DocTimeStamp")
smuggled("painted over", lambda u: painted(u, after=b"\n" + PAINT))


@kind("smuggled: no word of what the document is")
def _(pdf: bytes) -> bytes:
    def written(update: Update) -> bytes:
        raw = update.written()
        return pdf + raw[len(pdf) :].replace(b"/Info %d 0 R" % update.info, b"")

    return within(pdf, written=written)


def misspelt(old: bytes, new: bytes) -> Callable[[bytes], bytes]:
    """What pyHanko reads and poppler does not, which then looks for the pages elsewhere."""

    def written(update: Update) -> bytes:
        raw = update.written()
        return raw[: len(update.pdf)] + raw[len(update.pdf) :].replace(old, new, 1)

    return lambda pdf: within(pdf, written=written)


kind("smuggled: an object that is none")(misspelt(b" 0 obj", b" 0 ob5"))
kind("smuggled: a row of a table that is none")(misspelt(b" 00000 n \n", b" 00000 nR\n"))


@kind("smuggled: a signature that begins behind the report")
def _(pdf: bytes) -> bytes:
    return within(pdf, begin=len(pdf))


@kind("smuggled: a page in a stream of objects that has it twice")
def _(pdf: bytes) -> bytes:
    """First as it was."""

    def written(update: Update) -> bytes:
        page = update.page()
        right = update.body(page)
        wrong = right.replace(b"/Contents", b"/Contents %d 0 R /Old" % update.stream(PAINT))
        head = b"%d 0 %d %d " % (page, page, len(right) + 1)
        pack = update.stream(head + right + b"\n" + wrong, b"/Type /ObjStm /N 2 /First %d" % len(head))
        raw, at = update.written(), update.next
        places = {int(n): int(to) for n, to in re.findall(rb"\n(\d+) 1\n(\d{10}) 00000 n ", raw[len(pdf) :])}
        start = raw.rindex(b"xref\n0 1\n")
        rows = {n: b"\1" + to.to_bytes(4) + b"\0" for n, to in {**places, at: start}.items()}
        rows[page] = b"\2" + pack.to_bytes(4) + b"\0"
        index = b" ".join(b"%d 1" % n for n in sorted(rows))
        table = b"/Type /XRef /W [1 4 1] /Index [%s] /Size %d /Root %d 0 R /Info %d 0 R /Prev %d" % (
            index,
            at + 1,
            update.root,
            update.info,
            update.start,
        )
        body = streamed(b"".join(rows[n] for n in sorted(rows)), table)
        return raw[:start] + b"%d 0 obj\n%s\nendobj\nstartxref\n%d\n%%%%EOF\n" % (at, body, start)

    return within(pdf, written=written)


# --- what its metadata say
def xmp(old: bytes, new: bytes, entries: bytes = TRUE) -> Change:
    def how(update: Update) -> None:
        said = update.reader.root_object["/Metadata"].get_data()  # type: ignore[attr-defined]
        assert old in said
        update.put(update.at("/Metadata"), streamed(said.replace(old, new, 1), entries))

    return how


ABOUT = b'<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:rights>PASS</dc:rights></rdf:Description>'
END = b"</rdf:RDF>"
smuggled(
    "metadata: twice",
    xmp(END, END + b'<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">' + ABOUT + END),
)
smuggled("metadata: of something else", xmp(END, ABOUT.replace(b'""', b'"x"') + END))
smuggled(
    "metadata: of another kind", xmp(END, b'<dc:PASS rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/"/>' + END)
)
smuggled("metadata: loose words", xmp(END, END + b" all checks pass"))
smuggled("metadata: loose words in a list", xmp(b"<rdf:Alt>", b"<rdf:Alt>PASS"))
smuggled(
    "metadata: a title in another language",
    xmp(b"</rdf:li></rdf:Alt>", b'</rdf:li><rdf:li xml:lang="it">PASS</rdf:li></rdf:Alt>'),
)
smuggled("metadata: a title beside the list", xmp(b"</rdf:li></rdf:Alt>", b"</rdf:li><rdf:_1>PASS</rdf:_1></rdf:Alt>"))
smuggled("metadata: an instruction in the title", xmp(b"</rdf:li></rdf:Alt>", b"<?x PASS?></rdf:li></rdf:Alt>"))
smuggled("metadata: that are elsewhere", xmp(END, END, TRUE + b" /F (x)"))


# --- by the second who signs
behind(
    "another look of the first", lambda u: u.put(look_of(u), streamed(PAINT, b"/Type /XObject /Subtype /Form " + BOX))
)
behind("the first hidden", lambda u: u.entry(field(u), b"F", b"2"))
behind("the first signs what the second does", lambda u: u.entry(field(u), b"V", b"%d 0 R" % u.next))
behind("the first with another value", lambda u: u.put(u.at("/AcroForm", "/Fields", 0, "/V"), b"<< /Type /Sig >>"))


@kind("smuggled, the second: the field of the first emptied")
def _(pdf: bytes) -> bytes:
    def emptied(update: Update) -> None:
        update.swap(field(update), rb"/V \d+ 0 R", b"")

    return within(within(pdf, looks()), emptied)
