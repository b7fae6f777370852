# SPDX-License-Identifier: Apache-2.0
"""What stands still while the shaft turns: its weight and the force of its gear, on two bearings, beside the turning reactions."""

from dataclasses import replace
from typing import NamedTuple

from ..sheet.step import Outcome
from ..sheet.text import Text
from ..sheet.trace import about, trace
from ..sheet.units import Metre, Newton, Radian, RevPerSecond, Watt
from . import formulas as f
from .inputs import CountershaftInputs
from .outline import middles
from .result import CountershaftResult, Standing


class Gear(NamedTuple):
    """The wheel on the shaft, by its reference circle; `z`: its middle from mid-shaft."""

    diameter: Metre
    tip_diameter: Metre
    face_width: Metre
    normal_pressure_angle: Radian
    helix_angle: Radian


class Drive(NamedTuple):
    """What the wheel takes from the train."""

    power: Watt
    speed: RevPerSecond


def standing(reactions: tuple[Newton, Newton], positions: tuple[Metre, ...], weight: tuple[Newton, Newton, Newton] | None,
    gear: Gear | None, z_G: Metre | None, drive: Drive | None) -> Standing:  # fmt: skip
    """`reactions` turn with the shaft; `weight`: of the shaft, on its front and on its rear bearing; `drive` at its gear."""
    gear_forces: dict[str, Newton] = {}
    on_front: Newton = 0.0
    on_rear: Newton = 0.0
    if gear is not None and drive is not None and z_G is not None:
        torque = f.gear_torque(P=drive.power, n=drive.speed)
        z_f, z_r = positions[0], positions[-1]
        F_t = f.gear_tangential(T=torque, d=gear.diameter)
        F_r = f.gear_radial(F_t=F_t, alpha_n=gear.normal_pressure_angle, beta=gear.helix_angle)
        F_a = f.gear_axial(F_t=F_t, beta=gear.helix_angle)
        on_front = f.gear_on_front(F_t=F_t, F_r=F_r, F_a=F_a, d=gear.diameter, z_G=z_G, z_f=z_f, z_r=z_r)
        on_rear = f.gear_on_rear(F_t=F_t, F_r=F_r, F_a=F_a, d=gear.diameter, z_G=z_G, z_f=z_f, z_r=z_r)
        gear_forces = dict(gear_torque=torque, gear_force_tangential=F_t, gear_force_radial=F_r, gear_force_axial=F_a)
    G_S, G_f, G_r = weight if weight is not None else (None, 0.0, 0.0)
    if weight is None and not gear_forces:
        return Standing()
    front, rear = f.stationary(G_B=G_f, R_G=on_front), f.stationary(G_B=G_r, R_G=on_rear)
    return Standing(
        **gear_forces, weight=G_S, weight_front=None if weight is None else G_f, weight_rear=None if weight is None else G_r,
        stationary_front=front, stationary_rear=rear, reaction_front_peak=f.reaction_peak(R=reactions[0], R_0=front),
        reaction_rear_peak=f.reaction_peak(R=reactions[1], R_0=rear),
    )  # fmt: skip


def with_standing(outcome: Outcome[CountershaftResult], shaft: CountershaftInputs, gear: Gear | None,
    drive: Drive | None) -> Outcome[CountershaftResult]:  # fmt: skip
    """The same outcome with its weight and its gear's force on the bearings; on two bearings only."""
    if len(shaft.bearing_positions) != 2:
        return outcome
    with trace() as lines, about(Text("standing part of the load")):
        stands = standing_of(outcome.solution, shaft, gear, drive)
    return replace(outcome, result=replace(outcome.solution, standing=stands), lines=(*outcome.lines, *lines))


def standing_of(result: CountershaftResult, shaft: CountershaftInputs, gear: Gear | None, drive: Drive | None) -> Standing:
    """What stands still on the two bearings of a solved shaft; the power of its drive may be an array."""
    z_f, z_r = shaft.bearing_positions
    weight = None
    if result.mass is not None and result.centre_of_gravity is not None:
        G_S = f.weight(m_S=result.mass)
        G_r = f.weight_rear(G_S=G_S, z_S=result.centre_of_gravity, z_f=z_f, z_r=z_r)
        weight = G_S, f.weight_front(G_S=G_S, G_r=G_r), G_r
    reactions = result.reaction_front, result.reaction_rear
    return standing(reactions, shaft.bearing_positions, weight, gear, gear_place(shaft, result, gear), drive)


def gear_place(shaft: CountershaftInputs, result: CountershaftResult, gear: Gear | None) -> Metre | None:
    """The middle of the gear: given, or as the outline has it; else the front bearing's."""
    if gear is None:
        return None
    if shaft.gear_z is not None or result.outline is None:
        return shaft.gear_z if shaft.gear_z is not None else shaft.bearing_positions[0]
    return next((middles(z_1=p.start, z_2=p.end) for p in result.outline.pieces if p.what == "gear"), shaft.bearing_positions[0])
