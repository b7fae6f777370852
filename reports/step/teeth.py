# SPDX-License-Identifier: Apache-2.0
"""A shaft with the teeth of its wheel in place of the blank that its outline has.  Where the outline does not reach the
wheel, or runs through it, the wheel is a body of its own beside the shaft."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from calc.countershaft.outline import Outline, Piece
from calc.exchange.frame import Frame
from calc.gears.result import WheelResult
from calc.sheet.units import KilogramPerMetre3, Metre
from reports.step.kernel import KernelFault, Shape, StepPart, demand_valid, fused, moved
from reports.step.shaft import MM, SAME, Hole, Weighed, WeighedPart, apart, replace_pieces, shaft_solid, together
from reports.step.wheel import CLOSE, with_teeth

BLANK = 0.9  # rule of this program, of the root radius: from here on what stands in the place of a wheel is its blank


def beside(shape: Outline, wheel: WheelResult, z: Metre) -> list[Piece]:
    """The pieces of a shaft along the face of a wheel whose middle is at z."""
    start, end = _face(wheel, z)
    return [piece for piece in shape.pieces if piece.end > start + SAME and piece.start < end - SAME]


def has_blank(shape: Outline, wheel: WheelResult, z: Metre) -> bool:
    """Whether the outline of a shaft has the blank of its wheel."""
    start, end = _face(wheel, z)
    return (
        shape.start <= start + SAME
        and shape.end >= end - SAME
        and all(
            p.half_angle is None and (p.what == "gear" or p.outer_radius >= BLANK * wheel.root_diameter / 2)
            for p in beside(shape, wheel, z)
        )
    )


def seat(shape: Outline, wheel: WheelResult, z: Metre) -> Metre:
    """The radius of a shaft that runs through its wheel; 0: it does not reach it."""
    return max((piece.outer_radius for piece in beside(shape, wheel, z)), default=0.0)


def toothed_shaft(
    name: str,
    shape: Outline,
    rho: KilogramPerMetre3,
    frame: Frame,
    wheel: WheelResult,
    z: Metre,
    made: Callable[[Metre | None], WeighedPart],
    straight: bool,
    holes: Sequence[Hole] = (),
) -> WeighedPart:
    """`z`: of the middle of its wheel; `made`: that wheel, open inside a radius, or (None) inside its own; `straight`:
    whether its teeth are.  Raises KernelFault where the solid is not valid, or not what the program weighs."""
    if not has_blank(shape, wheel, z):
        shaft, solid = shaft_solid(name, shape, rho, frame, holes), made(None)
        own = f"{wheel.name}-wheel" if wheel.name == name else wheel.name
        ring = replace(_along(solid.whole, z), name=own)
        bodies = *shaft.part.bodies, (own, _set(solid, z))
        weights = *shaft.solids, ring
    else:
        # the blank gives way to a core, on which the teeth are set
        core = (shape.bore + min(wheel.root_diameter, wheel.reference_diameter) / 2) / 2
        cored = replace_pieces(shape, tuple(_cored(shape, *_face(wheel, z), core)))
        shaft, solid = shaft_solid(name, cored, rho, frame, holes), made(core)
        (own, body), *sectors = shaft.part.bodies
        joined = fused(body, _set(solid, z))
        demand_valid(joined, name)
        first = together(own, [shaft.solids[0], _along(solid.whole, z)])
        lost = with_teeth(joined, straight).volume / first.volume - 1
        if not abs(lost) <= CLOSE:
            raise KernelFault(f"joining the teeth to {name} changed its volume by {lost:.1e}")
        bodies, weights = ((own, joined), *sectors), (first, *shaft.solids[1:])
    beyond = _along(solid.by_program, z)
    whole = together(name, weights)
    by_program = together(name, [shaft.by_program, beyond])
    expected = together(name, [shaft.whole, beyond])  # which may be drilled
    deviation = apart(whole, expected, (max(shape.end, z) - min(shape.start, z)) * MM)
    if not deviation <= CLOSE:
        raise KernelFault(f"the solid of {name} with its teeth is off its parts by {deviation:.1e}")
    undrilled = together(name, [shaft.undrilled, beyond])
    return WeighedPart(StepPart(name, bodies), weights, whole, undrilled, by_program, deviation, tuple(holes))


def _face(wheel: WheelResult, z: Metre) -> tuple[Metre, Metre]:
    return z - wheel.face_width / 2, z + wheel.face_width / 2


def _set(solid: WeighedPart, z: Metre) -> Shape:
    return moved(solid.part.bodies[0][1], (0.0, 0.0, z * MM))


def _along(one: Weighed, z: Metre) -> Weighed:
    return replace(one, centre=one.centre + np.array([0.0, 0.0, z * MM]))


def _cored(shape: Outline, start: Metre, end: Metre, core: Metre) -> Iterator[Piece]:
    """The pieces with another radius between two faces."""
    for piece in shape.pieces:
        inside = max(piece.start, start), min(piece.end, end)
        if inside[1] <= inside[0] + SAME:
            yield piece
            continue
        if inside[0] > piece.start + SAME:
            yield replace(piece, end=inside[0])
        yield replace(piece, start=inside[0], end=inside[1], outer_radius=core)
        if inside[1] < piece.end - SAME:
            yield replace(piece, start=inside[1])
