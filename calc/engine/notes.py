# SPDX-License-Identifier: Apache-2.0
"""What the engine step assumed and chose."""

import math
from collections.abc import Iterator

from ..sheet.text import Amount, Text
from .crank import Firing
from .inputs import EngineInputs
from .result import EngineResult


def notes(engine: EngineInputs, e: EngineResult, fires: Firing) -> Iterator[Text]:
    yield from e.crank.chosen
    if engine.cylinders > 1:
        degrees = [round(math.degrees(gap), 3) for gap in fires.intervals]
        if fires.chosen:
            yield fires.chosen
        if max(degrees) - min(degrees) < 1e-3:
            when = Text("every {degrees}°.", degrees=Amount(degrees[0], form="g"))
        else:
            when = Text("after {what}°: unevenly.", what="-".join(f"{d:g}" for d in degrees))
        yield Text("Fires {map}, ", map="-".join(map(str, fires.order))) + when
    if engine.layout in ("w", "radial"):
        yield Text(
            "Every rod is taken to turn about its crankpin: link rods on a master rod move their pistons otherwise."
        )
    yield Text("The rod is replaced by two masses; the couple of its own inertia (J_G ≠ m·X₁·X₂) is neglected.")
    if engine.rod_cg_to_big_end is None and engine.rod_mass is not None:
        yield Text("The rod's centre of gravity is not given: one third of it is taken as reciprocating.")
    if e.cylinder is not None:
        yield Text(
            "Crank radii or offsets differ: crank ratio, stroke and harmonics, speed and acceleration of the piston, "
            "and its figures, are those of cylinder 1; those of each stand under its number. The torque is that of all."
        )
