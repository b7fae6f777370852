# SPDX-License-Identifier: Apache-2.0
"""The nearest passing design: of one step that fails, or of the whole design, step by step in the order of solving."""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from ...countershaft.checks import ENVELOPE, ENVELOPE_LENGTH
from ...countershaft.left_over import RESIDUAL, RESIDUAL_FORCE
from ...countershaft.outline import CROSSING, MASS_SHAPE
from ...design.addresses import value_at
from ...design.model import IN_SENTENCES
from ...design.names import in_context, words, words_each
from ...design.toml_file import Document
from ...gears.checks import (
    CONTACT_RATIO,
    INTERFERENCE,
    INTERFERENCE_LEAST,
    TIP_CLEARANCE_LEAST,
    TIP_THICKNESS,
    UNDERCUT,
)
from ...gears.layout.room import CLEARANCE, DISTANCE, REACH
from ...gears.rating.checks import SAFETY_BENDING, SAFETY_CONTACT
from ...sheet.check import Check, CheckRule
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, part
from ...sheet.record import replace
from ...sheet.remedy import Changes, assignments
from ...sheet.search import Budget
from ...sheet.step import Outcome
from ...sheet.text import COMMA, SEMICOLON, Text
from ...solve import Results
from . import sizing, teeth
from .levers import settled
from .state import ORDER, RepairState, broken, first_repaired, is_mended, repaired, state_of, warned
from .trials import one_number

ROUNDS = 3  # through the steps: one may undo a little of an earlier one
TIMES = 4  # through the checks of a step
NAMED = 6  # remedies that checks name, tried as whole designs
TRIES = 100  # whole designs that the search over single numbers may solve, for all checks together

Repairer = Callable[[RepairState, tuple[Check, ...], Progress | None], RepairState]


@dataclass(frozen=True)
class NearestRemedy:
    """What repairs a step.  `changes`: KEY=VALUE, as `--set` takes them; `each`: their words; `said`: the state of the
    step then; `mends`: ids of checks that failed and do not with it (a step that had no solution: its key).  `left`:
    what still fails in the step, and why; then it is a part of a remedy only.  `breaks`: ids of limits of other steps
    that are judged worse with it.  `document` and `results`: the design with it."""

    step: str
    changes: tuple[str, ...]
    each: tuple[Text, ...]
    said: Text
    mends: tuple[str, ...]
    left: "tuple[Unmended, ...]"
    breaks: tuple[str, ...]
    document: Document
    results: Results

    @property
    def made(self) -> Changes:
        """Each key with its new value."""
        keys = [change.partition("=")[0] for change in self.changes]
        return {key: value_at(self.document.data, key) for key in keys}

    @property
    def words(self) -> Text:
        return SEMICOLON.join(self.each)


@dataclass(frozen=True)
class Unmended:
    """A check, or a step without solution (its key), for which nothing was found, and why."""

    step: str
    id: str
    name: Text
    why: Text


@dataclass(frozen=True)
class Nearest:
    """Remedies in the order in which they are to be made, each on the design with those before; what then still fails;
    the design with all of them.  `changes` and `words`: all of them together."""

    remedies: tuple[NearestRemedy, ...]
    left: tuple[Unmended, ...]
    changes: tuple[str, ...]
    words: Text
    document: Document
    results: Results

    @property
    def nothing_fails(self) -> bool:
        """Whether no limit of the whole design fails any more."""
        return not any(o.verdict in ("fail", "no_solution", "blocked") for o in self.results.outcomes.values())


RepairTable = dict[str, tuple[tuple[tuple[CheckRule, ...], Repairer], ...]]
EVERY: tuple[CheckRule, ...] = ()  # checks of the step

# For each step: checks of it, and what repairs them.  What is left goes to the search over single numbers, then to the
# last ones.
WAYS: RepairTable = {
    "countershaft": (
        ((RESIDUAL, RESIDUAL_FORCE), sizing.balance),
        ((CROSSING,), sizing.shorter_journals),
    ),
    "bearings": ((EVERY, sizing.bearings_or_longer_journals),),
    "gears": (
        (
            (CONTACT_RATIO, INTERFERENCE, INTERFERENCE_LEAST, TIP_CLEARANCE_LEAST, UNDERCUT, TIP_THICKNESS),
            teeth.better_teeth,
        ),
        ((CLEARANCE, REACH, DISTANCE), teeth.idler),
        (teeth.JAMMING, teeth.free_backlash),
        ((SAFETY_CONTACT, SAFETY_BENDING), sizing.stronger_teeth),
    ),
}
LAST: RepairTable = {
    "countershaft": (((ENVELOPE, ENVELOPE_LENGTH, CROSSING, MASS_SHAPE), sizing.resize),),
    "gears": (((CLEARANCE,), teeth.idler),),  # once what else kept its teeth from passing is repaired
}
UNSOLVED: dict[str, Repairer] = {
    "bearings": sizing.nearest_bearings,
    "countershaft": sizing.resize,
    "gears": teeth.better_teeth,
}


def remedy(
    document: Document, step: str, results: Results | None = None, progress: Progress | None = None, tries: int = TRIES
) -> NearestRemedy:
    """The nearest remedy of one step.  One without changes: nothing of it can be repaired, or nothing fails.

    `results`: where the design is solved already.  `progress` may raise `Cancelled`.
    """
    return _Step(step, Budget(tries)).repair(state_of(document, results), progress)[0]


def nearest(
    document: Document,
    results: Results | None = None,
    progress: Progress | None = None,
    only: str | None = None,
    tries: int = TRIES,
) -> Nearest:
    """The nearest design in which no limit fails, with what can not be repaired.  `only`: the limits of this step
    alone.

    `tries`: how many designs may be solved in the search over single numbers, where nothing better is known for a
    check."""
    budget, start = Budget(tries), state_of(document, results)
    state, remedies, left = start, list[NearestRemedy](), dict[str, tuple[Unmended, ...]]()
    steps = [step for step in ORDER if only in (None, step)]
    for n in range(ROUNDS):
        before, moved = state, set[str]()
        for i, step in enumerate(steps):
            if not state.sick(step) or (
                left.get(step) and not any(earlier in moved for earlier in ORDER[: ORDER.index(step)])
            ):
                continue  # it holds; or what it was tried on has not changed since
            share = (n + i / len(steps)) / ROUNDS
            remedy, after = _Step(step, budget).repair(state, part(progress, share, share + 1 / len(steps) / ROUNDS))
            left[step] = remedy.left
            if remedy.changes:
                remedies.append(remedy)
                moved.add(step)
                kept = {key: value for key, value in state.changes.items() if key not in after.changes}
                state = replace(after, changes=kept | after.changes)
        if state is before or not any(state.sick(step) for step in steps):
            break
    undone = Text("what repairs other steps makes it fail")  # in the last round
    still = [
        unmended
        for step in steps
        if state.sick(step)
        for unmended in left.get(step) or [Unmended(step, c.id, c.name, undone) for c in state.failing(step)]
    ]
    changes = words(start.document, start.results, state.changes)
    return Nearest(
        tuple(remedies), tuple(still), tuple(assignments(state.changes)), changes, state.document, state.results
    )


def _without_needless(start: RepairState, state: RepairState) -> RepairState:
    """The same without the changes without which nothing is judged worse, the last ones first: a search moves several
    numbers at once, and what a later change repairs may need no earlier one.  A design is solved no further than to the
    first check that says so."""
    failing = {c.id for c in state.results.checks() if c.verdict == "fail"}
    worse: list[str] = []

    def fails(outcome: Outcome[object]) -> bool:
        known = outcome.key != "imbalance"  # whose checks change once the shaft is known
        worse.extend(c.id for c in outcome.checks if known and c.verdict == "fail" and c.id not in failing)
        return bool(worse)

    mended = {
        part
        for c in start.results.checks()
        if c.verdict == "fail" and c.id not in failing
        for part in re.split("[._]", c.id)[1:]
    }
    of = {key: key.split(".")[-2] for key in state.changes if key.count(".") > 1}  # the element of each
    for key in reversed(state.changes) if len(state.changes) > 1 else ():
        if of.get(key) in mended and [*of.values()].count(of[key]) == 1:
            continue  # the one change of an element whose check it mends
        if state.changes[key] is None and key in of and [*of.values()].count(of[key]) > 1:
            continue  # what goes with another change of its element: the catalogue's values of a former size
        worse.clear()
        rest = {k: value for k, value in state.changes.items() if k != key}
        try:
            other = start.with_changes(rest, state.results, fails)
        except BadInput:
            continue
        if not worse and not broken(state, other) and not warned(state.results, other.results):
            state = other
    return state


def _still(check: Check, ids: Sequence[str]) -> bool:
    """Whether it fails, and is among these: none are all."""
    return check.verdict == "fail" if not ids else check.id in ids and not is_mended(check)


def _by_shaft(state: RepairState, checks: Iterable[Check]) -> list[tuple[Check, ...]]:
    """The checks of each shaft, and those that are of none."""
    groups: dict[str, list[Check]] = {}
    for check in checks:
        groups.setdefault(state.design.shaft_of(state.design.of_original(check.id)), []).append(check)
    return [tuple(group) for group in groups.values()]


class _Step:
    """The repair of one step.  `why`: for each check what was tried in vain."""

    def __init__(self, step: str, budget: Budget) -> None:
        self.step, self.budget = step, budget
        self.why: dict[str, Text] = {}

    def repair(self, state: RepairState, progress: Progress | None) -> tuple[NearestRemedy, RepairState]:
        """The remedy, and the design with it, whose changes are those of the remedy alone."""
        state = start = replace(state, changes={})
        for n in range(TIMES):
            if not state.sick(self.step):
                break
            before, here = state, part(progress, n / TIMES, (n + 1) / TIMES)
            state = self._solution(state, here) if state.unsolved(self.step) else self._round(state, here)
            if state is before:
                break
        state = _without_needless(start, state)
        left = self._left(state)
        failing = {c.id for c in state.failing(self.step)}
        mends = [c.id for c in start.failing(self.step) if c.id not in failing]
        if start.unsolved(self.step) and not state.unsolved(self.step):
            mends = [self.step]
        breaks = tuple(id for id in broken(start, state) if not id.startswith(f"{self.step}."))
        then = state.outcome(self.step).words()
        if left:
            effect = Text("still fails: {checks}", checks=COMMA.join(unmended.name for unmended in left))
        elif breaks:
            effect = Text("{then}; then not kept: {checks}", then=then, checks=", ".join(breaks))
        else:
            effect = then
        changes, named = tuple(assignments(state.changes)), words_each(start.document, start.results, state.changes)
        document, results = state.document, state.results
        return NearestRemedy(self.step, changes, named, effect, tuple(mends), left, breaks, document, results), state

    def _left(self, state: RepairState) -> tuple[Unmended, ...]:
        step = self.step
        if state.unsolved(step):
            return (Unmended(step, step, IN_SENTENCES[step], self.why.get(step, state.outcome(step).reason)),)
        nothing = Text("nothing was found that repairs it")
        return tuple(Unmended(step, c.id, c.name, self.why.get(c.id, nothing)) for c in state.failing(step))

    def _solution(self, state: RepairState, progress: Progress | None) -> RepairState:
        """A step that finds no solution: its own search, else one number at a time."""
        ways = [*([UNSOLVED[self.step]] if self.step in UNSOLVED else []), self._one_number]
        for n, way in enumerate(ways):
            if state.unsolved(self.step):
                state = self._by(state, (), way, part(progress, n / len(ways), (n + 1) / len(ways)))
        return state

    def _round(self, state: RepairState, progress: Progress | None) -> RepairState:
        """Every failing check once: by what is made for it, then by its own remedies and the search over single
        numbers, then by a new start."""
        first, last = WAYS.get(self.step, ()), LAST.get(self.step, ())
        for n, (rules, way) in enumerate(first):
            # not those that were tried in vain
            failing = tuple(c for c in self._failing(state, rules) if c.id not in self.why)
            here = part(progress, 0.5 * n / len(first), 0.5 * (n + 1) / len(first))
            for mine in _by_shaft(state, failing):
                state = self._by(state, mine, way, here)
        every = state.failing(self.step)
        sets = [every] * (len(every) > 1) + [(check,) for check in every]
        for n, checks in enumerate(sets):
            failing = tuple(c for c in state.failing(self.step) if c.id in {check.id for check in checks})
            here = part(progress, 0.5 + 0.4 * n / len(sets), 0.5 + 0.4 * (n + 1) / len(sets))
            state = self._by(state, failing, self._one_number, here)
        for rules, way in last:
            for mine in _by_shaft(state, self._failing(state, rules)):
                state = self._by(state, mine, way, part(progress, 0.9, 1.0))
        return state

    def _failing(self, state: RepairState, rules: tuple[CheckRule, ...]) -> tuple[Check, ...]:
        return tuple(c for c in state.failing(self.step) if not rules or c.rule in rules)

    def _one_number(self, state: RepairState, failing: tuple[Check, ...], progress: Progress | None) -> RepairState:
        """By what a check itself names as a remedy, where that breaks nothing; else by the search over single
        numbers."""
        exact = [dict(remedy.changes) for c in failing for remedy in c.remedies]
        named = [way for changes in exact for way in (settled(state.document, changes), changes)]
        try:
            mended = first_repaired(state, self.step, [c.id for c in failing], named, progress, most=NAMED)
        except NoSolution:
            mended = state
        if mended is not state and not broken(state, mended):
            return mended
        return one_number(state, self.step, failing, self.budget, progress)

    def _by(
        self, state: RepairState, failing: tuple[Check, ...], way: Repairer, progress: Progress | None
    ) -> RepairState:
        """The design as a way repairs it; as it is where that does not, with the reason noted, or where nothing
        fails."""
        ids = [c.id for c in failing]
        if not ids and not state.unsolved(self.step):
            return state
        try:
            mended = way(state, failing, progress)
        except NoSolution as none:
            reason = none.text
        except BadInput as bad:
            reason = Text("{key} {reason}", key=bad.errors[0].key, reason=bad.errors[0].reason)
        else:
            worse = [id for id in broken(state, mended, ORDER[: ORDER.index(self.step) + 1]) if id not in ids]
            if repaired(state, mended, self.step, ids) and not worse:
                return mended
            still = [c.name for c in mended.outcome(self.step).checks if _still(c, ids)]
            if worse:
                named = {check.id: in_context(check.name, check.id) for check in mended.results.checks()}
                reason = Text("with what repairs it {check} is not kept", check=named.get(worse[0], worse[0]))
            else:
                reason = Text("the nearest still fails: {checks}", checks=COMMA.join(still))
        for id in ids or [self.step]:
            self.why.setdefault(id, reason)
        return state
