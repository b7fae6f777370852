# SPDX-License-Identifier: Apache-2.0
"""What the engine step assumed and chose."""

import math

from ..sheet.text import Amount, Text
from .crank import Firing
from .inputs import EngineInputs
from .result import EngineResult


def notes(engine: EngineInputs, e: EngineResult, fires: Firing) -> tuple[Text, ...]:
    notes = list(e.crank.chosen)
    if engine.cylinders > 1:
        degrees = [round(math.degrees(gap), 3) for gap in fires.intervals]
        even = max(degrees) - min(degrees) < 1e-3
        notes += [fires.chosen] if fires.chosen else []
        notes.append(
            Text("Fires {map}, ", map="-".join(map(str, fires.order)))
            + (
                Text("every {degrees}°.", degrees=Amount(degrees[0], form="g"))
                if even
                else Text("after {what}°: unevenly.", what="-".join(f"{d:g}" for d in degrees))
            )
        )
    notes.append(Text("The rod is replaced by two masses; the couple of its own inertia (J_G ≠ m·X₁·X₂) is neglected."))
    if engine.rod_cg_to_big_end is None and engine.rod_mass is not None:
        notes.append(Text("The rod's centre of gravity is not given: one third of it is taken as reciprocating."))
    if e.cylinder is not None:
        notes.append(
            Text(
                "The crank radii differ: crank ratio, stroke and harmonics, speed and acceleration of the piston, and "
                "its figures, are those of cylinder 1; those of each stand under its number. The torque is that of all."
            )
        )
    return tuple(notes)
