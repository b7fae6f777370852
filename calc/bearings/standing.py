# SPDX-License-Identifier: Apache-2.0
"""The bearings of a shaft with what stands still while it turns: weight, gear force, pull of chains."""

from ..countershaft.result import Standing
from ..sheet.record import replace
from ..sheet.step import Outcome
from ..sheet.text import Text
from ..sheet.value import trace
from .kinds import KINDS
from .lives import life_together
from .result import BearingsResult, TwinBearings
from .support import StandingLoads
from .told import shown

ALIKE = 1e-3  # of a standing load: so much more of it makes no other film


def with_standing(outcome: Outcome[BearingsResult], stands: Standing | None) -> Outcome[BearingsResult]:
    """The same outcome with the standing part of each bearing's load."""
    if stands is None or outcome.result is None or not stands.stationary:
        return outcome
    bearings, checks, notes = {}, list(outcome.checks), list[Text]()
    axial = stands.gear_force_axial or 0.0
    with trace() as lines:
        for place, load in stands.stationary.items():
            loads = StandingLoads(load, stands.weights.get(place, 0.0), axial)
            bearings[place], checks = outcome.result.bearings[place].under(loads, checks, notes)
        every = {**outcome.result.bearings, **bearings}
        life = life_together(every.values())
    for kind in dict.fromkeys(r.row.kind for r in every.values()):
        new = {
            check.id: check
            for check in KINDS[kind].renewed({p: r for p, r in every.items() if r.row.kind == kind}, life)
        }
        checks = [*(check for check in checks if check.id not in new), *new.values()]
    before, told = outcome.result.bearings, outcome.result.told
    result, told_lines = replace(outcome.result, bearings=every, system_life=life), outcome.lines
    again = {place: every[place] for place in bearings if before[place].anew}
    if again and told is not None:
        outcome = replace(outcome, **shown(told, result, {**before, **again}))
        dropped = {n for place in again for n in range(*told.spans[place].indices(len(told_lines)))}
        told_lines = tuple(line for n, line in enumerate(told_lines) if n not in dropped)
    return replace(
        outcome,
        result=result,
        checks=tuple(checks),
        lines=(*told_lines, *lines),
        notes=outcome.notes + tuple(notes),
    )


def of_twin(
    original: Outcome[BearingsResult], stands: Standing | None, theirs: Standing | None
) -> Outcome[BearingsResult] | None:
    """The bearings of a twin with the standing part of their loads, and what is judged of that; None where nowhere more
    stands than on its original's (`theirs`), by which they are judged."""
    if stands is None or theirs is None or original.result is None:
        return None
    more = (load > theirs.stationary[place] * (1 + ALIKE) for place, load in stands.stationary.items())
    return with_standing(Outcome("bearings", result=original.result), stands) if any(more) else None


def told(twin: BearingsResult) -> TwinBearings:
    """What is not its original's."""
    parts = {place: bearing.beside_original() for place, bearing in twin.bearings.items()}
    return TwinBearings(bearings={place: part for place, part in parts.items() if part is not None})
