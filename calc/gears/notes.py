# SPDX-License-Identifier: Apache-2.0
"""What is assumed and chosen for the geometry of the train, and where its source is wrong."""

import math

from ..sheet.step import Erratum
from ..sheet.text import Amount, Text
from .inputs import GearsInputs
from .result import TrainResult
from .train import Train


def notes(gears: GearsInputs, train: Train, result: TrainResult) -> tuple[Text, ...]:
    """What `settle` chose, what is not given of the backlash, and what holds for all wheels."""
    notes = list(train.notes)
    for mesh in result.meshes.values():
        name, thinned = mesh.title, any(result.wheels[w].allowance for w in (mesh.driver, mesh.driven))
        if not mesh.centre_tolerance and not thinned:
            notes.append(Text("Mesh {name}: neither tolerance nor allowance is given: its backlash is 0.", name=name))
        elif not mesh.centre_tolerance:
            notes.append(Text("Mesh {name}: no tolerance of the centre distance is given: it is taken as exact.", name=name))
        elif not thinned:
            notes.append(Text("Mesh {name}: no allowance of the span is given: the teeth are taken without thinning.", name=name))
    notes.append(Text("backlash_min and backlash_max hold at 20 °C without runout; cold, warm and with runout have values of their own."))
    if gears.ball_diameter is None:
        notes.append(
            Text("Measuring ball: not given; chosen: for each wheel the preferred one that touches nearest to the middle of its flank.")
        )
    notes.append(Text("The standard tip shortening k*·m_n is shown, not applied: only the tip cut that is given shortens a wheel."))
    return tuple(notes)


def errata(result: TrainResult) -> tuple[Erratum, ...]:
    """The source enters the speed of the first driver for the driver of every pair."""
    drivers = [result.wheels[name] for name in dict.fromkeys(mesh.driver for mesh in result.meshes.values())]
    first = drivers[0]
    return tuple(
        Erratum(
            f"gears.{wheel.name}.speed", Text("Speed of {name} by the sheet of Finotti 2013", name=wheel.name),
            math.copysign(first.speed, wheel.speed) * 60, "rpm", Text("method of Finotti 2013, Tables 4.5 and 4.6"),
            Text("The sheet enters the speed of the train's first wheel for {name} too; with {teeth} teeth against {teeth2} it turns at "
                "{speed} rpm.", name=wheel.name, teeth=wheel.teeth, teeth2=first.teeth, speed=Amount(abs(wheel.speed) * 60, form=".1f")),
        )
        for wheel in drivers if wheel.teeth != first.teeth
    )  # fmt: skip
