# SPDX-License-Identifier: Apache-2.0
"""Forgeries of what a document holds: its pages, its fields and signatures, its fonts, files and structure."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from tests.reports.forging import (
    EMPTY,
    PAINT,
    SCRIPT,
    Update,
    both,
    forged_contents,
    forged_pages,
    form_object,
    image_object,
    layer,
    many,
    painted,
    repainted,
    streamed,
)

many(
    "page",
    ("other contents", lambda u: u.entry(u.page(), b"Contents", forged_contents(u))),
    (
        "more contents",
        lambda u: u.swap(
            u.page(),
            rb"/Contents (\d+) 0 R",
            b"/Contents [%d 0 R %s]" % (u.at("/Pages", "/Kids", 0, "/Contents"), forged_contents(u)),
        ),
    ),
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
    (
        "an image within it",
        lambda u: painted(u, after=b"\nq 500 0 0 300 40 400 cm BI /W 1 /H 1 /BPC 8 /CS /RGB ID \0\xff\0 EI Q"),
    ),
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
    (
        "thumbnail",
        lambda u: u.entry(
            u.page(),
            b"Thumb",
            b"%d 0 R" % u.stream(b"\0\xff\0", b"/Width 1 /Height 1 /BitsPerComponent 8 /ColorSpace /DeviceRGB"),
        ),
    ),
    ("description", lambda u: u.entry(u.page(), b"PieceInfo", b"<< /X << /LastModified (D:2026) >> >>")),
    ("viewport", lambda u: u.entry(u.page(), b"VP", b"[<< /BBox [0 0 600 850] /Name (PASS) >>]")),
    ("time on it", lambda u: u.entry(u.page(), b"Dur", b"1")),
    ("template", lambda u: u.entry(u.page(), b"Type", b"/Template")),
    ("another more", lambda u: u.swap(u.at("/Pages"), rb"/Kids \[", b"/Kids [ %d 0 R " % u.add(u.body(u.page())))),
    (
        "another instead",
        lambda u: u.put(
            u.page(), u.body(u.add(u.body(u.page()))).replace(b"/Contents", b"/Contents %s /Old" % forged_contents(u))
        ),
    ),
    ("none", lambda u: u.entry(u.at("/Pages"), b"Kids", b"[]")),
    ("count", lambda u: u.entry(u.at("/Pages"), b"Count", b"0")),
    ("tree", lambda u: u.entry(u.root, b"Pages", forged_pages(u))),
)

many(
    "twice",
    *(
        (
            f"{name} {'before' if first else 'after'}",
            lambda u, m=make, n=at, k=key, f=first: both(u, n(u), k, m(u), first=f),
        )
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
            ("keywords", b"Keywords", lambda u: u.info, lambda u: b"(Contralbero 0.2.0)"),
            ("structure", b"StructTreeRoot", lambda u: u.root, lambda u: b"<< >>"),
        )
        for first in (True, False)
    ),
    (
        "rectangle of a signature, over the page first",
        lambda u: both(u, u.sign(), b"Rect", b"[0 0 595 842]", first=True),
    ),
    (
        "rectangle of a signature, over the page last",
        lambda u: both(u, u.sign(), b"Rect", b"[0 0 595 842]", first=False),
    ),
    ("kind of a signature", lambda u: both(u, u.sign(), b"Subtype", b"/Stamp", first=False)),
    ("look of a signature", lambda u: both(u, u.sign(), b"AP", b"<< >>", first=True)),
)

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
    (
        "a stamp of one row on the last page",
        lambda u: u.annotate(b"/Subtype /Stamp", len(u.reader.pages) - 1, (10, 10, 20, 20)),
    ),
)


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
    (
        "in slices, each thinner than a hair",
        lambda u: u.form(
            *(
                u.annotate(
                    b"/Subtype /Widget /FT /Sig /T (s%d) /F 132" % n, rect=(50, 600 + n * 0.9, 540, 600.8 + n * 0.9)
                )
                for n in range(200)
            )
        ),
    ),
    ("with a border", lambda u: u.sign(b"/F 132 /Border [0 0 500]")),
    ("under a parent with a script", parent_of_signature(b"/AA << /K " + SCRIPT + b" >>")),
    ("under a parent of two kinds", parent_of_signature(b"/Parent << /FT /Tx >>")),
    ("in a form with XFA", form_with(b"/XFA (<x/>)")),
    ("in a form that calculates", form_with(b"/CO [1 0 R]")),
    ("in a form that is drawn anew", form_with(b"/NeedAppearances true")),
    (
        "and a text field",
        lambda u: u.form(
            *(u.annotate(b"/Subtype /Widget /FT /%s /T (x)" % sort, rect=EMPTY) for sort in (b"Sig", b"Tx"))
        ),
    ),
    ("and a stamp", signed_and(lambda u: u.annotate(b"/Subtype /Stamp"))),
    ("and a crop box", signed_and(lambda u: u.entry(u.page(), b"CropBox", b"[0 0 595 400]"))),
    ("and other contents", signed_and(lambda u: u.entry(u.page(), b"Contents", forged_contents(u)))),
    ("and an action on opening", signed_and(lambda u: u.last(u.root, b"/OpenAction " + SCRIPT))),
    ("and another font", signed_and(lambda u: another_font(u))),
    ("and another title", signed_and(lambda u: u.entry(u.info, b"Title", b"(all checks pass)"))),
)


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
    other = update.add(
        b"<< /Type /Filespec /F (design.toml) /UF (design.toml) /EF << /F %d 0 R /UF %d 0 R >> >>" % (file, file)
    )
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
        b"/EF << /F %d 0 R /UF %s >>"
        % (update.stream(another_speed(update)), b"%d 0 R" % update.at("/AF", 0, "/EF", "/UF")),
    )


def structure(update: Update, role: str) -> int:
    top: Any = update.reader.root_object["/StructTreeRoot"]["/K"]  # type: ignore[index]
    return next(int(one.idnum) for one in top["/K"] if one.get_object()["/S"] == role)


def retitled(update: Update) -> None:
    raw = update.reader.root_object["/Metadata"].get_data()  # type: ignore[attr-defined]
    update.put(
        update.at("/Metadata"),
        streamed(raw.replace(b'default">', b'default">all checks pass '), b"/Type /Metadata /Subtype /XML"),
    )


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
    (
        "a file of another system",
        lambda u: u.swap(specification(u)[0], rb"/EF <<", b"/EF << /DOS %d 0 R " % u.stream(b"x")),
    ),
    ("a file elsewhere", lambda u: u.last(specification(u)[0], b"/FS /URL")),
    (
        "relation of the design",
        lambda u: u.swap(specification(u)[0], rb"/AFRelationship /\w+", b"/AFRelationship /Alternative"),
    ),
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
)
