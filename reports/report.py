# SPDX-License-Identifier: Apache-2.0
"""The calculation report: one design, solved, as an A4 document that can be signed.

The same design file and program give the same bytes: no date of printing, no path, no order but that of the design."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from calc.design.disk import write_file
from calc.design.toml_file import Document, design, parse, read
from calc.locale import LANGUAGES, language
from calc.locale.language import said
from calc.sheet.progress import Progress, part, tell
from calc.sheet.step import OF_SHAFTS, Outcome, Step
from calc.solve import Results, solve
from calc.studies.drive.front import picked

from .blocks.chapter import Parts, chapter_parts, derivation, of_all, of_one, twin_blocks, verdict_words
from .blocks.checks import check_blocks, errata_blocks
from .blocks.contents import ContentsEntry, contents_blocks, index_blocks, source_blocks
from .blocks.drawing import balancing_blocks, drawing_blocks, wheel_blocks
from .blocks.drive import drive_blocks, front_figure
from .blocks.inputs import input_blocks, material_blocks
from .blocks.nomenclature import nomenclature_blocks
from .blocks.page_one import mended
from .blocks.summary import step_anchor, summary_blocks
from .blocks.title_block import NOTE_LINES
from .blocks.values import table_blocks, value_blocks
from .blocks.words import verdict
from .context import DEPTHS, Context, logo, stands
from .figures.figures import figure_blocks
from .figures.plots import Plots
from .figures.sketches import sketch_figure
from .pdf import attach
from .pdf.binding import bind
from .typesetting.fonts import FACES, PAGE, WIDTH, widths
from .typesetting.pagination import Block, Heading, bullet, composed, heading, paragraph
from .typesetting.prose import BODY, HEADING, SECTION, SHAFT, lines

# --- the report

# What the contents name of a step; their row holds no more, and the errata stand in the summary as well.
LISTED = ("inputs", "notes", "formulas", "results", "tables", "checks", "figures")
CHAPTERS = ("verdicts_of", "proofs", "kept_checks", "key_values", "figures", "inputs")
NEED = 0.15 * PAGE[1]  # a step begins on a new page unless so much is left

# How far the report is when its steps are solved whole, and when all that it holds is there and only the pages are to
# be written
WHOLE, MADE, WRITTEN = 0.06, 0.55, 0.98


def write(
    document: Document,
    results: Results,
    raw: bytes,
    path: Path,
    *,
    depth: str = "engineer",
    lang: str = "en",
    front: bytes | None = None,
    progress: Progress | None = None,
) -> Path:
    """Write the report of a solved design to `path`; `raw`, the bytes of its file, is attached to it.

    `depth`: "summary" is the first page, "engineer" the calculation, "audit" every traced line.  Raises ValueError for
    a depth or a language that there is not.  `progress` is told every section and every page; what it raises ends the
    writing, and no file is left."""
    report = render(document, results, raw, depth=depth, lang=lang, front=front, progress=progress)
    path = write_file(path, report, inputs=inputs_of(document, results))
    tell(progress, 1.0, path.name)
    return path


def write_report(file: Path | str, path: Path | str, *, depth: str = "engineer", lang: str = "en") -> Path:
    """Solve the design in a file and write its report as a PDF to `path`, as `contralbero report` does; gives its path.

    `depth`: "summary" is the first page, "engineer" the calculation, "audit" every traced line.  `lang`: "en" or "it".
    BadInput with all that is wrong in the file; ValueError for a depth or a language that there is not."""
    document = read(file)
    return write(document, solve(design(document)), document.raw, Path(path), depth=depth, lang=lang)


def inputs_of(document: Document, results: Results) -> list[Path]:
    """The files that a report is made of: the design, and what lies beside it."""
    design = Path(document.place)
    return [design, *(design.with_name(str(name)) for name in (results.design.control.logo, attach.FRONT) if name)]


def render(
    document: Document,
    results: Results,
    raw: bytes,
    *,
    depth: str = "engineer",
    lang: str = "en",
    logo_file: bytes | None = None,
    front: bytes | None = None,
    made: dict[str, str] | None = None,
    progress: Progress | None = None,
) -> bytes:
    """The report as the bytes of a PDF.  `logo_file`: of the design's logo; without it, it is read beside the design.

    `front`: the front of drives that the design is one of, which is then attached too.  `made`: the versions that it
    says it was made with; without it those of here."""
    tell(progress, 0.0, results.design.name)
    context = context_of(document, results, raw, depth=depth, lang=lang, logo_file=logo_file)
    context.made = made or context.made
    context.drive = picked(front, document.data) if front is not None else None
    context.runs = results.runs
    if results.design.fits and context.audit:  # some seconds each, which no shorter report takes
        from calc.studies.fits import fits_of

        context.fits = fits_of(document, results)
    control, picture = context.design.control, context.logo
    tell(progress, WHOLE, context.design.name)
    pages = composed(blocks(context, part(progress, WHOLE, MADE)))
    solved = attach.values_bytes(attach.solved_values(results))
    said_of = dict(depth=depth, lang=lang, sha256=context.sha256, results=hashlib.sha256(solved).hexdigest())
    files = {attach.NAME: (raw, context.words["file"]), attach.RESULTS: (solved, context.words["solved"])}
    for n, (name, rows) in enumerate(attach.run_files(results).items(), 1):
        said_of[attach.run_key(n)] = hashlib.sha256(rows).hexdigest()
        files[name] = (rows, context.words["run"])
    if front is not None and context.drive is not None:
        said_of["front"] = hashlib.sha256(front).hexdigest()
        files[attach.FRONT] = (front, context.words["front"])
    if picture is not None:
        said_of["logo"] = hashlib.sha256(picture.raw).hexdigest()
        files[picture.name] = (picture.raw, context.words["logo"])
    return bind(
        pages,
        files,
        title=context.design.name,
        author=control.signatures()[0][1].name,
        revision=control.revision,
        number=control.number,
        said=said_of,
        made=context.made,
        words=context.words,
        progress=part(progress, MADE, WRITTEN),
    )


def again(inside: attach.Inside) -> tuple[bytes, dict[str, Any], list[Results]]:
    """A report written again from what is inside one, with the values and verdicts that it then has, and the results
    they are of.  Raises BadInput for a design that this version does not accept."""
    said = inside.said
    if said["depth"] not in DEPTHS or said["lang"] not in LANGUAGES:
        raise attach.refused(inside.place, attach.NO_REPORT)
    document = attach.with_runs(inside, parse(inside.file(attach.NAME), f"{inside.place}: {attach.NAME}"))
    results = solve(design(document))
    logo_name = results.design.control.logo
    pdf = render(
        document,
        results,
        document.raw,
        depth=said["depth"],
        lang=said["lang"],
        logo_file=inside.file(logo_name) if logo_name else None,
        front=inside.file(attach.FRONT) if "front" in said else None,
        made=inside.made,
    )
    return pdf, attach.solved_values(results), [results]


def context_of(
    document: Document, results: Results, raw: bytes, *, depth: str, lang: str, logo_file: bytes | None = None
) -> Context:
    """What every part of a report is made from, in its language.  Raises ValueError for a depth or a language that
    there is not."""
    if depth not in DEPTHS:
        raise ValueError(f"depth {depth!r}: must be one of {', '.join(DEPTHS)}")
    if lang not in LANGUAGES:
        raise ValueError(f"lang {lang!r}: must be one of {', '.join(LANGUAGES)}")
    picture = logo(document, results.design.control.logo, logo_file)
    for face in FACES:
        widths(face)
    say = language(lang)
    whole = results.whole() if depth == "audit" else results
    spoken = replace(whole, outcomes={key: said(outcome, say) for key, outcome in whole.outcomes.items()})
    return Context(document, spoken, hashlib.sha256(raw).hexdigest(), depth, say, whole, picture)


def blocks(context: Context, progress: Progress | None = None) -> list[Block]:
    """Everything that the report holds, in its order."""
    if context.depth == "summary":
        return summary_blocks(context, mended(context))
    entries: list[ContentsEntry] = []
    body: list[Block] = []
    plots = Plots(context.say)
    steps = [numbered for numbered in context.steps() if context.audit or numbered[2].state != "not_asked"]
    if context.drive is not None:
        front = front_figure(context, context.drive, plots)
    summary = summary_blocks(context, mended(context))
    for n, (number, step, outcome) in enumerate(steps):
        done = part(progress, n / len(steps), (n + 1) / len(steps))
        body += _step(context, number, step, outcome, entries, plots, done)
    w = context.words
    number = 1 + max((number for number, _, _ in steps), default=0)
    if context.drive is not None:
        body += _section(f"{number}  {w['drive']}", "drive", entries, need=120.0)
        body += drive_blocks(context, context.drive, front)
        number += 1
    if context.runs is not None:
        from .blocks.runs import run_blocks  # which a design without runs does not load

        body += _section(f"{number}  {w['measured']}", "measured", entries, need=200.0)
        body += run_blocks(context, context.runs, plots)
        if context.design.fits:
            from .blocks.fits import fit_blocks

            body += fit_blocks(context, context.design, context.fits)
        number += 1
    if materials := material_blocks(context) + wheel_blocks(context):
        body += _section(f"{number}  {w['materials']}", "materials", entries, need=120.0)
        body += materials
        number += 1
    if not context.audit and (
        wrong := errata_blocks(context, [e for _, _, outcome in steps for e in outcome.errata], short=True)
    ):
        body += _section(f"{number}  {w['errata']}", "errata", entries, need=120.0)
        body += wrong
        number += 1
    if len(lines(context.design.note, BODY, WIDTH)) > NOTE_LINES:
        body += _section(f"{number}  {w['design_note']}", "note", entries, need=120.0)
        body += paragraph(context.design.note, BODY)
        number += 1
    if sources := source_blocks(context):
        body += _section(f"{number}  {w['sources']}", "sources", entries, need=120.0)
        body += sources
        number += 1
    context.chapter = ""
    if symbols := nomenclature_blocks(context):
        body += _section(f"{number}  {w['nomenclature']}", "nomenclature", entries, need=70.0)
        body += symbols
        number += 1
    for anchor, drawn in (("drawing", drawing_blocks(context)), ("balancing", balancing_blocks(context))):
        if drawn:
            title = f"{number}  {w[anchor]}"
            entries.append(ContentsEntry(title, anchor, {}))
            body.append(Block(0.0, lambda pen, y: None, content=Heading(title, 1)))  # which the sheet has no room for
            body += [replace(drawn[0], anchor=anchor, outline=(0, title)), *drawn[1:]]
            number += 1
    if context.audit and (index := index_blocks(body)):
        body += _section(f"{number}  {w['index']}", "index", entries, need=0.9 * PAGE[1])
        body += index
    return (
        summary + contents_blocks(context, entries, [w[key] for key in (LISTED if context.audit else CHAPTERS)]) + body
    )


def _section(title: str, anchor: str, entries: list[ContentsEntry], *, need: float) -> list[Block]:
    entries.append(ContentsEntry(title, anchor, {}))
    return heading(title, HEADING, gap=18.0, after=3.0, anchor=anchor, outline=0, need=need, ruled=True)


def _step(
    context: Context,
    number: int,
    step: Step,
    outcome: Outcome[object],
    entries: list[ContentsEntry],
    plots: Plots,
    progress: Progress | None,
) -> list[Block]:
    """One step with its parts; or why there is nothing to show."""
    w = context.words
    asked = outcome.state != "not_asked"
    title, context.chapter = context.title(step), step.key
    chapter = _section(f"{number}  {title}", step_anchor(step.key), entries, need=NEED if asked else 0.0)
    reasons = {
        "not_asked": outcome.reason or context.text("not_asked_text", key=step.key),
        "blocked": context.text("blocked_text", reason=outcome.reason),
        "no_solution": context.text("no_solution_text", reason=outcome.reason),
    }
    if outcome.state in reasons:
        chapter += paragraph(f"{verdict(w, outcome.state)}: {reasons[outcome.state]}", BODY, gap=2.0)
    for source in dict.fromkeys(line.formula.source for line in outcome.lines):
        context.cite(source, step, stands=False)
    original = (context.original or context.results).outcomes[step.key]
    for source in dict.fromkeys(
        check.source for check in original.checks if check.source and (context.audit or stands(check))
    ):
        context.cite(source, step)
    for erratum in original.errata:
        context.cite(erratum.source, step)
    if not context.shafts or step.key not in OF_SHAFTS or not asked:
        return chapter + _parts(
            context, Section(str(number), title, step.key), step, outcome, entries[-1], plots, progress
        )
    if outcome.state == "solved":
        chapter += paragraph(verdict_words(context, outcome), BODY, gap=2.0, keep=True)
    for section, view, told, n, of in _sections(context, number, step, outcome):
        entries.append(ContentsEntry(f"{section.number}  {section.title}", section.anchor, {}))
        chapter += heading(entries[-1].title, SHAFT, gap=12.0, after=2.0, anchor=section.anchor, outline=1, need=90.0)
        if told is None:
            chapter += twin_blocks(context, step, outcome, section.title)
        else:
            chapter += _parts(view, section, step, told, entries[-1], plots, part(progress, n / of, (n + 1) / of))
        context.figures = max(context.figures, view.figures)
    return chapter


class Section(NamedTuple):
    """A part of the report by its number: a whole chapter, or what it says of all shafts or of one."""

    number: str
    title: str
    anchor: str
    level: int = 0  # in the outline


def _sections(
    context: Context, number: int, step: Step, outcome: Outcome[object]
) -> Iterator[tuple[Section, Context, Outcome[object] | None, int, int]]:
    """A step that each of several shafts has for itself: what is of all together, each shaft that is no twin, in view,
    and each twin (None: its original tells the rest); the place of each among so many."""
    own = [name for name, steps in context.results.of_shafts.items() if step.key in steps]
    names = ["", *(name for name in context.shafts if name in own or step.key == OF_SHAFTS[0])]
    for n, name in enumerate(names):
        title = name or context.words["together"]
        section = Section(f"{number}.{n + 1}", title, f"{step.key}-{name}", 1)
        if not name:
            yield section, context, of_all(context, step, outcome), n, len(names)
        elif name in own:
            view = context.in_view(name)
            yield section, view, of_one(context, outcome, view.results.outcomes[step.key], name), n, len(names)
        else:
            yield section, context, None, n, len(names)


def _parts(
    context: Context,
    section: Section,
    step: Step,
    outcome: Outcome[object],
    entry: ContentsEntry,
    plots: Plots,
    progress: Progress | None,
) -> list[Block]:
    """What the report says of a step, or of one shaft in it, part by part."""
    w = context.words
    blocks: list[Block] = []
    sketch = sketch_figure(context, step, outcome)
    figures = figure_blocks(context.number(outcome), context.words["figure"], plots, wide=not context.audit)
    if context.audit:
        parts = _everything(context, step, outcome, sketch + figures)
    else:
        blocks += sketch
        parts = chapter_parts(context, section.number, step, outcome, figures)
    for n, (key, make) in enumerate(parts):
        tell(progress, n / len(parts), f"{section.title}: {w[key]}")
        if made := make():
            anchor, outline = f"{section.anchor}-{key}", section.level + 1
            if made[0].floats:  # a figure says what it is, and need not stand where it is spoken of
                blocks += [replace(made[0], anchor=anchor, outline=(outline, w[key])), *made[1:]]
            else:
                blocks += heading(w[key], SECTION, gap=8.5, after=1.0, anchor=anchor, outline=outline)
                blocks += made
            if key in (LISTED if context.audit else CHAPTERS):
                entry.parts[w[key]] = anchor
    return blocks


def _everything(context: Context, step: Step, outcome: Outcome[object], figures: list[Block]) -> Parts:
    """The parts of a step's chapter in the audit report."""
    return (
        ("inputs", lambda: input_blocks(context, step)),
        ("notes", lambda: [block for note in outcome.notes for block in bullet(note)]),
        ("formulas", lambda: derivation(context, step, list(outcome.lines))),
        ("results", lambda: value_blocks(context, outcome, context.values_of(step))),
        ("proposals", lambda: [block for proposal in outcome.proposals for block in bullet(proposal)]),
        ("tables", lambda: table_blocks(context, outcome.tables)),
        ("checks", lambda: check_blocks(context, outcome.checks)),
        ("figures", lambda: figures),
        ("errata", lambda: errata_blocks(context, outcome.errata)),
    )
