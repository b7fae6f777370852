# SPDX-License-Identifier: Apache-2.0
"""Bearings to choose from: lengths, clearances, oils and supplies that fit the shaft and keep every rule at the worst corner."""

from calc.bearings.selection.convergence import changes, confirmed
from calc.bearings.selection.notes import hidden, notes, summary
from calc.bearings.selection.search import search
from calc.bearings.selection.tables import beyond_table, changed, choices_table, neighbours_table, pareto_table
from calc.bearings.selection.variants import SUPPLY
from calc.design.model import Design
from calc.studies.bearings_case import bearings_case
from calc.sheet.changes import Changes
from calc.sheet.errors import NoSolution
from calc.sheet.progress import Progress
from calc.sheet.step import Table
from calc.sheet.text import Amount, Text

from .offer import Offer

NEEDS = ("bearings",)
WHY = Text("there is nothing to choose a bearing for")


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.bearings is not None
    own = made.bearings
    case = bearings_case(made)
    found = search(case, progress=progress)

    def taken(number: int) -> Changes:
        """Rows that were not solved as whole designs are so now."""
        row = found.all[number - 1]
        if number > found.verified:
            settled = confirmed(case, row, found.slopes[0])
            if settled.row is None:
                raise NoSolution(Text("row {row} does not pass", row=number), settled.why, Text("take another row"))
        return changes(row, own)

    def written(number: int) -> Text:
        row = found.all[number - 1]
        words = Text(
            "now has the bearings of row {row} ({change}; {oil}, {supply}): {power}", row=number, oil=row.variant.oil,
            change=changed(row) or Text("lengths and clearances as they were"), supply=SUPPLY[row.variant.supply],
            power=Amount(row.power, "W"),
        )  # fmt: skip
        return Text("{row}; its journals are too long for their room", row=words) if any(row.too_long) else words

    def beside(top: int) -> tuple[Table, ...]:
        too_long = beyond_table(found, top)
        return (*((too_long,) if too_long else ()), neighbours_table(found), pareto_table(found))

    return Offer(
        count=len(found.all),
        table=lambda top: choices_table(found, top),
        keys=taken,
        said=written,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=summary(found),
        notes=notes(found),
        hidden=lambda top: hidden(found, top),
    )
