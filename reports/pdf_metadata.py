# SPDX-License-Identifier: Apache-2.0
"""What a document says about itself as XMP (ISO 16684-1), whichever of its ways it is written in: a program that saves or signs a document
writes it anew, and names itself in it."""

from __future__ import annotations

from xml.etree import ElementTree

from calc.design.limits import PDF_DEPTH

from .verify.pdf_file import Malformed

RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
XMP = "{http://ns.adobe.com/xap/1.0/}"
OF_THE_PROGRAM = {"{http://ns.adobe.com/pdf/1.3/}Producer", XMP + "ModifyDate", XMP + "MetadataDate"}


def same(before: bytes, now: bytes) -> None:
    """Raises Malformed if metadata say something else than before, with what they say."""
    was, is_now = _statements(before), _statements(now)
    other = {key for key in {*was, *is_now} - OF_THE_PROGRAM if was.get(key) != is_now.get(key)}
    if other:
        raise Malformed(f"the metadata have another {min(other).rpartition('}')[2]}")


def _statements(raw: bytes) -> dict[str, object]:
    if b"<!" in raw or b"\0" in raw:
        raise Malformed("the metadata declare what they are made of")
    try:
        top = ElementTree.fromstring(raw)
    except (ElementTree.ParseError, ValueError, LookupError):
        raise Malformed("the metadata can not be read") from None
    found: dict[str, object] = {}
    for about in top[0] if [one.tag for one in top] == [RDF + "RDF"] else top:
        if about.tag != RDF + "Description":
            raise Malformed("the metadata hold more than a description")
        said = [(key, value) for key, value in about.attrib.items() if key != RDF + "about"]
        for key, value in [*said, *((one.tag, _shape(one)) for one in about)]:
            if key in found:
                raise Malformed(f"the metadata have {key.rpartition('}')[2]} twice")
            found[key] = value
    return found


def _shape(of: ElementTree.Element, depth: int = 0) -> object:
    if depth > PDF_DEPTH:
        raise Malformed("the metadata are nested too deeply")
    text = (of.text or "").strip()
    return (of.tag, sorted(of.attrib.items()), text, [_shape(one, depth + 1) for one in of]) if len(of) or of.attrib else text
