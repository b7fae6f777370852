# SPDX-License-Identifier: Apache-2.0
"""The head of a report: the page that decides, then the sketch, how every step came out, and what is open."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from calc.draw.drawing import Arc, Point, Polyline, Primitive, Words, moved
from calc.sheet.check import THIN_MARGIN
from calc.sheet.text import Amount
from calc.sheet.verdict import closest, findings_of, open_findings
from calc.studies.assumptions import assumptions
from calc.studies.described import described
from calc.studies.drawings import shafts, train

from ..context import Context
from ..typesetting.boxes import BLACK, GREY, Colour
from ..typesetting.fonts import LEFT, PAGE, WIDTH
from ..typesetting.pagination import Block, Picture, bullet, composed, heading, paragraph
from ..typesetting.prose import CELL, NOTE, SECTION, one_line
from ..typesetting.tables import Cell, Column, Row, table
from ..typesetting.tags import FIGURE, Tag
from .checks import attention_blocks, name_of, shown_value, sign_cell, wrong_here
from .page_one import Mended, page_one
from .title_block import change_blocks, file_notes

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

    return [
        Block(
            scale * high + words + 4.0,
            draw,
            gap=8.0,
            content=Picture(),
            tag=Tag(FIGURE, alt=f"{names[0]}: {', '.join(names[1:])}"),
        )
    ]


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


def summary_blocks(context: Context, repair: Mended | None) -> list[Block]:
    """The head of every report: the page that decides, and behind it how every step came out.  A summary has of the
    latter what its pages have room for."""
    blocks = page_one(context, repair)
    parts = (_object(context) + sketch_blocks(context), _step_blocks(context), change_blocks(context))
    if context.depth != "summary":
        title = heading(context.words["design"], SECTION, gap=9.0, after=0.0, need=0.3 * PAGE[1])
        return (
            blocks
            + title
            + parts[0]
            + file_notes(context)
            + parts[1]
            + _findings(context)
            + _assumptions(context)
            + parts[2]
        )
    pages = max(len(composed(blocks)), min(2, len(context.shafts)))
    for part in (file_notes(context), *parts, _errata(context)):
        blocks += part if len(composed(blocks + part)) <= pages else []
    return blocks + _proposals(context, blocks, pages)


def _step_blocks(context: Context) -> list[Block]:
    blocks = heading(context.words["steps"], SECTION, gap=9.0, after=0.0) + _steps(context)
    return blocks + paragraph(context.text("kinds", margin=Amount(THIN_MARGIN * 100, "%")), CELL, gap=2.0)


def _findings(context: Context) -> list[Block]:
    checks = list(context.results.checks())
    attention = attention_blocks(context, checks)
    findings = findings_of(open_findings(checks))
    title = context.text("counted_attention", findings=findings)
    return heading(title, SECTION, gap=9.0, after=0.0) + attention if attention else []


def _assumptions(context: Context) -> list[Block]:
    """What stands for what is not given, numbered, and what it puts at risk."""
    w = context.words
    rows: list[Row] = [
        (one.name, context.say(one.words), str(len(one.checks)), context.say(one.risk))
        for one in assumptions((context.original or context.results).checks())
    ]
    columns = (Column(w["no"]), Column(w["assumed"]), Column(w["checks"], "r"), Column(w["at_worst"]))
    title = heading(w["assumptions"], SECTION, gap=9.0, after=0.0)
    return title + table(columns, rows, gap=2.0) if rows else []


def _errata(context: Context) -> list[Block]:
    errata = len(wrong_here(context, (e for outcome in context.results.outcomes.values() for e in outcome.errata)))
    return paragraph(context.text("errata_count", n=errata), CELL, gap=6.0) if errata else []


def _object(context: Context) -> list[Block]:
    """What is judged, and at which load."""
    rows: list[Row] = [(context.say(title), context.say(words)) for title, words in described(context.design)]
    return table((Column(width=78.0), Column()), rows, gap=7.0, header=False) if rows else []


def _proposals(context: Context, above: list[Block], pages: int) -> list[Block]:
    """The proposed remedies of all steps, as many as there is room for on so many pages."""
    w = context.words
    proposals = [proposal for _, _, outcome in context.steps() for proposal in outcome.proposals]
    for count in range(len(proposals), 0, -1):
        blocks = heading(w["proposals"], SECTION, gap=9.0, after=0.0)
        blocks += [block for proposal in proposals[:count] for block in bullet(proposal, CELL)]
        if count < len(proposals):
            blocks += paragraph(context.text("more_proposals", count=len(proposals) - count), CELL, gap=1.0)
        if len(composed(above + blocks)) <= pages:
            return blocks
    return []


def _steps(context: Context) -> list[Block]:
    """One row a step: its verdict and the limit or caution that is closest, or passed over furthest."""
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
            rows.append((title, sign, Cell(words, CELL), "", "", ""))
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
