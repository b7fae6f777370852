# SPDX-License-Identifier: Apache-2.0
"""What the parts of a page are, for whoever reads the document by a machine: headings, paragraphs, lists, tables,
figures with their captions, formulas.

A block says what it is by its tag (`pagination.Block.tag`); what says nothing is a paragraph.  Blocks with one and the
same tag, the lines of a paragraph, the rows of a table, are one element of the tree (ISO 32000-1, 14.7), on however
many pages."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from reportlab.pdfbase.pdfdoc import PDFDictionary, PDFName, PDFObject, PDFObjectReference, PDFStream, PDFZCompress

from .boxes import EDGE

GATHERED = {"LI": "L", "TOCI": "TOC"}  # neighbours of a kind stand in a common element
HEADING, FIGURE, FORMULA, CAPTION = "H", "Figure", "Formula", "Caption"
DRAWN = (FIGURE, FORMULA)  # of which lines and areas are content, as the bar of a fraction; elsewhere they adorn
CELLS = ("TD", "TH")
PRINTED = 4  # the flag of what lies over a page: it is printed
LEVELS = 6  # of headings, at most
COLUMN, ROW = "/O /Table /Scope /Column", "/O /Table /Scope /Row"  # what a cell heads


@dataclass(frozen=True, slots=True, eq=False)  # the same only as itself
class Tag:
    """`within`: the element that this one is part of; `size`: of a heading's letters, the larger above the smaller;
    `alt`: what a figure shows, in words; a formula as one line."""

    role: str
    within: Tag | None = None
    alt: str = ""
    size: float = 0.0
    attributes: str = ""


def title_tag(size: float) -> Tag:
    """Of a heading in letters of this size."""
    return Tag(HEADING, size=size)


@dataclass(slots=True, eq=False)
class TaggedPiece:
    """Marked content: where it is on which page."""

    page: int
    number: int


@dataclass(slots=True, eq=False)
class Annotation:
    """What lies over a page at its element: a link, or the field of a signature."""

    page: int
    name: str


class Element(PDFObject):  # type: ignore[misc]
    """An element of the tree."""

    __RefOnly__ = 1

    def __init__(self, role: str, parent: Element | None, alt: str = "", attributes: str = "") -> None:
        self.role, self.parent, self.alt, self.attributes = role, parent, alt, attributes
        self.kids: list[Element | TaggedPiece | Annotation] = []
        self.reference = self.written = b""  # as soon as it is an object of the document
        if parent is not None:
            parent.kids.append(self)

    @property
    def empty(self) -> bool:
        return not self.kids and self.role not in CELLS

    def place(self) -> tuple[int, int]:
        """Where its first content stands in the order of reading."""
        kid = next((kid for kid in self.kids if not isinstance(kid, Annotation)), None)
        return kid.place() if isinstance(kid, Element) else (kid.page, kid.number) if kid is not None else (-1, -1)

    def write(self, pages: list[bytes], annotations: Callable[[str], bytes], root: bytes) -> None:
        """What it is as an object, once every element has its reference; `pages`: references to all pages."""
        entries = [
            b"<< /S /%s /P %s" % (self.role.encode(), self.parent.reference if self.parent is not None else root)
        ]
        page = next((kid.page for kid in self.kids if isinstance(kid, TaggedPiece)), None)
        if page is not None:
            entries.append(b"/Pg " + pages[page])
        kids = []
        for kid in self.kids:
            if isinstance(kid, Element):
                kids.append(kid.reference)
            elif isinstance(kid, Annotation):
                kids.append(b"<< /Type /OBJR /Pg %s /Obj %s >>" % (pages[kid.page], annotations(kid.name)))
            elif kid.page != page:
                kids.append(b"<< /Type /MCR /Pg %s /MCID %d >>" % (pages[kid.page], kid.number))
            else:
                kids.append(b"%d" % kid.number)
        if kids:
            entries.append(b"/K " + (kids[0] if len(kids) == 1 else b"[%s]" % b" ".join(kids)))
        if self.alt:
            entries.append(f"/Alt <{hexed(self.alt)}>".encode())
        if self.attributes:
            entries.append(f"/A << {self.attributes} >>".encode())
        self.written = b" ".join([*entries, b">>"])

    def format(self, document: Any) -> bytes:
        return self.written


class Root(PDFObject):  # type: ignore[misc]
    """The root of the tree, with the way back from marked content to its elements."""

    __RefOnly__ = 1

    def __init__(self, tree: Tree) -> None:
        self.tree = tree

    def format(self, document: Any) -> bytes:
        back: list[bytes] = []
        for n, elements in enumerate(self.tree.pages):
            back.append(b"%d [%s]" % (n, b" ".join(element.reference for element in elements)))
        for n, element in enumerate(self.tree.links, len(self.tree.pages)):
            back.append(b"%d %s" % (n, element.reference))
        after = len(self.tree.pages) + len(self.tree.links)
        top = self.tree.top.reference
        return b"<< /Type /StructTreeRoot /K %s /ParentTree << /Nums [%s] >> /ParentTreeNextKey %d >>" % (
            top,
            b" ".join(back),
            after,
        )


@dataclass(slots=True)
class Tree:
    """The tree as it grows while the pages are drawn.  `count`: of the pages, all of them, of which the links are
    counted on."""

    count: int
    top: Element = field(default_factory=lambda: Element("Document", None))
    made: dict[Tag, Element] = field(default_factory=dict)
    # by page, its elements by the numbers of their marked content
    pages: list[list[Element]] = field(default_factory=list)
    links: list[Element] = field(default_factory=list)
    fields: list[str] = field(default_factory=list)  # of signatures, by the names of their annotations
    sizes: list[float] = field(default_factory=list)  # of the headings above the present place

    def element(self, tag: Tag) -> Element:
        """The element of a tag, made where it is met first."""
        known = self.made.get(tag)
        if known is None:
            parent = self.element(tag.within) if tag.within is not None else self.top
            if (whole := GATHERED.get(tag.role)) and parent is self.top:
                last = parent.kids[-1] if parent.kids else None
                parent = last if isinstance(last, Element) and last.role == whole else Element(whole, parent)
            role = f"H{self._level(tag.size)}" if tag.role == HEADING else tag.role
            known = self.made[tag] = Element(role, parent, tag.alt, tag.attributes)
        return known

    def _level(self, size: float) -> int:
        while self.sizes and self.sizes[-1] <= size:
            self.sizes.pop()
        self.sizes.append(size)
        return min(len(self.sizes), LEVELS)

    def mark(self, element: Element) -> int:
        """The number of marked content of an element on the present page."""
        page = self.pages[-1]
        piece = TaggedPiece(len(self.pages) - 1, len(page))
        element.kids.append(piece)
        page.append(element)
        return piece.number

    def link(self, element: Element, name: str) -> int:
        """The number by which a link, or a field, finds its element."""
        element.kids.append(Annotation(len(self.pages) - 1, name))
        self.links.append(element)
        return self.count + len(self.links) - 1

    def finish(self, document: Any) -> Root:
        """Leave out what has no content, and make the elements objects of a document, in the order of reading."""
        _prune(self.top)
        root, elements = Root(self), list(_all(self.top))
        for element in elements:
            element.reference = document.Reference(element).format(document)
        pages = [PDFObjectReference(f"Page{n}").format(document) for n in range(1, len(self.pages) + 1)]
        for element in elements:
            element.write(
                pages,
                lambda name: document.refAnnotation(name).format(document),
                document.Reference(root).format(document),
            )
        return root


def _prune(element: Element) -> None:
    for kid in element.kids:
        if isinstance(kid, Element):
            _prune(kid)
    element.kids = [kid for kid in element.kids if not (isinstance(kid, Element) and kid.empty)]
    if len({type(kid) for kid in element.kids} - {Annotation}) > 1:  # text with links in it
        element.kids.sort(
            key=lambda kid: kid.place() if isinstance(kid, Element) else (kid.page, getattr(kid, "number", -1))
        )


def _all(element: Element) -> Iterator[Element]:
    yield element
    for kid in element.kids:
        if isinstance(kid, Element):
            yield from _all(kid)


class Link(PDFObject):  # type: ignore[misc]
    """What lies over a page and leads to a destination.  `parent`: the number by which it finds its element."""

    __RefOnly__ = 1

    def __init__(self, corners: tuple[float, float, float, float], words: str, to: Any, parent: int | None) -> None:
        self.corners, self.words, self.to, self.parent = corners, words, to, parent

    def format(self, document: Any) -> bytes:
        box = " ".join(f"{x + EDGE:.2f}" for x in self.corners)
        entries = (
            f"/Type /Annot /Subtype /Link /Border [0 0 0] /F {PRINTED} /Contents <{hexed(self.words)}> /Rect [{box}]"
        ).encode()
        parent = b"" if self.parent is None else b" /StructParent %d" % self.parent
        return b"<< %s%s /Dest %s >>" % (entries, parent, self.to.format(document))


class SignatureField(PDFObject):  # type: ignore[misc]
    """Where somebody signs by certificate: a field without a look, so that the empty box is as it is printed.

    `name`: by which a signing program finds it; `words`: what is read out; `page`: counted from 1."""

    __RefOnly__ = 1

    def __init__(
        self, corners: tuple[float, float, float, float], name: str, words: str, page: int, parent: int | None
    ) -> None:
        self.corners, self.name, self.words, self.page, self.parent = corners, name, words, page, parent

    def format(self, document: Any) -> bytes:
        left, low, right, top = (x + EDGE for x in self.corners)
        look = PDFStream(
            PDFDictionary(
                {
                    "Type": PDFName("XObject"),
                    "Subtype": PDFName("Form"),
                    "BBox": f"[0 0 {right - left:.2f} {top - low:.2f}]",
                }
            ),
            b"",
            filters=[PDFZCompress],
        )
        entries = (
            f"/Type /Annot /Subtype /Widget /FT /Sig /T ({self.name}) /TU <{hexed(self.words)}> /F {PRINTED}"
            f" /Contents <{hexed(self.words)}> /Rect [{left:.2f} {low:.2f} {right:.2f} {top:.2f}]"
        ).encode()
        parent = b"" if self.parent is None else b" /StructParent %d" % self.parent
        page, shown = PDFObjectReference(f"Page{self.page}"), document.Reference(look)
        return b"<< %s%s /P %s /AP << /N %s >> >>" % (entries, parent, page.format(document), shown.format(document))


def hexed(words: str) -> str:
    """A text as the hexadecimal string of a document."""
    return ("\ufeff" + words).encode("utf-16-be").hex().upper()
