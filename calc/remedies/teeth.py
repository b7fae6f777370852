# SPDX-License-Identifier: Apache-2.0
"""Teeth that are undercut, pointed, that touch the fillet of their mate or hand over too late: the search for shifts and tip cuts."""

from ..gears.choosing.search import Found, Row, search
from ..gears.choosing.tables import changes
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, part
from .state import State, first_good

KINDS = (
    "contact_ratio", "contact_ratio_least", "interference", "interference_least", "tip_clearance_least", "undercut", "tip_thickness",
)  # fmt: skip
TRIED = 6  # rows, solved as whole designs


def about(check: Check) -> bool:
    return check.id.rpartition(".")[2] in KINDS


def mend(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Rows that pass, the nearest to the design first.  Raises NoSolution."""
    gears = state.design.gears
    assert gears is not None
    found = search(gears, part(progress, 0.0, 0.7))
    cuts = {wheel.name: wheel.tip_shortening for wheel in gears.wheels}
    rows = sorted((row for row in found.all if row.passes), key=lambda row: _change(row, found, cuts))
    if not rows:
        raise NoSolution("no shift and no tip cut that passes is left")
    ways = [changes(row) for row in rows[:TRIED]]
    return first_good(state, "gears", [c.id for c in failing], ways, part(progress, 0.7, 1.0))


def _change(row: Row, found: Found, cuts: dict[str, float]) -> float:
    """From the design: the sum of the changes of all shifts and, in modules, of all tip cuts; rule of this program."""
    start = {name: float(x[0]) for name, x in found.now.states.shifts.items()} if found.now else dict(found.freedoms[0].start)
    shifts = sum(abs(float(x[0]) - start[name]) for name, x in row.states.shifts.items())
    return shifts + sum(abs(k - cuts[name]) for name, k in row.cuts.items()) / found.case.system.m_n
