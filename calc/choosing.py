# SPDX-License-Identifier: Apache-2.0
"""A design put as the question that the search for bearings answers (`bearings.choosing.search`)."""

from dataclasses import replace

from .bearings.choosing.case import Case
from .bearings.inputs import BearingsInputs
from .design import Design
from .handing import shaft_gear
from .sheet.errors import NoSolution
from .solve import Results, solve


def bearings_case(design: Design, results: Results | None = None) -> Case:
    """`results`: of the design, where it is solved already.  Raises NoSolution where it has no bearings."""
    if design.bearings is None:
        raise NoSolution("there are no bearings to choose", "the design has no [bearings]", "give the table")
    done = results if results is not None else solve(design)
    gear = shaft_gear(design, done.outcomes["gears"].result)

    def with_bearings(bearings: BearingsInputs) -> Results:
        return solve(replace(design, bearings=bearings), done)

    return Case(
        design.bearings, design.countershaft, design.oils, tuple(oil.name for oil in design.oil), gear.tip_diameter if gear else None, done,
        with_bearings,
    )  # fmt: skip
