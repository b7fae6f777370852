# SPDX-License-Identifier: Apache-2.0
"""Whether what was appended to a report is signatures in the fields that it foresees, and nothing else.

pyHanko compares the file with the revision that this program wrote.  It is of the extra `sign`; without it nobody
says of a file that it is signed."""

import io
import logging
from typing import Any
from xml.etree import ElementTree

from calc.sheet.text import Text

RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
ABOUT = f"{RDF}Description"
FIELDS = {"Prepared", "Checked", "Approved"}
OF_PROGRAMS = {"/ModDate", "/Producer"}  # what a program that signs may say of itself
XMP_OF_PROGRAMS = {
    "http://ns.adobe.com/pdf/1.3/Producer",
    "http://ns.adobe.com/xap/1.0/ModifyDate",
    "http://ns.adobe.com/xap/1.0/MetadataDate",
}
NO_READER = Text("pyHanko, which compares what was appended, is not installed: pip install 'contralbero[sign]'")


class NotSigned(Exception):
    """Why what was appended is not signatures alone."""

    def __init__(self, why: Text) -> None:
        super().__init__(str(why))
        self.why = why


def signers(report: bytes, raw: bytes) -> list[Text]:
    """Who has signed the file `raw`, which begins with `report`: a line of words for each signature, as pyHanko sees
    its certificate, in which nobody here puts any trust.  Raises NotSigned."""
    try:
        from pyhanko.pdf_utils.reader import PdfFileReader
    except ImportError:
        raise NotSigned(NO_READER) from None
    logging.disable(logging.CRITICAL)  # it logs that nobody has told it whom to trust
    try:
        return _signers(PdfFileReader(io.BytesIO(raw)), report)
    except NotSigned:
        raise
    except Exception as error:  # whatever a file of a stranger does to its reader, it is not signed
        raise NotSigned(Text("it can not be read ({error})", error=f"{type(error).__name__}: {error}"[:80])) from None
    finally:
        logging.disable(logging.NOTSET)


def _signers(reader: Any, report: bytes) -> list[Text]:
    from pyhanko.pdf_utils.reader import PdfFileReader
    from pyhanko.sign.diff_analysis import DEFAULT_DIFF_POLICY, DiffResult, ModificationLevel
    from pyhanko.sign.validation.status import SignatureCoverageLevel

    first, old = PdfFileReader(io.BytesIO(report)), reader.get_historical_resolver(0)
    _demand(reader.xrefs.get_startxref_for_revision(0) == first.last_startxref, Text("it leads past the report"))
    changes = DEFAULT_DIFF_POLICY.review_file(reader, old)
    if not isinstance(changes, DiffResult):
        raise NotSigned(Text("{changes}", changes=str(changes)))
    _demand(changes.modification_level <= ModificationLevel.FORM_FILLING, Text("it changes more than fields"))
    more = changes.changed_form_fields - FIELDS
    _demand(not more, Text("it has the field {name}", name=min(more, default="")))
    signatures = reader.embedded_signatures
    _demand(bool(signatures), Text("nobody has signed"))
    revisions = reader.xrefs.total_revisions
    _demand(revisions == 1 + len(signatures), Text("something was appended beside the signatures"))
    _demand(_all_asked_for(reader, first, revisions), Text("it has an object that nobody asks for"))
    lines = []
    for signature in signatures:
        signature.compute_integrity_info()
        _demand(signature.field_name in FIELDS, Text("it has the field {name}", name=signature.field_name))
        sound = signature.evaluate_signature_coverage() in (
            SignatureCoverageLevel.ENTIRE_FILE,
            SignatureCoverageLevel.ENTIRE_REVISION,
        )
        _demand(sound, Text("a signature leaves out bytes of its revision"))
        lines.append(_line(signature))
    last = signatures[-1].evaluate_signature_coverage()
    _demand(last == SignatureCoverageLevel.ENTIRE_FILE, Text("there are bytes that no signature covers"))
    _as_written(first, reader)
    return lines


def _all_asked_for(reader: Any, first: Any, revisions: int) -> bool:
    """Whether all objects that were appended are parts of those of the report that were replaced."""
    from pyhanko.pdf_utils.generic import ArrayObject, DictionaryObject, IndirectObject

    appended = {ref for n in range(1, revisions) for ref in reader.xrefs.explicit_refs_in_revision(n)}
    size = int(first.trailer_view["/Size"])
    waiting: list[Any] = [reader.get_object(ref) for ref in appended if ref.idnum < size]
    left = {ref.idnum for ref in appended if ref.idnum >= size}
    while waiting:
        value = waiting.pop()
        if isinstance(value, IndirectObject) and value.idnum in left:
            left.discard(value.idnum)
            waiting.append(reader.get_object(value.reference))
        elif isinstance(value, DictionaryObject):
            waiting += [value.raw_get(key) for key in value]
        elif isinstance(value, ArrayObject):
            waiting += [value.raw_get(n) for n in range(len(value))]
    # the tables of objects themselves may be objects, which nothing asks for
    return all(reader.get_object(ref).get("/Type") == "/XRef" for ref in appended if ref.idnum in left)


def _line(signature: Any) -> Text:
    from pyhanko.sign.validation import validate_pdf_signature
    from pyhanko_certvalidator import ValidationContext

    status = validate_pdf_signature(signature, ValidationContext(trust_roots=[]), skip_diff=True)
    _demand(status.intact and status.valid, Text("the signature in {name} is broken", name=signature.field_name))
    return Text(
        "{name}: {who}, intact; whether the certificate is to be trusted is not judged here",
        name=signature.field_name,
        who=str(signature.signer_cert.subject.human_friendly),
    )


def _as_written(first: Any, reader: Any) -> None:
    """What the document says of itself is what this program wrote, but for what a signing program says of itself."""
    was, now = first.trailer["/Info"], reader.trailer["/Info"]
    other = {key for key in {*was, *now} - OF_PROGRAMS if was.get(key) != now.get(key)}
    _demand(not other, Text("the document has another {key}", key=min(other, default="")))
    metadata = [_metadata(one.root["/Metadata"].data) for one in (first, reader)]
    _demand(metadata[0] == metadata[1], Text("the document's metadata are others"))


def _metadata(raw: bytes) -> dict[str, Any]:
    """What XMP says, each property by its name, but for what a program that signs says of itself."""
    from pyhanko.pdf_utils.metadata.xmp_xml import parse_xmp

    _demand(b"<!" not in raw, Text("the document's metadata declare what they are made of"))
    names = [name for about in ElementTree.fromstring(raw).iter(ABOUT) for name in _names(about)]
    _demand(len(names) == len(set(names)), Text("the document's metadata say something twice"))
    said = {str(name): value for about in parse_xmp(io.BytesIO(raw)) for name, value in about}
    return {name: value for name, value in said.items() if name not in XMP_OF_PROGRAMS}


def _names(about: ElementTree.Element) -> list[str]:
    return [*(name for name in about.attrib if not name.startswith(RDF)), *(child.tag for child in about)]


def _demand(right: bool, otherwise: Text) -> None:
    if not right:
        raise NotSigned(otherwise)
