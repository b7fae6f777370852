# SPDX-License-Identifier: Apache-2.0
"""The gear train from its inputs: geometry first, its rating once the torque is known, and both as one outcome.

`rating` stands in its own file and is offered here, so that the step has one door."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from ..engine.inputs import EngineInputs
from ..library.catalogue import Material
from ..sheet.arguments import check_arguments
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.deferred import Later
from ..sheet.quantity import dotted
from ..sheet.record import record, replace
from ..sheet.step import Outcome, Table, finite
from ..sheet.text import Text
from ..sheet.units import Metre, Newton, NewtonMetre, Number, Radian, RevPerSecond
from ..sheet.value import about, trace
from . import stages as chains
from .backlash.case import free_turn, lags
from .backlash.formulas import residual_couple, residual_force
from .backlash.setting import coat_checks
from .backlash.solve import play, with_couple
from .checks import checks as train_checks
from .checks import no_wheel_check, speed_ratio_check
from .drive.remedies import Workshop, opening_remedies
from .drive.result import DriveResult
from .drive.solve import over_speed
from .drive.struck import struck as struck_parts
from .drive.window import MayLeave
from .drive.window import window as window_parts
from .formulas import speed_ratio as speed_ratio_of
from .inputs import ONLY, GearsInputs, Mesh
from .layout.forces import forces
from .layout.solve import ShaftInTrain, layout
from .limits import EXTREME
from .measures.solve import checks as measures_checks
from .measures.solve import measures
from .notes import errata, notes
from .pair import solve_mesh
from .profile.meshing import checks as profile_checks
from .profile.meshing import notes as profile_notes
from .profile.meshing import penetrations
from .rating.load import RatingContext
from .rating.result import RatingResult
from .rating.solve import rating
from .result import ShaftTurn, TrainResult, working_circles
from .train import settle, speeds, tooth_system
from .wheel import solve_wheel
from .wheel_inputs import Wheel

__all__ = ["geometry", "merge", "not_rated", "over_speed", "rating", "with_residuals", "with_speed_ratios"]


@record
class TrainPart:
    """A part of the step that may have no solution while the rest stands: its title, and what is then judged."""

    title: Text
    rule: CheckRule


NO_NUMBER = "1, no number"
NO_VALUES = Text("the part has no values")
POWER = dotted("gears", GearsInputs.power)
BACKLASH = TrainPart(
    Text("backlash over parts and temperature"),
    CheckRule(
        "gears.train.backlash",
        "limit",
        "The backlash over parts and temperature, a limit, has no values.",
        source=NO_VALUES,
        role="self",
        zero=NO_NUMBER,
    ),
)
LAYOUT = TrainPart(
    Text("layout of the train"),
    CheckRule(
        "gears.train.layout", "limit", "The wheels have no place.", source=NO_VALUES, role="self", zero=NO_NUMBER
    ),
)
DRIVE = TrainPart(
    Text("drive over speed"),
    CheckRule(
        "gears.train.drive",
        "limit",
        "What strikes do to the teeth, a limit, has no values.",
        source=NO_VALUES,
        role="self",
        zero=NO_NUMBER,
    ),
)
RATING = TrainPart(
    Text("rating of the teeth"),
    CheckRule(
        "gears.train.rating",
        "limit",
        "The safeties, limits, have no values.",
        source=NO_VALUES,
        role="self",
        zero=NO_NUMBER,
        moved_by=(POWER,),
    ),
)
NOT_RATED = Text(
    "Not rated yet: no torque is known. Bearings and friction give it by their power balance, or the power given here; "
    "stresses, safeties and forces on the axes have no values."
)


def geometry(gears: GearsInputs, first_speed: RevPerSecond) -> Outcome[TrainResult]:
    """Shifts, circles, measures, contact and backlash of the whole train, turning.  `first_speed` is that of the first
    driver.

    Raises NoSolution where wheels of these numbers can not be made, or can not mesh.
    """
    return turning(at_rest(gears), gears, first_speed)


def at_rest(gears: GearsInputs, shafts: Sequence[str] = (ONLY,)) -> Outcome[TrainResult]:
    """All of `geometry` but the speeds, of which none of it depends.  `shafts`: their names."""
    tree = gears.tree
    with trace() as lines:
        system = tooth_system(gears)
        train = settle(gears, system)
        wheels = {
            w.name: solve_wheel(gears, system, w, train.shifts[w.name], train.d[w.name], train.d_b[w.name])
            for w in gears.wheels
        }
        meshes = {
            mesh.key: solve_mesh(
                system, mesh, f"gears.meshes.{i}", train.distances[mesh.key], wheels[mesh.driver], wheels[mesh.driven]
            )
            for i, mesh in enumerate(gears.meshes)
        }
        stages = chains.stages(gears, tree)
        plays, turns = {key: mesh.play_angle for key, mesh in meshes.items()}, {}
        for shaft in shafts:
            wheel = gears.carrier(shaft)
            with about(Text("train, to {last}", last=wheel)):
                free = free_turn(tree, wheel, plays, lags(stages))
            turns[shaft] = ShaftTurn(speed_ratio=0.0, phase_error=free, wheel=wheel)
        spans: list[Callable[[], Table]] = []
        for given in gears.wheels:
            working = [(mate, d_w) for mate, d_w, _ in working_circles(meshes, given.name)]
            sizes, table = measures(system, given, wheels[given.name], working)
            wheels[given.name] = replace(wheels[given.name], measures=sizes)
            spans.append(table)
        result = TrainResult(
            system=system, wheels=wheels, meshes=meshes, stages=stages, shafts=turns, tree=tree, speeds={}
        )
        depths = penetrations(result)
    result = replace(result, meshes={key: replace(mesh, penetration=depths[key]) for key, mesh in meshes.items()})
    finite(result, "gears", EXTREME)
    return Outcome(
        "gears",
        result=result,
        checks=tuple(_checks(gears, result, depths)),
        lines=tuple(lines),
        tables=Later(lambda: (table() for table in spans)),
        notes=Later(lambda: (*notes(gears, train, result), *chains.notes(gears), *profile_notes(result))),
    )


def _checks(gears: GearsInputs, train: TrainResult, depths: Mapping[str, Metre]) -> Iterator[Check]:
    yield from train_checks(gears, train)
    for wheel in train.wheels.values():
        assert wheel.measures is not None  # of every wheel, once the geometry is solved
        yield from measures_checks(train.system, wheel, wheel.measures)
    yield from profile_checks(train, depths)
    yield from chains.checks(gears)


def turning(outcome: Outcome[TrainResult], gears: GearsInputs, first_speed: RevPerSecond) -> Outcome[TrainResult]:
    """A train with its speeds."""
    with trace() as lines:
        n, still, shafts = speeds(gears, first_speed), outcome.solution, {}
        for shaft, turn in still.shafts.items():
            with about(Text("train, to {last}", last=turn.wheel)):
                ratio = speed_ratio_of(n_last=n[turn.wheel], n_1=n[still.tree.first])
            shafts[shaft] = replace(turn, speed_ratio=ratio)
    wheels = {name: replace(wheel, speed=n[name]) for name, wheel in still.wheels.items()}
    result = replace(still, wheels=wheels, shafts=shafts, speeds=n)
    wrong = Later(lambda: errata(result) if gears.source_sheet == "finotti" else ())
    return replace(outcome, result=result, lines=(*outcome.lines, *lines), errata=outcome.errata + wrong)


def with_play(
    outcome: Outcome[TrainResult], gears: GearsInputs, materials: Mapping[str, Material], housing: str | None
) -> Outcome[TrainResult]:
    """What the backlash becomes over parts, chance, runout and temperature.  `housing`: the material between the
    centres."""
    with trace() as lines:
        played = play(gears, outcome.solution, materials, housing)
    beside: Outcome[object] = Outcome(
        "gears",
        checks=played.checks,
        lines=tuple(lines),
        curves=Later(played.curves),
        tables=Later(played.tables),
        notes=played.notes,
    )
    result = replace(outcome.solution, play=played.meshes, train_play=played.shafts)
    return replace(_joined(outcome, beside), result=result)


def with_layout(
    outcome: Outcome[TrainResult], gears: GearsInputs, shafts: Mapping[str, ShaftInTrain]
) -> Outcome[TrainResult]:
    """The train in its place; `shafts` by their names."""
    placed = layout(gears, outcome.solution, shafts)
    return replace(_joined(outcome, placed), result=replace(outcome.solution, layout=placed.result))


def with_drive(outcome: Outcome[TrainResult], driven: Outcome[DriveResult]) -> Outcome[TrainResult]:
    """The same with the drive over speed, and what it is to each mesh."""
    train, drive = outcome.solution, driven.solution
    meshes = {key: replace(mesh, over_speed=drive.meshes.get(key)) for key, mesh in train.meshes.items()}
    return replace(_joined(outcome, driven), result=replace(train, meshes=meshes, drive=drive))


def struck(outcome: Outcome[TrainResult], gears: GearsInputs, context: RatingContext | None) -> Outcome[TrainResult]:
    """The same with what the strikes do to the teeth, and all that is judged of the drive; `context`: that of the
    rating, None where there is none."""
    train = outcome.solution
    if train.drive is None:
        return outcome
    told, meshes, wheels, drive = struck_parts(gears, train, train.drive, context)
    of_meshes = {key: replace(mesh, over_speed=meshes.get(key)) for key, mesh in train.meshes.items()}
    of_wheels = {name: replace(wheel, strikes=wheels.get(name)) for name, wheel in train.wheels.items()}
    result = replace(train, meshes=of_meshes, wheels=of_wheels, drive=drive)
    return replace(_joined(outcome, told), result=result)


def with_coats(outcome: Outcome[TrainResult], gears: GearsInputs) -> Outcome[TrainResult]:
    """The same with what the coats of its flanks leave, against what the meshes need."""
    return _joined(outcome, coat_checks(gears, outcome.solution))


def with_window(
    outcome: Outcome[TrainResult], gears: GearsInputs, shafts: Mapping[str, MayLeave]
) -> Outcome[TrainResult]:
    """The same with the window of the nominal backlash; `shafts`: what each may leave, by its name."""
    train = outcome.solution
    if train.drive is None:
        return outcome
    told, drive = window_parts(train, train.drive, shafts, lambda of: opening_remedies(Workshop(gears, train, of)))
    return replace(_joined(outcome, told), result=replace(train, drive=drive))


def merge(geometry: Outcome[TrainResult], rated: Outcome[RatingResult]) -> Outcome[TrainResult]:
    """One outcome from the geometry of a train and its rating; both keep their lines, checks, errata and notes."""
    train, stresses = geometry.solution, rated.solution
    meshes = {key: replace(mesh, rating=stresses.meshes.get(key)) for key, mesh in train.meshes.items()}
    pulls = stresses.least_strand_forces
    stages = {name: replace(stage, least_strand_force=pulls.get(name)) for name, stage in train.stages.items()}
    return replace(_joined(geometry, rated), result=replace(train, meshes=meshes, stages=stages))


def with_forces(outcome: Outcome[TrainResult], gears: GearsInputs) -> Outcome[TrainResult]:
    """The forces on the axes of a train that is placed and rated."""
    train = outcome.solution
    if train.layout is None:
        return outcome
    torques = {key: mesh.rating.torque for key, mesh in train.meshes.items() if mesh.rating is not None}
    loaded = forces(gears, train, train.layout, torques)
    return replace(_joined(outcome, loaded), result=replace(train, forces=loaded.result))


def without(outcome: Outcome[TrainResult], part: TrainPart, reason: Text) -> Outcome[TrainResult]:
    """The same outcome, with a failing check for a part of it that has no solution."""
    name, advice = Text("No solution: {part}", part=part.title), Text("{reason}.", reason=reason)
    failed = part.rule(math.nan, 0.0, name=name, advice=advice, scale=1.0)
    return replace(outcome, checks=(*outcome.checks, failed))


def not_rated(outcome: Outcome[TrainResult], why: Text) -> Outcome[TrainResult]:
    """The same outcome without its safeties, which no power is known for."""
    source = Text("rule of this program: without a torque no tooth is rated")
    lack = Missing((POWER,), (), "none", "none")
    name = Text("Safeties of the teeth")
    open_ = RATING.rule(math.nan, 0.0, name=name, source=source, advice=why, scale=1.0, missing=lack)
    return replace(outcome, checks=(*outcome.checks, open_), notes=(*outcome.notes, why))


def _joined(first: Outcome[TrainResult], second: Outcome[object]) -> Outcome[TrainResult]:
    """The first outcome with everything that stands beside the result of the second."""
    return replace(
        first,
        checks=first.checks + second.checks,
        lines=first.lines + second.lines,
        curves=first.curves + second.curves,
        tables=first.tables + second.tables,
        errata=first.errata + second.errata,
        notes=first.notes + second.notes,
    )


class Balanced(NamedTuple):
    """What a shaft turns with: its couple, and its force where it has one."""

    couple: NewtonMetre
    force: Newton | None = None


def with_residuals(outcome: Outcome[TrainResult], shafts: Mapping[str, Balanced]) -> Outcome[TrainResult]:
    """The same outcome with what its whole backlash leaves of the couple and the force of each shaft, by its name."""
    train, turns, plays = outcome.solution, {}, {}
    with trace() as lines:
        for name, turn in train.shafts.items():
            balanced = shafts.get(name)
            with about(Text("train, by its backlash")):
                if balanced is not None:
                    left = residual_couple(balanced.couple, turn.phase_error)
                    turn = replace(turn, residual_couple=left)
                    if balanced.force is not None:
                        turn = replace(turn, residual_force=residual_force(balanced.force, turn.phase_error))
                    if train.train_play is not None:
                        plays[name] = with_couple(train.train_play[name], balanced.couple)
            turns[name] = turn
    whole = None if train.train_play is None else train.train_play | plays
    result = replace(train, shafts=turns, train_play=whole)
    return replace(outcome, result=result, lines=outcome.lines + tuple(lines))


def with_speed_ratios(
    outcome: Outcome[TrainResult], wanted: Mapping[str, Number], engine: EngineInputs | None = None
) -> Outcome[TrainResult]:
    """The same outcome with the checks that each shaft turns as it must; `wanted` −1: as fast as the crank, the other
    way.

    Without an `engine` the first driver is taken to turn as the crank does.
    """
    if outcome.result is None:
        return outcome
    crank, train = engine.rated_speed if engine is not None else None, outcome.result
    made = (
        (speed_ratio_check if name in train.shafts else no_wheel_check)(train, name, ratio, crank)
        for name, ratio in wanted.items()
    )
    return replace(outcome, checks=(*outcome.checks, *made))


# --- from Python, in SI: `from calc import gears`

DEGREES_20: Radian = math.radians(20.0)


def solve_pair(
    teeth: tuple[int, int],
    *,
    normal_module: Metre,
    face_width: Metre,
    helix_angle: Radian = 0.0,
    pressure_angle: Radian = DEGREES_20,
    profile_shift: tuple[Number | None, Number | None] = (None, None),
    centre_distance: Metre | None = None,
    tool_addendum: Number = 1.25,
    tool_tip_radius: Number = 0.38,
    speed: RevPerSecond = 1.0,
) -> TrainResult:
    """Geometry, measures and contact of two wheels: `wheels["driver"]`, `wheels["driven"]`, `meshes["driver_driven"]`.

    `teeth`, `profile_shift` (in modules): of driver and driven.  `normal_module`, `face_width`, `centre_distance` [m],
    `helix_angle`, `pressure_angle` [rad], `tool_addendum`, `tool_tip_radius` [in modules], `speed` of the driver
    [revolutions per second].  What is left out of profile shifts and centre distance follows from the others; without
    any of them the shifts are 0, and without a distance there is no backlash.

    Raises NoSolution where the teeth cannot be made, BadInput where an argument lies outside of the range that it has
    in a design file."""
    check_arguments(
        "solve_pair",
        teeth=(Wheel.teeth, teeth),
        normal_module=(GearsInputs.normal_module, normal_module),
        face_width=(GearsInputs.face_width, face_width),
        helix_angle=(GearsInputs.helix_angle, helix_angle),
        pressure_angle=(GearsInputs.pressure_angle, pressure_angle),
        profile_shift=(Wheel.profile_shift, profile_shift),
        centre_distance=(Mesh.centre_distance, centre_distance),
        tool_addendum=(GearsInputs.tool_addendum, tool_addendum),
        tool_tip_radius=(GearsInputs.tool_tip_radius, tool_tip_radius),
        speed=(GearsInputs.speed, speed),
    )
    wheels = tuple(
        Wheel(name=name, teeth=z, profile_shift=x) for name, z, x in zip(("driver", "driven"), teeth, profile_shift)
    )
    train = GearsInputs(
        normal_module=normal_module,
        pressure_angle=pressure_angle,
        helix_angle=helix_angle,
        face_width=face_width,
        tool_addendum=tool_addendum,
        tool_tip_radius=tool_tip_radius,
        wheels=wheels,
        meshes=(Mesh(driver="driver", driven="driven", centre_distance=centre_distance),),
    )
    return geometry(train, speed).solution
