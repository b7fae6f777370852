# SPDX-License-Identifier: Apache-2.0
"""Parts that are to be sized anew: other bearings, masses that balance, a smaller shaft, stronger teeth.

A counter-shaft that leaves too much or does not fit: its masses are set to what the engine asks for, or a shaft of the
sizing search is taken."""

import cmath
import math
from collections.abc import Iterator
from itertools import chain

from ...bearings.choice import nearest_changes
from ...bearings.inputs import BearingsInputs
from ...bearings.plain.selection.search import nearest_row
from ...bearings.plain.selection.variants import with_own_oil
from ...bearings.plain.selection.writing import bearing_changes
from ...countershaft.inputs import EccentricMass, ShaftInputs
from ...countershaft.left_over import RESIDUAL, RESIDUAL_FORCE
from ...countershaft.rows import BearingRow, called
from ...countershaft.shafts import ShaftsResult
from ...countershaft.sizing.choices import asked, candidates, changes, choices, envelope
from ...countershaft.sizing.sectors import ShaftTask, TooSmall, remainder, task
from ...design.locks import locked
from ...design.model import Design
from ...design.names import named
from ...design.step_inputs import bearings_case, given_beside, rolling_places, sized_alike
from ...engine.result import EngineResult
from ...gears.inputs import GearsInputs, wheel_key
from ...gears.rating.classes import DEFAULT, class_names, strength_class
from ...gears.wheel_inputs import Wheel
from ...imbalance.result import ImbalanceResult
from ...sheet.check import Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, part, tell
from ...sheet.quantity import dotted
from ...sheet.remedy import Changes, whole
from ...sheet.search import Budget, least_whole
from ...sheet.text import Text
from ...sheet.value import untraced
from ...solve import Results, solve
from .levers import levers
from .state import RepairState, broken, first_repaired, repaired
from .trials import ROUND, Trials

# --- bearings that fail: the nearest ones of the search that `choose` offers

TRIES = 100  # designs with longer journals


def nearest_bearings(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Lengths, clearances, oil and supply, and where these do not help surfaces, diameters and fits; of the shaft whose
    checks fail, or of each whose bearings have no solution.  Raises NoSolution."""
    lost = [name for name, view in state.results.views.items() if view.outcomes["bearings"].state == "no_solution"]
    names = dict.fromkeys(state.view(check.id).own_name for check in failing) or lost
    for name in names:
        case = bearings_case(state.design, solve, state.results, name)
        if locked(state.document.data, dotted(Design.bearings, BearingsInputs.oil)):
            case = with_own_oil(case)
        settled = nearest_row(case, progress)
        written = bearing_changes(settled.row, case) if settled.row is not None else {}
        if not written:
            raise NoSolution(Text("the search for bearings finds nothing to change: it keeps every rule that it knows"))
        state = state.with_changes(written, settled.results if isinstance(settled.results, Results) else None)
    return state


def bearings_or_longer_journals(
    state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None
) -> RepairState:
    """Rolling bearings that sit otherwise or are of another size; of plain ones the nearest that fit, else journals as
    long as their films ask for.  Raises NoSolution where none of it helps."""
    for own in of_rolling(state, failing):
        state = first_repaired(state, "bearings", [c.id for c in own], rolling_ways(state, own), progress)
        failing = tuple(c for c in failing if c not in own)
    if not failing:
        return state
    try:
        return nearest_bearings(state, failing, part(progress, 0.0, 0.5))
    except NoSolution as none:
        try:
            return longer_journals(state, failing, part(progress, 0.5, 1.0))
        except NoSolution:
            raise none from None


def of_rolling(state: RepairState, checks: tuple[Check, ...]) -> list[tuple[Check, ...]]:
    """Those of each bearing that needs no pressure oil."""
    groups: dict[str, list[Check]] = {}
    for check in checks:
        row = _row_of(state, check)
        if row is not None and not row.fed():
            groups.setdefault(check.id.rpartition(".")[0], []).append(check)
    return [tuple(group) for group in groups.values()]


def _row_of(state: RepairState, check: Check) -> BearingRow | None:
    """The bearing that a check is of; None: of none."""
    view = state.view(check.id)
    prefix = f"{state.design.ids_of('bearings', view.own_name)}."
    place = state.design.of_original(check.id).removeprefix(prefix).partition(".")[0]
    return next((row for row in view.rows if row.name == place), None)


def rolling_ways(state: RepairState, own: tuple[Check, ...]) -> Iterator[Changes]:
    """How the rolling bearing of these checks could sit, and what other sizes could stand there; its size first, then
    how it sits."""
    row, name = _row_of(state, own[0]), state.view(own[0].id).own_name
    if row is None:
        return
    case = bearings_case(state.design, solve, state.results, name)
    try:
        place = rolling_places(state.design, state.results, name)[row.name]
    except NoSolution:
        return
    for way in nearest_changes(case, place):
        yield dict(sorted(way.items(), key=lambda change: not change[0].endswith(SIZE)))


SIZE = f".{dotted(BearingRow.size)}"


def longer_journals(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Journals as much longer as their films ask for, outwards where the masses leave no room.  Raises NoSolution."""
    view = state.view(failing[0].id) if failing else state.design
    for n, row in enumerate(rows := view.rows):
        key = view.own_key(ShaftInputs.bearings, row.name, BearingRow.length)
        mine = f"{state.design.ids_of('bearings', view.own_name)}.{row.name}"
        group = tuple(c for c in failing if c.id.rpartition(".")[0] == mine)
        if not group or not row.fed():
            continue
        here = part(progress, n / len(rows), (n + 1) / len(rows))
        trials = Trials(state, "bearings", group, Budget(TRIES), here, named(state.document, key), near=ROUND)
        longer = next(filter(None, map(trials.least, levers(state, [key]))), None)
        if longer is None:
            raise NoSolution(Text("no longer journal is enough, {place}", place=called(row.name)))
        state = longer[1]
    return state


# --- a counter-shaft that leaves too much or does not fit

TRIED = 8  # shafts of the search, solved as whole designs
SAME = 0.01  # share of an unbalance: a mass that is right to this stays as it is
NEAR = 0.1  # of the couple: what a single mass may miss to be tried alone
SHARES = (1.0, 0.97)  # of what is asked for: all of it, or where there is no room for it what just passes
TENTH = 1e-4  # m, to which a radius or a length that is needed is rounded up
UNKNOWN = Text("what the engine asks for is not known")


def balance(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Of the masses of one shaft as few as will do, each by its mass, its angle or its radius alone where that is
    enough.  Raises NoSolution."""
    shafts = [view.countershaft for view in state.design.views.values() if view.countershaft is not None]
    imbalance = state.results.result(ImbalanceResult)
    alone = len(state.design.shafts) == 1
    if imbalance is not None and alone and _out_of_reach(failing, task(shafts[0].speed_ratio, imbalance)):
        raise NoSolution(Text("what turns against the shaft is more than may be left, and no mass on it takes that"))
    given = [shaft for shaft in shafts if shaft.mode == "given"]
    if not given:
        raise NoSolution(
            Text("the sized pair gives what is asked of it; look at overdesign_percent and the further elements")
        )
    ways = chain.from_iterable(balanced(state, shaft) for shaft in given)
    return first_repaired(state, "countershaft", [c.id for c in failing], ways, progress, whole=True)


def _out_of_reach(failing: tuple[Check, ...], todo: ShaftTask) -> bool:
    words = {RESIDUAL.id: "couple", RESIDUAL_FORCE.id: "force"}
    return any(words.get(c.id) in todo.out_of_reach for c in failing)


def balanced(state: RepairState, shaft: ShaftInputs) -> Iterator[Changes]:
    """Masses of a shaft that give what the engine asks for, the fewest changes first; beside others what all of them
    leave.  Raises NoSolution where that is not known."""
    imbalance, engine = state.results.result(ImbalanceResult), state.results.result(EngineResult)
    if imbalance is None or engine is None:
        raise NoSolution(UNKNOWN)
    now = [m.mass * m.radius * cmath.exp(1j * m.angle) for m in shaft.masses]
    if len(state.design.shafts) > 1:
        U, P = _beside_others(state, shaft, now, engine.angular_speed)
    else:
        with untraced():
            U, P, _ = asked(shaft, imbalance, engine.angular_speed)
            U, P = remainder(U, P, shaft.extras)
    for share in SHARES:
        for way in _ways(shaft.masses, now, share * U, share * P):
            yield {dotted(Design.shafts, shaft.name, ShaftInputs.masses, key): x for key, x in way.items()}


def _beside_others(state: RepairState, shaft: ShaftInputs, now: list[complex], omega: float) -> tuple[complex, complex]:
    """What its masses must give to take what all shafts leave of what turns like it; those that repeat it take as
    much."""
    every = state.results.result(ShaftsResult)
    if every is None:
        raise NoSolution(UNKNOWN)
    left, order = every.sums.vectors, round(abs(shaft.speed_ratio))
    turns = 0 if shaft.speed_ratio > 0 else 1
    alike = 1 + sum(other.repeats == shaft.name for other in state.design.shafts)
    each = alike * (shaft.speed_ratio * omega) ** 2
    U, P = sum(now), sum(u * mass.z for u, mass in zip(now, shaft.masses))
    return U - complex(left[order].forces[turns]) / each, P - complex(left[order].couples[turns]) / each


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
            yield {_of_mass(mass, EccentricMass.z): round(z.real * 1e3, 1)}


def _wanted(masses: tuple[EccentricMass, ...], now: list[complex], U: complex, P: complex) -> Iterator[list[complex]]:
    """Unbalances that leave nothing: of one mass, the others as they are; of the first and the last; of all, turned and
    scaled alike."""
    for n, mass in enumerate(masses):
        others = sum(u for i, u in enumerate(now) if i != n)
        unbalance = U - others
        rest = sum(u * m.z for i, (u, m) in enumerate(zip(now, masses)) if i != n)
        if abs(P - rest - unbalance * mass.z) <= NEAR * abs(P):
            yield [unbalance if i == n else u for i, u in enumerate(now)]
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
    now, turned = math.degrees(mass.angle), _near(math.degrees(cmath.phase(wanted)), math.degrees(mass.angle))
    angle = {_of_mass(mass, EccentricMass.angle): round(turned, 1)} if abs(turned - now) > 0.05 else {}
    weight = {_of_mass(mass, EccentricMass.mass): round(abs(wanted) / mass.radius, 3)} if mass.radius else {}
    radius = {_of_mass(mass, EccentricMass.radius): round(abs(wanted) / mass.mass * 1e3, 2)} if mass.mass else {}
    yield weight
    yield angle
    yield weight | angle
    yield radius | angle


def _of_mass(mass: EccentricMass, field: object) -> str:
    """Among the masses of the shaft."""
    return dotted(mass.name, field)


def _near(angle: float, old: float) -> float:
    """The same direction, less than half a turn from the old number of degrees."""
    return old + (angle - old + 180) % 360 - 180


def shorter_journals(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Journals that run into the sectors: bearings of the search, which fit."""
    if state.design.bearings is None:
        raise NoSolution(Text("there are no bearings to shorten"))
    mended = nearest_bearings(state, failing, progress)
    if any(c.id in {check.id for check in failing} for c in mended.failing("countershaft")):
        raise NoSolution(Text("no bearings that fit beside the sectors pass"))
    return mended


def resize(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """A shaft of the sizing search, the nearest in radius and of the same material first.  Raises NoSolution."""
    design, outcomes = state.design, {name: view.outcomes["countershaft"] for name, view in state.results.views.items()}
    lost = [name for name, outcome in outcomes.items() if outcome.state == "no_solution"]
    view = state.view(failing[0].id) if failing or not lost else design.views[lost[0]]
    shaft = view.countershaft
    imbalance, engine = state.results.result(ImbalanceResult), state.results.result(EngineResult)
    if shaft is None or imbalance is None or engine is None:
        raise NoSolution(UNKNOWN)
    try:
        room = envelope(shaft, state.document.place)
        materials = candidates(shaft, design.materials, state.document.place)
    except BadInput as bad:
        raise NoSolution(Text("{key} {reason}", key=bad.errors[0].key, reason=bad.errors[0].reason)) from None
    ids, alike = [c.id for c in failing], sized_alike(design, shaft.name)
    beside = given_beside(design, shaft.name, outcomes)
    try:
        own = {shaft.of_sectors: materials[shaft.of_sectors]}
        choices(shaft, imbalance, engine.angular_speed, room, own, alike=alike, beside=beside)
    except TooSmall as small:
        larger = (
            (ShaftInputs.outer_radius, small.outer_radius),
            (ShaftInputs.half_length, small.half_length),
        )
        sizes = ({view.own_key(size): math.ceil(x / TENTH) / 10} for size, x in larger if x is not None)
        try:
            return first_repaired(state, "countershaft", ids, sizes, part(progress, 0.0, 0.2))
        except NoSolution:
            pass
    searched = part(progress, 0.2, 0.3)
    shafts = choices(shaft, imbalance, engine.angular_speed, room, materials, searched, alike, beside).shafts
    R = shaft.outer_radius or room.outer_radius
    near = sorted(shafts, key=lambda choice: (choice.material != shaft.of_sectors, abs(choice.sized.outer_radius - R)))
    ways = (changes(choice, room) for choice in near)
    return first_repaired(state, "countershaft", ids, ways, part(progress, 0.3, 1.0), most=TRIED)


# --- teeth that are too weak
# The smallest face width that is enough, and beyond half as much again a stronger class or quality.

STEP = 0.5  # mm
WIDER = 1.5  # times the face width that is tried before a stronger class; rule of this program
WIDEST = 3.0  # times it where no class is enough
QUALITIES = ("MQ", "ME")


def stronger_teeth(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Raises NoSolution where neither helps."""
    ids, names = [c.id for c in failing], wheels(state, failing)
    tell(progress, 0.0, Text("face width"))
    mended = _wider(state, names, ids, 1.0, WIDER)
    if mended is None:
        try:
            mended = first_repaired(state, "gears", ids, stronger(state, names), part(progress, 0.3, 0.7))
        except NoSolution:
            mended = _wider(state, names, ids, WIDER, WIDEST)
    if mended is None:
        raise NoSolution(Text("neither {times} times the face width nor a stronger class is enough", times=WIDEST))
    return mended


def wheels(state: RepairState, failing: tuple[Check, ...]) -> list[str]:
    """Wheels of the pairs that fail: a root is as wide as its pair."""
    gears = state.design.gears
    assert gears is not None
    what = {c.id.split(".")[1] for c in failing}
    pairs = [mesh for mesh in gears.meshes if {mesh.key, mesh.driver, mesh.driven} & what]
    wanted = {name for mesh in pairs for name in (mesh.driver, mesh.driven)}
    return [wheel.name for wheel in gears.wheels if wheel.name in wanted]


def _wider(state: RepairState, names: list[str], ids: list[str], low: float, high: float) -> RepairState | None:
    """The smallest face width between two multiples of the present one, on half millimetres; None where none is
    enough."""
    gears = state.design.gears
    assert gears is not None
    face_widths = {w.name: w.face_width for w in gears.wheels if w.name in names and w.face_width is not None}
    widths = {wheel_key(name, Wheel.face_width): b * 1e3 for name, b in face_widths.items()}
    if len(face_widths) < len(names):
        widths[dotted(Design.gears, GearsInputs.face_width)] = gears.face_width * 1e3

    def with_width(n: int) -> RepairState | None:
        """The common width of n steps, wheels that are wider staying as they are; None where it is not enough."""
        try:
            wider = state.with_changes({key: whole(n * STEP) for key, b in widths.items() if b < n * STEP})
        except BadInput:
            return None
        return wider if repaired(state, wider, "gears", ids, well=True) and not broken(state, wider) else None

    narrow, wide = min(widths.values()), max(widths.values())
    return least_whole(with_width, math.floor(narrow * low / STEP) + 1, math.floor(wide * high / STEP))


def stronger(state: RepairState, names: list[str]) -> Iterator[Changes]:
    """Classes and qualities that are stronger than those of the wheels, the weakest first: for each wheel alone, then
    for all."""
    gears = state.design.gears
    assert gears is not None
    some_wheels = [wheel for wheel in gears.wheels if wheel.name in names]
    every = [strength_class(name, quality) for name in class_names() for quality in QUALITIES]
    every.sort(key=lambda strength: strength.sigma_Hlim + strength.sigma_Flim)
    for some in [*([wheel] for wheel in some_wheels), some_wheels]:
        now = [strength_class(w.gear_material or DEFAULT, w.quality, w.hardness) for w in some]
        enough = [
            strength
            for strength in every
            if all(strength.sigma_Hlim >= was.sigma_Hlim and strength.sigma_Flim >= was.sigma_Flim for was in now)
            and any(strength.sigma_Hlim > was.sigma_Hlim or strength.sigma_Flim > was.sigma_Flim for was in now)
        ]
        for strength in enough[:TRIED]:
            yield dict(change for wheel in some for change in _class(wheel, strength.name, strength.quality))


def _class(wheel: Wheel, name: str, quality: str) -> Iterator[tuple[str, str | None]]:
    """The hardness goes, which belonged to another class: the lowest of the new one is then taken."""
    if (wheel.gear_material or DEFAULT) != name:
        yield wheel_key(wheel.name, Wheel.gear_material), name
        if wheel.hardness is not None:
            yield wheel_key(wheel.name, Wheel.hardness), None
    if wheel.quality != quality:
        yield wheel_key(wheel.name, Wheel.quality), quality
