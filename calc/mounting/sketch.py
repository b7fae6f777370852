# SPDX-License-Identifier: Apache-2.0
"""The modes of the engine on its mounts: a box on its mounts at rest and as it moves, looked at from the side and a
little from above."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from ..draw.drawing import (
    AXIS,
    CONTEXT,
    OUTLINE,
    WORDS,
    Arc,
    Mark,
    Point,
    Polyline,
    Sketch,
    State,
    Words,
    awaited,
    judged,
)
from ..sheet.arrays import Array
from ..sheet.quantity import dotted
from ..sheet.text import Amount, Name, Text
from ..sheet.units import Radian
from .checks import DEFLECTION
from .curves import ModePicture, mode_pictures
from .inputs import MountingInputs
from .result import MountingResult

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

DOT, CROSS, SWING = 0.02, 0.04, 0.16  # of the box's diagonal: a mount, the cross of the centre, the largest move
# where what lies to the side is drawn
BACK = 0.5 * np.array([math.cos(math.radians(35.0)), math.sin(math.radians(35.0))])
# of the corners of `box`
EDGES = ((0, 1), (0, 2), (0, 4), (1, 3), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 6), (5, 7), (6, 7))


def sketch(design: "Design", results: "Results", angle: Radian = 0.0, view: int = 0) -> Sketch:
    """The modes beside each other, that of `view` first, at a phase: 0 is the end of the swing.  To the right: along
    the crank."""
    outcome = results.outcomes["mounting"]
    if design.mounting is None or not isinstance(outcome.result, MountingResult):
        return awaited(outcome)
    checks = tuple(outcome.checks)
    states = {mount.name: judged(checks, DEFLECTION.of(mount.name)) for mount in design.mounting.mounts}
    modes = mode_pictures(design.mounting, outcome.result)
    first, *others = [
        Sketch(tuple(_marks(design.mounting, mode, states, angle)), turning=True, title=_title(n, mode))
        for n, mode in _from(modes, view)
    ]
    note = Text("thin: at rest; dots: mounts, cross: centre of gravity, line through it: torque roll axis")
    return Sketch(first.primitives, (note,), turning=True, title=first.title, beside=tuple(others), views=len(modes))


def _from(modes: tuple[ModePicture, ...], view: int) -> list[tuple[int, ModePicture]]:
    numbered = list(enumerate(modes, 1))
    return numbered[view:] + numbered[:view]


def _title(n: int, mode: ModePicture) -> Text:
    return Text(
        "mode {n}: {words}, {frequency}", n=n, words=mode.words, frequency=Amount(mode.frequency, "Hz", digits=4)
    )


def _marks(mounting: MountingInputs, mode: ModePicture, states: dict[str, State], angle: Radian) -> Iterator[Mark]:
    size = float(np.linalg.norm(np.ptp(mode.corners, axis=0)))
    swing = SWING * size * math.cos(angle)
    rest, moved = _seen(mode.corners), _seen(mode.corners + swing * mode.corner_moves)
    for corners, layer in ((rest, CONTEXT), (moved, OUTLINE)):
        for start, end in EDGES:
            yield Polyline(layer, (corners[start], corners[end]))
    low, high = float(mode.corners[:, 2].min()), float(mode.corners[:, 2].max())
    yield Polyline(AXIS, tuple(_seen(np.array([[0.0, 0.0, low - DOT * size], [0.0, 0.0, high + DOT * size]]))))
    for i, (mount, at) in enumerate(zip(mounting.mounts, _seen(mode.mounts + swing * mode.mount_moves))):
        yield Arc(OUTLINE, at, DOT * size, key=dotted("mounting", MountingInputs.mounts, i), state=states[mount.name])
    for mount, at in zip(mounting.mounts, _seen(mode.mounts)):
        if states[mount.name]:
            yield Words(
                WORDS, (at[0], at[1] - 4 * DOT * size), Name(mount.name), state=states[mount.name], side="centre"
            )
    along = 0.25 * size * mode.roll_axis
    yield Polyline(AXIS, tuple(_seen(np.array([mode.centre - along, mode.centre + along]))))
    ((x, y),) = _seen(mode.centre[None, :])
    centre = dotted("mounting", MountingInputs.centre_of_gravity)
    for dx, dy in ((CROSS * size, 0.0), (0.0, CROSS * size)):
        yield Polyline(OUTLINE, ((x - dx, y - dy), (x + dx, y + dy)), key=centre)


def _seen(places: Array) -> list[Point]:
    """Places (n, 3) on the paper: z to the right, x up, y to the back."""
    return [(float(z + BACK[0] * y), float(x + BACK[1] * y)) for x, y, z in places]
