# SPDX-License-Identifier: Apache-2.0
"""How far a design is: the state of each step, whether the whole is ready, and what was left out by whom."""

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING

from ..design.addresses import Table, as_table, asks, step_at
from ..design.model import STEPS
from ..library.table_file import parsed, text_of_table
from ..sheet.record import record
from ..sheet.step import Outcome, Step
from ..sheet.text import COMMA, EMPTY, SEMICOLON, Small, Text, plural

if TYPE_CHECKING:
    from ..solve import Results

# --- the state of each step

SOLVED = ("fail", "not_verified", "not_judged", "computed", "warn", "pass")
LEFT = ("todo", "needs", "waits", "blocked", "no_solution", "fail", "not_verified")  # while one is, nothing is ready


@record
class StepState:
    """`state`: todo, needs (inputs), waits (for the solver), or a state of calc/sheet/verdict.py, whose words it has.

    `colour`: the state whose colour it has."""

    key: str
    state: str
    words: Text
    colour: str

    @property
    def done(self) -> bool:
        """Whether it keeps nothing from being ready; cautions may be open."""
        return self.state not in LEFT


def readiness(data: Table, results: "Results | None", wrong: Iterable[str] = ()) -> tuple[StepState, ...]:
    """The state of every step.  `data`: the tables of the design; `wrong`: keys of inputs that are missing or not
    understood.

    Those of the design itself, of its name or of what is measured, count with the first step, in which they are asked.
    """
    owners = [step_at(data, key) for key in wrong]
    owners = [key if any(key == step.key for step in STEPS) else STEPS[0].key for key in owners]
    outcomes: Mapping[str, Outcome[object]] = results.outcomes if results is not None else {}
    return tuple(_state(step, data, owners.count(step.key), outcomes.get(step.key)) for step in STEPS)


def _state(step: Step, data: Table, wrong: int, outcome: Outcome[object] | None) -> StepState:
    def state(name: str, words: Text) -> StepState:
        return StepState(step.key, name, words, name)

    without = as_table(data.get("without"))
    if wrong:
        return state("needs", plural("needs {n} input", "needs {n} inputs", n=wrong))
    if step.key in without:
        reason = str(without[step.key])
        left_out = Text("left out by the program: {reason}", reason=reason)
        return state("not_asked", left_out if by_program(reason) else Text("left out: {reason}", reason=reason))
    if not asks(data, step.key):
        todo = "engine" in data and not step.optional
        return state("todo", Text("to do")) if todo else state("not_asked", Text("not used"))
    if outcome is None or outcome.state == "not_asked":
        return state("waits", Text("solving …"))
    if outcome.state == "blocked":
        return state("blocked", outcome.reason)
    return StepState(step.key, outcome.verdict, outcome.words(), outcome.colour)


# --- whether the whole is ready


@record
class Readiness:
    """`state`: the sign and colour that it has; `words`: what is left, or what was judged and what was not used, beside
    the state of the design."""

    ready: bool
    state: str
    words: Text


def whole(states: Sequence[StepState], results: "Results | None") -> Readiness:
    """A design is ready where its limits were judged and hold, nothing is to do, and nothing is left out that no person
    has left out.  `states`: of its steps, with these results."""
    if left := sum(not state.done for state in states) or results is None:
        return Readiness(False, "todo", plural("{n} step left", "{n} steps left", n=left))
    if words := _by_program(results):
        return Readiness(False, "todo", words)
    if results.verdict not in ("pass", "warn"):
        return Readiness(False, results.verdict, Text("no limit judges it"))
    return Readiness(True, results.verdict, limits_hold(results))


def limits_hold(results: "Results") -> Text:
    """`31 limits hold; left out by you: bearings; not used: friction`: how many were judged and hold, and the steps in
    which nothing was."""
    design = results.design
    reasons = dict(design.without)
    by_you = _titles(step for step, reason in reasons.items() if not by_program(reason))
    program = _by_program(results)
    unused = _titles(s.key for s in STEPS if not (s.optional or s in design.asked() or s.key in reasons))
    held = plural("{n} limit holds", "{n} limits hold", n=results.counts.held)
    parts = [held if results.counts.limits else Text("no limit is judged")]
    parts += [Text("left out by you: {steps}", steps=by_you)] if by_you else []
    parts += [program] if program else []
    parts += [Text("not used: {steps}", steps=unused)] if unused else []
    return SEMICOLON.join(parts)


def _by_program(results: "Results") -> Text:
    """What the rules of this program have left out; whether the engine has changed since, and would have it now."""
    from ..imbalance.checks import BACKWARD_COUPLE, BACKWARD_FORCE  # here: the session begins without numpy

    left_out = dict(results.design.without)
    steps = _titles(step for step, reason in left_out.items() if by_program(reason))
    backward = (BACKWARD_COUPLE.id, BACKWARD_FORCE.id)
    none_needed = not {NOTHING, *reasons()}.isdisjoint(left_out.values())
    if none_needed and any(c.id in backward and c.open for c in results.checks()):
        return Text("left out by the program: {steps}, but of order 1 something turns backward now", steps=steps)
    return Text("left out by the program: {steps}", steps=steps) if steps else EMPTY


def _titles(keys: Iterable[str]) -> Text:
    wanted = set(keys)
    return COMMA.join(Small(step.title) for step in STEPS if step.key in wanted)


# --- what the rules behind `new` leave out, and why
# Known by their words, which stand in the design file as a person's would.

NO_BEARINGS = "no bearings were found that keep every limit, neither plain nor rolling ones"
NO_PLAIN = (  # as versions wrote it that knew plain ones alone
    "rolling bearings carry the shaft: no plain ones were found that keep every limit at every corner of their "
    "tolerances"
)
NO_TRAIN = "no train of usual wheels was found that keeps every limit"
NONE = "no shaft: what shakes is left to the mounts"
NOTHING = "nothing of order 1 turns backward, so no shaft at -1 is needed"
CRANK_ALONE = "no shaft: the counterweights of the crank are all the balancing"
OF_PROGRAM = (NO_BEARINGS, NO_PLAIN, NO_TRAIN, NONE, NOTHING, CRANK_ALONE)


@cache
def reasons() -> tuple[str, ...]:
    """Why engines that are built without a shaft have none, as their designs say it."""
    rows = parsed("engines.toml", text_of_table("engines.toml")).values()
    return tuple(row["arrangement"]["without"] for row in rows if "without" in row.get("arrangement", {}))


def by_program(reason: str) -> bool:
    """Whether a reason is one of those that `new` writes."""
    return reason in OF_PROGRAM or reason in reasons()
