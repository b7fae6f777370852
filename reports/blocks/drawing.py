# SPDX-License-Identifier: Apache-2.0
"""The drawing sheet on a page of its own, the data of the wheels, and the chapter of a drive picked from a front.

The page has the size of the drawing's paper."""

from __future__ import annotations

import math
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from calc.draw.drawing import LAYERS, Arc, Area, Dimension, Hatch, Ink, Point, Polyline, Words, hatch_lines
from calc.draw.lettering import strokes
from calc.locale.language import in_language
from calc.sheet.check import Check
from calc.sheet.step import Curve, Series, Table
from calc.sheet.text import EMPTY, Amount, Text
from calc.studies.drawings import PAPER, WorkshopSheet, sheets, wheels
from calc.studies.drive.front import UNITS, Picked
from calc.studies.drive.output import LABELS, power_of_ten, proof_of, ranges

from ..context import Context
from ..figures.figures import figure_blocks
from ..figures.plots import Plots
from ..typesetting.boxes import BLACK, text
from ..typesetting.fonts import LEFT, PLAIN
from ..typesetting.pagination import Block, Picture, bullet, heading, paragraph
from ..typesetting.prose import BODY, SECTION
from ..typesetting.tags import FIGURE, Tag
from .checks import check_blocks
from .values import table_blocks

if TYPE_CHECKING:
    from ..typesetting.pen import Pen


POINTS = 72 / 0.0254  # in a metre
MM = POINTS / 1000
PAGE = (PAPER[0] * MM, PAPER[1] * MM)
CAPITAL = 0.729  # height of a capital over the size of the letters
CHORD = 0.02 * MM  # how far the pieces of an arc may stand off it


def drawing_blocks(context: Context) -> list[Block]:
    """A page for each sheet of what the design draws."""
    drawn = sheets(context.results, context.say, context.document.data)
    return [_block(sheet) for sheet in drawn]


def _block(sheet: WorkshopSheet) -> Block:
    alt = "; ".join(mark.text for mark in sheet.marks if isinstance(mark, Words))
    return Block(0.0, lambda pen, _: _draw(pen, sheet), page=PAGE, content=Picture(), tag=Tag(FIGURE, alt=alt))


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
        case Dimension():
            for stroke in strokes(mark):
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


# --- the chapter of a drive picked from a front
# What was searched, where it stands, what each objective costs there, what binds it.

BINDING = 6  # limits with the least margins


def front_figure(context: Context, picked: Picked, plots: Plots) -> list[Block]:
    """Where the drive stands on its front, if that is one of power and mass."""
    if "power" not in picked.names or "mass" not in picked.names or len(picked.line("mass", "power")) <= 1:
        return []
    context.figures += 1
    return figure_blocks([(context.figures, _curve(picked))], context.words["figure"], plots)


def drive_blocks(context: Context, picked: Picked, figure: list[Block]) -> list[Block]:
    """Everything of the chapter below its title."""
    say = context.say
    proof = proof_of(picked.proved, picked.combinations, picked.done, picked.classes)
    intro = Text(
        "Drive {n} of {count} that were solved whole; {combinations} combinations were searched. {proof}",
        n=picked.number,
        count=len(picked.rows),
        combinations=power_of_ten(picked.combinations),
        proof=proof,
    )
    blocks = paragraph(say(intro), BODY)
    blocks += heading(say(Text("What was varied")), SECTION, gap=8.5, after=1.0)
    blocks += [block for line in ranges(picked.sizes, picked.choices) for block in bullet(say(line))]
    blocks += figure
    blocks += table_blocks(context, _said(context, [_neighbours(picked), *_costs(picked)]))
    binding = _binding(context, picked)
    if binding:
        blocks += heading(say(Text("What binds it")), SECTION, gap=8.5, after=1.0)
        blocks += check_blocks(context, binding)
    return blocks


def _said(context: Context, tables: list[Table]) -> list[Table]:
    from calc.locale.language import in_language

    return [in_language(table, context.say) for table in tables]


def _curve(picked: Picked) -> Curve:
    """The drives that no other beats in power and mass, and where this one stands."""
    line = picked.line("mass", "power")
    mass, power = (picked.mine[picked.names.index(name)] for name in ("mass", "power"))
    front = Series(Text("no drive is lighter with less power"), line[:, 0], line[:, 1])
    return Curve(
        "drive_front",
        Text("Front of power and mass; the point is this drive"),
        Text("shaft, kg"),
        Text("power at the crank, W"),
        (front,),
        point=(float(mass), float(power)),
    )


def _neighbours(picked: Picked) -> Table:
    columns = ((Text("no."), ""), *((LABELS[name], UNITS[name][0]) for name in picked.names))
    rows = [(float(n), *(float(f"{x:.6g}") for x in picked.rows[n - 1])) for n in picked.nearest()]
    note = Text("The drives nearest to number {n}, which is this one.", n=picked.number)
    return Table("drive_neighbours", Text("Around it on the front"), columns, tuple(rows), note)


def _costs(picked: Picked) -> list[Table]:
    rows: list[tuple[str | float | None, ...]] = [
        (
            Text("{gain} of {wanted}", gain=Amount(gain, UNITS[wanted][0]), wanted=LABELS[wanted]),
            Text("{loss} of {paid}", loss=Amount(loss, UNITS[paid][0]), paid=LABELS[paid]),
            Text("{slope}", slope=Amount(loss / gain, f"{UNITS[paid][0]}/{UNITS[wanted][0]}")),
        )
        for wanted, gain, paid, loss in picked.costs()
    ]
    if not rows:
        return []
    columns = ((Text("better by"), ""), (Text("costs"), ""), (Text("that is"), ""))
    note = Text(
        "From this drive to the next one along the front of each two objectives, whatever the others then are; only "
        "where it stands on it."
    )
    return [Table("drive_costs", Text("What each objective costs in another"), columns, tuple(rows), note)]


def _binding(context: Context, picked: Picked) -> list[Check]:
    """The limits of this drive with the least margins, findings that were limits of the search among them."""

    def binds(check: Check) -> bool:
        asked = any(fnmatchcase(check.id, p) for p in picked.limits) and not any(
            fnmatchcase(check.id, p) for p in picked.waived
        )
        return (check.kind == "limit" or asked) and check.verdict != "not_verified" and check.margin == check.margin

    checks = [check for check in context.results.checks() if binds(check)]
    return sorted(checks, key=lambda check: check.margin)[:BINDING]
