# SPDX-License-Identifier: Apache-2.0
"""Where two documents differ: what they say about themselves, what their pages show, and the files inside them.

This is for whoever has a report that is not, byte for byte, what its design gives: it says where to look, and vouches for nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from calc.version import VERSION

from .pdf_file import Malformed, Pdf, Reference, Stream, words
from ..pdf_metadata import same
from ..printed import contents, printed

OF_THE_PROGRAM = {"Producer", "CreationDate", "ModDate"}  # what a program that saves a document says about itself
TOLD = ("Title", "Author", "Subject")  # of a document of any version
APART = {"Pages", "StructTreeRoot", "Metadata", "Type"}  # of the catalogue, what is compared by itself
PACKED = {"Length", "Filter", "DecodeParms", "Parent", "P"}  # how a stream is packed, and the ways back up
INHERITED = ("Resources", "MediaBox", "CropBox", "Rotate")  # by a page from what it stands in
PROGRAM = "Contralbero"
MOST = 1_000_000  # pairs of values that are compared at most


@dataclass(frozen=True)
class Difference:
    """Something that is not as it was: a value, a verdict, the text of a page."""

    what: str
    was: str
    now: str


def attachments(pdf: Pdf) -> dict[str, list[bytes]]:
    """Every file inside the document, by any way that a reader may take to it: a specification can name two."""
    names = _leaves(pdf, pdf.entries(pdf.root.get("Names")).get("EmbeddedFiles"), "Names")
    listed = [one for node in names for one in pdf.items(node.get("Names"))[1::2]]
    found: dict[str, list[bytes]] = {}
    for specification in map(pdf.entries, [*listed, *pdf.items(pdf.root.get("AF"))]):
        files = [pdf.data(stream) for stream in pdf.entries(specification.get("EF")).values()]
        for name in {words(specification[key]) for key in ("F", "UF") if key in specification}:
            found.setdefault(name, []).extend(files)
    return dict(sorted((name, files) for name, files in found.items() if files))


def page_references(pdf: Pdf) -> list[Reference]:
    """The pages of a document, as every reader counts them.  Raises Malformed where readers would not agree."""
    nodes: list[tuple[Reference, int, list[Any] | None]] = []  # each after the one that it stands in, with what it counts
    waiting, met = [pdf.root.get("Pages")], set()
    while waiting:
        one = waiting.pop()
        if not isinstance(one, Reference) or one.number in met:
            raise Malformed("a page stands there twice, or is none")
        met.add(one.number)
        entries = pdf.entries(one)
        kids = pdf.items(entries["Kids"]) if "Kids" in entries else None
        if entries.get("Type") != ("Page" if kids is None else "Pages"):
            raise Malformed("a page does not say that it is one")
        nodes.append((one, entries.get("Count", 0), kids))
        waiting += reversed(kids or [])
    within: dict[int, int] = {}
    for one, count, kids in reversed(nodes):
        within[one.number] = 1 if kids is None else sum(within[kid.number] for kid in kids)
        if kids is not None and count != within[one.number]:
            raise Malformed("it does not have as many pages as it says")
    return [one for one, _, kids in nodes if kids is None]


def _leaves(pdf: Pdf, top: Any, key: str) -> list[dict[str, Any]]:
    return [pdf.entries(top), *(pdf.entries(Reference(number)) for number in _numbered(pdf, top, key))]


def _numbered(pdf: Pdf, top: Any, key: str) -> Iterator[int]:
    """The objects of a tree that have a key, each object once, however often the tree names it."""
    waiting, met = [top], set()
    while waiting:
        one = waiting.pop()
        if isinstance(one, Reference):
            if one.number in met:
                continue
            met.add(one.number)
        entries = pdf.entries(one)
        if isinstance(one, Reference) and key in entries:
            yield one.number
        waiting += reversed(pdf.items(entries.get("Kids")))


def about(old: Pdf, new: Pdf, version: str) -> list[Difference]:
    """What the document says and does as a whole, where that is another thing."""
    was, is_now = old.info, new.info
    keys = dict.fromkeys([*was, *is_now]) if version == VERSION else TOLD
    told = [(key, words(was.get(key)), words(is_now.get(key))) for key in keys if key not in OF_THE_PROGRAM]
    found = [Difference(f"the document's {key.lower()}", a or "–", b or "–") for key, a, b in told if a != b]
    if version != VERSION:
        return found
    try:
        same(old.data(old.root.get("Metadata")), new.data(new.root.get("Metadata")))
    except Malformed as error:
        found.append(Difference("the document's metadata", str(error), "as this program has them"))
    compared = _Compared(old, new)
    if not compared.alike(old.root.get("StructTreeRoot"), new.root.get("StructTreeRoot")):
        found.append(Difference("the document's structure", "otherwise", "as this program has it"))
    for key in dict.fromkeys([*new.root, *old.root]):
        if key not in APART and not compared.alike(old.root.get(key), new.root.get(key)):
            now = "as this program has it" if key in new.root else "nothing of that kind"
            found.append(Difference("the document as a whole", key if key in old.root else f"no {key}", now))
    return found


def pages(old: Pdf, new: Pdf, version: str) -> list[Difference]:
    """The pages whose text or drawing is another one, and what was laid over them."""
    compared = _Compared(old, new)
    before, after = compared.pages
    if len(before) != len(after):
        return [Difference("pages", str(len(before)), str(len(after)))]
    found = []
    for number, (was, now) in enumerate(zip(before, after), 1):
        name = f"page {number}"
        texts = _text(old, was).replace(f"{PROGRAM} {version}", f"{PROGRAM} {VERSION}").split(), _text(new, now).split()
        if texts[0] != texts[1]:
            first = next((n for n, (a, b) in enumerate(zip(*texts)) if a != b), min(map(len, texts)))
            found.append(Difference(name, *(" ".join(some[max(0, first - 3) : first + 4]) for some in texts)))
        elif version == VERSION and not compared.drawn_alike(number - 1):
            found.append(Difference(f"{name}, what is drawn on it", "otherwise", "as this program draws it"))
        laid, links = (pdf.items(pdf.entries(page).get("Annots")) for pdf, page in ((old, was), (new, now)))
        if version == VERSION and len(laid) < len(links):
            found.append(Difference(f"{name}, laid over it", f"{len(laid)} links", f"{len(links)} links"))
        for n, one in enumerate(laid if version == VERSION else ()):
            if not (n < len(links) and compared.alike(one, links[n])):
                found.append(Difference(f"{name}, laid over it", words(old.entries(one).get("Subtype")), "nothing, or something else"))
    return found


def _text(pdf: Pdf, page: Reference) -> str:
    try:
        return " ".join(said for _, said in printed(pdf, page))
    except (ValueError, TypeError, IndexError):  # in another program's way, or in none
        return ""


class _Compared:
    """Whether parts of two documents hold the same, whatever their numbers and however their streams are packed."""

    def __init__(self, old: Pdf, new: Pdf) -> None:
        self.old, self.new = old, new
        self.pages = page_references(old), page_references(new)
        self.numbers = [{page.number: n for n, page in enumerate(some)} for some in self.pages]
        self.left = MOST

    def drawn_alike(self, number: int) -> bool:
        """Whether a page looks the same: its marks, and all that it says of itself but what is laid over it."""
        old, new = self.old, self.new
        was, now = _whole(old, self.pages[0][number]), _whole(new, self.pages[1][number])
        marks = contents(old, was).strip() == contents(new, now).strip()
        return marks and self.alike(*({key: page[key] for key in page if key not in ("Contents", "Annots")} for page in (was, now)))

    def alike(self, first: Any, second: Any) -> bool:
        waiting, met = [(first, second)], set()
        while waiting:
            a, b = waiting.pop()
            self.left -= 1
            if self.left < 0:
                raise Malformed(f"it holds more than {MOST:,} values that must be compared")
            if isinstance(a, Reference) and isinstance(b, Reference):
                pair = a.number, b.number
                places = [numbers.get(n, -1) for numbers, n in zip(self.numbers, pair)]
                if places != [-1, -1] or pair in met:
                    if places[0] != places[1]:
                        return False
                    continue
                met.add(pair)
            a, b = self.old.value(a), self.new.value(b)
            if isinstance(a, Stream) and isinstance(b, Stream):
                packed = all(a.entries.get(key) == b.entries.get(key) for key in ("Filter", "DecodeParms")) and a.packed == b.packed
                if not packed and self.old.data(a) != self.new.data(b):
                    return False
                a, b = a.entries, b.entries
            if isinstance(a, dict) and isinstance(b, dict):
                keys = set(a) - PACKED
                if keys != set(b) - PACKED:
                    return False
                waiting += [(a[key], b[key]) for key in keys]
            elif isinstance(a, list) and isinstance(b, list):
                if len(a) != len(b):
                    return False
                waiting += zip(a, b)
            elif a != b or isinstance(a, bool) != isinstance(b, bool):
                return False
        return True


def _whole(pdf: Pdf, page: Reference) -> dict[str, Any]:
    """A page with what it inherits."""
    found, above = dict(pdf.entries(page)), pdf.entries(page)
    for _ in range(len(pdf.objects)):
        above = pdf.entries(above.get("Parent"))
        if not above:
            break
        found = {**{key: above[key] for key in INHERITED if key in above}, **found}
    return found
