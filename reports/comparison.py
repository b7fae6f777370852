# SPDX-License-Identifier: Apache-2.0
"""The report of a comparison: what it comes to, the inputs that differ; if asked for, every verdict, check and value
that does."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path
from typing import Any

from calc.design.disk import write_file
from calc.design.model import STEPS
from calc.design.other_tables import DocumentControl
from calc.design.predicted import compared_table
from calc.design.toml_file import Document, design, parse
from calc.locale import LANGUAGES, language
from calc.locale.language import in_language
from calc.sheet.check import SIGNS
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Name, plural
from calc.solve import Results, solve
from calc.studies.compare import Comparison, compare
from calc.studies.compare_runs import compared_runs
from calc.studies.compare_tables import (
    Names,
    Sign,
    check_table,
    input_table,
    moved_table,
    result_table,
    sentences,
    value_table,
    verdict_table,
)

from .blocks.title_block import SHORT_HASH, made_with, signature_block
from .blocks.values import table_blocks
from .blocks.words import WORDS, verdict
from .context import Context
from .made import versions
from .pdf import attach
from .pdf.binding import bind
from .typesetting.boxes import GREY
from .typesetting.boxes import text as text_box
from .typesetting.fonts import FACES, WIDTH, widths
from .typesetting.pagination import Block, bullet, heading, lines_block, paginate, paragraph
from .typesetting.prose import BODY, HEADING, NOTE, TITLE, lines
from .typesetting.tags import title_tag

FOOT_HASH = 8  # letters of a sum in the foot
MOVED = 12  # verdicts that moved, in the conclusion
DEPTHS = ("summary", "audit")  # of a comparison: the conclusion and the inputs, or everything
Side = tuple[Document, Results]


def write(
    a: Side, b: Side, comparison: Comparison, names: Names, path: Path, *, lang: str = "en", everything: bool = False
) -> Path:
    """Write the report of a comparison to `path`; both design files are attached to it.  `names`: the two designs in
    the columns."""
    report = render(a, b, comparison, names, lang=lang, everything=everything)
    return write_file(path, report, inputs=[document.place for document, _ in (a, b)])


def render(
    a: Side,
    b: Side,
    comparison: Comparison,
    names: Names,
    *,
    lang: str = "en",
    everything: bool = False,
    made: dict[str, str] | None = None,
) -> bytes:
    """The report as the bytes of a PDF: the same designs give the same bytes.  `made`: as of a report.

    `everything`: after the conclusion and the inputs also the verdicts of the steps, and every check and value that
    differs."""
    for face in FACES:
        widths(face)
    (first, before), (second, after) = a, b
    context = Context(first, before, "", "engineer", language(lang), made=made or versions())
    blocks = _title(context, (a, b), names)
    if comparison.equal:
        blocks += paragraph(context.words["equal"], BODY, gap=8.0)
    else:
        blocks += _conclusion(context, comparison, names)
        measured = compared_table((before.design, before.predicted), (after.design, after.predicted), names)
        runs = compared_runs(before.runs_with(after), after.runs_with(before), names)
        tables = [in_language(table, context.say) for table in (measured, runs) if table is not None]
        blocks += table_blocks(context, tables)
        blocks += _section(context, "inputs", [replace(input_table(comparison.inputs, names, ids=False), title=EMPTY)])
        blocks += (
            _details(context, comparison, names) if everything else paragraph(_more(context, comparison), NOTE, gap=8.0)
        )
    blocks += [signature_block(context, DocumentControl(), alone=True)]  # who has signed a design has not signed this
    w, title = context.words, f"{names[0]} – {names[1]}"
    solved = attach.values_bytes(attach.pair_values(names, before, after))
    files = {name: (document.raw, w["file"]) for name, document in zip(attach.PAIR, (first, second))}
    sums = {}
    for of, side in zip("ab", (before, after)):
        for n, (name, rows) in enumerate(attach.run_files(side, of).items(), 1):
            files[name], sums[attach.run_key(n, of)] = (rows, w["run"]), hashlib.sha256(rows).hexdigest()
    provenance = dict(
        depth=DEPTHS[everything],
        lang=lang,
        sha256=first.sha256,
        other=second.sha256,
        results=hashlib.sha256(solved).hexdigest(),
    )
    return bind(
        paginate(blocks),
        files | {attach.RESULTS: (solved, w["solved"])},
        title=title,
        author="",
        revision="",
        kind="comparison",
        designs=" · ".join(_of_foot(w, name, side) for name, side in zip(names, (a, b))),
        said=provenance | sums,
        made=context.made,
        words=w,
    )


def again(inside: attach.Inside) -> tuple[bytes, dict[str, Any], list[Results]]:
    """A comparison written again, as a report is."""
    said = inside.said
    if said["depth"] not in DEPTHS or said["lang"] not in LANGUAGES:
        raise attach.refused(inside.place, attach.NO_REPORT)
    a, b = (
        attach.with_runs(inside, parse(inside.file(name), f"{inside.place}: {name}"), of)
        for name, of in zip(attach.PAIR, "ab")
    )
    before, after = solve(design(a)), solve(design(b))
    match inside.solved():
        case {"names": [str(first), str(second)]}:
            names = first, second
        case _:
            raise inside.damaged()
    pdf = render(
        (a, before),
        (b, after),
        compare(a.data, b.data, before, after),
        names,
        lang=said["lang"],
        everything=said["depth"] == DEPTHS[True],
        made=inside.made,
    )
    return pdf, attach.pair_values(names, before, after), [before, after]


def _of_foot(words: dict[str, str], name: str, side: Side) -> str:
    """A design with its revision and the sum of its file."""
    document, results = side
    revision = results.design.control.revision
    of = f"{words['revision']} {revision}" if revision else ""
    return " ".join(filter(None, (name, of, document.sha256[:FOOT_HASH])))


def _title(context: Context, sides: tuple[Side, Side], names: Names) -> list[Block]:
    w = context.words
    blocks = [lines_block([text_box(w["comparison"], BODY.size, colour=GREY)], 11.0, keep=True)]
    blocks += [lines_block(lines(f"{names[0]} – {names[1]}", TITLE, WIDTH, 3), TITLE.leading, keep=True)]
    blocks[-1] = replace(blocks[-1], anchor="summary", outline=(0, w["summary"]), tag=title_tag(TITLE.size))
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
    blocks += table_blocks(context, [Table("designs", EMPTY, columns, tuple(rows))])
    return blocks + paragraph(" ".join(filter(None, (w["attached_pair"], made_with(context)))), NOTE, gap=2.0)


def _conclusion(context: Context, comparison: Comparison, names: Names) -> list[Block]:
    """What the comparison comes to: in sentences, then what moved and the key results."""
    sign = _signs(context)
    conclusion = sentences(comparison, names, sign)
    blocks = [
        block for n, text in enumerate(conclusion) for block in bullet(context.say(text), gap=8.0 if n == 0 else 1.5)
    ]
    tables = (moved_table(comparison, names, sign, MOVED), result_table(comparison, names))
    alone = [
        block for table in tables if not table.rows and table.note for block in bullet(context.say(table.note), gap=1.5)
    ]
    return blocks + alone + table_blocks(context, [in_language(table, context.say) for table in tables if table.rows])


def _signs(context: Context) -> Sign:
    return lambda state: verdict(context.words, state)


def _section(context: Context, key: str, tables: list[Table]) -> list[Block]:
    """Tables under a heading; those without rows are left out."""
    tables = [in_language(table, context.say) for table in tables if table.rows]
    if not tables:
        return []
    title = context.words[key]
    return heading(title, HEADING, gap=18.0, after=2.0, anchor=key, outline=0, need=90.0, ruled=True) + table_blocks(
        context, tables
    )


def _more(context: Context, comparison: Comparison) -> str:
    """What is not shown."""
    checks = plural("{n} check", "{n} checks", n=len(comparison.checks))
    values = plural("{n} value", "{n} values", n=len(comparison.values))
    return context.text("more_differ", checks=checks, values=values)


def _details(context: Context, comparison: Comparison, names: Names) -> list[Block]:
    """The verdicts of the steps, and every check and value that differs."""
    sign = _signs(context)
    values = []
    for step in STEPS:
        of_step = [d for d in comparison.values if d.step == step.key and d.both]
        values.append(value_table(step.key, step.title, of_step, names, ids=False))
    blocks = _section(context, "verdicts", [replace(verdict_table(comparison, names, sign), title=EMPTY)])
    blocks += _section(
        context,
        "checks",
        [
            replace(check_table(comparison.checks_moved, names, sign, ids=False), title=WORDS["moved"]),
            replace(check_table(comparison.checks_lone, names, sign, ids=False), title=WORDS["lone"]),
            replace(check_table(comparison.checks_kept, names, sign, ids=False), title=WORDS["kept"]),
        ],
    )
    blocks += _section(context, "results", values)
    if lone := sum(not d.both for d in comparison.values) + sum(not d.both for d in comparison.checks):
        blocks += paragraph(context.text("lone_values", n=lone), NOTE, gap=6.0)
    return blocks
