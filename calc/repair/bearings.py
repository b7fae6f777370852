# SPDX-License-Identifier: Apache-2.0
"""Bearings that fail: the nearest ones of the search that `choose` offers."""

from dataclasses import replace

from ..bearings.selection.convergence import changes
from ..bearings.selection.search import nearest_row
from ..locks import locked
from ..selection import bearings_case
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, part
from ..sheet.text import Text
from ..solve import Results
from .state import State


def repair(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Lengths, clearances, oil and supply, and where these do not help surfaces, diameters and fits; at the last journals that are
    longer than the masses leave room for, with the bearings further out.  Raises NoSolution."""
    case = bearings_case(state.design, state.results)
    if locked(state.document.data, "bearings.oil"):
        case = replace(case, oils={case.bearings.oil: case.oils[case.bearings.oil]})
    try:
        settled = nearest_row(case, part(progress, 0.0, 0.5))
    except NoSolution as none:
        from .trials import longer_journals

        try:
            return longer_journals(state, failing, part(progress, 0.5, 1.0))
        except NoSolution:
            raise none from None
    written = changes(settled.row, case.bearings) if settled.row is not None else {}
    if not written:
        raise NoSolution(Text("the search for bearings finds nothing to change: it keeps every rule that it knows"))
    return state.with_changes(written, settled.results if isinstance(settled.results, Results) else None)
