# SPDX-License-Identifier: Apache-2.0
"""The first page: what was calculated, by whom, how it came out, what is open, and the nearest design that passes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from calc.design.key_results import key_results
from calc.design.names import knows
from calc.design.unusual import told, unusual
from calc.draw.drawing import Arc, Point, Polyline, Primitive, Words, moved
from calc.sheet.check import SIGNS, THIN_MARGIN
from calc.sheet.text import Amount, Text
from calc.sheet.verdict import closest, findings_of, open_findings
from calc.studies.described import described, not_counted
from calc.studies.drawings import shafts, train
from calc.studies.headlines import drive_row, governing_safeties
from calc.studies.repair.nearest import nearest

from ..context import Context
from ..typesetting.boxes import BLACK, GREY, Colour
from ..typesetting.fonts import BOLD, LEFT, WIDTH
from ..typesetting.pagination import Block, Picture, TextContent, bullet, heading, paginate, paragraph
from ..typesetting.prose import BODY, CELL, NOTE, SECTION, STRONG, Style, lines, one_line
from ..typesetting.tables import Cell, Column, Row, table
from ..typesetting.tags import FIGURE, Tag
from ..typesetting.typeset import symbol
from .checks import attention_blocks, counted, name_of, shown_value, sign_cell
from .proof import used
from .title_block import change_blocks, title_blocks
from .values import paired_table
from .words import STATE_COLOURS, STATE_PANELS

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


# --- the drive at a glance: the shaft and its train side by side in one scale, without dimensions

HIGH = 84.0  # at most, of the drawing
BETWEEN = 22.0  # of shaft and train
UNDER = 0.15  # between two shafts, of the height of the lower one
PIECES = 40  # of a whole circle
LINES: dict[str, tuple[float, Colour]] = {"OUTLINE": (0.8, BLACK), "AXIS": (0.4, GREY)}
THIN = (0.5, GREY)


def sketch_blocks(context: Context) -> list[Block]:
    """The sketch of what the design has; nothing where it draws nothing."""
    drawn = [_side_view(shaft) for shaft in shafts(context.results)]
    parts = [part for part in (_stacked(drawn), list(train(context.results))) if part]
    if not parts:
        return []
    boxes = [_box(part) for part in parts]
    wide, high = sum(right - left for left, _, right, _ in boxes), max(top - low for _, low, _, top in boxes)
    scale = min((WIDTH - BETWEEN * (len(parts) - 1)) / wide, HIGH / high)
    words = NOTE.leading if any(isinstance(primitive, Words) for part in parts for primitive in part) else 0.0

    names = [
        context.design.name,
        *(primitive.text for part in parts for primitive in part if isinstance(primitive, Words)),
    ]

    def draw(pen: Pen, y: float) -> None:
        x = 0.0
        for part, (left, low, right, top) in zip(parts, boxes):
            middle = y - scale * high / 2
            for primitive in part:
                _draw(pen, primitive, scale, x - scale * left, middle - scale * (low + top) / 2)
            x += scale * (right - left) + BETWEEN

    return [Block(scale * high + words + 4.0, draw, gap=8.0, content=Picture(), tag=Tag(FIGURE, alt="; ".join(names)))]


def _side_view(drawn: tuple[Primitive, ...]) -> list[Primitive]:
    """Of the shaft's sheet the lines that lie within the outline of its side view."""
    lines = [line for line in drawn if isinstance(line, Polyline)]
    outline = next((line for line in lines if line.layer == "OUTLINE"), None)
    if outline is None:
        return []
    reach = max(abs(y) for _, y in outline.points) * 1.4
    return [line for line in lines if all(abs(y) <= reach for _, y in line.points)]


def _stacked(drawn: list[list[Primitive]]) -> list[Primitive]:
    """Shafts one below another, each at its place along the engine."""
    stack: list[Primitive] = []
    for shaft in filter(None, drawn):
        low, top = (_box(stack)[1], _box(shaft)[3]) if stack else (0.0, 0.0)
        high = _box(shaft)[3] - _box(shaft)[1]
        stack += [moved(line, 0.0, low - top - (UNDER * high if stack else 0.0)) for line in shaft]
    return stack


def _box(part: list[Primitive]) -> tuple[float, float, float, float]:
    """Left, lower, right and upper end of what is drawn."""
    points: list[Point] = []
    for primitive in part:
        if isinstance(primitive, Polyline):
            points += primitive.points
        elif isinstance(primitive, Arc):
            (x, y), r = primitive.centre, primitive.radius
            points += [(x - r, y - r), (x + r, y + r)]
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


def _draw(pen: Pen, primitive: Primitive, scale: float, x: float, y: float) -> None:
    """One primitive with the origin of its sheet at this place."""

    def at(point: Point) -> tuple[float, float]:
        return LEFT + x + scale * point[0], y + scale * point[1]

    match primitive:
        case Polyline(layer=layer, points=points, closed=closed):
            thick, colour = LINES.get(layer, THIN)
            pen.line(
                [at(point) for point in (*points, points[0])] if closed else [at(point) for point in points],
                thick,
                colour,
            )
        case Arc(layer=layer, centre=(cx, cy), radius=r, start=start, end=end):
            thick, colour = LINES.get(layer, THIN)
            turn = [start + (end - start) * i / PIECES for i in range(PIECES + 1)]
            pen.line([at((cx + r * math.cos(t), cy + r * math.sin(t))) for t in turn], thick, colour)
        case Words(at=(wx, wy), text=words):
            box = one_line(words, NOTE, 80.0)
            left, low = at((wx, wy))
            pen.put(box, left - LEFT - box.width / 2, low - NOTE.leading)


# --- the page


def step_anchor(key: str) -> str:
    return f"step-{key}"


def summary_blocks(context: Context) -> list[Block]:
    """The head of every report: what is calculated and how it came out."""
    w, results = context.words, context.results
    blocks = title_blocks(context)
    blocks += _verdict(context)
    blocks += _object(context)
    blocks += sketch_blocks(context)
    if rows := _key_results(context):
        blocks += heading(w["key_results"], SECTION, gap=9.0, after=0.0)
        blocks += paired_table(context, "", rows)
    if (driven := drive_row(context.original or results)) is not None:
        title, words = (context.say(text) for text in driven)
        blocks += table((Column(width=100.0), Column()), [(title, words)], gap=2.0, header=False)
    blocks += heading(w["steps"], SECTION, gap=9.0, after=0.0)
    blocks += _steps(context)
    blocks += paragraph(context.text("kinds", margin=Amount(THIN_MARGIN * 100, "%")), NOTE, gap=2.0)
    if attention := attention_blocks(context, results.checks()):
        findings = findings_of(open_findings(results.checks()))
        blocks += heading(context.text("counted_attention", findings=findings), SECTION, gap=9.0, after=0.0)
        blocks += attention
    if uncounted := [context.say(text) for text in not_counted(context.design)]:
        blocks += paragraph(context.text("not_counted", what=", ".join(uncounted)), NOTE, gap=3.0)
    return blocks


def closing_blocks(context: Context, mended: Mended | None, above: list[Block]) -> list[Block]:
    """What stands below that: the nearest design that passes, the record of changes, and where no chapters follow what
    they would say."""
    results = context.results
    blocks = above + (_nearest(context, mended) if mended is not None else []) + change_blocks(context)
    if context.depth != "summary":  # the proposals stand with their steps
        return blocks
    if errata := sum(len(outcome.errata) for outcome in results.outcomes.values()):
        blocks += paragraph(context.text("errata_count", n=errata), NOTE, gap=6.0)
    return blocks + _proposals(context, blocks)


def _object(context: Context) -> list[Block]:
    """What is judged, and at which load."""
    rows: list[Row] = [(context.say(title), context.say(words)) for title, words in described(context.design)]
    return table((Column(width=78.0), Column()), rows, gap=7.0, header=False) if rows else []


def _key_results(context: Context) -> list[tuple[str | Cell, ...]]:
    """The results that a design is known by, each by its worst part; the safeties of the teeth are those of the load
    that governs, which is named beside them."""
    rows: list[tuple[str | Cell, ...]] = []
    strikes = governing_safeties(context.results)
    for value in key_results(context.values).values():
        struck = strikes.get(value.symbol)
        name = context.say(value.label if struck is None else struck.label)
        whose = " ".join(context.belongs(value.id if struck is None else struck.high.id))
        name = f"{name}, {whose}" if whose and not knows(name, whose) else name
        rows.append(
            (
                name,
                Cell(box=symbol(value.symbol, CELL.size)) if value.symbol else "",
                context.written(value.shown, "") if struck is None else context.say(struck.words),
                value.unit,
            )
        )
    return rows


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
        tuple((unmended.name, unmended.why) for unmended in repair.left[:3]),
    )


def _nearest(context: Context, nearest: Mended) -> list[Block]:
    """The nearest design that passes, with all that it changes."""
    title = "nearest_title" if nearest.state in ("pass", "warn") else "nearest_no_fail"
    blocks = heading(context.words[title], SECTION, gap=9.0, after=0.0)
    if nearest.changes:
        template = "nearest_nothing_fails" if nearest.nothing_fails else "nearest_part"
        blocks += paragraph(
            context.text(template, changes=nearest.changes, state=context.say(nearest.words)), CELL, gap=1.0
        )
    for name, why in nearest.left:
        blocks += paragraph(context.text("nearest_left", name=name, why=why), CELL, gap=1.0)
    return blocks if nearest.changes or nearest.left else []


def _proposals(context: Context, above: list[Block]) -> list[Block]:
    """The proposed remedies of all steps, as many as there is room for without a further page."""
    w = context.words
    proposals = [proposal for _, _, outcome in context.steps() for proposal in outcome.proposals]
    pages = len(paginate(above))
    for count in range(len(proposals), 0, -1):
        blocks = heading(w["proposals"], SECTION, gap=9.0, after=0.0)
        blocks += [block for proposal in proposals[:count] for block in bullet(proposal, CELL)]
        if count < len(proposals):
            blocks += paragraph(context.text("more_proposals", count=len(proposals) - count), NOTE, gap=1.0)
        if len(paginate(above + blocks)) == pages:
            return blocks
    return []


def _verdict(context: Context) -> list[Block]:
    """The overall verdict as a panel: sign, word, and the count of checks."""
    results = context.results
    state, colour = results.verdict, results.colour
    checks = list(results.checks())
    verdict_words, _, open_ones = context.say(results.words()).partition(": ")
    unused = [context.title(step) for _, step, o in context.steps() if o.state == "not_asked" and not step.optional]
    unused_words = [context.text("unused", steps=", ".join(unused))] if unused else []
    words = "; ".join(filter(None, [open_ones, counted(context, checks), *unused_words]))
    if (worst := closest(checks)) is not None:
        at = context.text(
            "governing",
            name=name_of(context, worst),
            value=shown_value(context, worst),
            limit=context.say(worst.limit_text()),
        )
        words = ". ".join([words, ", ".join(filter(None, (at, used(context, worst).words)))])
    if odd := told(unusual(context.design, checks=context.results.checks())):
        words = ". ".join([words, context.say(odd)])
    big = Style(15.0, 18.0, BOLD, STATE_COLOURS[colour])
    sign = one_line(f"{SIGNS[state]}  {verdict_words}", big, 0.4 * WIDTH)
    beside = lines(words, BODY, WIDTH - sign.width - 40.0)
    height = max(30.0, len(beside) * BODY.leading + 12.0)

    def draw(pen: Pen, y: float) -> None:
        pen.panel(0.0, y - height, WIDTH, height, STATE_PANELS.get(colour, (0.94, 0.94, 0.94)))
        pen.panel(0.0, y - height, 3.0, height, STATE_COLOURS[colour])
        pen.put(sign, 12.0, y - height / 2 - 0.36 * big.size)
        base = y - height / 2 + (len(beside) / 2 - 0.5) * BODY.leading - 0.34 * BODY.size
        for i, line in enumerate(beside):
            pen.put(line, sign.width + 28.0, base - i * BODY.leading)

    return [Block(height, draw, gap=7.0, content=TextContent(f"{SIGNS[state]} {verdict_words}. {words}", STRONG))]


def _steps(context: Context) -> list[Block]:
    """One row a step: its verdict and the limit of physics that is closest, or passed over furthest."""
    w = context.words
    rows: list[Row] = []
    for number, step, outcome in context.steps():
        if step.optional and outcome.state == "not_asked":
            continue
        title = f"{number}  {context.title(step)}"
        sign = sign_cell(context, outcome.verdict, outcome.colour)
        worst = closest(outcome.checks) if outcome.state == "solved" else None
        if worst is None:
            words = outcome.reason or "–"
            rows.append((title, sign, Cell(words, NOTE), "", "", ""))
            continue
        cells = (
            name_of(context, worst),
            shown_value(context, worst),
            context.say(worst.limit_text()),
            context.say(worst.margin_text()),
        )
        rows.append((title, sign, *cells))
    columns = (
        Column(w["step"], width=84.0),
        Column(w["verdict"], width=60.0),
        Column(w["worst"]),
        Column(w["value"], "r"),
        Column(w["limit"], "r"),
        Column(w["margin"], "r"),
    )
    return table(columns, rows, gap=2.0)
