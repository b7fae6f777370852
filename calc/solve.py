# SPDX-License-Identifier: Apache-2.0
"""Solve a design: one page of explicit calls, read like a recipe.

The order of computing is not quite that of the screen: the journals carry the shaft's reactions, the train carries the journals'
loss, and only then is the torque known that loads the gears.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from .bearings import solve as bearings
from .countershaft import solve as countershaft
from .design import STEPS, Design
from .engine import solve as engine
from .imbalance import solve as imbalance
from .sheet.check import Check, worst
from .sheet.errors import NoSolution
from .sheet.quantity import Published
from .sheet.step import Outcome

TITLES = {step.key: step.title for step in STEPS}


@dataclass(frozen=True)
class Results:
    """What a design gives, step by step in the order of the screen."""

    design: Design
    outcomes: dict[str, Outcome]
    parts: dict[str, Any] = field(default_factory=dict, repr=False)  # for the next solve: what each part was asked, and said

    def values(self) -> dict[str, Published]:
        return {value.id: value for outcome in self.outcomes.values() for value in outcome.values()}

    def checks(self) -> Iterator[Check]:
        for outcome in self.outcomes.values():
            yield from outcome.checks

    @property
    def verdict(self) -> str:
        return worst([outcome.verdict for outcome in self.outcomes.values()])


class _Parts:
    """Calls the parts.  One whose arguments are what they were is taken over; one that waits for another is blocked."""

    def __init__(self, before: Results | None) -> None:
        self.before = before.parts if before else {}
        self.now: dict[str, Any] = {}

    def __call__(self, key: str, asked: Any, function: Callable[..., Outcome], *arguments: Any, after: tuple[Outcome, ...] = ()) -> Outcome:
        if asked is None:
            return Outcome(key, "not_asked")
        waiting = [TITLES[o.key] for o in after if o.state != "solved"]
        if waiting:
            return Outcome(key, "blocked", reason=f"waits for {' and '.join(waiting)}")
        name = f"{key}.{function.__name__}"
        known, said = self.before.get(name, (None, None))
        if known is None or not _same(known, arguments):
            try:
                said = function(*arguments)
            except NoSolution as none:
                said = Outcome(key, "no_solution", reason=str(none))
        self.now[name] = (arguments, said)
        return said  # type: ignore[no-any-return]


def _same(known: tuple[Any, ...], arguments: tuple[Any, ...]) -> bool:
    """Inputs are compared by value, results by identity (they hold arrays)."""
    try:
        return len(known) == len(arguments) and all(a is b or bool(a == b) for a, b in zip(known, arguments))
    except ValueError:
        return False


def solve(design: Design, before: Results | None = None) -> Results:
    """All six steps of a design.  `before`: the results of an earlier version, of which unchanged parts are taken over."""
    part = _Parts(before)
    oils, materials = design.oils, design.materials

    e = part("engine", design.engine, engine.solve, design.engine)
    i = part("imbalance", design.imbalance, imbalance.solve, design.imbalance, design.engine, e.result, after=(e,))
    omega = e.result.angular_speed if e.result else None
    c = part("countershaft", design.countershaft, countershaft.solve, design.countershaft, i.result, omega, after=(e, i))
    b = part(
        "bearings", design.bearings, bearings.solve, design.bearings, c.result, design.engine, oils.get(_name(design.bearings, "oil")),
        materials.get(_name(design.countershaft, "material")), materials.get(_name(design.bearings, "housing_material")), after=(e, i, c),
    )  # fmt: skip
    g = Outcome("gears", "not_asked")
    f = Outcome("friction", "not_asked")
    found = {outcome.key: outcome for outcome in (e, i, c, b, g, f)}
    return Results(design, found, part.now)


def _name(inputs: Any, attribute: str) -> str:
    """The name of an oil or material that a step asks for; empty where the step is not asked."""
    return getattr(inputs, attribute, None) or ""
