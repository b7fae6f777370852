# SPDX-License-Identifier: Apache-2.0
"""Profile shifts and tip cuts to choose from: the largest specific sliding of the train made least, every rule of the teeth kept."""

from calc.design import Design
from calc.gears.selection.search import search
from calc.gears.selection.tables import (
    around_table,
    changed,
    changes,
    choices_table,
    cuts_best_table,
    cuts_now_table,
    limits_table,
    notes,
    sliding_table,
    summary,
    wants_table,
)
from calc.sheet.progress import Progress
from calc.sheet.step import Table
from calc.sheet.text import Amount, Text

from .offer import Offer

NEEDS = ("gears",)
WHY = Text("there are no gears to choose shifts for")


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.gears is not None
    found = search(made.gears, progress=progress)

    def said(number: int) -> Text:
        row = found.all[number - 1]
        return Text(
            "now has the gears of row {row} ({change}): largest specific sliding {sliding}", row=number, change=changed(row),
            sliding=Amount(row.largest, form=".3f"),
        )  # fmt: skip

    def beside(top: int) -> tuple[Table, ...]:
        tables = (
            sliding_table(found, top), wants_table(found), around_table(found), limits_table(found), cuts_now_table(found),
            cuts_best_table(found, top),
        )  # fmt: skip
        return tuple(one for one in tables if one is not None)

    return Offer(
        count=len(found.all),
        table=lambda top: choices_table(found, top),
        keys=lambda number: changes(found.all[number - 1]),
        said=said,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=summary(found),
        notes=notes(found),
    )
