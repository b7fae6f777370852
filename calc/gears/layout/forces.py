# SPDX-License-Identifier: Apache-2.0
"""Forces between the teeth and on the axes of a train, once the torque of every mesh is known.

At the working circles, by the torque that is handed in: the mean one, or a peak.  Thrust is + along the axis of the
crank's rotation, which points towards the flywheel where the crank turns clockwise seen from its front end."""

from collections.abc import Mapping
from functools import reduce
from typing import NamedTuple

from ...sheet.deferred import Later
from ...sheet.linked_array import gathered
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, NewtonMetre, Number, PhasorNewton, Radian
from ...sheet.value import about, trace
from ..inputs import GearsInputs
from ..result import MeshResult, TrainResult
from . import formulas as f
from .curves import forces_notes, forces_tables
from .result import ForcesResult, LayoutResult, MeshForces, WheelForces


class Share(NamedTuple):
    """What one mesh does to one of its wheels."""

    force: PhasorNewton | None  # None: the line of centres is not known
    transverse: Newton
    thrust: Newton
    arm: Metre  # working diameter
    psi: Radian | None  # direction of the pitch point from the wheel's axis


def forces(
    gears: GearsInputs, train: TrainResult, layout: LayoutResult, torques: Mapping[str, NewtonMetre]
) -> Outcome[ForcesResult]:
    """`torques`: of the driver of every mesh, by the mesh ("a_b")."""
    turns = _turns(train)
    with trace() as lines:
        meshes, wheels = _all(gears, train, layout, torques, turns, gears.hands())
    result = ForcesResult(wheels=wheels, meshes=meshes)
    return Outcome(
        "gears",
        result=result,
        lines=tuple(lines),
        tables=Later(lambda: forces_tables(result)),
        notes=Later(lambda: forces_notes(gears, result, turns, _ends(train))),
    )


def axis_forces(gears: GearsInputs, train: TrainResult, torques: Mapping[str, NewtonMetre]) -> dict[str, Newton]:
    """The force of the teeth on the axis of every wheel, the largest it can be where the places of the wheels are not
    known.

    `torques` may be arrays: many operating points.
    """
    _, wheels = _all(gears, train, train.layout, torques, _turns(train), {})  # no hands: thrust is not asked for
    loads = {
        name: w.bearing_force if w.bearing_force is not None else w.bearing_force_max for name, w in wheels.items()
    }
    return {name: force for name, force in loads.items() if force is not None}


def _turns(train: TrainResult) -> dict[str, Number]:
    """+1 for the wheels that turn as the crank, −1 for the others."""
    return {name: float(sense) for name, sense in train.tree.senses.items()}


def _ends(train: TrainResult) -> list[str]:
    """The wheels on the shafts that are in a mesh."""
    meshing = {name for mesh in train.meshes.values() for name in (mesh.driver, mesh.driven)}
    return [turn.wheel for turn in train.shafts.values() if turn.wheel in meshing]


def _all(
    gears: GearsInputs,
    train: TrainResult,
    layout: LayoutResult | None,
    torques: Mapping[str, NewtonMetre],
    turns: Mapping[str, Number],
    hand: Mapping[str, str],
) -> tuple[dict[str, MeshForces], dict[str, WheelForces]]:
    shares: dict[str, list[Share]] = {w.name: [] for w in gears.wheels}
    meshes = {}
    for key, mesh in train.meshes.items():
        h = 1.0 if hand.get(mesh.driver) == "right" else -1.0
        gamma = layout.meshes[key].line_of_centres if layout is not None else None
        meshes[key] = _mesh(mesh, gamma, torques[key], turns[mesh.driver], h if hand else 0.0, shares)
    return meshes, {name: _wheel(name, hand.get(name, ""), parts) for name, parts in shares.items()}


def _mesh(
    mesh: MeshResult, gamma: Radian | None, T_1: NewtonMetre, s: Number, h: Number, shares: dict[str, list[Share]]
) -> MeshForces:
    """`s` +1: the driver turns as the crank; `h` +1: it is right-handed, 0: the wheels are spur."""
    d_w1, d_w2 = mesh.working_diameter_driver, mesh.working_diameter_driven
    with about(Text("mesh {pair}, forces", pair=mesh.title)):
        F_tw = f.tangential_force(T_1=T_1, d_w1=d_w1)
        F_rw = f.radial_force(F_tw=F_tw, alpha_wt=mesh.working_pressure_angle)
        F_bt = f.transverse_force(F_tw=F_tw, alpha_wt=mesh.working_pressure_angle)
        F_a: Newton | None = None
        on_1 = on_2 = 0.0
        if h:
            F_a = f.axial_force(F_tw=F_tw, beta_w=mesh.working_helix_angle)
            on_2 = f.thrust_on_driven(F_a=F_a, s=s, h=h)
            on_1 = f.thrust_on_driver(F_x2=on_2)
        F_1 = F_2 = back = None
        if gamma is not None:
            F_2 = f.force_on_driven(F_rw=F_rw, F_tw=F_tw, gamma=gamma, s=s)
            F_1 = f.force_on_driver(F_2=F_2)
            back = f.back_to_driver(gamma=gamma)
    shares[mesh.driver].append(Share(F_1, F_bt, on_1, d_w1, gamma))
    shares[mesh.driven].append(Share(F_2, F_bt, on_2, d_w2, back))
    return MeshForces(working_tangential_force=F_tw, working_radial_force=F_rw, axial_force=F_a)


def _wheel(name: str, hand: str, parts: list[Share]) -> WheelForces:
    values: dict[str, float] = {}
    placed = all(part.force is not None for part in parts)
    with about(Text("wheel {name}, forces", name=name)):
        if placed:
            F_W, *more = (part.force for part in parts if part.force is not None)
            for F_m in more:
                F_W = f.wheel_force(F_1=F_W, F_2=F_m)
            values["bearing_force"] = f.bearing_force(F_W=F_W)
            values["bearing_force_direction"] = f.force_direction(F_W=F_W)
        elif len(parts) == 1:
            values["bearing_force"] = parts[0].transverse
        elif len(parts) == 2:
            one, two = (part.transverse for part in parts)
            values["bearing_force_min"] = f.bearing_force_least(F_bt1=one, F_bt2=two)
            values["bearing_force_max"] = f.bearing_force_most(F_bt1=one, F_bt2=two)
        else:
            values["bearing_force_max"] = reduce(f.bearing_force_most, [part.transverse for part in parts])
        if hand:
            thrusts = gathered(part.thrust for part in parts)
            values["thrust"] = f.thrust(F_m=thrusts) if len(parts) > 1 else parts[0].thrust
            values |= _tilting(parts, placed)
    return WheelForces(**values, hand=hand)


def _tilting(parts: list[Share], placed: bool) -> dict[str, NewtonMetre]:
    if len(parts) == 1:
        return {"tilting_couple": f.tilting_of_one(F_x=parts[0].thrust, d_w=parts[0].arm)}
    if placed:
        C_K, *more = [f.tilting(F_x=part.thrust, d_w=part.arm, psi=part.psi) for part in parts if part.psi is not None]
        for C_m in more:
            C_K = f.tilting_sum(C_1=C_K, C_2=C_m)
        return {"tilting_couple": f.tilting_couple(C_K=C_K)}
    if len(parts) > 2:
        return {}
    one, two = (f.tilting_of_one(F_x=part.thrust, d_w=part.arm) for part in parts)
    return {
        "tilting_couple_min": f.tilting_least(M_1=one, M_2=two),
        "tilting_couple_max": f.tilting_most(M_1=one, M_2=two),
    }
