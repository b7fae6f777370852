# SPDX-License-Identifier: Apache-2.0
"""Whether what was appended to a report is signatures in the fields that it foresees, and nothing else.

pyHanko compares the file with the revision that this program wrote.  It is of the extra `sign`; without it nobody
says of a file that it is signed."""

import io
import logging
import re
from typing import Any
from xml.etree import ElementTree

from .reading import Refused

FIELDS = {"Prepared", "Checked", "Approved"}
OF_PROGRAMS = {"/ModDate", "/Producer"}  # what a program that signs may say of itself
XMP, XMP_PDF = "http://ns.adobe.com/xap/1.0/", "http://ns.adobe.com/pdf/1.3/"
XMP_OF_PROGRAMS = {f"{XMP_PDF}Producer", f"{XMP}ModifyDate", f"{XMP}MetadataDate"}
RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
# where an object begins, for readers that look for them in the bytes; comments count as white space
OBJECT = re.compile(rb"\d(?:[\0\s]|%[^\r\n]*)*obj")
BETWEEN = re.compile(rb"(?:%%EOF|endobj)[\0\s]*(?!\d|xref|startxref)[^\0\s]")  # objects and tables, what is neither
MISSING = "pyHanko, which compares what was appended, is not installed: pip install 'contralbero[sign]'"


def signers(raw: bytes, length: int) -> list[str]:
    """Who has signed the file `raw`, whose first `length` bytes are a report: a line for each signature, as pyHanko
    sees its certificate, in which nobody here puts any trust.  Raises Refused."""
    try:
        from pyhanko.pdf_utils.reader import PdfFileReader
        from pyhanko.sign.diff_analysis import DEFAULT_DIFF_POLICY, DiffResult, ModificationLevel
        from pyhanko.sign.validation.status import SignatureCoverageLevel
    except ImportError:
        raise Refused(MISSING) from None
    logging.disable(logging.CRITICAL)  # it logs that nobody has told it whom to trust
    first, reader = PdfFileReader(io.BytesIO(raw[:length])), PdfFileReader(io.BytesIO(raw))
    _demand(reader.xrefs.get_startxref_for_revision(0) == first.last_startxref, "it leads past the report")
    changes = DEFAULT_DIFF_POLICY.review_file(reader, reader.get_historical_resolver(0))
    if not isinstance(changes, DiffResult):
        raise Refused(re.split(r"[:\n]", f"pyHanko: {changes}")[1].strip()[:100])
    _demand(changes.modification_level <= ModificationLevel.FORM_FILLING, "it changes more than fields")
    signatures, revisions = reader.embedded_signatures, reader.xrefs.total_revisions
    _demand(bool(signatures), "nobody has signed")
    others = {*changes.changed_form_fields, *(signature.field_name for signature in signatures)} - FIELDS
    _demand(not others, f"it has the field {min(others, default='')}")
    _demand(revisions == 1 + len(signatures), "something was appended beside the signatures")
    _all_asked_for(reader, first, revisions, raw[length:])
    for signature in signatures:
        signature.compute_integrity_info()
    covered = [signature.evaluate_signature_coverage() for signature in signatures]
    _demand(min(covered) >= SignatureCoverageLevel.ENTIRE_REVISION, "a signature leaves out bytes of its revision")
    _demand(covered[-1] == SignatureCoverageLevel.ENTIRE_FILE, "there are bytes that no signature covers")
    _as_written(first, reader)
    return [_line(signature) for signature in signatures]


def _all_asked_for(reader: Any, first: Any, revisions: int, appended: bytes) -> None:
    """All objects that were appended are parts of those of the report that were replaced, and none is hidden."""
    from pyhanko.pdf_utils.generic import ArrayObject, DictionaryObject, IndirectObject

    tables = [reader.xrefs.get_xref_data(n).standard_xrefs for n in range(1, revisions)]
    objects = sum(len(table) + 1 for table in tables)  # the table itself may be one
    hidden = len(OBJECT.findall(appended)) > objects
    hidden |= max(appended.count(b"startxref"), appended.count(b"trailer")) > len(tables)
    _demand(not hidden and not BETWEEN.search(b"%%EOF" + appended), "something stands between its objects")
    new = {ref for n in range(1, revisions) for ref in reader.xrefs.explicit_refs_in_revision(n)}
    size = int(first.trailer_view["/Size"])
    waiting: list[Any] = [reader.get_object(ref) for ref in new if ref.idnum < size]
    left = {ref.idnum: ref for ref in new if ref.idnum >= size}
    while waiting:
        value = waiting.pop()
        if isinstance(value, IndirectObject) and left.pop(value.idnum, None):
            waiting.append(reader.get_object(value.reference))
        elif isinstance(value, DictionaryObject):
            waiting += [value.raw_get(key) for key in value]
        elif isinstance(value, ArrayObject):
            waiting += [value.raw_get(n) for n in range(len(value))]
    # the tables of objects themselves may be objects, which nothing asks for
    alone = [ref for ref in left.values() if reader.get_object(ref).get("/Type") != "/XRef"]
    _demand(not alone, "it has an object that nobody asks for")


def _line(signature: Any) -> str:
    from pyhanko.sign.validation import validate_pdf_signature
    from pyhanko_certvalidator import ValidationContext

    status = validate_pdf_signature(signature, ValidationContext(trust_roots=[]), skip_diff=True)
    _demand(status.intact and status.valid, f"the signature in {signature.field_name} is broken")
    who, when = signature.signer_cert.subject.human_friendly, status.signer_reported_dt
    said = f"{who}, {when:%Y-%m-%d %H:%M} by their own clock" if when is not None else who
    return f"{signature.field_name}: {said}; pyHanko: {status.summary()}, with nobody named to be trusted"


def _as_written(first: Any, reader: Any) -> None:
    """What the document says of itself is what this program wrote, but for what a signing program says of itself."""
    was, now = first.trailer["/Info"], reader.trailer["/Info"]
    other = {key for key in {*was, *now} - OF_PROGRAMS if was.get(key) != now.get(key)}
    _demand(not other, f"the document has another {min(other, default='')}")
    written, signed = (_metadata(pdf.root["/Metadata"].data) for pdf in (first, reader))
    _demand(written == signed, "the document's metadata are others")


def _metadata(raw: bytes) -> dict[str, Any]:
    """What XMP says, each property by its name, but for what a program that signs says of itself."""
    from pyhanko.pdf_utils.metadata.xmp_xml import parse_xmp

    _demand(b"<!" not in raw, "the document's metadata declare what they are made of")
    abouts = list(ElementTree.fromstring(raw).iter(f"{RDF}Description"))
    attributes = [name for about in abouts for name in about.attrib if not name.startswith(RDF)]
    names = [*attributes, *(child.tag for about in abouts for child in about)]
    _demand(len(names) == len(set(names)), "the document's metadata say something twice")
    said = {str(name): value for about in parse_xmp(io.BytesIO(raw)) for name, value in about}
    return {name: value for name, value in said.items() if name not in XMP_OF_PROGRAMS}


def _demand(right: bool, otherwise: str) -> None:
    if not right:
        raise Refused(otherwise)
