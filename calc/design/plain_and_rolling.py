# SPDX-License-Identifier: Apache-2.0
"""Beside the bearings of a design others of each kind: the table and the figure that are made when somebody looks."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from ..bearings import comparison
from ..bearings.inputs import BearingsInputs
from ..bearings.plain.selection.search import best_as_supplied
from ..bearings.plain.selection.writing import with_row
from ..bearings.result import BearingsResult
from ..countershaft.rows import BearingRow
from ..sheet.errors import NoSolution, text_of
from ..sheet.step import Further, Outcome
from ..sheet.text import Name, Text
from ..sheet.units import Number
from ..sheet.value import recorded
from .model import Design
from .step_inputs import bearings_case, rated_power, rolling_places

IDLE: Number = 0.35  # of the rated speed, where nobody gives one

Steps = Mapping[str, Outcome[object]]
Solve = Callable[..., Any]


def with_comparison(design: Design, steps: Steps, results: Callable[[], Any], solve: Solve) -> dict[str, Outcome[Any]]:
    """The bearings with what stands beside them, of all shafts that are no twins; none where they are not solved.

    `results`: of the design.  `solve`: that of the program, which stands above this room."""
    outcome = steps.get("bearings")
    if outcome is None or outcome.state != "solved":
        return {}
    return {"bearings": replace(outcome, further=partial(_further, design, outcome.further, results, solve))}


def _further(
    design: Design, before: Callable[[], Further] | None, results: Callable[[], Any], solve: Solve
) -> Further:
    more = before() if before is not None else Further()
    solved = results()
    several = len(design.shafts) > 1
    for name in design.originals:
        try:
            with recorded(False):
                here = comparison.further(_case(design, solved, name), _plain(design, solved, solve, name))
        except (NoSolution, ArithmeticError, ValueError) as error:
            lost = Text("Plain and rolling are not compared for {name}: {error}.", name=Name(name), error=text_of(error))
            here = Further(notes=(lost,))
        tables = tuple(table.of_one("bearings", name) if several else table for table in here.tables)
        curves = tuple(curve.of_one(name) if several else curve for curve in here.curves)
        more = Further(more.curves + curves, more.tables + tables, more.notes + here.notes)
    return more


def _case(design: Design, solved: Any, name: str) -> comparison.Case:
    view = solved.view(name)
    outcome, friction = view.outcomes["bearings"], design.friction
    result = outcome.result
    assert isinstance(result, BearingsResult)
    places = rolling_places(design, solved, name)
    task = next(iter(places.values())).task
    ratio = abs(task.ratio) if task.ratio is not None else 1.0
    slowest = min((row.speed for row in (*task.operation, *_inputs(design).duty)), default=None)
    if slowest is None and design.mounting is not None:
        slowest = design.mounting.idle_speed
    costs = comparison.Costs()
    if friction is not None:
        costs = comparison.Costs(rated_power(design), friction.specific_fuel_consumption, friction.co2_per_fuel)
    idle = IDLE * task.speed if slowest is None else ratio * slowest
    return comparison.Case(places, result.bearings, outcome.checks, idle, slowest is None, costs)


def _inputs(design: Design) -> BearingsInputs:
    assert design.bearings is not None  # they are solved
    return design.bearings


def _plain(
    design: Design, solved: Any, solve: Solve, name: str
) -> Iterator[tuple[BearingsInputs, Mapping[str, BearingRow]]]:
    """The best journals with the oil and the supply of the design."""
    try:
        case = bearings_case(design, solve, solved, name)
        row = best_as_supplied(case)
    except NoSolution:
        return
    if row is not None:
        bearings, rows = with_row(case, row)
        yield bearings, {one.name: one for one in rows}
