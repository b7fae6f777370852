# SPDX-License-Identifier: Apache-2.0
"""The checks of the mounts: whether they hold the engine, give too much, isolate, keep the modes apart, and what a person has of it."""

from collections.abc import Iterator, Sequence

import numpy as np

from ..engine.inputs import EngineInputs
from ..sheet.check import Check, check
from ..sheet.text import COMMA, Name, Text
from ..sheet.value import based_on
from .felt_checks import comfort_checks, exposure_checks, severity_checks
from .inputs import MountingInputs
from .mode_checks import critical_checks, mode_checks
from .result import MountingResult


def checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    """All of them but that of the estimated inertia."""
    lowest = result.modes["mode_1"].frequency
    yield check(
        "mounting.supported",
        Text("Slowest mode: the mounts hold the engine"),
        lowest,
        ">",
        0.0,
        "Hz",
        Text("statics: six motions, six springs"),
    )
    yield from _deflections(mounting, result)
    yield from exposure_checks(result)
    yield from mode_checks(mounting, result)
    yield from critical_checks(mounting, engine, result)
    yield from severity_checks(mounting, engine, result)
    yield from comfort_checks(mounting, result)
    for mount in mounting.mounts:
        yield check(
            f"mounting.lifted.{mount.name}",
            Text("Weight on the mount {name}", name=Name(mount.name)),
            result.static[mount.name].load,
            ">=",
            0.0,
            "N",
            Text("statics: rubber should not be pulled at rest"),
            Text("Move it towards the centre of gravity, or turn it."),
        )
    yield from _range(mounting, result)
    yield from _helps(result)


def _deflections(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    """At rest, under the mean torque and vibrating, along each own axis: the largest of all operations."""
    from .levels import peaks

    v = result.drive.variants.index(result.own)
    for j, mount in enumerate(mounting.mounts):
        if mount.deflection_limit is None:
            continue
        swing = peaks(result.levels.deflection[:, v, j])  # (operations, axes)
        standing = np.abs(result.rest.deflection[j]) + np.abs(np.outer(result.output, result.rest.by_torque[j]))
        most = float((swing + standing).max())
        yield check(
            f"mounting.{mount.name}.deflection",
            Text("Largest deflection of the mount {name}", name=Name(mount.name)),
            based_on(most, result.levels.source, mount.stiffness),
            "<=",
            mount.deflection_limit,
            "mm",
            Text("given in the design: room of the mount"),
            Text("Stiffen the mount, or give it more room."),
        )


def _range(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    """Whether the body is still rigid where the strongest order of the seat lies."""
    seat = next((point.name for point in mounting.points if point.role == "seat"), None)
    if seat is None:
        return
    W, a = result.levels.weight[seat], result.levels.acceleration[seat]
    v = result.drive.variants.index(result.own)
    sizes = ((W[:, 0] * np.abs(a[:, v])) ** 2).sum(1)  # (operations, orders)
    if not np.isfinite(sizes).all():
        return
    f = max(float(result.levels.frequency[i, sizes[i].argmax()]) for i in range(len(sizes)))
    yield check(
        "mounting.rigid_range",
        Text("Frequency of the strongest order at the seat"),
        based_on(f, result.levels.source),
        "<=",
        mounting.rigid_up_to,
        "Hz",
        Text("rule of this program: validity of the model, engine and frame bend above it"),
    )


def _helps(result: MountingResult) -> Iterator[Check]:
    if not result.has_shaft:
        return
    found = [
        (number, f"mounting.{name}.{id}")
        for name in result.speeds
        for id in ("felt_seat", "felt_engine", "felt_force")
        if (number := result.leaf(f"{name}.{id}")) is not None
    ]
    if found:
        ratio, id = min(found)
        yield check(
            "mounting.shaft_helps",
            Text("Smallest of all felt ratios, half over shaft"),
            ratio,
            ">=",
            1.0,
            "",
            Text("rule of this program: a shaft that is late or too heavy makes it worse"),
            value_id=id,
        )


def inertia_check(flips: Sequence[Text]) -> Check:
    named = COMMA.join(flips)
    advice = Text("These hang on it: {named}. Give inertia_kgm2.", named=named) if flips else Text("")
    return check(
        "mounting.inertia_range",
        Text("Verdicts that turn between half and nine tenths of a full box"),
        float(len(flips)),
        "<=",
        0.0,
        "",
        Text("assumed: the inertia is estimated from the overall dimensions"),
        advice,
    )
