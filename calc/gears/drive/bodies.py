# SPDX-License-Identifier: Apache-2.0
"""The train as bodies on its line of action: what turns, what drags, what plays, by the tree of its meshes.

The drag of a body is that of its journals or rolling bearings, seals, windage, churning and other losses, and what
hangs on its shaft; mesh losses are none of it."""

import cmath
import math
from collections.abc import Mapping, Sequence

import numpy as np

from ...library.catalogue import Material
from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import pi
from ...sheet.record import replace
from ...sheet.text import Text
from ...sheet.units import (
    Kilogram,
    KilogramMetre2,
    KilogramPerMetre3,
    Metre,
    Newton,
    NewtonMetre,
    Number,
    Radian,
)
from ...sheet.value import about
from ..backlash.formulas import play_angle_at_base
from ..inputs import GearsInputs
from ..rating.influence import full_stiffness, inner_diameter, must_leave_teeth
from ..result import TrainResult
from .inputs import DragRow
from .line import ShaftBody, TrainOnLine

GRAVITY = 9.80665  # m/s²
LIGHT_SHAFT = 0.01  # of the drag: gravity that turns a shaft by less is not counted


# --- what turns


@formula(
    "J_i",
    "dynamics: disc of the reference diameter, open inside its rim or its bore",
    unit="kg·mm²",
    meanings={"rho": "Density", "d_i": "Inside diameter of the rim"},
)
def wheel_inertia(rho: KilogramPerMetre3, b: Metre, d: Metre, d_i: Metre) -> KilogramMetre2:
    return pi / 32 * rho * b * (d**4 - d_i**4)


@formula("J", "mathematics: sum of what turns on one axis", unit="kg·mm²")
def with_shaft(J: KilogramMetre2, J_S: KilogramMetre2) -> KilogramMetre2:
    return J + J_S


@formula(
    "J_E",
    "dynamics, kinetic energy: with what the crank turns besides, by the square of its speed over the crank's",
    meanings={"i_k": "Speed of the body over that of the crank"},
)
def with_body(J: KilogramMetre2, J_k: KilogramMetre2, i_k: Number) -> KilogramMetre2:
    """>>> with_body(J=0.9, J_k=0.0069, i_k=-1.0)
    0.9069
    """
    return J + J_k * i_k**2


@formula(
    "M_i",
    "dynamics: moment of inertia as a mass on the line of action; r_b: base radius of the wheel that is driven",
    meanings={"r_b": "Base radius"},
)
def mass_on_line(J: KilogramMetre2, r_b: Metre) -> Kilogram:
    """>>> mass_on_line(J=0.00646, r_b=0.025086)
    10.265...
    """
    return J / r_b**2


@formula(
    "D_i",
    "statics: drag torque of a wheel with its shaft as a force on the line of action",
    meanings={"T_d": "Drag torque of the body", "r_b": "Base radius"},
)
def drag_on_line(T_d: NewtonMetre, r_b: Metre) -> Newton:
    return T_d / r_b


@formula(
    "j",
    "geometry: free turn of the driven wheel along the transverse line of action",
    unit="µm",
    meanings={"r_b": "Base radius"},
)
def play_on_line(phi_j: Radian, r_b: Metre) -> Metre:
    """>>> play_on_line(phi_j=0.0015, r_b=0.025)
    3.75...e-05
    """
    return phi_j * r_b


def inertias(
    gears: GearsInputs, train: TrainResult, shafts: Mapping[str, ShaftBody], materials: Mapping[str, Material]
) -> dict[str, KilogramMetre2]:
    """Of every wheel with its shaft; of a sprocket that turns beside no wheel what its shaft has."""
    on = {turn.wheel: shafts[name] for name, turn in train.shafts.items() if name in shafts}
    own: dict[str, KilogramMetre2] = {name: on[name].J if name in on else 0.0 for name in train.speeds}
    for w in gears.wheels:
        name, wheel, shaft = w.name, train.wheels[w.name], on.get(w.name)
        if shaft is not None and shaft.with_wheel:
            continue
        with about(Text("wheel {name}, inertia", name=name)):
            inside = must_leave_teeth(wheel, inner_diameter(wheel.root_diameter, w.bore_diameter, w.rim_thickness))
            J = wheel_inertia(rho=materials[w.material].density, b=wheel.face_width, d=wheel.pitch_diameter, d_i=inside)
            own[name] = J if shaft is None else with_shaft(J=J, J_S=shaft.J)
    return own


# --- the bodies


def on_line(
    train: TrainResult,
    own: Mapping[str, KilogramMetre2],
    materials: Mapping[str, Material],
    shafts: Mapping[str, ShaftBody],
) -> TrainOnLine:
    """`own`: what `inertias` gives.  All that gravity turns is there: `counted` leaves out what is too little."""
    on = {turn.wheel: shafts[name] for name, turn in train.shafts.items() if name in shafts}
    links, reached = train.tree.links, {train.tree.first: -1}
    r_first = _radius(train, train.tree.first)
    parent = list[int]()
    rho, radius, mass, width, stiffness = list[Number](), list[Metre](), list[Kilogram](), list[Metre](), list[float]()
    play: dict[str, list[Metre]] = {"nominal": [], "most": [], "least": []}
    for i, link in enumerate(links):
        before = reached[link.driver]
        r, r_before = _radius(train, link.driven), radius[before] if before >= 0 else r_first
        parent.append(before)
        radius.append(r)
        with about(Text("mesh {pair}, on the line of action", pair=link.title)):
            mass.append(mass_on_line(J=own[link.driven], r_b=r))
            if link.toothed:
                mesh = train.meshes[link.key]
                rho.append(_radius(train, link.driver) / r_before)
                width.append(mesh.face_width)
                stiffness.append(full_stiffness(train.system, mesh, train.wheels, materials))
                for corner, phi in _plays(train, link.key).items():
                    play[corner].append(play_on_line(phi_j=phi, r_b=r))
            else:
                rho.append(r * link.z_1 / (link.z_2 * r_before))
                width.append(0.0)
                stiffness.append(math.inf)
                for corner in play:
                    play[corner].append(0.0)
        reached[link.driven] = i
    turns = tuple(train.tree.turns(link.driven) for link in links)
    return TrainOnLine(
        links=links,
        parent=tuple(parent),
        rho=tuple(rho),
        radius=tuple(radius),
        first_radius=r_first,
        J=tuple(own[link.driven] for link in links),
        mass=tuple(mass),
        width=tuple(width),
        stiffness=tuple(stiffness),
        play={corner: tuple(plays) for corner, plays in play.items()},
        turns=turns,
        gravity=tuple(_gravity(on.get(link.driven), r) for link, r in zip(links, radius)),
        gravity_order=tuple(abs(on[link.driven].ratio) if link.driven in on else 0.0 for link in links),
    )


def _gravity(shaft: ShaftBody | None, r_b: Metre) -> complex:
    """G = U·g·sin θ/r_b, θ the angle of the unbalance from up, travelled in the shaft's own sense of rotation."""
    if shaft is None:
        return 0.0
    own_sense = math.copysign(1.0, shaft.ratio)
    return complex(-1j * cmath.exp(1j * own_sense * shaft.angle) * shaft.U * GRAVITY / r_b)


def counted(line: TrainOnLine, drag: Array) -> TrainOnLine:
    """The same without the gravity of shafts whose unbalance is but what rounding leaves; `drag` (B,) at idle."""
    little = [abs(G) <= LIGHT_SHAFT * D for G, D in zip(line.gravity, drag)]
    return replace(line, gravity=tuple(0.0 if out else G for G, out in zip(line.gravity, little)))


def _radius(train: TrainResult, name: str) -> Metre:
    """The base radius of a wheel; of a sprocket that turns beside none its pitch radius."""
    if name in train.wheels:
        return train.wheels[name].base_diameter / 2
    stage = next(stage for stage in train.stages.values() if name in (stage.driver, stage.driven))
    return (stage.pitch_diameter_driven if stage.driven == name else stage.pitch_diameter_driver) / 2


def plays_on_line(train: TrainResult, line: TrainOnLine) -> dict[str, tuple[Metre, ...]]:
    """The same of a train of these links with other shifts, tips or distances."""
    play: dict[str, list[Metre]] = {corner: [] for corner in line.play}
    for link, r in zip(line.links, line.radius):
        turns = _plays(train, link.key) if link.toothed else dict.fromkeys(play, 0.0)
        for corner, phi in turns.items():
            play[corner].append(play_on_line(phi_j=phi, r_b=r))
    return {corner: tuple(plays) for corner, plays in play.items()}


def _plays(train: TrainResult, key: str) -> dict[str, Radian]:
    """The free turn of the driven wheel: at mid-tolerance, largest and smallest when all is warm; where that is not
    known, by the tolerance of the centre distance alone."""
    mesh = train.meshes[key]
    d_b, beta_b = train.wheels[mesh.driven].base_diameter, train.system.base_helix_angle

    def turn(j_bn: Metre) -> Radian:
        return play_angle_at_base(j_bn=j_bn, beta_b=beta_b, d_b=d_b)

    if train.play is None:
        return {"nominal": turn(mesh.backlash_nominal), "most": mesh.play_angle, "least": turn(mesh.backlash_min)}
    play = train.play[key]
    return {"nominal": play.play_angle_nominal, "most": play.play_angle_running, "least": turn(play.backlash_running)}


# --- what drags


def measured(rows: Sequence[DragRow], wheel: str, speeds: Array) -> Array | None:
    """The drag of a wheel that is given over the speed of the crank, linear between the rows and constant outside; None
    where it is not."""
    mine = sorted((float(row.speed), float(row.torque)) for row in rows if row.wheel == wheel)
    return np.interp(speeds, [n for n, _ in mine], [T for _, T in mine]) if mine else None
