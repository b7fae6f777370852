# SPDX-License-Identifier: Apache-2.0
"""Solve a design: one page of explicit calls, read like a recipe.

The order of computing is not quite that of the screen: the journals carry the shaft's reactions, the train carries the journals'
loss, and only then is the torque known that loads the gears.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from math import pi
from typing import Any

from .bearings import solve as bearings
from .bearings.standing import with_standing as bearings_with_standing
from .countershaft import solve as countershaft
from .countershaft.standing import Drive, Gear, with_standing
from .design import STEPS, Design
from .engine import solve as engine
from .friction import train as friction
from .gears import solve as gears
from .gears.curves import curves
from .gears.result import TrainResult
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


def solve(design: Design, before: Results | None = None) -> Results:
    """All six steps of a design.  `before`: the results of an earlier version, of which unchanged parts are taken over."""
    part = _Parts(before)
    oils, materials = design.oils, design.materials

    e = part("engine", design.engine, engine.solve, design.engine, materials)
    i = part(
        "imbalance", design.imbalance, imbalance.solve, design.imbalance, design.engine, e.result, takes_first_order(design),
        shaft_teeth(design), shaft_axis(design), after=(e,),
    )  # fmt: skip
    first_speed = _first_speed(design)
    g = geometry = part("gears", design.gears, gears.geometry, design.gears, first_speed)
    omega = e.result.angular_speed if e.result else None
    slopes = design.bearings.slope if design.bearings else None
    gear = shaft_gear(design, geometry.result)
    c = part(
        "countershaft", design.countershaft, countershaft.solve, design.countershaft, i.result, omega, materials, journals(design), gear,
        slopes, after=(e, i),
    )  # fmt: skip
    if c.result is not None and design.imbalance is not None and takes_first_order(design):
        i = imbalance.with_shaft(i, c.result.force_vector, c.result.couple_vector, design.imbalance.crank_balance_fraction)
    b = part(
        "bearings", design.bearings, bearings.solve, design.bearings, c.result, design.engine, oils.get(_name(design.bearings, "oil")),
        materials.get(_name(design.bearings, "journal_material") or _name(design.countershaft, "material")),
        materials.get(_name(design.bearings, "housing_material")), after=_asked(e, i, c),
    )  # fmt: skip
    oil, law, temperature = _mesh_oil(design)
    f = part(
        "friction", design.friction, friction.solve, design.friction, design.gears, geometry.result, b.result, first_speed,
        oils.get(oil), law, temperature, materials, after=(g, b) if design.bearings else (g,),
    )  # fmt: skip
    if c.result is not None and design.countershaft is not None:
        c = with_standing(c, design.countershaft, gear, _shaft_drive(design, geometry.result, f))
        b = bearings_with_standing(b, c.result.standing)
    torque = _torque(design, geometry, f, first_speed)
    if torque is not None:
        rated = part("gears", design.gears, gears.rating, design.gears, geometry.result, torque, materials, after=(geometry,))
        g = gears.merge(g, rated) if rated.state == "solved" else rated
    if g.state == "solved" and c.result is not None:
        g = gears.with_residual_couple(g, c.result.couple)
    if g.state == "solved" and design.countershaft is not None:
        g = gears.with_speed_ratio(g, design.countershaft.speed_ratio)
    if g.state == "solved":
        g = replace(g, curves=curves(g.result))
    found = {outcome.key: outcome for outcome in (e, i, c, b, g, f)}
    return Results(design, found, part.now)


def _asked(*outcomes: Outcome) -> tuple[Outcome, ...]:
    """Those that a part may wait for: where a step is not asked, its inputs are given otherwise."""
    return tuple(outcome for outcome in outcomes if outcome.state != "not_asked")


def _first_speed(design: Design) -> float | None:
    """The speed of the train's first driver: given, or the crank's."""
    if design.gears is not None and design.gears.speed is not None:
        return design.gears.speed
    return design.engine.rated_speed if design.engine is not None else None


def takes_first_order(design: Design) -> bool:
    """Whether a shaft of the design turns at −1 times crank speed."""
    return design.countershaft is not None and design.countershaft.speed_ratio == -1


def shaft_teeth(design: Design) -> int | None:
    """The teeth of the wheel on the counter-shaft: the last of the train."""
    return design.gears.wheels[-1].teeth if design.countershaft is not None and design.gears is not None and design.gears.wheels else None


def shaft_axis(design: Design) -> complex | None:
    """Where the counter-shaft stands beside the crank: real up, imaginary 90° further in the sense of rotation."""
    place = design.countershaft.axis if design.countershaft is not None else None
    return complex(*place) if place is not None else None


def journals(design: Design) -> tuple[tuple[float, float], ...]:
    """Diameter and length of the shaft's journals, front to rear: its own, or those of the bearings; empty where they are not known."""
    if design.countershaft is not None and design.countershaft.journals:
        return tuple((j.diameter, j.length) for j in design.countershaft.journals)
    own = design.bearings
    return ((own.front.diameter, own.front.length), (own.rear.diameter, own.rear.length)) if own is not None else ()


def shaft_gear(design: Design, train: TrainResult | None) -> Gear | None:
    """The wheel on the counter-shaft: the last of the train."""
    if train is None or design.gears is None or design.countershaft is None:
        return None
    wheel = train.wheels[design.gears.wheels[-1].name]
    return Gear(wheel.pitch_diameter, wheel.tip_diameter, wheel.face_width, train.system.alpha_n, train.system.beta)


def _mesh_oil(design: Design) -> tuple[str, str, float | None]:
    """Name, viscosity law and temperature of the oil on the teeth: given, or that of the bearings."""
    own, there = design.friction, design.bearings
    oil = _name(own, "oil") or _name(there, "oil")
    law = there.viscosity_law if there is not None else "walther"
    given = own.oil_temperature if own is not None else None
    return oil, law, given if given is not None else there.supply_temperature if there is not None else None


def _torque(design: Design, geometry: Outcome, f: Outcome, first_speed: float | None) -> Any:
    """The torque that loads the teeth: of the given power, else of each mesh in the closed balance; None where neither is known."""
    if geometry.state != "solved" or design.gears is None or not first_speed:
        return None
    if design.gears.power is not None:
        return design.gears.power / (2 * pi * first_speed)
    if f.state != "solved":
        return None
    train = geometry.result
    return {key: mesh.power_in / (2 * pi * abs(train.wheels[train.meshes[key].driver].speed)) for key, mesh in f.result.meshes.items()}


def _shaft_drive(design: Design, train: TrainResult | None, f: Outcome) -> Drive | None:
    """What drives the shaft's gear: the given power, else what the last mesh passes on in the closed balance."""
    if train is None or design.gears is None:
        return None
    power = design.gears.power
    if power is None and f.state == "solved":
        power = list(f.result.meshes.values())[-1].power_out
    speed = abs(train.wheels[design.gears.wheels[-1].name].speed)
    return Drive(power, speed) if power is not None and speed else None


def _name(inputs: Any, attribute: str) -> str:
    """The name of an oil or material that a step asks for; empty where the step is not asked."""
    return getattr(inputs, attribute, None) or ""
