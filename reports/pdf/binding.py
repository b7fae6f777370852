# SPDX-License-Identifier: Apache-2.0
"""The pages on the canvas made into a document: running heads, outline, packed objects, files inside it."""

from __future__ import annotations

import io
import zlib
from collections.abc import Iterable, Iterator
from functools import partial
from typing import Any

from reportlab import rl_config
from reportlab.pdfgen.canvas import Canvas

from calc.sheet.progress import Progress, tell

from ..blocks.title_block import SHORT_HASH
from ..made import MADE, program
from ..typesetting.boxes import BETWEEN, EDGE, FAINT, GREY
from ..typesetting.fonts import PAGE, TOP, UPRIGHT, WIDTH, clean, unicode_map
from ..typesetting.pagination import Page
from ..typesetting.pen import Codes, Pen
from ..typesetting.prose import NOTE, one_line
from ..typesetting.tags import Tag, Tree
from . import attach
from .archive import archive


def paint(
    canvas: Canvas,
    pages: list[Page],
    head: tuple[str, str],
    foot: tuple[str, str],
    counted: str,
    progress: Progress | None = None,
) -> Tree:
    """All pages with running head, foot and outline; what their parts are.  `counted` holds {page} and {pages}."""
    numbers = {block.anchor: n for n, page in enumerate(pages, 1) for _, block in page.blocks if block.anchor}
    places: dict[str, list[int]] = {}
    for n, page in enumerate(pages, 1):
        for _, block in page.blocks:
            for name in block.indexed.split(BETWEEN) if block.indexed else ():
                if n not in places.setdefault(name, []):
                    places[name].append(n)
    upper = PAGE[1] - TOP
    codes: dict[str, Codes] = {}
    tree = Tree(len(pages))
    for n, page in enumerate(pages, 1):
        tell(progress, (n - 1) / len(pages), counted.format(page=n, pages=len(pages)))
        pen = Pen(canvas, numbers, codes, places, tree)
        canvas.setPageSize(page.size or PAGE)
        canvas.bookmarkHorizontalAbsolute(f"page-{n}", (page.size or PAGE)[1], left=0)
        if page.size is not None:
            titles = [block.outline[1] for _, block in page.blocks if block.outline is not None]
            pen.put(one_line(" · ".join([*titles, counted.format(page=n, pages=len(pages))]), NOTE, WIDTH), 0.0, 4.0)
        else:
            _running(pen, n, len(pages), head, foot, counted)
        again = page.blocks[1][1].repeat if len(page.blocks) > 1 else None
        for at, block in page.blocks:
            if block.anchor:
                canvas.bookmarkHorizontalAbsolute(block.anchor, round(upper - at + 8.0 + EDGE, 2), left=0)
            if block.outline is not None:
                canvas.addOutlineEntry(block.outline[1], block.anchor, block.outline[0], closed=block.outline[0] > 0)
            with pen.tagged(None if block is again else block.tag or Tag("P")):
                block.draw(pen, upper - at)
        pen.write()
        canvas.showPage()
    return tree


def _running(pen: Pen, number: int, count: int, head: tuple[str, str], foot: tuple[str, str], counted: str) -> None:
    pages = one_line(counted.format(page=number, pages=count), NOTE, 100.0)
    upper, lower = PAGE[1] - 36.0, 30.0
    right = one_line(head[1], NOTE, 0.35 * WIDTH)
    pen.put(one_line(head[0], NOTE, WIDTH - right.width - 12.0), 0.0, upper)
    pen.put(right, WIDTH - right.width, upper)
    pen.rule(0.0, upper - 5.0, WIDTH, 0.5, GREY)
    pen.rule(0.0, lower + 11.0, WIDTH, 0.4, FAINT)
    left = one_line(foot[0], NOTE, 0.4 * WIDTH)
    pen.put(left, 0.0, lower)
    pen.put(
        one_line(foot[1], NOTE, WIDTH - left.width - pages.width - 28.0), left.width + 14.0 if foot[0] else 0.0, lower
    )
    pen.put(pages, WIDTH - pages.width, lower)


# --- the objects of a document as the bytes of a file, small ones packed together
# The thousands that say what every cell of a table is take a tenth of the room that they take one by one.

EACH = 100  # objects of a pack: a reader unpacks all of them for one
OPEN, PACKED = 1, 2  # kinds of entry in the table of objects


def packed(document: Any) -> bytes:
    """What reportlab's document writes, with streams of objects and their table (PDF 1.5) instead of one object after
    the other."""
    root, info = document.Reference(document.Catalog), document.Reference(document.info)
    for name in [name for name in document.idToObject if name.startswith("toUnicodeCMap:")]:
        document.idToObject[name].content = unicode_map(document.idToObject[name].content)
    file = bytearray(b"%%PDF-%d.%d\n%%\223\214\213\236\n" % document._pdfVersion)
    entries: list[tuple[int, int, int]] = [(0, 0, 65535)]
    small: list[tuple[int, bytes]] = []
    for number, body in _objects(document):
        entries.append((OPEN, 0, 0))
        if body.endswith(b"endstream\n"):
            entries[number] = (OPEN, len(file), 0)
            file += _object(number, body.removesuffix(b"endstream\n") + b"\nendstream\n")
        else:
            small.append((number, body))
    for start in range(0, len(small), EACH):
        some = small[start : start + EACH]
        for n, (number, _) in enumerate(some):
            entries[number] = (PACKED, len(entries), n)
        entries.append((OPEN, len(file), 0))
        file += _object(len(entries) - 1, _pack(some))
    at = len(file)
    entries.append((OPEN, at, 0))
    identity = document.ID().partition(b"%")[0].strip()
    trailer = b"/Root %s /Info %s /ID %s" % (root.format(document), info.format(document), identity)
    file += _object(len(entries) - 1, _table(entries, trailer))
    file += b"startxref\n%d\n%%%%EOF\n" % at
    return bytes(file)


def _objects(document: Any) -> Iterator[tuple[int, bytes]]:
    """Every object by its number; writing one may call for others."""
    number = 1
    while number in document.numberToId:
        yield number, document.idToObject[document.numberToId[number]].format(document)
        number += 1


def _object(number: int, body: bytes) -> bytes:
    return b"%d 0 obj\n%sendobj\n" % (number, body)


def _stream(entries: bytes, contents: bytes) -> bytes:
    raw = zlib.compress(contents)
    return b"<< %s /Filter /FlateDecode /Length %d >>\nstream\n%s\nendstream\n" % (entries, len(raw), raw)


def _pack(some: list[tuple[int, bytes]]) -> bytes:
    heads, at = [], 0
    for number, body in some:
        heads.append(b"%d %d" % (number, at))
        at += len(body) + 1
    first = b" ".join(heads) + b"\n"
    return _stream(
        b"/Type /ObjStm /N %d /First %d" % (len(some), len(first)), first + b"\n".join(body for _, body in some)
    )


def _table(entries: Iterable[tuple[int, int, int]], trailer: bytes) -> bytes:
    """Where every object is: each entry as its difference from the one above, which are nearly all alike."""
    rows, above = [], bytes(7)
    for kind, where, n in entries:
        row = bytes([kind]) + where.to_bytes(4) + n.to_bytes(2)
        rows.append(b"\x02" + bytes((a - b) & 255 for a, b in zip(row, above)))
        above = row
    size = b"/Type /XRef /Size %d /W [1 4 2] /DecodeParms << /Predictor 12 /Columns 7 >> " % len(rows)
    return _stream(size + trailer, b"".join(rows))


# --- pages made into a document
# What it says about itself, the files inside it, its running heads.


def bind(
    pages: list[Page],
    files: dict[str, tuple[bytes, str]],
    *,
    title: str,
    author: str,
    revision: str,
    said: dict[str, str],
    made: dict[str, str],
    words: dict[str, str],
    number: str = "",
    kind: str = "report",
    designs: str = "",
    progress: Progress | None = None,
) -> bytes:
    """The document as the bytes of a PDF.  `said`: what it must keep about how it was made; `made`: with which
    versions; `kind`: of its title in the running head; `designs`: what its foot says of those that it is about, left
    out the sum of the one."""
    out = io.BytesIO()
    dense, rl_config.useA85 = rl_config.useA85, 0  # streams as bytes, not as text a quarter longer
    try:
        canvas = Canvas(
            out,
            pagesize=PAGE,
            invariant=1,
            pageCompression=1,
            pdfVersion=(1, 7),
            initialFontName=UPRIGHT,
            lang=said["lang"],
        )
        attach.describe(
            canvas,
            title=clean(title),
            author=clean(author),
            subject=f"{words[kind]}, design file sha256 {said['sha256']}",
            keywords=attach.keywords(program(made), **said, **{name: made[name] for name in MADE[1:] if name in made}),
            program=program(made),
        )
        attach.attach(canvas, files)
        canvas.setViewerPreference("DisplayDocTitle", "true")
        canvas.showOutline()
        of = " · ".join(filter(None, (number, revision and f"{words['revision']} {revision}")))
        foot = (of, f"{program(made)} · {designs or 'sha256 ' + said['sha256'][:SHORT_HASH]}")
        tree = paint(canvas, pages, (title, words[kind]), foot, words["page"], progress)
        archive(canvas._doc, tree, said["lang"])
        canvas._doc.format = partial(packed, canvas._doc)
        canvas.save()
    finally:
        rl_config.useA85 = dense
    return out.getvalue()
