# SPDX-License-Identifier: Apache-2.0
"""What was appended to a report, if that is what a program appends that signs it, and nothing else.

A signature is put into a file by leaving its bytes as they are and writing after them: the field, what it shows, the
page and the catalogue once more with the field in them (ISO 32000-1, 7.5.6 and 12.8).  The rule here is the other way
round from a search for what is wrong: what was appended must be these objects, each byte of it."""

from __future__ import annotations

import re
from math import isfinite
from typing import Any
from xml.etree import ElementTree

from calc.design.limits import PDF_DEPTH

from .pdf_file import Malformed, Pdf, Reference, Stream

# --- what a document says about itself as XMP (ISO 16684-1), whichever of its ways it is written in
# A program that saves or signs a document writes it anew, and names itself in it.

RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
XMP = "{http://ns.adobe.com/xap/1.0/}"
XMP_OF_THE_PROGRAM = {"{http://ns.adobe.com/pdf/1.3/}Producer", XMP + "ModifyDate", XMP + "MetadataDate"}


def same(before: bytes, now: bytes) -> None:
    """Raises Malformed if metadata say something else than before, with what they say."""
    was, is_now = _statements(before), _statements(now)
    other = {key for key in {*was, *is_now} - XMP_OF_THE_PROGRAM if was.get(key) != is_now.get(key)}
    if other:
        raise Malformed(f"the metadata have another {min(other).rpartition('}')[2]}")


def _statements(raw: bytes) -> dict[str, object]:
    if b"<!" in raw or b"\0" in raw:
        raise Malformed("the metadata declare what they are made of")
    try:
        top = ElementTree.fromstring(raw)
    except (ElementTree.ParseError, ValueError, LookupError):
        raise Malformed("the metadata can not be read") from None
    statements: dict[str, object] = {}
    for about in top[0] if [element.tag for element in top] == [RDF + "RDF"] else top:
        if about.tag != RDF + "Description":
            raise Malformed("the metadata hold more than a description")
        attributes = [(key, value) for key, value in about.attrib.items() if key != RDF + "about"]
        for key, value in [*attributes, *((child.tag, _shape(child)) for child in about)]:
            if key in statements:
                raise Malformed(f"the metadata have {key.rpartition('}')[2]} twice")
            statements[key] = value
    return statements


def _shape(of: ElementTree.Element, depth: int = 0) -> object:
    if depth > PDF_DEPTH:
        raise Malformed("the metadata are nested too deeply")
    text = (of.text or "").strip()
    return (
        (of.tag, sorted(of.attrib.items()), text, [_shape(child, depth + 1) for child in of])
        if len(of) or of.attrib
        else text
    )


# --- what a signature appends

TRAILER = {"Size", "Root", "Info", "Prev", "ID"}
TABLE = {"Type", "W", "Index", "Filter", "DecodeParms", "Length"}  # of a stream that is table and trailer at once
CATALOGUE = {"AcroForm", "Perms", "DSS", "Extensions"}
FORM = {"Fields", "SigFlags", "DR", "DA"}
FIELD = {"Type", "Subtype", "FT", "T", "TU", "F", "Ff", "Rect", "P", "AP", "V", "DA", "M", "NM", "Lock", "SV", "MK"}
# invisible, hidden, printed, read only, locked, contents locked: none that changes its size or place
FLAGS = 1 | 2 | 4 | 64 | 128 | 512
OF_THE_PROGRAM = {"Producer", "ModDate"}  # what a program says about itself and not about the document
ANY_OBJECT = re.compile(rb"\d\s+\d+\s+obj")
Rectangle = tuple[float, float, float, float]


def fields(report: bytes, raw: bytes, pages: list[Reference]) -> list[tuple[int, Rectangle]]:
    """The fields of signatures that were appended to a document, each with the number of its page from 1 and its place.

    Raises Malformed, with what else was appended.
    """
    old, new = Pdf(report), Pdf(raw, len(report))
    _demand(bool(new.sections), "no object is in it")
    _layout(old, new)
    return _Appended(old, new).fields(pages)


def _layout(old: Pdf, new: Pdf) -> None:
    """Every byte belongs to an object, each object stands in its table, and each table leads to the one before."""
    before, size = old.sections[-1], old.trailer["Size"]
    at = before.end
    for section in new.sections:
        table, trailer = {n: place for n, place in section.table.items() if n or place is not None}, section.trailer
        stream = {n for n, place in section.places.items() if place == section.at}
        size = max([size, *(n + 1 for n in section.places)])
        _demand(not section.remarks, "there are comments in it")
        _demand(section.tables == 1, "it has two tables")
        _demand(section.start == section.at >= at, "its end does not lead to its table")
        _demand(section.places == {**table, **{n: section.at for n in stream}}, "its table is not that of its objects")
        _demand(set(trailer) <= (TRAILER | TABLE if stream else TRAILER), "its trailer holds more than a trailer")
        _demand(_equal(trailer.get("Prev"), before.start), "its table does not lead to the one before")
        _demand(trailer.get("Root") == old.trailer["Root"], "it has another catalogue")
        _demand(
            trailer.get("Info", old.trailer["Info"]) == old.trailer["Info"], "it says something else about the document"
        )
        _demand(_equal(trailer.get("Size"), size), "its trailer has another number of objects")
        before, at = section, section.end
    _demand(new.raw[at:] in (b"", b"\n", b"\r\n"), "something stands after its end")
    appended, count = new.raw[old.sections[-1].end :], sum(len(section.places) for section in new.sections)
    _demand(
        len(ANY_OBJECT.findall(appended)) == count and appended.count(b"startxref") == len(new.sections),
        "there is an object within an object",
    )


class _Appended:
    """The objects of a report and those that were appended."""

    def __init__(self, old: Pdf, new: Pdf) -> None:
        self.old, self.new = old, new
        self.size = int(old.trailer["Size"])
        for value in new.objects.values():
            kind = value.entries.get("Type") if isinstance(value, Stream) else None
            _demand(kind != "ObjStm", "there are objects in a stream")

    def fields(self, pages: list[Reference]) -> list[tuple[int, Rectangle]]:
        _demand(self.old.trailer["Root"].number in self.new.objects, "there is no field of a signature")
        root, info = self.old.trailer["Root"], self.old.trailer["Info"]
        metadata = self.old.root["Metadata"]
        others = {n for n in self.new.objects if n < self.size} - {
            reference.number for reference in (root, info, metadata, *pages)
        }
        _demand(not others, f"object {min(others, default=0)} of the report is replaced")
        if info.number in self.new.objects:
            self._same(self.old.info, self.new.entries(info), OF_THE_PROGRAM, "what the document says about itself")
        if metadata.number in self.new.objects:
            self._metadata(metadata)
        catalogue = self.new.entries(root)
        self._same(self.old.root, catalogue, CATALOGUE, "the catalogue")
        _demand(set(self._entries(catalogue.get("Perms"))) <= {"DocMDP"}, "it gives permissions")
        form = self._entries(catalogue.get("AcroForm"))
        _demand(set(form) <= FORM, "it has a form that does more than to be signed")
        laid = [(n, field) for n, page in enumerate(pages, 1) for field in self._laid(page)]
        _demand(bool(laid), "there is no field of a signature")
        _demand(len(laid) == len({field for _, field in laid}), "a field stands on two pages")
        _demand(
            sorted(n.number for n in self._references(form.get("Fields", []))) == sorted(f.number for _, f in laid),
            "its form is not that of its fields",
        )
        return [(n, self._field(field, pages[n - 1])) for n, field in laid]

    def _laid(self, page: Reference) -> list[Reference]:
        """What is laid over a page more than before."""
        if page.number not in self.new.objects:
            return []
        before, now = self.old.entries(page), self.new.entries(page)
        self._same(before, now, {"Annots"}, "a page")
        links, laid = self.old.items(before.get("Annots")), self._references(now.get("Annots", []))
        _demand(laid[: len(links)] == links, "links are taken from a page")
        return laid[len(links) :]

    def _field(self, reference: Reference, page: Reference) -> Rectangle:
        field = self._entries(reference)
        _demand(
            field.get("Subtype") == "Widget" and field.get("FT") == "Sig",
            "something is laid over a page that is no field of a signature",
        )
        more = set(field) - FIELD
        _demand(not more, f"a field has the entry {min(more, default='')}")
        flags = field.get("F", 0)
        _demand(type(flags) is int and flags & ~FLAGS == 0, "a field does not stay in its place")
        _demand(field.get("P", page) == page, "a field stands on another page than it says")
        _demand(field.get("MK", {}) == {}, "a field has a look beside its look")
        place = _rectangle(field.get("Rect"))
        sheet = _rectangle(self.old.entries(page).get("MediaBox"))
        _demand(
            sheet[0] <= place[0] and place[2] <= sheet[2] and sheet[1] <= place[1] and place[3] <= sheet[3],
            "a field reaches beyond its page",
        )
        looks = self._entries(field.get("AP", {}))
        _demand(set(looks) <= {"N"}, "a field has more than one look")
        if looks:
            look = self.new.value(looks["N"])
            _demand(
                isinstance(looks["N"], Reference)
                and isinstance(look, Stream)
                and look.entries.get("Subtype") == "Form",
                "a field has no look",
            )
            _rectangle(look.entries.get("BBox"))
        return place

    def _entries(self, of: Any) -> dict[str, Any]:
        """Of a dictionary that was appended, with what it was appended with."""
        entries = self.new.value(of)
        _demand(isinstance(entries, dict) or of is None, "a dictionary is missing")
        return entries or {}

    def _references(self, of: Any) -> list[Reference]:
        references = self.new.value(of)
        _demand(
            isinstance(references, list) and all(isinstance(reference, Reference) for reference in references),
            "a list is missing",
        )
        return list(references)

    def _same(self, before: dict[str, Any], now: dict[str, Any], free: set[str], what: str) -> None:
        other = {
            key
            for key in {*before, *now} - free
            if key not in before or key not in now or not _equal(before[key], now[key])
        }
        _demand(not other, f"{what} has another {min(other, default='')}")

    def _metadata(self, reference: Reference) -> None:
        same(self.old.data(reference), self.new.data(reference))
        entries = self.new.entries(reference)
        _demand(set(entries) <= {"Type", "Subtype", "Length", "Filter"}, "the document's metadata are more than that")


def _equal(a: Any, b: Any) -> bool:
    """A number is no truth value, 1 is not 1.0, and a name is no text."""
    if isinstance(a, dict) and isinstance(b, dict):
        return set(a) == set(b) and all(_equal(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(_equal, a, b))
    return type(a) is type(b) and bool(a == b)


def _rectangle(of: Any) -> Rectangle:
    right = (
        isinstance(of, list)
        and len(of) == 4
        and all(type(number) in (int, float) and isfinite(number) for number in of)
    )
    _demand(right, "a rectangle does not stand where it is used")
    x, y, x_2, y_2 = map(float, of)
    return min(x, x_2), min(y, y_2), max(x, x_2), max(y, y_2)


def _demand(right: bool, otherwise: str) -> None:
    if not right:
        raise Malformed(otherwise)
