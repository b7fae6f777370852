# SPDX-License-Identifier: Apache-2.0
"""The contents, with links and page numbers, and the list of sources at the end."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from calc.publications import Publication, resolved
from calc.sheet.text import Text

from .boxes import FAINT, Box, text
from .context import Context
from .flow import Block, bullet, heading, paragraph
from .paper import WIDTH
from .prose import BODY, NOTE, SECTION, one_line, run
from .tables import Cell, Column, Row, table

if TYPE_CHECKING:
    from .pen import Pen

TITLE = 122.0  # width of a section's title
NUMBER = 16.0  # of a part's page number with the space before it
PARTS = WIDTH - TITLE - 6.0 - 22.0  # of all parts


@dataclass(slots=True)
class Entry:
    """A section and its parts: the title of each with the anchor that it leads to."""

    title: str
    anchor: str
    parts: dict[str, str]


def contents_blocks(context: Context, entries: list[Entry], names: list[str]) -> list[Block]:
    """One row a section: its title, its parts with their pages, its own page.  Like parts stand below each other; everything is a link.

    `names`: the parts that there may be, in their order.
    """
    made = heading(context.words["contents"], SECTION, gap=12.0, after=1.0)
    parts = {name: run(name, NOTE) for name in names if any(name in entry.parts for entry in entries)}
    share = (PARTS - sum(box.width + NUMBER for box in parts.values())) / max(len(parts), 1)
    columns: dict[str, tuple[float, Box]] = {}
    x = TITLE + 6.0
    for name, box in parts.items():
        columns[name] = x, box
        x += box.width + NUMBER + share
    rows = [_row(entry, columns) for entry in entries]
    made += [Block(b.height, b.draw, b.gap, keep=i < len(rows) - 1) for i, b in enumerate(rows)]
    return made


def _row(entry: Entry, columns: dict[str, tuple[float, Box]]) -> Block:
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

    return Block(tall, draw)


def source_blocks(context: Context) -> list[Block]:
    """The publications behind all that was calculated, with the steps that use them; clauses and rules of what stands in the report."""
    w = context.words
    published: dict[str, _Reference] = {}
    own: dict[str, list[str]] = {}
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
            own.setdefault(", ".join(steps), []).append(text)
    made = paragraph(w["sources_note"] if context.audit else w["sources_rest"], NOTE, gap=1.0)
    columns = (Column(w["source"]), Column(w["used_in"], width=110.0))
    ordered = sorted(published.items(), key=lambda item: (item[0].casefold(), item[0]))
    if not context.audit:
        return made + [block for name, of_it in ordered for block in bullet(f"{name}: {_what(context, of_it)}", NOTE)]
    rows: list[Row] = [(Cell(name, under=(_what(context, of_it), NOTE)), Cell(", ".join(of_it.users), NOTE)) for name, of_it in ordered]
    made += table(columns, rows, gap=3.0) if rows else []
    if own:
        made += heading(w["own"], SECTION, gap=9.0, after=0.0)
        columns = (Column(w["used_in"], width=110.0), Column(w["source"]))
        made += table(columns, [(steps, Cell("; ".join(sources), NOTE)) for steps, sources in own.items()], gap=2.0)
    return made


@dataclass(slots=True)
class _Reference:
    """A publication of the list: its clauses, the steps that use it, how we know what is used; each in the order in which it comes."""

    publication: Publication
    clauses: dict[str, None] = field(default_factory=dict)
    users: dict[str, None] = field(default_factory=dict)
    known: dict[Text, None] = field(default_factory=dict)


def _what(context: Context, of_it: _Reference) -> str:
    """What a publication is, its edition and status, how we know it, and its clauses; what several of them begin with stands once."""
    together: dict[str, list[str]] = {}
    for clause in of_it.clauses:
        head, mark, rest = clause.partition(": ")
        together.setdefault(head + mark, []).append(rest) if mark else together.setdefault(clause, [""])
    title = context.say(of_it.publication.described(list(of_it.known)))
    listed = "; ".join(head + "; ".join(rests) for head, rests in together.items())
    return f"{title}. {listed}" if listed and context.audit else title
