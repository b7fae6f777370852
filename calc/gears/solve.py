# SPDX-License-Identifier: Apache-2.0
"""The gear train from its inputs: geometry first, its rating once the torque is known, and both as one outcome.

`rating` stands in its own file and is offered here, so that the step has one door."""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from ..engine.inputs import EngineInputs
from ..library.catalogue import Material
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.deferred import Later
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.step import Outcome, Table, finite
from ..sheet.text import Text
from ..sheet.units import Metre, NewtonMetre, Number, Radian, RevPerSecond
from ..sheet.value import about, trace
from .backlash.case import backlash_at_shaft
from .backlash.formulas import residual_couple as _couple_of_phase_error
from .backlash.solve import play, with_couple
from .checks import checks as train_checks
from .checks import speed_ratio_check
from .formulas import speed_ratio as speed_ratio_of
from .inputs import GearsInputs, Mesh
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
from .rating.result import RatingResult
from .rating.solve import rating
from .result import TrainResult, working_circles
from .train import settle, speeds, tooth_system
from .wheel import solve_wheel
from .wheel_inputs import Wheel

__all__ = ["geometry", "merge", "not_rated", "rating", "residual_couple", "with_residual_couple", "with_speed_ratio"]


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


def at_rest(gears: GearsInputs) -> Outcome[TrainResult]:
    """All of `geometry` but the speeds, of which none of it depends."""
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
        last = gears.meshes[-1].driven
        with about(Text("train, to {last}", last=last)):
            free = backlash_at_shaft(wheels, meshes, last)
        spans: list[Callable[[], Table]] = []
        for given in gears.wheels:
            working = [(mate, d_w) for mate, d_w, _ in working_circles(meshes, given.name)]
            sizes, table = measures(system, given, wheels[given.name], working)
            wheels[given.name] = replace(wheels[given.name], measures=sizes)
            spans.append(table)
        result = TrainResult(system=system, wheels=wheels, meshes=meshes, speed_ratio=0.0, phase_error=free)
        depths = penetrations(result)
    result = replace(result, meshes={key: replace(mesh, penetration=depths[key]) for key, mesh in meshes.items()})
    finite(result, "gears", EXTREME)
    return Outcome(
        "gears",
        result=result,
        checks=tuple(_checks(gears, result, depths)),
        lines=tuple(lines),
        tables=Later(lambda: (table() for table in spans)),
        notes=Later(lambda: (*notes(gears, train, result), *profile_notes(result))),
    )


def _checks(gears: GearsInputs, train: TrainResult, depths: Mapping[str, Metre]) -> Iterator[Check]:
    yield from train_checks(gears, train)
    for wheel in train.wheels.values():
        assert wheel.measures is not None  # of every wheel, once the geometry is solved
        yield from measures_checks(train.system, wheel, wheel.measures)
    yield from profile_checks(train, depths)


def turning(outcome: Outcome[TrainResult], gears: GearsInputs, first_speed: RevPerSecond) -> Outcome[TrainResult]:
    """A train with its speeds."""
    with trace() as lines:
        n = speeds(gears, first_speed)
        last = gears.meshes[-1].driven
        with about(Text("train, to {last}", last=last)):
            ratio = speed_ratio_of(n_last=n[last], n_1=n[gears.meshes[0].driver])
    still = outcome.solution
    result = replace(
        still, wheels={name: replace(wheel, speed=n[name]) for name, wheel in still.wheels.items()}, speed_ratio=ratio
    )
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
    result = replace(outcome.solution, play=played.meshes, train_play=played.train)
    return replace(_joined(outcome, beside), result=result)


def with_layout(outcome: Outcome[TrainResult], gears: GearsInputs, shaft: ShaftInTrain) -> Outcome[TrainResult]:
    """The train in its place."""
    placed = layout(gears, outcome.solution, shaft)
    return replace(_joined(outcome, placed), result=replace(outcome.solution, layout=placed.result))


def merge(geometry: Outcome[TrainResult], rated: Outcome[RatingResult]) -> Outcome[TrainResult]:
    """One outcome from the geometry of a train and its rating; both keep their lines, checks, errata and notes."""
    train, stresses = geometry.solution, rated.solution
    meshes = {key: replace(mesh, rating=stresses.meshes.get(key)) for key, mesh in train.meshes.items()}
    return replace(_joined(geometry, rated), result=replace(train, meshes=meshes))


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


def residual_couple(outcome: Outcome[TrainResult], couple: NewtonMetre) -> NewtonMetre:
    """What is left of a couple that the last wheel should cancel, when the whole backlash turns it out of phase."""
    return _couple_of_phase_error(couple, outcome.solution.phase_error)


def with_residual_couple(outcome: Outcome[TrainResult], couple: NewtonMetre) -> Outcome[TrainResult]:
    """The same outcome with the residual couple among its values and its line among its lines."""
    train = outcome.solution
    with trace() as lines, about(Text("train, by its backlash")):
        left = residual_couple(outcome, couple)
        whole = with_couple(train.train_play, couple) if train.train_play is not None else None
    return replace(
        outcome, result=replace(train, residual_couple=left, train_play=whole), lines=outcome.lines + tuple(lines)
    )


def with_speed_ratio(
    outcome: Outcome[TrainResult], wanted: Number, engine: EngineInputs | None = None
) -> Outcome[TrainResult]:
    """The same outcome with the check that its last wheel turns as the shaft must; `wanted` −1: as fast as the crank,
    the other way.

    Without an `engine` the first driver is taken to turn as the crank does.
    """
    if outcome.result is None:
        return outcome
    crank = engine.rated_speed if engine is not None else None
    return replace(outcome, checks=(*outcome.checks, speed_ratio_check(outcome.result, wanted, crank)))


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

    What is left out of profile shifts and centre distance follows from the others; without any of them the shifts are
    0, and without a distance there is no backlash.  Tool sizes in modules; `speed` of the driver.  Raises NoSolution
    where the teeth cannot be made."""
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
