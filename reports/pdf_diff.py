# SPDX-License-Identifier: Apache-2.0
"""Two documents side by side: what they say about themselves, what their pages show, and the files inside them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pypdf import PageObject, PdfReader
from pypdf.generic import DictionaryObject, IndirectObject, StreamObject

from calc.version import VERSION

from .printed import covered

# What a link of a report has, and nothing that is seen
LINK = {"/Type", "/Subtype", "/Rect", "/Border", "/Contents", "/Dest", "/P", "/F", "/StructParent"}
SIGNED = {"/AcroForm", "/Perms", "/DSS", "/Extensions"}  # what a program that signs adds to a document
SPOKEN = ("/S", "/Alt", "/ActualText", "/E", "/Lang", "/MCID")  # of an element, what a machine reads out, and where
PACKED = {"/Length", "/Filter", "/DecodeParms", "/Parent"}  # how a stream is packed, and the way back up
ACTIONS = ("/AA", "/Group", "/Trans", "/VP")  # what a page of a report does not have
PROGRAM = "Contralbero"
Same = dict[tuple[int, int], bool]  # objects of both documents by their numbers → whether they are the same


@dataclass(frozen=True)
class Difference:
    """Something that is not as it was: a value, a verdict, the text of a page."""

    what: str
    was: str
    now: str


def attachments(reader: PdfReader) -> dict[str, list[bytes]]:
    """Every file inside the document, by any way that a reader may take to it: a specification can name two."""
    root = reader.root_object
    names = _resolved(_resolved(root.get("/Names", {})).get("/EmbeddedFiles", {}))
    found: dict[str, list[bytes]] = {}
    for specification in map(_resolved, [*_leaves(names), *_resolved(root.get("/AF", []))]):
        contents = [_resolved(stream).get_data() for stream in _resolved(specification["/EF"]).values()]
        for name in {str(specification[key]) for key in ("/F", "/UF") if key in specification}:
            found.setdefault(name, []).extend(contents)
    return dict(sorted(found.items()))


def _leaves(node: Any) -> Iterator[Any]:
    """The values of a tree of names."""
    yield from list(_resolved(node.get("/Names", [])))[1::2]
    for kid in _resolved(node.get("/Kids", [])):
        yield from _leaves(_resolved(kid))


def about(old: PdfReader, new: PdfReader, version: str) -> list[Difference]:
    """What the document says and does as a whole, where that is another thing; what a program has left out of a copy does no harm."""
    said = {name: [str(getattr(reader.metadata, name, None) or "") for reader in (old, new)] for name in ("title", "author", "subject")}
    found = [Difference(f"the document's {name}", was, now) for name, (was, now) in said.items() if was and was != now]
    found += [Difference(*one) for one in _described(old, new)]
    if version == VERSION and _spoken(old) not in ([], _spoken(new)):
        found.append(Difference("the document's structure", "otherwise", "as this program has it"))
    more = [key for key in old.root_object if key not in new.root_object and key not in SIGNED]
    found += [Difference("the document as a whole", key.removeprefix("/"), "nothing of that kind") for key in more]
    fields = _resolved(_resolved(old.root_object.get("/AcroForm", {})).get("/Fields", []))
    found += [Difference("the document as a whole", "a form", "no form") for field in fields if not signs(_resolved(field))]
    scripts = [key for key in _resolved(old.root_object.get("/Names", {})) if key not in _resolved(new.root_object.get("/Names", {}))]
    return found + [Difference("the document as a whole", key.removeprefix("/"), "nothing of that kind") for key in scripts]


def _described(old: PdfReader, new: PdfReader) -> list[tuple[str, str, str]]:
    """What the XMP of a document says that its information dictionary should not say; readers show either."""
    meta, now = old.xmp_metadata, new.metadata
    if meta is None or now is None:
        return []
    said = {
        "title": ([*(meta.dc_title or {}).values()], now.title), "author": (meta.dc_creator or [], now.author),
        "subject": ([*(meta.dc_description or {}).values()], now.subject),
    }  # fmt: skip
    return [(f"the document's {name}", one, is_now or "") for name, (all, is_now) in said.items() for one in all if one != is_now]


def _spoken(reader: PdfReader) -> list[Any]:
    """The tree of what the parts of the pages are, as a machine reads it out; empty where a copy has left it out."""
    found: list[Any] = []
    waiting = [reader.root_object.get("/StructTreeRoot")]
    met: set[int] = set()
    while waiting:
        one = waiting.pop()
        if isinstance(one, IndirectObject):
            if one.idnum in met:
                continue
            met.add(one.idnum)
        one = _resolved(one)
        if isinstance(one, DictionaryObject):
            found += [str(one.get(key, "")) for key in SPOKEN]
            kids = _resolved(one.get("/K", []))
            waiting += reversed(kids if isinstance(kids, list) else [kids])
        elif one is not None:
            found.append(one)
    return found


def pages(before: PdfReader, now: PdfReader, version: str) -> list[Difference]:
    """The pages whose text or drawing is another one, and what was laid over them."""
    if len(before.pages) != len(now.pages):
        return [Difference("pages", str(len(before.pages)), str(len(now.pages)))]
    found = []
    same: Same = {}
    for number, (old, new) in enumerate(zip(before.pages, now.pages), 1):
        name = f"page {number}"
        was = old.extract_text().replace(f"{PROGRAM} {version}", f"{PROGRAM} {VERSION}").split()
        is_now = new.extract_text().split()
        if was != is_now:
            first = next((n for n, (a, b) in enumerate(zip(was, is_now)) if a != b), min(len(was), len(is_now)))
            found.append(Difference(name, *(" ".join(words[max(0, first - 3) : first + 4]) for words in (was, is_now))))
        elif version == VERSION and not _drawn_alike(old, new, same):
            found.append(Difference(f"{name}, what is drawn on it", "otherwise", "as this program draws it"))
        links = {_place(one) for one in annotations(new)}
        laid = [one for one in annotations(old) if not (set(one) <= LINK and (_place(one) in links or version != VERSION))]
        over = [one for one in laid if not signs(one)]
        hidden = [words for one in laid if signs(one) and (words := covered(old, one))]
        found += [Difference(f"{name}, laid over it", str(one.get("/Subtype", "")).removeprefix("/"), "nothing") for one in over]
        found += [Difference(f"{name}, under the field of a signature", "covered", f"“{words}”") for words in hidden]
    return found


def _drawn_alike(old: PageObject, new: PageObject, same: Same) -> bool:
    """Whether two pages look the same: their marks, the fonts and pictures that these use, and the part of the sheet that is shown."""
    marks = [contents.get_data().strip() if (contents := page.get_contents()) is not None else b"" for page in (old, new)]
    shown = [(*page.mediabox, *page.cropbox, page.rotation, page.user_unit) for page in (old, new)]
    more = [key for key in old if key not in new and key in ACTIONS]
    used = [page.get("/Resources", {}) for page in (old, new)]
    return marks[0] == marks[1] and shown[0] == shown[1] and not more and _alike(used[0], used[1], same)


def _alike(a: Any, b: Any, same: Same) -> bool:
    """Whether two objects hold the same, whatever their numbers and however their streams are packed."""
    key = (a.idnum, b.idnum) if isinstance(a, IndirectObject) and isinstance(b, IndirectObject) else None
    if key in same:
        return same[key]
    if key is not None:
        same[key] = True  # on the way to itself
    a, b = _resolved(a), _resolved(b)
    if isinstance(a, DictionaryObject) and isinstance(b, DictionaryObject):
        mine, other = ({k: v for k, v in x.items() if k not in PACKED} for x in (a, b))
        found = set(mine) == set(other) and all(_alike(mine[k], other[k], same) for k in mine)
        if isinstance(a, StreamObject) or isinstance(b, StreamObject):
            found = found and isinstance(a, StreamObject) and isinstance(b, StreamObject) and a.get_data() == b.get_data()
    elif isinstance(a, list) and isinstance(b, list):
        found = len(a) == len(b) and all(_alike(x, y, same) for x, y in zip(a, b))
    else:
        found = bool(a == b)
    if key is not None:
        same[key] = found
    return found


def _resolved(x: Any) -> Any:
    return x.get_object() if isinstance(x, IndirectObject) else x


def annotations(page: PageObject) -> list[Any]:
    return [_resolved(one) for one in _resolved(page.get("/Annots")) or []]


def _place(annotation: Any) -> tuple[float, ...]:
    return tuple(round(float(x), 2) for x in annotation.get("/Rect", ()))


def signs(annotation: Any) -> bool:
    """Whether it is the field of a signature, and does nothing when it is touched."""
    kind = annotation.get("/FT") or _resolved(annotation.get("/Parent", {})).get("/FT")
    return bool(kind == "/Sig" and annotation.get("/Subtype", "/Widget") == "/Widget" and not {"/A", "/AA"} & set(annotation))
