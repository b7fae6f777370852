# SPDX-License-Identifier: Apache-2.0
"""The balancing sheet of a shaft whose masses are known: targets, rings, holes, and what a reading asks to be drilled.

What is permitted is that of the grade at the speed in service (making/unbalance.py): it turns with the shaft, as a
circle around the end of the target."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ...draw.drawing import TOUCH
from ...sheet.linked_array import column, item
from ...sheet.quantity import Described, Stated
from ...sheet.record import record
from ...sheet.text import Amount, Name, Text
from ...sheet.units import UNITS, KilogramMetre, KilogramPerMetre3, Metre, Number, Radian
from ...sheet.value import about, based_on
from ..inputs import EccentricMass, ShaftInputs
from ..making.unbalance import ToleranceResult
from ..outline import Outline, Piece
from . import formulas as f
from . import hole as h
from .drilling import amounts
from .inputs import ENGINE, OF_MASS, POINT, Balancing, MachineReading, from_to, within
from .result import PLANES, RINGS, BalancingPlane, BalancingResult, BalancingRing, Drill, HoleTakes, ReadingResult, Told

DISREGARDED = 0.05  # of U_per: an error of the machine below this share is none (ISO 21940-14)
STEPS = 10  # of the table of depths
DUST = 1e-12  # of what all masses have: a target below this has no direction


@record
class Made:
    """What the sheet needs of the shaft: `R`: outer radius of the sectors where it is known; densities of the sectors
    and of the rest."""

    masses: tuple[EccentricMass, ...]
    outline: Outline | None
    R: Metre | None
    of_sectors: KilogramPerMetre3
    of_core: KilogramPerMetre3
    permitted: ToleranceResult | None


def sheet(shaft: ShaftInputs, table: Balancing, made: Made) -> BalancingResult | None:
    """None where the zero of the shop is a mass that is not there (of a shaft that is sized: its masses are found)."""
    zero = table.zero_angle({mass.name: mass.angle for mass in made.masses})
    if zero is None:
        return None
    s = f.sense(shaft.speed_ratio, table.count)
    size = sum(abs(mass.mass * mass.radius) for mass in (*made.masses, *shaft.extras))
    planes = _planes(shaft, table, made, size, zero, s)
    z_1, z_2 = table.ring_positions or shaft.bearing_positions[:: len(shaft.bearing_positions) - 1]
    one, other = planes
    target = (one.vector, one.z, other.vector, other.z)
    with about(RINGS[0]):
        front = _ring(f.ring_front(*target, z_1=z_1, z_2=z_2), z_1, size, zero, s)
    with about(RINGS[1]):
        rear = _ring(f.ring_rear(*target, z_1=z_1, z_2=z_2), z_2, size, zero, s)
    asked = drills(shaft, table, made)
    holes = {drill.name: _hole(drill, planes) for drill in asked if drill.outside is None}
    return BalancingResult(
        front=planes[0],
        rear=planes[1],
        ring_front=front,
        ring_rear=rear,
        hole=holes,
        reading={each.serial: _reading(each, planes, tuple(holes.values()), zero, s) for each in table.readings},
        outside=tuple(drill for drill in asked if drill.outside is not None),
        inputs=table,
        zero=zero,
        sense=s,
        zero_words=zero_words(table),
    )


def zero_words(table: Balancing) -> Text:
    """Where the shop counts from."""
    try:
        return Text("{angle}° in the engine", angle=f"{float(table.zero):g}")
    except ValueError:
        pass
    if table.zero == ENGINE:
        return Text("up, with cylinder 1 at TDC")
    return Text("middle of mass {name}", name=Name(table.zero.removeprefix(OF_MASS)))


# --- planes and rings


def _planes(
    shaft: ShaftInputs, table: Balancing, made: Made, size: KilogramMetre, zero: Radian, s: Number
) -> tuple[BalancingPlane, BalancingPlane]:
    whole, per = (*made.masses, *shaft.extras), made.permitted
    z_f, z_r = shaft.bearing_positions[0], shaft.bearing_positions[-1]
    m, e, gamma, z = (column(whole, name) for name in ("mass", "radius", "angle", "z"))
    permitted = (
        (None, None) if per is None else (per.residual_unbalance_permitted_front, per.residual_unbalance_permitted_rear)
    )
    targets, errors = (f.target_front, f.target_rear), zip(table.measurement_errors, table.ring_tolerances)
    planes = []
    for words, target, at, most, (error, ring) in zip(PLANES, targets, (z_f, z_r), permitted, errors):
        with about(words):
            vector = target(m=m, e=e, gamma=gamma, z=z, z_f=z_f, z_r=z_r)
            U = f.length(U=vector)
            phi, alpha = _angles(vector, size, zero, s)
            planes.append(
                BalancingPlane(
                    target=U,
                    target_angle=phi,
                    shop_angle=alpha,
                    machine_force=f.machine_force(U=U, n_b=table.speed),
                    vector=vector,
                    z=at,
                    permitted=most,
                    error=f.uncertainty(s_m=error, s_r=ring) if error or ring else 0.0,
                    ring_error=ring,
                )
            )
    return planes[0], planes[1]


def _ring(vector: complex, z: Metre, size: KilogramMetre, zero: Radian, s: Number) -> BalancingRing:
    phi, alpha = _angles(vector, size, zero, s)
    return BalancingRing(unbalance=f.length(U=vector), angle=phi, shop_angle=alpha, vector=vector, z=z)


def _angles(vector: complex, size: KilogramMetre, zero: Radian, s: Number) -> tuple[Radian | None, Radian | None]:
    """The direction of an unbalance in the engine, and as the shop counts it; none where it is no more than rounding of
    what all masses have (`size`)."""
    if abs(vector) <= DUST * size:
        return None, None
    phi = f.direction(U=vector)
    return phi, f.shop_angle(s=s, phi=phi, phi_0=zero)


# --- holes


def drills(shaft: ShaftInputs, table: Balancing, made: Made) -> tuple[Drill, ...]:
    """The holes that are given, else the calibration holes, shared by the masses and in a row along each; none where it
    is not known from where they would be drilled."""
    if table.holes:
        given = (
            _drill(shaft, made, (o.name, o.z, o.angle, o.diameter, o.depth_max, o.point), o.radius) for o in table.holes
        )
        return tuple(drill for drill in given if drill is not None)
    if shaft.holes is None or made.outline is None or not made.masses:
        return ()
    each, more = divmod(shaft.holes.count, len(made.masses))
    names, found = [mass.name for mass in made.masses], []
    for i, mass in enumerate(made.masses):
        there = _own_stretch(made, mass)
        n = each + (i < more)
        if there is None:
            return ()
        length, name = there[1] - there[0], mass.name if names.count(mass.name) == 1 else f"{mass.name}-{i + 1}"
        for k in range(1, n + 1):
            z = based_on(mass.z + length * ((2 * k - 1) / (2 * n) - 0.5), mass.z, shaft.holes.count)
            size = f"{name}-{k}", z, mass.angle, shaft.holes.diameter, shaft.holes.depth, POINT
            drill = _drill(shaft, made, size, None)
            found += [] if drill is None else [drill]
    return tuple(found)


def _drill(
    shaft: ShaftInputs,
    made: Made,
    size: tuple[str, Metre, Radian, Metre, Metre, Radian],
    radius: Metre | None,
) -> Drill | None:
    """A hole with what stands around it; None where its outer radius is not known."""
    name, z, angle, diameter, depth, point = size
    piece, stretched = _piece(made.outline, z, angle), stretch(made.outline, z)
    if stretched is None:  # in none: it breaks out of the nearest one
        stretched = min(_stretches(made.outline), key=lambda run: max(run[0] - z, z - run[1]), default=None)
    R = radius if radius is not None else piece.outer_radius if piece is not None else made.R
    if R is None:
        return None
    sector = piece is not None and piece.half_angle is not None
    core = shaft.core_radius or 0.0
    if piece is not None:
        core = piece.core_radius if sector else made.outline.bore if made.outline is not None else 0.0
    start, end = stretched or ((piece.start, piece.end) if piece is not None else (-math.inf, math.inf))
    return Drill(
        name=name,
        z=z,
        angle=angle,
        diameter=diameter,
        depth=depth,
        point=point,
        R=R,
        core=core,
        start=start,
        end=end,
        middle=piece.angle if piece is not None else angle,
        half=piece.half_angle if piece is not None else None,
        density=made.of_sectors if sector or piece is None else made.of_core,
        outside=_outside(made.outline, piece, angle),
    )


def _outside(outline: Outline | None, piece: Piece | None, angle: Radian) -> Text | None:
    """Why a hole would be in the air, where the shape of the shaft is known."""
    if outline is None:
        return None
    if piece is None:
        low, high = (Amount(UNITS["mm"].shown(z), form="g") for z in (outline.start, outline.end))
        return Text("outside of the shaft, which goes from {low} to {high} mm", low=low, high=high)
    if piece.half_angle is None or within(angle, piece.angle, piece.half_angle):
        return None
    return Text("outside of its sector, which goes {where}", where=from_to(piece.angle, piece.half_angle))


def _piece(outline: Outline | None, z: Metre, angle: Radian | None = None) -> Piece | None:
    """What stands at a place: a sector rather than what touches it, of two sectors the one that reaches to `angle`."""
    pieces = [] if outline is None else [p for p in outline.pieces if p.start - TOUCH <= z <= p.end + TOUCH]
    sectors = [(piece, piece.half_angle) for piece in pieces if piece.half_angle is not None]
    reaching = [piece for piece, half in sectors if angle is not None and within(angle, piece.angle, half)]
    return next(iter((*reaching, *(piece for piece, _ in sectors), *pieces)), None)


def stretch(outline: Outline | None, z: Metre) -> tuple[Metre, Metre] | None:
    """Where the sector at a place begins and ends, with those of its angle that touch it; None where there is none."""
    return next((run for run in _stretches(outline) if run[0] - TOUCH <= z <= run[1] + TOUCH), None)


def _stretches(outline: Outline | None) -> list[tuple[Metre, Metre]]:
    """Where sectors begin and end."""
    if outline is None:
        return []
    runs: list[list[Piece]] = []
    for before, piece in pairwise((None, *outline.pieces)):
        assert piece is not None
        if piece.half_angle is None:
            continue
        if before is not None and before.half_angle is not None and before.angle == piece.angle:
            runs[-1].append(piece)
        else:
            runs.append([piece])
    return [(run[0].start, run[-1].end) for run in runs]


def _own_stretch(made: Made, mass: EccentricMass) -> tuple[Metre, Metre] | None:
    """The stretch of a mass: that of its sector; where several masses stand in one, the piece of its own."""
    there, piece = stretch(made.outline, mass.z), _piece(made.outline, mass.z)
    if there is None or piece is None:
        return None
    alone = sum(there[0] - TOUCH <= other.z <= there[1] + TOUCH for other in made.masses) == 1
    return there if alone else (piece.start, piece.end)


def _hole(drill: Drill, planes: tuple[BalancingPlane, BalancingPlane]) -> HoleTakes:
    with about(Text("hole {name}", name=Name(drill.name))):
        a = h.drill_radius(d=drill.diameter)
        l, q = h.cone_length(a=a, theta=drill.point), h.bottom_radius(R=drill.R, h=drill.depth)
        most = h.hole_unbalance(rho=drill.density, a=a, R=drill.R, q=q, l=l)
        least = h.least_depth(R=drill.R, a=a) if drill.R > a else math.nan
    z_f, z_r = planes[0].z, planes[1].z
    return HoleTakes(
        most=most,
        drill=drill,
        cone=l,
        least_depth=least,
        shares=((z_r - drill.z) / (z_r - z_f), (drill.z - z_f) / (z_r - z_f)),
        depths=tuple(
            h.depth_for.function(U=most * k / STEPS, rho=drill.density, a=a, R=drill.R, l=l)
            for k in range(1, STEPS + 1)
        ),
    )


# --- readings


def _reading(
    reading: MachineReading,
    planes: tuple[BalancingPlane, BalancingPlane],
    holes: Sequence[HoleTakes],
    zero: Radian,
    s: Number,
) -> ReadingResult:
    read = ((reading.front, reading.front_), (reading.rear, reading.rear_))
    before = []
    for plane, (U, alpha), words in zip(planes, read, PLANES):
        with about(Text("reading {serial}, {plane}", serial=Name(reading.serial), plane=words)):
            phi = f.engine_angle(s=s, alpha=alpha, phi_0=zero)
            before.append(f.excess(U_m=U, phi=phi, U_t=plane.vector if reading.kind == "total" else 0j))
    permitted = [plane.permitted for plane in planes]
    u, reach = np.zeros(len(holes)), np.zeros(len(holes))
    x = np.array([hole.shares for hole in holes], dtype=float).reshape(len(holes), 2).T
    gamma = np.array([hole.drill.angle for hole in holes])
    if holes and None not in permitted:
        takes, per = x * np.exp(1j * gamma), np.array(permitted, dtype=float)
        u = amounts(np.array(before), takes, per, np.array([hole.most for hole in holes], dtype=float))
        reach = amounts(np.array(before), takes, per, np.full(len(holes), math.inf))
    left, unreached = [], []
    for n, words in enumerate(PLANES):
        with about(Text("reading {serial}, {plane}, drilled", serial=Name(reading.serial), plane=words)):
            left.append(item(f.left(U_e=before[n], u=u, x=x[n], gamma=gamma)))
        unreached.append(complex(before[n] - np.sum(reach * x[n] * np.exp(1j * gamma))))
    ends = []
    for vector, words in zip(left, PLANES):
        with about(Text("reading {serial}, {plane}, drilled", serial=Name(reading.serial), plane=words)):
            ends.append(f.length(U=vector))
    return ReadingResult(
        front=ends[0],
        rear=ends[1],
        hole={hole.drill.name: _deep(hole, float(u_k)) for hole, u_k in zip(holes, u)},
        before=(before[0], before[1]),
        left=(left[0], left[1]),
        unreached=(unreached[0], unreached[1]),
        amounts={hole.drill.name: float(u_k) for hole, u_k in zip(holes, u)},
        as_read=_told(planes, [abs(U) for U in before]),
        told=_told(planes, [abs(U) for U in left]),
    )


def _deep(hole: HoleTakes, u: KilogramMetre) -> Stated:
    """How deep a hole goes; 0: it is not drilled."""
    drill = hole.drill
    label = Described(Text("Depth of hole {name}", name=Name(drill.name)), "mm", "h_k", short=True)
    if u <= DUST * hole.most:
        return Stated(label, based_on(0.0, hole.most))
    with about(Text("hole {name}, as deep as the reading asks", name=Name(drill.name))):
        a = h.drill_radius(d=drill.diameter)
        return Stated(label, h.depth_for(U=based_on(u, hole.most), rho=drill.density, a=a, R=drill.R, l=hole.cone))


def counted_error(plane: BalancingPlane) -> KilogramMetre:
    """The error that has to be reckoned with in a plane."""
    U = plane.permitted
    return 0.0 if U is None or plane.error <= DISREGARDED * U else plane.error


def _told(planes: tuple[BalancingPlane, BalancingPlane], U: Sequence[KilogramMetre]) -> tuple[Told, Told] | None:
    told: list[Told] = []
    for plane, found in zip(planes, U):
        if plane.permitted is None:
            return None
        error = counted_error(plane)
        over: Told = "fail" if found > plane.permitted + error else "between"
        told.append("pass" if found <= plane.permitted - error else over)
    return told[0], told[1]
