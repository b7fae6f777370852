# SPDX-License-Identifier: Apache-2.0
"""The reactions of a shaft on its supports: of the load that turns with it, and of what stands still.

Clapeyron's three moments for any number of supports: constant bending stiffness over the whole length, supports rigid
and in line, point loads, shear left out.  Loads and reactions are complex and turn with the shaft.  A moment is
positive where a load in the positive direction makes it so between two supports, so that the moments over inner
supports come out below zero (hogging)."""

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..sheet.arrays import Array, BoolArray, ComplexArray, IndexArray
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.record import replace
from ..sheet.step import Outcome
from ..sheet.text import Text
from ..sheet.units import (
    Metre,
    Metres,
    MetreTuple,
    Newton,
    PhasorNewton,
    PhasorNewtonMetres,
    PhasorNewtons,
    Radian,
    RevPerSecond,
    Watt,
)
from ..sheet.value import about, based_on, trace, untraced
from . import formulas as f
from .bending.condensed import OnSupports, at_rest, standing_on
from .bending.formulas import wheel_load
from .inputs import ShaftInputs
from .outline import Outline, middles
from .result import CountershaftResult, Standing
from .rows import BearingRow

if TYPE_CHECKING:
    from ..bearings.result import BearingsResult

CLAPEYRON = Text(
    "statics: bending moments over the supports, by Clapeyron's three moments (Finotti 2013, 3.2.3.1, for two spans; "
    "here any number)"
)


@formula(
    "M_i",
    CLAPEYRON,
    shows="M_1·L_1 + 2·M_2·(L_1 + L_2) + M_3·L_2 = −Σ F·a·(L_1² − a²)/L_1 − Σ F·b·(L_2² − b²)/L_2; "
    "M = −Σ F·a over the outer supports, a the distance of the loads beyond them",
)
def support_moments(F: PhasorNewtons, z: Metres, z_s: MetreTuple) -> PhasorNewtonMetres:
    """Bending moments over the supports at z_s, from loads F at z.  a is counted from the support away, b
    likewise."""
    load, place, support = _arrays(F, z, z_s)
    n, L = support.size, np.diff(support)
    first, last = place < support[0], place > support[-1]
    M = np.zeros(n, dtype=np.complex128)
    M[0] = -np.sum((load * (support[0] - place))[first])
    M[-1] = -np.sum((load * (place - support[-1]))[last])
    if n > 2:
        span, a, b, inside = _spans(place, support)
        L_s, load = L[span], load[inside]
        right, left = np.zeros(n, dtype=complex), np.zeros(n, dtype=complex)
        np.add.at(right, span + 1, load * a * (L_s**2 - a**2) / L_s)
        np.add.at(left, span, load * b * (L_s**2 - b**2) / L_s)
        wanted = -(right + left)[1:-1]
        wanted[0] -= M[0] * L[0]
        wanted[-1] -= M[-1] * L[-1]
        A = np.diag(2 * (L[:-1] + L[1:])) + np.diag(L[1:-1], 1) + np.diag(L[1:-1], -1)
        M[1:-1] = np.linalg.solve(A, wanted)
    return M


@formula(
    "R_i",
    "statics: reactions of the supports, from the equilibrium of each span after Clapeyron",
    shows="−(Σ F·b/L on the span behind + Σ F·a/L on the span ahead + moments' differences over the spans + overhung "
    "loads)",
)
def support_reactions(F: PhasorNewtons, z: Metres, z_s: MetreTuple, M: PhasorNewtonMetres) -> PhasorNewtons:
    """Forces of the supports on the shaft, from the loads and the moments over the supports."""
    load, place, support = _arrays(F, z, z_s)
    span, a, b, inside = _spans(place, support)
    L = np.diff(support)
    carried = np.zeros(support.size, dtype=np.complex128)
    carried[0] += np.sum(load[place < support[0]])
    carried[-1] += np.sum(load[place > support[-1]])
    np.add.at(carried, span, load[inside] * b / L[span])
    np.add.at(carried, span + 1, load[inside] * a / L[span])
    tilt = np.diff(M) / L
    carried[:-1] += tilt
    carried[1:] -= tilt
    return -carried


def reactions(F: ComplexArray, z: Array, positions: tuple[Metre, ...]) -> ComplexArray:
    """Forces of the supports on the shaft, front to rear.  `positions` rise; loads may lie between or beyond them.

    Raises NoSolution for less than two supports or two in one place.
    """
    if len(positions) < 2 or np.any(np.diff(positions) <= 0):
        raise NoSolution(
            Text("reactions of the shaft's supports"),
            Text(
                "{count} supports at {what} mm",
                count=len(positions),
                what=", ".join(f"{p * 1000.0:g}" for p in positions),
            ),
            Text("Give at least two bearings whose positions rise from front to rear."),
        )
    M = support_moments(F=F, z=z, z_s=positions)
    return support_reactions(F=F, z=z, z_s=positions, M=M)


def _arrays(F: ComplexArray, z: Array, z_s: tuple[Metre, ...]) -> tuple[ComplexArray, Array, Array]:
    return np.asarray(F, dtype=complex), np.asarray(z, dtype=float), np.asarray(z_s, dtype=float)


def _spans(place: Array, support: Array) -> tuple[IndexArray, Array, Array, BoolArray]:
    """Of each load between the outer supports: its span, and its distances from the support ahead of it and from that
    behind it."""
    inside = (place >= support[0]) & (place <= support[-1])
    span = np.clip(np.searchsorted(support, place[inside], side="right") - 1, 0, support.size - 2)
    return span, place[inside] - support[span], support[span + 1] - place[inside], inside


ROUNDING = 1e-6  # of the largest reaction: less may be no more than what rounding leaves, which has any direction


def phases_of(rows: Iterable[str], forces: Sequence[PhasorNewton]) -> dict[str, Radian]:
    """The directions of the forces of the supports on the shaft, by their names."""
    least = ROUNDING * max(map(abs, forces))
    return {row: f.reaction_phase(R=R) for row, R in zip(rows, forces) if abs(R) > least}


# --- what stands still while the shaft turns: its weight, the force of its gear, and bores out of line


class Gear(NamedTuple):
    """The wheel on the shaft, by its reference circle; `z`: its middle from mid-shaft."""

    diameter: Metre
    tip_diameter: Metre
    face_width: Metre
    normal_pressure_angle: Radian
    helix_angle: Radian


class Sprocket(NamedTuple):
    """One on the shaft, of the chain or belt `stage`; `tension`: what its tensioner gives both strands, 0 where that is
    not known."""

    stage: str
    diameter: Metre
    tension: Newton


class ShaftDrive(NamedTuple):
    """What the shaft takes from the train: by the teeth of its wheel, None where it has none, and what the chains and
    belts on its sprockets carry."""

    power: Watt | None
    speed: RevPerSecond
    strands: tuple[tuple[Sprocket, Watt], ...] = ()


def standing(
    loads: Mapping[str, Newton],
    places: Mapping[str, Metre],
    weight: tuple[Newton, Metre] | None,
    gear: Gear | None,
    z_G: Metre | None,
    drive: ShaftDrive | None,
) -> Standing:
    """Of two bearings, by their names: `loads` turn with the shaft; `weight`: of the shaft, and where its centre of
    gravity lies; `drive` at its gear."""
    of_gear: dict[str, Newton] = dict.fromkeys(places, 0.0)
    pull = None if z_G is None else _pull(drive)
    of_weight: dict[str, Newton] = dict.fromkeys(places, 0.0)
    (one, z_1), (other, z_2) = places.items()
    ends = ((one, z_1, z_2), (other, z_2, z_1))
    gear_forces = {} if z_G is None else _gear_forces(gear, drive)
    if gear_forces and gear is not None and z_G is not None:
        _, F_t, F_r, F_a = gear_forces.values()
        of_gear = {
            row: f.lever_gear(F_t=F_t, F_r=F_r, F_a=F_a, d=gear.diameter, z_G=z_G, z_o=z_o, z_B=z_B)
            for row, z_B, z_o in ends
        }
    if pull is not None and z_G is not None:
        for row, z_B, z_o in ends:
            R_K = f.lever_pull(F_K=pull, z_G=z_G, z_o=z_o, z_B=z_B)
            of_gear[row] = f.with_pull(R=of_gear[row], R_K=R_K)
    if weight is not None:
        G_S, z_S = weight
        of_weight = {row: f.lever_weight(G_S=G_S, z_S=z_S, z_o=z_o, z_B=z_B) for row, z_B, z_o in ends}
    if weight is None and not gear_forces and pull is None:
        return Standing(weights={}, stationary={}, peaks={})
    still = {row: f.stationary(G_B=of_weight[row], R_G=of_gear[row]) for row in places}
    return Standing(
        **gear_forces,
        chain_pull=pull,
        weight=None if weight is None else weight[0],
        weights={} if weight is None else of_weight,
        stationary=still,
        peaks={row: f.reaction_peak(R=loads[row], R_0=still[row]) for row in places},
    )


def _gear_forces(gear: Gear | None, drive: ShaftDrive | None) -> dict[str, Newton]:
    """Torque, and the tooth force tangential, radial and axial; none where the gear or its drive is not known."""
    if gear is None or drive is None or drive.power is None:
        return {}
    torque = f.gear_torque(P=drive.power, n=drive.speed)
    F_t = f.gear_tangential(T=torque, d=gear.diameter)
    F_r = f.gear_radial(F_t=F_t, alpha_n=gear.normal_pressure_angle, beta=gear.helix_angle)
    F_a = f.gear_axial(F_t=F_t, beta=gear.helix_angle)
    return dict(gear_torque=torque, gear_force_tangential=F_t, gear_force_radial=F_r, gear_force_axial=F_a)


def _pull(drive: ShaftDrive | None) -> Newton | None:
    """Of all chains and belts on the shaft, as if all pulled one way; None where there are none."""
    if drive is None or not drive.strands:
        return None
    pulls = []
    for sprocket, power in drive.strands:
        with about(Text("stage {name}", name=sprocket.stage)):
            F_t = f.gear_tangential(T=f.gear_torque(P=power, n=drive.speed), d=sprocket.diameter)
            pulls.append(f.strands_pull(F_t=F_t, F_S=sprocket.tension))
    return reduce(lambda F, F_K: f.pulls_together(F=F, F_K=F_K), pulls)


def on_supports(
    result: CountershaftResult, positions: tuple[Metre, ...], stiffness: Array | float
) -> OnSupports | None:
    """What stands on more than two bearings of that stiffness, N/m, infinite: rigid; None where nothing bends."""
    bent = result.bending
    if bent is None or result.outline is None or len(positions) == 2:
        return None
    with untraced():
        still = at_rest(result.outline, positions, bent.material, bent.points, bent.effectiveness, result.wheel)
        return standing_on(still, np.broadcast_to(stiffness, len(positions)))


def with_standing(
    outcome: Outcome[CountershaftResult],
    shaft: ShaftInputs,
    gear: Gear | None,
    drive: ShaftDrive | None,
    bearings: "BearingsResult | None",
) -> Outcome[CountershaftResult]:
    """The same outcome with its weight, its gear's force and that of bores out of line on the bearings."""
    result = outcome.solution
    stands = bearings.stands if bearings is not None else on_supports(result, shaft.bearing_positions, np.inf)
    if len(shaft.bearing_positions) > 2 and stands is None:
        return outcome
    with trace() as lines, about(Text("standing part of the load")):
        result = replace(result, standing=standing_of(result, shaft, gear, drive, stands, bearings))
    return replace(outcome, result=result, lines=(*outcome.lines, *lines))


def standing_of(
    result: CountershaftResult,
    shaft: ShaftInputs,
    gear: Gear | None,
    drive: ShaftDrive | None,
    stands: OnSupports | None,
    bearings: "BearingsResult | None",
) -> Standing:
    """What stands still on the bearings of a solved shaft; the power of its drive may be an array.

    `stands`: of more than two bearings what a load puts on each; `bearings`: what their bores may add."""
    if stands is not None:
        return _shared(result, shaft.bearings, gear, drive, stands, bearings)
    weight = None
    if result.mass is not None and result.centre_of_gravity is not None:
        weight = f.weight(m_S=result.mass), result.centre_of_gravity
    places = {row.name: row.position for row in shaft.bearings}
    return standing(result.loads, places, weight, gear, result.wheel, drive)


def _shared(
    result: CountershaftResult,
    rows: tuple[BearingRow, ...],
    gear: Gear | None,
    drive: ShaftDrive | None,
    stands: OnSupports,
    bearings: "BearingsResult | None",
) -> Standing:
    """Of more than two bearings, which share by their stiffness and the shaft's."""
    gear_forces, pull = ({}, None) if stands.force is None else (_gear_forces(gear, drive), _pull(drive))
    on_bores = stands.offset(np.array([complex(*(row.offset or (0.0, 0.0))) for row in rows]))
    still, peaks, weights = {}, {}, {}
    weight = None if result.mass is None else f.weight(m_S=result.mass)
    for i, row in enumerate(rows):
        G_u = based_on(stands.weight[i].item(), weight, row.position)
        weights[row.name] = f.weight_shared(G_u=G_u)
        R_G: Newton = 0.0
        if gear_forces and gear is not None and stands.force is not None and stands.couple is not None:
            _, F_t, F_r, F_a = gear_forces.values()
            G_F, G_C = abs(stands.force[i].item()), abs(stands.couple[i].item())
            R_G = wheel_load(G_F=G_F, G_C=G_C, F_t=F_t, F_r=F_r, F_a=F_a, d=gear.diameter)
        if pull is not None and stands.force is not None:
            R_G = f.with_pull(R=R_G, R_K=f.pull_shared(G_F=abs(stands.force[i].item()), F_K=pull))
        load, aligned = result.loads[row.name], None
        if bearings is not None:
            load = bearings.bearings[row.name].load
            on_shaft = bearings.bearings[row.name].on_shaft
            aligned = on_shaft.alignment_load if on_shaft is not None else None
        still[row.name] = f.stationary_shared(G_B=G_u, R_o=on_bores[i].item(), R_G=R_G, R_c=aligned or 0.0)
        peaks[row.name] = f.reaction_peak(R=load, R_0=still[row.name])
    return Standing(
        **gear_forces,
        chain_pull=pull,
        weight=weight,
        weights=weights,
        stationary=still,
        peaks=peaks,
    )


def gear_place(shaft: ShaftInputs, outline: Outline | None) -> Metre:
    """The middle of the gear, or of a sprocket that turns the shaft: given, or as the outline has it; else the front
    bearing's."""
    if shaft.gear_z is not None:
        return shaft.gear_z
    pieces = outline.pieces if outline is not None else ()
    places = (middles(z_1=piece.start, z_2=piece.end) for piece in pieces if piece.what == "gear")
    return next(places, shaft.bearing_positions[0])
