# SPDX-License-Identifier: Apache-2.0
"""A design on its way: its document, what has been changed so far, and what it then gives.  Nothing is changed in
place."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from ...design.addresses import value_at
from ...design.locks import locked
from ...design.model import STEPS, Design
from ...design.toml_file import Document, design
from ...sheet.check import Check
from ...sheet.errors import BadInput, InputError, NoSolution
from ...sheet.progress import Progress
from ...sheet.remedy import Changes
from ...sheet.search import Trial, first_good
from ...sheet.step import Outcome
from ...sheet.text import Small, Text
from ...sheet.value import recorded
from ...sheet.verdict import severity
from ...solve import Results, solve

# in which steps are repaired: that of solving
ORDER = ("engine", "imbalance", "countershaft", "bearings", "gears", "friction", "mounting")
TITLES = {step.key: Small(step.title) for step in STEPS}


@dataclass(frozen=True)
class RepairState:
    """`changes`: from the design that was asked about to this one."""

    document: Document
    results: Results
    changes: Changes = field(default_factory=dict)

    @property
    def design(self) -> Design:
        return self.results.design

    def outcome(self, step: str) -> Outcome[object]:
        return self.results.outcomes[step]

    def failing(self, step: str) -> tuple[Check, ...]:
        return tuple(c for c in self.outcome(step).checks if c.verdict == "fail")

    def unsolved(self, step: str) -> bool:
        return self.outcome(step).state == "no_solution"

    def sick(self, step: str) -> bool:
        """Whether a limit of the step fails, or it has no solution."""
        return self.unsolved(step) or bool(self.failing(step))

    def with_changes(
        self,
        changes: Mapping[str, object],
        known: Results | None = None,
        enough: Callable[[Outcome[object]], bool] | None = None,
    ) -> "RepairState":
        """The same with keys changed, solved whole but for what judges nothing.  Raises BadInput where they are not
        allowed, or locked.

        `known`: results of a design that is nearer to it, or of itself, whole or not.  `enough` ends the solution
        early, as in `solve`."""
        document, merged = self.document, dict(self.changes)
        for key, value in changes.items():
            if value == value_at(document.data, key):
                continue
            if reason := locked(document.data, key):
                raise BadInput(document.place, [InputError(0, key, "", Text("is locked: {reason}", reason=reason))])
            document = document.with_value(key, value)
            merged.pop(key, None)
            merged[key] = value
        wanted = design(document, (self.document, self.design))
        there = known is not None and known.design == wanted and known.outcomes.keys() >= self.results.outcomes.keys()
        if known is not None and there:
            return RepairState(document, known, merged)
        with recorded(False):
            results = solve(wanted, known or self.results, enough=enough, compared=False)
        return RepairState(document, results, merged)


def state_of(document: Document, results: Results | None = None) -> RepairState:
    """`results`: where the design, or an earlier version of it, is solved already."""
    wanted = design(document)
    return RepairState(
        document, results if results is not None and results.design == wanted else solve(wanted, results)
    )


def broken(before: RepairState, after: RepairState, steps: Iterable[str] = ORDER) -> list[str]:
    """Checks of these steps that fail now and did not before, and steps that lost their solution; of a step without one
    nothing counts."""
    worse = []
    for step in steps:
        if before.outcome(step).state != "solved":
            continue
        if after.outcome(step).state != "solved":
            worse.append(step)
        failed = {c.id for c in before.failing(step)}
        worse += [c.id for c in after.failing(step) if c.id not in failed]
    return worse


def warned(before: Results, after: Results) -> list[Check]:
    """Checks that held, or were not there, and are a warning now, the worst first."""
    known = {c.id for c in before.checks() if c.open}
    return sorted((c for c in after.checks() if c.verdict == "warn" and c.id not in known), key=severity)


def repaired(before: RepairState, after: RepairState, step: str, ids: Iterable[str]) -> bool:
    """Whether these checks hold now; where the step had no solution, all of its checks."""
    if after.outcome(step).state != "solved":
        return False
    failing = {c.id for c in after.failing(step)}
    return not failing if before.unsolved(step) else not failing & set(ids)


def first_repaired(
    before: RepairState,
    step: str,
    ids: Iterable[str],
    ways: Iterable[Changes],
    progress: Progress | None = None,
    *,
    whole: bool = False,
    most: int | None = None,
) -> RepairState:
    """The first of some ways, each a set of changes, by which the checks `ids` of a step hold; `most` of them are
    tried.

    One that breaks no check that held is preferred to one that breaks checks of later steps, which can be repaired in
    turn; with `whole` one by which all of the step holds goes before.  Raises NoSolution where no way does."""
    wanted, earlier = list(ids), ORDER[: ORDER.index(step) + 1]

    def tried(changes: Changes) -> Trial[RepairState]:
        try:
            after = before.with_changes(changes)
        except BadInput as bad:
            return Trial(None, why=bad.errors[0].reason)
        if not repaired(before, after, step, wanted):
            still = next((c for c in after.failing(step) if c.id in wanted), None)
            return Trial(
                None, why=Text("{check} would still fail", check=still.name) if still else after.outcome(step).reason
            )
        if worse := broken(before, after, earlier):
            return Trial(None, why=Text("{check} would then fail", check=worse[0]))
        later = broken(before, after) or any(map(after.unsolved, ORDER))
        return Trial(after, 2 * bool(whole and after.failing(step)) + bool(later))

    different = list({tuple(map(str, way.items())): way for way in ways if way}.values())
    best = first_good(different, tried, progress, TITLES[step], most)
    if best.result is None:
        raise NoSolution(best.why or Text("nothing is left to change"))
    return best.result
