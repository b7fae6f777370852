# SPDX-License-Identifier: Apache-2.0
"""A design on its way: its document, what has been changed so far, and what it then gives.  Nothing is changed in
place."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from ...bearings.plain.selection.variants import tied
from ...countershaft.inputs import ShaftInputs
from ...countershaft.rows import BearingRow
from ...design.addresses import value_at
from ...design.locks import locked
from ...design.model import IN_SENTENCES, Design
from ...design.step_inputs import bearings_case
from ...design.toml_file import Document, design
from ...sheet.check import Check
from ...sheet.errors import BadInput, InputError, NoSolution
from ...sheet.progress import Progress
from ...sheet.remedy import Changes
from ...sheet.search import Trial, first_good
from ...sheet.step import Outcome
from ...sheet.text import EMPTY, Name, Text
from ...sheet.value import recorded
from ...sheet.verdict import severity
from ...solve import Results, solve

# in which steps are repaired: that of solving
ORDER = ("engine", "imbalance", "countershaft", "bearings", "gears", "friction", "mounting")


@dataclass(frozen=True)
class RepairState:
    """`changes`: from the design that was asked about to this one."""

    document: Document
    results: Results
    changes: Changes = field(default_factory=dict)

    @property
    def design(self) -> Design:
        return self.results.design

    def view(self, key: str) -> Design:
        """The design with the shaft in view that a key, or the id of a check, is of, of a twin its original; of none
        the first."""
        views = self.design.views
        original = self.design.shaft_of(self.design.of_original(key))
        return views.get(original) or next(iter(views.values()), self.design)

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


def held(state: RepairState, key: str) -> Text:
    """Why a search leaves an input as it is: it is locked, or a journal whose seat something is threaded through, which
    the search for bearings holds too; empty where it may be moved."""
    if reason := locked(state.document.data, key):
        return Name(reason)
    view = state.view(key)
    for row in view.rows if view.bearings is not None else ():
        if row.fed() and key == view.own_key(ShaftInputs.bearings, row.name, BearingRow.diameter):
            return tied(bearings_case(state.design, solve, state.results, view.own_name), row)
    return EMPTY


def broken(before: RepairState, after: RepairState, steps: Iterable[str] = ORDER) -> list[str]:
    """Limits of these steps that are judged worse now: that fail and did not before, or are not verified any more; and
    steps that lost their solution.  Of a step without one nothing counts."""
    return worse_limits(before.results, after.results, steps)


def worse_limits(before: Results, after: Results, steps: Iterable[str] = ORDER) -> list[str]:
    """The same of two solved designs."""
    worse = []
    for step in steps:
        was, now = before.outcomes[step], after.outcomes[step]
        if was.state != "solved":
            continue
        if now.state != "solved":
            worse.append(step)
        were = {c.id: _lost(c) for c in was.checks}
        worse += [c.id for c in now.checks if _lost(c) > were.get(c.id, UNVERIFIED)]
    return worse


UNVERIFIED = 2  # of a limit that was not there: it may be new, but must not fail


def _lost(check: Check) -> int:
    """How far a limit is from being kept: 0 where it is, 3 where it fails; else it is not verified, and holds by what
    is taken, or does not."""
    if check.kind != "limit":
        return 0
    return {"fail": 3, "not_verified": 1 if check.holds else 2}.get(check.verdict, 0)


def warned(before: Results, after: Results) -> list[Check]:
    """Checks that held, or were not there, and are a warning now, the worst first."""
    known = {c.id for c in before.checks() if c.open and c.verdict != "fail"}
    return sorted((c for c in after.checks() if c.verdict == "warn" and c.id not in known), key=severity)


def closer_limits(before: Results, after: Results, part: str) -> list[Check]:
    """Limits that are kept by a narrow margin now and were not, and those of a part (`bearings.front`) that are passed
    over, or not verified, by more than before; the worst first."""
    were = {c.id: c for c in before.checks() if c.kind == "limit"}
    closer = []
    for check in after.checks():
        was = were.get(check.id)
        if was is None or not check.open:
            continue
        mine = check.id.startswith(f"{part}.") and check.margin < was.margin - NOTICED
        if mine if was.open else check.narrow:
            closer.append(check)
    return sorted(closer, key=severity)


NOTICED = 1e-3  # of a margin: a limit that is passed over by so little more is as far out as before


def is_mended(check: Check) -> bool:
    """Whether a limit that failed does not any more: it holds by what is taken, though it may not be verified."""
    return check.verdict != "fail" and check.holds


def repaired(before: RepairState, after: RepairState, step: str, ids: Iterable[str], *, well: bool = False) -> bool:
    """Whether these checks hold now, `well`: and by no narrow margin; where the step had no solution, all of its
    checks."""
    if after.outcome(step).state != "solved":
        return False
    if before.unsolved(step):
        return not after.failing(step)
    wanted = set(ids)
    checks = [c for c in after.outcome(step).checks if c.id in wanted]
    return all(is_mended(c) and not (well and c.narrow) for c in checks)


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
    turn, and of these one that leaves no narrow margin; with `whole` one by which all of the step holds goes before.
    Raises NoSolution where no way does."""
    wanted, earlier = list(ids), ORDER[: ORDER.index(step) + 1]

    def tried(changes: Changes) -> Trial[RepairState]:
        try:
            after = before.with_changes(changes)
        except BadInput as bad:
            return Trial(None, why=bad.errors[0].reason)
        if not repaired(before, after, step, wanted):
            still = next((c for c in after.outcome(step).checks if c.id in wanted and not is_mended(c)), None)
            return Trial(
                None, why=Text("{check} would still fail", check=still.name) if still else after.outcome(step).reason
            )
        if worse := broken(before, after, earlier):
            return Trial(None, why=Text("{check} would then fail", check=worse[0]))
        later = broken(before, after) or any(map(after.unsolved, ORDER))
        narrow = not repaired(before, after, step, wanted, well=True)
        return Trial(after, 4 * bool(whole and after.failing(step)) + 2 * bool(later) + narrow)

    different = list({tuple(map(str, way.items())): way for way in ways if way}.values())
    best = first_good(different, tried, progress, IN_SENTENCES[step], most)
    if best.result is None:
        raise NoSolution(best.why or Text("nothing is left to change"))
    return best.result
