# SPDX-License-Identifier: Apache-2.0
"""What one step hands to another: numbers that stand in one table of a design, or in one result, and are needed in the next."""

from typing import Any

from .countershaft.standing import Drive, Gear
from .design import Design
from .engine.inputs import EngineInputs
from .friction.journals import OnShaft
from .gears.rating.desk import Around
from .gears.rating.load import Irregularity, Power, Swing, firing_order
from .gears.result import TrainResult
from .lubricant import Lubricant
from .sheet.step import Outcome


def first_speed(design: Design) -> float | None:
    """The speed of the train's first driver: given, or the crank's."""
    if design.gears is not None and design.gears.speed is not None:
        return design.gears.speed
    return design.engine.rated_speed if design.engine is not None else None


def takes_first_order(design: Design) -> bool:
    """Whether a shaft of the design turns at −1 times crank speed."""
    return design.countershaft is not None and design.countershaft.speed_ratio == -1


def shaft_teeth(design: Design) -> int | None:
    """The teeth of the wheel on the counter-shaft: the last of the train."""
    if design.countershaft is None or design.gears is None:
        return None
    teeth = {wheel.name: wheel.teeth for wheel in design.gears.wheels}
    return teeth[design.gears.meshes[-1].driven]


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
    wheel = train.wheels[design.gears.meshes[-1].driven]
    return Gear(wheel.pitch_diameter, wheel.tip_diameter, wheel.face_width, train.system.alpha_n, train.system.beta)


def mesh_oil(design: Design) -> tuple[str, str, float | None]:
    """Name, viscosity law and temperature of the oil on the teeth: given, or that of the bearings."""
    own, there = design.friction, design.bearings
    oil = name_of(own, "oil") or name_of(there, "oil")
    law = there.viscosity_law if there is not None else "walther"
    given = own.oil_temperature if own is not None else None
    return oil, law, given if given is not None else there.supply_temperature if there is not None else None


def power(design: Design, geometry: Outcome, f: Outcome, first_speed: float | None) -> Power | None:
    """The power that loads the teeth: the given one, else that of each mesh in the closed balance; None where neither is known."""
    if geometry.state != "solved" or design.gears is None or not first_speed:
        return None
    if design.gears.power is not None:
        return Power(design.gears.power)
    if f.state != "solved":
        return None
    return Power({key: mesh.power_in for key, mesh in f.result.meshes.items()})


def on_shaft(design: Design, shaft: Outcome, journals: Outcome, gear: Gear | None) -> OnShaft | None:
    """The counter-shaft's journals at the end of the train; None where there are none."""
    if journals.result is None:
        return None
    return OnShaft(journals.result, shaft.result, design.countershaft, gear)


def shaft_drive(design: Design, train: TrainResult | None, f: Outcome) -> Drive | None:
    """What drives the shaft's gear: the given power, else what the last mesh passes on in the closed balance."""
    if train is None or design.gears is None:
        return None
    power = design.gears.power
    if power is None and f.state == "solved":
        power = list(f.result.meshes.values())[-1].power_out
    speed = abs(train.wheels[design.gears.meshes[-1].driven].speed)
    return Drive(power, speed) if power is not None and speed else None


def name_of(inputs: Any, attribute: str) -> str:
    """The name of an oil or material that a step asks for; empty where the step is not asked."""
    return getattr(inputs, attribute, None) or ""


def irregularity(design: Design, engine: Outcome, shaft: Outcome) -> Irregularity | None:
    """How unevenly the first driver turns: given, else by the engine's torque on its flywheel; None where neither is known."""
    own, crank = design.gears, design.engine
    speed = first_speed(design)
    if own is None or speed is None:
        return None
    delta_s, order, swing = own.speed_irregularity, own.irregularity_order, None
    if delta_s is None:
        swing = _swing(engine, crank, speed)
        if swing is None:
            return None
    elif order is None and crank is not None:
        order = firing_order(crank.cylinders, crank.strokes) * crank.rated_speed / speed
    outline = shaft.result.outline if shaft.result is not None else None
    J_S = shaft.result.moment_of_inertia if shaft.result is not None else None
    with_wheel = outline is not None and (not outline.derived or any(piece.what == "gear" for piece in outline.pieces))
    return Irregularity(delta_s, order, swing, J_S, with_wheel)


def _swing(engine: Outcome, crank: EngineInputs | None, speed: float) -> Swing | None:
    """The engine's torque over its cycle, where its gas and its flywheel are known."""
    torque = engine.result.torque if engine.result is not None else None
    if crank is None or torque is None or torque.mean_torque is None or crank.flywheel_inertia is None:
        return None
    ratio = speed / crank.rated_speed
    return Swing(torque.torque_highest, torque.mean_torque, torque.torque_lowest, crank.flywheel_inertia, ratio)


def eccentric(design: Design) -> float | None:
    """Direction of the shaft's first eccentric mass with cylinder 1 at TDC."""
    masses = design.countershaft.masses if design.countershaft is not None else ()
    return masses[0].angle if masses else None


def gear_end(design: Design, shaft: Outcome) -> str | None:
    """At which journal the shaft's gear stands: where it is given, else as its outline is put together; None: not known."""
    given = design.countershaft
    z = given.gear_z if given is not None else None
    if z is None and shaft.result is not None and shaft.result.outline is not None:
        z = next((piece.start for piece in shaft.result.outline.pieces if piece.what == "gear"), None)
    if given is None or z is None:
        return None
    return "rear" if z > sum(given.bearing_positions) / len(given.bearing_positions) else "front"


def housing(design: Design) -> str | None:
    """The material between the centres: that of the gears, else that of the bearings."""
    own = design.gears.housing_material if design.gears is not None else None
    return own or name_of(design.bearings, "housing_material") or None


def ends(places: tuple[tuple[float, float], ...]) -> tuple[float, float] | None:
    """Diameters of the first and the last journal."""
    return (places[0][0], places[-1][0]) if places else None


def around_gears(design: Design, engine: Outcome, shaft: Outcome) -> Around:
    """What the rating of the teeth takes from other steps."""
    oil, law, temperature = mesh_oil(design)
    lubricant = Lubricant(design.oils[oil], law) if oil in design.oils else None
    Ra = design.friction.flank_roughness if design.friction is not None else None
    return Around(irregularity(design, engine, shaft), lubricant, temperature, (Ra[0], Ra[-1]) if Ra else None)
