# SPDX-License-Identifier: Apache-2.0
"""A design put as the question that the search for bearings answers (`bearings.selection.search`)."""

from dataclasses import replace

from ..bearings.inputs import BearingsInputs
from ..bearings.selection.variants import SelectionCase
from ..design.model import Design
from ..design.step_inputs import shaft_gear
from ..gears.result import TrainResult
from ..sheet.errors import NoSolution
from ..sheet.text import Text
from ..solve import Results, solve


def bearings_case(design: Design, results: Results | None = None) -> SelectionCase:
    """`results`: of the design, where it is solved already.  Raises NoSolution where it has no bearings."""
    if design.bearings is None:
        raise NoSolution(
            Text("there are no bearings to choose"), Text("the design has no [bearings]"), Text("give the table")
        )
    done = results if results is not None else solve(design)
    gear = shaft_gear(design, done.result(TrainResult))

    def with_bearings(bearings: BearingsInputs, *, last: bool = False) -> Results:
        return solve(
            replace(design, bearings=bearings),
            done,
            enough=(lambda outcome: outcome.key == "bearings") if last else None,
        )

    return SelectionCase(
        design.bearings,
        design.countershaft,
        design.oils,
        tuple(oil.name for oil in design.oil),
        gear.tip_diameter if gear else None,
        done,
        with_bearings,
    )
