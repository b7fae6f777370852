# SPDX-License-Identifier: Apache-2.0
"""Calls the parts of a solve, and takes over from an earlier solve those whose arguments have not changed."""

from collections.abc import Callable, Mapping
from copy import copy
from typing import Never, ParamSpec, TypeVar, cast

import numpy as np

from .errors import Cancelled, NoSolution
from .progress import go_on
from .step import Outcome, beside, joined
from .text import EMPTY, Text

P = ParamSpec("P")
R = TypeVar("R")
# the arguments of a part, its outcome, and whether other methods stand in it beside those that judge
Kept = tuple[tuple[object, ...], Outcome[object], bool]


class Enough(Exception):
    """What is wanted of a design is known."""


class Parts:
    """`part("engine", engine.solve, …)` calls `engine.solve(…)`; the type checker holds the arguments against its
    signature.

    `titles`: of the steps by key, in their order; `before`: what an earlier solve kept; `left_out`: the steps that the
    design does without, each with its reason; `named`: the ids of what belongs to one shaft have its name; `stop` is
    asked before each part whether nobody waits for the results any more, then Cancelled is raised; `enough` after each
    part whether what there is of its step decides all that is asked."""

    def __init__(
        self,
        titles: Mapping[str, Text],
        before: Mapping[str, Kept],
        left_out: Mapping[str, str],
        *,
        named: bool = False,
        stop: Callable[[], bool],
        enough: Callable[[Outcome[object]], bool] | None,
    ) -> None:
        self.titles, self.before, self.left_out, self.stop, self.enough = titles, before, left_out, stop, enough
        self.named = named
        self.name = ""  # of the shaft whose parts are called
        self.kept: dict[str, Kept] = {}
        self.last: dict[tuple[str, str], Outcome[object]] = {}  # by step and shaft

    def of(self, name: str) -> "Parts":
        """The same for the parts of one shaft, by its name."""
        of_shaft = copy(self)  # what is kept they have together
        of_shaft.name = name
        return of_shaft

    def __call__(self, key: str, function: Callable[P, Outcome[R]], /, *args: P.args, **kwargs: P.kwargs) -> Outcome[R]:
        """The outcome of a part of the step `key`; where it finds no solution, or its arithmetic breaks down, an
        outcome that says so."""
        go_on()
        if self.stop():
            raise Cancelled
        compared = bool(kwargs.get("compared"))
        name = f"{key}.{self.name}.{function.__name__}"
        arguments = (*args, *(value for word, value in kwargs.items() if word != "compared"))
        known, kept, others = self.before.get(name, (None, None, False))
        outcome: Outcome[R]
        if known is not None and others >= compared and _same(known, arguments):
            outcome = cast("Outcome[R]", kept)  # of the same function: parts are kept by its name
        else:
            try:
                outcome = function(*args, **kwargs)
            except NoSolution as none:
                outcome = Outcome(key, "no_solution", reason=none.text)
            except (ArithmeticError, ValueError) as error:  # numbers that are allowed one by one, but not together
                reason = Text("the arithmetic breaks down ({error}); look for an extreme number", error=error)
                outcome = Outcome(key, "no_solution", reason=reason)
            others = compared
        self.kept[name], self.last[key, self.name] = (arguments, outcome, others), outcome
        if self.enough is not None and self.enough(self._so_far(key)):
            raise Enough
        return outcome

    def _joined(self, key: str, outcomes: Mapping[str, Outcome[object]]) -> Outcome[object]:
        return joined(key, outcomes, None, named=self.named and "" not in outcomes)

    @property
    def outcomes(self) -> dict[str, Outcome[object]]:
        """The last outcome of each step so far; of several shafts joined."""
        return {key: self._so_far(key) for key in dict.fromkeys(key for key, _ in self.last)}

    def _so_far(self, key: str) -> Outcome[object]:
        of_shafts = {name: outcome for (step, name), outcome in self.last.items() if step == key}
        sums = of_shafts.pop("", None)
        if not of_shafts and sums is not None:
            return sums
        shafts: Outcome[object] = joined(key, of_shafts, None, named=self.named)
        return shafts if sums is None else beside(sums, shafts)

    @property
    def of_shafts(self) -> dict[str, dict[str, Outcome[object]]]:
        """The last outcomes of each shaft so far, by its name and the step."""
        done: dict[str, dict[str, Outcome[object]]] = {}
        for (key, name), outcome in self.last.items():
            if name:
                done.setdefault(name, {})[key] = outcome
        return done

    def absent(self, key: str, inputs: object, after: tuple[Outcome[object], ...]) -> Outcome[Never]:
        """The outcome of a step that is not called: not asked where it has no inputs, else blocked by those of `after`
        without result."""
        if inputs is None:
            reason = self.left_out.get(key)
            return Outcome(key, "not_asked", reason=Text("left out: {reason}", reason=reason) if reason else EMPTY)
        late = {outcome.key: outcome.state for outcome in after if outcome.state != "solved"}
        waiting = [
            Text("{step} (not given: add the table [{key}])", step=title, key=other)
            if late[other] == "not_asked"
            else title
            for other, title in self.titles.items()
            if other in late
        ]
        return Outcome(key, "blocked", reason=Text("waits for {waiting}", waiting=Text(" and ").join(waiting)))


def _same(known: tuple[object, ...], arguments: tuple[object, ...]) -> bool:
    """Inputs are compared by value, results by identity (they hold arrays), records that are put together for a call
    part by part."""
    try:
        return len(known) == len(arguments) and all(
            a is b or bool(a == b) or alike(a, b) for a, b in zip(known, arguments)
        )
    except ValueError:
        return False


def alike(a: object, b: object) -> bool:
    """Two records of the same parts.  A number is the same where its line is: nothing that is kept leads back to lines
    of before."""
    if a is b:
        return True
    if type(a) is not type(b) or callable(a) or getattr(a, "link", None) != getattr(b, "link", None):
        return False
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
        return np.array_equal(a, b)
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(alike(part, b[key]) for key, part in a.items())
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(alike(element, other) for element, other in zip(a, b))
    if type(a).__eq__ is object.__eq__:
        return hasattr(a, "__dict__") and alike(vars(a), vars(b))
    return bool(a == b)
