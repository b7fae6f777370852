# SPDX-License-Identifier: Apache-2.0
"""Solve a design: one page of explicit calls, read like a recipe.

The order of computing is not quite that of the screen: the journals carry the shaft's reactions, the train carries the journals'
loss, and only then is the torque known that loads the gears.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from . import handing as h
from .bearings import solve as bearings
from .bearings.standing import with_standing as bearings_with_standing
from .countershaft import solve as countershaft
from .countershaft.standing import with_standing
from .design import STEPS, Design
from .engine import solve as engine
from .friction import solve as friction
from .gears import solve as gears
from .gears.curves import curves
from .imbalance import solve as imbalance
from .sheet.check import Check, worst
from .sheet.errors import Cancelled, NoSolution
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

    def whole(self) -> "Results":
        """The same with the curves, tables and notes that take longer than a keystroke may."""
        return replace(self, outcomes={key: outcome.whole for key, outcome in self.outcomes.items()})

    @property
    def verdict(self) -> str:
        return worst([outcome.verdict for outcome in self.outcomes.values()])


class _Parts:
    """Calls the parts.  One whose arguments are what they were is taken over; one that waits for another is blocked."""

    def __init__(self, before: Results | None, stop: Callable[[], bool]) -> None:
        self.before = before.parts if before else {}
        self.stop = stop
        self.now: dict[str, Any] = {}

    def __call__(self, key: str, asked: Any, function: Callable[..., Outcome], *arguments: Any, after: tuple[Outcome, ...] = ()) -> Outcome:
        if self.stop():
            raise Cancelled
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
            except (ArithmeticError, ValueError) as error:  # numbers that are allowed one by one, but not together
                said = Outcome(key, "no_solution", reason=f"the arithmetic breaks down ({error}); look for an extreme number")
        self.now[name] = (arguments, said)
        return said


def _same(known: tuple[Any, ...], arguments: tuple[Any, ...]) -> bool:
    """Inputs are compared by value, results by identity (they hold arrays)."""
    try:
        return len(known) == len(arguments) and all(a is b or bool(a == b) for a, b in zip(known, arguments))
    except ValueError:
        return False


def solve(design: Design, before: Results | None = None, stop: Callable[[], bool] = bool) -> Results:
    """All six steps of a design.  `before`: the results of an earlier version, of which unchanged parts are taken over.

    `stop` is asked between the parts whether nobody waits for the results any more; then Cancelled is raised.
    """
    part = _Parts(before, stop)
    oils, materials = design.oils, design.materials

    e = part("engine", design.engine, engine.solve, design.engine, materials)
    i = part(
        "imbalance", design.imbalance, imbalance.solve, design.imbalance, design.engine, e.result, h.takes_first_order(design),
        h.shaft_teeth(design), h.shaft_axis(design), after=(e,),
    )  # fmt: skip
    first_speed = h.first_speed(design)
    g = geometry = part("gears", design.gears, gears.geometry, design.gears, first_speed)
    omega = e.result.angular_speed if e.result else None
    slopes = design.bearings.slope if design.bearings else None
    gear = h.shaft_gear(design, geometry.result)
    c = part(
        "countershaft", design.countershaft, countershaft.solve, design.countershaft, i.result, omega, materials, h.journals(design), gear,
        slopes, after=(e, i),
    )  # fmt: skip
    if c.result is not None and design.imbalance is not None and h.takes_first_order(design):
        i = imbalance.with_shaft(i, c.result.force_vector, c.result.couple_vector, design.imbalance.crank_balance_fraction)
    b = part(
        "bearings", design.bearings, bearings.solve, design.bearings, c.result, design.engine, oils.get(h.name_of(design.bearings, "oil")),
        materials.get(h.name_of(design.bearings, "journal_material") or h.name_of(design.countershaft, "material")),
        materials.get(h.name_of(design.bearings, "housing_material")), after=_asked(e, i, c),
    )  # fmt: skip
    if g.state == "solved" and design.gears is not None:
        g = _placed(part, g, design, c)
    oil, law, temperature = h.mesh_oil(design)
    f = part(
        "friction", design.friction, friction.solve, design.friction, design.gears, g.result, h.on_shaft(design, c, b, gear), first_speed,
        oils.get(oil), law, temperature, materials, oils, after=(g, b) if design.bearings else (g,),
    )  # fmt: skip
    if c.result is not None and design.countershaft is not None:
        c = with_standing(c, design.countershaft, gear, h.shaft_drive(design, geometry.result, f))
        b = bearings_with_standing(b, c.result.standing)
    if g.state == "solved" and design.gears is not None:
        g = _rated(part, g, design, (e, c, f), first_speed)
    if g.state == "solved" and c.result is not None:
        g = gears.with_residual_couple(g, c.result.couple)
    if g.state == "solved" and design.countershaft is not None:
        g = gears.with_speed_ratio(g, design.countershaft.speed_ratio, design.engine.rated_speed if design.engine else first_speed)
    if g.state == "solved":
        g = replace(g, curves=g.curves + curves(g.result))
    found = {outcome.key: outcome for outcome in (e, i, c, b, g, f)}
    return Results(design, found, part.now)


def _placed(part: _Parts, g: Outcome, design: Design, c: Outcome) -> Outcome:
    """A train whose geometry is known: its play and its place.  What finds no solution fails, the rest stays."""
    assert design.gears is not None
    own = design.gears
    played = part("gears", own, gears.with_play, g, own, design.materials, h.housing(design))
    g = played if played.state == "solved" else gears.without(g, "backlash over parts and temperature", played.reason)
    couple = c.result.couple if c.result else None
    placed = part(
        "gears", own, gears.with_layout, g, own, h.shaft_axis(design), h.eccentric(design), h.ends(h.journals(design)),
        h.gear_end(design, c), couple,
    )  # fmt: skip
    return placed if placed.state == "solved" else gears.without(g, "layout of the train", placed.reason)


def _rated(part: _Parts, g: Outcome, design: Design, steps: tuple[Outcome, Outcome, Outcome], first_speed: float | None) -> Outcome:
    """Its rating and its forces, once the closed balance has the power of every mesh."""
    assert design.gears is not None
    own, (e, c, f) = design.gears, steps
    power = h.power(design, g, f, first_speed)
    if power is None:
        missing = (
            f"Not rated: {TITLES['friction']} gives no power: {f.reason}." if f.state in ("no_solution", "blocked") else gears.NOT_RATED
        )
        return replace(g, notes=(*g.notes, missing))
    rated = part("gears", own, gears.rating, own, g.result, power, design.materials, h.around_gears(design, e, c))
    if rated.state != "solved":
        return gears.without(g, "rating of the teeth", rated.reason)
    return gears.with_forces(gears.merge(g, rated), own)


def _asked(*outcomes: Outcome) -> tuple[Outcome, ...]:
    """Those that a part may wait for: where a step is not asked, its inputs are given otherwise."""
    return tuple(outcome for outcome in outcomes if outcome.state != "not_asked")
