# SPDX-License-Identifier: Apache-2.0
"""What makes a report an archive file, PDF/A-3 level A (ISO 19005-3): what it says about itself as XMP, its colours, its structure."""

from __future__ import annotations

from typing import Any

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFName, PDFStream, PDFString, PDFZCompress

from ..colour import NAME, profile
from ..setting.tags import Tree

PART, LEVEL = 3, "A"
XMP = """<?xpacket begin="\ufeff" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about=""
 xmlns:pdfaid="http://www.aiim.org/pdfa/ns/id/" xmlns:dc="http://purl.org/dc/elements/1.1/" xmlns:pdf="http://ns.adobe.com/pdf/1.3/"
 xmlns:xmp="http://ns.adobe.com/xap/1.0/">
<pdfaid:part>{part}</pdfaid:part><pdfaid:conformance>{level}</pdfaid:conformance><dc:format>application/pdf</dc:format>
{said}
</rdf:Description></rdf:RDF></x:xmpmeta>
<?xpacket end="w"?>"""
ONE = '<dc:{0}><rdf:Alt><rdf:li xml:lang="x-default">{1}</rdf:li></rdf:Alt></dc:{0}>'
LISTED = "<dc:{0}><rdf:{2}><rdf:li>{1}</rdf:li></rdf:{2}></dc:{0}>"
PLAIN = "<{0}>{1}</{0}>"
ESCAPED = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;"})  # xml.sax.saxutils would load the whole of urllib for it


def archive(document: Any, tree: Tree, lang: str) -> None:
    """Add to a document what PDF/A asks for; to be called when all pages are drawn and the document is described."""
    catalog = document.Catalog
    catalog.Metadata = PDFStream(PDFDictionary({"Type": PDFName("Metadata"), "Subtype": PDFName("XML")}), xmp(document.info, lang))
    catalog.OutputIntents = PDFArray([_intent(document)])
    catalog.__NoDefault__ = [*catalog.__NoDefault__, "OutputIntents"]
    catalog.MarkInfo = PDFDictionary({"Marked": "true"})
    catalog.StructTreeRoot = tree.finish(document)
    for n in range(len(tree.pages)):
        page = document.idToObject[f"Page{n + 1}"]
        page.__NoDefault__ = [*page.__NoDefault__, "StructParents", "Tabs"]
        page.StructParents, page.Tabs = n, PDFName("S")  # the tabulator goes from link to link as the structure has them


def xmp(info: Any, lang: str) -> bytes:
    """What the document says about itself, the same as in its information dictionary."""
    said = [
        (ONE, "title", info.title), (LISTED, "creator", info.author), (ONE, "description", info.subject), (LISTED, "language", lang),
        (PLAIN, "pdf:Keywords", info.keywords), (PLAIN, "pdf:Producer", info.producer), (PLAIN, "xmp:CreatorTool", info.creator),
    ]  # fmt: skip
    made = [form.format(name, words.translate(ESCAPED), "Seq" if name == "creator" else "Bag") for form, name, words in said if words]
    return XMP.format(part=PART, level=LEVEL, said="\n".join(made)).encode()


def _intent(document: Any) -> PDFDictionary:
    """What the colours of the pages mean."""
    stream = PDFStream(PDFDictionary({"N": 3}), profile(), filters=[PDFZCompress])
    return PDFDictionary(
        {
            "Type": PDFName("OutputIntent"), "S": PDFName("GTS_PDFA1"), "OutputConditionIdentifier": PDFString(NAME),
            "Info": PDFString(NAME), "DestOutputProfile": document.Reference(stream),
        }
    )  # fmt: skip
