# SPDX-License-Identifier: Apache-2.0
"""What finds things in a report: the contents, the index of values, the register of publications.

The contents have links and page numbers."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from calc.library.publications import Publication, resolved
from calc.sheet.text import Text

from ..context import Context
from ..typesetting.boxes import BETWEEN, FAINT, SIGN, Box, text
from ..typesetting.fonts import HEIGHT, WIDTH
from ..typesetting.pagination import Block, ListOfHeadings, bullet, heading, paragraph
from ..typesetting.prose import BODY, GROUP, NOTE, SECTION, one_line, run
from ..typesetting.tables import GUTTER, Cell, Column, Group, Row, noted_below, table
from ..typesetting.tags import Tag

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


TITLE = 122.0  # width of a section's title
NUMBER = 16.0  # of a part's page number with the space before it
PARTS = WIDTH - TITLE - 6.0 - 22.0  # of all parts


@dataclass(slots=True)
class ContentsEntry:
    """A section and its parts: the title of each with the anchor that it leads to."""

    title: str
    anchor: str
    parts: dict[str, str]


def contents_blocks(context: Context, entries: list[ContentsEntry], names: list[str]) -> list[Block]:
    """One row a section: its title, its parts with their pages, its own page.  Like parts stand below each other;
    everything is a link.

    `names`: the parts that there may be, in their order.
    """
    title = context.words["contents"]
    blocks = heading(title, SECTION, gap=12.0, after=1.0)
    blocks[0] = replace(blocks[0], content=ListOfHeadings(title))
    parts = {name: run(name, NOTE) for name in names if any(name in entry.parts for entry in entries)}
    share = (PARTS - sum(box.width + NUMBER for box in parts.values())) / max(len(parts), 1)
    columns: dict[str, tuple[float, Box]] = {}
    x = TITLE + 6.0
    for name, box in parts.items():
        columns[name] = x, box
        x += box.width + NUMBER + share
    rows = [_row(entry, columns) for entry in entries]
    blocks += [replace(b, keep=i < len(rows) - 1) for i, b in enumerate(rows)]
    return blocks


def _row(entry: ContentsEntry, columns: dict[str, tuple[float, Box]]) -> Block:
    tall = 12.6
    title = one_line(entry.title, BODY, TITLE)

    def draw(pen: Pen, y: float) -> None:
        base = y - 0.78 * BODY.leading
        page = text(str(pen.numbers.get(entry.anchor, "")), BODY.size)
        pen.put(title, 0.0, base)
        pen.put(page, WIDTH - page.width, base)
        for part, anchor in entry.parts.items():
            x, name = columns[part]
            number = text(str(pen.numbers.get(anchor, "")), NOTE.size, colour=NOTE.colour)
            pen.put(name, x, base)
            pen.put(number, x + name.width + 3.0, base)
            pen.link(x, base - 2.0, name.width + number.width + 4.0, 9.0, anchor, entry.title)
        pen.rule(0.0, y - tall + 0.6, WIDTH, 0.4, FAINT)
        pen.link(0.0, base - 2.5, TITLE + 2.0, 10.5, entry.anchor, entry.title)
        pen.link(WIDTH - 24.0, base - 2.5, 24.0, 10.5, entry.anchor, entry.title)

    return Block(tall, draw, tag=Tag("TOCI"))


# --- the index at the end: every value by its name, with the pages on which it stands

COLUMNS = 2
EACH = (WIDTH - (COLUMNS - 1) * GUTTER) / COLUMNS
NUMBERS = 34.0  # width for the pages of an entry
MOST = 3  # pages of an entry
ROWS = int((HEIGHT - 50.0) / NOTE.leading)  # of a page, below the heading


def index_blocks(blocks: Iterable[Block]) -> list[Block]:
    """The entries of what these blocks hold, in columns down the page."""
    indexed = {name for block in blocks if block.indexed for name in block.indexed.split(BETWEEN)}
    names = sorted((name for name in indexed if not name.startswith(SIGN)), key=lambda name: (name.casefold(), name))
    pages = []
    for start in range(0, len(names), COLUMNS * ROWS):
        some = names[start : start + COLUMNS * ROWS]
        pages.append(_page(some, -(-len(some) // COLUMNS)))
    return pages


def _page(names: list[str], rows: int) -> Block:
    def draw(pen: Pen, y: float) -> None:
        for n, name in enumerate(names):
            with pen.tagged(Tag("P")):
                entry(pen, y, n, name)

    def entry(pen: Pen, y: float, n: int, name: str) -> None:
        x, base = n // rows * (EACH + GUTTER), y - (n % rows + 0.78) * NOTE.leading
        page_numbers = pen.places.get(name, [])
        pages = ", ".join(map(str, page_numbers[:MOST])) + (" …" if len(page_numbers) > MOST else "")
        number = one_line(pages, NOTE, NUMBERS)
        pen.put(one_line(name, NOTE, EACH - NUMBERS - 4.0), x, base)
        pen.put(number, x + EACH - number.width, base)
        if page_numbers:
            pen.link(x, base - 2.0, EACH, NOTE.leading, f"page-{page_numbers[0]}", name)

    return Block(rows * NOTE.leading, draw)


# --- the register of the publications that a report stands on
# Title, edition, status, how we know them; and what no publication says.

# what the name of a standard begins with
STANDARD = re.compile(r"(?:ISO|DIN|AGMA|VDI|FKM|SAE|MIL|FVA|ASTM|API|BS|EN|IACS|JIS|UNI|Directive)\b")
NAME, STATUS, KNOWN = 74.0, 78.0, 72.0  # widths beside the title
REMEMBERED = " *"  # behind what we have from memory


@dataclass(slots=True)
class _Reference:
    """A publication of the list: its clauses, the steps that use it, how we know what is used; each in the order in
    which it comes."""

    publication: Publication
    clauses: dict[str, None] = field(default_factory=dict)
    users: dict[str, None] = field(default_factory=dict)
    known: dict[Text, None] = field(default_factory=dict)


def source_blocks(context: Context) -> list[Block]:
    """The publications behind all that was calculated; in the audit with their clauses, and the rules that no
    publication says."""
    w = context.words
    published: dict[str, _Reference] = {}
    rules: dict[str, None] = {}
    for source, steps in context.sources.items():
        if not context.audit and source not in context.cited:
            continue
        stands, text, citations = source in context.cited, context.say(source), resolved(source).citations
        for n, citation in enumerate(citations):
            of_it = published.setdefault(citation.name, _Reference(citation.publication))
            clause = text.removeprefix(citation.name).lstrip(" ,:;") if text.startswith(citation.name) else text
            of_it.clauses |= {clause: None} if clause and stands and n == 0 else {}
            of_it.users |= dict.fromkeys(steps)
            of_it.known |= {citation.known: None}
        if stands and not citations:
            rules.setdefault(text)
    ordered = dict(sorted(published.items(), key=lambda item: (item[0].casefold(), item[0])))
    if not ordered and not (context.audit and rules):
        return []
    blocks = paragraph(w["sources_note"] if context.audit else w["sources_rest"], NOTE, gap=1.0) + _register(
        context, ordered
    )
    if not context.audit:
        return blocks
    for name, of_it in ordered.items():
        if of_it.clauses:
            blocks += heading(f"{name} ({', '.join(of_it.users)})", GROUP, gap=5.0, after=0.0)
            blocks += [block for clause in _together(of_it.clauses) for block in bullet(clause, NOTE, gap=0.5)]
    if rules:
        blocks += heading(w["own"], SECTION, gap=9.0, after=0.0)
        blocks += [block for clause in _together(rules) for block in bullet(clause, NOTE, gap=0.5)]
    return blocks


def _register(context: Context, published: dict[str, _Reference]) -> list[Block]:
    """Standards, then other publications: what each is, its edition, whether it is current, and how we know what it
    says."""
    w = context.words
    rows: list[Row] = []
    for standard, title in ((True, w["standards"]), (False, w["literature"])):
        some = [(name, of_it) for name, of_it in published.items() if bool(STANDARD.match(name)) is standard]
        rows += [Group(title)] if some else []
        rows += [_source_row(context, name, of_it) for name, of_it in some]
    widths = (NAME, None, STATUS, KNOWN)
    heads = ("source", "title", "status", "how_known")
    columns = [Column(w[key], width=width, style=NOTE) for key, width in zip(heads, widths)]
    return noted_below(table(columns, rows), w["remembered"]) if rows else []


def _source_row(context: Context, name: str, of_it: _Reference) -> tuple[Cell, ...]:
    publication = of_it.publication
    title = (
        f"{context.say(Text(publication.title))}{REMEMBERED * publication.title_from_memory} "
        f"({context.say(Text(publication.edition))})"
    )
    status = context.say(replace(publication, status_from_memory=False).status_text)
    status += REMEMBERED * publication.status_from_memory
    return Cell(name), Cell(title), Cell(status), Cell(", ".join(map(context.say, of_it.known)))


def _together(clauses: dict[str, None]) -> list[str]:
    """One line for all clauses that begin alike, in their order."""
    by_head: dict[str, list[str]] = {}
    for clause in clauses:
        head, mark, rest = clause.partition(": ")
        by_head.setdefault(head, []).extend([rest] if mark else [])
    return [f"{head}: {' · '.join(rests)}" if rests else head for head, rests in by_head.items()]
