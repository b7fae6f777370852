# SPDX-License-Identifier: Apache-2.0
"""Whether what was appended to a report is signatures in the fields that it foresees, and nothing else.

pyHanko compares the file with the revision that this program wrote.  It is of the extra `sign`; without it nobody
says of a file that it is signed."""

import io
import logging
import re
from itertools import pairwise
from typing import Any
from xml.etree import ElementTree

from calc.sheet.extras import needs

from ..apart import Refused, demand
from .revisions import revisions

# what a program that signs may write anew of what the report has
OF_INFO, OF_ROOT = {"/ModDate", "/Producer"}, {"/Extensions", "/Version"}
OF_FORM, OF_FIELD = {"/DA", "/DR"}, {"/V", "/AP", "/F"}
PRINTED, LOCKED = 4, 132  # flags of a field
# what no signature needs, however it is asked for
FOREIGN = re.compile(r"'/(?:EF|JS|AA|OC|OCG|Launch|URI|Catalog|Pages?|ObjStm|XRef|Filespec|EmbeddedFile|Action|Annot)'")
XMP, RDF = "{http://ns.adobe.com/xap/1.0/}", "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
XMP_OF_PROGRAMS = {"{http://ns.adobe.com/pdf/1.3/}Producer", f"{XMP}ModifyDate", f"{XMP}MetadataDate"}
XMP_FRAME = {"{adobe:ns:meta/}xmpmeta", f"{RDF}RDF", f"{RDF}Description"}
UNSAID = re.compile(rb"\0|<!|<\?(?!xml |xpacket (?:begin|end)=)")


def signers(raw: bytes, length: int) -> list[str]:
    """Who has signed the file `raw`, whose first `length` bytes are a report: a line for each signature, as pyHanko
    sees its certificate, in which nobody here puts any trust.  Raises Refused."""
    try:
        from pyhanko.pdf_utils.reader import PdfFileReader
        from pyhanko.sign.diff_analysis import DEFAULT_DIFF_POLICY, DiffResult, ModificationLevel
    except ImportError:
        raise Refused(f"to compare them {needs('sign')}") from None
    logging.disable(logging.CRITICAL)  # it logs that nobody has told it whom to trust
    first, reader = PdfFileReader(io.BytesIO(raw[:length])), PdfFileReader(io.BytesIO(raw))
    xrefs: Any = reader.xrefs
    written, *signed = (reader.get_historical_resolver(n) for n in range(xrefs.total_revisions))
    signatures = reader.embedded_signatures
    demand(0 < len(signed) == len(signatures), "something was appended beside the signatures")
    tables = [one(xrefs.get_xref_container_info(one.revision).stream_ref) for one in signed]
    ends = revisions(raw, length, tables, first.trailer, first.last_startxref or 0)
    for was, now in pairwise([written, *signed]):  # each by itself: who signs may not change what was signed
        _asked_for(was, now)
    changes = DEFAULT_DIFF_POLICY.review_file(reader, written)
    if not isinstance(changes, DiffResult):
        raise Refused(re.split(r"[:\n]", f"pyHanko: {changes}")[1].strip())
    demand(changes.modification_level <= ModificationLevel.FORM_FILLING, "it changes more than fields")
    for signature, end in zip(signatures, ends):
        start, before, after, rest = signature.byte_range
        whole = start == 0 and end[0] <= after + rest <= end[1]
        whole &= raw[before:after].lower() == b"<%b>" % signature.pkcs7_content.hex().encode()
        demand(whole, "a signature leaves out bytes of its revision")
    demand(after + rest == len(raw), "there are bytes that no signature covers")
    return [_line(signature) for signature in signatures]


def _asked_for(was: Any, now: Any) -> None:
    """A revision writes anew what a signature must and no more of it, and what is new belongs to that."""
    new, fields = now.explicit_refs_in_revision(), was.root["/AcroForm"]["/Fields"]
    holders = (was.trailer_view, "/Info"), (was.root, "/AcroForm"), (was.root, "/Metadata")
    info, form, said = (holder.raw_get(key).reference for holder, key in holders)
    fields = {fields.raw_get(n).reference: OF_FIELD for n in range(len(fields))}
    may = {was.root_ref: OF_ROOT, info: OF_INFO, form: OF_FORM, said: {"/Length"}, **fields}
    old = {ref for ref in new if not was.is_ref_unassignable(ref)}
    demand(old <= {*may} and not now.refs_freed_in_revision(), "it writes anew what is no part of a signature")
    asked = {one for ref in old & {form, *fields} for one in now.collect_dependencies(now(ref), now.revision)}
    xrefs, revision = now.reader.xrefs, now.revision
    frame = xrefs.object_streams_used_in(revision) | {xrefs.get_xref_container_info(revision).stream_ref}
    demand(new <= old | asked | frame, "it has an object that nobody asks for")
    for ref in new - frame - {said}:
        made: Any = now(ref)
        inner = {key: dict.get(made, key) for key in may.get(ref, made)} if isinstance(made, dict) else made
        file = isinstance(inner, dict) and {"/F", "/Length"} <= {*inner}
        demand(not file and not FOREIGN.search(repr(inner)), "it has what no signature needs")
    for ref in old:
        before, after = was(ref), now(ref)
        other = {key for key in {*before, *after} - may[ref] if _entry(before, key) != _entry(after, key)}
        demand(not other, f"the document or its form has another {min(other, default='')[:40]}")
        if ref in fields:  # a look without a box is drawn over the page
            boxes = [after["/AP"][key].get("/BBox") for key in after["/AP"]]
            boxed = all(isinstance(box, list) and len(box) == 4 for box in boxes)
            signed = "/V" in {*after} - {*before} and after["/F"] in {PRINTED, LOCKED}
            demand(boxed and signed, "a field is changed, or shown otherwise")
    demand(now.root.get("/Version") in {None, "/2.0"}, "it is to be read in another way")
    demand(_metadata(was(said).data) == _metadata(now(said).data), "its metadata are others")


def _entry(holder: Any, key: str) -> Any:
    """To pyHanko 3.0 is 3, a name is a text, and texts in codes that some programs do not know are as any other."""
    value = holder.raw_get(key) if key in holder else None
    return type(value), getattr(value, "original_bytes", b"")[:2] in (b"\xff\xfe", b"\xef\xbb"), value


def _line(signature: Any) -> str:
    from pyhanko.sign.validation import validate_pdf_signature
    from pyhanko_certvalidator import ValidationContext

    status = validate_pdf_signature(signature, ValidationContext(trust_roots=[]), skip_diff=True)
    demand(status.intact and status.valid, f"the signature in {signature.field_name} is broken")
    who, when = signature.signer_cert.subject.human_friendly[:500], status.signer_reported_dt
    said = f"{who}, {when:%Y-%m-%d %H:%M} by their own clock" if when is not None else who
    return f"{signature.field_name}: {said}; pyHanko: {status.summary().split(',')[0]}, with nobody named to be trusted"


def _metadata(raw: bytes) -> list[str]:
    """What XMP says, each property as it stands there, but for what a program that signs says of itself."""
    demand(not UNSAID.search(raw), "its metadata declare what they are made of")
    top = ElementTree.fromstring(raw)
    frames = [top, *top, *(abouts := [about for rdf in top for about in rdf])]
    loose = "".join(text or "" for one in frames for text in (one.text, *(inner.tail for inner in one))).strip()
    demand(not loose and {one.tag for one in frames} == XMP_FRAME, "its metadata say more than properties")
    for about in abouts:
        for name, text in about.attrib.items():
            ElementTree.SubElement(about, name).text = text
    said = [ElementTree.tostring(one) for about in abouts for one in about if one.tag not in XMP_OF_PROGRAMS]
    return sorted(ElementTree.canonicalize(one, strip_text=True, rewrite_prefixes=True) for one in said)
