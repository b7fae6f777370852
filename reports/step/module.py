# SPDX-License-Identifier: Apache-2.0
"""All shafts and wheels of a design where they stand, as an assembly of named parts."""

from collections.abc import Sequence
from dataclasses import replace

from calc.exchange.frame import Frame
from calc.exchange.places import WheelPlace
from reports.step.kernel import Point, StepPart
from reports.step.shaft import MM, WeighedPart


def module_parts(
    shafts: Sequence[tuple[WeighedPart, complex]], wheels: Sequence[tuple[WeighedPart, WheelPlace]], frame: Frame
) -> list[StepPart]:
    """Each part set on its axis in the axes of the file: a shaft with its middle at mid-engine, a wheel with the middle
    of its face where that stands along the crank.  How each is turned is in its own solid.  A
    wheel that is called as a shaft is has -wheel behind its name."""
    parts = [replace(shaft.part, place=_at(frame, axis, 0.0)) for shaft, axis in shafts]
    taken = {part.name for part in parts}
    for wheel, place in wheels:
        name = f"{wheel.part.name}-wheel" if wheel.part.name in taken else wheel.part.name
        parts.append(replace(wheel.part, name=name, place=_at(frame, place.axis, place.z)))
    return parts


def _at(frame: Frame, axis: complex, z: float) -> Point:
    X, Y, Z = frame.place(axis.real * MM, axis.imag * MM, z * MM)
    return X, Y, Z
