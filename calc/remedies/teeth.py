# SPDX-License-Identifier: Apache-2.0
"""Teeth that are undercut, pointed, that touch the fillet of their mate or hand over too late: another shift, or another tip cut.

The rules are those of the search for shifts (`choose`).  That search looks for the least sliding; here every shift and every cut is looked
at alone, and the nearest to the design that keeps the rules is taken.  Where there is none, the rows of that search.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from ..gears.choosing.freedom import Freedom, freedoms, settled
from ..gears.choosing.optimum import ROUND, Case, ends, evaluated
from ..gears.choosing.rules import USUAL, Bar, eased, judged, least
from ..gears.choosing.search import Row, search
from ..gears.choosing.states import States, states
from ..gears.choosing.tables import changes
from ..gears.inputs import GearsInputs
from ..gears.train import tooth_system
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, part, tell
from .state import State, first_good

KINDS = (
    "contact_ratio", "contact_ratio_least", "interference", "interference_least", "tip_clearance_least", "undercut", "tip_thickness",
)  # fmt: skip
TRIED = 6  # designs, solved whole
CUT = 1e-5  # m: step of the tip cuts
DEEPEST = 1.0  # modules off a tip
MARGIN = 1e-6  # by which a rule is kept, so that the same number judged elsewhere keeps it too


def about(check: Check) -> bool:
    return check.id.rpartition(".")[2] in KINDS


def mend(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Raises NoSolution where neither passes."""
    gears = state.design.gears
    assert gears is not None
    ids = [c.id for c in failing]
    tell(progress, 0.0, "profile shifts and tip cuts")
    try:
        return first_good(state, "gears", ids, _nearest(gears)[:TRIED], part(progress, 0.1, 0.4))
    except NoSolution:
        found = search(gears, part(progress, 0.4, 0.8))
    rows = sorted((row for row in found.all if row.passes), key=lambda row: _change(row, gears))
    return first_good(state, "gears", ids, [changes(row) for row in rows[:TRIED]], part(progress, 0.8, 1.0))


def _nearest(gears: GearsInputs) -> list[list[str]]:
    """Of every way to leave shifts free the nearest along each, and the nearest cut of each tip; the smallest change first."""
    case = Case(tooth_system(gears), gears)
    now = settled(gears, case.system)
    there = None if now is None else states(case.system, gears, now.shifts)
    hard: Bar = tuple(replace(rule, limit=rule.hard) for rule in USUAL)  # type: ignore[assignment]
    easier = eased(there, case.system) if there is not None else None
    bars = [USUAL, *([easier] if easier is not None else []), hard]
    found: list[tuple[int, float, list[str]]] = []
    for n, bar in enumerate(bars):
        for way in freedoms(gears, case.system):
            for leader in way.free:
                if (x := _shift(case, way, leader, bar)) is not None:
                    found.append((n, abs(x - way.start[leader]), _written(way, leader, x)))
        for wheel in gears.wheels if now is not None else ():
            cuts = np.arange(round(DEEPEST * case.system.m_n / CUT) + 1) * CUT
            made = states(case.system, gears, now.shifts, {wheel.name: cuts}) if now is not None else None
            if made is not None and (k := _first(case, made, bar, cuts, wheel.tip_shortening)) is not None:
                change = abs(k - wheel.tip_shortening) / case.system.m_n
                found.append((n, change, [f"gears.wheels.{wheel.name}.tip_shortening_mm={round(k * 1e3, 6)!r}"]))
    return [words for _, _, words in sorted(found, key=lambda one: one[:2])]


def _shift(case: Case, way: Freedom, leader: str, bar: Bar) -> float | None:
    """The nearest shift of one wheel that keeps every rule, the other free ones as they are; None: there is none."""
    low, high, _, _ = ends(case, way)[leader]
    t = np.arange(np.ceil(low * ROUND - 1e-6), np.floor(high * ROUND + 1e-6) + 1) / ROUND
    if not t.size:
        return None
    made = evaluated(case, way, {**{name: way.start[name] for name in way.free}, leader: t}, {})
    return _first(case, made, bar, t, way.start[leader])


def _first(case: Case, made: States, bar: Bar, numbers: Any, start: float) -> float | None:
    kept = np.broadcast_to(least(judged(made, case.system, bar)) >= MARGIN, numbers.shape)
    return float(min(numbers[kept], key=lambda x: abs(x - start))) if kept.any() else None


def _written(way: Freedom, leader: str, x: float) -> list[str]:
    """As `choose` writes a row: shifts that would contradict it go, distances that were held are given."""
    words = [f"{key}=" for key in way.removed] + [f"gears.wheels.{leader}.profile_shift={round(x, 4)!r}"]
    return words + [f"gears.meshes.{i}.centre_distance_mm={round(a * 1e3, 4)!r}" for i, a in way.held.items()]


def _change(row: Row, gears: GearsInputs) -> float:
    """From the design: the sum of the changes of all given shifts and, in modules, of all tip cuts; rule of this program."""
    shifts = sum(abs(float(row.states.shifts[w.name][0]) - w.profile_shift) for w in gears.wheels if w.profile_shift is not None)
    cuts = {wheel.name: wheel.tip_shortening for wheel in gears.wheels}
    return shifts + sum(abs(k - cuts[name]) for name, k in row.cuts.items()) / gears.normal_module
