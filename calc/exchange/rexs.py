# SPDX-License-Identifier: Apache-2.0
"""A solved design as a file of REXS 1.7, for gear programs: its shafts in the flow of power, its wheels and stages.

Forces that turn with a shaft have no place there; what else is left out, or assumed, is said beside."""

from ..design import step_inputs as h
from ..gears.result import MeshResult, WheelResult
from ..gears.wheel_inputs import Wheel
from ..sheet.quantity import dotted, keys
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.value import untraced
from ..solve import Results
from .frame import date_of
from .places import HANDS
from .rexs_file import RexsModel, file_of, pose
from .rexs_shafts import WrittenShaft, add_section, add_shaft
from .rexs_unit import GearUnit

LEFT_OUT = Text(
    "Left out: the forces of the bearings, which turn with the shafts (--loads has them), and which tooth stands where."
)
NO_CRANK = Text("The supports of the crank are not part of this model: its shaft is as wide as its wheel.")
UNSAID = keys(Wheel)[dotted(Wheel.material)].field.default  # of a wheel on a shaft: one piece with it


@record
class Rexs:
    """`notes`: what is not in the file, or assumed in it."""

    model: RexsModel
    notes: tuple[Text, ...]
    date: str

    def file(self) -> bytes:
        """Its bytes, held against the table of REXS.  Raises FaultyFile."""
        return file_of(self.model, self.date, self.notes)


def has_parts(results: Results) -> bool:
    """Whether there is anything to write: a train, or a shaft that turns."""
    return results.train is not None or any(results.view(one.name).shaft for one in h.turning(results.design))


def rexs(results: Results) -> Rexs:
    """The model of a design with shafts or wheels that are solved."""
    with untraced():
        unit = GearUnit(results)
        unit.notes.append(Text("{axes}. u = Z, v = X, w = Y.", axes=unit.frame.words))
        _shafts(unit)
        for name in unit.along:
            if unit.train is not None and name in unit.train.wheels:
                _wheel(unit, unit.train.wheels[name])
        for mesh in unit.train.meshes.values() if unit.train is not None else ():
            _stage(unit, mesh)
        _left_out(unit)
    return Rexs(unit.model, tuple(dict.fromkeys(unit.notes)), f"{date_of(results.design)}T00:00:00+00:00")


def _shafts(unit: GearUnit) -> None:
    """In the flow of power, then those that the train does not turn."""
    carried = {unit.carrier(shaft): shaft for shaft in h.turning(unit.design)}
    for name in unit.along:
        if name in carried:
            WrittenShaft(unit, carried[name]).add()
        elif unit.train is not None and name in unit.train.wheels:
            _wheel_shaft(unit, unit.train.wheels[name])
    for shaft in h.turning(unit.design):
        if not unit.carrier(shaft):
            WrittenShaft(unit, shaft).add()


def _wheel_shaft(unit: GearUnit, wheel: WheelResult) -> None:
    """The crank as far as its wheel reaches, or an idler on its pin."""
    assert unit.train is not None
    name, b, z, axis = wheel.name, wheel.face_width, unit.planes[wheel.name], unit.places[wheel.name]
    start, crank = z - b / 2, name == unit.train.tree.first
    shaft = add_shaft(unit, name, axis, start, name, unit.train.speeds.get(name), None)
    unit.material(shaft, wheel.material)
    inside = _given(unit, name).bore_diameter or 0.0
    add_section(unit, shaft, "seat" if crank else "body", 0.0, b, wheel.root_diameter, inside)
    unit.carried[name] = shaft, start
    if not crank:
        pin = unit.model.add(
            "concept_bearing",
            f"{name} pin",
            u_coordinate_on_shaft_inner_side=b / 2,
            axial_force_absorption="both_directions",
            radial_force_absorption=True,
            **pose(unit.at(axis, z)),
        )
        unit.model.relate("side", assembly=pin, inner_part=shaft, outer_part=unit.casing)
        return
    unit.notes.append(NO_CRANK)
    balance = unit.results.friction.result
    if balance is not None:
        load = unit.model.add(
            "external_load",
            f"{name} drive",
            u_coordinate_on_shaft=0.0,
            torque_around_u_axis=unit.frame.turn * balance.crank_torque,
            defines_torque=True,
            transmits_torque=True,
        )
        unit.model.relate("assembly", assembly=shaft, part=load)


def _given(unit: GearUnit, name: str) -> Wheel:
    assert unit.design.gears is not None
    return next(wheel for wheel in unit.design.gears.wheels if wheel.name == name)


# --- wheels and stages


def _wheel(unit: GearUnit, wheel: WheelResult) -> None:
    if wheel.name not in unit.carried or unit.train is None or unit.design.gears is None:
        return  # its shaft is left out
    shaft, start = unit.carried[wheel.name]
    system, z, given = unit.train.system, unit.planes[wheel.name], _given(unit, wheel.name)
    hand = HANDS[unit.design.gears.hands().get(wheel.name, "")]
    upper, lower = wheel.allowance or (None, None)
    speed = unit.train.speeds.get(wheel.name)
    gear = unit.model.add(
        "cylindrical_gear",
        wheel.name,
        u_coordinate_on_shaft=z - start,
        number_of_teeth=wheel.teeth,
        normal_module=system.m_n,
        helix_angle_reference_diameter=hand * system.beta,
        face_width=wheel.face_width,
        rotational_speed=None if speed is None else unit.frame.turn * speed,
        tip_diameter=wheel.tip_diameter,
        root_diameter=wheel.root_diameter,
        root_form_diameter=wheel.form_diameter,
        reference_circle_diameter=wheel.reference_diameter,
        base_circle_diameter=wheel.base_diameter,
        number_of_teeth_for_span_measurement=wheel.span_teeth,
        span_measurement=wheel.span_length,
        upper_backlash_allowance_referenced_to_span=upper,
        lower_backlash_allowance_referenced_to_span=lower,
        arithmetic_average_roughness_flank=_roughness(unit, wheel.name),
        **pose(unit.at(unit.places[wheel.name], z)),
    )
    unit.gears[wheel.name] = gear
    unit.model.relate("assembly", assembly=shaft, part=gear)
    flanks = {
        side: unit.model.add(
            "cylindrical_gear_flank",
            f"{wheel.name} {side}",
            normal_pressure_angle=system.alpha_n,
            addendum_modification_coefficient=wheel.profile_shift,
        )
        for side in ("left", "right")
    }
    unit.model.relate("flank", gear=gear, **flanks)
    on = {unit.carrier(one): one.inputs.material for one in unit.design.resolved}.get(wheel.name, wheel.material)
    if given.material not in (UNSAID, on):
        unit.material(gear, given.material)


def _roughness(unit: GearUnit, name: str) -> float | None:
    """Ra of the flanks of a wheel; None: not known, or one number as a driver and another as a driven wheel."""
    friction = unit.design.friction
    if friction is None or unit.train is None:
        return None
    first, last = friction.flank_roughness[0], friction.flank_roughness[-1]
    meshes = unit.train.meshes.values()
    there = {Ra for mesh in meshes for wheel, Ra in ((mesh.driver, first), (mesh.driven, last)) if wheel == name}
    return there.pop() if len(there) == 1 else None


def _stage(unit: GearUnit, mesh: MeshResult) -> None:
    train, gears = unit.train, unit.design.gears
    if train is None or gears is None or not {mesh.driver, mesh.driven} <= unit.gears.keys():
        return
    key, rating = f"{mesh.driver}_{mesh.driven}", mesh.rating
    factor = rating.application_factor if rating is not None else gears.application_factor
    stage = unit.model.add(
        "cylindrical_stage",
        key,
        center_distance=mesh.centre_distance,
        radial_contact_ratio=mesh.transverse_contact_ratio,
        overlap_contact_ratio=mesh.overlap_ratio or None,
        total_contact_ratio=mesh.total_contact_ratio,
        minimum_normal_backlash=mesh.backlash_min,
        maximum_normal_backlash=mesh.backlash_max,
        upper_center_distance_allowance=mesh.centre_tolerance or None,
        lower_center_distance_allowance=mesh.centre_tolerance or None,
        **{f"application_factor_iso_6336_{gears.iso_6336_edition}": factor},
    )
    unit.model.relate("assembly", assembly=unit.gear_unit, part=stage)
    unit.model.relate("stage", stage=stage, gear_1=unit.gears[mesh.driver], gear_2=unit.gears[mesh.driven])
    if unit.mesh_oil is not None:
        unit.model.relate("reference", origin=stage, referenced=unit.mesh_oil)
    mean = rating.mean_torque if rating is not None else None
    ratio = train.wheels[mesh.driven].teeth / train.wheels[mesh.driver].teeth
    sides = (
        (mesh.driver, True, mesh.working_diameter_driver, mean),
        (mesh.driven, False, mesh.working_diameter_driven, None if mean is None else mean * ratio),
    )
    for name, drives, d_w, torque in sides:
        sense = unit.frame.turn * train.tree.senses[name]
        data = unit.model.add(
            "cylindrical_stage_gear_data",
            f"{name} in {key}",
            is_driving_gear=drives,
            pitch_diameter=d_w,
            operating_pressure_angle_in_the_transverse_section=mesh.working_pressure_angle,
            torque=None if torque is None else sense * torque,
        )
        unit.model.relate("stage_gear_data", stage=stage, gear=unit.gears[name], stage_gear_data=data)


# --- what is not there


def _left_out(unit: GearUnit) -> None:
    gears = unit.design.gears
    if unit.train is not None and gears is not None:
        for stage in gears.stages:
            unit.notes.append(
                Text("{stage}: a chain or belt has no component in REXS, it is left out.", stage=stage.name)
            )
        for mesh in gears.meshes:
            if mesh.scissor is not None:
                words = Text(
                    "{mesh}: the split wheel is one of its whole width there, without its spring.", mesh=mesh.title
                )
                unit.notes.append(words)
        if unit.train.tree.first not in unit.train.wheels:
            unit.notes.append(Text("The crank is left out: no wheel turns with it."))
    for shaft in unit.design.shafts:
        if shaft.loads:
            unit.notes.append(Text("What hangs on {shaft} ([[shafts.loads]]) is left out.", shaft=shaft.name))
    if unit.design.shafts:
        unit.notes.append(LEFT_OUT)
