# SPDX-License-Identifier: Apache-2.0
"""Bearings to choose from: lengths, clearances, oils and supplies that keep every rule at the worst corner of the tolerances."""

from assistant.commands.choose import Offer
from calc.bearings.choosing.search import confirmed, search
from calc.bearings.choosing.tables import changed, changes, choices_table, neighbours_table, pareto_table
from calc.choosing import bearings_case
from calc.design import Design
from calc.sheet.errors import NoSolution

NEEDS = ("bearings",)
WHY = "there is nothing to choose a bearing for"


def offer(made: Design, file: str) -> Offer:
    assert made.bearings is not None
    own = made.bearings
    case = bearings_case(made)
    found = search(case)

    def taken(number: int) -> list[str]:
        """Rows that were not solved as whole designs are so now."""
        row = found.all[number - 1]
        if number > found.verified:
            settled = confirmed(case, row, found.slopes[0])
            if settled.row is None:
                raise NoSolution(f"row {number} does not pass", settled.why, "take another row")
        return changes(row, own.oil, own.supply)

    def said(number: int) -> str:
        row = found.all[number - 1]
        oil = f"{row.variant.oil}, {row.variant.supply}"
        return f"now has the bearings of row {number} ({changed(row) or 'lengths and clearances as they were'}; {oil}): {row.power:.4g} W"

    return Offer(
        count=len(found.all),
        table=lambda top: choices_table(found, top),
        changes=taken,
        said=said,
        hint="`--apply N` writes the N-th row, of the Pareto set too, into the design; `--top N` shows more.",
        beside=lambda: (neighbours_table(found), pareto_table(found)),
    )
