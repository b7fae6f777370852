# SPDX-License-Identifier: Apache-2.0
"""Bearings to choose from: lengths, clearances, oils and supplies that fit the shaft and keep every rule at the worst corner."""

from calc.bearings.choosing.said import hidden, notes, summary
from calc.bearings.choosing.search import search
from calc.bearings.choosing.settling import confirmed
from calc.bearings.choosing.tables import beyond_table, changed, changes, choices_table, neighbours_table, pareto_table
from calc.choosing import bearings_case
from calc.design import Design
from calc.sheet.errors import NoSolution
from calc.sheet.progress import Progress
from calc.sheet.step import Table

from .offer import Offer

NEEDS = ("bearings",)
WHY = "there is nothing to choose a bearing for"


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.bearings is not None
    own = made.bearings
    case = bearings_case(made)
    found = search(case, progress=progress)

    def taken(number: int) -> list[str]:
        """Rows that were not solved as whole designs are so now."""
        row = found.all[number - 1]
        if number > found.verified:
            settled = confirmed(case, row, found.slopes[0])
            if settled.row is None:
                raise NoSolution(f"row {number} does not pass", settled.why, "take another row")
        return changes(row, own)

    def written(number: int) -> str:
        row = found.all[number - 1]
        oil = f"{row.variant.oil}, {row.variant.supply}"
        words = f"now has the bearings of row {number} ({changed(row) or 'lengths and clearances as they were'}; {oil}): {row.power:.4g} W"
        return words + ("; its journals are too long for their room" if any(row.too_long) else "")

    def beside(top: int) -> tuple[Table, ...]:
        too_long = beyond_table(found, top)
        return (*((too_long,) if too_long else ()), neighbours_table(found), pareto_table(found))

    return Offer(
        count=len(found.all),
        table=lambda top: choices_table(found, top),
        changes=taken,
        said=written,
        hint="`--apply N` writes the N-th row, of every table with numbers, into the design.",
        beside=beside,
        summary=summary(found),
        notes=notes(found),
        hidden=lambda top: hidden(found, top),
    )
