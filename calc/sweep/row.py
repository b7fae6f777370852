# SPDX-License-Identifier: Apache-2.0
"""One design of many, and many of them together as they are kept."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from math import isfinite

from ..sheet.errors import InputError
from ..sheet.record import record
from .plan import Combination

Cell = float | str | None


@record
class Solved:
    """`values`: number and unit by id; `verdicts` by step; `reason`: why it is no design, or which steps have no solution."""

    values: dict[str, tuple[float | None, str]]
    verdicts: dict[str, str]
    reason: str = ""


@record
class Row:
    """A design as it stands in the table, under the ids and steps of its chunk."""

    at: Combination
    cells: tuple[float | None, ...]
    verdicts: tuple[str | None, ...]
    reason: str = ""


@record
class Chunk:
    """Designs that are computed at once.  `units`: of the values by id; `steps`: those that have verdicts."""

    units: dict[str, str]
    steps: tuple[str, ...]
    rows: tuple[Row, ...]


def chunk_of(grid: Sequence[Combination], solved: Iterable[Solved], wanted: Sequence[str]) -> Chunk:
    """Rows of all designs under the values that any of them has, or under those that are wanted."""
    found = list(solved)
    units: dict[str, str] = {}
    steps: dict[str, None] = {}
    for one in found:
        for id, (_, unit) in one.values.items():
            units.setdefault(id, unit)
        steps |= dict.fromkeys(one.verdicts)
    if wanted:
        units = {id: units[id] for id in wanted if id in units}
    rows = (
        Row(
            at,
            tuple([_finite(one.values[id][0]) if id in one.values else None for id in units]),
            tuple([one.verdicts.get(step) for step in steps]),
            one.reason,
        )
        for at, one in zip(grid, found)
    )
    return Chunk(units, tuple(steps), tuple(rows))


def _finite(number: float | None) -> float | None:
    return number if number is not None and isfinite(number) else None


def reason_of(errors: Iterable[InputError]) -> str:
    """All that is wrong with a combination, in one line."""
    return "; ".join(replace(error, line=0).text("").removeprefix(": ") for error in errors)
