# SPDX-License-Identifier: Apache-2.0
"""What is assumed and chosen for the geometry of the train, and where its source is wrong."""

import math
from collections.abc import Iterator

from ..sheet.quantity import dotted
from ..sheet.step import Erratum
from ..sheet.text import COMMA, Amount, Text, plural
from .inputs import GearsInputs
from .result import TrainResult, WheelResult
from .train import Train


def notes(gears: GearsInputs, train: Train, result: TrainResult) -> Iterator[Text]:
    """What `settle` chose, what is not given of the backlash, and what holds for all wheels."""
    yield from train.notes
    yield from _not_given(result)
    yield Text(
        "The smallest and the largest backlash hold at 20 °C without runout; cold, warm and with runout have "
        "values of their own."
    )
    if gears.ball_diameter is None:
        yield Text(
            "Measuring ball: not given; chosen: for each wheel the preferred one that touches nearest to the middle of "
            "its flank."
        )
    yield Text(
        "The standard tip shortening k*·m_n is shown, not applied: only the tip cut that is given shortens a wheel."
    )


def _not_given(result: TrainResult) -> Iterator[Text]:
    """What the backlash is without where tolerances or allowances are left out, for all meshes of a kind together."""
    kinds: dict[tuple[bool, bool], list[str]] = {}
    for mesh in result.meshes.values():
        thinned = any(result.wheels[w].allowance for w in (mesh.driver, mesh.driven))
        kinds.setdefault((bool(mesh.centre_tolerance), thinned), []).append(mesh.title)
    for (toleranced, thinned), titles in kinds.items():
        n, pairs = len(titles), COMMA.join(titles)
        if not toleranced and not thinned:
            yield plural(
                "Mesh {pairs}: neither tolerance nor allowance is given: its backlash is 0.",
                "Meshes {pairs}: neither tolerance nor allowance is given: their backlash is 0.",
                n=n,
                pairs=pairs,
            )
        elif not toleranced:
            yield plural(
                "Mesh {pairs}: no tolerance of the centre distance is given: it is taken as exact.",
                "Meshes {pairs}: no tolerance of the centre distance is given: it is taken as exact.",
                n=n,
                pairs=pairs,
            )
        elif not thinned:
            yield plural(
                "Mesh {pairs}: no allowance of the span is given: the teeth are taken without thinning.",
                "Meshes {pairs}: no allowance of the span is given: the teeth are taken without thinning.",
                n=n,
                pairs=pairs,
            )


def errata(result: TrainResult) -> tuple[Erratum, ...]:
    """The source enters the speed of the first driver for the driver of every pair."""
    drivers = [result.wheels[name] for name in dict.fromkeys(mesh.driver for mesh in result.meshes.values())]
    first = drivers[0]
    return tuple(
        Erratum(
            dotted("gears", wheel.name, WheelResult.speed),
            Text("Speed of {name} by the sheet of Finotti 2013", name=wheel.name),
            math.copysign(first.speed, wheel.speed) * 60,
            "rpm",
            Text("method of Finotti 2013, Tables 4.5 and 4.6"),
            Text(
                "The sheet enters the speed of the train's first wheel for {name} too; with {teeth} teeth against "
                "{teeth2} it turns at {speed} rpm.",
                name=wheel.name,
                teeth=wheel.teeth,
                teeth2=first.teeth,
                speed=Amount(abs(wheel.speed) * 60, form=".1f"),
            ),
            ("Finotti 2013", "2107, 2131"),
        )
        for wheel in drivers
        if wheel.teeth != first.teeth
    )
