# SPDX-License-Identifier: Apache-2.0
"""The drawing sheet on a page of its own, which has the size of the drawing's paper; and the data of the wheels."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from calc.draw.drawing import LAYERS, Arc, Area, Hatch, Ink, Measure, Point, Polyline, Words, hatch_lines, strokes_of
from calc.locale.language import in_language
from calc.sheet.text import EMPTY
from calc.studies.balancing import sheets as balancing_sheets
from calc.studies.drawings import WorkshopSheet, sheets, wheels

from ..context import Context
from ..figures.spoken import read_out
from ..typesetting.boxes import BLACK, text
from ..typesetting.fonts import LEFT, PLAIN
from ..typesetting.pagination import Block, Picture, heading
from ..typesetting.prose import SECTION
from ..typesetting.tags import FIGURE, Tag
from .values import table_blocks

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


POINTS = 72 / 0.0254  # in a metre
MM = POINTS / 1000
CAPITAL = 0.729  # height of a capital over the size of the letters
CHORD = 0.02 * MM  # how far the pieces of an arc may stand off it


def drawing_blocks(context: Context) -> list[Block]:
    """A page for each sheet of what the design draws."""
    drawn = sheets(context.original or context.results, context.say, context.document.data, context.sha256)
    return [sheet_block(sheet, context.words["drawing"]) for sheet in drawn]


def balancing_blocks(context: Context) -> list[Block]:
    """A page for each shaft that asks for a balancing sheet."""
    drawn = balancing_sheets(context.original or context.results, context.say, context.sha256)
    return [sheet_block(sheet, context.words["balancing"]) for sheet in drawn.values()]


def sheet_block(sheet: WorkshopSheet, title: str) -> Block:
    words = (stroke.text for mark in sheet.marks for stroke in strokes_of(mark) if isinstance(stroke, Words))
    alt = f"{title}: {'; '.join(read_out(words))}"
    page = sheet.paper.wide * MM, sheet.paper.high * MM
    return Block(0.0, lambda pen, _: _draw(pen, sheet), page=page, content=Picture(), tag=Tag(FIGURE, alt=alt))


def wheel_blocks(context: Context) -> list[Block]:
    """The data of the wheels as they stand on their drawings."""
    data = wheels(context.results)
    if data is None:
        return []
    table = replace(in_language(data, context.say), columns=data.columns)  # the names of the wheels are the user's
    return [*heading(table.title, SECTION, gap=11.0, after=0.0), *table_blocks(context, [replace(table, title=EMPTY)])]


def _draw(pen: Pen, sheet: WorkshopSheet) -> None:
    for mark in sheet.marks:
        _mark(pen, mark)


def _mark(pen: Pen, mark: Ink) -> None:
    layer = LAYERS[mark.layer]
    wide, dashes = layer.width * MM, tuple(abs(dash) * MM for dash in layer.dashes)
    match mark:
        case Polyline(points=points, closed=closed):
            pen.line(_placed((*points, points[0]) if closed else points), wide, BLACK, dashes)
        case Arc():
            pen.line(_placed(_chords(mark)), wide, BLACK, dashes)
        case Area(outlines=outlines):
            pen.shape([_placed(outline) for outline in outlines], BLACK)
        case Hatch():
            for line in hatch_lines(mark):
                pen.line(_placed(line), wide, BLACK)
        case Measure(picture=picture):
            for stroke in picture:
                _mark(pen, stroke)
        case Words():
            _words(pen, mark)


def _words(pen: Pen, words: Words) -> None:
    box = text(words.text, words.height * POINTS / CAPITAL, PLAIN)
    ((x, y),) = _placed((words.at,))
    back = {"left": 0.0, "centre": box.width / 2, "right": box.width}[words.side]
    if words.turned:
        pen.turn(box, x - LEFT, y - back)
    else:
        pen.put(box, x - LEFT - back, y)


def _placed(points: tuple[Point, ...]) -> list[tuple[float, float]]:
    return [(x * POINTS, y * POINTS) for x, y in points]


def _chords(arc: Arc) -> tuple[Point, ...]:
    (x, y), r = arc.centre, arc.radius
    step = 2 * math.acos(max(0.0, 1 - CHORD / (r * POINTS))) or 1.0
    n = max(2, math.ceil((arc.end - arc.start) / step))
    turns = [arc.start + (arc.end - arc.start) * i / n for i in range(n + 1)]
    return tuple((x + r * math.cos(turn), y + r * math.sin(turn)) for turn in turns)
