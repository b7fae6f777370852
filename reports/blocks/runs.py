# SPDX-License-Identifier: Apache-2.0
"""The chapter of what the bench measured over speed: of each column a figure, a table of its nodes, a verdict."""

from __future__ import annotations

from calc.design.run_results import RunResults
from calc.locale.language import in_language
from calc.measurements.rows import RunRows
from calc.sheet.record import replace
from calc.sheet.text import EMPTY, Name, Text, plural

from ..context import Context
from ..figures.figures import figure_blocks
from ..figures.plots import Plots
from ..typesetting.pagination import Block, heading, paragraph
from ..typesetting.prose import BODY, NOTE, SECTION
from .values import table_blocks

INTRO = Text(
    "Each node is the mean of the rows at one speed with equal conditions; the design is solved there with its "
    "clearances as made and the oil of the bench run. The bars are one standard uncertainty. A measurement judges the "
    "calculation: no verdict of the design depends on it."
)


def run_blocks(context: Context, runs: RunResults, plots: Plots) -> list[Block]:
    """Everything of the chapter below its title."""
    say = context.say
    blocks = paragraph(say(INTRO), BODY)
    for rows in runs.design.runs:
        columns = runs.of_run(rows.name)
        blocks += heading(rows.name, SECTION, gap=8.5, after=1.0, need=150.0)
        blocks += paragraph(say(_file(rows)), NOTE)
        for column in columns:
            context.figures += bool(column.found.used)
            pair = [(context.figures, in_language(curve, say)) for curve in (column.curve, column.strip)]
            blocks += paragraph(say(column.sentence), BODY, gap=6.0)
            blocks += figure_blocks(pair, context.words["figure"], plots) if column.found.used else []
            blocks += table_blocks(context, [in_language(replace(column.table, note=EMPTY), say)])
    return blocks


def _file(rows: RunRows) -> Text:
    words = Text(
        "{file}, SHA-256 {sha}; {used} used, attached to this document.",
        file=Name(rows.file),
        sha=Name(rows.sha256),
        used=plural("{n} row is", "{n} rows are", n=len(rows.speed)),
    )
    if rows.lost:
        words += Text(" ") + plural(
            "{n} row without a speed above 0, or without a condition, is left out.",
            "{n} rows without a speed above 0, or without a condition, are left out.",
            n=rows.lost,
        )
    return words
