# SPDX-License-Identifier: Apache-2.0
"""Bearings that fail: the nearest ones that fit, else journals as long as their films ask for, with the bearings further out."""

from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, part
from ..sheet.text import Text
from . import bearings
from ..studies.repair.levers import Plan, levers
from ..studies.repair.state import State
from ..studies.repair.trials import Trials
from .way import AS_GIVEN
from ..design.names import PLACES, named


def repair(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Raises NoSolution where neither helps."""
    try:
        return bearings.repair(state, failing, part(progress, 0.0, 0.5))
    except NoSolution as none:
        try:
            return longer_journals(state, failing, part(progress, 0.5, 1.0))
        except NoSolution:
            raise none from None


def longer_journals(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Journals as much longer as their films ask for, outwards where the masses leave no room.  Raises NoSolution."""
    for n, place in enumerate(PLACES):
        group = tuple(c for c in failing if c.id.startswith(f"bearings.{place}."))
        key = f"bearings.{place}.length_mm"
        if not group:
            continue
        here = part(progress, n / len(PLACES), (n + 1) / len(PLACES))
        way = Trials(state, "bearings", group, here, named(state.document, key)).best(Plan((key,), tuple(levers(state, [key]))))
        if way is None or way.quality > AS_GIVEN:
            raise NoSolution(Text("no longer journal is enough, {place}", place=PLACES[place]))
        state = state.with_changes(dict(way.made), way.results)
    return state
