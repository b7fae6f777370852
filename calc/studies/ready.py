# SPDX-License-Identifier: Apache-2.0
"""How far a design is: the state of each step, whether the whole is ready, and what is open."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from ..design.addresses import Table, as_table
from ..design.model import STEPS
from ..sheet.check import Check
from ..sheet.record import record
from ..sheet.step import Outcome, Step
from ..sheet.text import COMMA, Small, Text, plural

if TYPE_CHECKING:
    from ..solve import Results

# --- the state of each step, and whether the design is ready

DONE = ("ready", "not_asked")
OPEN = ("fail", "not_verified", "warn")


@record
class StepState:
    """`state`: todo, needs (inputs), waits (for another step, or for the solver), fail, not_verified, warn, ready,
    not_asked.

    `count`: the inputs that are needed, or the findings that are open, those of one cause counted once.
    """

    key: str
    state: str
    count: int
    words: Text

    @property
    def done(self) -> bool:
        return self.state in DONE


def readiness(data: Table, results: "Results | None", wrong: Iterable[str] = ()) -> tuple[StepState, ...]:
    """The state of every step.  `data`: the tables of the design; `wrong`: keys of inputs that are missing or not
    understood.

    Those of the design itself, of its name or of what is measured, count with the first step, in which they are asked.
    """
    owners = [key.partition(".")[0] for key in wrong]
    owners = [key if any(key == step.key for step in STEPS) else STEPS[0].key for key in owners]
    left_out = as_table(data.get("without"))
    outcomes: Mapping[str, Outcome[object]] = results.outcomes if results is not None else {}
    return tuple(_state(step, data, left_out, owners.count(step.key), outcomes.get(step.key)) for step in STEPS)


def ready(states: Iterable[StepState]) -> bool:
    """Nothing is left to do: every step is ready, or is not asked for."""
    return all(state.done for state in states)


def _state(step: Step, data: Table, left_out: Table, wrong: int, outcome: Outcome[object] | None) -> StepState:
    key = step.key
    if wrong:
        return StepState(key, "needs", wrong, plural("needs {n} input", "needs {n} inputs", n=wrong))
    if key in left_out:
        return StepState(key, "not_asked", 0, Text("left out: {reason}", reason=str(left_out[key])))
    if key not in data and "engine" in data and not step.optional:
        return StepState(key, "todo", 0, Text("to do"))
    if key not in data:
        return StepState(key, "not_asked", 0, Text("not used"))
    if outcome is None or outcome.state == "not_asked":
        return StepState(key, "waits", 0, Text("solving …"))
    if outcome.state == "no_solution":
        return StepState(key, "fail", 1, Text("no solution"))
    if outcome.state == "blocked":
        return StepState(key, "waits", 0, outcome.reason)
    counts = open_causes(outcome.causes)
    for state, words in KINDS:
        if count := counts[state]:
            return StepState(key, state, count, plural(words.one, words.template, n=count))
    return StepState(key, "ready", 0, Text("ready"))


KINDS = (
    ("fail", plural("{n} limit fails", "{n} limits fail", n=0)),
    ("not_verified", plural("{n} not verified", "{n} not verified", n=0)),
    ("warn", plural("{n} caution", "{n} cautions", n=0)),
)


def open_causes(causes: Iterable[Sequence[Check]]) -> dict[str, int]:
    """How many causes have a limit that fails, one that can not be judged, or a caution that is open; each counts as
    its worst."""
    counts = dict.fromkeys(OPEN, 0)
    for worst, *_ in causes:
        if worst.verdict in counts:
            counts["warn" if worst.verdict == "not_verified" and worst.kind != "limit" else worst.verdict] += 1
    return counts


@record
class Tally:
    """The states of all steps counted: `of` steps are asked for, `ready` of them are ready."""

    fail: int
    not_verified: int
    warn: int
    ready: int
    of: int

    @property
    def words(self) -> tuple[tuple[str, Text], ...]:
        """`1 limit fails`, `2 cautions`, each with its state; then how many steps are ready."""
        counts = [(state, plural(text.one, text.template, n=n)) for state, text in KINDS if (n := getattr(self, state))]
        if self.ready == self.of:
            return (*counts, ("ready", Text("ready")))
        return (*counts, ("todo", Text("ready {n} of {count}", n=self.ready, count=self.of)))


def tally(states: Sequence[StepState], results: "Results | None") -> Tally:
    """What is open in the whole design.  A step without a solution counts as a limit that fails."""
    checks = results.outcomes.values() if results is not None else ()
    open_ = [open_causes(outcome.causes) for outcome in checks if outcome.state == "solved"]
    lost = sum(outcome.state == "no_solution" for outcome in checks)
    asked = [state for state in states if state.state != "not_asked"]
    return Tally(
        sum(n["fail"] for n in open_) + lost,
        sum(n["not_verified"] for n in open_),
        sum(n["warn"] for n in open_),
        sum(state.state == "ready" for state in asked),
        len(asked),
    )


def limits_hold(results: "Results") -> Text:
    """`31 limits hold; bearings not used`: how many were judged and hold, and the steps that were not asked."""
    held = plural("{n} limit holds", "{n} limits hold", n=results.counts.held)
    outcomes = results.outcomes
    unused = [Small(step.title) for step in STEPS if not step.optional and outcomes[step.key].state == "not_asked"]
    return Text("{held}; {steps} not used", held=held, steps=COMMA.join(unused)) if unused else held
