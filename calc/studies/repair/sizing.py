# SPDX-License-Identifier: Apache-2.0
"""A counter-shaft that leaves too much or does not fit: its masses set to what the engine asks for, or a shaft of the sizing search."""

import cmath
import math
from collections.abc import Iterator

from ...countershaft.inputs import CountershaftInputs, EccentricMass
from ...countershaft.sizing.choices import asked, candidates, changes, choices, envelope
from ...countershaft.sizing.sectors import TooSmall, remainder
from ...countershaft.task import Task, task
from ...engine.result import EngineResult
from ...imbalance.result import ImbalanceResult
from ...sheet.changes import Changes
from ...sheet.check import Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, part
from ...sheet.text import Text
from ...sheet.trace import untraced
from ...repair import bearings
from .state import State, first_repaired

TRIED = 8  # shafts of the search, solved as whole designs
SAME = 0.01  # share of an unbalance: a mass that is right to this stays as it is
NEAR = 0.1  # of the couple: what a single mass may miss to be tried alone
SHARES = (1.0, 0.97)  # of what is asked for: all of it, or where there is no room for it what just passes
TENTH = 1e-4  # m, to which a radius or a length that is needed is rounded up
UNKNOWN = Text("what the engine asks for is not known")


def balance(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Of the masses as few as will do, each by its mass, its angle or its radius alone where that is enough.  Raises NoSolution."""
    shaft = state.design.countershaft
    assert shaft is not None
    imbalance = state.results.result(ImbalanceResult)
    if imbalance is not None and shaft.pair != "yes" and _out_of_reach(failing, task(shaft, imbalance)):
        raise NoSolution(Text("what turns against the shaft is more than may be left, and no mass on it takes that"))
    if shaft.mode != "given":
        raise NoSolution(Text("the sized pair gives what is asked of it; look at overdesign_percent and the further elements"))
    return first_repaired(state, "countershaft", [c.id for c in failing], balanced(state, shaft), progress, whole=True)


def _out_of_reach(failing: tuple[Check, ...], todo: Task) -> bool:
    words = {"countershaft.residual": "couple", "countershaft.residual_force": "force"}
    return any(words.get(c.id) in todo.out_of_reach for c in failing)


def balanced(state: State, shaft: CountershaftInputs) -> Iterator[Changes]:
    """Masses that give what the engine asks for, the fewest changes first.  Raises NoSolution where that is not known."""
    imbalance, engine = state.results.result(ImbalanceResult), state.results.result(EngineResult)
    if imbalance is None or engine is None:
        raise NoSolution(UNKNOWN)
    with untraced():
        U, P, _ = asked(shaft, imbalance, engine.angular_speed)
        U, P = remainder(U, P, shaft.extras)
    now = [m.mass * m.radius * cmath.exp(1j * m.angle) for m in shaft.masses]
    for share in SHARES:
        yield from _ways(shaft.masses, now, share * U, share * P)


def _ways(masses: tuple[EccentricMass, ...], now: list[complex], U: complex, P: complex) -> Iterator[Changes]:
    yield from _shifted(masses, now, U, P)
    for wanted in _wanted(masses, now, U, P):
        off = [n for n, (old, new) in enumerate(zip(now, wanted)) if abs(new - old) > SAME * max(abs(new), abs(old))]
        for ways in zip(*(_single(masses[n], wanted[n]) for n in off)):
            yield {key: number for way in ways for key, number in way.items()}


def _shifted(masses: tuple[EccentricMass, ...], now: list[complex], U: complex, P: complex) -> Iterator[Changes]:
    """One mass moved along the shaft, where the force is right already."""
    if abs(sum(now) - U) > NEAR * max(map(abs, now), default=0.0):
        return
    for n, mass in enumerate(masses):
        rest = sum(u * m.z for i, (u, m) in enumerate(zip(now, masses)) if i != n)
        if now[n] and abs((z := (P - rest) / now[n]).imag) < NEAR * abs(z):
            yield {f"countershaft.masses.{mass.name}.z_mm": round(z.real * 1e3, 1)}


def _wanted(masses: tuple[EccentricMass, ...], now: list[complex], U: complex, P: complex) -> Iterator[list[complex]]:
    """Unbalances that leave nothing: of one mass, the others as they are; of the first and the last; of all, turned and scaled alike."""
    for n, mass in enumerate(masses):
        others = sum(u for i, u in enumerate(now) if i != n)
        one = U - others
        rest = sum(u * m.z for i, (u, m) in enumerate(zip(now, masses)) if i != n)
        if abs(P - rest - one * mass.z) <= NEAR * abs(P):
            yield [one if i == n else u for i, u in enumerate(now)]
    first, last = masses[0], masses[-1]
    if last.z != first.z:
        inner = U - sum(now[1:-1]), P - sum(u * m.z for u, m in zip(now[1:-1], masses[1:-1]))
        rear = (inner[1] - inner[0] * first.z) / (last.z - first.z)
        yield [inner[0] - rear, *now[1:-1], rear]
    product = sum(u * m.z for u, m in zip(now, masses))
    if product and P:
        yield [u * P / product for u in now]


def _single(mass: EccentricMass, wanted: complex) -> Iterator[Changes]:
    """By its mass; by its angle; by mass and angle; by radius and angle."""
    at = f"countershaft.masses.{mass.name}"
    turned = _near(math.degrees(cmath.phase(wanted)), math.degrees(mass.angle))
    angle = {f"{at}.angle_deg": round(turned, 1)} if abs(turned - math.degrees(mass.angle)) > 0.05 else {}
    weight = {f"{at}.mass_kg": round(abs(wanted) / mass.radius, 3)} if mass.radius else {}
    radius = {f"{at}.radius_mm": round(abs(wanted) / mass.mass * 1e3, 3)} if mass.mass else {}
    yield weight
    yield angle
    yield weight | angle
    yield radius | angle


def _near(angle: float, old: float) -> float:
    """The same direction, less than half a turn from the old number of degrees."""
    return old + (angle - old + 180) % 360 - 180


def shorter_journals(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Journals that run into the sectors: bearings of the search, which fit."""
    if state.design.bearings is None:
        raise NoSolution(Text("there are no bearings to shorten"))
    made = bearings.repair(state, failing, progress)
    if any(c.id in {one.id for one in failing} for c in made.failing("countershaft")):
        raise NoSolution(Text("no bearings that fit beside the sectors pass"))
    return made


def resize(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """A shaft of the sizing search, the nearest in radius and of the same material first.  Raises NoSolution."""
    shaft, design = state.design.countershaft, state.design
    imbalance, engine = state.results.result(ImbalanceResult), state.results.result(EngineResult)
    if shaft is None or imbalance is None or engine is None:
        raise NoSolution(UNKNOWN)
    try:
        room = envelope(shaft, design.bearings, state.document.place)
        materials = candidates(shaft, design.materials, state.document.place)
    except BadInput as bad:
        raise NoSolution(Text("{key} {reason}", key=bad.errors[0].key, reason=bad.errors[0].reason)) from None
    ids = [c.id for c in failing]
    try:
        choices(shaft, imbalance, engine.angular_speed, room, {shaft.material: materials[shaft.material]})
    except TooSmall as small:
        larger = (("outer_radius", small.outer_radius), ("half_length", small.half_length))
        sizes = ({f"countershaft.{name}_mm": math.ceil(x / TENTH) / 10} for name, x in larger if x is not None)
        try:
            return first_repaired(state, "countershaft", ids, sizes, part(progress, 0.0, 0.2))
        except NoSolution:
            pass
    shafts = choices(shaft, imbalance, engine.angular_speed, room, materials, part(progress, 0.2, 0.3)).shafts
    R = shaft.outer_radius or room.outer_radius
    near = sorted(shafts, key=lambda one: (one.material != shaft.material, abs(one.sized.outer_radius - R)))
    ways = (changes(one, room) for one in near)
    return first_repaired(state, "countershaft", ids, ways, part(progress, 0.3, 1.0), most=TRIED)
