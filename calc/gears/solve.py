# SPDX-License-Identifier: Apache-2.0
"""The gear train from its inputs: geometry first, its rating once the torque is known, and both as one outcome.

`rating` stands in its own file and is offered here, so that the step has one door.
"""

import math
from dataclasses import replace

from ..sheet.step import Erratum, Outcome
from ..sheet.trace import about, trace
from ..sheet.units import NewtonMetre, Number, RevPerSecond
from .checks import checks, speed_ratio
from .finite import finite
from .inputs import GearsInputs
from .pair import solve_mesh
from .play.backlash import backlash_at_shaft
from .play.backlash import residual_couple as _couple_of_phase_error
from .rating.rating import RatingResult, rating
from .result import TrainResult
from .train import Train, mesh_key, settle, speeds, tooth_system
from .wheel import solve_wheel

__all__ = ["geometry", "merge", "rating", "residual_couple", "with_residual_couple", "with_speed_ratio"]


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
            a_w = train.distances[key := mesh_key(mesh)]
            meshes[key] = solve_mesh(system, mesh, f"gears.meshes.{i}", a_w, wheels[mesh.driver], wheels[mesh.driven])
        last = gears.meshes[-1].driven
        with about(f"train, to {last}"):
            play = backlash_at_shaft(wheels, meshes, last)
    result = TrainResult(system=system, wheels=wheels, meshes=meshes, phase_error=play)
    judged, notes = checks(result), _notes(gears, train, result)
    return finite(Outcome("gears", result=result, checks=judged, lines=tuple(lines), errata=_errata(result), notes=notes))


def merge(geometry: Outcome, rated: Outcome) -> Outcome:
    """One outcome from the geometry of a train and its rating; both keep their lines, checks, errata and notes."""
    train, stresses = geometry.result, rated.result
    assert isinstance(train, TrainResult) and isinstance(stresses, RatingResult)
    meshes = {key: replace(mesh, rating=stresses.meshes.get(key)) for key, mesh in train.meshes.items()}
    return replace(
        geometry,
        result=replace(train, meshes=meshes),
        checks=geometry.checks + rated.checks,
        lines=geometry.lines + rated.lines,
        errata=geometry.errata + rated.errata,
        notes=geometry.notes + rated.notes,
    )


def residual_couple(outcome: Outcome, couple: NewtonMetre) -> NewtonMetre:
    """What is left of a couple that the last wheel should cancel, when the whole backlash turns it out of phase."""
    return _couple_of_phase_error(couple, outcome.result.phase_error)


def with_residual_couple(outcome: Outcome, couple: NewtonMetre) -> Outcome:
    """The same outcome with the residual couple among its values and its line among its lines."""
    with trace() as lines, about("train, by its backlash"):
        left = residual_couple(outcome, couple)
    return replace(outcome, result=replace(outcome.result, residual_couple=left), lines=outcome.lines + tuple(lines))


def with_speed_ratio(outcome: Outcome, wanted: Number) -> Outcome:
    """The same outcome with the check that its last wheel turns as the shaft must; `wanted` −1: as fast as the first, the other way."""
    if outcome.state != "solved" or outcome.result is None:
        return outcome
    return replace(outcome, checks=(*outcome.checks, speed_ratio(outcome.result, wanted)))


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
    notes.append("Backlash is at equal temperature of wheels and housing, and without runout; a cold aluminium housing takes more of it.")
    if gears.ball_diameter is None:
        notes.append("Measuring ball: not given; chosen: for each wheel the ball that touches it in the middle of its flank.")
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
