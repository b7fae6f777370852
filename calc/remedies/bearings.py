# SPDX-License-Identifier: Apache-2.0
"""Bearings that fail: the nearest ones of the search that `choose` offers."""

from ..bearings.choosing.nearest import nearest_row
from ..bearings.choosing.tables import changes
from ..choosing import bearings_case
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress
from .state import State


def mend(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Lengths, clearances, oil and supply, and where these do not help surfaces, diameters and fits.  Raises NoSolution."""
    case = bearings_case(state.design, state.results)
    written = changes(nearest_row(case, progress), case.bearings)
    if not written:
        raise NoSolution("the search for bearings finds nothing to change: it keeps every rule that it knows")
    return state.with_changes(written)
