# SPDX-License-Identifier: Apache-2.0
"""The report of a comparison: what changed between two designs, which verdicts moved, and how far the values went."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from calc.compare import Comparison
from calc.compare_tables import Names, check_table, input_table, value_table, verdict_table
from calc.design import STEPS
from calc.design_file import Document
from calc.languages import language
from calc.languages.outcome import in_language
from calc.prediction import compared_table
from calc.sheet.check import SIGNS
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Name
from calc.solve import Results

from .binding import bind, put
from .boxes import GREY
from .boxes import text as text_box
from .context import Context
from .flow import Block, bullet, heading, lines_block, paginate, paragraph
from .fonts import FACES, widths
from .paper import WIDTH
from .prose import BODY, HEADING, NOTE, TITLE, lines
from .title_block import SHORT_HASH
from .values import table_blocks
from .words import WORDS

MOST = 40  # values of a step that are shown, those that differ most first
Side = tuple[Document, Results]


def write(a: Side, b: Side, found: Comparison, names: Names, path: Path, *, lang: str = "en") -> Path:
    """Write the report of a comparison to `path`; both design files are attached to it.  `names`: the two designs in the columns."""
    return put(render(a, b, found, names, lang=lang), path)


def render(a: Side, b: Side, found: Comparison, names: Names, *, lang: str = "en") -> bytes:
    """The report as the bytes of a PDF: the same designs give the same bytes."""
    for face in FACES:
        widths(face)
    (first, before), (second, after) = a, b
    context = Context(first, before, "", "engineer", language(lang))
    made = _title(context, (a, b), names)
    made += _summary(context, found)
    if not found.equal:
        made += _tables(context, found, names)
        measured = compared_table((before.design, before.predicted), (after.design, after.predicted), names)
        made += table_blocks(context, [in_language(measured, context.say)]) if measured is not None else []
    sums = [document.sha256 for document in (first, second)]
    w = context.words
    files = {f"{letter}.toml": (document.raw, w["file"]) for letter, document in zip("ab", (first, second))}
    title, control = f"{names[0]} – {names[1]}", after.design.control
    return bind(
        paginate(made), files, title=title, author=control.signatures()[0][1].name, revision=control.revision, kind="comparison",
        said=dict(lang=lang, sha256=sums[0], other=sums[1]), words=w,
    )  # fmt: skip


def _title(context: Context, sides: tuple[Side, Side], names: Names) -> list[Block]:
    w = context.words
    made = [lines_block([text_box(w["comparison"], BODY.size, colour=GREY)], 11.0, keep=True)]
    made += [lines_block(lines(f"{names[0]} – {names[1]}", TITLE, WIDTH, 3), TITLE.leading, keep=True)]
    made[-1] = replace(made[-1], anchor="summary", outline=(0, w["summary"]))
    rows = [
        (
            name,
            r.design.name,
            r.design.control.revision or "–",
            f"{SIGNS[r.verdict]} {w[r.verdict]}",
            f"{d.sha256[:SHORT_HASH]}…",
        )
        for name, (d, r) in zip(names, sides)
    ]
    columns = ((EMPTY, ""), *((Name(w[key]), "") for key in ("design", "revision", "verdict", "file")))
    return made + table_blocks(context, [Table("designs", EMPTY, columns, tuple(rows))])


def _summary(context: Context, found: Comparison) -> list[Block]:
    """How much differs, in a few lines."""
    w, moved = context.words, found.checks_moved
    if found.equal:
        return paragraph(w["equal"], BODY, gap=8.0)
    worse = sum(d.worse for d in moved)
    sentences = [
        context.text("inputs_differ", count=len(found.inputs)), context.text("steps_move", count=len(found.steps_moved)),
        context.text("checks_move", count=len(moved), worse=worse, better=len(moved) - worse),
        context.text("values_differ", count=sum(d.both for d in found.values), lone=sum(not d.both for d in found.values)),
    ]  # fmt: skip
    return [block for n, text in enumerate(sentences) for block in bullet(text, gap=8.0 if n == 0 else 1.5)]


def _tables(context: Context, found: Comparison, names: Names) -> list[Block]:
    w, say = context.words, context.say

    def sign(verdict: str) -> str:
        return f"{SIGNS[verdict]} {w[verdict]}"

    def section(key: str, tables: list[Table]) -> list[Block]:
        tables = [in_language(table, say) for table in tables if table.rows]
        if not tables:
            return []
        return heading(w[key], HEADING, gap=18.0, after=2.0, anchor=key, outline=0, need=90.0, ruled=True) + table_blocks(context, tables)

    values = []
    for step in STEPS:
        of_step = [d for d in found.values if d.step == step.key and d.both]
        table = value_table(step.key, step.title, of_step[:MOST], names, ids=False)
        more = len(of_step) - MOST
        values.append(replace(table, note=Name(context.text("more_values", n=more))) if more > 0 else table)
    made = section("inputs", [replace(input_table(found.inputs, names, ids=False), title=EMPTY)])
    made += section("verdicts", [replace(verdict_table(found, names, sign), title=EMPTY)])
    made += section("checks", [
        replace(check_table(found.checks_moved, names, sign, ids=False), title=WORDS["moved"]),
        replace(check_table(found.checks_lone, names, sign, ids=False), title=WORDS["lone"]),
        replace(check_table(found.checks_kept, names, sign, ids=False), title=WORDS["kept"]),
    ])  # fmt: skip
    made += section("results", values)
    lone_values, lone_checks = any(not d.both for d in found.values), any(not d.both for d in found.checks)
    return made + (paragraph(w["lone_values"], NOTE, gap=6.0) if lone_values or lone_checks else [])
