# SPDX-License-Identifier: Apache-2.0
"""What stands still while the shaft turns: its weight and the force of its gear, on two bearings, beside the turning reactions."""

from typing import NamedTuple

from ..sheet.quantity import result, value
from ..sheet.units import Metre, Newton, NewtonMetre, Radian
from . import formulas as f


class Gear(NamedTuple):
    """The wheel on the shaft, by its reference circle; `z`: its middle from mid-shaft."""

    diameter: Metre
    face_width: Metre
    normal_pressure_angle: Radian
    helix_angle: Radian


@result
class Standing:
    """The standing part of the bearings' load, and the largest load over a turn."""

    weight: Newton | None = value("Weight of the shaft", "N", "G_S", default=None)
    weight_front: Newton | None = value("Weight on the front bearing", "N", "G_f", default=None)
    weight_rear: Newton | None = value("Weight on the rear bearing", "N", "G_r", default=None)
    gear_torque: NewtonMetre | None = value("Torque at the shaft's gear", "N·m", "T", default=None)
    gear_force_tangential: Newton | None = value("Tooth force, tangential", "N", "F_t", default=None)
    gear_force_radial: Newton | None = value("Tooth force, radial", "N", "F_r", default=None)
    gear_force_axial: Newton | None = value("Tooth force, axial", "N", "F_a", default=None)
    stationary_front: Newton | None = value("Standing part at the front bearing, at most", "N", "R_0,f", default=None)
    stationary_rear: Newton | None = value("Standing part at the rear bearing, at most", "N", "R_0,r", default=None)
    reaction_front_peak: Newton | None = value("Largest load of the front bearing over a turn", "N", default=None)
    reaction_rear_peak: Newton | None = value("Largest load of the rear bearing over a turn", "N", default=None)


def standing(
    reactions: tuple[Newton, Newton], positions: tuple[Metre, ...], weight: tuple[Newton, Newton, Newton] | None,
    gear: Gear | None, z_G: Metre | None, torque: NewtonMetre | None,
) -> Standing:  # fmt: skip
    """`reactions` turn with the shaft; `weight`: of the shaft, on its front and on its rear bearing; `torque` at its gear."""
    found: dict[str, Newton] = {}
    on_front: Newton = 0.0
    on_rear: Newton = 0.0
    if gear is not None and torque is not None and z_G is not None:
        z_f, z_r = positions[0], positions[-1]
        F_t = f.gear_tangential(T=torque, d=gear.diameter)
        F_r = f.gear_radial(F_t=F_t, alpha_n=gear.normal_pressure_angle, beta=gear.helix_angle)
        F_a = f.gear_axial(F_t=F_t, beta=gear.helix_angle)
        on_front = f.gear_on_front(F_t=F_t, F_r=F_r, F_a=F_a, d=gear.diameter, z_G=z_G, z_f=z_f, z_r=z_r)
        on_rear = f.gear_on_rear(F_t=F_t, F_r=F_r, F_a=F_a, d=gear.diameter, z_G=z_G, z_f=z_f, z_r=z_r)
        found = dict(gear_torque=torque, gear_force_tangential=F_t, gear_force_radial=F_r, gear_force_axial=F_a)
    G_S, G_f, G_r = weight if weight is not None else (None, 0.0, 0.0)
    if weight is None and not found:
        return Standing()
    front, rear = f.stationary(G_B=G_f, R_G=on_front), f.stationary(G_B=G_r, R_G=on_rear)
    return Standing(
        **found,
        weight=G_S,
        weight_front=G_f if weight is not None else None,
        weight_rear=G_r if weight is not None else None,
        stationary_front=front,
        stationary_rear=rear,
        reaction_front_peak=f.reaction_peak(R=reactions[0], R_0=front),
        reaction_rear_peak=f.reaction_peak(R=reactions[1], R_0=rear),
    )
