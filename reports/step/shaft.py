# SPDX-License-Identifier: Apache-2.0
"""A shaft as a solid: its core one closed profile turned about the axis, a prism for each sector; then its bore and its
holes are cut.  Its origin is on its own axis at mid-shaft, turned as at TDC of cylinder 1.

What the solid weighs is held against the program's own mass properties before anything is written."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise

import numpy as np

from calc.countershaft.mass_properties import MassProperties, mass_properties
from calc.countershaft.outline import Outline, Piece, outline
from calc.exchange.frame import Frame
from calc.sheet.arrays import Array
from calc.sheet.units import KilogramPerMetre3, Metre, Radian
from calc.sheet.value import recorded
from reports.step.kernel import (
    KernelFault,
    Point,
    Shape,
    StepPart,
    along,
    arc,
    cut,
    demand_valid,
    face,
    fused,
    line,
    polygon,
    prism,
    properties,
    revolved,
)

MM = 1e3
SAME = 1e-9  # m: radii closer than this are one
SAME_ANGLE = 1e-9
HALF_TURN = math.pi - 1e-9  # a sector of this half-angle is a full cylinder
CLOSE = 1e-6  # of the solid to the program's mass, centre and tensor
OF_DRILLED = 1e-12  # of the volume: the moments of a drilled solid are then as close as 1e-10
ROUND = 1.0  # mm: what a tool stands out beyond what it cuts


@dataclass(frozen=True)
class Hole:
    """A radial hole by a drill: its full diameter goes to `depth` from the radius `R`, and its cone on from there."""

    name: str
    z: Metre
    angle: Radian
    R: Metre
    diameter: Metre
    depth: Metre
    point: Radian


@dataclass(frozen=True)
class Weighed:
    """What a solid weighs, in the frame of the file, in mm and kg; its tensor is about its centre, with −∫ab dm."""

    name: str
    volume: float  # mm³
    mass: float
    centre: Array
    tensor: Array


@dataclass(frozen=True)
class WeighedPart:
    """A shaft or a wheel as a part: of each of its solids what it weighs, all of them, and before anything was drilled;
    the same by the program, and how far they are apart of it (mass, centre over the shaft's length, tensor over its
    largest)."""

    part: StepPart
    solids: tuple[Weighed, ...]
    whole: Weighed
    undrilled: Weighed
    by_program: Weighed
    deviation: float
    holes: tuple[Hole, ...] = ()


def shaft_solid(
    name: str, shape: Outline, rho: KilogramPerMetre3, frame: Frame, holes: Sequence[Hole] = ()
) -> WeighedPart:
    """`rho`: density of the core.  Raises KernelFault where the solid is not valid, or not what the program weighs."""
    pieces = tuple(_turned(piece, frame) for piece in drawn_pieces(shape))
    bodies = _bodies(name, pieces, shape.heavier != 1)
    densities = {name: rho, _sectors(name): rho * shape.heavier}
    if shape.bore:
        bore = cylinder(shape.bore * MM, pieces[0].start * MM - ROUND, pieces[-1].end * MM + ROUND)
        bodies = tuple((body, cut(solid, bore)) for body, solid in bodies)
    for body, solid in bodies:
        demand_valid(solid, body)
    undrilled = together(name, [_weighed(body, solid, densities[body]) for body, solid in bodies])
    by_program = _by_program(name, replace_pieces(shape, pieces), rho)
    deviation = apart(undrilled, by_program, (pieces[-1].end - pieces[0].start) * MM)
    if not deviation <= CLOSE:
        raise KernelFault(f"the solid of {name} is off the program's mass properties by {deviation:.1e}")
    if holes:
        bodies = tuple((body, _drilled(body, solid, holes, frame)) for body, solid in bodies)
    weights = [_weighed(body, solid, densities[body], bool(holes)) for body, solid in bodies]
    return WeighedPart(
        StepPart(name, bodies), tuple(weights), together(name, weights), undrilled, by_program, deviation, tuple(holes)
    )


# --- the pieces as they are drawn


def drawn_pieces(shape: Outline) -> list[Piece]:
    """The pieces of the solid: each begins where the one before it ends, and neighbours of the same section are one."""
    row: list[Piece] = []
    for piece in shape.pieces:
        if row and _alike(row[-1], piece):
            row[-1] = replace(row[-1], end=piece.end)
        else:
            row.append(replace(piece, start=row[-1].end) if row else piece)
    return row


def _alike(first: Piece, second: Piece) -> bool:
    if (first.half_angle is None) != (second.half_angle is None):
        return False
    close = abs(first.outer_radius - second.outer_radius) < SAME
    if first.half_angle is None or second.half_angle is None:
        return close
    turned = cmath.phase(cmath.rect(1.0, first.angle - second.angle))
    return (
        close
        and abs(first.core_radius - second.core_radius) < SAME
        and max(abs(first.half_angle - second.half_angle), abs(turned)) < SAME
    )


def _turned(piece: Piece, frame: Frame) -> Piece:
    return replace(piece, angle=frame.angle(piece.angle))


def mirrored(shape: Outline) -> Outline:
    """The outline of the mirror image in the vertical plane through the crank: angles −φ, every place as it is."""
    return replace_pieces(shape, tuple(replace(piece, angle=-piece.angle) for piece in shape.pieces))


def replace_pieces(shape: Outline, pieces: tuple[Piece, ...]) -> Outline:
    """The outline of other pieces with the same bore and densities."""
    with recorded(False):
        return outline(pieces, shape.derived, shape.bore, shape.heavier)


# --- its solids


def _sectors(name: str) -> str:
    return f"{name}-sectors"


def _bodies(name: str, pieces: Sequence[Piece], apart: bool) -> tuple[tuple[str, Shape], ...]:
    """The solid of the shaft; where its sectors are of another density (`apart`) that of the rest and theirs."""
    sectors = [p for p in pieces if p.half_angle is not None and (apart or p.half_angle < HALF_TURN)]
    turned = [(p.start * MM, p.end * MM, _turned_radius(p, apart) * MM) for p in pieces]
    rest = [_profile(run) for run in _runs(turned)]
    if not apart:
        return ((name, _grown(name, rest, [(p, prism(face(_section(p)), p.length * MM)) for p in sectors])),)
    rings = _sectors(name), _grown(_sectors(name), [], [(p, _ring(p)) for p in sectors]) if sectors else None
    return tuple((body, solid) for body, solid in ((name, fused(*rest) if rest else None), rings) if solid is not None)


def _grown(name: str, solids: Sequence[Shape], sectors: Sequence[tuple[Piece, Shape]]) -> Shape:
    """All in one; where it is not valid any more, the sector with which that came is named."""
    whole = fused(*solids) if solids else None
    for piece, shape in sectors:
        whole = shape if whole is None else fused(whole, shape)
        demand_valid(whole, f"{name} with its sector from {piece.start * MM:g} to {piece.end * MM:g} mm")
    return whole


def _drilled(name: str, solid: Shape, holes: Sequence[Hole], frame: Frame) -> Shape:
    for hole in holes:
        solid = cut(solid, _drill(hole, frame))
        demand_valid(solid, f"{name} with its hole {hole.name}")
    return solid


def _turned_radius(piece: Piece, apart: bool) -> Metre:
    """How far out a piece is a full cylinder."""
    if piece.half_angle is None or (piece.half_angle >= HALF_TURN and not apart):
        return piece.outer_radius
    return piece.core_radius


def _runs(stretches: Sequence[tuple[float, float, float]]) -> Iterator[list[tuple[float, float, float]]]:
    """Stretches that hang together: between them the core has no radius."""
    for there, run in groupby(stretches, key=lambda stretch: stretch[2] > SAME * MM):
        if there:
            yield list(run)


def _profile(run: Sequence[tuple[float, float, float]]) -> Shape:
    """One closed profile, turned about the axis."""
    steps: list[tuple[float, float]] = [(0.0, run[0][0]), (run[0][2], run[0][0])]
    for before, after in pairwise(run):
        if abs(before[2] - after[2]) >= SAME * MM:
            steps += [(before[2], before[1]), (after[2], after[0])]
    steps += [(run[-1][2], run[-1][1]), (0.0, run[-1][1])]
    return revolved(face(polygon([(r, 0.0, z) for r, z in steps])))


def _section(piece: Piece) -> list[Shape]:
    """Core and sector: the arc of the sector, a flank, the arc of the core the long way round, the other flank."""
    half, out, core = piece.half_angle or math.pi, piece.outer_radius * MM, piece.core_radius * MM
    low, high, z = piece.angle - half, piece.angle + half, piece.start * MM
    tip = arc(at(out, low, z), at(out, piece.angle, z), at(out, high, z))
    if core <= SAME * MM:
        if abs(half - math.pi / 2) < SAME:
            return [tip, line(at(out, high, z), at(out, low, z))]
        axis = (0.0, 0.0, z)
        return [tip, line(at(out, high, z), axis), line(axis, at(out, low, z))]
    back = arc(at(core, high, z), at(core, piece.angle + math.pi, z), at(core, low, z))
    return [tip, line(at(out, high, z), at(core, high, z)), back, line(at(core, low, z), at(out, low, z))]


def _ring(piece: Piece) -> Shape:
    """The sector without its core."""
    half, out, core = piece.half_angle or math.pi, piece.outer_radius * MM, piece.core_radius * MM
    if half >= HALF_TURN:
        outer = cylinder(out, piece.start * MM, piece.end * MM)
        inner = cylinder(core, piece.start * MM - ROUND, piece.end * MM + ROUND) if core > SAME * MM else None
        return outer if inner is None else cut(outer, inner)
    low, high, z = piece.angle - half, piece.angle + half, piece.start * MM
    if core <= SAME * MM:
        return prism(face(_section(piece)), piece.length * MM)
    tip = arc(at(out, low, z), at(out, piece.angle, z), at(out, high, z))
    back = arc(at(core, high, z), at(core, piece.angle, z), at(core, low, z))
    flanks = line(at(out, high, z), at(core, high, z)), line(at(core, low, z), at(out, low, z))
    return prism(face([tip, flanks[0], back, flanks[1]]), piece.length * MM)


def cylinder(radius: float, start: float, end: float) -> Shape:
    """About the Z axis, all in mm."""
    return revolved(face(polygon([(0.0, 0.0, start), (radius, 0.0, start), (radius, 0.0, end), (0.0, 0.0, end)])))


def _drill(hole: Hole, frame: Frame) -> Shape:
    """What the drill takes, from outside of the shaft to the end of its cone."""
    a, R = hole.diameter / 2 * MM, hole.R * MM
    bottom = R - hole.depth * MM
    cone = a / math.tan(hole.point / 2) if hole.point < math.pi - SAME else 0.0
    tip = [(0.0, bottom - cone), (a, bottom)] if cone else [(0.0, bottom), (a, bottom)]
    profile = [*tip, (a, R + ROUND), (0.0, R + ROUND)]
    tool = revolved(face(polygon([(r, 0.0, z) for r, z in profile])))
    return along(tool, (0.0, 0.0, hole.z * MM), at(1.0, frame.angle(hole.angle), 0.0))


def at(radius: float, angle: float, z: float) -> Point:
    """A point by its radius and angle."""
    return radius * math.cos(angle), radius * math.sin(angle), z


# --- what they weigh


def _weighed(name: str, solid: Shape, density: KilogramPerMetre3, drilled: bool = False) -> Weighed:
    found, kg = properties(solid, drilled, OF_DRILLED), density * 1e-9  # per mm³
    return Weighed(name, found.volume, found.volume * kg, found.centre, found.tensor * kg)


def together(name: str, solids: Sequence[Weighed]) -> Weighed:
    """All of them, about their common centre (Steiner)."""
    mass = sum(one.mass for one in solids)
    centre = sum((one.mass * one.centre for one in solids), np.zeros(3)) / mass
    tensor = np.zeros((3, 3))
    for one in solids:
        away = one.centre - centre
        tensor += one.tensor + one.mass * (away @ away * np.eye(3) - np.outer(away, away))
    return Weighed(name, sum(one.volume for one in solids), mass, centre, tensor)


def _by_program(name: str, shape: Outline, rho: KilogramPerMetre3) -> Weighed:
    """The same of an outline that is turned as in the file."""
    with recorded(False):
        solid: MassProperties = mass_properties(shape, rho)
        l = np.array([piece.length for piece in shape.pieces])
    J = solid.inertia
    tensor = np.array([[J.xx, J.xy, J.zx], [J.xy, J.yy, J.yz], [J.zx, J.yz, J.zz]]) * 1e6
    centre = np.array([solid.up, solid.side, solid.along]) * MM
    return Weighed(name, float(np.sum(shape.area * l)) * 1e9, solid.mass, centre, tensor)


def apart(solid: Weighed, program: Weighed, length: float) -> float:
    return max(
        abs(solid.mass / program.mass - 1),
        float(np.max(np.abs(solid.centre - program.centre))) / length,
        float(np.max(np.abs(solid.tensor - program.tensor)) / np.max(np.abs(program.tensor))),
    )
