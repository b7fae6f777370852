# SPDX-License-Identifier: Apache-2.0
"""Own checks of what PDF/A-3 level A asks of a report, after the rules that veraPDF publishes (PDFA-3A.xml); no
validator.

Each rule that a report could break is one function that yields what is wrong, under the clause of ISO 19005-3.
"""

import io
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from typing import Any

from fontTools.ttLib import TTFont
from pypdf import PdfReader
from pypdf.generic import IndirectObject

STANDARD = set(
    "Document H1 H2 H3 H4 H5 H6 P L LI Lbl LBody Table TR TH TD TOC TOCI Link Form Figure Formula Caption Span".split()
)
INSIDE = {"L": {"LI"}, "LI": {"Lbl", "LBody"}, "Table": {"TR", "Caption"}, "TR": {"TH", "TD"}, "TOC": {"TOCI"}}
DRAWS = re.compile(rb"(?:^|\s)(?:Tj|TJ|f\*?|S|B|Do)$")
NS = {
    "rdf": "http://www.w3.org/1999/02/22-rdf-syntax-ns#",
    "pdfaid": "http://www.aiim.org/pdfa/ns/id/",
    "dc": "http://purl.org/dc/elements/1.1/",
}
OPERATORS = set("q Q cm w J j d re m l c h f f* S B W n rg RG BT ET Tf Tm Tj Tr BMC BDC EMC Do".split())


def wrong(raw: bytes) -> list[str]:
    """Everything that is wrong with a report."""
    reader = PdfReader(io.BytesIO(raw))
    rules = (
        file_rules(raw, reader),
        about_rules(reader),
        colour_rules(reader),
        file_rules_inside(reader),
        font_rules(reader),
    )
    more = (annotation_rules(reader), content_rules(reader), structure_rules(reader))
    return [one for rule in (*rules, *more) for one in rule]


def file_rules(raw: bytes, reader: PdfReader) -> Iterator[str]:
    if not re.match(rb"%PDF-1\.[0-7]\n%[\x80-\xff]{4}", raw):
        yield "6.1.2 the header"
    if not raw.endswith(b"%%EOF\n") or raw.count(b"%%EOF") != 1:
        yield "6.1.3 the end"
    if "/ID" not in reader.trailer or "/Encrypt" in reader.trailer:
        yield "6.1.3 the trailer"
    for at in re.finditer(rb"(?<![\r\n])endstream", raw):
        yield f"6.1.7 no line's end before endstream at {at.start()}"
    if b"LZWDecode" in raw or b"/Crypt" in raw:
        yield "6.1.7 a filter"
    root = reader.root_object
    for key in ("/AA", "/OpenAction", "/Requirements", "/OCProperties"):
        if key in root:
            yield f"6.5, 6.11 {key} in the catalog"


def about_rules(reader: PdfReader) -> Iterator[str]:
    root = reader.root_object
    stream = root["/Metadata"].get_object()
    packet = stream.get_data()
    if "/Filter" in stream or b"bytes=" in packet or b"encoding=" in packet:
        yield "6.6.2.1 the packet's header"
    said = ET.fromstring(packet.decode())
    if (said.findtext(".//pdfaid:part", None, NS), said.findtext(".//pdfaid:conformance", None, NS)) != ("3", "A"):
        yield "6.6.4 which part and level"
    if said.findtext(".//dc:title/rdf:Alt/rdf:li", None, NS) != reader.metadata.title:  # type: ignore[union-attr]
        yield "6.6.3 another title"
    if not re.fullmatch(r"[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*", str(root.get("/Lang", "?"))):
        yield "6.7.4 the language"
    if set(root.get("/AcroForm", {})) - {"/Fields", "/SigFlags"}:
        yield "6.4.1 a form that is more than fields to sign in"
    if root["/MarkInfo"]["/Marked"].value is not True:  # type: ignore[index]
        yield "6.7.2 not marked"


def colour_rules(reader: PdfReader) -> Iterator[str]:
    intents = [one.get_object() for one in reader.root_object["/OutputIntents"]]  # type: ignore[attr-defined]
    if [one["/S"] for one in intents] != ["/GTS_PDFA1"]:
        yield "6.2.3 the output intent"
    profile = intents[0]["/DestOutputProfile"].get_object()
    raw = profile.get_data()
    kind, space, version, size = raw[12:16], raw[16:20], raw[8], int.from_bytes(raw[:4])
    if (kind, space, size, profile["/N"]) != (b"mntr", b"RGB ", len(raw), 3) or version >= 5:
        yield "6.2.3 the profile's header"


def file_rules_inside(reader: PdfReader) -> Iterator[str]:
    associated = [one.get_object() for one in reader.root_object["/AF"]]  # type: ignore[attr-defined]
    names = reader.root_object["/Names"]["/EmbeddedFiles"]["/Names"]  # type: ignore[index]
    if [str(one["/F"]) for one in associated] and sorted(str(one["/F"]) for one in associated) != [
        str(name) for name in names[::2]
    ]:
        yield "6.8 a file that is not associated"
    for one in associated:
        if not {"/F", "/UF", "/AFRelationship", "/EF", "/Desc"} <= set(one):
            yield f"6.8 what is said of {one['/F']}"
        if not re.fullmatch(r"/[-\w+.]+/[-\w+.]+", one["/EF"]["/F"].get_object()["/Subtype"].replace("#2F", "/")):
            yield f"6.8 the kind of {one['/F']}"
    if associated[0]["/AFRelationship"] != "/Source":
        yield "6.8 the first is the source"


def font_rules(reader: PdfReader) -> Iterator[str]:
    for name, font, codes in used(reader):
        program = font["/FontDescriptor"].get("/FontFile2")
        if program is None or "/ToUnicode" not in font:
            yield f"6.2.11.4 {name} is not embedded"
            continue
        first, last = font["/FirstChar"], font["/LastChar"]
        widths = [float(one) for one in font["/Widths"]]
        letters = dict(re.findall(rb"<([0-9A-F]{2})> <([0-9A-F]+)>", font["/ToUnicode"].get_object().get_data()))
        embedded = TTFont(io.BytesIO(program.get_object().get_data()), lazy=True)
        tables = embedded["cmap"].tables
        glyphs, advances, em = tables[0].cmap, embedded["hmtx"].metrics, embedded["head"].unitsPerEm
        if len(widths) != last - first + 1:
            yield f"6.2.11.2 {name} has {len(widths)} widths"
        if not font["/FontDescriptor"]["/Flags"] & 4 or "/Encoding" in font or len(tables) != 1:
            yield f"6.2.11.6 {name}: a symbolic font with one table of codes and no encoding"
        for code in sorted(codes):
            unicode = letters.get(b"%02X" % code, b"0000")
            if len(unicode) % 4 or unicode in (b"0000", b"FEFF", b"FFFE") or 0xE000 <= int(unicode, 16) < 0xF900:
                yield f"6.2.11.7 {name} {code}: {unicode.decode()}"
            glyph = glyphs.get(code, ".notdef")
            if glyph == ".notdef":
                yield f"6.2.11.8 {name} {code} has no glyph"
            elif abs(advances[glyph][0] * 1000 / em - widths[code - first]) > 1:
                yield f"6.2.11.5 {name} {code}: another width"


def used(reader: PdfReader) -> list[tuple[str, Any, set[int]]]:
    """Every font that is used, with the codes that are set in it."""
    found: dict[int, tuple[str, Any, set[int]]] = {}
    for page in reader.pages:
        fonts: Any = page["/Resources"]["/Font"]  # type: ignore[index]
        name = ""
        for font, codes in re.findall(rb"/(\S+) [\d.]+ Tf|<([0-9a-f]*)> Tj", page.get_contents().get_data()):  # type: ignore[union-attr]
            name = font.decode() or name
            reference = fonts.raw_get(f"/{name}")
            found.setdefault(reference.idnum, (name, reference.get_object(), set()))[2].update(
                bytes.fromhex(codes.decode())
            )
    return list(found.values())


def annotation_rules(reader: PdfReader) -> Iterator[str]:
    for number, page in enumerate(reader.pages, 1):
        for one in (reference.get_object() for reference in page.get("/Annots", [])):
            # what is no link has a look, and does nothing when it is used
            field = one["/Subtype"] == "/Widget" and one.get("/FT") == "/Sig" and set(one["/AP"]) == {"/N"}
            if not (field or one["/Subtype"] == "/Link") or one.get("/F") != 4 or not one.get("/Contents"):
                yield f"6.3 page {number}: {one}"
            if {"/A", "/AA"} & set(one):
                yield f"6.6 page {number}: an action of {one}"


def content_rules(reader: PdfReader) -> Iterator[str]:
    """All that is drawn is marked, and what is no artifact has its element, which knows it."""
    back = tree(reader)[1]
    known: dict[tuple[int, int], str] = {}
    for element in elements(reader):
        for page, kid in contents_of(element):
            known[page, kid] = element["/S"]
    for number, page in enumerate(reader.pages, 1):
        owners = back[page["/StructParents"]]
        place = page.indirect_reference.idnum  # type: ignore[union-attr]
        depth, marks, seen = 0, [], []
        for line in page.get_contents().get_data().splitlines():  # type: ignore[union-attr]
            for word in re.sub(rb"<<.*>>|<[^<>]*>|\[[^]]*\]|/\S+", b"", line).split():
                depth += {b"q": 1, b"Q": -1}.get(word, 0)
                if not re.fullmatch(rb"-?[\d.]+", word) and word.decode() not in OPERATORS:
                    yield f"6.2.2 page {number}: {word!r}"
            if depth > 28:
                yield f"6.1.13 page {number}: too deep"
            if begun := re.match(rb"/(\w+) (?:<</MCID (\d+)>> BDC|<</ActualText <[0-9A-F]+>>> BDC|BMC)$", line):
                role, mark = begun[1].decode(), begun[2]
                marks.append(role)
                if mark:
                    seen.append(int(mark))
                    if (
                        owners[int(mark)].get_object()["/S"] != f"/{role}"
                        or known.get((place, int(mark))) != f"/{role}"
                    ):
                        yield f"6.7.3 page {number}, {int(mark)}: not the element's"
                elif role not in ("Artifact", "Span") or (role == "Artifact" and len(marks) > 1):
                    yield f"6.7.3 page {number}: {role}"
            elif line == b"EMC":
                marks.pop()
            elif DRAWS.search(line) and not marks:
                yield f"6.7.3 page {number}: {line[:60]!r} is neither content nor artifact"
        if (
            marks
            or seen != list(range(len(owners)))
            or sorted(seen) != sorted(mcid for on, mcid in known if on == place)
        ):
            yield f"6.7.3 page {number}: what is marked and what the structure has"


def structure_rules(reader: PdfReader) -> Iterator[str]:
    """Standard types, each inside what it may be in; headings that leave out no level; tables whose rows are of one
    length."""
    level, links = 0, 0
    for element in elements(reader):
        role, kids = element["/S"][1:], [kid for kid in kids_of(element) if isinstance(kid, dict) and "/S" in kid]
        if role not in STANDARD:
            yield f"6.7.3 the type {role}"
        if role in INSIDE and not (
            {kid["/S"][1:] for kid in kids} <= INSIDE[role] and len(kids) == len(kids_of(element))
        ):
            yield f"6.7.3 in {role}: {[kid['/S'] for kid in kids]}"
        if heading := re.fullmatch(r"H(\d)", role):
            if int(heading[1]) > level + 1:
                yield f"a heading of level {heading[1]} after one of level {level}"
            level = int(heading[1])
        if role in ("Figure", "Formula") and not str(element.get("/Alt", "")).strip():
            yield f"6.7.5 a {role} without words"
        if role == "Caption" and (element["/P"].get_object()["/S"] not in ("/Figure", "/Table")):
            yield f"a caption of a {element['/P'].get_object()['/S']}"
        if role == "Table" and any(kid["/S"] == "/Caption" for kid in kids[1:]):
            yield "a caption below the rows of its table"
        lengths = {
            sum(int(cell.get("/A", {}).get("/ColSpan", 1)) for cell in kids_of(line))
            for line in kids
            if line["/S"] == "/TR"
        }
        if role == "Table" and len(lengths) != 1:
            yield "a table whose rows differ in length"
        if role not in ("TD", "TH") and not kids_of(element):
            yield f"6.7.3 an empty {role}"
        links += role in ("Link", "Form")
    if links != sum(len(page.get("/Annots", [])) for page in reader.pages):
        yield "links or fields that are no part of the structure"


def tree(reader: PdfReader) -> tuple[Any, dict[int, Any]]:
    """The root of the structure, and the way back from pages and links to their elements."""
    root: Any = reader.root_object["/StructTreeRoot"]
    numbers = root["/ParentTree"]["/Nums"]
    return root, dict(zip(numbers[::2], numbers[1::2]))


def elements(reader: PdfReader) -> Iterator[Any]:
    """Every element, as it is read."""
    waiting = [tree(reader)[0]["/K"]]
    while waiting:
        element = waiting.pop()
        yield element
        waiting += reversed([kid for kid in kids_of(element) if isinstance(kid, dict) and "/S" in kid])


def kids_of(element: Any) -> list[Any]:
    kids = element.get("/K", [])
    return [
        kid.get_object() if isinstance(kid, IndirectObject) else kid
        for kid in (kids if isinstance(kids, list) else [kids])
    ]


def contents_of(element: Any) -> Iterator[tuple[int, int]]:
    """The marked content of an element: the object of its page, and its number there."""
    for kid in kids_of(element):
        if isinstance(kid, int):
            yield element.raw_get("/Pg").idnum, kid
        elif isinstance(kid, dict) and "/MCID" in kid:
            yield kid.raw_get("/Pg").idnum, kid["/MCID"]
