# SPDX-License-Identifier: Apache-2.0
"""Beside the bearings of a design others of each kind: the table and the figure that are made when somebody looks."""

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from ..bearings.inputs import BearingsInputs
from ..bearings.result import BearingsResult
from ..countershaft.rows import BearingRow
from ..friction.result import carbon_dioxide, fuel
from ..sheet.deferred import Later
from ..sheet.errors import NoSolution
from ..sheet.record import replace
from ..sheet.step import Further, Outcome
from ..sheet.units import Number
from ..sheet.value import recorded
from .model import Design
from .step_inputs import bearings_case, rated_power, rolling_places

if TYPE_CHECKING:
    from ..bearings.comparison import ComparisonCase  # loaded when somebody looks

IDLE: Number = 0.35  # of the rated speed, where nobody gives one

Steps = Mapping[str, Outcome[object]]
Solve = Callable[..., Any]


def with_comparison(design: Design, steps: Steps, results: Callable[[], Any], solve: Solve) -> dict[str, Outcome[Any]]:
    """The bearings with what stands beside them, of all shafts that are no twins; none where they are not solved.

    `results`: of the design.  `solve`: that of the program, which stands above this room."""
    outcome = steps.get("bearings")
    if outcome is None or outcome.state != "solved":
        return {}
    beside = cache(partial(_beside, design, results, solve))
    return {
        "bearings": replace(
            outcome,
            curves=outcome.curves + Later(lambda: beside().curves),
            tables=outcome.tables + Later(lambda: beside().tables),
        )
    }


def _beside(design: Design, results: Callable[[], Any], solve: Solve) -> Further:
    from ..bearings import comparison

    more, solved = Further(), results()
    several = len(design.shafts) > 1
    for name in design.originals:
        try:
            with recorded(False):
                here = comparison.further(_case(design, solved, name), _plain(design, solved, solve, name))
        except (NoSolution, ArithmeticError, ValueError):
            continue  # a shaft whose loads are not known
        tables = tuple(table.of_one("bearings", name) if several else table for table in here.tables)
        curves = tuple(curve.of_one(name) if several else curve for curve in here.curves)
        more = Further((*more.curves, *curves), more.tables + tables)
    return more


def _case(design: Design, solved: Any, name: str) -> "ComparisonCase":
    from ..bearings.comparison import ComparisonCase, Costs

    view = solved.view(name)
    outcome, friction = view.outcomes["bearings"], design.friction
    result = outcome.result
    assert isinstance(result, BearingsResult)
    places = rolling_places(design, solved, name)
    task = next(iter(places.values())).task
    ratio = abs(task.ratio) if task.ratio is not None else 1.0
    speeds = [row.speed for row in _inputs(design).duty or task.operation]
    slowest = min(speeds, default=None)
    if slowest is None and design.mounting is not None:
        slowest = design.mounting.idle_speed
    costs = Costs()
    if friction is not None and (b_e := friction.specific_fuel_consumption) is not None:
        e_CO2 = friction.co2_per_fuel
        costs = Costs(
            rated_power(design), lambda P: fuel(b_e=b_e, P=P), lambda m_B: carbon_dioxide(e_CO2=e_CO2, m_B=m_B)
        )
    idle = IDLE * task.speed if slowest is None else ratio * slowest
    shaft = view.design.countershaft
    return ComparisonCase(
        places,
        result.bearings,
        outcome.checks,
        idle,
        slowest is None,
        costs,
        shaft.seat_asked if shaft is not None else 0.0,
    )


def _inputs(design: Design) -> BearingsInputs:
    assert design.bearings is not None  # they are solved
    return design.bearings


def _plain(
    design: Design, solved: Any, solve: Solve, name: str
) -> Iterator[tuple[BearingsInputs, Mapping[str, BearingRow]]]:
    """The best journals with the oil and the supply of the design; where it has no journals, with what is usual."""
    from ..bearings.choice import plain_case
    from ..bearings.plain.selection.search import best_as_supplied
    from ..bearings.plain.selection.writing import with_row

    try:
        case = plain_case(bearings_case(design, solve, solved, name), rolling_places(design, solved, name))
        row = best_as_supplied(case)
    except NoSolution:
        return
    if row is not None:
        bearings, rows = with_row(case, row)
        yield bearings, {one.name: one for one in rows}
