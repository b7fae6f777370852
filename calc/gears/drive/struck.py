# SPDX-License-Identifier: Apache-2.0
"""What the strikes do to the teeth, what a split gear holds, and all that is judged and said of the drive."""

import math
from collections.abc import Collection, Iterator, Mapping
from fractions import Fraction

import numpy as np

from ...sheet.check import Check
from ...sheet.deferred import Later
from ...sheet.record import replace
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.units import Newton, Number
from ...sheet.value import about, based_on, trace, untraced
from ..inputs import GearsInputs
from ..rating.load import RatingContext
from ..rating.solve import Loaded
from ..result import TrainResult
from .checks import grade_limits, method_checks, rattle_checks, strength_checks
from .notes import notes
from .orders import error_by_load
from .remedies import Strikes, Workshop, quiet_remedies
from .remedies import notes as of_remedies
from .result import HARDEST, IDLE, OPERATIONS, DriveResult, MeshAt, MeshOverSpeed, ScissorResult, WheelStruck
from .scissor import ScissorCase, scissor, scissor_checks
from .strength import StrikeRate, strike_rate
from .strength import struck as under_strike
from .tables import tables

STRUCK = (HARDEST, IDLE)  # where the teeth are rated under their strikes
ESTIMATES = ("low", "high", "most")
SMALLER = 0.8  # of the force where it is hardest: at idle, slower, such a force leaves more of every safety


def struck(
    gears: GearsInputs, train: TrainResult, drive: DriveResult, context: RatingContext | None
) -> tuple[Outcome[object], dict[str, MeshOverSpeed], dict[str, WheelStruck], DriveResult]:
    """Checks, lines and notes, the meshes and the wheels with their safeties, and the drive with its window."""
    meshes = {key: mesh.over_speed for key, mesh in train.meshes.items() if mesh.over_speed is not None}
    wheels: dict[str, WheelStruck] = {}
    springs: dict[str, ScissorResult] = {}
    with trace() as lines:
        if context is not None:
            meshes, wheels = _safeties(context, train, drive, meshes)
            springs = _springs(gears, context, drive)
        meshes = {
            key: replace(mesh, scissor=springs.get(key), error_by_load=_error(train, key))
            for key, mesh in meshes.items()
        }
    rated = replace(
        train,
        meshes={key: replace(mesh, over_speed=meshes.get(key)) for key, mesh in train.meshes.items()},
        wheels={name: replace(wheel, strikes=wheels.get(name)) for name, wheel in train.wheels.items()},
    )
    shop = Workshop(gears, train, drive)
    told: Outcome[object] = Outcome(
        "gears",
        checks=tuple(_checks(shop, meshes, wheels, springs, context)),
        lines=tuple(lines),
        tables=Later(lambda: tables(rated, drive)),
        notes=Later(lambda: (*notes(gears, rated, drive), *of_remedies(shop))),
    )
    return told, meshes, wheels, drive


def force_of(at: MeshAt, estimate: str) -> Newton:
    if estimate == "low":
        return at.impact_force_low
    return at.impact_force if estimate == "high" else at.impact_force_most


Asked = tuple[str, str]  # a mesh by its key, or a wheel by its name, and an estimate
Least = dict[Asked, Number]


def _safeties(
    context: RatingContext, train: TrainResult, drive: DriveResult, meshes: Mapping[str, MeshOverSpeed]
) -> tuple[dict[str, MeshOverSpeed], dict[str, WheelStruck]]:
    """The least safeties of every mesh and wheel under the strikes at idle and where these are hardest."""

    def struck_at(op: str, asked: Collection[Asked]) -> Iterator[tuple[Asked, Loaded]]:
        n = float(drive.survey.speeds[drive.at[op]])
        ratio, rate = n / float(drive.drive.work.engine.rated_speed), _rate(train, drive, n)
        for key, mesh in meshes.items():
            loaded: Loaded | None = None
            for estimate in ESTIMATES:
                if (key, estimate) in asked:
                    F = force_of(mesh.operations[op], estimate)
                    with about(Text("mesh {pair}, strikes, {op}", pair=train.meshes[key].title, op=OPERATIONS[op])):
                        loaded = under_strike(context, key, F, ratio, rate, loaded)
                    if loaded is not None:
                        yield (key, estimate), loaded

    S_H, S_F = Least(), Least()
    every = [(key, estimate) for key in meshes for estimate in ESTIMATES]
    for asked, loaded in struck_at(HARDEST, every):
        _taken(S_H, S_F, asked, loaded)
    if IDLE in drive.at and drive.at[IDLE] != drive.at[HARDEST]:
        strong = [
            (key, estimate)
            for key, estimate in every
            if force_of(meshes[key].operations[IDLE], estimate)
            >= SMALLER * force_of(meshes[key].operations[HARDEST], estimate)
        ]
        with untraced():
            at_idle = [
                asked for asked, loaded in struck_at(IDLE, strong) if _taken(dict(S_H), dict(S_F), asked, loaded)
            ]
        if at_idle:  # line by line where they leave less alone
            for asked, loaded in struck_at(IDLE, at_idle):
                _taken(S_H, S_F, asked, loaded)
    of_meshes = {
        key: replace(
            mesh,
            strike_safety_contact_low=S_H.get((key, "low")),
            strike_safety_contact=S_H.get((key, "high")),
            strike_safety_contact_most=S_H.get((key, "most")),
        )
        for key, mesh in meshes.items()
    }
    of_wheels = {
        name: WheelStruck(
            strike_safety_bending_low=S_F.get((name, "low")),
            strike_safety_bending=S_F.get((name, "high")),
            strike_safety_bending_most=S_F.get((name, "most")),
        )
        for name in dict.fromkeys(name for name, _ in S_F)
    }
    return of_meshes, of_wheels


def _taken(S_H: Least, S_F: Least, asked: Asked, loaded: Loaded) -> bool:
    """Whether a load leaves less than all before it; what it leaves is then the least."""
    key, estimate = asked
    found = [(S_H, key, loaded.contact), *((S_F, wheel, S) for wheel, S in loaded.bending.items())]
    less = [(of, name, S) for of, name, S in found if S is not None and S < of.get((name, estimate), math.inf)]
    for of, name, S in less:
        of[name, estimate] = S
    return bool(less)


def _rate(train: TrainResult, drive: DriveResult, n: float) -> StrikeRate:
    """How often a tooth meets a strike: an engine that fires evenly strikes alike at every firing."""
    engine, motion = drive.drive.work.engine, drive.survey.motion
    alike = max(1, round(motion.cycle / motion.period))
    first = Fraction(abs(float(drive.drive.work.ratio))).limit_denominator(1000)
    return strike_rate(train.tree, n, engine.strokes, alike, first)


def _error(train: TrainResult, key: str) -> Number | None:
    """Of spur wheels whose load is known."""
    mesh = train.meshes[key]
    K = mesh.rating.influence if mesh.rating is not None else None
    if K is None or mesh.overlap_ratio or not 1 < mesh.transverse_contact_ratio < 2:
        return None
    with about(Text("mesh {pair}", pair=mesh.title)):
        return error_by_load(w=K.line_load, c=K.single_stiffness)


def _springs(gears: GearsInputs, context: RatingContext, drive: DriveResult) -> dict[str, ScissorResult]:
    """Of the meshes with a split wheel; none where idle without load is not known."""
    if IDLE not in drive.at:
        return {}
    of, line, found = drive.survey, drive.drive.line, {}
    speeds = of.each_speed
    for mesh in gears.meshes:
        if mesh.scissor is None:
            continue
        i, at = line.index(mesh.key), drive.meshes[mesh.key].operations
        least = np.array([of.closed.least[of.speeds == n, i] for n in speeds])
        case = ScissorCase(
            backlash=line.play["most"][i],
            idle_speed=drive.idle_speed,
            idle_force=at[IDLE].least_force,
            speeds=based_on(speeds, drive.idle_speed),
            forces=based_on(least, at[IDLE].least_force),
            steady=based_on(float(of.closed.drag[drive.at["rated"], i]), at["rated"].least_force),
            most=at["rated"].most_force,
            lost=drive.drive.lost(mesh.key),
        )
        found[mesh.key] = scissor(mesh.scissor, context, mesh.key, case)
    return found


def _checks(
    shop: Workshop,
    meshes: Mapping[str, MeshOverSpeed],
    wheels: Mapping[str, WheelStruck],
    springs: Mapping[str, ScissorResult],
    context: RatingContext | None,
) -> Iterator[Check]:
    drive = shop.drive
    titles = {key: mesh.title for key, mesh in shop.train.meshes.items()}
    index = {mesh.key: i for i, mesh in enumerate(shop.gears.meshes)}
    taken = drive.drive.taken
    idle = {key: mesh.operations[IDLE] for key, mesh in meshes.items() if IDLE in mesh.operations}
    if idle and drive.impact_speed is not None:
        quiet, loud = grade_limits()
        ways = Later(lambda: quiet_remedies(shop, loud)), Later(lambda: quiet_remedies(shop, quiet, loud))
        yield from rattle_checks(drive, idle, titles, taken, index, *ways)
    if context is not None:
        under = Strikes(shop, context, lambda n: _rate(shop.train, drive, n))
        yield from strength_checks(drive, meshes, wheels, titles, taken, index, under.remedies)
    shares = {
        key: max(mesh.operations[op].backlash_share for op in STRUCK if op in mesh.operations)
        for key, mesh in meshes.items()
    }
    yield from method_checks(drive, shares)
    for key, spring in springs.items():
        yield from scissor_checks(key, titles[key], index[key], spring)
