# SPDX-License-Identifier: Apache-2.0
"""What one step hands to another: numbers that stand in one table of a design, or in one result, and are needed in the
next."""

from collections.abc import Callable
from dataclasses import replace
from math import hypot
from typing import Any

from ..bearings.inputs import BearingsInputs
from ..bearings.result import BearingsResult
from ..bearings.selection.variants import SelectionCase
from ..bearings.solve import BearingMaterials
from ..bearings.speeds import highest_speed, of_journals
from ..countershaft.inputs import ShaftInputs
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import BearingRow
from ..countershaft.supports import Gear, ShaftDrive
from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..friction.journals import OnShaft
from ..friction.result import FrictionResult
from ..friction.solve import MeshOil
from ..gears.inputs import ONLY, GearsInputs
from ..gears.layout.solve import ShaftInTrain
from ..gears.rating.load import Irregularity, Power, ShaftInertia, Surroundings, Swing, firing_order
from ..gears.result import TrainResult
from ..gears.solve import NOT_RATED, Balanced
from ..library.lubricant import Lubricant
from ..mounting.wrenches import ShaftOnEngine
from ..sheet.errors import NoSolution
from ..sheet.step import Outcome
from ..sheet.text import Text
from ..sheet.value import based_on, recorded
from .model import STEPS, Design

NORMAL_95 = 1.96  # standard deviations on either side of the mean, within which 95 % lie


def unsolved(outcomes: tuple[Outcome[object], ...]) -> tuple[Outcome[object], ...]:
    """Those that a part has to wait for: where a step is not asked, what it hands on is given otherwise."""
    return tuple(outcome for outcome in outcomes if outcome.state not in ("solved", "not_asked"))


def first_speed(design: Design) -> float | None:
    """The speed of the train's first driver: given, or the crank's."""
    if design.gears is not None and design.gears.speed is not None:
        return design.gears.speed
    return design.engine.rated_speed if design.engine is not None else None


def rated_power(design: Design) -> float | None:
    """What the losses are a share of: None where the train turns at a speed of its own, at which the engine's power is
    not known."""
    own_speed = design.gears is not None and design.gears.speed is not None
    return design.engine.rated_power if design.engine is not None and not own_speed else None


def takes_first_order(design: Design) -> bool:
    """Whether a shaft of the design turns at −1 times crank speed."""
    return design.countershaft is not None and design.countershaft.speed_ratio == -1


def shafts(design: Design) -> tuple[str, ...]:
    """The names of the shafts that the train turns."""
    return (ONLY,)


def shaft_teeth(design: Design) -> int | None:
    """The teeth by which the train turns the counter-shaft: of its wheel, or of the sprocket beside that."""
    if design.countershaft is None or design.gears is None:
        return None
    return design.gears.tree.driving[design.gears.carrier()].z_2


def shaft_axis(design: Design) -> complex | None:
    """Where the counter-shaft stands beside the crank: real up, imaginary 90° further in the sense of rotation."""
    place = design.countershaft.axis if design.countershaft is not None else None
    return based_on(complex(*place), place) if place is not None else None


def shaft_axes(design: Design) -> dict[str, complex]:
    """Of the shafts that have a given one, by their names."""
    axis = shaft_axis(design)
    return {} if axis is None else {ONLY: axis}


def overrun(design: Design) -> float:
    """The highest speed that the engine runs at, over its rated one."""
    if design.engine is None:
        return 1.0
    rated, bench = of_journals(design.engine, design.own.speed_ratio if design.own is not None else None)
    return highest_speed(rated, bench, design.bearings) / rated


def journals(design: Design) -> tuple[tuple[float, float], ...]:
    """Diameter and length of the shaft's journals, front to rear; empty where they are not known."""
    return design.own.journals if design.own is not None else ()


def shaft_gear(design: Design, train: TrainResult | None) -> Gear | None:
    """The wheel on the counter-shaft; None where a sprocket alone turns it."""
    if train is None or design.gears is None or design.countershaft is None:
        return None
    wheel = train.wheels.get(design.gears.carrier())
    if wheel is None:
        return None
    return Gear(wheel.pitch_diameter, wheel.tip_diameter, wheel.face_width, train.system.alpha_n, train.system.beta)


def balanced(shaft: Outcome[CountershaftResult]) -> dict[str, Balanced]:
    """What the backlash of the train takes a part of, by shaft."""
    return {} if shaft.result is None else {ONLY: Balanced(shaft.result.couple)}


def ratios(design: Design) -> dict[str, float]:
    """How fast the shafts must turn, over the crank, by their names."""
    return {} if design.countershaft is None else {ONLY: design.countershaft.speed_ratio}


def bearing_materials(design: Design, bearings: BearingsInputs) -> BearingMaterials:
    """The oil of the bearings, and what journals and housing are made of; journals that are not given are those of the
    shaft."""
    shaft = design.countershaft.material if design.countershaft is not None else ""
    solids = design.materials
    return BearingMaterials(
        oil=bearings.in_bearings(design.oils[bearings.oil]),
        journal=solids[bearings.journal_material or shaft],
        housing=solids[bearings.housing_material],
    )


def mesh_oil(design: Design) -> MeshOil | None:
    """The oil on the teeth: given, or that of the bearings; None where neither is."""
    friction, there = design.friction, design.bearings
    name = (friction.oil if friction is not None else None) or (there.oil if there is not None else None)
    temperature = friction.oil_temperature if friction is not None else None
    if temperature is None and there is not None:
        temperature = there.supply_temperature
    if name is None or temperature is None:
        return None
    law = there.viscosity_law if there is not None else "walther"
    return MeshOil(oil=design.oils[name], viscosity_law=law, temperature=temperature)


def power(gears: GearsInputs, f: Outcome[FrictionResult]) -> Power | None:
    """The power that loads the teeth: the given one, else that of each mesh in the closed balance; None where neither
    is known."""
    if gears.power is not None:
        return Power(gears.power)
    if f.result is None:
        return None
    of_meshes = {key: mesh.power_in for key, mesh in f.result.meshes.items()}
    return Power(of_meshes | {key: stage.power_in for key, stage in f.result.stages.items()})


def not_rated(f: Outcome[FrictionResult]) -> Text:
    """Why the teeth have no power to be rated with."""
    if f.state not in ("no_solution", "blocked"):
        return NOT_RATED
    title = next(step.title for step in STEPS if step.key == f.key)
    return Text("Not rated: {titles} gives no power: {reason}.", titles=title, reason=f.reason)


def on_shafts(
    design: Design, shaft: Outcome[CountershaftResult], journals: Outcome[BearingsResult], gear: Gear | None
) -> dict[str, OnShaft]:
    """The journals that the train turns, by the names of their shafts; none where there are no bearings."""
    if journals.result is None:
        return {}
    return {ONLY: OnShaft(journals.result, shaft.result, design.countershaft, gear)}


def shaft_drive(design: Design, train: TrainResult | None, f: Outcome[FrictionResult]) -> ShaftDrive | None:
    """What drives the shaft's gear: the given power, else what its teeth carry in the closed balance."""
    if train is None or design.gears is None:
        return None
    wheel = train.wheels.get(design.gears.carrier())
    if wheel is None:
        return None
    power = design.gears.power
    if power is None and f.result is not None:
        power = f.result.at_teeth(wheel.name)
    speed = based_on(abs(wheel.speed), wheel.speed)
    return ShaftDrive(power, speed) if power is not None and speed else None


def irregularity(
    design: Design, engine: Outcome[EngineResult], shaft: Outcome[CountershaftResult]
) -> Irregularity | None:
    """How unevenly the first driver turns: given, else by the engine's torque on its flywheel; None where neither is
    known."""
    gears, crank = design.gears, design.engine
    speed = first_speed(design)
    if gears is None or speed is None:
        return None
    delta_s, order, swing = gears.speed_irregularity, gears.irregularity_order, None
    if delta_s is None:
        swing = _swing(engine, crank, speed)
        if swing is None:
            return None
    elif order is None:  # without a crank δ_s is 0, which has no order
        order = firing_order(crank.cylinders, crank.strokes) * crank.rated_speed / speed if crank is not None else 1.0
    outline = shaft.result.outline if shaft.result is not None else None
    J_S = shaft.result.moment_of_inertia if shaft.result is not None else None
    with_wheel = outline is not None and (not outline.derived or any(piece.what == "gear" for piece in outline.pieces))
    return Irregularity(delta_s, order, swing, {} if J_S is None else {ONLY: ShaftInertia(J_S, with_wheel)})


def _swing(engine: Outcome[EngineResult], crank: EngineInputs | None, speed: float) -> Swing | None:
    """The engine's torque over its cycle, where its gas and its flywheel are known."""
    torque = engine.result.torque if engine.result is not None else None
    if crank is None or torque is None or crank.flywheel_inertia is None:
        return None
    highest, mean, lowest = torque.torque_highest, torque.mean_torque, torque.torque_lowest
    if highest is None or mean is None or lowest is None:
        return None
    ratio = speed / crank.rated_speed
    return Swing(highest=highest, mean=mean, lowest=lowest, inertia=crank.flywheel_inertia, ratio=ratio)


def eccentric(design: Design, end: str | None) -> float | None:
    """Direction, with cylinder 1 at TDC, of the shaft's eccentric mass nearest to its gear, whose journal is `end`; of
    two in one plane that of the larger unbalance.  Where the gear's place is not known, the front is taken."""
    masses = design.countershaft.masses if design.countershaft is not None else ()
    away = -1 if end == "rear" else 1
    return min(masses, key=lambda x: (away * x.z, -x.mass * x.radius, x.angle)).angle if masses else None


def gear_end(design: Design, shaft: Outcome[CountershaftResult]) -> str | None:
    """At which journal the shaft's gear stands: where it is given, else as its outline is put together; None: not
    known."""
    given = design.countershaft
    z = given.gear_z if given is not None else None
    if z is None and shaft.result is not None and shaft.result.outline is not None:
        z = next((piece.start for piece in shaft.result.outline.pieces if piece.what == "gear"), None)
    if given is None or z is None:
        return None
    return "rear" if z > sum(given.bearing_positions) / len(given.bearing_positions) else "front"


def housing(design: Design) -> str | None:
    """The material between the centres: that of the gears, else that of the bearings."""
    material = design.gears.housing_material if design.gears is not None else None
    return material or (design.bearings.housing_material if design.bearings is not None else None)


def shafts_in_train(design: Design, shaft: Outcome[CountershaftResult]) -> dict[str, ShaftInTrain]:
    """What the place of the train has to know of the shafts on its wheels, by their names."""
    sizes, end = journals(design), gear_end(design, shaft)
    alone = ShaftInTrain(
        axis=shaft_axis(design),
        eccentric=eccentric(design, end),
        journals=(sizes[0][0], sizes[-1][0]) if sizes else None,
        gear_end=end,
        couple=shaft.result.couple if shaft.result is not None else None,
    )
    return {ONLY: alone}


def around_gears(design: Design, engine: Outcome[EngineResult], shaft: Outcome[CountershaftResult]) -> Surroundings:
    """What the rating of the teeth takes from other steps."""
    oil = mesh_oil(design)
    lubricant = Lubricant(oil.oil, oil.viscosity_law) if oil is not None else None
    Ra = design.friction.flank_roughness if design.friction is not None else None
    return Surroundings(
        uneven=irregularity(design, engine, shaft),
        lubricant=lubricant,
        oil_temperature=oil.temperature if oil is not None else None,
        flank_ra=(Ra[0], Ra[-1]) if Ra else None,
    )


def shaft_on_engine(
    design: Design, shaft: Outcome[CountershaftResult], train: Outcome[TrainResult]
) -> "ShaftOnEngine | None":
    """The counter-shaft as the engine's mounts see it; None where there is none."""
    countershaft, result = design.countershaft, shaft.result
    if countershaft is None or result is None:
        return None
    return ShaftOnEngine(
        countershaft.speed_ratio,
        result.force_vector,
        result.couple_vector,
        countershaft.paired,
        countershaft.axis,
        shaft_errors(design, result, train.result),
        shaft_teeth(design),
    )


def shaft_errors(design: Design, shaft: CountershaftResult, train: TrainResult | None) -> tuple[float, float] | None:
    """Error of the couple and of the angle of a shaft as it scatters: given, else what 95 % of the shafts stay below;
    None: not known."""
    given, scatter = design.mounting, shaft.scatter
    if given is None:
        return None
    s, delta = given.scatter_couple, given.late
    if scatter is not None and shaft.couple:
        of_couple = (scatter.couple_error_by_mass, scatter.couple_error_by_radius, scatter.couple_error_by_position)
        of_angle = (scatter.couple_error_by_angle, scatter.couple_error_by_timing)
        s = based_on(NORMAL_95 * hypot(*of_couple) / shaft.couple, of_couple, shaft.couple) if s is None else s
        turned = based_on(NORMAL_95 * hypot(*of_angle) / shaft.couple, of_angle, shaft.couple)
    else:
        turned = 0.0
    free = _free_turn(train)
    if delta is None and (free is not None or turned):
        delta = based_on(turned + (free or 0.0), turned, free)
    return (s or 0.0, delta or 0.0) if s is not None or delta is not None else None


def _free_turn(train: TrainResult | None) -> float | None:
    """Of the shaft's wheel: what 95 % of the trains stay below, else the worst case."""
    if train is None:
        return None
    by_chance = train.train_play[ONLY].phase_error_95 if train.train_play is not None else None
    return train.shafts[ONLY].phase_error if by_chance is None else by_chance


def bearings_case(design: Design, solve: Callable[..., Any], results: Any = None) -> "SelectionCase":
    """A design put as the question that the search for bearings answers.

    `solve`: that of the program, which stands above this room.  `results`: of the design, where it is solved already.
    Raises NoSolution where it has no bearings."""
    if design.bearings is None:
        lacks = Text("the design has no [bearings]")
        raise NoSolution(Text("there are no bearings to choose"), lacks, Text("give the table"))
    own = design.own
    assert own is not None  # bearings stand in its rows
    if len(own.bearings) != 2:
        three = Text("the shaft has {n}, which share its load", n=len(own.bearings))
        advice = Text("vary one of them: sweep its key, or set it")
        raise NoSolution(Text("only the bearings of a shaft that has two are searched"), three, advice)
    done = results if results is not None else solve(design)
    gear = shaft_gear(design, done.result(TrainResult))

    def with_bearings(bearings: BearingsInputs, rows: tuple[BearingRow, ...], *, last: bool = False) -> Any:
        enough = (lambda outcome: outcome.key == "bearings") if last else None
        changed = replace(design, bearings=bearings).with_shaft(replace(own, bearings=rows))
        with recorded(False):
            return solve(changed, done, enough=enough)

    return SelectionCase(
        design.bearings,
        own.bearings,
        design.own_key(ShaftInputs.bearings),
        design.countershaft,
        design.oils,
        tuple(oil.name for oil in design.oil),
        gear.tip_diameter if gear else None,
        done,
        with_bearings,
    )
