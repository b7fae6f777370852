# SPDX-License-Identifier: Apache-2.0
"""The first page, on which somebody decides: what the report is for and what came out, what fails and what it takes,
the loads that govern, what is not verified and not covered; then the results that the design is known by."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from calc.design.key_results import key_results
from calc.design.names import knows
from calc.design.unusual import told, unusual
from calc.sheet.check import SIGNS, Check
from calc.sheet.text import COMMA, Small, Text
from calc.sheet.verdict import open_findings, severity
from calc.studies.described import not_counted
from calc.studies.headlines import drive_row, governing_safeties
from calc.studies.load_cases import load_cases
from calc.studies.repair.nearest import nearest

from ..context import Context
from ..typesetting.fonts import BOLD, WIDTH
from ..typesetting.pagination import Block, TextContent, composed, heading, paragraph
from ..typesetting.prose import BODY, CELL, SECTION, STRONG, Style, lines, one_line
from ..typesetting.tables import Cell, Column, Row, table
from .checks import counted, name_of, not_given, shown_value
from .title_block import title_blocks
from .values import paired_table
from .words import STATE_COLOURS, STATE_PANELS

if TYPE_CHECKING:
    from ..typesetting.pen import Pen

LABEL = 78.0  # of the column that says what a line is about
GAP = 5.0  # above a heading of this page
LEFT = 3  # of what is not mended
LONGEST = 500  # characters of purpose, of scope
MOST = 8  # failures, or what is not verified, by their causes: the others are counted


# --- the nearest design


class Mended(NamedTuple):
    """The nearest design in which no limit fails: what it changes, whether none does, the state that it then has with
    its words, and what is left, with the reason."""

    changes: Text
    nothing_fails: bool
    state: str
    words: Text
    left: tuple[tuple[Text, Text], ...]


def mended(context: Context) -> Mended | None:
    """Of a design that fails only.  Solves some twenty designs."""
    results = context.original or context.results
    if results.verdict != "fail":
        return None
    repair = nearest(context.document, results, tries=0)
    after = repair.results
    return Mended(
        repair.words,
        repair.nothing_fails,
        after.verdict,
        after.words(),
        tuple((unmended.name, unmended.why) for unmended in repair.left),
    )


# --- the page


def page_one(context: Context, repair: Mended | None) -> list[Block]:
    """All of it; in a summary as many of its key results as there is room for."""
    w = context.words
    blocks = title_blocks(context)
    blocks += _purpose(context)
    blocks += _conclusion(context, repair)
    blocks += _requirements(context)
    blocks += _reasons(context, repair)
    blocks += _headed(w["load_cases"], _load_cases(context))
    blocks += _not_verified(context)
    rows = _key_results(context)
    for count in range(len(rows), 0, -1):
        whole = _headed(w["key_results"], paired_table(context, "", rows[:count]))
        if count < len(rows):
            whole += paragraph(context.text("more_proposals", count=len(rows) - count), CELL, gap=1.0)
        if context.depth != "summary" or len(composed(blocks + whole)) == 1:
            return blocks + whole
    return blocks


def _headed(title: str, blocks: list[Block]) -> list[Block]:
    return heading(title, SECTION, gap=GAP, after=0.0) + blocks if blocks else []


def _purpose(context: Context) -> list[Block]:
    """What it is for, as its user says, or what it judges, and what it leaves out."""
    control, w = context.design.control, context.words
    engine = context.design.engine.name if context.design.engine is not None else ""
    asked = [Small(context.design.title(step.key)) for _, step, done in context.steps() if done.state != "not_asked"]
    judges = context.text("judges" if engine else "judges_alone", steps=COMMA.join(asked), engine=engine)
    rows = [(w["purpose"], control.purpose or judges), (w["scope"], control.scope)]
    given: list[Row] = [(Cell(label, STRONG), in_short(words)) for label, words in rows if words]
    return table((Column(width=LABEL), Column()), given, gap=6.0, header=False)


def in_short(words: str) -> str:
    """Words that do not push the verdict off the page; what is left out stands in the file that is attached."""
    return words if len(words) <= LONGEST else f"{words[:LONGEST].rpartition(' ')[0] or words[:LONGEST]} …"


def _requirements(context: Context) -> list[Block]:
    w = context.words
    rows: list[Row] = [(one.name, one.value, one.owner) for one in context.design.requirements]
    columns = (Column(w["requirement"]), Column(w["asked"]), Column(w["owner"]))
    return table(columns, rows, gap=6.0) if rows else []


def _reasons(context: Context, repair: Mended | None) -> list[Block]:
    """Which steps have no solution and why; the worst of each cause that fails, and the changes with which none does;
    where none fails, what warns."""
    w = context.words
    unsolved: list[Row] = [
        (Cell(context.title(step), STRONG), outcome.reason)
        for _, step, outcome in context.steps()
        if outcome.state in ("no_solution", "blocked") and outcome.reason
    ]
    blocks = table((Column(width=LABEL), Column()), unsolved, gap=4.0, header=False) if unsolved else []
    every = open_findings(list(context.results.checks()))
    verdict = "fail" if any(group[0].verdict == "fail" for group in every) else "warn"
    groups = _of_verdict(every, verdict)
    if not groups:
        return blocks
    rows: list[Row] = []
    for worst, *others in groups[:MOST]:
        name = name_of(context, worst)
        name = context.text("with_more", name=name, n=len(others)) if others else name
        takes = context.say(worst.ways_text() or worst.advice) if verdict == "warn" else ""
        cells = shown_value(context, worst), context.say(worst.limit_text()), context.say(worst.margin_text())
        rows.append((Cell(name, under=(takes, CELL)), *cells))
    columns = Column(w["check"]), Column(w["value"], "r"), Column(w["limit"], "r"), Column(w["margin"], "r")
    blocks += _headed(w["failures" if verdict == "fail" else "warnings"], table(columns, rows, gap=1.0))
    if len(groups) > MOST:
        blocks += paragraph(context.text("further", n=len(groups) - MOST), CELL, gap=1.0)
    if repair is not None:
        blocks += _what_it_takes(context, repair)
    return blocks + (_worst_warning(context, every) if verdict == "fail" else [])


def _of_verdict(every: list[tuple[Check, ...]], verdict: str) -> list[list[Check]]:
    """What has this verdict of each cause, whatever else stands under it, the worst first."""
    found = [[check for check in group if check.verdict == verdict] for group in every]
    return sorted((group for group in found if group), key=lambda group: severity(group[0]))


def _worst_warning(context: Context, every: list[tuple[Check, ...]]) -> list[Block]:
    """What warns most where something fails: the others stand with the findings."""
    groups = _of_verdict(every, "warn")
    if not groups:
        return []
    worst, w = groups[0][0], context.words
    words = context.text(
        "worst_warning",
        name=name_of(context, worst),
        value=shown_value(context, worst),
        limit=context.say(worst.limit_text()),
    )
    rows: list[Row] = [(Cell(w["warns_most"], STRONG), words)]
    return table((Column(width=LABEL), Column()), rows, gap=0.0, header=False)


def _what_it_takes(context: Context, repair: Mended) -> list[Block]:
    """The changes of the nearest design in which no limit fails, or what can be mended, and what is left."""
    words = []
    if repair.changes:
        words.append(f"{context.say(repair.changes)}.")
    words += [context.text("nearest_left", name=name, why=why) for name, why in repair.left[:LEFT]]
    if len(repair.left) > LEFT:
        words.append(context.text("more_left", n=len(repair.left) - LEFT))
    rows: list[Row] = [(Cell(context.words["it_takes"], STRONG), " ".join(words))]
    return table((Column(width=LABEL), Column()), rows, gap=2.0, header=False) if words else []


def _load_cases(context: Context) -> list[Block]:
    results = context.original or context.results
    told = [*load_cases(results), drive_row(results)]
    rows: list[Row] = [(context.say(row[0]), context.say(row[1])) for row in told if row is not None]
    return table((Column(width=LABEL), Column()), rows, gap=1.0, header=False) if rows else []


def _not_verified(context: Context) -> list[Block]:
    """What is not verified, with what to give; and what no input describes."""
    w = context.words
    every = open_findings(list(context.results.checks()))
    groups = _of_verdict(every, "not_verified")
    rows: list[Row] = [(name_of(context, group[0]), context.say(not_given(context, group))) for group in groups[:MOST]]
    columns = Column(w["not_verified_title"], width=0.45 * WIDTH), Column(w["to_give"])
    blocks = table(columns, rows, gap=GAP) if rows else []
    if len(groups) > MOST:
        blocks += paragraph(context.text("further", n=len(groups) - MOST), CELL, gap=1.0)
    if uncounted := [context.say(text) for text in not_counted(context.design)]:
        covered: list[Row] = [(Cell(w["not_covered"], STRONG), ", ".join(uncounted))]
        blocks += table((Column(width=LABEL), Column()), covered, gap=4.0, header=False)
    return blocks


def _key_results(context: Context) -> list[tuple[str | Cell, ...]]:
    """The results that a design is known by, each by its worst part; the safeties of the teeth are those of the load
    that governs, which is named beside them."""
    rows: list[tuple[str | Cell, ...]] = []
    first: list[tuple[str | Cell, ...]] = []  # the safeties that strikes govern: they stand where there is little room
    strikes = governing_safeties(context.results)
    for value in key_results(context.values).values():
        struck = strikes.get(value.symbol)
        name = context.say(value.label if struck is None else struck.label)
        whose = ", ".join(context.belongs(value.id if struck is None else struck.high.id))
        name = f"{name}, {whose}" if whose and not knows(name, whose) else name
        (rows if struck is None else first).append(
            (
                name,
                context.written(value.shown, "") if struck is None else context.say(struck.words),
                value.unit,
            )
        )
    return [*first, *rows]


# --- the verdict


def _concluded(context: Context, repair: Mended | None) -> list[str]:
    """What came out, in two sentences."""
    _, _, opened = context.say(context.results.words()).partition(": ")
    state = context.results.verdict
    first = context.text(f"concluded_{state}" if f"concluded_{state}" in context.words else "concluded", open=opened)
    if state == "not_verified":
        return [first, context.words["once_given"]]
    if repair is None:
        return [first]
    key = "mended_whole" if repair.nothing_fails else "mended_part" if repair.changes else "mended_nothing"
    left = context.say(repair.words).partition(": ")
    return [first, context.text(key, state=left[2] or left[0])]


def _conclusion(context: Context, repair: Mended | None) -> list[Block]:
    """The overall verdict as a panel: sign and word, the conclusion, and the count of checks."""
    results = context.results
    state, colour = results.verdict, results.colour
    checks = list(results.checks())
    verdict_words = context.say(results.words()).partition(": ")[0]
    unused = [context.title(step) for _, step, o in context.steps() if o.state == "not_asked" and not step.optional]
    unused_words = [context.text("unused", steps=", ".join(unused))] if unused else []
    numbers = ["; ".join([counted(context, checks), *unused_words])]
    if odd := told(unusual(context.design, checks=checks)):
        numbers.append(context.say(odd))
    said, more = " ".join(_concluded(context, repair)), ". ".join(numbers)
    big = Style(15.0, 18.0, BOLD, STATE_COLOURS[colour])
    sign = one_line(f"{SIGNS[state]}  {verdict_words}", big, 0.4 * WIDTH)
    room = WIDTH - sign.width - 40.0
    beside = [(line, BODY) for line in lines(said, Style(BODY.size, BODY.leading, BOLD), room)]
    beside += [(line, CELL) for line in lines(more, CELL, room)]
    tall = sum(style.leading for _, style in beside)
    height = max(30.0, tall + 12.0)

    def draw(pen: Pen, y: float) -> None:
        pen.panel(0.0, y - height, WIDTH, height, STATE_PANELS.get(colour, (0.94, 0.94, 0.94)))
        pen.panel(0.0, y - height, 3.0, height, STATE_COLOURS[colour])
        pen.put(sign, 12.0, y - height / 2 - 0.36 * big.size)
        base = y - (height - tall) / 2
        for line, style in beside:
            pen.put(line, sign.width + 28.0, base - 0.78 * style.leading)
            base -= style.leading

    words = f"{SIGNS[state]} {verdict_words}. {said} {more}"
    return [Block(height, draw, gap=6.0, content=TextContent(words, STRONG))]
