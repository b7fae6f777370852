# SPDX-License-Identifier: Apache-2.0
"""Bearings that fail: the nearest ones of the search that `choose` offers."""

from dataclasses import replace

from ..bearings.selection.convergence import changes
from ..bearings.selection.search import nearest_row
from ..design.locks import locked
from ..studies.bearings_case import bearings_case
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress
from ..sheet.text import Text
from ..solve import Results
from ..studies.repair.state import State


def repair(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Lengths, clearances, oil and supply, and where these do not help surfaces, diameters and fits.  Raises NoSolution."""
    case = bearings_case(state.design, state.results)
    if locked(state.document.data, "bearings.oil"):
        case = replace(case, oils={case.bearings.oil: case.oils[case.bearings.oil]})
    settled = nearest_row(case, progress)
    written = changes(settled.row, case.bearings) if settled.row is not None else {}
    if not written:
        raise NoSolution(Text("the search for bearings finds nothing to change: it keeps every rule that it knows"))
    return state.with_changes(written, settled.results if isinstance(settled.results, Results) else None)
