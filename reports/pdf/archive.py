# SPDX-License-Identifier: Apache-2.0
"""What makes a report an archive file, PDF/A-3 level A (ISO 19005-3): XMP, colours, structure.

XMP is what it says about itself."""

from __future__ import annotations

import struct
from typing import Any

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFName, PDFStream, PDFString, PDFZCompress

from ..typesetting.tags import Tree

# --- the colour space sRGB as an ICC profile, which says what the colours are wherever the document is printed
# Written here from the numbers of the standard, so that nothing is shipped under another licence and the bytes are
# always the same: primaries, white and curve of IEC 61966-2-1, adapted to D50 by Bradford as ICC.1:2010 (profile
# version 4.3), annex E, has it; the numbers were remembered, and are compared with LittleCMS's own profile by a test.

NAME = "sRGB IEC61966-2.1"
D50 = (0.9642, 1.0, 0.8249)  # the profile connection space's white
PRIMARIES = {
    "r": (0.4360747, 0.2225045, 0.0139322),
    "g": (0.3850649, 0.7168786, 0.0971045),
    "b": (0.1430804, 0.0606169, 0.7141733),
}
# D65 to D50
ADAPTED = (1.0478112, 0.0228866, -0.0501270, 0.0295424, 0.9904844, -0.0170491, -0.0092345, 0.0150436, 0.7521316)
CURVE = (2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045)  # ((a·x + b) to the power of g) from d on, below it c·x


def profile() -> bytes:
    """The profile as bytes: a header, a table of its tags, what they hold."""
    tags = {
        "desc": _words(NAME),
        "cprt": _words("No copyright, use freely"),
        "wtpt": _xyz(D50),
        "chad": b"sf32" + bytes(4) + _fixed(*ADAPTED),
    }
    curve = b"para" + bytes(4) + struct.pack(">HH", 3, 0) + _fixed(*CURVE)
    for letter, primary in PRIMARIES.items():
        tags |= {f"{letter}XYZ": _xyz(primary), f"{letter}TRC": curve}
    at = 128 + 4 + 12 * len(tags)
    table, contents, places = b"", b"", {}
    for name, held in tags.items():
        if held not in places:
            places[held] = at + len(contents)
            contents += held + bytes(-len(held) % 4)
        table += name.encode() + struct.pack(">II", places[held], len(held))
    body = struct.pack(">I", len(tags)) + table + contents
    return _header(128 + len(body)) + body


def _header(size: int) -> bytes:
    # of the specification that it follows; any other would change the bytes
    date = struct.pack(">6H", 2010, 12, 1, 0, 0, 0)
    kinds = struct.pack(">I", size) + bytes(4) + b"\x04\x30\0\0" + b"mntrRGB XYZ " + date + b"acsp"
    return (kinds + bytes(28) + _fixed(*D50)).ljust(128, b"\0")


def _fixed(*numbers: float) -> bytes:
    return struct.pack(f">{len(numbers)}i", *(round(number * 65536) for number in numbers))


def _xyz(numbers: tuple[float, float, float]) -> bytes:
    return b"XYZ " + bytes(4) + _fixed(*numbers)


def _words(words: str) -> bytes:
    raw = words.encode("utf-16-be")
    return b"mluc" + bytes(4) + struct.pack(">II2s2sII", 1, 12, b"en", b"US", len(raw), 28) + raw


# --- what the document says about itself

PART, LEVEL = 3, "A"
SIGNED_BY_APPENDING = 3  # signatures are foreseen, and a program that adds one appends to the file
XMP = """<?xpacket begin="\ufeff" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about=""
 xmlns:pdfaid="http://www.aiim.org/pdfa/ns/id/" xmlns:dc="http://purl.org/dc/elements/1.1/" xmlns:pdf="http://ns.adobe.com/pdf/1.3/"
 xmlns:xmp="http://ns.adobe.com/xap/1.0/">
<pdfaid:part>{part}</pdfaid:part><pdfaid:conformance>{level}</pdfaid:conformance><dc:format>application/pdf</dc:format>
{said}
</rdf:Description></rdf:RDF></x:xmpmeta>
<?xpacket end="w"?>"""  # noqa: E501
ONE = '<dc:{0}><rdf:Alt><rdf:li xml:lang="x-default">{1}</rdf:li></rdf:Alt></dc:{0}>'
LISTED = "<dc:{0}><rdf:{2}><rdf:li>{1}</rdf:li></rdf:{2}></dc:{0}>"
PLAIN = "<{0}>{1}</{0}>"
# xml.sax.saxutils would load the whole of urllib for it
ESCAPED = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;"})


def archive(document: Any, tree: Tree, lang: str) -> None:
    """Add to a document what PDF/A asks for; to be called when all pages are drawn and the document is described."""
    catalog = document.Catalog
    catalog.Metadata = PDFStream(
        PDFDictionary({"Type": PDFName("Metadata"), "Subtype": PDFName("XML")}), xmp(document.info, lang)
    )
    catalog.OutputIntents = PDFArray([_intent(document)])
    catalog.__NoDefault__ = [*catalog.__NoDefault__, "OutputIntents"]
    catalog.MarkInfo = PDFDictionary({"Marked": "true"})
    catalog.StructTreeRoot = tree.finish(document)
    if tree.fields:
        fields = PDFArray([document.refAnnotation(name) for name in tree.fields])
        catalog.AcroForm = PDFDictionary({"Fields": fields, "SigFlags": SIGNED_BY_APPENDING})
    for n in range(len(tree.pages)):
        page = document.idToObject[f"Page{n + 1}"]
        page.__NoDefault__ = [*page.__NoDefault__, "StructParents", "Tabs"]
        # the tabulator goes from link to link as the structure has them
        page.StructParents, page.Tabs = (n, PDFName("S"))


def xmp(info: Any, lang: str) -> bytes:
    """What the document says about itself, the same as in its information dictionary."""
    properties = [
        (ONE, "title", info.title),
        (LISTED, "creator", info.author),
        (ONE, "description", info.subject),
        (LISTED, "language", lang),
        (PLAIN, "pdf:Keywords", info.keywords),
        (PLAIN, "pdf:Producer", info.producer),
        (PLAIN, "xmp:CreatorTool", info.creator),
    ]
    elements = [
        form.format(name, words.translate(ESCAPED), "Seq" if name == "creator" else "Bag")
        for form, name, words in properties
        if words
    ]
    return XMP.format(part=PART, level=LEVEL, said="\n".join(elements)).encode()


def _intent(document: Any) -> PDFDictionary:
    """What the colours of the pages mean."""
    stream = PDFStream(PDFDictionary({"N": 3}), profile(), filters=[PDFZCompress])
    return PDFDictionary(
        {
            "Type": PDFName("OutputIntent"),
            "S": PDFName("GTS_PDFA1"),
            "OutputConditionIdentifier": PDFString(NAME),
            "Info": PDFString(NAME),
            "DestOutputProfile": document.Reference(stream),
        }
    )
