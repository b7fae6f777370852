# SPDX-License-Identifier: Apache-2.0
"""Where two documents differ: what they say about themselves, what their pages show, and the files inside them.

This is for whoever has a report that is not, byte for byte, what its design gives: it says where to look, and vouches
for nothing."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from calc.sheet.version import VERSION

from ..typesetting.tags import FIGURE
from .pdf_file import Malformed, Pdf, Reference, Stream, words
from .signature import same

# --- where on a page something is printed, so that what is laid over it can be told from what covers nothing
# Text counts wherever it stands, figures and formulas as a whole, with the bars between their letters; rules, frames
# and panels say nothing by themselves.

Rectangle = tuple[float, float, float, float]  # left, lower, right, upper
ABOVE, BELOW = 0.72, 0.20  # of the size: how far letters reach from their base line
NEAR = 1.0  # points at its edges in which something printed may be overlapped
SPAN = "Span"  # of a formula: its letters with what is read out for them
WHOLE = {FIGURE: "figure", SPAN: "formula"}
PARTS = 100  # of the contents of a page
MOST_PRINTED = 60  # letters that are quoted of what is covered
NUMBER = rb"-?[\d.]{1,30}"
TOKEN = re.compile(
    rb"(?P<matrix>(?:" + NUMBER + rb" ){6})Tm|/(?P<font>\S{1,60}) (?P<size>[\d.]{1,30}) Tf|<(?P<codes>[0-9a-fA-F]*)> Tj"
    rb"|/(?P<role>\w{1,60}) (?:<<(?:[^<>]|<[^<>]*>)*>> BDC|BMC)|(?P<end>EMC)"
    rb"|1 0 0 1 (?P<frame>(?:" + NUMBER + rb" ){2})cm|(?P<image>(?:" + NUMBER + rb" ){6})cm"
    rb"|(?P<area>(?:" + NUMBER + rb" ){4})re\b|(?P<points>(?:" + NUMBER + rb" ){2,6})[mlc]\b",
    re.S,
)
CODE = re.compile(rb"<([0-9A-F]{2})> <([0-9A-F]{4,})>")


def covered(rectangle: Rectangle, under: Iterable[tuple[Rectangle, str]]) -> str:
    """What a rectangle covers of what is printed on a page; empty where it is nothing."""
    left, low, right, top = rectangle
    texts = [text for (a, b, c, d), text in under if _reaches(left, right, a, c) and _reaches(low, top, b, d)]
    passage = " ".join(texts)
    return passage if len(passage) <= MOST_PRINTED else f"{passage[:MOST_PRINTED]} …"


def _reaches(start: float, end: float, low: float, high: float) -> bool:
    """Whether one stretch reaches into another beyond its edges; what is thinner than both edges has still a middle."""
    return start < max(high - NEAR, (low + high) / 2) and end > min(low + NEAR, (low + high) / 2)


def printed(pdf: Pdf, page: Any) -> Iterator[tuple[Rectangle, str]]:
    """Every piece of text, every formula and every figure of a page with its place."""
    known = pdf.entries(pdf.entries(pdf.entries(page).get("Resources")).get("Font"))
    fonts = {name: _font(pdf, pdf.entries(reference)) for name, reference in known.items()}
    matrix, x, size, font = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0), 0.0, 0.0, ""
    roles: list[str] = []
    drawn: list[tuple[float, float]] = []
    origin: tuple[float, ...] = (0.0, 0.0)  # of what is drawn in a frame of its own
    for token in TOKEN.finditer(contents(pdf, page)):
        if token["matrix"]:
            matrix, x = _six(token["matrix"]), 0.0
        elif token["font"]:
            font, size = token["font"].decode("latin-1"), float(token["size"])
        elif token["codes"] is not None:
            wide, text = _set(fonts.get(font), bytes.fromhex(token["codes"].decode()))
            if text.strip():
                place = _box(matrix, x, x + wide * size, size)
                yield place, text
                if SPAN in roles:
                    drawn += [place[:2], place[2:]]
            x += wide * size
        elif token["role"]:
            roles.append(token["role"].decode())
        elif token["end"]:
            role = roles.pop() if roles else ""
            if role in WHOLE and drawn:
                xs, ys = zip(*drawn)
                yield (min(xs), min(ys), max(xs), max(ys)), WHOLE[role]
                drawn = []
            origin = 0.0, 0.0
        elif token["frame"]:
            origin = tuple(map(float, token["frame"].split()))
        elif FIGURE in roles:
            drawn += [(a + origin[0], b + origin[1]) for a, b in _corners(token)]


def contents(pdf: Pdf, page: Any) -> bytes:
    """The operators of a page."""
    entry = pdf.entries(page).get("Contents")
    parts = pdf.items(entry) or [entry]
    if len(parts) > PARTS:
        raise Malformed(f"a page has {len(parts):,} contents; at most {PARTS} are read")
    return b"\n".join(pdf.data(part) for part in parts)


def _corners(token: re.Match[bytes]) -> list[tuple[float, float]]:
    """The points of an operator that draws."""
    if token["points"]:
        numbers = [float(number) for number in token["points"].split()]
        return list(zip(numbers[::2], numbers[1::2]))
    if token["area"]:
        x, y, wide, high = (float(number) for number in token["area"].split())
    else:
        wide, _, _, high, x, y = _six(token["image"])
    return [(x, y), (x + wide, y + high)]


def _six(numbers: bytes) -> tuple[float, float, float, float, float, float]:
    a, b, c, d, e, f = (float(number) for number in numbers.split())
    return a, b, c, d, e, f


def _box(matrix: tuple[float, float, float, float, float, float], start: float, end: float, size: float) -> Rectangle:
    """The room of a piece of text from start to end along its line."""
    a, b, c, d, e, f = matrix
    ends = [(a * u + c * v + e, b * u + d * v + f) for u in (start, end) for v in (-BELOW * size, ABOVE * size)]
    xs, ys = zip(*ends)
    return min(xs), min(ys), max(xs), max(ys)


Font = tuple[int, list[float], dict[int, str]]  # its first code, widths from there, letters


def _font(pdf: Pdf, font: dict[str, Any]) -> Font:
    letters = {
        int(code, 16): bytes.fromhex(to.decode()).decode("utf-16-be")
        for code, to in CODE.findall(pdf.data(font.get("ToUnicode")))
    }
    return int(font.get("FirstChar", 0)), [float(width) for width in pdf.items(font.get("Widths"))], letters


def _set(font: Font | None, codes: bytes) -> tuple[float, str]:
    """How wide codes stand for each point of size, and what they say; of a font that is not known half a size each."""
    if font is None or not font[1]:
        return 0.5 * len(codes), "?" * len(codes)
    first, widths, letters = font
    wide = sum(widths[code - first] if 0 <= code - first < len(widths) else 500.0 for code in codes)
    return wide / 1000, "".join(letters.get(code, "?") for code in codes)


# --- the differences

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
    listed = [entry for node in names for entry in pdf.items(node.get("Names"))[1::2]]
    by_name: dict[str, list[bytes]] = {}
    for specification in map(pdf.entries, [*listed, *pdf.items(pdf.root.get("AF"))]):
        files = [pdf.data(stream) for stream in pdf.entries(specification.get("EF")).values()]
        for name in {words(specification[key]) for key in ("F", "UF") if key in specification}:
            by_name.setdefault(name, []).extend(files)
    return dict(sorted((name, files) for name, files in by_name.items() if files))


def page_references(pdf: Pdf) -> list[Reference]:
    """The pages of a document, as every reader counts them.  Raises Malformed where readers would not agree."""
    # each after the one that it stands in, with what it counts
    nodes: list[tuple[Reference, int, list[Any] | None]] = []
    waiting, met = [pdf.root.get("Pages")], set()
    while waiting:
        node = waiting.pop()
        if not isinstance(node, Reference) or node.number in met:
            raise Malformed("a page stands there twice, or is none")
        met.add(node.number)
        entries = pdf.entries(node)
        kids = pdf.items(entries["Kids"]) if "Kids" in entries else None
        if entries.get("Type") != ("Page" if kids is None else "Pages"):
            raise Malformed("a page does not say that it is one")
        nodes.append((node, entries.get("Count", 0), kids))
        waiting += reversed(kids or [])
    within: dict[int, int] = {}
    for node, count, kids in reversed(nodes):
        within[node.number] = 1 if kids is None else sum(within[kid.number] for kid in kids)
        if kids is not None and count != within[node.number]:
            raise Malformed("it does not have as many pages as it says")
    return [node for node, _, kids in nodes if kids is None]


def _leaves(pdf: Pdf, top: Any, key: str) -> list[dict[str, Any]]:
    return [pdf.entries(top), *(pdf.entries(Reference(number)) for number in _numbered(pdf, top, key))]


def _numbered(pdf: Pdf, top: Any, key: str) -> Iterator[int]:
    """The objects of a tree that have a key, each object once, however often the tree names it."""
    waiting, met = [top], set()
    while waiting:
        node = waiting.pop()
        if isinstance(node, Reference):
            if node.number in met:
                continue
            met.add(node.number)
        entries = pdf.entries(node)
        if isinstance(node, Reference) and key in entries:
            yield node.number
        waiting += reversed(pdf.items(entries.get("Kids")))


def about(old: Pdf, new: Pdf, version: str) -> list[Difference]:
    """What the document says and does as a whole, where that is another thing."""
    was, is_now = old.info, new.info
    keys = dict.fromkeys([*was, *is_now]) if version == VERSION else TOLD
    statements = [(key, words(was.get(key)), words(is_now.get(key))) for key in keys if key not in OF_THE_PROGRAM]
    differences = [
        Difference(f"the document's {key.lower()}", a or "–", b or "–") for key, a, b in statements if a != b
    ]
    if version != VERSION:
        return differences
    try:
        same(old.data(old.root.get("Metadata")), new.data(new.root.get("Metadata")))
    except Malformed as error:
        differences.append(Difference("the document's metadata", str(error), "as this program has them"))
    compared = _Compared(old, new)
    if not compared.alike(old.root.get("StructTreeRoot"), new.root.get("StructTreeRoot")):
        differences.append(Difference("the document's structure", "otherwise", "as this program has it"))
    for key in dict.fromkeys([*new.root, *old.root]):
        if key not in APART and not compared.alike(old.root.get(key), new.root.get(key)):
            now = "as this program has it" if key in new.root else "nothing of that kind"
            differences.append(Difference("the document as a whole", key if key in old.root else f"no {key}", now))
    return differences


def pages(old: Pdf, new: Pdf, version: str) -> list[Difference]:
    """The pages whose text or drawing is another one, and what was laid over them."""
    compared = _Compared(old, new)
    before, after = compared.pages
    if len(before) != len(after):
        return [Difference("pages", str(len(before)), str(len(after)))]
    differences = []
    for number, (was, now) in enumerate(zip(before, after), 1):
        name = f"page {number}"
        texts = _text(old, was).replace(f"{PROGRAM} {version}", f"{PROGRAM} {VERSION}").split(), _text(new, now).split()
        if texts[0] != texts[1]:
            first = next((n for n, (a, b) in enumerate(zip(*texts)) if a != b), min(map(len, texts)))
            differences.append(Difference(name, *(" ".join(some[max(0, first - 3) : first + 4]) for some in texts)))
        elif version == VERSION and not compared.drawn_alike(number - 1):
            differences.append(Difference(f"{name}, what is drawn on it", "otherwise", "as this program draws it"))
        laid, links = (pdf.items(pdf.entries(page).get("Annots")) for pdf, page in ((old, was), (new, now)))
        if version == VERSION and len(laid) < len(links):
            differences.append(Difference(f"{name}, laid over it", f"{len(laid)} links", f"{len(links)} links"))
        for n, annotation in enumerate(laid if version == VERSION else ()):
            if not (n < len(links) and compared.alike(annotation, links[n])):
                differences.append(
                    Difference(
                        f"{name}, laid over it",
                        words(old.entries(annotation).get("Subtype")),
                        "nothing, or something else",
                    )
                )
    return differences


def _text(pdf: Pdf, page: Reference) -> str:
    try:
        return " ".join(text for _, text in printed(pdf, page))
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
        return marks and self.alike(
            *({key: page[key] for key in page if key not in ("Contents", "Annots")} for page in (was, now))
        )

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
                packed = (
                    all(a.entries.get(key) == b.entries.get(key) for key in ("Filter", "DecodeParms"))
                    and a.packed == b.packed
                )
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
    entries, above = dict(pdf.entries(page)), pdf.entries(page)
    for _ in range(len(pdf.objects)):
        above = pdf.entries(above.get("Parent"))
        if not above:
            break
        entries = {**{key: above[key] for key in INHERITED if key in above}, **entries}
    return entries
