# SPDX-License-Identifier: Apache-2.0
"""The nearest passing design: of one step that fails, or of the whole design, step by step in the order of solving."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from ..design_file import Document
from ..sheet.check import Check
from ..sheet.errors import BadInput, NoSolution
from ..sheet.progress import Progress, part
from ..solve import Results
from . import backlash, bearings, shaft, strength, teeth, vary
from .state import ORDER, TITLES, State, broken, mended, state_of
from .words import words

ROUNDS = 3  # through the steps: one may undo a little of an earlier one
TIMES = 4  # through the checks of a step

Mend = Callable[[State, tuple[Check, ...], Progress | None], State]


@dataclass(frozen=True)
class Remedy:
    """What mends a step.  `changes`: KEY=VALUE, as `--set` takes them; `mends`: ids of checks that failed and hold with it (a step that
    had no solution: its key).  `left`: what still fails in the step, and why; then it is a part of a remedy only.  `breaks`: ids of
    checks of other steps that fail with it and did not before.  `document` and `results`: the design with it."""

    step: str
    changes: tuple[str, ...]
    words: str
    said: str
    mends: tuple[str, ...]
    left: "tuple[Unmended, ...]"
    breaks: tuple[str, ...]
    document: Document
    results: Results


@dataclass(frozen=True)
class Unmended:
    """A check, or a step without solution (its key), for which nothing was found, and why."""

    step: str
    id: str
    name: str
    why: str


@dataclass(frozen=True)
class Nearest:
    """Remedies in the order in which they are to be made, each on the design with those before; what then still fails; the design with
    all of them.  `changes` and `words`: all of them together."""

    remedies: tuple[Remedy, ...]
    left: tuple[Unmended, ...]
    changes: tuple[str, ...]
    words: str
    document: Document
    results: Results

    @property
    def passes(self) -> bool:
        """Whether no limit of the whole design fails any more."""
        return not any(o.verdict in ("fail", "no_solution", "blocked") for o in self.results.outcomes.values())


def _any(check: Check) -> bool:
    return True


# For each step: which of its checks, and what mends them.  What is left goes to the search over single numbers.
MENDS: dict[str, tuple[tuple[Callable[[Check], bool], Mend], ...]] = {
    "countershaft": ((shaft.leaves, shaft.balance), (shaft.crosses, shaft.shorter_journals)),
    "bearings": ((_any, bearings.mend),),
    "gears": ((teeth.about, teeth.mend), (backlash.about, backlash.mend), (strength.about, strength.mend)),
}
UNSOLVED: dict[str, Mend] = {"bearings": bearings.mend, "countershaft": shaft.resize}
LAST: dict[str, tuple[tuple[Callable[[Check], bool], Mend], ...]] = {"countershaft": ((shaft.fits, shaft.resize),)}


def remedy(document: Document, step: str, results: Results | None = None, progress: Progress | None = None) -> Remedy:
    """The nearest remedy of one step.  One without changes: nothing of it can be mended, or nothing fails.

    `results`: where the design is solved already.  `progress` may raise `Cancelled`.
    """
    return _remedy(state_of(document, results), step, progress)


def nearest(document: Document, results: Results | None = None, progress: Progress | None = None, only: str | None = None) -> Nearest:
    """The nearest design in which no limit fails; what can not be mended is said.  `only`: the limits of this step alone."""
    start = state = state_of(document, results)
    remedies: list[Remedy] = []
    steps = [step for step in ORDER if only in (None, step)]
    left: dict[str, tuple[Unmended, ...]] = {}
    for n in range(ROUNDS):
        before = state
        for i, step in enumerate(steps):
            if not state.sick(step):
                continue
            share = (n + i / len(steps)) / ROUNDS
            found = _remedy(state, step, part(progress, share, share + 1 / len(steps) / ROUNDS))
            left[step] = found.left
            if found.changes:
                remedies.append(found)
                state = State(found.document, found.results, _together(state.changes, found.changes))
        if state is before or not any(state.sick(step) for step in steps):
            break
    still = [one for step in steps if state.sick(step) for one in left.get(step) or _undone(state, step)]
    said = words(start.document, start.results, state.changes)
    return Nearest(tuple(remedies), tuple(still), state.changes, said, state.document, state.results)


def _together(before: tuple[str, ...], more: tuple[str, ...]) -> tuple[str, ...]:
    """Of two changes of one key the later."""
    keys = {change.partition("=")[0] for change in more}
    return (*(change for change in before if change.partition("=")[0] not in keys), *more)


def _undone(state: State, step: str) -> tuple[Unmended, ...]:
    """Checks that a remedy of another step made fail in the last round."""
    return tuple(Unmended(step, c.id, c.name, "what mends other steps makes it fail") for c in state.failing(step))


def _remedy(start: State, step: str, progress: Progress | None) -> Remedy:
    state = start = replace(start, changes=())
    why: dict[str, str] = {}
    for n in range(TIMES):
        if not state.sick(step):
            break
        before, here = state, part(progress, n / TIMES, (n + 1) / TIMES)
        state = _unsolved(state, step, why, here) if state.unsolved(step) else _round(state, step, why, here)
        if state is before:
            break
    left = _left(state, step, why)
    failing = {c.id for c in state.failing(step)}
    mends = [c.id for c in start.failing(step) if c.id not in failing]
    if start.unsolved(step) and not state.unsolved(step):
        mends = [step]
    breaks = tuple(id for id in broken(start, state) if not id.startswith(f"{step}."))
    if left:
        said = f"still fails: {', '.join(one.name for one in left)}"
    elif breaks:
        said = f"passes all checks of the {TITLES[step]}; then fails: {', '.join(breaks)}"
    else:
        said = f"passes all checks of the {TITLES[step]}"
    return Remedy(
        step, state.changes, words(start.document, start.results, state.changes), said, tuple(mends), left, breaks, state.document,
        state.results,
    )  # fmt: skip


def _left(state: State, step: str, why: dict[str, str]) -> tuple[Unmended, ...]:
    if state.unsolved(step):
        return (Unmended(step, step, TITLES[step], why.get(step, state.outcome(step).reason)),)
    return tuple(Unmended(step, c.id, c.name, why.get(c.id, "nothing was found that mends it")) for c in state.failing(step))


def _unsolved(state: State, step: str, why: dict[str, str], progress: Progress | None) -> State:
    """A step that finds no solution: its own search, else one number at a time."""
    ways: list[Mend] = [lambda s, _, p: vary.mend(s, step, None, p)]
    if step in UNSOLVED:
        ways.insert(0, UNSOLVED[step])
    for n, way in enumerate(ways):
        made = _tried(state, step, (), way, why, part(progress, n / len(ways), (n + 1) / len(ways)))
        if made is not None:
            return made
    return state


def _round(state: State, step: str, why: dict[str, str], progress: Progress | None) -> State:
    """Every failing check once: by what is made for it, then by the search over single numbers, then by a new start."""
    first, last = MENDS.get(step, ()), LAST.get(step, ())
    for n, (about, way) in enumerate(first):
        state = _mended(state, step, about, way, why, part(progress, 0.5 * n / len(first), 0.5 * (n + 1) / len(first)))
    some = state.failing(step)
    for n, one in enumerate(some):
        state = _alone(state, step, one, why, part(progress, 0.5 + 0.4 * n / len(some), 0.5 + 0.4 * (n + 1) / len(some)))
    for about, way in last:
        state = _mended(state, step, about, way, why, part(progress, 0.9, 1.0))
    return state


def _mended(
    state: State, step: str, about: Callable[[Check], bool], way: Mend, why: dict[str, str], progress: Progress | None
) -> State:  # fmt: skip
    failing = tuple(c for c in state.failing(step) if about(c))
    return (_tried(state, step, failing, way, why, progress) if failing else None) or state


def _alone(state: State, step: str, check: Check, why: dict[str, str], progress: Progress | None) -> State:
    """One check by the search over single numbers, where it still fails."""
    now = state.check(step, check.id)
    if now is None or now.verdict != "fail":
        return state
    return _tried(state, step, (now,), lambda s, failing, p: vary.mend(s, step, failing[0], p), why, progress) or state


def _tried(
    state: State, step: str, failing: tuple[Check, ...], way: Mend, why: dict[str, str], progress: Progress | None
) -> State | None:  # fmt: skip
    """The design as a way mends it; None where it does not, with the reason noted."""
    ids = [c.id for c in failing]
    try:
        made = way(state, failing, progress)
    except NoSolution as none:
        reason = str(none)
    except BadInput as bad:
        reason = f"{bad.errors[0].key} {bad.errors[0].reason}"
    else:
        earlier = ORDER[: ORDER.index(step) + 1]
        worse = [id for id in broken(state, made, earlier) if id not in ids]
        if mended(state, made, step, ids) and not worse:
            return made
        still = [c.name for c in made.failing(step) if not ids or c.id in ids]
        reason = f"what mends it makes {worse[0]} fail" if worse else f"the nearest still fails: {', '.join(still)}"
    for id in ids or [step]:
        why.setdefault(id, reason)
    return None
