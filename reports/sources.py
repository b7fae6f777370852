# SPDX-License-Identifier: Apache-2.0
"""The register of the publications that a report stands on: title, edition, status, how we know them; and what no publication says."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace

from calc.library.publications import Publication, resolved
from calc.sheet.text import Text

from .context import Context
from .setting.flow import Block, bullet, heading, paragraph
from .setting.prose import GROUP, NOTE, SECTION
from .setting.tables import Cell, Column, Group, Row, noted_below, table

STANDARD = re.compile(r"(?:ISO|DIN|AGMA|VDI|FVA|ASTM|API|BS|EN|IACS|JIS|UNI)\b")  # what the name of a standard begins with
NAME, STATUS, KNOWN = 74.0, 78.0, 72.0  # widths beside the title
REMEMBERED = " *"  # behind what we have from memory


@dataclass(slots=True)
class _Reference:
    """A publication of the list: its clauses, the steps that use it, how we know what is used; each in the order in which it comes."""

    publication: Publication
    clauses: dict[str, None] = field(default_factory=dict)
    users: dict[str, None] = field(default_factory=dict)
    known: dict[Text, None] = field(default_factory=dict)


def source_blocks(context: Context) -> list[Block]:
    """The publications behind all that was calculated; in the audit with their clauses, and the rules that no publication says."""
    w = context.words
    published: dict[str, _Reference] = {}
    own: dict[str, None] = {}
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
            own.setdefault(text)
    ordered = dict(sorted(published.items(), key=lambda item: (item[0].casefold(), item[0])))
    if not ordered and not (context.audit and own):
        return []
    made = paragraph(w["sources_note"] if context.audit else w["sources_rest"], NOTE, gap=1.0) + _register(context, ordered)
    if not context.audit:
        return made
    for name, of_it in ordered.items():
        if of_it.clauses:
            made += heading(f"{name} ({', '.join(of_it.users)})", GROUP, gap=5.0, after=0.0)
            made += [block for clause in _together(of_it.clauses) for block in bullet(clause, NOTE, gap=0.5)]
    if own:
        made += heading(w["own"], SECTION, gap=9.0, after=0.0)
        made += [block for clause in _together(own) for block in bullet(clause, NOTE, gap=0.5)]
    return made


def _register(context: Context, published: dict[str, _Reference]) -> list[Block]:
    """Standards, then other publications: what each is, its edition, whether it is current, and how we know what it says."""
    w = context.words
    rows: list[Row] = []
    for standard, title in ((True, w["standards"]), (False, w["literature"])):
        some = [(name, of_it) for name, of_it in published.items() if bool(STANDARD.match(name)) is standard]
        rows += [Group(title)] if some else []
        rows += [_row(context, name, of_it) for name, of_it in some]
    widths = (NAME, None, STATUS, KNOWN)
    heads = ("source", "title", "status", "how_known")
    columns = [Column(w[key], width=width, style=NOTE) for key, width in zip(heads, widths)]
    return noted_below(table(columns, rows), w["remembered"]) if rows else []


def _row(context: Context, name: str, of_it: _Reference) -> tuple[Cell, ...]:
    one = of_it.publication
    title = f"{context.say(Text(one.title))}{REMEMBERED * one.title_from_memory} ({context.say(Text(one.edition))})"
    status = f"{context.say(replace(one, status_from_memory=False).status_text)}{REMEMBERED * one.status_from_memory}"
    return Cell(name), Cell(title), Cell(status), Cell(", ".join(map(context.say, of_it.known)))


def _together(clauses: dict[str, None]) -> list[str]:
    """One line for all clauses that begin alike, in their order."""
    found: dict[str, list[str]] = {}
    for clause in clauses:
        head, mark, rest = clause.partition(": ")
        found.setdefault(head, []).extend([rest] if mark else [])
    return [f"{head}: {' · '.join(rests)}" if rests else head for head, rests in found.items()]
