# SPDX-License-Identifier: Apache-2.0
"""The smallest change of one lever by which checks hold and nothing that held fails; whole designs are tried, each
once."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from itertools import islice
from math import inf, isnan, nan

from ...design.addresses import value_at
from ...design.model import IN_SENTENCES
from ...sheet.check import THIN_MARGIN, Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.remedy import Changes
from ...sheet.search import Budget, crossing
from ...sheet.step import Outcome
from ...sheet.text import Text
from .levers import Lever, free_keys, levers, named_keys, together
from .state import ORDER, RepairState, broken, held, repaired

PROBE = 0.02  # relative change by which a number is moved to see what it does
STEP = 0.01  # least relative change from one that is tried to the next
FARTHEST = (10.0, 10.0)  # relative changes up and down that are still believed
ROUND = 0.03  # relative change that a round number is worth, where the smallest is not asked for
BEST = 5  # numbers that are moved all the way
UNKNOWN = 0.15  # relative change that is hoped for where a small one tells nothing
SURE = 0.3  # of the change that a small one asks for: hardly one is enough by less


@dataclass
class Trials:
    """`checks`: those that are to hold; none: the step finds no solution.  `name`: what is being looked at.  `near`:
    the relative change that a round number is worth."""

    state: RepairState
    step: str
    checks: tuple[Check, ...]
    budget: Budget
    progress: Progress | None
    name: Text
    farthest: tuple[float, float] = FARTHEST
    near: float = 0.0
    _known: dict[tuple[str, bool], RepairState | None] = field(default_factory=dict)  # by changes, and whether whole
    _ended: bool = False  # whether the last one was solved as far as the checks only

    @property
    def ids(self) -> set[str]:
        return {c.id for c in self.checks}

    # --- whole designs
    def tried(self, changes: Changes | None, whole: bool = False) -> RepairState | None:
        """The design with a change, solved no further than to the checks; `whole`: to the end.  None where it is not
        allowed, or nothing may be tried any more."""
        name = str(changes)
        if changes is None or ((name, False) not in self._known and not self.budget.spend()):
            return None
        if (name, whole) not in self._known:
            tell(self.progress, 1 - 0.9 ** len(self._known), self.name)
            self._ended = False
            begun = self._known.get((name, False))
            try:
                after = self.state.with_changes(
                    changes, begun.results if begun else None, None if whole else self._decided
                )
            except (BadInput, NoSolution):
                after = None
            self._known[name, False] = after
            if not self._ended:
                self._known[name, True] = after
        return self._known[name, whole]

    def _decided(self, outcome: Outcome[object]) -> bool:
        """Whether all of the checks are known, or that there is no solution; those of the imbalance change once the
        shaft is known, and behind the last step there is nothing to be spared."""
        if outcome.key == self.step and self.step not in ("imbalance", ORDER[-1]):
            known = self.ids <= {c.id for c in outcome.checks}
            self._ended = known if self.ids else outcome.state == "no_solution"
        return self._ended

    def score(self, after: RepairState | None, wanted: tuple[Check, ...]) -> float:
        """The least margin of what is to hold, from that at which it is no warning; no number where there is none."""
        if after is None or after.outcome(self.step).state != "solved":
            return nan
        there = {c.id: c for c in after.outcome(self.step).checks}
        margins = [there[c.id].margin - _needed(c) for c in wanted if c.id in there]
        if not margins or any(map(isnan, margins)):
            return 0.0 if repaired(self.state, after, self.step, self.ids) else nan
        return min(margins)

    # --- one lever
    def enough(self, lever: Lever, wanted: tuple[Check, ...]) -> tuple[Iterator[float], float]:
        """Numbers of a lever by which what is wanted holds, as a workshop writes them, the roundest of the smallest
        changes first; where there is none, the relative change that comes nearest, which else is 0."""
        start, nearest = self.score(self.state, wanted), 0.0
        numbers: list[float] = []
        for sign, farthest in zip((1.0, -1.0), self.farthest):
            score, first = partial(self.score_at, lever, wanted, sign), max(PROBE, lever.step)
            if not isnan(start) and not score(first) > start:
                continue
            ends = crossing(score, start, first, farthest, max(STEP, lever.step), self.near)
            if isinstance(ends, tuple):
                low, high = ends
                beyond = high + max(high - low, self.near)
                numbers = lever.offered(
                    lever.rounded(sign * low, sign * high),
                    lever.rounded(sign * high, sign * beyond),
                    lever.number(sign * high),
                )
                break
            if nearest := sign * ends:
                numbers = lever.offered(lever.number(nearest))  # it may hold there, by a narrow margin
                break
        holds = (number for number in numbers if self.holds(self.tried(lever.offered_at(number)), wanted))
        return holds, nearest

    def holds(self, after: RepairState | None, wanted: tuple[Check, ...]) -> bool:
        """Whether what is wanted is kept: what failed, if only just, and what was narrow, clear of it."""
        score = self.score(after, wanted)
        if after is None or not score < 0:
            return score >= 0
        there = {c.id: c for c in after.outcome(self.step).checks}
        return all(c.verdict == "fail" and c.id in there and there[c.id].holds for c in wanted)

    def score_at(self, lever: Lever, wanted: tuple[Check, ...], sign: float, change: float) -> float:
        """That of a relative change up or down."""
        return self.score(self.tried(lever.at(lever.number(sign * change))), wanted)

    def least(self, lever: Lever) -> tuple[float, RepairState] | None:
        """The smallest relative change of a lever by which all checks hold and nothing that held fails, and the design
        with it."""
        for number in self.enough(lever, self.checks)[0]:
            after = self.tried(lever.offered_at(number), whole=True)
            if after is not None and repaired(self.state, after, self.step, self.ids) and not broken(self.state, after):
                return abs(number - lever.now) / lever.scale, after
        return None


def _needed(check: Check) -> float:
    """The margin by which a check is no warning."""
    return THIN_MARGIN if check.kind == "limit" and not check.exact else 0.0


# --- of all numbers the one that changes least


def one_number(
    state: RepairState, step: str, checks: tuple[Check, ...], budget: Budget, progress: Progress | None = None
) -> RepairState:
    """All these checks by one number.  Each is moved a little, to see how far it would have to go; the most promising
    are then moved until the checks hold.  Raises NoSolution where no single one helps, or not within the budget."""
    trials = Trials(state, step, checks, budget, progress, checks[0].name if checks else IN_SENTENCES[step])
    named = named_keys(state, checks)
    free = [key for keys in free_keys(state, step, checks) for key in keys if _given(state, key) and key not in named]
    numbers = [(last, lever) for last, keys in enumerate((named, free)) for lever in _one_by_one(state, keys)]
    hopes = [(last, need, lever) for last, lever in numbers if (need := _need(trials, lever)) <= FARTHEST[0]]
    best: tuple[float, RepairState] | None = None
    for n, (last, need, lever) in enumerate(sorted(hopes, key=lambda hope: hope[:2])):
        if best is not None and (n >= BEST or best[0] <= SURE * need or (named and last)):
            break
        moved = trials.least(lever)
        if moved is not None and (best is None or moved[0] < best[0]):
            best = moved
    if best is not None:
        return best[1]
    if not numbers:
        raise NoSolution(Text("there is no number to change"))
    if budget.left > 0:
        raise NoSolution(Text("no single number of the step repairs it"))
    raise NoSolution(Text("no single number of the step repairs it; the search was ended there"))


def _given(state: RepairState, key: str) -> bool:
    return value_at(state.document.data, key) is not None


def _one_by_one(state: RepairState, keys: Iterable[str]) -> Iterator[Lever]:
    for one in together(key for key in keys if not held(state, key)):
        yield from islice(levers(state, one), 1)


def _need(trials: Trials, lever: Lever) -> float:
    """The relative change that is needed as far as a small one tells."""
    small = PROBE if lever.at(lever.number(PROBE)) is not None else -PROBE
    now = trials.score(trials.state, trials.checks)
    gain = trials.score_at(lever, trials.checks, 1.0, small) - now
    return UNKNOWN if isnan(gain) else inf if gain == 0 else PROBE * -now / abs(gain)
