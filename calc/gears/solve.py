# SPDX-License-Identifier: Apache-2.0
"""The gear train from its inputs: geometry first, its rating once the torque is known, and both as one outcome.

`rating` stands in its own file and is offered here, so that the step has one door.
"""

import math
from collections.abc import Mapping
from dataclasses import replace

from ..catalogue import Material
from ..sheet.check import Check, check
from ..sheet.step import Erratum, Outcome, Table
from ..sheet.trace import about, trace
from ..sheet.units import Metre, NewtonMetre, Number, Radian, RevPerSecond
from .checks import checks, speed_ratio
from .finite import finite
from .formulas import speed_ratio as speed_ratio_of
from .inputs import GearsInputs
from .layout.drawing import layout_curve
from .layout.forces import forces
from .layout.layout import layout
from .measures.measures import measures
from .pair import solve_mesh
from .play.backlash import backlash_at_shaft
from .play.backlash import residual_couple as _couple_of_phase_error
from .play.play import play, with_couple
from .profile.judge import checks as profile_checks
from .profile.judge import notes as profile_notes
from .profile.meshing import penetrations
from .rating.desk import Around
from .rating.load import Power
from .rating.rating import RatingResult, rating
from .result import MeshResult, ToothSystem, TrainResult, WheelResult, working_circles
from .train import Train, settle, speeds, tooth_system
from .wheel import solve_wheel

__all__ = ["NOT_RATED", "Around", "Power", "geometry", "merge", "rating", "residual_couple", "with_residual_couple", "with_speed_ratio"]


NOT_RATED = (
    "Not rated: no torque is known. Give gears.power_kW, or [bearings] and [friction], whose closed power balance gives it; stresses, "
    "safeties and forces on the axes have no values."
)


def geometry(gears: GearsInputs, first_speed: RevPerSecond) -> Outcome:
    """Shifts, circles, measures, contact and backlash of the whole train.  `first_speed` is that of the first driver.

    Raises NoSolution where wheels of these numbers can not be made, or can not mesh.
    """
    with trace() as lines:
        system = tooth_system(gears)
        train = settle(gears, system)
        n = speeds(gears, first_speed)
        wheels = {
            w.name: solve_wheel(gears, system, w, train.shifts[w.name], train.d[w.name], train.d_b[w.name], n[w.name]) for w in gears.wheels
        }
        meshes = {}
        for i, mesh in enumerate(gears.meshes):
            a_w = train.distances[key := mesh.key]
            meshes[key] = solve_mesh(system, mesh, f"gears.meshes.{i}", a_w, wheels[mesh.driver], wheels[mesh.driven])
        last = gears.meshes[-1].driven
        with about(f"train, to {last}"):
            free = backlash_at_shaft(wheels, meshes, last)
            ratio = speed_ratio_of(n_last=n[last], n_1=n[gears.meshes[0].driver])
        measured, spans, judged = _measured(gears, system, wheels, meshes)
        result = TrainResult(system=system, wheels=measured, meshes=meshes, speed_ratio=ratio, phase_error=free)
        depths = penetrations(result)
    result = replace(result, meshes={key: replace(mesh, penetration=depths[key]) for key, mesh in meshes.items()})
    return finite(
        Outcome(
            "gears", result=result, checks=(*checks(result), *judged, *profile_checks(result, depths)), lines=tuple(lines),
            tables=spans, errata=_errata(result) if gears.source_sheet == "finotti" else (),
            notes=(*_notes(gears, train, result), *profile_notes(result)),
        )
    )  # fmt: skip


def _measured(
    gears: GearsInputs, system: ToothSystem, wheels: Mapping[str, WheelResult], meshes: Mapping[str, MeshResult]
) -> tuple[dict[str, WheelResult], tuple[Table, ...], tuple[Check, ...]]:
    """The wheels with all that is measured on them, the tables of their spans, and what is judged."""
    found: dict[str, WheelResult] = {}
    spans: list[Table] = []
    judged: list[Check] = []
    for given in gears.wheels:
        name = given.name
        working = [(mate, d_w) for mate, d_w, _ in working_circles(meshes, name)]
        sizes, checked, table = measures(system, given, wheels[name], working)
        found[name] = replace(wheels[name], measures=sizes)
        spans.append(table)
        judged += checked
    return found, tuple(spans), tuple(judged)


def with_play(outcome: Outcome, gears: GearsInputs, materials: Mapping[str, Material], housing: str | None) -> Outcome:
    """What the backlash becomes over parts, chance, runout and temperature.  `housing`: the material between the centres."""
    with trace() as lines:
        played = play(gears, outcome.result, materials, housing)
    return replace(
        outcome,
        result=replace(outcome.result, play=played.meshes, train_play=played.train),
        checks=outcome.checks + played.checks,
        lines=outcome.lines + tuple(lines),
        curves=outcome.curves + played.curves(),
        tables=outcome.tables + played.tables(),
        notes=outcome.notes + played.notes,
    )


def with_layout(
    outcome: Outcome, gears: GearsInputs, axis: complex | None, eccentric: Radian | None, journals: tuple[Metre, Metre] | None,
    gear_end: str | None, couple: NewtonMetre | None,
) -> Outcome:  # fmt: skip
    """The train in its place; the arguments are those of `layout.layout`."""
    placed = layout(gears, outcome.result, axis, eccentric, journals, gear_end, couple)
    drawn = layout_curve(gears, outcome.result, placed.result)
    return replace(
        _joined(outcome, placed),
        result=replace(outcome.result, layout=placed.result),
        curves=outcome.curves + ((drawn,) if drawn is not None else ()),
    )


def merge(geometry: Outcome, rated: Outcome) -> Outcome:
    """One outcome from the geometry of a train and its rating; both keep their lines, checks, errata and notes."""
    train, stresses = geometry.result, rated.result
    assert isinstance(train, TrainResult) and isinstance(stresses, RatingResult)
    meshes = {key: replace(mesh, rating=stresses.meshes.get(key)) for key, mesh in train.meshes.items()}
    return replace(_joined(geometry, rated), result=replace(train, meshes=meshes))


def with_forces(outcome: Outcome, gears: GearsInputs) -> Outcome:
    """The forces on the axes of a train that is placed and rated."""
    train = outcome.result
    if train.layout is None:
        return outcome
    torques = {key: mesh.rating.torque for key, mesh in train.meshes.items()}
    found = forces(gears, train, train.layout, torques)
    return replace(_joined(outcome, found), result=replace(train, forces=found.result))


def without(outcome: Outcome, part: str, reason: str) -> Outcome:
    """The same outcome, with a failing check for a part of it that has no solution."""
    failed = check(
        f"gears.train.{part.split()[0]}", f"No solution: {part}", math.nan, ">=", 0.0, "", "the part has no values", f"{reason}.",
    )  # fmt: skip
    return replace(outcome, checks=(*outcome.checks, failed))


def _joined(one: Outcome, two: Outcome) -> Outcome:
    """The first outcome with everything that stands beside the result of the second."""
    return replace(
        one, checks=one.checks + two.checks, lines=one.lines + two.lines, curves=one.curves + two.curves, tables=one.tables + two.tables,
        errata=one.errata + two.errata, notes=one.notes + two.notes,
    )  # fmt: skip


def residual_couple(outcome: Outcome, couple: NewtonMetre) -> NewtonMetre:
    """What is left of a couple that the last wheel should cancel, when the whole backlash turns it out of phase."""
    return _couple_of_phase_error(couple, outcome.result.phase_error)


def with_residual_couple(outcome: Outcome, couple: NewtonMetre) -> Outcome:
    """The same outcome with the residual couple among its values and its line among its lines."""
    with trace() as lines, about("train, by its backlash"):
        left = residual_couple(outcome, couple)
        whole = outcome.result.train_play
        whole = whole if whole is None else with_couple(whole, couple)
    return replace(outcome, result=replace(outcome.result, residual_couple=left, train_play=whole), lines=outcome.lines + tuple(lines))


def with_speed_ratio(outcome: Outcome, wanted: Number, crank: RevPerSecond | None = None) -> Outcome:
    """The same outcome with the check that its last wheel turns as the shaft must; `wanted` −1: as fast as the crank, the other way.

    `crank`: its speed, where the first driver does not stand on it; the first driver is taken to turn as the crank does.
    """
    if outcome.state != "solved" or outcome.result is None:
        return outcome
    return replace(outcome, checks=(*outcome.checks, speed_ratio(outcome.result, wanted, crank)))


def _notes(gears: GearsInputs, train: Train, result: TrainResult) -> tuple[str, ...]:
    notes = list(train.notes)
    for mesh in result.meshes.values():
        name, thinned = f"{mesh.driver}–{mesh.driven}", any(result.wheels[w].allowance for w in (mesh.driver, mesh.driven))
        if not mesh.centre_tolerance and not thinned:
            notes.append(f"Mesh {name}: neither tolerance nor allowance is given: its backlash is 0.")
        elif not mesh.centre_tolerance:
            notes.append(f"Mesh {name}: no tolerance of the centre distance is given: it is taken as exact.")
        elif not thinned:
            notes.append(f"Mesh {name}: no allowance of the span is given: the teeth are taken without thinning.")
    notes.append("backlash_min and backlash_max hold at 20 °C without runout; cold, warm and with runout have values of their own.")
    if gears.ball_diameter is None:
        notes.append("Measuring ball: not given; chosen: for each wheel the preferred one that touches nearest to the middle of its flank.")
    notes.append("The standard tip shortening k*·m_n is shown, not applied: only the tip cut that is given shortens a wheel.")
    return tuple(notes)


def _errata(result: TrainResult) -> tuple[Erratum, ...]:
    """The source enters the speed of the first driver for the driver of every pair."""
    drivers = list(dict.fromkeys(mesh.driver for mesh in result.meshes.values()))
    first = result.wheels[drivers[0]]
    found = []
    for wheel in (result.wheels[name] for name in drivers):
        if wheel.teeth != first.teeth:
            found.append(
                Erratum(
                    f"gears.{wheel.name}.speed",
                    f"Speed of {wheel.name} by the sheet of Finotti 2013",
                    math.copysign(first.speed, wheel.speed) * 60,
                    "rpm",
                    "method of Finotti 2013, Tables 4.5 and 4.6",
                    f"The sheet enters the speed of the train's first wheel for {wheel.name} too; with {wheel.teeth} teeth against "
                    f"{first.teeth} it turns at {abs(wheel.speed) * 60:.1f} rpm.",
                )
            )
    return tuple(found)
