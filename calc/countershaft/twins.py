# SPDX-License-Identifier: Apache-2.0
"""Several shafts: each as it turns, a twin with what is its original's.

The mirror image in the vertical plane through the crank turns the other way; its masses stand at −γ (not at γ + 180°),
each at the same place along the engine, its axis at the same height on the other side.  A repeated shaft is the same
once more, about an axis of its own."""

import cmath
import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Literal, TypeVar

from ..sheet.record import record, replace
from ..sheet.units import Radian
from ..sheet.value import based_on
from .inputs import EccentricMass, Section, ShaftInputs
from .rows import BearingRow, said_in

if TYPE_CHECKING:
    from .outline import Outline

How = Literal["own", "mirrors", "repeats"]
M = TypeVar("M", bound=EccentricMass)
SAME_ANGLE = 1e-9  # rad


@record
class Resolved:
    """One of the shafts of a design: its inputs as they are, of a twin made from those of its original; `of`: the name
    of that, None of a shaft of its own; `rows`: what the twin says of its bearings itself."""

    name: str
    inputs: ShaftInputs
    how: How = "own"
    of: str | None = None
    rows: tuple[BearingRow, ...] = ()


def resolved(shafts: Iterable[ShaftInputs]) -> tuple[Resolved, ...]:
    """All shafts in their order; a twin comes behind its original, which is checked elsewhere."""
    known: dict[str, ShaftInputs] = {}
    found = []
    for shaft in shafts:
        if not shaft.is_twin:
            known[shaft.name] = shaft
            found.append(Resolved(shaft.name, shaft))
            continue
        rows = tuple(row for row in shaft.bearings if said_in(row))
        if shaft.mirrors is not None:
            inputs = mirrored(known[shaft.mirrors], shaft)
            found.append(Resolved(shaft.name, with_rows(inputs, rows), "mirrors", shaft.mirrors, rows))
        elif shaft.repeats is not None:
            inputs = replace(known[shaft.repeats], name=shaft.name, axis=shaft.axis, loads=shaft.loads)
            found.append(Resolved(shaft.name, with_rows(inputs, rows), "repeats", shaft.repeats, rows))
    return tuple(found)


def with_rows(shaft: ShaftInputs, rows: tuple[BearingRow, ...]) -> ShaftInputs:
    """A twin whose bearings of these names have what the rows say."""
    if not rows:
        return shaft
    own = {row.name: row for row in rows}
    return replace(shaft, bearings=tuple(b.with_own(own[b.name]) if b.name in own else b for b in shaft.bearings))


def mirrored(original: ShaftInputs, twin: ShaftInputs) -> ShaftInputs:
    """The inputs of the mirror image of a shaft: those of the original, turned over; of its axis its own, where it has
    one: heights may differ, which changes no phase."""
    axis = twin.axis
    if axis is None and original.axis is not None:
        up, side = original.axis
        axis = up, based_on(-side, side)
    return replace(
        original,
        name=twin.name,
        speed_ratio=based_on(-original.speed_ratio, original.speed_ratio),
        axis=axis,
        loads=twin.loads,
        masses=tuple(map(turned_over, original.masses)),
        extras=tuple(map(turned_over, original.extras)),
        sections=tuple(map(_section_turned_over, original.sections)),
    )


def turned_over(mass: M) -> M:
    """An eccentric mass as its mirror image has it."""
    return replace(mass, angle=based_on(-mass.angle, mass.angle))


def _section_turned_over(section: Section) -> Section:
    return section if section.angle is None else replace(section, angle=based_on(-section.angle, section.angle))


def turned_alike(shape: "Outline", holes: Iterable[Radian] = ()) -> Radian | None:
    """By which angle the part is to be turned about its axis to be its mirror image, 0 … 2π; None: it is another part.
    All that is eccentric then lies in one plane through the axis.  `holes`: their directions."""
    angles = [p.angle for p in shape.pieces if p.half_angle is not None and p.half_angle < math.pi - SAME_ANGLE]
    turns = [cmath.rect(1.0, -2 * angle) for angle in (*angles, *holes)]
    if any(abs(turn - turns[0]) > SAME_ANGLE for turn in turns):
        return None
    turn = cmath.phase(turns[0]) % (2 * math.pi) if turns else 0.0
    return 0.0 if 2 * math.pi - turn < SAME_ANGLE else turn
