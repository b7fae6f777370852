# SPDX-License-Identifier: Apache-2.0
"""A counter-shaft that leaves too much or does not fit: its masses set to what the engine asks for, or a shaft of the sizing search."""

import cmath
import math
from collections.abc import Iterator

from ..countershaft.inputs import CountershaftInputs, EccentricMass
from ..countershaft.sizing.choices import asked, candidates, changes, choices, envelope
from ..countershaft.sizing.sectors import remainder
from ..sheet.check import Check
from ..sheet.errors import BadInput, NoSolution
from ..sheet.progress import Progress, part
from ..sheet.trace import untraced
from .bearings import mend as mend_bearings
from .state import State, first_good

LEFT = ("countershaft.residual", "countershaft.residual_force")
FIT = ("countershaft.envelope", "countershaft.envelope_length", "countershaft.crossing", "countershaft.mass_shape")
TRIED = 8  # shafts of the search, solved as whole designs
SAME = 0.01  # share of an unbalance: a mass that is right to this stays as it is


def leaves(check: Check) -> bool:
    return check.id in LEFT


def crosses(check: Check) -> bool:
    return check.id == "countershaft.crossing"


def fits(check: Check) -> bool:
    """Of the room, or of a step without solution, where there is no check at all."""
    return check.id in FIT


def balance(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Of the masses as few as will do, each by its mass, its angle or its radius alone where that is enough.  Raises NoSolution."""
    shaft = state.design.countershaft
    assert shaft is not None
    if shaft.mode != "given":
        raise NoSolution("the sized pair gives what is asked of it; look at overdesign_percent and the further elements")
    ways = list(_balanced(state, shaft))
    return first_good(state, "countershaft", [c.id for c in failing], ways, progress)


def _balanced(state: State, shaft: CountershaftInputs) -> Iterator[list[str]]:
    imbalance, engine = state.outcome("imbalance").result, state.outcome("engine").result
    if imbalance is None or engine is None:
        raise NoSolution("what the engine asks for is not known")
    with untraced():
        U, P, _ = asked(shaft, imbalance, engine.angular_speed)
        U, P = remainder(U, P, shaft.extras)
    now = [m.mass * m.radius * cmath.exp(1j * m.angle) for m in shaft.masses]
    for wanted in _wanted(shaft.masses, now, U, P):
        off = [n for n, (old, new) in enumerate(zip(now, wanted)) if abs(new - old) > SAME * max(abs(new), abs(old))]
        parts = [list(_single(shaft.masses[n], wanted[n])) for n in off]
        if len(parts) == 1:
            yield from parts[0][:2]  # by its mass alone, by its angle alone
        elif parts:
            yield [change for one in parts for change in one[0]]
            yield [change for one in parts for change in one[1]]
        yield [change for one in parts for change in one[2]]  # its mass and its angle
        yield [change for one in parts for change in one[3]]  # its radius and its angle


def _wanted(masses: tuple[EccentricMass, ...], now: list[complex], U: complex, P: complex) -> Iterator[list[complex]]:
    """Unbalances that leave nothing: of one mass, the others as they are; of the first and the last; of all, turned and scaled alike."""
    for n, mass in enumerate(masses):
        others = sum(u for i, u in enumerate(now) if i != n)
        one = U - others
        rest = sum(u * m.z for i, (u, m) in enumerate(zip(now, masses)) if i != n)
        if abs(P - rest - one * mass.z) <= SAME * abs(P):
            yield [one if i == n else u for i, u in enumerate(now)]
    first, last = masses[0], masses[-1]
    if last.z != first.z:
        inner = U - sum(now[1:-1]), P - sum(u * m.z for u, m in zip(now[1:-1], masses[1:-1]))
        rear = (inner[1] - inner[0] * first.z) / (last.z - first.z)
        yield [inner[0] - rear, *now[1:-1], rear]
    product = sum(u * m.z for u, m in zip(now, masses))
    if product and P:
        yield [u * P / product for u in now]


def _single(mass: EccentricMass, wanted: complex) -> Iterator[list[str]]:
    """By its mass; by its angle; by mass and angle; by radius and angle."""
    at = f"countershaft.masses.{mass.name}"
    turned = _near(math.degrees(cmath.phase(wanted)), math.degrees(mass.angle))
    angle = [f"{at}.angle_deg={round(turned, 1)!r}"] if abs(turned - math.degrees(mass.angle)) > 0.05 else []
    weight = [f"{at}.mass_kg={round(abs(wanted) / mass.radius, 3)!r}"] if mass.radius else []
    radius = [f"{at}.radius_mm={round(abs(wanted) / mass.mass * 1e3, 3)!r}"] if mass.mass else []
    yield weight
    yield angle
    yield weight + angle
    yield radius + angle


def _near(angle: float, old: float) -> float:
    """The same direction, less than half a turn from the old number of degrees."""
    return old + (angle - old + 180) % 360 - 180


def shorter_journals(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Journals that run into the sectors: bearings of the search, which fit."""
    if state.design.bearings is None:
        raise NoSolution("there are no bearings to shorten")
    made = mend_bearings(state, failing, progress)
    if any(crosses(c) for c in made.failing("countershaft")):
        raise NoSolution("no bearings that fit beside the sectors pass")
    return made


def resize(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """A shaft of the sizing search, the nearest in radius and of the same material first.  Raises NoSolution."""
    shaft, design = state.design.countershaft, state.design
    imbalance, engine = state.outcome("imbalance").result, state.outcome("engine").result
    if shaft is None or imbalance is None or engine is None:
        raise NoSolution("what the engine asks for is not known")
    try:
        room = envelope(shaft, design.bearings, state.document.place)
        materials = candidates(shaft, design.materials, state.document.place)
    except BadInput as bad:
        raise NoSolution(f"{bad.errors[0].key} {bad.errors[0].reason}") from None
    found = choices(shaft, imbalance, engine.angular_speed, room, materials, part(progress, 0.0, 0.3)).shafts
    R = shaft.outer_radius or room.outer_radius
    near = sorted(found, key=lambda one: (one.material != shaft.material, abs(one.sized.outer_radius - R)))
    ways = [changes(one, room) for one in near[:TRIED]]
    return first_good(state, "countershaft", [c.id for c in failing], ways, part(progress, 0.3, 1.0))
