# SPDX-License-Identifier: Apache-2.0
"""Profile shifts, tip cuts and the teeth of an idler to choose from, every rule of the teeth kept."""

from calc.design.model import Design
from calc.gears.selection.idler import idler_table, idlers, passed, written
from calc.gears.selection.search import search
from calc.gears.selection.tables import around_table, changed, changes, choices_table, cuts_best_table, cuts_now_table, limits_table, notes, sliding_table, summary, wants_table
from calc.sheet.changes import Changes
from calc.sheet.progress import Progress, part
from calc.sheet.step import Table
from calc.sheet.text import Amount, Text
from calc.design.step_inputs import shaft_axis

from .offer import Offer

NEEDS = ("gears",)
WHY = Text("there are no gears to choose shifts for")


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.gears is not None
    axis = shaft_axis(made)
    found = search(made.gears, part(progress, 0.0, 0.9), axis)
    teeth = idlers(made.gears, axis, part(progress, 0.9, 1.0))
    shifts, others = found.all, [row for rows in teeth for row in passed(rows)]

    def keys(number: int) -> Changes:
        return changes(shifts[number - 1]) if number <= len(shifts) else others[number - 1 - len(shifts)].changes

    def said(number: int) -> Text:
        if number > len(shifts):
            return written(others[number - 1 - len(shifts)])
        row = shifts[number - 1]
        return Text(
            "now has the gears of row {row} ({change}): largest specific sliding {sliding}", row=number, change=changed(row),
            sliding=Amount(row.largest, form=".3f"),
        )  # fmt: skip

    def beside(top: int) -> tuple[Table, ...]:
        first, own = len(shifts) + 1, []
        for rows in teeth:
            own.append(idler_table(rows, first, top))
            first += len(passed(rows))
        tables = (
            *own, sliding_table(found, top), wants_table(found), around_table(found), limits_table(found), cuts_now_table(found),
            cuts_best_table(found, top),
        )  # fmt: skip
        return tuple(one for one in tables if one is not None)

    return Offer(
        count=len(shifts) + len(others),
        table=lambda top: choices_table(found, top),
        keys=keys,
        said=said,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=summary(found),
        notes=notes(found),
    )
