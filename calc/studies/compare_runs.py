# SPDX-License-Identifier: Apache-2.0
"""Two designs on the same runs of the bench."""

from typing import TYPE_CHECKING

from ..measurements.words import WORDS
from ..sheet.step import Table
from ..sheet.text import Name, Text

if TYPE_CHECKING:
    from ..design.run_results import ColumnResult, RunResults  # which designs without runs do not load


def compared_runs(a: "RunResults | None", b: "RunResults | None", names: tuple[str, str]) -> Table | None:
    """What both designs come to on the same runs; None where there are none."""
    if a is None or b is None:
        return None
    rows: list[tuple[str | float | None, ...]] = []
    by_id = [{column.id: column for column in side.columns} for side in (a, b)]
    for id in dict.fromkeys([*by_id[0], *by_id[1]]):
        sides = [side.get(id) for side in by_id]
        one = next(side for side in sides if side is not None)
        row: list[str | float | None] = [Name(f"{one.target.run}: {one.target.column}"), Name(one.unit)]
        for side in sides:
            row += [None, None, None] if side is None else _side(side)
        rows.append(tuple(row))
    if not rows:
        return None
    columns = [(Text("Run"), ""), (Text("Unit"), "")]
    for name in names:
        bias, chi = Text("{name}, bias", name=Name(name)), Text("{name}, χ²/n", name=Name(name))
        columns += [(Name(name), ""), (bias, ""), (chi, "")]
    return Table("runs", Text("Runs of the bench on both"), tuple(columns), tuple(rows))


def _side(column: "ColumnResult") -> list[str | float | None]:
    return [WORDS[column.found.verdict], column.found.bias, column.found.chi2_reduced]
