# SPDX-License-Identifier: Apache-2.0
"""A design on its way: its document, what has been changed so far, and what it then gives.  Nothing is changed in place."""

from collections.abc import Iterable
from dataclasses import dataclass

from ..design import STEPS, Design
from ..design_file import Document, design, parse_assignment
from ..sheet.check import Check
from ..sheet.errors import BadInput, NoSolution
from ..sheet.progress import Progress, tell
from ..sheet.step import Outcome
from ..solve import Results, solve

ORDER = ("engine", "imbalance", "countershaft", "bearings", "gears", "friction")  # in which steps are mended: that of solving
TITLES = {step.key: step.title.lower() for step in STEPS}


@dataclass(frozen=True)
class State:
    """`changes`: KEY=VALUE, as `--set` takes them, from the design that was asked about to this one."""

    document: Document
    results: Results
    changes: tuple[str, ...] = ()

    @property
    def design(self) -> Design:
        return self.results.design

    def outcome(self, step: str) -> Outcome:
        return self.results.outcomes[step]

    def failing(self, step: str) -> tuple[Check, ...]:
        return tuple(c for c in self.outcome(step).checks if c.verdict == "fail")

    def unsolved(self, step: str) -> bool:
        return self.outcome(step).state == "no_solution"

    def sick(self, step: str) -> bool:
        """Whether a limit of the step fails, or it has no solution."""
        return self.unsolved(step) or bool(self.failing(step))

    def check(self, step: str, id: str) -> Check | None:
        return next((c for c in self.outcome(step).checks if c.id == id), None)

    def with_changes(self, changes: Iterable[str]) -> "State":
        """The same with keys changed, solved whole.  Raises BadInput where they are not allowed."""
        document = self.document
        said = {change.partition("=")[0]: change for change in self.changes}
        for change in changes:
            key, value = parse_assignment(change)
            document = document.with_value(key, value)
            said.pop(key, None)
            said[key] = change
        return State(document, solve(design(document), self.results), tuple(said.values()))


def state_of(document: Document, results: Results | None = None) -> State:
    """`results`: where the design, or an earlier version of it, is solved already."""
    made = design(document)
    return State(document, results if results is not None and results.design == made else solve(made, results))


def broken(before: State, after: State, steps: Iterable[str] = ORDER) -> list[str]:
    """Checks of these steps that fail now and did not before, and steps that lost their solution; of a step without one nothing counts."""
    found = []
    for step in steps:
        was, now = before.outcome(step), after.outcome(step)
        if was.state != "solved":
            continue
        if now.state != "solved":
            found.append(step)
        failed = {c.id for c in before.failing(step)}
        found += [c.id for c in after.failing(step) if c.id not in failed]
    return found


def first_good(before: State, step: str, ids: Iterable[str], ways: Iterable[Iterable[str]], progress: Progress | None = None) -> State:
    """The first of some ways, each a set of changes, by which the checks `ids` of a step hold.

    One that breaks no check that held is preferred to one that breaks checks of later steps, which can be mended in turn.  Raises
    NoSolution where no way does.
    """
    wanted, second = list(ids), None
    later = ORDER[ORDER.index(step) + 1 :]
    earlier = ORDER[: ORDER.index(step) + 1]
    tried = list(ways)
    why = "nothing is left to change"
    for n, changes in enumerate(tried):
        tell(progress, n / len(tried), TITLES[step])
        try:
            after = before.with_changes(changes)
        except BadInput as bad:
            why = bad.errors[0].reason
            continue
        if not mended(before, after, step, wanted):
            still = [c for c in after.failing(step) if c.id in wanted]
            why = f"{still[0].name} would still fail" if still else after.outcome(step).reason or why
            continue
        if not broken(before, after):
            return after
        if not broken(before, after, earlier):
            second = second or after
        else:
            why = f"{broken(before, after, earlier)[0]} would then fail"
    if second is not None and broken(before, second, later):
        return second
    raise NoSolution(why)


def mended(before: State, after: State, step: str, ids: Iterable[str]) -> bool:
    """Whether these checks hold now; where the step had no solution, all of its checks."""
    if after.outcome(step).state != "solved":
        return False
    failing = {c.id for c in after.failing(step)}
    return not failing if before.unsolved(step) else not failing & set(ids)
